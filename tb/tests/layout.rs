//! The repository keeps its promises: one unit has one name in four places, and models and hardware do not know
//! each other.

use std::fs;
use std::path::{Path, PathBuf};

use pointcore_contract::{search, splat};

/// Folders of `hdl/src` and `golden/src` whose files are units.
const CORES: &[&str] = &["stream", "splat", "search", "bus"];

/// Folders of a core that hold no unit: what several units share, and the cores behind their buses.
const SHARED: &[&str] = &["parts", "cores"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All Rust files below a folder, sorted.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = vec![];
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.expect("a folder that opens can be listed").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The file that describes a unit, or would: `<unit>.rs`, or `<unit>/mod.rs` where it has parts of its own.
fn unit_file(side: &str, core: &str, unit: &str) -> String {
    let folder = format!("{side}/src/{core}/{unit}");
    let file = format!("{folder}/mod.rs");
    if root().join(&file).is_file() { file } else { format!("{folder}.rs") }
}

/// Names of the units of a core, by the files that describe their hardware.
fn units(core: &str) -> Vec<String> {
    let folder = root().join("hdl/src").join(core);
    let files = rust_files(&folder).into_iter();
    let places = files.map(|path| path.strip_prefix(&folder).expect("it was found in the folder").with_extension(""));
    let units = places.filter_map(|place| match place.to_string_lossy().split_once('/') {
        None => (place != Path::new("mod")).then(|| place.to_string_lossy().into_owned()),
        Some((unit, file)) => (file == "mod").then(|| unit.to_owned()),
    });
    let mut units: Vec<_> = units.filter(|unit| !SHARED.contains(&unit.as_str())).collect();
    units.sort();
    units
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Units of a core: those of the contract, where it describes them, and then no others have hardware.
fn specified(core: &str) -> Vec<String> {
    let found = units(core);
    assert!(!found.is_empty(), "{core} has no units");
    let mut described: Vec<String> = match core {
        "splat" => splat::units::UNITS.iter().map(|unit| unit.name().to_owned()).collect(),
        "search" => search::units::UNITS.iter().map(|unit| unit.name().to_owned()).collect(),
        _ => return found,
    };
    described.sort();
    assert_eq!(found, described, "hdl/src/{core} holds the units of contract/src/{core}/units");
    described
}

#[test]
fn every_unit_has_hardware_a_model_a_test_and_a_module() {
    let mut missing = vec![];
    for core in CORES {
        for unit in specified(core) {
            let test = format!("{core}_{unit}");
            for place in [unit_file("golden", core, &unit), format!("tb/tests/{test}.rs")] {
                if !root().join(&place).is_file() {
                    missing.push(place);
                }
            }
            let hardware = unit_file("hdl", core, &unit);
            if !read(&root().join(&hardware)).contains(&format!("\"{test}\"")) {
                missing.push(format!("module `{test}` in {hardware}"));
            }
        }
    }
    assert!(missing.is_empty(), "missing:\n{}", missing.join("\n"));
}

/// Operators of one format are verilated and compared together, so their tests are one file.
#[test]
fn every_operator_has_hardware_a_model_and_a_comparison() {
    // All operators on floats that are listed with their models, and others one by one.
    let files = ["pointcore/src/operators/mod.rs", "lab/src/float_check/operations.rs"];
    let compared = files.map(|file| read(&root().join(file))).concat();
    assert!(compared.contains("ON_FLOATS.iter().map("), "the listed operators are not compared");
    assert!(root().join("tb/tests/float.rs").is_file(), "the comparison of operators is gone");
    let mut missing = vec![];
    for operator in units("float") {
        let model = format!("golden/src/float/{operator}.rs");
        if !root().join(&model).is_file() {
            missing.push(model);
        }
        if !compared.contains(&format!("{operator}::")) {
            missing.push(format!("`{operator}` in {}", files.join(" or ")));
        }
    }
    assert!(missing.is_empty(), "missing:\n{}", missing.join("\n"));
}

#[test]
fn models_and_hardware_do_not_know_each_other() {
    for (side, other) in [("golden", "hdl"), ("hdl", "golden")] {
        let folder = root().join(side);
        assert!(!read(&folder.join("Cargo.toml")).contains(&format!("pointcore-{other}")), "{side} depends on {other}");
        let crate_name = format!("pointcore_{other}");
        for path in rust_files(&folder.join("src")) {
            for (number, line) in read(&path).lines().enumerate() {
                let code = line.split("//").next().unwrap_or(line);
                assert!(!code.contains(&crate_name), "{}:{} uses {other}", path.display(), number + 1);
            }
        }
    }
}
