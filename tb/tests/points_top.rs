//! The point processor against its model in every cycle, and each query against the interpreter with the neighbors that
//! brute force finds, on small random trees, with memories that answer late.

use std::cell::Cell;
use std::collections::HashMap;

use pointcore_contract::fields;
use pointcore_contract::points::{Config, units};
use pointcore_contract::process::records::Settings;
use pointcore_golden::points::{Latencies, Top};
use pointcore_golden::process::{KernelPipelines, Pipeline};
use pointcore_golden::search::CacheLatencies;
use pointcore_golden::{process as golden_process, search as golden_search};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::points::top::{self, Core};

use crate::points::{Asked, World, anywhere, cores};
use crate::process::cloud::BLOCK_CYCLES;
use crate::search::environment::{Feeds, Rule};
use crate::search::memory::Memory;
use crate::search::tree::Tree;
use crate::search::{all, cache_scales, close_coordinate, lockstep, number};
use crate::support::cases;

const QUERIES: u64 = 24;
/// Cycles that a line of points takes at most, in a memory of one kind.
const MEMORY_CYCLES: [u32; 3] = [4, 40, 400];

/// The host and the memories.
#[derive(Clone)]
struct Host {
    world: World,
    /// Hardly two points are equally far from anywhere.
    is_apart: bool,
    queries: Vec<Vec<u64>>,
    writes_left: usize,
    positions: Memory,
    records: Memory,
    line_cycles: u32,
    /// By number: what it is to leave with, where no two neighbors are equally far.
    expected: HashMap<u64, Option<Vec<u64>>>,
    left: u64,
    compared: u64,
    anew: u64,
}

impl Host {
    fn begin(config: &Config, feeds: &mut Feeds) -> Self {
        let is_apart = feeds.random.bool();
        // Balls are compared with the model alone, so not where most neighborhoods are known.
        let has_balls = config.search.neighbor_cache > 0 && !is_apart && feeds.random.bool();
        let coordinate = if is_apart || has_balls { anywhere } else { close_coordinate };
        let mut world = World::random(config, coordinate, &mut feeds.random);
        if has_balls {
            world.ask_for_balls(&mut feeds.random);
        }
        let queries = world.queries(QUERIES, &mut feeds.random);
        world.touch(&queries, &mut feeds.random);
        let Asked { settings, k, radius2, iterations_max, .. } = &world.asked;
        for (field, &value) in fields::<Settings>(&config.process).iter().zip(settings) {
            feeds.hold(&format!("setting_{}", field.name), value.into());
        }
        let held =
            [("iterations_max", (*iterations_max).into()), ("search_k", (*k).into()), ("search_radius2", *radius2)];
        held.into_iter().for_each(|(name, value)| feeds.hold(name, value));
        let host = Self {
            queries,
            writes_left: world.tree.writes.len(),
            world,
            is_apart,
            positions: Memory::default(),
            records: Memory::default(),
            line_cycles: MEMORY_CYCLES[feeds.random.usize(..MEMORY_CYCLES.len())],
            expected: HashMap::new(),
            left: 0,
            compared: 0,
            anew: 0,
        };
        let search = &config.search;
        if search.neighbor_cache > 0 {
            let [ball, reach, margin_scale] = host.world.asked.cache(search);
            feeds.hold("search_reach", reach);
            // With balls that always count as covered, or never, if a digit of that is lost.
            let covers = has_balls && feeds.random.u8(..4) == 0;
            let margin_scale = if covers { f32::INFINITY } else { number(search, margin_scale) };
            let scales = cache_scales(search, margin_scale, &mut feeds.random);
            feeds.feed("setup", [&[ball], &scales[..]].concat());
        } else {
            host.load(feeds);
        }
        host
    }

    fn load(&self, feeds: &mut Feeds) {
        match self.world.config.search.tree_cache {
            0 => self.world.tree.writes.iter().for_each(|write| feeds.feed("tree", write.clone())),
            _ => self.ask(feeds),
        }
    }

    fn ask(&self, feeds: &mut Feeds) {
        self.queries.iter().for_each(|query| feeds.feed("query", query.clone()));
    }

    fn line(&self, feeds: &mut Feeds, line: u64) {
        let Config { process, .. } = &self.world.config;
        let points = u64::from(process.line_points);
        for point in 0..points {
            let cycles = if point == 0 { feeds.random.u32(..self.line_cycles) } else { 0 };
            // A line may end behind the last point.
            let words = self.world.points.get((line * points + point) as usize).cloned();
            let words = words.unwrap_or_else(|| vec![0; process.program.neighbor.len()]);
            feeds.feed_after(cycles, "fill", words.into_iter().map(u64::from).collect());
        }
    }
}

fn send_positions(tree: &Tree, feeds: &mut Feeds, request: &[u64]) {
    let &[thread, address, beats] = request else { panic!("a request has three fields") };
    tree.beats(thread, address, beats).for_each(|beat| feeds.feed("beat", beat));
}

fn send_record(tree: &Tree, feeds: &mut Feeds, request: &[u64]) {
    feeds.feed("record", [request, tree.record(request[1])].concat());
}

impl Rule for Host {
    const SEEDS: u64 = 24;

    fn quiet_cycles(&self) -> u64 {
        BLOCK_CYCLES
    }

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "setup" => self.load(feeds),
            "tree" => {
                self.writes_left -= 1;
                if self.writes_left == 0 {
                    self.ask(feeds);
                }
            }
            "query" => {
                let expected = self.world.expect(fields);
                self.anew += expected.searches - 1;
                self.expected.insert(fields[0], expected.outcome);
            }
            "fetch" => {
                self.positions
                    .request(feeds, fields, |feeds, request| send_positions(&self.world.tree, feeds, request));
            }
            "beat" if fields[2] == 1 => {
                self.positions.answered(feeds, |feeds, request| send_positions(&self.world.tree, feeds, request));
            }
            "lookup" => {
                self.records.request(feeds, fields, |feeds, request| send_record(&self.world.tree, feeds, request))
            }
            "record" => self.records.answered(feeds, |feeds, request| send_record(&self.world.tree, feeds, request)),
            "line" => self.line(feeds, fields[0]),
            "result" => {
                self.left += 1;
                if let Some(expected) = self.expected.remove(&fields[0]).expect("it has not left") {
                    assert_eq!(fields, expected, "query {}", fields[0]);
                    self.compared += 1;
                }
            }
            _ => {}
        }
    }
}

/// The core and its model.
fn build(config: &Config) -> (Core, Top) {
    assert_eq!(config.validate(), Ok(()));
    let core = top::core(config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let latency = |block: &str| core.manifests.get(block).map(|manifest| manifest.latency);
    let length = |block: &str| latency(block).expect("every core has the block");
    let pipeline =
        |block: &str| Pipeline { latency: length(block), interval: core.manifests[block].initiation_interval };
    let neighbor_cache = latency("check").zip(latency("cover")).map(|(check, cover)| CacheLatencies { check, cover });
    let latencies = Latencies {
        search: golden_search::Latencies { path: length("traversal"), distance: length("leaf"), neighbor_cache },
        blocks: golden_process::Latencies { init: latency("init"), finish: length("final") },
        kernel: KernelPipelines { kernel: pipeline("kernel"), sums: pipeline("sums") },
    };
    let model = Top::new(config, latencies);
    (core, model)
}

#[test]
fn queries_leave_as_brute_force_and_the_interpreter_say() {
    for config in cases(cores()) {
        let (core, model) = build(&config);
        let [apart, compared, anew, reused] = [const { Cell::new(0) }; 4];
        let begin = |feeds: &mut Feeds| Host::begin(&config, feeds);
        lockstep(&config, &core.module, &model, &units::top::UNIT, begin, all, |host, report| {
            assert_eq!(host.left, QUERIES);
            // A ball may hold nothing.
            let has_ball = number(&config.search, host.world.asked.radius2).is_finite();
            assert!(has_ball || report.transfers("line") > 0);
            if host.is_apart {
                apart.set(apart.get() + QUERIES);
                compared.set(compared.get() + host.compared);
            }
            anew.set(anew.get() + host.anew);
            if config.search.neighbor_cache > 0 {
                reused.set(reused.get() + report.events("event_cache_hit"));
            }
        });
        assert!(config.search.neighbor_cache == 0 || reused.get() > 0, "no neighborhood was reused");
        let name = config.process.program.name();
        assert!(compared.get() * 10 > 9 * apart.get(), "{name}: {} of {} compared", compared.get(), apart.get());
        assert!(!config.process.has_search() || anew.get() > 0, "{name}: no query was searched for anew");
    }
}
