//! Width-checked expressions: immutable shared trees that never panic.
//!
//! A mistake (widths that differ, a bit that is not there) becomes a poison node carrying its message; elaboration
//! reports it with the module it ended up in.

use std::fmt;
use std::rc::Rc;

use super::fold;

/// An expression of a known width; cloning shares it.
#[derive(Clone)]
pub struct Expr(Rc<Node>);

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

pub(super) struct Node {
    pub operation: Operation,
    pub width: usize,
    pub operands: Vec<Expr>,
    /// A poison node lies below: widths are guesses and are not checked again.
    pub tainted: bool,
}

impl Expr {
    /// A node exactly as described, without checks.
    pub(super) fn raw(operation: Operation, width: usize, operands: Vec<Expr>) -> Self {
        let tainted = matches!(operation, Operation::Poison(_)) || operands.iter().any(|operand| operand.0.tainted);
        Self(Rc::new(Node { operation, width, operands, tainted }))
    }

    /// A node in its simplest form.
    pub(super) fn build(operation: Operation, width: usize, operands: Vec<Expr>) -> Self {
        let node = Self::raw(operation, width, operands);
        if node.0.tainted { node } else { fold::simplify(node) }
    }

    /// The mark of an error, with the width that was probably meant.
    pub(super) fn poison(width: usize, message: String) -> Self {
        Self::raw(Operation::Poison(message.into()), width.max(1), vec![])
    }

    pub(super) fn node(&self) -> &Node {
        &self.0
    }

    /// Identity of the shared node.
    pub(super) fn address(&self) -> *const Node {
        Rc::as_ptr(&self.0)
    }

    /// The value, of a literal.
    #[must_use]
    pub fn literal_value(&self) -> Option<u128> {
        match self.0.operation {
            Operation::Literal(value) => Some(value),
            _ => None,
        }
    }

    /// Number of bits.
    #[must_use]
    pub fn width(&self) -> usize {
        self.0.width
    }
}

impl AsRef<Expr> for Expr {
    fn as_ref(&self) -> &Expr {
        self
    }
}

/// Short text for messages: signals by name, deep operands as `…`.
impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_short(self, 2, f)
    }
}

impl fmt::Debug for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self} [{} bits]", self.width())
    }
}

fn write_short(expr: &Expr, depth: usize, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let node = expr.node();
    match &node.operation {
        Operation::Signal(signal) => return f.write_str(&signal.name),
        Operation::Literal(value) => return write!(f, "{}'d{value}", node.width),
        Operation::Poison(_) => return f.write_str("<error>"),
        _ if depth == 0 => return f.write_str("…"),
        Operation::Slice(low) => {
            write_short(&node.operands[0], depth - 1, f)?;
            return write!(f, "[{}:{low}]", low + node.width - 1);
        }
        operation => write!(f, "{operation:?}(")?,
    }
    for (index, operand) in node.operands.iter().take(4).enumerate() {
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
    Expr::raw(Operation::Literal(value), width, vec![])
}

/// A constant bit.
#[must_use]
pub fn bit(value: bool) -> Expr {
    lit(1, u128::from(value))
}

/// The parts side by side, most significant first.
#[must_use]
pub fn cat(parts: &[&Expr]) -> Expr {
    if parts.is_empty() {
        return Expr::poison(1, "concatenation of nothing".into());
    }
    let width = parts.iter().map(|part| part.width()).sum();
    Expr::build(Operation::Concat, width, parts.iter().map(|&part| part.clone()).collect())
}

/// The entry that `index` picks; an index past the end picks the last.
#[must_use]
pub fn select(index: &Expr, entries: &[&Expr]) -> Expr {
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
    select_bits(index, index.width(), entries)
}

/// A tree of two-way choices over the lowest `bits` bits of the index.
fn select_bits(index: &Expr, bits: usize, entries: &[&Expr]) -> Expr {
    if entries.len() == 1 || bits == 0 {
        return entries[0].clone();
    }
    let top = bits - 1;
    let half = if top < usize::BITS as usize - 1 { 1 << top } else { usize::MAX };
    if entries.len() <= half {
        let below = select_bits(index, top, entries);
        return index.bit(top).mux(entries[entries.len() - 1], &below);
    }
    let (low, high) = entries.split_at(half);
    index.bit(top).mux(&select_bits(index, top, high), &select_bits(index, top, low))
}
