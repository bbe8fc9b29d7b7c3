//! Signs of life from the tools: a line for each step that is done, and of one that takes long what it is and since when.

use indicatif::{MultiProgress, ProgressBar};
use pointcore_lab::note;
use pointcore_lab::synthesis::{State, Step, Work};
use std::collections::HashMap;
use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::Duration;

/// How often a log hears of a step that goes on.
const LOG_SECONDS: u64 = 60;
/// How often a spinner turns.
const TURN: Duration = Duration::from_millis(100);

/// Lines on the error stream; on a terminal, a spinner for each step under way besides.
#[derive(Default)]
pub struct Display {
    spinners: MultiProgress,
    running: Mutex<HashMap<(String, Work), ProgressBar>>,
}

/// 75 s, or 12:05 min.
fn time(duration: Duration) -> String {
    let seconds = duration.as_secs();
    if seconds < 100 {
        format!("{:.1} s", duration.as_secs_f64())
    } else {
        format!("{}:{:02} min", seconds / 60, seconds % 60)
    }
}

fn under_way(work: Work) -> String {
    match work {
        Work::Synthesis => "synthesis".to_owned(),
        Work::Placing(seed) => format!("placing with seed {seed}"),
        Work::PlaceAndRoute(seed) => format!("place and route with seed {seed}"),
    }
}

fn done(work: Work) -> String {
    match work {
        Work::Synthesis => "synthesized".to_owned(),
        Work::Placing(seed) => format!("placed with seed {seed}"),
        Work::PlaceAndRoute(seed) => format!("placed and routed with seed {seed}"),
    }
}

impl Display {
    /// Shows a step.
    pub fn show(&self, step: &Step<'_>) {
        let Step { unit, work, duration, state } = *step;
        let key = (unit.to_owned(), work);
        let mut running = self.running.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        match state {
            State::Running if std::io::stderr().is_terminal() => {
                let spinner = || {
                    let spinner = self.spinners.add(ProgressBar::new_spinner());
                    spinner.enable_steady_tick(TURN);
                    spinner
                };
                let spinner = running.entry(key).or_insert_with(spinner);
                spinner.set_message(format!("{unit}: {} for {}", under_way(work), time(duration)));
            }
            State::Running if duration.as_secs() > 0 && duration.as_secs().is_multiple_of(LOG_SECONDS) => {
                note!("{unit}: {} has run for {}", under_way(work), time(duration));
            }
            State::Running => {}
            State::Diverged(divergence) => {
                let route = under_way(work);
                let note = || note!("{unit}: {route}: {divergence}; stopped, the other router takes over");
                self.spinners.suspend(note);
            }
            State::Done => {
                if let Some(spinner) = running.remove(&key) {
                    spinner.finish_and_clear();
                }
                self.spinners.suspend(|| note!("{unit}: {} ({})", done(work), time(duration)));
            }
        }
    }
}
