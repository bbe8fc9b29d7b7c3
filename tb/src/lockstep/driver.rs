//! The loop.

use std::sync::Arc;

use super::comparison::Comparison;
use super::failure::{Cause, LockstepError, LockstepFailure, Waveform};
use super::interrupted::{interrupted, noisy_reset};
use super::protocol::Protocol;
use super::replay::Replay;
use super::seed::SEED_VARIABLE;
use super::stimulus::{Flow, Golden, RESET_CYCLES, Stimulus};
use super::stream::Streams;
use crate::verilated::{Direction, Library, RESET, VerilatedError, VerilatedModel};

/// Cycles after which a run is taken for stuck, unless another limit is set.
const DEFAULT_LIMIT: u64 = 1_000_000;

/// Cycles in the waveform of a failure, unless another number is set.
const DEFAULT_RECORDED: u64 = 200;

/// Hardware and golden model side by side.
pub struct Lockstep<G> {
    library: Arc<Library>,
    golden: G,
    comparison: Comparison,
    streams: Streams,
    seed: u64,
    limit: u64,
    recorded: u64,
    reproduce: String,
}

/// A run that went well.
#[derive(Debug)]
pub struct Run<S> {
    /// The stimulus in its final state, with what it collected.
    pub stimulus: S,
    /// What happened.
    pub report: LockstepReport,
}

/// What happened in a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LockstepReport {
    /// Cycles compared.
    pub cycles: u64,
    /// Items transferred by each stream.
    pub transfers: Vec<(String, u64)>,
    /// Cycles in which each output of one bit was set that is no part of a stream, as those are that tell of events.
    pub events: Vec<(String, u64)>,
}

impl LockstepReport {
    /// Items transferred by the stream `name`; 0 for a stream that does not exist.
    #[must_use]
    pub fn transfers(&self, name: &str) -> u64 {
        count(&self.transfers, name)
    }

    /// Cycles in which the output `name` was set; 0 for one that is no such output.
    #[must_use]
    pub fn events(&self, name: &str) -> u64 {
        count(&self.events, name)
    }
}

fn count(counts: &[(String, u64)], name: &str) -> u64 {
    counts.iter().find(|(counted, _)| counted == name).map_or(0, |(_, count)| *count)
}

impl<G: Golden> Lockstep<G> {
    /// Compares instances of `library` with `golden`, which is in its initial state. `seed` decides the hardware's
    /// uninitialized values and is printed when the run fails.
    #[must_use]
    pub fn new(library: &Arc<Library>, golden: G, seed: u64) -> Self {
        let streams = Streams::of(library);
        let comparison = Comparison::new(streams.clone(), library.outputs().len());
        let limit = DEFAULT_LIMIT;
        let reproduce = reproducing_test(seed);
        Self {
            library: Arc::clone(library),
            golden,
            comparison,
            streams,
            seed,
            limit,
            recorded: DEFAULT_RECORDED,
            reproduce,
        }
    }

    /// Leaves outputs open: `mask(hardware, golden)` sets those that do not matter in this cycle to the same value. The
    /// fields of a stream that offers nothing are masked already.
    #[must_use]
    pub fn mask(mut self, mask: impl FnMut(&mut [u64], &mut [u64]) + Send + 'static) -> Self {
        self.comparison.set_mask(Box::new(mask));
        self
    }

    /// The number of cycles after which the run fails as stuck; a finished run takes fewer.
    #[must_use]
    pub fn limit(mut self, cycles: u64) -> Self {
        self.limit = cycles;
        self
    }

    /// The number of cycles in the waveform of a failure.
    #[must_use]
    pub fn recorded(mut self, cycles: u64) -> Self {
        self.recorded = cycles;
        self
    }

    /// The command to print with a failure; without it, the one that runs the current test.
    #[must_use]
    pub fn reproduced_by(mut self, command: String) -> Self {
        self.reproduce = command;
        self
    }

    /// Resets both, then steps both until the stimulus is done, comparing every output in every cycle. The hardware begins in
    /// the middle of such a run: of what it was doing, the reset leaves nothing.
    ///
    /// # Errors
    /// The first difference, broken protocol or failed assertion; a run beyond its limit; a run without transaction.
    pub fn run<S: Stimulus + Clone>(mut self, mut stimulus: S) -> Result<Run<S>, LockstepError> {
        let initial = stimulus.clone();
        let mut hardware = interrupted(&self.library, self.seed, initial.clone())?;
        let mut state = State::new(&self.library, &self.streams, self.seed);
        for _ in 0..RESET_CYCLES {
            hardware.step(&state.inputs, &mut state.outputs)?;
            self.golden.step(&state.inputs, &mut state.expected);
        }
        state.inputs.fill(0);
        let mut cycle = 0;
        while stimulus.drive(cycle, &state.outputs, &mut state.inputs) == Flow::Continue {
            let mut outcome = self.step(&mut hardware, &mut state)?;
            if outcome.is_ok() && cycle + 1 == self.limit {
                outcome = Err(Cause::Unfinished);
            }
            if let Err(cause) = outcome {
                return Err(self.explain(cycle, cause, &state, initial));
            }
            cycle += 1;
        }
        let report = self.report(cycle, &state)?;
        Ok(Run { stimulus, report })
    }

    /// One cycle of both; the inner error is what went wrong in it.
    fn step(&mut self, hardware: &mut VerilatedModel, state: &mut State) -> Result<Result<(), Cause>, VerilatedError> {
        match hardware.step(&state.inputs, &mut state.outputs) {
            Ok(()) => {}
            Err(VerilatedError::Stopped(text)) => return Ok(Err(Cause::Stopped(text))),
            Err(error) => return Err(error),
        }
        self.golden.step(&state.inputs, &mut state.expected);
        if !self.comparison.agree(&state.outputs, &state.expected) {
            return Ok(Err(Cause::Mismatch(self.comparison.differences(self.library.outputs()))));
        }
        state.count_events();
        Ok(state.protocol.check(&state.inputs, &state.outputs).map_err(Cause::Protocol))
    }

    fn explain(&mut self, cycle: u64, cause: Cause, state: &State, initial: impl Stimulus + Clone) -> LockstepError {
        let replay = Replay {
            library: &self.library,
            seed: self.seed,
            cycle,
            outputs: &state.outputs,
            comparison: &mut self.comparison,
            recorded: self.recorded,
        };
        let waveform: Waveform = replay.run(initial);
        let ports = self.library.inputs().iter().map(|port| port.name.clone());
        LockstepError::Failed(Box::new(LockstepFailure {
            top: self.library.source().top.clone(),
            cycle,
            cause,
            inputs: ports.zip(state.inputs.iter().copied()).collect(),
            seed: self.seed,
            reproduce: self.reproduce.clone(),
            waveform,
        }))
    }

    /// Results must have come out where results can come out, else something must have gone in; a unit without streams
    /// has one transaction a cycle.
    fn report(&self, cycles: u64, state: &State) -> Result<LockstepReport, LockstepError> {
        let protocol = &state.protocol;
        let produces = self.streams.iter().any(|stream| stream.direction == Direction::Output);
        let wanted = if produces { Direction::Output } else { Direction::Input };
        let counted: Vec<_> = protocol.transfers().filter(|(stream, _)| stream.direction == wanted).collect();
        let transactions = if counted.is_empty() { cycles } else { counted.iter().map(|(_, count)| count).sum() };
        if transactions == 0 {
            let names: Vec<_> = counted.iter().map(|(stream, _)| stream.name.as_str()).collect();
            return Err(LockstepError::NoTransaction { cycles, streams: names.join(", "), seed: self.seed });
        }
        let transfers = protocol.transfers().map(|(stream, count)| (stream.name.clone(), count)).collect();
        let outputs = self.library.outputs();
        let events = state.events.iter().map(|&(output, count)| (outputs[output].name.clone(), count)).collect();
        Ok(LockstepReport { cycles, transfers, events })
    }
}

/// The words of the current cycle.
struct State {
    inputs: Vec<u64>,
    outputs: Vec<u64>,
    expected: Vec<u64>,
    protocol: Protocol,
    /// Position and count of each event.
    events: Vec<(usize, u64)>,
}

impl State {
    fn new(library: &Library, streams: &Streams, seed: u64) -> Self {
        let reset = library.inputs().iter().position(|port| port.name == RESET);
        let outputs = vec![0; library.outputs().len()];
        let protocol = Protocol::new(streams, reset);
        let is_event = |&output: &usize| library.outputs()[output].width == 1 && !streams.have_output(output);
        let events = (0..outputs.len()).filter(is_event).map(|output| (output, 0)).collect();
        Self { inputs: noisy_reset(library, seed), expected: outputs.clone(), outputs, protocol, events }
    }

    fn count_events(&mut self) {
        for (output, count) in &mut self.events {
            *count += self.outputs[*output];
        }
    }
}

/// The command that runs the current test again: the test harness names its threads after the tests.
fn reproducing_test(seed: u64) -> String {
    let thread = std::thread::current();
    let test = thread.name().filter(|name| *name != "main").unwrap_or_default();
    format!("{SEED_VARIABLE}={seed} cargo test -p pointcore-tb --test units {test}").trim_end().to_owned()
}
