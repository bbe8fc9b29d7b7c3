//! Evaluation of splats that move while the shutter is open (thesis chapter 4): the time for which a sample is covered, the depth then, and the
//! kernel's integral over it, all within one bin of the exposure.
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

/// The evaluation unit.
#[derive(Clone, Debug)]
pub struct MotionEvaluation {
    geometry: Format,
    sampling: Sampling,
    division: Division,
    has_planes: bool,
    has_depth_plane: bool,
    /// Bits of a time within a bin.
    time_bits: u32,
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
            time_bits: config.bin_time_bits(),
            kernel: Kernel::new(config),
            datapath: Datapath::new(latency, config.sample_interval),
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
        let MovingPlace { last, slot, column, row, odd_bin, ref footprint } = *place;
        let course = Course::new(self, footprint, [column, row].map(u32::from));
        let times = [course.begin, course.end];
        let zero = self.number(0);
        let [begin, end] = times.map(|time| (time + zero.of(1.0)).to_fixed(TIME_BITS, TIME_FRACTION_BITS - 1) as u32);
        // Modulo two bins, of which every other border is zero.
        let (mask, length) = ((1 << self.time_bits) - 1, 1 << (self.time_bits - 1));
        let border = |is_odd: bool| if is_odd { length } else { 0_u32 };
        let local = |place: u16| u32::from(place) % TILE_SIZE;
        MovingSample {
            last,
            inside: course.is_inside,
            slot,
            pixel: (local(row) * TILE_SIZE + local(column)) as u8,
            time: [border(!odd_bin).wrapping_sub(begin) & mask, end.wrapping_sub(border(odd_bin)) & mask],
            depth: times.map(|time| self.depth(&course, footprint, time, depth_a)),
            share: self.kernel.share(&course, times),
        }
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
