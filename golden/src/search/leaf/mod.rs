//! Leaf processing: fetches the points of a leaf and computes their squared distances to the query (thesis figure 6.9).
//!
//! `((x − q_x)² + (y − q_y)²) + (z − q_z)²`, each operation rounded once; NaN for a lane without a point.

mod table;

use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Beat, Candidates, Point};
pub use pointcore_contract::search::units::leaf::{In, Out};
use table::Table;

/// The leaf processing.
#[derive(Clone, Debug)]
pub struct Leaf {
    lanes: usize,
    geometry: Format,
    /// Not with a tree cache, which knows the leaves.
    table: Option<Table>,
    points: Vec<Point>,
    beat: Skid<Beat>,
    /// A beat with its query's point.
    paired: Option<(Beat, Point)>,
    distance: Datapath<Candidates>,
}

impl Leaf {
    /// The unit with a distance pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            lanes: config.lanes as usize,
            geometry: config.geometry,
            table: (config.tree_cache == 0).then(|| Table::new(config)),
            points: vec![Point::default(); config.threads as usize],
            beat: Skid::default(),
            paired: None,
            distance: Datapath::new(latency, 1),
        }
    }

    fn measure(&self, beat: &Beat, query: Point) -> Candidates {
        let mut candidates = Candidates { place: beat.place, ..Candidates::default() };
        for (distance, point) in candidates.distances.iter_mut().zip(&beat.points.lane[..self.lanes]) {
            *distance = squared_distance(self.geometry, *point, query);
        }
        candidates
    }
}

/// The squared distance as the hardware rounds it.
#[must_use]
pub fn squared_distance(geometry: Format, point: Point, query: Point) -> u32 {
    let square = |axis: usize| {
        let difference = Number::new(geometry, point[axis]) - Number::new(geometry, query[axis]);
        difference * difference
    };
    (square(0) + square(1) + square(2)).bits()
}

impl Model for Leaf {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            leaf_ready: self.table.as_ref().is_some_and(Table::leaf_ready),
            fetch: self.table.as_ref().and_then(Table::fetch),
            beat_ready: self.beat.in_ready(),
            candidates: self.distance.out().copied(),
        }
    }

    fn clock(&mut self, inputs: &In) {
        if let Some(table) = &mut self.table {
            table.step(inputs);
        }

        let measured = self.paired.as_ref().filter(|_| self.distance.in_ready());
        let takes_beat = self.paired.is_none() || measured.is_some();
        let candidates = measured.map(|(beat, query)| self.measure(beat, *query));
        self.distance.step(candidates.map(Token::Kept), inputs.candidates_ready);
        if takes_beat {
            self.paired = self.beat.out().map(|beat| (*beat, self.points[beat.place.thread.index()]));
        }
        self.beat.step(inputs.beat, takes_beat);

        if let Some(start) = inputs.start {
            self.points[start.thread.index()] = start.query.point;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::for_each_seed;
    use pointcore_contract::search::records::{BeatPlace, Bucket, Query, Thread};
    use pointcore_contract::search::records::{LeafVisit, Points, Start, TreeWrite};

    /// The host's f32 rounds each operation as the hardware does.
    #[test]
    fn distances_round_each_operation() {
        for_each_seed("leaf", |random| {
            for _ in 0..2000 {
                let mut point = || [(); 3].map(|()| (random.f32() - 0.5) * 2.0_f32.powi(random.i32(-20..20)));
                let (a, b) = (point(), point());
                let [x, y, z] = [0, 1, 2].map(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis]));
                let distance = squared_distance(Format::F32, a.map(f32::to_bits), b.map(f32::to_bits));
                assert_eq!(f32::from_bits(distance), x + y + z);
            }
        });
    }

    #[test]
    fn distances_are_in_the_lanes_of_their_points_and_to_their_threads_queries() {
        let mut leaf = Leaf::new(&Config { lanes: 2, ..Config::default() }, 3);
        let point = |x: f32| [x, 0.0, 0.0].map(f32::to_bits);
        for (thread, x) in [(0, 1.0), (1, 5.0)] {
            let start = Start { thread: Thread { thread }, query: Query { point: point(x), ..Query::default() } };
            leaf.clock(&In { start: Some(start), ..In::default() });
        }
        let mut points = [point(0.0); 8];
        points[0] = point(7.0);
        points[1] = point(f32::NAN);
        let mut shown = Vec::new();
        for cycle in 0..20_u8 {
            let place = BeatPlace { thread: Thread { thread: cycle }, address: 9, last: cycle == 1 };
            let beat = (cycle < 2).then_some(Beat { place, points: Points { lane: points } });
            shown.extend(leaf.outputs().candidates.map(|candidates| {
                assert_eq!(candidates.place.address, 9);
                let [first, second, ..] = candidates.distances.map(f32::from_bits);
                (candidates.place.thread.thread, candidates.place.last, first, second.is_nan())
            }));
            leaf.clock(&In { beat, candidates_ready: true, ..In::default() });
        }
        assert_eq!(shown, [(0, false, 36.0, true), (1, true, 4.0, true)]);
    }

    #[test]
    fn a_leaf_is_fetched_by_its_entry_of_the_table() {
        let mut leaf = Leaf::new(&Config { tree_depth: 2, ..Config::default() }, 1);
        for address in 0..4 {
            let bucket = Bucket { begin: 100 + address, beats: address as u8 + 1 };
            let write = TreeWrite { is_leaf: true, address, bucket, ..TreeWrite::default() };
            leaf.clock(&In { tree: Some(write), ..In::default() });
        }
        let (mut next, mut fetched) = (0, Vec::new());
        for cycle in 0..30 {
            let out = leaf.outputs();
            let visit = (next < 4).then(|| LeafVisit { thread: Thread { thread: 5 }, leaf: 3 - next });
            let fetch_ready = cycle % 3 == 0;
            next += u32::from(visit.is_some() && out.leaf_ready);
            fetched.extend(
                out.fetch.filter(|_| fetch_ready).map(|fetch| (fetch.thread.thread, fetch.address, fetch.beats)),
            );
            leaf.clock(&In { leaf: visit, fetch_ready, ..In::default() });
        }
        assert_eq!(fetched, [(5, 103, 4), (5, 102, 3), (5, 101, 2), (5, 100, 1)]);
    }
}
