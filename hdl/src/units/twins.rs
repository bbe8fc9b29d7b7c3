//! Registers that are asked near and far.

use rtl::{Expr, Module, Reg};

/// A register of a bit, clear after the reset, and one of its inverse.
pub(crate) fn twins(m: &mut Module, [register, inverse]: [&str; 2]) -> [Reg; 2] {
    [m.reg_reset(register, 1, 0), m.reg_reset(inverse, 1, 1)]
}

/// Sets a register to a bit, and another to the inverse: of two that are alike synthesis would make one, however far apart those are who
/// ask. That they agree is asserted by that name.
pub(crate) fn next_twins(m: &mut Module, assertion: &str, [register, inverse]: [Reg; 2], bit: Expr) {
    m.next(register, bit);
    m.next(inverse, !bit);
    m.assert(assertion, register ^ inverse);
}
