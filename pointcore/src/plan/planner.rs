//! From what a scene asks for to hardware of one size or another.

use super::attributes::{constants, differing, filter_conflict, material_conflict, varying};
use super::demand::Demand;
use super::given::{Conflict, conflict};
use super::overrides::overridden;
use super::{Choice, Plan, PlanError, choices, everything, feature, is_filtered, materials, moving};
use crate::scene::Scene;
use pointcore_contract::splat::{Config, Feature};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;

/// The most cycles that a splat may take in transform and setup.
const INTERVAL_MAX: u32 = 16;
/// The fewest for one that moves: setup has 190 products then, and sharing its operators over less saves a few percent of a frame's time at most.
const MOVING_INTERVAL_MIN: u32 = 4;

/// How large hardware is to be that renders the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Rasterizers.
    pub rasterizers: u32,
    /// By how many powers of two splats take longer in transform and setup than rasterizers need.
    pub slower: u32,
    /// Levels of copies and payloads that are missing from what hides the frame that leaves.
    pub fewer_levels: u32,
}

/// What there is to do in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    /// Splats.
    pub splats: u64,
    /// Copies of them, one a tile.
    pub copies: u64,
    /// Samples within their bounds.
    pub samples: u64,
}

/// What a scene asks for, once; and the hardware of every size that gives it.
pub struct Planner<'a> {
    scene: &'a Scene,
    overrides: &'a toml::Table,
    /// The scene's image and formats, with the overrides in.
    asked: Config,
    /// The same without.
    config: Config,
    demand: Demand,
    attributes: Vec<usize>,
    constants: [Option<f32>; CONTINUOUS_ATTRIBUTES],
    /// The first splat's, and whether there are others.
    materials: (u16, bool),
    /// Why the hardware has so many bins of the exposure, if it has any.
    motion: Vec<Choice>,
}

impl<'a> Planner<'a> {
    /// Looks at all of a scene's splats.
    ///
    /// # Errors
    /// As [`Plan::of`], of what does not depend on the size.
    pub fn new(scene: &'a Scene, overrides: &'a toml::Table) -> Result<Self, PlanError> {
        if scene.motion.is_some() {
            return Err(PlanError::Moving);
        }
        let config = of_scene(scene, 0);
        // What a splat asks for depends on the number format.
        let asked = overridden(&config, overrides)?;
        asked.validate()?;
        if let Some((value, reason)) = filter_conflict(scene, asked.raster_format()) {
            let alternative = " or choose another `splatting.filter_radius_px`";
            return Err(PlanError::Conflict { key: "rasterizer", value, reason, alternative });
        }
        let demand = Demand::of(scene, &everything(scene, &asked));
        let constants = constants(scene);
        let attributes = varying(&constants);
        let materials = materials(scene.splats.iter());
        let motion = Vec::new();
        Ok(Self { scene, overrides, asked, config, demand, attributes, constants, materials, motion })
    }

    /// Looks at what moves of a scene, which something that stands still may hide.
    ///
    /// # Errors
    /// As [`MovingPlan::of`](super::MovingPlan::of), of what does not depend on the size.
    pub(super) fn of_moving(
        scene: &'a Scene,
        may_be_hidden: bool,
        overrides: &'a toml::Table,
    ) -> Result<Self, PlanError> {
        let (time_bins, reason) = moving::time_bins(scene)?;
        let splats = &scene.moving_part(time_bins as usize);
        let config = Config { merge: feature(may_be_hidden), ..of_scene(scene, time_bins) };
        let asked = overridden(&config, overrides)?;
        asked.validate()?;
        let everything = Config { eye_plane: Feature::On, ..asked.clone() };
        let demand = Demand::of_moving(scene, splats, &everything);
        let constants = differing(splats.iter().map(|moving| &moving.splat));
        let materials = materials(splats.iter().map(|moving| &moving.splat));
        let motion = moving::choices(scene, splats, &demand, &config, reason);
        let attributes = varying(&constants);
        Ok(Self { scene, overrides, asked, config, demand, attributes, constants, materials, motion })
    }

    /// The size without a budget.
    #[must_use]
    pub const fn size(&self) -> Size {
        Size { rasterizers: self.asked.rasterizers, slower: 0, fewer_levels: 0 }
    }

    /// Whether the scene leaves a parameter of the hardware open.
    #[must_use]
    pub fn is_free(&self, key: &str) -> bool {
        !self.overrides.contains_key(key)
    }

    /// What there is to do in a frame: of each the most, where there are several.
    #[must_use]
    pub const fn work(&self) -> Work {
        let Demand { copies, load, .. } = self.demand;
        Work { splats: load.splats as u64, copies: copies as u64, samples: load.samples as u64 }
    }

    /// The hardware of a size; overrides have the last word.
    ///
    /// # Errors
    /// As [`Plan::of`].
    pub fn plan(&self, size: Size) -> Result<Plan, PlanError> {
        let Self { scene, overrides, ref demand, ref attributes, .. } = *self;
        let mut config = Config { rasterizers: size.rasterizers, ..self.config.clone() };
        let is_moving = config.has_motion();
        config.eye_plane = feature(demand.crossing > 0);
        config.continuous = u32::try_from(attributes.len()).unwrap_or(u32::MAX);
        config.cardinal = self.materials.1.into();
        // A splat has two copies or so. A lane has its share of all of them.
        let levels = demand.copy_levels();
        let lane_levels = |count: usize| (count.max(1).ilog2() + 1).saturating_sub(config.rasterizer_bits());
        let fewer = |levels: u32| levels.saturating_sub(size.fewer_levels);
        let [copies, splats] = [lane_levels(demand.copies), lane_levels(demand.drawn)];
        config.splat_levels = fewer(config.splat_levels.max(levels - 1).min(splats));
        config.heap_levels = fewer(levels.min(copies)).max(2);
        let [columns, rows] = demand.tiles();
        config.tile_slots = config.tile_slots.min((columns * rows).max(2));
        config.memory_ports = demand.memory_ports(config.rasterizers);
        let least = if is_moving { MOVING_INTERVAL_MIN } else { 1 };
        let interval = (demand.load.interval(config.rasterizers) << size.slower).clamp(least, INTERVAL_MAX);
        (config.transform_interval, config.setup_interval) = (interval, interval);
        let mut choices = if is_moving {
            self.motion.iter().cloned().chain(choices::of_any(scene, &config, demand)).collect()
        } else {
            config.culling = feature(demand.back_facing > 0);
            config.screen_filter = feature(demand.filtered > 0 && is_filtered(scene));
            choices::of_still(scene, &config, demand)
        };

        config = overridden(&config, overrides)?;
        if let Some(value) = overrides.get("continuous").filter(|_| config.continuous < attributes.len() as u32) {
            let differing = attributes.len();
            let problem = format!(
                "{differing} components of normal and color differ between splats: expected {differing} at least"
            );
            return Err(PlanError::Value { key: "continuous".to_owned(), value: value.clone(), problem });
        }
        if let Some(Conflict { effect, value, reason, alternative }) = conflict(scene, &config, demand) {
            return Err(PlanError::Conflict { key: effect.key(), value, reason, alternative });
        }
        if let Some((value, reason)) = material_conflict(scene, config.attribute) {
            let alternative = " or choose a wider format";
            return Err(PlanError::Conflict { key: "attribute", value, reason, alternative });
        }
        for (key, value) in overrides {
            let (chosen, reason) = (format!("{key} = {value}"), "the scene's [overrides] say so".to_owned());
            choices.push(Choice { effect: None, part: "override", chosen, reason });
        }
        config.validate()?;
        let image = [scene.rendering.width, scene.rendering.height];
        let (attributes, constants) = (attributes.clone(), self.constants);
        let (material, is_filtered) = (self.materials.0, !is_moving && is_filtered(scene));
        Ok(Plan { config, image, attributes, constants, material, choices, is_filtered })
    }
}

/// What a configuration says as its scene does, with so many bins of the exposure.
fn of_scene(scene: &Scene, time_bins: u32) -> Config {
    let edge = |edge: usize| u32::try_from(edge).unwrap_or(u32::MAX);
    let still = Config {
        width: edge(scene.rendering.width),
        height: edge(scene.rendering.height),
        sampling: scene.rendering.sampling,
        depth: scene.rendering.depth,
        kernel_gamma: scene.rendering.kernel_gamma,
        merge: feature(scene.is_merged()),
        ..Config::default()
    };
    if time_bins == 0 {
        return still;
    }
    // Shares of the exposure are differences of the kernel's integral: its table has to be fine.
    Config { time_bins, screen_filter: Feature::Off, culling: Feature::On, kernel_index_bits: 10, ..still }
}
