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

use crate::color::linear_from_srgb;
use file::{ImageTable, SceneFile, SplattingTable};
use glam::DVec3;
use pointcore_contract::splat::config::{IMAGE_EDGE_MAX, KERNEL_GAMMA_RANGE};
use pointcore_contract::surface::NORMAL;
use pointcore_contract::{Camera, Rendering, Sampling, Splat};
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
/// Samples along an edge beyond which more show nothing.
const SAMPLES_LIMIT: usize = 8;
/// Cut off nearer, splats leave holes; farther, the kernel has hardly any weight left.
const CUTOFF_RANGE: std::ops::RangeInclusive<f64> = 0.25..=2.0;
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
    /// Samples along each edge of a pixel of the picture: camera and image size are those of the samples.
    pub samples: usize,
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
        let (light, overrides) = (file.light, file.overrides);
        let scene = Self { camera, rendering, splats, light, materials, background, samples: 1, overrides };
        let (samples, cutoff) = (file.image.samples, file.splatting.cutoff.unwrap_or(1.0));
        check_sampling(samples, &scene.rendering).map_err(|problem| value("image.sampling".to_owned(), problem))?;
        check_samples(samples, &scene.rendering).map_err(|problem| value("image.samples".to_owned(), problem))?;
        camera::within("splatting.cutoff", cutoff, CUTOFF_RANGE)
            .map_err(|(key, problem)| value(key.to_owned(), problem))?;
        Ok(scene.without_unread().cut_off(cutoff).supersampled(samples))
    }

    /// Whether the light falls on surfaces from its direction, so that shading reads normals and materials.
    #[must_use]
    pub fn is_lit(&self) -> bool {
        self.light.diffuse > 0.0
    }

    /// The same picture from splats that are alike in what shading never reads of them: without light normal and material, and which one of
    /// materials that shine alike.
    fn without_unread(mut self) -> Self {
        let is_lit = self.is_lit();
        let shine = |material: &Material| {
            (is_lit && material.specular > 0.0).then_some((material.specular, material.shininess))
        };
        let shines: Vec<_> = self.materials.iter().map(shine).collect();
        let first = |shine| shines.iter().position(|other| *other == shine).unwrap_or_default();
        let alike: Vec<usize> = shines.iter().map(|&shine| first(shine)).collect();
        for splat in &mut self.splats {
            if !is_lit {
                splat.attributes[NORMAL].fill(0.0);
            }
            splat.material = alike.get(usize::from(splat.material)).map_or(splat.material, |&index| index as u16);
        }
        self
    }

    /// The same picture from `factor` times as many samples along each edge of a pixel; lengths in pixels are lengths in samples then.
    #[must_use]
    pub fn supersampled(mut self, factor: usize) -> Self {
        let scale = factor as f64;
        let Camera { scale_x, scale_y, center_x, center_y, .. } = &mut self.camera;
        for length in [scale_x, scale_y, center_x, center_y] {
            *length *= scale;
        }
        self.rendering.width *= factor;
        self.rendering.height *= factor;
        self.rendering.filter_radius_px = self.rendering.filter_radius_px.map(|radius| radius * scale);
        self.samples *= factor;
        self
    }

    /// The same splats with kernels cut off at a share of their radius.
    ///
    /// The hardware cuts at `ρ = 1`, so the splats shrink, and the kernels fall as much less over `ρ`. The filter's kernel does the same, and a
    /// splat's depth range of eq. 5.9 stays what it was.
    fn cut_off(mut self, share: f64) -> Self {
        for component in self.splats.iter_mut().flat_map(|splat| splat.tangents.iter_mut().flatten()) {
            *component = (f64::from(*component) * share) as f32;
        }
        let rendering = &mut self.rendering;
        rendering.kernel_gamma *= share * share;
        rendering.filter_radius_px = rendering.filter_radius_px.map(|radius| radius * share);
        rendering.epsilon_scale /= share;
        self
    }

    /// The overrides of a scene file, with settings as [`Scene::load`] takes them; no model is loaded.
    ///
    /// # Errors
    /// The file cannot be read, or is no scene.
    pub fn overrides(path: &Path, settings: &[String]) -> Result<toml::Table, SceneError> {
        Ok(SceneFile::load(path, settings)?.overrides)
    }

    /// A scene file as TOML, with settings as [`Scene::load`] takes them put in, the models' paths absolute: it may lie anywhere.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn text(path: &Path, settings: &[String]) -> Result<String, SceneError> {
        SceneFile::text(path, settings)
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
    // A pixel's right and bottom sides are the left and top sides of pixels beside it: the last ones have such beside them, too.
    let (width, height) = match image.sampling {
        Sampling::Center => (image.width, image.height),
        Sampling::Flipquad => (2 * (image.width + 1), image.height + 1),
    };
    Ok(Rendering {
        width,
        height,
        sampling: image.sampling,
        depth: splatting.depth,
        kernel_gamma,
        filter_radius_px: (filter_radius_px > 0.0).then_some(filter_radius_px),
        epsilon_scale,
        epsilon_bias: number("splatting.epsilon_bias", splatting.epsilon_bias, blending_depth, 0.0..=1.0)?,
    })
}

fn check_samples(samples: usize, rendering: &Rendering) -> Result<(), String> {
    if !(1..=SAMPLES_LIMIT).contains(&samples) {
        return Err(format!("is {samples}: expected 1 to {SAMPLES_LIMIT} along an edge of a pixel"));
    }
    let longest = samples * rendering.width.max(rendering.height);
    let limit = IMAGE_EDGE_MAX as usize;
    (longest <= limit).then_some(()).ok_or_else(|| {
        format!("is {samples}, which makes {longest} samples along an edge of the image: expected up to {limit}")
    })
}

fn check_sampling(samples: usize, rendering: &Rendering) -> Result<(), String> {
    let limit = IMAGE_EDGE_MAX as usize;
    match rendering.sampling {
        Sampling::Center => Ok(()),
        Sampling::Flipquad if samples > 1 => {
            Err(format!("is \"flipquad\", which has samples of its own: expected `image.samples` = 1, not {samples}"))
        }
        Sampling::Flipquad if rendering.width.max(rendering.height) > limit => Err(format!(
            "is \"flipquad\", which makes {} by {} samples: expected up to {limit}, an image of {} by {} pixels",
            rendering.width,
            rendering.height,
            limit / 2 - 1,
            limit - 1
        )),
        Sampling::Flipquad => Ok(()),
    }
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
