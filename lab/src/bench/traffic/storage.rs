//! What reorder stage and tile cache store, in bits.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{Reordering, TILE_PIXELS};
use pointcore_contract::splat::records::{HeapEntry, Pixel, SplatCopy};
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

/// Bits of a copy but for what orders it: its tile, and whether it is one at all.
fn payload_bits(config: &Config) -> u32 {
    width::<SplatCopy>(config) - config.tile_bits() - 1
}

/// Bytes of a copy in memory.
pub(super) fn payload_bytes(config: &Config) -> u64 {
    payload_bits(config).div_ceil(u8::BITS).into()
}

/// Bits of the reorder stage's memories: of each copy its pointer among those returned and what orders it, of lists the end of each tile's.
pub(super) fn reorder_bits(config: &Config, payload: Payload) -> u64 {
    let (entry, pointer) = (width::<HeapEntry>(config), config.heap_levels);
    let (order, ends) = match config.reorder {
        Reordering::Heap => (entry + config.sequence_bits(), 0),
        Reordering::Lists => (entry + pointer, u64::from(pointer + 1) << config.tile_bits()),
    };
    let copy = match payload {
        Payload::OnChip => payload_bits(config),
        Payload::InMemory => 0,
    };
    u64::from(config.payloads()) * u64::from(copy + order + pointer) + ends
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_memory_is_counted() {
        let config = Config { width: 64, height: 64, heap_levels: 3, ..Config::default() };
        let ends = 4 << 6;
        let ordered = |payload, reorder| reorder_bits(&Config { reorder, ..config.clone() }, payload);
        assert_eq!(ordered(Payload::InMemory, Reordering::Lists), 8 * (6 + 3 + 3 + 3) + ends);
        assert_eq!(ordered(Payload::InMemory, Reordering::Heap), 8 * (6 + 3 + 7 + 3));
        let payload = ordered(Payload::OnChip, Reordering::Heap) - ordered(Payload::InMemory, Reordering::Heap);
        assert_eq!(payload.div_ceil(64), payload_bytes(&config));
        assert_eq!(slot_bits(&config), 64 * u64::from(width::<Pixel>(&config)));
    }
}
