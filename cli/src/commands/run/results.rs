//! What `run` leaves behind: pictures, numbers, and a report, of one frame or of a sequence.

use super::super::simulation::Engine;
use super::super::{Failure, write};
use pointcore::picture::{Animation, FloatImage};
use pointcore::shading;
use pointcore::splat::activity::Activity;
use pointcore::splat::{
    Drawn, FrameFigures, FramePictures, RenderSession, RenderedFrame, RunPage, SplatReport, SplatRun,
};
use serde::Serialize;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::Path;

/// How much difference.png magnifies.
const MAGNIFICATION: f64 = 16.0;
/// All frames of a sequence.
const ANIMATION: &str = "animation.png";

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

/// What report and page tell of the first frame.
struct FirstFrame {
    report: SplatReport,
    pictures: FramePictures,
    activity: Activity,
}

/// Results of frames so far.
pub struct FrameResults<'a> {
    name: &'a str,
    folder: &'a Path,
    /// Where the folder's files will lie.
    place: &'a Path,
    engine: Engine,
    animation: Option<Animation>,
    first: Option<FirstFrame>,
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
            Some(Animation::create(&folder.join(ANIMATION), [width, height], session.frames())?)
        } else {
            None
        };
        Ok(Self { name, folder, place, engine, animation, first: None, frames: Vec::new() })
    }

    /// Adds the next frame, which the session has just rendered.
    pub fn add(&mut self, session: &RenderSession, frame: &RenderedFrame) -> Result<(), Failure> {
        let (report, pictures) = compared(self.name, self.engine, session, frame);
        if let Some(animation) = &mut self.animation {
            let name = format!("frames/{:04}.png", self.frames.len());
            frame.picture.save_png(&self.folder.join(name))?;
            animation.push(&frame.picture)?;
        }
        self.frames.push(FrameFigures::of(&report));
        if self.first.is_none() {
            save_pictures(&pictures, self.folder)?;
            self.first = Some(FirstFrame { report, pictures, activity: frame.outcome.activity.clone() });
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

    /// Writes report and page; returns what is to be printed.
    pub fn finish(self, session: &RenderSession) -> Result<Summary, Failure> {
        let fragments = self.frames.iter().map(|frame| frame.fragments).sum();
        let is_sequence = self.animation.is_some();
        self.animation.map_or(Ok(()), Animation::finish)?;
        let FirstFrame { report, pictures, activity } = self.first.expect("a session has one frame at least");
        let notes = &session.scene().notes;
        let mut markdown = report.markdown();
        if is_sequence {
            markdown += &table(&self.frames);
        }
        markdown += &to_be_known(notes);
        let sequence = if is_sequence { &self.frames[..] } else { &[] };
        let document = Document { report: &report, notes, sequence };
        write(&self.folder.join("report.md"), &markdown)?;
        let text = serde_json::to_string_pretty(&document).expect("reports have string keys");
        write(&self.folder.join("report.json"), &text)?;
        let animation = if is_sequence { Some(read(&self.folder.join(ANIMATION))?) } else { None };
        let page = RunPage {
            report: &report,
            pictures: &pictures,
            activity: &activity,
            plan: session.plan(),
            still: None,
            notes,
            sequence,
            animation: animation.as_deref(),
        };
        write(&self.folder.join("index.html"), &page.html())?;
        let shown = self.place.join(if is_sequence { ANIMATION } else { "frame.png" });
        let text =
            format!("{markdown}\nWritten to {}: {}; index.html tells more", self.place.display(), shown.display());
        Ok(Summary { fragments, document: json!(document), text })
    }
}

/// A frame's figures and pictures beside the f64 reference.
pub(super) fn compared(
    name: &str,
    engine: Engine,
    session: &RenderSession,
    frame: &RenderedFrame,
) -> (SplatReport, FramePictures) {
    let reference = session.reference();
    let pictures =
        FramePictures { frame: frame.picture.clone(), reference: shading::picture(&reference, session.scene()) };
    let report = SplatReport::new(&SplatRun {
        scene: name,
        engine: engine.name(),
        config: &session.plan().config,
        memory: *session.memory(),
        fates: frame.fates,
        outcome: &frame.outcome,
        drawn: Drawn::Frame { frame: &frame.samples, reference: &reference },
        psnr_db: pictures.frame.psnr_db(&pictures.reference),
        mismatches: engine.mismatches(),
    });
    (report, pictures)
}

/// What is to be known of a scene, as a section in Markdown.
pub(super) fn to_be_known(notes: &[String]) -> String {
    let list: String = notes.iter().map(|note| format!("- {note}\n")).collect();
    if list.is_empty() { list } else { format!("\n## To be known\n\n{list}") }
}

/// Writes frame, reference and their difference.
pub(super) fn save_pictures(pictures: &FramePictures, folder: &Path) -> Result<(), Failure> {
    let FramePictures { frame, reference } = pictures;
    frame.save_png(&folder.join("frame.png"))?;
    reference.save_png(&folder.join("reference.png"))?;
    Ok(frame.difference(reference, MAGNIFICATION).save_png(&folder.join("difference.png"))?)
}

/// What was just written.
fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).map_err(|source| Failure::Write { path: path.to_owned(), source })
}

/// The figures of a sequence's frames.
fn table(frames: &[FrameFigures]) -> String {
    let heads = FrameFigures::HEADS.join(" | ");
    let rule = "|---".repeat(FrameFigures::HEADS.len() + 1);
    let mut text = format!("\n## The sequence\n\n![animation]({ANIMATION})\n\n| frame | {heads} |\n{rule}|\n");
    for (index, frame) in frames.iter().enumerate() {
        _ = writeln!(text, "| {index} | {} |", frame.cells().join(" | "));
    }
    text
}
