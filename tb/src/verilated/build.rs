//! From Verilog to a shared object: `verilator --cc`, then g++ over as few units as fill the machine.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

use super::model::Library;
use super::shim::{self, MODEL_CLASS};
use super::substitute;
use super::{BuildOptions, Optimization, Trace, VerilatedError, VerilogSource};
use crate::cache::{Cache, file, key};
use crate::toolchain::Toolchain;

/// C++ beyond this many bytes is compiled in several units at once, for who waits for a model; below, reading the headers
/// again costs more.
const UNIT_BYTES: u64 = 200_000;
/// As many for tests, of which others fill the machine meanwhile.
const QUICK_UNIT_BYTES: u64 = 1_000_000;

/// Arguments of every translation. One file holds all modules, so it cannot be named for each (`DECLFILENAME`); values
/// that the Verilog leaves open are randomised, so that a design depending on them shows.
const VERILATOR_ARGUMENTS: &[&str] = &[
    "--cc",
    "-Wall",
    "-Wno-DECLFILENAME",
    "-O3",
    "--x-assign",
    "unique",
    "--x-initial",
    "unique",
    "--output-split",
    "20000",
    "--prefix",
    MODEL_CLASS,
    "--Mdir",
    "model",
    "-DRTL_ASSERT",
];

/// Arguments of every compilation. Each library keeps its own copy of the run-time (no symbols shared between libraries).
const COMPILER_ARGUMENTS: &[&str] = &["-std=c++17", "-fPIC", "-fvisibility=hidden", "-fno-gnu-unique"];

/// The unit of code that runs once; optimizing it would take longer than running it.
const START_UP: &str = "start_up";

/// File name of a finished model.
const LIBRARY: &str = "model.so";

const RUNTIME_HEADER: &str = include_str!("runtime.h");
const RUNTIME_SOURCE: &str = include_str!("runtime.cpp");

/// The tools and the cache that models are built with.
#[derive(Debug)]
pub struct Builder {
    toolchain: Toolchain,
    cache: Cache,
}

impl Builder {
    /// The tools of the search path and the usual cache: the folder `POINTCORE_CACHE`, or `target/verilated`.
    ///
    /// # Errors
    /// When a tool is missing or too old.
    pub fn new() -> Result<Arc<Self>, VerilatedError> {
        Ok(Self::with(Toolchain::find()?, Cache::default_folder("verilated")))
    }

    /// These tools and this cache folder.
    #[must_use]
    pub fn with(toolchain: Toolchain, cache: PathBuf) -> Arc<Self> {
        Arc::new(Self { toolchain, cache: Cache::new(cache) })
    }

    /// The cache folder.
    #[must_use]
    pub fn cache(&self) -> &Path {
        self.cache.folder()
    }

    /// The compiled model of `source`, from the cache where it is there.
    ///
    /// # Errors
    /// When a port cannot be exchanged, a tool refuses the design (warnings count), or the cache cannot be written.
    pub fn build(
        self: &Arc<Self>,
        source: &VerilogSource,
        options: BuildOptions,
    ) -> Result<Arc<Library>, VerilatedError> {
        check_ports(source)?;
        let substitute = substitute::of(source)?;
        let source = substitute.as_ref();
        let shim = shim::generate(source, options.trace);
        let key = self.key(&[&source.verilog, &source.top, &shim, RUNTIME_HEADER, RUNTIME_SOURCE], options);
        let entry = self.cache.entry(&key, |content| {
            let runtime = self.runtime(options.optimization)?;
            let waveform_writer = match options.trace {
                Trace::On => Some(self.waveform_writer(options.optimization)?),
                Trace::Off => None,
            };
            Build { toolchain: &self.toolchain, source, options, runtime, waveform_writer, content }.run(&shim)
        })?;
        Library::load(&entry.join(LIBRARY), key, source.clone(), options, Arc::clone(self))
    }

    /// The run-time library and the precompiled header, shared by all models of one optimization.
    fn runtime(&self, optimization: Optimization) -> Result<PathBuf, VerilatedError> {
        let options = BuildOptions { optimization, trace: Trace::Off };
        let threads = self.toolchain.include.join("verilated_threads.cpp");
        let jobs = [
            ["-xc++-header", "runtime.h", "-o", "runtime.h.gch"],
            ["-c", "runtime.cpp", "-o", "runtime.o"],
            ["-c", &threads.to_string_lossy(), "-o", "threads.o"],
        ];
        self.precompiled("Verilator's run-time library", options, &jobs)
    }

    /// The writer of waveforms, which needs a library that simulation does not.
    fn waveform_writer(&self, optimization: Optimization) -> Result<PathBuf, VerilatedError> {
        let options = BuildOptions { optimization, trace: Trace::On };
        let writer = self.toolchain.include.join("verilated_fst_c.cpp");
        let jobs = [["-c", &writer.to_string_lossy(), "-o", "waveform.o"]];
        self.precompiled("the waveform writer (needs `apt-get install zlib1g-dev`)", options, &jobs)
    }

    /// The cache entry with the results of these compilations.
    fn precompiled(&self, what: &str, options: BuildOptions, jobs: &[[&str; 4]]) -> Result<PathBuf, VerilatedError> {
        let key = self.key(&[what, RUNTIME_HEADER, RUNTIME_SOURCE], options);
        self.cache.entry(&key, |content| {
            write(&content.join("runtime.h"), RUNTIME_HEADER)?;
            write(&content.join("runtime.cpp"), RUNTIME_SOURCE)?;
            let compilations = jobs.iter().map(|arguments| {
                let mut command = compiler(&self.toolchain, options.optimization);
                command.arg("-I.").args(arguments);
                command
            });
            run_all(compilations.collect(), what, content)
        })
    }

    fn key(&self, parts: &[&str], options: BuildOptions) -> String {
        let tools = [&self.toolchain.verilator.description, &self.toolchain.compiler.description].map(String::as_str);
        let asked = format!("{options:?}");
        let asked = [asked.as_str()];
        let arguments = [VERILATOR_ARGUMENTS, COMPILER_ARGUMENTS, options.optimization.compiler_arguments()];
        key([parts, &tools, &asked].into_iter().chain(arguments).flatten().copied())
    }
}

/// One build of one model.
struct Build<'a> {
    toolchain: &'a Toolchain,
    source: &'a VerilogSource,
    options: BuildOptions,
    runtime: PathBuf,
    waveform_writer: Option<PathBuf>,
    content: &'a Path,
}

impl Build<'_> {
    fn run(&self, shim: &str) -> Result<(), VerilatedError> {
        let scratch = tempfile::tempdir_in(self.content).map_err(file("create a folder in", self.content))?;
        let work = scratch.path();
        let verilog = format!("{}.v", self.source.top);
        write(&work.join(&verilog), &self.source.verilog)?;
        let mut translate = Command::new(&self.toolchain.verilator.program);
        translate.args(VERILATOR_ARGUMENTS).args(["--top-module", &self.source.top, &verilog]);
        if self.options.trace == Trace::On {
            translate.args(["--trace-fst", "--trace-underscore"]);
        }
        run_all(vec![translate], &self.source.top, work)?;
        write(&work.join("shim.cpp"), shim)?;
        let units = self.write_units(work)?;
        let compilations = units.iter().map(|unit| {
            let mut command = compiler(self.toolchain, self.options.optimization);
            command.args(["-c", &format!("{unit}.cpp"), "-o", &format!("{unit}.o")]);
            command.arg("-I").arg(&self.runtime).args(["-I.", "-Imodel"]);
            command
        });
        run_all(compilations.collect(), &self.source.top, work)?;
        let mut link = Command::new(&self.toolchain.compiler.program);
        link.args(["-shared", "-Wl,--no-undefined", "-pthread", "-o"]).arg(self.content.join(LIBRARY));
        link.args(units.iter().map(|unit| format!("{unit}.o")));
        link.args(["runtime.o", "threads.o"].map(|object| self.runtime.join(object)));
        if let Some(writer) = &self.waveform_writer {
            link.arg(writer.join("waveform.o")).arg("-lz");
        }
        run_all(vec![link], &self.source.top, work)
    }

    /// Gathers the generated files and the shim into units of similar size; returns their names.
    fn write_units(&self, work: &Path) -> Result<Vec<String>, VerilatedError> {
        let folder = work.join("model");
        let mut files = Vec::new();
        for item in fs::read_dir(&folder).map_err(file("read", &folder))? {
            let item = item.map_err(file("read", &folder))?;
            let name = item.file_name().to_string_lossy().into_owned();
            if name.ends_with(".cpp") {
                files.push((item.metadata().map_err(file("read", &folder))?.len(), name));
            }
        }
        files.sort_by(|left, right| right.cmp(left));
        let total: u64 = files.iter().map(|(bytes, _)| bytes).sum();
        let unit_bytes = match self.options.optimization {
            Optimization::Quick => QUICK_UNIT_BYTES,
            Optimization::Full => UNIT_BYTES,
        };
        let (slow, fast): (Vec<_>, Vec<_>) =
            files.into_iter().partition(|(_, name)| total > unit_bytes && name.contains("Slow"));
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let count = usize::try_from(total / unit_bytes).unwrap_or(processors).clamp(1, processors);
        let mut units = vec![(0, String::new()); count];
        units[0].1 += "#include \"shim.cpp\"\n";
        for (bytes, name) in fast {
            let smallest = units.iter_mut().min_by_key(|(bytes, _)| *bytes).expect("count is at least 1");
            smallest.0 += bytes;
            smallest.1 += &format!("#include \"{name}\"\n");
        }
        let mut named: Vec<_> =
            units.into_iter().enumerate().map(|(n, (_, text))| (format!("unit{n}"), text)).collect();
        if !slow.is_empty() {
            named.push((START_UP.to_owned(), slow.iter().map(|(_, name)| format!("#include \"{name}\"\n")).collect()));
        }
        for (name, text) in &named {
            // Not an argument: with another one than its own, the precompiled header is of no use.
            let optimization = if name == START_UP { "#pragma GCC optimize (\"O0\")\n" } else { "" };
            let text = format!("#include \"runtime.h\"\n{optimization}{text}");
            write(&work.join(format!("{name}.cpp")), &text)?;
        }
        Ok(named.into_iter().map(|(name, _)| name).collect())
    }
}

fn compiler(toolchain: &Toolchain, optimization: Optimization) -> Command {
    let mut command = Command::new(&toolchain.compiler.program);
    command.args(COMPILER_ARGUMENTS).args(optimization.compiler_arguments());
    command.arg("-I").arg(&toolchain.include).arg("-I").arg(toolchain.include.join("vltstd"));
    command
}

fn check_ports(source: &VerilogSource) -> Result<(), VerilatedError> {
    for port in &source.ports {
        let (top, name, width) = (source.top.clone(), port.name.clone(), port.width);
        if !(1..=64).contains(&width) {
            return Err(VerilatedError::PortWidth { top, name, width });
        }
        let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if !plain || !name.starts_with(|c: char| c.is_ascii_alphabetic()) || name.contains("__") {
            return Err(VerilatedError::PortName { top, name });
        }
    }
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), VerilatedError> {
    Ok(fs::write(path, text).map_err(file("write", path))?)
}

fn failed(tool: &str, what: &str, output: String) -> VerilatedError {
    VerilatedError::Tool { tool: tool.to_owned(), top: what.to_owned(), output }
}

/// Runs the commands side by side in `folder`; the first failure is the error, with what the tool printed.
fn run_all(commands: Vec<Command>, what: &str, folder: &Path) -> Result<(), VerilatedError> {
    let mut running = Vec::new();
    for mut command in commands {
        let tool = command.get_program().to_string_lossy().into_owned();
        command.current_dir(folder).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let child = command.spawn().map_err(|error| failed(&tool, what, format!("cannot be started: {error}")))?;
        running.push((tool, child));
    }
    let mut failure = Ok(());
    for (tool, child) in running {
        let output = child.wait_with_output().map_err(|error| failed(&tool, what, error.to_string()))?;
        if !output.status.success() && failure.is_ok() {
            let output = [output.stdout, output.stderr].concat();
            let output = String::from_utf8_lossy(&output).into_owned();
            failure = Err(failed(&tool, what, output));
        }
    }
    failure
}
