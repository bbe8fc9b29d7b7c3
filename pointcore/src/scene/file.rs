//! The scene file as it is written: TOML tables whose keys are all known.

use super::model::NormalSource;
use super::motion::{MotionTable, ShutterTable};
use pointcore_contract::{FragmentDepth, Sampling};
use serde::Deserialize;
use std::path::PathBuf;

/// A scene file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneFile {
    pub camera: CameraTable,
    pub image: ImageTable,
    #[serde(default)]
    pub light: LightTable,
    /// When the shutter is open, of a scene that moves.
    pub shutter: Option<ShutterTable>,
    #[serde(default)]
    pub splatting: SplattingTable,
    #[serde(default, rename = "material")]
    pub materials: Vec<Material>,
    #[serde(rename = "object")]
    pub objects: Vec<ObjectTable>,
    #[serde(default)]
    pub overrides: toml::Table,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct CameraTable {
    /// Whether the camera goes where it sees the whole scene.
    pub fit: bool,
    /// With `fit`, where to look from: the direction from the scene to the eye.
    pub from: Option<[f64; 3]>,
    pub eye: Option<[f64; 3]>,
    pub target: Option<[f64; 3]>,
    pub up: Option<[f64; 3]>,
    /// Vertical opening angle.
    pub fov_degrees: Option<f64>,
    /// By default both planes lie around what is before the eye.
    pub near: Option<f64>,
    pub far: Option<f64>,
    /// Frames of a turn around the target.
    pub turntable: Option<usize>,
    /// Where a path leads, evenly in time.
    #[serde(rename = "keyframe")]
    pub keyframes: Vec<Keyframe>,
    /// Frames of the path.
    pub frames: Option<usize>,
    /// How it moves within a frame.
    pub motion: Option<MotionTable>,
}

/// A place on a camera's path; what it leaves out is the camera's.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keyframe {
    pub eye: [f64; 3],
    pub target: Option<[f64; 3]>,
    pub up: Option<[f64; 3]>,
    pub fov_degrees: Option<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ImageTable {
    pub width: usize,
    pub height: usize,
    #[serde(default)]
    pub background: [f64; 3],
    /// Samples along each edge of a pixel.
    #[serde(default = "one_sample")]
    pub samples: usize,
    /// Where samples lie.
    #[serde(default)]
    pub sampling: Sampling,
}

fn one_sample() -> usize {
    1
}

/// The one light, infinitely far away.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// From the surface towards the light, in world space; of any length but zero.
    pub direction: [f64; 3],
    /// Linear intensity that reaches every surface.
    pub ambient: f64,
    /// Linear intensity of the light.
    pub diffuse: f64,
}

impl Default for Light {
    fn default() -> Self {
        Self { direction: [0.5, 1.0, 0.8], ambient: 0.08, diffuse: 0.92 }
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct LightTable {
    pub direction: LightDirection,
    pub ambient: f64,
    pub diffuse: f64,
}

impl Default for LightTable {
    fn default() -> Self {
        let Light { direction, ambient, diffuse } = Light::default();
        Self { direction: LightDirection::World(direction), ambient, diffuse }
    }
}

/// Where the light comes from.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged, expecting = "expected three numbers or \"camera\"")]
pub(super) enum LightDirection {
    World([f64; 3]),
    Derived(DerivedDirection),
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum DerivedDirection {
    /// From over the shoulder of who looks, wherever the camera goes.
    Camera,
}

/// How a surface reflects the light besides its color; splats refer to it by its index.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// Share of the light that is mirrored.
    pub specular: f64,
    /// Exponent of the highlight: the larger, the smaller it is.
    pub shininess: f64,
}

impl Default for Material {
    fn default() -> Self {
        Self { specular: 0.15, shininess: 24.0 }
    }
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct SplattingTable {
    pub kernel_gamma: Option<f64>,
    /// Share of a splat's radius at which its kernel is cut off.
    pub cutoff: Option<f64>,
    /// Zero switches the filter off.
    pub filter_radius_px: Option<f64>,
    pub epsilon_scale: Option<f64>,
    /// By default derived from the splats' radii.
    pub epsilon_bias: Option<f64>,
    /// Whether samples have their splat's depth, or that of its plane.
    pub depth: FragmentDepth,
    /// What splats blend with.
    pub surfaces: Surfaces,
    /// How a moving scene settles what hides what.
    pub motion: Option<String>,
    /// How far straight parts of a path may lie from it.
    pub resample_px: Option<f64>,
}

/// Which splats are of one surface.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum Surfaces {
    /// All of them.
    #[default]
    One,
    /// Those of each object, one surface after the other.
    Objects,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum Kind {
    Sphere,
    Torus,
    TorusKnot,
    Plane,
    File,
}

impl Kind {
    /// As the scene file spells it.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Torus => "torus",
            Self::TorusKnot => "torus_knot",
            Self::Plane => "plane",
            Self::File => "file",
        }
    }
}

/// The radius of an object's splats before [`ObjectTable::radius_scale`].
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged, expecting = "expected a number or \"spacing\" or \"elliptic\"")]
pub(super) enum Radius {
    Length(f64),
    Derived(DerivedRadius),
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum DerivedRadius {
    Spacing,
    /// Discs as long and as wide as the points around them spread.
    Elliptic,
}

/// How many points an object has.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged, expecting = "expected a number of points or \"auto\"")]
pub(super) enum Points {
    Count(usize),
    Derived(DerivedPoints),
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum DerivedPoints {
    /// Those of the file, unless they are too few for its faces or too many for a simulation.
    Auto,
}

/// Whether discs are seen from behind, too.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged, expecting = "expected true, false or \"estimated\"")]
pub(super) enum TwoSided {
    Always(bool),
    Derived(DerivedSides),
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum DerivedSides {
    /// Where normals are estimated, and so may point to either side.
    Estimated,
}

/// Which side of the surface estimated normals point to.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum Orientation {
    /// To that of their neighbors, along a minimum spanning tree.
    Tree,
    /// Towards the sensor.
    Viewpoint,
}

/// What an object is made of.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum Draw {
    /// Splats.
    #[default]
    Splats,
    /// The file's faces, which whoever draws triangles leaves in memory before splats are tested against them.
    Triangles,
}

/// An object of any kind; which keys apply to which is settled when it is built.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectTable {
    pub kind: Kind,
    #[serde(default)]
    pub draw: Draw,

    pub points: Option<Points>,
    pub outer_radius: Option<f64>,
    pub tube_radius: Option<f64>,
    pub knot_radius: Option<f64>,
    pub windings: Option<[u32; 2]>,
    pub size: Option<f64>,
    pub checks: Option<[u32; 2]>,
    pub checker_color: Option<[f64; 3]>,

    pub path: Option<PathBuf>,
    pub normals: Option<NormalSource>,
    pub orient: Option<Orientation>,
    /// Where the sensor stood, by default what the file says.
    pub viewpoint: Option<[f64; 3]>,
    /// Leaves out points that are no numbers.
    pub drop_invalid: Option<bool>,
    pub two_sided: Option<TwoSided>,
    /// Radii by spacing end at so many times their median: a stray point is no disc over everything.
    pub radius_limit: Option<f64>,

    #[serde(default)]
    pub translate: [f64; 3],
    /// About the fixed axes x, then y, then z.
    #[serde(default)]
    pub rotate_degrees: [f64; 3],
    #[serde(default = "one")]
    pub scale: f64,
    pub color: Option<[f64; 3]>,
    #[serde(default)]
    pub material: u16,
    #[serde(default = "by_spacing")]
    pub radius: Radius,
    #[serde(default = "one")]
    pub radius_scale: f64,
    /// How it moves while the shutter is open.
    pub motion: Option<MotionTable>,
}

fn one() -> f64 {
    1.0
}

fn by_spacing() -> Radius {
    Radius::Derived(DerivedRadius::Spacing)
}
