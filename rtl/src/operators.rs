//! The operators of expressions, each with its width rule.

use std::ops;

use super::expression::{Expr, Primitive, lit};
use super::handle::{Reg, Wire};

impl Expr {
    /// Two operands of one width.
    #[track_caller]
    fn same_width(self, symbol: &str, operation: Primitive, width: u32, other: Expr) -> Expr {
        if self.width() != other.width() && !self.is_tainted() && !other.is_tainted() {
            let message =
                format!("width mismatch in `{self} {symbol} {other}`: {} and {}", self.width(), other.width());
            return Expr::poison(width, message + " bits");
        }
        Expr::build(operation, width, [self, other])
    }

    /// A condition of one bit is needed here.
    #[track_caller]
    pub(super) fn as_condition(self, what: &str) -> Expr {
        if self.width() == 1 || self.is_tainted() {
            return self;
        }
        Expr::poison(1, format!("{what} `{self}` has {} bits instead of 1", self.width()))
    }

    /// A product is as wide as both factors together.
    #[track_caller]
    fn product(self, primitive: Primitive, other: Self) -> Self {
        Self::build(primitive, self.width() + other.width(), [self, other])
    }

    /// Two's complement product, as wide as both operands together.
    #[must_use]
    #[track_caller]
    pub fn mul_signed(self, other: impl Into<Self>) -> Self {
        self.product(Primitive::MultiplySigned, other.into())
    }

    /// Sum with its carry: one bit wider than the operands.
    #[must_use]
    #[track_caller]
    pub fn add_carry(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        let width = self.width() + 1;
        self.zext(width).same_width("+", Primitive::Add, width, other.zext(other.width() + 1))
    }

    /// Equal.
    #[must_use]
    #[track_caller]
    pub fn eq(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        self.same_width("==", Primitive::Equal, 1, other)
    }

    /// Not equal.
    #[must_use]
    #[track_caller]
    pub fn ne(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        self.same_width("!=", Primitive::NotEqual, 1, other)
    }

    /// Unsigned less.
    #[must_use]
    #[track_caller]
    pub fn lt(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        self.same_width("<", Primitive::Less, 1, other)
    }

    /// Unsigned less or equal.
    #[must_use]
    #[track_caller]
    pub fn le(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        self.same_width("<=", Primitive::LessOrEqual, 1, other)
    }

    /// Unsigned greater.
    #[must_use]
    #[track_caller]
    pub fn gt(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        other.lt(self)
    }

    /// Unsigned greater or equal.
    #[must_use]
    #[track_caller]
    pub fn ge(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        other.le(self)
    }

    /// Two's complement less.
    #[must_use]
    #[track_caller]
    pub fn lt_signed(self, other: impl Into<Expr>) -> Expr {
        let other = other.into();
        self.same_width("<", Primitive::LessSigned, 1, other)
    }

    /// Equal to a constant.
    #[must_use]
    #[track_caller]
    pub fn eq_lit(self, value: u128) -> Expr {
        self.eq(lit(self.width(), value))
    }

    /// Plus a constant; wraps.
    #[must_use]
    #[track_caller]
    pub fn add_lit(self, value: u128) -> Expr {
        self + lit(self.width(), value)
    }

    /// Minus a constant; wraps.
    #[must_use]
    #[track_caller]
    pub fn sub_lit(self, value: u128) -> Expr {
        self - lit(self.width(), value)
    }

    /// Unsigned less than a constant.
    #[must_use]
    #[track_caller]
    pub fn lt_lit(self, value: u128) -> Expr {
        self.lt(lit(self.width(), value))
    }

    /// Unsigned greater than or equal to a constant.
    #[must_use]
    #[track_caller]
    pub fn ge_lit(self, value: u128) -> Expr {
        self.ge(lit(self.width(), value))
    }

    #[track_caller]
    fn shift(self, operation: Primitive, amount: u32) -> Expr {
        if amount >= self.width() {
            return lit(self.width(), 0);
        }
        let bits = (u32::BITS - amount.leading_zeros()).max(1);
        Expr::build(operation, self.width(), [self, lit(bits, amount.into())])
    }

    /// Shifted right by a constant, copies of the sign from the left, same width.
    #[must_use]
    #[track_caller]
    pub fn sar(self, amount: u32) -> Expr {
        let kept = amount.min(self.width() - 1);
        self.bits(self.width() - 1, kept).sext(self.width())
    }

    /// Shifted left by a variable amount, zeros from the right, same width.
    #[must_use]
    #[track_caller]
    pub fn shl_by(self, amount: impl Into<Expr>) -> Expr {
        let amount = amount.into();
        Expr::build(Primitive::ShiftLeft, self.width(), [self, amount])
    }

    /// Shifted right by a variable amount, zeros from the left, same width.
    #[must_use]
    #[track_caller]
    pub fn shr_by(self, amount: impl Into<Expr>) -> Expr {
        let amount = amount.into();
        Expr::build(Primitive::ShiftRight, self.width(), [self, amount])
    }

    /// Some bit is set.
    #[must_use]
    #[track_caller]
    pub fn any(self) -> Expr {
        Expr::build(Primitive::Any, 1, [self])
    }

    /// Every bit is set.
    #[must_use]
    #[track_caller]
    pub fn all(self) -> Expr {
        Expr::build(Primitive::All, 1, [self])
    }

    /// No bit is set.
    #[must_use]
    #[track_caller]
    pub fn is_zero(self) -> Expr {
        self.eq_lit(0)
    }

    /// `when_true` where this bit is set, else `when_false`.
    #[must_use]
    #[track_caller]
    pub fn mux(self, when_true: impl Into<Expr>, when_false: impl Into<Expr>) -> Expr {
        let (when_true, when_false) = (when_true.into(), when_false.into());
        let (width, other) = (when_true.width(), when_false.width());
        if width != other && !when_true.is_tainted() && !when_false.is_tainted() {
            let message = format!("width mismatch in `{self} ? {when_true} : {when_false}`: {width} and {other} bits");
            return Expr::poison(width, message);
        }
        let condition = self.as_condition("selector");
        Expr::build(Primitive::Mux, width, [condition, when_true, when_false])
    }
}

/// A binary operator of the language for every mix of expressions, registers and wires.
macro_rules! binary_operator {
    ($trait:ident, $method:ident, |$a:ident, $b:ident| $build:expr) => {
        binary_operator!($trait, $method, |$a, $b| $build; Expr, Reg, Wire);
    };
    ($trait:ident, $method:ident, |$a:ident, $b:ident| $build:expr; $($left:ty),+) => {$(
        impl<R: Into<Expr>> ops::$trait<R> for $left {
            type Output = Expr;
            #[track_caller]
            fn $method(self, right: R) -> Expr {
                let ($a, $b): (Expr, Expr) = (self.into(), right.into());
                $build
            }
        }
    )+};
}

binary_operator!(Add, add, |a, b| a.same_width("+", Primitive::Add, a.width(), b));
binary_operator!(Sub, sub, |a, b| a.same_width("-", Primitive::Subtract, a.width(), b));
binary_operator!(BitAnd, bitand, |a, b| a.same_width("&", Primitive::And, a.width(), b));
binary_operator!(BitOr, bitor, |a, b| a.same_width("|", Primitive::Or, a.width(), b));
binary_operator!(BitXor, bitxor, |a, b| a.same_width("^", Primitive::Xor, a.width(), b));
binary_operator!(Mul, mul, |a, b| a.product(Primitive::Multiply, b));

/// A shift by a constant: zeros come in, the width stays.
macro_rules! shift_operator {
    ($trait:ident, $method:ident, $primitive:ident; $($left:ty),+) => {$(
        impl ops::$trait<u32> for $left {
            type Output = Expr;
            #[track_caller]
            fn $method(self, amount: u32) -> Expr {
                Expr::from(self).shift(Primitive::$primitive, amount)
            }
        }
    )+};
}

shift_operator!(Shl, shl, ShiftLeft; Expr, Reg, Wire);
shift_operator!(Shr, shr, ShiftRight; Expr, Reg, Wire);

macro_rules! not_operator {
    ($($operand:ty),+) => {$(
        impl ops::Not for $operand {
            type Output = Expr;
            #[track_caller]
            fn not(self) -> Expr {
                let operand = Expr::from(self);
                Expr::build(Primitive::Not, operand.width(), [operand])
            }
        }
    )+};
}

not_operator!(Expr, Reg, Wire);
