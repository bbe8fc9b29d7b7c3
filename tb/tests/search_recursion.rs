//! Stack recursion against its model, on random stacks.

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::Recursion;
use pointcore_hdl::search::recursion;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, configs, distance2, lockstep, radius2, start, word};
use crate::support::cases;

const PATHS: u64 = 2000;
/// Threads that pop without order.
const DISORDERLY: u64 = 500;

/// The stack, and leaves whose radii shrink while their threads search.
#[derive(Clone)]
struct Surroundings {
    config: Config,
    paths_left: u64,
    /// Radii on their way, by thread: a query starts when there are none.
    radii: Vec<u32>,
    waiting: Vec<bool>,
}

impl Surroundings {
    fn restart(&mut self, feeds: &mut Feeds, thread: u64) {
        let index = thread as usize;
        self.waiting[index] = self.radii[index] > 0;
        if !self.waiting[index] && self.paths_left > 0 {
            let start = start(&self.config, thread, 0, &mut feeds.random);
            feeds.feed("start", start);
        }
    }
}

impl Rule for Surroundings {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let thread = fields[0];
        let index = thread as usize;
        match stream {
            "start" => feeds.feed("in", vec![thread]),
            "pop" => {
                let some = self.paths_left > 0 && feeds.random.u8(..8) > 0;
                self.paths_left -= u64::from(some);
                feeds.hold("top_empty", u64::from(!some));
                if some {
                    let node = feeds.random.u64(2..1 << self.config.node_bits());
                    let any = distance2(&self.config, &mut feeds.random);
                    let distance2 = if feeds.random.u8(..8) == 0 { f32::NAN } else { any };
                    feeds.hold("top_node", node);
                    feeds.hold("top_distance2", word(&self.config, distance2));
                }
            }
            "resume" => {
                feeds.feed("in", vec![thread]);
                self.radii[index] += 1;
                let radius2 = radius2(&self.config, &mut feeds.random);
                feeds.feed("radius", vec![thread, word(&self.config, radius2)]);
            }
            "radius" => {
                self.radii[index] -= 1;
                if self.waiting[index] {
                    self.restart(feeds, thread);
                }
            }
            "empty" => self.restart(feeds, thread),
            _ => {}
        }
    }
}

#[test]
fn recursion_agrees_with_the_model() {
    for config in cases(configs()) {
        let threads = config.threads as usize;
        let begin = |feeds: &mut Feeds| {
            let mut surroundings = Surroundings {
                config: config.clone(),
                paths_left: PATHS,
                radii: vec![0; threads],
                waiting: vec![false; threads],
            };
            (0..threads).for_each(|thread| surroundings.restart(feeds, thread as u64));
            surroundings
        };
        let (module, model) = (recursion::module(&config), Recursion::new(&config));
        lockstep(&config, &module, &model, &units::recursion::UNIT, begin, all, |surroundings, report| {
            assert_eq!(surroundings.paths_left, 0);
            let resumed = report.transfers("resume");
            assert!(resumed > PATHS / 8 && resumed < PATHS, "{resumed} of {PATHS} paths were near");
            assert_eq!(report.transfers("empty"), report.transfers("start"));
        });
    }
}

/// Threads, radii and paths at any time: once all threads have begun, nothing follows from anything.
#[derive(Clone)]
struct Disorder {
    config: Config,
    begun: u32,
}

impl Disorder {
    fn feed(&self, feeds: &mut Feeds) {
        let mut thread = || feeds.random.u64(..u64::from(self.config.threads));
        let [popping, starting, narrowing] = [thread(), thread(), thread()];
        let start = start(&self.config, starting, 0, &mut feeds.random);
        let radius2 = word(&self.config, radius2(&self.config, &mut feeds.random));
        feeds.feed("in", vec![popping]);
        feeds.feed("start", start);
        feeds.feed("radius", vec![narrowing, radius2]);
    }
}

impl Rule for Disorder {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, _: &[u64]) {
        if stream == "start" {
            self.begun += 1;
            if self.begun == self.config.threads {
                (0..DISORDERLY).for_each(|_| self.feed(feeds));
            }
        }
        let node = feeds.random.u64(..1 << self.config.node_bits());
        let distance2 = word(&self.config, distance2(&self.config, &mut feeds.random));
        let is_empty = feeds.random.u8(..4) == 0;
        feeds.hold("top_empty", u64::from(is_empty));
        feeds.hold("top_node", node);
        feeds.hold("top_distance2", distance2);
    }
}

#[test]
fn recursion_agrees_with_the_model_when_nothing_follows_from_anything() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| {
            for thread in 0..config.threads {
                let start = start(&config, thread.into(), 0, &mut feeds.random);
                feeds.feed("start", start);
            }
            Disorder { config: config.clone(), begun: 0 }
        };
        let (module, model) = (recursion::module(&config), Recursion::new(&config));
        lockstep(&config, &module, &model, &units::recursion::UNIT, begin, all, |_, report| {
            assert_eq!(report.transfers("in"), DISORDERLY);
            assert_eq!(report.transfers("resume") + report.transfers("empty"), DISORDERLY);
        });
    }
}
