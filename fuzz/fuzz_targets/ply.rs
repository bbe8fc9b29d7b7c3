//! Any bytes as a PLY file are a model or an error, never a panic.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pointcore::scene::{Model, NormalSource};

fuzz_target!(|bytes: &[u8]| {
    let file = tempfile::Builder::new().suffix(".ply").tempfile().expect("there is room for a file");
    std::fs::write(file.path(), bytes).expect("there is room for a file");
    if let Ok(model) = Model::load(file.path()) {
        _ = model.unit_normals(NormalSource::Auto);
    }
});
