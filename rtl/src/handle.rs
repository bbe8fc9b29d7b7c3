//! Registers and wires as a description refers to them: they read as their values.

use std::ops::Deref;

use super::expression::Expr;

/// A register; reads as its current value.
#[derive(Clone, Copy)]
pub struct Reg(Expr);

/// A wire that is driven after its declaration; reads as its value.
#[derive(Clone, Copy)]
pub struct Wire(Expr);

macro_rules! readable {
    ($handle:ty) => {
        impl $handle {
            pub(super) const fn of(signal: Expr) -> Self {
                Self(signal)
            }

            /// Its value as an expression.
            #[must_use]
            pub const fn expr(self) -> Expr {
                self.0
            }
        }

        impl Deref for $handle {
            type Target = Expr;
            fn deref(&self) -> &Expr {
                &self.0
            }
        }

        impl From<$handle> for Expr {
            fn from(handle: $handle) -> Self {
                handle.0
            }
        }
    };
}

readable!(Reg);
readable!(Wire);
