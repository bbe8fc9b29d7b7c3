//! `pointcore run` of a scene that moves while the shutter is open: pictures, figures and a page, as of a still one.

use super::super::progress::{with_progress, with_spinner};
use super::super::results::Results;
use super::super::simulation::Engine;
use super::super::{Failure, Output, generate, scene_name, waveform, write};
use super::results::{compared, save_pictures, to_be_known};
use super::{Arguments, GENERATING, OPTIONAL, WAVEFORM};
use pointcore::exposure::is_blank;
use pointcore::package::Package;
use pointcore::plan::MovingPlan;
use pointcore::scene::Scene;
use pointcore::shading;
use pointcore::splat::memory::ReconstructionBuffer;
use pointcore::splat::{Drawn, ExposedFrame, FramePictures, MovingSession, RunPage, SplatReport, SplatRun, StillPart};
use pointcore::waveform::splat_view;
use serde::Serialize;
use serde_json::json;
use std::path::Path;

/// The report as JSON: figures of what moves, and beside them those of what stands still.
#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    report: &'a SplatReport,
    still: Option<&'a SplatReport>,
    notes: &'a [String],
}

/// The figures of what moves, beside the whole picture's reference.
fn moving_report(
    name: &str,
    engine: Engine,
    session: &MovingSession,
    frame: &ExposedFrame,
) -> (SplatReport, FramePictures) {
    let reference = with_spinner("exposing in f64", || session.reference());
    let pictures =
        FramePictures { frame: frame.picture.clone(), reference: shading::exposed(&reference, session.scene()) };
    let fragments = frame.outcome.fragments.len() as u64;
    let report = SplatReport::new(&SplatRun {
        scene: name,
        engine: engine.name(),
        config: &session.plan().config,
        memory: *session.memory(),
        fates: frame.fates,
        outcome: &frame.outcome,
        drawn: Drawn::Exposure { exposure: &frame.exposure, reference: &reference, fragments },
        psnr_db: pictures.frame.psnr_db(&pictures.reference),
        mismatches: engine.mismatches(),
    });
    (report, pictures)
}

/// Renders a scene on the hardware of a plan.
pub(super) fn run(arguments: &Arguments, scene: Scene, plan: MovingPlan, output: Output) -> Result<(), Failure> {
    if arguments.depth || arguments.normals {
        let problem = "a scene that moves shows several surfaces in a sample, each for a part of the exposure: leave out --depth and --normals";
        return Err(Failure::Usage(format!("{}: {problem}", arguments.scene.display())));
    }
    let (name, engine) = (scene_name(&arguments.scene), arguments.engine());
    let place = arguments.place(&name);
    let results = Results::begin(&place)?;
    let folder = results.folder();

    let session = with_spinner(GENERATING, || MovingSession::on(scene, plan, engine.into(), arguments.trace()))?;
    let mut session = session
        .behind(arguments.memory.settings(ReconstructionBuffer::SETTINGS))?
        .randomized(arguments.simulation.stall(), arguments.seed);
    write_verilog(&name, &session, &folder.join("verilog"))?;
    let wave = arguments.simulation.waveform(folder.join(WAVEFORM));
    let frame = with_progress(engine.name(), |progress| session.frame_with(progress, wave.as_ref()))?;
    if arguments.simulation.is_traced() {
        waveform::finish(arguments.simulation.trace_window.as_ref(), frame.outcome.simulated_cycles)?;
        waveform::write_view(&splat_view(&session.plan().config), WAVEFORM, folder, &place)?;
    }

    let (report, pictures) = moving_report(&name, engine, &session, &frame);
    save_pictures(&pictures, folder)?;
    let parts = session.still().zip(frame.still.as_ref());
    // As if nothing else were there.
    let still = parts
        .map(|(session, frame)| StillPart { report: compared(&name, engine, session, frame).0, plan: session.plan() });
    let notes = &session.scene().notes;
    let mut markdown = report.markdown();
    if let Some(StillPart { report, .. }) = &still {
        markdown += "\n## What stands still\n\nAnother core draws it, and the host lays it behind what moves.\n\n";
        markdown += &report.table();
    }
    markdown += &to_be_known(notes);
    write(&folder.join("report.md"), &markdown)?;
    let document = Document { report: &report, still: still.as_ref().map(|still| &still.report), notes };
    let text = serde_json::to_string_pretty(&document).expect("reports have string keys");
    write(&folder.join("report.json"), &text)?;
    let page = RunPage {
        report: &report,
        pictures: &pictures,
        activity: &frame.outcome.activity,
        plan: session.plan(),
        still: still.as_ref(),
        notes,
        sequence: &[],
        animation: None,
    };
    write(&folder.join("index.html"), &page.html())?;
    results.finish(&OPTIONAL)?;
    let shown = place.join("frame.png");
    output.print(
        &json!(document),
        &format!("{markdown}\nWritten to {}: {}; index.html tells more", place.display(), shown.display()),
    )?;
    if is_blank(&frame.exposure) {
        let fates = frame.still.map_or(frame.fates, |still| frame.fates.sum(still.fates));
        return Err(Failure::Blank { path: arguments.scene.clone(), fates });
    }
    Ok(())
}

/// Both cores, that of what stands still in a folder of its own.
fn write_verilog(name: &str, session: &MovingSession, folder: &Path) -> Result<(), Failure> {
    let package = Package::splat(name, session.core(), &session.plan().config)?;
    generate::write_package(&package, folder)?;
    if let Some(still) = session.still() {
        let name = format!("{name}_{}", generate::STILL);
        let package = Package::splat(&name, still.core(), &still.plan().config)?;
        generate::write_package(&package, &folder.join(generate::STILL))?;
    }
    Ok(())
}
