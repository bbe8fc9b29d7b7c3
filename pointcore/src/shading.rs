//! Deferred shading on the host (thesis 5.4.6): reconstructed fragments become colors.
//!
//! Shading is linear and per pixel: Lambert's diffuse and Blinn's specular reflection of one distant light about the
//! reconstructed normal. The picture is sRGB.

use crate::color::{linear_from_srgb, srgb_from_linear};
use crate::picture::Picture;
use crate::scene::Scene;
use crate::triangles::Layer;
use glam::{DMat3, DVec3};
use pointcore_contract::surface::{COLOR, NORMAL};
use pointcore_contract::{Camera, Sampling};
use pointcore_golden::reference::motion::Exposure;
use pointcore_golden::reference::{Fragment, Frame, sampling};
use rayon::prelude::*;

/// Shades a frame of `scene`, from the reference or read back from hardware; its triangles are seen where no splat is.
#[must_use]
pub fn shade(frame: &Frame, scene: &Scene) -> Picture {
    let view = View::new(&scene.camera, scene);
    let triangles = Layer::of(scene);
    let pixel = |(index, fragment): (usize, &Option<Fragment>)| {
        let linear = match fragment.as_ref().or_else(|| triangles.as_ref()?.at(index)) {
            Some(fragment) => {
                let (column, row) = (index % frame.width, index / frame.width);
                let [x, y] = sampling::position(scene.rendering.sampling, column, row);
                view.shade(fragment, scene, x, y)
            }
            None => scene.background,
        };
        linear.map(srgb_from_linear)
    };
    let pixels = frame.pixels.par_iter().enumerate().map(pixel).collect();
    Picture { width: frame.width, height: frame.height, pixels }
}

/// Colors of fragments of `scene`, seen by a camera.
pub(crate) fn colors<'a>(
    scene: &'a Scene,
    camera: &Camera,
) -> impl Fn(&Fragment, [f64; 2]) -> [f64; 3] + Sync + use<'a> {
    let view = View::new(camera, scene);
    move |fragment, [x, y]| view.shade(fragment, scene, x, y)
}

/// The picture of an exposure of `scene`, whose pixels may have several samples.
#[must_use]
pub fn exposed(exposure: &Exposure, scene: &Scene) -> Picture {
    let pixels =
        exposure.samples.par_iter().map(|sample| sample.over(scene.background).map(srgb_from_linear)).collect();
    let samples = Picture { width: exposure.width, height: exposure.height, pixels };
    resolve(samples, scene.rendering.sampling, scene.samples)
}

/// The picture whose samples are another's pixels: `edge` × `edge` of them in a pixel, or those on its four sides. Means are those of linear light.
fn resolve(samples: Picture, sampling: Sampling, edge: usize) -> Picture {
    let mean = |width: usize, height: usize, of_pixel: &(dyn Fn(usize, usize) -> Vec<[usize; 2]> + Sync)| {
        let pixel = |index: usize| {
            let places = of_pixel(index % width, index / width);
            let linear =
                |[column, row]: &[usize; 2]| samples.pixels[row * samples.width + column].map(linear_from_srgb);
            let sum: DVec3 = places.iter().map(|place| DVec3::from_array(linear(place))).sum();
            (sum / places.len() as f64).to_array().map(srgb_from_linear)
        };
        Picture { width, height, pixels: (0..width * height).into_par_iter().map(pixel).collect() }
    };
    match (sampling, edge) {
        (Sampling::Center, 1) => samples,
        (Sampling::Center, edge) => mean(samples.width / edge, samples.height / edge, &|column, row| {
            (0..edge * edge).map(|i| [column * edge + i % edge, row * edge + i / edge]).collect()
        }),
        // Left, top, right and bottom: those on the right and at the bottom are the next pixels'.
        (Sampling::Flipquad, _) => mean(samples.width / 2 - 1, samples.height - 1, &|column, row| {
            vec![[2 * column, row], [2 * column + 1, row], [2 * column + 2, row], [2 * column + 1, row + 1]]
        }),
    }
}

/// Pixels a row and rows of [`picture`].
#[must_use]
pub fn picture_size(scene: &Scene) -> [usize; 2] {
    let (edge, [width, height]) = (scene.samples, [scene.rendering.width, scene.rendering.height]);
    match scene.rendering.sampling {
        Sampling::Center => [width / edge, height / edge],
        Sampling::Flipquad => [width / 2 - 1, height - 1],
    }
}

/// The picture of a frame of `scene`, whose pixels may have several samples.
#[must_use]
pub fn picture(frame: &Frame, scene: &Scene) -> Picture {
    resolve(shade(frame, scene), scene.rendering.sampling, scene.samples)
}

/// What all pixels of a picture share.
struct View {
    camera: Camera,
    world_from_camera: DMat3,
    to_light: DVec3,
}

impl View {
    fn new(camera: &Camera, scene: &Scene) -> Self {
        // A rotation's inverse is its transpose: the rows of the model-view matrix are the axes in world space.
        let axes = camera.model_view.map(|row| DVec3::from_slice(&row));
        Self {
            camera: *camera,
            world_from_camera: DMat3::from_cols(axes[0], axes[1], axes[2]),
            to_light: DVec3::from_array(scene.light.direction).normalize(),
        }
    }

    /// Linear color of a fragment seen at pixel position `(x, y)`.
    fn shade(&self, fragment: &Fragment, scene: &Scene, x: f64, y: f64) -> [f64; 3] {
        let camera = &self.camera;
        let ray = DVec3::new((x - camera.center_x) / camera.scale_x, (y - camera.center_y) / camera.scale_y, 1.0);
        let to_eye = -(self.world_from_camera * ray).normalize();
        // Opposite normals may cancel; such a pixel shows its surface face on.
        let normal = DVec3::from_slice(&fragment.attributes[NORMAL]).try_normalize().unwrap_or(to_eye);
        let material = scene.materials.get(usize::from(fragment.material)).copied().unwrap_or_default();

        let incidence = normal.dot(self.to_light).max(0.0);
        let highlight = match (self.to_light + to_eye).try_normalize() {
            Some(half_way) if incidence > 0.0 => normal.dot(half_way).max(0.0).powf(material.shininess),
            _ => 0.0,
        };
        let reflected = scene.light.ambient + scene.light.diffuse * incidence;
        let mirrored = scene.light.diffuse * material.specular * highlight;
        let color = &fragment.attributes[COLOR];
        [0, 1, 2].map(|component| color[component] * reflected + mirrored)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One white fragment with the given normal in the middle of the view, the light behind the eye.
    fn shade_one(normal: [f64; 3], material: u16) -> [f64; 3] {
        shade_under(0.6, normal, material)
    }

    fn shade_under(diffuse: f64, normal: [f64; 3], material: u16) -> [f64; 3] {
        let scene = Scene {
            camera: pointcore_contract::Camera {
                model_view: [[1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0]],
                scale_x: 1.0,
                scale_y: 1.0,
                center_x: 0.5,
                center_y: 0.5,
                depth_a: 2.0,
                depth_b: -2.0,
                near: 1.0,
            },
            rendering: pointcore_contract::Rendering {
                width: 2,
                height: 1,
                sampling: Sampling::Center,
                depth: pointcore_contract::FragmentDepth::Center,
                kernel_gamma: 2.0,
                filter_radius_px: None,
                epsilon_scale: 1.0,
                epsilon_bias: 0.0,
            },
            splats: Vec::new(),
            surfaces: Vec::new(),
            triangles: Vec::new(),
            light: crate::scene::Light { direction: [0.0, 0.0, 3.0], ambient: 0.1, diffuse },
            materials: [0.0, 0.5].map(|specular| crate::scene::Material { specular, shininess: 10.0 }).to_vec(),
            background: [0.0, 0.5, 1.0],
            samples: 1,
            overrides: toml::Table::new(),
            placement: crate::scene::Placement::WORLD,
            sides: Vec::new(),
            views: Vec::new(),
            notes: Vec::new(),
            motion: None,
        };
        let [x, y, z] = normal;
        let fragment = Fragment { depth: 0.5, weight: 1.0, attributes: [x, y, z, 1.0, 1.0, 1.0], material };
        let pixels = vec![Some(fragment), None];
        let frame = Frame {
            width: 2,
            height: 1,
            pixels,
            decisions: Vec::new(),
            margins: Vec::new(),
            statistics: Default::default(),
        };
        let picture = shade(&frame, &scene);
        assert_eq!(picture.pixels[1], [0.0, 0.5, 1.0].map(srgb_from_linear), "the background");
        picture.pixels[0].map(linear_from_srgb)
    }

    #[test]
    fn samples_are_averaged_in_linear_light() {
        let gray = |value: f64| [value; 3];
        let samples = [0.0, 1.0, 0.5, 0.5, 0.0, 1.0, 0.5, 0.5].map(gray);
        let picture = Picture { width: 4, height: 2, pixels: samples.to_vec() };
        let resolved = resolve(picture.clone(), Sampling::Center, 2);
        assert_eq!((resolved.width, resolved.height), (2, 1));
        let expected = [srgb_from_linear(0.5), 0.5];
        for (pixel, expected) in resolved.pixels.iter().zip(expected) {
            assert!(pixel.iter().all(|component| (component - expected).abs() < 1e-6), "{pixel:?}");
        }
        assert_eq!(resolve(picture.clone(), Sampling::Center, 1), picture);
    }

    #[test]
    fn flipquad_pixels_share_the_samples_on_their_sides() {
        // Two pixels, three columns of left and top sides, two rows: only the sample on the side between both is white.
        let mut pixels = vec![[0.0; 3]; 6 * 2];
        pixels[2] = [1.0; 3];
        let resolved = resolve(Picture { width: 6, height: 2, pixels: pixels.clone() }, Sampling::Flipquad, 1);
        assert_eq!((resolved.width, resolved.height), (2, 1));
        assert!(resolved.pixels.iter().all(|pixel| (pixel[0] - srgb_from_linear(0.25)).abs() < 1e-9));
        // The sample below the second pixel.
        pixels = vec![[0.0; 3]; 6 * 2];
        pixels[6 + 3] = [1.0; 3];
        let resolved = resolve(Picture { width: 6, height: 2, pixels }, Sampling::Flipquad, 1);
        assert!(resolved.pixels[0][0].abs() < 1e-9 && (resolved.pixels[1][0] - srgb_from_linear(0.25)).abs() < 1e-9);
    }

    #[test]
    fn without_light_neither_normal_nor_material_is_read() {
        let bits = |normal, material| shade_under(0.0, normal, material).map(f64::to_bits);
        let unread = bits([0.0; 3], 0);
        for (normal, material) in [([0.0, 0.0, 1.0], 0), ([0.3, -0.2, 0.9], 1), ([1.0, 0.0, -1.0], 1)] {
            assert_eq!(bits(normal, material), unread, "{normal:?}, material {material}");
        }
        assert_ne!(shade_under(0.6, [0.0, 0.0, 1.0], 0).map(f64::to_bits), unread);
    }

    #[test]
    fn light_falls_by_the_cosine_and_highlights_by_the_material() {
        let close = |color: [f64; 3], expected: f64| color.iter().all(|component| (component - expected).abs() < 1e-6);
        assert!(close(shade_one([0.0, 0.0, 1.0], 0), 0.7), "ambient and full diffuse, of a normal of any length");
        assert!(close(shade_one([0.0, 0.0, 0.2], 1), 1.0), "the highlight adds 0.3");
        assert!(close(shade_one([3_f64.sqrt(), 0.0, 1.0], 0), 0.4), "at 60 degrees half the light");
        assert!(close(shade_one([0.0, 1.0, -0.1], 1), 0.1), "turned away, only ambient");
    }
}
