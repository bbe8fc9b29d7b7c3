//! `pointcore accuracy` as a user meets it: a sweep in parts, put together, and the scene it recommends.

use crate::command::{WRONG_INPUT, Workplace, json};
use pointcore_tb::skipped::skipped;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// A scene with a texture and an outline, whose frames take no time.
const SCENE: &str = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 30, near = 1, far = 10 }\n\
                     image = { width = 32, height = 24, background = [0.9, 0.9, 0.9] }\n\
                     [[object]]\nkind = \"sphere\"\npoints = 400\nouter_radius = 1\nchecks = [4, 8]\nchecker_color = [0.1, 0.2, 0.6]\n";

/// Runs `pointcore accuracy` on the scene with a few points; `folder` keeps them.
fn sweep(workplace: &Workplace, folder: &str, arguments: &[&str]) -> Output {
    let knobs = ["--vary", "samples=1,4", "--vary", "geometry=bf16-ftz", "--vary", "sharing=16"];
    let output =
        workplace.pointcore(&[&["accuracy", "scene.toml", "--points", folder], &knobs[..], arguments].concat());
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && !error.contains("left out"), "{arguments:?}: {error}");
    output
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn a_sweep_in_parts_is_the_sweep_as_a_whole() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    let read =
        |path: &str| fs::read_to_string(workplace.path().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
    sweep(&workplace, "whole", &["--jobs", "2", "-o", "first"]);
    for shard in ["1/2", "2/2"] {
        let output = sweep(&workplace, "parts", &["--shard", shard]);
        assert!(text(&output.stdout).contains(" points are in parts."), "{}", text(&output.stdout));
    }
    let together = sweep(&workplace, "parts", &["-o", "second"]);
    assert_eq!(text(&together.stderr), "", "every point was kept");
    for file in ["README.md", "accuracy.json", "index.html"] {
        assert!(read(&format!("first/{file}")) == read(&format!("second/{file}")), "{file} differs");
    }

    let result = json(&read("first/accuracy.json"));
    let points = result["points"].as_array().expect("a list of points");
    // 1 sample is what the scene has: base, two of f64, 4 samples, bf16, sharing, and their combinations.
    assert_eq!(points.len(), 10, "{:?}", points.iter().map(|point| &point["name"]).collect::<Vec<_>>());
    let point = |name: &str| {
        let found = points.iter().find(|point| point["name"] == name);
        &found.unwrap_or_else(|| panic!("{name} is missing"))["figures"]
    };
    let psnr = |name: &str, kind: &str| point(name)[kind].as_f64().expect("a number");
    let cycles = |name: &str| point(name)["hardware"]["cycles"].as_u64().expect("cycles");
    assert!(
        psnr("samples 4", "psnr_db") > psnr("base", "psnr_db") + 10.0,
        "samples bring the picture nearer to the truth"
    );
    assert!(psnr("base", "rounding_psnr_db") > psnr("geometry bf16-ftz", "rounding_psnr_db") + 20.0, "bf16 rounds");
    assert_eq!(psnr("sharing 16", "rounding_psnr_db"), psnr("base", "rounding_psnr_db"), "sharing changes no bit");
    assert!(cycles("sharing 16") >= cycles("base") && cycles("samples 4") > 2 * cycles("base"));
    assert_eq!(point("f64")["hardware"], serde_json::Value::Null);
    let bench = json(&read("out/bench.json"));
    assert_eq!(bench["accuracy.scene.points"], 10);
    assert!(read("first/README.md").contains("| samples 4 | "));
}

#[test]
fn what_is_recommended_renders_as_it_was_measured() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    let output = sweep(&workplace, "points", &["--at-least", "45dB"]);
    let scene = text(&output.stdout);
    assert!(scene.contains("at least 45 dB") && scene.contains("samples = 4"), "{scene}");
    workplace.write("chosen.toml", &scene);
    let report = json(&workplace.succeeds(&["run", "chosen.toml", "--model", "golden", "--json", "-o", "chosen"]));
    let again = json(&text(&sweep(&workplace, "points", &["--at-least", "45dB", "--json"]).stdout));
    let name = &again["recommended"]["point"];
    let points = again["points"].as_array().expect("a list of points");
    let point = points.iter().find(|point| point["name"] == *name).expect("it is one of them");
    assert_eq!(report["cycles"], point["figures"]["hardware"]["cycles"]);
    assert_eq!(report["psnr_db"].as_f64(), point["figures"]["rounding_psnr_db"].as_f64());

    let best = ["accuracy", "scene.toml", "--points", "points", "--vary", "samples=1", "--at-least", "90dB"];
    let output = workplace.pointcore(&best);
    let error = text(&output.stderr);
    assert!(output.status.code() == Some(WRONG_INPUT) && error.contains("the most accurate is `base`"), "{error}");
}

#[test]
fn mistakes_are_explained() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    let fails = |arguments: &[&str], part: &str| {
        let output = workplace.pointcore(&[&["accuracy", "scene.toml", "--points", "points"], arguments].concat());
        let error = text(&output.stderr);
        assert!(output.status.code() == Some(WRONG_INPUT) && error.contains(part), "{arguments:?}: {error}");
    };
    fails(&["--vary", "speed=1"], "--vary `speed=1`: expected KNOB=VALUE");
    fails(&["--shard", "3/2"], "expected I/N with I from 1 to N");
    fails(&["--at-least", "much"], "expected a number of decibels");
    fails(&["--vary", "samples=1,99"], "--vary samples=1,99: `99` is no value here");
    fails(&["--vary", "samples=1,99"], "expected 1 to 8");
    fails(&["--vary", "geometry=f31"], "`f31` is no value here");
    fails(&["--tries", "3"], "--at-least");
}

/// In a real browser, where there is one.
#[test]
fn the_page_works_in_a_browser() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    sweep(&workplace, "points", &["-o", "page"]);
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scripts/check-page");
    let output = Command::new("python3").arg(script).arg(workplace.path().join("page/index.html")).output();
    let Ok(output) = output else {
        return skipped("python3 is missing");
    };
    if output.status.code() == Some(77) {
        return skipped(&text(&output.stderr));
    }
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
    assert!(text(&output.stdout).contains("shown on hovering"), "{}", text(&output.stdout));
}

#[test]
fn neighbor_search_is_swept_too() {
    let workplace = Workplace::new();
    let search = ["accuracy", "--neighbors", "surface:300", "--k", "6", "--queries", "640", "--points", "points"];
    let part = workplace.pointcore(&[&search[..], &["--shard", "1/9", "--json"]].concat());
    assert!(part.status.success(), "{}", text(&part.stderr));
    assert_eq!(json(&text(&part.stdout))["points"], 3);
    assert_eq!(text(&part.stderr).matches(" cycles a query").count(), 3, "{}", text(&part.stderr));
    for (arguments, problem) in [
        (&["--neighbors", "surface:0"][..], "expected a number from 1"),
        (&["--k", "6"], "--neighbors"),
        (&["--neighbors", "surface:300", "scene.toml"], "cannot be used with"),
        (&[], "required arguments"),
    ] {
        let output = workplace.pointcore(&[&["accuracy"], arguments].concat());
        let error = text(&output.stderr);
        assert!(output.status.code() == Some(WRONG_INPUT) && error.contains(problem), "{arguments:?}: {error}");
    }
}
