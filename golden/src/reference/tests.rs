use super::*;
use glam::DVec3;
use pointcore_contract::{FragmentDepth, Sampling};

const CAMERA: Camera = Camera {
    model_view: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
    scale_x: 50.0,
    scale_y: 60.0,
    center_x: 32.0,
    center_y: 30.0,
    depth_a: 100.0 / 99.0,
    depth_b: -100.0 / 99.0,
    near: 1.0,
};

const RENDERING: Rendering = Rendering {
    width: 64,
    height: 61,
    sampling: Sampling::Center,
    depth: FragmentDepth::Center,
    kernel_gamma: Rendering::DEFAULT_KERNEL_GAMMA,
    filter_radius_px: Some(Rendering::DEFAULT_FILTER_RADIUS_PX),
    epsilon_scale: Rendering::DEFAULT_EPSILON_SCALE,
    epsilon_bias: 0.01,
};

const UNFILTERED: Rendering = Rendering { filter_radius_px: None, ..RENDERING };

fn splat(center: [f32; 3], tangents: [[f32; 3]; 2]) -> Splat {
    Splat { center, tangents, attributes: [0.0, 0.0, -1.0, 0.2, 0.4, 0.6], material: 1 }
}

/// A disc at the given center that faces the eye squarely.
fn facing(center: [f32; 3], radius: f32) -> Splat {
    splat(center, [[0.0, radius, 0.0], [radius, 0.0, 0.0]])
}

fn footprint(splat: &Splat, rendering: &Rendering) -> (Projection, Footprint) {
    let projection = Projection::new(splat, &CAMERA).expect("the test's splat is visible");
    let footprint = Footprint::new(&projection, rendering, Mapping::Backward).expect("the test's splat is in view");
    (projection, footprint)
}

/// Random splats, small and large, of which some face away, some leave the viewport and some cross the eye plane.
fn random_splats(count: usize) -> Vec<Splat> {
    let seed = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1_u64);
    println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-golden reference");
    let mut state = seed;
    let mut uniform = move |low: f32, high: f32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((state >> 40) as f32 / (1 << 24) as f32)
    };
    let splats = (0..count).map(|_| {
        let size = 2_f32.powf(uniform(-6.0, 2.5));
        let mut vector = || [uniform(-1.0, 1.0) * size, uniform(-1.0, 1.0) * size, uniform(-1.0, 1.0) * size];
        let tangents = [vector(), vector()];
        let z = uniform(-1.5, 12.0);
        let spread = 0.8 * z.abs().max(0.5);
        let mut splat = splat([uniform(-1.0, 1.0) * spread, uniform(-1.0, 1.0) * spread, z], tangents);
        splat.attributes = splat.attributes.map(|_| uniform(0.0, 1.0));
        splat.material = uniform(0.0, 5.0) as u16;
        splat
    });
    splats.collect()
}

/// `ρ²` at pixel `(column, row)` by intersecting the viewing ray with the splat's plane in camera space, between near and far plane.
fn ray_cast(splat: &Splat, column: usize, row: usize) -> Option<f64> {
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let ray = DVec3::new(
        (column as f64 + 0.5 - CAMERA.center_x) / CAMERA.scale_x,
        (row as f64 + 0.5 - CAMERA.center_y) / CAMERA.scale_y,
        1.0,
    );
    let (u, a1, a2) = (vector(splat.center), vector(splat.tangents[0]), vector(splat.tangents[1]));
    let n = a1.cross(a2);
    let distance = u.dot(n) / ray.dot(n);
    let offset = distance * ray - u;
    // `a2 × n` is orthogonal to a2 and n, so it singles out the coordinate along a1, and likewise for a2.
    let (s, t) = (offset.dot(a2.cross(n)) / a1.dot(a2.cross(n)), offset.dot(a1.cross(n)) / a2.dot(a1.cross(n)));
    let far = CAMERA.depth_b / (1.0 - CAMERA.depth_a);
    (distance > CAMERA.near * (1.0 + 1e-9) && distance < far * (1.0 - 1e-9)).then_some(s * s + t * t)
}

#[test]
fn a_facing_disc_covers_exactly_its_circle() {
    // 2 units at distance 10: semi-axes of 10 px and 12 px about the pixel coordinate (32, 30).
    let (projection, footprint) = footprint(&facing([0.0, 0.0, 10.0], 2.0), &UNFILTERED);
    assert_eq!(footprint.bounds, Bounds { columns: 22..42, rows: 18..42 });
    assert_eq!((projection.half_depth, projection.depth), (0.0, CAMERA.depth_a + CAMERA.depth_b * 0.1));
    for row in 0..RENDERING.height {
        for column in 0..RENDERING.width {
            let (x, y) = ((column as f64 + 0.5 - 32.0) / 10.0, (row as f64 + 0.5 - 30.0) / 12.0);
            let expected = x * x + y * y;
            match footprint.weight(column, row) {
                None => assert!(expected >= 1.0, "({column}, {row}) is inside"),
                Some(weight) => {
                    assert!(expected < 1.0, "({column}, {row}) is outside");
                    assert!((weight - (-2.0 * expected).exp()).abs() < 1e-12);
                }
            }
        }
    }
}

#[test]
fn weights_follow_the_ray_cast_and_bounds_hold_them_all() {
    let (mut compared, mut crossing) = (0, 0);
    for splat in random_splats(3000) {
        let Ok(projection) = Projection::new(&splat, &CAMERA) else { continue };
        crossing += usize::from(projection.crosses_eye_plane());
        let footprint = Footprint::new(&projection, &UNFILTERED, Mapping::Backward);
        for row in 0..RENDERING.height {
            for column in 0..RENDERING.width {
                let Some(expected) = ray_cast(&splat, column, row).filter(|squared| *squared < 1.0 - 1e-6) else {
                    continue;
                };
                let Ok(footprint) = &footprint else { panic!("culled, but covers ({column}, {row}): {splat:?}") };
                let bounds = &footprint.bounds;
                assert!(bounds.columns.contains(&column) && bounds.rows.contains(&row), "{bounds:?} of {splat:?}");
                let weight = footprint.weight(column, row).expect("the ray cast hit the splat");
                assert!((weight - (-2.0 * expected).exp()).abs() < 1e-6, "({column}, {row}) of {splat:?}");
                compared += 1;
            }
        }
    }
    assert!(compared > 10_000 && crossing > 10, "compared {compared} samples, {crossing} splats across the eye plane");
}

#[test]
fn bounds_are_tight() {
    // Every side of the rectangle is touched: growing the splat's image by a pixel is all that rounding may add.
    let (mut compared, mut ranges) = (0, 0);
    for splat in random_splats(3000) {
        let Ok(projection) = Projection::new(&splat, &CAMERA) else { continue };
        let Ok(footprint) = Footprint::new(&projection, &UNFILTERED, Mapping::Backward) else { continue };
        let Bounds { columns, rows } = footprint.bounds.clone();
        let inner = columns.start > 0 && columns.end < RENDERING.width && rows.start > 0 && rows.end < RENDERING.height;
        if projection.crosses_eye_plane() || !inner {
            continue;
        }
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let rim = (0..720).map(|step| {
            let (sin, cos) = (f64::from(step) * std::f64::consts::PI / 360.0).sin_cos();
            vector(splat.center) + cos * vector(splat.tangents[0]) + sin * vector(splat.tangents[1])
        });
        let (mut high_x, mut high_depth, mut low_depth) = (f64::MIN, f64::MIN, f64::MAX);
        for point in rim {
            high_x = high_x.max(CAMERA.scale_x * point.x / point.z + CAMERA.center_x);
            let depth = CAMERA.depth_a + CAMERA.depth_b / point.z;
            (low_depth, high_depth) = (low_depth.min(depth), high_depth.max(depth));
        }
        assert!((columns.end as f64 - 0.5 - high_x).abs() <= 1.01, "{columns:?}, {high_x}");
        let (low, high) = (projection.depth - projection.half_depth, projection.depth + projection.half_depth);
        let tolerance = 1e-9 + 1e-3 * projection.half_depth;
        compared += 1;
        // The rim is sampled, so it may seem to begin just beyond the near plane.
        if low_depth > tolerance {
            ranges += 1;
            assert!((low - low_depth).abs() < tolerance && (high - high_depth).abs() < tolerance, "{splat:?}");
        } else if low_depth < 0.0 {
            let center = CAMERA.depth_a + CAMERA.depth_b / f64::from(splat.center[2]);
            assert!((projection.depth - center).abs() < 1e-9, "{splat:?}");
        }
    }
    assert!(compared > 100 && ranges > 100, "compared only {compared} splats, {ranges} of them with their depths");
}

#[test]
fn a_plane_has_the_depth_of_its_points() {
    let mut compared = 0;
    for splat in random_splats(1000) {
        let Ok(projection) = Projection::new(&splat, &CAMERA) else { continue };
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        for (s, t) in [(0.0, 0.0), (0.5, -0.6), (-0.9, 0.3)] {
            let point = vector(splat.center) + s * vector(splat.tangents[0]) + t * vector(splat.tangents[1]);
            if point.z <= CAMERA.near {
                continue;
            }
            let x = CAMERA.scale_x * point.x / point.z + CAMERA.center_x - projection.center[0];
            let y = CAMERA.scale_y * point.y / point.z + CAMERA.center_y - projection.center[1];
            let error = projection.plane_depth(x, y) - (CAMERA.depth_a + CAMERA.depth_b / point.z);
            assert!(error.abs() < 1e-6, "({s}, {t}) of {splat:?}: {error}");
            compared += 1;
        }
    }
    assert!(compared > 500, "compared {compared} points");
}

#[test]
fn the_screen_filter_keeps_a_tiny_splat_visible() {
    let tiny = facing([0.01, 0.01, 10.0], 1e-4);
    assert!(
        render(std::slice::from_ref(&tiny), &CAMERA, &UNFILTERED, Mapping::Backward).pixels.iter().all(Option::is_none)
    );
    for mapping in [Mapping::Backward, Mapping::Forward] {
        let frame = render(std::slice::from_ref(&tiny), &CAMERA, &RENDERING, mapping);
        assert_eq!(frame.pixels.iter().flatten().count(), 4, "{mapping:?}: the samples within a pixel of the center");
    }
}

#[test]
fn forward_and_backward_mapping_agree_on_a_facing_disc() {
    let disc = [facing([0.0, 0.0, 10.0], 2.0)];
    let backward = render(&disc, &CAMERA, &UNFILTERED, Mapping::Backward);
    let forward = render(&disc, &CAMERA, &UNFILTERED, Mapping::Forward);
    for (backward, forward) in backward.pixels.iter().zip(&forward.pixels) {
        assert_eq!(backward.is_some(), forward.is_some());
        if let (Some(backward), Some(forward)) = (backward, forward) {
            assert!((backward.weight - forward.weight).abs() < 1e-12);
        }
    }
    assert!(backward.statistics.inside > 300);
}

#[test]
fn splats_are_culled_for_their_reason() {
    let mut away = facing([0.0, 0.0, 10.0], 1.0);
    away.tangents.swap(0, 1);
    let near = facing([0.0, 0.0, 1.0], 0.1);
    let far = facing([0.0, 0.0, 100.5], 1.0);
    let beside = facing([20.0, 0.0, 10.0], 1.0);
    let frame = render(&[away, near, far, beside], &CAMERA, &RENDERING, Mapping::Backward);
    let expected =
        Statistics { splats: 4, back_facing: 1, outside_depth: 2, outside_viewport: 1, ..Statistics::default() };
    assert_eq!(frame.statistics, expected);
    assert_eq!(frame.statistics.drawn(), 0);
}

#[test]
fn the_ternary_test_replaces_blends_and_drops() {
    let color = |z: f32, red: f32| {
        let mut splat = facing([0.0, 0.0, z], 2.0);
        splat.attributes[3] = red;
        splat
    };
    // Depths 0.909…, with a bias of 0.01: 10.2 blends with 10, 5 replaces both, 20 is hidden.
    let splats = [color(10.0, 0.0), color(10.2, 1.0), color(5.0, 0.5), color(20.0, 1.0)];
    let at_center = |count: usize| {
        let frame = render(&splats[..count], &CAMERA, &RENDERING, Mapping::Backward);
        let index = 30 * RENDERING.width + 32;
        (frame.pixels[index].clone().expect("the splats cover the center"), frame.decisions[index])
    };
    let (two, decisions) = at_center(2);
    assert_eq!(decisions, Decisions { pass: 1, blend: 1, fail: 0 });
    assert!((two.attributes[3] - 0.5).abs() < 1e-2 && two.weight > 1.9);
    let (four, decisions) = at_center(4);
    assert_eq!(decisions, Decisions { pass: 2, blend: 1, fail: 1 });
    assert_eq!((four.attributes[3], four.depth), (0.5, CAMERA.depth_a + CAMERA.depth_b / 5.0));
}

#[test]
fn cardinal_attributes_form_voronoi_cells() {
    let centers = [-1.0, 0.0, 1.0];
    let splats: Vec<_> =
        (0..).zip(centers).map(|(material, x)| Splat { material, ..facing([x, 0.0, 10.0], 2.0) }).collect();
    let frame = render(&splats, &CAMERA, &RENDERING, Mapping::Backward);
    for column in 20..44 {
        let x = (column as f64 + 0.5 - 32.0) / 5.0;
        // On a cell's boundary both weights are equal, and the earlier splat keeps the pixel.
        let nearest = centers.iter().skip(1).filter(|center| x > f64::from(**center) - 0.5).count() as u16;
        let fragment = frame.pixels[30 * RENDERING.width + column].as_ref().expect("the splats cover the row");
        assert_eq!(fragment.material, nearest, "column {column}");
    }
}

#[test]
fn bands_render_what_one_pixel_at_a_time_renders() {
    let splats = random_splats(400);
    let frame = render(&splats, &CAMERA, &RENDERING, Mapping::Backward);
    let drawn: Vec<_> = splats
        .iter()
        .filter_map(|splat| {
            let projection = Projection::new(splat, &CAMERA).ok()?;
            Some((splat, projection, Footprint::new(&projection, &RENDERING, Mapping::Backward).ok()?))
        })
        .collect();
    assert_eq!(frame.statistics.drawn(), drawn.len());
    for (index, pixel) in frame.pixels.iter().enumerate() {
        let mut expected = Pixel::default();
        for (splat, projection, footprint) in &drawn {
            let weight = footprint.weight(index % RENDERING.width, index / RENDERING.width);
            if let Some(weight) = weight {
                expected.add(splat, Band::around(projection.depth, projection, &RENDERING), weight);
            }
        }
        assert_eq!((pixel, frame.decisions[index]), (&expected.normalized(), expected.decisions), "pixel {index}");
    }
    let inside: u32 = frame.decisions.iter().map(|counts| counts.pass + counts.blend + counts.fail).sum();
    assert!(inside > 1000 && u64::from(inside) == frame.statistics.inside);
}
