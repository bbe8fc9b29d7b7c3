//! Pictures of scenes that move while the shutter is open, in f64 (thesis ch. 4).

use crate::scene::Scene;
use crate::shading;
use pointcore_golden::reference::motion::{self, Exposed, Interval, Method, MovingSplat, Setting, Shutter};
use pointcore_golden::reference::{Mapping, render};

pub use pointcore_golden::reference::motion::Exposure;

/// Exposes a scene, whose splats move so, by a method; `row_done` is called whenever a row of its samples is done.
#[must_use]
pub fn by_method(scene: &Scene, splats: &[MovingSplat], method: Method, row_done: &(dyn Fn() + Sync)) -> Exposure {
    let setting = Setting {
        camera: &scene.camera,
        rendering: &scene.rendering,
        shutter: shutter(scene),
        shade: &shading::colors(scene, &scene.camera),
        row_done,
    };
    motion::expose(splats, method, &setting)
}

/// Exposes a scene as the mean of so many still frames, each for an equal part of the exposure, from its middle: temporal supersampling, which many
/// samples make the truth. `frame_done` is called whenever a frame is done.
///
/// Surfaces are reconstructed and shaded in each frame before the mean is taken, with coverage as alpha.
#[must_use]
pub fn by_samples(scene: &Scene, count: usize, frame_done: &(dyn Fn() + Sync)) -> Exposure {
    let mut exposure = Exposure::dark(&scene.rendering);
    for part in Interval::equal_parts(count) {
        let (splats, camera) = scene.at(part.middle());
        let frame = render(&splats, &camera, &scene.rendering, Mapping::Backward);
        exposure.add(&frame, shutter(scene).share(part), &scene.rendering, &shading::colors(scene, &camera));
        frame_done();
    }
    exposure
}

pub(crate) fn shutter(scene: &Scene) -> Shutter {
    scene.motion.as_ref().map_or(Shutter::Box, |motion| motion.shutter)
}

/// Whether an exposure shows any surface.
#[must_use]
pub fn is_blank(exposure: &Exposure) -> bool {
    exposure.samples.iter().all(|sample: &Exposed| sample.coverage == 0.0)
}
