//! What leaves programs.

use crate::arguments::{borrowed, copy, drop_handle, required_text};
use crate::status::c_text;
use pointcore_bindings::{Output, Results, Values};
use std::ffi::{CString, c_char};
use std::ptr;

/// What left with queries.
pub struct Processed {
    results: Results,
    outputs: Vec<Numbers>,
    flags: Flags,
    report: CString,
}

/// An output as C sees it.
struct Numbers {
    name: CString,
    values: Vec<f64>,
}

/// Truth values as C sees them.
struct Flags {
    capped: Vec<u8>,
    valid: Option<Vec<u8>>,
}

/// The arrays of what left with queries, in their order, valid until it is closed.
#[repr(C)]
pub struct ProcessedArrays {
    /// How many queries there were.
    pub count: usize,
    /// Where they lie in the end, three numbers each: the output `position`, or where they began without it.
    pub positions: *const f64,
    /// Iterations of each.
    pub iterations: *const u32,
    /// Neighbors of each in its last iteration; NULL of a point processor, which does not tell.
    pub neighbors: *const u32,
    /// 1 for a query that was not done, but had no iteration left, 0 for others.
    pub capped: *const u8,
    /// The output `valid`: 0 where there is no surface, say; NULL of a program without it.
    pub valid: *const u8,
    /// Cycles from the first query to the last result, of all programs and passes; 0 of the interpreter.
    pub cycles: u64,
    /// The report's figures, a JSON object.
    pub report: *const c_char,
}

/// Those of nothing.
const NO_ARRAYS: ProcessedArrays = ProcessedArrays {
    count: 0,
    positions: ptr::null(),
    iterations: ptr::null(),
    neighbors: ptr::null(),
    capped: ptr::null(),
    valid: ptr::null(),
    cycles: 0,
    report: ptr::null(),
};

impl From<Results> for Processed {
    fn from(results: Results) -> Self {
        let bytes = |flags: &[bool]| flags.iter().copied().map(u8::from).collect();
        let valid = results.output("valid").and_then(|output| match &output.numbers {
            Values::Bool(flags) => Some(bytes(flags)),
            _ => None,
        });
        let numbers = |output: &Output| Numbers { name: c_text(&output.name), values: output.numbers.doubles() };
        let flags = Flags { capped: bytes(&results.capped), valid };
        Self { outputs: results.outputs.iter().map(numbers).collect(), flags, report: c_text(&results.report), results }
    }
}

/// What left under a name, `components` numbers for each query, in their order: ints and truth values, too, all exact;
/// NULL if there is no output of the name. Valid until what left is closed. `components` may be NULL.
///
/// # Safety
/// `processed` is open, `name` a C string, `components` NULL or a place for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_processed_output(
    processed: *const Processed,
    name: *const c_char,
    components: *mut usize,
) -> *const f64 {
    // SAFETY: as the caller says.
    let (Ok(processed), Ok(name)) = (unsafe { (borrowed("processed", processed), required_text("name", name)) }) else {
        return ptr::null();
    };
    let place = processed.results.outputs.iter().position(|output| output.name == name);
    let Some(place) = place else { return ptr::null() };
    // SAFETY: as the caller says.
    unsafe { copy(&[processed.results.outputs[place].components], components) };
    processed.outputs[place].values.as_ptr()
}

/// The name of the program's output of this number, which counts from 0; NULL if there are not as many. Valid until
/// what left is closed.
///
/// # Safety
/// `processed` is NULL or open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_processed_name(processed: *const Processed, index: usize) -> *const c_char {
    // SAFETY: as the caller says.
    let output = unsafe { processed.as_ref() }.and_then(|processed| processed.outputs.get(index));
    output.map_or(ptr::null(), |output| output.name.as_ptr())
}

/// The arrays of what left; all NULL and 0 for NULL.
///
/// # Safety
/// `processed` is NULL or open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_processed_arrays(processed: *const Processed) -> ProcessedArrays {
    // SAFETY: as the caller says.
    let Some(Processed { results, flags, report, .. }) = (unsafe { processed.as_ref() }) else { return NO_ARRAYS };
    ProcessedArrays {
        count: results.positions.len(),
        positions: results.positions.as_ptr().cast(),
        iterations: results.iterations.as_ptr(),
        neighbors: results.neighbors.as_ref().map_or(ptr::null(), |counts| counts.as_ptr()),
        capped: flags.capped.as_ptr(),
        valid: flags.valid.as_ref().map_or(ptr::null(), |flags| flags.as_ptr()),
        cycles: results.cycles.unwrap_or_default(),
        report: report.as_ptr(),
    }
}

/// Ends what left; NULL is none.
///
/// # Safety
/// `processed` is NULL or open, and no thread uses it or its arrays any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_processed_close(processed: *mut Processed) {
    // SAFETY: as the caller says.
    unsafe { drop_handle(processed) };
}
