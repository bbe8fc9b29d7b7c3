//! Random trees and queries for a search core of any configuration: points on a coarse grid, so that distances tie,
//! duplicates, numbers that are none, leaves without points. Leaves lie together in memory or scattered over all of it, and
//! queries have numbers with all their bits.

use super::one_of;
use crate::number::{decode, encode};
use fastrand::Rng;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{
    Bucket, CacheSetup, CachedQuery, LANES_MAX, Lookup, Node, Points, Query, TreeRecord, TreeWrite,
};
use std::collections::{BTreeMap, HashMap};

/// Odd, so that products with it are another order of all numbers; its bits are those of the golden ratio.
const STEP: u32 = 0x9e37_79b1;
/// The distance of places where points are close to each other, and the bits in which they differ.
const CLOSE: f32 = 0.618_034;
const CLOSE_BITS: u32 = 12;
/// Numbers that are none, or hardly.
const ODD: [f32; 8] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, f32::MAX, f32::MIN, 1e-40, 1e-25];

/// A point in the core's format.
type Point = [u32; 3];

/// How coordinates are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Spread {
    /// On a coarse grid.
    Grid,
    /// Anywhere near the origin.
    Fine,
    /// Of all magnitudes.
    Wild,
    /// All at one place.
    Same,
    /// At a few places, but for their last bits.
    Close,
}

/// From which the spread of a tree is drawn.
const SPREADS: [Spread; 7] =
    [Spread::Grid, Spread::Grid, Spread::Fine, Spread::Wild, Spread::Same, Spread::Close, Spread::Close];

/// A tree and its points in memory.
#[derive(Clone, Debug)]
pub struct RandomTree {
    lanes: usize,
    /// By lane, beat after beat; NaN where there is none.
    points: Vec<Point>,
    /// The first beat of each leaf in memory, and among the points.
    places: BTreeMap<u32, u32>,
    /// What the host writes.
    pub writes: Vec<TreeWrite>,
    by_address: HashMap<(bool, u32), TreeWrite>,
    spread: Spread,
}

/// A part of the tree that is to be built.
struct Part {
    address: u32,
    level: u32,
}

fn coordinate(config: &Config, spread: Spread, random: &mut Rng) -> u32 {
    let signed = |random: &mut Rng| 2.0 * random.f32() - 1.0;
    let number = match spread {
        _ if random.u16(..400) == 0 => one_of(random, &ODD),
        Spread::Grid => f32::from(random.i8(-12..=12)) / 4.0,
        Spread::Fine => 3.0 * signed(random),
        Spread::Wild => signed(random) * (70.0 * signed(random)).exp2(),
        Spread::Same => 0.75,
        Spread::Close => {
            let word = encode(config.geometry, f32::from(random.i8(-2..=2)) * CLOSE);
            return word ^ random.u32(..) & ((1 << random.u32(0..CLOSE_BITS)) - 1);
        }
    };
    encode(config.geometry, number)
}

impl RandomTree {
    /// A tree of so many points at most, which the configuration's memories and indices hold.
    #[must_use]
    pub fn random(config: &Config, most_points: u32, random: &mut Rng) -> Self {
        let spread = one_of(random, &SPREADS);
        // As many as its leaves hold, with room for an uneven division.
        let most = (u64::from(config.bucket) << config.tree_depth) * 3 / 4;
        let mut count = random.u32(1..=most.clamp(1, most_points.into()) as u32);
        let room = 1_u64 << config.beat_bits();
        loop {
            let points = (0..count).map(|_| [(); 3].map(|()| coordinate(config, spread, random))).collect();
            let mut tree = Self::of(config, points, spread, random);
            if let Some(free) = room.checked_sub(tree.beats()) {
                tree.place(if random.bool() { free as u32 } else { 0 }, random);
                return tree;
            }
            // One point in one leaf always has room.
            count = (count / 2).max(1);
        }
    }

    fn of(config: &Config, mut points: Vec<Point>, spread: Spread, random: &mut Rng) -> Self {
        let lanes = config.lanes as usize;
        let places = BTreeMap::new();
        let mut tree = Self { lanes, points: vec![], places, writes: vec![], by_address: HashMap::new(), spread };
        tree.build(config, random, &Part { address: 1, level: 0 }, &mut points);
        tree
    }

    /// Leaves so many beats of the memory free, before and between leaves.
    fn place(&mut self, free: u32, random: &mut Rng) {
        // They were written in the order in which they lie.
        let leaves: Vec<_> = self.writes.iter_mut().filter(|write| write.is_leaf).collect();
        let mut gaps: Vec<_> = leaves.iter().map(|_| random.u32(0..=free)).collect();
        gaps.sort_unstable();
        for (leaf, gap) in leaves.into_iter().zip(gaps) {
            let begin = &mut leaf.bucket.begin;
            self.places.insert(*begin + gap, *begin);
            *begin += gap;
        }
        self.by_address = self.writes.iter().map(|write| ((write.is_leaf, write.address), *write)).collect();
    }

    fn build(&mut self, config: &Config, random: &mut Rng, part: &Part, points: &mut [Point]) {
        let &Part { address, level } = part;
        let is_internal = level < config.tree_depth;
        let fits = points.len() <= config.bucket as usize;
        if !is_internal || (fits && random.u8(..3) > 0) {
            if is_internal {
                let node = Node { internal_leaf: true, ..Node::default() };
                self.writes.push(TreeWrite { is_leaf: false, address, node, bucket: Bucket::default() });
            }
            let leaf = (address << (config.tree_depth - level)) & ((1 << config.tree_depth) - 1);
            return self.leaf(config, leaf, points);
        }
        let dimension = random.usize(..3);
        let key = |point: &Point| decode(config.geometry, point[dimension]);
        points.sort_by(|a, b| key(a).total_cmp(&key(b)));
        let middle = points.len() / 2;
        let split = points.get(middle).map_or(0, |point| point[dimension]);
        let node = Node { split, dimension: dimension as u8, internal_leaf: false };
        self.writes.push(TreeWrite { is_leaf: false, address, node, bucket: Bucket::default() });
        let (left, right) = points.split_at_mut(middle);
        self.build(config, random, &Part { address: 2 * address, level: level + 1 }, left);
        self.build(config, random, &Part { address: 2 * address + 1, level: level + 1 }, right);
    }

    /// A leaf has a beat even without points.
    fn leaf(&mut self, config: &Config, address: u32, points: &[Point]) {
        let beats = points.len().div_ceil(self.lanes).max(1);
        let begin = self.points.len() / self.lanes;
        self.points.extend(points);
        let none = [encode(config.geometry, f32::NAN); 3];
        self.points.resize((begin + beats) * self.lanes, none);
        let bucket = Bucket { begin: begin as u32, beats: beats as u8 };
        self.writes.push(TreeWrite { is_leaf: true, address, node: Node::default(), bucket });
    }

    /// Beats of points in memory.
    #[must_use]
    pub fn beats(&self) -> u64 {
        (self.points.len() / self.lanes) as u64
    }

    /// A beat of points.
    #[must_use]
    pub fn beat(&self, address: u32) -> Points {
        let mut lane = [Point::default(); LANES_MAX];
        let (place, packed) = self.places.range(..=address).next_back().expect("memory is asked for beats of leaves");
        let begin = (packed + address - place) as usize * self.lanes;
        lane[..self.lanes].copy_from_slice(&self.points[begin..begin + self.lanes]);
        Points { lane }
    }

    /// What a tree in memory holds of a node or a leaf; zeros where the tree has none.
    #[must_use]
    pub fn record(&self, config: &Config, lookup: Lookup) -> TreeRecord {
        let is_leaf = lookup.address >> config.tree_depth == 1;
        let address = lookup.address - (u32::from(is_leaf) << config.tree_depth);
        let write = self.by_address.get(&(is_leaf, address)).copied().unwrap_or_default();
        TreeRecord { lookup, node: write.node, bucket: write.bucket }
    }

    /// How the neighbor cache is to judge.
    #[must_use]
    pub fn setup(config: &Config, random: &mut Rng) -> CacheSetup {
        let scale = |number| encode(config.geometry, number);
        let ball = random.bool();
        let margin = if ball { 1.0 } else { 0.5 };
        CacheSetup { ball, far_scale: scale(1.0 - random.f32() / 1000.0), margin_scale: scale(margin) }
    }

    /// A squared distance that the core comes to know, or almost: to a point, or to one in a single dimension, as a plane is.
    fn near_radius2(&self, config: &Config, from: Point, random: &mut Rng) -> u32 {
        let to = one_of(random, &self.points);
        let offset = |dimension: usize| {
            let [from, to] = [from, to].map(|point| f64::from(decode(config.geometry, point[dimension])));
            (from - to).powi(2)
        };
        let distance2 = if random.bool() { (0..3).map(offset).sum() } else { offset(random.usize(..3)) };
        let word = encode(config.geometry, distance2 as f32);
        let toggled = word ^ 1 << random.u32(..config.geometry.width() - 1);
        let is_radius = |word: &u32| decode(config.geometry, *word) >= 0.0;
        [toggled, word].into_iter().find(is_radius).unwrap_or_else(|| encode(config.geometry, f32::INFINITY))
    }

    /// So many queries at most that are asked together: near a few places, so that a neighbor cache is of use, or anywhere.
    #[must_use]
    pub fn queries(&self, config: &Config, most: u32, random: &mut Rng) -> Vec<CachedQuery> {
        let place = |random: &mut Rng| match random.u8(..4) {
            // A point itself: distances of zero.
            0 => self.points[random.usize(..self.points.len())],
            _ => [(); 3].map(|()| coordinate(config, self.spread, random)),
        };
        let places: Vec<_> = (0..random.usize(1..=6)).map(|_| place(random)).collect();
        let all_k = random.u8(1..=config.neighbors as u8);
        let radii = [f32::INFINITY, f32::INFINITY, 9.0, 1.0, 0.01, 0.0];
        let common = one_of(random, &radii);
        let query = |number: u32, random: &mut Rng| {
            let mut point = if random.bool() { one_of(random, &places) } else { place(random) };
            if random.bool() {
                let component = &mut point[random.usize(..3)];
                *component ^= random.u32(..) & ((1 << random.u32(..8)) - 1);
            }
            let (k, radius2) = match config.neighbor_cache {
                0 if random.bool() => (random.u8(1..=config.neighbors as u8), self.near_radius2(config, point, random)),
                0 => (random.u8(1..=config.neighbors as u8), encode(config.geometry, one_of(random, &radii))),
                _ => (all_k, encode(config.geometry, common)),
            };
            let number = number.wrapping_mul(STEP) & (u32::MAX >> (u32::BITS - config.index_bits));
            let reach = encode(config.geometry, random.f32());
            let query = Query { number, k, radius2, point };
            CachedQuery { query, reach: if config.neighbor_cache > 0 { reach } else { 0 } }
        };
        let count = random.u32(1..=most);
        (0..count).map(|number| query(number, random)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stimuli::configuration::search_core;

    #[test]
    fn every_tree_fits_its_configuration() {
        let (mut leaves, mut empty, mut queries, mut far) = (0, 0, 0, 0);
        for seed in 0..300 {
            let random = &mut Rng::with_seed(seed);
            let config = search_core(random);
            let tree = RandomTree::random(&config, 300, random);
            for write in tree.writes.iter().filter(|write| write.is_leaf) {
                assert!(u64::from(write.address) < 1 << config.tree_depth);
                let end = u64::from(write.bucket.begin) + u64::from(write.bucket.beats);
                assert!(end <= 1 << config.beat_bits(), "{config:?}");
                assert!(u32::from(write.bucket.beats) <= config.bucket.div_ceil(config.lanes), "{config:?}");
                leaves += 1;
                far += usize::from(u64::from(write.bucket.begin) > tree.beats());
                let nan = encode(config.geometry, f32::NAN);
                empty += usize::from(tree.beat(write.bucket.begin).lane[0] == [nan; 3]);
            }
            let asked = tree.queries(&config, 60, random);
            let is_sound = |query: &CachedQuery| (1..=config.neighbors).contains(&u32::from(query.query.k));
            assert!(!asked.is_empty() && asked.iter().all(is_sound));
            queries += asked.len();
        }
        assert!(leaves > 600 && empty > 20 && queries > 3000, "{leaves} leaves, {empty} empty, {queries} queries");
        assert!(far > leaves / 4, "{far} leaves far off");
    }
}
