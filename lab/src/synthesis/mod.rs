//! Area and clock of the hardware on open tools: yosys for the cells, nextpnr for the clock.
//!
//! Every step's result is kept by the hash of all it depends on, so a long series that was interrupted goes on where it was.

mod area;
mod cells;
mod convergence;
mod document;
mod error;
mod late;
mod record;
mod revision;
mod samples;
mod steps;
mod table;
mod target;
mod timing;
mod tools;
mod units;

pub use area::DeviceArea;
pub use convergence::{Divergence, Iteration};
pub use error::SynthesisError;
pub use late::{LatePath, LatePaths};
pub use record::{AreaEntry, AreaRecord, Stale};
pub use revision::Revision;
pub use steps::{State, Step, StepListener, Work};
pub(crate) use table::markdown;
pub use table::{AreaLine, Style, table};
pub use target::Target;
pub use timing::Timing;
pub use units::{GROUPS, Group, MeasuredUnit, Scope, all, known, standard};

use pointcore::package::shell::{self, Shelled};
use pointcore_tb::cache::{Cache, FileError, file, key};
use rayon::prelude::*;
use serde::Serialize;
use std::fs;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Instant;
use steps::watched;
use target::Device;
use tools::Ending;
pub(crate) use tools::Tool;

/// A unit's area and clock.
#[derive(Clone, Debug, Serialize)]
pub struct Measurement {
    /// The unit's name.
    pub unit: String,
    /// What it takes.
    pub area: DeviceArea,
    /// The run with the median frequency, where the target is placed and routed.
    pub timing: Option<Timing>,
    /// The frequency with every seed, in MHz.
    pub fmax_mhz: Vec<f64>,
    /// The first of the seeds.
    pub first_seed: u32,
}

/// Tools for one target, and the cache of their results.
pub struct Synthesizer {
    target: Target,
    yosys: Tool,
    router: Option<(&'static Device, Tool)>,
    cache: Cache,
}

impl Synthesizer {
    /// The tools for a target.
    ///
    /// # Errors
    /// When one is missing or too old.
    pub fn new(target: Target) -> Result<Self, SynthesisError> {
        let router = target.device().map(|device| Ok::<_, SynthesisError>((device, Tool::nextpnr(device.program)?)));
        let cache = Cache::new(Cache::default_folder("synthesis"));
        Ok(Self { target, yosys: Tool::yosys()?, router: router.transpose()?, cache })
    }

    /// Measures a unit, its clock with each of the `seeds`; `progress` hears of every step done.
    ///
    /// # Errors
    /// A tool's failure, or a unit that the device cannot hold.
    pub fn measure(
        &self,
        unit: &MeasuredUnit,
        seeds: RangeInclusive<u32>,
        progress: StepListener<'_>,
    ) -> Result<Measurement, SynthesisError> {
        let name = &unit.name;
        let synthesis = watched(name, Work::Synthesis, progress, || self.synthesize(name, &design(unit)?))?;
        let report = |problem| SynthesisError::Report { unit: name.clone(), problem };
        let area = cells::parse(self.target, &read(&synthesis.0.join(CELLS))?).map_err(report)?;
        let (first_seed, mut runs) = (*seeds.start(), Vec::new());
        if let Some((device, router)) = &self.router {
            check_capacity(name, device, &area)?;
            let route = |seed| {
                let route = || self.route(&Run { unit, device, router, seed }, &synthesis, progress);
                watched(name, Work::PlaceAndRoute(seed), progress, route)
            };
            runs = seeds.into_par_iter().map(route).collect::<Result<_, SynthesisError>>()?;
        }
        let fmax_mhz = runs.iter().map(|run: &Timing| run.fmax_mhz).collect();
        Ok(Measurement { unit: name.clone(), area, timing: timing::median(&runs).cloned(), fmax_mhz, first_seed })
    }

    /// Places a unit with a seed, and lists the paths that take longer than `limit_ns` by usual wires.
    ///
    /// # Errors
    /// A target that is not placed, a tool's failure, or a unit that the device cannot hold.
    pub fn late_paths(
        &self,
        unit: &MeasuredUnit,
        seed: u32,
        limit_ns: f64,
        progress: StepListener<'_>,
    ) -> Result<LatePaths, SynthesisError> {
        let name = &unit.name;
        let Some((device, router)) = &self.router else {
            return Err(SynthesisError::NotPlaced { target: self.target.name() });
        };
        let report = |problem| SynthesisError::Report { unit: name.clone(), problem };
        let synthesis = watched(name, Work::Synthesis, progress, || self.synthesize(name, &design(unit)?))?;
        check_capacity(name, device, &cells::parse(self.target, &read(&synthesis.0.join(CELLS))?).map_err(report)?)?;
        let run = Run { unit, device, router, seed };
        let estimate = || {
            let placed = self.step(&run, &synthesis, NETLIST, PLACE)?;
            self.step(&run, &placed, PLACED, ESTIMATE)
        };
        let delays = watched(name, Work::Placing(seed), progress, estimate)?.0.join(DELAYS);
        late::paths(name, &read(&delays)?, limit_ns).map_err(report)
    }

    /// The technology.
    #[must_use]
    pub const fn target(&self) -> Target {
        self.target
    }

    /// What the tools say of their versions.
    #[must_use]
    pub fn tools(&self) -> Vec<String> {
        let router = self.router.iter().map(|(_, tool)| tool.description.clone());
        std::iter::once(self.yosys.description.clone()).chain(router).collect()
    }

    /// The cache entry with the unit's cells and netlist, and its key.
    fn synthesize(&self, unit: &str, design: &Shelled) -> Result<(PathBuf, String), SynthesisError> {
        let script = self.target.script(design);
        let key = key([design.verilog.as_str(), &script, &self.yosys.description]);
        let entry = self.cache.entry(&key, |content| {
            write(&content.join("design.v"), &design.verilog)?;
            write(&content.join("script.ys"), &script)?;
            self.yosys.run(unit, content, &["-q", "-s", "script.ys"])
        })?;
        Ok((entry, key))
    }

    /// The clock of a unit with one seed. Places and wires are of one run, as they are in packages.
    fn route(
        &self,
        run: &Run<'_>,
        synthesis: &(PathBuf, String),
        progress: StepListener<'_>,
    ) -> Result<Timing, SynthesisError> {
        let begin = Instant::now();
        let name = &run.unit.name;
        let routed = match self.step(run, synthesis, NETLIST, &[]) {
            Err(SynthesisError::Unroutable { divergence, .. }) if matches!(run.unit.scope, Scope::Core(_)) => {
                let state = State::Diverged(divergence);
                progress(&Step { unit: name, work: Work::PlaceAndRoute(run.seed), duration: begin.elapsed(), state });
                self.step(run, synthesis, NETLIST, OTHER_ROUTER)
            }
            result => result,
        };
        timing::parse(&read(&routed?.0.join(TIMING))?)
            .map_err(|problem| SynthesisError::Report { unit: name.clone(), problem })
    }

    /// The cache entry of a step of place and route, and its key; the netlist is that of the step before.
    fn step(
        &self,
        Run { unit, device, router, seed }: &Run<'_>,
        (start, start_key): &(PathBuf, String),
        netlist: &str,
        options: &[&str],
    ) -> Result<(PathBuf, String), SynthesisError> {
        let arguments: Vec<&str> = device.arguments(unit.scope).collect();
        let text = seed.to_string();
        let parts = [start_key.as_str(), &router.description, &text];
        let key = key(parts.into_iter().chain(arguments.iter().chain(options).copied()));
        let entry = self.cache.entry(&key, |content| {
            let copy = content.join(netlist);
            fs::copy(start.join(netlist), &copy).map_err(file("copy the netlist to", &copy))?;
            let files = ["--seed", &text, "--json", netlist, "--report", TIMING, "--log", ROUTING];
            let arguments = [&["-q", "--timing-allow-fail"], &files[..], &arguments, options].concat();
            let log = content.join(ROUTING);
            let diverges = || convergence::divergence(&fs::read_to_string(&log).unwrap_or_default());
            if let Ending::Stopped(divergence) = router.run_while(&unit.name, content, &arguments, diverges)? {
                return Err(SynthesisError::Unroutable { unit: unit.name.clone(), seed: *seed, divergence });
            }
            Ok::<_, SynthesisError>(fs::remove_file(&copy).map_err(file("remove", &copy))?)
        })?;
        Ok((entry, key))
    }
}

/// What is placed and routed, and how.
struct Run<'a> {
    unit: &'a MeasuredUnit,
    device: &'a Device,
    router: &'a Tool,
    seed: u32,
}

/// A unit in its shell. Its Verilog has no comments: what explains the hardware does not age what was measured of it.
fn design(unit: &MeasuredUnit) -> Result<Shelled, SynthesisError> {
    let design = unit.module().and_then(shell::wrap);
    let design = design.map_err(|source| SynthesisError::Generate { unit: unit.name.clone(), source })?;
    Ok(Shelled { verilog: without_comments(&design.verilog), ..design })
}

/// Generated Verilog without its comments, and the lines that held nothing else; it has no strings that `//` could stand in.
fn without_comments(verilog: &str) -> String {
    let code = verilog.lines().map(|line| line.split_once("//").map_or(line, |(code, _)| code).trim_end());
    code.filter(|line| !line.is_empty()).fold(String::new(), |text, line| text + line + "\n")
}

/// The hash of all that a measurement depends on but the tools' versions: the unit's Verilog, the script, the arguments.
///
/// # Errors
/// A fault of the generator.
pub fn source_hash(target: Target, unit: &MeasuredUnit) -> Result<String, SynthesisError> {
    let design = design(unit)?;
    let script = target.script(&design);
    let arguments: Vec<&str> = target.device().into_iter().flat_map(|device| device.arguments(unit.scope)).collect();
    Ok(key([design.verilog.as_str(), &script].into_iter().chain(arguments)))
}

/// What yosys counts.
const CELLS: &str = "cells.json";
/// What yosys hands to place and route.
const NETLIST: &str = "netlist.json";
/// A design as it is placed, for [`ESTIMATE`].
const PLACED: &str = "placed.json";
/// Arguments that leave the wires out.
const PLACE: &[&str] = &["--no-route", "--write", PLACED];
/// What says how long all wires of a placed design may take.
const ESTIMATE: &[&str] = &["--no-pack", "--no-place", "--no-route", "--sdf", DELAYS];
/// See there.
const DELAYS: &str = "delays.sdf";
/// Where the usual router gets nowhere.
const OTHER_ROUTER: &[&str] = &["--router", "router2"];
/// What place and route say on their way; a whole core takes them most of an hour.
const ROUTING: &str = "route.log";
/// What place and route report.
const TIMING: &str = "timing.json";

/// A clear word before the router gives up after minutes.
fn check_capacity(unit: &str, device: &Device, area: &DeviceArea) -> Result<(), SynthesisError> {
    for capacity in device.capacities {
        let (needed, available) = ((capacity.taken)(area), capacity.available);
        if needed > available {
            let (unit, device, resource) = (unit.to_owned(), device.name, capacity.name);
            return Err(SynthesisError::TooLarge { unit, resource, device, needed, available });
        }
    }
    Ok(())
}

fn read(path: &Path) -> Result<String, FileError> {
    fs::read_to_string(path).map_err(file("read", path))
}

fn write(path: &Path, text: &str) -> Result<(), FileError> {
    fs::write(path, text).map_err(file("write", path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_device_cannot_hold_is_said_before_it_is_placed() {
        let device = Target::Ecp5.device().expect("an ECP5 is placed and routed");
        let fits = DeviceArea { lut: 80_000, carry: 1_800, dsp: 156, ..DeviceArea::default() };
        assert!(check_capacity("core", device, &fits).is_ok());
        let error = check_capacity("core", device, &DeviceArea { carry: 1_900, ..fits }).unwrap_err().to_string();
        for part in ["`core` takes 83800 LUT4", "LFE5U-85F has 83640"] {
            assert!(error.contains(part), "`{part}` is missing in: {error}");
        }
        let multipliers = check_capacity("core", device, &DeviceArea { dsp: 157, ..fits }).unwrap_err();
        assert!(matches!(multipliers, SynthesisError::TooLarge { needed: 157, available: 156, .. }), "{multipliers}");
    }

    #[test]
    fn a_design_is_measured_without_its_comments() {
        let text = "// A module.\nmodule one;  // of one wire\n\n    wire a = b / c;\n    // end\nendmodule\n";
        assert_eq!(without_comments(text), "module one;\n    wire a = b / c;\nendmodule\n");
    }
}
