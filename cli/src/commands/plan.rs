//! `pointcore plan SCENE`.

use super::budget::{BudgetArguments, Planned, tried};
use super::{Failure, Output, load, scene_name};
use pointcore::area::count;
use pointcore::area::estimate::Estimator;
use pointcore::cost::budget::Candidate;
use pointcore::cost::{Costs, Cycles, HardwareFigures, TABLE_HEAD, table_row};
use pointcore::plan::{MovingPlan, Plan};
use pointcore::scene::{Scene, SceneError};
use pointcore::splat::SplatCore;
use pointcore_lab::accuracy::estimator;
use pointcore_lab::note;
use pointcore_tb::cache::Cache;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Arguments of `plan`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The scene file; several with --table.
    #[arg(required = true)]
    scenes: Vec<PathBuf>,
    /// Tell cycles and look-up tables, too: renders the frame on the golden model of the hardware with more and with less of every effect,
    /// which takes some seconds each. Without it only what is counted before synthesis is told.
    #[arg(long)]
    measure: bool,
    /// A table in Markdown instead, a line a scene: what each has, and which share of everything that saves; renders two frames a scene.
    #[arg(long, conflicts_with_all = ["device", "luts"])]
    table: bool,
    #[command(flatten)]
    budget: BudgetArguments,
    /// The record that look-up tables are estimated from.
    #[arg(long, value_name = "FILE", default_value = "docs/area.json")]
    record: PathBuf,
    /// Replaces a value of the scene file, e.g. `--set object.0.path=/scans/face.ply`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

impl Arguments {
    fn estimator(&self) -> Result<Estimator, Failure> {
        Ok(estimator(&self.record, &Cache::new(Cache::default_folder("accuracy")))?)
    }
}

/// A figure with its sign where it is a difference; nothing where there is none.
fn number(figure: Option<f64>) -> String {
    figure.map_or_else(String::new, |figure| format!("{figure:.0}"))
}

/// The columns of some figures.
fn cells(figures: &HardwareFigures) -> [String; 5] {
    let count = |figure: i64| number(Some(figure as f64));
    [
        count(figures.register_bits),
        count(figures.memory_bits),
        count(figures.multipliers),
        number(figures.lut4),
        number(figures.cycles.map(|cycles| cycles as f64)),
    ]
}

/// The prices of effects as text.
fn prices(costs: &Costs, measured: bool) -> String {
    let columns = if measured { 5 } else { 3 };
    let heads = ["registers", "memory", "mult.", "LUT4", "cycles"].map(str::to_owned);
    let line = |name: &str, cells: [[String; 5]; 2]| {
        let row =
            |cells: &[String; 5]| cells[..columns].iter().fold(String::new(), |row, cell| format!("{row} {cell:>9}"));
        format!("  {name:22}{}  |{}\n", row(&cells[0]), row(&cells[1]))
    };
    let width = 10 * columns;
    let mut text = format!("  {:22}{:>width$}  |{:>width$}\n", "", "what it costs", "what leaving it out saves");
    text += &line("effect", [heads.clone(), heads]);
    for priced in &costs.effects {
        text += &line(priced.effect.name(), [cells(&priced.cost), cells(&priced.saved)]);
    }
    text += "  Registers and memories in bits. The cost is that of what is there beyond the least; cycles then are those of another picture\n";
    text += "  where the scene needs more than the least.\n";
    text
}

/// Explains the hardware for a scene, or the table of several.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    if arguments.table {
        return table(arguments, output);
    }
    let [path] = &arguments.scenes[..] else {
        return Err(Failure::Usage("several scenes go with --table".to_owned()));
    };
    let (scene, planned) = arguments.budget.load(path, &arguments.settings, || arguments.estimator())?;
    let (text, document) = match &planned {
        Planned::Still(plan, candidates) => {
            let heading = format!("{}: {} splats", path.display(), scene.splats.len());
            explain(arguments, &heading, &scene, plan, candidates)?
        }
        Planned::Moving(plan) => explain_moving(arguments, path, &scene, plan)?,
    };
    let Value::Object(mut document) = document else { unreachable!("a plan is an object") };
    document.insert("scene".to_owned(), json!(path));
    output.print(&document, &text)
}

/// What moves, and what stands still beside it.
fn explain_moving(
    arguments: &Arguments,
    path: &Path,
    scene: &Scene,
    plan: &MovingPlan,
) -> Result<(String, Value), Failure> {
    let heading = format!("{}: what moves while the shutter is open", path.display());
    let (mut text, mut document) = explain(arguments, &heading, scene, &plan.moving, &[])?;
    if let (Some(still), Some(plan)) = (scene.still_part(), &plan.still) {
        let heading =
            format!("{}: what stands still, {} splats, on a core of its own", path.display(), still.splats.len());
        let (of_still, beside) = explain(arguments, &heading, &still, plan, &[])?;
        text += "\n";
        text += &of_still;
        document["still"] = beside;
    }
    Ok((text, document))
}

fn explain(
    arguments: &Arguments,
    heading: &str,
    scene: &Scene,
    plan: &Plan,
    candidates: &[Candidate],
) -> Result<(String, Value), Failure> {
    let planned = SplatCore::generate(&plan.config)?;
    let full = SplatCore::generate(&plan.with_everything().config)?;
    let costs = if arguments.measure {
        Costs::of(scene, plan, Cycles::Measured, Some(&arguments.estimator()?))?
    } else {
        Costs::of(scene, plan, Cycles::Untold, None)?
    };

    let mut text = format!("{heading}\n\n");
    for choice in &plan.choices {
        _ = writeln!(text, "  {:22} {:14} {}", choice.part, choice.chosen, choice.reason);
    }
    if !candidates.is_empty() {
        text += &tried(candidates);
    }
    _ = write!(text, "\n{}", prices(&costs, arguments.measure));
    _ = writeln!(text, "\n  {:22} {:>12} {:>12} {:>8}", "area proxy", "this scene", "everything", "saved");
    for (name, planned, full) in count::rows(&planned.design, &full.design) {
        let saved = 100.0 * (1.0 - planned as f64 / full.max(1) as f64);
        _ = writeln!(text, "  {name:22} {planned:>12} {full:>12} {saved:>7.1}%");
    }
    if let (Some(planned), Some(everything), Some(saved)) =
        (costs.planned.cycles, costs.everything.cycles, costs.cycles_saved())
    {
        _ = writeln!(text, "  {:22} {planned:>12} {everything:>12} {:>7.1}%", "cycles", 100.0 * saved);
    }
    _ = writeln!(text, "\n  {:22} {:>9} {:>9}", "datapath", "latency", "interval");
    for (unit, manifest) in &planned.manifests {
        _ = writeln!(text, "  {unit:22} {:>9} {:>9}", manifest.latency, manifest.initiation_interval);
    }
    let document = json!({
        "splats": scene.splats.len(),
        "config": plan.config,
        "choices": plan.choices,
        "tried": candidates,
        "effects": costs.effects,
        "planned": costs.planned,
        "everything": costs.everything,
        "area": count::document(&planned.design),
        "area_with_everything": count::document(&full.design),
        "datapaths": planned.manifests,
    });
    Ok((text, document))
}

/// Whether a scene is right but for a model that is not there.
fn lacks_model(failure: &Failure) -> bool {
    matches!(failure, Failure::Scene(SceneError::Value { key, .. }) if key.starts_with("object.") && key.ends_with(".path"))
}

fn table(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let estimator = arguments.estimator()?;
    let (mut text, mut documents) = (TABLE_HEAD.to_owned(), Vec::new());
    let mut left_out = None;
    for path in &arguments.scenes {
        let (scene, plan) = match load(path, &arguments.settings) {
            Ok(loaded) => loaded,
            // Models need not be there: the shipped scenes name some that are not part of the project.
            Err(error) if lacks_model(&error) => {
                note!("{} is left out: {error}", path.display());
                documents.push(json!({ "scene": path, "left_out": error.to_string() }));
                left_out = Some(error);
                continue;
            }
            Err(error) => return Err(error),
        };
        let costs = Costs::whole(&scene, &plan, Cycles::Measured, Some(&estimator))?;
        let name = scene_name(path);
        _ = write!(text, "\n{}", table_row(&name, &plan, &costs));
        documents.push(
            json!({ "scene": path, "config": plan.config, "planned": costs.planned, "everything": costs.everything }),
        );
    }
    match left_out {
        Some(error) if text == TABLE_HEAD => Err(error),
        _ => output.print(&documents, &text),
    }
}
