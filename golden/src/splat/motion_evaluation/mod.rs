//! Evaluation of splats that move while the shutter is open (thesis chapter 4): the time for which a sample is covered, the depth then, and the
//! kernel's integral over each bin of the exposure.
//!
//! All in the geometry format but the tables' sums, which are integers. The error of a share and what it hangs on are derived in
//! docs/units/splat/motion_evaluation.md; `tests.rs` holds it against f64.

mod course;
mod share;
#[cfg(test)]
mod tests;

use super::parts::division::recip;
use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::unit::Model;
use course::Course;
use pointcore_contract::splat::config::{DEPTH_BITS, TILE_SIZE};
use pointcore_contract::splat::motion::{TIME_BITS, TIME_FRACTION_BITS};
use pointcore_contract::splat::records::{MovingFootprint, MovingPlace, MovingSample};
pub use pointcore_contract::splat::units::motion_evaluation::{In, Out};
use pointcore_contract::splat::{Config, Division};
use pointcore_contract::{Format, Sampling};
use share::Kernel;
use std::iter;

/// The evaluation unit.
#[derive(Clone, Debug)]
pub struct MotionEvaluation {
    geometry: Format,
    sampling: Sampling,
    division: Division,
    has_planes: bool,
    has_depth_plane: bool,
    /// Bins of the exposure.
    bins: usize,
    kernel: Kernel,
    datapath: Datapath<MovingSample>,
}

impl MotionEvaluation {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            geometry: config.geometry,
            sampling: config.sampling,
            division: config.division,
            has_planes: config.eye_plane.is_on(),
            has_depth_plane: config.has_depth_plane(),
            bins: config.time_bins as usize,
            kernel: Kernel::new(config.kernel_gamma, config.time_bins),
            datapath: Datapath::new(latency, config.time_bins),
        }
    }

    /// Whether a place is taken in this cycle.
    #[must_use]
    pub fn in_ready(&self) -> bool {
        self.datapath.in_ready()
    }

    /// The sample that is shown.
    #[must_use]
    pub fn out(&self) -> Option<&MovingSample> {
        self.datapath.out()
    }

    /// What the splat does to the sample at a place, inside or not.
    #[must_use]
    pub fn evaluate(&self, place: &MovingPlace, depth_a: u32) -> MovingSample {
        let MovingPlace { last, slot, column, row, ref footprint } = *place;
        let course = Course::new(self, footprint, [column, row].map(u32::from));
        let times = self.times(&course);
        let zero = self.number(0);
        let since_begin = |time: Number| (time + zero.of(1.0)).to_fixed(TIME_BITS, TIME_FRACTION_BITS - 1) as u32;
        let local = |place: u32| place % TILE_SIZE;
        let first_bin = u32::from(column) * self.bins as u32;
        let pixel = (local(row.into()) * TILE_SIZE + local(first_bin)) as u8;
        let mut sample = MovingSample { last, inside: course.is_inside, slot, pixel, ..MovingSample::default() };
        for (index, &time) in times.iter().enumerate() {
            sample.time[index] = since_begin(time);
            sample.depth[index] = self.depth(&course, footprint, time, depth_a);
        }
        for (share, times) in sample.share.iter_mut().zip(times.windows(2)) {
            *share = self.kernel.share(&course, [times[0], times[1]]);
        }
        sample
    }

    /// The borders of bins within the time for which the sample is covered.
    fn times(&self, course: &Course) -> Vec<Number> {
        let one = self.number(0).of(1.0);
        let inner = (1..self.bins).map(|index| {
            let border = one.of(2.0 * index as f32 / self.bins as f32 - 1.0);
            border.max(course.begin).min(course.end)
        });
        iter::once(course.begin).chain(inner).chain(iter::once(course.end)).collect()
    }

    /// Depth at a time: of the splat's plane, or of its centre.
    fn depth(&self, course: &Course, footprint: &MovingFootprint, time: Number, depth_a: u32) -> u32 {
        let [at_zero, change] = footprint.distance.map(|bits| self.number(bits));
        let scale = self.number(footprint.depth_scale);
        let scale = if self.has_depth_plane { course.determinant * scale } else { scale };
        let inverse = recip(self.division, at_zero + time * change);
        let depth = self.number(depth_a) + scale * inverse;
        depth.max(self.number(0)).to_fixed(DEPTH_BITS, DEPTH_BITS) as u32
    }

    const fn number(&self, bits: u32) -> Number {
        Number::new(self.geometry, bits)
    }
}

impl Model for MotionEvaluation {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.in_ready(), out: self.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready());
        let sample = accepted.map(|place| self.evaluate(place, inputs.depth_a));
        let token = sample.map(|sample| Token::from(Some(sample).filter(|sample| sample.inside || sample.last)));
        self.datapath.step(token, inputs.out_ready);
    }
}
