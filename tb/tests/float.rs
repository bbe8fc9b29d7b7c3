//! Floating-point operators of every format, hardware against golden model.

use pointcore_contract::Format;
use pointcore_lab::float_check::{Enable, Stages, check_format};
use pointcore_tb::lockstep::{SEED_VARIABLE, seed};

/// Operand triples for the formats in their own right.
const CASES: u64 = 1_050_000;
/// For their flushing variants and other choices.
const FEWER_CASES: u64 = 200_000;

fn agree(format: Format, stages: Stages, enable: Enable, cases: u64) {
    let seed = seed().expect("POINTCORE_SEED is a number");
    let reports = check_format(format, stages, enable, cases, seed).expect("the operators build and run");
    assert!(!reports.is_empty() && reports.iter().all(|report| report.cases >= cases), "too few cases: {reports:?}");
    let differing: Vec<String> =
        reports.iter().filter(|report| report.mismatches > 0).map(ToString::to_string).collect();
    assert!(
        differing.is_empty(),
        "{format}: {}\nreproduce: {SEED_VARIABLE}={seed} cargo test -p pointcore-tb --test units float",
        differing.join("\n")
    );
}

#[test]
fn f32_operators_agree() {
    agree(Format::F32, Stages::Default, Enable::Always, CASES);
}

#[test]
fn f24_operators_agree() {
    agree(Format::F24, Stages::Default, Enable::Always, CASES);
}

#[test]
fn f16_operators_agree() {
    agree(Format::F16, Stages::Default, Enable::Always, CASES);
}

#[test]
fn bf16_operators_agree() {
    agree(Format::BF16, Stages::Default, Enable::Always, CASES);
}

#[test]
fn f32_flushing_operators_agree() {
    agree(Format::F32.flushed(), Stages::Default, Enable::Random, FEWER_CASES);
}

#[test]
fn f24_flushing_operators_agree() {
    agree(Format::F24.flushed(), Stages::Default, Enable::Random, FEWER_CASES);
}

#[test]
fn f16_flushing_operators_agree() {
    agree(Format::F16.flushed(), Stages::Default, Enable::Random, FEWER_CASES);
}

#[test]
fn operators_hold_while_disabled() {
    for format in [Format::F32, Format::F24, Format::F16, Format::BF16] {
        agree(format, Stages::Default, Enable::Random, FEWER_CASES);
    }
}

#[test]
fn operators_agree_at_other_latencies() {
    agree(Format::F16, Stages::Fixed(3), Enable::Random, FEWER_CASES);
}
