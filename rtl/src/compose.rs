//! Expressions as Verilog text: exact widths, few parentheses, long parts in wires of their own.

use super::expression::Primitive;
use super::text::{braced, literal};
use super::writer::Writer;

/// A part of an expression that would be longer than this gets a wire.
const INLINE_CHARACTERS: usize = 64;

/// How tightly a text holds together.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// A name, a literal, anything in brackets.
    Atom,
    Unary,
    Binary(&'static str),
    Conditional,
}

impl Writer<'_> {
    /// A node as an operand: short text, in parentheses unless `fits` lets its shape stand as it is.
    fn operand(&mut self, node: usize, fits: impl Fn(Shape) -> bool) -> String {
        if self.wants_wire(node) {
            return self.whole(node);
        }
        let (text, shape) = self.compose(node);
        // A product stays a statement of its own: signedness and width of what surrounds it are kept away from it.
        if shape == Shape::Binary("*") || (text.len() > INLINE_CHARACTERS && !self.is_leaf(node)) {
            let name = self.name_value(node, &text);
            return self.read_all(&name);
        }
        if fits(shape) { text } else { format!("({text})") }
    }

    fn atom(&mut self, node: usize) -> String {
        self.operand(node, |shape| shape == Shape::Atom)
    }

    /// The text of a node from its operands.
    pub fn compose(&mut self, node: usize) -> (String, Shape) {
        let graph = self.graph;
        let description = &graph.nodes[node];
        let operands = &description.operands;
        match &description.operation {
            Primitive::Signal(signal) => {
                self.define(signal.index);
                (self.read_all(self.signal_name(signal.index)), Shape::Atom)
            }
            Primitive::Literal(value) => (literal(description.width, *value), Shape::Atom),
            Primitive::Not => (format!("~{}", self.atom(operands[0])), Shape::Unary),
            Primitive::Any => (format!("|{}", self.atom(operands[0])), Shape::Unary),
            Primitive::All => (format!("&{}", self.atom(operands[0])), Shape::Unary),
            Primitive::And => self.binary("&", operands),
            Primitive::Or => self.binary("|", operands),
            Primitive::Xor => self.binary("^", operands),
            Primitive::Add => self.binary("+", operands),
            Primitive::Subtract => self.binary("-", operands),
            Primitive::Equal => self.binary("==", operands),
            Primitive::NotEqual => self.binary("!=", operands),
            Primitive::Less => self.binary("<", operands),
            Primitive::LessOrEqual => self.binary("<=", operands),
            Primitive::ShiftLeft => self.shift("<<", operands),
            Primitive::ShiftRight => self.shift(">>", operands),
            Primitive::Multiply => {
                let factors = [0, 1].map(|index| self.zero_extended(operands[index], description.width));
                (factors.join(" * "), Shape::Binary("*"))
            }
            Primitive::MultiplySigned => {
                let factors = [0, 1].map(|index| self.sign_extended(operands[index], description.width));
                (factors.join(" * "), Shape::Binary("*"))
            }
            Primitive::LessSigned => {
                let sides = [0, 1].map(|index| format!("$signed({})", self.operand(operands[index], |_| true)));
                (sides.join(" < "), Shape::Binary("<"))
            }
            Primitive::Slice(low) => (self.slice(operands[0], *low, description.width), Shape::Atom),
            Primitive::Cat => {
                let parts: Vec<String> = operands.iter().map(|&part| self.operand(part, |_| true)).collect();
                (braced(&parts), Shape::Atom)
            }
            Primitive::Repeat(count) => {
                (format!("{{{count}{{{}}}}}", self.operand(operands[0], |_| true)), Shape::Atom)
            }
            Primitive::Mux => {
                let simple = |shape| matches!(shape, Shape::Atom | Shape::Unary);
                let condition = self.operand(operands[0], simple);
                let when_true = self.operand(operands[1], simple);
                let when_false = self.operand(operands[2], |shape| simple(shape) || shape == Shape::Conditional);
                (format!("{condition} ? {when_true} : {when_false}"), Shape::Conditional)
            }
            Primitive::Poison(mistake) => unreachable!("a module with poison is not written: {}", mistake.message),
        }
    }

    /// Left-associative chains of one associative operator stay flat.
    fn binary(&mut self, symbol: &'static str, operands: &[usize]) -> (String, Shape) {
        let chains = ["&", "|", "^", "+"].contains(&symbol);
        let simple = |shape| matches!(shape, Shape::Atom | Shape::Unary);
        let left = self.operand(operands[0], |shape| simple(shape) || (chains && shape == Shape::Binary(symbol)));
        let right = self.operand(operands[1], simple);
        (format!("{left} {symbol} {right}"), Shape::Binary(symbol))
    }

    fn shift(&mut self, symbol: &'static str, operands: &[usize]) -> (String, Shape) {
        let simple = |shape| matches!(shape, Shape::Atom | Shape::Unary);
        let value = self.operand(operands[0], simple);
        let amount = match self.graph.nodes[operands[1]].operation {
            Primitive::Literal(amount) => amount.to_string(),
            _ => self.operand(operands[1], simple),
        };
        (format!("{value} {symbol} {amount}"), Shape::Binary(symbol))
    }

    fn zero_extended(&mut self, node: usize, width: u32) -> String {
        let missing = width - self.graph.nodes[node].width;
        format!("{{{}, {}}}", literal(missing, 0), self.operand(node, |_| true))
    }

    fn sign_extended(&mut self, node: usize, width: u32) -> String {
        let own = self.graph.nodes[node].width;
        let sign = self.slice(node, own - 1, 1);
        let value = self.whole(node);
        format!("$signed({{{{{}{{{sign}}}}}, {value}}})", width - own)
    }

    /// Bits of something that has a name, or gets one.
    pub fn slice(&mut self, node: usize, low: u32, width: u32) -> String {
        let name = self.name_of(node);
        let whole = self.graph.nodes[node].width;
        if let Some(bits) = self.bits_read.get_mut(&name) {
            bits[low as usize..(low + width) as usize].fill(true);
        }
        match (whole, width) {
            (1, _) => name,
            (_, 1) => format!("{name}[{low}]"),
            _ => format!("{name}[{}:{low}]", low + width - 1),
        }
    }
}
