//! The beginning of a small frame, recorded at the ports of the golden model: the test that goes with generated Verilog.

use super::encode::{END, EncodedFrame};
use super::generate::SplatCore;
use super::run::SplatRunner;
use crate::number::{encode, encode_attribute};
use crate::recording::Recording;
use crate::uniforms::uniforms;
use fastrand::Rng;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Attributes, Splat};
use pointcore_contract::{Camera, Rendering};
use pointcore_tb::lockstep::{LockstepError, Stall};

/// Splats of the frame: few, so that its first pixels leave the core within the vectors.
const SPLATS: usize = 3;
/// Bits of the vectors: the whole frame would take hundreds of times as much.
const VECTOR_BITS: u32 = 3 << 19;
/// Pixel that the camera's axis meets: near the first tile, for tiles leave the core in their order.
const CENTER_PX: f64 = 16.0;
/// Cycles beyond one a tile until the core has cleared its directory of tiles.
const SETTLING_CYCLES: u64 = 8;
/// Where the splats lie, and half their size.
const DEPTH: f32 = 5.0;
const RADIUS: f32 = 0.05;
/// The seed of splats.
const SEED: u64 = 1;

/// A camera at the origin that looks along z, its view one unit high at distance 1.
fn camera(config: &Config) -> Camera {
    let height = f64::from(config.height);
    let (near, far) = (1.0, 10.0);
    let depth_a = far / (far - near);
    Camera {
        model_view: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
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

/// A splat near the camera's axis that faces the eye.
fn splat(config: &Config, random: &mut Rng) -> Splat {
    let vector = |numbers: [f32; 3]| numbers.map(|number| encode(config.geometry, number));
    let [x, y] = [(); 2].map(|()| (2.0 * random.f32() - 1.0) * RADIUS);
    let center = vector([x, y, DEPTH + random.f32()]);
    // The cross product of the tangents points at the eye.
    let tangents = [[0.0, RADIUS, 0.0], [RADIUS, 0.0, 0.0]].map(vector);
    let mut attributes = Attributes::default();
    let (continuous, cardinals) = attributes.split_at_mut(config.continuous as usize);
    continuous.fill_with(|| encode_attribute(config.attribute, random.f32()));
    cardinals[..config.cardinal as usize].fill(1);
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
    let width: u32 = core.design.ports().iter().map(|port| port.width).sum();
    let stop_after = Some((VECTOR_BITS / width).into());
    let runner =
        SplatRunner { config, frame: &frame, stall: Stall::Never, seed: SEED, progress: &|_, _| {}, stop_after };
    runner.recording(core, (1 << config.tile_bits()) + SETTLING_CYCLES)
}
