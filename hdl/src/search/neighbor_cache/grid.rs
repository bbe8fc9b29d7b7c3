//! The grid on which queries are near each other or not (thesis 6.6.3 asks for queries that are not under way together); golden
//! twin: `pointcore_golden::search::neighbor_cache`.

use std::ops::RangeInclusive;

use pointcore_contract::Format;

use rtl::{Expr, Module, Reg, Wire, bit, cat, lit};

/// Bits of a place on an axis.
pub(super) const PLACE_BITS: u32 = 12;
/// Bits of a shift that leaves anything of a number.
const SHIFT_BITS: u32 = 6;
/// Bits of the number of units that are near.
const LIMIT_BITS: u32 = 5;
/// Exponents by which the margin that a unit is taken from is above it.
const TAKEN: u32 = 3;
/// Those by which a margin may be above it later.
const KEPT: RangeInclusive<u32> = 2..=4;
/// Exponents of margins that are followed.
const MEASURED: RangeInclusive<u128> = 4..=254;

/// A margin that was computed, where `valid`.
#[derive(Clone, Copy)]
pub(super) struct Measured {
    pub valid: Expr,
    pub margin: Expr,
}

/// What moves a coordinate to its place on the grid, held in registers.
#[derive(Clone, Copy)]
pub(super) struct Shift {
    amount: Reg,
    /// It leaves something of the number.
    is_inside: Reg,
}

/// The grid's unit.
pub(super) struct Grid {
    format: Format,
    pub known: Reg,
    /// Biased exponent of the unit.
    unit: Reg,
    /// Units from which on places are far.
    limit: Reg,
    /// The unit changes in this cycle.
    pub changes: Wire,
}

/// Biased exponent of a number.
fn exponent(format: Format, number: Expr) -> Expr {
    number.bits(format.mantissa + format.exponent - 1, format.mantissa)
}

impl Grid {
    /// Unknown after reset.
    pub fn new(m: &mut Module, format: Format) -> Self {
        let known = m.reg_reset("grid_known", 1, 0);
        let unit = m.reg("grid_unit", format.exponent);
        let limit = m.reg("grid_limit", LIMIT_BITS);
        let changes = m.forward("grid_changes", 1);
        Self { format, known, unit, limit, changes }
    }

    /// The shift of a coordinate, taken where `enable` is set.
    pub fn shift(&self, m: &mut Module, name: &str, enable: Expr, coordinate: Expr) -> Shift {
        // unit + M + 11 − e lies within −229 and 289: ten bits, of which the top one is the sign.
        let wide = self.format.exponent + 2;
        let bias = u128::from(self.format.mantissa + PLACE_BITS - 1);
        let exponent = exponent(self.format, coordinate).zext(wide);
        let shift = m.wire(&format!("{name}_shift"), self.unit.zext(wide).add_lit(bias) - exponent);
        let amount = m.reg(&format!("{name}_amount"), SHIFT_BITS);
        let is_inside = m.reg(&format!("{name}_inside"), 1);
        m.next_if(amount, enable, shift.trunc(SHIFT_BITS));
        m.next_if(is_inside, enable, shift.bits(wide - 1, SHIFT_BITS).is_zero());
        Shift { amount, is_inside }
    }

    /// The place of a coordinate on its axis.
    pub fn place(&self, coordinate: Expr, shift: Shift) -> Expr {
        let mantissa = coordinate.trunc(self.format.mantissa);
        let significand = cat([bit(true), mantissa, lit(PLACE_BITS - 1, 0)]);
        let units = significand.shr_by(shift.amount).trunc(PLACE_BITS) & shift.is_inside.repeat(PLACE_BITS);
        units ^ coordinate.bit(self.format.width() - 1).repeat(PLACE_BITS)
    }

    /// Whether two places on an axis differ by less than the limit.
    pub fn is_near(&self, a: Expr, b: Expr) -> Expr {
        let offset = a - b;
        let (low, rest) = (offset.trunc(LIMIT_BITS), offset.bits(PLACE_BITS - 1, LIMIT_BITS));
        // Of a negative offset, the lower bits are what it is above −32.
        let above = lit(LIMIT_BITS, 0) - self.limit.expr();
        (rest.is_zero() & low.lt(self.limit)) | (rest.all() & low.gt(above))
    }

    /// Follows a margin, and forgets what it knows where `forgets` is set; to be called once.
    pub fn update(self, m: &mut Module, measured: Measured, forgets: Expr) {
        let Measured { valid, margin } = measured;
        let Format { mantissa, .. } = self.format;
        let exponent = exponent(self.format, margin);
        let is_normal = exponent.ge_lit(*MEASURED.start()) & exponent.lt_lit(MEASURED.end() + 1);
        let sign = margin.bit(self.format.width() - 1);
        let follows = m.wire("grid_follows", valid & (!sign & is_normal));
        let bits = exponent.width() + 1;
        let above = m.wire("margin_above_unit", exponent.zext(bits) - self.unit.zext(bits));
        // The significand's leading bits, as many as its exponent is above the unit's, and one.
        let leading = |above: u32| cat([bit(true), margin.bits(mantissa - 1, mantissa - above)]).zext(LIMIT_BITS);
        let as_taken = (self.known & above.eq_lit(u128::from(TAKEN)), leading(TAKEN));
        let others = KEPT.filter(|kept| *kept != TAKEN);
        let kept = others.map(|kept| (self.known & above.eq_lit(u128::from(kept)), leading(kept)));
        let (keeps, limit) =
            kept.fold(as_taken, |(keeps, limit), (is_so, leading)| (keeps | is_so, is_so.mux(leading, limit)));
        let changes = m.wire("grid_moves", follows & !keeps);
        m.drive(self.changes, changes);
        m.next_if(self.limit, follows, limit);
        m.next_if(self.unit, changes, exponent.sub_lit(u128::from(TAKEN)));
        m.next(self.known, (self.known | follows) & !forgets);
    }
}
