//! Setup's end for a rasterizer in fixed point: coefficients as integers with one power of two in common; golden twin:
//! `pointcore_golden::splat::fixed_footprint`.

use super::Projection;
use super::exponent::Exponents;
use crate::compiler::{Program, Type, Value};
use crate::units::values::Values;
use pointcore_contract::splat::Coefficient;
use pointcore_contract::splat::records::Footprint;
use pointcore_contract::{Fixed, Format, Signedness};

/// Biased exponent of numbers from one half to one.
const HALF: u64 = 126;
/// Biased exponent of infinities and NaNs.
const NOT_FINITE: u64 = 255;
/// Bits in which biased exponents are added and subtracted: of the largest twice, and some.
const EXPONENT_BITS: u32 = 10;

/// What the steps share.
struct Rounding<'a> {
    program: &'a Program,
    /// The geometry format.
    format: Format,
}

/// The fields of a footprint but for its depth.
pub(super) fn footprint(
    program: &Program,
    format: Format,
    coefficient: Coefficient,
    splat: &Projection,
) -> Footprint<Values> {
    let rounding = Rounding { program, format };
    let place = coefficient.center();
    let limit = HALF + u64::from(Coefficient::CENTER_INTEGER_BITS);
    let [in_x, in_y] = splat.center.map(|center| rounding.exponent(center).lt(rounding.integer(limit)));
    let placed = (in_x & in_y).named("placed");
    let beside = program.constant(Type::Signed(place.width), 1 << (place.width - 1));
    let center = splat.center.map(|center| placed.mux(rounding.rounded(center, place), beside));
    let shift = rounding.shift(coefficient, &center, &splat.pixels).named("shift");

    let delta_width = coefficient.delta_width();
    let lowered = shift.resize(EXPONENT_BITS) + rounding.integer((delta_width - coefficient.width()).into());
    let delta_exponent = rounding.exponent(splat.delta);
    let none = rounding.integer(0);
    let delta_relative = lowered.lt(delta_exponent).mux(delta_exponent - lowered, none);
    let lengths = [splat.a[0], splat.b[0], splat.a[1], splat.b[1], splat.m[0], splat.m[1]];
    let exponents = lengths.map(|length| rounding.exponent(length));
    let exponent = exponents.iter().fold(delta_relative, |largest, exponent| largest.max(*exponent)).named("exponent");

    let [ax, bx, ay, by, mx, my] = lengths.map(|length| rounding.fraction(length, exponent, coefficient.width()));
    let delta = rounding.fraction(splat.delta, exponent + lowered, delta_width);
    let odd = exponents.iter().chain([&delta_exponent]).map(|exponent| exponent.eq(rounding.integer(NOT_FINITE)));
    let odd = odd.reduce(|one, other| one | other).expect("there are seven").named("odd");
    let signed_delta = |value: i64| {
        let ty = Type::Signed(delta_width);
        program.constant(ty, value as u64 & ty.mask())
    };
    let least = i64::from(coefficient.delta_least());
    let vanishes = (delta.lt(signed_delta(least)) & signed_delta(-least).lt(delta)).named("vanishes");
    let covers_nothing = (splat.edge_on | !placed | odd | vanishes).named("covers_nothing");

    let or_none = |value: Value| {
        let none = program.constant(value.ty().unwrap_or(Type::BOOL), 0);
        covers_nothing.mux(none, value)
    };
    let [ax, bx, ay, by, delta, mx, my] = [ax, bx, ay, by, delta, mx, my].map(or_none);
    let sight = splat.limits.map(|limits| {
        let [(no_near, near), (no_far, far)] = limits.planes;
        let units = |limit: Value| rounding.units(limit, exponent + lowered, delta_width);
        let [none, all] = [0, u64::MAX >> (u64::BITS - delta_width)].map(|bits| program.lit(delta_width, bits));
        limits.sight([no_near.mux(all, units(near)), no_far.mux(none, units(far))].map(or_none))
    });
    let sight = sight.unwrap_or_default();
    Footprint { center, ax, bx, ay, by, delta, mx, my, shift, sight, ..Footprint::default() }
}

impl Rounding<'_> {
    fn integer(&self, value: u64) -> Value {
        self.program.lit(EXPONENT_BITS, value)
    }

    /// The biased exponent.
    fn exponent(&self, value: Value) -> Value {
        value.bits(self.format.width() - 2, self.format.mantissa).resize(EXPONENT_BITS)
    }

    /// `value · 2^(126 − exponent)`, below one in magnitude, as a signed fraction.
    fn fraction(&self, value: Value, exponent: Value, width: u32) -> Value {
        let own = self.exponent(value);
        let raised = own + self.integer(HALF);
        let is_number = exponent.lt(raised) & !own.eq(self.integer(0));
        let field = is_number.mux(raised - exponent, self.integer(0)).resize(self.format.exponent);
        let top = self.format.width() - 1;
        let bits = value.bits(top, top).cat(field).cat(value.bits(self.format.mantissa - 1, 0));
        let scaled = bits.reinterpret(Type::Float(self.format));
        self.rounded(scaled, Fixed { width, fraction: width - 1, signed: Signedness::Signed })
    }

    /// The magnitude of `value · 2^(126 − exponent)` in units of a `Δ` so wide, truncated and saturated.
    fn units(&self, value: Value, exponent: Value, width: u32) -> Value {
        let exponents = Exponents { program: self.program, format: self.format };
        let wide = |bits: Value| bits.resize(exponents.lit(0).ty().map_or(1, Type::width));
        let scaled = exponents.raise_far(value.abs(), exponents.lit(HALF), wide(exponent));
        scaled.to_fixed(Fixed { width, fraction: width - 1, signed: Signedness::Unsigned })
    }

    /// To the nearest, ties away from zero; what rounds up to the end of the range saturates.
    fn rounded(&self, value: Value, fixed: Fixed) -> Value {
        let finer = Fixed { width: fixed.width + 1, fraction: fixed.fraction + 1, ..fixed };
        let truncated = value.to_fixed(finer);
        let positive = !truncated.bits(finer.width - 1, finer.width - 1);
        let room = finer.width + 1;
        let sum = truncated.resize(room) + positive.zext(room).reinterpret(Type::Signed(room));
        let largest = self.program.constant(Type::Signed(room), (1 << (fixed.width - 1)) - 1);
        (sum >> 1).min(largest).resize(fixed.width)
    }

    /// Places by which offsets are shifted so that all of the rectangle's fit.
    fn shift(&self, coefficient: Coefficient, center: &[Value; 2], pixels: &[[Value; 2]; 2]) -> Value {
        let Fixed { width, fraction, .. } = coefficient.offset();
        let place = |pixel: Value| (pixel.resize(width) << fraction).reinterpret(Type::Signed(width));
        let one = self.program.lit(width, 1);
        let edges = center.iter().zip(pixels).flat_map(|(center, [first, last])| {
            let past = last.resize(width) + one;
            [*first, past].map(|pixel| place(pixel) - center.resize(width))
        });
        let reach = edges.map(magnitude).reduce(|reach, edge| reach | edge).expect("there are four");
        let top = width - 2;
        let none = self.program.lit(Coefficient::SHIFT_BITS, 0);
        (1..=width - coefficient.width()).fold(none, |shift, places| {
            let low = coefficient.width() - 2 + places;
            let is_wide = !reach.bits(top, low).eq(self.program.lit(top - low + 1, 0));
            is_wide.mux(self.program.lit(Coefficient::SHIFT_BITS, places.into()), shift)
        })
    }
}

/// A signed number without its sign, inverted if it is negative: a bit narrower, and unsigned.
pub(in crate::splat) fn magnitude(value: Value) -> Value {
    let sign = value.ty().map_or(1, Type::width) - 1;
    value.bits(sign, sign).mux(!value, value).bits(sign - 1, 0)
}
