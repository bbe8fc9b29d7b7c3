//! Hashes the sources that decide what a frame looks like and how long it takes, so that results kept on disk are used only by programs
//! that would come to the same.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// Folders and files below the workspace's root that decide what a point of a sweep comes to.
const MODEL: &[&str] = &[
    "contract/src",
    "golden/src",
    "hdl/src",
    "lab/src/accuracy/figures.rs",
    "lab/src/accuracy/measure.rs",
    "pointcore/src/splat",
    "pointcore/src/color.rs",
    "pointcore/src/number.rs",
    "pointcore/src/picture.rs",
    "pointcore/src/plan",
    "pointcore/src/scene",
    "pointcore/src/shading.rs",
    "pointcore/src/uniforms.rs",
];
/// Those that decide what a case of the soak comes to.
const SOAK: &[&str] = &[
    "contract/src",
    "golden/src",
    "hdl/src",
    "lab/src/soak",
    "lab/src/stability/families.rs",
    "lab/src/stability/frames.rs",
    "pointcore/src/number.rs",
    "pointcore/src/splat/mask.rs",
    "pointcore/src/splat/memory.rs",
    "pointcore/src/stimuli",
    "rtl/src",
    "tb/src/lockstep",
    "tb/src/verilated",
];

/// All files of a folder, or the file itself.
fn files(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path.to_owned()];
    }
    let entries = fs::read_dir(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut files: Vec<_> = entries.flat_map(|entry| files(&entry.expect("a folder's entry").path())).collect();
    files.sort();
    files
}

/// A hash of all files of the sources; another compiler may come to another one, and results are then measured again.
fn hash(sources: &[&str]) -> u64 {
    let mut hash = DefaultHasher::new();
    for source in sources {
        println!("cargo::rerun-if-changed=../{source}");
        for path in files(&Path::new("..").join(source)) {
            let text = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            (path, text).hash(&mut hash);
        }
    }
    hash.finish()
}

fn main() {
    println!("cargo::rustc-env=POINTCORE_MODEL_SOURCES={:016x}", hash(MODEL));
    println!("cargo::rustc-env=POINTCORE_SOAK_SOURCES={:016x}", hash(SOAK));
}
