//! What a run says: figures with their definitions, as JSON and as a page to read.

use super::fates::Fates;
use super::host::{EventCounts, SplatCounters};
use pointcore_contract::splat::{AttributeFormat, Config, records};
use pointcore_golden::reference::Frame;
use serde::Serialize;
use std::fmt::Write as _;

/// Largest difference of an attribute that the rounding of one value explains. In coarse fixed point it is [more](rounding_limit), and that of
/// sums of many samples [grows with them](sum_limit).
pub const ROUNDING_LIMIT: f64 = 1.0 / 256.0;

/// Units in the last place of a fixed-point attribute that the host's and the normalizer's rounding and the missing one come to.
const ROUNDED_PLACES: f64 = 2.0;

/// Roundings of a sample on its way into a sum: of its attribute, of the product with its weight, of the sum.
const ROUNDINGS_PER_SAMPLE: f64 = 3.0;

/// Largest difference that the rounding of sums over so many samples explains; sums in fixed point are exact.
#[must_use]
pub fn sum_limit(config: &Config, samples: u32) -> f64 {
    match config.attribute {
        AttributeFormat::Float(format) => {
            let half_place = 0.5_f64.powi(format.mantissa as i32 + 1);
            ROUNDING_LIMIT.max(ROUNDINGS_PER_SAMPLE * f64::from(samples) * half_place)
        }
        AttributeFormat::Fixed(_) => rounding_limit(config),
    }
}

/// Largest difference of an attribute that the rounding of one value explains on a configuration.
#[must_use]
pub fn rounding_limit(config: &Config) -> f64 {
    match config.attribute {
        AttributeFormat::Float(_) => ROUNDING_LIMIT,
        AttributeFormat::Fixed(fraction) => {
            let places = ROUNDED_PLACES * 0.5_f64.powi(fraction.number().fraction as i32);
            places.max(ROUNDING_LIMIT)
        }
    }
}

/// How far a stored or tested depth may be off: 16 units in the last place of a 24-bit depth, for the roundings of `f32` in setup
/// and of the fixed-point depths behind it.
pub const DEPTH_ROUNDING: f64 = 16.0 / (1 << 24) as f64;

/// How far ρ² may be off at the edge of a splat: some 2⁻²⁴ for each of its roundings, magnified by the foreshortening of splats that
/// are seen almost edge-on.
pub const EDGE_ROUNDING: f64 = 1.0 / (1 << 14) as f64;

/// The figures of one frame.
#[derive(Clone, Debug, Serialize)]
pub struct SplatReport {
    /// The scene's name.
    pub scene: String,
    /// What ran: `rtl` (in lockstep or not) or `golden`.
    pub engine: String,
    /// Splats sent.
    pub splats: u64,
    /// What became of them.
    pub fates: Fates,
    /// Image size in pixels.
    pub width: u32,
    /// Image size in pixels.
    pub height: u32,
    /// Outputs on which hardware and model differed; absent where they were not compared.
    pub mismatches: Option<u64>,
    /// Cycles from the first splat to the end of the frame.
    pub cycles: u64,
    /// Cycles for each splat sent.
    pub cycles_per_splat: f64,
    /// Samples evaluated by the rasterizer.
    pub samples: u64,
    /// Cycles for each sample evaluated.
    pub cycles_per_sample: f64,
    /// Samples inside their splat, which reach the accumulator.
    pub accumulated: u64,
    /// Share of the cycles in which the rasterizer evaluates a sample.
    pub rasterizer_utilisation: f64,
    /// Share of the cycles in which the accumulator takes a sample.
    pub accumulator_utilisation: f64,
    /// Share of the cycles in which the accumulator waits for an earlier sample of the same pixel.
    pub hazard_fraction: f64,
    /// Share of the cycles in which the accumulator waits for its tile.
    pub slot_wait_fraction: f64,
    /// Share of the cycles in which the rasterizer has nothing to do.
    pub starved_fraction: f64,
    /// Share of the cycles in which what follows holds the rasterizer.
    pub blocked_fraction: f64,
    /// Bytes read from the reconstruction buffer.
    pub buffer_read_bytes: u64,
    /// Bytes written to the reconstruction buffer.
    pub buffer_write_bytes: u64,
    /// Fragments of the frame.
    pub fragments: u64,
    /// Peak signal-to-noise ratio of the shaded picture against the f64 reference; absent where neither shows a splat.
    pub psnr_db: Option<f64>,
    /// Pixels that only one of frame and reference covers.
    pub coverage_differences: u64,
    /// Pixels covered by both that took their cardinal attribute from another splat: two weights were nearly equal.
    pub material_differences: u64,
    /// Pixels covered by both whose attributes differ by more than the rounding of one value explains ([`rounding_limit`]).
    pub outcome_differences: u64,
    /// Of those, pixels where no test came near another outcome, and the rounding of their sums explains the difference ([`sum_limit`]).
    pub sum_differences: u64,
    /// Of those, pixels where the reference's depth test came within [`DEPTH_ROUNDING`] of another outcome.
    pub depth_test_differences: u64,
    /// Of the others, pixels where a sample's ρ² came within [`EDGE_ROUNDING`] of the edge of its splat.
    pub edge_differences: u64,
    /// Cycles simulated in a second.
    pub simulated_cycles_per_second: f64,
}

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

/// How a frame differs from its reference.
#[derive(Default)]
struct Differences {
    coverage: u64,
    material: u64,
    outcome: u64,
    sum: u64,
    depth_test: u64,
    edge: u64,
}

impl Differences {
    fn of(frame: &Frame, reference: &Frame, config: &Config) -> Self {
        let limit = rounding_limit(config);
        let mut found = Self::default();
        let tests = reference.margins.iter().zip(&reference.decisions);
        for (pair, (margins, decisions)) in frame.pixels.iter().zip(&reference.pixels).zip(tests) {
            match pair {
                (Some(a), Some(b)) => {
                    found.material += u64::from(a.material != b.material);
                    let apart = a.attributes.iter().zip(&b.attributes).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    if apart > limit {
                        found.outcome += 1;
                        let summed = sum_limit(config, decisions.pass + decisions.blend);
                        if margins.depth <= DEPTH_ROUNDING {
                            found.depth_test += 1;
                        } else if margins.edge <= EDGE_ROUNDING {
                            found.edge += 1;
                        } else if apart <= summed {
                            found.sum += 1;
                        }
                    }
                }
                (None, None) => {}
                _ => found.coverage += 1,
            }
        }
        found
    }
}

/// The run behind a report.
pub struct SplatRun<'a> {
    /// The scene's name.
    pub scene: &'a str,
    /// What ran.
    pub engine: &'a str,
    /// The hardware's configuration.
    pub config: &'a Config,
    /// What became of the splats sent.
    pub fates: Fates,
    /// What the host counted.
    pub counters: &'a SplatCounters,
    /// The frame.
    pub frame: &'a Frame,
    /// The f64 reference.
    pub reference: &'a Frame,
    /// Of the shaded pictures.
    pub psnr_db: f64,
    /// Outputs that differed, where they were compared.
    pub mismatches: Option<u64>,
    /// Simulation speed.
    pub simulated_cycles_per_second: f64,
}

impl SplatReport {
    /// Derives the figures.
    #[must_use]
    pub fn new(run: &SplatRun) -> Self {
        let SplatCounters { cycles, events, pixels_read, pixels_written } = *run.counters;
        let EventCounts { sample: samples, starved, blocked, accumulate: accumulated, hazard, slot_wait } = events;
        let share = |count: u64| count as f64 / (cycles.max(1) * u64::from(run.config.rasterizers)) as f64;
        let pixel_bytes = u64::from(records::pixel_bytes(run.config));
        let differences = Differences::of(run.frame, run.reference, run.config);
        let is_comparable = [run.frame, run.reference].iter().any(|frame| frame.pixels.iter().any(Option::is_some));
        Self {
            scene: run.scene.to_owned(),
            engine: run.engine.to_owned(),
            splats: run.fates.total(),
            fates: run.fates,
            width: run.frame.width as u32,
            height: run.frame.height as u32,
            mismatches: run.mismatches,
            cycles,
            cycles_per_splat: cycles as f64 / run.fates.total().max(1) as f64,
            samples,
            cycles_per_sample: cycles as f64 / samples.max(1) as f64,
            accumulated,
            rasterizer_utilisation: share(samples),
            accumulator_utilisation: share(accumulated),
            hazard_fraction: share(hazard),
            slot_wait_fraction: share(slot_wait),
            starved_fraction: share(starved),
            blocked_fraction: share(blocked),
            buffer_read_bytes: pixels_read * pixel_bytes,
            buffer_write_bytes: pixels_written * pixel_bytes,
            fragments: run.frame.pixels.iter().flatten().count() as u64,
            psnr_db: is_comparable.then_some(run.psnr_db),
            coverage_differences: differences.coverage,
            material_differences: differences.material,
            outcome_differences: differences.outcome,
            sum_differences: differences.sum,
            depth_test_differences: differences.depth_test,
            edge_differences: differences.edge,
            simulated_cycles_per_second: run.simulated_cycles_per_second,
        }
    }

    /// Why pixels differ by more than one rounding, in words.
    fn explanation(&self) -> String {
        let Self { outcome_differences, depth_test_differences, edge_differences, sum_differences, .. } = *self;
        if outcome_differences == 0 {
            return "0".to_owned();
        }
        let unexplained = outcome_differences - depth_test_differences - edge_differences - sum_differences;
        format!(
            "{outcome_differences}: in {depth_test_differences} the stored depth lies within rounding of an end of the ε-band, in \
             {edge_differences} a sample within rounding of its splat's edge, so that a test came out differently; in {sum_differences} \
             the sums were rounded, no test; {unexplained} are unexplained"
        )
    }

    /// The figures with their names, in words.
    #[must_use]
    pub fn rows(&self) -> Vec<(&'static str, String)> {
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let compared = match self.mismatches {
            Some(count) => format!("{count} mismatches, every output compared in every cycle"),
            None => "not compared".to_owned(),
        };
        let psnr = match self.psnr_db {
            Some(psnr_db) if psnr_db.is_finite() => format!("{psnr_db:.1} dB"),
            Some(_) => "the pictures are equal".to_owned(),
            None => "nothing to compare: both pictures are empty".to_owned(),
        };
        vec![
            ("engine", self.engine.clone()),
            ("lockstep", compared),
            ("image", format!("{} × {} px, {} fragments", self.width, self.height, self.fragments)),
            (
                "splats",
                format!("{}, {} of them drawn in {} tile copies", self.splats, self.fates.drawn, self.fates.copies),
            ),
            ("splats culled", self.fates.to_string()),
            ("cycles", self.cycles.to_string()),
            ("cycles per splat", format!("{:.2}", self.cycles_per_splat)),
            ("samples", format!("{} visited, {} of them inside their splat", self.samples, self.accumulated)),
            ("cycles per sample", format!("{:.3}", self.cycles_per_sample)),
            ("rasterizer busy", percent(self.rasterizer_utilisation)),
            ("rasterizer without work", percent(self.starved_fraction)),
            ("rasterizer held back", percent(self.blocked_fraction)),
            ("accumulator busy", percent(self.accumulator_utilisation)),
            ("accumulator waits for a pixel (hazard)", percent(self.hazard_fraction)),
            ("accumulator waits for a tile", percent(self.slot_wait_fraction)),
            ("reconstruction buffer read", format!("{} bytes", self.buffer_read_bytes)),
            ("reconstruction buffer written", format!("{} bytes", self.buffer_write_bytes)),
            ("PSNR against the f64 reference", psnr),
            ("pixels covered differently", self.coverage_differences.to_string()),
            ("pixels with another material", self.material_differences.to_string()),
            ("pixels that differ by more than one rounding", self.explanation()),
            ("simulation", format!("{:.0} cycles/s", self.simulated_cycles_per_second)),
        ]
    }

    /// The report as Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n\n| figure | value |\n|---|---|\n", self.scene);
        for (name, value) in self.rows() {
            _ = writeln!(text, "| {name} | {value} |");
        }
        text += "\n![frame](frame.png) ![reference](reference.png) ![difference](difference.png)\n\n";
        text +=
            "Frame, f64 reference, and their difference magnified 16 times. Rows named after the rasterizer and the ";
        text += "accumulator count cycles of the frame; waits overlap with each other across the two units.\n";
        text
    }
}
