//! What `run` leaves behind: pictures, numbers, and a report, of one frame or of a sequence.

use super::super::simulation::Engine;
use super::super::{Failure, write};
use pointcore::picture::{Animation, FloatImage};
use pointcore::shading;
use pointcore::splat::{Fates, RenderSession, RenderedFrame, SplatReport, SplatRun};
use serde::Serialize;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::Path;

/// How much difference.png magnifies.
const MAGNIFICATION: f64 = 16.0;

/// The figures of a frame of a sequence.
#[derive(Serialize)]
struct FrameFigures {
    cycles: u64,
    fates: Fates,
    samples: u64,
    accumulated: u64,
    fragments: u64,
    mismatches: Option<u64>,
    psnr_db: Option<f64>,
}

/// The report as JSON: the first frame's figures, and beside them those of all.
#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    report: &'a SplatReport,
    notes: &'a [String],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    sequence: &'a [FrameFigures],
}

/// What is printed of all frames.
pub struct Summary {
    /// The fragments of all.
    pub fragments: u64,
    /// For programs.
    pub document: Value,
    /// For people.
    pub text: String,
}

/// Results of frames so far.
pub struct FrameResults<'a> {
    name: &'a str,
    folder: &'a Path,
    /// Where the folder's files will lie.
    place: &'a Path,
    engine: Engine,
    animation: Option<Animation>,
    /// The first frame's.
    report: Option<SplatReport>,
    frames: Vec<FrameFigures>,
}

impl<'a> FrameResults<'a> {
    /// Nothing so far, of a session's frames.
    pub fn new(
        session: &RenderSession,
        name: &'a str,
        (folder, place): (&'a Path, &'a Path),
        engine: Engine,
    ) -> Result<Self, Failure> {
        let animation = if session.frames() > 1 {
            let frames = folder.join("frames");
            std::fs::create_dir_all(&frames).map_err(|source| Failure::Write { path: frames, source })?;
            let [width, height] = shading::picture_size(session.scene());
            Some(Animation::create(&folder.join("animation.png"), [width, height], session.frames())?)
        } else {
            None
        };
        Ok(Self { name, folder, place, engine, animation, report: None, frames: Vec::new() })
    }

    /// Adds the next frame, which the session has just rendered.
    pub fn add(&mut self, session: &RenderSession, frame: &RenderedFrame) -> Result<(), Failure> {
        let reference = session.reference();
        let reference_picture = shading::picture(&reference, session.scene());
        let report = SplatReport::new(&SplatRun {
            scene: self.name,
            engine: self.engine.name(),
            config: &session.plan().config,
            fates: frame.fates,
            counters: &frame.outcome.counters,
            frame: &frame.samples,
            reference: &reference,
            psnr_db: frame.picture.psnr_db(&reference_picture),
            mismatches: self.engine.mismatches(),
            simulated_cycles_per_second: frame.outcome.simulated_cycles as f64 / frame.outcome.elapsed.as_secs_f64(),
        });
        if let Some(animation) = &mut self.animation {
            let name = format!("frames/{:04}.png", self.frames.len());
            frame.picture.save_png(&self.folder.join(name))?;
            animation.push(&frame.picture)?;
        }
        self.frames.push(FrameFigures {
            cycles: report.cycles,
            fates: report.fates,
            samples: report.samples,
            accumulated: report.accumulated,
            fragments: report.fragments,
            mismatches: report.mismatches,
            psnr_db: report.psnr_db,
        });
        if self.report.is_none() {
            let save = |name: &str| self.folder.join(name);
            frame.picture.save_png(&save("frame.png"))?;
            reference_picture.save_png(&save("reference.png"))?;
            frame.picture.difference(&reference_picture, MAGNIFICATION).save_png(&save("difference.png"))?;
            self.report = Some(report);
        }
        Ok(())
    }

    /// Writes what a frame's fragments say besides their color.
    pub fn write_numbers(
        &self,
        session: &RenderSession,
        frame: &RenderedFrame,
        has_depth: bool,
        has_normals: bool,
    ) -> Result<(), Failure> {
        let (width, count) = (frame.samples.width, frame.samples.pixels.len());
        let place = |column: usize, row: usize| row * width + column;
        if has_depth {
            let mut image = FloatImage { width, pixels: vec![[f32::INFINITY]; count] };
            for fragment in &frame.fragments {
                image.pixels[place(fragment.column, fragment.row)] = [fragment.depth as f32];
            }
            image.save_pfm(&self.folder.join("depth.pfm"))?;
        }
        if has_normals {
            if !session.scene().is_lit() {
                return Err(Failure::Usage("--normals: a scene without `light.diffuse` carries none".to_owned()));
            }
            let mut image = FloatImage { width, pixels: vec![[0.0; 3]; count] };
            for fragment in &frame.fragments {
                image.pixels[place(fragment.column, fragment.row)] = fragment.normal;
            }
            image.save_pfm(&self.folder.join("normals.pfm"))?;
        }
        Ok(())
    }

    /// Writes the report; returns what is to be printed.
    pub fn finish(self, session: &RenderSession) -> Result<Summary, Failure> {
        let fragments = self.frames.iter().map(|frame| frame.fragments).sum();
        let is_sequence = self.animation.is_some();
        self.animation.map_or(Ok(()), Animation::finish)?;
        let report = self.report.expect("a session has one frame at least");
        let notes = &session.scene().notes;
        let mut markdown = report.markdown();
        if is_sequence {
            markdown += &table(&self.frames);
        }
        if !notes.is_empty() {
            markdown += "\n## To be known\n\n";
            notes.iter().for_each(|note| _ = writeln!(markdown, "- {note}"));
        }
        let sequence = if is_sequence { &self.frames[..] } else { &[] };
        let document = Document { report: &report, notes, sequence };
        write(&self.folder.join("report.md"), &markdown)?;
        let text = serde_json::to_string_pretty(&document).expect("reports have string keys");
        write(&self.folder.join("report.json"), &text)?;
        let shown = self.place.join(if is_sequence { "animation.png" } else { "frame.png" });
        let text = format!("{markdown}\nWritten to {}: {}", self.place.display(), shown.display());
        Ok(Summary { fragments, document: json!(document), text })
    }
}

/// The figures of a sequence's frames.
fn table(frames: &[FrameFigures]) -> String {
    let mut text =
        "\n## The sequence\n\n![animation](animation.png)\n\n| frame | cycles | drawn | culled | samples | inside | \
                    fragments | PSNR |\n|---|---|---|---|---|---|---|---|\n"
            .to_owned();
    for (index, frame) in frames.iter().enumerate() {
        let psnr = frame.psnr_db.map_or("–".to_owned(), |psnr_db| format!("{psnr_db:.1} dB"));
        let FrameFigures { cycles, fates, samples, accumulated, fragments, .. } = frame;
        let (drawn, culled) = (fates.drawn, fates.culled());
        _ = writeln!(
            text,
            "| {index} | {cycles} | {drawn} | {culled} | {samples} | {accumulated} | {fragments} | {psnr} |"
        );
    }
    text
}
