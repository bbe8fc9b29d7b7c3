//! A tile cache without reordering, as the thesis compares with (5.7.1): fully associative, the tile used longest ago leaves.

use std::collections::{BTreeMap, HashMap, HashSet};

/// Tiles that a cache moved over a frame, its end included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct TileMoves {
    /// From memory.
    pub read: u64,
    /// To memory.
    pub written: u64,
}

/// Plays the tiles of a frame's copies in their order through a cache of so many tiles.
///
/// Every copy changes its tile, so each that leaves is written. A tile that comes for the first time is empty and not read. At the end
/// of the frame the tiles that are in memory are read once more, as pixels go to normalization.
pub(super) fn play(tiles: &[u32], slots: usize) -> TileMoves {
    let mut moves = TileMoves::default();
    // When each tile in the cache was used last, and the other way round.
    let (mut used, mut by_use) = (HashMap::new(), BTreeMap::new());
    let mut in_memory = HashSet::new();
    for (now, &tile) in tiles.iter().enumerate() {
        match used.insert(tile, now) {
            Some(before) => _ = by_use.remove(&before),
            None => {
                moves.read += u64::from(in_memory.remove(&tile));
                if used.len() > slots {
                    let (_, oldest) = by_use.pop_first().expect("the tiles in the cache were used");
                    used.remove(&oldest);
                    in_memory.insert(oldest);
                    moves.written += 1;
                }
            }
        }
        by_use.insert(now, tile);
    }
    moves.read += in_memory.len() as u64;
    moves
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tile_used_longest_ago_leaves() {
        // 1 and 2 are there; 3 takes the place of 2, which comes back for 1, which is read at the end.
        assert_eq!(play(&[1, 2, 1, 3, 2], 2), TileMoves { read: 2, written: 2 });
        assert_eq!(play(&[1, 2, 1, 3, 2], 3), TileMoves::default());
        assert_eq!(play(&[], 2), TileMoves::default());
    }

    /// A list of tiles, the one used last in front.
    fn naive(tiles: &[u32], slots: usize) -> TileMoves {
        let (mut moves, mut cache, mut memory) = (TileMoves::default(), vec![], vec![]);
        for &tile in tiles {
            if let Some(place) = cache.iter().position(|other| *other == tile) {
                cache.remove(place);
            } else if let Some(place) = memory.iter().position(|other| *other == tile) {
                memory.remove(place);
                moves.read += 1;
            }
            cache.insert(0, tile);
            if cache.len() > slots {
                memory.extend(cache.pop());
                moves.written += 1;
            }
        }
        moves.read += memory.len() as u64;
        moves
    }

    #[test]
    fn it_moves_what_a_list_would() {
        let mut random = fastrand::Rng::with_seed(1);
        for slots in 1..20 {
            let tiles: Vec<u32> = (0..500).map(|_| random.u32(0..30)).collect();
            assert_eq!(play(&tiles, slots), naive(&tiles, slots), "{slots} slots");
        }
    }
}
