use super::*;
use crate::splat::Setup;
use crate::splat::uniforms::SetupUniforms;
use pointcore_contract::FragmentDepth;
use pointcore_contract::splat::Coefficient;
use pointcore_contract::splat::records::{
    CompleteCopy, ImageRectangle, SetupSplat, Sight, Splat, TileDiagonals, TileRectangle, Viewport,
};

fn bits(number: f32) -> u32 {
    number.to_bits()
}

/// A disc of 3 px radius that faces the eye, in tile (1, 1) of the default image, about the tile's fourth pixel's corner.
fn disc(slot: u8) -> CompleteCopy {
    let footprint = Footprint {
        center: [bits(12.0); 2],
        ax: bits(3.0),
        by: bits(3.0),
        delta: bits(9.0),
        sight: Sight { near: u32::MAX >> 1, disc: true, ..Sight::default() },
        band: Band { depth: u32::from(slot), low: 1, high: 2 },
        ..Footprint::default()
    };
    let bounds = TileRectangle { left: 1, right: 6, top: 1, bottom: 6 };
    // 4.2 px to either side of the centre, where column and row of a sample are ½ more than its pixel's.
    let diagonals = TileDiagonals { first_sum: 3, last_sum: 11, first_difference: 3, last_difference: 11 };
    CompleteCopy { footprint, bounds, diagonals, tile: 1 << 5 | 1, slot, ..CompleteCopy::default() }
}

#[test]
fn a_sample_has_the_depth_of_its_plane_within_the_range() {
    let unit = Rasterizer::new(&Config { depth: FragmentDepth::Plane, ..Config::default() }, 4);
    let plane = DepthPlane {
        center: bits(0.5),
        slope: [bits(0.125), bits(-0.0625)],
        range: [bits(0.25), bits(0.75)],
        epsilon: bits(0.125),
    };
    let footprint = Footprint { center: [bits(4.5); 2], plane, ..Footprint::default() };
    let depth_at = |column, row| {
        let Band { depth, low, high } = unit.depth_band(&footprint, [column, row]);
        [depth, low, high].map(|depth| f64::from(depth) / f64::from(1 << DEPTH_BITS))
    };
    assert_eq!(depth_at(4, 4), [0.5, 0.375, 0.625]);
    assert_eq!(depth_at(5, 6), [0.5, 0.375, 0.625]);
    assert_eq!(depth_at(5, 4), [0.625, 0.5, 0.75]);
    assert_eq!(depth_at(7, 4), [0.75, 0.625, 0.875], "not beyond its far end");
    assert_eq!(depth_at(0, 4), [0.25, 0.125, 0.375], "not before its near end");
}

#[test]
fn samples_cover_the_disc_and_the_last_closes_it() {
    let mut unit = Rasterizer::new(&Config::default(), 4);
    let mut copies = (0..4).map(disc).collect::<Vec<_>>().into_iter();
    let mut input = copies.next();
    let mut samples = Vec::new();
    let mut evaluated = 0;
    for _ in 0..4 * 32 + 12 {
        let out = unit.outputs();
        samples.extend(out.out);
        evaluated += u32::from(out.events.sample);
        unit.clock(&In { input, out_ready: true, filter_scale: bits(1.0), ..In::default() });
        if out.in_ready {
            input = copies.next();
        }
    }
    assert_eq!(evaluated, 4 * 32, "a sample a cycle, without a gap between rows and copies");
    for (slot, samples) in (0..).zip(samples.chunk_by(|a, _| !a.place.last)) {
        assert_eq!(samples.last().map(|sample| sample.place.pixel), Some(6 * 8 + 5), "the corner is left out");
        assert_eq!(samples.len(), 32, "6 by 6 pixels without the corners");
        for sample in samples {
            let [x, y] = [sample.place.pixel % 8, sample.place.pixel / 8].map(|i| f64::from(i) - 3.5);
            let weight = (-2.0 * (x * x + y * y) / 9.0).exp() * 65535.0;
            assert!(sample.place.inside && (f64::from(sample.place.weight) - weight).abs() < 3.0);
            assert_eq!((sample.place.slot, sample.band.depth), (slot, u32::from(slot)));
        }
    }
}

/// `ρ²` and distance where the ray through a sample meets a splat's plane, by Cramer's rule in camera space.
fn ray_cast([u, a1, a2]: [[f64; 3]; 3], ray: [f64; 3]) -> (f64, f64) {
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (normal, along) = (cross(a1, a2), dot(ray, cross(a1, a2)));
    let (s, t) = (dot(ray, cross(a2, u)) / along, dot(ray, cross(u, a1)) / along);
    (s * s + t * t, dot(u, normal) / along)
}

#[test]
fn what_lies_between_near_and_far_plane_is_drawn_and_nothing_else() {
    const EDGE: u32 = 64;
    const FAR: f64 = 8.0;
    let mut random = fastrand::Rng::with_seed(9);
    let uniforms = SetupUniforms {
        viewport: Viewport {
            scale: [bits(48.0); 2],
            origin: [bits(32.0); 2],
            depth_a: bits(8.0 / 7.0),
            depth_b: bits(-8.0 / 7.0),
        },
        near_plane: bits(1.0),
        ..SetupUniforms::default()
    };
    // How far off they may be, as shares of ρ² and of the distance.
    let kinds = [(None, 1e-3), (Some(RasterFormat::Fixed(Coefficient::Eighteen)), 0.02)];
    for (rasterizer, rim) in kinds {
        let config = Config {
            width: EDGE,
            height: EDGE,
            geometry: Format::F32,
            rasterizer,
            culling: Feature::Off,
            screen_filter: Feature::Off,
            ..Config::default()
        };
        let (setup, unit) = (Setup::new(&config, 1), Rasterizer::new(&config, 1));
        let (mut turned, mut cut, mut drawn, mut boxed) = (0, 0, 0, 0);
        for _ in 0..1500 {
            let mut signed = || 2.0 * random.f32() - 1.0;
            let center = [3.0 * signed(), 3.0 * signed(), 4.0 * signed() + 1.5];
            let tangents = [(); 2].map(|()| [3.0 * signed(), 3.0 * signed(), 5.0 * signed()]);
            let vectors = [center, tangents[0], tangents[1]].map(|vector| vector.map(f64::from));
            let splat = Splat { center: center.map(bits), tangents: tangents.map(|t| t.map(bits)), ..Splat::default() };
            let outcome = setup.setup(&splat, &uniforms);
            let rectangle = outcome.map(|drawn| drawn.bounds);
            turned += u32::from(outcome.is_some_and(|drawn| drawn.footprint.sight.turned));
            boxed += u32::from(rectangle.is_some_and(|bounds| u32::from(bounds.right - bounds.left) + 1 < EDGE));
            for pixel in (0..EDGE).step_by(7).flat_map(|column| (0..EDGE).step_by(7).map(move |row| [column, row])) {
                let [x, y] = pixel.map(|index| (f64::from(index) + 0.5 - 32.0) / 48.0);
                let (squared, distance) = ray_cast(vectors, [x, y, 1.0]);
                let is_seen = outcome.is_some_and(|drawn| {
                    let ImageRectangle { left, right, top, bottom } = drawn.bounds;
                    let holds =
                        (left..=right).contains(&(pixel[0] as u16)) && (top..=bottom).contains(&(pixel[1] as u16));
                    holds && Rasterizer::is_inside(unit.squared_distance(&drawn.footprint, pixel, 0))
                });
                let is_between = distance > 1.0 && distance < FAR;
                let is_close = |plane: f64| (distance / plane - 1.0).abs() < rim;
                if (squared - 1.0).abs() < rim || is_close(1.0) || is_close(FAR) || outcome.is_some_and(is_vague) {
                    continue;
                }
                assert_eq!(is_seen, squared < 1.0 && is_between, "{squared} at {distance}, {pixel:?} of {vectors:?}");
                drawn += u32::from(is_seen);
                cut += u32::from(squared < 1.0 && distance > 0.0 && !is_between);
            }
        }
        assert!(turned > 200 && cut > 1000 && drawn > 1000 && boxed > 100, "{turned}, {cut}, {drawn}, {boxed}");
    }
}

/// Whether integers have no place for a footprint's origin, or no digits for its `Δ`.
fn is_vague(drawn: SetupSplat) -> bool {
    drawn.footprint.delta == 0 || drawn.footprint.shift > 5
}
