//! Why a scene has no hardware, or cannot be rendered on some.

use pointcore_contract::splat::config::ConfigError;

/// Hardware that does not fit a scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// A scene that moves while the shutter is open, where a still one is asked for.
    #[error(
        "the scene moves while the shutter is open, and a still one is asked for: take `[shutter]` and all `motion` tables out; `run`, `plan` and `gen` know \
         scenes that move, but no budget or table of several"
    )]
    Moving,
    /// A way to settle what hides what of which there is no hardware.
    #[error(
        "`splatting.motion` = \"{method}\", but hardware has 1, 2, 4, … up to {most} bins of the exposure: say \"bins:{most}\", or render by \
         `pointcore run SCENE --model reference`"
    )]
    Method {
        /// What the scene asks for.
        method: String,
        /// The most bins.
        most: u32,
    },
    /// A key of `[overrides]` that is no parameter of the hardware.
    #[error("`overrides.{key}` is unknown: expected one of {expected}")]
    Unknown {
        /// The key.
        key: String,
        /// The keys there are.
        expected: String,
    },
    /// A table of the configuration's file.
    #[error("`overrides.{table}`: overrides are written without the table, such as `overrides.heap_levels`")]
    Table {
        /// The table.
        table: &'static str,
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
    /// A value of `[overrides]` that the scene contradicts.
    #[error("`overrides.{key}` = \"{value}\", but {reason}: remove the override{alternative}")]
    Conflict {
        /// The key.
        key: &'static str,
        /// Its value.
        value: &'static str,
        /// What the scene needs.
        reason: String,
        /// What else to do.
        alternative: &'static str,
    },
    /// An effect that a given configuration has not.
    #[error("the scene calls for {effect} ({reason}), which the configuration's `{key}` = {value} excludes: {remedy}")]
    Excluded {
        /// The effect.
        effect: &'static str,
        /// Why the scene calls for it.
        reason: String,
        /// The configuration's key.
        key: &'static str,
        /// Its value, as the file says it.
        value: String,
        /// What to do.
        remedy: String,
    },
    /// A number out of range.
    #[error("[overrides]: {0}")]
    Range(#[from] ConfigError),
}
