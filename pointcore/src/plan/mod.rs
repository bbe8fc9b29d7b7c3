//! Which hardware a scene calls for: the smallest configuration that renders it, with the reason for every choice.
//!
//! No bit of the frame hangs on what is left out: that is asked of the golden models, splat by splat, and where samples are too many, of
//! bounds on their rounding that hold with a margin of two.

mod attributes;
mod choices;
mod demand;
mod depth;
mod effect;
mod error;
mod given;
mod moving;
mod overrides;
mod planner;

pub use depth::DepthLoss;
pub use effect::{Effect, EffectExtent};
pub use error::PlanError;
pub use moving::MovingPlan;
pub use planner::{Planner, Size, Work};

use crate::scene::Scene;
use pointcore_contract::Splat;
use pointcore_contract::splat::config::{Config, Feature};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use serde::Serialize;

/// What was chosen for a scene, and why.
#[derive(Clone, Debug, Serialize)]
pub struct Choice {
    /// The effect whose extent was chosen, if it is one.
    pub effect: Option<Effect>,
    /// What was chosen about.
    pub part: &'static str,
    /// What was chosen.
    pub chosen: String,
    /// Why, in terms of the scene.
    pub reason: String,
}

/// The hardware for a scene.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The configuration.
    pub config: Config,
    /// Columns and rows of the scene's image, which may be smaller than the hardware's.
    pub image: [usize; 2],
    /// Index into [`pointcore_contract::Splat::attributes`] of each continuous attribute the hardware is given.
    pub attributes: Vec<usize>,
    /// Values of the attributes that are the same for all splats, and so need no hardware.
    pub constants: [Option<f32>; CONTINUOUS_ATTRIBUTES],
    /// The material of splats that have but one, and so need no hardware for it.
    pub material: u16,
    /// What was chosen and why.
    pub choices: Vec<Choice>,
    /// Whether the scene has a screen filter at all.
    is_filtered: bool,
}

impl Plan {
    /// Derives the hardware from the scene; its `[overrides]` have the last word.
    ///
    /// # Errors
    /// The scene moves while the shutter is open; overrides that are no keys of the configuration, that the scene contradicts, or that the hardware
    /// cannot hold.
    pub fn of(scene: &Scene) -> Result<Self, PlanError> {
        Self::with_overrides(scene, &scene.overrides)
    }

    /// Derives the hardware from the scene, with overrides in the place of its own.
    ///
    /// # Errors
    /// As [`Plan::of`].
    pub fn with_overrides(scene: &Scene, overrides: &toml::Table) -> Result<Self, PlanError> {
        let planner = Planner::new(scene, overrides)?;
        planner.plan(planner.size())
    }
}
/// The configuration with every effect that the scene may have: what decides which of them it needs.
fn everything(scene: &Scene, config: &Config) -> Config {
    let screen_filter = feature(is_filtered(scene));
    Config { culling: Feature::On, eye_plane: Feature::On, screen_filter, ..config.clone() }
}

const fn is_filtered(scene: &Scene) -> bool {
    scene.rendering.filter_radius_px.is_some()
}

/// The first splat's material, and whether fragments must say of which they are, for others have another.
fn materials<'a>(splats: impl Iterator<Item = &'a Splat>) -> (u16, bool) {
    let mut materials = splats.map(|splat| splat.material);
    let first = materials.next().unwrap_or_default();
    (first, materials.any(|material| material != first))
}

const fn feature(needed: bool) -> Feature {
    if needed { Feature::On } else { Feature::Off }
}

#[cfg(test)]
mod tests;
