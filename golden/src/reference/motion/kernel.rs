//! A moving splat on the screen: the samples it may reach, when it covers one, how strongly, and how deep it lies there.

use super::disc::MovingDisc;
use super::distance::SquaredDistance;
use super::interval::Interval;
use super::shutter::Shutter;
use super::{MovingSplat, Place};
use crate::reference::footprint::{Footprint, Mapping, extent};
use crate::reference::projection::{Bounds, Culled, Projection, in_camera_space};
use crate::reference::reconstruction::Band;
use glam::DVec3;
use pointcore_contract::{Camera, FragmentDepth, Rendering, Splat};

/// A time for which a sample is covered, with its distance from the splat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// When.
    pub interval: Interval,
    /// How far from the splat's center.
    pub squared_distance: SquaredDistance,
}

/// A splat ready to be sampled.
#[derive(Clone, Debug)]
pub struct Kernel<'a> {
    /// The splat.
    pub splat: &'a Splat,
    /// The samples it may reach.
    pub bounds: Bounds,
    shape: Shape,
}

#[derive(Clone, Debug)]
enum Shape {
    /// The static renderer's own, for the same bits.
    Still {
        projection: Box<Projection>,
        footprint: Box<Footprint>,
    },
    Moving(Box<Moving>),
}

/// The way of a splat in camera space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// The center at `τ = 0`.
    pub center: DVec3,
    /// Its way in a unit of `τ`.
    pub motion: DVec3,
    /// The tangents, which stay.
    pub tangents: [DVec3; 2],
    /// The part of the exposure for which it is there.
    pub part: Interval,
}

#[derive(Clone, Debug)]
pub(super) struct Moving {
    /// At `τ = 0`, in camera space.
    pub center: DVec3,
    pub motion: DVec3,
    pub tangents: [DVec3; 2],
    /// While it faces the eye, and some of it lies beyond the near and before the far plane.
    pub life: Interval,
    disc: MovingDisc,
    filter: Option<Filter>,
}

/// The screen filter as a disc parallel to the image, as large on the screen as the filter in the middle of its life.
#[derive(Clone, Debug)]
struct Filter {
    /// While the splat's center lies between near and far plane.
    life: Interval,
    disc: MovingDisc,
    /// Its radius on the screen times its distance from the eye.
    radius_px_times_distance: f64,
}

/// Where `z ≥` the near plane's distance and `≤` the far plane's, `z = at_zero + τ·slope`.
fn between_planes(interval: Interval, [at_zero, slope]: [f64; 2], camera: &Camera) -> Option<Interval> {
    let (a, b) = (camera.depth_a, camera.depth_b);
    interval.where_positive(a * at_zero + b, a * slope)?.where_positive((1.0 - a) * at_zero - b, (1.0 - a) * slope)
}

impl Filter {
    fn new(life: Interval, center: DVec3, motion: DVec3, camera: &Camera, rendering: &Rendering) -> Option<Self> {
        let radius_px = rendering.filter_radius_px?;
        let life = between_planes(life, [center.z, motion.z], camera)?;
        let distance = center.z + life.middle() * motion.z;
        let radius = radius_px * distance;
        let tangents = [DVec3::X * (radius / camera.scale_x), DVec3::Y * (radius / camera.scale_y)];
        Some(Self { life, disc: MovingDisc::new(center, motion, tangents), radius_px_times_distance: radius })
    }
}

impl Moving {
    pub fn new(moving: &MovingSplat, camera: &Camera, rendering: &Rendering) -> Result<Self, Culled> {
        let (middle, tangents) = in_camera_space(&moving.splat, camera);
        let rotation = camera.model_view.map(|row| DVec3::from_slice(&row));
        let motion = DVec3::from_array(rotation.map(|row| row.dot(moving.motion)));
        let way = Way { center: middle - moving.part.middle() * motion, motion, tangents, part: moving.part };
        Self::along(&way, camera, rendering)
    }

    /// Of a splat in camera space.
    pub fn along(way: &Way, camera: &Camera, rendering: &Rendering) -> Result<Self, Culled> {
        let Way { center, motion, tangents, part } = *way;
        let disc = MovingDisc::new(center, motion, tangents);
        let [volume, change] = disc.volume();
        let life = part.where_positive(-volume, -change).ok_or(Culled::BackFacing)?;
        // The nearest and the farthest of its points.
        let reach = tangents[0].z.hypot(tangents[1].z);
        let (a, b) = (camera.depth_a, camera.depth_b);
        let life = life
            .where_positive(center.z + reach - camera.near, motion.z)
            .and_then(|life| life.where_positive((1.0 - a) * (center.z - reach) - b, (1.0 - a) * motion.z))
            .ok_or(Culled::OutsideDepth)?;
        let filter = Filter::new(life, center, motion, camera, rendering);
        Ok(Self { center, motion, tangents, life, disc, filter })
    }

    fn projection(&self, time: f64, camera: &Camera) -> Projection {
        Projection::set_up(self.center + time * self.motion, self.tangents, camera)
    }

    /// Every point of the splat moves along a line, also on the screen: what it sweeps lies within the hull of where it begins and ends.
    pub fn bounds(&self, camera: &Camera, rendering: &Rendering) -> Result<Bounds, Culled> {
        let at = |time: f64| {
            let distance = self.center.z + time * self.motion.z;
            let radius_px = self.filter.as_ref().map_or(0.0, |filter| filter.radius_px_times_distance / distance);
            extent(&self.projection(time, camera), radius_px)
        };
        let (Some(begin), Some(end)) = (at(self.life.begin), at(self.life.end)) else {
            return Ok(Bounds::viewport(rendering));
        };
        let corner = |corner: usize, choose: fn(f64, f64) -> f64| {
            [0, 1].map(|axis: usize| choose(begin[corner][axis], end[corner][axis]))
        };
        Bounds::of_samples(corner(0, f64::min), corner(1, f64::max), rendering)
    }

    /// When the splat itself and its filter cover a place; the smaller distance counts, as in the static renderer.
    fn pieces(&self, ray: DVec3, camera: &Camera) -> Vec<Piece> {
        let piece = |squared_distance: SquaredDistance, life: Interval| {
            let interval = squared_distance.within_kernel(life)?;
            Some(Piece { interval, squared_distance })
        };
        let on_splat = self.disc.meet(ray).and_then(|meeting| {
            let life = between_planes(self.life, meeting.distance, camera)?;
            piece(meeting.squared_distance, life)
        });
        let on_screen =
            self.filter.as_ref().and_then(|filter| piece(filter.disc.meet(ray)?.squared_distance, filter.life));
        match (on_splat, on_screen) {
            (Some(on_splat), Some(on_screen)) => nearer_of(on_splat, on_screen),
            (one, other) => one.or(other).into_iter().collect(),
        }
    }
}

/// The union of two pieces' times, with the smaller distance of those there are.
fn nearer_of(first: Piece, second: Piece) -> Vec<Piece> {
    let ends = [first, second].map(|piece| [piece.interval.begin, piece.interval.end]);
    let crossings = first.squared_distance.crossings(&second.squared_distance);
    let mut cuts: Vec<f64> = ends.into_iter().flatten().chain(crossings.into_iter().flatten()).collect();
    cuts.sort_by(f64::total_cmp);
    let mut pieces: Vec<Piece> = Vec::with_capacity(cuts.len());
    for interval in cuts.windows(2).filter_map(|ends| Interval::new(ends[0], ends[1])) {
        let middle = interval.middle();
        let nearest = [first, second]
            .into_iter()
            .filter(|piece| piece.interval.contains(middle))
            .min_by(|a, b| a.squared_distance.at(middle).total_cmp(&b.squared_distance.at(middle)));
        let Some(Piece { squared_distance, .. }) = nearest else { continue };
        match pieces.last_mut() {
            Some(last) if last.squared_distance == squared_distance && last.interval.end == interval.begin => {
                last.interval.end = interval.end;
            }
            _ => pieces.push(Piece { interval, squared_distance }),
        }
    }
    pieces
}

impl<'a> Kernel<'a> {
    /// The kernel of a moving splat.
    ///
    /// # Errors
    /// As [`Projection::new`] and [`Footprint::new`], all the time.
    pub fn new(moving: &'a MovingSplat, camera: &Camera, rendering: &Rendering) -> Result<Self, Culled> {
        let splat = &moving.splat;
        if moving.is_still() {
            let projection = Projection::new(splat, camera)?;
            let footprint = Footprint::new(&projection, rendering, Mapping::Backward)?;
            let bounds = footprint.bounds.clone();
            let (projection, footprint) = (Box::new(projection), Box::new(footprint));
            return Ok(Self { splat, bounds, shape: Shape::Still { projection, footprint } });
        }
        let shape = Moving::new(moving, camera, rendering)?;
        Ok(Self { splat, bounds: shape.bounds(camera, rendering)?, shape: Shape::Moving(Box::new(shape)) })
    }

    /// Whether it is where it is for all of the exposure.
    #[must_use]
    pub const fn is_still(&self) -> bool {
        matches!(self.shape, Shape::Still { .. })
    }

    /// When it covers a sample, in the order of time.
    #[must_use]
    pub fn pieces(&self, place: &Place, camera: &Camera) -> Vec<Piece> {
        match &self.shape {
            Shape::Still { footprint, .. } => {
                let squared = footprint.squared_distance(place.column, place.row);
                let squared_distance = SquaredDistance::still(squared);
                if squared < 1.0 { vec![Piece { interval: Interval::EXPOSURE, squared_distance }] } else { Vec::new() }
            }
            Shape::Moving(moving) => moving.pieces(place.ray(camera), camera),
        }
    }

    /// Depth and ε-band at a sample at a time, as the static renderer has them.
    #[must_use]
    pub fn band(&self, time: f64, place: &Place, camera: &Camera, rendering: &Rendering) -> Band {
        match &self.shape {
            Shape::Still { projection, footprint, .. } => {
                let depth = footprint.depth(projection, rendering, place.column, place.row);
                Band::around(depth, projection, rendering)
            }
            Shape::Moving(moving) => {
                let projection = moving.projection(time, camera);
                let [x, y] = [0, 1].map(|axis| place.position[axis] - projection.center[axis]);
                let depth = match rendering.depth {
                    FragmentDepth::Center => projection.depth,
                    FragmentDepth::Plane => projection.plane_depth(x, y),
                };
                Band::around(depth, &projection, rendering)
            }
        }
    }
}

/// What a splat does to one sample.
#[derive(Clone, Debug)]
pub struct Hit<'k> {
    /// The splat's kernel.
    pub kernel: &'k Kernel<'k>,
    /// When it covers the sample; not empty.
    pub pieces: Vec<Piece>,
}

impl Hit<'_> {
    /// The splat's share of the light that comes in during an interval: the integral of its kernel times the shutter.
    #[must_use]
    pub fn integral(&self, interval: Interval, shutter: Shutter, gamma: f64) -> f64 {
        let of_piece = |piece: &Piece| {
            let common = piece.interval.intersection(interval)?;
            Some(piece.squared_distance.integral(shutter, gamma, common))
        };
        self.pieces.iter().filter_map(of_piece).sum()
    }

    /// From the first to the last time within an interval at which the sample is covered.
    #[must_use]
    pub fn covered(&self, interval: Interval) -> Option<Interval> {
        self.pieces.iter().filter_map(|piece| piece.interval.intersection(interval)).reduce(Interval::hull)
    }

    /// Whether the sample is covered at a time.
    #[must_use]
    pub fn covers(&self, time: f64) -> bool {
        self.pieces.iter().any(|piece| piece.interval.contains(time))
    }
}
