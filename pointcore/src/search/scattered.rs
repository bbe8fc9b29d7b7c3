//! A search whose buckets lie scattered over the whole point memory, and whose queries have numbers with all their bits.
//!
//! A short search has few points and few queries; packed, the upper bits of addresses and numbers would never change, and
//! a recording of it would miss faults there. What the core and the host exchange is renamed on its way.

use super::Tree;
use fastrand::Rng;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::Bucket;
use pointcore_golden::search::top::{In, Out};
use std::collections::BTreeMap;

/// Odd, so that products with it are another order of all numbers; its bits are those of the golden ratio.
const STEP: u32 = 0x9e37_79b1;
/// Rounds of Newton's method for its inverse: the correct bits double, from 3 on.
const INVERSE_ROUNDS: u32 = 4;

/// Where buckets lie, and which numbers queries bear.
pub struct Scattered {
    lanes: u32,
    number_mask: u32,
    /// The first beat of each bucket as the host has it, and as the core has it; and the other way round.
    there: BTreeMap<u32, u32>,
    back: BTreeMap<u32, u32>,
}

impl Scattered {
    /// The buckets of a tree in their order, with gaps between them that fill the memory.
    pub fn new(config: &Config, tree: &Tree, random: &mut Rng) -> Self {
        let buckets: BTreeMap<u32, u32> =
            tree.writes().filter(|write| write.is_leaf).map(|write| extent(write.bucket)).collect();
        let used: u32 = buckets.values().sum();
        let beats = (1_u32 << config.beat_bits()).min((1 << config.index_bits) / config.lanes);
        let mut gaps: Vec<u32> = buckets.iter().map(|_| random.u32(0..=beats.saturating_sub(used))).collect();
        gaps.sort_unstable();
        let mut before = 0;
        let place = |((begin, beats), gap): ((&u32, &u32), u32)| {
            let place = (*begin, before + gap);
            before += beats;
            place
        };
        let there: BTreeMap<u32, u32> = buckets.iter().zip(gaps).map(place).collect();
        let back = there.iter().map(|(begin, place)| (*place, *begin)).collect();
        let number_mask = u32::MAX >> (u32::BITS - config.index_bits);
        Self { lanes: config.lanes, number_mask, there, back }
    }

    /// What the core is given for what the host gives.
    pub fn inputs(&self, host: &In) -> In {
        let mut inputs = *host;
        if let Some(write) = &mut inputs.tree {
            write.bucket.begin = moved(&self.there, write.bucket.begin);
        }
        if let Some(record) = &mut inputs.record {
            record.bucket.begin = moved(&self.there, record.bucket.begin);
        }
        if let Some(query) = &mut inputs.query {
            query.query.number = query.query.number.wrapping_mul(STEP) & self.number_mask;
        }
        if let Some(beat) = &mut inputs.beat {
            beat.place.address = moved(&self.there, beat.place.address);
        }
        inputs
    }

    /// What the host is given for what the core gives.
    pub fn outputs(&self, core: &Out) -> Out {
        let mut outputs = *core;
        if let Some(fetch) = &mut outputs.fetch {
            fetch.address = moved(&self.back, fetch.address);
        }
        if let Some(result) = &mut outputs.result {
            let neighbor = &mut result.result;
            let (beat, lane) = (neighbor.index / self.lanes, neighbor.index % self.lanes);
            if neighbor.found {
                neighbor.index = moved(&self.back, beat) * self.lanes + lane;
            }
            neighbor.number = neighbor.number.wrapping_mul(inverse(STEP)) & self.number_mask;
        }
        outputs
    }
}

fn extent(bucket: Bucket) -> (u32, u32) {
    (bucket.begin, bucket.beats.into())
}

/// The beat in its bucket's new place; a bucket that is none stays.
fn moved(places: &BTreeMap<u32, u32>, beat: u32) -> u32 {
    places.range(..=beat).next_back().map_or(beat, |(begin, place)| place + (beat - begin))
}

/// The number whose product with an odd one is 1, modulo 2³².
fn inverse(odd: u32) -> u32 {
    (0..INVERSE_ROUNDS).fold(odd, |inverse, _| inverse.wrapping_mul(2_u32.wrapping_sub(odd.wrapping_mul(inverse))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::knn;
    use crate::search::{PointSet, Splitting};
    use pointcore_contract::search::records::CachedQuery;

    #[test]
    fn what_is_renamed_on_its_way_there_has_its_name_again_on_its_way_back() {
        let config = knn();
        let points: Vec<_> = (0..100_u16).map(|x| [f32::from(x), 0.0, 1.0]).collect();
        let points = PointSet::new(config.geometry, &points).unwrap_or_else(|error| panic!("{error}"));
        let tree = Tree::build(&config, &points, Splitting::Packed).unwrap_or_else(|error| panic!("{error}"));
        let scattered = Scattered::new(&config, &tree, &mut Rng::with_seed(1));
        let places: Vec<_> =
            (0..tree.memory().len() as u32 / config.lanes).map(|beat| moved(&scattered.there, beat)).collect();
        assert!(places.is_sorted() && places.last() > Some(&1000), "they lie apart, and do not overlap");
        for (beat, place) in (0..).zip(places) {
            assert_eq!(moved(&scattered.back, place), beat);
        }
        let mut host = In::default();
        let mut query = CachedQuery::default();
        query.query.number = 5;
        host.query = Some(query);
        let number = scattered.inputs(&host).query.map_or(0, |query| query.query.number);
        assert!(number > 1000 && number.wrapping_mul(inverse(STEP)) & scattered.number_mask == 5);
    }
}
