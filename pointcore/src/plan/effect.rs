//! The effects that hardware may have or not, and how much of each.

use super::Plan;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::ATTRIBUTES_MAX;
use pointcore_contract::splat::motion::TIME_BINS_MAX;
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use serde::Serialize;

/// A part of the hardware that a scene may do without, or that may be smaller for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Effect {
    /// Splats that face away are dropped.
    Culling,
    /// No splat is narrower than a pixel.
    ScreenFilter,
    /// Splats may reach the eye plane.
    EyePlane,
    /// Attributes that are blended.
    Continuous,
    /// Attributes that are selected.
    Cardinal,
    /// Copies that are put in order at a time.
    HeapLevels,
    /// Tiles that are held at a time.
    TileSlots,
    /// Bins of the exposure, where splats move.
    TimeBins,
}

/// How much of an effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EffectExtent {
    /// None, or the smallest that hardware can be.
    Least,
    /// As much as any scene may ask for.
    Most,
}

/// The smallest heap and the fewest tile slots that hardware can have.
const LEAST: u32 = 2;

impl Effect {
    /// Those of hardware on which splats stand still.
    pub const STILL: [Self; 7] = [
        Self::Culling,
        Self::ScreenFilter,
        Self::EyePlane,
        Self::Continuous,
        Self::Cardinal,
        Self::HeapLevels,
        Self::TileSlots,
    ];

    /// Those of hardware on which splats move, which culls and has no screen filter in any case.
    pub const MOVING: [Self; 6] =
        [Self::TimeBins, Self::EyePlane, Self::Continuous, Self::Cardinal, Self::HeapLevels, Self::TileSlots];

    /// What it is called.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Culling => "back-face culling",
            Self::ScreenFilter => "screen filter",
            Self::EyePlane => "eye plane",
            Self::Continuous => "continuous attributes",
            Self::Cardinal => "cardinal attributes",
            Self::HeapLevels => "heap",
            Self::TileSlots => "tile slots",
            Self::TimeBins => "motion",
        }
    }

    /// The configuration's key.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Culling => "culling",
            Self::ScreenFilter => "screen_filter",
            Self::EyePlane => "eye_plane",
            Self::Continuous => "continuous",
            Self::Cardinal => "cardinal",
            Self::HeapLevels => "heap_levels",
            Self::TileSlots => "tile_slots",
            Self::TimeBins => "time_bins",
        }
    }
}

impl Plan {
    /// The effects that its hardware may have or not.
    #[must_use]
    pub const fn effects(&self) -> &'static [Effect] {
        if self.config.has_motion() { &Effect::MOVING } else { &Effect::STILL }
    }

    /// The same hardware with another extent of one effect, or as it is where no hardware has so many attributes, or so few. Without bins of the
    /// exposure it draws the still picture of the exposure's middle.
    #[must_use]
    pub fn at(&self, effect: Effect, extent: EffectExtent) -> Self {
        use pointcore_contract::splat::Feature::{Off, On};
        let mut plan = Self { choices: Vec::new(), ..self.clone() };
        let config = &mut plan.config;
        let default = Config::default();
        let is_most = extent == EffectExtent::Most;
        let feature = if is_most { On } else { Off };
        let size = |planned: u32, most: u32| if is_most { planned.max(most) } else { LEAST };
        match effect {
            Effect::Culling => config.culling = feature,
            // A scene that switches the filter off must not have it.
            Effect::ScreenFilter => config.screen_filter = if self.is_filtered { feature } else { Off },
            Effect::EyePlane => config.eye_plane = feature,
            Effect::Continuous if is_most => {
                config.continuous = config.continuous.max(CONTINUOUS_ATTRIBUTES as u32);
                plan.attributes = (0..CONTINUOUS_ATTRIBUTES).collect();
                plan.constants = [None; CONTINUOUS_ATTRIBUTES];
            }
            Effect::Continuous => {
                config.continuous = 1;
                plan.attributes.truncate(1);
            }
            Effect::Cardinal => config.cardinal = if is_most { config.cardinal.max(1) } else { 0 },
            Effect::HeapLevels => config.heap_levels = size(config.heap_levels, default.heap_levels),
            Effect::TileSlots => config.tile_slots = size(config.tile_slots, default.tile_slots),
            Effect::TimeBins => config.time_bins = if is_most { TIME_BINS_MAX as u32 } else { 0 },
        }
        if (1..=ATTRIBUTES_MAX).contains(&config.attributes()) {
            plan
        } else {
            Self { choices: Vec::new(), ..self.clone() }
        }
    }

    /// The same frame on hardware with everything in: what leaving parts out is measured against.
    #[must_use]
    pub fn with_everything(&self) -> Self {
        self.effects().iter().fold(self.clone(), |plan, &effect| plan.at(effect, EffectExtent::Most))
    }
}
