//! What the tests of the renderer's units share: configurations, stimuli, and the comparison of a unit with its model.

pub mod exchange;
pub mod scene;

use std::sync::Arc;

use pointcore::splat::mask::end_records;
use pointcore_contract::splat::{
    AttributeFormat, Coefficient, Config, Direction, Division, Feature, Fraction, Port, RasterFormat,
};
use pointcore_contract::{Format, FragmentDepth, Sampling};
use pointcore_golden::unit::{Model, Ported, Unit};
use pointcore_tb::lockstep::{Golden, Lockstep, Run, Stall, StreamTestbench, Streams, seeds};
use pointcore_tb::verilated::Library;
use rtl::Module;

use crate::support;

/// Runs of a unit, each with its own seed and pattern of stalls.
pub const RUNS: u64 = 5;

/// When source and sink pause, in the runs of a unit.
const PATTERNS: [(Stall, Stall); RUNS as usize] = [
    (Stall::Never, Stall::Never),
    (Stall::Random(0.5), Stall::Random(0.5)),
    (Stall::Bursts(40), Stall::Random(0.2)),
    (Stall::Random(0.2), Stall::Bursts(40)),
    (Stall::Never, Stall::Random(0.7)),
];

/// When everything around a unit pauses, in the run with this seed.
pub fn stalls(seed: u64) -> Stall {
    PATTERNS[(seed % RUNS) as usize].0
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

/// A unit of the renderer, verilated, with its ports as specified.
pub struct Device {
    config: Config,
    library: Arc<Library>,
    specified: Vec<Port>,
}

impl Device {
    /// Verilates `module`. The fields of its streams must come in the records' order.
    pub fn new(config: &Config, module: &Module, specified: Vec<Port>) -> Self {
        let library = support::verilate(module);
        let found = support::ports(&library);
        assert_eq!(found.len(), specified.len());
        for stream in &Streams::of(&library) {
            let prefix = format!("{}_", stream.name);
            let side = |ports: &[Port]| -> Vec<String> {
                let names = ports.iter().map(|port| port.name.clone()).filter(|name| name.starts_with(&prefix));
                names.collect()
            };
            let [ours, theirs] = [side(&found), side(&specified)].map(|mut names| {
                names.retain(|name| !name.ends_with("_valid") && !name.ends_with("_ready"));
                names
            });
            assert_eq!(ours, theirs, "fields of stream {}", stream.name);
        }
        Self { config: config.clone(), library, specified }
    }

    /// The hardware.
    pub fn library(&self) -> &Arc<Library> {
        &self.library
    }

    /// Where the hardware has the specified inputs.
    pub fn input_places(&self) -> Vec<usize> {
        support::places(&self.library, &self.specified, Direction::Input)
    }

    /// The model with its words in the order of the hardware's ports.
    pub fn golden(&self, model: impl Unit) -> impl FnMut(&[u64], &mut [u64]) {
        support::by_name(&self.library, &self.specified, model)
    }

    /// The unit beside its model.
    pub fn lockstep(&self, model: impl Unit, seed: u64) -> Lockstep<impl Golden> {
        let mask = end_records(&support::ports(&self.library));
        Lockstep::new(&self.library, self.golden(model), seed).mask(mask)
    }

    /// Sends `items` through `in` in lockstep with `model`, once for each seed; returns what left through `out` in each run, end
    /// records as a lone 1.
    pub fn runs<M: Model<Config = Config>>(
        &self,
        model: &M,
        items: &[Vec<u64>],
        constants: &[(String, u64)],
    ) -> Vec<Vec<Vec<u64>>> {
        let has_end = self.library.outputs().iter().any(|port| port.name == "out_end");
        let run = |seed: u64| {
            let (source, sink) = PATTERNS[(seed % RUNS) as usize];
            let testbench = StreamTestbench::new(&self.library, seed).quiet_cycles(QUIET_CYCLES);
            let testbench = testbench.source("in", items.to_vec(), source)?.sink("out", sink)?;
            let present = |name: &str| self.library.inputs().iter().any(|port| port.name == name);
            let mut constants = constants.iter().filter(|(name, _)| present(name));
            let testbench = constants.try_fold(testbench, |testbench, (name, word)| testbench.constant(name, *word))?;
            self.lockstep(Ported::new(&self.config, model.clone()), seed).run(testbench)
        };
        let outcome = |seed| {
            let run: Run<StreamTestbench> = run(seed).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(run.report.transfers("in"), items.len() as u64, "seed {seed}");
            let mut collected = run.stimulus.collected("out").to_vec();
            collected.iter_mut().filter(|item| has_end && item[0] == 1).for_each(|item| item.truncate(1));
            collected
        };
        seeds(RUNS).expect("POINTCORE_SEED is a number").into_iter().map(outcome).collect()
    }

    /// As [`Device::runs`] for a unit whose results do not depend on when they leave: all runs must have the same.
    pub fn run<M: Model<Config = Config>>(
        &self,
        model: &M,
        items: &[Vec<u64>],
        constants: &[(String, u64)],
    ) -> Vec<Vec<u64>> {
        let mut runs = self.runs(model, items, constants);
        assert!(runs.iter().all(|run| *run == runs[0]), "the results depend on stalls");
        runs.swap_remove(0)
    }
}

/// What a model with the specified ports makes of `items` when nothing stalls.
pub fn through<M: Model<Config = Config>>(
    config: &Config,
    model: M,
    specified: &[Port],
    items: &[Vec<u64>],
    constants: &[(String, u64)],
) -> Vec<Vec<u64>> {
    let side = |direction| -> Vec<&str> {
        specified.iter().filter(|port| port.direction == direction).map(|port| port.name.as_str()).collect()
    };
    let (input_names, output_names) = (side(Direction::Input), side(Direction::Output));
    let place = |names: &[&str], name: &str| names.iter().position(|other| *other == name);
    let fields = |names: &[&str], prefix: &str| -> Vec<usize> {
        let is_field = |name: &str| name.starts_with(prefix) && !name.ends_with("_valid") && !name.ends_with("_ready");
        (0..names.len()).filter(|&index| is_field(names[index])).collect()
    };
    let (in_fields, out_fields) = (fields(&input_names, "in_"), fields(&output_names, "out_"));
    let [in_valid, out_ready] = ["in_valid", "out_ready"].map(|name| place(&input_names, name).expect("a stream unit"));
    let [in_ready, out_valid] =
        ["in_ready", "out_valid"].map(|name| place(&output_names, name).expect("a stream unit"));

    let mut unit = Ported::new(config, model);
    let (mut inputs, mut outputs) = (vec![0; input_names.len()], vec![0; output_names.len()]);
    for (name, word) in constants {
        if let Some(place) = place(&input_names, name) {
            inputs[place] = *word;
        }
    }
    inputs[out_ready] = 1;
    let (mut sent, mut quiet, mut results) = (0, 0, Vec::new());
    while quiet < QUIET_CYCLES {
        inputs[in_valid] = u64::from(sent < items.len());
        if let Some(item) = items.get(sent) {
            in_fields.iter().zip(item).for_each(|(&field, &word)| inputs[field] = word);
        }
        unit.step(&inputs, &mut outputs);
        let taken = inputs[in_valid] & outputs[in_ready] == 1;
        sent += usize::from(taken);
        if outputs[out_valid] == 1 {
            results.push(out_fields.iter().map(|&field| outputs[field]).collect());
        }
        quiet = if taken || outputs[out_valid] == 1 { 0 } else { quiet + 1 };
    }
    assert_eq!(sent, items.len(), "the model takes everything");
    results
}
