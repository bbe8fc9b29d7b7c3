//! The script for the point processor.

use super::control::Control;
use super::operations::{Burst, Pauses, Refusal};
use super::registers::{self, ABORT, RESET, START, clear, refuse_while_busy};
use super::script::{Script, words};
use super::search_script::memory::{WORD_BYTES, table};
use crate::points::{PointsSession, Task};
use crate::process::Answer;
use crate::search::{MemorySettings, PointSet, SearchEngine, SearchError, Splitting, Tree};
use fastrand::Rng;
use pointcore_contract::bus::config::{BORDER_BYTES, TREE_WORD_BITS};
use pointcore_contract::bus::registers::{CONTROL, ErrorCounter, INTERRUPT_ENABLE, PointsRegisters, RegisterMap};
use pointcore_contract::bus::{Layout, packets};
use pointcore_contract::points::Config;
use pointcore_contract::process::queries::{Outcome, Query};
use pointcore_contract::process::records::Neighbor;
use pointcore_contract::process::{Scalar, Word};
use pointcore_contract::search;
use pointcore_contract::search::records::{Bucket, Node, Points};
use std::collections::BTreeMap;

/// The seed of everything that a script chooses.
const SEED: u64 = 1;
/// Where positions, points and tree lie; the first two share an image.
const POINTS_BASE: u32 = 0x5a96_7000;
const LINES_BASE: u32 = 0x2969_8000;
const TREE_BASE: u32 = 0xc35a_9000;
const POINTS: usize = 60;
const QUERIES: usize = 16;
const ITERATIONS: u32 = 3;
/// Runs that are aborted somewhere.
const ABORTS: u32 = 4;
/// Runs that a reset ends somewhere.
const RESETS: u32 = 4;
/// Cycles of a reset.
const RESET_CYCLES: u32 = 5;
/// Cycles in which what is under way comes to rest.
const SETTLE_CYCLES: u32 = 300;
const SIZE: u32 = WORD_BYTES.ilog2();
const INCREMENTING: u32 = 1;
const ALL_STROBES: u32 = 0xff;

/// Points with attributes, and what queries among them leave with.
struct World {
    tree: Tree,
    points: Vec<Vec<u32>>,
    settings: Vec<u32>,
    queries: Vec<Vec<u32>>,
    k: u32,
    answers: Vec<Answer>,
}

/// A word of a program that is no extreme.
fn word(config: &Config, random: &mut Rng, Word { ty, .. }: &Word) -> u32 {
    match ty {
        Scalar::Float => crate::number::encode(config.process.format, 2.0 * random.f32() - 1.0),
        Scalar::Int => random.u32(..16),
        Scalar::Bool => random.u32(..2),
    }
}

impl World {
    fn new(config: &Config) -> Result<Self, SearchError> {
        let random = &mut Rng::with_seed(SEED);
        let Config { search, process } = config;
        let room = (search.bucket as usize) << search.tree_depth;
        let count = POINTS.min(room).min(1 << (search.index_bits - 1));
        let positions: Vec<[f32; 3]> = (0..count).map(|_| std::array::from_fn(|_| 2.0 * random.f32() - 1.0)).collect();
        let set = PointSet::new(search.geometry, &positions)?;
        let tree = Tree::build(search, &set, Splitting::Median)?;
        let program = &process.program;
        let rest: Vec<Word> = program.neighbor.words().split_off(3);
        let point = |position: &[u32; 3]| {
            let attributes: Vec<u32> = rest.iter().map(|item| word(config, random, item)).collect();
            [&position[..], &attributes].concat()
        };
        let points = set.encoded().iter().map(point).collect();
        let settings = program.settings.words().iter().map(|item| word(config, random, item) & !(1 << 31)).collect();
        let query = |_| program.query.words().iter().map(|item| word(config, random, item)).collect();
        let queries = (0..QUERIES).map(query).collect();
        // A neighbor cache takes one neighbor more.
        let k = (search.neighbors - u32::from(search.neighbor_cache > 0)).clamp(1, 9);
        let mut world = Self { tree, points, settings, queries, k, answers: vec![] };
        // What it would reuse hangs on time; it is told to reuse nothing.
        let plain = Config { search: search::Config { neighbor_cache: 0, ..search.clone() }, process: process.clone() };
        let session = PointsSession::open(plain, MemorySettings::default(), SearchEngine::Golden)?;
        let task = Task {
            settings: &world.settings,
            iterations: ITERATIONS,
            queries: &world.queries,
            points: &world.points,
            k,
            radius: None,
        };
        world.answers = session.run(&world.tree, task, &|_, _| {})?.answers;
        Ok(world)
    }
}

/// A host with its core.
struct Host<'a> {
    control: Control<'a>,
    config: &'a Config,
    world: &'a World,
}

impl Host<'_> {
    fn enter(&mut self) {
        let Config { search, .. } = self.config;
        let positions = self.image();
        let records = self.tree();
        let tree = if search.tree_cache > 0 {
            let at = |(number, bytes): (&u32, &Vec<u8>)| {
                (u64::from(TREE_BASE) + u64::from(*number) * bytes.len() as u64, bytes.clone())
            };
            table(self.control.script, &records.iter().map(at).collect())
        } else {
            self.write_tree(&records);
            0
        };
        self.control.script.images([positions, tree]);
        let infinity = search.geometry.infinity() as u32;
        let searched = self.world.k + u32::from(search.neighbor_cache > 0);
        let settings = [
            ("points_base", POINTS_BASE),
            ("lines_base", LINES_BASE),
            ("tree_base", TREE_BASE),
            ("k", searched),
            ("radius2", infinity),
            ("cache_far_scale", 0),
            ("iterations_max", ITERATIONS),
        ];
        settings.into_iter().for_each(|(name, value)| self.control.set(name, value));
        for (Word { name, .. }, value) in self.config.process.program.settings.words().iter().zip(&self.world.settings)
        {
            self.control.set(&format!("setting_{name}"), *value);
        }
        self.control.script.write(CONTROL, RESET);
        self.control.script.write(INTERRUPT_ENABLE, 1);
    }

    /// Positions as the search reads them, and points as the program does, whole lines of them.
    fn image(&mut self) -> u32 {
        let (World { tree, points, .. }, Config { search, process }) = (self.world, self.config);
        let mut beats = BTreeMap::new();
        let layout = Layout::record::<Points>(search);
        let stride = layout.stride(search.bus.memory_bits);
        for beat in 0..tree.memory().len() as u32 / search.lanes {
            let values: Vec<u64> = tree.beat(beat).iter().flatten().map(|number| (*number).into()).collect();
            beats.insert(u64::from(POINTS_BASE + beat * stride), layout.encode(&values, stride));
        }
        let layout = Layout::record::<Neighbor>(process);
        let stride = layout.stride(search.bus.memory_bits);
        let places = (tree.memory().len() as u32).next_multiple_of(process.line_points);
        for place in 0..places {
            let words = tree.source(place).map_or_else(
                || vec![0; process.program.neighbor.len()],
                |index| points[index as usize].iter().map(|word| u64::from(*word)).collect(),
            );
            beats.insert(u64::from(LINES_BASE + place * stride), layout.encode(&words, stride));
        }
        assert!(beats.len() < BORDER_BYTES as usize, "a small world");
        table(self.control.script, &beats)
    }

    /// The records of the tree by number, as bytes.
    fn tree(&self) -> BTreeMap<u32, Vec<u8>> {
        let config = &self.config.search;
        let (node, leaf) = (Layout::record::<Node>(config), Layout::record::<Bucket>(config));
        let beat_bits = if config.tree_cache > 0 { config.bus.memory_bits } else { TREE_WORD_BITS };
        let stride = packets::tree_stride(config, beat_bits);
        let record = |write: search::records::TreeWrite| {
            if write.is_leaf {
                let values = [write.bucket.begin.into(), write.bucket.beats.into()];
                (1 << config.tree_depth | write.address, leaf.encode(&values, stride))
            } else {
                let values = [write.node.split.into(), write.node.dimension.into(), write.node.internal_leaf.into()];
                (write.address, node.encode(&values, stride))
            }
        };
        self.world.tree.writes().map(record).collect()
    }

    fn write_tree(&mut self, records: &BTreeMap<u32, Vec<u8>>) {
        for (number, bytes) in records {
            let (address, data) = (number * WORD_BYTES, words(bytes));
            let strobes = (0, ALL_STROBES);
            let burst = Burst { address, data, length: 0, size: SIZE, kind: INCREMENTING, strobes, misplaced: 0 };
            self.control.script.begin_burst(&burst, true);
        }
        self.control.script.sync();
    }

    /// A query's packet, with noise where it holds nothing.
    fn send(&mut self, index: usize) {
        let (process, stream_bits) = (&self.config.process, self.config.search.bus.stream_bits);
        let layout = Layout::record::<Query>(process);
        let values: Vec<u64> = std::iter::once(index as u64)
            .chain(self.world.queries[index].iter().map(|word| u64::from(*word)))
            .collect();
        let packet = self.control.script.packet(&layout, &values, stream_bits);
        self.control.script.send(&packet, stream_bits);
    }

    /// Expects what leaves with queries.
    fn expect(&mut self, indices: std::ops::Range<usize>) {
        let (process, stream_bits) = (&self.config.process, self.config.search.bus.stream_bits);
        let layout = Layout::record::<Outcome>(process);
        let bytes = layout.packet_bytes(stream_bits);
        let mut expected = vec![];
        for index in indices {
            let Answer { outputs, iterations, capped, .. } = &self.world.answers[index];
            let first = [index as u64, (*iterations).into(), (*capped).into()];
            let values: Vec<u64> = first.into_iter().chain(outputs.iter().map(|word| u64::from(*word))).collect();
            let place = self.control.script.data(&words(&layout.encode(&values, bytes)));
            expected.push((place, 1));
        }
        self.control.script.expect(&expected);
    }

    fn start(&mut self, queries: usize) {
        self.control.set("queries", queries as u32);
        self.control.start();
    }

    /// A whole run, whose queries wait for its start.
    fn run(&mut self, pauses: Pauses) {
        self.control.script.pauses(pauses);
        (0..QUERIES).for_each(|index| self.send(index));
        self.control.script.wait(SETTLE_CYCLES);
        self.control.script.check_quiet(0);
        self.expect(0..QUERIES);
        self.start(QUERIES);
        self.control.script.wait_received(0);
        self.control.finish(QUERIES);
    }

    /// A run with all that must not be done during one.
    fn run_disturbed(&mut self) {
        self.control.script.pauses(Pauses::Some);
        self.expect(0..QUERIES);
        self.start(QUERIES);
        (1..QUERIES).for_each(|index| self.send(index));
        self.control.script.wait(SETTLE_CYCLES);
        refuse_while_busy(self.control.script, self.control.map);
        self.control.script.refuse(CONTROL, START, Refusal::Busy);
        self.send(0);
        self.control.script.wait_received(0);
        self.control.finish(QUERIES);
        clear(self.control.script);
    }

    /// Runs with answers of memory that are errors, and bursts that are misshapen.
    fn run_spoilt(&mut self) {
        for shares in [[40, 0, 0], [0, 40, 0]] {
            // Without a reset caches would answer.
            self.control.script.write(CONTROL, RESET);
            self.control.script.spoil(shares);
            self.run(Pauses::Some);
        }
        self.control.script.spoil([0; 3]);
        clear(self.control.script);
    }

    /// Beats that nobody asked for change nothing.
    fn give_unasked(&mut self) {
        for memory in 0..1 + u32::from(self.config.search.tree_cache > 0) {
            self.control.script.give_unasked(memory, 3);
            self.control.script.wait(20);
        }
        self.control.script.write(CONTROL, RESET);
        self.run(Pauses::None);
        clear(self.control.script);
    }

    /// A run that is aborted somewhere on its way.
    fn abort_somewhere(&mut self) {
        let sent = self.begin_somewhere();
        self.control.script.write(CONTROL, ABORT);
        self.control.script.wait_interrupt();
        self.control.check_counters(sent);
        self.control.script.expect(&[]);
        self.control.script.check_quiet(0);
    }

    /// A run that a reset of one cycle ends somewhere on its way, and one of which the reset leaves nothing.
    fn reset_somewhere(&mut self) {
        self.begin_somewhere();
        self.control.script.reset(1);
        self.control.script.expect(&[]);
        self.enter();
        self.run(Pauses::Some);
    }

    /// Begins a run and sends some of its queries; returns how many.
    fn begin_somewhere(&mut self) -> usize {
        self.control.script.pauses(Pauses::Some);
        self.expect(0..QUERIES);
        let sent = self.control.script.random.usize(1..QUERIES);
        self.start(QUERIES);
        (0..sent).for_each(|index| self.send(index));
        self.control.script.wait_sent();
        let cycles = self.control.script.random.u32(..SETTLE_CYCLES);
        self.control.script.wait(cycles);
        sent
    }

    /// A broken packet is counted, and what follows is right.
    fn send_broken(&mut self) {
        let process = &self.config.process;
        let layout = Layout::record::<Query>(process);
        let words_a_beat = self.config.search.bus.stream_bits / 32;
        let beats = layout.beats(self.config.search.bus.stream_bits);
        for beats in [beats + 1, beats * 2].into_iter().chain((beats > 1).then_some(1)) {
            let noise: Vec<u32> = (0..beats * words_a_beat).map(|_| self.control.script.random.u32(..)).collect();
            self.control.script.send(&noise, self.config.search.bus.stream_bits);
            self.control.script.count(ErrorCounter::Packet);
        }
        self.run(Pauses::Some);
        clear(self.control.script);
    }
}

/// The whole script.
///
/// # Errors
/// The configuration is not valid, or the golden model is stuck.
pub fn script(config: &Config) -> Result<Script, SearchError> {
    let map = PointsRegisters::registers(config);
    let world = World::new(config)?;
    let mut script = Script::new(SEED);
    for pauses in [Pauses::None, Pauses::Some] {
        script.pauses(pauses);
        registers::check_reset(&mut script, &map);
        registers::check_accesses(&mut script, &map);
    }
    registers::check_late(&mut script, &map);
    let mut host = Host { control: Control { script: &mut script, map: &map }, config, world: &world };
    host.enter();
    host.run(Pauses::None);
    host.run(Pauses::Some);
    host.run_disturbed();
    host.run_spoilt();
    host.give_unasked();
    host.send_broken();
    (0..ABORTS).for_each(|_| host.abort_somewhere());
    (0..RESETS).for_each(|_| host.reset_somewhere());
    host.run(Pauses::Some);
    registers::start_after_reset(host.control.script, &map);
    host.control.script.reset(RESET_CYCLES);
    registers::check_reset(host.control.script, &map);
    host.enter();
    host.run(Pauses::Some);
    Ok(script)
}
