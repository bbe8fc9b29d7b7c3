//! What a run says: figures with their definitions, as JSON and as a page to read.

use super::bound::{FrameBound, bounds, sample_interval};
use super::depth_memory::DEPTH_BYTES;
use super::differences::Differences;
use super::fates::Fates;
use super::host::{EventCounts, SplatCounters};
use super::payload_memory::payload_word_bytes;
use super::run::SplatOutcome;
use crate::exposure::{Exposure, is_blank};
use crate::memory::MemorySettings;
use pointcore_contract::splat::{Config, records};
use pointcore_golden::reference::Frame;
use serde::Serialize;
use std::fmt::Write as _;

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
    /// Bins of the exposure in each sample; 0 where nothing moves.
    pub time_bins: u32,
    /// Cycles from the first splat to the end of the frame.
    pub cycles: u64,
    /// Cycles that every resource would take for the frame if it never waited.
    pub bounds: [FrameBound; 8],
    /// The one that takes most: no frame ends sooner.
    pub bound: FrameBound,
    /// The bound's share of the cycles.
    pub bound_fraction: f64,
    /// Cycles for each splat sent.
    pub cycles_per_splat: f64,
    /// Copies of splats, one for each tile that a splat touches.
    pub copies: u64,
    /// Cycles for each copy.
    pub cycles_per_copy: f64,
    /// Samples evaluated by the rasterizer.
    pub samples: u64,
    /// Cycles for each sample evaluated.
    pub cycles_per_sample: f64,
    /// Samples inside their splat, which reach the accumulator.
    pub accumulated: u64,
    /// Samples evaluated for each that is inside its splat.
    pub visited_ratio: f64,
    /// Samples inside their splat for each splat drawn.
    pub samples_per_splat: f64,
    /// Share of the image's samples, or of their bins of the exposure, that have a fragment.
    pub coverage: f64,
    /// Samples inside their splat for each fragment.
    pub overdraw: f64,
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
    /// Bytes that the memory moved for both, whole bursts.
    pub buffer_moved_bytes: u64,
    /// Bytes of payloads read from memory; none where they are on the chip, and in what follows.
    pub payload_read_bytes: u64,
    /// Bytes of payloads written to memory.
    pub payload_write_bytes: u64,
    /// Bytes that the memory moved for both, whole bursts.
    pub payload_moved_bytes: u64,
    /// Fragments that something nearer in memory hid, or samples of what moves; none without `merge`, and in what follows.
    pub hidden: u64,
    /// Bytes of depths read from memory.
    pub depth_read_bytes: u64,
    /// Bytes of depths written to memory.
    pub depth_write_bytes: u64,
    /// Bytes that the memory moved for both, whole bursts.
    pub depth_moved_bytes: u64,
    /// How the memory that holds the reconstruction buffer answers, and those of payloads and of depths.
    pub memory: MemorySettings,
    /// Fragments of the frame.
    pub fragments: u64,
    /// Peak signal-to-noise ratio of the shaded picture against the f64 reference; absent where neither shows a splat.
    pub psnr_db: Option<f64>,
    /// Pixels in which frame and reference differ; absent of an exposure, whose pixels are sums over time.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub differences: Option<Differences>,
    /// Cycles simulated in a second.
    pub simulated_cycles_per_second: f64,
}

/// What a run draws, beside the f64 reference.
#[derive(Clone, Copy)]
pub enum Drawn<'a> {
    /// Surfaces in samples.
    Frame {
        /// The frame.
        frame: &'a Frame,
        /// The f64 reference.
        reference: &'a Frame,
    },
    /// Light that comes in while the shutter is open.
    Exposure {
        /// Of hardware.
        exposure: &'a Exposure,
        /// Of the f64 reference.
        reference: &'a Exposure,
        /// What the hardware put out: a fragment for each bin of a sample in which anything moves.
        fragments: u64,
    },
}

impl Drawn<'_> {
    /// Samples in a row, and rows.
    fn size(&self) -> [usize; 2] {
        match self {
            Self::Frame { frame, .. } => [frame.width, frame.height],
            Self::Exposure { exposure, .. } => [exposure.width, exposure.height],
        }
    }

    fn fragments(&self) -> u64 {
        match self {
            Self::Frame { frame, .. } => frame.pixels.iter().flatten().count() as u64,
            Self::Exposure { fragments, .. } => *fragments,
        }
    }

    fn is_blank(&self) -> bool {
        match self {
            Self::Frame { frame, reference } => {
                [frame, reference].iter().all(|frame| frame.pixels.iter().all(Option::is_none))
            }
            Self::Exposure { exposure, reference, .. } => is_blank(exposure) && is_blank(reference),
        }
    }

    fn differences(&self, config: &Config) -> Option<Differences> {
        match self {
            Self::Frame { frame, reference } => Some(Differences::of(frame, reference, config)),
            Self::Exposure { .. } => None,
        }
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
    /// How the reconstruction buffer answered.
    pub memory: MemorySettings,
    /// What became of the splats sent.
    pub fates: Fates,
    /// What it brought.
    pub outcome: &'a SplatOutcome,
    /// What came of it.
    pub drawn: Drawn<'a>,
    /// Of the shaded pictures.
    pub psnr_db: f64,
    /// Outputs that differed, where they were compared.
    pub mismatches: Option<u64>,
}

impl SplatReport {
    /// Derives the figures.
    #[must_use]
    pub fn new(run: &SplatRun) -> Self {
        let SplatOutcome { ref counters, simulated_cycles, elapsed, .. } = *run.outcome;
        let SplatCounters { cycles, events, buffer, payloads, depths } = *counters;
        let EventCounts { sample: samples, starved, blocked, accumulate: accumulated, hazard, slot_wait, hidden } =
            events;
        let ratio = |count: u64, each: u64| count as f64 / each.max(1) as f64;
        let share = |count: u64| ratio(count, cycles * u64::from(run.config.rasterizers));
        let pixel_bytes = u64::from(records::pixel_bytes(run.config));
        let word_bytes = u64::from(payload_word_bytes(run.config));
        let bounds = bounds(run.config, &run.fates, counters);
        let bound = bounds.into_iter().max_by_key(|bound| bound.cycles).expect("a frame uses resources");
        let (fragments, [width, height]) = (run.drawn.fragments(), run.drawn.size());
        let places = (width * height) as u64 * u64::from(run.config.time_bins.max(1));
        let busy = samples * u64::from(sample_interval(run.config));
        let Fates { drawn, copies, .. } = run.fates;
        Self {
            scene: run.scene.to_owned(),
            engine: run.engine.to_owned(),
            splats: run.fates.total(),
            fates: run.fates,
            width: width as u32,
            height: height as u32,
            mismatches: run.mismatches,
            time_bins: run.config.time_bins,
            cycles,
            bounds,
            bound,
            bound_fraction: ratio(bound.cycles, cycles),
            cycles_per_splat: ratio(cycles, run.fates.total()),
            copies,
            cycles_per_copy: ratio(cycles, copies),
            samples,
            cycles_per_sample: ratio(cycles, samples),
            accumulated,
            visited_ratio: ratio(samples, accumulated),
            samples_per_splat: ratio(accumulated, drawn),
            coverage: ratio(fragments, places),
            overdraw: ratio(accumulated, fragments),
            rasterizer_utilisation: share(busy),
            accumulator_utilisation: share(accumulated),
            hazard_fraction: share(hazard),
            slot_wait_fraction: share(slot_wait),
            starved_fraction: share(starved),
            // A sample that takes several cycles is busy in all of them.
            blocked_fraction: share(blocked.saturating_sub(busy - samples)),
            buffer_read_bytes: buffer.read * pixel_bytes,
            buffer_write_bytes: buffer.written * pixel_bytes,
            buffer_moved_bytes: buffer.bytes,
            payload_read_bytes: payloads.read * word_bytes,
            payload_write_bytes: payloads.written * word_bytes,
            payload_moved_bytes: payloads.bytes,
            hidden,
            depth_read_bytes: depths.read * u64::from(DEPTH_BYTES),
            depth_write_bytes: depths.written * u64::from(DEPTH_BYTES),
            depth_moved_bytes: depths.bytes,
            memory: run.memory,
            fragments,
            psnr_db: (!run.drawn.is_blank()).then_some(run.psnr_db),
            differences: run.drawn.differences(run.config),
            simulated_cycles_per_second: simulated_cycles as f64 / elapsed.as_secs_f64(),
        }
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
        let counted = if self.time_bins > 0 { "bins of samples" } else { "samples" };
        let mut rows = vec![
            ("engine", self.engine.clone()),
            ("lockstep", compared),
            ("image", format!("{} × {} px, {} fragments", self.width, self.height, self.fragments)),
            (
                "splats",
                format!("{}, {} of them drawn in {} tile copies", self.splats, self.fates.drawn, self.fates.copies),
            ),
            ("splats culled", self.fates.to_string()),
            ("cycles", self.cycles.to_string()),
            ("bound", format!("{}: {} of the cycles", self.bound.name, percent(self.bound_fraction))),
            ("cycles per splat", format!("{:.2}", self.cycles_per_splat)),
            ("cycles per tile copy", format!("{:.2}", self.cycles_per_copy)),
            ("samples", format!("{} visited, {} of them inside their splat", self.samples, self.accumulated)),
            ("visited for each inside its splat", format!("{:.3}", self.visited_ratio)),
            ("inside for each splat drawn", format!("{:.2}", self.samples_per_splat)),
            ("coverage, overdraw", format!("{} of the {counted}, {:.2}", percent(self.coverage), self.overdraw)),
            ("cycles per sample", format!("{:.3}", self.cycles_per_sample)),
            ("rasterizer busy", percent(self.rasterizer_utilisation)),
            ("rasterizer without work", percent(self.starved_fraction)),
            ("rasterizer held back", percent(self.blocked_fraction)),
            ("accumulator busy", percent(self.accumulator_utilisation)),
            ("accumulator waits for a pixel (hazard)", percent(self.hazard_fraction)),
            ("accumulator waits for a tile", percent(self.slot_wait_fraction)),
            ("memory", self.memory_in_words()),
            ("reconstruction buffer read", format!("{} bytes", self.buffer_read_bytes)),
            ("reconstruction buffer written", format!("{} bytes", self.buffer_write_bytes)),
        ];
        if self.payload_moved_bytes > 0 {
            rows.push(("payloads read from memory", format!("{} bytes", self.payload_read_bytes)));
            rows.push(("payloads written to memory", format!("{} bytes", self.payload_write_bytes)));
        }
        if self.depth_moved_bytes > 0 {
            let moves = self.time_bins > 0;
            let what = if moves { "samples behind what stands still" } else { "fragments behind what was in memory" };
            rows.push((what, self.hidden.to_string()));
            rows.push(("depths read from memory", format!("{} bytes", self.depth_read_bytes)));
            if !moves {
                rows.push(("depths written to memory", format!("{} bytes", self.depth_write_bytes)));
            }
        }
        rows.push(("PSNR against the f64 reference", psnr));
        if let Some(differences) = &self.differences {
            rows.extend(differences.rows());
        }
        rows.push(("simulation", format!("{:.0} cycles/s", self.simulated_cycles_per_second)));
        rows
    }

    /// How the memory answers.
    fn memory_in_words(&self) -> String {
        let MemorySettings { latency_cycles, bytes_per_cycle, burst_bytes, .. } = self.memory;
        let bandwidth = match bytes_per_cycle {
            Some(bytes) => format!("{bytes} bytes a cycle for both ways"),
            None => "a pixel a cycle each way".to_owned(),
        };
        let bursts = match burst_bytes {
            1 => String::new(),
            bytes => {
                let moved = self.buffer_moved_bytes + self.payload_moved_bytes + self.depth_moved_bytes;
                format!(", in bursts of {bytes} bytes: {moved} bytes moved")
            }
        };
        format!("{latency_cycles} cycles latency, {bandwidth}{bursts}")
    }

    /// The figures as a table in Markdown.
    #[must_use]
    pub fn table(&self) -> String {
        let rows = self.rows().into_iter();
        rows.fold("| figure | value |\n|---|---|\n".to_owned(), |table, (name, value)| {
            table + &format!("| {name} | {value} |\n")
        })
    }

    /// The report as Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n\n{}", self.scene, self.table());
        text += "\n![frame](frame.png) ![reference](reference.png) ![difference](difference.png)\n\n";
        text +=
            "Frame, f64 reference, and their difference magnified 16 times. Rows named after the rasterizer and the ";
        text += "accumulator count cycles of the frame; waits overlap with each other across the two units.\n\n";
        text += "What the frame uses, and the cycles that this would take if it never waited; the largest is the frame's bound.\n\n";
        text += "| resource | cycles |\n|---|---|\n";
        for FrameBound { name, cycles } in &self.bounds {
            _ = writeln!(text, "| {name} | {cycles} |");
        }
        text
    }
}
