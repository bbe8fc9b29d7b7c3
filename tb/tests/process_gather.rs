//! The gathering of neighbors against its model, with lines that compete for slots and a memory that answers late.

use std::collections::VecDeque;
use std::sync::Arc;

use pointcore_contract::Format;
use pointcore_contract::process::library::program;
use pointcore_contract::process::{Config, units};
use pointcore_golden::process::Gatherer;
use pointcore_hdl::process::gatherer;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};
use crate::support::cases;

const NEIGHBORS: u32 = 1500;
/// Runs, between which the points change.
const RUNS: u32 = 3;

/// Whole lines and single points, few slots and a slot for every line, narrow and wide words.
fn configs() -> [Config; 3] {
    let base = Config {
        program: Arc::new(program("mls")),
        format: Format::F32.flushed(),
        index_bits: 10,
        neighbors: 16,
        threads: 128,
        rate: 1,
        line_points: 4,
        cache_lines: 8,
    };
    let sph = Arc::new(program("sph_forces"));
    [
        Config { line_points: 1, cache_lines: 64, program: sph, format: Format::F24.flushed(), ..base.clone() },
        Config { line_points: 8, cache_lines: 256, threads: 1, index_bits: 8, ..base.clone() },
        base,
    ]
}

/// Neighbors of queries that are near each other, and now and then of one far away; between them some that take one slot by turns.
#[derive(Clone)]
struct Wanted {
    config: Config,
    runs_left: u32,
    center: u64,
    /// What is wanted: the words of its place, and its index.
    open: VecDeque<(Vec<u64>, u64)>,
    indices: u64,
}

impl Wanted {
    /// The words of a point of this run, as good as any.
    fn point(&self, index: u64) -> Vec<u64> {
        let mut random = fastrand::Rng::with_seed(index << 8 | u64::from(self.runs_left));
        let words = self.config.program.neighbor.words().into_iter();
        words.map(|word| random.u64(..1 << self.config.word_bits(word.ty))).collect()
    }

    fn want(&mut self, feeds: &mut Feeds) {
        let random = &mut feeds.random;
        if random.u8(..40) == 0 {
            self.center = random.u64(..self.indices);
        }
        let in_slots = u64::from(self.config.cache_lines * self.config.line_points);
        let offset = if random.u8(..24) == 0 { random.u64(..self.indices) * in_slots } else { random.u64(..24) };
        let index = (self.center + offset) % self.indices;
        let (thread, farthest) = (random.u64(..u64::from(self.config.threads)), random.u64(..2));
        let place = vec![thread, farthest, u64::from(random.u8(..16) == 0), random.u64(..2)];
        self.open.push_back((place.clone(), index));
        feeds.feed("gather", place.into_iter().chain([index]).collect());
    }

    fn run(&mut self, feeds: &mut Feeds) {
        (0..NEIGHBORS).for_each(|_| self.want(feeds));
    }
}

impl Rule for Wanted {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "fetch" => {
                let points = u64::from(self.config.line_points);
                for point in 0..points {
                    // Most answers come together, some late.
                    let latency = if point == 0 && feeds.random.u8(..3) == 0 { feeds.random.u32(..40) } else { 0 };
                    feeds.feed_after(latency, "fill", self.point(fields[0] * points + point));
                }
            }
            "gathered" => {
                let (place, index) = self.open.pop_front().expect("nothing comes that was not wanted");
                let is_none = place[2] == 1;
                let words = self.point(index);
                let words = if is_none { vec![0; words.len()] } else { words };
                assert_eq!(fields, place.into_iter().chain(words).collect::<Vec<_>>());
                if self.open.is_empty() && self.runs_left > 0 {
                    self.runs_left -= 1;
                    feeds.pulse("forget");
                    self.run(feeds);
                }
            }
            _ => {}
        }
    }
}

#[test]
fn neighbors_come_in_their_order_as_in_the_model() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| {
            let indices = 1 << config.index_bits;
            let mut wanted =
                Wanted { config: config.clone(), runs_left: RUNS - 1, center: 0, open: VecDeque::new(), indices };
            wanted.run(feeds);
            wanted
        };
        let (module, model) = (gatherer::module(&config), Gatherer::new(&config));
        lockstep(&config, &module, &model, &units::gatherer::UNIT, begin, all, |wanted, report| {
            assert!(wanted.runs_left == 0 && wanted.open.is_empty());
            assert_eq!(report.transfers("gathered"), u64::from(RUNS * NEIGHBORS));
            let [hits, misses] = ["event_line_hit", "event_line_miss"].map(|event| report.events(event));
            assert_eq!(misses, report.transfers("fetch"));
            assert_eq!(report.transfers("fill"), misses * u64::from(config.line_points));
            assert!(hits > u64::from(NEIGHBORS) && misses > 60, "{hits} hits, {misses} misses");
        });
    }
}
