//! Which hardware a scene calls for: the smallest configuration that renders it, with the reason for every choice.
//!
//! No bit of the frame hangs on what is left out: that is asked of the golden models, splat by splat, and where samples are too many, of
//! bounds on their rounding that hold with a margin of two.

mod attributes;
mod demand;
mod depth;
mod effect;
mod error;
mod given;
mod overrides;
mod planner;

pub(crate) use attributes::differing;
pub use depth::DepthLoss;
pub use effect::{Effect, EffectExtent};
pub use error::PlanError;
pub use planner::{Planner, Size, Work};

use crate::scene::Scene;
use demand::Demand;
use pointcore_contract::splat::config::{Config, Feature};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use pointcore_contract::{FragmentDepth, Sampling};
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
/// What was chosen and why, before overrides.
fn choices(scene: &Scene, config: &Config, demand: &Demand) -> Vec<Choice> {
    let of = |effect: Effect, chosen: String, reason: String| Choice {
        effect: Some(effect),
        part: effect.name(),
        chosen,
        reason,
    };
    let fixed = |part, chosen: &str, reason: &str| Choice {
        effect: None,
        part,
        chosen: chosen.to_owned(),
        reason: reason.to_owned(),
    };
    let Demand { back_facing, filtered, crossing, drawn, copies, .. } = *demand;
    let interval = config.setup_interval;
    let [columns, rows] = demand.tiles();
    let (continuous, total) = (config.continuous, scene.splats.len());
    let filter = match scene.rendering.filter_radius_px {
        Some(radius) => {
            format!("{filtered} of {drawn} drawn splats are narrower on the screen than the filter's {radius} px")
        }
        None => "the scene switches it off".to_owned(),
    };
    let unlit = if scene.is_lit() { "" } else { "; without light shading reads no normal" };
    let attributes = format!(
        "{continuous} of {CONTINUOUS_ATTRIBUTES} (normal, color) differ between splats; the others are constants of the scene{unlit}"
    );
    let sampling = match scene.rendering.sampling {
        Sampling::Center => {
            ("center", "a sample in the middle of every pixel, or of the parts that `image.samples` makes of it")
        }
        Sampling::Flipquad => ("flipquad", "the scene shares samples between pixels"),
    };
    let depth = match scene.rendering.depth {
        FragmentDepth::Center => ("center", "all samples of a splat have its depth"),
        FragmentDepth::Plane => ("plane", "the scene gives each sample the depth of its splat's plane"),
    };
    let materials = if config.cardinal > 0 { "splats differ in material" } else { "all splats shine alike" };
    vec![
        of(Effect::Culling, on_off(config.culling), format!("{back_facing} of {total} splats face away from the eye")),
        of(Effect::ScreenFilter, on_off(config.screen_filter), filter),
        of(
            Effect::EyePlane,
            on_off(config.eye_plane),
            format!(
                "{crossing} of {drawn} drawn splats reach the near, far or eye plane, or might have a sample taken from beyond"
            ),
        ),
        of(Effect::Continuous, continuous.to_string(), attributes),
        of(Effect::Cardinal, config.cardinal.to_string(), materials.to_owned()),
        of(
            Effect::HeapLevels,
            format!("{} levels", config.heap_levels),
            format!("{copies} splat copies pass the reorder stage, it holds {}", config.copies_held()),
        ),
        fixed(
            "payloads",
            &format!("{} splats", config.splats_held()),
            &format!("{drawn} splats are drawn; the payload of one is held while a copy of it waits"),
        ),
        of(
            Effect::TileSlots,
            config.tile_slots.to_string(),
            format!(
                "what is drawn lies in {columns} × {rows} tiles; one loads while others are in use, more than there are stay empty"
            ),
        ),
        Choice {
            effect: None,
            part: "memory ports",
            chosen: config.memory_ports.to_string(),
            reason: format!(
                "up to {} pixels leave, one a cycle at each, and {copies} copies bring some back; rasterizers take {} of {} samples a cycle",
                demand.pixels(),
                config.rasterizers,
                demand.load.samples
            ),
        },
        Choice {
            effect: None,
            part: "transform, setup",
            chosen: format!("{interval} cycles a splat"),
            reason: format!(
                "{} splats come beside {} samples, of which the rasterizer takes one a cycle",
                demand.load.splats, demand.load.samples
            ),
        },
        fixed("sampling", sampling.0, sampling.1),
        fixed("depth", depth.0, depth.1),
        fixed("lighting", "on the host", "fragments are shaded after the frame, whatever the light"),
        fixed("motion", "none", "splats stand still within a frame; there is no hardware for anything else"),
    ]
}

/// The configuration with every effect that the scene may have: what decides which of them it needs.
fn everything(scene: &Scene, config: &Config) -> Config {
    let screen_filter = feature(is_filtered(scene));
    Config { culling: Feature::On, eye_plane: Feature::On, screen_filter, ..config.clone() }
}

const fn is_filtered(scene: &Scene) -> bool {
    scene.rendering.filter_radius_px.is_some()
}

/// Whether fragments must say of which material they are.
fn has_materials(scene: &Scene) -> bool {
    let first = scene.splats.first().map_or(0, |splat| splat.material);
    scene.splats.iter().any(|splat| splat.material != first)
}

const fn feature(needed: bool) -> Feature {
    if needed { Feature::On } else { Feature::Off }
}

fn on_off(feature: Feature) -> String {
    if feature.is_on() { "generated" } else { "left out" }.to_owned()
}

#[cfg(test)]
mod tests;
