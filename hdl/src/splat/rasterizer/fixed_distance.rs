//! `ρ²` in fixed point: integers from a sample's offset to a quotient, digit by digit; golden twin:
//! `pointcore_golden::splat::fixed_distance`.

use super::position::Shape;
use crate::compiler::{Program, Type, Value, name};
use crate::splat::setup::fixed_footprint::magnitude;
use crate::units::values::Values;
use pointcore_contract::Fixed;
use pointcore_contract::splat::records::Sight;
use pointcore_contract::splat::units::rasterizer::PORTS;
use pointcore_contract::splat::{Coefficient, Config};

/// Bits of a square's operand.
const SIGNIFICANT: u32 = Coefficient::SIGNIFICANT_BITS;
/// Bits of a square.
const SQUARE: u32 = 2 * SIGNIFICANT;
/// Bits of a quotient's operands beyond those of the quotient.
const GUARD_BITS: u32 = 6;

/// Whether a sample is covered, and the leading bits of its `ρ²`.
pub(super) struct Squared {
    /// Inside its splat, or its filter's disc.
    pub covered: Value,
    /// The kernel's argument, all ones outside.
    pub argument: Value,
}

/// An evaluation's parts.
struct Evaluation<'a> {
    program: &'a Program,
    shape: &'a Shape<Values>,
    coefficient: Coefficient,
    kernel_bits: u32,
}

/// Of a sample at `places`, px, each with its fraction bits.
pub(super) fn squared(
    config: &Config,
    coefficient: Coefficient,
    program: &Program,
    shape: &Shape<Values>,
    places: [(Value, u32); 2],
) -> Squared {
    let kernel_bits = config.kernel_table().index_bits + config.kernel_table().fraction_bits;
    let evaluation = Evaluation { program, shape, coefficient, kernel_bits };
    let [(column, column_fraction), (row, row_fraction)] = places;
    let x = evaluation.offset(column, column_fraction, shape.center[0]);
    let y = evaluation.offset(row, row_fraction, shape.center[1]);
    name!(x, y);
    let on_splat = evaluation.on_splat(config, x, y);
    if !config.screen_filter.is_on() {
        return on_splat;
    }
    let mut in_disc = evaluation.in_disc(x, y);
    if config.eye_plane.is_on() {
        in_disc = evaluation.argument(in_disc.covered & shape.sight.disc, in_disc.argument);
    }
    Squared { covered: on_splat.covered | in_disc.covered, argument: on_splat.argument.min(in_disc.argument) }
}

impl Evaluation<'_> {
    fn number(&self, bits: Value) -> Value {
        bits.reinterpret(Type::Signed(self.coefficient.width()))
    }

    /// From the centre to a sample.
    fn offset(&self, place: Value, place_fraction: u32, center: Value) -> Value {
        let Fixed { width, fraction, .. } = self.coefficient.offset();
        let place = (place.resize(width) << (fraction - place_fraction)).reinterpret(Type::Signed(width));
        place - center.reinterpret(Type::Signed(self.coefficient.center().width)).resize(width)
    }

    /// An offset shifted to a coefficient's width, which it fits, the longest distance first.
    fn shifted(&self, offset: Value) -> Value {
        let shift = self.shape.shift;
        let mut width = self.coefficient.offset().width;
        (0..Coefficient::SHIFT_BITS).rev().fold(offset, |value, bit| {
            let chosen = shift.bits(bit, bit).mux(value >> (1 << bit), value);
            // It fits with what is left to be shifted.
            width = width.min(self.coefficient.width() + (1 << bit) - 1);
            chosen.resize(width)
        })
    }

    /// The kernel's argument, or all ones.
    fn argument(&self, covered: Value, argument: Value) -> Squared {
        let ones = self.program.lit(self.kernel_bits, (1 << self.kernel_bits) - 1);
        let argument = covered.mux(argument, ones);
        Squared { covered, argument }
    }

    fn on_splat(&self, config: &Config, x: Value, y: Value) -> Squared {
        let (n, shape) = (self.coefficient.width(), self.shape);
        let [x, y] = [x, y].map(|offset| self.shifted(offset));
        let s1 = x * self.number(shape.ay) - y * self.number(shape.ax);
        let s2 = x * self.number(shape.by) - y * self.number(shape.bx);
        let wide = 2 * n + 1;
        let delta = shape.delta.reinterpret(Type::Signed(self.coefficient.delta_width()));
        let [along_x, along_y] =
            [x * self.number(shape.mx), y * self.number(shape.my)].map(|product| product.resize(wide));
        let d = (delta.resize(wide) << self.coefficient.place_fraction()) + along_x + along_y;

        name!(s1, s2, d);
        let (mut across, mut d) = (s1.resize(wide), d);
        if config.eye_plane.is_on() {
            let turned = shape.sight.turned;
            (across, d) = (turned.mux(d, across), turned.mux(across, d));
        }
        let (d_bits, s_bits) = (magnitude(d), [across, s2.resize(wide)].map(magnitude));
        let (significant, beyond) = self.significant(d_bits, s_bits);
        let [denominator, first, second] = significant.map(|part| part * part);
        name!(denominator);
        let sum = first.resize(SQUARE + 1) + second.resize(SQUARE + 1);
        let mut covered = sum.lt(denominator.resize(SQUARE + 1)) & !beyond;
        if config.eye_plane.is_on() {
            let Sight { negative, near, far, .. } = shape.sight;
            let in_units = d_bits.bits(2 * n - 1, self.coefficient.place_fraction());
            let behind = d.bits(wide - 1, wide - 1) ^ negative;
            covered = covered & in_units.le(near) & far.le(in_units);
            covered = covered & !behind;
        }
        let dropped = SQUARE - (self.kernel_bits + GUARD_BITS);
        let [numerator, denominator] = [sum, denominator].map(|square| square.bits(SQUARE - 1, dropped));
        self.argument(covered, self.quotient(numerator, denominator))
    }

    /// `D` without its leading zeros, and both `s` shifted alike: their leading bits, and whether one of `s` is wider than `D`.
    fn significant(&self, d: Value, [first, second]: [Value; 2]) -> ([Value; 3], Value) {
        let mut width = 2 * self.coefficient.width();
        let mut parts = [d, first, second];
        let mut beyond = self.program.lit(1, 0);
        for level in (0..width.next_power_of_two().ilog2()).rev() {
            let by = 1 << level;
            let [d_empty, first_empty, second_empty] = parts.each_ref().map(|part| {
                let top = part.bits(width - 1, width - by);
                top.eq(self.program.lit(by, 0))
            });
            beyond = beyond | (d_empty & !(first_empty & second_empty));
            // What the levels left can shift, and the bits that are kept.
            let kept = width.min(SIGNIFICANT + by - 1);
            parts = parts.map(|part| d_empty.mux(part << by, part).bits(width - 1, width - kept));
            width = kept;
        }
        (parts, beyond)
    }

    /// `numerator/denominator` of not more than one, truncated, or the largest below one.
    fn quotient(&self, numerator: Value, denominator: Value) -> Value {
        let width = self.kernel_bits + GUARD_BITS;
        let room = width + 2;
        let divisor = denominator.resize(room);
        let mut remainder = numerator;
        let mut digits: Option<Value> = None;
        for _ in 0..self.kernel_bits {
            let twice = remainder.resize(room) << 1;
            let difference = twice - divisor;
            let below = difference.bits(room - 1, room - 1);
            remainder = below.mux(twice, difference).resize(width);
            let digit = !below;
            digits = Some(digits.map_or_else(|| digit, |digits| digits.cat(digit)));
        }
        digits.expect("a kernel's argument has bits")
    }

    /// Within the screen filter's radius of the projected centre.
    fn in_disc(&self, x: Value, y: Value) -> Squared {
        let (offset, narrow) = (self.coefficient.offset(), self.coefficient.filter_offset());
        let square = Coefficient::FILTER_SQUARE;
        let dropped = offset.fraction - narrow.fraction;
        let sign = dropped + narrow.width - 1;
        let sides = [x, y].map(|side| {
            let (high, bits) = (side.bits(offset.width - 1, sign), offset.width - sign);
            let [zeros, ones] = [0, (1 << bits) - 1].map(|value| self.program.lit(bits, value));
            let is_near = high.eq(zeros) | high.eq(ones);
            let side = side.bits(sign, dropped).reinterpret(Type::Signed(narrow.width));
            (is_near, (side * side).reinterpret(Type::Unsigned(2 * narrow.width)))
        });
        let [(near_x, squared_x), (near_y, squared_y)] = sides;
        let sum = squared_x + squared_y;
        let lowest = 2 * narrow.fraction - square.fraction;
        let end = lowest + square.width;
        let is_zero = |value: Value, bits: u32| value.eq(self.program.lit(bits, 0));
        let top = 2 * narrow.width - 1;
        let near = near_x & near_y & is_zero(sum.bits(top, end), top - end + 1);

        let scale = Coefficient::FILTER_SCALE;
        let product =
            sum.bits(end - 1, lowest) * self.program.uniform(PORTS.filter_scale.name, Type::Unsigned(scale.width));
        let (fraction, width) = (square.fraction + scale.fraction, square.width + scale.width);
        let covered = near & is_zero(product.bits(width - 1, fraction), width - fraction);
        self.argument(covered, product.bits(fraction - 1, fraction - self.kernel_bits))
    }
}
