//! Triangles beside splats: what a triangle rasterizer leaves in memory before the frame, and what of splats is seen before it (thesis 5.4.6).
//!
//! In f64, a sample where splats have theirs: it stands for the part of a graphics pipeline that the renderer is not.

use crate::scene::{Corner, Scene, Triangle};
use crate::splat::depth_memory::Depths;
use glam::{DVec2, DVec3};
use pointcore_contract::splat::Config;
use pointcore_contract::{Camera, Rendering, Sampling};
use pointcore_golden::reference::{Fragment, Frame, sampling};
use std::ops::Range;

/// Triangles of a scene, drawn: the nearest one in each sample, row by row.
#[derive(Clone, Debug)]
pub struct Layer {
    width: usize,
    /// `None` where there is no triangle.
    pixels: Vec<Option<Fragment>>,
}

/// A corner as the camera has it.
#[derive(Clone, Copy)]
struct Seen {
    /// To the right, down and forward.
    place: DVec3,
    /// Normal and color.
    attributes: [f64; 6],
}

impl Seen {
    fn of(corner: &Corner, camera: &Camera) -> Self {
        let place = camera.model_view.map(|row| DVec3::from_slice(&row[..3]).dot(corner.place) + row[3]);
        let [nx, ny, nz] = corner.normal.to_array();
        let [red, green, blue] = corner.color.map(f64::from);
        Self { place: DVec3::from_array(place), attributes: [nx, ny, nz, red, green, blue] }
    }

    /// Where the way to another corner has this distance.
    fn toward(&self, other: &Self, distance: f64) -> Self {
        let share = (distance - self.place.z) / (other.place.z - self.place.z);
        let attributes =
            std::array::from_fn(|i| self.attributes[i] + share * (other.attributes[i] - self.attributes[i]));
        Self { place: self.place.lerp(other.place, share), attributes }
    }
}

/// What of a triangle lies beyond the near plane: three or four corners, or none.
fn beyond_near(corners: [Seen; 3], near: f64) -> Vec<Seen> {
    let mut kept = Vec::with_capacity(4);
    for (corner, next) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let [is_beyond, is_next_beyond] = [corner, next].map(|seen| seen.place.z >= near);
        if is_beyond {
            kept.push(*corner);
        }
        if is_beyond != is_next_beyond {
            kept.push(corner.toward(next, near));
        }
    }
    kept
}

/// Samples of a row or a column that may lie between two places, px.
fn between(low: f64, high: f64, samples_a_pixel: usize, count: usize) -> Range<usize> {
    // A pixel more on either side: samples need not lie in its middle.
    let [first, past] = [(low - 1.0).floor(), (high + 2.0).ceil()].map(|pixel| pixel.max(0.0) as usize);
    (first * samples_a_pixel).min(count)..(past * samples_a_pixel).min(count)
}

impl Layer {
    /// Draws the triangles of a scene, if it has any, as the camera sees them.
    #[must_use]
    pub fn of(scene: &Scene) -> Option<Self> {
        if scene.triangles.is_empty() {
            return None;
        }
        let Rendering { width, height, .. } = scene.rendering;
        let mut layer = Self { width, pixels: vec![None; width * height] };
        for triangle in &scene.triangles {
            layer.draw(triangle, &scene.camera, scene.rendering.sampling);
        }
        Some(layer)
    }

    fn draw(&mut self, triangle: &Triangle, camera: &Camera, sampling: Sampling) {
        let corners = triangle.corners.each_ref().map(|corner| Seen::of(corner, camera));
        let kept = beyond_near(corners, camera.near);
        for second in 1..kept.len().saturating_sub(1) {
            self.fill([kept[0], kept[second], kept[second + 1]], triangle.material, camera, sampling);
        }
    }

    /// Fills the samples within a triangle that lies beyond the near plane.
    fn fill(&mut self, corners: [Seen; 3], material: u16, camera: &Camera, sampling: Sampling) {
        let Camera { scale_x, scale_y, center_x, center_y, depth_a, depth_b, .. } = *camera;
        let places = corners.map(|Seen { place, .. }| {
            DVec2::new(center_x + scale_x * place.x / place.z, center_y + scale_y * place.y / place.z)
        });
        let twice_area = (places[1] - places[0]).perp_dot(places[2] - places[0]);
        if twice_area == 0.0 || !twice_area.is_finite() {
            return;
        }
        let [low, high] = [DVec2::min, DVec2::max].map(|least| least(least(places[0], places[1]), places[2]));
        let height = self.pixels.len() / self.width;
        for row in between(low.y, high.y, 1, height) {
            for column in between(low.x, high.x, sampling.columns() as usize, self.width) {
                let sample = DVec2::from_array(sampling::position(sampling, column, row));
                let share = |i: usize| {
                    let [from, to] = [places[(i + 1) % 3], places[(i + 2) % 3]];
                    (to - from).perp_dot(sample - from) / twice_area
                };
                let shares = [share(0), share(1), share(2)];
                if shares.iter().any(|share| *share < 0.0) {
                    continue;
                }
                // The reciprocal of the distance is linear on the screen, and so is what is divided by the distance.
                let weights = [0, 1, 2].map(|i| shares[i] / corners[i].place.z);
                let reciprocal: f64 = weights.iter().sum();
                let depth = depth_a + depth_b * reciprocal;
                let pixel = &mut self.pixels[row * self.width + column];
                if depth >= 1.0 || pixel.as_ref().is_some_and(|found| found.depth <= depth) {
                    continue;
                }
                let mut attributes: [f64; 6] = std::array::from_fn(|a| {
                    (0..3).map(|i| weights[i] * corners[i].attributes[a]).sum::<f64>() / reciprocal
                });
                face_the_eye(&mut attributes, sample, camera);
                *pixel = Some(Fragment { depth, weight: 1.0, attributes, material });
            }
        }
    }

    /// The depths that lie in memory of the hardware.
    #[must_use]
    pub fn depths(&self, config: &Config) -> Depths {
        Depths::of_fragments(config, self.width, &self.pixels)
    }

    /// Takes from a frame of splats what lies behind triangles. How near a surface came to one is a margin of its depth test.
    pub fn hide(&self, splats: &mut Frame) {
        for ((splat, margins), triangle) in splats.pixels.iter_mut().zip(&mut splats.margins).zip(&self.pixels) {
            let (Some(found), Some(triangle)) = (&*splat, triangle) else { continue };
            // As memory has it.
            let stored = f64::from(triangle.depth as f32);
            margins.depth = margins.depth.min((found.depth - stored).abs());
            if found.depth >= stored {
                *splat = None;
            }
        }
    }

    /// What is seen in a sample without splats.
    #[must_use]
    pub fn at(&self, sample: usize) -> Option<&Fragment> {
        self.pixels[sample].as_ref()
    }
}

/// Turns a normal over where the eye is behind the surface: triangles are seen from both sides.
fn face_the_eye(attributes: &mut [f64; 6], sample: DVec2, camera: &Camera) {
    let ray =
        DVec3::new((sample.x - camera.center_x) / camera.scale_x, (sample.y - camera.center_y) / camera.scale_y, 1.0);
    let normal = DVec3::from_slice(&attributes[..3]);
    let seen = camera.model_view.map(|row| DVec3::from_slice(&row[..3]).dot(normal));
    if DVec3::from_array(seen).dot(ray) > 0.0 {
        attributes[..3].iter_mut().for_each(|component| *component = -*component);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Plan;
    use crate::scene::Disc;
    use crate::splat::{RenderEngine, RenderSession};
    use pointcore_contract::splat::Feature;
    use pointcore_contract::surface::COLOR;

    /// Two discs one behind the other, red and green, and a triangle in blue that stands across both, from before them to behind them.
    fn scene() -> Scene {
        let disc = |z: f64, color| Disc::new(DVec3::new(0.0, 0.0, z), DVec3::Z, 2.0).colored(color);
        let discs = vec![disc(0.0, [1.0, 0.0, 0.0]), disc(-1.0, [0.0, 1.0, 0.0])];
        let corner = |place: [f64; 3]| Corner {
            place: DVec3::from_array(place),
            normal: DVec3::new(0.0, 1.0, 1.0).normalize(),
            color: [0.0, 0.0, 1.0],
        };
        // The upper half lies before the red disc, the lower one behind the green one.
        let corners = [[-3.0, 2.5, 1.0], [3.0, 2.5, 1.0], [0.0, -2.5, -2.0]].map(corner);
        let triangles = vec![Triangle { corners, material: 0 }];
        let scene = Scene::of(discs).image(48, 48).camera([0.0, 0.0, 8.0], [0.0; 3], 40.0).triangles(triangles);
        scene.build().expect("it is good")
    }

    #[test]
    fn the_nearest_is_seen_and_depth_is_that_of_the_plane() {
        let scene = scene();
        let layer = Layer::of(&scene).expect("there is a triangle");
        let Camera { depth_a, depth_b, .. } = scene.camera;
        // In the middle the plane has z = −0.5.
        let middle = layer.at(24 * 48 + 24).expect("the triangle is there");
        let distance = depth_b / (middle.depth - depth_a) * scene.placement.unit;
        assert!((distance - 8.5).abs() < 0.1, "{distance}");
        let off = DVec3::from_slice(&middle.attributes[COLOR]).distance(DVec3::Z);
        assert!(off < 1e-9 && layer.at(48 * 48 - 1).is_none(), "{off}");
    }

    #[test]
    fn hardware_sends_what_is_seen_before_triangles() {
        let mut session = RenderSession::open(scene(), RenderEngine::Golden).expect("hardware for it is generated");
        assert!(session.plan().config.merge.is_on());
        let frame = session.frame(0).expect("it renders");
        let reference = session.reference();
        let covered = |frame: &Frame| frame.pixels.iter().map(Option::is_some).collect::<Vec<_>>();
        assert_eq!(covered(&frame.samples), covered(&reference));
        let sent = frame.fragments.len() as u64;
        let hidden = frame.outcome.counters.events.hidden;
        assert!(sent > 300 && hidden > 100, "{sent} are seen, {hidden} hidden");
        // From above: the triangle, then red with the triangle behind it.
        let color = |row: usize| frame.picture.pixels[row * 48 + 24];
        let [above, middle] = [14, 26].map(color);
        assert!(above[2] > above[0] && middle[0] > middle[2], "{above:?} {middle:?}");
        let without = Plan::on(&scene(), &Config { merge: Feature::Off, ..session.plan().config.clone() });
        let message = without.expect_err("triangles need depths").to_string();
        assert!(message.contains("set `merge = \"on\"`"), "{message}");
    }

    #[test]
    fn surfaces_are_drawn_one_after_the_other_and_do_not_blend() {
        // Both discs at the same place but for less than blends.
        let mut scene = scene();
        scene.triangles.clear();
        for splat in &mut scene.splats {
            splat.center[2] *= 1e-3;
        }
        let color = |scene: &Scene| {
            let mut session = RenderSession::open(scene.clone(), RenderEngine::Golden).expect("it is generated");
            let frame = session.frame(0).expect("it renders");
            let ends = frame.samples.pixels.iter().flatten().count();
            assert_eq!(ends, session.reference().pixels.iter().flatten().count());
            frame.samples.pixels[24 * 48 + 24].as_ref().expect("both are there").attributes[COLOR].to_vec()
        };
        let blended = color(&scene);
        assert!(blended[0] > 0.4 && blended[1] > 0.4, "{blended:?}");
        for surfaces in [[0..1, 1..2], [1..2, 0..1]] {
            let mut apart = Scene { surfaces: surfaces.to_vec(), ..scene.clone() };
            if surfaces[0].start > 0 {
                apart.splats.reverse();
                apart.surfaces = vec![0..1, 1..2];
            }
            let color = color(&apart);
            assert!(color[0] > 0.99 && color[1] < 0.01, "{color:?}");
        }
    }

    #[test]
    fn what_reaches_behind_the_eye_is_cut_at_the_near_plane() {
        let mut scene = scene();
        scene.triangles[0].corners[1].place = DVec3::new(1.0, 1.0, 30.0);
        let layer = Layer::of(&scene).expect("there is a triangle");
        let seen = layer.pixels.iter().flatten().count();
        assert!(seen > 50 && layer.pixels.iter().flatten().all(|found| (0.0..1.0).contains(&found.depth)), "{seen}");
    }
}
