//! A fault planted in one unit of a renderer, as the harness reports it.

use pointcore::splat::{SplatCore, SplatRunner};
use pointcore_tb::lockstep::{Cause, LockstepError, Stall, Waveform, inject, seed};
use pointcore_tb::verilated::VerilogSource;

use crate::splat::{configs, scene};
use crate::support;

/// Splats and ends of several frames.
const RECORDS: usize = 400;

#[test]
fn a_fault_in_a_unit_is_reported_with_cycle_and_port() {
    let [config, ..] = configs();
    let core = SplatCore::generate(&config).unwrap_or_else(|error| panic!("{error}"));
    let mut source = VerilogSource::from(&core.design);
    source.verilog = inject(&source.verilog, "depth_sum_4 <= stored", "+", "-").unwrap();
    let broken = support::build(&source);
    let frame = scene::frames(&config, RECORDS);
    let runner = SplatRunner { stall: Stall::Random(0.2), seed: seed().unwrap(), ..SplatRunner::new(&config, &frame) };
    let outcome = runner.lockstep(&core, &broken);
    let Err(LockstepError::Failed(failure)) = outcome else { panic!("the accumulator subtracts depths unnoticed") };
    let Cause::Mismatch(differences) = &failure.cause else { panic!("{failure}") };
    assert!(differences.iter().all(|difference| difference.hardware != difference.golden));
    let ports: Vec<&str> = differences.iter().map(|difference| difference.port.as_str()).collect();
    assert!(ports.iter().any(|port| ["write_depth", "fragment_depth"].contains(port)), "{failure}");
    assert!(failure.cycle > 100, "samples need as long to be accumulated: {failure}");
    assert!(matches!(failure.waveform, Waveform::Written(_)), "the replay shows the same failure: {failure}");
    let text = failure.to_string();
    assert!(text.contains(&format!("cycle {}", failure.cycle)) && text.contains(ports[0]), "{text}");
}
