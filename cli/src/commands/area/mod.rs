//! `pointcore area [UNIT|CONFIG]...`: what units take on an FPGA, and how fast they are there.

mod progress;
mod record;

use super::{Failure, Output, choices, merge, numbers, scene_name};
use pointcore::configuration::{parse, read_text};
use pointcore_lab::Figures;
use pointcore_lab::note;
use pointcore_lab::synthesis::{
    self, AreaLine, AreaRecord, MeasuredUnit, Measurement, Revision, Style, Synthesizer, Target,
};
use progress::Display;
use rayon::prelude::*;
use record::Recorder;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Arguments of `area`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Units such as f32_add or splat_heap, the whole cores splat, search and points, groups of them (operators, splat_units,
    /// search_units, process_units, bus_units, heaps, cores), or configuration files; without any, the operators that the cores rest on,
    /// every unit of the cores and of their bus, heaps, and the cores. Units and cores have the parameters of configs/ecp5.toml,
    /// configs/knn.toml and configs/points.toml.
    #[arg(value_name = "UNIT|CONFIG")]
    units: Vec<String>,
    /// The technology: ecp5 and ice40 are placed and routed, the others synthesized only.
    #[arg(long, value_parser = choices::targets(), default_value = "ecp5")]
    target: Target,
    /// Runs of place and route for each unit; the median counts.
    #[arg(long, default_value_t = 5, value_parser = numbers::within(1_u32..=99, "1 to 99 seeds"))]
    seeds: u32,

    /// Seed of the first run, the others follow: where a placement does not route, that of another seed may; the record says which.
    #[arg(long, value_name = "SEED", default_value_t = 1, value_parser = numbers::within(1_u32..=9999, "a seed from 1 to 9999"))]
    first_seed: u32,
    /// Tools that run at a time.
    #[arg(long, default_value_t = 1, value_parser = numbers::within(1_u16..=256, "1 to 256 at a time"))]
    jobs: u16,
    /// Place only, with the first seed, and list the paths that take longer than this many ns where every wire takes what is usual for its
    /// fan-out: what the structure costs, before anything is routed and wherever the placer put what.
    #[arg(long, value_name = "NS", value_parser = numbers::positive(),
        conflicts_with_all = ["seeds", "markdown", "merge", "record", "tables", "recorded", "mark_stale", "check"])]
    late: Option<f64>,
    /// Print the table in Markdown.
    #[arg(long)]
    markdown: bool,
    /// Merge the figures into this file, as `fpga.UNIT.FIGURE`; of another target than ecp5, as `TARGET.UNIT.FIGURE`.
    #[arg(long, value_name = "FILE")]
    merge: Option<PathBuf>,
    /// Keep every unit's figures in this file as soon as it has been measured, with the hash of what it was measured of.
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Write the tables of this Markdown file anew from the record, between lines `<!-- area TARGET -->` and `<!-- end of area -->`.
    #[arg(long, value_name = "FILE")]
    tables: Option<PathBuf>,
    /// Measure nothing: write --tables from --record, and merge those of its figures that are of the hardware as it is now.
    #[arg(long, requires = "record", conflicts_with = "units")]
    recorded: bool,
    /// Measure nothing: have every figure of --record that is not of the hardware as it is now name this revision of the project, a commit's short
    /// hash or a date, as the one it was measured of. What names one keeps it. Tables show it, and --check lets it pass.
    #[arg(long, value_name = "REVISION", requires = "record", conflicts_with_all = ["units", "merge", "recorded"])]
    mark_stale: Option<Revision>,
    /// Measure nothing: say which figures of this record claim to be of the hardware as it is now and are not, and whether --tables are those
    /// of the record. Figures that name the revision they were measured of claim no such thing.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["units", "merge", "record", "recorded", "mark_stale"])]
    check: Option<PathBuf>,
}

/// A unit, and the file it is read from if it is a configuration's core.
struct Named {
    unit: MeasuredUnit,
    configuration: Option<PathBuf>,
}

impl From<MeasuredUnit> for Named {
    fn from(unit: MeasuredUnit) -> Self {
        Self { unit, configuration: None }
    }
}

/// The units that the command line names, in its order.
fn units(names: &[String]) -> Result<Vec<Named>, Failure> {
    if names.is_empty() {
        return Ok(synthesis::standard().into_iter().map(Named::from).collect());
    }
    let mut known = synthesis::all();
    let mut units = Vec::new();
    for name in names {
        if let Some((_, group)) = synthesis::GROUPS.iter().find(|(group, _)| group == name) {
            units.extend(group().into_iter().map(Named::from));
        } else if let Some(index) = known.iter().position(|unit| unit.name == *name) {
            units.push(known.swap_remove(index).into());
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
fn core(path: &Path) -> Result<Named, Failure> {
    let unit = MeasuredUnit::core(scene_name(path), parse(path, &read_text(path)?)?);
    Ok(Named { unit, configuration: Some(path.to_owned()) })
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

/// The figures of a record that are of the hardware as it is now.
fn recorded(record: &AreaRecord) -> Figures {
    let of_target = |&target: &Target| {
        let measurements: Vec<_> = record.fresh(target).into_iter().map(|(entry, _)| entry.measurement()).collect();
        figures(target, &measurements)
    };
    Target::ALL.iter().flat_map(of_target).collect()
}

/// Measures units, one after the other or several at a time; one that fails does not keep the others from being measured.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    if let Some(path) = &arguments.check {
        return record::check(path, arguments.tables.as_deref(), output);
    }
    if arguments.tables.is_some() && arguments.record.is_none() {
        let problem = "--tables needs the record that they are made from: expected --record or --check FILE";
        return Err(Failure::Usage(problem.to_owned()));
    }
    if let Some(limit_ns) = arguments.late {
        return late(arguments, limit_ns, output);
    }
    if let (Some(revision), Some(path)) = (&arguments.mark_stale, &arguments.record) {
        record::mark_stale(path, revision, output)?;
    } else if !arguments.recorded {
        measure(arguments, output)?;
    } else if let (Some(path), Some(record)) = (&arguments.merge, &arguments.record) {
        merge(path, recorded(&AreaRecord::load(record)?))?;
    }
    match (&arguments.record, &arguments.tables) {
        (Some(path), Some(tables)) => record::write_tables(path, tables),
        _ => Ok(()),
    }
}

/// Lists what is late in units, one after the other.
fn late(arguments: &Arguments, limit_ns: f64, output: Output) -> Result<(), Failure> {
    let synthesizer = Synthesizer::new(arguments.target)?;
    let display = Display::default();
    let of_unit = |Named { unit, .. }: Named| {
        Ok(synthesizer.late_paths(&unit, arguments.first_seed, limit_ns, &|step| display.show(step))?)
    };
    let units: Vec<_> = units(&arguments.units)?.into_iter().map(of_unit).collect::<Result<_, Failure>>()?;
    let texts: Vec<_> = units.iter().map(ToString::to_string).collect();
    output.print(&units, &texts.join("\n\n"))
}

fn measure(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let units = units(&arguments.units)?;
    let recorder = arguments.record.as_deref().map(Recorder::new).transpose()?;
    let synthesizer = Synthesizer::new(arguments.target)?;
    let jobs = usize::from(arguments.jobs);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    let pool = pool.map_err(|error| Failure::Usage(format!("--jobs {jobs}: {error}")))?;
    let display = Display::default();
    let measure = |Named { unit, configuration }: &Named| {
        let seeds = arguments.first_seed..=arguments.first_seed + arguments.seeds - 1;
        let measured = synthesizer.measure(unit, seeds, &|step| display.show(step))?;
        if let Some(recorder) = &recorder {
            recorder.keep(&synthesizer, unit, configuration.as_deref(), &measured)?;
        }
        Ok(measured)
    };
    let results: Vec<Result<_, Failure>> = pool.install(|| units.par_iter().map(measure).collect());
    let mut measurements = Vec::new();
    let mut failures: Vec<Failure> = Vec::new();
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
        let document = json!({ "target": arguments.target.name(), "units": measurements });
        let lines: Vec<_> = measurements.into_iter().map(AreaLine::from).collect();
        output.print(&document, &synthesis::table(arguments.target, &lines, style))?;
    }
    let last = failures.pop();
    for failure in failures {
        note!("error: {failure}");
    }
    last.map_or(Ok(()), Err)
}
