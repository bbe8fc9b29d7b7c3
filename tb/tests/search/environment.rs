//! A unit's surroundings that react to it: streams and pulses in, fed at random times, streams out, taken at random
//! times, and a rule that says what follows from a transfer.

use std::collections::VecDeque;

use pointcore_tb::lockstep::{Flow, Stall, Stalls, Stimulus, StreamPorts, Streams};
use pointcore_tb::verilated::{Direction, Library, Port};

/// Cycles without a transfer that end a run, where its rule does not say otherwise; longer than any latency or pause here.
const QUIET_CYCLES: u64 = 500;

/// What waits to enter the unit.
#[derive(Clone)]
pub struct Feeds {
    sources: Vec<Source>,
    inputs: Vec<Port>,
    held: Vec<(usize, u64)>,
    /// What is held from the next cycle on.
    held_next: Vec<(usize, u64)>,
    /// For what the rule leaves to chance.
    pub random: fastrand::Rng,
}

#[derive(Clone)]
struct Source {
    stream: StreamPorts,
    /// Each with the cycles that it waits at the head.
    items: VecDeque<(u32, Vec<u64>)>,
    offering: bool,
    stalls: Stalls,
}

impl Source {
    /// The item to be offered in this cycle, if any.
    fn next(&mut self) -> Option<Vec<u64>> {
        match self.items.front_mut() {
            Some((cycles, _)) if *cycles > 0 => {
                *cycles -= 1;
                None
            }
            _ if self.stalls.stalled() => None,
            _ => self.items.pop_front().map(|(_, item)| item),
        }
    }
}

impl Feeds {
    /// Queues an item of an input stream or pulse.
    pub fn feed(&mut self, stream: &str, item: Vec<u64>) {
        self.feed_after(0, stream, item);
    }

    /// Queues an item that waits for some cycles when it is the next one.
    pub fn feed_after(&mut self, cycles: u32, stream: &str, item: Vec<u64>) {
        let source = self.sources.iter_mut().find(|source| source.stream.name == stream);
        let source = source.unwrap_or_else(|| panic!("no input stream {stream}"));
        assert_eq!(item.len(), source.stream.fields.len(), "{stream}");
        source.items.push_back((cycles, item));
    }

    /// Holds an input that belongs to no stream.
    pub fn hold(&mut self, name: &str, value: u64) {
        let position = self.position(name);
        self.held.push((position, value));
    }

    /// Raises an input that belongs to no stream for a cycle.
    pub fn pulse(&mut self, name: &str) {
        let position = self.position(name);
        self.held.push((position, 1));
        self.held_next.push((position, 0));
    }

    fn position(&self, name: &str) -> usize {
        self.inputs.iter().position(|port| port.name == name).expect("inputs are named as specified")
    }
}

/// What follows from what moves.
pub trait Rule: Clone {
    /// Runs of one configuration.
    const SEEDS: u64 = 40;

    /// Called for every transfer, in the cycle after it.
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]);

    /// Cycles without a transfer that end a run.
    fn quiet_cycles(&self) -> u64 {
        QUIET_CYCLES
    }
}

/// The surroundings of a unit.
#[derive(Clone)]
pub struct Environment<R> {
    streams: Streams,
    feeds: Feeds,
    sinks: Vec<(usize, Stalls)>,
    /// The rule, with what it has collected.
    pub rule: R,
    quiet: u64,
}

impl<R: Rule> Environment<R> {
    /// Around instances of `library`. `begin` queues the first items and makes the rule; `seed` decides everything random.
    pub fn new(library: &Library, seed: u64, begin: impl FnOnce(&mut Feeds) -> R) -> Self {
        let streams = Streams::of(library);
        let mut random = fastrand::Rng::with_seed(seed);
        let mut stalls = || {
            let patterns =
                [Stall::Never, Stall::Random(0.3), Stall::Bursts(30), Stall::Varied, Stall::Varied, Stall::Varied];
            let pattern = patterns[random.usize(..patterns.len())];
            Stalls::new(pattern, random.fork())
        };
        let (mut sources, mut sinks) = (vec![], vec![]);
        for stream in &streams {
            match (stream.direction, stream.ready) {
                (Direction::Input, _) => {
                    let stream = stream.clone();
                    sources.push(Source { stream, items: VecDeque::new(), offering: false, stalls: stalls() });
                }
                (Direction::Output, Some(ready)) => sinks.push((ready, stalls())),
                (Direction::Output, None) => {}
            }
        }
        let mut feeds = Feeds { sources, inputs: library.inputs().to_vec(), held: vec![], held_next: vec![], random };
        let rule = begin(&mut feeds);
        Self { streams, feeds, sinks, rule, quiet: 0 }
    }

    /// Tells the rule what moved in the cycle before.
    fn react(&mut self, outputs: &[u64], inputs: &[u64]) -> bool {
        let moved: Vec<_> = self.streams.iter().filter(|stream| stream.transfers(inputs, outputs)).collect();
        for stream in &moved {
            if let Some(source) = self.feeds.sources.iter_mut().find(|source| source.stream == **stream) {
                source.offering = false;
            }
            let (words, _) = stream.sides(inputs, outputs);
            let fields: Vec<u64> = stream.fields.iter().map(|&field| words[field]).collect();
            self.rule.transferred(&mut self.feeds, &stream.name, &fields);
        }
        !moved.is_empty()
    }
}

impl<R: Rule> Stimulus for Environment<R> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let moved = cycle > 0 && self.react(outputs, inputs);
        for (position, value) in self.feeds.held.drain(..) {
            inputs[position] = value;
        }
        self.feeds.held = std::mem::take(&mut self.feeds.held_next);
        let Feeds { sources, inputs: ports, random, .. } = &mut self.feeds;
        for source in sources.iter_mut().filter(|source| !source.offering) {
            let item = source.next();
            source.offering = item.is_some();
            inputs[source.stream.valid] = u64::from(source.offering);
            for (index, &field) in source.stream.fields.iter().enumerate() {
                // A unit that looks at fields while nothing is offered is wrong.
                inputs[field] =
                    item.as_ref().map_or_else(|| random.u64(..) >> (64 - ports[field].width), |item| item[index]);
            }
        }
        for (ready, stalls) in &mut self.sinks {
            inputs[*ready] = u64::from(!stalls.stalled());
        }
        let waiting = self.feeds.sources.iter().any(|source| source.offering || !source.items.is_empty());
        self.quiet = if moved || waiting { 0 } else { self.quiet + 1 };
        if self.quiet > self.rule.quiet_cycles() { Flow::Done } else { Flow::Continue }
    }
}
