//! The hardware shrinks with the scene, and what is left renders the same bits.

use std::path::Path;

use pointcore::area::count;
use pointcore::cost::{Costs, Cycles, table_row};
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use pointcore::splat::{EncodedFrame, SplatCore, SplatOutcome, SplatRunner, assemble};
use pointcore_contract::splat::records::{Attributes, Fragment};
use pointcore_contract::splat::{Config, Feature};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::{BuildOptions, Builder, VerilogSource};

/// Both cores do the same work at the same rate. Their pipelines differ in length, so that copies meet others in the heap and the
/// tiles come and go in another order.
const TIMING_MARGIN: f64 = 0.01;

fn planned(name: &str, settings: &[String]) -> (Scene, Plan) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name).with_extension("toml");
    let scene = Scene::load(&path, settings).unwrap_or_else(|error| panic!("{error}"));
    let plan = Plan::of(&scene).unwrap_or_else(|error| panic!("{error}"));
    (scene, plan)
}

fn generate(plan: &Plan) -> SplatCore {
    SplatCore::generate(&plan.config).unwrap_or_else(|error| panic!("{error}"))
}

fn render(scene: &Scene, plan: &Plan, core: &SplatCore) -> SplatOutcome {
    let (config, frame) = (&plan.config, &EncodedFrame::new(scene, plan));
    SplatRunner::new(config, frame).golden(core).unwrap_or_else(|error| panic!("{error}"))
}

fn instances(core: &SplatCore) -> u64 {
    core.design.modules().iter().map(|module| module.instances).sum()
}

#[test]
fn hardware_shrinks_with_the_scene() {
    let (plane, small) = planned("plane", &[]);
    let (_, large) = planned("shapes", &[]);
    let features = |config: &Config| [config.culling, config.screen_filter];
    assert_eq!((features(&small.config), small.config.cardinal), ([Feature::Off; 2], 0));
    assert_eq!((features(&large.config), large.config.cardinal), ([Feature::On; 2], 1));
    assert!(small.config.continuous <= 3 && large.config.continuous == CONTINUOUS_ATTRIBUTES as u32);

    let cores = [&small, &large].map(generate);
    assert!(instances(&cores[0]) < instances(&cores[1]));
    for (figure, small, large) in count::rows(&cores[0].design, &cores[1].design) {
        assert!(small < large, "{figure}: {small} for the plane, {large} for the shapes");
    }

    let everything = small.with_everything();
    let large_core = generate(&everything);
    let [with_little, with_all] =
        [(&small, &cores[0]), (&everything, &large_core)].map(|(plan, core)| render(&plane, plan, core));
    let relative = with_little.counters.cycles as f64 / with_all.counters.cycles as f64;
    assert!(relative < 1.0 + TIMING_MARGIN, "what is left out costs time: {relative} of the cycles");

    assert!(agree(&small, &with_little, &with_all) > 5000);
}

/// Asserts that the small hardware renders what that with everything in does, bit for bit: column, row, depth, and the attributes that it
/// carries. Returns the number of fragments.
fn agree(small: &Plan, of_little: &SplatOutcome, of_all: &SplatOutcome) -> usize {
    let (continuous, cardinal) = (small.attributes.len(), small.config.cardinal as usize);
    let carried = |fragment: &Fragment| {
        let mut attributes = Attributes::default();
        attributes.iter_mut().zip(&small.attributes).for_each(|(to, &from)| *to = fragment.attributes[from]);
        let cardinals = &fragment.attributes[CONTINUOUS_ATTRIBUTES..][..cardinal];
        attributes[continuous..][..cardinal].copy_from_slice(cardinals);
        Fragment { attributes, ..*fragment }
    };
    let sorted = |fragments: &mut dyn Iterator<Item = Fragment>| {
        let mut fragments: Vec<_> = fragments.collect();
        fragments.sort_unstable_by_key(|fragment| (fragment.row, fragment.column));
        fragments
    };
    // Which tile leaves first hangs on the hardware.
    let common = sorted(&mut of_all.fragments.iter().map(carried));
    assert!(sorted(&mut of_little.fragments.iter().copied()) == common, "the small hardware renders other bits");
    common.len()
}

/// A scan in the place of the one that scenes/igea.toml names: as many points as are quick, of a sphere of its size.
fn small_scan(folder: &Path) -> String {
    const POINTS: usize = 600;
    const RADIUS: f64 = 0.05;
    let mut text = format!("ply\nformat ascii 1.0\nelement vertex {POINTS}\n");
    for name in ["x", "y", "z", "nx", "ny", "nz"] {
        text += &format!("property float {name}\n");
    }
    text += "end_header\n";
    for index in 0..POINTS {
        // Along a spiral from pole to pole.
        let height = (2 * index + 1) as f64 / POINTS as f64 - 1.0;
        let (across, angle) = ((1.0 - height * height).sqrt(), 2.4 * index as f64);
        let normal = [across * angle.cos(), across * angle.sin(), height];
        let point = normal.map(|component| RADIUS * component);
        let line: Vec<String> = point.iter().chain(&normal).map(f64::to_string).collect();
        text += &(line.join(" ") + "\n");
    }
    let path = folder.join("scan.ply");
    std::fs::write(&path, text).expect("a temporary folder can be written");
    format!("object.0.path={}", path.display())
}

/// Every shipped scene with the settings that make it small.
fn shipped(folder: &Path) -> [(&'static str, Vec<String>); 7] {
    let image = ["image.width=64", "image.height=48"].map(str::to_owned).to_vec();
    let with = |more: &[&str]| image.iter().cloned().chain(more.iter().map(|&text| text.to_owned())).collect();
    [
        ("knot", with(&["object.0.points=1200"])),
        ("shapes", with(&["object.0.points=500", "object.1.points=400", "object.2.points=400"])),
        ("minified", with(&["object.0.points=1000"])),
        ("plane", with(&["object.0.points=200"])),
        ("igea", with(&[&small_scan(folder)])),
        ("inside", with(&["object.0.points=2000"])),
        ("dense", with(&["object.0.points=1200", "object.0.radius_scale=2"])),
    ]
}

#[test]
fn planned_hardware_renders_shipped_scenes_bit_for_bit() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    for (name, settings) in shipped(folder.path()) {
        let (scene, plan) = planned(name, &settings);
        let everything = plan.with_everything();
        assert_ne!(plan.config, everything.config, "{name}: nothing is left out");
        let [little, all] = [&plan, &everything].map(|plan| render(&scene, plan, &generate(plan)));
        let count = agree(&plan, &little, &all);
        assert!(count > 200, "{name}: {count} fragments");
    }
}

/// But for the scan, which is not shipped, and for LUT4 and cycles, of which the one is a fit and the other takes long.
#[test]
fn results_say_what_shipped_scenes_call_for() {
    let cells = |row: &str| -> Vec<String> { row.split('|').map(|cell| cell.trim().to_owned()).collect() };
    let rows: Vec<_> = include_str!("../../docs/results.md").lines().map(cells).collect();
    for name in ["dense", "inside", "knot", "minified", "plane", "shapes"] {
        let (scene, plan) = planned(name, &[]);
        let costs = Costs::whole(&scene, &plan, Cycles::Untold, None).unwrap_or_else(|error| panic!("{error}"));
        let expected = cells(&table_row(name, &plan, &costs));
        let agrees = |row: &Vec<String>| {
            row.len() == expected.len() && row.iter().zip(&expected).all(|(said, right)| right == "?" || said == right)
        };
        assert!(rows.iter().any(agrees), "`pointcore plan --table` says {expected:?}");
    }
}

#[test]
fn planned_hardware_agrees_with_its_model() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let [_, _, _, (name, settings), ..] = shipped(folder.path());
    let (scene, plan) = planned(name, &settings);
    assert_eq!([plan.config.culling, plan.config.screen_filter, plan.config.eye_plane], [Feature::Off; 3]);
    let core = generate(&plan);
    let (config, frame) = (&plan.config, &EncodedFrame::new(&scene, &plan));
    let runner = SplatRunner { stall: Stall::Random(0.2), ..SplatRunner::new(config, frame) };
    let library = {
        let builder = Builder::new().unwrap_or_else(|error| panic!("{error}"));
        let source = VerilogSource::from(&core.design);
        builder.build(&source, BuildOptions::default()).unwrap_or_else(|error| panic!("{error}"))
    };
    let outcome = runner.lockstep(&core, &library).unwrap_or_else(|error| panic!("{error}"));
    let everything = plan.with_everything();
    let all = render(&scene, &everything, &generate(&everything));
    assert!(agree(&plan, &outcome, &all) > 200);
}

#[test]
fn given_hardware_renders_what_planned_hardware_does() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let [_, (name, settings), ..] = shipped(folder.path());
    let (scene, plan) = planned(name, &settings);
    // Larger in every respect.
    let config = Config { width: 80, height: 64, continuous: 9, cardinal: 2, heap_levels: 6, ..Config::default() };
    let given = Plan::on(&scene, &config).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(given.config, config);
    let [ours, theirs] = [&plan, &given].map(|plan| assemble(plan, &render(&scene, plan, &generate(plan)).fragments));
    assert_eq!((theirs.width, theirs.height), (64, 48));
    assert!(ours.pixels.iter().flatten().count() > 200 && ours.pixels == theirs.pixels);
}
