//! The priority queues against their model and against sorting.

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::Queue;
use pointcore_hdl::search::queue;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, configs, distance2, lockstep, number, start, word};
use crate::support::cases;

const QUERIES: u64 = 250;
/// Numbers have more bits than that; what is above is for show.
const NUMBERED: u64 = 256;

/// So many of a distance's last bits differ where it is told from others by a hair.
const HAIR_BITS: u32 = 6;

/// The query of a thread.
#[derive(Clone, Default)]
struct Search {
    number: usize,
    k: usize,
    radius2: f32,
    leaves_left: u32,
    /// Those whose last beat is not done with.
    under_way: u32,
    /// Most of its points are as far as this word says, but for its last bits.
    hair: Option<u64>,
    distances: Vec<f32>,
}

/// Threads that search a few leaves each, or none, as many at once as may be; of a leaf, beats follow each other.
#[derive(Clone)]
struct Searches {
    config: Config,
    queries_left: u64,
    threads: Vec<Search>,
    /// Distances expected and found, by query.
    expected: Vec<Vec<f32>>,
    found: Vec<Vec<f32>>,
}

impl Searches {
    fn restart(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.queries_left > 0 {
            self.queries_left -= 1;
            let beyond = feeds.random.u64(..1 << self.config.index_bits) / NUMBERED * NUMBERED;
            let start = start(&self.config, thread, beyond + self.queries_left, &mut feeds.random);
            let leaves_left = feeds.random.u32(..5);
            let radius2 = number(&self.config, start[3]);
            self.threads[thread as usize] = Search {
                number: (start[1] % NUMBERED) as usize,
                k: start[2] as usize,
                radius2,
                leaves_left,
                under_way: 0,
                hair: feeds.random.bool().then(|| word(&self.config, distance2(&self.config, &mut feeds.random))),
                distances: vec![],
            };
            feeds.feed("start", start);
        }
    }

    /// Whether the thread has another leaf, and its points come.
    fn leaf(&mut self, feeds: &mut Feeds, thread: u64) -> bool {
        let search = &mut self.threads[thread as usize];
        if search.leaves_left == 0 || search.under_way == self.config.leaves_in_flight {
            return false;
        }
        search.leaves_left -= 1;
        search.under_way += 1;
        let beats = feeds.random.u64(1..6);
        for beat in 0..beats {
            let mut item = vec![thread, feeds.random.u64(..1 << self.config.beat_bits()), u64::from(beat + 1 == beats)];
            for _ in 0..self.config.lanes {
                let random = &mut feeds.random;
                let distance2 = match (random.u8(..8), search.hair) {
                    (0, _) => f32::NAN,
                    (1..7, Some(word)) => {
                        let bits = random.u32(..=HAIR_BITS);
                        number(&self.config, word ^ random.u64(..1 << bits))
                    }
                    _ => distance2(&self.config, random),
                };
                search.distances.push(distance2);
                item.push(word(&self.config, distance2));
            }
            feeds.feed("candidates", item);
        }
        true
    }
}

impl Rule for Searches {
    const SEEDS: u64 = 120;

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "start" | "radius" => {
                let thread = fields[0];
                if stream == "radius" {
                    self.threads[thread as usize].under_way -= 1;
                }
                while self.leaf(feeds, thread) {}
                let search = &self.threads[thread as usize];
                if search.under_way > 0 {
                    return;
                }
                let mut near = search.distances.clone();
                near.retain(|&distance2| distance2 < search.radius2);
                near.sort_by(f32::total_cmp);
                near.truncate(search.k);
                self.expected[search.number] = near;
                feeds.feed("finish", vec![fields[0]]);
            }
            "released" => self.restart(feeds, fields[0]),
            "result" if fields[2] == 1 => {
                self.found[(fields[0] % NUMBERED) as usize].push(number(&self.config, fields[4]))
            }
            _ => {}
        }
    }
}

#[test]
fn queues_agree_with_the_model_and_with_sorting() {
    for config in cases(configs()) {
        let threads = config.threads;
        let begin = |feeds: &mut Feeds| {
            let nothing = vec![vec![]; QUERIES as usize];
            let mut searches = Searches {
                config: config.clone(),
                queries_left: QUERIES,
                threads: vec![Search::default(); threads as usize],
                expected: nothing.clone(),
                found: nothing,
            };
            (0..threads.into()).for_each(|thread| searches.restart(feeds, thread));
            searches
        };
        let (module, model) = (queue::module(&config), Queue::new(&config));
        lockstep(&config, &module, &model, &units::queue::UNIT, begin, all, |searches, report| {
            assert_eq!(report.transfers("finish"), QUERIES);
            assert_eq!(searches.found, searches.expected);
        });
    }
}
