//! The point processor on AXI: queries leave with what the interpreter says of the neighbors that brute force finds; tree through the
//! window or in memory, with caches and without.

use std::collections::HashMap;

use pointcore_contract::bus::registers::{PointsRegisters, RegisterMap};
use pointcore_contract::bus::units::points_axi::Ports;
use pointcore_contract::bus::units::{window_bits, window_index_bits};
use pointcore_contract::bus::{Config as Widths, Layout};
use pointcore_contract::points::Config;
use pointcore_contract::process::queries::{Outcome, Query};
use pointcore_contract::process::records::{Neighbor, Settings};
use pointcore_contract::{fields, words};
use pointcore_hdl::bus::points;
use pointcore_hdl::compiler::Options;
use pointcore_tb::lockstep::seeds;

use crate::bus::host::{Around, Host, MemoryOrder, RESET};
use crate::bus::searched::{LINES_BASE, MEMORY_BYTES, put_points, put_tree, tree_words};
use crate::points::{Asked, World, anywhere, cores};
use crate::search::{close_coordinate, word};
use crate::support::cases;

/// A host of the point processor.
type PointsHost = Host<Query, Outcome>;

const TOP: Ports = Ports::ALL;
const QUERIES: u64 = 20;

fn host(world: &World, seed: u64) -> PointsHost {
    let config = &world.config;
    let (search, process) = (&config.search, &config.process);
    let top = points::core(config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let has_window = search.tree_cache == 0;
    let reads = [TOP.points, TOP.lines].into_iter().chain((!has_window).then_some(TOP.tree));
    let around = Around {
        map: PointsRegisters::registers(config),
        registers: TOP.registers,
        packets: (TOP.queries, TOP.results),
        reads: reads.map(|port| (port, search.bus.memory_bits)).collect(),
        writes: vec![],
        window: has_window.then(|| (TOP.window, window_bits(window_index_bits(search)))),
        memory: MEMORY_BYTES,
        memory_order: MemoryOrder::Any,
    };
    let mut host = Host::new(top.module, process, search.bus, around, seed);
    put_points(&mut host, search, &world.tree);
    put_tree(&mut host, search, tree_words(search, &world.tree));
    let point = Layout::record::<Neighbor>(process);
    let stride = point.stride(search.bus.memory_bits);
    for (index, words) in world.points.iter().enumerate() {
        let words: Vec<u64> = words.iter().map(|&word| word.into()).collect();
        let place = LINES_BASE as usize + index * stride as usize;
        host.memory[place..place + stride as usize].copy_from_slice(&point.encode(&words, stride));
    }
    host.write_base("lines_base", LINES_BASE);
    if search.neighbor_cache > 0 {
        host.write("cache_far_scale", word(search, 1.0 - 1e-4) as u32);
    }
    host
}

/// Writes what is asked in a run.
fn set(host: &mut PointsHost, world: &World) {
    let Asked { settings, k, radius2, iterations_max, .. } = &world.asked;
    host.write("queries", QUERIES as u32);
    host.write("k", *k);
    host.write("radius2", *radius2 as u32);
    host.write("iterations_max", *iterations_max);
    let search = &world.config.search;
    if search.neighbor_cache > 0 {
        let cache = world.asked.cache(search).map(|word| word as u32);
        ["cache_ball", "reach", "cache_margin_scale"]
            .into_iter()
            .zip(cache)
            .for_each(|(name, word)| host.write(name, word));
    }
    for (field, &value) in fields::<Settings>(&world.config.process).iter().zip(settings) {
        host.write(&format!("setting_{}", field.name), value);
    }
}

/// A run of queries, with packets that are refused between them; how many were, and how many queries were compared.
fn run(host: &mut PointsHost, world: &World, random: &mut fastrand::Rng, commands: u32) -> [u32; 2] {
    set(host, world);
    assert!(host.start(commands));
    host.received.clear();
    let queries = world.queries(QUERIES, random);
    let mut refused = 0;
    for query in &queries {
        let beats = Layout::record::<Query>(&world.config.process).beats(world.config.search.bus.stream_bits);
        if beats > 1 && random.u8(..8) == 0 {
            host.send(query, 1);
            refused += 1;
        }
        host.send(query, 0);
    }
    assert!(!host.start(0), "a run is under way");
    host.finish();
    let mut compared = 0;
    let mut expected: HashMap<_, _> = queries.iter().map(|query| (query[0], world.expect(query))).collect();
    for outcome in &host.received {
        let expected = expected.remove(&outcome.number.into()).expect("each query leaves once");
        if let Some(expected) = expected.outcome {
            assert_eq!(words(&world.config.process, *outcome), expected);
            compared += 1;
        }
    }
    assert!(expected.is_empty(), "each query leaves");
    assert_eq!(host.read("packets_in"), QUERIES as u32);
    assert_eq!(host.read("packets_out"), QUERIES as u32);
    assert!(host.read("event_kernel") >= QUERIES as u32 && host.read("event_line_hit") > 0);
    [refused, compared]
}

/// The cores of the lockstep test on buses of several widths.
fn configs() -> [Config; 3] {
    let [mut bare, mut cached, mut tree] = cores();
    bare.search.bus = Widths { stream_bits: 64, memory_bits: 64 };
    cached.search.bus = Widths { stream_bits: 32, memory_bits: 512 };
    tree.search.bus = Widths { stream_bits: 512, memory_bits: 32 };
    [bare, cached, tree]
}

#[test]
fn what_leaves_on_the_bus_is_what_the_interpreter_says() {
    for config in cases(configs()) {
        for seed in seeds(2).unwrap() {
            let mut random = fastrand::Rng::with_seed(seed);
            let is_apart = seed.is_multiple_of(2);
            let coordinate = if is_apart { anywhere } else { close_coordinate };
            let mut world = World::random(&config, coordinate, &mut random);
            let mut host = host(&world, seed);
            assert_eq!(host.read("id"), 0x5043_0c01);
            let mut refused = 0;
            for (number, commands) in [RESET, RESET, 0].into_iter().enumerate() {
                let [wrong, right] = run(&mut host, &world, &mut random, commands);
                refused += wrong;
                let most = if is_apart { QUERIES * 9 / 10 } else { 1 };
                assert!(u64::from(right) >= most, "{}: {right} compared", config.process.program.name());
                host.expect_errors([0, number as u32 + 1, 0, refused, 0]);
                if commands == RESET {
                    world.ask_anew(&mut random);
                }
            }
            // Neighbors may be another query's then; each query leaves once.
            if config.search.neighbor_cache > 0 {
                world.ask_for_balls(&mut random);
                refused += run(&mut host, &world, &mut random, 0)[0];
                host.expect_errors([0, 4, 0, refused, 0]);
            }
        }
    }
}

/// A number that a register does not take leaves it as it was, and is counted.
#[test]
fn what_no_search_can_be_asked_for_is_refused() {
    let [config, ..] = configs();
    let mut random = fastrand::Rng::with_seed(1);
    let world = World::random(&config, anywhere, &mut random);
    let mut host = host(&world, 1);
    set(&mut host, &world);
    let map = PointsRegisters::registers(&config);
    let mut refused = 0;
    let negative = 0xbf80_0000;
    let wrong = [
        ("k", 0),
        ("k", config.search.neighbors + 1),
        ("radius2", negative),
        ("radius2", 0x7fc0_0000),
        ("iterations_max", 0),
    ];
    for (name, value) in wrong {
        let register = map.iter().find(|register| register.name == name).expect("the map has it");
        let before = host.read(name);
        assert!(!host.write_at(register.address.into(), value), "{name} = {value:x} is taken");
        assert_eq!(host.read(name), before);
        refused += 1;
    }
    host.expect_errors([refused, 0, 0, 0, 0]);
    run(&mut host, &world, &mut random, 0);
}

#[test]
fn an_aborted_run_leaves_nothing_behind() {
    for config in cases(configs()) {
        let mut random = fastrand::Rng::with_seed(3);
        let world = World::random(&config, anywhere, &mut random);
        let mut host = host(&world, 3);
        let mut refused = 0;
        for number in 1..=3 {
            for _ in 0..3 {
                set(&mut host, &world);
                assert!(host.start(0));
                let queries = world.queries(random.u64(..QUERIES), &mut random);
                queries.iter().for_each(|query| host.send(query, 0));
                (0..random.u32(..1500)).for_each(|_| host.step());
                host.abort();
            }
            refused += run(&mut host, &world, &mut random, 0)[0];
            host.expect_errors([0, number, 0, refused, 0]);
        }
    }
}
