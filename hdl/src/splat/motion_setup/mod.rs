//! Setup of splats that move while the shutter is open (thesis chapter 4); golden twin: `pointcore_golden::splat::motion_setup`.

mod bounds;
mod instant;
mod life;

use super::parts::division::{recip, sqrt};
use super::setup::{ROUNDING_BITS, cancelled};
use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, name};
use crate::float::mul;
use crate::units::datapath;
use crate::units::values::{Terms, Uniforms, Values};
use bounds::Octagon;
use instant::Instant;
use life::Life;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{self, EpsilonScale, Motion, MovingFootprint, SetupSplat, Splat, Viewport};
use pointcore_contract::splat::units::motion_setup::PORTS;
use pointcore_contract::splat::{Config, units};
use pointcore_contract::{Fixed, Format, Signedness};

/// The least change of the distance in a unit of `τ`, in distances, where near and far plane are met.
const LEAST_CHANGE: f64 = 1.0 / (1 << 20) as f64;

/// What all parts share.
struct Frame<'a> {
    config: &'a Config,
    program: &'a Program,
    format: Format,
    zero: Value,
    one: Value,
    /// Of the image, along both axes.
    scale: [Value; 2],
    origin: [Value; 2],
    depth_a: Value,
    depth_b: Value,
    near_plane: Value,
}

/// A splat in numbers.
struct Moving {
    center: [Value; 3],
    tangents: [[Value; 3]; 2],
    motion: [Value; 3],
    part: [Value; 2],
}

impl<'a> Frame<'a> {
    fn new(config: &'a Config, program: &'a Program) -> Self {
        let format = config.geometry;
        let [zero, one] = [0.0, 1.0].map(|value| program.float(format, value));
        let viewport = Uniforms::<Viewport>::new(program, config, format);
        let scale = [0, 1].map(|axis: usize| viewport.declare(|viewport| viewport.scale[axis]));
        let origin = [0, 1].map(|axis: usize| viewport.declare(|viewport| viewport.origin[axis]));
        let depth_a = viewport.declare(|viewport| viewport.depth_a);
        let depth_b = viewport.declare(|viewport| viewport.depth_b);
        let near_plane = program.uniform(PORTS.near_plane.name, Type::Float(format));
        Self { config, program, format, zero, one, scale, origin, depth_a, depth_b, near_plane }
    }

    fn constant(&self, value: f64) -> Value {
        self.program.float(self.format, value)
    }

    fn infinity(&self) -> Value {
        self.program.constant(Type::Float(self.format), self.format.infinity())
    }

    fn sign(&self, value: Value) -> Value {
        value.bits(self.format.width() - 1, self.format.width() - 1)
    }

    fn recip(&self, value: Value) -> Value {
        recip(self.config.division, value)
    }

    fn sqrt(&self, value: Value) -> Value {
        sqrt(self.config.division, self.program, self.format, value)
    }

    /// Unsigned, all bits behind the point.
    fn fixed(&self, value: Value) -> Value {
        let shape = Fixed { width: DEPTH_BITS, fraction: DEPTH_BITS, signed: Signedness::Unsigned };
        value.max(self.zero).to_fixed(shape)
    }
}

/// Life, footprint and bounds of a moving splat; drops those that are never seen.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let format = config.geometry;
    let program = Program::new("splat_motion_setup", "Footprint and bounds of a moving splat.");
    let splat = Splat::inputs(&program, config);
    let Motion { way, part } = splat.motion;
    let frame = Frame::new(config, &program);
    let vector = |bits: [Value; 3]| bits.map(|bits| bits.as_float(format));
    let (bin, part) = bin(&frame, part.map(|bits| bits.as_float(format)));
    let (center, tangents) = (vector(splat.center), splat.tangents.map(vector));
    let moving = Moving { center, tangents, motion: vector(way), part };
    let life = Life::new(&frame, &moving);
    let instant = Instant::new(&frame, &moving, life.origin);
    let (footprint, edge_on) = footprint(&frame, &moving, &life, &instant);
    let epsilon = epsilon(&frame, &life, &instant);
    let Octagon { bounds, diagonals, occupied } = bounds::octagon(&frame, &moving, &life);
    let Splat { end, attributes, .. } = splat;
    program.keep_if(end | (life.alive & !edge_on & occupied));
    let moving = records::Moving { footprint, epsilon };
    SetupSplat { end, moving, bin, attributes, bounds, diagonals, ..SetupSplat::default() }.outputs(&program, config);
    // Among so many multipliers some are placed far from their operands.
    let spare = mul::stages(format) + 1;
    let options = options.with_interval(config.setup_interval).with_stages(&format!("mul.{format}"), spare);
    datapath::unit(&units::motion_setup::UNIT, config, &program, &options)
}

/// The bin of the exposure in which the middle of a part lies, and what of the part lies there; of one bin nothing has to be found.
fn bin(frame: &Frame, [begin, end]: [Value; 2]) -> (Value, [Value; 2]) {
    let bits = frame.config.bin_bits();
    if bits == 0 {
        return (Value::default(), [begin, end]);
    }
    let middle = (begin + end) * frame.constant(0.5) + frame.one;
    let bin = middle.to_fixed(Fixed { width: bits, fraction: bits - 1, signed: Signedness::Unsigned });
    let border = |index: u32| frame.constant(f64::from(index) / f64::from(1 << (bits - 1)) - 1.0);
    let bins = 1 << bits;
    let begin = begin.max(datapath::pick(bin, (0..bins).map(border).collect()));
    let end = end.min(datapath::pick(bin, (1..=bins).map(border).collect()));
    name!(bin);
    (bin, [begin, end])
}

/// What evaluation needs, and whether the splat is seen edge-on.
fn footprint(frame: &Frame, moving: &Moving, life: &Life, instant: &Instant) -> (MovingFootprint<Values>, Value) {
    let Instant { a, b, m, alpha, beta, mu, center, r, .. } = *instant;
    let diagonal = a[0] * b[1];
    let delta = diagonal - b[0] * a[1];
    let edge_on = cancelled(frame.program, frame.format, delta, diagonal, ROUNDING_BITS);
    let per_area = frame.recip(delta);
    let [a, b] = [a, b].map(|tangent| tangent.map(|part| part * per_area));
    let [of_alpha, of_beta] = [alpha, beta].map(|slant| slant * per_area);
    let determinant = [beta * a[1] - alpha * b[1], alpha * b[0] - beta * a[0]];
    let speed = [
        [m[1] * b[0] - m[0] * b[1], mu * b[1] - m[1] * of_beta, m[0] * of_beta - mu * b[0]],
        [m[0] * a[1] - m[1] * a[0], m[1] * of_alpha - mu * a[1], mu * a[0] - m[0] * of_alpha],
    ];
    let change = m[0] * determinant[0] + m[1] * determinant[1] + mu;
    let by_depth = frame.depth_b * r;
    name!(delta, edge_on, change, by_depth);
    let (of_distance, depth_scale) = if frame.config.has_depth_plane() {
        (change, by_depth)
    } else {
        (mu, instant.whole.mux(by_depth * instant.reciprocal, by_depth))
    };
    let has_planes = frame.config.eye_plane.is_on();
    let footprint = MovingFootprint {
        center,
        time: life.origin,
        determinant,
        place: [[b[1], -b[0]], [-a[1], a[0]]],
        speed,
        distance: [frame.one - life.origin * of_distance, of_distance],
        depth_scale,
        life: [life.begin, life.end],
        planes: if has_planes { planes(frame, moving, life, change, r) } else { Default::default() },
    };
    (footprint, edge_on)
}

/// Where near and far plane are met; no limit where none of the splat ever lies beyond.
fn planes(frame: &Frame, moving: &Moving, life: &Life, change: Value, r: Value) -> [Value; 3] {
    let magnitude = change.abs().max(frame.constant(LEAST_CHANGE));
    let nearing = frame.sign(change);
    let inverse = frame.recip(nearing.mux(-magnitude, magnitude));
    let scale = r * inverse;
    let ends = [life.begin, life.end].map(|time| moving.center[2] + time * moving.motion[2]);
    let beyond_near = frame.near_plane.le(ends[0].min(ends[1]) - life.reach);
    let before_far = (ends[0].max(ends[1]) + life.reach).le(life.far);
    let infinity = frame.infinity();
    let (all, none) = (nearing.mux(infinity, -infinity), nearing.mux(-infinity, infinity));
    let near = beyond_near.mux(all, frame.near_plane * scale);
    let far = before_far.mux(none, life.far * scale);
    [nearing.mux(far, near), nearing.mux(near, far), inverse - life.origin]
}

/// Half the depth band at the origin of time.
fn epsilon(frame: &Frame, life: &Life, instant: &Instant) -> Value {
    let Instant { r, squared, reciprocal, whole, .. } = *instant;
    let by_depth = frame.depth_b * r;
    let of_splat = by_depth.abs() * (life.reach * r) * reciprocal;
    let middle = frame.depth_a + by_depth + by_depth * (squared * reciprocal);
    let beyond_near = whole & frame.zero.le(middle - of_splat);
    let half = beyond_near.mux(of_splat, by_depth.abs().min(frame.one));
    let uniforms = Uniforms::<EpsilonScale>::new(frame.program, frame.config, frame.format);
    frame.fixed(half * uniforms.declare(|epsilon| epsilon.scale) + uniforms.declare(|epsilon| epsilon.bias))
}
