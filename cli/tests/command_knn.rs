//! `pointcore knn` and the search core's `pointcore gen` as a user meets them.

use serde_json::Value;
use std::fs;

use super::command::{WRONG_INPUT, Workplace, accepts_bus, json};

/// Small hardware, so that it builds soon.
const CONFIG: &str = "kind = \"search\"\n[features]\nneighbors = 8\ntree_depth = 6\nbucket = 8\n[implementation]\nthreads = 4\nlanes = 2\n";

#[test]
fn wrong_input_is_one_message_and_exit_code_2() {
    let workplace = Workplace::new();
    workplace.write("config.toml", CONFIG);
    workplace.write("flat.toml", &CONFIG.replace("tree_depth = 6", "tree_depth = 2"));
    workplace.write("odd.toml", &CONFIG.replace("lanes = 2", "lanes = 3"));
    workplace.write("unknown.toml", &CONFIG.replace("lanes", "lains"));
    workplace.write("a.toml", "width = 64\n");
    workplace.write("nan.obj", "v 0 0 0\nv 0 nan 0\n");
    workplace.write("empty.obj", "# nothing\n");
    let surface = ["knn", "--points", "surface:100"];
    for (arguments, parts) in [
        (&["--k", "0"][..], ["'0' for '--k", "1 to 64"]),
        (&["--k", "65"], ["'65' for '--k", "1 to 64"]),
        (&["--k", "9", "--config", "config.toml"], ["`neighbors` is 8", "raise it to 9 (up to 64)"]),
        (&["--radius", "-1"], ["'-1' for '--radius", "positive"]),
        (&["--radius", "nan"], ["'nan' for '--radius", "positive"]),
        (&["--radius", "1e-30"], ["radius", "vanishes"]),
        (&["--latency", "501"], ["'501' for '--latency", "1 to 500"]),
        (&["--bandwidth", "0"], ["'0' for '--bandwidth", "0.01 to 65536"]),
        (&["--burst", "0"], ["'0' for '--burst", "1 byte"]),
        (&["--stalls", "1"], ["'1' for '--stalls", "expected"]),
        (&["--interleave", "0"], ["'0' for '--interleave", "expected"]),
        (&["--cache", "33"], ["'33' for '--cache", "0 to 32"]),
        (&["--cache", "0", "--epsilon", "0.1"], ["--cache 0", "1 to 32"]),
        (&["--cache", "8", "--k", "64"], ["needs one more", "ask for fewer"]),
        (&["--cache", "8", "--epsilon", "nan"], ["'nan' for '--epsilon", "0 to 10"]),
        (&["--cache", "8", "--alpha", "0.5"], ["'0.5' for '--alpha", "1 to 10"]),
        (&["--clock-mhz", "0"], ["'0' for '--clock-mhz", "expected"]),
        (&["--model", "golden", "--no-lockstep"], ["--no-lockstep", "--model rtl"]),
        (&["--queries", "nan.obj"], ["nan.obj", "vertex 1"]),
        (&["--config", "gone.toml"], ["gone.toml", "cannot be read"]),
        (&["--config", "a.toml"], ["a.toml", "kind = \"search\""]),
        (&["--config", "config.toml", "--k", "5", "--epsilon", "0.1"], ["config.toml", "`neighbor_cache`"]),
        (&["--config", "odd.toml"], ["odd.toml: `lanes` = 3", "1, 2, 4 or 8"]),
        (&["--config", "unknown.toml"], ["unknown.toml: line 8: `lains`", "`lanes`"]),
        (&["--config", "flat.toml"], ["100 points", "raise `tree_depth` to 4"]),
    ] {
        workplace.fails(WRONG_INPUT, &[&surface, arguments].concat(), &parts);
    }
    workplace.fails(WRONG_INPUT, &["knn", "--points", "gone.ply"], &["gone.ply", "cannot be read"]);
    workplace.fails(WRONG_INPUT, &["knn", "--points", "empty.obj"], &["empty.obj", "no vertex"]);
    workplace.fails(WRONG_INPUT, &["knn", "--points", "nan.obj"], &["nan.obj", "vertex 1"]);
    for arguments in [&["--order", "sorted"][..], &["--limit", "0"], &["--order", "file", "--queries", "nan.obj"]] {
        let output = workplace.pointcore(&[&surface, arguments].concat());
        assert_eq!(output.status.code(), Some(WRONG_INPUT), "{arguments:?}");
    }
    assert!(!workplace.path().join("out").exists(), "nothing is written on wrong input");
}

#[test]
fn the_model_finds_neighbors_and_leaves_them_with_a_report() {
    let workplace = Workplace::new();
    let line: String = (0..40).map(|x| format!("v {x} 0 0\n")).collect();
    workplace.write("line.obj", &line);
    workplace.write("queries.obj", "v 7.25 0 0\nv 100 0 0\n");
    let search = ["knn", "--points", "line.obj", "--model", "golden", "--k", "2", "--json"];
    let within = [&search[..], &["--csv", "--queries", "queries.obj", "--radius", "1.5"]].concat();
    let report = json(&workplace.succeeds(&within));
    assert_eq!((&report["queries"], &report["neighbors"]), (&Value::from(2), &Value::from(2)));
    let neighbors = fs::read_to_string(workplace.path().join("out/knn/neighbors.csv")).expect("neighbors are written");
    assert_eq!(neighbors, "query,rank,point,distance2\n0,0,7,6.25e-2\n0,1,8,5.625e-1\n");
    let queries = fs::read_to_string(workplace.path().join("out/knn/queries.csv")).expect("queries are written");
    assert_eq!(queries, "query,x,y,z\n0,7.25e0,0e0,0e0\n1,1e2,0e0,0e0\n");
    for file in ["report.md", "report.json", "verilog/search_top.v", "verilog/config.toml"] {
        assert!(workplace.path().join("out/knn").join(file).is_file(), "{file} is missing");
    }

    for order in ["random", "file", "morton", "grid:3x2"] {
        let arguments = ["--order", order, "--check", "--limit", "30", "-o", "other"];
        let report = json(&workplace.succeeds(&[&search[..], &arguments].concat()));
        assert_eq!(
            (&report["checked"]["exact"], &report["neighbors"]),
            (&Value::from(30), &Value::from(60)),
            "{order}"
        );
        assert_eq!(report["mismatches"], Value::Null, "nothing was compared");
        let neighbors =
            fs::read_to_string(workplace.path().join("other/neighbors.json")).expect("neighbors are written");
        assert_eq!(json(&neighbors).as_array().map(Vec::len), Some(30));
    }
}

/// Points some centimetres apart in a corner of a map, in two strips so far from each other.
fn strips(apart: f64) -> String {
    let strip = |index: i32| {
        let (side, place) = (f64::from(index % 2), f64::from(index / 2));
        [412_345.67 + side * apart + 0.031 * place, 5_654_321.09 + 0.017 * (place * 1.7).sin(), 120.0]
    };
    (0..400).map(strip).map(|[x, y, z]| format!("v {x:.4} {y:.4} {z:.4}\n")).collect()
}

#[test]
fn maps_are_searched_right_or_not_at_all() {
    let workplace = Workplace::new();
    workplace.write("near.obj", &strips(20.0));
    workplace.write("far.obj", &strips(3e6));
    workplace.write("coarse.toml", &CONFIG.replace("[features]", "[features]\ngeometry = \"f24-ftz\""));
    let search = |points| ["knn", "--points", points, "--model", "golden", "--k", "6", "--check", "--json"];
    let report = json(&workplace.succeeds(&search("near.obj")));
    assert_eq!((&report["truth"]["others"], &report["truth"]["neighbors"]), (&Value::from(0), &Value::from(2400)));
    assert_ne!(report["rounding"]["origin"][0], Value::from(0.0));
    let queries = fs::read_to_string(workplace.path().join("out/knn/queries.csv")).expect("queries are written");
    assert!(queries.contains(",4.123"), "queries stand in the file's coordinates: {queries}");
    let coarse = [&search("far.obj")[..], &["--config", "coarse.toml"]].concat();
    workplace.fails(WRONG_INPUT, &coarse, &["too many neighbors would be wrong", "`geometry` = \"f32-ftz\""]);
    workplace.fails(WRONG_INPUT, &search("far.obj"), &["too many neighbors would be wrong", "tiles"]);
}

#[test]
fn hardware_and_model_search_in_lockstep() {
    let workplace = Workplace::new();
    workplace.write("config.toml", CONFIG);
    let search = [
        "knn",
        "--points",
        "surface:400",
        "--config",
        "config.toml",
        "--k",
        "5",
        "--limit",
        "60",
        "--check",
        "--json",
        "--burst",
        "64",
        "--bandwidth",
        "20",
        "--out-of-order",
        "--stalls",
        "0.1",
        "--tree",
        "median",
        "--interleave",
        "3",
    ];
    let lockstep = json(&workplace.succeeds(&search));
    assert_eq!((&lockstep["mismatches"], &lockstep["checked"]["exact"]), (&Value::from(0), &Value::from(60)));
    let alone = json(&workplace.succeeds(&[&search[..], &["--no-lockstep"]].concat()));
    let golden = json(&workplace.succeeds(&[&search[..], &["--model", "golden"]].concat()));
    for other in [&alone, &golden] {
        assert_eq!((&other["cycles"], &other["bounds"]), (&lockstep["cycles"], &lockstep["bounds"]));
        assert_eq!(other["mismatches"], Value::Null);
    }
    let markdown = fs::read_to_string(workplace.path().join("out/knn/report.md")).expect("the report is written");
    assert!(markdown.contains("60 of 60 queries, every distance equal bit for bit"), "{markdown}");
}

#[test]
fn generated_verilog_is_accepted_by_every_tool() {
    let workplace = Workplace::new();
    workplace.write("config.toml", CONFIG);
    let files = json(&workplace.succeeds(&["gen", "config.toml", "-o", "first", "--json"]));
    assert_eq!(files["top"], "search_top");
    workplace.succeeds(&["gen", "first/config.toml", "-o", "second"]);
    for name in files["files"].as_array().expect("a list of files") {
        let first = workplace.path().join(name.as_str().expect("file names are strings"));
        let second = workplace.path().join("second").join(first.file_name().expect("files have names"));
        let [first, second] = [first, second].map(|path| fs::read(&path).unwrap_or_else(|error| panic!("{error}")));
        assert!(first == second, "{name} differs from one run to the next");
    }
    workplace.accepts("verilator", &["--lint-only", "-Wall", "search_top.v"], "first");
    workplace.accepts("iverilog", &["-t", "null", "-Wall", "search_top.v"], "first");
    let script = "read_verilog search_top.v; hierarchy -check -top search_top; proc; check -assert";
    workplace.accepts("yosys", &["-q", "-p", script], "first");
    accepts_bus(&workplace, "search", "first");
}
