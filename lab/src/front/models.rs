//! Models and clouds as users have them, each in a file, with what is right of it.

use super::files::{self, LAS_STEP, Ply};
use super::neighbors;
use super::picture::{self, Expected};
use super::program::Program;
use super::shapes::{self, Shape};
use crate::LabError;
use glam::DVec3;
use pointcore::scene::Model;
use pointcore_tb::cache::file;
use std::path::Path;

/// Where a map's corner is.
const MAP: DVec3 = DVec3::new(1_412_345.0, 5_654_321.0, 120.0);
/// Least PSNR of a picture against the f64 reference: no difference that an eye finds.
const PSNR_DB: f64 = 40.0;
/// How far from its points a surface of some thousand of them may reach.
const REACH_PX: f64 = 4.0;

/// What a picture of a surface must show.
const SURFACE: Expected = Expected { psnr_db: PSNR_DB, reach_px: REACH_PX, is_surface: true };
/// What a picture of stray points must show: they are discs as large as they lie apart.
const SCATTERED: Expected = Expected { psnr_db: PSNR_DB, reach_px: 12.0, is_surface: false };
/// What a picture of a single place must show: a disc that fills it.
const LONE: Expected = Expected { psnr_db: PSNR_DB, reach_px: f64::INFINITY, is_surface: false };

/// A model in a file.
pub struct Case {
    /// The file's name.
    pub file: String,
    /// What is in it.
    pub shape: Shape,
    /// The file.
    pub bytes: Vec<u8>,
    expected: Expected,
    /// How far the format moves points.
    grain: f64,
    /// Settings for its picture.
    settings: &'static [&'static str],
    /// Arguments for its search.
    search: &'static [&'static str],
}

impl Case {
    fn new(file: &str, shape: Shape, write: impl FnOnce(&Shape) -> Vec<u8>) -> Self {
        let bytes = write(&shape);
        Self { file: file.to_owned(), shape, bytes, expected: SURFACE, grain: 0.0, settings: &[], search: &[] }
    }

    fn expected(self, expected: Expected) -> Self {
        Self { expected, ..self }
    }

    /// A scan: its vertices are what is known of it, so that what reads them is not judged.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn scan(path: &Path) -> Result<Self, LabError> {
        let bytes = std::fs::read(path).map_err(file("read", path))?;
        let shape = Shape { points: Model::load(path)?.points, ..Shape::default() };
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        Ok(Self { settings: &["object.0.points=20000"], ..Self::new(&name, shape, |_| bytes) })
    }

    /// Writes the file, renders it and searches in it; an error says what is wrong.
    ///
    /// # Errors
    /// Picture or neighbors are not right.
    pub fn judge(&self, program: &Program) -> Result<String, String> {
        let fault = |part: &str, problem: String| format!("{}: {part}: {problem}", self.file);
        std::fs::write(program.file(&self.file), &self.bytes).map_err(|error| fault("file", error.to_string()))?;
        let picture = picture::judge(program, &self.file, &self.shape, self.expected, self.settings);
        let picture = picture.map_err(|problem| fault("picture", problem))?;
        let neighbors = neighbors::judge(program, &self.file, &self.shape, self.grain, self.search);
        let neighbors = neighbors.map_err(|problem| fault("neighbors", problem))?;
        Ok(format!("{}: {picture}; {neighbors}", self.file))
    }
}

/// The model of the first picture.
#[must_use]
pub fn first() -> Case {
    Case::new("torus.ply", shapes::torus(100, 32).single(), |shape| files::ply(shape, Ply::Little))
}

/// All models that need no file of anyone.
#[must_use]
pub fn cases() -> Vec<Case> {
    let hills = || shapes::terrain(48, 0.05);
    vec![
        Case::new("sphere.ply", shapes::sphere(3000), |shape| files::ply(shape, Ply::Ascii)),
        first(),
        Case::new("torus-bare.ply", shapes::torus(100, 32).bare(), |shape| files::ply(shape, Ply::Big)),
        Case::new("plane.ply", shapes::terrain(48, 0.0).colored(), |shape| files::ply(shape, Ply::Big)),
        Case::new("globe.ply", shapes::globe(20).bare(), |shape| files::ply(shape, Ply::Big)),
        Case::new("cube.obj", shapes::cube(60), files::obj),
        Case::new("hills.obj", hills().colored(), files::obj),
        Case::new("globe.obj", shapes::globe(12), files::obj),
        moved("cube.gltf", shapes::cube(60).colored(), DVec3::new(3.0, -1.0, 8.0), files::gltf),
        // A little irregular, for neighbors at equal distances are others when they are rounded.
        moved("globe.glb", shapes::noisy(shapes::globe(16), 1e-3), DVec3::ZERO, files::glb),
        Case::new("hills.pcd", hills().colored().single(), files::pcd_binary),
        with_invalid_points(),
        Case {
            grain: LAS_STEP,
            ..Case::new("map.las", hills().placed(80.0, MAP).colored(), |shape| files::las(shape, false))
        },
        Case {
            grain: LAS_STEP,
            ..Case::new("map.laz", hills().placed(80.0, MAP).colored(), |shape| files::las(shape, true))
        },
        Case::new("map.csv", hills().placed(50.0, MAP), |shape| files::columns(shape, ';', true)),
        Case::new("tiny.csv", hills().placed(1e-6, DVec3::ZERO).colored(), |shape| files::columns(shape, ',', true)),
        Case::new("tiny-sphere.xyz", shapes::sphere(3000).placed(1e-6, DVec3::ZERO), |shape| {
            files::columns(shape, ' ', false)
        }),
        Case::new("huge.xyz", hills().placed(1e8, DVec3::ZERO), |shape| files::columns(shape, ' ', false)),
        Case::new("noisy.xyz", shapes::noisy(shapes::sphere(4000).bare(), 0.01), |shape| {
            files::columns(shape, '\t', false)
        }),
        Case::new("cloud.asc", shapes::cloud(2000), |shape| files::columns(shape, ' ', false)).expected(SCATTERED),
        Case::new("needle.obj", shapes::needle(2000), files::obj).expected(SCATTERED),
        Case::new("line.xyz", shapes::line(60), |shape| files::columns(shape, ' ', false)).expected(SCATTERED),
        Case::new("two.pts", shapes::line(2), |shape| files::columns(shape, ' ', false)).expected(LONE),
        Case::new("point.xyz", shapes::repeated(1).placed(1.0, MAP), |shape| files::columns(shape, ' ', false))
            .expected(LONE),
        Case::new("repeated.ply", shapes::repeated(500), |shape| files::ply(shape, Ply::Ascii)).expected(LONE),
    ]
}

/// A mesh that a node of its file moves and scales.
fn moved(file: &str, shape: Shape, origin: DVec3, write: fn(&Shape, f64, DVec3) -> Vec<u8>) -> Case {
    const SCALE: f64 = 2.0;
    let mut case = Case::new(file, shape.single(), |shape| write(shape, SCALE, origin));
    case.shape = case.shape.placed(SCALE, origin);
    case
}

/// A scan of which every seventh ray has hit nothing.
fn with_invalid_points() -> Case {
    let mut shape = shapes::noisy(shapes::terrain(56, 0.05), 0.002).single();
    shape.points.iter_mut().step_by(7).for_each(|point| *point = DVec3::NAN);
    Case { search: &["--drop-invalid"], ..Case::new("scan.pcd", shape, files::pcd) }
}
