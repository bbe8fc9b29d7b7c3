//! Abort: a run ends early, and cleanly.

use pointcore_contract::bus::units::QUIET_CYCLES;

/// What ends a run early, cycle by cycle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Abort {
    state: State,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    /// The run, if there is one, goes on.
    #[default]
    Idle,
    /// The run is being ended; nothing was under way for so many cycles.
    Aborting { quiet: u32 },
    /// It has ended in the last cycle.
    Ended,
}

impl Abort {
    /// Whether the core is to stay in reset.
    #[must_use]
    pub const fn aborts(&self) -> bool {
        matches!(self.state, State::Aborting { .. })
    }

    /// Whether the run has just ended.
    #[must_use]
    pub const fn ended(&self) -> bool {
        matches!(self.state, State::Ended)
    }

    /// A cycle in which the host asks for the end, or not, of a run that is under way, or not, while the buses are quiet, or not.
    pub const fn clock(&mut self, asked: bool, running: bool, quiet: bool) {
        self.state = match self.state {
            State::Aborting { quiet: cycles } if quiet && cycles + 1 == QUIET_CYCLES => State::Ended,
            State::Aborting { quiet: cycles } => State::Aborting { quiet: if quiet { cycles + 1 } else { 0 } },
            State::Idle | State::Ended if asked && running => State::Aborting { quiet: 0 },
            State::Idle | State::Ended => State::Idle,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_ends_when_the_buses_have_been_quiet_for_a_while() {
        let mut unit = Abort::default();
        unit.clock(true, false, true);
        assert!(!unit.aborts(), "there is no run");
        unit.clock(true, true, true);
        (1..QUIET_CYCLES).for_each(|_| unit.clock(false, true, true));
        unit.clock(false, true, false);
        (1..QUIET_CYCLES).for_each(|_| unit.clock(true, true, true));
        assert!(unit.aborts() && !unit.ended(), "it begins to count anew");
        unit.clock(true, true, true);
        assert!(unit.ended() && !unit.aborts());
        unit.clock(false, true, true);
        assert!(!unit.ended() && !unit.aborts());
    }
}
