//! `pointcore run --model reference`: a frame in f64, still or with what moves while the shutter is open.

use super::super::progress::with_count;
use super::super::results::Results;
use super::super::{Failure, Output, Renderer, plan_on, scene_name};
use super::Arguments;
use pointcore::exposure;
use pointcore::picture::Picture;
use pointcore::scene::{Motion, Scene};
use pointcore::shading;
use pointcore_golden::reference::Mapping;
use serde_json::{Value, json};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// What is written.
const PICTURE: &str = "reference.png";

/// Renders a scene's first frame by the f64 reference alone.
pub(super) fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let path = &arguments.scene;
    let renderer = arguments.config.as_deref().map(Renderer::read).transpose()?;
    let scene = Scene::load(path, &arguments.settings())?;
    let place = arguments.place(&scene_name(path));
    let mut document = json!({ "scene": scene_name(path), "reference": place.join(PICTURE) });
    let (picture, said) = match &scene.motion {
        Some(motion) => {
            let (picture, about) = exposed(&scene, motion, arguments.samples_in_time);
            let said = format!(" ({})", about["method"].as_str().unwrap_or_default());
            document["motion"] = about;
            (picture, said)
        }
        None if arguments.samples_in_time.is_some() => {
            let problem = "goes with a scene that moves, with `[shutter]` and `motion` tables; here nothing moves";
            return Err(Failure::Usage(format!("{}: --samples-in-time {problem}", path.display())));
        }
        None => {
            // Configuration and overrides are held against the scene, as where it is rendered on hardware.
            plan_on(path, &scene, renderer.as_ref())?;
            let frame = pointcore::splat::reference(&scene, Mapping::Backward);
            let is_blank = frame.pixels.iter().flatten().next().is_none();
            ((!is_blank).then(|| shading::picture(&frame, &scene)), String::new())
        }
    };
    let Some(picture) = picture else {
        let problem =
            format!("nothing is drawn of its {} splats: `camera.fit = true` has a camera see them", scene.splats.len());
        return Err(Failure::Usage(format!("{}: {problem}", path.display())));
    };
    let results = Results::begin(&place)?;
    picture.save_png(&results.folder().join(PICTURE))?;
    results.finish(&[])?;
    output.print(&document, &format!("{}{said}", place.join(PICTURE).display()))
}

/// The picture of a moving scene, unless it is blank, and how it came about.
fn exposed(scene: &Scene, motion: &Motion, samples_in_time: Option<usize>) -> (Option<Picture>, Value) {
    let begin = Instant::now();
    let moving = scene.moving_splats();
    let done = AtomicU64::new(0);
    let total = samples_in_time.unwrap_or(scene.rendering.height) as u64;
    let exposure = with_count("exposing", total, |progress| {
        let step = || progress(done.fetch_add(1, Ordering::Relaxed) + 1);
        match samples_in_time {
            Some(count) => exposure::by_samples(scene, count, &step),
            None => exposure::by_method(scene, &moving, motion.reference_method(), &step),
        }
    });
    let method = samples_in_time
        .map_or_else(|| motion.reference_method().to_string(), |count| format!("{count} samples in time"));
    let about = json!({
        "method": method,
        "splats": scene.splats.len(),
        "parts": moving.len(),
        "coverage": exposure.samples.iter().map(|sample| sample.coverage).sum::<f64>() / exposure.samples.len() as f64,
        "seconds": begin.elapsed().as_secs_f64(),
    });
    ((!exposure::is_blank(&exposure)).then(|| shading::exposed(&exposure, scene)), about)
}
