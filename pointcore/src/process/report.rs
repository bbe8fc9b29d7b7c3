//! What an operator did, in a form for people and machines.

use super::cost::{Cost, Operators};
use super::outcome::Summary;
use super::timing::Timing;
use crate::area::recorded::Clock;
use crate::process::check::Comparison;
use serde::Serialize;
use std::fmt::Write as _;

/// The report on a run.
#[derive(Clone, Debug, Serialize)]
pub struct ProcessReport {
    /// What happened.
    #[serde(flatten)]
    pub summary: Summary,
    /// Neighbors of a query at most.
    pub k: u32,
    /// Only neighbors nearer than this counted.
    pub radius: Option<f64>,
    /// Iterations that a query may have.
    pub iterations_limit: u32,
    /// The format of floats.
    pub format: String,
    /// The clock at which times are told, where time was counted.
    pub clock: Option<Clock>,
    /// What the programs take as hardware.
    pub cost: Vec<Cost>,
    /// Look-up tables of the blocks' pipelines, estimated.
    pub lut4: Option<f64>,
    /// Outputs beside those of f64, if they were compared.
    pub compared: Option<Vec<Comparison>>,
}

impl ProcessReport {
    /// The report for people.
    #[must_use]
    pub fn markdown(&self) -> String {
        let mut text = format!("# {} of {}\n\n", self.summary.operation, self.summary.points);
        self.write_run(&mut text);
        self.write_time(&mut text);
        self.write_bindings(&mut text);
        self.write_compared(&mut text);
        self.write_cost(&mut text);
        text
    }

    fn write_run(&self, text: &mut String) {
        let summary = &self.summary;
        let each = |total: u64| total as f64 / summary.queries.max(1) as f64;
        let radius = self.radius.map_or(String::new(), |radius| format!(" within {radius}"));
        let passes =
            if summary.passes > 1 { format!(", in the last of {} passes", summary.passes) } else { String::new() };
        _ = writeln!(
            text,
            "{} queries among {} points{passes}, by the {}, floats in {}.\n",
            summary.queries, summary.point_count, summary.engine, self.format
        );
        if summary.left_out > 0 {
            _ = writeln!(text, "{} points of the file are no numbers and were left out.\n", summary.left_out);
        }
        _ = writeln!(text, "| | |\n|---|---|");
        let mut row = |name: &str, value: String| _ = writeln!(text, "| {name} | {value} |");
        let found = summary.neighbors.map_or(String::new(), |count| format!("{:.2} of ", each(count)));
        row("neighbors of a query", format!("{found}up to {}{radius}", self.k));
        if let Some(lonely) = summary.lonely {
            row("queries without a neighbor", lonely.to_string());
        }
        row(
            "iterations of a query",
            format!("{:.2}, at most {} of {}", each(summary.iterations), summary.iterations_max, self.iterations_limit),
        );
        row("capped: not done by then", summary.capped.to_string());
        row("not valid", summary.invalid.map_or("the program does not say".to_owned(), |count| count.to_string()));
    }

    fn write_time(&self, text: &mut String) {
        let Some(clock) = &self.clock else { return };
        _ = writeln!(text, "\n## Time\n\nAt {clock}.\n");
        _ = writeln!(
            text,
            "| program | cycles | a query | queries a second | kernel busy | lines there | neighbor cache | bytes a query |\n|---|---|---|---|---|---|---|---|"
        );
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        for timing in &self.summary.timings {
            let Timing { program, cycles, queries, bytes, line_hits, line_misses, .. } = timing;
            let each = timing.cycles_per_query();
            let saved = timing.saved().map_or("none".to_owned(), |share| format!("{} spared", percent(share)));
            let lines = *line_hits as f64 / (line_hits + line_misses).max(1) as f64;
            _ = writeln!(
                text,
                "| `{program}` | {cycles} | {each:.2} | {:.0} | {} | {} | {saved} | {:.1} |",
                clock.mhz * 1e6 / each,
                percent(timing.kernel_busy()),
                percent(lines),
                *bytes as f64 / (*queries).max(1) as f64,
            );
        }
        let simulated: u64 = self.summary.timings.iter().map(|timing| timing.simulated_cycles).sum();
        let seconds: f64 = self.summary.timings.iter().map(|timing| timing.seconds).sum();
        _ = writeln!(text, "\n{simulated} cycles were simulated in {seconds:.1} s.");
    }

    fn write_bindings(&self, text: &mut String) {
        _ = writeln!(text, "\n## Settings and fields\n\n| | |\n|---|---|");
        for (program, settings) in &self.summary.settings {
            for setting in settings {
                let values: Vec<String> = setting.values.iter().map(|value| shortened(*value)).collect();
                let from = if setting.given { "given" } else { "derived" };
                _ = writeln!(text, "| `{program}`: `{}` | {} ({from}) |", setting.name, values.join(", "));
            }
        }
        for (field, from) in &self.summary.attributes {
            _ = writeln!(text, "| `{field}` | {from} |");
        }
    }

    fn write_compared(&self, text: &mut String) {
        let Some(compared) = &self.compared else { return };
        _ = writeln!(text, "\n## Beside f64\n\nThe last iteration of each query, from where it began.\n");
        _ = writeln!(
            text,
            "| output | compared | without a bound | largest error | its bound | largest share of a bound |\n|---|---|---|---|---|---|"
        );
        for Comparison { output, compared, unbounded, error, bound, share, .. } in compared {
            let [error, bound] = [error, bound].map(|number| shortened(*number));
            _ = writeln!(text, "| `{output}` | {compared} | {unbounded} | {error} | {bound} | {share:.3} |");
        }
    }

    fn write_cost(&self, text: &mut String) {
        _ = writeln!(text, "\n## Hardware\n\nPipelines of the blocks, and the adders of the sums.\n");
        _ = writeln!(
            text,
            "| | add | mul | div | sqrt | others | latency | a token every | register bits |\n|---|---|---|---|---|---|---|---|---|"
        );
        let operators = |operators: &Operators| {
            let Operators { add, mul, div, sqrt, other } = operators;
            format!("{add} | {mul} | {div} | {sqrt} | {other}")
        };
        for cost in &self.cost {
            for block in &cost.blocks {
                let (name, used) = (block.block, operators(&block.operators));
                _ = writeln!(
                    text,
                    "| `{}` .{name} | {used} | {} | {} | {} |",
                    cost.program, block.latency, block.interval, block.register_bits
                );
            }
            let registers: u64 = cost.blocks.iter().map(|block| block.register_bits).sum();
            _ = writeln!(text, "| `{}`, all | {} | | | {registers} |", cost.program, operators(&cost.operators));
            if let Some(thesis) = cost.thesis() {
                let Operators { add, mul, div, sqrt, .. } = thesis;
                _ = writeln!(text, "| thesis table 6.2 | {add} | {mul} | {div} | {sqrt} | | | | |");
            }
        }
        if let Some(lut4) = self.lut4 {
            _ = writeln!(text, "\nAbout {lut4:.0} look-up tables of four inputs, by the record of areas.");
        }
    }
}

/// A number in few digits.
fn shortened(number: f64) -> String {
    let magnitude = number.abs();
    if magnitude == 0.0 || (1e-3..1e5).contains(&magnitude) { format!("{number:.5}") } else { format!("{number:.4e}") }
}
