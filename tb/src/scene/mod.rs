//! Scenes: a TOML file that says where the camera is, how large the image, and of which objects the splats are made.
//!
//! Colors in the file are sRGB, as an image editor shows them; splats carry them linear. Paths are relative to the
//! scene file. World space is right-handed; `up` is y by default.

mod camera;
mod error;
mod file;
pub(crate) mod model;
pub mod neighbors;
pub mod normals;
mod object;
mod shapes;

pub use error::SceneError;
pub use file::{Light, Material};
pub use model::{Model, NormalOrigin, NormalSource};
pub use shapes::trefoil;

use crate::shading::linear_from_srgb;
use file::{ImageTable, SceneFile, SplattingTable};
use glam::DVec3;
use pointcore_spec::core_a::config::KERNEL_GAMMA_RANGE;
use pointcore_spec::{Camera, Rendering, Splat};
use std::path::Path;

/// The share of a splat's radius by which surfaces may lie apart in depth and still blend. Neighboring splats of a
/// curved surface that all face the eye have no depth range of their own (eq. 5.9), but do differ in depth.
const BLENDED_RADIUS_SHARE: f64 = 0.5;
/// Thirty times the largest scan of the thesis; keeps a slip of the keyboard from filling the memory.
const SPLAT_LIMIT: usize = 4_000_000;
/// A filter of eight tiles' width; beyond, a picture is a blur.
const FILTER_RADIUS_LIMIT_PX: f64 = 64.0;
/// A splat that blends with what lies this many of its own depth ranges away blends with everything.
const EPSILON_SCALE_LIMIT: f64 = 1e6;
/// A light that is overexposed by this factor leaves nothing but white.
const INTENSITY_LIMIT: f64 = 1000.0;
/// A highlight narrower than a pixel of the largest picture.
const SHININESS_LIMIT: f64 = 1e6;

/// A scene, ready to be rendered.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The camera.
    pub camera: Camera,
    /// Image size, kernel and depth tolerance.
    pub rendering: Rendering,
    /// The splats, object after object.
    pub splats: Vec<Splat>,
    /// The light.
    pub light: Light,
    /// At least one; splats refer to them by index.
    pub materials: Vec<Material>,
    /// Linear RGB of pixels without a splat.
    pub background: [f64; 3],
    /// Keys of the hardware configuration that this scene wants changed.
    pub overrides: toml::Table,
}

impl Scene {
    /// Loads a scene file and the models it names. Each of `settings` reads `key=value` and replaces a value of the
    /// file, e.g. `object.0.path=scan.ply`.
    ///
    /// # Errors
    /// The file or one of its models is missing or malformed; the message names file and key.
    pub fn load(path: &Path, settings: &[String]) -> Result<Self, SceneError> {
        let file = SceneFile::load(path, settings)?;
        let value = |key: String, problem: String| SceneError::Value { path: path.to_owned(), key, problem };
        let camera =
            camera::derive(&file.camera, &file.image).map_err(|(key, problem)| value(key.to_owned(), problem))?;
        object::check_color(file.image.background).map_err(|problem| value("image.background".to_owned(), problem))?;
        check_light(&file.light).map_err(|(key, problem)| value(key.to_owned(), problem))?;

        for (index, material) in file.materials.iter().enumerate() {
            check_material(material).map_err(|(key, problem)| value(format!("material.{index}.{key}"), problem))?;
        }

        let materials = if file.materials.is_empty() { vec![Material::default()] } else { file.materials };
        let mut splats = Vec::new();
        for (index, object) in file.objects.iter().enumerate() {
            let key = format!("object.{index}");
            if usize::from(object.material) >= materials.len() {
                let problem = format!("is {}: expected an index below {}", object.material, materials.len());
                return Err(value(format!("{key}.material"), problem));
            }
            splats.extend(object::build(object, path, &key)?);
            if splats.len() > SPLAT_LIMIT {
                let problem = format!("brings the scene to {} splats: expected up to {SPLAT_LIMIT}", splats.len());
                return Err(value(key, problem));
            }
        }
        if splats.is_empty() {
            return Err(value("object".to_owned(), "is empty: a scene needs at least one object".to_owned()));
        }

        let rendering = rendering(&file.image, &file.splatting, blending_depth(&splats, &camera))
            .map_err(|(key, problem)| value(key.to_owned(), problem))?;
        let background = file.image.background.map(linear_from_srgb);
        Ok(Self { camera, rendering, splats, light: file.light, materials, background, overrides: file.overrides })
    }
}

/// Image size, kernel and tolerance; `blending_depth` is the tolerance unless the scene says another.
fn rendering(
    image: &ImageTable,
    splatting: &SplattingTable,
    blending_depth: f64,
) -> Result<Rendering, camera::Problem> {
    let number = |key, given: Option<f64>, default, range| {
        given.map_or(Ok(default), |number| camera::within(key, number, range).map(|()| number))
    };
    let kernel_gamma =
        number("splatting.kernel_gamma", splatting.kernel_gamma, Rendering::DEFAULT_KERNEL_GAMMA, KERNEL_GAMMA_RANGE)?;
    let filter_radius_px = number(
        "splatting.filter_radius_px",
        splatting.filter_radius_px,
        Rendering::DEFAULT_FILTER_RADIUS_PX,
        0.0..=FILTER_RADIUS_LIMIT_PX,
    )?;
    let epsilon_scale = number(
        "splatting.epsilon_scale",
        splatting.epsilon_scale,
        Rendering::DEFAULT_EPSILON_SCALE,
        0.0..=EPSILON_SCALE_LIMIT,
    )?;
    Ok(Rendering {
        width: image.width,
        height: image.height,
        kernel_gamma,
        filter_radius_px: (filter_radius_px > 0.0).then_some(filter_radius_px),
        epsilon_scale,
        epsilon_bias: number("splatting.epsilon_bias", splatting.epsilon_bias, blending_depth, 0.0..=1.0)?,
    })
}

fn check_light(light: &Light) -> Result<(), camera::Problem> {
    if DVec3::from_array(light.direction).try_normalize().is_none() {
        return Err(("light.direction", format!("is {:?}: expected a vector other than zero", light.direction)));
    }
    camera::within("light.ambient", light.ambient, 0.0..=INTENSITY_LIMIT)?;
    camera::within("light.diffuse", light.diffuse, 0.0..=INTENSITY_LIMIT)
}

fn check_material(material: &Material) -> Result<(), camera::Problem> {
    camera::within("specular", material.specular, 0.0..=1.0)?;
    camera::within("shininess", material.shininess, 0.0..=SHININESS_LIMIT)
}

/// The mean, over the splats before the camera, of the depth difference that [`BLENDED_RADIUS_SHARE`] of their radius
/// makes: `|∂depth/∂Z| = |depth_b| / Z²`.
fn blending_depth(splats: &[Splat], camera: &Camera) -> f64 {
    let forward = camera.model_view[2];
    let depth = |splat: &Splat| {
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let distance = DVec3::from_slice(&forward).dot(vector(splat.center)) + forward[3];
        let radius = vector(splat.tangents[0]).length();
        (distance > camera.near).then(|| BLENDED_RADIUS_SHARE * radius * camera.depth_b.abs() / (distance * distance))
    };
    let visible: Vec<f64> = splats.iter().filter_map(depth).collect();
    visible.iter().sum::<f64>() / visible.len().max(1) as f64
}

#[cfg(test)]
mod tests;
