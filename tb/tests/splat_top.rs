//! `splat_top` against its model, in every cycle: units, wiring, and frames that depend on their splats alone.

use std::collections::HashMap;
use std::sync::Arc;

use pointcore::splat::activity::{State, Unit};
use pointcore::splat::depth_memory::Depths;
use pointcore::splat::{EncodedFrame, SplatCore, SplatCounters, SplatOutcome, SplatRunner};
use pointcore_contract::Format;
use pointcore_contract::splat::config::{MERGED_DEPTH_BITS, PayloadStore};
use pointcore_contract::splat::records::Fragment;
use pointcore_contract::splat::{Config, Feature};
use pointcore_tb::lockstep::{LockstepError, SEED_VARIABLE, Stall, seed, seeds};
use pointcore_tb::verilated::{Library, VerilogSource};
use rayon::prelude::*;

use crate::splat::{RUNS, configs, fixed_configs, in_order, integer_configs, knobs, moving_configs, scene, stalls};
use crate::support::{self, cases};

/// Splats and ends of several frames.
const RECORDS: usize = 400;

fn run(
    config: &Config,
    frame: &EncodedFrame,
    (core, library): (&SplatCore, &Arc<Library>),
    stall: Stall,
    seed: u64,
) -> Result<SplatOutcome, LockstepError> {
    let runner = SplatRunner { stall, seed, ..SplatRunner::new(config, frame) };
    runner.lockstep(core, library)
}

/// What is seen in the streams between the units must come to what the hardware's events and its memory say.
fn adds_up(SplatOutcome { activity, counters, simulated_cycles, .. }: &SplatOutcome) {
    let (events, timeline) = (counters.events, activity.timeline());
    let samples = activity.samples().expect("the model's units were seen");
    assert_eq!(samples.evaluated().sum(), events.sample);
    assert_eq!(samples.inside().sum(), events.accumulate);
    assert_eq!(samples.hazards().sum(), events.hazard);
    assert_eq!(timeline.cycles(), *simulated_cycles);
    assert_eq!(timeline.total(Unit::Rasterizer, State::Held), events.blocked);
    assert_eq!(timeline.total(Unit::Accumulator, State::Tile), events.slot_wait);
}

/// Hardware alone shows at its ports what the model shows there.
fn is_seen_at_ports(alone: &SplatOutcome, lockstep: &SplatOutcome) {
    let (alone, lockstep) = (&alone.activity, &lockstep.activity);
    assert!(alone.samples().is_none() && alone.written_back() == lockstep.written_back());
    for (unit, state) in Unit::AT_PORTS.into_iter().flat_map(|unit| State::ALL.map(|state| (unit, state))) {
        let [alone, lockstep] = [alone, lockstep].map(|seen| seen.timeline().row(unit, state).collect::<Vec<_>>());
        assert_eq!(alone, lockstep, "{unit:?} {state:?}");
    }
}

#[test]
fn it_agrees_with_the_model_and_frames_depend_on_their_splats_alone() {
    let ([coarse, _], [fixed, ..], [.., integers]) = (knobs(), fixed_configs(), integer_configs());
    let [bare, _, mixed] = configs();
    let several = [
        Config { rasterizers: 2, ..bare.clone() },
        Config { rasterizers: 2, memory_ports: 2, payload: PayloadStore::Memory, payload_beats: 2, ..bare },
        Config { rasterizers: 4, memory_ports: 2, ..mixed },
    ];
    let [first, second, third, fourth] = moving_configs();
    let moving = [
        Config { merge: Feature::On, ..first },
        second,
        Config { rasterizers: 2, merge: Feature::On, ..third },
        fourth,
    ];
    let all = configs().into_iter().chain([coarse, fixed, integers]).chain(several).chain(moving);
    cases(all).par_bridge().for_each(|config| {
        let core = SplatCore::generate(&config).unwrap_or_else(|error| panic!("{error}"));
        let library = support::build(&VerilogSource::from(&core.design));
        let mut frame = scene::frames(&config, RECORDS);
        frame.depths = config.tests_samples().then(|| Depths::new(&config, spread));
        let mut expected: Option<Vec<Fragment>> = None;
        for seed in seeds(RUNS).unwrap() {
            let outcome = run(&config, &frame, (&core, &library), stalls(seed), seed);
            let mut outcome =
                outcome.unwrap_or_else(|error| panic!("{error}\nor {SEED_VARIABLE}={seed} with this test"));
            adds_up(&outcome);
            let counters = &outcome.counters;
            assert!(counters.buffer.written > 1000 && counters.buffer.read > 1000, "seed {seed}: {counters:?}");
            assert!(counters.events.hidden > 100 || !config.tests_samples(), "seed {seed}: {counters:?}");
            in_order(&config, &mut outcome.fragments);
            let expected = expected.get_or_insert(outcome.fragments.clone());
            assert!(outcome.fragments == *expected, "seed {seed}: the frames depend on stalls");
        }
        // The same again, right behind.
        let expected = expected.expect("there is a run");
        assert!(expected.len() > 1000, "{} fragments", expected.len());
        frame.records.extend_from_within(..);
        let seed = seed().unwrap();
        let twice = run(&config, &frame, (&core, &library), Stall::Random(0.2), seed);
        let mut twice = twice.unwrap_or_else(|error| panic!("{error}"));
        let again = twice.fragments.split_off(expected.len());
        for mut fragments in [twice.fragments.clone(), again] {
            in_order(&config, &mut fragments);
            assert!(fragments == expected, "a frame leaves something behind");
        }
        let stall = Stall::Random(0.2);
        let runner = SplatRunner { stall, seed, ..SplatRunner::new(&config, &frame) };
        is_seen_at_ports(&runner.hardware(&library, None).unwrap_or_else(|error| panic!("{error}")), &twice);
    });
}

/// A depth for each sample, and none for every fourth.
fn spread(column: u32, row: u32) -> Option<f32> {
    (!(column + row).is_multiple_of(4)).then_some([0.3, 0.6, 0.7, 0.8, 0.9][((column / 3 + row / 2) % 5) as usize])
}

/// What moves is as without depths in memory where these are far, and hidden where they are near.
#[test]
fn samples_that_move_are_hidden_behind_what_is_in_memory() {
    for config in moving_configs() {
        let fragments = |merge: Feature, held: fn(u32, u32) -> Option<f32>| {
            let config = Config { merge, ..config.clone() };
            let core = SplatCore::generate(&config).unwrap_or_else(|error| panic!("{error}"));
            let mut frame = scene::frames(&config, RECORDS / 4);
            frame.depths = Some(Depths::new(&config, held));
            let outcome = SplatRunner::new(&config, &frame).golden(&core).unwrap_or_else(|error| panic!("{error}"));
            let (mut fragments, hidden) = (outcome.fragments, outcome.counters.events.hidden);
            in_order(&config, &mut fragments);
            (fragments, hidden)
        };
        let (alone, _) = fragments(Feature::Off, |_, _| None);
        assert!(alone.len() > 100 && (alone.clone(), 0) == fragments(Feature::On, |_, _| None));
        let (left, hidden) = fragments(Feature::On, |column, _| (column >= 24).then_some(0.0));
        // A band that begins at zero is behind nothing.
        assert!(hidden > 100 && left.len() < alone.len(), "{hidden} samples, {} fragments", left.len());
        let is_free = |fragment: &&Fragment| fragment.column < 24;
        assert!(left.iter().filter(is_free).eq(alone.iter().filter(is_free)));
    }
}

/// What memory holds decides which fragments leave, and nothing else does.
#[test]
fn fragments_leave_that_are_nearer_than_what_is_in_memory() {
    let [bare, _, mixed] = configs();
    for config in cases([bare, Config { rasterizers: 2, memory_ports: 2, geometry: Format::F24, ..mixed }]) {
        let [alone, config] = [Feature::Off, Feature::On].map(|merge| Config { merge, ..config.clone() });
        let core = SplatCore::generate(&config).unwrap_or_else(|error| panic!("{error}"));
        let library = support::build(&VerilogSource::from(&core.design));
        let low_bits = MERGED_DEPTH_BITS - config.geometry.width();
        // One frame: those that follow are tested against the depths of those before.
        let mut frame = scene::frames(&config, RECORDS);
        let end = frame.records.iter().position(|record| record.end).expect("there is a frame");
        frame.records.truncate(end + 1);
        let core_alone = SplatCore::generate(&alone).unwrap_or_else(|error| panic!("{error}"));
        let all =
            SplatRunner::new(&alone, &frame).golden(&core_alone).unwrap_or_else(|error| panic!("{error}")).fragments;
        // Nothing, something before, something behind, and the very same.
        let drawn: HashMap<_, _> = all.iter().map(|found| ((found.column, found.row), found.depth)).collect();
        let held = |column: u32, row: u32| match (column + row) % 4 {
            0 => None,
            kind => drawn.get(&(column as u16, row as u16)).map(|depth| f32::from_bits((depth + kind - 2) << low_bits)),
        };
        frame.depths = Some(Depths::new(&config, held));
        let is_nearer = |found: &&Fragment| matches!((found.column + found.row) % 4, 0 | 3);
        let mut expected: Vec<_> = all.iter().filter(is_nearer).copied().collect();
        in_order(&config, &mut expected);
        assert!(expected.len() > 100 && all.len() - expected.len() > 100);
        for seed in seeds(RUNS).unwrap() {
            let outcome = run(&config, &frame, (&core, &library), stalls(seed), seed);
            let mut outcome = outcome.unwrap_or_else(|error| panic!("{error}"));
            in_order(&config, &mut outcome.fragments);
            assert!(outcome.fragments == expected, "seed {seed}: {} fragments", outcome.fragments.len());
            let hidden = (all.len() - expected.len()) as u64;
            let SplatCounters { events, depths, .. } = outcome.counters;
            assert_eq!([events.hidden, depths.read, depths.written], [hidden, all.len() as u64, expected.len() as u64]);
        }
    }
}
