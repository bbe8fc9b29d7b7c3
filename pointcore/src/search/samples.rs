//! Point sets of all kinds and queries among them, to try a search on.

use super::Query;
use fastrand::Rng;

/// Point sets by name: evenly spread and clustered, flat, in a line, with many equal distances, all equal, and with coordinates
/// from 1e-30 to 1e30.
#[must_use]
pub fn point_sets(count: usize, random: &mut Rng) -> Vec<(&'static str, Vec<[f32; 3]>)> {
    let mut cloud = |point: &dyn Fn(&mut Rng) -> [f32; 3]| (0..count).map(|_| point(random)).collect();
    let signed = |random: &mut Rng| 2.0 * random.f32() - 1.0;
    let magnitude = |random: &mut Rng| signed(random).signum() * 10_f32.powf(30.0 * signed(random));
    vec![
        ("uniform", cloud(&|random| [(); 3].map(|()| signed(random)))),
        (
            "clustered",
            cloud(&|random| {
                let center = f32::from(random.u8(0..5));
                [(); 3].map(|()| center + 1e-3 * signed(random))
            }),
        ),
        ("coplanar", cloud(&|random| [signed(random), 0.25, signed(random)])),
        ("collinear", cloud(&|random| [0.5, -0.5, signed(random)])),
        ("lattice", cloud(&|random| [(); 3].map(|()| f32::from(random.i8(-3..4))))),
        ("identical", cloud(&|_| [0.1, 0.2, 0.3])),
        ("magnitudes", cloud(&|random| [(); 3].map(|()| magnitude(random)))),
    ]
}

/// Queries at points and near them, for up to `neighbors` of them, half of them within a radius.
#[must_use]
pub fn queries_near(points: &[[f32; 3]], neighbors: u32, count: usize, random: &mut Rng) -> Vec<Query> {
    let query = |index: usize| {
        let point = points[random.usize(..points.len())];
        let moved = point.map(|x| x + (random.f32() - 0.5) * 0.1 * x.abs().max(1e-20));
        let radius = random.bool().then(|| 10_f32.powf(random.f32() * 4.0 - 3.0));
        Query { point: if index.is_multiple_of(2) { point } else { moved }, k: random.u32(1..=neighbors), radius }
    };
    (0..count).map(query).collect()
}
