//! Rasterization setup and back-face culling (thesis 5.4.1, table 5.2), recentred at the splat's projected centre; golden twin:
//! `pointcore_golden::splat::setup`.

pub(super) mod fixed_footprint;

use super::parts::division::{recip, sqrt};
use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, compile};
use crate::float::mul;
use crate::units::datapath::{Inputs, uniform};
use fixed_footprint::Projection;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::{Config, RasterFormat, records};
use pointcore_contract::{Fixed, Format, FragmentDepth, Sampling, Signedness};

/// Where bounds saturate, in px: beyond every image.
const BOUND_MAX: f64 = 8191.0;
/// Bounds are rounded to pixels from so many fraction bits.
const BOUND: Fixed = Fixed { width: 21, fraction: 8, signed: Signedness::Unsigned };

/// What rounds bounds with 8 fraction bits to the first and one past the last pixel with a sample within 1/256 px of them:
/// `(bound + offset) >> 8`.
const fn offsets(sampling: Sampling) -> (u64, u64) {
    match sampling {
        // ceil(low − ½ − 1/256) and 1 + floor(high − ½ + 2/256).
        Sampling::Center => (126, 130),
        // A pixel's samples reach from its edge to ⅝: ceil(low − ⅝ − 1/256) and 1 + floor(high + 2/256).
        Sampling::Flipquad => (94, 258),
    }
}
/// Depths as the record holds them.
const DEPTH: Fixed = Fixed { width: DEPTH_BITS, fraction: DEPTH_BITS, signed: Signedness::Unsigned };

/// Smallest `e` for which a splat counts as wholly in front of the eye; below, its bounds would be rounding.
const fn clearance(format: Format) -> f64 {
    if format.mantissa < Format::F32.mantissa { 1.0 / 32.0 } else { 1.0 / 4096.0 }
}

/// One image axis: projected centre, the tangents' components, and the pixels within the bounds.
struct Axis {
    /// Sign of the image's scale.
    mirrored: Value,
    center: Value,
    a: Value,
    b: Value,
    first: Value,
    last: Value,
    occupied: Value,
}

/// What the axes share.
struct Frame<'a> {
    config: &'a Config,
    program: &'a Program,
    splat: &'a Inputs,
    /// `1/u_z`.
    r: Value,
    alpha: Value,
    beta: Value,
    /// `1/e`.
    f: Value,
    /// The splat lies wholly in front of the eye; none where every splat is taken to.
    whole: Option<Value>,
    /// Radius of the screen filter, where there is one.
    filter_radius: Option<Value>,
}

impl Frame<'_> {
    fn constant(&self, value: f64) -> Value {
        self.program.float(self.config.geometry, value)
    }

    fn uniform(&self, name: &str) -> Value {
        uniform(self.program, self.config.geometry, name)
    }

    fn sqrt(&self, value: Value) -> Value {
        sqrt(self.config.division, self.program, self.config.geometry, value)
    }

    fn axis(&self, axis: &str, edge: u32, columns: u32, bits: u32) -> Axis {
        let component = |name: &str| self.splat.float(self.config.geometry, &format!("{name}_{axis}"));
        let scale = self.uniform(&format!("scale_{axis}"));
        let v = component("center") * self.r;
        let a = scale * (component("tangent1") * self.r - v * self.alpha);
        let b = scale * (component("tangent2") * self.r - v * self.beta);
        let center = scale * v + self.uniform(&format!("origin_{axis}"));

        let t = (a * self.alpha + b * self.beta) * self.f;
        let h = self.sqrt(t * t + (a * a + b * b) * self.f);
        let middle = center - t;
        let (mut low, mut high) = (middle - h, middle + h);
        if let Some(radius) = &self.filter_radius {
            low = low.min(center - *radius);
            high = high.max(center + *radius);
        }
        let (first, last, occupied) = self.samples(low, high, edge, columns, bits);
        let top = self.config.geometry.width() - 1;
        Axis { mirrored: scale.bits(top, top), center, a, b, first, last, occupied }
    }

    /// First and last row or column of samples between two bounds, `columns` to a pixel, and whether there is one; a NaN widens the bounds.
    fn samples(&self, low: Value, high: Value, edge: u32, columns: u32, bits: u32) -> (Value, Value, Value) {
        let sum_bits = BOUND.width + 1;
        let constant = |value| self.program.lit(sum_bits, value);
        let zero = self.constant(0.0);
        let fraction = BOUND.fraction;
        let round = |bound: Value, offset| {
            let pixel = (bound.to_fixed(BOUND).resize(sum_bits) + constant(offset)) >> fraction;
            if columns == 1 { pixel } else { pixel.cat(self.program.lit(columns.ilog2(), 0)).resize(sum_bits) }
        };
        let (first_offset, past_offset) = offsets(self.config.sampling);
        let first = round(low.max(zero), first_offset);
        let past = round(high.min(self.constant(BOUND_MAX)).max(zero), past_offset);
        let edge = constant(edge.into());
        let (first, past) = match &self.whole {
            Some(whole) => (whole.mux(first, constant(0)), whole.mux(past.min(edge), edge)),
            None => (first, past.min(edge)),
        };
        let last = past - constant(1);
        (first.resize(bits), last.resize(bits), first.lt(past))
    }
}

/// Depth of a splat: at its center, over the splat, and the band that counts as its surface.
struct Depth {
    zero: Value,
    one: Value,
    /// What depth changes with `u_z`.
    b: Value,
    center: Value,
    /// Middle and half of what the splat spans.
    spread: [Value; 2],
    /// The splat lies wholly beyond the near plane.
    beyond_near: Value,
    /// Middle of the band, and half of it.
    middle: Value,
    epsilon: Value,
}

impl Depth {
    fn new(frame: &Frame, q: Value, one: Value) -> Self {
        let b = frame.uniform("depth_b") * frame.r;
        let center = frame.uniform("depth_a") + b;
        let spread_middle = center + b * (q * frame.f);
        let spread_half = b.abs() * (frame.sqrt(q) * frame.f);
        let zero = frame.constant(0.0);
        let beyond_near = zero.le(spread_middle - spread_half);
        let beyond_near = frame.whole.map_or(beyond_near, |whole| whole & beyond_near).named("beyond_near");
        let middle = beyond_near.mux(spread_middle, center);
        let half = beyond_near.mux(spread_half, b.abs().min(one));
        let epsilon = half * frame.uniform("epsilon_scale") + frame.uniform("epsilon_bias");
        Self { zero, one, b, center, spread: [spread_middle, spread_half], beyond_near, middle, epsilon }
    }

    /// One depth for all fragments.
    fn band(&self) -> [(&'static str, Value); 3] {
        let fixed = |depth: Value| depth.max(self.zero).to_fixed(DEPTH);
        let Self { middle, epsilon, .. } = *self;
        [("depth", fixed(middle)), ("depth_low", fixed(middle - epsilon)), ("depth_high", fixed(middle + epsilon))]
    }

    /// A plane, by its slopes along both axes of the image.
    fn plane(
        &self,
        slope: impl Fn(Value) -> Value,
        [mx, my]: [Value; 2],
        coefficient: impl Fn(Value) -> Value,
    ) -> [(&'static str, Value); 6] {
        let [middle, half] = self.spread;
        [
            ("depth_center", coefficient(self.center)),
            ("depth_x", coefficient(slope(mx))),
            ("depth_y", coefficient(slope(my))),
            ("depth_near", coefficient(self.beyond_near.mux(middle - half, self.zero))),
            ("depth_far", coefficient(self.beyond_near.mux(middle + half, self.one))),
            ("epsilon", coefficient(self.epsilon)),
        ]
    }
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

/// Camera space to footprint, depth band and bounding rectangle; drops splats outside the image, beyond the far plane, and such
/// as face away.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let format = config.geometry;
    let program = Program::new("splat_setup", "Footprint, depth band and bounding rectangle of a splat.");
    let splat = Inputs::new(&program, &records::splat(config));
    let one = program.float(format, 1.0);

    let r = recip(config.division, splat.float(format, "center_z"));
    let alpha = splat.float(format, "tangent1_z") * r;
    let beta = splat.float(format, "tangent2_z") * r;
    let q = alpha * alpha + beta * beta;
    let e = one - q;
    let f = recip(config.division, e);
    let whole = config.eye_plane.is_on().then(|| program.float(format, clearance(format)).lt(e).named("whole"));
    let filter_radius = config.screen_filter.is_on().then(|| uniform(&program, format, "filter_radius"));
    let frame = Frame { config, program: &program, splat: &splat, r, alpha, beta, f, whole, filter_radius };
    let x = frame.axis("x", config.width, config.sampling.columns(), config.column_bits());
    let y = frame.axis("y", config.height, 1, config.row_bits());

    let diagonal = x.a * y.b;
    let delta = diagonal - x.b * y.a;
    let edge_on = cancelled(&program, format, delta, diagonal).named("edge_on");
    let mx = beta * y.a - alpha * y.b;
    let my = alpha * x.b - beta * x.a;

    let depth = Depth::new(&frame, q, one);
    let mut visible = depth.center.le(one) & x.occupied & y.occupied;
    if config.culling.is_on() {
        let negative = delta.bits(format.width() - 1, format.width() - 1);
        visible = visible & (edge_on | (negative ^ (x.mirrored ^ y.mirrored)));
    }
    let raster = match config.raster_format() {
        RasterFormat::Float(raster) => raster,
        RasterFormat::Fixed(_) => format,
    };
    let no_delta = program.constant(Type::Float(raster), raster.quiet_nan());
    let coefficient = |value: Value| if raster == format { value } else { value.convert(raster) };
    program.keep_if(splat.bits("end") | visible);
    let mut computed = match config.raster_format() {
        RasterFormat::Float(_) => vec![
            ("center_x", coefficient(x.center)),
            ("center_y", coefficient(y.center)),
            ("ax", coefficient(x.a)),
            ("bx", coefficient(x.b)),
            ("ay", coefficient(y.a)),
            ("by", coefficient(y.b)),
            ("delta", edge_on.mux(no_delta, coefficient(delta))),
            ("mx", coefficient(mx)),
            ("my", coefficient(my)),
        ],
        RasterFormat::Fixed(coefficient) => {
            let per_pixel = config.sampling.columns().ilog2();
            let projection = Projection {
                center: [x.center, y.center],
                a: [x.a, y.a],
                b: [x.b, y.b],
                delta,
                edge_on,
                m: [mx, my],
                pixels: [[(x.first >> per_pixel), (x.last >> per_pixel)], [y.first, y.last]],
            };
            fixed_footprint::footprint(&program, format, coefficient, &projection)
        }
    };
    computed.extend([("left", x.first), ("right", x.last), ("top", y.first), ("bottom", y.last)]);
    computed.extend(match config.depth {
        FragmentDepth::Center => depth.band().to_vec(),
        FragmentDepth::Plane => {
            let scale = depth.b * recip(config.division, delta);
            depth.plane(|m| edge_on.mux(depth.zero, scale * m), [mx, my], coefficient).to_vec()
        }
    });
    splat.output(&program, &records::setup(config), &computed);
    // Among so many multipliers some are placed far from their operands.
    let spare = mul::stages(format) + 1;
    compile(&program, &options.with_interval(config.setup_interval).with_stages(&format!("mul.{format}"), spare))
}
