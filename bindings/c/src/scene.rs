//! Scenes.

use crate::arguments::{array, borrowed, drop_handle, hand_over, place, required_text};
use crate::plan::Plan;
use crate::status::{Status, call};
use pointcore_bindings::{BindingError, Mesh as MeshArrays, Sides, Splats as Arrays, View, Viewpoint};
use std::ffi::c_char;
use std::path::Path;

/// A scene, ready to be rendered.
pub struct Scene(pub(crate) pointcore_bindings::Scene);

/// Splats as arrays, which are copied.
#[repr(C)]
pub struct Splats {
    /// How many there are.
    pub count: usize,
    /// Where they are: three numbers each.
    pub points: *const f64,
    /// Out of the surface: three numbers each, of any length, zero for a splat that faces the eye; NULL if all do.
    pub normals: *const f64,
    /// Radii: `radii_count` numbers.
    pub radii: *const f64,
    /// One for all, or one for each.
    pub radii_count: usize,
    /// sRGB from 0 to 1: three numbers each; NULL for white.
    pub colors: *const f64,
    /// Other than 0 if they are seen from behind, too.
    pub two_sided: u8,
}

/// Triangles as arrays, which are copied: drawn before the splats, they hide what lies behind them. They are seen from both sides.
#[repr(C)]
pub struct Mesh {
    /// How many vertices there are.
    pub vertex_count: usize,
    /// Where they are: three numbers each.
    pub vertices: *const f64,
    /// Their normals: three numbers each, of any length; NULL for the means of those of their faces.
    pub normals: *const f64,
    /// sRGB from 0 to 1: three numbers each; NULL for white.
    pub colors: *const f64,
    /// How many triangles there are.
    pub face_count: usize,
    /// Indices of their vertices: three each.
    pub faces: *const u32,
}

/// A camera.
#[repr(C)]
pub struct Camera {
    /// The eye.
    pub eye: [f64; 3],
    /// What it looks at.
    pub target: [f64; 3],
    /// What is up in the image.
    pub up: [f64; 3],
    /// The vertical opening angle.
    pub fov_degrees: f64,
}

/// An image.
#[repr(C)]
pub struct Image {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// sRGB from 0 to 1 where there is no splat.
    pub background: [f64; 3],
}

/// An array of three numbers for each of `count`; none for NULL.
///
/// # Safety
/// The pointer is NULL or holds as many numbers.
unsafe fn given(name: &str, pointer: *const f64, count: usize) -> Result<Option<Vec<[f64; 3]>>, BindingError> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: as the caller says.
    unsafe { array(name, pointer, count) }.map(|rows| Some(rows.to_vec()))
}

impl Mesh {
    /// # Safety
    /// Pointers are NULL or hold as many numbers as the counts say.
    unsafe fn arrays(&self) -> Result<MeshArrays, BindingError> {
        let count = self.vertex_count;
        // SAFETY: as the caller says.
        unsafe {
            Ok(MeshArrays {
                vertices: array("vertices", self.vertices, count)?.to_vec(),
                faces: array("faces", self.faces, self.face_count)?.to_vec(),
                normals: given("normals", self.normals, count)?,
                colors: given("colors", self.colors, count)?,
            })
        }
    }
}

impl Splats {
    /// # Safety
    /// Pointers are NULL or hold as many numbers as the counts say.
    unsafe fn arrays(&self) -> Result<Arrays, BindingError> {
        // SAFETY: as the caller says.
        unsafe {
            Ok(Arrays {
                points: array("points", self.points, self.count)?.to_vec(),
                normals: given("normals", self.normals, self.count)?,
                radii: array("radii", self.radii, self.radii_count)?.to_vec(),
                colors: given("colors", self.colors, self.count)?,
                sides: if self.two_sided == 0 { Sides::Front } else { Sides::Both },
            })
        }
    }
}

/// Makes a scene of splats, and of triangles beside them where `mesh` is not NULL; without a camera (NULL) one sees all of it.
/// `pointcore_scene_close` ends it.
///
/// # Safety
/// `splats`, `mesh` and `image` are structures whose pointers hold what they say, `mesh` and `camera` may be NULL, `scene` is a
/// place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_scene_open(
    splats: *const Splats,
    mesh: *const Mesh,
    camera: *const Camera,
    image: *const Image,
    scene: *mut *mut Scene,
) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (splats, mesh) =
            unsafe { (borrowed("splats", splats)?.arrays()?, mesh.as_ref().map(|mesh| mesh.arrays()).transpose()?) };
        // SAFETY: as the caller says.
        let (camera, image, scene) = unsafe { (camera.as_ref(), borrowed("image", image)?, place("scene", scene)?) };
        let viewpoint = camera.map_or(Viewpoint::Anywhere, |camera| Viewpoint::At {
            eye: camera.eye,
            target: camera.target,
            fov_degrees: camera.fov_degrees,
        });
        let &Image { width, height, background } = image;
        let view = View { width, height, viewpoint, up: camera.map(|camera| camera.up), background, frames: 1 };
        hand_over(Scene(pointcore_bindings::Scene::new(&splats, mesh.as_ref(), &view)?), scene);
        Ok(())
    })
}

/// Loads a scene file, or a model that a camera fits. `pointcore_scene_close` ends it.
///
/// # Safety
/// `path` is a C string, `scene` a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_scene_load(path: *const c_char, scene: *mut *mut Scene) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (path, scene) = unsafe { (required_text("path", path)?, place("scene", scene)?) };
        hand_over(Scene(pointcore_bindings::Scene::load(Path::new(path))?), scene);
        Ok(())
    })
}

/// Plans the renderer that a scene calls for. `pointcore_plan_close` ends it.
///
/// # Safety
/// `scene` is open, `plan` is a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_plan_scene(scene: *const Scene, plan: *mut *mut Plan) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (Scene(scene), plan) = unsafe { (borrowed("scene", scene)?, place("plan", plan)?) };
        hand_over(pointcore_bindings::Plan::scene(scene)?.into(), plan);
        Ok(())
    })
}

/// Ends a scene; NULL is none. What renders it may go on.
///
/// # Safety
/// `scene` is NULL or open, and no thread uses it any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_scene_close(scene: *mut Scene) {
    // SAFETY: as the caller says.
    unsafe { drop_handle(scene) };
}
