//! Families of hard cases. Each takes a severity from 0, which is ordinary, to the limit of the number format.

use super::case::{Case, IMAGE_EDGE_PX, Lens};
use super::family::Family;
use fastrand::Rng;
use glam::DVec3;
use pointcore::number::encode;
use pointcore_contract::Format;
use pointcore_contract::splat::Feature;
use pointcore_contract::splat::records::Splat;

/// Severities.
pub const LEVELS: u8 = 16;
/// The highest one, as a number.
const WORST: f64 = (LEVELS - 1) as f64;
/// Farthest and nearest distance of a camera's view, by ratio.
const REACH: f32 = 1000.0;

/// A disc or ellipse while its family bends it.
struct SplatShape {
    center: DVec3,
    tangents: [DVec3; 2],
}

fn signed(random: &mut Rng) -> f64 {
    2.0 * random.f64() - 1.0
}

fn either(random: &mut Rng) -> f64 {
    if random.bool() { 1.0 } else { -1.0 }
}

fn direction(random: &mut Rng) -> DVec3 {
    loop {
        let vector = DVec3::new(signed(random), signed(random), signed(random));
        if (0.01..1.0).contains(&vector.length_squared()) {
            return vector.normalize();
        }
    }
}

impl SplatShape {
    /// In view, a few pixels wide, tangents orthogonal and of an aspect up to four, the front to the eye.
    fn ordinary(lens: &Lens, random: &mut Rng) -> Self {
        let z = lens.near * (1.5 + 20.0 * random.f64().powi(2));
        let pixel = z / lens.scale;
        let half = f64::from(IMAGE_EDGE_PX) / 2.0;
        let center = DVec3::new(half * pixel * signed(random), half * pixel * signed(random), z);
        let normal = direction(random);
        let first = normal.any_orthonormal_vector();
        let (sin, cos) = (random.f64() * std::f64::consts::TAU).sin_cos();
        let axis = first * cos + normal.cross(first) * sin;
        let radius = pixel * (1.0 + 15.0 * random.f64().powi(2));
        let other = normal.cross(axis) * (radius / (1.0 + 3.0 * random.f64()));
        Self { center, tangents: [axis * radius, other] }.facing()
    }

    /// Turned so that the eye sees the front, as far as that is a question.
    fn facing(self) -> Self {
        let [a, b] = self.tangents;
        if self.center.dot(a.cross(b)) > 0.0 { Self { tangents: [b, a], ..self } } else { self }
    }

    fn scaled(self, factors: [f64; 2]) -> Self {
        let [a, b] = self.tangents;
        Self { tangents: [a * factors[0], b * factors[1]], ..self }
    }

    /// With the rim's nearest point at depth `z`, measured in the centre's.
    fn reaching(self, z: f64) -> Self {
        let rise = self.tangents.map(|tangent| tangent.z);
        let factor = (1.0 - z) * self.center.z / rise[0].hypot(rise[1]);
        self.scaled([factor; 2])
    }
}

/// The case of a family, a severity and a seed.
#[must_use]
pub fn case(family: Family, level: u8, format: Format, seed: u64) -> Case {
    let mut random = Rng::with_seed(seed);
    let random = &mut random;
    let severity = f64::from(level) / WORST;
    let mut lens = Lens::new(format, 1.0, REACH);
    if family == Family::Depth {
        lens = Lens::new(format, 1.0, 2_f32.powf(1.0 + 30.0 * severity as f32));
    }
    let shape = SplatShape::ordinary(&lens, random);
    // Down to a few units in the last place of f32.
    let least = 2_f64.powf(-28.0 * severity);
    let shape = match family {
        Family::Ordinary | Family::Odd | Family::Noise => shape,
        Family::Parallel => {
            let [a, b] = shape.tangents;
            SplatShape { tangents: [a, a * signed(random) + b * least], ..shape }.facing()
        }
        Family::Vanishing => {
            let small = if level + 1 == LEVELS { 0.0 } else { 10_f64.powf(-38.0 * severity) };
            let factors = match random.u8(0..3) {
                0 => [small, 1.0],
                1 => [1.0, small],
                _ => [small, small],
            };
            shape.scaled(factors)
        }
        Family::Ratio => {
            let ratio = 10_f64.powf(-6.0 * severity);
            shape.scaled([if random.bool() { 30.0 } else { 1.0 }, 1.0]).scaled([1.0, ratio])
        }
        Family::EdgeOn => {
            let sight = shape.center.normalize();
            let side = sight.any_orthonormal_vector();
            let (sin, cos) = (random.f64() * std::f64::consts::TAU).sin_cos();
            let side = side * cos + sight.cross(side) * sin;
            let along = sight + sight.cross(side) * (least * signed(random));
            let [a, b] = shape.tangents.map(DVec3::length);
            SplatShape { tangents: [along * a, side * b], ..shape }.facing()
        }
        Family::Behind => {
            let z = lens.near * least * signed(random);
            let scale = if random.bool() { 1.0 } else { least };
            let center = DVec3::new(shape.center.x * scale, shape.center.y * scale, z);
            // Large enough for a part to be seen.
            let size = lens.near * (1.0 + 3.0 * random.f64()) / shape.tangents[0].length();
            SplatShape { center, ..shape }.scaled([size; 2]).facing()
        }
        Family::Crossing => shape.reaching(0.5 * least * signed(random)),
        Family::NearPlane => {
            let near = lens.near / shape.center.z;
            shape.reaching(near * (1.0 + 0.5 * least * signed(random)))
        }
        Family::Huge => shape.scaled([10_f64.powf(2.0 + 10.0 * severity); 2]),
        Family::Tiny => shape.scaled([10_f64.powf(-9.0 * severity); 2]),
        Family::OffAxis => {
            let out = 10_f64.powf(6.0 * severity) * either(random);
            let [x, y, z] = shape.center.to_array();
            let center = if random.bool() { DVec3::new(x * out, y, z) } else { DVec3::new(x, y * out, z) };
            let reach = 0.5 + random.f64();
            let size = (center - shape.center).length() * reach / shape.tangents[0].length();
            SplatShape { center, ..shape }.scaled([size.max(1.0); 2]).facing()
        }
        Family::Depth => {
            let z = lens.near * 2_f64.powf(30.0 * severity * random.f64()) * 1.5;
            let factor = z / shape.center.z;
            SplatShape { center: shape.center * factor, tangents: shape.tangents.map(|tangent| tangent * factor) }
        }
        Family::Magnitude => {
            let unit = 10_f64.powf(30.0 * severity * either(random));
            lens = Lens::new(format, unit as f32, REACH);
            SplatShape { center: shape.center * unit, tangents: shape.tangents.map(|tangent| tangent * unit) }
        }
    };
    encoded(family, level, format, lens, &shape, random)
}

fn encoded(family: Family, level: u8, format: Format, lens: Lens, shape: &SplatShape, random: &mut Rng) -> Case {
    let vector = |v: DVec3| v.to_array().map(|value| encode(format, value as f32));
    let mut attributes = [0; 14];
    for attribute in &mut attributes[..6] {
        *attribute = encode(Format::F16, signed(random) as f32);
    }
    let splat =
        Splat { center: vector(shape.center), tangents: shape.tangents.map(vector), attributes, ..Splat::default() };
    let filter = if random.bool() { Feature::On } else { Feature::Off };
    let mut case = Case { family, level, format, splat, lens, filter };
    match family {
        Family::Odd => {
            for _ in 0..=level / 2 {
                case = odd(case, random);
            }
        }
        Family::Noise => {
            for vector in std::iter::once(&mut case.splat.center).chain(&mut case.splat.tangents) {
                vector.iter_mut().for_each(|bits| *bits = random.u32(..) >> (32 - format.width()));
            }
            attributes.iter_mut().for_each(|bits| *bits = random.u32(..) >> 16);
            case.splat.attributes = attributes;
        }
        _ => {}
    }
    case
}

/// Replaces a number by one that is none, or hardly.
fn odd(mut case: Case, random: &mut Rng) -> Case {
    const ODD: [f32; 12] = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        0.0,
        -0.0,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        1e-40,
        -1e-45,
        1e30,
        -1e-30,
    ];
    let value = ODD[random.usize(0..ODD.len())];
    match random.usize(0..10) {
        9 => case.splat.attributes[random.usize(0..6)] = encode(Format::F16, value),
        place => case = case.with_number(place, f64::from(value)),
    }
    case
}
