//! Rasterization setup and back-face culling (thesis 5.4.1, table 5.2), recentred at the splat's projected centre; golden twin:
//! `pointcore_golden::splat::setup`.

mod axes;
mod depth;
pub(super) mod fixed_footprint;

use super::parts::division::recip;
use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, name};
use crate::float::mul;
use crate::units::datapath;
use crate::units::values::{Terms, Values};
use axes::{Frame, Grid};
use depth::Depth;
use pointcore_contract::Format;
use pointcore_contract::splat::records::{Footprint, ImageRectangle, SetupSplat, Splat};
use pointcore_contract::splat::{Config, RasterFormat, units};

/// A splat's projection, in the geometry format.
struct Projection {
    /// Projected centre, px.
    center: [Value; 2],
    /// `A_x`, `A_y`.
    a: [Value; 2],
    /// `B_x`, `B_y`.
    b: [Value; 2],
    /// `Δ`.
    delta: Value,
    /// `Δ` is nothing but rounding.
    edge_on: Value,
    /// What is sent in its place: a NaN.
    no_delta: Value,
    /// `m_x`, `m_y`.
    m: [Value; 2],
    /// First and last pixel along each axis.
    pixels: [[Value; 2]; 2],
}

/// Whether so little is left of a difference that it is the rounding of its terms, by exponents: where much cancels, both
/// terms have the same one.
fn cancelled(program: &Program, format: Format, difference: Value, term: Value) -> Value {
    let bits = format.exponent + 1;
    let exponent = |value: Value| value.bits(format.width() - 2, format.mantissa).resize(bits);
    let left = exponent(difference);
    // A term is known to four bits less than a number is.
    let raised = left + program.lit(bits, u64::from(format.mantissa - 3));
    left.eq(program.lit(bits, 0)) | raised.lt(exponent(term))
}

/// A footprint in floating point.
fn floating(config: &Config, raster: Format, splat: &Projection, depth: &Depth) -> Footprint<Values> {
    let round = |value: Value| if raster == config.geometry { value } else { value.convert(raster) };
    let Projection { edge_on, delta, m, .. } = *splat;
    let ([ax, ay], [bx, by]) = (splat.a, splat.b);
    let footprint = Footprint {
        center: splat.center.map(round),
        ax: round(ax),
        bx: round(bx),
        ay: round(ay),
        by: round(by),
        delta: edge_on.mux(splat.no_delta, round(delta)),
        mx: round(m[0]),
        my: round(m[1]),
        ..Footprint::default()
    };
    if !config.has_depth_plane() {
        return Footprint { band: depth.band(), ..footprint };
    }
    let scale = depth.b * recip(config.division, delta);
    let slope = m.map(|m| edge_on.mux(depth.zero, scale * m));
    Footprint { plane: depth.plane(slope, round), ..footprint }
}

/// Camera space to footprint, depth band and bounding rectangle; drops splats outside the image, beyond the far plane, and such
/// as face away.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let format = config.geometry;
    let program = Program::new("splat_setup", "Footprint, depth band and bounding rectangle of a splat.");
    let splat = Splat::inputs(&program, config);
    let frame = Frame::new(config, &program, &splat);
    let Frame { one, alpha, beta, .. } = frame;
    let columns = config.sampling.columns();
    let x = frame.axis(0, Grid { pixels: config.width, columns, bits: config.column_bits() });
    let y = frame.axis(1, Grid { pixels: config.height, columns: 1, bits: config.row_bits() });

    let diagonal = x.a * y.b;
    let delta = diagonal - x.b * y.a;
    let edge_on = cancelled(&program, format, delta, diagonal).named("edge_on");
    let mx = beta * y.a - alpha * y.b;
    let my = alpha * x.b - beta * x.a;
    name!(delta, mx, my);

    let depth = Depth::new(&frame);
    let mut visible = depth.center.le(one) & x.occupied & y.occupied;
    if config.culling.is_on() {
        let negative = delta.bits(format.width() - 1, format.width() - 1);
        visible = visible & (edge_on | (negative ^ (x.mirrored ^ y.mirrored)));
    }
    let raster = config.raster_format().floating().unwrap_or(format);
    let no_delta = program.constant(Type::Float(raster), raster.quiet_nan());
    name!(visible);
    program.keep_if(splat.end | visible);
    let per_pixel = columns.ilog2();
    let projection = Projection {
        center: [x.center, y.center],
        a: [x.a, y.a],
        b: [x.b, y.b],
        delta,
        edge_on,
        no_delta,
        m: [mx, my],
        pixels: [[x.first >> per_pixel, x.last >> per_pixel], [y.first, y.last]],
    };
    let footprint = match config.raster_format() {
        RasterFormat::Float(raster) => floating(config, raster, &projection, &depth),
        RasterFormat::Fixed(coefficient) => {
            let footprint = fixed_footprint::footprint(&program, format, coefficient, &projection);
            Footprint { band: depth.band(), ..footprint }
        }
    };
    let bounds = ImageRectangle { left: x.first, right: x.last, top: y.first, bottom: y.last };
    let Splat { end, attributes, .. } = splat;
    SetupSplat { end, footprint, attributes, bounds }.outputs(&program, config);
    // Among so many multipliers some are placed far from their operands.
    let spare = mul::stages(format) + 1;
    datapath::unit(
        &units::setup::UNIT,
        config,
        &program,
        &options.with_interval(config.setup_interval).with_stages(&format!("mul.{format}"), spare),
    )
}
