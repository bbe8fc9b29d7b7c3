//! Hardware for a scene that moves while the shutter is open (thesis ch. 4): with bins of the exposure for what moves, and today's for what stands
//! still.

use super::attributes::differing;
use super::choices::{fixed, of};
use super::demand::Demand;
use super::given::{self, held};
use super::planner::Planner;
use super::{Choice, Effect, Plan, PlanError, materials};
use crate::scene::Scene;
use pointcore_contract::splat::motion::TIME_BINS_MAX;
use pointcore_contract::splat::{Config, Feature};
use pointcore_golden::reference::motion::{Method, MovingSplat};

/// The hardware for a scene that moves.
#[derive(Clone, Debug)]
pub struct MovingPlan {
    /// For what moves.
    pub moving: Plan,
    /// For what stands still, if anything does.
    pub still: Option<Plan>,
}

impl MovingPlan {
    /// Derives both from the scene, whose `[overrides]` have the last word on each.
    ///
    /// # Errors
    /// As [`Plan::of`], and if the scene's `splatting.motion` is none that hardware has.
    pub fn of(scene: &Scene) -> Result<Self, PlanError> {
        Self::with_overrides(scene, &scene.overrides)
    }

    /// The same with overrides in the place of the scene's own.
    ///
    /// # Errors
    /// As [`MovingPlan::of`].
    pub fn with_overrides(scene: &Scene, overrides: &toml::Table) -> Result<Self, PlanError> {
        let still = scene.still_part();
        let planner = Planner::of_moving(scene, still.is_some(), overrides)?;
        let moving = planner.plan(planner.size())?;
        let still = still.map(|still| Plan::with_overrides(&still, overrides)).transpose()?;
        Ok(Self { moving, still })
    }

    /// What moves on given hardware as it is, and what stands still on its own.
    ///
    /// # Errors
    /// The first effect that what moves calls for and the configuration excludes.
    pub fn on(scene: &Scene, config: &Config) -> Result<Self, PlanError> {
        let (time_bins, _) = time_bins(scene)?;
        let excluded = |effect, reason, value: u32, remedy| {
            given::excluded(effect, reason, "time_bins", value.to_string(), remedy)
        };
        if !config.has_motion() {
            let reason = "it moves while the shutter is open".to_owned();
            return excluded("motion blur", reason, 0, format!("set `time_bins = {time_bins}`"));
        }
        if matches!(method(scene), Some(Method::Bins(_))) && time_bins != config.time_bins {
            let reason = format!("its `splatting.motion` is \"bins:{time_bins}\"");
            let remedy = format!(
                "set `time_bins = {time_bins}`, or the scene's `splatting.motion = \"bins:{}\"`",
                config.time_bins
            );
            return excluded("other bins of the exposure", reason, config.time_bins, remedy);
        }
        let splats = scene.moving_part(config.time_bins as usize);
        let each = || splats.iter().map(|moving| &moving.splat);
        let constants = differing(each());
        let plan = held(scene, config, constants, materials(each()))?;
        let still = scene.still_part();
        if still.is_some() && !config.merge.is_on() {
            return given::without_depths("what stands still in it may hide what moves".to_owned());
        }
        let everything = Config { eye_plane: Feature::On, ..config.clone() };
        let demand = Demand::of_moving(scene, &splats, &everything);
        let moving = plan.meeting(scene, &demand)?;
        let still = still.map(|still| Plan::with_overrides(&still, &toml::Table::new())).transpose()?;
        Ok(Self { moving, still })
    }
}

fn method(scene: &Scene) -> Option<Method> {
    scene.motion.as_ref().and_then(|motion| motion.method)
}

/// Bins of the exposure that hardware for a scene has, and why.
pub(super) fn time_bins(scene: &Scene) -> Result<(u32, String), PlanError> {
    let most = TIME_BINS_MAX as u32;
    match method(scene) {
        None => {
            // A sample is covered in few bins, so that many take hardly longer.
            Ok((most, "`splatting.motion` leaves it open; fewer would err more, and be hardly faster".to_owned()))
        }
        Some(Method::Bins(bins)) if bins.is_power_of_two() && bins as u32 <= most => {
            Ok((bins as u32, format!("`splatting.motion` is \"bins:{bins}\"")))
        }
        Some(method) => Err(PlanError::Method { method: method.to_string(), most }),
    }
}

/// What was chosen for motion alone.
pub(super) fn choices(
    scene: &Scene,
    splats: &[MovingSplat],
    demand: &Demand,
    config: &Config,
    reason: String,
) -> Vec<Choice> {
    let time_bins = config.time_bins;
    let parts = splats.len();
    let discs = demand.discs;
    let filter = match scene.rendering.filter_radius_px {
        Some(radius) => {
            format!("{discs} of {parts} are narrower than the filter's {radius} px, whose disc is sent, too")
        }
        None => "the scene switches it off".to_owned(),
    };
    let chosen = if discs > 0 { "on the host" } else { "left out" };
    vec![
        of(Effect::TimeBins, format!("{time_bins} bins"), reason),
        fixed(
            "what moves",
            &format!("{parts} splats"),
            &format!(
                "straight parts of the ways of splats that move, each in a bin, of {} splats in the scene",
                scene.splats.len()
            ),
        ),
        if config.merge.is_on() {
            fixed("merge", "depths in memory", "what stands still hides what moves behind it")
        } else {
            fixed("merge", "none", "nothing stands still; no depths are read from memory")
        },
        fixed("screen filter", chosen, &filter),
        fixed("back-face culling", "generated", "a splat that moves lives while it faces the eye"),
    ]
}
