//! All vectors of an independent generator: operands, result and exception flags in hex, one case a line. Flags are
//! ignored, NaNs compare as the canonical one.

use crate::skipped::skipped;
use crate::support::{Tally, canonical};
use flate2::read::GzDecoder;
use pointcore_contract::{Fixed, Format, Signedness};
use pointcore_golden::float;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/vectors");

type Model = fn(&[u64]) -> u64;

const F: Format = Format::F32;
const I32: Fixed = Fixed { width: 32, fraction: 0, signed: Signedness::Signed };
const U32: Fixed = Fixed { width: 32, fraction: 0, signed: Signedness::Unsigned };

/// What the generator returns where it signals an invalid operation; IEEE 754 leaves the value open.
const INVALID_INTEGER: u64 = 0x8000_0000;

/// File, operator, format of a floating-point result, model.
const SETS: [(&str, &str, Option<Format>, Model); 14] = [
    ("f32_add", "add", Some(F), |x| float::add(F, x[0], x[1])),
    ("f32_sub", "sub", Some(F), |x| float::sub(F, x[0], x[1])),
    ("f32_mul", "mul", Some(F), |x| float::mul(F, x[0], x[1])),
    ("f32_div", "div", Some(F), |x| float::div(F, x[0], x[1])),
    ("f32_mulAdd", "fma", Some(F), |x| float::fma(F, x[0], x[1], x[2])),
    ("f32_sqrt", "sqrt", Some(F), |x| float::sqrt(F, x[0])),
    ("f32_lt", "lt", None, |x| float::lt(F, x[0], x[1]).into()),
    ("f32_le", "le", None, |x| float::le(F, x[0], x[1]).into()),
    ("f32_eq", "eq", None, |x| float::eq(F, x[0], x[1]).into()),
    ("f32_to_f16", "to_f16", Some(Format::F16), |x| float::convert(F, Format::F16, x[0])),
    ("f16_to_f32", "to_f32", Some(F), |x| float::convert(Format::F16, F, x[0])),
    ("f32_to_i32_rminMag", "to_i32", None, |x| float::to_fixed_checked(F, x[0], I32).unwrap_or(INVALID_INTEGER)),
    ("i32_to_f32", "from_i32", Some(F), |x| float::from_fixed(F, x[0], I32)),
    ("ui32_to_f32", "from_u32", Some(F), |x| float::from_fixed(F, x[0], U32)),
];

fn cases(file: &str) -> impl Iterator<Item = Vec<u64>> {
    let path = PathBuf::from(FOLDER).join(format!("{file}.txt.gz"));
    let archive = File::open(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    BufReader::new(GzDecoder::new(archive)).lines().map(move |line| {
        let line = line.unwrap_or_else(|error| panic!("{file}: {error}"));
        let hex = |field| u64::from_str_radix(field, 16).unwrap_or_else(|error| panic!("{file}, `{line}`: {error}"));
        line.split_whitespace().map(hex).collect()
    })
}

#[test]
fn vectors_of_an_independent_generator() {
    if !PathBuf::from(FOLDER).is_dir() {
        return skipped(&format!("there is no folder {FOLDER}"));
    }
    for (file, operator, format, model) in SETS {
        let mut tally = Tally::new(&format!("vectors.{operator}"), F);
        for fields in cases(file) {
            let [operands @ .., expected, _flags] = fields.as_slice() else { panic!("{file}: {fields:x?} is short") };
            let expected = format.map_or(*expected, |format| canonical(format, *expected));
            tally.check(operands, model(operands), expected);
        }
        tally.finish();
    }
}
