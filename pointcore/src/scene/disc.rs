//! Discs in world space, and where in it the splats' single precision counts from.

use glam::DVec3;
use pointcore_contract::Splat;
use pointcore_contract::surface::NORMAL;

/// Coordinates this many times larger than the scene would cost it four of the 24 bits of single precision.
const OFFSET_LIMIT: f64 = 16.0;
/// Sizes of scenes whose squares and cubes keep well within single precision.
const SIZE_RANGE: std::ops::Range<f64> = 1e-3..1e6;

/// Which side of a disc is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// That of its normal; from behind it is culled.
    #[default]
    Front,
    /// Both: it is turned over where the eye is behind it.
    Both,
    /// It has no normal, and faces the eye, wherever that is.
    Eye,
}

/// A surface splat in world space, in f64.
#[derive(Clone, Debug, PartialEq)]
pub struct Disc {
    /// Its center.
    pub center: DVec3,
    /// Two radii across each other; their cross product points out of the surface.
    pub tangents: [DVec3; 2],
    /// Unit normal of the surface.
    pub normal: DVec3,
    /// Linear RGB, each component in `0..=1`.
    pub color: [f32; 3],
    /// Index into the scene's materials.
    pub material: u16,
    /// Which side of it is seen.
    pub sides: Sides,
}

impl Disc {
    /// A white disc about a normal of any length; without one (zero) it faces the eye.
    #[must_use]
    pub fn new(center: DVec3, normal: DVec3, radius: f64) -> Self {
        match normal.try_normalize() {
            Some(unit) => Self::about(center, unit, radius),
            None => Self { sides: Sides::Eye, ..Self::about(center, DVec3::Z, radius) },
        }
    }

    /// A white disc about a unit normal.
    pub(super) fn about(center: DVec3, normal: DVec3, radius: f64) -> Self {
        // Any two axes of a circle will do.
        let (first, second) = normal.any_orthonormal_pair();
        let tangents = [radius * first, radius * second];
        Self { center, tangents, normal, color: [1.0; 3], material: 0, sides: Sides::Front }
    }

    /// The same disc in a linear color.
    #[must_use]
    pub const fn colored(self, color: [f32; 3]) -> Self {
        Self { color, ..self }
    }

    /// Its larger radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.tangents[0].length().max(self.tangents[1].length())
    }
}

/// Where splats' coordinates count from, and in what unit: single precision resolves a scene anywhere, of any size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The splats' origin in world space.
    pub origin: DVec3,
    /// World units in one of the splats', a power of two.
    pub unit: f64,
}

impl Placement {
    /// World space itself.
    pub const WORLD: Self = Self { origin: DVec3::ZERO, unit: 1.0 };

    /// World space for scenes of usual size around the origin; else the middle of the discs, and a unit of about their size.
    #[must_use]
    pub fn of(discs: &[Disc]) -> Self {
        let Some([low, high]) = bounds(discs) else { return Self::WORLD };
        let (middle, size) = ((low + high) / 2.0, (high - low).length());
        let origin = if middle.abs().max_element() > OFFSET_LIMIT * size { middle } else { DVec3::ZERO };
        let unit = if size > 0.0 && !SIZE_RANGE.contains(&size) { size.log2().floor().exp2() } else { 1.0 };
        Self { origin, unit }
    }

    /// A place as splats have it.
    #[must_use]
    pub fn place(&self, world: DVec3) -> DVec3 {
        (world - self.origin) / self.unit
    }

    /// The disc as a splat.
    #[must_use]
    pub fn splat(&self, disc: &Disc) -> Splat {
        let [nx, ny, nz] = disc.normal.as_vec3().to_array();
        let [red, green, blue] = disc.color;
        Splat {
            center: self.place(disc.center).as_vec3().to_array(),
            tangents: disc.tangents.map(|tangent| (tangent / self.unit).as_vec3().to_array()),
            attributes: [nx, ny, nz, red, green, blue],
            material: disc.material,
        }
    }
}

/// Opposite corners of the box around discs, their radii included.
#[must_use]
pub fn bounds(discs: &[Disc]) -> Option<[DVec3; 2]> {
    let corners = discs.iter().map(|disc| {
        let radius = DVec3::splat(disc.radius());
        [disc.center - radius, disc.center + radius]
    });
    corners.reduce(|[low, high], [next_low, next_high]| [low.min(next_low), high.max(next_high)])
}

/// Turns a splat so that an eye at `eye`, in the splats' coordinates, sees it.
pub(super) fn turn(splat: &mut Splat, sides: Sides, eye: DVec3) {
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let [first, second] = splat.tangents.map(vector);
    let to_eye = eye - vector(splat.center);
    match sides {
        Sides::Front => {}
        Sides::Both => {
            if first.cross(second).dot(to_eye) < 0.0 {
                splat.tangents.swap(0, 1);
                splat.attributes[NORMAL].iter_mut().for_each(|component| *component = -*component);
            }
        }
        Sides::Eye => {
            let Some(normal) = to_eye.try_normalize() else { return };
            let (across, along) = normal.any_orthonormal_pair();
            let radii = [first.length(), second.length()];
            splat.tangents = [radii[0] * across, radii[1] * along].map(|tangent| tangent.as_vec3().to_array());
            splat.attributes[NORMAL].copy_from_slice(&normal.as_vec3().to_array());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_of_usual_size_stay_where_they_are() {
        let disc = |center| Disc::new(center, DVec3::Z, 0.1);
        assert_eq!(Placement::of(&[disc(DVec3::ZERO), disc(DVec3::ONE)]), Placement::WORLD);
        assert_eq!(Placement::of(&[]), Placement::WORLD);
    }

    #[test]
    fn far_and_tiny_scenes_keep_their_digits() {
        let center = DVec3::new(500_000.0, 5_000_000.0, 100.0);
        let far = [0.0, 0.015_625].map(|offset| Disc::new(center + offset, DVec3::Z, 0.1));
        let placement = Placement::of(&far);
        let [first, second] = far.each_ref().map(|disc| placement.splat(disc).center[1]);
        assert_eq!(second - first, 0.015_625, "single precision has no such difference at five million");
        let tiny = [0.0, 1e-6].map(|x| Disc::new(DVec3::splat(x), DVec3::Z, 1e-8));
        let unit = Placement::of(&tiny).unit;
        assert!((0.5e-6..2e-6).contains(&unit) && unit.log2().fract() == 0.0, "{unit}");
    }

    #[test]
    fn discs_are_turned_towards_the_eye() {
        let facing = |splat: &Splat, eye: DVec3| {
            let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
            let across = vector(splat.tangents[0]).cross(vector(splat.tangents[1])).normalize();
            let normal = DVec3::from_slice(&splat.attributes[NORMAL].iter().map(|&x| x.into()).collect::<Vec<_>>());
            assert!(normal.dot(across) > 0.999);
            across.dot((eye - vector(splat.center)).normalize())
        };
        let splat = |normal| Placement::WORLD.splat(&Disc::new(DVec3::X, normal, 0.5));
        let behind = DVec3::new(1.0, 0.0, -3.0);
        for (sides, expected) in [(Sides::Front, -1.0), (Sides::Both, 1.0), (Sides::Eye, 1.0)] {
            let mut turned = splat(DVec3::Z);
            turn(&mut turned, sides, behind);
            assert!((facing(&turned, behind) - expected).abs() < 1e-6, "{sides:?}");
        }
        let mut seen = splat(DVec3::NEG_Z);
        turn(&mut seen, Sides::Both, behind);
        assert_eq!(seen, splat(DVec3::NEG_Z), "it faced the eye before");
        assert_eq!(Disc::new(DVec3::ZERO, DVec3::ZERO, 1.0).sides, Sides::Eye);
    }
}
