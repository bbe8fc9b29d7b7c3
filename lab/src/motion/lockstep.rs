//! Moving splats through the generated hardware of setup, and the samples made of them through that of evaluation, in lockstep with their models.

use super::check::{Case, Units, case};
use crate::{LabError, note};
use fastrand::Rng;
use pointcore::generated::{GenerateError, verilate};
use pointcore::splat::mask::end_records;
use pointcore::stimuli::motion::{Family, uniforms};
use pointcore_contract::splat::{Config, units};
use pointcore_contract::{Direction, Port, Unit, words};
use pointcore_golden::splat::{MotionEvaluation, MotionSetup};
use pointcore_golden::unit::{Model, Ported, Unit as _};
use pointcore_hdl::compiler::{Datapath, Options};
use pointcore_hdl::splat::{motion_evaluation, motion_setup};
use pointcore_tb::lockstep::{Lockstep, LockstepError, Stall, StreamTestbench};
use pointcore_tb::verilated::{Library, Trace};
use rtl::elaborate;
use std::sync::Arc;

/// Share of the cycles in which streams are held back.
const STALL_SHARE: f64 = 0.2;
/// Silence that ends a run: longer than either pipeline.
const QUIET_CYCLES: u64 = 600;
/// Cases of a run.
const RUN_CASES: u64 = 5_000;

/// What came of all runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Splats that went through setup, and samples of them through evaluation.
    pub cases: u64,
    /// Runs in which hardware and model differed.
    pub mismatches: u64,
}

/// A unit's hardware beside its model.
struct Device<M> {
    unit: &'static Unit<Config>,
    library: Arc<Library>,
    model: M,
}

impl<M: Model<Config = Config>> Device<M> {
    fn new(unit: &'static Unit<Config>, datapath: Datapath, model: impl FnOnce(u32) -> M) -> Result<Self, LabError> {
        let library = verilate(&elaborate(&datapath.module)?, Trace::Off)?;
        Ok(Self { unit, library, model: model(datapath.manifest.latency) })
    }

    /// Sends items through both; 1 if they differ.
    fn run(
        &self,
        config: &Config,
        items: Vec<Vec<u64>>,
        constants: &[(String, u64)],
        seed: u64,
    ) -> Result<u64, LabError> {
        let (library, stall) = (&self.library, Stall::Random(STALL_SHARE));
        let interface = (self.unit.interface)(config);
        let testbench = StreamTestbench::new(library, seed).quiet_cycles(QUIET_CYCLES);
        let testbench = testbench.source("in", items, stall).map_err(LockstepError::from)?;
        let mut testbench = testbench.sink("out", stall).map_err(LockstepError::from)?;
        for (name, value) in constants.iter().filter(|(name, _)| library.inputs().iter().any(|port| port.name == *name))
        {
            testbench = testbench.constant(name, *value).map_err(LockstepError::from)?;
        }
        let outputs: Vec<String> = library.outputs().iter().map(|port| port.name.clone()).collect();
        let golden = by_name(library, &interface.ports(), Ported::new(config, self.model.clone()));
        let lockstep = Lockstep::new(library, golden, seed).mask(end_records(&interface, &outputs));
        match lockstep.reproduced_by("pointcore bench --only motion".to_owned()).run(testbench) {
            Ok(_) => Ok(0),
            Err(LockstepError::Failed(failure)) => {
                note!("{}: {failure}", self.unit.module);
                Ok(1)
            }
            Err(error) => Err(error.into()),
        }
    }
}

/// A model with its words in the order of the hardware's ports.
fn by_name<M: Model<Config = Config>>(
    library: &Library,
    specified: &[Port],
    mut model: Ported<M>,
) -> impl FnMut(&[u64], &mut [u64]) + use<M> {
    let places = |direction: Direction| -> Vec<usize> {
        let side = if direction == Direction::Input { library.inputs() } else { library.outputs() };
        let of_direction = specified.iter().filter(|port| port.direction == direction);
        let place = |port: &Port| side.iter().position(|other| other.name == port.name);
        of_direction.map(|port| place(port).expect("hardware has the ports of its unit")).collect()
    };
    let [input_places, output_places] = [Direction::Input, Direction::Output].map(places);
    let (mut inputs, mut outputs) = (vec![0; input_places.len()], vec![0; output_places.len()]);
    move |hardware_inputs, hardware_outputs| {
        inputs.iter_mut().zip(&input_places).for_each(|(input, &place)| *input = hardware_inputs[place]);
        model.step(&inputs, &mut outputs);
        outputs.iter().zip(&output_places).for_each(|(output, &place)| hardware_outputs[place] = *output);
    }
}

/// Runs so many cases of all families in a configuration.
///
/// # Errors
/// A fault of the generator, or a tool is missing or fails.
pub fn run(config: &Config, cases: u64, seed: u64) -> Result<Report, LabError> {
    let options = Options::default();
    let compiled = |error| LabError::Generate(GenerateError::Compile(error));
    let setup = motion_setup::datapath(config, &options).map_err(compiled)?;
    let setup = Device::new(&units::motion_setup::UNIT, setup, |latency| MotionSetup::new(config, latency))?;
    let evaluation = motion_evaluation::datapath(config, &options).map_err(compiled)?;
    let evaluation =
        Device::new(&units::motion_evaluation::UNIT, evaluation, |latency| MotionEvaluation::new(config, latency))?;
    let (units, uniforms) = (Units::new(config), uniforms(config));
    let mut random = Rng::with_seed(seed);
    let mut families = Family::ALL.into_iter().cycle();
    let mut report = Report::default();
    while report.cases < cases {
        let count = RUN_CASES.min(cases - report.cases) as usize;
        let drawn: Vec<Case> =
            families.by_ref().filter_map(|family| case(&mut random, family, config)).take(count).collect();
        let splats = drawn.iter().map(|case| words(config, case.splat)).collect();
        let places = drawn.iter().map(|case| words(config, units.place(case))).collect();
        let seed = seed + report.cases;
        report.mismatches += setup.run(config, splats, &uniforms, seed)?;
        report.mismatches += evaluation.run(config, places, &uniforms, seed)?;
        report.cases += count as u64;
        note!("motion, {}: {} of {cases} cases in lockstep", config.geometry, report.cases);
    }
    Ok(report)
}
