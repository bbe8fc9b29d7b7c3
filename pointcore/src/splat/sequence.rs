//! What a table of a sequence's frames says of each.

use super::fates::Fates;
use super::report::SplatReport;
use serde::Serialize;

/// The figures of a frame of a sequence.
#[derive(Clone, Debug, Serialize)]
pub struct FrameFigures {
    cycles: u64,
    fates: Fates,
    samples: u64,
    accumulated: u64,
    /// Fragments of the frame.
    pub fragments: u64,
    mismatches: Option<u64>,
    psnr_db: Option<f64>,
}

impl FrameFigures {
    /// What its [`cells`](Self::cells) are.
    pub const HEADS: [&str; 7] = ["cycles", "drawn", "culled", "samples", "inside", "fragments", "PSNR"];

    /// Those of a report.
    #[must_use]
    pub const fn of(report: &SplatReport) -> Self {
        let SplatReport { cycles, fates, samples, accumulated, fragments, mismatches, psnr_db, .. } = *report;
        Self { cycles, fates, samples, accumulated, fragments, mismatches, psnr_db }
    }

    /// Its line in a table.
    #[must_use]
    pub fn cells(&self) -> [String; 7] {
        let Self { cycles, fates, samples, accumulated, fragments, .. } = *self;
        let psnr = self.psnr_db.map_or("–".to_owned(), |psnr_db| format!("{psnr_db:.1} dB"));
        let [cycles, drawn, culled, samples, accumulated, fragments] =
            [cycles, fates.drawn, fates.culled(), samples, accumulated, fragments].map(|count| count.to_string());
        [cycles, drawn, culled, samples, accumulated, fragments, psnr]
    }
}
