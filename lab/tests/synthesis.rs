//! From a unit to its area through the real tools.

use pointcore_lab::synthesis::{Measurement, State, Step, SynthesisError, Synthesizer, Target, all};
use pointcore_tb::skipped::skipped;
use std::sync::Mutex;

/// What a target says of a unit; none, visibly, where its tools are not installed.
fn measure(target: Target, name: &str) -> Option<Measurement> {
    let synthesizer = match Synthesizer::new(target) {
        Ok(synthesizer) => synthesizer,
        Err(error @ SynthesisError::Missing { .. }) => {
            skipped(&error.to_string());
            return None;
        }
        Err(error) => panic!("{error}"),
    };
    let unit = all().into_iter().find(|unit| unit.name == name).expect("the test names a unit that is known");
    let steps = Mutex::new(0);
    let done = |step: &Step<'_>| {
        if step.state == State::Done {
            *steps.lock().expect("no step panics") += 1;
        }
    };
    let measured = synthesizer.measure(&unit, 1..=1, &done);
    let measured = measured.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(*steps.lock().expect("no step panics"), 1, "synthesis only");
    Some(measured)
}

#[test]
fn a_comparison_becomes_gates_and_its_result_registers() {
    let Some(measured) = measure(Target::Gates, "bf16_lt") else { return };
    // At least one gate for each of the 32 bits that are compared, and the result's register.
    assert!((31..400).contains(&measured.area.gate), "{:?}", measured.area);
    assert!((1..40).contains(&measured.area.flip_flop), "{:?}", measured.area);
    assert_eq!((measured.area.memory_bits, measured.timing), (0, None), "no memory, and nothing is placed");
}

#[test]
fn a_small_product_takes_one_multiplier() {
    let Some(measured) = measure(Target::Xilinx7, "bf16_ftz_mul") else { return };
    assert_eq!((measured.area.dsp, measured.area.block_ram), (1, 0), "{:?}", measured.area);
    assert!((1..200).contains(&measured.area.lut), "{:?}", measured.area);
}
