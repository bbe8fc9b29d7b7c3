//! Rasterization setup and back-face culling (thesis 5.4.1, table 5.2), recentred at the splat's projected centre; golden twin:
//! `pointcore_golden::splat::setup`.

pub(super) mod axes;
mod depth;
mod diagonals;
mod exponent;
pub(super) mod fixed_footprint;
mod origin;
mod scaling;

use super::parts::division::recip;
use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, name};
use crate::float::mul;
use crate::units::datapath;
use crate::units::values::{Terms, Values};
use axes::{Frame, Grid};
use depth::Depth;
use exponent::Exponents;
use origin::Origin;
use pointcore_contract::Format;
use pointcore_contract::splat::records::{Footprint, ImageRectangle, SetupSplat, Sight, Splat};
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
    /// What is seen of it, where that is asked sample by sample.
    limits: Option<Limits>,
    /// First and last pixel along each axis.
    pixels: [[Value; 2]; 2],
}

/// What decides whether a sample is seen.
#[derive(Clone, Copy)]
struct Limits {
    /// `D` is negative before the eye.
    negative: Value,
    /// Of near and far plane, whether no sample lies beyond, and `D` there.
    planes: [(Value, Value); 2],
    turned: Value,
    disc: Value,
}

impl Limits {
    fn sight(&self, [near, far]: [Value; 2]) -> Sight<Values> {
        Sight { negative: self.negative, near, far, turned: self.turned, disc: self.disc }
    }
}

/// A term of `Δ` is known to so many bits less than a number is.
pub(super) const ROUNDING_BITS: u32 = 4;

/// In so many bits its sign may be wrong.
const fn doubtful_bits(format: Format) -> u32 {
    if format.mantissa < Format::F32.mantissa { ROUNDING_BITS } else { 6 }
}

/// Whether so little is left of a difference that it is the rounding of its terms, by exponents: where much cancels, both
/// terms have the same one.
pub(super) fn cancelled(
    program: &Program,
    format: Format,
    difference: Value,
    term: Value,
    rounding_bits: u32,
) -> Value {
    let bits = format.exponent + 1;
    let exponent = |value: Value| value.bits(format.width() - 2, format.mantissa).resize(bits);
    let left = exponent(difference);
    let raised = left + program.lit(bits, u64::from(format.mantissa + 1 - rounding_bits));
    left.eq(program.lit(bits, 0)) | raised.lt(exponent(term))
}

/// A footprint in floating point.
fn floating(
    config: &Config,
    program: &Program,
    raster: Format,
    splat: &Projection,
    depth: &Depth,
) -> Footprint<Values> {
    let round = |value: Value| if raster == config.geometry { value } else { value.convert(raster) };
    let Projection { edge_on, delta, m, limits, .. } = *splat;
    let ([ax, ay], [bx, by]) = (splat.a, splat.b);
    let sight = limits.map(|limits| {
        let [(no_near, near), (no_far, far)] = limits.planes;
        let magnitude = |limit: Value| round(limit).bits(raster.width() - 2, 0);
        let [none, all] = [0, (1 << (raster.width() - 1)) - 1].map(|bits| program.lit(raster.width() - 1, bits));
        limits.sight([no_near.mux(all, magnitude(near)), no_far.mux(none, magnitude(far))])
    });
    let footprint = Footprint {
        center: splat.center.map(round),
        ax: round(ax),
        bx: round(bx),
        ay: round(ay),
        by: round(by),
        delta: edge_on.mux(splat.no_delta, round(delta)),
        mx: round(m[0]),
        my: round(m[1]),
        sight: sight.unwrap_or_default(),
        ..Footprint::default()
    };
    if !config.has_depth_plane() {
        return Footprint { band: depth.band(), ..footprint };
    }
    let scale = depth.b * recip(config.division, delta);
    let along = limits.map_or(m, |limits| {
        // `s1` in the place of `D`.
        let turned = [ay, Exponents { program, format: config.geometry }.negated(ax)];
        [0, 1].map(|axis| limits.turned.mux(turned[axis], m[axis]))
    });
    let slope = along.map(|m| edge_on.mux(depth.zero, scale * m));
    Footprint { plane: depth.plane(slope, round), ..footprint }
}

/// Camera space to footprint, depth band and bounding octagon; drops splats outside the image, beyond the far plane, and such
/// as face away.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let format = config.geometry;
    let program = Program::new("splat_setup", "Footprint, depth band and bounding octagon of a splat.");
    let splat = Splat::inputs(&program, config);
    let frame = Frame::new(config, &program, Origin::new(config, &program, &splat));
    let Frame { alpha, beta, .. } = frame;
    let (eye, exponents) = (frame.origin.eye, frame.exponents());
    let depth = Depth::new(&frame);
    let columns = config.sampling.columns();
    let shown = depth.center_shown();
    let x = frame.axis(0, Grid { pixels: config.width, columns, bits: config.column_bits() }, shown);
    let y = frame.axis(1, Grid { pixels: config.height, columns: 1, bits: config.row_bits() }, shown);

    let common = scaling::Common { lowered: eye.map(|eye| eye.lowered), depth: depth.b };
    let scaled = scaling::scaled(&exponents, [x.a, y.a], [x.b, y.b], [alpha, beta], common);
    let [unit_delta, diagonal] = scaled.of_units;
    let lost = |bits: u32| cancelled(&program, format, unit_delta, diagonal, bits) | scaled.vanishing;
    let (edge_on, doubtful) = (lost(ROUNDING_BITS).named("edge_on"), lost(doubtful_bits(format)).named("doubtful"));
    let ([mx, my], delta) = (scaled.m, scaled.delta);
    name!(delta, mx, my);

    let mut negative = exponents.sign(unit_delta);
    let mut mirrored = x.mirrored ^ y.mirrored;
    let diagonals = diagonals::Limits::new(&frame, [&x, &y], shown);
    let mut visible = depth.before_far & x.occupied & y.occupied & diagonals.occupied;
    let mut a = scaled.a;
    if let Some(eye) = eye {
        negative = negative ^ (eye.turned & exponents.sign(frame.origin.center[2]));
        mirrored = mirrored ^ (eye.turned & eye.swapped);
        visible = visible & eye.reaches_near;
        a = a.map(|length| eye.turned.mux(exponents.negated(length), length));
    }
    if config.culling.is_on() {
        visible = visible & (doubtful | (negative ^ mirrored));
    }
    let limits = depth.limits(&frame, delta).zip(eye).zip(shown).map(|((planes, eye), disc)| Limits {
        negative,
        planes,
        turned: eye.turned,
        disc,
    });
    let raster = config.raster_format().floating().unwrap_or(format);
    let no_delta = program.constant(Type::Float(raster), raster.quiet_nan());
    name!(visible);
    program.keep_if(splat.end | visible);
    let per_pixel = columns.ilog2();
    let projection = Projection {
        center: [x.center, y.center],
        a,
        b: scaled.b,
        delta,
        edge_on,
        no_delta,
        m: [mx, my],
        limits,
        pixels: [[x.first >> per_pixel, x.last >> per_pixel], [y.first, y.last]],
    };
    let footprint = match config.raster_format() {
        RasterFormat::Float(raster) => floating(config, &program, raster, &projection, &depth),
        RasterFormat::Fixed(coefficient) => {
            let footprint = fixed_footprint::footprint(&program, format, coefficient, &projection);
            Footprint { band: depth.band(), ..footprint }
        }
    };
    let bounds = ImageRectangle { left: x.first, right: x.last, top: y.first, bottom: y.last };
    let Splat { end, attributes, .. } = splat;
    let diagonals = diagonals.record;
    SetupSplat { end, footprint, attributes, bounds, diagonals, ..SetupSplat::default() }.outputs(&program, config);
    // Among so many multipliers some are placed far from their operands.
    let spare = mul::stages(format) + 1;
    datapath::unit(
        &units::setup::UNIT,
        config,
        &program,
        &options.with_interval(config.setup_interval).with_stages(&format!("mul.{format}"), spare),
    )
}
