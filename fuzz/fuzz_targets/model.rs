//! Any bytes as a file of any format of points are a model or an error, never a panic.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pointcore::scene::{InvalidPoints, Model, NormalSource};

/// Formats besides PLY and OBJ, which have targets of their own; the first byte chooses.
const SUFFIXES: [&str; 6] = [".gltf", ".glb", ".pcd", ".las", ".laz", ".xyz"];

fuzz_target!(|bytes: &[u8]| {
    let Some((choice, bytes)) = bytes.split_first() else { return };
    let suffix = SUFFIXES[usize::from(*choice) % SUFFIXES.len()];
    let file = tempfile::Builder::new().suffix(suffix).tempfile().expect("there is room for a file");
    std::fs::write(file.path(), bytes).expect("there is room for a file");
    if let Ok(model) = Model::load_with(file.path(), InvalidPoints::Drop) {
        _ = model.unit_normals(NormalSource::Auto);
    }
});
