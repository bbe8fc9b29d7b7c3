//! Setup of splats that move while the shutter is open (thesis chapter 4): life, footprint, near and far plane, and bounds, all in the geometry
//! format. docs/units/splat/motion_setup.md has the equations and the error.
//!
//! Dropped are splats that never face the eye between near and far plane, whose centre is never beyond the near plane, that are seen edge-on in
//! the middle of their life, or without a sample.

mod bounds;
mod instant;
mod life;
#[cfg(test)]
mod tests;

use super::Dropped;
use super::parts::division::{recip, sqrt};
use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::unit::Model;
use instant::Instant;
use life::Life;
use pointcore_contract::Format;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{self, EpsilonScale, Motion, MovingFootprint, SetupSplat, Splat, Viewport};
pub use pointcore_contract::splat::units::motion_setup::{In, Out};
use pointcore_contract::splat::{Config, Division};

/// A change of the distance in a unit of `τ`, in distances, is no less than this power of ½ where near and far plane are met.
const LEAST_CHANGE: i64 = 20;

/// What a frame's splats share.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MotionUniforms {
    /// From camera space to pixels and depths.
    pub viewport: Viewport,
    /// What ε is made of.
    pub epsilon: EpsilonScale,
    /// Near plane.
    pub near_plane: u32,
}

/// The setup unit.
#[derive(Clone, Debug)]
pub struct MotionSetup {
    config: Config,
    geometry: Format,
    division: Division,
    /// Samples of the image along both axes, and those of a pixel.
    edges: [u64; 2],
    per_pixel: [u32; 2],
    has_planes: bool,
    has_depth_plane: bool,
    datapath: Datapath<SetupSplat>,
}

/// A splat in numbers.
struct Moving {
    center: [Number; 3],
    tangents: [[Number; 3]; 2],
    motion: [Number; 3],
    part: [Number; 2],
}

impl MotionSetup {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            config: config.clone(),
            geometry: config.geometry,
            division: config.division,
            edges: [config.width, config.height].map(u64::from),
            per_pixel: [config.sampling.columns(), 1],
            has_planes: config.eye_plane.is_on(),
            has_depth_plane: config.has_depth_plane(),
            datapath: Datapath::new(latency, config.setup_interval),
        }
    }

    const fn number(&self, bits: u32) -> Number {
        Number::new(self.geometry, bits)
    }

    fn one(&self) -> Number {
        self.number(0).of(1.0)
    }

    /// The splat with footprint and bounds; `None` if it is dropped.
    #[must_use]
    pub fn setup(&self, splat: &Splat, uniforms: &MotionUniforms) -> Option<SetupSplat> {
        self.outcome(splat, uniforms).ok()
    }

    /// The splat with footprint and bounds, or why it is never drawn.
    ///
    /// # Errors
    /// As [`Dropped`] has it, all the time for which the splat is there.
    pub fn outcome(&self, splat: &Splat, uniforms: &MotionUniforms) -> Result<SetupSplat, Dropped> {
        if splat.end {
            return Ok(SetupSplat { end: true, ..SetupSplat::default() });
        }
        let vector = |bits: [u32; 3]| bits.map(|bits| self.number(bits));
        let Motion { way, part } = splat.motion;
        let (bin, part) = self.bin(part.map(|bits| self.number(bits)));
        let moving =
            Moving { center: vector(splat.center), tangents: splat.tangents.map(vector), motion: vector(way), part };
        let life = Life::of(self, &moving, uniforms);
        if let Some(dropped) = life.dropped {
            return Err(dropped);
        }
        let (bounds, diagonals) = bounds::octagon(self, &moving, &life, uniforms).ok_or(Dropped::Beside)?;
        let instant = Instant::of(self, &moving, life.origin, uniforms);
        let footprint = self.footprint(&moving, &life, &instant, uniforms).ok_or(Dropped::Facing)?;
        let moving = records::Moving { footprint, epsilon: self.epsilon(&life, &instant, uniforms) };
        Ok(SetupSplat { moving, bin, attributes: splat.attributes, bounds, diagonals, ..SetupSplat::default() })
    }

    /// The bin of the exposure in which the middle of a part lies, and what of the part lies there.
    fn bin(&self, [begin, end]: [Number; 2]) -> (u8, [Number; 2]) {
        let (bits, one) = (self.config.bin_bits(), self.one());
        if bits == 0 {
            return (0, [begin, end]);
        }
        // In halves of the exposure, which has two.
        let middle = (begin + end) * one.of(0.5) + one;
        let bin = middle.to_fixed(bits, bits - 1);
        let border = |index: u64| one.of(index as f32 / (1 << (bits - 1)) as f32 - 1.0);
        (bin as u8, [begin.max(border(bin)), end.min(border(bin + 1))])
    }

    /// What evaluation needs; `None` of a splat seen edge-on.
    fn footprint(
        &self,
        moving: &Moving,
        life: &Life,
        instant: &Instant,
        uniforms: &MotionUniforms,
    ) -> Option<MovingFootprint> {
        let Instant { a, b, m, alpha, beta, mu, center, r, .. } = *instant;
        let diagonal = a[0] * b[1];
        let delta = diagonal - b[0] * a[1];
        if is_cancelled(delta, diagonal) {
            return None;
        }
        let per_area = recip(self.division, delta);
        let [a, b] = [a, b].map(|tangent| tangent.map(|part| part * per_area));
        let [of_alpha, of_beta] = [alpha, beta].map(|slant| slant * per_area);
        let determinant = [beta * a[1] - alpha * b[1], alpha * b[0] - beta * a[0]];
        let speed = [
            [m[1] * b[0] - m[0] * b[1], mu * b[1] - m[1] * of_beta, m[0] * of_beta - mu * b[0]],
            [m[0] * a[1] - m[1] * a[0], m[1] * of_alpha - mu * a[1], mu * a[0] - m[0] * of_alpha],
        ];
        let change = m[0] * determinant[0] + m[1] * determinant[1] + mu;
        let by_depth = self.number(uniforms.viewport.depth_b) * r;
        let at_center = if instant.is_whole { by_depth * instant.reciprocal } else { by_depth };
        let (of_distance, scale) = if self.has_depth_plane { (change, by_depth) } else { (mu, at_center) };
        let planes = if self.has_planes { self.planes(moving, life, change, r, uniforms) } else { [0; 3] };
        let bits = |number: Number| number.bits();
        Some(MovingFootprint {
            center: center.map(bits),
            time: life.origin.bits(),
            determinant: determinant.map(bits),
            place: [[b[1], b[0].negated()], [a[1].negated(), a[0]]].map(|form| form.map(bits)),
            speed: speed.map(|form| form.map(bits)),
            distance: [self.one() - life.origin * of_distance, of_distance].map(bits),
            depth_scale: scale.bits(),
            life: [life.begin, life.end].map(bits),
            planes,
        })
    }

    /// Where near and far plane are met; no limit where none of the splat ever lies beyond.
    fn planes(&self, moving: &Moving, life: &Life, change: Number, r: Number, uniforms: &MotionUniforms) -> [u32; 3] {
        let magnitude = change.abs().max(self.one().raised(-LEAST_CHANGE));
        let steep = if change.is_negative() { magnitude.negated() } else { magnitude };
        let inverse = recip(self.division, steep);
        let scale = r * inverse;
        let near_plane = self.number(uniforms.near_plane);
        let ends = [life.begin, life.end].map(|time| moving.center[2] + time * moving.motion[2]);
        let is_beyond_near = near_plane.is_at_most(ends[0].min(ends[1]) - life.reach);
        let is_before_far = (ends[0].max(ends[1]) + life.reach).is_at_most(life.far);
        let infinity = self.number(self.geometry.infinity() as u32);
        let (all, none) =
            if change.is_negative() { (infinity, infinity.negated()) } else { (infinity.negated(), infinity) };
        let near = if is_beyond_near { all } else { near_plane * scale };
        let far = if is_before_far { none } else { life.far * scale };
        let [begin, end] = if change.is_negative() { [far, near] } else { [near, far] };
        [begin, end, inverse - life.origin].map(|number| number.bits())
    }

    /// Half the depth band at the origin of time.
    fn epsilon(&self, life: &Life, instant: &Instant, uniforms: &MotionUniforms) -> u32 {
        let number = |bits: u32| self.number(bits);
        let Instant { r, squared, reciprocal, .. } = *instant;
        let by_depth = number(uniforms.viewport.depth_b) * r;
        let half = by_depth.abs() * (life.reach * r) * reciprocal;
        let middle = number(uniforms.viewport.depth_a) + by_depth + by_depth * (squared * reciprocal);
        let is_beyond_near = instant.is_whole && number(0).is_at_most(middle - half);
        let half = if is_beyond_near { half } else { by_depth.abs().min(self.one()) };
        let epsilon = half * number(uniforms.epsilon.scale) + number(uniforms.epsilon.bias);
        epsilon.max(number(0)).to_fixed(DEPTH_BITS, DEPTH_BITS) as u32
    }

    fn sqrt(&self, number: Number) -> Number {
        sqrt(self.division, number)
    }

    fn recip(&self, number: Number) -> Number {
        recip(self.division, number)
    }
}

/// Whether so little is left of a difference that it is the rounding of its terms.
fn is_cancelled(difference: Number, term: Number) -> bool {
    const ROUNDING_BITS: u32 = 4;
    let resolution = u64::from(difference.format().mantissa + 1 - ROUNDING_BITS);
    let exponent = difference.exponent_field();
    exponent == 0 || exponent + resolution < term.exponent_field()
}

impl Model for MotionSetup {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.datapath.in_ready(), out: self.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready());
        let In { viewport, epsilon, near_plane, .. } = *inputs;
        let uniforms = MotionUniforms { viewport, epsilon, near_plane };
        let accepted = accepted.map(|splat| Token::from(self.setup(splat, &uniforms)));
        self.datapath.step(accepted, inputs.out_ready);
    }
}
