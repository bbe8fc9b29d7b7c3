//! Motion blur: how far each method's picture is from the mean of many still frames, the truth, and how many still frames err as little.

use crate::accuracy::figures::{PSNR_MAX_DB, perceived};
use crate::{Figures, LabError, note, write};
use pointcore::exposure::{by_method, by_samples};
use pointcore::picture::Picture;
use pointcore::scene::{Scene, SceneError};
use pointcore::shading;
use pointcore::splat::{MovingSession, RenderEngine, RenderSession};
use pointcore_golden::reference::motion::Method;
use pointcore_golden::reference::{Mapping, render};
use pointcore_tb::cache::file;
use rayon::prelude::*;
use std::path::Path;
use std::time::Instant;

/// The shipped scenes that move, in `scenes/motion/`.
const SCENES: [&str; 5] = ["translation", "rotation", "uncover", "ends", "spin"];
/// What is measured.
const METHODS: [Method; 9] = [
    Method::Exact,
    Method::Bins(1),
    Method::Bins(2),
    Method::Bins(4),
    Method::Bins(8),
    Method::Passes(1),
    Method::Passes(2),
    Method::Passes(4),
    Method::Passes(8),
];
/// What a strip shows, from left to right, behind the truth and before what hardware with the most bins draws.
const SHOWN: [Method; 5] = [Method::Exact, Method::Bins(2), Method::Bins(4), Method::Bins(8), Method::Passes(1)];
/// Samples in time of the truth.
const TRUE_SAMPLES: usize = 256;
/// How many samples in time are tried, from the fewest up, until they err as little as a method.
const LADDER: [usize; 14] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128];
/// Bins of hardware that is measured beside f64.
const HARDWARE_BINS: [usize; 3] = [2, 4, 8];
/// How much differences are magnified.
const MAGNIFICATION: f64 = 4.0;

const HEAD: &str = "| scene | | exact | bins:1 | bins:2 | bins:4 | bins:8 | gpu:1 | gpu:2 | gpu:4 | gpu:8 |\n|---|---|---|---|---|---|---|---|---|---|---|\n";

const HARDWARE_HEAD: &str = "| scene | bins | PSNR, dB | FLIP | cycles | cycles a sample | still frames that err as little | their cycles | times those of bins |\n|---|---|---|---|---|---|---|---|---|\n";

/// A picture beside the truth.
struct Measured {
    psnr_db: f64,
    flip: f64,
    seconds: f64,
    picture: Picture,
}

impl Measured {
    fn new(truth: &Picture, draw: impl FnOnce() -> Picture) -> Self {
        let begin = Instant::now();
        let picture = draw();
        let seconds = begin.elapsed().as_secs_f64();
        let psnr_db = picture.psnr_db(truth).min(PSNR_MAX_DB);
        Self { psnr_db, flip: perceived(&picture, truth), seconds, picture }
    }
}

/// A method as a part of a figure's key.
fn key(method: Method) -> String {
    method.to_string().replace(':', "_")
}

/// Measures every scene; a table and a strip of pictures each go to `folder`.
///
/// # Errors
/// A scene cannot be loaded, or the folder not be written.
pub fn figures(folder: &Path, figures: &mut Figures) -> Result<(), LabError> {
    let (mut table, mut on_hardware) = (HEAD.to_owned(), HARDWARE_HEAD.to_owned());
    for name in SCENES {
        let scene = match Scene::load(&Path::new("scenes/motion").join(name).with_extension("toml"), &[]) {
            Ok(scene) => scene,
            // Models need not be there: some are not part of the project.
            Err(SceneError::Value { key, problem, .. }) if key.ends_with(".path") => {
                note!("{name} is left out: {problem}");
                continue;
            }
            Err(error) => return Err(error.into()),
        };
        note!("{name}: the truth from {TRUE_SAMPLES} samples in time");
        let supersampled = |count: usize| shading::exposed(&by_samples(&scene, count, &|| ()), &scene);
        let truth = supersampled(TRUE_SAMPLES);
        let ladder: Vec<_> = LADDER.iter().map(|&count| Measured::new(&truth, || supersampled(count))).collect();
        for (count, measured) in LADDER.iter().zip(&ladder) {
            figures.insert(format!("motion.{name}.psnr_db.samples_{count}"), measured.psnr_db.into());
            figures.insert(format!("motion.{name}.flip.samples_{count}"), measured.flip.into());
        }
        let methods = METHODS.map(|method| {
            note!("{name}: {method}");
            Measured::new(&truth, || {
                shading::exposed(&by_method(&scene, &scene.moving_splats(), method, &|| ()), &scene)
            })
        });
        let equal_samples = |measured: &Measured| {
            ladder.iter().position(|samples| samples.psnr_db >= measured.psnr_db).map(|index| LADDER[index])
        };
        let equal: Vec<_> = methods.iter().map(equal_samples).collect();
        for ((method, measured), equal) in METHODS.iter().zip(&methods).zip(&equal) {
            let method = key(*method);
            figures.insert(format!("motion.{name}.psnr_db.{method}"), measured.psnr_db.into());
            figures.insert(format!("motion.{name}.flip.{method}"), measured.flip.into());
            figures.insert(format!("motion.{name}.seconds.{method}"), measured.seconds.into());
            if let Some(count) = equal {
                figures.insert(format!("motion.{name}.equal_samples.{method}"), (*count).into());
            }
        }
        let row = |what: &str, cell: &dyn Fn(usize) -> String| {
            let cells: Vec<_> = (0..METHODS.len()).map(cell).collect();
            format!("| {} | {what} | {} |\n", if what == "PSNR, dB" { name } else { "" }, cells.join(" | "))
        };
        table += &row("PSNR, dB", &|index| format!("{:.1}", methods[index].psnr_db));
        table += &row("FLIP", &|index| format!("{:.4}", methods[index].flip));
        table += &row("samples that err as little", &|index| {
            equal[index].map_or_else(|| format!("> {}", LADDER[LADDER.len() - 1]), |count| count.to_string())
        });
        note!("{name}: hardware");
        let still = still_cycles(&scene)?;
        figures.insert(format!("motion.{name}.cycles.still"), still.into());
        let runs = HARDWARE_BINS.par_iter().map(|&bins| exposed(&scene, bins)).collect::<Result<Vec<_>, LabError>>()?;
        let mut drawn = Vec::new();
        for (bins, run) in HARDWARE_BINS.iter().zip(runs) {
            let Run { picture, cycles, bins_cycles, samples } = run;
            let measured = Measured::new(&truth, || picture);
            let equal = equal_samples(&measured);
            let mut insert = |what: &str, value: serde_json::Value| {
                _ = figures.insert(format!("motion.{name}.{what}.hardware_{bins}"), value);
            };
            insert("psnr_db", measured.psnr_db.into());
            insert("flip", measured.flip.into());
            insert("cycles", cycles.into());
            insert("cycles_a_sample", (bins_cycles as f64 / samples as f64).into());
            let frames = equal.map(|count| (count, count as u64 * still));
            if let Some((count, supersampled)) = frames {
                insert("equal_samples", count.into());
                insert("supersample.cycles", supersampled.into());
            }
            let [count, supersampled, times] =
                frames.map_or(["–".to_owned(), "–".to_owned(), "–".to_owned()], |(count, supersampled)| {
                    [count.to_string(), supersampled.to_string(), format!("{:.2}", supersampled as f64 / cycles as f64)]
                });
            on_hardware += &format!(
                "| {} | {bins} | {:.1} | {:.4} | {cycles} | {:.2} | {count} | {supersampled} | {times} |\n",
                if *bins == HARDWARE_BINS[0] { name } else { "" },
                measured.psnr_db,
                measured.flip,
                bins_cycles as f64 / samples as f64,
            );
            drawn.push(measured.picture);
        }
        // The table so far, which makes the folder, too.
        write(&folder.join("README.md"), &format!("{table}\n{on_hardware}"))?;
        let shown = SHOWN.iter().filter_map(|method| METHODS.iter().position(|other| other == method));
        let shown: Vec<_> = shown.map(|index| &methods[index].picture).chain(drawn.last()).collect();
        save_strip(&scene, &truth, &shown, &folder.join(format!("motion_{name}.png")))?;
    }
    Ok(())
}

/// A scene on the golden models of its hardware.
struct Run {
    picture: Picture,
    /// Of both cores, one after the other.
    cycles: u64,
    /// Of the one with bins of the exposure.
    bins_cycles: u64,
    /// That it evaluates.
    samples: u64,
}

/// What hardware exposes that has so many bins.
fn exposed(scene: &Scene, bins: usize) -> Result<Run, LabError> {
    let mut scene = scene.clone();
    if let Some(motion) = &mut scene.motion {
        motion.method = Some(Method::Bins(bins));
    }
    let mut session = MovingSession::open(scene, RenderEngine::Golden)?;
    let frame = session.frame()?;
    let counters = &frame.outcome.counters;
    let still = frame.still.map_or(0, |still| still.outcome.counters.cycles);
    let (cycles, bins_cycles) = (counters.cycles + still, counters.cycles);
    Ok(Run { picture: frame.picture, cycles, bins_cycles, samples: counters.events.sample })
}

/// Cycles of a still frame of all splats, from the middle of the exposure.
fn still_cycles(scene: &Scene) -> Result<u64, LabError> {
    let still = Scene { motion: None, ..scene.clone() };
    Ok(RenderSession::open(still, RenderEngine::Golden)?.frame(0)?.outcome.counters.cycles)
}

/// Above, the truth and pictures to be shown beside it; below, the still picture of the middle of the exposure, and their differences from the truth.
fn save_strip(scene: &Scene, truth: &Picture, shown: &[&Picture], path: &Path) -> Result<(), LabError> {
    let frame = render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward);
    let above: Vec<_> = std::iter::once(truth).chain(shown.iter().copied()).cloned().collect();
    let differences = shown.iter().map(|picture| picture.difference(truth, MAGNIFICATION));
    let below: Vec<_> = std::iter::once(shading::picture(&frame, scene)).chain(differences).collect();
    let (width, height) = (truth.width, truth.height);
    let rows = [above, below].into_iter().flat_map(|pictures| {
        (0..height).flat_map(move |row| {
            let pixels = |picture: &Picture| picture.pixels[row * width..(row + 1) * width].to_vec();
            pictures.iter().flat_map(pixels).collect::<Vec<_>>()
        })
    });
    let strip = Picture { width: width * (1 + shown.len()), height: 2 * height, pixels: rows.collect() };
    save_small(&strip, path)
}

/// Writes a PNG as small as it gets, for it goes with the documents.
fn save_small(picture: &Picture, path: &Path) -> Result<(), LabError> {
    let written = || -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, picture.width as u32, picture.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&picture.bytes())?;
        writer.finish()?;
        Ok(bytes)
    };
    let bytes = written().map_err(std::io::Error::other);
    Ok(bytes.and_then(|bytes| std::fs::write(path, bytes)).map_err(file("write", path))?)
}
