//! The sieve against its model, with radii that shrink while leaves pass; nothing near enough may be lost.

use std::collections::VecDeque;

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::Sieve;
use pointcore_hdl::search::sieve;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, configs, distance2, lockstep, number, radius2, start, word};
use crate::support::cases;

const LEAVES: u64 = 1500;

/// A beat on its way through the unit.
#[derive(Clone)]
struct Beat {
    query: usize,
    item: Vec<u64>,
}

/// Threads that search some leaves a query, whose radii the queue makes smaller.
#[derive(Clone)]
struct Searches {
    config: Config,
    leaves_left: u64,
    next_address: u64,
    /// By thread: its query, leaves still to be visited, leaves under way.
    threads: Vec<(usize, u32, u32)>,
    /// By query: the radius² that the unit knows, and the smaller one that is on its way.
    radii: Vec<f32>,
    next_radii: Vec<f32>,
    beats: VecDeque<Beat>,
}

impl Searches {
    fn restart(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.leaves_left > 0 {
            let start = start(&self.config, thread, 0, &mut feeds.random);
            let leaves = feeds.random.u32(1..8);
            self.threads[thread as usize] = (self.radii.len(), leaves, 0);
            self.radii.push(number(&self.config, start[3]));
            self.next_radii.push(number(&self.config, start[3]));
            feeds.feed("start", start);
        }
    }

    /// Feeds leaves until there are as many under way as there may be.
    fn search(&mut self, feeds: &mut Feeds, thread: u64) {
        let (query, mut left, mut under_way) = self.threads[thread as usize];
        while left > 0 && under_way < self.config.leaves_in_flight {
            (left, under_way) = (left - 1, under_way + 1);
            self.leaves_left = self.leaves_left.saturating_sub(1);
            let beats = feeds.random.u64(1..5);
            for beat in 1..=beats {
                let mut item = vec![thread, self.next_address, u64::from(beat == beats)];
                self.next_address = (self.next_address + 1) % (1 << self.config.beat_bits());
                item.extend((0..self.config.lanes).map(|_| {
                    let near = distance2(&self.config, &mut feeds.random);
                    word(&self.config, if feeds.random.u8(..8) == 0 { f32::NAN } else { near })
                }));
                self.beats.push_back(Beat { query, item: item.clone() });
                feeds.feed("candidates", item);
            }
        }
        self.threads[thread as usize] = (query, left, under_way);
        if left == 0 && under_way == 0 {
            self.restart(feeds, thread);
        }
    }

    fn leaf_ended(&mut self, feeds: &mut Feeds, thread: u64) {
        self.threads[thread as usize].2 -= 1;
        self.search(feeds, thread);
    }

    /// Whether a beat has a point that its query wants even now.
    fn is_near(&self, beat: &Beat) -> bool {
        beat.item[3..].iter().any(|&distance2| number(&self.config, distance2) < self.radii[beat.query])
    }
}

impl Rule for Searches {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "start" => self.search(feeds, fields[0]),
            "kept" => {
                let is_kept = |beat: &Beat| beat.item[..2] == fields[..2];
                while let Some(beat) = self.beats.pop_front().filter(|beat| !is_kept(beat)) {
                    assert!(!self.is_near(&beat), "beat {:?} is lost", beat.item);
                }
                if fields[2] == 1 {
                    let query = self.threads[fields[0] as usize].0;
                    let farthest = radius2(&self.config, &mut feeds.random);
                    self.next_radii[query] = farthest.min(self.next_radii[query]);
                    feeds.feed("radius", vec![fields[0], word(&self.config, self.next_radii[query])]);
                }
            }
            "radius" => {
                let radius = &mut self.radii[self.threads[fields[0] as usize].0];
                *radius = number(&self.config, fields[1]);
                self.leaf_ended(feeds, fields[0]);
            }
            "skipped" => self.leaf_ended(feeds, fields[0]),
            _ => {}
        }
    }
}

#[test]
fn beats_without_a_near_point_are_taken_out_as_in_the_model() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| {
            let mut searches = Searches {
                config: config.clone(),
                leaves_left: LEAVES,
                next_address: 0,
                threads: vec![(0, 0, 0); config.threads as usize],
                radii: vec![],
                next_radii: vec![],
                beats: VecDeque::new(),
            };
            (0..config.threads.into()).for_each(|thread| searches.restart(feeds, thread));
            searches
        };
        let (module, model) = (sieve::module(&config), Sieve::new(&config));
        lockstep(&config, &module, &model, &units::sieve::UNIT, begin, all, |searches, report| {
            assert_eq!(searches.leaves_left, 0);
            assert!(searches.threads.iter().all(|(_, left, under_way)| left + under_way == 0));
            assert!(searches.beats.iter().all(|beat| !searches.is_near(beat)), "the last beats are lost");
            let [beats, kept, leaves, skipped] =
                ["candidates", "kept", "radius", "skipped"].map(|stream| report.transfers(stream));
            assert!(kept < beats, "{kept} of {beats} beats are kept");
            assert!(leaves > 20 && skipped > 20, "{leaves} leaves with kept beats, {skipped} without");
        });
    }
}

/// Beats, starts and radii at any time: once all threads have begun, nothing follows from anything.
#[derive(Clone)]
struct Disorder {
    config: Config,
    begun: u32,
}

impl Disorder {
    fn feed(&self, feeds: &mut Feeds) {
        let mut thread = || feeds.random.u64(..u64::from(self.config.threads));
        let [of_beat, starting, narrowing] = [thread(), thread(), thread()];
        let mut beat = vec![of_beat, feeds.random.u64(..1 << self.config.beat_bits()), feeds.random.u64(..2)];
        beat.extend((0..self.config.lanes).map(|_| word(&self.config, distance2(&self.config, &mut feeds.random))));
        let start = start(&self.config, starting, 0, &mut feeds.random);
        let radius2 = word(&self.config, radius2(&self.config, &mut feeds.random));
        feeds.feed("candidates", beat);
        feeds.feed("start", start);
        feeds.feed("radius", vec![narrowing, radius2]);
    }
}

impl Rule for Disorder {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, _: &[u64]) {
        if stream == "start" {
            self.begun += 1;
            if self.begun == self.config.threads {
                (0..LEAVES).for_each(|_| self.feed(feeds));
            }
        }
    }
}

#[test]
fn the_sieve_agrees_with_the_model_when_nothing_follows_from_anything() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| {
            for thread in 0..config.threads {
                let start = start(&config, thread.into(), 0, &mut feeds.random);
                feeds.feed("start", start);
            }
            Disorder { config: config.clone(), begun: 0 }
        };
        let (module, model) = (sieve::module(&config), Sieve::new(&config));
        lockstep(&config, &module, &model, &units::sieve::UNIT, begin, all, |_, report| {
            assert_eq!(report.transfers("candidates"), LEAVES);
            assert!(report.transfers("kept") > 0 && report.transfers("skipped") > 0);
        });
    }
}
