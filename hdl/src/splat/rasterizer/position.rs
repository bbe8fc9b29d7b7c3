//! What goes into the evaluation of samples, what comes out of it, and what goes by.

use pointcore_contract::record;
use pointcore_contract::splat::records::{
    ATTRIBUTES, AXES, Band, DepthPlane, Footprint, SamplePlace, Sight, attribute_name,
};
use pointcore_contract::splat::{Coefficient, Config};

use crate::units::wires::Wires;

/// What of a footprint a sample's evaluation needs: all but a depth band that the samples share.
#[record(config: Config)]
pub(super) struct Shape {
    /// Projected center (px), the origin of what follows.
    #[name(format!("center_{}", AXES[i]))]
    #[bits(config.raster_format().center_width())]
    center: [u32; 2],
    /// `A` in x.
    #[bits(config.raster_format().coefficient_width())]
    ax: u32,
    /// `B` in x.
    #[bits(config.raster_format().coefficient_width())]
    bx: u32,
    /// `A` in y.
    #[bits(config.raster_format().coefficient_width())]
    ay: u32,
    /// `B` in y.
    #[bits(config.raster_format().coefficient_width())]
    by: u32,
    /// The determinant of `A` and `B`.
    #[bits(config.raster_format().delta_width())]
    delta: u32,
    /// `m` in x.
    #[bits(config.raster_format().coefficient_width())]
    mx: u32,
    /// `m` in y.
    #[bits(config.raster_format().coefficient_width())]
    my: u32,
    /// In fixed point, places by which offsets from the centre are shifted.
    #[when(config.raster_format().fixed().is_some())]
    #[bits(Coefficient::SHIFT_BITS)]
    shift: u8,
    /// What of it is seen, where that is asked sample by sample.
    #[when(config.eye_plane.is_on())]
    sight: Sight,
    /// Depth plane, where each sample has its own.
    #[when(config.has_depth_plane())]
    plane: DepthPlane,
}

impl From<Footprint<Wires>> for Shape<Wires> {
    fn from(footprint: Footprint<Wires>) -> Self {
        let Footprint { center, ax, bx, ay, by, delta, mx, my, shift, sight, plane, .. } = footprint;
        Self { center, ax, bx, ay, by, delta, mx, my, shift, sight, plane }
    }
}

/// What the scanner sends into the evaluation, one item a sample.
#[record(config: Config)]
pub(super) struct Position {
    /// Closes its copy.
    last: bool,
    /// Slot of the tile cache.
    #[bits(config.slot_bits())]
    slot: u8,
    /// Column of the image.
    #[bits(config.column_bits())]
    column: u16,
    /// Row of the image.
    #[bits(config.row_bits())]
    row: u16,
    /// The splat.
    shape: Shape,
}

/// What is computed of a sample.
#[record(config: Config)]
pub(super) struct Evaluated {
    /// Place and weight.
    place: SamplePlace,
    /// Depth band, where each sample has its own.
    #[when(config.has_depth_plane())]
    band: Band,
}

/// What all samples of a copy share.
#[record(config: Config)]
pub(super) struct Shared {
    /// Depth band, where samples do not have their own.
    #[when(!config.has_depth_plane())]
    band: Band,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    attributes: [u32; ATTRIBUTES],
}
