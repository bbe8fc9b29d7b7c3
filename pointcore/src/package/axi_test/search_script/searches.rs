//! Points, queries, and what the golden model finds, at places all over the point memory.

use crate::number::{decode, encode};
use crate::search::{
    MemorySettings, Neighbor, PointSet, Query, Reuse, SearchEngine, SearchError, Session, Splitting, Tree,
};
use fastrand::Rng;
use pointcore_contract::bus::units::chunk_records;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CachedQuery, CachedResult, Points};
use pointcore_contract::{Format, fields};
use std::collections::{BTreeMap, HashMap};

/// Points of the tree, unless the hardware holds less.
const POINTS: usize = 120;
/// Queries of a run.
const QUERIES: usize = 10;
/// Neighbors a query asks for at most, but one that asks for all that the core finds.
const LARGEST_K: u32 = 6;
/// Tries until queries lie far enough apart.
const TRIES: usize = 10_000;
/// The radius of balls.
const RADIUS: f32 = 0.25;
/// Tries until a leaf has a place.
const PLACES_TRIED: u32 = 1000;
/// An odd number that leads from one query's number to the next.
const NUMBER_STEP: u32 = 0x9e37_79b1;

/// Points, queries and neighbors.
pub struct Searches {
    /// The tree.
    pub tree: Tree,
    /// What is sent of each query, but its number.
    pub sent: Vec<CachedQuery>,
    /// The neighbors of each, nearest first.
    pub found: Vec<Vec<Neighbor>>,
}

/// Where leaves lie in the point memory, and which numbers queries bear.
pub struct Placement {
    /// From a leaf's beats in the tree to those in memory.
    pub begins: BTreeMap<u32, u32>,
    first_number: u32,
}

impl Searches {
    /// A search on the hardware of a configuration.
    pub fn new(config: &Config) -> Result<Self, SearchError> {
        let mut random = Rng::with_seed(1);
        let capacity = ((config.bucket as usize) << config.tree_depth)
            .min((1_usize << config.index_bits) / config.lanes as usize / 2);
        // Of the numbers of points near the wanted one, the first whose tree has a leaf of one beat.
        let mut points = PointSet::new(config.geometry, &[[0.0; 3]])?;
        let mut tree = Tree::build(config, &points, Splitting::Midpoint)?;
        for count in (1..=POINTS.min(capacity)).rev() {
            let places: Vec<_> = (0..count).map(|_| [(); 3].map(|()| 2.0 * random.f32() - 1.0)).collect();
            points = PointSet::new(config.geometry, &places)?;
            // Its leaves are as full as the points happen to lie.
            tree = Tree::build(config, &points, Splitting::Midpoint)?;
            if short_leaf(&tree).is_some() {
                break;
            }
        }
        // Balls lie apart, so what a core finds is what one without a neighbor cache does.
        let plain = Config { neighbor_cache: 0, ..config.clone() };
        let session = Session::open(plain, tree.clone(), MemorySettings::default(), SearchEngine::Golden)?;
        let mut asked = queries(config, &tree, points.points(), &mut random);
        if config.neighbor_cache == 0 {
            let nearest = session.search(&asked)?.neighbors;
            bound(config.geometry, &mut asked, &nearest);
        }
        let reuse = Reuse::default();
        let encode_one = |(index, query): (usize, &Query)| Ok(query.encode(config, reuse, index)?.sent);
        let sent = asked.iter().enumerate().map(encode_one).collect::<Result<Vec<_>, SearchError>>()?;
        // A neighbor cache searches balls that are larger, and hands out all that it finds.
        let alpha = if config.neighbor_cache > 0 { reuse.alpha } else { 1.0 };
        let larger = |query: &Query| Query { radius: query.radius.map(|radius| radius * alpha), ..*query };
        let searched: Vec<_> = asked.iter().map(larger).collect();
        let found = session.search(&searched)?.neighbors;
        Ok(Self { tree, sent, found })
    }

    /// The number of queries.
    pub fn count(&self) -> usize {
        self.sent.len()
    }

    /// A leaf of one beat and a query at its point.
    pub fn short_leaf(&self) -> Option<u32> {
        short_leaf(&self.tree)
    }

    /// The words of a query.
    pub fn query(&self, config: &Config, placement: &Placement, index: usize) -> Vec<u64> {
        let CachedQuery { query, reach } = self.sent[index];
        let [x, y, z] = query.point.map(u64::from);
        let number = placement.number(config, index);
        let words = [number.into(), query.k.into(), query.radius2.into(), x, y, z, reach.into()];
        words[..fields::<CachedQuery>(config).len()].to_vec()
    }

    /// The words of a query's results: of the neighbors found, the first so many.
    pub fn results(
        &self,
        config: &Config,
        placement: &Placement,
        index: usize,
        most: usize,
        is_cached: bool,
    ) -> Vec<Vec<u64>> {
        let number = placement.number(config, index).into();
        let width = fields::<CachedResult>(config).len();
        let neighbors = &self.found[index][..self.found[index].len().min(most)];
        let places: HashMap<u32, u32> =
            (0..self.tree.memory().len() as u32).filter_map(|place| Some((self.tree.source(place)?, place))).collect();
        let result = |(rank, neighbor): (usize, &Neighbor)| {
            let index = placement.place(config, places[&neighbor.point]);
            let distance2 = encode(config.geometry, neighbor.distance2);
            let last = rank + 1 == neighbors.len();
            [number, last.into(), 1, index.into(), distance2.into(), is_cached.into()][..width].to_vec()
        };
        let none = neighbors.is_empty().then(|| [number, 1, 0, 0, 0, is_cached.into()][..width].to_vec());
        neighbors.iter().enumerate().map(result).chain(none).collect()
    }
}

/// The first beat of a leaf of one beat.
fn short_leaf(tree: &Tree) -> Option<u32> {
    tree.writes().find(|write| write.is_leaf && write.bucket.beats == 1).map(|write| write.bucket.begin)
}

/// Queries at a point and elsewhere. A neighbor cache is asked for balls that lie apart: it finds none within another, in whatever
/// order they come.
fn queries(config: &Config, tree: &Tree, points: &[[f32; 3]], random: &mut Rng) -> Vec<Query> {
    let is_cached = config.neighbor_cache > 0;
    let at_leaf = short_leaf(tree).and_then(|begin| tree.source(begin * config.lanes));
    let first = at_leaf.map_or([0.0; 3], |point| points[point as usize]);
    let count = QUERIES.min(1 << config.index_bits.min(usize::BITS - 1));
    let mut queries = vec![Query { point: first, k: 1, radius: is_cached.then_some(RADIUS) }];
    let distance2 = |a: [f32; 3], b: [f32; 3]| (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f32>();
    for _ in 0..TRIES {
        if queries.len() == count {
            break;
        }
        let point = [(); 3].map(|()| 2.0 * random.f32() - 1.0);
        if is_cached && queries.iter().any(|other| distance2(point, other.point) < (3.0 * RADIUS).powi(2)) {
            continue;
        }
        // One of them asks for all that the core finds.
        let k = if queries.len() == 1 { config.neighbors } else { random.u32(1..=config.neighbors.min(LARGEST_K)) };
        queries.push(Query { point, k, radius: is_cached.then_some(RADIUS) });
    }
    queries
}

/// Has every third query ask within a ball that ends at the farthest of its neighbors, or right behind it. What comes of a ball
/// without points is not specified but for `found`, so one neighbor lies within at least.
fn bound(format: Format, queries: &mut [Query], nearest: &[Vec<Neighbor>]) {
    for (index, (query, found)) in queries.iter_mut().zip(nearest).enumerate().skip(2).step_by(3) {
        if let [nearest, .., farthest] = &found[..]
            && nearest.distance2 < farthest.distance2
        {
            let behind = index as u32 / 3 % 2;
            let radius2 = encode(format, farthest.distance2) + behind;
            query.radius = Some(decode(format, radius2).sqrt());
        }
    }
}

impl Placement {
    /// Places leaves at random, some across the borders of bursts.
    pub fn new(config: &Config, tree: &Tree, seed: u64) -> Self {
        let mut random = Rng::with_seed(seed);
        let beats = 1_u32 << config.beat_bits();
        let chunk = chunk_records::<Points>(config, config.bus.memory_bits);
        let mut begins = BTreeMap::new();
        let mut taken: Vec<(u32, u32)> = vec![];
        for (rank, leaf) in tree.writes().filter(|write| write.is_leaf).enumerate() {
            let count = u32::from(leaf.bucket.beats);
            let mut candidates = (0..PLACES_TRIED).map(|_| {
                let any = random.u32(..=beats - count);
                // Some across a border, anywhere in them.
                let crosses = rank % 3 == 0 && chunk < beats;
                if crosses { (any / chunk * chunk).saturating_sub(random.u32(..count)) } else { any }
            });
            let is_free =
                |begin: &u32| taken.iter().all(|(other, length)| begin + count <= *other || other + length <= *begin);
            let Some(begin) = candidates.find(is_free) else {
                // In a memory that is nearly full all stay where they are.
                let leaves = tree.writes().filter(|write| write.is_leaf);
                let begins = leaves.map(|leaf| (leaf.bucket.begin, leaf.bucket.begin)).collect();
                return Self { begins, first_number: random.u32(..) };
            };
            taken.push((begin, count));
            begins.insert(leaf.bucket.begin, begin);
        }
        Self { begins, first_number: random.u32(..) }
    }

    /// The number of a query.
    pub fn number(&self, config: &Config, index: usize) -> u32 {
        let number = self.first_number.wrapping_add((index as u32).wrapping_mul(NUMBER_STEP));
        number & (u32::MAX >> (u32::BITS - config.index_bits))
    }

    /// Where the point of a place in the tree's memory lies.
    fn place(&self, config: &Config, place: u32) -> u32 {
        let beat = place / config.lanes;
        let (begin, moved) = self.begins.range(..=beat).next_back().expect("every point lies in a leaf");
        (moved + beat - begin) * config.lanes + place % config.lanes
    }
}
