//! `pointcore area [UNIT|CONFIG]...`: what units take on an FPGA, and how fast they are there.

use super::configuration::{self, Configuration};
use super::{Failure, Figures, Output, merge, scene_name};
use pointcore::synthesis::{self, Measurement, Step, Style, SynthesisError, Synthesizer, Target, Unit};
use rayon::prelude::*;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Arguments of `area`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Units such as f32_add or core_a_heap, groups of them (operators, core_a, core_b, heaps), or configuration files;
    /// without any, the operators that the cores rest on, every unit of the cores, and heaps.
    #[arg(value_name = "UNIT|CONFIG")]
    units: Vec<String>,
    /// The technology: ecp5 and ice40 are placed and routed, the others synthesized only.
    #[arg(long, value_enum, default_value = "ecp5")]
    target: Target,
    /// Runs of place and route for each unit, with seeds from 1; the median counts.
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=99))]
    seeds: u32,
    /// Tools that run at a time.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
    /// Print the table in Markdown.
    #[arg(long)]
    markdown: bool,
    /// Merge the figures into this file, as `fpga.UNIT.FIGURE`; of another target than ecp5, as `TARGET.UNIT.FIGURE`.
    #[arg(long, value_name = "FILE")]
    merge: Option<PathBuf>,
}

/// The units that the command line names, in its order.
fn units(names: &[String]) -> Result<Vec<Unit>, Failure> {
    if names.is_empty() {
        return Ok(synthesis::standard());
    }
    let mut known = synthesis::all();
    let mut units = Vec::new();
    for name in names {
        if let Some((_, group)) = synthesis::GROUPS.iter().find(|(group, _)| group == name) {
            units.extend(group());
        } else if let Some(index) = known.iter().position(|unit| unit.name == *name) {
            units.push(known.swap_remove(index));
        } else if Path::new(name).extension().is_some_and(|ending| ending == "toml") {
            units.push(core(Path::new(name))?);
        } else {
            let problem = format!("unknown unit `{name}`: expected {}", synthesis::known());
            return Err(Failure::Usage(problem));
        }
    }
    Ok(units)
}

/// The whole core of a configuration file, by the file's name.
fn core(path: &Path) -> Result<Unit, Failure> {
    let name = scene_name(path);
    Ok(match configuration::parse(path, &configuration::read_text(path)?)? {
        Configuration::CoreA(config) => Unit::core_a(name, config),
        Configuration::CoreB(config) => Unit::core_b(name, config),
    })
}

/// One line on the error stream for each step.
fn progress(step: &Step<'_>) {
    let Step { unit, seed, duration } = step;
    let what = seed.map_or_else(|| "synthesized".to_owned(), |seed| format!("placed and routed with seed {seed}"));
    eprintln!("{unit}: {what} ({:.1} s)", duration.as_secs_f64());
}

/// The figures by their keys.
fn figures(target: Target, measurements: &[Measurement]) -> Figures {
    let place = if target == Target::Ecp5 { "fpga" } else { target.name() };
    let mut figures = Figures::new();
    for Measurement { unit, area, timing, .. } in measurements {
        let all: &[(&str, u64)] = match target {
            Target::Gates => &[("gates", area.gate), ("ff", area.flip_flop), ("memory_bits", area.memory_bits)],
            _ => &[
                ("lut4", area.lut),
                ("carry", area.carry),
                ("ff", area.flip_flop),
                ("lutram", area.distributed_ram),
                ("bram", area.block_ram),
                ("dsp", area.dsp),
            ],
        };
        let rename = |name: &'static str| if target == Target::Xilinx7 && name == "lut4" { "lut6" } else { name };
        figures.extend(all.iter().map(|&(name, value)| (format!("{place}.{unit}.{}", rename(name)), value.into())));
        if let Some(timing) = timing {
            figures.insert(format!("{place}.{unit}.fmax_mhz"), timing.fmax_mhz.into());
        }
    }
    figures
}

/// Measures units, one after the other or several at a time; one that fails does not keep the others from being measured.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let units = units(&arguments.units)?;
    let synthesizer = Synthesizer::new(arguments.target)?;
    let jobs = usize::from(arguments.jobs);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    let pool = pool.map_err(|error| Failure::Usage(format!("--jobs {jobs}: {error}")))?;
    let measure = |unit: &Unit| synthesizer.measure(unit, arguments.seeds, &progress);
    let results: Vec<_> = pool.install(|| units.par_iter().map(measure).collect());
    let mut measurements = Vec::new();
    let mut failures: Vec<SynthesisError> = Vec::new();
    for result in results {
        match result {
            Ok(measurement) => measurements.push(measurement),
            Err(failure) => failures.push(failure),
        }
    }
    if let Some(path) = &arguments.merge {
        merge(path, figures(arguments.target, &measurements))?;
    }
    if !measurements.is_empty() {
        let style = if arguments.markdown { Style::Markdown } else { Style::Plain };
        let text = synthesis::table(arguments.target, &measurements, style);
        output.print(&json!({ "target": arguments.target.name(), "units": measurements }), &text);
    }
    let last = failures.pop();
    for failure in failures {
        eprintln!("pointcore: {failure}");
    }
    last.map_or(Ok(()), |failure| Err(failure.into()))
}
