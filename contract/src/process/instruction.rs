//! The operations that statements name, and how each is made of nodes.

use super::builder::{Builder, Value};
use super::layout::Type::{self, Bool, Float, Float3, Int};
use super::operation::Operation;

/// How an operation's result is made.
#[derive(Clone, Copy)]
enum Form {
    /// Component by component; an operand of one word serves all of them.
    Each(Operation),
    /// `(x·x′ + y·y′) + z·z′`.
    Dot,
    /// `y·z′ − z·y′` and so on.
    Cross,
    /// A vector's `dot` with itself.
    Length2,
    /// The root of it.
    Length,
    /// A vector of its components.
    Vector,
}

/// An operation on operands of given types.
struct Instruction {
    name: &'static str,
    operands: &'static [Type],
    result: Type,
    form: Form,
}

/// A line of the table: `name operand, operand -> result = form`.
macro_rules! instructions {
    ($($name:ident $($operand:ident),+ -> $result:ident = $form:expr;)*) => {
        &[$(Instruction { name: stringify!($name), operands: &[$($operand),+], result: $result, form: $form }),*]
    };
}

/// All of them; docs/programs.md has the same table in words.
const INSTRUCTIONS: &[Instruction] = {
    use Form::{Cross, Dot, Each, Length, Length2, Vector};
    use Operation as O;
    instructions! {
        add Float, Float -> Float = Each(O::Add);
        add Float3, Float3 -> Float3 = Each(O::Add);
        add Int, Int -> Int = Each(O::Add);
        sub Float, Float -> Float = Each(O::Subtract);
        sub Float3, Float3 -> Float3 = Each(O::Subtract);
        sub Int, Int -> Int = Each(O::Subtract);
        mul Float, Float -> Float = Each(O::Multiply);
        mul Int, Int -> Int = Each(O::Multiply);
        scale Float3, Float -> Float3 = Each(O::Multiply);
        fma Float, Float, Float -> Float = Each(O::MultiplyAdd);
        div Float, Float -> Float = Each(O::Divide);
        recip Float -> Float = Each(O::Reciprocal);
        sqrt Float -> Float = Each(O::SquareRoot);
        rsqrt Float -> Float = Each(O::ReciprocalSquareRoot);
        exp_neg Float -> Float = Each(O::ExpNegative);
        min Float, Float -> Float = Each(O::Minimum);
        min Int, Int -> Int = Each(O::Minimum);
        max Float, Float -> Float = Each(O::Maximum);
        max Int, Int -> Int = Each(O::Maximum);
        abs Float -> Float = Each(O::Absolute);
        neg Float -> Float = Each(O::Negate);
        neg Float3 -> Float3 = Each(O::Negate);
        neg Int -> Int = Each(O::Negate);
        dot Float3, Float3 -> Float = Dot;
        cross Float3, Float3 -> Float3 = Cross;
        length2 Float3 -> Float = Length2;
        length Float3 -> Float = Length;
        vector Float, Float, Float -> Float3 = Vector;
        less Float, Float -> Bool = Each(O::Less);
        less Int, Int -> Bool = Each(O::Less);
        less_or_equal Float, Float -> Bool = Each(O::LessOrEqual);
        less_or_equal Int, Int -> Bool = Each(O::LessOrEqual);
        equal Float, Float -> Bool = Each(O::Equal);
        equal Int, Int -> Bool = Each(O::Equal);
        and Bool, Bool -> Bool = Each(O::And);
        and Int, Int -> Int = Each(O::And);
        or Bool, Bool -> Bool = Each(O::Or);
        or Int, Int -> Int = Each(O::Or);
        xor Bool, Bool -> Bool = Each(O::Xor);
        xor Int, Int -> Int = Each(O::Xor);
        not Bool -> Bool = Each(O::Not);
        not Int -> Int = Each(O::Not);
        select Bool, Float, Float -> Float = Each(O::Select);
        select Bool, Float3, Float3 -> Float3 = Each(O::Select);
        select Bool, Int, Int -> Int = Each(O::Select);
        select Bool, Bool, Bool -> Bool = Each(O::Select);
        to_float Int -> Float = Each(O::ToFloat);
        to_int Float -> Int = Each(O::ToInt);
    }
};

/// Names of all operations, each once.
pub(super) fn names() -> Vec<String> {
    let mut names: Vec<String> = INSTRUCTIONS.iter().map(|instruction| instruction.name.to_owned()).collect();
    names.dedup();
    names
}

/// What the operation of that name expects, in words; nothing if there is none.
pub(super) fn expected(name: &str) -> Option<String> {
    let forms = INSTRUCTIONS.iter().filter(|instruction| instruction.name == name);
    let forms: Vec<String> = forms.map(|instruction| list(instruction.operands)).collect();
    (!forms.is_empty()).then(|| forms.join(" or "))
}

/// Types, separated by commas.
pub(super) fn list(types: &[Type]) -> String {
    types.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// Adds the operation of that name on these operands to a block; nothing if they do not suit it.
pub(super) fn apply(builder: &mut Builder<'_>, name: &str, operands: &[Value]) -> Option<Value> {
    let suits = |instruction: &&Instruction| {
        instruction.name == name && operands.iter().map(|operand| operand.ty).eq(instruction.operands.iter().copied())
    };
    let instruction = INSTRUCTIONS.iter().find(suits)?;
    let ty = instruction.result;
    let words = match instruction.form {
        Form::Each(operation) => {
            let word = |operand: &Value, index: usize| operand.words[index.min(operand.words.len() - 1)];
            let components = 0..ty.words();
            components
                .map(|index| {
                    let operands = operands.iter().map(|operand| word(operand, index)).collect();
                    builder.node(operation, operands, ty.scalar())
                })
                .collect()
        }
        Form::Dot => vec![dot(builder, &operands[0], &operands[1])],
        Form::Length2 => vec![dot(builder, &operands[0], &operands[0])],
        Form::Length => {
            let squared = dot(builder, &operands[0], &operands[0]);
            vec![builder.node(Operation::SquareRoot, vec![squared], ty.scalar())]
        }
        Form::Cross => cross(builder, &operands[0], &operands[1]),
        Form::Vector => operands.iter().map(|operand| operand.words[0]).collect(),
    };
    Some(Value { ty, words })
}

fn dot(builder: &mut Builder<'_>, a: &Value, b: &Value) -> super::NodeId {
    let [x, y, z] = [0, 1, 2].map(|axis| builder.float(Operation::Multiply, a.words[axis], b.words[axis]));
    let sum = builder.float(Operation::Add, x, y);
    builder.float(Operation::Add, sum, z)
}

fn cross(builder: &mut Builder<'_>, a: &Value, b: &Value) -> Vec<super::NodeId> {
    let component = |(first, second): (usize, usize)| {
        let left = builder.float(Operation::Multiply, a.words[first], b.words[second]);
        let right = builder.float(Operation::Multiply, a.words[second], b.words[first]);
        builder.float(Operation::Subtract, left, right)
    };
    [(1, 2), (2, 0), (0, 1)].map(component).to_vec()
}
