//! What was chosen for a scene and why, before overrides.

use super::demand::Demand;
use super::{Choice, Effect};
use crate::scene::Scene;
use pointcore_contract::splat::config::{Config, Feature};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use pointcore_contract::{FragmentDepth, Sampling};

pub(super) fn of(effect: Effect, chosen: String, reason: String) -> Choice {
    Choice { effect: Some(effect), part: effect.name(), chosen, reason }
}

pub(super) fn fixed(part: &'static str, chosen: &str, reason: &str) -> Choice {
    Choice { effect: None, part, chosen: chosen.to_owned(), reason: reason.to_owned() }
}

fn on_off(feature: Feature) -> String {
    if feature.is_on() { "generated" } else { "left out" }.to_owned()
}

/// Of splats that stand still.
pub(super) fn of_still(scene: &Scene, config: &Config, demand: &Demand) -> Vec<Choice> {
    let Demand { back_facing, filtered, drawn, .. } = *demand;
    let filter = match scene.rendering.filter_radius_px {
        Some(radius) => {
            format!("{filtered} of {drawn} drawn splats are narrower on the screen than the filter's {radius} px")
        }
        None => "the scene switches it off".to_owned(),
    };
    let total = scene.splats.len();
    let mut choices = vec![
        of(Effect::Culling, on_off(config.culling), format!("{back_facing} of {total} splats face away from the eye")),
        of(Effect::ScreenFilter, on_off(config.screen_filter), filter),
    ];
    choices.extend(of_any(scene, config, demand));
    choices.push(if config.merge.is_on() {
        fixed("merge", "depths in memory", &format!("{} hide what lies behind them", merged(scene)))
    } else {
        fixed("merge", "none", "neither triangles nor other surfaces hide splats; no depths are read from memory")
    });
    choices.push(fixed(
        "motion",
        "none",
        "nothing moves while the shutter is open; there is no hardware for what does",
    ));
    choices
}

/// What fragments are tested against.
pub(super) fn merged(scene: &Scene) -> String {
    let triangles = (!scene.triangles.is_empty()).then(|| format!("{} triangles", scene.triangles.len()));
    let surfaces = (scene.surfaces.len() > 1).then(|| format!("{} surfaces", scene.surfaces.len()));
    triangles.into_iter().chain(surfaces).collect::<Vec<_>>().join(" and ")
}

/// Of splats whether they move or not.
pub(super) fn of_any(scene: &Scene, config: &Config, demand: &Demand) -> Vec<Choice> {
    let Demand { crossing, drawn, copies, .. } = *demand;
    let [columns, rows] = demand.tiles();
    let continuous = config.continuous;
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
        fixed(
            "memory ports",
            &config.memory_ports.to_string(),
            &format!(
                "up to {} pixels leave, one a cycle at each, and {copies} copies bring some back; rasterizers take {} of {} samples a cycle",
                demand.pixels(),
                config.rasterizers,
                demand.load.samples
            ),
        ),
        fixed(
            "transform, setup",
            &format!("{} cycles a splat", config.setup_interval),
            &format!(
                "{} splats come beside {} samples, of which the rasterizer takes one a cycle",
                demand.load.splats, demand.load.samples
            ),
        ),
        fixed("sampling", sampling.0, sampling.1),
        fixed("depth", depth.0, depth.1),
        fixed("lighting", "on the host", "fragments are shaded after the frame, whatever the light"),
    ]
}
