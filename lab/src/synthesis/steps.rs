//! Steps of a measurement, and those who hear of them.

use super::convergence::Divergence;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// How often a step that goes on says so.
const TICK: Duration = Duration::from_secs(1);

/// A step, at its end and about once a second until then.
pub struct Step<'a> {
    /// On what.
    pub unit: &'a str,
    /// What is done.
    pub work: Work,
    /// How long it took, or has taken; short if its result was kept.
    pub duration: Duration,
    /// Whether it has ended.
    pub state: State,
}

/// What a step does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Work {
    /// Cells of a unit.
    Synthesis,
    /// Their places, with a seed.
    Placing(u32),
    /// Places and wires, with a seed.
    PlaceAndRoute(u32),
}

/// Whether a step has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It goes on.
    Running,
    /// A router was stopped, and another one goes on.
    Diverged(Divergence),
    /// It is done.
    Done,
}

/// Hears of steps.
pub type StepListener<'a> = &'a (dyn Fn(&Step<'_>) + Sync);

/// Runs a step, and has the progress told of it.
pub(super) fn watched<T, E>(
    unit: &str,
    work: Work,
    progress: StepListener<'_>,
    run: impl FnOnce() -> Result<T, E>,
) -> Result<T, E> {
    let begin = Instant::now();
    let tell = |state| progress(&Step { unit, work, duration: begin.elapsed(), state });
    let (end, ended) = mpsc::channel::<()>();
    let result = thread::scope(|scope| {
        scope.spawn(move || {
            while ended.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                tell(State::Running);
            }
        });
        let result = run();
        drop(end);
        result
    })?;
    tell(State::Done);
    Ok(result)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[test]
    fn a_long_step_is_told_of_until_its_end_and_a_failed_one_has_none() {
        let heard = Mutex::new(Vec::new());
        let progress = |step: &Step<'_>| heard.lock().expect("no step panics").push((step.work, step.state));
        let slow = watched("unit", Work::Placing(1), &progress, || {
            thread::sleep(TICK * 3 / 2);
            Ok::<_, ()>(7)
        });
        assert_eq!(slow, Ok(7));
        assert_eq!(watched("unit", Work::Synthesis, &progress, || Err::<(), _>("broken")), Err("broken"));
        assert_eq!(
            *heard.lock().expect("no step panics"),
            [State::Running, State::Done].map(|state| (Work::Placing(1), state))
        );
    }
}
