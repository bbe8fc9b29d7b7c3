//! What the benchmark of the search core shows beside its charts: tables with the thesis' own beside them.

use crate::LabError;
use crate::bench::page::FigurePage;
use pointcore::search::resources::{arithmetic, storage};
use pointcore::search::{SearchCore, SearchReport};
use pointcore_contract::search::Config;
use std::fmt::Write as _;

/// Cycles a query of the thesis' prototype: 75 MHz by the throughput that figure 6.12 shows for k = 10.
const PROTOTYPE_CYCLES: f64 = 140.0;

impl FigurePage {
    /// What one shape of core takes, beside what bounds it.
    pub fn bound(&mut self, lanes: u32, report: &SearchReport) {
        let ratio = PROTOTYPE_CYCLES / report.cycles_per_query;
        _ = writeln!(
            self.text,
            "\n## Lanes: {lanes}; random order, k = {}\n\n{:.1} cycles a query, {:.0} queries/s at {} MHz; the thesis' prototype took \
             about {PROTOTYPE_CYCLES}, {ratio:.1} times as many. {:.1} bytes a query from memory.\n\n| resource | items a query |\n|---|---|",
            report.k, report.cycles_per_query, report.queries_per_second, report.clock.mhz, report.bytes_per_query
        );
        for bound in &report.bounds {
            _ = writeln!(self.text, "| {} | {:.1} |", bound.name, bound.cycles_per_query);
        }
        let percent = 100.0 * report.share_of_bound;
        _ = writeln!(self.text, "\nBound by {}: {percent:.0} % of the cycles.", report.bound.name);
    }

    /// Storage and arithmetic units of a core as generated, beside thesis tables 6.3 and 6.2.
    pub fn resources(&mut self, config: &Config) -> Result<(), LabError> {
        let variants = [
            ("search on chip", config.clone()),
            ("with neighbor cache", Config { neighbor_cache: 8, neighbors: 32, lanes: 1, ..config.clone() }),
            (
                "tree in external memory",
                Config { tree_cache: 4096, neighbor_cache: 8, neighbors: 32, lanes: 1, ..config.clone() },
            ),
        ];
        let cores = variants.iter().map(|(_, config)| SearchCore::generate(config)).collect::<Result<Vec<_>, _>>()?;
        let names: Vec<_> = variants.iter().map(|(name, _)| *name).collect();
        _ = writeln!(
            self.text,
            "\n## On-chip storage in kB, beside thesis table 6.3\n\n| part | {} | prototype | prototype, tree off chip |\n|---|{}---|---|",
            names.join(" | "),
            "---|".repeat(names.len())
        );
        let tables: Vec<_> = cores.iter().map(|core| storage(&core.design)).collect();
        let thesis = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
        for (index, row) in tables[0].iter().enumerate() {
            let ours: Vec<_> = tables.iter().map(|table| format!("{:.2}", table[index].kilobytes)).collect();
            _ = writeln!(
                self.text,
                "| {} | {} | {} | {} |",
                row.part,
                ours.join(" | "),
                thesis(row.prototype),
                thesis(row.off_chip)
            );
        }
        self.text += "\n## Arithmetic units, one lane, beside thesis table 6.2\n\n";
        self.text +=
            "| unit | search | neighbor cache | thesis: search | thesis: neighbor cache |\n|---|---|---|---|---|\n";
        for row in arithmetic(&cores[1].manifests) {
            let [search, cache] = row.thesis;
            _ = writeln!(self.text, "| {} | {} | {} | {search} | {cache} |", row.kind, row.search, row.cache);
        }
        Ok(())
    }
}
