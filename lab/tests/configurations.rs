//! README's table of the named configurations is what the models and the record of areas say.

use pointcore_lab::bench::configurations::tabulate;
use std::path::Path;

/// Set, this environment variable has README written instead of compared.
const WRITE: &str = "POINTCORE_WRITE";

#[test]
fn readme_has_the_cycles_and_areas_of_every_named_configuration() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let path = root.join("README.md");
    let page = std::fs::read_to_string(&path).expect("README is there");
    let expected = tabulate(&root, &page).unwrap_or_else(|error| panic!("{error}"));
    if std::env::var_os(WRITE).is_some() {
        std::fs::write(&path, expected).expect("README is writable");
        return;
    }
    assert!(page == expected, "README's table is old: {WRITE}=1 cargo test -p pointcore-lab --test lab readme");
}

#[test]
fn readme_names_every_configuration() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = std::fs::read_to_string(root.join("README.md")).expect("README is there");
    for file in std::fs::read_dir(root.join("configs")).expect("the folder is there") {
        let name = file.expect("the folder is readable").file_name().into_string().expect("names are ASCII");
        assert!(page.contains(&format!("](configs/{name})")), "{name} is missing");
    }
}
