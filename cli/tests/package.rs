//! What is written for a configuration: whole, and accepted by the usual tools.

use crate::command::{Workplace, json};
use pointcore_tb::verilated::Optimization;
use rayon::prelude::*;
use std::fs;
use std::path::Path;
use std::process::Command;

/// A small renderer.
const SPLATTING: &str = "kind = \"splat\"\nimage = { width = 64, height = 64 }\nfeatures = { geometry = \"f24-ftz\", continuous = 2 }\nimplementation.heap_levels = 5\n";
/// One of two rasterizers, each with a port to memory, which a bus leads to one, one to payloads, and one to depths; no edge of its image is
/// a power of two.
const WIDE: &str = "kind = \"splat\"\nimage = { width = 72, height = 40 }\nfeatures = { geometry = \"bf16\", continuous = 1, merge = \"on\" }\nimplementation = { heap_levels = 4, rasterizers = 2, memory_ports = 2, tile_slots = 2, payload = \"memory\" }\n";
/// One whose splats move, with two bins of the exposure.
const MOVING: &str = "kind = \"splat\"\nimage = { width = 32, height = 32 }\nfeatures = { geometry = \"f24-ftz\", continuous = 1, time_bins = 2, culling = \"on\", screen_filter = \"off\" }\nimplementation = { heap_levels = 4, setup_interval = 16 }\n";
/// A small search core with a tree cache and a neighbor cache.
const CACHED: &str = "kind = \"search\"\nfeatures = { neighbors = 1, tree_depth = 3, bucket = 4, neighbor_cache = 2 }\nimplementation = { threads = 2, tree_cache = 16 }\n";
/// A small search core whose point memory holds a few points, each in a beat of its own.
const NARROW: &str = "kind = \"search\"\nfeatures = { neighbors = 4, tree_depth = 2, bucket = 8, index_bits = 4 }\nimplementation = { threads = 1, lanes = 8 }\n";

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Simulates the test that goes with a core; whether it passed, and what it printed.
fn simulated(core: &str, folder: &Path) -> (bool, String) {
    simulated_with(core, &[&format!("{core}_top.v")], folder)
}

/// Simulates the test that goes with the core on AXI.
fn simulated_on_axi(core: &str, folder: &Path) -> (bool, String) {
    simulated_with(&format!("{core}_axi"), &[&format!("{core}_top.v"), &format!("{core}_axi.v")], folder)
}

fn simulated_with(core: &str, design: &[&str], folder: &Path) -> (bool, String) {
    let program = folder.join(format!("obj_dir/V{core}_test"));
    if !program.exists() {
        let optimization = Optimization::Quick.compiler_arguments().join(" ");
        let compiled = Command::new("verilator")
            .args(["--binary", "--x-initial", "unique", "--top-module", &format!("{core}_test")])
            // One unit of C++: headers are long. What `-CFLAGS` says of optimization, Verilator's makefile takes back. At -O0 a test on AXI
            // takes a third less to compile and twice as long to run, which is more.
            .args(["-MAKEFLAGS", &format!("VM_PARALLEL_BUILDS=0 OPT_GLOBAL=-O0 OPT_FAST='{optimization}'")])
            .arg(format!("{core}_test.sv"))
            .args(design)
            .current_dir(folder)
            .output()
            .unwrap_or_else(|error| panic!("cannot run verilator ({error}): run `make setup`"));
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    }
    let run = Command::new(program).arg("+verilator+rand+reset+2").current_dir(folder).output();
    let run = run.expect("verilator has built it");
    (run.status.success(), String::from_utf8_lossy(&run.stdout).into_owned())
}

#[test]
fn the_test_that_goes_with_a_core_passes_and_finds_faults() {
    let configs = [("splat", SPLATTING), ("splat", WIDE), ("splat", MOVING), ("search", CACHED)];
    configs.into_par_iter().for_each(|(core, config)| {
        let workplace = Workplace::new();
        workplace.write("config.toml", config);
        workplace.succeeds(&["gen", "config.toml", "-o", "a"]);
        check(core, &workplace.path().join("a"));
    });
}

fn check(core: &str, folder: &Path) {
    let (passed, text) = simulated(core, folder);
    assert!(passed && text.contains("PASSED") && !text.contains(" 0 items"), "{text}");

    let vectors = folder.join(format!("{core}_test.hex"));
    let recorded = read(&vectors);
    // In the midst of the run: at its beginning the core clears its memories, and some inputs mean nothing. More bits than a
    // beat has, which may be of points that nobody finds.
    let middle = recorded.lines().count() / 2;
    let spoilt = middle..middle + 16;
    let wrong = recorded.lines().enumerate().map(|(place, word)| {
        let bits = u64::from_str_radix(word, 16).expect("a word");
        format!("{:016x}\n", if spoilt.contains(&place) { !bits } else { bits })
    });
    fs::write(&vectors, wrong.collect::<String>()).expect("a temporary folder can be written");
    let (passed, text) = simulated(core, folder);
    assert!(!passed && text.contains("differs from the model") && text.contains("FAILED"), "{text}");
}

#[test]
fn the_test_that_goes_with_an_axi_top_passes_and_finds_faults() {
    let configs = [("splat", SPLATTING), ("splat", WIDE), ("splat", MOVING), ("search", CACHED), ("search", NARROW)];
    configs.into_par_iter().for_each(|(core, config)| {
        let workplace = Workplace::new();
        workplace.write("config.toml", config);
        workplace.succeeds(&["gen", "config.toml", "-o", "a"]);
        let folder = workplace.path().join("a");
        let (passed, text) = simulated_on_axi(core, &folder);
        assert!(passed && text.contains("PASSED") && !text.contains(" 0 packets"), "{text}");

        // The first read expects another value.
        let vectors = folder.join(format!("{core}_axi_test.hex"));
        let script = read(&vectors);
        let first_operation = usize::from_str_radix(script.lines().nth(1).expect("a header"), 16).expect("a number");
        let expected = first_read(&script, first_operation) + 1;
        let wrong = script.lines().enumerate().map(|(place, word)| {
            let value = u32::from_str_radix(word, 16).expect("a word");
            format!("{:x}\n", if place == expected { value ^ 1 } else { value })
        });
        fs::write(&vectors, wrong.collect::<String>()).expect("a temporary folder can be written");
        let (passed, text) = simulated_on_axi(core, &folder);
        assert!(!passed && text.contains("FAILED: read "), "{text}");
        fs::write(&vectors, "0\n0\n").expect("a temporary folder can be written");
        let (passed, text) = simulated_on_axi(core, &folder);
        assert!(!passed && text.contains("is missing or another's"), "{text}");
    });
}

/// The first operation that reads a register: until then no operation has operands.
fn first_read(script: &str, first_operation: usize) -> usize {
    let is_read = |word: &str| word.ends_with("04");
    let place = script.lines().skip(first_operation).position(is_read);
    first_operation + place.expect("a script reads registers")
}

#[test]
fn a_core_names_the_files_that_are_there_and_they_are_accepted() {
    let workplace = Workplace::new();
    workplace.write("a.toml", SPLATTING);
    workplace.write("b.toml", NARROW);
    for (name, core) in [("a", "splat"), ("b", "search")] {
        let files = json(&workplace.succeeds(&["gen", &format!("{name}.toml"), "-o", name, "--json"]));
        let folder = workplace.path().join(name);
        let description = read(&folder.join(format!("{name}.core")));
        let named = description.lines().filter_map(|line| line.trim().strip_prefix("- ")?.split_once(": {"));
        let named: Vec<_> = named.map(|(file, _)| file).collect();
        assert!(named.contains(&format!("{core}_top.v").as_str()), "{description}");
        for file in &named {
            assert!(folder.join(file).is_file(), "{file} is missing");
        }
        assert!(description.contains(&format!("\"pointcore:cores:{name}:{}\"", env!("CARGO_PKG_VERSION"))));
        for module in [format!("{core}_top"), format!("{core}_pins")] {
            for ending in ["lpf", "xdc", "sdc"] {
                let constraints = read(&folder.join(format!("{module}.{ending}")));
                assert!(
                    constraints.starts_with(&format!("# {module}")) && constraints.contains("clk"),
                    "{constraints}"
                );
            }
        }
        assert_eq!(files["files"].as_array().map(Vec::len), fs::read_dir(&folder).ok().map(Iterator::count));
        let [top, pins] = [format!("{core}_top.v"), format!("{core}_pins.v")];
        let arguments = ["--lint-only", "-Wall", "--top-module", pins.trim_end_matches(".v"), &pins, &top];
        workplace.accepts("verilator", &arguments, name);
    }
}

#[test]
fn a_file_a_module_and_their_list_are_accepted_from_their_folder() {
    let workplace = Workplace::new();
    workplace.write("a.toml", SPLATTING);
    workplace.write("b.toml", NARROW);
    for (name, core) in [("a", "splat"), ("b", "search")] {
        workplace.succeeds(&["gen", &format!("{name}.toml"), "-o", name, "--split"]);
        let folder = workplace.path().join(name);
        let list = read(&folder.join(format!("modules/{core}_top.f")));
        let files: Vec<&str> = list.lines().collect();
        assert!(files.len() > 10 && files.last() == Some(&format!("{core}_top.v").as_str()), "{list}");
        // The list names every file but itself.
        assert_eq!(fs::read_dir(folder.join("modules")).ok().map(Iterator::count), Some(files.len() + 1));
        let mut above = String::new();
        for file in files {
            let text = read(&folder.join("modules").join(file));
            let module = file.trim_end_matches(".v");
            let instance = format!("    {module} ");
            assert!(!above.lines().any(|line| line.starts_with(&instance)), "{module} comes after what it is part of");
            assert!(text.is_ascii(), "old tools take nothing else: {text}");
            above += &text;
        }
        assert_eq!(
            above.matches("endmodule").count(),
            read(&folder.join(format!("{core}_top.v"))).matches("endmodule").count()
        );
        let list = format!("{core}_top.f");
        let modules = format!("{name}/modules");
        workplace.accepts("verilator", &["--lint-only", "-Wall", "-f", &list], &modules);
        workplace.accepts("verilator", &["--lint-only", "-Wall", "-DRTL_ASSERT", "-f", &list], &modules);
        workplace.accepts("iverilog", &["-Wall", "-t", "null", "-f", &list], &modules);
    }
}
