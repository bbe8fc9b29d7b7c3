//! Files that users hand in are read or refused with an error, whatever is in them: valid ones with bytes changed, taken out, put in.

use pointcore::plan::Plan;
use pointcore::scene::{Model, NormalSource, Scene};
use pointcore_spec::{core_a, core_b};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

const PLY: &str = "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                   property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\n\
                   end_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 9 9\n4 0 1 2 3\n";
const OBJ: &str = "# a triangle and a quadrilateral\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 1 1e-3\nvn 0 0 1\nf 1//1 2//1 3//1\nf -4 -3 -2 -1\n";
const SCENE: &str = "[camera]\neye = [0.0, 1.0, 4.0]\ntarget = [0.0, 0.0, 0.0]\nfov_degrees = 40.0\nnear = 1.0\nfar = 10.0\n[image]\nwidth = 16\nheight = 9\n[[material]]\nspecular = 0.1\n\
                     [[object]]\nkind = \"sphere\"\npoints = 50\nouter_radius = 1.0\ncolor = [0.5, 0.5, 0.5]\n[overrides]\nheap_levels = 5\n";
const CORE_A: &str = "width = 64\nheight = 64\ngeometry = \"f24-ftz\"\nattribute = \"f16\"\ncontinuous = 3\nculling = \"on\"\nkernel_gamma = 2.0\n";
const CORE_B: &str = "lanes = 4\nthreads = 8\nbucket = 16\nneighbors = 10\n";

/// One change at a place given as a share of the file.
#[derive(Clone, Debug)]
enum Change {
    Replace(f64, u8),
    Insert(f64, Vec<u8>),
    Remove(f64, usize),
    Repeat(f64, usize),
}

fn change() -> impl Strategy<Value = Change> {
    let pieces = ["-", "1e999", "nan", "inf", "0", "\n", " ", "[", "\"", "99999999999", "\0", "é"];
    let piece = prop::sample::select(pieces.to_vec()).prop_map(|piece| piece.as_bytes().to_vec());
    prop_oneof![
        (0.0..1.0, any::<u8>()).prop_map(|(place, byte)| Change::Replace(place, byte)),
        (0.0..1.0, piece).prop_map(|(place, piece)| Change::Insert(place, piece)),
        (0.0..1.0, 1_usize..12).prop_map(|(place, count)| Change::Remove(place, count)),
        (0.0..1.0, 1_usize..40).prop_map(|(place, count)| Change::Repeat(place, count)),
    ]
}

fn changed(text: &str, changes: &[Change]) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for change in changes {
        let place = |share: f64| (share * bytes.len() as f64) as usize;
        match change {
            Change::Replace(share, byte) => {
                let place = place(*share);
                if let Some(old) = bytes.get_mut(place) {
                    *old = *byte;
                }
            }
            Change::Insert(share, piece) => {
                let place = place(*share);
                bytes.splice(place..place, piece.iter().copied());
            }
            Change::Remove(share, count) => {
                let place = place(*share);
                bytes.drain(place..(place + count).min(bytes.len()));
            }
            Change::Repeat(share, count) => {
                let place = place(*share);
                let piece = bytes[place..(place + count).min(bytes.len())].to_vec();
                bytes.splice(place..place, piece);
            }
        }
    }
    bytes
}

/// A file with these bytes.
fn file(suffix: &str, bytes: &[u8]) -> tempfile::NamedTempFile {
    let file = tempfile::Builder::new().suffix(suffix).tempfile().expect("there is room for a file");
    std::fs::write(file.path(), bytes).expect("there is room for a file");
    file
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct("tests/parsers.regressions"))),
        ..ProptestConfig::with_cases(500)
    })]

    #[test]
    fn models_are_read_or_refused(changes in prop::collection::vec(change(), 0..6)) {
        for (suffix, text) in [(".ply", PLY), (".obj", OBJ)] {
            let file = file(suffix, &changed(text, &changes));
            match Model::load(file.path()) {
                Ok(model) => {
                    prop_assert!(!model.points.is_empty() && model.points.iter().all(|point| point.is_finite()));
                    let _ = model.unit_normals(NormalSource::Auto);
                }
                Err(error) => prop_assert!(!changes.is_empty() && error.to_string().contains(suffix), "{}", error),
            }
        }
    }

    #[test]
    fn scenes_are_read_or_refused(changes in prop::collection::vec(change(), 0..4)) {
        let bytes = changed(SCENE, &changes);
        // A scene with a million points is fine, but takes its time.
        prop_assume!(!bytes.split(|byte| !byte.is_ascii_digit()).any(|digits| digits.len() > 4));
        let file = file(".toml", &bytes);
        match Scene::load(file.path(), &[]) {
            Ok(scene) => {
                let _ = Plan::of(&scene);
            }
            Err(error) => prop_assert!(!changes.is_empty(), "{}", error),
        }
    }

    #[test]
    fn configurations_are_read_or_refused(changes in prop::collection::vec(change(), 0..4)) {
        let text = |text| String::from_utf8(changed(text, &changes));
        if let Ok(text) = text(CORE_A) {
            match toml::from_str::<core_a::Config>(&text).map_err(|error| error.to_string()) {
                Ok(config) if config.validate().is_ok() => {
                    let written = toml::to_string(&config).expect("a configuration is a TOML table");
                    prop_assert_eq!(toml::from_str(&written), Ok(config));
                }
                Ok(_) => prop_assert!(!changes.is_empty()),
                Err(error) => prop_assert!(!changes.is_empty(), "{}", error),
            }
        }
        if let Ok(text) = text(CORE_B) {
            match toml::from_str::<core_b::Config>(&text).map_err(|error| error.to_string()) {
                Ok(config) if config.validate().is_ok() => {
                    let written = toml::to_string(&config).expect("a configuration is a TOML table");
                    prop_assert_eq!(toml::from_str(&written), Ok(config));
                }
                Ok(_) => prop_assert!(!changes.is_empty()),
                Err(error) => prop_assert!(!changes.is_empty(), "{}", error),
            }
        }
    }
}
