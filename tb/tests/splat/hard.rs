//! What makes splats hard: odd numbers, any magnitude, places where something is decided by a hair.

use fastrand::Rng;
use pointcore::number::{decode, encode, encode_attribute};
use pointcore_contract::Format;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{CompleteCopy, Footprint, Splat, Uniforms, Viewport};

use super::scene::{registers, seen};

/// Numbers that are none, or hardly.
const ODD: [f32; 8] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, f32::MAX, 1e-40, -1e-20];

/// Replaces a number of one splat in `one_in` by an odd one, and a continuous attribute of as many.
pub fn spoil(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    for Splat { center, tangents, attributes, .. } in splats {
        if random.u32(0..one_in) == 0 {
            let [first, second] = tangents;
            let number = &mut [center, first, second][random.usize(0..3)][random.usize(0..3)];
            *number = encode(config.geometry, ODD[random.usize(0..ODD.len())]);
        }
        if random.u32(0..one_in) == 0 && config.continuous > 0 {
            let odd = ODD[random.usize(0..ODD.len())];
            attributes[random.usize(0..config.continuous as usize)] = encode_attribute(config.attribute, odd);
        }
    }
}

/// Moves one splat in `one_in` to where it, or its center, just reaches beyond the near plane, or does not by a hair.
pub fn approach(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    let Uniforms { model_view, near_plane, .. } = registers(config);
    let number = |bits: u32| f64::from(decode(config.geometry, bits));
    let [.., [x, y, z, w]] = model_view.rows.map(|row| row.map(number));
    let axis = glam::DVec3::new(x, y, z);
    for Splat { center, tangents, end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let [first, second] = tangents.map(|tangent| axis.dot(tangent.map(number).into()).abs());
        let reach = if random.bool() { 2.0 * first.max(second) } else { 0.0 };
        let hair = (random.f64() - 0.5) * 2_f64.powi(-random.i32(0..config.geometry.mantissa as i32));
        let at = glam::DVec3::from(center.map(number));
        let beyond = number(near_plane) - reach + hair - (axis.dot(at) + w);
        let moved = at + axis * (beyond / axis.length_squared());
        *center = moved.to_array().map(|number| encode(config.geometry, number as f32));
    }
}

/// Multiplies an encoded number.
fn multiply(format: Format, number: &mut u32, factor: f64) {
    *number = encode(format, (f64::from(decode(format, *number)) * factor) as f32);
}

/// Gives one splat in `one_in`, or its tangents or one of their numbers alone, another magnitude: any that the format has, most of them
/// nearly the least or the largest. Or each number of its tangents another one, not far from the first.
pub fn scale(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    for Splat { center, tangents: [first, second], .. } in splats {
        if random.u32(0..one_in) == 0 {
            let (least, most) = [(-126, -90), (90, 127), (-126, 127)][random.usize(0..3)];
            let factor = 2_f64.powi(random.i32(least..=most));
            let scale = |number: &mut u32| multiply(config.geometry, number, factor);
            match random.u8(0..5) {
                0 => [first, second, center].into_iter().flatten().for_each(scale),
                1 => [first, second].into_iter().flatten().for_each(scale),
                2 => {
                    let numbers = [first, second].into_iter().flatten();
                    numbers.for_each(|number| multiply(config.geometry, number, 2_f64.powi(-random.i32(0..40))));
                }
                _ => scale(&mut [first, second][random.usize(0..2)][random.usize(0..3)]),
            }
        }
    }
}

/// Has one splat in camera space in `one_in` lie across the eye plane, its box's edges before the eye where the image is.
pub fn cross_the_eye(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    let encoded = |numbers: [f32; 3]| numbers.map(|number| encode(config.geometry, number));
    for Splat { center, tangents, end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let mut centered = |size: f32| size * (2.0 * random.f32() - 1.0);
        let reaching = [(); 2].map(|()| [centered(0.5), centered(0.5), centered(4.0)]);
        let reach: [f32; 3] = std::array::from_fn(|axis| 2.0 * reaching[0][axis].abs().max(reaching[1][axis].abs()));
        let deep = centered(0.25 * reach[2]);
        let mut aside = |axis: usize| {
            let edge = centered(0.7 * (deep + reach[2]));
            edge + reach[axis].copysign(edge)
        };
        *center = encoded([aside(0), aside(1), deep]);
        *tangents = reaching.map(encoded);
    }
}

/// Has one splat in camera space in `one_in` be a speck of any size at the middle of a pixel, which it covers however small it is.
pub fn strew(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    let Viewport { scale, origin, .. } = registers(config).viewport;
    let number = |bits| decode(config.geometry, bits);
    let pixels = [config.width, config.height];
    for Splat { center, tangents, end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let depth = 2_f32.powi(random.i32(1..4));
        let place: [f32; 2] = std::array::from_fn(|axis| {
            let middle = random.u32(0..pixels[axis]) as f32 + 0.5;
            depth * (middle - number(origin[axis])) / number(scale[axis])
        });
        *center = [place[0], place[1], depth].map(|part| encode(config.geometry, part));
        let size = 2_f32.powi(-random.i32(5..126).max(random.i32(5..126)));
        *tangents =
            tangents.map(|tangent| tangent.map(|part| encode(config.geometry, number(part).clamp(-1.0, 1.0) * size)));
    }
}

/// Tilts one splat in camera space in `one_in`, slightly in one direction, so that a coefficient of `m` in fixed point is rounded to another
/// place, a hair away. In the other direction it is not tilted at all, or so much that the other coefficient is far larger.
pub fn tilt(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    let scale = registers(config).viewport.scale;
    let number = |bits| f64::from(decode(config.geometry, bits));
    for Splat { center, tangents: [first, second], end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let axis = random.usize(0..2);
        let deep = number(center[2]);
        let slope = [0.0, 0.7][random.usize(0..2)];
        first[2] = encode(config.geometry, (slope * deep) as f32);
        if slope > 0.0 {
            // Nothing is taken away from the small coefficient.
            (center[axis], second[axis]) = (0, 0);
        }
        let along = |tangent: &[u32; 3], axis: usize, slope: f64| {
            number(scale[axis]) * (number(tangent[axis]) - number(center[axis]) * slope) / deep
        };
        let lengths = [along(first, 0, slope), along(first, 1, slope), along(second, 0, 0.0), along(second, 1, 0.0)];
        let largest = lengths.into_iter().map(f64::abs).fold(0.0, f64::max);
        let place = 2_f64.powf(largest.log2().ceil() - f64::from(random.u32(17..20)));
        let hair = (2.0 * random.f64() - 1.0) * 2_f64.powi(-random.i32(12..20));
        let odd = if slope > 0.0 { 1 } else { 2 * random.u32(0..16) + 1 };
        let coefficient = place * f64::from(odd) * (1.0 + hair);
        second[2] = encode(config.geometry, (coefficient * deep / lengths[axis]) as f32);
    }
}

/// Gives one copy in `one_in` another magnitude, where that is a float's: its `A` and `B` a smaller one, so that its samples are hardly away
/// from its centre; or its `A`, `B`, `Δ` and `m` any other, which leaves them where they are. It has no limits of `D` then.
pub fn magnify(config: &Config, copies: &mut [CompleteCopy], one_in: u32, random: &mut Rng) {
    let Some(format) = config.raster_format().floating() else { return };
    for CompleteCopy { footprint, .. } in copies {
        if random.u32(0..one_in) != 0 {
            continue;
        }
        let Footprint { ax, ay, bx, by, delta, mx, my, sight, .. } = footprint;
        if random.bool() {
            let factor = 2_f64.powi(-random.i32(1..30));
            [ax, ay, bx, by].into_iter().for_each(|number| multiply(format, number, factor));
        } else {
            let factor = 2_f64.powi(random.i32(-40..40));
            [ax, ay, bx, by, delta, mx, my].into_iter().for_each(|number| multiply(format, number, factor));
            *sight = seen(config, *sight);
        }
    }
}

/// Gives one splat in `one_in` a second tangent that is the first one, to a few bits: it is seen edge-on from anywhere.
pub fn flatten(splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    for Splat { tangents: [first, second], .. } in splats {
        if random.u32(0..one_in) == 0 {
            let noise = (1 << random.u32(0..12)) - 1;
            *second = first.map(|component| component ^ (random.u32(..) & noise));
        }
    }
}
