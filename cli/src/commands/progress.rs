//! Signs of life on a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Steps of the progress bar.
const STEPS: u64 = 1000;

/// A bar on a terminal, nothing elsewhere.
fn bar(message: &'static str) -> ProgressBar {
    let template = "{msg} [{bar:30}] {percent}% {prefix} {eta} left";
    let style = ProgressStyle::with_template(template).expect("the template is well-formed");
    ProgressBar::new(STEPS).with_style(style).with_message(message)
}

/// Runs a simulation with a progress bar.
pub fn with_progress<T>(message: &'static str, run: impl FnOnce(&(dyn Fn(u64, f64) + Sync)) -> T) -> T {
    let bar = bar(message);
    let outcome = run(&|cycle, share| {
        let rate = cycle as f64 / bar.elapsed().as_secs_f64().max(1e-3) / 1e3;
        bar.set_prefix(format!("{cycle} cycles, {rate:.0} kHz,"));
        bar.set_position((share * STEPS as f64) as u64);
    });
    bar.finish_and_clear();
    outcome
}

/// Runs a long step that cannot count its work, and shows that it lives.
pub fn with_spinner<T>(message: &'static str, run: impl FnOnce() -> T) -> T {
    let bar = ProgressBar::new_spinner().with_message(message);
    bar.enable_steady_tick(Duration::from_millis(100));
    let outcome = run();
    bar.finish_and_clear();
    outcome
}

/// Runs many cases with a progress bar.
pub fn with_count<T>(message: &'static str, total: u64, run: impl FnOnce(&(dyn Fn(u64) + Sync)) -> T) -> T {
    let bar = bar(message);
    let outcome = run(&|done| {
        bar.set_prefix(format!("{done},"));
        bar.set_position(done * STEPS / total.max(1));
    });
    bar.finish_and_clear();
    outcome
}
