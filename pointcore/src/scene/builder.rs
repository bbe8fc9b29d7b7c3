//! Scenes built in memory.

use super::disc::Disc;
use super::error::SceneError;
use super::file::{CameraTable, DerivedDirection, ImageTable, Light, LightDirection, LightTable, Material, SceneFile};
use super::mesh::TRIANGLE_LIMIT;
use super::mesh::{Corner, Triangle};
use super::{SPLAT_LIMIT, Scene, assemble};
use pointcore_contract::Sampling;
use std::path::PathBuf;

/// What errors call a scene without a file.
const NAME: &str = "scene in memory";
/// Pixels along each edge of an image of which nothing is said.
const EDGE_PX: usize = 512;

/// A scene in the making: discs, and what is told about camera, image and light.
///
/// ```
/// use pointcore::scene::{Disc, Scene};
///
/// let row = (0..9_u8).map(|x| Disc::new([f64::from(x), 0.0, 0.0].into(), [0.0, 0.0, 1.0].into(), 0.7));
/// let scene = Scene::of(row.collect()).image(64, 16).from([0.0, 0.0, 1.0]).build()?;
/// assert_eq!((scene.splats.len(), scene.rendering.width), (9, 64));
/// # Ok::<(), pointcore::scene::SceneError>(())
/// ```
#[derive(Debug)]
pub struct SceneBuilder {
    discs: Vec<Disc>,
    triangles: Vec<Triangle>,
    file: SceneFile,
}

impl SceneBuilder {
    pub(super) fn new(discs: Vec<Disc>) -> Self {
        let direction = LightDirection::Derived(DerivedDirection::Camera);
        let file = SceneFile {
            camera: CameraTable { fit: true, ..CameraTable::default() },
            image: ImageTable {
                width: EDGE_PX,
                height: EDGE_PX,
                background: [0.0; 3],
                samples: 1,
                sampling: Sampling::default(),
            },
            light: LightTable { direction, ..LightTable::default() },
            shutter: None,
            splatting: Default::default(),
            materials: Vec::new(),
            objects: Vec::new(),
            overrides: toml::Table::new(),
        };
        Self { discs, triangles: Vec::new(), file }
    }

    /// An image of so many pixels.
    #[must_use]
    pub fn image(mut self, width: usize, height: usize) -> Self {
        (self.file.image.width, self.file.image.height) = (width, height);
        self
    }

    /// What is seen where there is no splat, as sRGB.
    #[must_use]
    pub fn background(mut self, color: [f64; 3]) -> Self {
        self.file.image.background = color;
        self
    }

    /// A camera that sees the whole scene from this direction.
    #[must_use]
    pub fn from(mut self, direction: [f64; 3]) -> Self {
        self.file.camera.from = Some(direction);
        self
    }

    /// A camera at a place, turned to another, with a vertical opening angle.
    #[must_use]
    pub fn camera(mut self, eye: [f64; 3], target: [f64; 3], fov_degrees: f64) -> Self {
        let camera = &mut self.file.camera;
        (camera.fit, camera.eye, camera.target) = (false, Some(eye), Some(target));
        camera.fov_degrees = Some(fov_degrees);
        self
    }

    /// What is up in the image.
    #[must_use]
    pub fn up(mut self, up: [f64; 3]) -> Self {
        self.file.camera.up = Some(up);
        self
    }

    /// A sequence of so many frames, a full turn around the scene.
    #[must_use]
    pub fn turntable(mut self, frames: usize) -> Self {
        self.file.camera.turntable = Some(frames);
        self
    }

    /// Triangles in world space that are drawn before the discs, and hide what lies behind them.
    #[must_use]
    pub fn triangles(mut self, triangles: Vec<Triangle>) -> Self {
        self.triangles = triangles;
        self
    }

    /// A light that stays where it is when the camera moves.
    #[must_use]
    pub fn light(mut self, light: Light) -> Self {
        let Light { direction, ambient, diffuse } = light;
        self.file.light = LightTable { direction: LightDirection::World(direction), ambient, diffuse };
        self
    }

    /// The materials that discs refer to.
    #[must_use]
    pub fn materials(mut self, materials: Vec<Material>) -> Self {
        self.file.materials = materials;
        self
    }

    /// Keys of the hardware configuration to be changed.
    #[must_use]
    pub fn overrides(mut self, overrides: toml::Table) -> Self {
        self.file.overrides = overrides;
        self
    }

    /// The scene.
    ///
    /// # Errors
    /// A value makes no sense; there is no disc; a disc or a triangle is nowhere, or of a material that there is none of.
    pub fn build(self) -> Result<Scene, SceneError> {
        let Self { discs, triangles, file } = self;
        let value = |(key, problem): (String, String)| SceneError::Value { path: PathBuf::from(NAME), key, problem };
        assemble::check(&file).map_err(value)?;
        for (count, limit, what) in
            [(discs.len(), SPLAT_LIMIT, "discs"), (triangles.len(), TRIANGLE_LIMIT, "triangles")]
        {
            if count > limit {
                return Err(value((what.to_owned(), format!("are {count}: expected up to {limit}"))));
            }
        }
        let materials = file.materials.len().max(1);
        let is_good = |disc: &Disc| {
            let is_finite = disc.center.is_finite() && disc.tangents.iter().all(|tangent| tangent.is_finite());
            is_finite && disc.normal.is_finite() && usize::from(disc.material) < materials
        };
        if let Some(index) = discs.iter().position(|disc| !is_good(disc)) {
            let problem = format!("is {:?}: expected finite numbers and a material below {materials}", discs[index]);
            return Err(value((format!("discs.{index}"), problem)));
        }
        let is_good = |triangle: &Triangle| {
            let is_finite = |corner: &Corner| corner.place.is_finite() && corner.normal.is_finite();
            triangle.corners.iter().all(is_finite) && usize::from(triangle.material) < materials
        };
        if let Some(index) = triangles.iter().position(|triangle| !is_good(triangle)) {
            let problem =
                format!("is {:?}: expected finite numbers and a material below {materials}", triangles[index]);
            return Err(value((format!("triangles.{index}"), problem)));
        }
        assemble::assemble(file, (discs, triangles), &[], Vec::new()).map_err(value)
    }
}
