//! Small random trees for core B, and brute force.

use pointcore_spec::core_b::Config;

use crate::core_b::{coordinate, word};

/// Points in the order of the memory, and the writes that set up the core's tables.
#[derive(Clone)]
pub struct Tree {
    lanes: usize,
    /// By index; NaN where a lane holds no point.
    pub points: Vec<[f32; 3]>,
    /// Records of `tree`.
    pub writes: Vec<Vec<u64>>,
}

impl Tree {
    /// A tree over random points, split in random dimensions, with internal leaves where there are few points.
    pub fn random(config: &Config, random: &mut fastrand::Rng) -> Self {
        let most = (config.bucket << config.tree_depth) * 3 / 4;
        let count = random.u32(1..=most.min(100));
        let mut points: Vec<_> = (0..count).map(|_| [(); 3].map(|()| coordinate(random))).collect();
        let mut tree = Self { lanes: config.lanes as usize, points: vec![], writes: vec![] };
        tree.build(config, random, (1, 0), &mut points);
        tree
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
        self.writes.push(vec![0, address, word(split), dimension as u64, 0, 0, 0]);
        let (left, right) = points.split_at_mut(middle);
        self.build(config, random, (2 * address, level + 1), left);
        self.build(config, random, (2 * address + 1, level + 1), right);
    }

    /// A leaf has a beat even without points.
    fn leaf(&mut self, number: u64, points: &[[f32; 3]]) {
        let beats = points.len().div_ceil(self.lanes).max(1);
        let begin = self.points.len() / self.lanes;
        self.points.extend(points);
        self.points.resize((begin + beats) * self.lanes, [f32::NAN; 3]);
        self.writes.push(vec![1, number, 0, 0, 0, begin as u64, beats as u64]);
    }

    /// The coordinates of the points of a beat, lane by lane.
    pub fn beat(&self, address: u64) -> impl Iterator<Item = u64> {
        let begin = address as usize * self.lanes;
        self.points[begin..begin + self.lanes].iter().flatten().map(|&coordinate| word(coordinate))
    }

    /// The squared distance of a point, summed as the hardware does.
    pub fn distance2(&self, index: u64, query: [f32; 3]) -> f32 {
        let point = self.points[index as usize];
        let offsets: [f32; 3] = std::array::from_fn(|axis| point[axis] - query[axis]);
        offsets[0] * offsets[0] + offsets[1] * offsets[1] + offsets[2] * offsets[2]
    }

    /// The squared distances of the `k` nearest points nearer than the radius, by looking at all of them.
    pub fn nearest(&self, query: [f32; 3], k: usize, radius2: f32) -> Vec<f32> {
        let distances = (0..self.points.len() as u64).map(|index| self.distance2(index, query));
        let mut near: Vec<_> = distances.filter(|&distance2| distance2 < radius2).collect();
        near.sort_by(f32::total_cmp);
        near.truncate(k);
        near
    }
}
