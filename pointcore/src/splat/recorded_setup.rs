//! Setup alone, recorded at the ports of its golden model: most of what it computes moves limits that few samples are near, and
//! does not show at the ports of the core.

use super::generate::SplatCore;
use crate::generated::GenerateError;
use crate::number::encode;
use crate::recording::{Recorder, Recording};
use crate::stimuli::frames::{Frame, Lens, around, between, frames};
use fastrand::Rng;
use pointcore_contract::read;
use pointcore_contract::splat::records::{Splat, Uniforms};
use pointcore_contract::splat::{Config, units};
use pointcore_golden::splat::uniforms::TransformUniforms;
use pointcore_golden::splat::{MotionSetup, Setup, Transform};
use pointcore_golden::unit::Model;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::splat::{motion_setup, setup};
use pointcore_tb::lockstep::{Stall, Stalls};
use rtl::{Design, elaborate};
use std::f32::consts::TAU;

/// Frames whose splats lie all around what the camera sees.
const FRAMES: u64 = 12;
const SPLATS: u32 = 160;
/// Frames of anything, odd numbers among it, each of so many splats at most.
const ODD_FRAMES: usize = 48;
const ODD_SPLATS: u32 = 16;
/// Frames of splats that hardly any scene has.
const HARD_FRAMES: u64 = 12;
/// Binary logarithms, each from the first to the last: of the near plane, of the far one beyond it, of a splat's depth beyond it.
const HARD_UNITS: [f32; 2] = [-40.0, 40.0];
const HARD_RANGES: [f32; 2] = [1.0, 40.0];
const HARD_DEPTHS: [f32; 2] = [-1.0, 12.0];
/// Of a splat's radius across the line of sight (px), of how far from the eye's plane it ends (its depth is 1), of how much shorter some are.
const HARD_RADII_PX: [f32; 2] = [-2.0, 4.0];
const EYE_DISTANCES: [f32; 2] = [-14.0, -1.0];
const SHORTER: [f32; 2] = [-130.0, 0.0];
/// Of how much shorter one part of a tangent is than the other: at about the middle it vanishes beside it.
const VANISHING: [f32; 2] = [-129.0, -126.0];
/// Of how much longer the other part then is: beside a short one, no part could be shorter by so much.
const LONGER: [f32; 2] = [0.0, 24.0];
/// Where splats are in the image, whose edge is 1.
const BESIDE: [f32; 2] = [-0.05, 1.05];
/// How both streams are held back, frame after frame.
const PATTERNS: [Stall; 3] = [Stall::Never, Stall::Varied, Stall::Random(0.2)];
/// Cycles beyond the latency until nothing is under way.
const SETTLING_CYCLES: u32 = 64;

/// Records frames on setup as it stands in the core; its design goes with the recording.
pub fn record_setup(config: &Config, core: &SplatCore) -> Result<(Design, Recording), GenerateError> {
    let (options, latency) = (Options::default(), core.latencies().setup);
    if config.has_motion() {
        let recorder = Recorder::new(config, &units::motion_setup::UNIT, MotionSetup::new(config, latency));
        let recording = record(config, latency, recorder, |recorder, input, out_ready, uniforms| {
            let Uniforms { viewport, epsilon, near_plane, .. } = uniforms;
            let shown = recorder.step(&units::motion_setup::In { input, out_ready, viewport, epsilon, near_plane });
            (shown.in_ready, shown.out.is_some())
        });
        return Ok((elaborate(&motion_setup::datapath(config, &options)?.module)?, recording));
    }
    let recorder = Recorder::new(config, &units::setup::UNIT, Setup::new(config, latency));
    let recording = record(config, latency, recorder, |recorder, input, out_ready, uniforms| {
        let Uniforms { viewport, epsilon, near_plane, filter_radius, .. } = uniforms;
        let inputs = units::setup::In { input, out_ready, viewport, epsilon, near_plane, filter_radius };
        let shown = recorder.step(&inputs);
        (shown.in_ready, shown.out.is_some())
    });
    Ok((elaborate(&setup::datapath(config, &options)?.module)?, recording))
}

/// Records frames by `step`, which is given what comes in and says whether it is taken and something leaves.
fn record<M: Model>(
    config: &Config,
    latency: u32,
    mut recorder: Recorder<M>,
    step: impl Fn(&mut Recorder<M>, Option<Splat>, bool, Uniforms) -> (bool, bool),
) -> Recording {
    for (seed, (uniforms, splats)) in (0..).zip(scenes(config)) {
        let random = &mut Rng::with_seed(seed);
        let pattern = PATTERNS[seed as usize % PATTERNS.len()];
        let [mut source, mut sink] = [(); 2].map(|()| Stalls::new(pattern, random.fork()));
        let mut splats = splats.into_iter().peekable();
        let (mut quiet, mut waits) = (0, false);
        while quiet < latency + SETTLING_CYCLES {
            // What was offered stays until it is taken.
            let offered = splats.peek().copied().filter(|_| waits || !source.stalled());
            let (is_ready, leaves) = step(&mut recorder, offered, !sink.stalled(), uniforms);
            waits = offered.is_some() && !is_ready;
            splats.next_if(|_| offered.is_some() && is_ready);
            quiet = if splats.peek().is_some() || leaves { 0 } else { quiet + 1 };
        }
    }
    recorder.into_recording()
}

/// Splats in camera space, those that transform leaves, and the camera's uniforms.
fn scenes(config: &Config) -> Vec<(Uniforms, Vec<Splat>)> {
    let lens = Lens::whole(config);
    let transform = Transform::new(config, 1);
    let around = (0..FRAMES).map(|seed| around(config, SPLATS, lens, &mut Rng::with_seed(seed)));
    let odd = frames(config, ODD_FRAMES, ODD_SPLATS, lens, None, &mut Rng::with_seed(0));
    let hard = (0..HARD_FRAMES).map(|seed| hard(config, lens, &mut Rng::with_seed(seed)));
    let sent = around.chain(odd).map(|Frame { uniforms, records, .. }| (read(config, &uniforms), records));
    let seen = |(uniforms, splats): (Uniforms, Vec<Splat>)| {
        let Uniforms { model_view, near_plane, .. } = uniforms;
        let camera = TransformUniforms { model_view, near_plane };
        let left = splats.iter().filter_map(|splat| transform.transform(splat, &camera));
        (uniforms, left.collect())
    };
    sent.chain(hard).map(seen).collect()
}

/// A frame that few scenes have: in a unit of length of its own, with a far plane far beyond the near one, of splats that lie along the
/// line of sight and end just before the eye's plane, where what is added for rounding shows, and of such that are as short as the
/// format's numbers can be.
fn hard(config: &Config, lens: Lens, random: &mut Rng) -> (Uniforms, Vec<Splat>) {
    let Frame { uniforms, mut records, .. } = around(config, SPLATS, lens, random);
    let number = |value: f32| encode(config.geometry, value);
    let near = between(HARD_UNITS, random).exp2();
    let far = near * between(HARD_RANGES, random).exp2();
    let depth_a = far / (far - near);
    let mut uniforms: Uniforms = read(config, &uniforms);
    let row = |axis: usize| [0, 1, 2, 3].map(|column| number(if column == axis { 1.0 } else { 0.0 }));
    uniforms.model_view.rows = [row(0), row(1), row(2)];
    uniforms.near_plane = number(near);
    (uniforms.viewport.depth_a, uniforms.viewport.depth_b) = (number(depth_a), number(-near * depth_a));
    for splat in records.iter_mut().filter(|splat| !splat.end) {
        let depth = near * between(HARD_DEPTHS, random).exp2();
        let pixel = [config.width, config.height].map(|edge| edge as f32 * between(BESIDE, random));
        let mut place = [0, 1].map(|axis| (pixel[axis] - lens.origin[axis]) / lens.scale[axis]);
        let mut tangents = [(); 2].map(|()| {
            let radius = depth * between(HARD_RADII_PX, random).exp2();
            [0, 1].map(|axis| radius * between([-1.0, 1.0], random) / lens.scale[axis])
        });
        let (sine, cosine) = between([0.0, TAU], random).sin_cos();
        let mut along = [cosine, sine].map(|part| part * depth * (1.0 - between(EYE_DISTANCES, random).exp2()));
        match random.u8(..3) {
            0 => {
                for part in tangents.iter_mut().flatten().chain(&mut along) {
                    if random.bool() {
                        *part *= between(SHORTER, random).exp2();
                    }
                }
            }
            1 => {
                let [tangent, axis] = [(); 2].map(|()| random.usize(..2));
                let [long, short] = [LONGER, VANISHING].map(|range| between(range, random).exp2());
                tangents[tangent][1 - axis] *= long;
                tangents[tangent][axis] = tangents[tangent][1 - axis] * short;
                // Elsewhere its part along the line of sight would be most of it.
                place[axis] = 0.0;
            }
            _ => {}
        }
        let [x, y] = place;
        let vector = |[of_x, of_y]: [f32; 2], of_z: f32| [x * of_z + of_x, y * of_z + of_y, of_z].map(number);
        splat.center = vector([0.0; 2], depth);
        splat.tangents = [0, 1].map(|of| vector(tangents[of], along[of]));
    }
    (uniforms, records)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::Feature;

    #[test]
    fn it_is_the_setup_of_the_core_and_some_splats_leave_it() {
        let still = Config { width: 64, height: 48, ..Config::default() };
        let moving = Config {
            time_bins: 4,
            setup_interval: 16,
            culling: Feature::On,
            screen_filter: Feature::Off,
            ..still.clone()
        };
        for config in [still, moving] {
            let core = SplatCore::generate(&config).unwrap_or_else(|error| panic!("{error}"));
            let (design, recording) = record_setup(&config, &core).unwrap_or_else(|error| panic!("{error}"));
            for module in design.files() {
                assert!(core.design.files().contains(module), "the core has another {}", module.0);
            }
            let [input, out] = ["in", "out"].map(|name| {
                let stream = design.streams().iter().find(|stream| stream.name == name);
                recording.transfers(stream.expect("setup has the stream"))
            });
            assert!((500..input).contains(&out), "{out} of {input}");
        }
    }
}
