//! Evaluation of a sample: its distance from its splat's centre, its kernel weight, and its depth where it has its own.

use super::fixed_distance;
use super::position::{Evaluated, Position};
use crate::compiler::{CompileError, Datapath, Options, Program, Table, Type, Value, compile, name};
use crate::float::exp_neg;
use crate::splat::parts::division::squared_ratio;
use crate::splat::parts::place;
use crate::units::values::{Terms, Values};
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{Band, DepthPlane, LOCAL_BITS, SamplePlace, Sight};
use pointcore_contract::splat::units::rasterizer::PORTS;
use pointcore_contract::splat::{Config, RasterFormat};
use pointcore_contract::{Fixed, Format, Signedness};
use std::rc::Rc;

/// exp(−γρ²) for ρ² in `[0, 1]`.
fn kernel(config: &Config) -> Result<Rc<Table>, CompileError> {
    let shape = config.kernel_table();
    Table::new(shape, exp_neg::samples(config.kernel_gamma, shape)).map(Rc::new)
}

/// `ρ²` of a sample.
enum Squared {
    /// A number, from the offsets `x` and `y` to the splat's centre, px.
    Float { format: Format, distance: Value, offset: [Value; 2] },
    /// Its leading bits.
    Fixed(fixed_distance::Squared),
}

/// Intersects the viewing ray of each sample with the splat's plane (table 5.2, recentred) and weighs it.
pub(super) fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program =
        Program::new("splat_evaluation", "Distance of a sample from its splat's centre, and its kernel weight.");
    let position = Position::inputs(&program, config);
    let squared = match config.raster_format() {
        RasterFormat::Float(format) => floating(config, format, &program, &position),
        RasterFormat::Fixed(coefficient) => {
            let places = place::places(config.sampling, &program, [position.column, position.row]);
            Squared::Fixed(fixed_distance::squared(config, coefficient, &program, &position.shape, places))
        }
    };

    let Position { last, slot, column, row, shape } = position;
    let covered = match &squared {
        Squared::Float { format, distance, .. } => distance.lt(program.float(*format, 1.0)),
        Squared::Fixed(squared) => squared.covered,
    };
    name!(covered);
    program.keep_if(covered | last);
    let kernel = kernel(config)?;
    let argument_bits = kernel.shape().index_bits + kernel.shape().fraction_bits;
    let argument = match &squared {
        Squared::Float { distance, .. } => {
            distance.to_fixed(Fixed { width: argument_bits, fraction: argument_bits, signed: Signedness::Unsigned })
        }
        Squared::Fixed(squared) => squared.argument,
    };
    let weight = argument.kernel(&kernel);
    let local = |index: Value| index.bits(LOCAL_BITS - 1, 0);
    let pixel = local(row).cat(local(column));
    let band = match squared {
        Squared::Float { format, offset, .. } if config.has_depth_plane() => {
            depth_band(format, &program, &shape.plane, offset)
        }
        _ => Band::default(),
    };
    let place = SamplePlace { last, inside: covered, slot, pixel, weight };
    Evaluated { place, band }.outputs(&program, config);
    compile(&program, options)
}

/// `ρ²` in a floating-point format.
fn floating(config: &Config, format: Format, program: &Program, position: &Position<Values>) -> Squared {
    let shape = &position.shape;
    let number = |bits: Value| bits.as_float(format);
    let places = place::places(config.sampling, program, [position.column, position.row]);
    let offset = |axis: usize| {
        let (place, fraction) = places[axis];
        place.to_float(format, fraction) - number(shape.center[axis])
    };
    let (x, y) = (offset(0), offset(1));

    let s1 = x * number(shape.ay) - y * number(shape.ax);
    let s2 = x * number(shape.by) - y * number(shape.bx);
    let d = number(shape.delta) + x * number(shape.mx) + y * number(shape.my);
    let infinity = program.constant(Type::Float(format), format.infinity());
    let has_sight = config.eye_plane.is_on();
    let mut distance = if has_sight {
        let Sight { negative, near, far, turned, .. } = shape.sight;
        let (across, divisor) = (turned.mux(d, s1), turned.mux(s1, d));
        let magnitude = divisor.bits(format.width() - 2, 0);
        let seen = !(sign(divisor, format) ^ negative) & magnitude.le(near) & far.le(magnitude);
        seen.mux(squared_ratio(config.division, across, s2, divisor), infinity)
    } else {
        squared_ratio(config.division, s1, s2, d)
    };
    if config.screen_filter.is_on() {
        let screen = (x * x + y * y) * program.uniform(PORTS.filter_scale.name, Type::Float(format));
        let screen = if has_sight { shape.sight.disc.mux(screen, infinity) } else { screen };
        distance = distance.min(screen);
    }
    let rho_squared = distance;
    name!(x, y, s1, s2, d, rho_squared);
    Squared::Float { format, distance, offset: [x, y] }
}

/// Depth of the splat's plane at a sample, within the splat's range, and the ends of its ε-band.
fn depth_band(format: Format, program: &Program, plane: &DepthPlane<Values>, [x, y]: [Value; 2]) -> Band<Values> {
    let number = |bits: Value| bits.as_float(format);
    let [along_x, along_y] = plane.slope;
    let [near, far] = plane.range;
    let on_plane = number(plane.center) + x * number(along_x) + y * number(along_y);
    let depth = on_plane.max(number(near)).min(number(far));
    name!(on_plane);
    let (low, high) = (depth - number(plane.epsilon), depth + number(plane.epsilon));
    let zero = program.float(format, 0.0);
    let shape = Fixed { width: DEPTH_BITS, fraction: DEPTH_BITS, signed: Signedness::Unsigned };
    let fixed = |depth: Value| depth.max(zero).to_fixed(shape);
    Band { depth: fixed(depth), low: fixed(low), high: fixed(high) }
}

fn sign(value: Value, format: Format) -> Value {
    let top = format.width() - 1;
    value.bits(top, top)
}
