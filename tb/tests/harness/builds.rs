//! Building, caching, loading and stepping.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

use pointcore_tb::toolchain::{Toolchain, ToolchainError};
use pointcore_tb::verilated::{BuildOptions, Builder, Direction, Trace, VerilatedError, VerilatedModel, VerilogSource};
use rtl::{Module, elaborate};

use super::{FIFO, library, port, source};

/// A Verilator that appends a line to a file each time it translates.
fn counting_verilator(folder: &Path) -> (PathBuf, PathBuf) {
    let (script, log) = (folder.join("verilator"), folder.join("translations"));
    let text = format!("#!/bin/sh\ncase $1 in --cc) echo >> {} ;; esac\nexec verilator \"$@\"\n", log.display());
    fs::write(&script, text).unwrap();
    fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).unwrap();
    (script, log)
}

fn only_library_in(folder: &Path) -> PathBuf {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path().join("model.so"));
    let libraries: Vec<_> = entries.filter(|path| path.exists()).collect();
    assert_eq!(libraries.len(), 1, "{libraries:?}");
    libraries[0].clone()
}

#[test]
fn the_second_build_comes_from_the_cache_and_a_damaged_one_is_redone() {
    let folder = tempfile::tempdir().unwrap();
    let (verilator, log) = counting_verilator(folder.path());
    let cache = folder.path().join("cache");
    let toolchain = Toolchain::with(&verilator, Path::new("g++")).unwrap();
    let translations = || fs::read_to_string(&log).unwrap().lines().count();
    let build = || {
        let builder = Builder::with(toolchain.clone(), cache.clone());
        builder.build(&source(FIFO), BuildOptions::default()).unwrap().instantiate(1).reset(2).unwrap();
    };
    std::thread::scope(|scope| {
        scope.spawn(build);
        scope.spawn(build);
    });
    assert_eq!(translations(), 1, "two at once share one build");
    build();
    assert_eq!(translations(), 1, "the third finds it");
    let library = only_library_in(&cache);
    let bytes = fs::read(&library).unwrap();
    fs::remove_file(&library).unwrap(); // the threads above may still have it mapped
    fs::write(&library, &bytes[..bytes.len() / 2]).unwrap();
    build();
    assert_eq!(translations(), 2, "half a library is no library");
    let builder = Builder::with(toolchain.clone(), cache.clone());
    builder.build(&source(&FIFO.replace("17'd1", "17'd3")), BuildOptions::default()).unwrap();
    assert_eq!(translations(), 3, "other text, other build");
}

#[test]
fn tools_that_are_missing_or_old_are_named_with_the_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let error = Toolchain::with(&folder.path().join("verilator"), Path::new("g++")).unwrap_err();
    assert!(matches!(error, ToolchainError::Missing { .. }), "{error}");
    let old = folder.path().join("old");
    fs::write(&old, "#!/bin/sh\necho Verilator 4.038 2020-07-11\n").unwrap();
    fs::set_permissions(&old, fs::Permissions::from_mode(0o755)).unwrap();
    let text = Toolchain::with(&old, Path::new("g++")).unwrap_err().to_string();
    assert!(text.contains("4.038") && text.contains("5.006"), "{text}");
    assert!(text.contains("apt-get install verilator"), "{text}");
}

#[test]
fn a_design_that_is_not_clean_is_refused_with_the_message_of_verilator() {
    let builder = Builder::new().unwrap();
    for (from, to, expected) in [(" + 17'd1;", " +;", "fifo.v:25"), ("17'd1", "18'd1", "WIDTH")] {
        let error =
            builder.build(&source(&FIFO.replace(from, to)), BuildOptions::default()).err().expect("it is not clean");
        assert!(matches!(error, VerilatedError::Tool { .. }), "{error}");
        assert!(error.to_string().contains(expected), "{error}");
    }
}

#[test]
fn ports_that_cannot_be_exchanged_are_refused() {
    let builder = Builder::new().unwrap();
    let mut wide = source(FIFO);
    wide.ports.push(port("wide", 65, Direction::Output));
    let mut odd = source(FIFO);
    odd.ports.push(port("odd__name", 1, Direction::Output));
    assert!(matches!(builder.build(&wide, BuildOptions::default()), Err(VerilatedError::PortWidth { width: 65, .. })));
    assert!(matches!(builder.build(&odd, BuildOptions::default()), Err(VerilatedError::PortName { .. })));
}

#[test]
fn outputs_are_those_before_the_edge() {
    let library = library(FIFO);
    let mut model = library.instantiate(1);
    model.reset(2).unwrap();
    let mut outputs = [9; 4];
    let valid = |model: &mut VerilatedModel, outputs: &mut [u64], inputs: [u64; 5]| {
        model.step(&inputs, outputs).unwrap();
        (outputs[0], outputs[1], outputs[2])
    };
    assert_eq!(valid(&mut model, &mut outputs, [0, 1, 0xffff, 1, 0]).1, 0, "the item goes in at the edge");
    assert_eq!(valid(&mut model, &mut outputs, [0, 0, 0, 0, 1]), (1, 1, 0x1ffff), "and is at the front after it");
    assert_eq!(outputs[3], 1);
    assert_eq!(valid(&mut model, &mut outputs, [0, 0, 0, 0, 1]).1, 0, "it was taken");
}

#[test]
fn elaborated_designs_run() {
    let mut accumulator = Module::new("accumulator", "Sums its input.");
    let step = accumulator.input("step", 8);
    let sum = accumulator.reg_reset("sum", 40, 5);
    accumulator.next(sum, sum.expr() + step.zext(40));
    accumulator.output("total", sum.expr());
    let source = VerilogSource::from(&elaborate(&accumulator).unwrap());
    let mut model = Builder::new().unwrap().build(&source, BuildOptions::default()).unwrap().instantiate(1);
    model.reset(2).unwrap();
    let step = model.library().inputs().iter().position(|port| port.name == "step").expect("it was declared");
    let mut inputs = vec![0; model.library().inputs().len()];
    inputs[step] = 200;
    let totals = [5, 205, 405].map(|expected| {
        let mut outputs = [0];
        model.step(&inputs, &mut outputs).unwrap();
        (outputs[0], expected)
    });
    assert!(totals.iter().all(|(total, expected)| total == expected), "{totals:?}");
}

#[test]
fn instances_are_independent_and_can_change_threads() {
    let library = library(FIFO);
    let (mut fed, mut empty) = (library.instantiate(1), library.instantiate(1));
    let mut outputs = [0; 4];
    fed.reset(2).unwrap();
    empty.reset(2).unwrap();
    fed.step(&[0, 1, 5, 0, 0], &mut outputs).unwrap();
    let fed = std::thread::spawn(move || {
        let mut outputs = [0; 4];
        fed.step(&[0, 0, 0, 0, 0], &mut outputs).unwrap();
        outputs
    });
    assert_eq!(fed.join().unwrap()[1..3], [1, 11]);
    empty.step(&[0, 0, 0, 0, 0], &mut outputs).unwrap();
    assert_eq!(outputs[1], 0);
}

#[test]
fn what_nothing_initializes_follows_the_seed() {
    let library = library(FIFO);
    let before_reset = |seed| {
        let mut outputs = [0; 4];
        library.instantiate(seed).step(&[1, 0, 0, 0, 0], &mut outputs).unwrap();
        outputs
    };
    assert_eq!(before_reset(3), before_reset(3));
    let distinct: std::collections::HashSet<_> = (0..16).map(before_reset).collect();
    assert!(distinct.len() > 8, "{distinct:?}");
}

#[test]
fn the_bare_loop_leaves_the_model_where_single_steps_do() {
    let library = library(FIFO);
    let rows = [[0, 1, 7, 0, 0], [0, 1, 8, 1, 1], [0, 0, 0, 0, 0]];
    let (mut bare, mut stepped) = (library.instantiate(1), library.instantiate(1));
    let (mut after_bare, mut after_steps) = ([0; 4], [0; 4]);
    bare.reset(2).unwrap();
    stepped.reset(2).unwrap();
    bare.run_bare(rows.as_flattened(), 7).unwrap();
    rows.iter().cycle().take(7).for_each(|row| stepped.step(row, &mut after_steps).unwrap());
    bare.step(&[0; 5], &mut after_bare).unwrap();
    stepped.step(&[0; 5], &mut after_steps).unwrap();
    assert_eq!(after_bare, after_steps);
    assert_eq!(after_bare[1], 1, "the rows put in more than they take out");
}

#[test]
fn waveforms_are_written_on_demand_only() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fifo.fst");
    let plain = library(FIFO);
    assert!(matches!(plain.instantiate(1).open_trace(&path), Err(VerilatedError::Waveform { .. })));
    let traced = Builder::new()
        .unwrap()
        .build(&source(FIFO), BuildOptions { trace: Trace::On, ..BuildOptions::default() })
        .unwrap();
    let mut model = traced.instantiate(1);
    model.reset(2).unwrap();
    assert!(model.open_trace(Path::new("/nowhere/at/all.fst")).is_err());
    model.open_trace(&path).unwrap();
    model.reset(2).unwrap();
    drop(model);
    assert!(fs::metadata(&path).unwrap().len() > 0);
}
