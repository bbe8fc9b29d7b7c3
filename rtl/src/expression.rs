//! Width-checked expressions: values that are copied and never panic.
//!
//! A mistake (widths that differ, a bit that is not there) becomes a poison node carrying its message; elaboration
//! reports it with the module it ended up in.

use std::fmt;
use std::marker::PhantomData;
use std::rc::Rc;

use super::arena;
use super::fold;

/// An expression of a known width.
///
/// It is a handle that is copied. What it stands for is kept by the thread as long as any [`Module`](crate::Module) of
/// the thread lives, whether something still uses it or not; an expression that is used later is an error at
/// elaboration.
#[derive(Clone, Copy)]
pub struct Expr {
    number: u64,
    width: usize,
    /// The number means something in its own thread only.
    thread: PhantomData<Rc<Node>>,
}

/// A signal of one module, as expressions refer to it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct SignalRef {
    /// Identity of the module that declared it.
    pub module: u64,
    /// Its place in that module's table.
    pub index: usize,
    /// Its name, for messages.
    pub name: Rc<str>,
}

/// What a node computes from its operands. The node's width completes the description.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    Signal(SignalRef),
    Literal(u128),
    Not,
    And,
    Or,
    Xor,
    Add,
    Subtract,
    /// Unsigned product; the width is the sum of the operands' widths.
    Multiply,
    /// Two's complement product; the width is the sum of the operands' widths.
    MultiplySigned,
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    LessSigned,
    ShiftLeft,
    ShiftRight,
    /// Bits of the operand from this one upwards.
    Slice(usize),
    /// Operands side by side, most significant first.
    Concat,
    /// The operand this many times.
    Repeat(usize),
    Any,
    All,
    /// `operands[0] ? operands[1] : operands[2]`.
    Mux,
    /// An error that was made while building.
    Poison(Rc<str>),
}

/// What an expression stands for.
pub(super) struct Node {
    pub operation: Operation,
    pub width: usize,
    pub operands: Box<[Expr]>,
    /// A poison node lies below: widths are guesses and are not checked again.
    pub tainted: bool,
}

impl Node {
    pub fn new(operation: Operation, width: usize, operands: impl Into<Box<[Expr]>>) -> Self {
        let operands = operands.into();
        let tainted = matches!(operation, Operation::Poison(_)) || operands.iter().any(|operand| operand.is_tainted());
        Self { operation, width, operands, tainted }
    }

    /// Keeps the node exactly as it is.
    pub fn keep(self) -> Expr {
        Expr { width: self.width, number: arena::keep(self), thread: PhantomData }
    }
}

impl Expr {
    /// A node in its simplest form.
    pub(super) fn build(operation: Operation, width: usize, operands: impl Into<Box<[Self]>>) -> Self {
        let node = Node::new(operation, width, operands);
        let simpler = if node.tainted { None } else { fold::simplify(&node) };
        simpler.unwrap_or_else(|| node.keep())
    }

    /// The mark of an error, with the width that was probably meant.
    pub(super) fn poison(width: usize, message: String) -> Self {
        Node::new(Operation::Poison(message.into()), width.max(1), []).keep()
    }

    /// What it stands for.
    pub(super) fn node(self) -> Rc<Node> {
        arena::node(self.number)
    }

    /// Identity of the node.
    pub(super) const fn number(self) -> u64 {
        self.number
    }

    /// A mistake lies below.
    pub(super) fn is_tainted(self) -> bool {
        self.node().tainted
    }

    /// The value, of a literal.
    #[must_use]
    pub fn literal_value(self) -> Option<u128> {
        match self.node().operation {
            Operation::Literal(value) => Some(value),
            _ => None,
        }
    }

    /// Number of bits.
    #[must_use]
    pub const fn width(self) -> usize {
        self.width
    }
}

/// Short text for messages: signals by name, deep operands as `…`.
impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_short(*self, 2, f)
    }
}

impl fmt::Debug for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self} [{} bits]", self.width())
    }
}

fn write_short(expr: Expr, depth: usize, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let node = expr.node();
    match &node.operation {
        Operation::Signal(signal) => return f.write_str(&signal.name),
        Operation::Literal(value) => return write!(f, "{}'d{value}", node.width),
        Operation::Poison(_) => return f.write_str("<error>"),
        _ if depth == 0 => return f.write_str("…"),
        Operation::Slice(low) => {
            write_short(node.operands[0], depth - 1, f)?;
            return write!(f, "[{}:{low}]", low + node.width - 1);
        }
        operation => write!(f, "{operation:?}(")?,
    }
    for (index, &operand) in node.operands.iter().take(4).enumerate() {
        if index > 0 {
            f.write_str(", ")?;
        }
        write_short(operand, depth - 1, f)?;
    }
    f.write_str(if node.operands.len() > 4 { ", …)" } else { ")" })
}

/// A constant of `width` bits.
#[must_use]
pub fn lit(width: usize, value: u128) -> Expr {
    if width == 0 {
        return Expr::poison(1, format!("literal {value} has no bits"));
    }
    if width < 128 && value >> width != 0 {
        return Expr::poison(width, format!("literal {value} does not fit {width} bits"));
    }
    Node::new(Operation::Literal(value), width, []).keep()
}

/// A constant bit.
#[must_use]
pub fn bit(value: bool) -> Expr {
    lit(1, u128::from(value))
}

/// The parts side by side, most significant first.
#[must_use]
pub fn cat(parts: impl IntoIterator<Item = impl Into<Expr>>) -> Expr {
    let parts: Box<[Expr]> = parts.into_iter().map(Into::into).collect();
    if parts.is_empty() {
        return Expr::poison(1, "concatenation of nothing".into());
    }
    let width = parts.iter().map(|part| part.width()).sum();
    Expr::build(Operation::Concat, width, parts)
}

/// The entry that `index` picks; an index past the end picks the last.
#[must_use]
pub fn select(index: impl Into<Expr>, entries: impl IntoIterator<Item = impl Into<Expr>>) -> Expr {
    let index = index.into();
    let entries: Vec<Expr> = entries.into_iter().map(Into::into).collect();
    let Some(last) = entries.last() else {
        return Expr::poison(1, format!("selection by `{index}` from nothing"));
    };
    if let Some(odd) = entries.iter().find(|entry| entry.width() != last.width()) {
        let message = format!("entries of a selection by `{index}`: `{odd}` has {} bits", odd.width());
        return Expr::poison(last.width(), format!("{message}, `{last}` has {}", last.width()));
    }
    let reachable = if index.width() < usize::BITS as usize - 1 { 1 << index.width() } else { usize::MAX };
    if entries.len() > reachable {
        let message = format!("`{index}` has {} bits and cannot pick from {}", index.width(), entries.len());
        return Expr::poison(last.width(), format!("{message} entries"));
    }
    select_bits(index, index.width(), &entries)
}

/// A tree of two-way choices over the lowest `bits` bits of the index.
fn select_bits(index: Expr, bits: usize, entries: &[Expr]) -> Expr {
    if entries.len() == 1 || bits == 0 {
        return entries[0];
    }
    let top = bits - 1;
    let half = if top < usize::BITS as usize - 1 { 1 << top } else { usize::MAX };
    if entries.len() <= half {
        let below = select_bits(index, top, entries);
        return index.bit(top).mux(entries[entries.len() - 1], below);
    }
    let (low, high) = entries.split_at(half);
    index.bit(top).mux(select_bits(index, top, high), select_bits(index, top, low))
}
