//! Width-checked expressions: values that are copied and never panic.
//!
//! A mistake (widths that differ, a bit that is not there) becomes a poison node carrying its message; elaboration
//! reports it with the module it ended up in.

use std::fmt;
use std::marker::PhantomData;
use std::panic::Location;
use std::rc::Rc;

use super::arena;
use super::error::Place;
use super::simplify::simplify;

/// An expression of a known width.
///
/// It is a handle that is copied. What it stands for is kept by the thread as long as any [`Module`](crate::Module) of
/// the thread lives, whether something still uses it or not; an expression that is used later is an error at
/// elaboration.
#[derive(Clone, Copy)]
pub struct Expr {
    number: u64,
    width: u32,
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

/// An error in an expression.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Mistake {
    pub message: Rc<str>,
    /// Where it was made; none where that is forgotten.
    pub place: Option<Place>,
}

/// What a node computes from its operands. The node's width completes the description.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Primitive {
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
    Slice(u32),
    /// Operands side by side, most significant first.
    Cat,
    /// The operand this many times.
    Repeat(u32),
    Any,
    All,
    /// `operands[0] ? operands[1] : operands[2]`.
    Mux,
    /// An error that was made while building.
    Poison(Mistake),
}

/// What an expression stands for.
pub(super) struct Node {
    pub operation: Primitive,
    pub width: u32,
    pub operands: Box<[Expr]>,
    /// A poison node lies below: widths are guesses and are not checked again.
    pub tainted: bool,
}

impl Node {
    #[track_caller]
    pub fn new(operation: Primitive, width: u32, operands: impl Into<Box<[Expr]>>) -> Self {
        let operands = operands.into();
        let tainted = matches!(operation, Primitive::Poison(_)) || operands.iter().any(|operand| operand.is_tainted());
        Self { operation, width, operands, tainted }
    }

    /// Keeps the node exactly as it is.
    pub fn keep(self) -> Expr {
        Expr { width: self.width, number: arena::keep(self), thread: PhantomData }
    }
}

/// What stands in the place of an expression that is not there; using it is an error at elaboration.
impl Default for Expr {
    fn default() -> Self {
        Self { number: arena::NOTHING, width: 1, thread: PhantomData }
    }
}

impl Expr {
    /// A node in its simplest form.
    #[track_caller]
    pub(super) fn build(operation: Primitive, width: u32, operands: impl Into<Box<[Self]>>) -> Self {
        let node = Node::new(operation, width, operands);
        let simpler = if node.tainted { None } else { simplify(&node) };
        simpler.unwrap_or_else(|| node.keep())
    }

    /// The mark of an error, with the width that was probably meant.
    #[track_caller]
    pub(super) fn poison(width: u32, message: String) -> Self {
        let mistake = Mistake { message: message.into(), place: Some(Location::caller()) };
        Node::new(Primitive::Poison(mistake), width.max(1), []).keep()
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
            Primitive::Literal(value) => Some(value),
            _ => None,
        }
    }

    /// Number of bits.
    #[must_use]
    pub const fn width(self) -> u32 {
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
        Primitive::Signal(signal) => return f.write_str(&signal.name),
        Primitive::Literal(value) => return write!(f, "{}'d{value}", node.width),
        Primitive::Poison(_) => return f.write_str("<error>"),
        _ if depth == 0 => return f.write_str("…"),
        Primitive::Slice(low) => {
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
#[track_caller]
pub fn lit(width: u32, value: u128) -> Expr {
    if width == 0 {
        return Expr::poison(1, format!("literal {value} has no bits"));
    }
    if width < 128 && value >> width != 0 {
        return Expr::poison(width, format!("literal {value} does not fit {width} bits"));
    }
    Node::new(Primitive::Literal(value), width, []).keep()
}

/// A constant bit.
#[must_use]
#[track_caller]
pub fn bit(value: bool) -> Expr {
    lit(1, u128::from(value))
}

/// The parts side by side, most significant first.
#[must_use]
#[track_caller]
pub fn cat(parts: impl IntoIterator<Item = impl Into<Expr>>) -> Expr {
    let parts: Box<[Expr]> = parts.into_iter().map(Into::into).collect();
    if parts.is_empty() {
        return Expr::poison(1, "concatenation of nothing".into());
    }
    let width = parts.iter().map(|part| part.width()).sum();
    Expr::build(Primitive::Cat, width, parts)
}

impl Expr {
    /// The entry that this index picks; an index past the end picks the last.
    #[must_use]
    #[track_caller]
    pub fn pick(self, entries: impl IntoIterator<Item = impl Into<Self>>) -> Self {
        let entries: Vec<_> = entries.into_iter().map(|entry| Some(entry.into())).collect();
        self.pick_or(&entries, entries.last().copied().flatten())
    }

    /// The entry that this index picks, where it never is one without an entry or past the end: those take no choice.
    #[must_use]
    #[track_caller]
    pub fn pick_some(self, entries: impl IntoIterator<Item = Option<Self>>) -> Self {
        self.pick_or(&entries.into_iter().collect::<Vec<_>>(), None)
    }

    #[track_caller]
    fn pick_or(self, entries: &[Option<Self>], beyond: Option<Self>) -> Self {
        let Some(last) = entries.iter().copied().flatten().next_back() else {
            return Self::poison(1, format!("`{self}` picks from nothing"));
        };
        if let Some(odd) = entries.iter().flatten().find(|entry| entry.width() != last.width()) {
            let message = format!("entries that `{self}` picks from: `{odd}` has {} bits", odd.width());
            return Self::poison(last.width(), format!("{message}, `{last}` has {}", last.width()));
        }
        if entries.len() > places(self.width()) {
            let message = format!("`{self}` has {} bits and cannot pick from {} entries", self.width(), entries.len());
            return Self::poison(last.width(), message);
        }
        self.pick_by(self.width(), entries, beyond).unwrap_or(last)
    }

    /// A tree of two-way choices over the lowest `bits` bits of the index.
    #[track_caller]
    fn pick_by(self, bits: u32, entries: &[Option<Self>], beyond: Option<Self>) -> Option<Self> {
        if entries.is_empty() {
            return beyond;
        }
        if bits == 0 {
            return entries[0];
        }
        let top = bits - 1;
        let (low, high) = entries.split_at(places(top).min(entries.len()));
        match [low, high].map(|half| self.pick_by(top, half, beyond)) {
            [Some(low), Some(high)] => Some(self.bit(top).mux(high, low)),
            [low, high] => low.or(high),
        }
    }
}

/// How many entries an index of so many bits tells apart.
fn places(bits: u32) -> usize {
    1_usize.checked_shl(bits).unwrap_or(usize::MAX)
}
