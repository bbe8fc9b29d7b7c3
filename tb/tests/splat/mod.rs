//! What the tests of the renderer's units share: configurations, stimuli, and the comparison of a unit with its model.

pub mod collected;
pub mod edges;
pub mod exchange;
pub mod hard;
pub mod integers;
pub mod scene;

use std::sync::Arc;

use pointcore::splat::mask::end_records;
use pointcore_contract::splat::config::Reordering;
use pointcore_contract::splat::records::Fragment;
use pointcore_contract::splat::{AttributeFormat, Coefficient, Config, Division, Feature, Fraction, RasterFormat};
use pointcore_contract::{Direction, Format, FragmentDepth, Interface, Record, Sampling, Words, fields, read, words};
use pointcore_golden::unit::{Model, Ported, Unit};
use pointcore_tb::lockstep::{Golden, Lockstep, Run, Stall, StreamPorts, StreamTestbench, seeds};
use pointcore_tb::verilated::Library;
use rtl::Module;

use crate::support;

/// Runs of a unit, each with its own seed and pattern of stalls.
pub const RUNS: u64 = 6;

/// When source and sink pause, in the runs of a unit.
const PATTERNS: [(Stall, Stall); RUNS as usize] = [
    (Stall::Never, Stall::Never),
    (Stall::Random(0.5), Stall::Random(0.5)),
    (Stall::Bursts(40), Stall::Random(0.2)),
    (Stall::Random(0.2), Stall::Bursts(40)),
    (Stall::Never, Stall::Random(0.7)),
    (Stall::Varied, Stall::Varied),
];

/// When everything around a unit pauses, in the run with this seed.
pub fn stalls(seed: u64) -> Stall {
    PATTERNS[(seed % RUNS) as usize].0
}

/// Puts fragments in an order that does not hang on stalls: tiles come in any.
pub fn in_order(config: &Config, fragments: &mut [Fragment]) {
    fragments.sort_unstable_by_key(|fragment| words(config, *fragment));
}

/// The record that a stream of a unit moves in this cycle.
pub fn moved<R: Record<Domain = Words, Config = Config>>(
    config: &Config,
    stream: &StreamPorts,
    inputs: &[u64],
    outputs: &[u64],
) -> Option<R> {
    let fields: Vec<_> = stream.fields.iter().map(|&field| outputs[field]).collect();
    stream.transfers(inputs, outputs).then(|| read(config, &fields))
}

/// Shows a record at an input, or none.
pub fn offer(stream: &StreamPorts, inputs: &mut [u64], record: Option<Vec<u64>>) {
    inputs[stream.valid] = u64::from(record.is_some());
    stream.fields.iter().zip(record.into_iter().flatten()).for_each(|(&field, value)| inputs[field] = value);
}

/// Silence that ends a run: longer than any pipeline.
const QUIET_CYCLES: u64 = 600;

/// The configurations of a unit's test: everything left out, everything in, and some of each. No image edge is a multiple of a
/// tile's in the first and the last.
pub fn configs() -> [Config; 3] {
    let bare = Config {
        width: 52,
        height: 37,
        continuous: 1,
        heap_levels: 2,
        splat_levels: 1,
        payload_beats: 1,
        tile_slots: 2,
        culling: Feature::Off,
        screen_filter: Feature::Off,
        eye_plane: Feature::Off,
        transform_interval: 1,
        setup_interval: 4,
        accumulate_stages: 5,
        ..Config::default()
    };
    let full = Config {
        width: 64,
        height: 48,
        geometry: Format::F24.flushed(),
        continuous: 13,
        cardinal: 1,
        heap_levels: 4,
        heap_interval: 4,
        splat_levels: 3,
        payload_beats: 3,
        tile_slots: 5,
        transform_interval: 2,
        setup_interval: 1,
        accumulate_stages: 7,
        ..Config::default()
    };
    let mixed = Config {
        width: 62,
        height: 45,
        depth: FragmentDepth::Plane,
        sampling: Sampling::Flipquad,
        continuous: 3,
        cardinal: 2,
        heap_levels: 3,
        reorder: Reordering::Lists,
        tiles_in_turn: 2,
        splat_levels: 2,
        payload_beats: 8,
        tile_slots: 3,
        culling: Feature::On,
        screen_filter: Feature::Off,
        transform_interval: 4,
        setup_interval: 2,
        accumulate_stages: 6,
        kernel_gamma: 0.9,
        ..Config::default()
    };
    [bare, full, mixed]
}

/// Those with attributes in fixed point, for the units that compute with them.
pub fn fixed_configs() -> [Config; 3] {
    let [bare, full, mixed] = configs();
    let fixed = |config, fraction| Config { attribute: AttributeFormat::Fixed(fraction), ..config };
    [fixed(mixed, Fraction::Twelve), fixed(bare, Fraction::Eight), fixed(full, Fraction::Sixteen)]
}

/// Those with a rasterizer in fixed point: in every width, with and without filter and eye plane, and with samples between pixels.
pub fn integer_configs() -> [Config; 3] {
    let [bare, full, mixed] = configs();
    let fixed = |config, coefficient| Config { rasterizer: Some(RasterFormat::Fixed(coefficient)), ..config };
    let mixed = Config { depth: FragmentDepth::Center, screen_filter: Feature::On, ..mixed };
    let coarse = Config { kernel_index_bits: 5, kernel_fraction_bits: 0, division: Division::Newton, ..full };
    [fixed(bare, Coefficient::Eighteen), fixed(coarse, Coefficient::Sixteen), fixed(mixed, Coefficient::Eighteen)]
}

/// Those in which splats may move: one bin of the exposure and several, in every format, in tiles with one column of pixels and more.
pub fn moving_configs() -> [Config; 4] {
    let [bare, full, mixed] = configs();
    let moving = |config: Config, time_bins: u32| {
        let sample_interval = config.setup_interval.min(3);
        let setup_interval = 4 * config.setup_interval;
        Config {
            time_bins,
            sample_interval,
            setup_interval,
            culling: Feature::On,
            screen_filter: Feature::Off,
            ..config
        }
    };
    let fixed = Config { attribute: AttributeFormat::Fixed(Fraction::Twelve), ..full.clone() };
    let newton = Config { geometry: Format::F24.flushed(), division: Division::Newton, ..mixed };
    [moving(bare, 8), moving(full, 2), moving(newton, 4), moving(Config { continuous: 3, ..fixed }, 1)]
}

/// Two more, with everything otherwise that trades accuracy for hardware: as coarse as can be, and in between.
pub fn knobs() -> [Config; 2] {
    let [bare, full, _] = configs();
    let coarse = Config {
        depth: FragmentDepth::Plane,
        screen_filter: Feature::On,
        kernel_index_bits: 5,
        kernel_fraction_bits: 0,
        division: Division::Newton,
        geometry: Format::F32,
        rasterizer: Some(Format::F24.flushed().into()),
        ..bare
    };
    let between = Config {
        continuous: 2,
        kernel_index_bits: 6,
        kernel_fraction_bits: 10,
        kernel_gamma: 3.0,
        rasterizer: Some(Format::BF16.flushed().into()),
        division: Division::Newton,
        setup_interval: 3,
        ..full
    };
    [coarse, between]
}

/// A unit of the renderer, verilated, with its interface as specified.
pub struct Device {
    config: Config,
    library: Arc<Library>,
    interface: Interface,
}

impl Device {
    /// Verilates `module`. Its streams must be those of the specified unit, their fields in the records' order.
    pub fn new(config: &Config, module: &Module, unit: &pointcore_contract::Unit<Config>) -> Self {
        let library = support::verilate(module);
        let interface = (unit.interface)(config);
        support::check_streams(&library, &interface);
        assert_eq!(library.inputs().len() + library.outputs().len(), interface.ports().len(), "{}", unit.module);
        Self { config: config.clone(), library, interface }
    }

    /// The hardware.
    pub fn library(&self) -> &Arc<Library> {
        &self.library
    }

    /// Names of the hardware's outputs in its order.
    pub fn outputs(&self) -> Vec<String> {
        self.library.outputs().iter().map(|port| port.name.clone()).collect()
    }

    /// Where the hardware has the specified inputs.
    pub fn input_places(&self) -> Vec<usize> {
        support::places(&self.library, &self.interface.ports(), Direction::Input)
    }

    /// The model with its words in the order of the hardware's ports.
    pub fn golden<U: Unit>(&self, model: U) -> impl FnMut(&[u64], &mut [u64]) + use<U> {
        support::by_name(&self.library, &self.interface.ports(), model)
    }

    /// The unit beside its model.
    pub fn lockstep(&self, model: impl Unit, seed: u64) -> Lockstep<impl Golden> {
        let mask = end_records(&self.interface, &self.outputs());
        Lockstep::new(&self.library, self.golden(model), seed).mask(mask)
    }

    /// Sends `items` through `in` in lockstep with `model`, once for each seed; returns what left through `out` in each run, end
    /// records without what else they carry.
    pub fn runs<M: Model<Config = Config>, I: Travels, O: Travels>(
        &self,
        model: &M,
        items: &[I],
        constants: &[(String, u64)],
    ) -> Vec<Vec<O>> {
        let sent: Vec<_> = items.iter().map(|item| words(&self.config, *item)).collect();
        let run = |seed: u64| {
            let (source, sink) = PATTERNS[(seed % RUNS) as usize];
            let testbench = StreamTestbench::new(&self.library, seed).quiet_cycles(QUIET_CYCLES);
            let testbench = testbench.source("in", sent.clone(), source)?.sink("out", sink)?;
            let present = |name: &str| self.library.inputs().iter().any(|port| port.name == name);
            let mut constants = constants.iter().filter(|(name, _)| present(name));
            let testbench = constants.try_fold(testbench, |testbench, (name, word)| testbench.constant(name, *word))?;
            self.lockstep(Ported::new(&self.config, model.clone()), seed).run(testbench)
        };
        let has_end = fields::<O>(&self.config).first().is_some_and(|field| field.name == "end");
        let outcome = |seed| {
            let run: Run<StreamTestbench> = run(seed).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(run.report.transfers("in"), items.len() as u64, "seed {seed}");
            let mut collected = run.stimulus.collected("out").to_vec();
            collected.iter_mut().filter(|item| has_end && item[0] == 1).for_each(|item| item[1..].fill(0));
            collected.iter().map(|item| read(&self.config, item)).collect()
        };
        seeds(RUNS).expect("POINTCORE_SEED is a number").into_iter().map(outcome).collect()
    }

    /// As [`Device::runs`] for a unit whose results do not depend on when they leave: all runs must have the same.
    pub fn run<M: Model<Config = Config>, I: Travels, O: Travels>(
        &self,
        model: &M,
        items: &[I],
        constants: &[(String, u64)],
    ) -> Vec<O> {
        let mut runs = self.runs(model, items, constants);
        assert!(runs.iter().all(|run| *run == runs[0]), "the results depend on stalls");
        runs.swap_remove(0)
    }
}

/// A record of the renderer as models have it.
pub trait Travels: Record<Domain = Words, Config = Config> + PartialEq {}

impl<R: Record<Domain = Words, Config = Config> + PartialEq> Travels for R {}

/// What a model makes of `items` when nothing stalls: `see` says what it sees while an item is offered, `show` whether it takes it and what
/// it puts out.
pub fn through<M: Model, I: Copy, O>(
    mut model: M,
    items: &[I],
    see: impl Fn(Option<I>) -> M::In,
    show: impl Fn(M::Out) -> (bool, Option<O>),
) -> Vec<O> {
    let (mut sent, mut quiet, mut results) = (0, 0, Vec::new());
    while quiet < QUIET_CYCLES {
        let item = items.get(sent).copied();
        let (ready, result) = show(model.outputs());
        model.clock(&see(item));
        let taken = item.is_some() && ready;
        sent += usize::from(taken);
        quiet = if taken || result.is_some() { 0 } else { quiet + 1 };
        results.extend(result);
    }
    assert_eq!(sent, items.len(), "the model takes everything");
    results
}
