//! Setup alone, recorded at the ports of its golden model: most of what it computes moves limits that few samples are near, and
//! does not show at the ports of the core.

use super::generate::SplatCore;
use crate::generated::GenerateError;
use crate::recording::{Recorder, Recording};
use crate::stimuli::frames::{Frame, Lens, around, frames};
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

/// Frames whose splats lie all around what the camera sees.
const FRAMES: u64 = 12;
const SPLATS: u32 = 160;
/// Frames of anything, odd numbers among it, each of so many splats at most.
const ODD_FRAMES: usize = 48;
const ODD_SPLATS: u32 = 16;
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
    let seen = |frame: Frame| {
        let uniforms: Uniforms = read(config, &frame.uniforms);
        let Uniforms { model_view, near_plane, .. } = uniforms;
        let camera = TransformUniforms { model_view, near_plane };
        let left = |splat: &Splat| transform.transform(splat, &camera);
        (uniforms, frame.records.iter().filter_map(left).collect())
    };
    around.chain(odd).map(seen).collect()
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
