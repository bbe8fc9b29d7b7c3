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

/// Integrates a moving splat's kernel at a sample over each bin of the exposure.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("splat_motion_evaluation", "What a moving splat does to a sample, bin by bin.");
    let frame = Frame::new(config, &program);
    let MovingPlace { last, slot, column, row, footprint } = MovingPlace::inputs(&program, config);
    let places = place::places(config.sampling, &program, [column, row]);
    let course = Course::new(frame, &footprint, places);
    let times = times(frame, &course);
    let mut sample = MovingSample { last, inside: course.inside, slot, ..MovingSample::default() };
    let since_begin = |time: Value| (time + frame.one).to_fixed(unsigned(TIME_BITS, TIME_FRACTION_BITS - 1));
    sample.time.iter_mut().zip(&times).for_each(|(at, &time)| *at = since_begin(time));
    sample.depth.iter_mut().zip(depths(frame, &course, &footprint, &times)).for_each(|(at, depth)| *at = depth);
    sample.share.iter_mut().zip(share::shares(frame, &course, &times)?).for_each(|(of, share)| *of = share);
    let local_row = row.bits(LOCAL_BITS - 1, 0);
    sample.pixel = match config.bin_bits() {
        0 => local_row.cat(column.bits(LOCAL_BITS - 1, 0)),
        LOCAL_BITS => local_row.cat(program.lit(LOCAL_BITS, 0)),
        bits => local_row.cat(column.bits(LOCAL_BITS - 1 - bits, 0)).cat(program.lit(bits, 0)),
    };
    program.keep_if(course.inside | last);
    sample.outputs(&program, config);
    datapath::unit(&units::motion_evaluation::UNIT, config, &program, &options.with_interval(config.time_bins))
}

/// The borders of bins within the time for which the sample is covered.
fn times(frame: Frame, course: &Course) -> Vec<Value> {
    let bins = frame.config.time_bins;
    let time = |index: u32| match index {
        0 => course.begin,
        _ if index == bins => course.end,
        _ => {
            let border = frame.constant(f64::from(2 * index) / f64::from(bins) - 1.0);
            border.max(course.begin).min(course.end)
        }
    };
    (0..=bins).map(time).collect()
}

/// Depth at each time: of the splat's plane, or of its centre.
fn depths(frame: Frame, course: &Course, footprint: &MovingFootprint<Values>, times: &[Value]) -> Vec<Value> {
    let depth_a = frame.program.uniform(PORTS.depth_a.name, Type::Float(frame.format));
    let [at_zero, change] = footprint.distance.map(|bits| frame.number(bits));
    let scale = frame.number(footprint.depth_scale);
    let scale = if frame.config.has_depth_plane() { course.determinant * scale } else { scale };
    let depth_at = |&time: &Value| {
        let distance = at_zero + time * change;
        let depth = depth_a + scale * recip(frame.config.division, distance);
        name!(distance);
        depth.max(frame.zero).to_fixed(unsigned(DEPTH_BITS, DEPTH_BITS))
    };
    times.iter().map(depth_at).collect()
}
