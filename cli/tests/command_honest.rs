//! What can go wrong around a command: closed pipes, full disks, interruptions, folders that cannot be written, leftovers.

use super::command::{WRONG_INPUT, Workplace, json};
use pointcore_tb::skipped::skipped;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

/// A scene whose hardware is small.
const SCENE: &str = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = 1, far = 10 }\n\
                     image = { width = 32, height = 24 }\n\
                     [[object]]\nkind = \"sphere\"\npoints = 200\nouter_radius = 1\n";

fn command(workplace: &Workplace, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_pointcore"));
    command.args(arguments).current_dir(workplace.path()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Code and error stream.
fn said(output: &Output) -> (Option<i32>, String) {
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn a_reader_that_has_had_enough_is_no_error() {
    let workplace = Workplace::new();
    workplace.write("square.obj", "v 0 0 1\nv 3 0 1\nv 3 4 1\nv 0 4 1\nf 1 2 3 4\n");
    let (reader, writer) = std::io::pipe().expect("the system has pipes");
    drop(reader);
    let output = command(&workplace, &["inspect", "square.obj"]).stdout(writer).output().expect("it runs");
    assert_eq!(said(&output), (Some(0), String::new()));
}

#[test]
fn a_full_disk_is_one_message() {
    let workplace = Workplace::new();
    workplace.write("square.obj", "v 0 0 1\nv 3 0 1\nv 3 4 1\nv 0 4 1\nf 1 2 3 4\n");
    let Ok(full) = fs::File::options().write(true).open("/dev/full") else { return skipped("there is no /dev/full") };
    let inspect = |full: fs::File, error| {
        let mut command = command(&workplace, &["inspect", "square.obj"]);
        said(&command.stdout(full).stderr(error).output().expect("it runs"))
    };
    let again = || full.try_clone().expect("a file can be opened twice");
    let (code, error) = inspect(again(), Stdio::piped());
    assert_eq!(code, Some(WRONG_INPUT), "{error}");
    assert!(error.contains("standard output cannot be written") && !error.contains("panicked"), "{error}");
    assert_eq!(inspect(again(), again().into()).0, Some(WRONG_INPUT), "nor does the error stream panic");
}

#[test]
fn a_cache_that_cannot_be_written_is_named_with_its_variable() {
    let workplace = Workplace::new();
    workplace.write("file", "");
    let search = ["knn", "--points", "surface:50", "--limit", "5"];
    let output = command(&workplace, &search).env("POINTCORE_CACHE", "file/cache").output().expect("it runs");
    let (code, error) = said(&output);
    assert_eq!(code, Some(WRONG_INPUT), "{error}");
    assert!(error.contains("file/cache") && error.contains("set POINTCORE_CACHE"), "{error}");
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|item| item.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn results_of_two_runs_never_mix() {
    let workplace = Workplace::new();
    let folder = workplace.path().join("out/knn");
    let search = ["knn", "--points", "surface:100", "--limit", "9", "--model", "golden"];
    workplace.succeeds(&search);
    assert!(names(&folder).contains(&"neighbors.csv".to_owned()));
    workplace.succeeds(&[&search[..], &["--json"]].concat());
    let left = ["index.html", "neighbors.json", "queries.csv", "report.json", "report.md", "verilog"];
    assert_eq!(names(&folder), left);
    let page = fs::read_to_string(folder.join("index.html")).expect("the page is written");
    assert!(page.contains("Cycles by cause") && !page.contains("http"), "one file that needs nothing besides");
}

#[test]
fn the_page_of_a_run_has_its_figures_and_all_frames() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    let run = ["run", "scene.toml", "--model", "golden", "--json", "--turntable", "3"];
    let report = json(&workplace.succeeds(&run));
    let folder = workplace.path().join("out/scene");
    let page = fs::read_to_string(folder.join("index.html")).expect("the page is written");
    for figure in [&report["cycles"], &report["samples"], &report["fates"]["drawn"], &report["fragments"]] {
        assert!(page.contains(&format!("<dd>{figure}</dd>")), "{figure}");
    }
    for (index, frame) in report["sequence"].as_array().expect("there are three frames").iter().enumerate() {
        assert!(page.contains(&format!("<tr><td>{index}</td><td>{}</td>", frame["cycles"])), "{frame}");
    }
    let sums = format!("\"sum\":{},", report["samples"]);
    assert!(page.contains(&sums) && page.contains("the first of 3 frames") && !page.contains("://"));
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 4, "frame, reference, difference, animation");
}

#[test]
fn an_interrupted_run_leaves_the_results_before_it() {
    let workplace = Workplace::new();
    let (folder, short) = (workplace.path().join("out/knn"), ["knn", "--points", "surface:100", "--model", "golden"]);
    workplace.succeeds(&short);
    let report = || fs::read_to_string(folder.join("report.json")).expect("there is a report");
    let (before, files) = (report(), names(&folder));
    let long = ["knn", "--points", "surface:300000", "--model", "golden", "--limit", "all"];
    let mut run = command(&workplace, &long).spawn().expect("it runs");
    let unfinished = folder.join(".unfinished");
    while !unfinished.join("verilog").exists() {
        assert!(run.try_wait().expect("it can be asked").is_none(), "it was over too soon");
        std::thread::sleep(Duration::from_millis(20));
    }
    let other = workplace.pointcore(&short);
    assert!(said(&other).1.contains("another run is writing to it"), "{:?}", said(&other));
    let killed = Command::new("kill").args(["-TERM", &run.id().to_string()]).status().expect("there is a `kill`");
    assert!(killed.success());
    assert_eq!(run.wait().expect("it ends").code(), Some(130));
    assert_eq!((report(), names(&folder)), (before, files));
}

#[test]
fn what_is_ignored_or_left_out_is_said() {
    let workplace = Workplace::new();
    workplace.write("scene.toml", SCENE);
    workplace.write("config.toml", "kind = \"splat\"\n[image]\nwidth = 32\nheight = 24\n");
    workplace.write("far.toml", "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_degrees = 40\nnear = 1\nfar = 10\n[image]\nwidth = 32\nheight = 24\n[[object]]\nkind = \"file\"\npath = \"gone.ply\"\n");
    let run = ["run", "scene.toml", "--config", "config.toml", "--model", "golden", "--set", "overrides.tile_slots=4"];
    let (code, error) = said(&workplace.pointcore(&run));
    assert!(code == Some(0) && error.contains("ignored") && error.contains("overrides.tile_slots"), "{code:?} {error}");

    let table = workplace.pointcore(&["plan", "--table", "scene.toml", "far.toml"]);
    let (code, error) = said(&table);
    assert!(
        code == Some(0) && error.contains("far.toml is left out") && error.contains("gone.ply"),
        "{code:?} {error}"
    );
    assert!(String::from_utf8_lossy(&table.stdout).contains("| scene | on |"), "{table:?}");
    workplace.fails_with_notes(&["plan", "--table", "far.toml"], &["gone.ply"]);

    let near = workplace.pointcore(&["plan", "scene.toml", "--set", "camera.near=1e-7"]);
    let (code, error) = said(&near);
    assert!(code == Some(0) && error.contains("raise `camera.near`"), "{code:?} {error}");
}

#[test]
fn waveforms_come_with_a_view_of_records_and_numbers() {
    let workplace = Workplace::new();
    workplace.write(
        "config.toml",
        "kind = \"search\"\n[features]\nneighbors = 8\ntree_depth = 6\nbucket = 8\n[implementation]\nthreads = 4\nlanes = 2\n",
    );
    let search = ["knn", "--points", "surface:200", "--config", "config.toml", "--k", "4", "--limit", "20", "--json"];
    let traced = |arguments: &[&str]| json(&workplace.succeeds(&[&search[..], arguments].concat()));
    let window = traced(&["--trace-window", "300..340"]);
    let bytes = || fs::metadata(workplace.path().join("out/knn/search.fst")).expect("there is a waveform").len();
    let short = bytes();
    let whole = traced(&["--trace"]);
    assert!(bytes() > 2 * short, "{} of the whole run, {short} of 40 cycles", bytes());
    assert_eq!((&window["cycles"], &window["mismatches"]), (&whole["cycles"], &serde_json::Value::Null));
    let view = fs::read_to_string(workplace.path().join("out/knn/search.gtkw")).expect("there is a view");
    assert!(view.contains("-query\n") && view.contains("TOP.query_x[31:0]"), "{view}");
    let filter = workplace.path().join("out/knn/formats/f32-ftz");
    let mut filter = Command::new(filter).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("it runs");
    std::io::Write::write_all(&mut filter.stdin.take().expect("it has an input"), b"3fc00000\n").expect("it listens");
    assert_eq!(filter.wait_with_output().expect("it ends").stdout, b"1.5\n");
    traced(&["--model", "golden"]);
    assert!(!workplace.path().join("out/knn/search.fst").exists(), "it was another run's");
    let beyond = [&search[..], &["--trace-window", "9000000..9000001"]].concat();
    workplace.fails(WRONG_INPUT, &beyond, &["--trace-window", "the run has"]);
}
