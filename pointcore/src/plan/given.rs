//! A scene on hardware that it was not planned for, and what no hardware may lack.

use super::attributes::{constants, filter_conflict, material_conflict, varying};
use super::choices::merged;
use super::demand::Demand;
use super::{Effect, Plan, PlanError, everything, is_filtered, materials};
use crate::scene::Scene;
use pointcore_contract::Rendering;
use pointcore_contract::splat::{Config, Feature};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use serde::Serialize;

/// What a configuration lacks, or has against the scene's will.
pub(super) struct Conflict {
    pub effect: Effect,
    pub value: &'static str,
    pub reason: String,
    /// What helps besides another configuration.
    pub alternative: &'static str,
}

impl Plan {
    /// The scene on given hardware as it is.
    ///
    /// # Errors
    /// The first effect that the scene calls for and the configuration excludes.
    pub fn on(scene: &Scene, config: &Config) -> Result<Self, PlanError> {
        if scene.motion.is_some() {
            return Err(PlanError::Moving);
        }
        if config.has_motion() {
            let (value, remedy) = (config.time_bins.to_string(), "set `time_bins = 0`".to_owned());
            return excluded("a still picture", "nothing in it moves".to_owned(), "time_bins", value, remedy);
        }
        let plan = held(scene, config, constants(scene), materials(scene.splats.iter()))?;
        plan.meeting(scene, &Demand::of(scene, &everything(scene, config)))
    }

    /// The same, if the hardware has what splats demand.
    pub(super) fn meeting(self, scene: &Scene, demand: &Demand) -> Result<Self, PlanError> {
        let Some(Conflict { effect, value, reason, alternative }) = conflict(scene, &self.config, demand) else {
            return Ok(self);
        };
        let (right, name) = match value {
            "off" => ("on", effect.name()),
            _ => ("off", "no screen filter"),
        };
        let remedy = format!("set `{} = \"{right}\"`{alternative}", effect.key());
        excluded(name, reason, effect.key(), format!("\"{value}\""), remedy)
    }
}

/// What a scene calls for and a configuration excludes.
pub(super) fn excluded<T>(
    effect: &'static str,
    reason: String,
    key: &'static str,
    value: String,
    remedy: String,
) -> Result<T, PlanError> {
    Err(PlanError::Excluded { effect, reason, key, value, remedy })
}

/// The same where nothing is tested against depths in memory.
pub(super) fn without_depths<T>(reason: String) -> Result<T, PlanError> {
    excluded("depths in memory", reason, "merge", "\"off\"".to_owned(), "set `merge = \"on\"`".to_owned())
}

/// A scene on hardware as it is, if that holds image, kernel and the attributes that differ between splats.
pub(super) fn held(
    scene: &Scene,
    config: &Config,
    constants: [Option<f32>; CONTINUOUS_ATTRIBUTES],
    (material, has_materials): (u16, bool),
) -> Result<Plan, PlanError> {
    let image = [scene.rendering.width, scene.rendering.height];
    for (key, edge, held) in [("width", image[0], config.width), ("height", image[1], config.height)] {
        if edge > held as usize {
            let reason = format!("its `image.{key}` comes to {edge} samples");
            let remedy = format!("set `{key} = {edge}`, or a smaller `image.{key}`");
            return excluded("a larger image", reason, key, held.to_string(), remedy);
        }
    }
    let Rendering { sampling, depth, .. } = scene.rendering;
    for (effect, is_held, key, scene_key, asked, held) in [
        (
            "another sampling",
            sampling == config.sampling,
            "sampling",
            "image.sampling",
            quoted(&sampling),
            quoted(&config.sampling),
        ),
        (
            "another depth of samples",
            depth == config.depth,
            "depth",
            "splatting.depth",
            quoted(&depth),
            quoted(&config.depth),
        ),
    ] {
        if !is_held {
            let reason = format!("its `{scene_key}` is {asked}");
            let remedy = format!("set `{key} = {asked}`, or the scene's `{scene_key} = {held}`");
            return excluded(effect, reason, key, held, remedy);
        }
    }
    if scene.is_merged() && !config.merge.is_on() {
        return without_depths(format!("its {} may hide splats", merged(scene)));
    }
    let gamma = scene.rendering.kernel_gamma;
    if gamma.to_bits() != config.kernel_gamma.to_bits() {
        let (reason, value) = (format!("γ = {gamma}"), config.kernel_gamma.to_string());
        let remedy = format!("set `kernel_gamma = {gamma:?}`, or the scene's `splatting.kernel_gamma = {value}`");
        return excluded("another kernel", reason, "kernel_gamma", value, remedy);
    }
    let attributes = varying(&constants);
    let cardinal = u32::from(has_materials);
    for (effect, needed, held, remedy) in [
        (Effect::Continuous, attributes.len() as u32, config.continuous, "more components the same for all splats"),
        (Effect::Cardinal, cardinal, config.cardinal, "one `material` for all objects"),
    ] {
        if needed > held {
            let reason = format!("{needed} of them differ between splats");
            let remedy = format!("set `{} = {needed}`, or {remedy}", effect.key());
            return excluded(effect.name(), reason, effect.key(), held.to_string(), remedy);
        }
    }
    if let Some((value, reason)) = material_conflict(scene, config.attribute) {
        let remedy = "choose a wider format, or fewer materials".to_owned();
        return excluded("more materials", reason, "attribute", format!("\"{value}\""), remedy);
    }
    if let Some((value, reason)) = filter_conflict(scene, config.raster_format()) {
        let remedy = "choose a floating-point format, or another `splatting.filter_radius_px`".to_owned();
        return excluded("another screen filter", reason, "rasterizer", format!("\"{value}\""), remedy);
    }
    Ok(Plan {
        config: config.clone(),
        image,
        attributes,
        constants,
        material,
        choices: Vec::new(),
        is_filtered: is_filtered(scene),
    })
}

/// A name as a configuration says it.
fn quoted(name: &impl Serialize) -> String {
    toml::Value::try_from(name).map_or_else(|_| String::new(), |value| value.to_string())
}

/// Parts of the hardware decide what the picture shows, so that they may neither be missing nor be there at will.
pub(super) fn conflict(scene: &Scene, config: &Config, demand: &Demand) -> Option<Conflict> {
    let off = |effect, feature: Feature, needed: usize| (!feature.is_on() && needed > 0).then_some(effect);
    let filter = scene.rendering.filter_radius_px;
    let found = |effect, value, reason, alternative| Some(Conflict { effect, value, reason, alternative });
    if let Some(effect) = off(Effect::Culling, config.culling, demand.back_facing) {
        let reason = format!("{} splats of the scene face away from the eye and need it", demand.back_facing);
        return found(effect, "off", reason, "");
    }
    if let Some(effect) = off(Effect::EyePlane, config.eye_plane, demand.crossing) {
        let first = demand.first_crossing.unwrap_or_default();
        let reason = format!(
            "{} splats of the scene reach the near, far or eye plane, or might have a sample taken from beyond, splat {first} first",
            demand.crossing
        );
        return found(effect, "off", reason, "");
    }
    match filter {
        Some(radius) if !config.screen_filter.is_on() && demand.filtered > 0 => {
            let reason = format!("{} splats of the scene are narrower than its filter of {radius} px", demand.filtered);
            found(Effect::ScreenFilter, "off", reason, " or set `splatting.filter_radius_px = 0`")
        }
        None if config.screen_filter.is_on() => {
            let reason = "the scene switches it off".to_owned();
            found(Effect::ScreenFilter, "on", reason, " or `splatting.filter_radius_px = 0`")
        }
        _ => None,
    }
}
