//! The hardware shrinks with the scene, and what is left renders the same bits.

use std::path::Path;

use pointcore::core_a::{Core, EncodedFrame, Outcome, Runner, area};
use pointcore::lockstep::Stall;
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use pointcore_spec::core_a::{Config, Feature, records};
use pointcore_spec::splat::CONTINUOUS_ATTRIBUTES;

/// Both cores do the same work at the same rate. Their pipelines differ in length, so that copies meet others in the heap and the
/// tiles come and go in another order.
const TIMING_MARGIN: f64 = 0.01;

fn planned(name: &str) -> (Scene, Plan) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name).with_extension("toml");
    let scene = Scene::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
    let plan = Plan::of(&scene).unwrap_or_else(|error| panic!("{error}"));
    (scene, plan)
}

fn generate(plan: &Plan) -> Core {
    Core::generate(&plan.config).unwrap_or_else(|error| panic!("{error}"))
}

fn render(scene: &Scene, plan: &Plan, core: &Core) -> Outcome {
    let (config, frame) = (&plan.config, &EncodedFrame::new(scene, plan));
    let runner = Runner { config, frame, stall: Stall::Never, seed: 1, progress: &|_, _| {}, stop_after: None };
    runner.golden(core).unwrap_or_else(|error| panic!("{error}"))
}

fn instances(core: &Core) -> usize {
    core.design.modules().iter().map(|module| module.instances).sum()
}

#[test]
fn hardware_shrinks_with_the_scene() {
    let (plane, small) = planned("plane");
    let (_, large) = planned("shapes");
    let features = |config: &Config| [config.culling, config.screen_filter];
    assert_eq!((features(&small.config), small.config.cardinal), ([Feature::Off; 2], 0));
    assert_eq!((features(&large.config), large.config.cardinal), ([Feature::On; 2], 1));
    assert!(small.config.continuous <= 3 && large.config.continuous == CONTINUOUS_ATTRIBUTES as u32);

    let cores = [&small, &large].map(generate);
    assert!(instances(&cores[0]) < instances(&cores[1]));
    for (figure, small, large) in area::rows(&cores[0].design, &cores[1].design) {
        assert!(small < large, "{figure}: {small} for the plane, {large} for the shapes");
    }

    let everything = small.with_everything();
    let large_core = generate(&everything);
    let [with_little, with_all] =
        [(&small, &cores[0]), (&everything, &large_core)].map(|(plan, core)| render(&plane, plan, core));
    let relative = with_little.counters.cycles as f64 / with_all.counters.cycles as f64;
    assert!(relative < 1.0 + TIMING_MARGIN, "what is left out costs time: {relative} of the cycles");

    let words = |plan: &Plan| records::fragment(&plan.config).len() - 1;
    let fragments = |plan, outcome: &Outcome| -> Vec<Vec<u64>> {
        outcome.fragments.chunks_exact(words(plan)).map(<[_]>::to_vec).collect()
    };
    // Column, row and depth, then the attributes that the small hardware carries.
    let carried: Vec<usize> = (0..3).chain(small.attributes.iter().map(|index| 3 + index)).collect();
    let of_all = fragments(&everything, &with_all);
    let common: Vec<Vec<u64>> =
        of_all.iter().map(|fragment| carried.iter().map(|&index| fragment[index]).collect()).collect();
    assert!(common.len() > 5000, "{} fragments", common.len());
    assert!(fragments(&small, &with_little) == common, "the small hardware renders other bits");
}
