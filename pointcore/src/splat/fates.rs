//! What becomes of the splats of a frame, by the hardware's own arithmetic.

use super::encode::EncodedFrame;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{SetupSplat, Splat, SplatCopy, Uniforms};
use pointcore_golden::splat::uniforms::{SetupUniforms, TransformUniforms};
use pointcore_golden::splat::{Dropped, MotionSetup, MotionUniforms, Setup, Splitter, Transform};
use rayon::prelude::*;
use serde::Serialize;
use std::fmt;

/// Splats by what became of them; of several reasons for which one is dropped the first counts, in the order in which the hardware has them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Fates {
    /// Splats that reach the rasterizer.
    pub drawn: u64,
    /// Copies of them, one a tile.
    pub copies: u64,
    /// Splats that reach setup, drawn or not.
    pub set_up: u64,
    /// Splats before the near plane, or behind the eye.
    pub near: u64,
    /// Splats behind the far plane.
    pub far: u64,
    /// Splats beside the image.
    pub beside: u64,
    /// Splats that face away.
    pub facing: u64,
}

/// The models that decide on a frame's splats.
pub(crate) struct Front {
    transform: Transform,
    transform_uniforms: TransformUniforms,
    setup: EitherSetup,
    splitter: Splitter,
}

enum EitherSetup {
    Still(Box<Setup>, SetupUniforms),
    Moving(Box<MotionSetup>, MotionUniforms),
}

impl Front {
    pub fn new(config: &Config, uniforms: &Uniforms) -> Self {
        let Uniforms { model_view, near_plane, viewport, epsilon, filter_radius, .. } = *uniforms;
        let setup = if config.has_motion() {
            let setup = MotionSetup::new(config, 1);
            EitherSetup::Moving(Box::new(setup), MotionUniforms { viewport, epsilon, near_plane })
        } else {
            let uniforms = SetupUniforms { viewport, epsilon, near_plane, filter_radius };
            EitherSetup::Still(Box::new(Setup::new(config, 1)), uniforms)
        };
        Self {
            transform: Transform::new(config, 1),
            transform_uniforms: TransformUniforms { model_view, near_plane },
            setup,
            splitter: Splitter::new(config),
        }
    }

    /// What setup makes of a splat, if it gets there.
    pub fn set_up(&self, splat: &Splat) -> Option<Result<SetupSplat, Dropped>> {
        let placed = self.transform.transform(splat, &self.transform_uniforms)?;
        Some(match &self.setup {
            EitherSetup::Still(setup, uniforms) => setup.outcome(&placed, uniforms),
            EitherSetup::Moving(setup, uniforms) => setup.outcome(&placed, uniforms),
        })
    }

    /// Its copies.
    pub fn copies(&self, drawn: &SetupSplat) -> impl Iterator<Item = SplatCopy> {
        self.splitter.copies(drawn)
    }
}

/// The tile of each copy of a frame's splats, in the order in which the splitter makes them.
#[must_use]
pub fn copy_tiles(config: &Config, frame: &EncodedFrame) -> Vec<u32> {
    let front = Front::new(config, &frame.uniforms);
    let tiles = |splat: &Splat| -> Vec<u32> {
        let Some(Ok(drawn)) = front.set_up(splat) else { return Vec::new() };
        front.copies(&drawn).map(|copy| copy.tile).collect()
    };
    frame.records.par_iter().filter(|record| !record.end).flat_map_iter(tiles).collect()
}

impl Fates {
    /// Asks the models of transform and setup about each splat of a frame.
    #[must_use]
    pub fn of(config: &Config, frame: &EncodedFrame) -> Self {
        let front = Front::new(config, &frame.uniforms);
        let set_up = Self { set_up: 1, ..Self::default() };
        let fate = |splat: &Splat| match front.set_up(splat) {
            None => Self { near: 1, ..Self::default() },
            Some(Ok(drawn)) => Self { drawn: 1, copies: front.copies(&drawn).count() as u64, ..set_up },
            Some(Err(Dropped::Near)) => Self { near: 1, ..set_up },
            Some(Err(Dropped::Far)) => Self { far: 1, ..set_up },
            Some(Err(Dropped::Beside)) => Self { beside: 1, ..set_up },
            Some(Err(Dropped::Facing)) => Self { facing: 1, ..set_up },
        };
        frame.records.par_iter().filter(|record| !record.end).map(fate).reduce(Self::default, Self::sum)
    }

    /// Both together.
    #[must_use]
    pub const fn sum(self, other: Self) -> Self {
        Self {
            drawn: self.drawn + other.drawn,
            copies: self.copies + other.copies,
            set_up: self.set_up + other.set_up,
            near: self.near + other.near,
            far: self.far + other.far,
            beside: self.beside + other.beside,
            facing: self.facing + other.facing,
        }
    }

    /// All splats.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.drawn + self.culled()
    }

    /// Splats that are not drawn.
    #[must_use]
    pub const fn culled(&self) -> u64 {
        self.near + self.far + self.beside + self.facing
    }

    /// What would bring most of what is culled into the picture.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        let Self { near, far, beside, facing, .. } = *self;
        match [near, far, beside, facing].into_iter().max() {
            Some(0) | None => {
                "the splats that are drawn cover no pixel's sample: draw them larger, e.g. `object.0.radius_scale = 2`"
            }
            Some(most) if most == facing => {
                "look from the other side, or have both sides drawn: `two_sided = true` in the file's object"
            }
            Some(most) if most == near => "step back, or move `camera.near` closer; `camera.fit = true` does both",
            Some(most) if most == far => "move `camera.far` away; `camera.fit = true` does so",
            Some(_) => "turn the camera to the scene; `camera.fit = true` does so",
        }
    }
}

impl fmt::Display for Fates {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let reasons = [
            (self.facing, "away from the eye"),
            (self.near, "before the near plane or behind the eye"),
            (self.far, "behind the far plane"),
            (self.beside, "beside the image"),
        ];
        let given = reasons.into_iter().filter(|(count, _)| *count > 0);
        let given: Vec<_> = given.map(|(count, reason)| format!("{count} {reason}")).collect();
        write!(f, "{}", if given.is_empty() { "none".to_owned() } else { given.join(", ") })
    }
}
