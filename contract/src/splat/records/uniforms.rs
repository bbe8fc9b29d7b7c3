//! The uniform registers: constants of a frame, written before its first splat.

use super::Shutter;
use crate::splat::motion::SHUTTER;
use crate::splat::{Config, UniformFormat};
use crate::{fields, places, record};
use std::cmp::Ordering;
use std::iter;

/// Bits of a uniform register's address.
pub const UNIFORM_ADDRESS_BITS: u32 = 5;

/// Model-view matrix.
#[record(config: Config)]
pub struct ModelView {
    /// By rows; the last row is (0, 0, 0, 1).
    #[name(format!("m{i}{j}"))]
    #[bits(config.geometry.width())]
    pub rows: [[u32; 4]; 3],
}

/// From camera space to pixels and depths.
#[record(config: Config)]
pub struct Viewport {
    /// Scale (px).
    #[name(["scale_x", "scale_y"][i])]
    #[bits(config.geometry.width())]
    pub scale: [u32; 2],
    /// Where the optical axis meets the image (px).
    #[name(["origin_x", "origin_y"][i])]
    #[bits(config.geometry.width())]
    pub origin: [u32; 2],
    /// Depth is `depth_a + depth_b/z`, in `[0, 1]`.
    #[bits(config.geometry.width())]
    pub depth_a: u32,
    /// See `depth_a`.
    #[bits(config.geometry.width())]
    pub depth_b: u32,
}

/// What ε is made of (eq. 5.9).
#[record(config: Config)]
pub struct EpsilonScale {
    /// Scale of the splat's own depth range.
    #[name("epsilon_scale")]
    #[bits(config.geometry.width())]
    pub scale: u32,
    /// Constant part.
    #[name("epsilon_bias")]
    #[bits(config.geometry.width())]
    pub bias: u32,
}

/// All uniform registers; their order is their address.
#[record(config: Config)]
pub struct Uniforms {
    /// Model-view matrix.
    pub model_view: ModelView,
    /// From camera space to pixels and depths.
    pub viewport: Viewport,
    /// Near plane.
    #[bits(config.geometry.width())]
    pub near_plane: u32,
    /// What epsilon is made of.
    pub epsilon: EpsilonScale,
    /// Radius of the screen filter (px).
    #[bits(config.geometry.width())]
    pub filter_radius: u32,
    /// The reciprocal of its square.
    #[bits(config.filter_scale_format().width())]
    pub filter_scale: u32,
    /// How much each bin of the exposure counts.
    #[when(config.has_motion())]
    pub shutter: Shutter,
}

/// The places of the registers that are read until a frame has left: others only until it is set up.
#[must_use]
pub fn late_uniforms(config: &Config) -> Vec<usize> {
    let Uniforms { viewport, filter_scale, shutter, .. } = places::<Uniforms>(config);
    if config.has_motion() {
        iter::once(viewport.depth_a).chain(shutter.weight).flatten().collect()
    } else {
        filter_scale.into_iter().collect()
    }
}

/// The format of each uniform register, in their order.
pub fn uniform_formats(config: &Config) -> impl Iterator<Item = UniformFormat> {
    let filter_scale = places::<Uniforms>(config).filter_scale.expect("it is always there");
    let format = move |place: usize| match place.cmp(&filter_scale) {
        Ordering::Less => UniformFormat::Float(config.geometry),
        Ordering::Equal => config.filter_scale_format(),
        Ordering::Greater => UniformFormat::Fixed(SHUTTER),
    };
    (0..fields::<Uniforms>(config).len()).map(format)
}

/// A write to a uniform register.
#[record(config: Config)]
pub struct UniformWrite {
    /// Its place among the frame's uniforms.
    #[bits(UNIFORM_ADDRESS_BITS)]
    pub address: u8,
    /// Its new value.
    #[bits(config.geometry.width())]
    pub data: u32,
}
