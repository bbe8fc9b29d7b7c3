//! Evaluation of splats that move while the shutter is open (thesis chapter 4); golden twin: `pointcore_golden::splat::motion_evaluation`.

mod course;
mod share;

use super::parts::division::recip;
use super::parts::place;
use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, name};
use crate::units::datapath;
use crate::units::values::{Terms, Values};
use course::Course;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::motion::{TIME_BITS, TIME_FRACTION_BITS};
use pointcore_contract::splat::records::{LOCAL_BITS, MovingFootprint, MovingPlace, MovingSample};
use pointcore_contract::splat::units::motion_evaluation::PORTS;
use pointcore_contract::splat::{Config, units};
use pointcore_contract::{Fixed, Format, Signedness};

/// What all parts share.
#[derive(Clone, Copy)]
struct Frame<'a> {
    config: &'a Config,
    program: &'a Program,
    format: Format,
    zero: Value,
    one: Value,
}

impl<'a> Frame<'a> {
    fn new(config: &'a Config, program: &'a Program) -> Self {
        let format = config.geometry;
        let [zero, one] = [0.0, 1.0].map(|value| program.float(format, value));
        Self { config, program, format, zero, one }
    }

    fn constant(&self, value: f64) -> Value {
        self.program.float(self.format, value)
    }

    fn number(&self, bits: Value) -> Value {
        bits.as_float(self.format)
    }
}

/// An unsigned fixed-point number.
const fn unsigned(width: u32, fraction: u32) -> Fixed {
    Fixed { width, fraction, signed: Signedness::Unsigned }
}

/// Integrates a moving splat's kernel at a sample over its bin of the exposure.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program =
        Program::new("splat_motion_evaluation", "What a moving splat does to a sample in a bin of the exposure.");
    let frame = Frame::new(config, &program);
    let MovingPlace { last, slot, column, row, odd_bin, footprint } = MovingPlace::inputs(&program, config);
    let places = place::places(config.sampling, &program, [column, row]);
    let course = Course::new(frame, &footprint, places);
    let times = [course.begin, course.end];
    let depth = depths(frame, &course, &footprint, times);
    let share = share::share(frame, &course, times)?;
    let pixel = row.bits(LOCAL_BITS - 1, 0).cat(column.bits(LOCAL_BITS - 1, 0));
    program.keep_if(course.inside | last);
    let time = since(frame, odd_bin, times);
    MovingSample { last, inside: course.inside, slot, pixel, time, depth, share }.outputs(&program, config);
    datapath::unit(&units::motion_evaluation::UNIT, config, &program, &options.with_interval(config.sample_interval))
}

/// Begin and end, counted from the bin's end and from its begin; modulo two bins, of which every other border is zero.
fn since(frame: Frame, odd_bin: Value, times: [Value; 2]) -> [Value; 2] {
    let Frame { config, program, .. } = frame;
    let bits = config.bin_time_bits();
    let fixed =
        |time: Value| (time + frame.one).to_fixed(unsigned(TIME_BITS, TIME_FRACTION_BITS - 1)).bits(bits - 1, 0);
    let [begin, end] = times.map(fixed);
    let border = |is_odd: Value| is_odd.cat(program.lit(bits - 1, 0));
    let odd = if config.bin_bits() > 0 { odd_bin } else { program.lit(1, 0) };
    [border(!odd) - begin, end - border(odd)]
}

/// Depth at each time: of the splat's plane, or of its centre.
fn depths(frame: Frame, course: &Course, footprint: &MovingFootprint<Values>, times: [Value; 2]) -> [Value; 2] {
    let depth_a = frame.program.uniform(PORTS.depth_a.name, Type::Float(frame.format));
    let [at_zero, change] = footprint.distance.map(|bits| frame.number(bits));
    let scale = frame.number(footprint.depth_scale);
    let scale = if frame.config.has_depth_plane() { course.determinant * scale } else { scale };
    times.map(|time| {
        let distance = at_zero + time * change;
        let depth = depth_a + scale * recip(frame.config.division, distance);
        name!(distance);
        depth.max(frame.zero).to_fixed(unsigned(DEPTH_BITS, DEPTH_BITS))
    })
}
