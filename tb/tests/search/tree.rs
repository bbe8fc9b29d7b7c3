//! Small random trees for the search core, and brute force.

use pointcore_contract::search::Config;

use crate::search::{Coordinate, coordinate, fine_coordinate, number, word};

/// Points of a tree; they fill the leaves of the smallest.
const MOST_POINTS: u32 = 128;

/// Points in the order of the memory, and the writes that set up the core's tables.
#[derive(Clone)]
pub struct Tree {
    /// Of the core it is for.
    pub config: Config,
    /// By index; NaN where a lane holds no point.
    pub points: Vec<[f32; 3]>,
    /// Records of `tree`.
    pub writes: Vec<Vec<u64>>,
}

impl Tree {
    /// A tree over random points of a coarse grid, split in random dimensions, with internal leaves where there are few points.
    pub fn random(config: &Config, random: &mut fastrand::Rng) -> Self {
        Self::over(coordinate, config, random)
    }

    /// The same over points whose coordinates have all the bits of a mantissa.
    pub fn fine(config: &Config, random: &mut fastrand::Rng) -> Self {
        Self::over(fine_coordinate, config, random)
    }

    /// The same over points with coordinates of a kind.
    pub fn over(coordinate: Coordinate, config: &Config, random: &mut fastrand::Rng) -> Self {
        let most = (config.bucket << config.tree_depth).min(MOST_POINTS);
        let count = if random.bool() { most } else { random.u32(1..=most) };
        let mut points: Vec<_> = (0..count).map(|_| [(); 3].map(|()| coordinate(random))).collect();
        let mut tree = Self { config: config.clone(), points: vec![], writes: vec![] };
        tree.build(config, random, (1, 0), &mut points);
        tree.shift(random);
        tree
    }

    /// Moves all points to somewhere in memory.
    fn shift(&mut self, random: &mut fastrand::Rng) {
        let lanes = self.config.lanes as usize;
        let beats = random.usize(..=(1 << self.config.beat_bits()) - self.points.len() / lanes);
        self.points.splice(..0, std::iter::repeat_n([f32::NAN; 3], beats * lanes));
        self.writes.iter_mut().filter(|write| write[0] == 1).for_each(|write| write[5] += beats as u64);
    }

    fn build(&mut self, config: &Config, random: &mut fastrand::Rng, node: (u64, u32), points: &mut [[f32; 3]]) {
        let (address, level) = node;
        let internal = level < config.tree_depth;
        if !internal || (points.len() <= config.bucket as usize && random.bool()) {
            if internal {
                self.writes.push(vec![0, address, 0, 0, 1, 0, 0]);
            }
            self.leaf((address << (config.tree_depth - level)) & ((1 << config.tree_depth) - 1), points);
            return;
        }
        let dimension = random.usize(..3);
        points.sort_by(|a, b| a[dimension].total_cmp(&b[dimension]));
        let middle = points.len() / 2;
        let split = points.get(middle).map_or(0.0, |point| point[dimension]);
        self.writes.push(vec![0, address, word(config, split), dimension as u64, 0, 0, 0]);
        let (left, right) = points.split_at_mut(middle);
        self.build(config, random, (2 * address, level + 1), left);
        self.build(config, random, (2 * address + 1, level + 1), right);
    }

    /// A leaf has a beat even without points.
    fn leaf(&mut self, number: u64, points: &[[f32; 3]]) {
        let lanes = self.config.lanes as usize;
        let beats = points.len().div_ceil(lanes).max(1);
        let begin = self.points.len() / lanes;
        self.points.extend(points);
        self.points.resize((begin + beats) * lanes, [f32::NAN; 3]);
        self.writes.push(vec![1, number, 0, 0, 0, begin as u64, beats as u64]);
    }

    /// The beats of a leaf for a thread, which asks for so many from an address on.
    pub fn beats(&self, thread: u64, address: u64, beats: u64) -> impl Iterator<Item = Vec<u64>> {
        (address..address + beats).map(move |beat| {
            let lanes = self.config.lanes as usize;
            let begin = beat as usize * lanes;
            let points = self.points[begin..begin + lanes].iter().flatten();
            let place = [thread, beat, u64::from(beat + 1 == address + beats)];
            place.into_iter().chain(points.map(|&coordinate| word(&self.config, coordinate))).collect()
        })
    }

    /// What a tree in external memory holds of a node or leaf: the fields of the write that belongs there.
    pub fn record(&self, address: u64) -> &[u64] {
        let is_leaf = address >> self.config.tree_depth;
        let key = [is_leaf, address - (is_leaf << self.config.tree_depth)];
        let write = self.writes.iter().find(|write| write[..2] == key);
        &write.unwrap_or_else(|| panic!("nobody asks for {address}, which the tree does not have"))[2..]
    }

    /// The addresses of its inner nodes.
    pub fn nodes(&self) -> impl Iterator<Item = u64> + '_ {
        self.writes.iter().filter(|write| write[0] == 0).map(|write| write[1])
    }

    /// The leaves' numbers.
    pub fn leaves(&self) -> Vec<u64> {
        self.writes.iter().filter(|write| write[0] == 1).map(|write| write[1]).collect()
    }

    /// The squared distance of a point. On the coarse grid of [`coordinate`] no format rounds it.
    pub fn distance2(&self, index: u64, query: [f32; 3]) -> f32 {
        let point = self.points[index as usize];
        let offsets: [f32; 3] = std::array::from_fn(|axis| point[axis] - query[axis]);
        offsets[0] * offsets[0] + offsets[1] * offsets[1] + offsets[2] * offsets[2]
    }

    /// Where a query is.
    pub fn point(&self, query: &[u64]) -> [f32; 3] {
        [3, 4, 5].map(|field| number(&self.config, query[field]))
    }

    /// The radius around a query to a core with a neighbor cache.
    pub fn reach(&self, query: &[u64]) -> f32 {
        number(&self.config, query[6])
    }

    /// The squared distances of the nearest points that a query asks for, by looking at all of them.
    pub fn nearest(&self, query: &[u64]) -> Vec<f32> {
        let (point, k, radius2) = (self.point(query), query[1] as usize, number(&self.config, query[2]));
        let distances = (0..self.points.len() as u64).map(|index| self.distance2(index, point));
        let mut near: Vec<_> = distances.filter(|&distance2| distance2 < radius2).collect();
        near.sort_by(f32::total_cmp);
        near.truncate(k);
        near
    }
}
