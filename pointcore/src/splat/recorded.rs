//! The beginning of a small frame, recorded at the ports of the golden model: the test that goes with generated Verilog.

use super::encode::{END, EncodedFrame};
use super::generate::SplatCore;
use super::run::SplatRunner;
use crate::number::{encode, encode_attribute};
use crate::recording::Recording;
use crate::uniforms::uniforms;
use fastrand::Rng;
use glam::{DMat3, DVec3, EulerRot};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Attributes, Splat};
use pointcore_contract::{Camera, Rendering};
use pointcore_tb::lockstep::{LockstepError, Stall};

/// Splats of the frame.
const SPLATS: usize = 40;
/// Cycles of the recording: the whole frame would take hundreds of times as many.
const CYCLES: u64 = 12_000;
/// Pixel that the camera's axis meets: near the first tile, for tiles leave the core in their order.
const CENTER_PX: f64 = 16.0;
/// Cycles beyond one a tile until the core has cleared its directory of tiles.
const SETTLING_CYCLES: u64 = 8;
/// Where the splats lie in front of the camera, and the largest half of their size, in pixels; the near plane cuts some off.
const NEAR: f32 = 1.0;
const DEPTHS: [f32; 2] = [0.9, 9.0];
const SPREAD_PX: [f32; 2] = [120.0, 20.0];
const LARGEST_PX: f32 = 12.0;
/// Chance that the memory or the host waits in a cycle.
const STALLS: Stall = Stall::Random(0.2);
/// The seed of splats.
const SEED: u64 = 1;

/// A rotation without a zero in it, and where it takes the origin: no product of the projection is trivial.
fn view() -> (DMat3, DVec3) {
    (DMat3::from_euler(EulerRot::XYZ, 0.7, -0.4, 2.1), DVec3::new(0.31, -0.22, 1.43))
}

/// A camera whose view is one unit high at distance 1.
fn camera(config: &Config) -> Camera {
    let height = f64::from(config.height);
    let (near, far) = (f64::from(NEAR), 10.0);
    let depth_a = far / (far - near);
    let (rotation, translation) = view();
    let row = |index: usize| {
        let row = rotation.row(index);
        [row.x, row.y, row.z, translation[index]]
    };
    Camera {
        model_view: [row(0), row(1), row(2)],
        scale_x: height,
        scale_y: height,
        center_x: CENTER_PX,
        center_y: CENTER_PX,
        depth_a,
        depth_b: -near * depth_a,
        near,
    }
}

fn rendering(config: &Config) -> Rendering {
    Rendering {
        width: config.width as usize,
        height: config.height as usize,
        sampling: config.sampling,
        depth: config.depth,
        kernel_gamma: Rendering::DEFAULT_KERNEL_GAMMA,
        filter_radius_px: Some(Rendering::DEFAULT_FILTER_RADIUS_PX),
        epsilon_scale: Rendering::DEFAULT_EPSILON_SCALE,
        epsilon_bias: 1e-3,
    }
}

/// A splat around the upper rim of the image, of any orientation.
fn splat(config: &Config, random: &mut Rng) -> Splat {
    let (rotation, translation) = view();
    let world = |vector: DVec3| (rotation.transpose() * vector).as_vec3().to_array();
    let vector = |numbers: [f32; 3]| numbers.map(|number| encode(config.geometry, number));
    let signed = |random: &mut Rng| f64::from(2.0 * random.f32() - 1.0);
    let depth = f64::from(DEPTHS[0] + (DEPTHS[1] - DEPTHS[0]) * random.f32());
    let px = depth / f64::from(config.height);
    let [x, y] = SPREAD_PX.map(|spread| f64::from(spread) * signed(random) * px);
    let mut tangent = || DVec3::from([(); 3].map(|()| signed(random))) * (f64::from(LARGEST_PX) * px);
    let tangents = [tangent(), tangent()].map(|tangent| vector(world(tangent)));
    let center = vector(world(DVec3::new(x, y, depth) - translation));
    let mut attributes = Attributes::default();
    let (continuous, cardinals) = attributes.split_at_mut(config.continuous as usize);
    continuous.fill_with(|| encode_attribute(config.attribute, 2.0 * random.f32() - 1.0));
    cardinals[..config.cardinal as usize].fill_with(|| random.u32(..));
    Splat { end: false, center, tangents, attributes }
}

fn frame(config: &Config) -> EncodedFrame {
    let mut random = Rng::with_seed(SEED);
    let splats = (0..SPLATS).map(|_| splat(config, &mut random));
    EncodedFrame {
        records: splats.chain([END]).collect(),
        uniforms: uniforms(&camera(config), &rendering(config), config),
    }
}

/// Records the beginning of a frame on the hardware of a configuration.
///
/// # Errors
/// The frame does not come to its end.
pub fn record(config: &Config, core: &SplatCore) -> Result<Recording, LockstepError> {
    let frame = frame(config);
    let stop_after = Some(CYCLES);
    let runner = SplatRunner { config, frame: &frame, stall: STALLS, seed: SEED, progress: &|_, _| {}, stop_after };
    runner.recording(core, (1 << config.tile_bits()) + SETTLING_CYCLES)
}
