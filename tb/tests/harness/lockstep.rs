//! Lockstep: what it passes, and every kind of failure it must find.

use std::fs;

use pointcore_tb::lockstep::{
    Cause, Flow, FourStateError, Lockstep, LockstepError, LockstepFailure, PortDifference, ProtocolViolation, Recorded,
    Run, Stall, StreamTestbench, TestbenchError, Waveform, inject, seed, seeds,
};
use pointcore_tb::verilated::Direction;

use super::{FIFO, golden, library};

/// The items that go through the queue.
fn items() -> Vec<Vec<u64>> {
    (0..500).map(|n| vec![n * 7919 % 0x1_0000, n % 2]).collect()
}

fn run(verilog: &str, seed: u64, stall: Stall) -> Result<Run<StreamTestbench>, LockstepError> {
    let library = library(verilog);
    let testbench = StreamTestbench::new(&library, seed).source("in", items(), stall)?.sink("out", stall)?;
    Lockstep::new(&library, golden(), seed).run(testbench)
}

/// The failure of a run that must not succeed.
fn failure(outcome: Result<Run<impl Sized>, LockstepError>) -> LockstepFailure {
    match outcome {
        Err(LockstepError::Failed(failure)) => *failure,
        Err(other) => panic!("another error: {other}"),
        Ok(_) => panic!("the fault was not found"),
    }
}

#[test]
fn the_queue_agrees_with_its_model_under_every_stall_pattern() {
    let expected: Vec<_> = items().iter().map(|item| vec![2 * item[0] + 1, item[1]]).collect();
    for seed in seeds(5).unwrap() {
        for stall in [Stall::Never, Stall::Random(0.5), Stall::Bursts(20)] {
            let run = run(FIFO, seed, stall).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(run.stimulus.collected("out"), expected, "seed {seed}, {stall:?}");
            assert_eq!((run.report.transfers("in"), run.report.transfers("out")), (500, 500));
        }
    }
}

#[test]
fn an_injected_fault_is_located_and_recorded() {
    let broken = inject(FIFO, "out_value = front", "+", "-").unwrap();
    let seed = seed().unwrap();
    let failure = failure(run(&broken, seed, Stall::Random(0.3)));
    let Cause::Mismatch(differences) = &failure.cause else { panic!("{failure}") };
    let [PortDifference { port, hardware, golden }] = differences.as_slice() else { panic!("{failure}") };
    assert_eq!((port.as_str(), *hardware, *golden), ("out_value", 0x1_ffff, 1), "the first item is 0");
    assert!(failure.cycle >= 1, "nothing comes out in cycle 0");
    assert_eq!(failure.inputs[0], ("rst".to_owned(), 0));
    let Waveform::Written(path) = &failure.waveform else { panic!("{failure}") };
    assert!(fs::metadata(path).unwrap().len() > 0);
    let text = failure.to_string();
    for part in
        ["cycle", "hardware 0x1ffff, model 0x1", "in_valid=", ".fst", "cargo test -p pointcore-tb --test units harness"]
    {
        assert!(text.contains(part), "`{part}` is missing in: {text}");
    }
    assert!(text.contains(&format!("POINTCORE_SEED={seed} ")), "{text}");
}

#[test]
fn faults_in_control_are_found_too() {
    let faults = [
        ("in_ready = count", "3'd4", "3'd3"),
        ("if (take) head", "2'd1", "2'd2"),
        ("count <= count + ", "- {2'd0, take}", "- {2'd0, take & ~put}"),
    ];
    for (line, from, to) in faults {
        let failure = failure(run(&inject(FIFO, line, from, to).unwrap(), 1, Stall::Random(0.3)));
        assert!(matches!(failure.cause, Cause::Mismatch(_)), "{failure}");
    }
}

#[test]
fn what_a_reset_leaves_is_found() {
    // The first value is right, so that only a reset in the middle of a run tells.
    let right_at_first = inject(FIFO, "reg [1:0] head", "head", "head = 2'd0").unwrap();
    let broken = inject(&right_at_first, "head <= 2'd0", "head <= 2'd0;", "").unwrap();
    let failure = failure(run(&broken, seed().unwrap(), Stall::Random(0.3)));
    assert!(matches!(failure.cause, Cause::Mismatch(_)), "{failure}");
    assert!(matches!(failure.waveform, Waveform::Written(_)), "{failure}");
}

#[test]
fn what_nothing_sets_is_found_in_four_states() {
    let whole = library(FIFO);
    let testbench = StreamTestbench::new(&whole, 1).source("in", items(), Stall::Random(0.3)).unwrap();
    let recorded = Recorded::new(testbench.sink("out", Stall::Random(0.3)).unwrap());
    let empty = recorded.replay(&whole).unwrap_err();
    assert!(matches!(empty, FourStateError::Empty { .. }), "{empty}");
    let Run { stimulus, .. } = Lockstep::new(&whole, golden(), 1).run(recorded).unwrap();
    stimulus.replay(&whole).unwrap_or_else(|error| panic!("{error}"));
    let cases = [
        ("head <= 2'd0", "head <= 2'd0;", "", "`out_value` is xxxxxxxxxxxxxxxxx"),
        ("out_value = front", "+", "-", "`out_value` is 11111111111111111 and should be 00000000000000001"),
    ];
    for (line, from, to, difference) in cases {
        let error = stimulus.replay(&library(&inject(FIFO, line, from, to).unwrap())).unwrap_err().to_string();
        assert!(error.contains(difference), "`{difference}` is missing in: {error}");
    }
}

#[test]
fn a_stream_that_breaks_its_promise_is_found() {
    // The model follows the hardware, so that only the protocol can object.
    let library = library(&FIFO.replace("out_valid = count != 3'd0", "out_valid = count != 3'd0 & ~in_valid"));
    let copy = library.clone();
    let mut twin = copy.instantiate(1);
    let golden = move |inputs: &[u64], outputs: &mut [u64]| twin.step(inputs, outputs).unwrap();
    let testbench = StreamTestbench::new(&library, 1).source("in", items(), Stall::Random(0.5)).unwrap();
    let testbench = testbench.sink("out", Stall::Random(0.5)).unwrap();
    let failure = failure(Lockstep::new(&library, golden, 1).run(testbench));
    let Cause::Protocol(violation) = &failure.cause else { panic!("{failure}") };
    assert_eq!(violation, &ProtocolViolation::Withdrawn { stream: "out".to_owned() });
}

#[test]
fn a_stimulus_that_breaks_its_promise_is_found() {
    let library = library(FIFO);
    let impatient = |cycle: u64, _: &[u64], inputs: &mut [u64]| {
        inputs.copy_from_slice(&[0, 1, cycle, 0, 0]);
        Flow::Continue
    };
    let failure = failure(Lockstep::new(&library, golden(), 1).run(impatient));
    assert_eq!(failure.cycle, 5, "the queue is full in cycle 4: {failure}");
    assert!(
        matches!(&failure.cause, Cause::Protocol(ProtocolViolation::Changed { stream }) if stream == "in"),
        "{failure}"
    );
}

#[test]
fn an_assertion_of_the_hardware_ends_the_run() {
    let broken = inject(FIFO, "!rst && count", ">", "==").unwrap();
    let failure = failure(run(&broken, 1, Stall::Bursts(20)));
    let Cause::Stopped(text) = &failure.cause else { panic!("{failure}") };
    assert!(text.contains("assertion count_in_range failed") && text.contains("fifo.v:"), "{text}");
    assert!(matches!(failure.waveform, Waveform::Written(_)), "{failure}");
}

#[test]
fn a_run_without_transaction_fails() {
    let library = library(FIFO);
    let nothing = StreamTestbench::new(&library, 1).source("in", Vec::new(), Stall::Never).unwrap();
    let error = Lockstep::new(&library, golden(), 1).run(nothing).map(|_| ()).expect_err("nothing was tested");
    assert!(matches!(error, LockstepError::NoTransaction { .. }), "{error}");
    let no_sink = StreamTestbench::new(&library, 1).source("in", items()[..3].to_vec(), Stall::Never).unwrap();
    let error = Lockstep::new(&library, golden(), 1).run(no_sink).map(|_| ()).expect_err("nothing came out");
    assert!(matches!(error, LockstepError::NoTransaction { .. }), "{error}");
}

#[test]
fn a_run_that_never_ends_fails() {
    let library = library(FIFO);
    let no_sink = StreamTestbench::new(&library, 1).source("in", items(), Stall::Never).unwrap();
    let failure = failure(Lockstep::new(&library, golden(), 1).limit(1000).run(no_sink));
    assert!(matches!(failure.cause, Cause::Unfinished), "{failure}");
    assert!(matches!(failure.waveform, Waveform::Written(_)), "{failure}");
}

#[test]
fn a_mask_leaves_open_what_it_names_and_nothing_else() {
    let library = library(&inject(FIFO, "out_last = front", "front", "~front").unwrap());
    let testbench = || {
        let testbench = StreamTestbench::new(&library, 1).source("in", items(), Stall::Never)?;
        testbench.sink("out", Stall::Never)
    };
    assert!(Lockstep::new(&library, golden(), 1).run(testbench().unwrap()).is_err());
    let run = Lockstep::new(&library, golden(), 1).mask(|hardware, golden| (hardware[3], golden[3]) = (0, 0));
    assert_eq!(run.run(testbench().unwrap()).unwrap().report.transfers("out"), 500);
}

#[test]
fn a_testbench_that_does_not_fit_is_refused() {
    let library = library(FIFO);
    let testbench = || StreamTestbench::new(&library, 1);
    let wrong_way = testbench().source("out", Vec::new(), Stall::Never).unwrap_err();
    assert!(matches!(wrong_way, TestbenchError::NoStream { direction: Direction::Input, .. }));
    let short = testbench().source("in", vec![vec![1]], Stall::Never).unwrap_err();
    assert!(matches!(short, TestbenchError::Fields { found: 1, fields: 2, .. }));
    let wide = testbench().source("in", vec![vec![0x1_0000, 0]], Stall::Never).unwrap_err();
    assert!(matches!(wide, TestbenchError::TooWide { value: 0x1_0000, .. }));
    assert!(matches!(testbench().constant("threshold", 0).unwrap_err(), TestbenchError::NoInput { .. }));
}
