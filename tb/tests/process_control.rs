//! Control against its model, with surroundings that answer sooner or later.

use pointcore_contract::process::records::Gather;
use pointcore_contract::process::{Config, queries, stages};
use pointcore_golden::process::Control;
use pointcore_hdl::process::control;

use crate::process::scene::{configs, field, item, number};
use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};
use crate::support::cases;

const QUERIES: u64 = 300;

/// Searches find some neighbors, `init` and `kernel` and `final` take their time.
#[derive(Clone)]
struct Surroundings {
    config: Config,
    /// By thread.
    lists: Vec<Vec<u64>>,
    /// Neighbors that `kernel` has met since its thread's turn began, and whether `init` is over.
    met: Vec<Vec<u64>>,
    prepared: Vec<bool>,
    released: u64,
    /// Turns with so many neighbors: none, one, more.
    turns: [u64; 3],
}

impl Surroundings {
    fn begin(config: &Config, feeds: &mut Feeds) -> Self {
        for index in 0..QUERIES {
            let number = number(config, index);
            let query = item::<queries::Query>(config, &[number], &mut feeds.random);
            feeds.feed("query", query);
        }
        let threads = config.threads as usize;
        Self {
            config: config.clone(),
            lists: vec![vec![]; threads],
            met: vec![vec![]; threads],
            prepared: vec![!config.has_init(); threads],
            released: 0,
            turns: [0; 3],
        }
    }

    fn search(&mut self, feeds: &mut Feeds, thread: u64) {
        let most = self.config.neighbors.into();
        let count = [0, 1, most, feeds.random.u64(0..=most)][feeds.random.usize(..4)];
        let list: Vec<u64> = (0..count).map(|_| feeds.random.u64(..1 << self.config.index_bits)).collect();
        for (rank, &index) in list.iter().enumerate() {
            feeds.feed("found", vec![thread, u64::from(rank + 1 == list.len()), 1, index]);
        }
        if list.is_empty() {
            let index = feeds.random.u64(..1 << self.config.index_bits);
            feeds.feed("found", vec![thread, 1, 0, index]);
        }
        self.lists[thread as usize] = list;
    }

    /// The end of an iteration.
    fn finish(&mut self, feeds: &mut Feeds, thread: usize) {
        assert_eq!(self.met[thread], self.lists[thread], "thread {thread}");
        self.turns[self.met[thread].len().min(2)] += 1;
        self.met[thread].clear();
        self.prepared[thread] = !self.config.has_init();
        match feeds.random.u8(..4) {
            0 => feeds.feed("again", vec![thread as u64, 0]),
            1 => feeds.feed("again", vec![thread as u64, 1]),
            _ => feeds.feed("released", vec![thread as u64]),
        }
    }
}

impl Rule for Surroundings {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let thread = fields[0] as usize;
        match stream {
            "want" => self.search(feeds, fields[0]),
            "listed" => assert_eq!(fields[1], self.lists[thread].len() as u64),
            "prepare" => feeds.feed("prepared", vec![fields[0]]),
            "prepared" => self.prepared[thread] = true,
            "released" => self.released += 1,
            "gather" => {
                let [farthest, none, last, index] =
                    ["farthest", "none", "last", "index"].map(|name| field::<Gather>(&self.config, fields, name));
                assert_eq!(none == 1, self.lists[thread].is_empty());
                if farthest == 1 {
                    assert_eq!(index, self.lists[thread].last().copied().unwrap_or(0));
                    feeds.feed("prepared", vec![fields[0]]);
                    return;
                }
                assert!(self.prepared[thread], "`init` comes first");
                self.met[thread].extend((none == 0).then_some(index));
                if last == 1 {
                    self.finish(feeds, thread);
                }
            }
            _ => {}
        }
    }
}

#[test]
fn every_query_meets_its_neighbors_in_order_as_in_the_model() {
    for config in cases(configs()) {
        let (module, model) = (control::module(&config), Control::new(&config));
        let begin = |feeds: &mut Feeds| Surroundings::begin(&config, feeds);
        lockstep(&config, &module, &model, &stages::control::UNIT, begin, all, |surroundings, report| {
            assert_eq!(report.transfers("query"), QUERIES);
            assert_eq!(surroundings.released, QUERIES);
            assert_eq!(report.transfers("again") + QUERIES, surroundings.turns.iter().sum::<u64>());
            let [none, one, more] = surroundings.turns;
            assert!(none > 0 && one > 0 && (more > 0 || config.neighbors == 1), "{none}, {one}, {more}");
        });
    }
}
