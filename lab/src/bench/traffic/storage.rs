//! What reorder stage and tile cache store, in bits.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{Reordering, TILE_PIXELS};
use pointcore_contract::splat::records::{CompleteCopy, HeapEntry, Pixel, TileCopy};
use pointcore_contract::width;

/// Where copies wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Payload {
    /// In the reorder stage.
    OnChip,
    /// In external memory, to which each is written and from which it is read; on chip is what orders them.
    InMemory,
}

impl Payload {
    pub const ALL: [Self; 2] = [Self::OnChip, Self::InMemory];

    pub const fn name(self) -> &'static str {
        match self {
            Self::OnChip => "on_chip",
            Self::InMemory => "in_memory",
        }
    }

    pub const fn words(self) -> &'static str {
        match self {
            Self::OnChip => "copies on the chip",
            Self::InMemory => "copies in memory",
        }
    }
}

/// Bits of a tile slot.
pub(super) fn slot_bits(config: &Config) -> u64 {
    u64::from(TILE_PIXELS * width::<Pixel>(config))
}

/// Bits of what a copy has of its own, but for what orders it: its tile, and whether it is one at all.
fn copy_bits(config: &Config) -> u32 {
    width::<TileCopy>(config) - config.tile_bits() - 1
}

/// Bits of what the copies of a splat have in common.
fn payload_bits(config: &Config) -> u32 {
    width::<CompleteCopy>(config) - config.slot_bits() - (width::<TileCopy>(config) - config.splat_bits())
}

/// Bytes of that in memory.
pub(super) fn payload_bytes(config: &Config) -> u64 {
    payload_bits(config).div_ceil(u8::BITS).into()
}

/// Bits of the reorder stage's memories: of each copy what it has of its own, its pointer among those returned and what orders it, of lists
/// the end of each tile's; of each splat its payload, if that is on the chip.
pub(super) fn reorder_bits(config: &Config, payload: Payload) -> u64 {
    let (entry, pointer) = (width::<HeapEntry>(config), config.heap_levels);
    let (order, ends) = match config.reorder {
        Reordering::Heap => (entry + config.sequence_bits(), 0),
        Reordering::Lists => (entry + pointer, u64::from(pointer + 1) << config.tile_bits()),
    };
    let payloads = match payload {
        Payload::OnChip => u64::from(config.splats_held()) * u64::from(payload_bits(config)),
        Payload::InMemory => 0,
    };
    u64::from(config.pointers()) * u64::from(copy_bits(config) + order + pointer) + ends + payloads
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_memory_is_counted() {
        let config = Config { width: 64, height: 64, heap_levels: 3, splat_levels: 2, ..Config::default() };
        let ends = 4 << 6;
        let ordered = |payload, reorder| reorder_bits(&Config { reorder, ..config.clone() }, payload);
        // Four edges of three bits and four of four, and which of four splats it is.
        let own = 12 + 16 + 2;
        assert_eq!(ordered(Payload::InMemory, Reordering::Lists), 8 * (own + 6 + 3 + 3 + 3) + ends);
        assert_eq!(ordered(Payload::InMemory, Reordering::Heap), 8 * (own + 6 + 3 + 7 + 3));
        let payloads = ordered(Payload::OnChip, Reordering::Heap) - ordered(Payload::InMemory, Reordering::Heap);
        assert_eq!(payloads.div_ceil(4 * 8), payload_bytes(&config));
        assert_eq!(slot_bits(&config), 64 * u64::from(width::<Pixel>(&config)));
    }
}
