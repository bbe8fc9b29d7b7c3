//! Constant folding and the identities that keep comparisons and slices out of lint's way.

use super::expression::{Expr, Node, Primitive, bit, cat, lit};

/// Literals up to this width are computed here; wider ones are left to the tools.
const FOLDED_BITS: u32 = 128;

/// The simplest equivalent of a node whose operands are simple already, where it is another one.
pub(super) fn simplify(node: &Node) -> Option<Expr> {
    constant(node).or_else(|| identity(node))
}

fn mask(width: u32) -> u128 {
    if width >= FOLDED_BITS { u128::MAX } else { (1 << width) - 1 }
}

fn sign_extended(value: u128, width: u32) -> i128 {
    let unused = FOLDED_BITS - width;
    ((value << unused) as i128) >> unused
}

/// The value of a node over literals only.
fn constant(node: &Node) -> Option<Expr> {
    let width = node.width;
    let operand_widths: Vec<u32> = node.operands.iter().map(|operand| operand.width()).collect();
    if width > FOLDED_BITS || operand_widths.iter().any(|&width| width > FOLDED_BITS) {
        return None;
    }
    let values = node.operands.iter().map(|operand| operand.literal_value()).collect::<Option<Vec<u128>>>()?;
    let first = *values.first()?;
    let second = values.get(1).copied().unwrap_or(0);
    let value = match &node.operation {
        Primitive::Not => !first,
        Primitive::And => first & second,
        Primitive::Or => first | second,
        Primitive::Xor => first ^ second,
        Primitive::Add => first.wrapping_add(second),
        Primitive::Subtract => first.wrapping_sub(second),
        Primitive::Multiply => first.wrapping_mul(second),
        Primitive::MultiplySigned => {
            let product =
                sign_extended(first, operand_widths[0]).wrapping_mul(sign_extended(second, operand_widths[1]));
            product as u128
        }
        Primitive::Equal => u128::from(first == second),
        Primitive::NotEqual => u128::from(first != second),
        Primitive::Less => u128::from(first < second),
        Primitive::LessOrEqual => u128::from(first <= second),
        Primitive::LessSigned => {
            u128::from(sign_extended(first, operand_widths[0]) < sign_extended(second, operand_widths[1]))
        }
        Primitive::ShiftLeft => shift_amount(second).map_or(0, |amount| first << amount),
        Primitive::ShiftRight => shift_amount(second).map_or(0, |amount| first >> amount),
        Primitive::Slice(low) => first >> low,
        Primitive::Cat => {
            let parts = values.iter().zip(&operand_widths);
            parts.fold(0u128, |high, (value, &width)| high.checked_shl(width).unwrap_or(0) | value)
        }
        Primitive::Repeat(count) => {
            (0..*count).fold(0u128, |high, _| high.checked_shl(operand_widths[0]).unwrap_or(0) | first)
        }
        Primitive::Any => u128::from(first != 0),
        Primitive::All => u128::from(first == mask(operand_widths[0])),
        Primitive::Mux => values[if first == 1 { 1 } else { 2 }],
        Primitive::Signal(_) | Primitive::Literal(_) | Primitive::Poison(_) => return None,
    };
    Some(lit(width, value & mask(width)))
}

fn shift_amount(amount: u128) -> Option<u32> {
    u32::try_from(amount).ok().filter(|&amount| amount < FOLDED_BITS)
}

/// An operand that is a literal of all zeros or all ones.
fn is_zero(expr: Expr) -> bool {
    expr.literal_value() == Some(0)
}

fn is_ones(expr: Expr) -> bool {
    expr.width() <= FOLDED_BITS && expr.literal_value() == Some(mask(expr.width()))
}

/// They are one, or the same bits of one.
fn same(a: Expr, b: Expr) -> bool {
    let sliced = |expr: Expr| match expr.node().operation {
        Primitive::Slice(low) => Some((low, expr.width(), expr.node().operands[0].number())),
        _ => None,
    };
    a.number() == b.number() || sliced(a).is_some_and(|bits| sliced(b) == Some(bits))
}

fn identity(node: &Node) -> Option<Expr> {
    let operands = &node.operands;
    let first = *operands.first()?;
    let second = *operands.get(1).unwrap_or(&first);
    if operands.len() == 2 && same(first, second) {
        match &node.operation {
            Primitive::And | Primitive::Or => return Some(first),
            Primitive::Xor | Primitive::Subtract => return Some(lit(node.width, 0)),
            Primitive::Equal | Primitive::LessOrEqual => return Some(bit(true)),
            Primitive::NotEqual | Primitive::Less | Primitive::LessSigned => return Some(bit(false)),
            _ => {}
        }
    }
    match &node.operation {
        Primitive::Not if first.node().operation == Primitive::Not => Some(first.node().operands[0]),
        Primitive::And if is_zero(first) || is_ones(second) => Some(first),
        Primitive::And if is_zero(second) || is_ones(first) => Some(second),
        Primitive::Or if is_ones(first) || is_zero(second) => Some(first),
        Primitive::Or if is_ones(second) || is_zero(first) => Some(second),
        Primitive::Add | Primitive::Subtract | Primitive::Xor if is_zero(second) => Some(first),
        Primitive::Add | Primitive::Xor if is_zero(first) => Some(second),
        Primitive::ShiftLeft | Primitive::ShiftRight if is_zero(second) || is_zero(first) => Some(first),
        // Comparisons that every operand decides alike: lint reports them.
        Primitive::Less if is_zero(second) || is_ones(first) => Some(bit(false)),
        Primitive::LessOrEqual if is_zero(first) || is_ones(second) => Some(bit(true)),
        Primitive::Equal if first.width() == 1 => one_bit_equal(first, second),
        Primitive::Any | Primitive::All if first.width() == 1 => Some(first),
        Primitive::Repeat(1) => Some(first),
        Primitive::Slice(low) => slice(first, *low, node.width),
        Primitive::Cat => concat(operands, node.width),
        Primitive::Mux => mux(operands),
        _ => None,
    }
}

fn one_bit_equal(first: Expr, second: Expr) -> Option<Expr> {
    match (first.literal_value(), second.literal_value()) {
        (Some(1), _) => Some(second),
        (Some(_), _) => Some(!second),
        (_, Some(1)) => Some(first),
        (_, Some(_)) => Some(!first),
        _ => None,
    }
}

fn mux(operands: &[Expr]) -> Option<Expr> {
    let &[condition, when_true, when_false] = operands else { return None };
    match condition.literal_value() {
        Some(0) => return Some(when_false),
        Some(_) => return Some(when_true),
        None => {}
    }
    if same(when_true, when_false) {
        return Some(when_true);
    }
    if when_true.width() > 1 {
        return None;
    }
    match (when_true.literal_value(), when_false.literal_value()) {
        (Some(1), Some(0)) => Some(condition),
        (Some(0), Some(1)) => Some(!condition),
        _ => None,
    }
}

/// A slice of a slice or of a concatenation names the bits it means.
fn slice(source: Expr, low: u32, width: u32) -> Option<Expr> {
    if width == source.width() {
        return Some(source);
    }
    let node = source.node();
    match &node.operation {
        Primitive::Slice(inner) => Some(Expr::build(Primitive::Slice(inner + low), width, [node.operands[0]])),
        Primitive::Cat => {
            let mut pieces = Vec::new();
            let mut top = source.width();
            for part in &node.operands {
                let bottom = top - part.width();
                let (from, to) = (low.max(bottom), (low + width).min(top));
                if from < to {
                    pieces.push(part.bits(to - 1 - bottom, from - bottom));
                }
                top = bottom;
            }
            Some(cat(pieces))
        }
        Primitive::Repeat(count) if node.operands[0].width() == 1 && width < *count => {
            Some(node.operands[0].repeat(width))
        }
        _ => None,
    }
}

/// One flat list of parts; neighboring literals and neighboring slices of one signal are merged.
fn concat(operands: &[Expr], width: u32) -> Option<Expr> {
    let mut parts: Vec<Expr> = Vec::with_capacity(operands.len());
    for operand in operands {
        let node = operand.node();
        let flat = match &node.operation {
            Primitive::Cat => &node.operands,
            _ => std::slice::from_ref(operand),
        };
        for &part in flat {
            match parts.last().and_then(|&previous| merged(previous, part)) {
                Some(both) => *parts.last_mut().expect("a part was merged into the last one") = both,
                None => parts.push(part),
            }
        }
    }
    if parts.len() == 1 {
        return parts.pop();
    }
    let changed = parts.len() != operands.len() || parts.iter().zip(operands).any(|(&a, &b)| !same(a, b));
    changed.then(|| Node::new(Primitive::Cat, width, parts).keep())
}

fn merged(high: Expr, low: Expr) -> Option<Expr> {
    if let (Some(a), Some(b)) = (high.literal_value(), low.literal_value()) {
        let width = high.width() + low.width();
        return (width <= FOLDED_BITS).then(|| lit(width, a << low.width() | b));
    }
    high.adjoining(low)
}

impl Expr {
    /// Slices of one expression that lie side by side, as one.
    pub(super) fn adjoining(self, low: Self) -> Option<Self> {
        let (above, below) = (self.node(), low.node());
        let (Primitive::Slice(a), Primitive::Slice(b)) = (&above.operation, &below.operation) else { return None };
        let source = above.operands[0];
        let adjoining = same(source, below.operands[0]) && *a == b + low.width();
        adjoining.then(|| source.bits(a + self.width() - 1, *b))
    }
}
