//! `pointcore soak` and its record as a user meets them; what it runs is tested in lab/ and tb/.

use crate::command::{WRONG_INPUT, Workplace, json};
use std::fs;

const RECORD: &str = r#"[{"core": "splat", "revision": "abc1234", "sources": "0", "seed": 1, "cycles_per_configuration": 1000,
    "configurations": 2, "runs": 30, "items": 90, "cycles": 2500, "mismatches": 0}]"#;

#[test]
fn a_record_becomes_a_table_and_figures() {
    let workplace = Workplace::new();
    workplace.write("soak.json", RECORD);
    workplace.write("page.md", "before\n<!-- soak -->\n<!-- end of soak -->\nafter\n");
    let path = |name: &str| workplace.path().join(name);
    let output = workplace.pointcore(&[
        "soak",
        "--recorded",
        "--record",
        "soak.json",
        "--tables",
        "page.md",
        "--merge",
        "bench.json",
    ]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = fs::read_to_string(path("page.md")).expect("it was there");
    assert!(page.contains("| splat | abc1234 | 1 | 2 | 30 | 2,500 | 0 |") && page.ends_with("after\n"), "{page}");
    let figures = json(&fs::read_to_string(path("bench.json")).expect("figures were merged"));
    assert_eq!((&figures["soak.cycles"], &figures["soak.mismatches"]), (&2500.into(), &0.into()));
}

#[test]
fn wrong_input_is_told_before_anything_is_run() {
    let workplace = Workplace::new();
    workplace.write("wrong.json", "{}");
    for (arguments, part) in [
        (&["soak", "--record", "soak.json"][..], "--record needs the revision"),
        (&["soak", "--record", "wrong.json", "--revision", "a"], "wrong.json"),
        (&["soak", "--cases", "0"], "1 to 1000000 cases"),
        (&["soak", "--shard", "3/2"], "expected I/N"),
        (&["soak", "--run", "3"], "--case"),
        (&["soak", "--case", "1", "--record", "soak.json"], "cannot be used with"),
    ] {
        let output = workplace.pointcore(arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(WRONG_INPUT), "{said}");
        assert!(said.contains(part), "{said}");
    }
}
