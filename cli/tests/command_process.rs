//! `pointcore process` as a user meets it.

use super::command::{WRONG_INPUT, Workplace, json};
use serde_json::Value;
use std::fs;

/// A program that nothing is known of.
const OWN: &str = ".program warmth\n.setting gain: float\n.neighbor heat: float\n.kernel\nw = mul neighbor.heat, gain\n\
                   accumulate warm, w\n.final\noutput warm, warm\n";

#[test]
fn wrong_input_is_one_message_and_exit_code_2() {
    let workplace = Workplace::new();
    workplace.write("own.pasm", OWN);
    workplace.write("bad.pasm", ".program bad\n.kernel\nx = add 1.0, 2\n");
    workplace.write("nan.xyz", "0 0 0\n0 1 0\n0 nan 0\n");
    workplace.write("same.xyz", "1 2 3\n1 2 3\n1 2 3\n");
    workplace.write("holes.csv", "x,y,z,heat\n0,0,0,1\n0,1,0,\n1,0,0,2\n");
    let surface = ["process", "--points", "surface:100"];
    for (arguments, parts) in [
        (&["--op", "smoothe"][..], &["no operation `smoothe`", "smooth, resample, sph", "--program"][..]),
        (&["--op", "mls", "--k", "65"], &["'65' for '--k", "1 to 64"]),
        (&["--op", "mls", "--radius", "-1"], &["'-1' for '--radius", "positive"]),
        (&["--op", "mls", "--iterations", "0"], &["'0' for '--iterations", "1 to 65535"]),
        (&["--op", "mls", "--set", "tolerance"], &["'tolerance' for '--set", "NAME=NUMBER"]),
        (&["--op", "mls", "--set", "speed=1"], &["`mls` has no setting `speed`", "tolerance (float)"]),
        (&["--op", "mls", "--set", "tolerance=1", "--set", "tolerance=2"], &["--set gives `tolerance` twice"]),
        (&["--op", "mls", "--attribute", "heat=1"], &["`mls` reads no field `heat`", "normal (float3)"]),
        (&["--op", "mls", "--pattern", "2x2"], &["--pattern", "`mls`", "`resample`"]),
        (&["--op", "resample", "--pattern", "0x2"], &["'0x2' for '--pattern", "1x1 to 64x64"]),
        (&["--op", "normals", "--passes", "2"], &["2 passes of `normals`", "moves points"]),
        (&["--op", "smooth", "--passes", "2", "--limit", "9"], &["`smooth` asks all points"]),
        (&["--op", "mls", "--format", "f16"], &["\"f16\"", "f32-ftz or f24-ftz"]),
        (&["--program", "own.pasm"], &["setting `gain`", "--set gain=NUMBER"]),
        (&["--program", "own.pasm", "--set", "gain=1"], &["surface:100", "neighbor.heat (float)", "--attribute heat="]),
        (&["--program", "own.pasm", "--check"], &["no formulas in f64 of `warmth`", "covariance"]),
        (&["--program", "bad.pasm"], &["bad.pasm:3:"]),
        (&["--program", "gone.pasm"], &["gone.pasm", "cannot be read"]),
    ] {
        workplace.fails(WRONG_INPUT, &[&surface, arguments].concat(), parts);
    }
    let fails = |points: &str, arguments: &[&str], parts: &[&str]| {
        workplace.fails(WRONG_INPUT, &[&["process", "--points", points], arguments].concat(), parts);
    };
    fails("nan.xyz", &["--op", "mls"], &["nan.xyz", "vertex 2", "--drop-invalid"]);
    fails("same.xyz", &["--op", "mls"], &["same.xyz", "lie in one place", "--radius"]);
    fails(
        "same.xyz",
        &["--op", "mls", "--normals", "file"],
        &["same.xyz", "neither normals nor faces", "--normals estimate"],
    );
    workplace.write("half.csv", "x,y,z,nx,ny\n0,0,0,0,1\n0,1,0,0,1\n1,0,0,0,1\n");
    fails("half.csv", &["--op", "mls"], &["half.csv", "expected nx, ny and nz"]);
    fails("holes.csv", &["--program", "own.pasm", "--set", "gain=1"], &["holes.csv: heat of vertex 1 is NaN"]);
    assert!(!workplace.path().join("out").exists(), "nothing is written on wrong input");
}

#[test]
fn an_operator_leaves_points_report_and_arrays() {
    let workplace = Workplace::new();
    let text = workplace.succeeds(&[
        "--json",
        "process",
        "--op",
        "mls",
        "--points",
        "surface:500",
        "--check",
        "--write",
        "ply,csv,npy",
        "-o",
        "mls",
    ]);
    let report: Value = json(&text);
    assert_eq!((&report["queries"], &report["invalid"]), (&500.into(), &0.into()));
    assert!(report["compared"].as_array().is_some_and(|compared| compared.len() == 4), "{report}");
    let folder = workplace.path().join("mls");
    let markdown = fs::read_to_string(folder.join("report.md")).expect("it is written");
    assert!(markdown.contains("| thesis table 6.2 | 29 | 32 | 3 | 2 |"), "{markdown}");
    assert!(markdown.contains("estimated by `normals` from 16 neighbors"), "{markdown}");
    assert!(folder.join("arrays/normal.npy").exists() && folder.join("points.csv").exists());
    // What was written is points with normals for the next.
    let again =
        workplace.succeeds(&["process", "--op", "smooth", "--points", "mls/points.ply", "-o", "mls", "--passes", "2"]);
    assert!(again.contains("vertex normals of the file") && again.contains("in the last of 2 passes"), "{again}");
    assert!(!folder.join("points.csv").exists() && !folder.join("arrays").exists(), "files of another run are gone");
}

#[test]
fn a_check_that_compares_nothing_fails() {
    let workplace = Workplace::new();
    workplace.write("one.xyz", "1 2 3\n");
    workplace.fails(
        1,
        &["process", "--op", "normals", "--points", "one.xyz", "--radius", "1", "--check"],
        &["no query of `normals` is valid, so nothing was compared"],
    );
    workplace.succeeds(&["process", "--op", "normals", "--points", "one.xyz", "--radius", "1"]);
}

#[test]
fn a_program_of_your_own_reads_columns_of_the_points() {
    let workplace = Workplace::new();
    workplace.write("own.pasm", OWN);
    workplace.write("points.csv", "x,y,z,heat\n0,0,0,1\n0,1,0,2\n1,0,0,4\n");
    let run = ["process", "--program", "own.pasm", "--points", "points.csv", "--set", "gain=0.5", "--write", "csv"];
    workplace.succeeds(&run);
    let text = fs::read_to_string(workplace.path().join("out/process/points.csv")).expect("it is written");
    let expected = "query,x,y,z,iterations,neighbors,capped,warm\n0,0,0,0,1,3,0,3.5e0\n";
    assert!(text.starts_with(expected), "{text}");
}

#[test]
fn an_output_named_as_a_column_of_every_file_is_kept() {
    let workplace = Workplace::new();
    workplace.write(
        "sum.pasm",
        ".program sum\n.kernel\none = mul 1, 7\naccumulate total, one\n.final\noutput neighbors, total\n",
    );
    workplace.write("points.csv", "x,y,z\n0,0,0\n0,1,0\n1,0,0\n");
    workplace.succeeds(&["process", "--program", "sum.pasm", "--points", "points.csv", "--write", "ply,csv,npy"]);
    let folder = workplace.path().join("out/process");
    let text = fs::read_to_string(folder.join("points.csv")).expect("it is written");
    assert!(text.starts_with("query,x,y,z,iterations,neighbors,capped,output_neighbors\n0,0,0,0,1,3,0,21\n"), "{text}");
    assert!(folder.join("arrays/output_neighbors.npy").exists());
}
