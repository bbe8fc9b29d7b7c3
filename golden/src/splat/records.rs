//! The records that flow between the renderer's units, field for field as the specification's `splat::records` lists them.
//!
//! Encoded numbers are `u32`: every named format fits. Weighted attributes and their sums, which are wider in fixed point, are `u64`.

use crate::unit::{Record, Visitor, Word};
use pointcore_contract::FragmentDepth;
use pointcore_contract::splat::config::ATTRIBUTES_MAX;
use pointcore_contract::splat::{Config, Feature, RasterFormat};

/// Attributes of a splat: first the continuous ones, then the cardinal ones, then unused places.
pub type Attributes = [u32; ATTRIBUTES_MAX as usize];

/// What is made of a splat's attributes, in the same places: of continuous ones, contributions or sums.
pub type Contributions = [u64; ATTRIBUTES_MAX as usize];

/// What the layout of the records depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Attributes that are blended.
    pub continuous: usize,
    /// Attributes that are selected.
    pub cardinal: usize,
    /// Whether the uniforms of the screen filter exist.
    pub screen_filter: Feature,
    /// Whether splats have a depth band, or a plane of depths.
    pub depth: FragmentDepth,
    /// Format of footprints.
    pub raster: RasterFormat,
}

impl Shape {
    /// The layout of a configuration.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            continuous: config.continuous as usize,
            cardinal: config.cardinal as usize,
            screen_filter: config.screen_filter,
            depth: config.depth,
            raster: config.raster_format(),
        }
    }

    fn attributes(self, values: &mut [impl Word], visitor: &mut impl Visitor) {
        let (continuous, others) = values.split_at_mut(self.continuous);
        visitor.fields("attribute", continuous);
        visitor.fields("cardinal", &mut others[..self.cardinal]);
    }
}

/// A splat in world or camera space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Splat {
    /// Closes the frame.
    pub end: bool,
    /// Center.
    pub center: [u32; 3],
    /// Tangents, whose ends lie at ρ = 1.
    pub tangents: [[u32; 3]; 2],
    /// Attributes.
    pub attributes: Attributes,
}

impl Record<Shape> for Splat {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("end", &mut self.end);
        for (vector, name) in [&mut self.center].into_iter().chain(&mut self.tangents).zip(VECTORS) {
            for (component, name) in vector.iter_mut().zip(name) {
                visitor.field(name, component);
            }
        }
        shape.attributes(&mut self.attributes, visitor);
    }
}

const VECTORS: [[&str; 3]; 3] = [
    ["center_x", "center_y", "center_z"],
    ["tangent1_x", "tangent1_y", "tangent1_z"],
    ["tangent2_x", "tangent2_y", "tangent2_z"],
];

/// A splat's depth and the ends of its ε-band.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Band {
    /// Depth.
    pub depth: u32,
    /// What is nearer hides the splat.
    pub low: u32,
    /// What is farther is hidden by the splat.
    pub high: u32,
}

impl Band {
    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.field("depth", &mut self.depth);
        visitor.field("depth_low", &mut self.low);
        visitor.field("depth_high", &mut self.high);
    }
}

/// Depth over a splat's plane, in the rasterizer's format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DepthPlane {
    /// At the splat's centre.
    pub center: u32,
    /// Change over a pixel in x and in y.
    pub slope: [u32; 2],
    /// Near and far end of the splat's range.
    pub range: [u32; 2],
    /// Half the ε-band.
    pub epsilon: u32,
}

impl DepthPlane {
    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.field("depth_center", &mut self.center);
        visitor.field("depth_x", &mut self.slope[0]);
        visitor.field("depth_y", &mut self.slope[1]);
        visitor.field("depth_near", &mut self.range[0]);
        visitor.field("depth_far", &mut self.range[1]);
        visitor.field("epsilon", &mut self.epsilon);
    }
}

/// What the rasterizer needs of a splat.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Footprint {
    /// Projected center (px), the origin of what follows.
    pub center: [u32; 2],
    /// `A_x`, `A_y`.
    pub a: [u32; 2],
    /// `B_x`, `B_y`.
    pub b: [u32; 2],
    /// `Δ`.
    pub delta: u32,
    /// `m_x`, `m_y`.
    pub m: [u32; 2],
    /// In fixed point, places by which offsets from the centre are shifted.
    pub shift: u8,
    /// Depth band, where all samples share it.
    pub band: Band,
    /// Depth plane, where each sample has its own.
    pub plane: DepthPlane,
}

impl Footprint {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("center_x", &mut self.center[0]);
        visitor.field("center_y", &mut self.center[1]);
        visitor.field("ax", &mut self.a[0]);
        visitor.field("bx", &mut self.b[0]);
        visitor.field("ay", &mut self.a[1]);
        visitor.field("by", &mut self.b[1]);
        visitor.field("delta", &mut self.delta);
        visitor.field("mx", &mut self.m[0]);
        visitor.field("my", &mut self.m[1]);
        if shape.raster.fixed().is_some() {
            visitor.field("shift", &mut self.shift);
        }
        match shape.depth {
            FragmentDepth::Center => self.band.visit(visitor),
            FragmentDepth::Plane => self.plane.visit(visitor),
        }
    }
}

/// An inclusive rectangle of pixels, of the image or of a tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rectangle {
    /// First column.
    pub left: u16,
    /// Last column.
    pub right: u16,
    /// First row.
    pub top: u16,
    /// Last row.
    pub bottom: u16,
}

impl Rectangle {
    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.field("left", &mut self.left);
        visitor.field("right", &mut self.right);
        visitor.field("top", &mut self.top);
        visitor.field("bottom", &mut self.bottom);
    }
}

/// A splat after setup, with its bounds in the image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SetupSplat {
    /// Closes the frame.
    pub end: bool,
    /// Footprint.
    pub footprint: Footprint,
    /// Attributes.
    pub attributes: Attributes,
    /// Bounds in the image.
    pub bounds: Rectangle,
}

impl Record<Shape> for SetupSplat {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("end", &mut self.end);
        self.footprint.visit(shape, visitor);
        shape.attributes(&mut self.attributes, visitor);
        self.bounds.visit(visitor);
    }
}

/// A splat's copy for one tile, with its bounds in the tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SplatCopy {
    /// Closes the frame.
    pub end: bool,
    /// Footprint.
    pub footprint: Footprint,
    /// Attributes.
    pub attributes: Attributes,
    /// Bounds in the tile.
    pub bounds: Rectangle,
    /// Tile index: row above column.
    pub tile: u32,
}

impl Record<Shape> for SplatCopy {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("end", &mut self.end);
        self.footprint.visit(shape, visitor);
        shape.attributes(&mut self.attributes, visitor);
        self.bounds.visit(visitor);
        visitor.field("tile", &mut self.tile);
    }
}

/// A copy with the slot its tile lives in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlacedCopy {
    /// The copy.
    pub copy: SplatCopy,
    /// Slot of the tile cache.
    pub slot: u8,
}

impl Record<Shape> for PlacedCopy {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.copy.visit(shape, visitor);
        visitor.field("slot", &mut self.slot);
    }
}

/// Where a sample lies and what it weighs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SamplePlace {
    /// Closes the frame.
    pub end: bool,
    /// Closes its copy.
    pub last: bool,
    /// Lies inside the splat.
    pub inside: bool,
    /// Slot of the tile cache.
    pub slot: u8,
    /// Pixel of the tile: row above column.
    pub pixel: u8,
    /// Kernel weight.
    pub weight: u16,
}

impl SamplePlace {
    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.field("end", &mut self.end);
        visitor.field("last", &mut self.last);
        visitor.field("inside", &mut self.inside);
        visitor.field("slot", &mut self.slot);
        visitor.field("pixel", &mut self.pixel);
        visitor.field("weight", &mut self.weight);
    }
}

/// A sample with its splat's depth band and attributes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sample {
    /// Place and weight.
    pub place: SamplePlace,
    /// Depth band.
    pub band: Band,
    /// Attributes.
    pub attributes: Attributes,
}

impl Record<Shape> for Sample {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.place.visit(visitor);
        self.band.visit(visitor);
        shape.attributes(&mut self.attributes, visitor);
    }
}

/// A sample with its contributions to the sums.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WeightedSample {
    /// Place and weight.
    pub place: SamplePlace,
    /// Weighted depth.
    pub weighted_depth: u64,
    /// Near end of the depth band.
    pub depth_low: u32,
    /// Far end of the depth band.
    pub depth_high: u32,
    /// Weighted continuous attributes, and cardinal ones as they are.
    pub attributes: Contributions,
}

impl Record<Shape> for WeightedSample {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.place.visit(visitor);
        visitor.field("weighted_depth", &mut self.weighted_depth);
        visitor.field("depth_low", &mut self.depth_low);
        visitor.field("depth_high", &mut self.depth_high);
        shape.attributes(&mut self.attributes, visitor);
    }
}

/// A pixel of the reconstruction buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pixel {
    /// Sum of weights.
    pub weight: u32,
    /// Sum of weighted depths.
    pub depth: u64,
    /// The largest single weight, with cardinal attributes only.
    pub peak: u16,
    /// Sums of weighted continuous attributes, and the cardinal ones of the largest weight.
    pub attributes: Contributions,
}

impl Record<Shape> for Pixel {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("weight", &mut self.weight);
        visitor.field("depth", &mut self.depth);
        if shape.cardinal > 0 {
            visitor.field("peak", &mut self.peak);
        }
        shape.attributes(&mut self.attributes, visitor);
    }
}

/// A pixel with its place in the reconstruction buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlacedPixel {
    /// Tile index.
    pub tile: u32,
    /// Pixel of the tile.
    pub pixel: u8,
    /// What the pixel holds.
    pub value: Pixel,
}

impl Record<Shape> for PlacedPixel {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("tile", &mut self.tile);
        visitor.field("pixel", &mut self.pixel);
        self.value.visit(shape, visitor);
    }
}

/// A pixel on its way to normalization.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FinishedPixel {
    /// Closes the frame.
    pub end: bool,
    /// Pixel and place.
    pub placed: PlacedPixel,
}

impl Record<Shape> for FinishedPixel {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("end", &mut self.end);
        self.placed.visit(shape, visitor);
    }
}

/// A normalized pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fragment {
    /// Closes the frame.
    pub end: bool,
    /// Column of the image.
    pub column: u16,
    /// Row of the image.
    pub row: u16,
    /// Depth in the geometry format.
    pub depth: u32,
    /// Attributes.
    pub attributes: Attributes,
}

impl Record<Shape> for Fragment {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("end", &mut self.end);
        visitor.field("column", &mut self.column);
        visitor.field("row", &mut self.row);
        visitor.field("depth", &mut self.depth);
        shape.attributes(&mut self.attributes, visitor);
    }
}
