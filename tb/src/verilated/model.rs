//! A loaded model and its instances.

use std::ffi::{CStr, CString, c_char, c_int};
use std::fs::File;
use std::path::Path;
use std::ptr::NonNull;
use std::sync::Arc;

use super::build::Builder;
use super::shim;
use super::{BuildOptions, Direction, Port, Trace, VerilatedError, VerilogSource};

/// Name of the synchronous reset, active high.
pub const RESET: &str = "rst";

/// The instance as the shim sees it.
#[repr(C)]
struct Instance {
    _private: [u8; 0],
}

type New = unsafe extern "C" fn(c_int) -> *mut Instance;
type Delete = unsafe extern "C" fn(*mut Instance);
type Report = unsafe extern "C" fn(*const Instance) -> *const c_char;
type Step = unsafe extern "C" fn(*mut Instance, *const u64, *mut u64) -> c_int;
type RunBare = unsafe extern "C" fn(*mut Instance, *const u64, usize, u64) -> c_int;
type OpenTrace = unsafe extern "C" fn(*mut Instance, *const c_char);
type CloseTrace = unsafe extern "C" fn(*mut Instance);

/// The shim's entry points; valid as long as the library is loaded.
struct EntryPoints {
    new: New,
    delete: Delete,
    report: Report,
    step: Step,
    run_bare: RunBare,
    open_trace: Option<OpenTrace>,
    close_trace: Option<CloseTrace>,
}

/// A compiled model: makes instances.
pub struct Library {
    entry_points: EntryPoints,
    source: VerilogSource,
    options: BuildOptions,
    builder: Arc<Builder>,
    inputs: Vec<Port>,
    outputs: Vec<Port>,
    key: String,
    _loaded: libloading::Library,
}

impl Library {
    pub(super) fn load(
        path: &Path,
        key: String,
        source: VerilogSource,
        options: BuildOptions,
        builder: Arc<Builder>,
    ) -> Result<Arc<Self>, VerilatedError> {
        let failed = |error| VerilatedError::Load { path: path.to_path_buf(), source: error };
        // SAFETY: the file is one that the builder wrote (its checksum was compared); its initializers only set up
        // Verilator's run-time. The types of the functions are those of the generated shim, whose text is part of the
        // cache key, and the pointers are kept no longer than the library.
        let (loaded, entry_points) = unsafe {
            let loaded = libloading::Library::new(path).map_err(failed)?;
            let entry_points = EntryPoints {
                new: *loaded.get(b"model_new").map_err(failed)?,
                delete: *loaded.get(b"model_delete").map_err(failed)?,
                report: *loaded.get(b"model_report").map_err(failed)?,
                step: *loaded.get(b"model_step").map_err(failed)?,
                run_bare: *loaded.get(b"model_run_bare").map_err(failed)?,
                open_trace: match options.trace {
                    Trace::On => Some(*loaded.get(b"model_open_trace").map_err(failed)?),
                    Trace::Off => None,
                },
                close_trace: match options.trace {
                    Trace::On => Some(*loaded.get(b"model_close_trace").map_err(failed)?),
                    Trace::Off => None,
                },
            };
            (loaded, entry_points)
        };
        let inputs = shim::ports(&source, Direction::Input);
        let outputs = shim::ports(&source, Direction::Output);
        Ok(Arc::new(Self { entry_points, source, options, builder, inputs, outputs, key, _loaded: loaded }))
    }

    /// A model in its initial state. What the design does not initialize is random, the same for the same `seed`.
    #[must_use]
    pub fn instantiate(self: &Arc<Self>, seed: u64) -> VerilatedModel {
        // Verilator takes 31 bits and understands 0 as "no seed".
        let seed = 1 + ((seed ^ (seed >> 32)) & 0x3fff_ffff) as c_int;
        // SAFETY: any seed is valid; the shim returns a new instance (or ends the program when memory is exhausted).
        let instance =
            NonNull::new(unsafe { (self.entry_points.new)(seed) }).expect("operator new does not return null");
        VerilatedModel { library: Arc::clone(self), instance }
    }

    /// The same design, built so that it can write waveforms.
    ///
    /// # Errors
    /// As [`Builder::build`].
    pub fn traced(&self) -> Result<Arc<Self>, VerilatedError> {
        self.builder.build(&self.source, BuildOptions { trace: Trace::On, ..self.options })
    }

    /// The design.
    #[must_use]
    pub fn source(&self) -> &VerilogSource {
        &self.source
    }

    /// Input ports without the clock: the order of `inputs` in [`VerilatedModel::step`].
    #[must_use]
    pub fn inputs(&self) -> &[Port] {
        &self.inputs
    }

    /// Output ports: the order of `outputs` in [`VerilatedModel::step`].
    #[must_use]
    pub fn outputs(&self) -> &[Port] {
        &self.outputs
    }

    /// Inputs of a reset cycle: `rst` high, everything else low.
    #[must_use]
    pub fn reset_inputs(&self) -> Vec<u64> {
        self.inputs.iter().map(|port| u64::from(port.name == RESET)).collect()
    }

    /// A short name for this very build, fit for file names.
    #[must_use]
    pub fn digest(&self) -> &str {
        &self.key[..8]
    }

    /// The folder that the builder keeps its results in.
    #[must_use]
    pub fn cache(&self) -> &Path {
        self.builder.cache()
    }
}

/// One running instance of the hardware.
pub struct VerilatedModel {
    library: Arc<Library>,
    instance: NonNull<Instance>,
}

// SAFETY: an instance owns all its state; Verilator's thread-local state is set anew in every call of the shim.
unsafe impl Send for VerilatedModel {}

impl VerilatedModel {
    /// What this is an instance of.
    #[must_use]
    pub fn library(&self) -> &Arc<Library> {
        &self.library
    }

    /// One cycle: applies `inputs`, samples `outputs` before the rising edge, then lets the edge happen.
    /// Bits above a port's width are ignored.
    ///
    /// # Errors
    /// When an assertion of the hardware fails.
    ///
    /// # Panics
    /// When the arrays are not as long as the library has ports.
    pub fn step(&mut self, inputs: &[u64], outputs: &mut [u64]) -> Result<(), VerilatedError> {
        assert_eq!(inputs.len(), self.library.inputs.len(), "one word an input port");
        assert_eq!(outputs.len(), self.library.outputs.len(), "one word an output port");
        // SAFETY: the instance is alive and borrowed mutably, the arrays are as long as the shim expects.
        let stopped =
            unsafe { (self.library.entry_points.step)(self.instance.as_ptr(), inputs.as_ptr(), outputs.as_mut_ptr()) };
        self.outcome(stopped)
    }

    /// Clocks the model through `rows` of inputs, again and again, in one loop in C++ that looks at no output:
    /// what any testbench's speed is to be compared with.
    ///
    /// # Errors
    /// When an assertion of the hardware fails.
    ///
    /// # Panics
    /// When `rows` is not one or more whole rows of inputs.
    pub fn run_bare(&mut self, rows: &[u64], cycles: u64) -> Result<(), VerilatedError> {
        let width = self.library.inputs.len().max(1);
        assert!(!rows.is_empty() && rows.len().is_multiple_of(width), "whole rows of {width} words");
        // SAFETY: the instance is alive and borrowed mutably, `rows` holds as many rows as said.
        let stopped = unsafe {
            let run = self.library.entry_points.run_bare;
            run(self.instance.as_ptr(), rows.as_ptr(), rows.len() / width, cycles)
        };
        self.outcome(stopped)
    }

    /// Holds `rst` for `cycles` with all other inputs at zero.
    ///
    /// # Errors
    /// When an assertion of the hardware fails.
    pub fn reset(&mut self, cycles: u64) -> Result<(), VerilatedError> {
        let inputs = self.library.reset_inputs();
        let mut outputs = vec![0; self.library.outputs.len()];
        (0..cycles).try_for_each(|_| self.step(&inputs, &mut outputs))
    }

    /// Writes all signals to the FST file `path` from the next cycle until [`VerilatedModel::close_trace`], or until the model is dropped.
    ///
    /// # Errors
    /// When the library was built without [`Trace::On`], or the file cannot be created.
    pub fn open_trace(&mut self, path: &Path) -> Result<(), VerilatedError> {
        let failed = |reason| VerilatedError::Waveform { path: path.to_path_buf(), reason };
        let open = self.library.entry_points.open_trace.ok_or(failed("the model was built without waveforms"))?;
        let name = CString::new(path.as_os_str().as_encoded_bytes()).map_err(|_| failed("the name contains a zero"))?;
        // The run-time does not survive a file that it cannot create.
        File::create(path).map_err(|_| failed("the file cannot be created"))?;
        // SAFETY: the instance is alive and borrowed mutably; the shim copies the name.
        unsafe { open(self.instance.as_ptr(), name.as_ptr()) };
        Ok(())
    }

    /// Ends a waveform, if one is being written.
    pub fn close_trace(&mut self) {
        if let Some(close) = self.library.entry_points.close_trace {
            // SAFETY: the instance is alive and borrowed mutably; a file that is not open stays so.
            unsafe { close(self.instance.as_ptr()) };
        }
    }

    fn outcome(&self, stopped: c_int) -> Result<(), VerilatedError> {
        if stopped == 0 {
            return Ok(());
        }
        // SAFETY: the text belongs to the live instance and is copied before anything else can change it.
        let text = unsafe { CStr::from_ptr((self.library.entry_points.report)(self.instance.as_ptr())) };
        Err(VerilatedError::Stopped(text.to_string_lossy().trim_end().to_owned()))
    }
}

impl Drop for VerilatedModel {
    fn drop(&mut self) {
        // SAFETY: the instance was made by this library, which is still loaded, and is not used again.
        unsafe { (self.library.entry_points.delete)(self.instance.as_ptr()) };
    }
}
