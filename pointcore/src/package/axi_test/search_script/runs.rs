//! Runs of the search core: whole ones, disturbed ones, and such as are aborted.

use super::super::control::Control;
use super::super::operations::{Channel, Pauses};
use super::super::registers::{BUSY, DONE, RESET, clear, refuse_while_busy};
use super::super::script::{Script, words};
use super::memory;
use super::searches::{Placement, Searches};
use crate::search::{QueryKind, Reuse};
use pointcore_contract::bus::registers::{CONTROL, ErrorCounter, INTERRUPT_ENABLE, STATUS};
use pointcore_contract::bus::{Layout, Register};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CachedQuery, CachedResult};
use std::collections::BTreeMap;

/// Where points and the tree lie in each placement.
const POINTS_BASES: [u32; 2] = [0x5a96_7000, 0xa569_8000];
const TREE_BASES: [u32; 2] = [0xc35a_9000, 0x3ca5_6000];
/// Cycles in which what is under way comes to rest, or to wherever it is held.
pub const SETTLE_CYCLES: u32 = 300;
/// Cycles of the longest run.
const LONG_RUN_CYCLES: u32 = 70_000;
/// Resets while packets come: from the first one to beyond the last.
const RESETS: u32 = 10;
/// Queries of a run that lacks others.
pub const FEW: usize = 3;
/// A channel hardly moves.
const HARDLY: u8 = 248;
/// Nothing but holds a channel back.
pub const ALWAYS: u8 = 255;

/// A host with its core.
pub struct Host<'a> {
    pub control: Control<'a>,
    pub config: &'a Config,
    pub searches: &'a Searches,
    placements: [Placement; 2],
    /// The placement in force.
    now: usize,
}

impl<'a> Host<'a> {
    pub fn new(script: &'a mut Script, config: &'a Config, map: &'a [Register], searches: &'a Searches) -> Self {
        let placements = [1, 2].map(|seed| Placement::new(config, &searches.tree, seed));
        Self { control: Control { script, map }, config, searches, placements, now: 0 }
    }

    /// The tree of a placement; one of its leaves may be without beats.
    pub fn tree(&self, placement: usize, empty: Option<u32>) -> BTreeMap<u32, Vec<u8>> {
        memory::tree(self.config, self.searches, &self.placements[placement], empty)
    }

    /// Places tree and points, and resets the core, whose caches would hold what lay there before.
    pub fn enter(&mut self, placement: usize) {
        self.now = placement;
        self.place(None);
        self.set_up();
        self.control.script.write(CONTROL, RESET);
    }

    /// Sets all that a reset takes back.
    fn set_up(&mut self) {
        self.control.set("points_base", POINTS_BASES[self.now]);
        self.control.set("tree_base", TREE_BASES[self.now]);
        self.control.script.write(INTERRUPT_ENABLE, 1);
        let setup = Reuse::default().setup(self.config.geometry, QueryKind::Ball);
        self.control.set("cache_ball", setup.ball.into());
        self.control.set("cache_far_scale", setup.far_scale);
        self.control.set("cache_margin_scale", setup.margin_scale);
    }

    fn place(&mut self, empty: Option<u32>) {
        let now = self.now;
        let placement = &self.placements[now];
        let points = memory::points(self.control.script, self.config, self.searches, placement, POINTS_BASES[now]);
        let records = self.tree(now, empty);
        let tree = if self.config.tree_cache > 0 {
            memory::tree_image(self.control.script, &records, TREE_BASES[now])
        } else {
            self.write_tree(&records);
            0
        };
        self.control.script.images([points, tree]);
    }

    /// A query's packet, with noise where it holds nothing.
    fn packet(&mut self, values: &[u64]) -> Vec<u32> {
        let layout = Layout::record::<CachedQuery>(self.config);
        self.control.script.packet(&layout, values, self.config.bus.stream_bits)
    }

    fn values(&self, index: usize) -> Vec<u64> {
        self.searches.query(self.config, &self.placements[self.now], index)
    }

    fn send_values(&mut self, values: &[u64]) {
        let packet = self.packet(values);
        self.control.script.send(&packet, self.config.bus.stream_bits);
    }

    pub fn send(&mut self, index: usize) {
        let values = self.values(index);
        self.send_values(&values);
    }

    /// Expects the results of queries; of each so many as the core finds for it.
    pub fn expect(&mut self, indices: impl Iterator<Item = usize>) {
        let answers: Vec<_> = indices.map(|index| self.answer(index, usize::MAX, false)).collect();
        self.control.script.expect(&answers);
    }

    /// The results of a query, at most so many, as where they lie, and how many they are.
    fn answer(&mut self, index: usize, most: usize, is_cached: bool) -> (u32, u32) {
        let config = self.config;
        let placement = &self.placements[self.now];
        let results = self.searches.results(config, placement, index, most, is_cached);
        let layout = Layout::record::<CachedResult>(config);
        let bytes = layout.packet_bytes(config.bus.stream_bits);
        let packets: Vec<u32> = results.iter().flat_map(|result| words(&layout.encode(result, bytes))).collect();
        let place = self.control.script.data(&packets);
        (place, results.len() as u32)
    }

    pub fn start(&mut self, queries: u32) {
        self.control.set("queries", queries);
        self.control.start();
    }

    pub fn all(&self) -> std::ops::Range<usize> {
        0..self.searches.count()
    }

    /// A whole run.
    pub fn run(&mut self, pauses: Pauses) {
        self.control.script.pauses(pauses);
        self.run_all();
    }

    /// A whole run in which one channel hardly moves, and what is before it fills.
    pub fn run_narrow(&mut self, channel: Channel) {
        self.control.script.pauses(Pauses::None);
        self.control.script.share(channel, HARDLY);
        self.run_all();
    }

    /// A whole run, whose queries wait for its start.
    fn run_all(&mut self) {
        self.all().for_each(|index| self.send(index));
        self.control.script.wait(SETTLE_CYCLES);
        self.control.script.check_quiet(0);
        self.expect(self.all());
        self.start(self.searches.count() as u32);
        self.control.script.wait_received(0);
        self.control.finish(self.searches.count());
    }

    /// A reset of one cycle while packets come, each time a cycle later: nothing is left of any of them.
    pub fn reset_among_packets(&mut self) {
        for cycles in 0..RESETS {
            self.control.script.pauses(Pauses::None);
            self.start(u32::MAX);
            (0..FEW.min(self.searches.count())).for_each(|index| self.send(index));
            self.control.script.wait(cycles);
            self.control.script.reset(1);
            self.set_up();
            self.run_all();
        }
    }

    /// A run whose end no interrupt tells.
    pub fn run_silently(&mut self) {
        self.control.script.pauses(Pauses::Some);
        self.control.script.write(INTERRUPT_ENABLE, 0);
        self.expect(self.all());
        self.start(self.searches.count() as u32);
        self.control.script.read(STATUS, BUSY);
        self.all().for_each(|index| self.send(index));
        self.control.script.wait_received(0);
        self.control.script.wait_low(BUSY);
        self.control.script.interrupt(0);
        self.control.script.errors(DONE);
        self.control.script.write(INTERRUPT_ENABLE, 1);
        self.control.script.wait(2);
        self.control.script.interrupt(1);
        self.control.script.write(INTERRUPT_ENABLE, 0);
        self.control.script.wait(2);
        self.control.script.interrupt(0);
        self.control.script.write(INTERRUPT_ENABLE, 1);
    }

    /// A run with broken packets among the good ones, and with all that must not be done during a run.
    pub fn run_disturbed(&mut self) {
        self.control.script.pauses(Pauses::Some);
        self.control.script.share(Channel::Receive, ALWAYS);
        self.expect(self.all());
        self.start(self.searches.count() as u32);
        for index in self.all().skip(1) {
            self.send_broken(index);
            self.send(index);
        }
        self.control.script.wait(SETTLE_CYCLES);
        refuse_while_busy(self.control.script, self.control.map);
        self.control.script.read(INTERRUPT_ENABLE, 1);
        if self.config.tree_cache == 0 {
            self.check_locked();
        }
        self.control.script.share(Channel::Receive, 0);
        self.send_broken(0);
        self.control.script.wait_sent();
        self.control.script.wait(SETTLE_CYCLES);
        self.control.script.errors(BUSY);
        self.send(0);
        self.control.script.wait_received(0);
        self.control.finish(self.searches.count());
        clear(self.control.script);
        self.control.script.errors(DONE);
    }

    /// Packets of every kind that is refused.
    fn send_broken(&mut self, index: usize) {
        let config = self.config;
        let stream_words = (config.bus.stream_bits / 32) as usize;
        let values = self.values(index);
        let good = self.packet(&values);
        let (infinity, sign) = (config.geometry.infinity(), config.geometry.sign_mask());
        let mut wrong = vec![
            (1, 0),
            (2, infinity + 1),
            (2, infinity | sign),
            (2, sign),
            (2, u64::MAX >> (64 - config.geometry.width())),
        ];
        let largest = (1_u64 << config.rank_bits()) - 1;
        // In its bits there may be no number beyond those that the core finds.
        wrong.extend((u64::from(config.neighbors) + 1..=largest).take(1).map(|k| (1, k)));
        wrong.extend((u64::from(config.neighbors) + 1..=largest).last().map(|k| (1, k)));
        for (field, value) in wrong {
            let mut values = values.clone();
            values[field] = value;
            self.send_values(&values);
            self.control.script.count(ErrorCounter::Packet);
        }
        for beats in 1..good.len() / stream_words {
            self.control.script.send(&good[..beats * stream_words], config.bus.stream_bits);
            self.control.script.count(ErrorCounter::Packet);
        }
        for beats in [1, 2, good.len() / stream_words] {
            let long: Vec<u32> = good.iter().chain(good.iter().cycle().take(beats * stream_words)).copied().collect();
            self.control.script.send(&long, config.bus.stream_bits);
            self.control.script.count(ErrorCounter::Packet);
        }
    }

    /// Runs with answers of memory that are errors, and bursts that are misshapen.
    pub fn run_spoilt(&mut self) {
        for shares in [[40, 0, 0], [0, 40, 0], [60, 90, 0]] {
            // Without a reset caches would answer.
            self.control.script.write(CONTROL, RESET);
            self.control.script.spoil(shares);
            self.run(Pauses::Some);
        }
        self.control.script.spoil([0; 3]);
        clear(self.control.script);
        self.control.script.errors(DONE);
    }

    /// Beats that nobody asked for change nothing.
    pub fn give_unasked(&mut self) {
        let memories = 1 + u32::from(self.config.tree_cache > 0);
        for memory in 0..memories {
            for beats in [1, 3, 2] {
                self.control.script.give_unasked(memory, beats);
            }
            self.control.script.wait(20);
            self.control.script.errors(DONE);
        }
        self.control.script.write(CONTROL, RESET);
        self.run(Pauses::None);
        clear(self.control.script);
    }

    /// A run that waits for its last query for long.
    pub fn run_long(&mut self) {
        self.control.script.pauses(Pauses::None);
        self.expect(self.all());
        self.start(self.searches.count() as u32);
        self.all().skip(1).for_each(|index| self.send(index));
        self.control.script.wait(LONG_RUN_CYCLES);
        self.send(0);
        self.control.script.wait_received(0);
        self.control.finish(self.searches.count());
    }

    /// A leaf without beats is read as of one, and counted.
    pub fn read_empty_leaf(&mut self) {
        let Some(leaf) = self.searches.short_leaf() else { return };
        self.place(Some(leaf));
        self.control.script.write(CONTROL, RESET);
        self.control.script.pauses(Pauses::None);
        self.expect(0..1);
        self.start(1);
        self.send(0);
        self.control.script.count(ErrorCounter::Burst);
        self.control.script.wait_received(0);
        self.control.finish(1);
        clear(self.control.script);
    }

    /// A query that is asked again is answered by the neighbor cache, but for settings that let it answer none. If it was not
    /// told of balls, it keeps the last of as many neighbors as were asked for to itself.
    pub fn run_cached(&mut self) {
        self.control.script.pauses(Pauses::None);
        let index = self.searches.count() - 1;
        let found = self.searches.found[index].len();
        let full = usize::from(found == usize::from(self.searches.sent[index].query.k));
        let setup = Reuse::default().setup(self.config.geometry, QueryKind::Ball);
        for (ball, far_scale) in [(1, setup.far_scale), (1, 0), (0, 0), (1, setup.far_scale)] {
            self.control.set("cache_ball", ball);
            self.control.set("cache_far_scale", far_scale);
            let most = if ball == 1 { found } else { found - full };
            let first = self.answer(index, most, false);
            let again = self.answer(index, most, far_scale != 0);
            self.control.script.expect(&[first]);
            self.start(2);
            self.send(index);
            self.control.script.wait_received(0);
            self.control.script.wait(SETTLE_CYCLES);
            self.control.script.expect(&[again]);
            self.send(index);
            self.control.script.wait_received(0);
            self.control.finish(2);
        }
    }
}
