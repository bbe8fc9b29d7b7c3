//! The `pointcore` command as a user meets it: exit codes, messages, and files that the usual tools accept.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A scene whose hardware is small.
const SCENE: &str = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = 1, far = 10 }\n\
                     image = { width = 64, height = 48 }\n\
                     [[object]]\nkind = \"sphere\"\npoints = 500\nouter_radius = 1\n";

const SUCCESS: i32 = 0;
pub const WRONG_INPUT: i32 = 2;

/// Where a test writes.
pub struct Workplace(TempDir);

impl Workplace {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("the system has a temporary folder"))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn write(&self, name: &str, contents: &str) -> PathBuf {
        let path = self.path().join(name);
        fs::write(&path, contents).expect("a temporary folder can be written");
        path
    }

    pub fn pointcore(&self, arguments: &[&str]) -> Output {
        let output = Command::new(env!("CARGO_BIN_EXE_pointcore")).args(arguments).current_dir(self.path()).output();
        output.expect("cargo has built the binary")
    }

    /// Runs `pointcore`, which must succeed without a word on the error stream; returns what it prints.
    pub fn succeeds(&self, arguments: &[&str]) -> String {
        let output = self.pointcore(arguments);
        let [out, error] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
        assert_eq!((output.status.code(), error.as_str()), (Some(SUCCESS), ""), "pointcore {arguments:?}");
        out
    }

    /// Runs `pointcore`, which must say each of `parts` on the error stream, once, and nothing else.
    pub fn fails(&self, code: i32, arguments: &[&str], parts: &[&str]) {
        let output = self.pointcore(arguments);
        let [out, error] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
        assert_eq!((output.status.code(), out.as_str()), (Some(code), ""), "pointcore {arguments:?}: {error}");
        assert_eq!(error.matches("error: ").count(), 1, "{error}");
        assert!(!error.contains("panicked"), "{error}");
        for part in parts {
            assert!(error.contains(part), "`{part}` is missing in: {error}");
        }
    }

    /// Runs `pointcore`, which must refuse its input, in words that hold `parts` after what it has to say on the way.
    pub fn fails_with_notes(&self, arguments: &[&str], parts: &[&str]) {
        let output = self.pointcore(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(WRONG_INPUT), "pointcore {arguments:?}: {error}");
        let last = error.lines().last().unwrap_or_default();
        assert!(last.starts_with("error: ") && parts.iter().all(|part| last.contains(part)), "{error}");
    }

    /// Runs a tool in a folder, which must accept its input without a warning.
    pub fn accepts(&self, program: &str, arguments: &[&str], folder: &str) {
        let output = Command::new(program).args(arguments).current_dir(self.path().join(folder)).output();
        let output = output.unwrap_or_else(|error| panic!("cannot run {program} ({error}): run `make setup-tests`"));
        let text = [&output.stdout[..], &output.stderr[..]].map(String::from_utf8_lossy).concat();
        let clean = output.status.success() && !text.contains("%Warning") && !text.to_lowercase().contains("warning:");
        assert!(clean, "{program} {arguments:?} says\n{text}");
    }
}

pub fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error} in: {text}"))
}

#[test]
fn help_names_every_subcommand_and_the_exit_codes() {
    let workplace = Workplace::new();
    let help = workplace.succeeds(&["--help"]);
    for part in ["plan", "gen", "run", "knn", "vectors", "inspect", "bench", "area", "scenes/knot.toml", "Exit codes"] {
        assert!(help.contains(part), "`{part}` is missing in: {help}");
    }
    for command in ["plan", "gen", "run", "knn", "vectors", "inspect", "bench", "area"] {
        assert!(workplace.succeeds(&[command, "--help"]).contains("Usage: pointcore"), "{command}");
    }
}

#[test]
fn wrong_input_is_one_message_and_exit_code_2() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    workplace.write("misspelt.toml", &SCENE.replace("points", "pionts"));
    workplace.write("overridden.toml", &format!("{SCENE}[overrides]\nwidth = 32\n"));
    workplace.write("unculled.toml", &format!("{SCENE}[overrides]\nculling = \"off\"\n"));
    workplace.write("config.toml", "kind = \"splat\"\nimplementation.tile_slots = 1\n");
    workplace.write("kindless.toml", "width = 64\n");
    workplace.write("unknown.toml", "kind = \"splat\"\nimage.widht = 64\n");
    workplace.write("empty.toml", "");
    workplace.write("empty.ply", "");
    let header = "ply\nformat ascii 1.0\nelement vertex 1000000000000000000\nproperty float x\nproperty float y\n\
                  property float z\nend_header\n";
    workplace.write("absurd.ply", &format!("{header}0 0 0\n"));
    workplace.write("unculled_config.toml", "kind = \"splat\"\nfeatures.culling = \"off\"\n");
    workplace.write("knn.toml", "kind = \"search\"\n");
    workplace.write("nan.obj", "v 0 0 0\nv 0 nan 0\nv 0 1 0\n");
    for (arguments, parts) in [
        (&["plan", "gone.toml"][..], ["gone.toml", "cannot be read"]),
        (&["plan", "."], [".", "cannot be read"]),
        (&["plan", "empty.toml"], ["empty.toml", "camera"]),
        (&["plan", "misspelt.toml"], ["misspelt.toml", "line 5"]),
        (&["plan", "overridden.toml"], ["overridden.toml: `overrides.width`", "`image.width`"]),
        (&["run", "unculled.toml"], ["unculled.toml: `overrides.culling`", "face away"]),
        (&["run", "scene.toml", "--stalls", "1"], ["'1' for '--stalls", "expected"]),
        (&["run", "scene.toml", "--model", "golden", "--trace"], ["--trace", "--model rtl"]),
        (&["run", "scene.toml", "--set", "object.0.points"], ["object.0.points", "key=value"]),
        (
            &["run", "scene.toml", "--config", "unculled_config.toml"],
            ["scene.toml on unculled_config.toml", "`culling` = \"off\""],
        ),
        (&["run", "scene.toml", "--config", "knn.toml"], ["knn.toml", "the renderer"]),
        (&["plan", "scene.toml", "scene.toml"], ["several scenes", "--table"]),
        (&["gen", "gone.toml", "-o", "out"], ["gone.toml", "cannot be read"]),
        (&["gen", "config.toml", "-o", "out"], ["config.toml: `tile_slots` = 1", "2 to 64"]),
        (&["gen", "unknown.toml", "-o", "out"], ["unknown.toml: line 2: `widht`", "`width`"]),
        (&["gen", "kindless.toml", "-o", "out"], ["kindless.toml: the line `kind = \"splat\"`", "is missing"]),
        (&["gen", "misspelt.toml", "-o", "out"], ["misspelt.toml", "line 5"]),
        (&["gen", "config.toml", "-o", "out", "--set", "width=9"], ["--set", "configuration file"]),
        (&["area", "f32_sub"], ["unknown unit `f32_sub`", "splat_heap"]),
        (&["area", "gone.toml"], ["gone.toml", "cannot be read"]),
        (&["area", "config.toml"], ["config.toml: `tile_slots` = 1", "2 to 64"]),
        (&["inspect", "gone.ply"], ["gone.ply", "cannot be read"]),
        (&["inspect", "empty.ply"], ["empty.ply", "not a PLY header"]),
        (&["inspect", "absurd.ply"], ["absurd.ply", "1000000000000000000"]),
        (&["inspect", "scene.toml"], ["scene.toml", ".ply, .obj"]),
        (&["run", "gone.las"], ["gone.las", "cannot be read"]),
        (&["run", "nan.obj", "--set", "object.0.drop_invalid=false"], ["nan.obj", "vertex 1"]),
        (&["run", "scene.toml", "--model", "reference", "--depth"], ["--depth", "--model rtl"]),
    ] {
        workplace.fails(WRONG_INPUT, arguments, &parts);
    }
    assert!(!workplace.path().join("out").exists(), "nothing is written on wrong input");
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    workplace.write("config.toml", "kind = \"splat\"\n");
    workplace.write("file", "");
    workplace.fails(WRONG_INPUT, &["gen", "config.toml", "-o", "file"], &["file", "cannot be written"]);
    let reference = ["run", "scene.toml", "--model", "reference", "-o", "file/out"];
    workplace.fails(WRONG_INPUT, &reference, &["file/out", "cannot be written"]);
}

#[test]
fn plan_keeps_a_budget() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    let plan = json(&workplace.succeeds(&["plan", "scene.toml", "--json", "--device", "85F"]));
    let tried = plan["tried"].as_array().expect("a list");
    let chosen = tried.last().expect("something was tried");
    assert_eq!(chosen["shortages"], Value::Array(vec![]));
    assert!(chosen["needs"]["lut4"].as_f64().is_some_and(|luts| luts < 83_640.0), "{chosen}");
    assert_eq!(chosen["rasterizers"], plan["config"]["implementation"]["rasterizers"]);
    assert!(tried.len() > 1, "eight rasterizers do not fit: {tried:?}");
    let text = workplace.succeeds(&["plan", "scene.toml", "--device", "85F"]);
    assert!(text.contains("chosen") && text.contains("too many look-up tables"), "{text}");
    workplace.fails(
        WRONG_INPUT,
        &["gen", "scene.toml", "--luts", "5", "-o", "out"],
        &["scene.toml", "fits 5 look-up tables", "allow more"],
    );
    workplace.fails(WRONG_INPUT, &["plan", "scene.toml", "--device", "85G"], &["85G", "LFE5U-85F"]);
    workplace.write("config.toml", "kind = \"splat\"\n");
    workplace.fails(WRONG_INPUT, &["gen", "config.toml", "--luts", "90000", "-o", "out"], &["--luts", "for scenes"]);
}

#[test]
fn plan_explains_its_choices() {
    let workplace = Workplace::new();
    workplace.write(
        "scene.toml",
        &format!("{SCENE}[splatting]\nfilter_radius_px = 0\n[overrides]\nheap_levels = 7\nsetup_interval = 4\n"),
    );
    let text = workplace.succeeds(&["plan", "scene.toml"]);
    for part in [
        "500 splats",
        "back-face culling",
        "generated",
        "screen filter",
        "left out",
        "heap_levels = 7",
        "eye plane",
        "what it costs",
    ] {
        assert!(text.contains(part), "`{part}` is missing in: {text}");
    }
    let plan = json(&workplace.succeeds(&["plan", "scene.toml", "--json", "--set", "object.0.points=300"]));
    assert_eq!(
        (&plan["splats"], &plan["config"]["implementation"]["heap_levels"]),
        (&Value::from(300), &Value::from(7))
    );
    assert_eq!(
        (&plan["config"]["features"]["culling"], &plan["config"]["features"]["screen_filter"]),
        (&Value::from("on"), &Value::from("off"))
    );
    let effects = plan["effects"].as_array().expect("a list");
    let figure = |effect: &str, side: &str, figure: &str| {
        let found = effects.iter().find(|entry| entry["effect"] == effect);
        found.and_then(|entry| entry[side][figure].as_i64()).unwrap_or_else(|| panic!("{effect} has no {side}"))
    };
    assert!(figure("culling", "cost", "register_bits") > 0 && figure("culling", "saved", "register_bits") == 0);
    assert!(figure("eye_plane", "saved", "register_bits") > 0 && figure("eye_plane", "cost", "register_bits") == 0);
}

#[test]
fn inspect_measures_a_model() {
    let workplace = Workplace::new();
    workplace.write("square.obj", "v 0 0 1\nv 3 0 1\nv 3 4 1\nv 0 4 1\nf 1 2 3 4\n");
    assert!(workplace.succeeds(&["inspect", "square.obj"]).contains("[0, 0, 1] to [3, 4, 1]"));
    let inspection = json(&workplace.succeeds(&["--json", "inspect", "square.obj"]));
    workplace.write("scan.obj", "v 0 0 0\nv nan 0 0\nv 0 0 0\n");
    let scan = json(&workplace.succeeds(&["--json", "inspect", "scan.obj"]));
    assert_eq!(
        (&scan["points"], &scan["invalid"], &scan["repeated"]),
        (&Value::from(2), &Value::from(1), &Value::from(1))
    );
    assert_eq!(scan["spacing"], Value::Null, "in one place");
    assert_eq!((&inspection["points"], &inspection["spacing"]["mean"]), (&Value::from(4), &Value::from(4.0)));
}

#[test]
fn generated_verilog_is_the_same_every_time_and_accepted_by_every_tool() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    let files = json(&workplace.succeeds(&["gen", "scene.toml", "-o", "first", "--json"]));
    assert_eq!(files["top"], "splat_top");
    // What a scene's hardware was generated from is a configuration that generates it again.
    let config = fs::read_to_string(workplace.path().join("first/config.toml")).expect("it was written");
    workplace.write("scene.toml", &config);
    workplace.succeeds(&["gen", "scene.toml", "-o", "second", "--rust-hdl"]);
    let block = fs::read_to_string(workplace.path().join("second/splat_top.rs")).expect("it was asked for");
    assert!(block.contains("pub struct SplatTop {") && block.contains("include_str!(\"splat_top.v\")"), "{block}");
    let names = files["files"].as_array().expect("a list of files");
    assert!(!names.is_empty());
    for name in names {
        let first = workplace.path().join(name.as_str().expect("file names are strings"));
        let file = first.file_name().expect("files have names");
        let [first, second] = [first.clone(), workplace.path().join("second").join(file)]
            .map(|path| fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display())));
        assert!(first == second, "{name} differs from one run to the next");
    }
    workplace.accepts("verilator", &["--lint-only", "-Wall", "splat_top.v"], "first");
    workplace.accepts("iverilog", &["-t", "null", "-Wall", "splat_top.v"], "first");
    let script = "read_verilog splat_top.v; hierarchy -check -top splat_top; proc; check -assert";
    workplace.accepts("yosys", &["-q", "-p", script], "first");
    accepts_bus(&workplace, "splat", "first");
}

/// The AXI top and its core are one design, and compilers take the header and agree with its sizes.
pub fn accepts_bus(workplace: &Workplace, core: &str, folder: &str) {
    let [axi, core] = [format!("{core}_axi"), format!("{core}_top.v")];
    let file = format!("{axi}.v");
    workplace.accepts("verilator", &["--lint-only", "-Wall", "--top-module", &axi, &file, &core], folder);
    workplace.accepts(
        "gcc",
        &["-std=c11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-xc", "registers.h"],
        folder,
    );
    workplace.accepts("g++", &["-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-xc++", "registers.h"], folder);
    let registers = fs::read_to_string(workplace.path().join(folder).join("registers.md")).expect("gen writes it");
    assert!(registers.contains("| 0x004 | `control` | W |"), "{registers}");
}

#[test]
fn a_model_alone_is_rendered_with_its_depths_and_normals_and_from_all_sides() {
    let workplace = Workplace::new();
    let points: String = (0..900).map(|i| format!("{} {} 100\n", 500_000 + i % 30, 5_000_000 + i / 30)).collect();
    workplace.write("field.xyz", &points);
    let small = ["--set", "image.width=64", "--set", "image.height=48", "--model", "golden"];
    let run = |more: &[&'static str]| [&["run", "field.xyz", "--json"], &small[..], more].concat();
    let report = json(&workplace.succeeds(&run(&["--depth", "--normals"])));
    assert_eq!((&report["splats"], &report["fates"]["drawn"]), (&Value::from(900), &Value::from(900)));
    assert!(report["fragments"].as_u64().is_some_and(|fragments| fragments > 400), "{report}");
    for (file, bytes) in [("depth.pfm", 64 * 48 * 4), ("normals.pfm", 64 * 48 * 12)] {
        let size = fs::metadata(workplace.path().join("out/field").join(file)).expect("it was asked for").len();
        assert_eq!(size, bytes + "PF\n64 48\n-1.0\n".len() as u64, "{file}");
    }
    let turn = json(&workplace.succeeds(&run(&["--turntable", "3", "-o", "turn"])));
    assert_eq!(turn["sequence"].as_array().map(Vec::len), Some(3));
    for file in ["frames/0000.png", "frames/0002.png", "animation.png", "frame.png", "report.md"] {
        assert!(workplace.path().join("turn").join(file).is_file(), "{file} is missing");
    }
}

#[test]
fn a_blank_picture_is_no_success() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", &SCENE.replace("target = [0, 0, 0]", "target = [0, 0, 9]"));
    let output = workplace.pointcore(&["run", "scene.toml", "--model", "golden", "--json"]);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(WRONG_INPUT), "{error}");
    for part in ["nothing is drawn of its 500 splats", "500 before the near plane or behind the eye", "camera.fit"] {
        assert!(error.contains(part), "`{part}` is missing in: {error}");
    }
    let report = json(&String::from_utf8_lossy(&output.stdout));
    assert_eq!((&report["psnr_db"], &report["fates"]["near"]), (&Value::Null, &Value::from(500)));
    let report = fs::read_to_string(workplace.path().join("out/scene/report.md")).expect("it was written");
    assert!(report.contains("nothing to compare"), "{report}");
}

#[test]
fn the_models_render_a_scene_and_leave_a_report() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    let reference = json(&workplace.succeeds(&["run", "scene.toml", "--model", "reference", "--json"]));
    assert_eq!(reference["reference"], "out/scene/reference.png");
    let golden = ["run", "scene.toml", "--model", "golden", "--json", "-o", "golden"];
    let report = json(&workplace.succeeds(&golden));
    assert_eq!(report["splats"], 500);
    assert_eq!(report["mismatches"], Value::Null, "nothing was compared");
    for file in ["frame.png", "reference.png", "difference.png", "report.md", "report.json", "verilog/splat_top.v"] {
        assert!(workplace.path().join("golden").join(file).is_file(), "{file} is missing");
    }
}

/// A sphere that moves before a floor that does not.
fn moving_scene() -> String {
    let floor =
        "[[object]]\nkind = \"plane\"\npoints = 196\nsize = 2\ntranslate = [0, -1, -1]\nrotate_degrees = [30, 0, 0]\n";
    format!("{SCENE}motion = {{ velocity = [1, 0, 0] }}\n{floor}[shutter]\nopen = 0\nclose = 1\n")
}

#[test]
fn a_moving_scene_is_rendered_on_two_cores() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", &moving_scene());
    let run = ["run", "scene.toml", "--model", "golden", "--json"];
    let report = json(&workplace.succeeds(&run));
    assert_eq!((&report["time_bins"], &report["still"]["splats"]), (&Value::from(8), &Value::from(196)));
    for (report, psnr_db) in [(&report, 40.0), (&report["still"], 50.0)] {
        assert!(report["psnr_db"].as_f64().is_some_and(|found| found > psnr_db), "{report}");
    }
    let files = [
        "frame.png",
        "reference.png",
        "difference.png",
        "index.html",
        "verilog/splat_top.v",
        "verilog/still/splat_top.v",
    ];
    for file in files {
        assert!(workplace.path().join("out/scene").join(file).is_file(), "{file} is missing");
    }
    let text = workplace.succeeds(&["plan", "scene.toml", "--set", "splatting.motion=bins:2"]);
    for part in
        ["what moves while the shutter is open", "`splatting.motion` is \"bins:2\"", "what stands still, 196 splats"]
    {
        assert!(text.contains(part), "`{part}` is missing in: {text}");
    }
    workplace.succeeds(&["gen", "scene.toml", "-o", "cores"]);
    for (folder, bins) in [("cores", "time_bins = 8"), ("cores/still", "time_bins = 0")] {
        let config = fs::read_to_string(workplace.path().join(folder).join("config.toml")).expect("it was written");
        assert!(config.contains(bins), "{config}");
    }
    // On hardware for a larger image, as it is.
    workplace.write(
        "larger.toml",
        "kind = \"splat\"\n[image]\nwidth = 128\nheight = 128\n[features]\ntime_bins = 8\nmerge = \"on\"\nkernel_index_bits = 10\nscreen_filter = \"off\"\n",
    );
    let given = json(&workplace.succeeds(&[&run[..], &["--config", "larger.toml", "-o", "given"]].concat()));
    assert_eq!((&given["fragments"], &given["psnr_db"]), (&report["fragments"], &report["psnr_db"]));
}

#[test]
fn motion_that_no_hardware_has_is_refused() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", &moving_scene());
    workplace.write("still.toml", "kind = \"splat\"\n");
    workplace.write(
        "small.toml",
        "kind = \"splat\"\n[image]\nwidth = 32\nheight = 64\n[features]\ntime_bins = 2\nscreen_filter = \"off\"\n",
    );
    workplace.write(
        "apart.toml",
        "kind = \"splat\"\n[image]\nwidth = 64\nheight = 64\n[features]\ntime_bins = 8\nscreen_filter = \"off\"\n",
    );
    let cases: [(&[&str], &[&str]); 8] = [
        (
            &["run", "--set", "splatting.motion=exact"],
            &["`splatting.motion` = \"exact\"", "bins:8", "--model reference"],
        ),
        (&["plan", "--set", "splatting.motion=gpu:2"], &["`splatting.motion` = \"gpu:2\"", "bins:8"]),
        (&["gen", "-o", "cores", "--set", "splatting.motion=bins:3"], &["\"bins:3\"", "1, 2, 4, … up to 8"]),
        (
            &["run", "--set", "overrides.time_bins=8"],
            &["`overrides.time_bins` follows from the scene", "splatting.motion"],
        ),
        (&["run", "--config", "still.toml"], &["motion blur", "`time_bins` = 0", "set `time_bins = 8`"]),
        (&["run", "--config", "small.toml"], &["`width` = 32", "set `width = 64`"]),
        (&["run", "--config", "apart.toml"], &["depths in memory", "`merge` = \"off\"", "set `merge = \"on\"`"]),
        (&["run", "--normals"], &["--normals", "several surfaces"]),
    ];
    for (arguments, parts) in cases {
        let arguments = [&arguments[..1], &["scene.toml"], &arguments[1..]].concat();
        workplace.fails(WRONG_INPUT, &arguments, parts);
    }
    workplace.fails(
        WRONG_INPUT,
        &["plan", "scene.toml", "--luts", "50000"],
        &["moves while the shutter is open", "no budget"],
    );
}

#[test]
fn a_moving_scene_is_rendered_in_f64() {
    let workplace = Workplace::new();
    let moving = format!("{SCENE}motion = {{ velocity = [1, 0, 0] }}\n[shutter]\nopen = 0\nclose = 1\n");
    workplace.write("scene.toml", &moving);
    let run = |arguments: &[&str]| {
        json(&workplace.succeeds(&[&["run", "scene.toml", "--model", "reference", "--json"], arguments].concat()))
    };
    let exact = run(&[]);
    assert_eq!((&exact["motion"]["method"], &exact["motion"]["splats"]), (&Value::from("exact"), &Value::from(500)));
    assert!(workplace.path().join("out/scene/reference.png").is_file());
    let bins = run(&["--set", "splatting.motion=bins:4", "-o", "bins"]);
    assert_eq!(bins["motion"]["method"], "bins:4");
    let truth = run(&["--samples-in-time", "32"]);
    assert_eq!(truth["motion"]["method"], "32 samples in time");
    let coverage = |report: &Value| report["motion"]["coverage"].as_f64().expect("a share");
    for report in [&exact, &bins] {
        assert!((coverage(report) - coverage(&truth)).abs() < 0.01, "{report} beside {truth}");
    }
}
