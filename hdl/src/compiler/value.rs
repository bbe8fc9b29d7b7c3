//! Values of a program, with operators and methods that add to it.

use super::graph::ValueId;
use super::operation::Operation;
use super::program::ProgramId;
use super::table::Table;
use super::types::Type;
use pointcore_contract::{Fixed, Format};
use std::rc::Rc;

/// A value of a [`Program`](super::Program): a handle that is copied, and inert once the program is gone. The default is of no program.
#[derive(Clone, Copy, Debug, Default)]
pub struct Value {
    pub(super) program: ProgramId,
    /// `None` when a mistake led here.
    pub(super) id: Option<ValueId>,
}

impl Value {
    /// Applies any operation to this value and others.
    #[must_use]
    pub fn apply(self, operation: Operation, others: &[Self]) -> Self {
        let mnemonic = operation.mnemonic();
        let Some(program) = self.program.find() else { return Self { id: None, ..self } };
        let all = std::iter::once(self).chain(others.iter().copied());
        let operands: Result<Option<Vec<_>>, _> = all.map(|value| program.own(mnemonic, value)).collect();
        match operands {
            Ok(Some(operands)) => program.record(|graph| graph.apply(operation, &operands)),
            Ok(None) => Self { id: None, ..self },
            Err(error) => program.record(|_| Err(error)),
        }
    }

    /// Names the value for messages and for the Verilog; a port keeps its name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        if let (Some(id), Some(program)) = (self.id, self.program.find()) {
            program.name(id, name);
        }
        self
    }

    /// The value's type; `None` when a mistake led here.
    #[must_use]
    pub fn ty(self) -> Option<Type> {
        Some(self.program.find()?.type_of(self.id?))
    }

    /// `self · factor + addend`, rounded once.
    #[must_use]
    pub fn fma(self, factor: Self, addend: Self) -> Self {
        self.apply(Operation::MultiplyAdd, &[factor, addend])
    }

    /// Converts to another floating-point format.
    #[must_use]
    pub fn convert(self, format: Format) -> Self {
        self.apply(Operation::Convert(format), &[])
    }

    /// Float to fixed point, truncated and saturated.
    #[must_use]
    pub fn to_fixed(self, fixed: Fixed) -> Self {
        self.apply(Operation::ToFixed(fixed), &[])
    }

    /// An integer times `2^−fraction` as a float.
    #[must_use]
    pub fn to_float(self, format: Format, fraction: u32) -> Self {
        self.apply(Operation::ToFloat { format, fraction }, &[])
    }

    /// Looks the value up in `table`, with linear interpolation if it has fraction bits.
    #[must_use]
    pub fn kernel(self, table: &Rc<Table>) -> Self {
        self.apply(Operation::Interpolate(Rc::clone(table)), &[])
    }

    /// `when_true` where this truth value is 1, else `when_false`.
    #[must_use]
    pub fn mux(self, when_true: Self, when_false: Self) -> Self {
        self.apply(Operation::Mux, &[when_true, when_false])
    }

    /// Bits `high` down to `low`, unsigned.
    #[must_use]
    pub fn bits(self, high: u32, low: u32) -> Self {
        self.apply(Operation::Bits { high, low }, &[])
    }

    /// This value above `lower`.
    #[must_use]
    pub fn cat(self, lower: Self) -> Self {
        self.apply(Operation::Cat, &[lower])
    }

    /// Truncated or extended to `width` bits, as the value's signedness says.
    #[must_use]
    pub fn resize(self, width: u32) -> Self {
        self.apply(Operation::Resize(width), &[])
    }

    /// The value's bits as an unsigned integer, extended with zeros or truncated to `width` bits.
    #[must_use]
    pub fn zext(self, width: u32) -> Self {
        let bits = self.ty().map_or(1, Type::width);
        self.reinterpret(Type::Unsigned(bits)).resize(width)
    }

    /// The value's bits as a number of `format`.
    #[must_use]
    pub fn as_float(self, format: Format) -> Self {
        self.reinterpret(Type::Float(format))
    }

    /// The same bits under another type.
    #[must_use]
    pub fn reinterpret(self, ty: Type) -> Self {
        self.apply(Operation::Reinterpret(ty), &[])
    }
}

/// Names values after the variables that hold them; behind `in`, what stands behind each name: `name!(in "x": a, b)` names `a_x`.
macro_rules! name {
    (in $suffix:expr; $($value:ident),*) => {$(
        let _ = $value.named(&format!("{}_{}", stringify!($value), $suffix));
    )*};
    ($($value:ident),*) => {$(
        let _ = $value.named(stringify!($value));
    )*};
}
pub(crate) use name;

/// Methods of one operation, without parameters or with one more operand.
macro_rules! methods {
    ($($(#[$doc:meta])* $name:ident($($other:ident)?) = $operation:ident;)*) => {
        impl Value {$(
            $(#[$doc])*
            #[must_use]
            pub fn $name(self $(, $other: Self)?) -> Self {
                self.apply(Operation::$operation, &[$($other)?])
            }
        )*}
    };
}

methods! {
    /// Absolute value of a float.
    abs() = Absolute;
    /// `√self`.
    sqrt() = SquareRoot;
    /// `1 / self`.
    recip() = Reciprocal;
    /// `1 / √self`.
    rsqrt() = ReciprocalSquareRoot;
    /// `1 / self` from a table and Newton steps.
    recip_newton() = ReciprocalNewton;
    /// `1 / √self` from a table and Newton steps.
    rsqrt_newton() = ReciprocalSquareRootNewton;
    /// The smaller of both.
    min(other) = Minimum;
    /// The larger of both.
    max(other) = Maximum;
    /// `self < other`.
    lt(other) = Less;
    /// `self ≤ other`.
    le(other) = LessOrEqual;
    /// `self = other`; of floats as IEEE 754 has it.
    eq(other) = Equal;
}

/// Rust's operators.
macro_rules! binary_operators {
    ($($operator:ident::$method:ident = $operation:ident;)*) => {$(
        impl std::ops::$operator for Value {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.apply(Operation::$operation, &[other])
            }
        }
    )*};
}

binary_operators! {
    Add::add = Add;
    Sub::sub = Subtract;
    Mul::mul = Multiply;
    Div::div = Divide;
    BitAnd::bitand = And;
    BitOr::bitor = Or;
    BitXor::bitxor = Xor;
}

macro_rules! unary_operators {
    ($($operator:ident::$method:ident = $operation:ident;)*) => {$(
        impl std::ops::$operator for Value {
            type Output = Self;
            fn $method(self) -> Self {
                self.apply(Operation::$operation, &[])
            }
        }
    )*};
}

unary_operators! {
    Neg::neg = Negate;
    Not::not = Not;
}

/// Shifts by a constant; to the right a signed value keeps its sign.
macro_rules! shift_operators {
    ($($operator:ident::$method:ident = $operation:ident;)*) => {$(
        impl std::ops::$operator<u32> for Value {
            type Output = Self;
            fn $method(self, by: u32) -> Self {
                self.apply(Operation::$operation(by), &[])
            }
        }
    )*};
}

shift_operators! {
    Shl::shl = ShiftLeft;
    Shr::shr = ShiftRight;
}
