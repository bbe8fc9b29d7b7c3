//! The screen filter of splats that move: their hardware has none, so a splat that is narrower on the screen is sent with the filter's disc beside it.
//!
//! Both together cover what the filter has them cover (thesis 5.4.2), where one of two distances counts, the smaller. Where they overlap both weights
//! count, not the larger. The disc alone is sent where the splat does not reach beyond it. It is there while the splat faces the eye.
//!
//! On the screen a splat's tangents are the columns of a matrix `P = UΣVᵀ`, affine about its center; those of the disc are `rUVᵀ`, `r` the filter's
//! radius. What they differ by lies in a plane parallel to the image, at the distance of the splat in the middle of its way: the disc lies in space
//! as the splat does, and blends with as much before and behind it.

use crate::scene::Scene;
use glam::{DMat2, DMat3, DVec2, DVec3};
use pointcore_contract::Splat;
use pointcore_golden::reference::motion::{Interval, MovingSplat};

/// From splats' space to the screen.
pub(crate) struct Lens {
    /// Splats' space to camera space.
    rotation: DMat3,
    translation: DVec3,
    /// Pixels at a distance of one.
    scale: DVec2,
    near: f64,
    /// Of the filter, px.
    radius: Option<f64>,
}

impl Lens {
    /// That of a scene's camera and filter.
    pub fn of(scene: &Scene) -> Self {
        let camera = &scene.camera;
        let [x, y, z] = camera.model_view.map(|row| DVec3::from_slice(&row));
        Self {
            rotation: DMat3::from_cols(x, y, z).transpose(),
            translation: camera.model_view.map(|row| row[3]).into(),
            scale: DVec2::new(camera.scale_x.abs(), camera.scale_y.abs()),
            near: camera.near,
            radius: scene.rendering.filter_radius_px,
        }
    }

    /// What is sent of a splat: itself, and the filter's disc.
    pub fn sent(&self, moving: &MovingSplat) -> [Option<MovingSplat>; 2] {
        let itself = || Some(moving.clone());
        let Some((radius, part)) = self.radius.zip(self.facing(moving)) else { return [itself(), None] };
        let later = part.middle() - moving.part.middle();
        let center = double(moving.splat.center) + later * moving.motion;
        let seen = self.rotation * center + self.translation;
        let distance = seen.z.max(self.near);
        let per_px = self.scale.recip() * distance;
        let on_screen = |tangent: [f32; 3]| {
            let tangent = self.rotation * double(tangent);
            (tangent.truncate() - seen.truncate() * (tangent.z / distance)) / per_px
        };
        let [first, second] = moving.splat.tangents;
        let p = DMat2::from_cols(on_screen(first), on_screen(second));
        let Ellipse { longer, shorter, circle } = Ellipse::of(p);
        if shorter >= radius {
            return [itself(), None];
        }
        let gain = circle * radius - p;
        let grown = |tangent: [f32; 3], gain: DVec2| {
            let gain = self.rotation.transpose() * (gain * per_px).extend(0.0);
            (double(tangent) + gain).as_vec3().to_array()
        };
        let tangents = [grown(first, gain.x_axis), grown(second, gain.y_axis)];
        let splat = Splat { center: center.as_vec3().to_array(), tangents, ..moving.splat.clone() };
        [itself().filter(|_| longer > radius), Some(MovingSplat { splat, motion: moving.motion, part })]
    }

    /// The time for which a splat faces the eye.
    fn facing(&self, moving: &MovingSplat) -> Option<Interval> {
        let [first, second] = moving.splat.tangents.map(|tangent| self.rotation * double(tangent));
        let (normal, way) = (first.cross(second), self.rotation * moving.motion);
        let center = self.rotation * double(moving.splat.center) + self.translation - moving.part.middle() * way;
        moving.part.where_positive(-center.dot(normal), -way.dot(normal))
    }
}

/// The ellipse that the columns of a matrix `UΣVᵀ` span.
struct Ellipse {
    /// Its semi-axes, `Σ`.
    longer: f64,
    shorter: f64,
    /// `UVᵀ`, turned as of a splat that faces the eye, for which the matrix' determinant is negative.
    circle: DMat2,
}

impl Ellipse {
    fn of(p: DMat2) -> Self {
        let square = p * p.transpose();
        let [a, b, c] = [square.x_axis.x, square.x_axis.y, square.y_axis.y];
        let left = DVec2::from_angle(0.5 * (2.0 * b).atan2(a - c));
        let right = p.transpose() * left;
        let longer = right.length();
        let shorter = if longer > 0.0 { p.determinant().abs() / longer } else { 0.0 };
        let right = right.try_normalize().unwrap_or(DVec2::X);
        let outer = |left: DVec2, right: DVec2| DMat2::from_cols(left * right.x, left * right.y);
        Self { longer, shorter, circle: outer(left, right) - outer(left.perp(), right.perp()) }
    }
}

fn double(vector: [f32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;

    /// Ten pixels wide at a distance of one, a filter of one pixel, and its eye at the origin.
    const LENS: Lens = Lens {
        rotation: DMat3::IDENTITY,
        translation: DVec3::ZERO,
        scale: DVec2::splat(10.0),
        near: 0.5,
        radius: Some(1.0),
    };

    /// At a distance of two, where a pixel is 0.2, in the middle of the second half of the exposure.
    fn moving(tangents: [[f32; 3]; 2], motion: DVec3) -> MovingSplat {
        let attributes = [0.0; CONTINUOUS_ATTRIBUTES];
        let splat = Splat { center: [0.0, 0.0, 2.0], tangents, attributes, material: 0 };
        MovingSplat { splat, motion, part: Interval { begin: 0.0, end: 1.0 } }
    }

    #[test]
    fn a_disc_is_sent_beside_what_is_narrower_and_in_place_of_what_is_smaller() {
        let facing = |width: f32, height: f32| moving([[width, 0.0, 0.3], [0.0, -height, 0.0]], DVec3::X);
        let is_sent = |moving: &MovingSplat| LENS.sent(moving).map(|sent| sent.is_some());
        assert_eq!(is_sent(&facing(0.5, 0.3)), [true, false]);
        assert_eq!(is_sent(&facing(0.5, 0.1)), [true, true]);
        assert_eq!(is_sent(&facing(0.1, 0.0)), [false, true]);
        let none = Lens { radius: None, ..LENS };
        assert_eq!(none.sent(&facing(0.0, 0.0)).map(|sent| sent.is_some()), [true, false]);
    }

    #[test]
    fn a_disc_is_round_on_the_screen_and_as_deep_as_its_splat() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut discs = 0;
        for _ in 0..10_000 {
            let mut vector = || [(); 3].map(|()| random.f32() - 0.5);
            let sent = moving([vector(), vector()], DVec3::from(vector().map(f64::from)));
            let [_, Some(disc)] = LENS.sent(&sent) else { continue };
            let center = double(disc.splat.center);
            let on_screen = |tangent: [f32; 3]| {
                let tangent = double(tangent);
                (tangent - center * (tangent.z / center.z)).truncate() * (10.0 / center.z)
            };
            let [first, second] = disc.splat.tangents.map(on_screen);
            let near = |a: f64, b: f64| (a - b).abs() < 1e-5;
            assert!(near(first.length(), 1.0) && near(second.length(), 1.0) && near(first.perp_dot(second), -1.0));
            assert_eq!(disc.splat.tangents.map(|tangent| tangent[2]), sent.splat.tangents.map(|tangent| tangent[2]));
            discs += 1;
        }
        assert!(discs > 500, "{discs}");
    }

    #[test]
    fn a_disc_is_there_while_its_splat_faces_the_eye() {
        let away = moving([[0.5, 0.0, 0.0], [0.0, 0.1, 0.0]], DVec3::X);
        assert!(LENS.sent(&away)[1].is_none());
        // Its plane holds the eye in the middle of its way.
        let turning = moving([[0.0, 0.5, 0.0], [0.0, 0.0, 0.5]], DVec3::X);
        let disc = LENS.sent(&turning)[1].clone().expect("it faces the eye for half of the time");
        assert_eq!(disc.part, Interval { begin: 0.0, end: 0.5 });
        assert_eq!(disc.splat.center, [-0.25, 0.0, 2.0]);
    }
}
