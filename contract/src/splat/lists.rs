//! The records that flow through the renderer: names and widths of their fields, in order.
//!
//! Geometry fields are values of [`Config::geometry`], those of footprints of [`Config::raster_format`] (in fixed point with widths of
//! their own), attributes of [`Config::attribute`],
//! whose products and sums may be wider; depths, weights and coordinates are unsigned integers. A record with `end` set closes the frame
//! and carries nothing else.

use super::config::{Config, DEPTH_BITS, DEPTH_SUM_BITS, WEIGHT_BITS, WEIGHT_SUM_BITS};
use super::raster::{Coefficient, RasterFormat};
use super::records::{LOCAL_BITS, PIXEL_BITS};
use crate::{Format, FragmentDepth};

/// A field: its name and its width in bits.
pub type Field = (String, u32);

fn fields<const N: usize>(names: [&str; N], width: u32) -> Vec<Field> {
    names.into_iter().map(|name| (name.to_owned(), width)).collect()
}

/// `attribute_0…`, the continuous attributes, then `cardinal_0…`.
#[must_use]
pub fn attributes(config: &Config) -> Vec<Field> {
    made_of_attributes(config, config.attribute.width())
}

/// What is made of the continuous attributes, in so many bits each, and the cardinal ones as they are.
fn made_of_attributes(config: &Config, width: u32) -> Vec<Field> {
    let continuous = (0..config.continuous).map(|i| (format!("attribute_{i}"), width));
    continuous.chain((0..config.cardinal).map(|i| (format!("cardinal_{i}"), config.attribute.width()))).collect()
}

/// A splat, in world space as the host sends it and in camera space as the transform unit passes it on: centre, two tangents
/// whose ends lie at ρ = 1, attributes.
#[must_use]
pub fn splat(config: &Config) -> Vec<Field> {
    let geometry = ["center_x", "center_y", "center_z", "tangent1_x", "tangent1_y", "tangent1_z"];
    let mut record = fields(["end"], 1);
    record.extend(fields(geometry, config.geometry.width()));
    record.extend(fields(["tangent2_x", "tangent2_y", "tangent2_z"], config.geometry.width()));
    record.extend(attributes(config));
    record
}

/// What the rasterizer needs of a splat, recentred at its projected centre (px), and its depth band.
#[must_use]
pub fn footprint(config: &Config) -> Vec<Field> {
    let (centers, coefficients) = (["center_x", "center_y"], ["ax", "bx", "ay", "by", "delta", "mx", "my"]);
    let mut record = match config.raster_format() {
        RasterFormat::Float(format) => {
            let mut record = fields(centers, format.width());
            record.extend(fields(coefficients, format.width()));
            record
        }
        RasterFormat::Fixed(fixed) => {
            let mut record = fields(centers, fixed.center().width);
            record.extend(fields(coefficients, fixed.width()));
            record.extend(fields(["shift"], Coefficient::SHIFT_BITS));
            let delta = record.iter_mut().filter(|(name, _)| name == "delta");
            delta.for_each(|(_, width)| *width = fixed.delta_width());
            record
        }
    };
    record.extend(match (config.depth, config.raster_format()) {
        (FragmentDepth::Plane, RasterFormat::Float(format)) => depth_plane(format),
        _ => band(),
    });
    record
}

/// Depth over a splat's plane: at its centre, its change a pixel, the ends of its range, and half the ε-band (eq. 5.9).
#[must_use]
pub fn depth_plane(format: Format) -> Vec<Field> {
    let names = ["depth_center", "depth_x", "depth_y", "depth_near", "depth_far", "epsilon"];
    fields(names, format.width())
}

/// Depth of a splat, or of a sample, and the ends of its ε-band (eq. 5.8, 5.9).
#[must_use]
pub fn band() -> Vec<Field> {
    fields(["depth", "depth_low", "depth_high"], DEPTH_BITS)
}

/// A splat after setup: footprint, attributes and the inclusive pixel rectangle that bounds it.
#[must_use]
pub fn setup(config: &Config) -> Vec<Field> {
    let mut record = fields(["end"], 1);
    record.extend(footprint(config));
    record.extend(attributes(config));
    record.extend(fields(["left", "right"], config.column_bits()));
    record.extend(fields(["top", "bottom"], config.row_bits()));
    record
}

/// A splat's copy for one tile without the tile's index: what the reorder stage stores.
#[must_use]
pub fn payload(config: &Config) -> Vec<Field> {
    let mut record = footprint(config);
    record.extend(attributes(config));
    record.extend(fields(["left", "right", "top", "bottom"], LOCAL_BITS));
    record
}

/// A splat's copy for one tile: payload, rectangle within the tile, and the tile.
#[must_use]
pub fn copy(config: &Config) -> Vec<Field> {
    let mut record = fields(["end"], 1);
    record.extend(payload(config));
    record.extend(fields(["tile"], config.tile_bits()));
    record
}

/// A copy with the cache slot its tile lives in.
#[must_use]
pub fn placed_copy(config: &Config) -> Vec<Field> {
    let mut record = copy(config);
    record.extend(fields(["slot"], config.slot_bits()));
    record
}

/// Where a sample lies and its kernel weight.
#[must_use]
pub fn sample_head(config: &Config) -> Vec<Field> {
    let mut record = fields(["end", "last", "inside"], 1);
    record.extend(fields(["slot"], config.slot_bits()));
    record.extend(fields(["pixel"], PIXEL_BITS));
    record.extend(fields(["weight"], WEIGHT_BITS));
    record
}

/// What is computed of a sample: place and weight, and its depth band where splats have none.
#[must_use]
pub fn evaluated(config: &Config) -> Vec<Field> {
    let mut record = sample_head(config);
    if config.depth == FragmentDepth::Plane {
        record.extend(band());
    }
    record
}

/// What all samples of a copy share: its splat's attributes, and its depth band where it has one.
#[must_use]
pub fn shared(config: &Config) -> Vec<Field> {
    let mut record = match config.depth {
        FragmentDepth::Center => band(),
        FragmentDepth::Plane => Vec::new(),
    };
    record.extend(attributes(config));
    record
}

/// A sample: where, how much, depth band and its splat's attributes. `last` closes its copy; a sample outside the splat
/// is passed on only to say so.
#[must_use]
pub fn sample(config: &Config) -> Vec<Field> {
    let mut record = evaluated(config);
    record.extend(shared(config));
    record
}

/// A sample with its contributions: weighted depth and weighted continuous attributes (eq. 5.10).
#[must_use]
pub fn weighted_sample(config: &Config) -> Vec<Field> {
    let mut record = sample_head(config);
    record.extend(fields(["weighted_depth"], WEIGHT_BITS + DEPTH_BITS));
    record.extend(fields(["depth_low", "depth_high"], DEPTH_BITS));
    record.extend(made_of_attributes(config, config.attribute.contribution_width()));
    record
}

/// A pixel of the reconstruction buffer: sums, and with cardinal attributes the weight that won them.
#[must_use]
pub fn pixel(config: &Config) -> Vec<Field> {
    let mut record = fields(["weight"], WEIGHT_SUM_BITS);
    record.extend(fields(["depth"], DEPTH_SUM_BITS));
    if config.cardinal > 0 {
        record.extend(fields(["peak"], WEIGHT_BITS));
    }
    record.extend(made_of_attributes(config, config.attribute.sum_width()));
    record
}

/// A pixel on its way to normalization, with its place in the image.
#[must_use]
pub fn finished_pixel(config: &Config) -> Vec<Field> {
    let mut record = fields(["end"], 1);
    record.extend(fields(["tile"], config.tile_bits()));
    record.extend(fields(["pixel"], PIXEL_BITS));
    record.extend(pixel(config));
    record
}

/// A fragment: place (px), normalized depth, normalized attributes (eq. 5.13).
#[must_use]
pub fn fragment(config: &Config) -> Vec<Field> {
    let mut record = fields(["end"], 1);
    record.extend(fields(["column"], config.column_bits()));
    record.extend(fields(["row"], config.row_bits()));
    record.extend(fields(["depth"], config.geometry.width()));
    record.extend(attributes(config));
    record
}

/// Bytes a pixel takes in the reconstruction buffer.
#[must_use]
pub fn pixel_bytes(config: &Config) -> u32 {
    pixel(config).iter().map(|(_, width)| width).sum::<u32>().div_ceil(8)
}
