//! Files that users hand in are read or refused with an error, whatever is in them: valid ones with bytes changed, taken out, put in.

use pointcore::plan::Plan;
use pointcore::scene::{InvalidPoints, Model, NormalSource, Scene};
use pointcore_contract::{search, splat};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

const PLY: &str = include_str!("../../fuzz/seeds/ply/square.ply");
const PLY_BINARY: &[u8] = include_bytes!("../../fuzz/seeds/ply/square_binary.ply");
const OBJ: &str = include_str!("../../fuzz/seeds/obj/square.obj");
const GLTF: &str = include_str!("../../fuzz/seeds/gltf/triangle.gltf");
const PCD: &str = include_str!("../../fuzz/seeds/pcd/square.pcd");
const XYZ: &str = include_str!("../../fuzz/seeds/xyz/square.xyz");
const SCENE: &str = include_str!("../../fuzz/seeds/scene/sphere.toml");
const SPLAT: &str = include_str!("../../fuzz/seeds/configuration/splat.toml");
const SEARCH: &str = include_str!("../../fuzz/seeds/configuration/search.toml");

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

fn changed(text: impl AsRef<[u8]>, changes: &[Change]) -> Vec<u8> {
    let mut bytes = text.as_ref().to_vec();
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

/// A LAS file of a few points, compressed or not.
fn las(is_compressed: bool) -> Vec<u8> {
    let mut builder = las::Builder::from((1, 2));
    builder.point_format = las::point::Format::new(2).expect("there is such a format");
    builder.point_format.is_compressed = is_compressed;
    let header = builder.into_header().expect("the header is good");
    let mut writer = las::Writer::new(std::io::Cursor::new(Vec::new()), header).expect("the header is good");
    for x in 0..4 {
        let color = Some(las::Color { red: 7, green: 8, blue: x });
        writer.write_point(las::Point { x: x.into(), color, ..Default::default() }).expect("memory takes it");
    }
    writer.close().expect("memory takes it");
    writer.into_inner().expect("it was closed").into_inner()
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
        for (suffix, text) in [
            (".ply", PLY.as_bytes()),
            (".ply", PLY_BINARY),
            (".obj", OBJ.as_bytes()),
            (".gltf", GLTF.as_bytes()),
            (".pcd", PCD.as_bytes()),
            (".xyz", XYZ.as_bytes()),
            (".las", &las(false)),
            (".laz", &las(true)),
        ] {
            let file = file(suffix, &changed(text, &changes));
            _ = Model::load_with(file.path(), InvalidPoints::Drop);
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
        if let Ok(text) = text(SPLAT) {
            match toml::from_str::<splat::Config>(&text).map_err(|error| error.to_string()) {
                Ok(config) if config.validate().is_ok() => {
                    let written = toml::to_string(&config).expect("a configuration is a TOML table");
                    prop_assert_eq!(toml::from_str(&written), Ok(config));
                }
                Ok(_) => prop_assert!(!changes.is_empty()),
                Err(error) => prop_assert!(!changes.is_empty(), "{}", error),
            }
        }
        if let Ok(text) = text(SEARCH) {
            match toml::from_str::<search::Config>(&text).map_err(|error| error.to_string()) {
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
