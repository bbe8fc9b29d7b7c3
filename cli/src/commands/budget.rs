//! What hardware for a scene may take.

use super::{Failure, moving_plan_on, plan_on, warn};
use pointcore::area::device::{Device, Needs};
use pointcore::area::estimate::Estimator;
use pointcore::cost::budget::{Budget, BudgetError, Budgeted, Candidate};
use pointcore::plan::{MovingPlan, Plan};
use pointcore::scene::Scene;
use std::fmt::Write as _;
use std::path::Path;

/// Arguments of commands that choose hardware.
#[derive(clap::Args)]
pub struct BudgetArguments {
    /// Chooses the fastest hardware for the scene that this device holds, as far as can be told before synthesis: rasterizers, cycles a
    /// splat, copies that wait. What the scene's [overrides] say stays as it is.
    #[arg(long, value_name = "DEVICE")]
    device: Option<Device>,
    /// Chooses the fastest hardware of so many look-up tables of four inputs, as they are estimated from what was synthesized.
    #[arg(long, value_name = "COUNT")]
    luts: Option<u64>,
}

impl BudgetArguments {
    /// Whether there is a budget.
    pub const fn is_limited(&self) -> bool {
        self.device.is_some() || self.luts.is_some()
    }

    /// Loads a scene and derives its hardware; within a budget, which look-up tables are estimated for, tells what was tried, too.
    pub fn load(
        &self,
        path: &Path,
        settings: &[String],
        estimator: impl FnOnce() -> Result<Estimator, Failure>,
    ) -> Result<(Scene, Planned), Failure> {
        let Self { device, luts } = *self;
        let scene = Scene::load(path, settings)?;
        if !self.is_limited() {
            let planned = if scene.motion.is_some() {
                Planned::Moving(Box::new(moving_plan_on(path, &scene, None)?))
            } else {
                Planned::Still(Box::new(plan_on(path, &scene, None)?), vec![])
            };
            return Ok((scene, planned));
        }
        let budgeted = Budgeted::of(&scene, Budget { luts, device }, &estimator()?);
        let Budgeted { plan, tried } = budgeted.map_err(|error| match error {
            BudgetError::Plan(source) => Failure::Plan { path: path.to_owned(), source: Box::new(source) },
            BudgetError::Generate(error) => error.into(),
            error @ BudgetError::TooSmall { .. } => Failure::Budget { path: path.to_owned(), source: Box::new(error) },
        })?;
        warn(path, &scene, &plan);
        Ok((scene, Planned::Still(Box::new(plan), tried)))
    }
}

/// Hardware for a scene.
pub enum Planned {
    /// In which nothing moves while the shutter is open, and what was tried within a budget.
    Still(Box<Plan>, Vec<Candidate>),
    /// In which something does.
    Moving(Box<MovingPlan>),
}

/// What was tried, a line each, the hardware that was chosen last.
pub fn tried(candidates: &[Candidate]) -> String {
    let heads =
        ["rasterizers", "cycles/splat", "copies", "cycles, from", "LUT4", "flip-flops", "block RAMs", "multipliers"];
    let [rasterizers, interval, copies, cycles, lut4, flip_flops, block_rams, multipliers] = heads;
    let mut text = format!(
        "\n  {rasterizers:>11} {interval:>12} {copies:>9} {cycles:>12} {lut4:>9} {flip_flops:>10} {block_rams:>10} {multipliers:>11}\n"
    );
    for Candidate { rasterizers, interval, copies, cycles, needs, shortages } in candidates {
        let Needs { lut4, flip_flops, block_rams, multipliers, .. } = needs;
        let lut4 = lut4.map_or_else(String::new, |lut4| format!("{lut4:.0}"));
        let verdict = match &shortages[..] {
            [] => "chosen".to_owned(),
            _ => format!("too many {}", shortages.iter().map(|shortage| shortage.of).collect::<Vec<_>>().join(", ")),
        };
        _ = writeln!(
            text,
            "  {rasterizers:>11} {interval:>12} {copies:>9} {cycles:>12} {lut4:>9} {flip_flops:>10} {block_rams:>10} {multipliers:>11}  {verdict}"
        );
    }
    text
}
