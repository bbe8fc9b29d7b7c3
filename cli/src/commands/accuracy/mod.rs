//! `pointcore accuracy SCENE`, and `pointcore accuracy --neighbors POINTS`.

mod neighbors;

use super::shard::{Shard, spread};
use super::{Failure, Output, choices, existing, merge, numbers, scene_name, write};
use pointcore::area::estimate::Estimator;
use pointcore::search::PointSource;
use pointcore_lab::accuracy::choice::{Against, Decibels, Prefer, Rated, cheapest, most_accurate, rate};
use pointcore_lab::accuracy::estimator;
use pointcore_lab::accuracy::figures::PointEngine;
use pointcore_lab::accuracy::page::SweepPage;
use pointcore_lab::accuracy::point::{Knob, SweepPoint, UnknownKnob, points};
use pointcore_lab::accuracy::product::{Goal, PRODUCT_LIMIT, Searched, combinations, search};
use pointcore_lab::accuracy::sweep::{MeasuredPoint, Planned, Sweep};
use pointcore_lab::accuracy::table::{cells, document, legend, markdown};
use pointcore_lab::note;
use pointcore_lab::{Figures, LabError};
use pointcore_tb::cache::Cache;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Accuracies whose cheapest points are among the project's figures.
const BENCH_DB: [f64; 2] = [45.0, 55.0];

/// Arguments of `accuracy`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The scene file.
    #[arg(required_unless_present = "neighbors")]
    scene: Option<PathBuf>,
    /// Sweep neighbor search among these points instead: tolerance, neighborhoods in the neighbor cache, points of a leaf.
    #[arg(long, value_name = "FILE|surface:COUNT", conflicts_with_all = ["scene", "at_least", "knobs", "settings"])]
    neighbors: Option<PointSource>,
    /// Neighbors of a query, 1 to 63; with --neighbors.
    #[arg(long, value_name = "COUNT", default_value_t = 30, value_parser = numbers::within(1_u32..=63, "1 to 63 neighbors"), requires = "neighbors")]
    k: u32,
    /// Queries, eight by eight around a point; with --neighbors.
    #[arg(long, value_name = "COUNT", default_value_t = 32_768, value_parser = numbers::within(1_u32.., "1 query at least"), requires = "neighbors")]
    queries: u32,
    /// Print the cheapest configuration with at least so many decibels, as a scene file that `pointcore run` takes; besides the sweep, looks
    /// through all combinations of the knobs' values for a cheaper one.
    #[arg(long, value_name = "DECIBELS")]
    at_least: Option<Decibels>,
    /// Combinations that --at-least renders at most while it looks for a cheaper one; 0 for the sweep alone.
    #[arg(long, value_name = "COUNT", default_value_t = 32, value_parser = numbers::within::<u16>(.., numbers::WHOLE), requires = "at_least")]
    tries: u16,
    /// Which error --at-least is about.
    #[arg(long, value_parser = choices::errors(), default_value = "truth")]
    against: Against,
    /// What the cheapest configuration has the least of.
    #[arg(long, value_parser = choices::preferences(), default_value = "area-time")]
    prefer: Prefer,
    /// Values of a knob, all combined with those of other knobs, in the place of the usual sweep: `geometry`, `rasterizer`, `attribute`, `samples`, `cutoff`,
    /// `kernel`, `division`, `sharing`, `tile_slots`, or a key of the scene such as `overrides.accumulate_stages`.
    #[arg(long = "vary", value_name = "KNOB=VALUE,...")]
    knobs: Vec<String>,
    /// Run every point on the Verilog, too, in lockstep with the golden model.
    #[arg(long)]
    lockstep: bool,
    /// Points measured at a time.
    #[arg(long, default_value_t = 1, value_parser = numbers::within(1_u16..=256, "1 to 256 at a time"))]
    jobs: u16,
    /// Measure only every N-th point, from the I-th, and write nothing but these; the same command without it puts all together.
    #[arg(long, value_name = "I/N", conflicts_with_all = ["at_least", "output"])]
    shard: Option<Shard>,
    /// The folder in which measured points are kept, by default in cargo's target folder; several machines may share it.
    #[arg(long, value_name = "DIR")]
    points: Option<PathBuf>,
    /// The record that areas and clocks are taken and estimated from.
    #[arg(long, value_name = "FILE", default_value = "docs/area.json")]
    record: PathBuf,
    /// The folder for table, JSON and page; by default out/accuracy/<scene>.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// The file to merge the figures into.
    #[arg(long, value_name = "FILE", default_value = "out/bench.json")]
    merge: PathBuf,
    /// Replaces a value of the scene file, e.g. `--set object.0.path=/scans/face.ply`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

impl Arguments {
    /// The folder of points.
    fn folder(&self) -> PathBuf {
        self.points.clone().unwrap_or_else(|| Cache::default_folder("accuracy"))
    }

    fn goal(&self, at_least: Decibels) -> Goal {
        Goal { at_least, against: self.against, prefer: self.prefer, tries: self.tries.into() }
    }

    /// What hardware is rendered on.
    const fn engine(&self) -> PointEngine {
        if self.lockstep { PointEngine::Lockstep } else { PointEngine::Golden }
    }
}

/// Says where the points of a shard are.
fn report(count: usize, folder: &Path, output: Output) -> Result<(), Failure> {
    let text = format!("{count} points are in {}.", folder.display());
    output.print(&json!({ "points": count, "folder": folder }), &text)
}

/// Measures what is not kept yet; a point that fails does not keep the others from being measured.
fn measure(sweep: &Sweep, planned: &[Planned], jobs: u16) -> Result<Vec<MeasuredPoint>, Failure> {
    let done = AtomicUsize::new(0);
    let results = spread(planned, jobs, |point| {
        let kept = sweep.kept(point)?;
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        if let Some(measured) = kept {
            return Ok(measured);
        }
        let measured = sweep.measure(point)?;
        let (name, psnr_db) = (&measured.point.name, measured.figures.psnr_db);
        note!("{count} of {}: {name}: {psnr_db:.1} dB", planned.len());
        Ok::<_, LabError>(measured)
    });
    let (mut measured, mut failures) = (Vec::new(), Vec::new());
    for (planned, result) in planned.iter().zip(results) {
        match result {
            Ok(point) => measured.push(point),
            Err(error) => failures.push((&planned.point.name, error)),
        }
    }
    let last = failures.pop();
    // What keeps all points from being measured is said once.
    let said = last.as_ref().map(|(_, error): &(_, LabError)| error.to_string());
    let others = failures.iter().filter(|(_, error)| Some(error.to_string()) != said);
    others.for_each(|(name, error)| note!("{name}: {error}"));
    last.map_or(Ok(measured), |(_, error)| Err(error.into()))
}

fn figures(scene: &str, rated: &[Rated]) -> Figures {
    let mut figures = Figures::new();
    let mut insert = |key: &str, value: serde_json::Value| figures.insert(format!("accuracy.{scene}.{key}"), value);
    insert("points", rated.len().into());
    insert("pareto_points", rated.iter().filter(|point| point.on_front).count().into());
    for db in BENCH_DB {
        let point = cheapest(rated, Decibels(db), Against::Truth, Prefer::AreaTime);
        let Some(point) = point else { continue };
        let cycles = point.measured.figures.hardware.as_ref().map(|hardware| hardware.cycles);
        insert(&format!("{db}db.cycles"), cycles.into());
        insert(&format!("{db}db.lut4"), point.lut4().map(f64::round).into());
    }
    figures
}

/// What the cheapest points at some accuracies are, in words.
fn advice(rated: &[Rated]) -> Vec<String> {
    let sentence = |(db, against): (f64, Against)| {
        let error = if against == Against::Truth { "against the truth" } else { "of rounding alone" };
        match cheapest(rated, Decibels(db), against, Prefer::AreaTime) {
            Some(point) => {
                let [name, .., cycles, ms, lut4] = cells(point);
                format!("The cheapest with at least {db} dB {error}: {name} ({cycles} cycles, {ms} ms, {lut4} LUT4).")
            }
            None => format!("None has {db} dB {error}."),
        }
    };
    [
        (35.0, Against::Truth),
        (45.0, Against::Truth),
        (55.0, Against::Truth),
        (45.0, Against::Rounding),
        (55.0, Against::Rounding),
    ]
    .map(sentence)
    .to_vec()
}

/// The scene file of the cheapest point that is accurate enough, with its figures as comments.
fn recommended(
    sweep: &Sweep,
    rated: &[Rated],
    arguments: &Arguments,
    scene: &Path,
    at_least: Decibels,
) -> Result<(String, usize), Failure> {
    let Arguments { against, prefer, .. } = *arguments;
    let Some(point) = cheapest(rated, at_least, against, prefer) else {
        let best = most_accurate(rated, against).map_or("nothing was rendered".to_owned(), |(point, db)| {
            format!("the most accurate is `{}` with {db:.1} dB", point.measured.point.name)
        });
        return Err(Failure::Usage(format!("--at-least {}: no point is as accurate; {best}", at_least.0)));
    };
    let [name, _, engine, psnr, flip, .., rounding, cycles, ms, lut4] = cells(point);
    let text = format!(
        "# {}: the cheapest of {} configurations with at least {} dB.\n# {name}: {psnr} dB against the truth (FLIP {flip}), {rounding} dB of rounding alone; {cycles} cycles, {ms} ms, {lut4} LUT4; measured on: {engine}.\n",
        scene.display(),
        rated.len(),
        at_least.0
    );
    let place = rated.iter().position(|other| std::ptr::eq(other, point)).expect("it is one of them");
    Ok((text + &sweep.scene_file(&point.measured.point)?, place))
}

/// Refuses values that a user names and that no point admits, whatever the other knobs are.
fn check_values(knobs: &[Knob], arguments: &Arguments, refused: &[(SweepPoint, LabError)]) -> Result<(), Failure> {
    let (all, points_refused): (_, Vec<_>) = (points(knobs), refused.iter().map(|(point, _)| point).collect());
    for (knob, text) in knobs.iter().zip(&arguments.knobs) {
        if let Some(value) = knob.impossible(&all, &points_refused).first() {
            let reason = refused.iter().find(|(point, _)| point.name == knob.alone(value));
            let reason = reason.map_or_else(String::new, |(_, error)| format!(": {error}"));
            return Err(Failure::Usage(format!("--vary {text}: `{value}` is no value here{reason}")));
        }
    }
    Ok(())
}

/// Looks through all combinations of the knobs for one that is cheaper.
fn look_further(
    sweep: &Sweep,
    knobs: &[Knob],
    rated: Vec<Rated>,
    estimator: &Estimator,
    goal: Goal,
) -> Result<(Vec<Rated>, Option<Searched>), Failure> {
    if goal.tries == 0 {
        return Ok((rated, None));
    }
    let count = combinations(knobs);
    if count > PRODUCT_LIMIT {
        let problem = format!("the knobs have {count} combinations: name fewer values with --vary, or use --tries 0");
        return Err(Failure::Usage(problem));
    }
    let told = |point: &Rated| {
        let [name, _, _, psnr, .., lut4] = cells(point);
        note!("tried {name}: {psnr} dB, {lut4} LUT4");
    };
    let (found, searched) = search(sweep, knobs, &rated, estimator, &goal, told)?;
    if searched.is_cut_short {
        note!("{} combinations were rendered, and some that may be cheaper are left: --tries renders more", goal.tries);
    }
    let all = rated.into_iter().map(|point| point.measured).chain(found).collect();
    Ok((rate(all, estimator), Some(searched)))
}

/// Sweeps the knobs, and says what came of it.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    match (&arguments.neighbors, &arguments.scene) {
        (Some(source), _) => neighbors::run(source, arguments, output),
        (None, Some(scene)) => sweep_scene(scene, arguments, output),
        (None, None) => Err(Failure::Usage("expected a scene, or points with --neighbors".to_owned())),
    }
}

fn sweep_scene(scene: &Path, arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let name = scene_name(scene);
    let knobs: Result<Vec<Knob>, UnknownKnob> = arguments.knobs.iter().map(|text| Knob::parse(text)).collect();
    let knobs = knobs.map_err(|error| Failure::Usage(format!("--vary {error}")))?;
    let (folder, engine) = (arguments.folder(), arguments.engine());
    let sweep = Sweep::open(scene, &arguments.settings, folder.clone(), engine)?;
    let standard = if sweep.moves() { Knob::of_motion } else { Knob::standard };
    let knobs = if knobs.is_empty() { standard() } else { knobs };

    let (planned, refused) = sweep.plan(points(&knobs));
    check_values(&knobs, arguments, &refused)?;
    for (point, error) in &refused {
        note!("left out: {}: {error}", point.name);
    }
    if let Some(shard) = arguments.shard {
        return report(measure(&sweep, &shard.of(planned), arguments.jobs)?.len(), &folder, output);
    }
    // Files that are none are found before anything is measured.
    existing(&arguments.merge)?;
    let estimator = estimator(&arguments.record, &Cache::new(folder))?;
    let measured = measure(&sweep, &planned, arguments.jobs)?;
    let rated = rate(measured, &estimator);
    let (rated, searched) = match arguments.at_least {
        Some(at_least) => look_further(&sweep, &knobs, rated, &estimator, arguments.goal(at_least))?,
        None => (rated, None),
    };

    let results = arguments.output.clone().unwrap_or_else(|| Path::new("out/accuracy").join(&name));
    let (legend, advice) = (legend(&estimator), advice(&rated));
    let list: String = advice.iter().map(|line| format!("- {line}\n")).collect();
    let text = format!("# {name}: what accuracy costs\n\n{}\n{legend}\n\n{list}", markdown(&rated));
    let (figures, truth) = (figures(&name, &rated), sweep.truth_folder()?);
    let mut result = json!({
        "scene": name,
        "legend": legend,
        "fit": estimator.fit,
        "points": rated.iter().map(document).collect::<Vec<_>>(),
        "left_out": refused.iter().map(|(point, error)| json!({ "name": point.name, "reason": error.to_string() })).collect::<Vec<_>>(),
        "figures": figures,
    });
    write(&results.join("README.md"), &text)?;
    write(&results.join("accuracy.json"), &serde_json::to_string_pretty(&result).expect("results have string keys"))?;
    let page = SweepPage { scene: &name, rated: &rated, legend: &legend, advice: &advice, truth: &truth };
    write(&results.join("index.html"), &page.html()?)?;
    merge(&arguments.merge, figures)?;
    match arguments.at_least {
        Some(at_least) => {
            let (scene, place) = recommended(&sweep, &rated, arguments, scene, at_least)?;
            result["searched"] = json!(searched);
            result["recommended"] = json!({ "point": rated[place].measured.point.name, "scene": scene });
            output.print(&result, &scene)
        }
        None => output.print(&result, &format!("{text}\nWritten to {}.", results.display())),
    }
}
