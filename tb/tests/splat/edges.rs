//! What makes a splat's edges hard: bounds and limits in the image that are rounded to another pixel by a hair.

use fastrand::Rng;
use pointcore::number::{decode, encode};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Splat, Viewport};

use super::scene::registers;

/// Places of a center within a pixel, in a row or column.
const PLACES: i32 = 256;

/// A projected splat along a direction, from the lengths of its tangents there and their slopes: how far its middle lies before its centre,
/// and half its extent; none if it is not clearly before the eye.
fn extent(lengths: [f64; 2], slopes: [f64; 2]) -> Option<[f64; 2]> {
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let before_eye = 1.0 - dot(slopes, slopes);
    let middle = dot(lengths, slopes) / before_eye;
    let half = (middle * middle + dot(lengths, lengths) / before_eye).sqrt();
    (before_eye >= 0.1).then_some([middle, half])
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
        let mut place = number(center[axis]);
        // The tangents' projections hardly change with it.
        for _ in 0..8 {
            let lengths: [f64; 2] = std::array::from_fn(|tangent| {
                scale * (number(tangents[tangent][axis]) - place * slopes[tangent]) / depth
            });
            let Some([middle, half]) = extent(lengths, slopes).filter(|_| depth > 0.0) else { break };
            let bound = scale * place / depth + number(viewport.origin[axis]) - middle + side * half;
            place += (limit - bound) * depth / scale;
        }
        center[axis] = encode(config.geometry, place as f32);
    }
}

/// Has one splat in camera space in `one_in` be a needle along a diagonal that crosses the image, or passes it, any number of pixels
/// away, while its box covers it.
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
        let aside = if random.bool() { 0.5 * apart } else { middle[0] * random.f32() };
        let at = |axis: usize| (middle[axis] + aside * across[axis] - number(origin[axis])) * per_pixel[axis];
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

/// Moves and scales one splat in camera space in `one_in` so that a limit of its rows' and columns' sums or differences is rounded to another
/// pixel, and its centre and its distance from there to another place, a hair away.
pub fn graze(config: &Config, splats: &mut [Splat], one_in: u32, random: &mut Rng) {
    /// Where limits are rounded, of pixels with a sample in the middle or four on their edges.
    const ROUNDED: [f64; 4] = [9.0, 88.0, 169.0, 248.0];
    let viewport = registers(config).viewport;
    let number = |bits| f64::from(decode(config.geometry, bits));
    let places = f64::from(PLACES);
    let digit = 2_f64.powi(-(config.geometry.mantissa as i32));
    for Splat { center, tangents, end, .. } in splats {
        if *end || random.u32(0..one_in) != 0 {
            continue;
        }
        let [side, slope] = [(); 2].map(|()| if random.bool() { 1.0 } else { -1.0 });
        let pixel = f64::from(random.u32(0..config.width + config.height));
        let pixel = if slope > 0.0 { pixel } else { pixel - f64::from(config.height) };
        let limit = places * pixel + ROUNDED[random.usize(0..ROUNDED.len())];
        // Near the image's edge a coordinate has more digits than its place.
        let rows = PLACES << random.u32(0..6);
        let hair = |random: &mut Rng, most: i32| (2.0 * random.f64() - 1.0) * 2_f64.powi(-random.i32(0..most));
        let row = f64::from(random.i32(0..rows)) + hair(random, 12);
        let aside = hair(random, 12);
        let deep = number(center[2]);
        let (mut at, mut ends) = ([center[0], center[1]].map(number), tangents.map(|tangent| tangent.map(number)));
        let from_image = |axis: usize, place: f64| {
            (place / places - number(viewport.origin[axis])) * deep / number(viewport.scale[axis])
        };
        let mut reached = None;
        for _ in 0..8 {
            let slopes = ends.map(|[.., z]| z / deep);
            let lengths: [f64; 2] = std::array::from_fn(|tangent| {
                let along = |axis: usize| {
                    number(viewport.scale[axis]) * (ends[tangent][axis] - at[axis] * slopes[tangent]) / deep
                };
                along(0) + slope * along(1)
            });
            let Some([middle, half]) = extent(lengths, slopes).filter(|_| deep > 0.0) else { break };
            let reach = places * (half - side * middle);
            let reached = *reached.get_or_insert(reach.floor());
            let factor = reached * (1.0 + 4.0 * digit * hair(random, 1)) / reach;
            ends = ends.map(|tangent| tangent.map(|number| number * factor));
            let wide = reached + (reached / 128.0).floor();
            at = [from_image(0, limit - side * wide - slope * row.round() + aside), from_image(1, row)];
        }
        if reached.is_some() {
            let encoded = |number: f64| encode(config.geometry, number as f32);
            (center[0], center[1]) = (encoded(at[0]), encoded(at[1]));
            *tangents = ends.map(|tangent| tangent.map(encoded));
        }
    }
}
