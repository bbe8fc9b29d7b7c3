//! The tile cache's ports and the small records in them.

use crate::splat::records::{FinishedPixel, Pixel, PlacedCopy, PlacedPixel, Shape, SplatCopy};
use crate::unit::{Record, Visitor, optional, stream};

/// What the unit sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Copies in order of tiles.
    pub input: Option<SplatCopy>,
    /// Whether the rasterizer is ready.
    pub out_ready: bool,
    /// Whether the memory takes a read request.
    pub read_ready: bool,
    /// Pixels of the tiles requested, in pixel order.
    pub data: Option<Pixel>,
    /// Whether the memory takes a write.
    pub write_ready: bool,
    /// Whether the normalizer is ready.
    pub pixel_ready: bool,
    /// The accumulator is done with a copy.
    pub retire: Option<Slot>,
    /// The accumulator is done with the frame.
    pub frame_end: bool,
    /// The pixel of the last [`Out::drain`].
    pub drained: Pixel,
}

/// What the unit shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Out {
    /// Whether a copy is accepted.
    pub in_ready: bool,
    /// Copies with their slots.
    pub out: Option<PlacedCopy>,
    /// Request for the pixels of a tile.
    pub read: Option<Tile>,
    /// Whether a pixel is accepted.
    pub data_ready: bool,
    /// Pixels of evicted tiles.
    pub write: Option<PlacedPixel>,
    /// Pixels of a finished frame.
    pub pixel: Option<FinishedPixel>,
    /// A bit for each slot that may be accumulated into.
    pub slot_ready: u64,
    /// Write to a slot.
    pub fill: Option<Fill>,
    /// Read of a slot.
    pub drain: Option<SlotPixel>,
}

/// A tile's index alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tile {
    /// Tile index.
    pub tile: u32,
}

/// A slot's number alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Slot {
    /// Slot number.
    pub slot: u8,
}

/// A pixel of a slot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SlotPixel {
    /// Slot number.
    pub slot: u8,
    /// Pixel of the tile.
    pub pixel: u8,
}

/// A write to a slot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fill {
    /// Where.
    pub place: SlotPixel,
    /// What.
    pub value: Pixel,
}

impl Record<Shape> for Tile {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("tile", &mut self.tile);
    }
}

impl Record<Shape> for Slot {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("slot", &mut self.slot);
    }
}

impl Record<Shape> for SlotPixel {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("slot", &mut self.slot);
        visitor.field("pixel", &mut self.pixel);
    }
}

impl Record<Shape> for Fill {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.place.visit(shape, visitor);
        self.value.visit(shape, visitor);
    }
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "in_", &mut self.input);
        visitor.field("out_ready", &mut self.out_ready);
        visitor.field("read_ready", &mut self.read_ready);
        stream(visitor, shape, "data_", &mut self.data);
        visitor.field("write_ready", &mut self.write_ready);
        visitor.field("pixel_ready", &mut self.pixel_ready);
        stream(visitor, shape, "retire_", &mut self.retire);
        visitor.field("frame_end", &mut self.frame_end);
        visitor.prefix("drain_");
        self.drained.visit(shape, visitor);
        visitor.prefix("");
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("in_ready", &mut self.in_ready);
        stream(visitor, shape, "out_", &mut self.out);
        stream(visitor, shape, "read_", &mut self.read);
        visitor.field("data_ready", &mut self.data_ready);
        stream(visitor, shape, "write_", &mut self.write);
        stream(visitor, shape, "pixel_", &mut self.pixel);
        visitor.field("slot_ready", &mut self.slot_ready);
        stream(visitor, shape, "fill_", &mut self.fill);
        optional(visitor, shape, "drain_", "enable", &mut self.drain);
    }
}
