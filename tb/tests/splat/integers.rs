//! What makes footprints in fixed point hard: specks, and quotients that hardly leave anything.

use std::iter::repeat_with;

use fastrand::Rng;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{CompleteCopy, Footprint, Sight};
use pointcore_contract::splat::{Coefficient, Config};
use pointcore_contract::{Fixed, Sampling};

use super::scene::seen;

/// So many `Δ` are tried for a quotient that hardly leaves anything.
const TRIES: usize = 1 << 17;
/// Bits of a quotient's operands beyond those of the quotient.
const GUARD_BITS: u32 = 6;

/// The number that the low bits of a word are in two's complement.
fn signed(word: u32, width: u32) -> i64 {
    let unused = u32::BITS - width;
    i64::from((word << unused) as i32 >> unused)
}

fn unsigned(number: i64, width: u32) -> u32 {
    number as u32 & (u32::MAX >> (u32::BITS - width))
}

/// Column and row of a copy's first sample in the image.
fn first(config: &Config, copy: &CompleteCopy) -> [u32; 2] {
    let column_bits = config.tile_column_bits();
    let tile = [copy.tile & ((1 << column_bits) - 1), copy.tile >> column_bits];
    [TILE_SIZE * tile[0] + u32::from(copy.bounds.left), TILE_SIZE * tile[1] + u32::from(copy.bounds.top)]
}

/// Makes one copy in `one_in` so small that the screen filter's disc decides, if there is one, and has it begin within a pixel of its centre.
pub fn shrink(config: &Config, copies: &mut [CompleteCopy], one_in: u32, random: &mut Rng) {
    let Some(coefficient) = config.raster_format().fixed() else { return };
    let Fixed { width, fraction, .. } = coefficient.center();
    for copy in copies {
        if random.u32(0..one_in) != 0 {
            continue;
        }
        let [column, row] = first(config, copy);
        let footprint = &mut copy.footprint;
        footprint.center = [column / config.sampling.columns(), row]
            .map(|pixel| unsigned((i64::from(pixel) << fraction) + i64::from(random.u32(0..1 << fraction)), width));
        let places = random.u32(2..8);
        let smaller = |number: &mut u32, width| *number = unsigned(signed(*number, width) >> places, width);
        smaller(&mut footprint.delta, coefficient.delta_width());
        smaller(&mut footprint.mx, coefficient.width());
        smaller(&mut footprint.my, coefficient.width());
        footprint.sight = seen(config, footprint.sight);
    }
}

/// Gives one copy in `one_in` no `m`, and such a `Δ` that `ρ²` at its first sample is a quotient that hardly leaves anything, where samples are
/// in the middle of pixels.
pub fn divide(config: &Config, copies: &mut [CompleteCopy], one_in: u32, random: &mut Rng) {
    let (Some(coefficient), Sampling::Center) = (config.raster_format().fixed(), config.sampling) else { return };
    let Fixed { width: center_width, fraction, .. } = coefficient.center();
    let quotient_bits = config.kernel_index_bits + config.kernel_fraction_bits;
    let kept = Coefficient::SIGNIFICANT_BITS;
    let dropped = 2 * kept - quotient_bits - GUARD_BITS;
    for copy in copies {
        if random.u32(0..one_in) != 0 {
            continue;
        }
        let pixels = first(config, copy);
        let footprint = &mut copy.footprint;
        let Footprint { center, ax, ay, bx, by, shift, .. } = *footprint;
        let number = |word| signed(word, coefficient.width());
        let [x, y] = [0, 1].map(|axis| {
            let middle = (2 * i64::from(pixels[axis]) + 1) << (fraction - 1);
            number(((middle - signed(center[axis], center_width)) >> shift) as u32)
        });
        let along = [(ax, ay), (bx, by)].map(|(column, row)| x * number(row) - y * number(column));
        let along = along.map(|part| if part < 0 { !part } else { part } as u64);
        let rest = |delta: u32| {
            let length = u64::from(delta) << coefficient.place_fraction();
            let bits = u64::BITS - length.leading_zeros();
            let square = |part: u64| {
                let part = if bits < kept { part << (kept - bits) } else { part >> (bits - kept) };
                part * part
            };
            let is_far = along.iter().any(|&part| part > length);
            let [sum, whole] = [square(along[0]) + square(along[1]), square(length)].map(|sum| sum >> dropped);
            (!is_far && sum < whole).then(|| (sum << quotient_bits) % whole)
        };
        let largest = 1 << (coefficient.delta_width() - 1);
        let deltas = repeat_with(|| random.u32(largest / 8..largest)).take(TRIES);
        if let Some((_, delta)) = deltas.filter_map(|delta| Some((rest(delta)?, delta))).min() {
            let sight = Sight { turned: false, negative: false, ..seen(config, footprint.sight) };
            *footprint = Footprint { delta, mx: 0, my: 0, sight, ..*footprint };
        }
    }
}
