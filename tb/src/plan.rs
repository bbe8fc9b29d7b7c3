//! Which hardware a scene calls for: the smallest configuration that renders it, with the reason for every choice.

use crate::scene::Scene;
use pointcore_golden::reference::{Footprint, Mapping, Projection};
use pointcore_spec::core_a::config::{Config, ConfigError, Feature, TILE_SIZE};
use pointcore_spec::splat::{CONTINUOUS_ATTRIBUTES, NORMAL};
use rayon::prelude::*;
use serde::Serialize;

/// Relative margin by which the filter must be idle in f64 before hardware of less precision may do without it.
const FILTER_MARGIN: f64 = 1.0 / 256.0;

/// A scene asks for hardware that does not exist.
#[derive(Debug, thiserror::Error)]
pub enum PlanError {
    /// The `[overrides]` table has an unknown key or a value of the wrong type.
    #[error("[overrides]: {0}")]
    Overrides(String),
    /// A parameter is out of range.
    #[error("[overrides] or the scene asks for a core that cannot be built: {0}")]
    Config(#[from] ConfigError),
}

/// A part of the hardware that a scene may do without, or the size of one.
#[derive(Clone, Debug, Serialize)]
pub struct Choice {
    /// The part.
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
    /// Index into [`pointcore_spec::Splat::attributes`] of each continuous attribute the hardware carries.
    pub attributes: Vec<usize>,
    /// Values of the attributes that are the same for all splats, and so need no hardware.
    pub constants: [Option<f32>; CONTINUOUS_ATTRIBUTES],
    /// What was chosen and why.
    pub choices: Vec<Choice>,
}

/// What the f64 analysis finds in a scene.
#[derive(Clone, Copy, Default)]
struct Demand {
    back_facing: usize,
    filtered: usize,
    drawn: usize,
    copies: usize,
}

impl Demand {
    fn sum(self, other: Self) -> Self {
        Self {
            back_facing: self.back_facing + other.back_facing,
            filtered: self.filtered + other.filtered,
            drawn: self.drawn + other.drawn,
            copies: self.copies + other.copies,
        }
    }
}

impl Plan {
    /// Derives the hardware from the scene; its `[overrides]` have the last word.
    ///
    /// # Errors
    /// Overrides that are no keys of the configuration, or a configuration the hardware cannot hold.
    pub fn of(scene: &Scene) -> Result<Self, PlanError> {
        let mut choices = Vec::new();
        let demand = scene.splats.par_iter().map(|splat| demand(scene, splat)).reduce(Demand::default, Demand::sum);
        let mut config = Config {
            width: u32::try_from(scene.rendering.width).unwrap_or(u32::MAX),
            height: u32::try_from(scene.rendering.height).unwrap_or(u32::MAX),
            kernel_gamma: scene.rendering.kernel_gamma,
            ..Config::default()
        };
        let total = scene.splats.len();

        config.culling = feature(demand.back_facing > 0);
        choices.push(Choice {
            part: "back-face culling",
            chosen: on_off(config.culling),
            reason: format!("{} of {total} splats face away from the eye", demand.back_facing),
        });

        config.screen_filter = feature(demand.filtered > 0 && scene.rendering.filter_radius_px.is_some());
        choices.push(Choice {
            part: "screen filter",
            chosen: on_off(config.screen_filter),
            reason: match scene.rendering.filter_radius_px {
                Some(radius) => format!(
                    "{} of {} drawn splats are narrower on the screen than the filter's {radius} px",
                    demand.filtered, demand.drawn
                ),
                None => "the scene switches it off".to_owned(),
            },
        });

        let (attributes, constants) = attributes(scene);
        config.continuous = u32::try_from(attributes.len()).unwrap_or(u32::MAX);
        choices.push(Choice {
            part: "continuous attributes",
            chosen: config.continuous.to_string(),
            reason: format!(
                "{} of {CONTINUOUS_ATTRIBUTES} (normal, color) differ between splats; the others are constants of the scene",
                attributes.len()
            ),
        });

        let first = scene.splats.first().map_or(0, |splat| splat.material);
        let materials = scene.splats.iter().any(|splat| splat.material != first);
        config.cardinal = materials.into();
        choices.push(Choice {
            part: "cardinal attributes",
            chosen: config.cardinal.to_string(),
            reason: if materials { "splats differ in material" } else { "all splats have one material" }.to_owned(),
        });

        let needed = demand.copies.max(2).ilog2() + 1;
        config.heap_levels = config.heap_levels.min(needed.max(2));
        choices.push(Choice {
            part: "heap",
            chosen: format!("{} levels", config.heap_levels),
            reason: format!(
                "{} splat copies pass the reorder stage, it holds {}",
                demand.copies,
                config.heap_capacity()
            ),
        });

        config = overridden(&config, &scene.overrides)?;
        for (key, value) in &scene.overrides {
            let (chosen, reason) = (format!("{key} = {value}"), "the scene's [overrides] say so".to_owned());
            choices.push(Choice { part: "override", chosen, reason });
        }
        config.validate()?;
        Ok(Self { config, attributes, constants, choices })
    }
}

fn feature(needed: bool) -> Feature {
    if needed { Feature::On } else { Feature::Off }
}

fn on_off(feature: Feature) -> String {
    if feature.is_on() { "generated" } else { "left out" }.to_owned()
}

/// What one splat asks for.
fn demand(scene: &Scene, splat: &pointcore_spec::Splat) -> Demand {
    use pointcore_golden::reference::Culled;
    let projection = match Projection::new(splat, &scene.camera) {
        Ok(projection) => projection,
        Err(culled) => return Demand { back_facing: usize::from(culled == Culled::BackFacing), ..Demand::default() },
    };
    let Ok(footprint) = Footprint::new(&projection, &scene.rendering, Mapping::Backward) else {
        return Demand::default();
    };
    let tile = TILE_SIZE as usize;
    let tiles = |range: &std::ops::Range<usize>| (range.end - 1) / tile - range.start / tile + 1;
    let radius = scene.rendering.filter_radius_px.unwrap_or(0.0);
    Demand {
        back_facing: 0,
        filtered: usize::from(!covers_disc(&projection, radius)),
        drawn: 1,
        copies: tiles(&footprint.bounds.columns) * tiles(&footprint.bounds.rows),
    }
}

/// Whether the splat's projection contains the disc of that radius (px) about its centre, so that a filter of the radius
/// never decides: `ρ² ≤ dist²/radius²` at every sample.
///
/// With `J` the projection's Jacobian, `ρ ≤ dist/(σ_min(J)·D/Δ)`, and `D/Δ ≥ 1/(1 + |(α, β)|)` on the splat.
fn covers_disc(projection: &Projection, radius: f64) -> bool {
    let ([ax, bx], [ay, by]) = (projection.gradient_x, projection.gradient_y);
    let (sum, difference) = ((ax + by).hypot(ay - bx), (ax - by).hypot(ay + bx));
    let smallest_extent = (sum - difference).abs() / 2.0;
    let [alpha, beta] = projection.slant;
    !projection.crosses_eye_plane() && smallest_extent >= radius * (1.0 + alpha.hypot(beta)) * (1.0 + FILTER_MARGIN)
}

/// Indices of the attributes that differ between splats (at least one is carried), and the values of the others.
fn attributes(scene: &Scene) -> (Vec<usize>, [Option<f32>; CONTINUOUS_ATTRIBUTES]) {
    let constant = |index: usize| {
        let first = scene.splats.first().map(|splat| splat.attributes[index])?;
        scene.splats.iter().all(|splat| splat.attributes[index] == first).then_some(first)
    };
    let mut constants: [_; CONTINUOUS_ATTRIBUTES] = std::array::from_fn(constant);
    if constants.iter().all(Option::is_some) {
        constants[NORMAL.start] = None;
    }
    let varying = (0..CONTINUOUS_ATTRIBUTES).filter(|&index| constants[index].is_none()).collect();
    (varying, constants)
}

/// A configuration with some of its keys replaced.
fn overridden(config: &Config, overrides: &toml::Table) -> Result<Config, PlanError> {
    let wrong = |error: &dyn std::fmt::Display| PlanError::Overrides(error.to_string().trim_end().to_owned());
    let mut table = toml::Table::try_from(config).map_err(|error| wrong(&error))?;
    table.extend(overrides.clone());
    table.try_into().map_err(|error| wrong(&error))
}
