//! Any text as a scene file is a scene or an error, never a panic.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pointcore::plan::Plan;
use pointcore::scene::Scene;

/// Scenes with longer numbers than this would spend the time on splats.
const DIGITS: usize = 4;

fuzz_target!(|text: &str| {
    if text.split(|c: char| !c.is_ascii_digit()).any(|number| number.len() > DIGITS) {
        return;
    }
    let file = tempfile::Builder::new().suffix(".toml").tempfile().expect("there is room for a file");
    std::fs::write(file.path(), text).expect("there is room for a file");
    if let Ok(scene) = Scene::load(file.path(), &[]) {
        _ = Plan::of(&scene);
    }
});
