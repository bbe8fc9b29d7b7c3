use super::*;
use pointcore_contract::splat::records::{Band, EpsilonScale, Viewport};

fn uniforms() -> SetupUniforms {
    let bits = f32::to_bits;
    SetupUniforms {
        viewport: Viewport {
            scale: [bits(100.0); 2],
            origin: [bits(128.0), bits(64.0)],
            depth_a: bits(1.0),
            depth_b: bits(-1.0),
        },
        epsilon: EpsilonScale { scale: bits(1.0), bias: bits(0.0) },
        near_plane: bits(1.0),
        filter_radius: bits(1.0),
    }
}

/// A splat at depth 2 on the axis, with the given tangents.
fn setup(tangents: [[f32; 3]; 2]) -> Option<SetupSplat> {
    setup_in(Format::F32, Feature::Off, tangents, &uniforms())
}

fn setup_in(
    geometry: Format,
    culling: Feature,
    tangents: [[f32; 3]; 2],
    uniforms: &SetupUniforms,
) -> Option<SetupSplat> {
    let unit = Setup::new(&Config { height: 128, geometry, culling, ..Config::default() }, 1);
    let encode = |value: f32| Number::new(Format::F32, value.to_bits()).convert(geometry).bits();
    let center = [0.0, 0.0, 2.0].map(encode);
    let tangents = tangents.map(|tangent| tangent.map(encode));
    let encode = |bits| encode(f32::from_bits(bits));
    let uniforms = SetupUniforms {
        viewport: Viewport {
            scale: uniforms.viewport.scale.map(encode),
            origin: uniforms.viewport.origin.map(encode),
            depth_a: encode(uniforms.viewport.depth_a),
            depth_b: encode(uniforms.viewport.depth_b),
        },
        epsilon: EpsilonScale { scale: encode(uniforms.epsilon.scale), bias: encode(uniforms.epsilon.bias) },
        near_plane: encode(uniforms.near_plane),
        filter_radius: encode(uniforms.filter_radius),
    };
    unit.setup(&Splat { center, tangents, ..Splat::default() }, &uniforms)
}

fn bounds(splat: &SetupSplat) -> [u16; 4] {
    let ImageRectangle { left, right, top, bottom } = splat.bounds;
    [left, right, top, bottom]
}

#[test]
fn a_facing_disc_has_the_bounds_of_its_circle() {
    // 0.2 at distance 2: 10 px about (128, 64); samples lie at half pixels.
    let splat = setup([[0.2, 0.0, 0.0], [0.0, 0.2, 0.0]]).expect("it is in view");
    assert_eq!(bounds(&splat), [118, 137, 54, 73]);
    let Band { depth, low, high } = splat.footprint.band;
    assert_eq!([depth, low, high], [1 << 23; 3], "all of it lies at depth ½");
    let tiny = setup([[1e-6, 0.0, 0.0], [0.0, 1e-6, 0.0]]).expect("the filter shows it");
    assert_eq!(bounds(&tiny), [127, 128, 63, 64]);
}

#[test]
fn a_slanted_disc_has_a_depth_range() {
    let splat = setup([[0.2, 0.0, 0.5], [0.0, 0.2, 0.0]]).expect("it is in view");
    let Band { low, high, .. } = splat.footprint.band;
    // It reaches from z = 1½ to z = 2½: depths ⅓ and ⅗.
    let error =
        [(low, 1.0 / 3.0), (high, 3.0 / 5.0)].map(|(bits, depth)| (f64::from(bits) / f64::from(1 << 24) - depth).abs());
    assert!(error.into_iter().all(|error| error < 1e-6), "{low}, {high}");
}

#[test]
fn a_splat_across_the_near_plane_is_tested_at_its_center() {
    // It reaches from z = ½ to z = 3½.
    let splat = setup([[0.2, 0.0, 1.5], [0.0, 0.2, 0.0]]).expect("it is in view");
    assert_ne!(bounds(&splat), [0, 255, 0, 127]);
    assert_eq!(splat.footprint.band, Band { depth: 1 << 23, low: 0, high: (1 << 24) - 1 });
}

#[test]
fn without_the_part_for_the_eye_plane_whole_splats_are_what_they_were() {
    let unit =
        |eye_plane| Setup::new(&Config { height: 128, geometry: Format::F32, eye_plane, ..Config::default() }, 1);
    let [with, without] = [Feature::On, Feature::Off].map(unit);
    let splat = |reach: f32| {
        let tangents = [[0.0, 0.2, 0.0], [0.2, 0.0, 2.0 * reach]].map(|tangent| tangent.map(f32::to_bits));
        Splat { center: [0.0, 0.0, 2.0].map(f32::to_bits), tangents, ..Splat::default() }
    };
    for (reach, is_whole) in [(0.0, true), (0.9, true), (0.999_94, false), (1.5, false)] {
        let splat = splat(reach);
        assert_eq!(with.slant_of(&splat, &uniforms()).is_whole, is_whole, "{reach}");
        let unseen = |setup: &Setup| {
            let drawn = setup.setup(&splat, &uniforms()).expect("it is in view");
            SetupSplat { footprint: Footprint { sight: Sight::default(), ..drawn.footprint }, ..drawn }
        };
        let same = unseen(&with) == unseen(&without);
        assert_eq!(same, is_whole, "{reach}: only splats across the eye plane need the part");
    }
}

#[test]
fn back_faces_are_culled_in_any_size_and_image() {
    let [upright, upside_down] = [1.0, -1.0].map(|sign| {
        let scale = [100.0_f32, sign * 100.0].map(f32::to_bits);
        SetupUniforms { viewport: Viewport { scale, ..uniforms().viewport }, ..uniforms() }
    });
    let is_drawn = |tangents, culling, uniforms| setup_in(Format::F32, culling, tangents, uniforms).is_some();
    for size in [0.2_f32, 1e-12, 1e12] {
        // The cross product of the front's tangents points towards the eye, along −z.
        let front = [[0.0, size, 0.0], [size, 0.0, 0.0]];
        let back = [front[1], front[0]];
        for uniforms in [&upright, &upside_down] {
            assert!(is_drawn(front, Feature::On, uniforms) && !is_drawn(back, Feature::On, uniforms), "{size}");
            assert!(is_drawn(front, Feature::Off, uniforms) && is_drawn(back, Feature::Off, uniforms));
        }
        let edge_on = [front[0], front[0]];
        assert!(is_drawn(edge_on, Feature::On, &upright), "its disc is drawn");
    }
}

#[test]
fn a_splat_seen_edge_on_has_no_delta() {
    // Tangents a little apart from parallel: more and less than rounding takes.
    for (format, apart) in [(Format::F32, 1e-5_f32), (Format::F24, 1e-3)] {
        let delta = |tilt: f32| {
            let splat = setup_in(format, Feature::On, [[0.3, 0.3, 0.0], [0.3 + tilt, 0.3, 0.0]], &uniforms());
            Number::new(format, splat.expect("it is in view").footprint.delta)
        };
        assert!(delta(0.0).is_nan() && delta(apart / 128.0).is_nan());
        assert!(delta(apart).is_negative());
    }
}

#[test]
fn coarse_formats_keep_away_from_the_eye_plane() {
    let has_viewport = |format, reach: f32| {
        // Bounds by the box, which holds the axis here.
        let splat = setup_in(format, Feature::Off, [[0.2, 0.0, 2.0 * reach], [0.0, 0.2, 0.0]], &uniforms());
        bounds(&splat.expect("it is in view")) == [0, 255, 0, 127]
    };
    // `e = 1 − reach²`: 0.06, 0.02, 2^−13.
    for (reach, fine, coarse) in [(0.97, false, false), (0.99, false, true), (0.999_94, true, true)] {
        assert_eq!((has_viewport(Format::F32, reach), has_viewport(Format::F24, reach)), (fine, coarse), "{reach}");
    }
}

#[test]
fn the_footprint_alone_has_the_rasterizers_format() {
    let setup = |rasterizer: Option<Format>| {
        let rasterizer = rasterizer.map(RasterFormat::Float);
        let unit = Setup::new(&Config { geometry: Format::F32, rasterizer, ..Config::default() }, 1);
        let encode = f32::to_bits;
        let (center, tangents) =
            ([0.3, 0.1, 2.0].map(encode), [[0.0, 0.3, 0.1], [0.2, 0.0, 0.7]].map(|t| t.map(encode)));
        unit.setup(&Splat { center, tangents, ..Splat::default() }, &uniforms()).expect("it is in view")
    };
    let (wide, narrow) = (setup(None), setup(Some(Format::BF16)));
    let rounded = |bits| Number::new(Format::F32, bits).convert(Format::BF16).bits();
    let Footprint { center, ax, bx, ay, by, delta, mx, my, shift, sight, band, plane } = wide.footprint;
    let center = center.map(rounded);
    let [ax, bx, ay, by, delta, mx, my] = [ax, bx, ay, by, delta, mx, my].map(rounded);
    let plane = DepthPlane {
        center: rounded(plane.center),
        slope: plane.slope.map(rounded),
        range: plane.range.map(rounded),
        epsilon: rounded(plane.epsilon),
    };
    let limit = |bits: u32| if bits << 1 == u32::MAX - 1 { 0x7fff } else { rounded(bits) };
    let sight = Sight { near: limit(sight.near), far: limit(sight.far), ..sight };
    let rounded = Footprint { center, ax, bx, ay, by, delta, mx, my, shift, sight, band, plane };
    assert_eq!(narrow.footprint, rounded);
    assert_eq!(narrow.bounds, wide.bounds);
}

#[test]
fn a_splat_across_the_eye_plane_has_the_bounds_of_its_box() {
    let splat = setup([[0.2, 0.0, 2.0], [0.0, 0.2, 0.0]]).expect("it is in view");
    assert_eq!(bounds(&splat), [0, 255, 0, 127], "the axis lies in the box");
    assert_eq!(splat.footprint.band, Band { depth: 1 << 23, low: 0, high: (1 << 24) - 1 });

    // Half right of the axis, ½ below it; its box reaches from −2 to 6.
    let aside = |center: [f32; 3], scale_x: f32| {
        let config = Config { height: 128, geometry: Format::F32, culling: Feature::Off, ..Config::default() };
        let unit = Setup::new(&config, 1);
        let tangents = [[0.0, 0.0625, 0.0], [0.125, 0.0, 2.0]].map(|tangent| tangent.map(f32::to_bits));
        let splat = Splat { center: center.map(f32::to_bits), tangents, ..Splat::default() };
        let viewport = Viewport { scale: [scale_x, 100.0].map(f32::to_bits), ..uniforms().viewport };
        unit.setup(&splat, &SetupUniforms { viewport, ..uniforms() })
    };
    // From (2.25 − 0.25)/6 on to the right, and to −(0.5 − 0.125)/6 upwards; the centre's disc is at 240.
    let below = |splat: Option<SetupSplat>| bounds(&splat.expect("it is in view"));
    assert_eq!(below(aside([2.25, -0.5, 2.0], 100.0)), [161, 255, 0, 57]);
    assert_eq!(below(aside([2.25, -0.5, 2.0], -100.0)), [0, 94, 0, 57], "mirrored");
    assert_eq!(aside([40.0, 0.0, 2.0], 100.0), None, "nowhere in the image");
    assert_eq!(below(aside([0.25, -0.5, 2.0], 100.0))[..2], [0, 255], "the box touches the axis");
}

/// `D`'s limits as numbers, and which of its terms stands for it.
fn sight(splat: &SetupSplat) -> (f32, f32, bool) {
    let Sight { near, far, turned, .. } = splat.footprint.sight;
    (f32::from_bits(near), f32::from_bits(far), turned)
}

#[test]
fn only_what_reaches_beyond_a_plane_has_a_limit() {
    // Depth is `2 − 2/z`: from the near plane at 1 to the far one at 2.
    let viewport = Viewport { depth_a: f32::to_bits(2.0), depth_b: f32::to_bits(-2.0), ..uniforms().viewport };
    let drawn = |z: f32, reach: f32| {
        let unit = Setup::new(&Config { geometry: Format::F32, culling: Feature::Off, ..Config::default() }, 1);
        let tangents = [[0.0, 0.25, 0.0], [0.25, 0.0, reach]].map(|tangent| tangent.map(f32::to_bits));
        let splat = Splat { center: [0.0, 0.0, z].map(f32::to_bits), tangents, ..Splat::default() };
        unit.outcome(&splat, &SetupUniforms { viewport, ..uniforms() })
    };
    let limits = |z: f32, reach: f32| {
        let drawn = drawn(z, reach).expect("some of it is in view");
        let (near, far, turned) = sight(&drawn);
        let of = f32::from_bits(drawn.footprint.delta).abs() * if turned { reach } else { z };
        (near / of, far / of, turned, drawn.footprint.sight.disc)
    };
    let (near, far, turned, disc) = limits(1.5, 0.25);
    assert!(near.is_nan() && far == 0.0 && !turned && disc, "all of it lies between both");
    let is_about = |value: f32, expected: f32| (value - expected).abs() < 1e-5;
    let (near, far, ..) = limits(1.25, 0.5);
    assert!(is_about(near, 1.0) && far == 0.0, "it reaches before the near plane, at 1/z = {near}");
    let (near, far, _, disc) = limits(1.75, 0.5);
    assert!(near.is_nan() && is_about(far, 0.5) && disc, "it reaches behind the far plane, at 1/z = {far}");
    for z in [0.9, 0.25, -0.5] {
        let (near, far, turned, disc) = limits(z, 2.0);
        assert!(is_about(near, 1.0) && is_about(far, 0.5) && turned && !disc, "{z}: {near}, {far}");
    }
    let (_, far, turned, disc) = limits(2.25, 0.5);
    assert!(is_about(far, 0.5) && !turned && !disc, "its centre lies behind the far plane");
    assert_eq!(drawn(0.5, 0.125), Err(Dropped::Near));
    assert_eq!(drawn(-2.5, 1.0), Err(Dropped::Near));
    assert_eq!(drawn(2.5, 0.125), Err(Dropped::Far));
}

#[test]
fn size_is_no_question_of_range() {
    // What a footprint has that was scaled: numbers about one, whatever the splat's size is, and one power of two from it.
    let unit = Setup::new(&Config { geometry: Format::F32, culling: Feature::Off, ..Config::default() }, 1);
    let footprint = |size: f32| {
        let tangents = [[0.0, size, 0.0], [size, 0.0, 0.25 * size]].map(|tangent| tangent.map(f32::to_bits));
        let splat = Splat { center: [0.5, 0.0, 2.0].map(f32::to_bits), tangents, ..Splat::default() };
        unit.setup(&splat, &uniforms()).expect("it is in view").footprint
    };
    let numbers = |footprint: &Footprint| {
        let Footprint { ax, bx, ay, by, delta, mx, my, .. } = *footprint;
        [ax, bx, ay, by, mx, my, delta].map(f32::from_bits)
    };
    let ordinary = numbers(&footprint(0.25));
    for power in [-90, -40, -1, 1, 40, 57] {
        let [lengths @ .., _, _, delta] = numbers(&footprint(0.25 * f32::powi(2.0, power)));
        // Half of what it is at the near plane, at half the depth.
        assert!((0.5..1.0).contains(&delta.abs()), "2^{power}: {delta}");
        // Δ is an area: twice the size makes lengths half as long beside it.
        let [ordinary @ .., _, _, _] = ordinary;
        assert_eq!(lengths.map(|length| length * f32::powi(2.0, power)), ordinary, "2^{power}");
    }
}

/// Splats of the sizes and slants that scenes have, some of them slivers, in and around the image of [`uniforms`].
fn any_splat(geometry: Format, random: &mut fastrand::Rng) -> Splat {
    let encode = |value: f32| Number::new(Format::F32, value.to_bits()).convert(geometry).bits();
    let mut centered = || 2.0 * random.f32() - 1.0;
    let z = 3.0 + 2.0 * centered();
    let center = [1.5 * z * centered(), 0.8 * z * centered(), z];
    let [a, b] = [(); 2].map(|()| glam::Vec3::from([centered(), centered(), centered()]));
    let first = a.try_normalize().unwrap_or(glam::Vec3::X);
    let second = first.cross(b).try_normalize().unwrap_or(first.any_orthonormal_vector());
    let radius = 2_f32.powf(2.5 * centered() - 4.0);
    let shorter = if random.u8(..4) == 0 { random.f32() } else { 1.0 };
    let tangents = [first * radius, second * (radius * shorter)];
    let tangents = tangents.map(|tangent| tangent.to_array().map(encode));
    Splat { center: center.map(encode), tangents, ..Splat::default() }
}

#[test]
fn no_sample_of_a_splat_lies_beyond_its_diagonals() {
    let fixed = RasterFormat::Fixed(pointcore_contract::splat::Coefficient::Eighteen);
    for (geometry, rasterizer, screen_filter, sampling) in [
        (Format::F32.flushed(), None, Feature::Off, Sampling::Center),
        (Format::F32.flushed(), None, Feature::On, Sampling::Flipquad),
        (Format::F24.flushed(), None, Feature::On, Sampling::Center),
        (Format::F24.flushed(), None, Feature::Off, Sampling::Flipquad),
        (Format::BF16, None, Feature::On, Sampling::Center),
        (Format::F24.flushed(), Some(fixed), Feature::On, Sampling::Center),
    ] {
        let columns = sampling.columns();
        let config = Config {
            width: 256 * columns,
            height: 128,
            geometry,
            rasterizer,
            screen_filter,
            sampling,
            culling: Feature::Off,
            ..Config::default()
        };
        let setup = Setup::new(&config, 1);
        let rasterizer = crate::splat::Rasterizer::new(&config, 1);
        let encoded = |bits: u32| Number::new(Format::F32, bits).convert(geometry).bits();
        let SetupUniforms { viewport, epsilon, near_plane, .. } = uniforms();
        let Viewport { scale, origin, depth_a, depth_b } = viewport;
        let uniforms = SetupUniforms {
            viewport: Viewport {
                scale: scale.map(encoded),
                origin: origin.map(encoded),
                depth_a: encoded(depth_a),
                depth_b: encoded(depth_b),
            },
            epsilon: EpsilonScale { scale: encoded(epsilon.scale), bias: encoded(epsilon.bias) },
            near_plane: encoded(near_plane),
            filter_radius: encoded(0.75_f32.to_bits()),
        };
        let filter_scale = match config.raster_format() {
            RasterFormat::Float(_) => encoded((1.0_f32 / (0.75 * 0.75)).to_bits()),
            RasterFormat::Fixed(_) => (16.0 / 9.0 * 4096.0) as u32,
        };
        let random = &mut fastrand::Rng::with_seed(5);
        let row_mask = (1 << config.row_bits()) - 1;
        let [mut inside, mut within, mut boxed] = [0_u32; 3];
        for _ in 0..4000 {
            let splat = any_splat(geometry, random);
            let Some(SetupSplat { bounds, diagonals, footprint, .. }) = setup.setup(&splat, &uniforms) else {
                continue;
            };
            let ImageRectangle { left, right, top, bottom } = bounds;
            for (row, column) in (top..=bottom).flat_map(|row| (left..=right).map(move |column| (row, column))) {
                let pixel = column / columns as u16;
                let [sum, difference] = [pixel + row, pixel + (row_mask - row)];
                let is_within = (diagonals.first_sum..=diagonals.last_sum).contains(&sum)
                    && (diagonals.first_difference..=diagonals.last_difference).contains(&difference);
                let squared = rasterizer.squared_distance(&footprint, [column, row].map(u32::from), filter_scale);
                let is_inside = crate::splat::Rasterizer::is_inside(squared);
                assert!(is_within || !is_inside, "({column}, {row}) of {splat:?} in {geometry}");
                boxed += 1;
                within += u32::from(is_within);
                inside += u32::from(is_inside);
            }
        }
        let [boxed, within] = [boxed, within].map(|count| f64::from(count) / f64::from(inside));
        println!("{geometry} {sampling:?}: {boxed:.3} {within:.3}");
        assert!(geometry.mantissa < Format::F24.mantissa || within < 0.85 * boxed, "{within} of {boxed} visited");
    }
}
