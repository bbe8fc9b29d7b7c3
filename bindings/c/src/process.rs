//! Programs on neighborhoods.

use crate::arguments::{array, borrowed, drop_handle, hand_over, place, required_text, text};
use crate::processed::Processed;
use crate::status::{Status, call, engine};
use pointcore_bindings::{BindingError, Named, Points, ProcessSettings, ProgramSource};
use std::ffi::c_char;

/// A program, and what carries it out.
pub struct Process(pointcore_bindings::Process);

/// Numbers that have a name: an attribute of points, or a setting.
#[repr(C)]
pub struct NamedNumbers {
    /// The name.
    pub name: *const c_char,
    /// `components * count` numbers.
    pub values: *const f64,
    /// 1, or 3 of a vector.
    pub components: usize,
    /// One for each point, or 1: the same for all. 1 of a setting.
    pub count: usize,
}

/// Points with their attributes, which are copied.
#[repr(C)]
pub struct Cloud {
    /// Where they are: three numbers each.
    pub points: *const f64,
    /// How many there are.
    pub count: usize,
    /// What is known of each: `attributes_count` attributes. Normals, areas and masses that are missing are estimated.
    pub attributes: *const NamedNumbers,
    /// How many attributes there are.
    pub attributes_count: usize,
}

/// What is asked of a program.
#[repr(C)]
pub struct ProcessOptions {
    /// Neighbors of a query at most, 1 to 64, itself among them.
    pub k: u32,
    /// Only neighbors nearer than this count; INFINITY for all.
    pub radius: f64,
    /// Iterations of a query at most, 1 to 65535; one that is not done by then is capped.
    pub iterations: u32,
    /// How often the points are replaced by what leaves, 1 at least.
    pub passes: u32,
    /// Columns and rows of queries around each point, for "resample"; 0 and 0 for the usual ones.
    pub pattern: [u32; 2],
    /// Settings, `settings_count`; those that are not given follow from the points.
    pub settings: *const NamedNumbers,
    /// How many settings there are.
    pub settings_count: usize,
}

/// Copies what has names.
///
/// # Safety
/// `numbers` holds `count` structures whose pointers hold what they say.
unsafe fn named(what: &str, numbers: *const NamedNumbers, count: usize) -> Result<Vec<Named>, BindingError> {
    // SAFETY: as the caller says.
    let numbers: &[NamedNumbers] = unsafe { array(what, numbers, count)? };
    let copied = |given: &NamedNumbers| {
        // SAFETY: as the caller says.
        let name = unsafe { required_text("name", given.name)? };
        let shape = match given.components {
            1 => vec![given.count],
            3 => vec![given.count, 3],
            other => return Err(BindingError::input(format!("`{name}` has {other} components: expected 1 or 3"))),
        };
        let length = given.components.checked_mul(given.count);
        let length = length.ok_or_else(|| BindingError::input(format!("`{name}` has too many numbers")))?;
        // SAFETY: as the caller says.
        let values: &[f64] = unsafe { array("values", given.values, length)? };
        Ok(Named { name: name.to_owned(), values: values.to_vec(), shape })
    };
    numbers.iter().map(copied).collect()
}

impl Cloud {
    /// # Safety
    /// Pointers are NULL or hold as many numbers as the counts say.
    unsafe fn points(&self) -> Result<Points, BindingError> {
        // SAFETY: as the caller says.
        let (places, attributes): (&[[f64; 3]], _) = unsafe {
            (array("points", self.points, self.count)?, named("attributes", self.attributes, self.attributes_count)?)
        };
        Ok(Points { places: places.to_vec(), attributes })
    }
}

impl ProcessOptions {
    /// # Safety
    /// The settings are as many as is said.
    unsafe fn settings(&self) -> Result<ProcessSettings, BindingError> {
        Ok(ProcessSettings {
            k: Some(self.k),
            radius: (self.radius != f64::INFINITY).then_some(self.radius),
            iterations: self.iterations,
            passes: self.passes,
            pattern: (self.pattern != [0, 0]).then_some(self.pattern),
            // SAFETY: as the caller says.
            settings: unsafe { named("settings", self.settings, self.settings_count)? },
        })
    }
}

/// Reads a program: the name of an operation, such as "normals", or of one of its programs, the path of a `.pasm` file,
/// or a text of several lines (docs/programs.md).
///
/// `configuration` is the point processor's, as TOML, or NULL for one that follows from the points; `back_end` is one of
/// `PointcoreBackEnd`. The hardware is generated when it is first used. `pointcore_process_close` ends it.
///
/// # Safety
/// `program` is a C string, `configuration` NULL or one, `process` a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_process_open(
    program: *const c_char,
    configuration: *const c_char,
    back_end: u32,
    process: *mut *mut Process,
) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (program, configuration, process) = unsafe {
            (required_text("program", program)?, text("configuration", configuration)?, place("process", process)?)
        };
        let program = ProgramSource::Said(program);
        hand_over(Process(pointcore_bindings::Process::open(program, configuration, engine(back_end)?)?), process);
        Ok(())
    })
}

/// Carries a program out for each point, or for each of some queries instead (NULL for none). Options may be NULL: 16
/// neighbors, 16 iterations, one pass. `pointcore_processed_close` ends what is given.
///
/// # Safety
/// `process` is open, `points`, `queries` and `options` are structures whose pointers hold what they say, the latter two
/// or NULL, `processed` is a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_process(
    process: *const Process,
    points: *const Cloud,
    queries: *const Cloud,
    options: *const ProcessOptions,
    processed: *mut *mut Processed,
) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (Process(process), points, queries, options, place) = unsafe {
            (
                borrowed("process", process)?,
                borrowed("points", points)?.points()?,
                queries.as_ref().map(|queries| queries.points()).transpose()?,
                options.as_ref().map(|options| options.settings()).transpose()?,
                place("processed", processed)?,
            )
        };
        hand_over(process.run(&points, queries.as_ref(), &options.unwrap_or_default())?.into(), place);
        Ok(())
    })
}

/// Ends a program; NULL is none. What left stays.
///
/// # Safety
/// `process` is NULL or open, and no thread uses it any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_process_close(process: *mut Process) {
    // SAFETY: as the caller says.
    unsafe { drop_handle(process) };
}
