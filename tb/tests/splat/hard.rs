//! What makes splats hard: odd numbers, any magnitude, places where something is decided by a hair.

use fastrand::Rng;
use pointcore::number::{decode, encode, encode_attribute};
use pointcore_contract::Format;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{CompleteCopy, Footprint, Sight, Splat, Uniforms, Viewport};

use super::scene::registers;

/// Numbers that are none, or hardly.
const ODD: [f32; 8] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, f32::MAX, 1e-40, -1e-20];

/// Places of a center within a pixel, in a row or column.
const PLACES: i32 = 256;

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

/// Moves one splat in camera space in `one_in` to where one of its bounds in the image is rounded to another pixel.
pub fn border(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    /// Where bounds are rounded, of pixels with a sample in the middle or four on their edges.
    const ROUNDED: [f64; 4] = [126.0, 130.0, 162.0, 254.0];
    let viewport = registers(config).viewport;
    let pixels = [config.width, config.height];
    let number = |bits| f64::from(decode(config.geometry, bits));
    for Splat { center, tangents, end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let axis = random.usize(0..pixels.len());
        let limit = f64::from(random.u32(0..pixels[axis])) + ROUNDED[random.usize(0..ROUNDED.len())] / 256.0;
        let side = if random.bool() { 1.0 } else { -1.0 };
        let (scale, depth) = (number(viewport.scale[axis]), number(center[2]));
        let slopes = tangents.map(|tangent| number(tangent[2]) / depth);
        let before_eye = 1.0 - slopes.iter().map(|slope| slope * slope).sum::<f64>();
        if depth <= 0.0 || before_eye < 0.1 {
            continue;
        }
        let mut place = number(center[axis]);
        // The tangents' projections hardly change with it.
        for _ in 0..8 {
            let lengths: [f64; 2] = std::array::from_fn(|tangent| {
                scale * (number(tangents[tangent][axis]) - place * slopes[tangent]) / depth
            });
            let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
            let middle = dot(lengths, slopes) / before_eye;
            let half = (middle * middle + dot(lengths, lengths) / before_eye).sqrt();
            let bound = scale * place / depth + number(viewport.origin[axis]) - middle + side * half;
            place += (limit - bound) * depth / scale;
        }
        center[axis] = encode(config.geometry, place as f32);
    }
}

/// Has one splat in camera space in `one_in` be a needle along a diagonal that passes the image, any number of pixels away, while its
/// box covers it.
pub fn pass_by(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    let Viewport { scale, origin, .. } = registers(config).viewport;
    let number = |bits| decode(config.geometry, bits);
    for Splat { center, tangents, end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let [side, slope] = [(); 2].map(|()| if random.bool() { 1.0 } else { -1.0 });
        let [along, across] = [[1.0, slope], [side, -side * slope]];
        let apart = 2_f32.powi(random.i32(4..14)) + (config.width + config.height) as f32 * random.f32();
        let depth = 2_f32.powi(random.i32(1..4));
        let per_pixel: [f32; 2] = std::array::from_fn(|axis| depth / number(scale[axis]));
        let middle = [config.width, config.height].map(|pixels| pixels as f32 / 2.0);
        let at = |axis: usize| (middle[axis] + 0.5 * apart * across[axis] - number(origin[axis])) * per_pixel[axis];
        let reach = |axis: usize, pixels: f32| pixels * along[axis] * per_pixel[axis];
        let encoded = |numbers: [f32; 3]| numbers.map(|number| encode(config.geometry, number));
        *center = encoded([at(0), at(1), depth]);
        *tangents = [apart, 0.01].map(|pixels| encoded([reach(0, pixels), reach(1, pixels), 0.0]));
    }
}

/// Moves the center of one splat in camera space in `one_in` to where one of its coordinates in the image is rounded to another place, a
/// hair away.
pub fn tie(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    let Viewport { scale, origin, .. } = registers(config).viewport;
    let number = |bits| decode(config.geometry, bits);
    for Splat { center, end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let axis = random.usize(0..2);
        let places = (1 << random.u32(1..6)) * PLACES;
        let hair = (2.0 * random.f32() - 1.0) * 2_f32.powi(-random.i32(9..20));
        let place = (random.i32(-places..places) as f32 + 0.5) / PLACES as f32 + hair;
        let moved = (place - number(origin[axis])) * number(center[2]) / number(scale[axis]);
        center[axis] = encode(config.geometry, moved);
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
            let all = u32::MAX >> (32 - config.raster_format().limit_width());
            *sight = Sight { near: all, far: 0, ..*sight };
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
