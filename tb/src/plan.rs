//! Which hardware a scene calls for: the smallest configuration that renders it, with the reason for every choice.

use crate::scene::Scene;
use pointcore_golden::reference::{Footprint, Mapping, Projection};
use pointcore_spec::core_a::config::{Config, ConfigError, Feature, TILE_SIZE};
use pointcore_spec::splat::{CONTINUOUS_ATTRIBUTES, NORMAL};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Relative margin by which the filter must be idle in f64 before hardware of less precision may do without it.
const FILTER_MARGIN: f64 = 1.0 / 256.0;

/// Keys of the configuration that follow from the scene alone, and where it says them.
const SCENE_KEYS: [(&str, &str); 7] = [
    ("width", "set `image.width`"),
    ("height", "set `image.height`"),
    ("sampling", "set `image.sampling`"),
    ("depth", "set `splatting.depth`"),
    ("kernel_gamma", "set `splatting.kernel_gamma`"),
    ("continuous", "it counts the components of normal and color that differ between splats"),
    ("cardinal", "it is 1 where splats differ in `material`"),
];

/// An `[overrides]` table that does not fit the hardware or the scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// A key that is no parameter of the hardware.
    #[error("`overrides.{key}` is unknown: expected one of {expected}")]
    Unknown {
        /// The key.
        key: String,
        /// The keys there are.
        expected: String,
    },
    /// A parameter that follows from the scene.
    #[error("`overrides.{key}` follows from the scene and cannot be overridden: {place}")]
    Determined {
        /// The key.
        key: &'static str,
        /// Where the scene says it.
        place: &'static str,
    },
    /// A value of the wrong type, or none of the values there are.
    #[error("`overrides.{key}` = {value}: {problem}")]
    Value {
        /// The key.
        key: String,
        /// Its value.
        value: toml::Value,
        /// What would be right.
        problem: String,
    },
    /// A value that the scene contradicts.
    #[error("`overrides.{key}` = \"{value}\", but {conflict}")]
    Conflict {
        /// The key.
        key: &'static str,
        /// Its value.
        value: &'static str,
        /// What the scene needs, and what to do.
        conflict: String,
    },
    /// A number out of range.
    #[error("[overrides]: {0}")]
    Range(#[from] ConfigError),
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

    /// Parts of the hardware decide what the picture shows, so overrides may neither take nor add them at will.
    fn check(&self, config: &Config, filter_radius_px: Option<f64>) -> Result<(), PlanError> {
        let conflict = |key, value, conflict| Err(PlanError::Conflict { key, value, conflict });
        if !config.culling.is_on() && self.back_facing > 0 {
            let splats = self.back_facing;
            let problem =
                format!("{splats} splats of the scene face away from the eye and need it: remove the override");
            return conflict("culling", "off", problem);
        }
        match filter_radius_px {
            Some(radius) if !config.screen_filter.is_on() && self.filtered > 0 => {
                let splats = self.filtered;
                let problem = format!(
                    "{splats} splats of the scene are narrower than its filter of {radius} px: remove the override or set \
                     `splatting.filter_radius_px = 0`"
                );
                conflict("screen_filter", "off", problem)
            }
            None if config.screen_filter.is_on() => {
                let problem = "the scene switches it off: remove the override or `splatting.filter_radius_px = 0`";
                conflict("screen_filter", "on", problem.to_owned())
            }
            _ => Ok(()),
        }
    }
}

impl Plan {
    /// The same frame on hardware with everything in: what leaving parts out is measured against.
    #[must_use]
    pub fn with_everything(&self) -> Self {
        let config = Config {
            culling: Feature::On,
            screen_filter: Feature::On,
            continuous: CONTINUOUS_ATTRIBUTES as u32,
            cardinal: self.config.cardinal.max(1),
            heap_levels: self.config.heap_levels.max(Config::default().heap_levels),
            ..self.config.clone()
        };
        let attributes = (0..CONTINUOUS_ATTRIBUTES).collect();
        Self { config, attributes, constants: [None; CONTINUOUS_ATTRIBUTES], choices: Vec::new() }
    }

    /// Derives the hardware from the scene; its `[overrides]` have the last word.
    ///
    /// # Errors
    /// Overrides that are no keys of the configuration, that the scene contradicts, or that the hardware cannot hold.
    pub fn of(scene: &Scene) -> Result<Self, PlanError> {
        Self::with_overrides(scene, &scene.overrides)
    }

    /// Derives the hardware from the scene, with overrides in the place of its own.
    ///
    /// # Errors
    /// As [`Plan::of`].
    pub fn with_overrides(scene: &Scene, overrides: &toml::Table) -> Result<Self, PlanError> {
        let mut choices = Vec::new();
        let demand = scene.splats.par_iter().map(|splat| demand(scene, splat)).reduce(Demand::default, Demand::sum);
        let mut config = Config {
            width: u32::try_from(scene.rendering.width).unwrap_or(u32::MAX),
            height: u32::try_from(scene.rendering.height).unwrap_or(u32::MAX),
            sampling: scene.rendering.sampling,
            depth: scene.rendering.depth,
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

        config = overridden(&config, overrides)?;
        demand.check(&config, scene.rendering.filter_radius_px)?;
        for (key, value) in overrides {
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
    let mut table = toml::Table::try_from(config).expect("a configuration is a TOML table");
    for (key, value) in overrides {
        if let Some(&(key, place)) = SCENE_KEYS.iter().find(|(determined, _)| determined == key) {
            return Err(PlanError::Determined { key, place });
        }
        let wrong = |problem| PlanError::Value { key: key.clone(), value: value.clone(), problem };
        let Some(planned) = table.get(key) else {
            let determined = |key: &str| SCENE_KEYS.iter().any(|(determined, _)| *determined == key);
            let keys: Vec<_> = table.keys().filter(|key| !determined(key)).map(|key| format!("`{key}`")).collect();
            return Err(PlanError::Unknown { key: key.clone(), expected: keys.join(", ") });
        };
        if !planned.same_type(value) {
            return Err(wrong(format!("expected a value such as {planned}")));
        }
        table.insert(key.clone(), value.clone());
        // Key by key, so that the error is that of this key; its first line leaves out the key, which stands there already.
        Config::deserialize(table.clone())
            .map_err(|error| wrong(error.message().lines().next().unwrap_or_default().to_owned()))?;
    }
    Ok(table.try_into().expect("every replaced key was tried"))
}

#[cfg(test)]
mod tests;
