//! Scenes: a TOML file that says where the camera is, how large the image, and of which objects the splats are made.
//!
//! Colors in the file are sRGB, as an image editor shows them; splats carry them linear. Paths are relative to the
//! scene file. World space is right-handed; `up` is y by default.

mod assemble;
mod builder;
mod camera;
mod disc;
mod error;
mod file;
mod fit;
mod mesh;
pub(crate) mod model;
mod motion;
pub mod neighbors;
pub mod normals;
mod object;
mod reading;
mod scan;
mod settings;
mod shapes;

pub use builder::SceneBuilder;
pub use camera::FRAMES_LIMIT;
pub use disc::{Disc, Placement, Sides};
pub use error::SceneError;
pub use file::{Light, Material};
pub use mesh::{Corner, Triangle};
pub use model::{InvalidPoints, Model, NormalOrigin, NormalSource, is_guarded};
pub use motion::Motion;
pub use shapes::trefoil;

use file::{Draw, SceneFile};
use glam::DVec3;
use mesh::TRIANGLE_LIMIT;
use pointcore_contract::surface::NORMAL;
use pointcore_contract::{Camera, Rendering, Splat};
use std::ops::Range;
use std::path::Path;

/// Thirty times the largest scan of the thesis; keeps a slip of the keyboard from filling the memory.
const SPLAT_LIMIT: usize = 4_000_000;

/// A scene, ready to be rendered.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The camera.
    pub camera: Camera,
    /// Image size, kernel and depth tolerance.
    pub rendering: Rendering,
    /// The splats, object after object.
    pub splats: Vec<Splat>,
    /// Splats of surfaces that do not blend with each other, one after the other; none where all are of one.
    pub surfaces: Vec<Range<usize>>,
    /// Triangles that whoever draws them leaves in memory before the splats, where splats' coordinates count from.
    pub triangles: Vec<Triangle>,
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
    /// Where in world space the splats' coordinates count from, and in what unit: the camera's, too.
    pub placement: Placement,
    /// Which side of each splat is seen; empty if each is seen from its front.
    pub sides: Vec<Sides>,
    /// The frames of its sequence, one at least; the first is what the scene shows after loading.
    pub views: Vec<View>,
    /// What whoever draws it should know about its models.
    pub notes: Vec<String>,
    /// What moves while the shutter is open; splats and camera are those of the middle of the exposure.
    pub motion: Option<Motion>,
}

/// What differs from frame to frame of a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// The camera.
    pub camera: Camera,
    /// The light.
    pub light: Light,
    /// How far surfaces may lie apart in depth and still blend.
    pub epsilon_bias: f64,
}

impl Scene {
    /// Loads a scene file and the models it names, or a model alone, which a camera then fits. Each of `settings` reads `key=value` and
    /// replaces a value of the file, e.g. `object.0.path=scan.ply`.
    ///
    /// # Errors
    /// The file or one of its models is missing or malformed; the message names file and key.
    pub fn load(path: &Path, settings: &[String]) -> Result<Self, SceneError> {
        let file = SceneFile::load(path, settings)?;
        let value = |(key, problem): (String, String)| SceneError::Value { path: path.to_owned(), key, problem };
        assemble::check(&file).map_err(value)?;
        let (mut discs, mut triangles, mut spans, mut notes) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (index, object) in file.objects.iter().enumerate() {
            let key = format!("object.{index}");
            object::check(object).map_err(|(name, problem)| value((format!("{key}.{name}"), problem)))?;
            let first = discs.len();
            match object.draw {
                Draw::Splats => discs.extend(object::build(object, path, &key, &mut notes)?),
                Draw::Triangles => triangles.extend(mesh::build(object, path, &key)?),
            }
            spans.push(first..discs.len());
            for (count, limit, what) in
                [(discs.len(), SPLAT_LIMIT, "splats"), (triangles.len(), TRIANGLE_LIMIT, "triangles")]
            {
                if count > limit {
                    let problem = format!("brings the scene to {count} {what}: expected up to {limit}");
                    return Err(value((key, problem)));
                }
            }
        }
        assemble::assemble(file, (discs, triangles), &spans, notes).map_err(value)
    }

    /// A scene of discs in memory, seen by a camera around it unless the builder is told otherwise.
    #[must_use]
    pub fn of(discs: Vec<Disc>) -> SceneBuilder {
        SceneBuilder::new(discs)
    }

    /// Shows a frame of the sequence: camera, light, and splats that turn to the eye.
    pub fn look(&mut self, view: &View) {
        self.camera = view.camera;
        self.light = view.light.clone();
        self.rendering.epsilon_bias = view.epsilon_bias;
        let rows = view.camera.model_view;
        // A rotation's inverse is its transpose.
        let eye: DVec3 = rows.iter().map(|row| -row[3] * DVec3::from_slice(row)).sum();
        for (splat, sides) in self.splats.iter_mut().zip(&self.sides) {
            disc::turn(splat, *sides, eye);
        }
        if !self.is_lit() {
            self.splats.iter_mut().for_each(|splat| splat.attributes[NORMAL].fill(0.0));
        }
    }

    /// Whether fragments are tested against depths in memory: those of triangles, or of surfaces that came before.
    #[must_use]
    pub fn is_merged(&self) -> bool {
        !self.triangles.is_empty() || self.surfaces.len() > 1
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
        for camera in self.views.iter_mut().map(|view| &mut view.camera).chain([&mut self.camera]) {
            let Camera { scale_x, scale_y, center_x, center_y, .. } = camera;
            for length in [scale_x, scale_y, center_x, center_y] {
                *length *= scale;
            }
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

#[cfg(test)]
mod tests;

#[cfg(test)]
mod model_scenes;
#[cfg(test)]
mod shipped_scenes;
