//! The footprint beside the kernel that it stands for.

use super::*;
use crate::reference::motion::MovingFootprint;

#[test]
fn a_footprint_covers_a_sample_when_and_as_its_kernel_does() {
    let rendering = Rendering { depth: FragmentDepth::Plane, ..UNFILTERED };
    let mut random = Random::new();
    let mut covered = 0;
    for index in 0..3000 {
        let mut moving = random.moving(0.3);
        if index % 3 == 0 {
            // Through the near plane.
            moving.motion.z = -f64::from(moving.splat.center[2]) * random.uniform(0.5, 1.5);
        }
        let place = random.place_near(&moving);
        let Ok(footprint) = MovingFootprint::new(&moving, &CAMERA, &rendering) else { continue };
        let kernel = Kernel::new(&moving, &CAMERA, &rendering).expect("the footprint is not culled either");
        assert_eq!(kernel.bounds, footprint.bounds);
        let met = footprint.meet(&place);
        let squared_distance = met.squared_distance(footprint.time);
        let interval = met.life.and_then(|life| squared_distance.within_kernel(life));
        let pieces = kernel.pieces(&place, &CAMERA);
        let (Some(interval), [piece]) = (interval, pieces.as_slice()) else {
            let length =
                interval.map_or(0.0, Interval::length) + pieces.iter().map(|p| p.interval.length()).sum::<f64>();
            assert!(length < 1e-4, "{interval:?} beside {pieces:?}: {moving:?}");
            continue;
        };
        let ends = [interval.begin - piece.interval.begin, interval.end - piece.interval.end];
        assert!(ends.iter().all(|end| end.abs() < 1e-4), "{interval:?} beside {piece:?}: {moving:?}");
        let integral = |squared_distance: &crate::reference::motion::distance::SquaredDistance| {
            squared_distance.integral(Shutter::Box, rendering.kernel_gamma, piece.interval)
        };
        assert!((integral(&squared_distance) - integral(&piece.squared_distance)).abs() < 1e-6, "{moving:?}");
        // What the hull of a splat that reaches the near plane spans in depth has no meaning.
        let time = interval.middle();
        let depth = kernel.band(time, &place, &CAMERA, &rendering).depth();
        if (0.01..0.99).contains(&depth) {
            let found = footprint.depth(time, met.determinant, &CAMERA, &rendering);
            assert!((found - depth).abs() < 1e-6, "{found} beside {depth}: {moving:?}");
        }
        covered += 1;
    }
    assert!(covered > 1000, "{covered}");
}
