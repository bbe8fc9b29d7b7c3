//! The search core on AXI finds what a search through all points does: tree through the window or in memory, with caches and without.

use pointcore_contract::bus::Config as Widths;
use pointcore_contract::bus::registers::{RegisterMap, SearchRegisters};
use pointcore_contract::bus::units::search_axi::Ports;
use pointcore_contract::bus::units::{window_bits, window_index_bits};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{CachedQuery, CachedResult};
use pointcore_hdl::bus::search;
use pointcore_hdl::compiler::Options;
use pointcore_tb::lockstep::seeds;

use crate::bus::host::{Around, Host, MemoryOrder, RESET};
use crate::bus::searched::{MEMORY_BYTES, put_points, put_tree, tree_words};
use crate::search::tree::Tree;
use crate::search::{query, word};
use crate::support::cases;

/// A host of the search core.
type SearchHost = Host<CachedQuery, CachedResult>;

const TOP: Ports = Ports::ALL;
const QUERIES: u32 = 40;

fn host(config: &Config, tree: &Tree, seed: u64) -> SearchHost {
    let top = search::core(config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let has_window = config.tree_cache == 0;
    let reads = std::iter::once(TOP.points).chain((!has_window).then_some(TOP.tree));
    let around = Around {
        map: SearchRegisters::registers(config),
        registers: TOP.registers,
        packets: (TOP.queries, TOP.results),
        reads: reads.map(|port| (port, config.bus.memory_bits)).collect(),
        writes: vec![],
        window: has_window.then(|| (TOP.window, window_bits(window_index_bits(config)))),
        memory: MEMORY_BYTES,
        memory_order: MemoryOrder::Any,
    };
    let mut host = Host::new(top.module, config, config.bus, around, seed);
    put_points(&mut host, config, tree);
    put_tree(&mut host, config, tree_words(config, tree));
    if config.neighbor_cache > 0 {
        host.write("cache_far_scale", word(config, 1.0) as u32);
        host.write("cache_margin_scale", word(config, 0.5) as u32);
    }
    host
}

/// A query as it is sent.
fn asked(config: &Config, number: u32, random: &mut fastrand::Rng) -> Vec<u64> {
    let mut asked = query(config, number.into(), random);
    if config.neighbor_cache > 0 {
        // Nearest neighbors: one more than wanted, of any distance.
        (asked[1], asked[2]) = (config.neighbors.into(), word(config, f32::INFINITY));
        asked.push(word(config, 0.0));
    }
    asked
}

/// A run of queries, with packets that are refused between them.
fn run(host: &mut SearchHost, config: &Config, tree: &Tree, random: &mut fastrand::Rng, commands: u32) -> u32 {
    host.write("queries", QUERIES);
    assert!(host.start(commands));
    answered(host, config, tree, random)
}

/// The queries of a run that has begun.
fn answered(host: &mut SearchHost, config: &Config, tree: &Tree, random: &mut fastrand::Rng) -> u32 {
    host.received.clear();
    let mut queries = vec![];
    let mut refused = 0;
    for number in 0..QUERIES {
        let asked = asked(config, number, random);
        let (senseless, short) = (random.u8(..8) == 0, random.u8(..8) == 0 && config.bus.stream_bits < 128);
        if senseless {
            host.send(&[&asked[..1], &[0], &asked[2..]].concat(), 0);
        }
        if short {
            host.send(&asked, 1);
        }
        refused += u32::from(senseless) + u32::from(short);
        host.send(&asked, 0);
        queries.push(asked);
    }
    assert!(!host.start(0), "a run is under way");
    host.finish();
    for CachedResult { result, cached } in host.received.iter().filter(|result| result.result.found) {
        let distance2 = tree.distance2(result.index.into(), tree.point(&queries[result.number as usize]));
        assert!(*cached || word(config, distance2) == u64::from(result.distance2), "{result:?}");
    }
    let found = results(host, queries.len());
    for (asked, found) in queries.iter().zip(found) {
        let mut expected = tree.nearest(asked);
        if config.neighbor_cache > 0 {
            expected.truncate(found.len());
        }
        let expected: Vec<u64> = expected.into_iter().map(|distance2| word(config, distance2)).collect();
        assert_eq!(found, expected, "{asked:?}");
    }
    assert_eq!(host.read("packets_in"), QUERIES);
    assert_eq!(host.read("packets_out"), host.received.len() as u32);
    assert!(host.read("cycles") > QUERIES && host.read("event_node") > QUERIES);
    refused
}

/// Squared distances by query; of a cached answer, those to the query whose neighborhood it is are left out.
fn results(host: &SearchHost, count: usize) -> Vec<Vec<u64>> {
    let mut found = vec![vec![]; count];
    for result in &host.received {
        let CachedResult { result, cached } = result;
        if result.found && !cached {
            found[result.number as usize].push(result.distance2.into());
        }
    }
    let lasts = host.received.iter().filter(|result| result.result.last).count();
    assert_eq!(lasts, count, "each query is closed once");
    found
}

/// A run that ends before its time, somewhere on its way.
fn aborted_run(host: &mut SearchHost, config: &Config, random: &mut fastrand::Rng) {
    host.write("queries", QUERIES);
    assert!(host.start(0));
    for number in 0..random.u32(..QUERIES) {
        host.send(&asked(config, number, random), 0);
    }
    (0..random.u32(..1000)).for_each(|_| host.step());
    host.abort();
}

/// Steps a run until nothing is missing but that its last packets are taken, and so many cycles on in which they may be.
fn run_to_its_end(host: &mut SearchHost, config: &Config, random: &mut fastrand::Rng, cycles: u64) {
    const LONG: u64 = 500;
    host.received.clear();
    (0..QUERIES).for_each(|number| host.send(&asked(config, number, random), 0));
    while host.received.iter().filter(|result| result.result.last).count() + 1 < QUERIES as usize {
        host.step();
    }
    host.is_held = true;
    (0..LONG).for_each(|_| host.step());
    host.is_held = false;
    (0..cycles).for_each(|_| host.step());
}

fn configs() -> [Config; 4] {
    let base = Config {
        index_bits: 10,
        tree_depth: 4,
        bucket: 8,
        threads: 3,
        neighbors: 6,
        point_cache: 0,
        ..Config::default()
    };
    let bus = |stream_bits, memory_bits| Widths { stream_bits, memory_bits };
    [
        Config { bus: bus(64, 64), lanes: 1, ..base.clone() },
        Config { bus: bus(32, 128), lanes: 4, point_cache: 4, leaves_in_flight: 2, ..base.clone() },
        Config { bus: bus(512, 32), lanes: 2, tree_cache: 16, ..base.clone() },
        Config { bus: bus(64, 512), lanes: 8, tree_cache: 16, neighbor_cache: 2, ..base },
    ]
}

#[test]
fn an_aborted_run_leaves_nothing_behind() {
    for config in cases(configs()) {
        for seed in seeds(2).unwrap() {
            let mut random = fastrand::Rng::with_seed(seed);
            let tree = Tree::random(&config, &mut random);
            let mut host = host(&config, &tree, seed);
            let mut refused = 0;
            for number in 1..=4 {
                (0..3).for_each(|_| aborted_run(&mut host, &config, &mut random));
                refused += run(&mut host, &config, &tree, &mut random, 0);
                host.expect_errors([0, number, 0, refused, 0]);
            }
        }
    }
}

/// A run ends by itself about the moment in which it is aborted: what begins next, as soon as it may, is whole.
#[test]
fn an_abort_may_come_with_the_end_of_a_run() {
    for config in cases(configs()) {
        let mut random = fastrand::Rng::with_seed(1);
        let tree = Tree::random(&config, &mut random);
        let mut host = host(&config, &tree, 1);
        let (mut refused, mut busy) = (0, 0);
        host.write("queries", QUERIES);
        for cycles in (0..20).chain(0..20) {
            assert!(host.start(0));
            run_to_its_end(&mut host, &config, &mut random, cycles);
            let mut is_started = host.abort_and_start();
            host.forget();
            while !is_started {
                busy += 1;
                is_started = host.start(0);
            }
            refused += answered(&mut host, &config, &tree, &mut random);
            // It asked for a start within the run.
            busy += 1;
        }
        host.expect_errors([0, busy, 0, refused, 0]);
    }
}

/// Every leaf lacks its beats: each is read as one of one beat, and counted.
#[test]
fn leaves_without_beats_end_a_run_and_are_counted() {
    for config in cases(configs()) {
        let mut random = fastrand::Rng::with_seed(1);
        let tree = Tree::random(&config, &mut random);
        let mut host = host(&config, &tree, 1);
        let empty = (0..1 << config.tree_depth).map(|leaf| (leaf + (1 << config.tree_depth), 0));
        put_tree(&mut host, &config, empty);
        host.write("queries", QUERIES);
        assert!(host.start(0));
        for number in 0..QUERIES {
            host.send(&asked(&config, number, &mut random), 0);
        }
        host.finish();
        let counted = host.read("burst_errors");
        assert!(
            counted > 0 && (counted >= QUERIES || config.point_cache > 0 || config.neighbor_cache > 0),
            "{counted}"
        );
        put_tree(&mut host, &config, tree_words(&config, &tree));
        let refused = run(&mut host, &config, &tree, &mut random, RESET);
        host.expect_errors([0, 1, counted, refused, 0]);
    }
}

#[test]
fn neighbors_on_the_bus_equal_brute_force() {
    for config in cases(configs()) {
        for seed in seeds(2).unwrap() {
            let mut random = fastrand::Rng::with_seed(seed);
            let tree = Tree::random(&config, &mut random);
            let mut host = host(&config, &tree, seed);
            assert_eq!(host.read("id"), 0x5043_0b01);
            let mut refused = 0;
            for (number, commands) in [0, 0, RESET].into_iter().enumerate() {
                refused += run(&mut host, &config, &tree, &mut random, commands);
                host.expect_errors([0, number as u32 + 1, 0, refused, 0]);
            }
        }
    }
}
