//! `include/pointcore.h` is what cbindgen makes of the sources.

use std::path::Path;

/// Set to write the header instead of comparing it.
const WRITE: &str = "POINTCORE_WRITE";

#[test]
fn the_header_is_that_of_the_sources() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(folder.join("cbindgen.toml")).expect("the settings are valid");
    let bindings = cbindgen::Builder::new().with_crate(folder).with_config(config).generate();
    let mut made = Vec::new();
    bindings.expect("the sources can be read").write(&mut made);
    let path = folder.join("include/pointcore.h");
    if std::env::var_os(WRITE).is_some() {
        std::fs::write(&path, &made).expect("the header can be written");
    }
    let found = std::fs::read(&path).expect("the header is there");
    assert!(found == made, "{} is old: {WRITE}=1 cargo test -p pointcore-c header", path.display());
}
