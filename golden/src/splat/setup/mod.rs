//! Setup unit: projection, bounds and depth band of a splat (thesis tables 5.1 and 5.2, recentred as docs/splat.md derives).
//!
//! A datapath of interval `setup_interval`, in the geometry format; the footprint leaves it in the rasterizer's. Bounds are rounded
//! outwards to pixels; a splat that crosses the eye plane has the viewport for bounds, unless that part is left out. Dropped are splats
//! behind the far plane, splats without a pixel and, with culling, splats that face away. A splat seen edge-on has no `Δ` to speak of,
//! and draws its screen filter's disc at most.

pub(super) mod fixed_footprint;

use super::parts::division::{recip, sqrt};
use super::uniforms::SetupUniforms;
use crate::datapath::Datapath;
use crate::number::Number;
use crate::unit::Model;
use fixed_footprint::Projection;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{Band, DepthPlane, Footprint, ImageRectangle, SetupSplat, Splat};
pub use pointcore_contract::splat::units::setup::{In, Out};
use pointcore_contract::splat::{Config, Division, Feature, RasterFormat};
use pointcore_contract::{Format, Sampling};
use std::ops::Range;

/// `e` up to this power of ½ counts as crossing the eye plane, in a format as precise as `f32`.
const CLEARANCE_FRACTION_BITS: u32 = 12;
/// The same in less precise ones, where bounds so near the eye plane would be rounding.
const COARSE_CLEARANCE_FRACTION_BITS: u32 = 5;
/// Fraction bits of `f32`.
const FINE_MANTISSA_BITS: u32 = 23;
/// Bits of a difference's precision that its terms' own rounding takes: a `Δ` that has cancelled to that is none.
const ROUNDING_BITS: u32 = 4;
/// Bounds as fixed-point numbers: 13 integer bits hold every image edge.
const BOUND_BITS: u32 = 21;
/// Fraction bits of the bounds.
const BOUND_FRACTION_BITS: u32 = 8;
/// The largest bound in pixels before the conversion.
const BOUND_MAX_PX: u64 = 8191;
/// One of [`BOUND_FRACTION_BITS`].
const PIXEL: u64 = 1 << BOUND_FRACTION_BITS;
/// What bounds are wider by at either end, in units of [`BOUND_FRACTION_BITS`].
const FIRST_MARGIN: u64 = 1;
const LAST_MARGIN: u64 = 2;

/// The setup unit.
#[derive(Clone, Debug)]
pub struct Setup {
    geometry: Format,
    raster: RasterFormat,
    division: Division,
    culling: Feature,
    eye_plane: Feature,
    has_screen_filter: bool,
    edges: [u64; 2],
    sampling: Sampling,
    datapath: Datapath<SetupSplat>,
}

/// How far a splat leans towards the eye: what the bounds of both axes and the depth share.
#[derive(Clone, Copy, Debug)]
pub struct Slant {
    /// The first tangent's depth relative to the centre's.
    pub alpha: Number,
    /// The second tangent's.
    pub beta: Number,
    /// `q = α² + β²`.
    squared: Number,
    /// Whether `e = 1 − q` says that the splat lies wholly in front of the eye.
    pub is_whole: bool,
    /// `f = 1/e`; `None` of a splat that is not whole, where there is a part that sees to it.
    reciprocal: Option<Number>,
}

impl Setup {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            geometry: config.geometry,
            raster: config.raster_format(),
            division: config.division,
            has_screen_filter: config.screen_filter.is_on(),
            culling: config.culling,
            eye_plane: config.eye_plane,
            edges: [config.width, config.height].map(u64::from),
            sampling: config.sampling,
            datapath: Datapath::new(latency, config.setup_interval),
        }
    }

    fn number(&self, bits: u32) -> Number {
        Number::new(self.geometry, bits)
    }

    fn constant(&self, value: u64, fraction: u32) -> Number {
        Number::from_fixed(self.geometry, value, BOUND_BITS, fraction)
    }

    /// The splat with footprint and bounds; `None` if it lies behind the far plane, covers no pixel, or faces away and is culled.
    #[must_use]
    pub fn setup(&self, splat: &Splat, uniforms: &SetupUniforms) -> Option<SetupSplat> {
        if splat.end {
            return Some(SetupSplat { end: true, ..SetupSplat::default() });
        }
        let [ux, uy, uz] = splat.center.map(|bits| self.number(bits));
        let [[a1x, a1y, _], [a2x, a2y, _]] = splat.tangents.map(|tangent| tangent.map(|bits| self.number(bits)));
        let [scale_x, scale_y] = uniforms.viewport.scale.map(|bits| self.number(bits));
        let [origin_x, origin_y] = uniforms.viewport.origin.map(|bits| self.number(bits));

        let r = recip(self.division, uz);
        let (vx, vy) = (ux * r, uy * r);
        let slant = self.slant(splat, r);
        let (alpha, beta) = (slant.alpha, slant.beta);
        let (ax, bx) = (scale_x * (a1x * r - vx * alpha), scale_x * (a2x * r - vx * beta));
        let (ay, by) = (scale_y * (a1y * r - vy * alpha), scale_y * (a2y * r - vy * beta));
        let (cx, cy) = (scale_x * vx + origin_x, scale_y * vy + origin_y);

        let columns = self.bounds(0, cx, ax, bx, &slant, uniforms);
        let rows = self.bounds(1, cy, ay, by, &slant, uniforms);
        let depths = self.depths(r, &slant, uniforms)?;
        if columns.is_empty() || rows.is_empty() {
            return None;
        }
        let delta = ax * by - bx * ay;
        let is_edge_on = self.is_cancelled(delta, ax * by);
        if self.culling.is_on() && !is_edge_on && !is_front(delta, scale_x, scale_y) {
            return None;
        }
        let m = [beta * ay - alpha * by, alpha * bx - beta * ax];
        let delta = (!is_edge_on).then_some(delta);
        let projection = Projection { center: [cx, cy], a: [ax, ay], b: [bx, by], delta, m };
        let footprint = match self.raster {
            RasterFormat::Float(format) => self.footprint(format, &projection, &depths),
            RasterFormat::Fixed(coefficient) => {
                let per_pixel = u64::from(self.sampling.columns());
                let columns = columns.start / per_pixel..columns.end / per_pixel;
                let footprint = fixed_footprint::footprint(coefficient, &projection, [columns, rows.clone()]);
                Footprint { band: depths.band(), ..footprint }
            }
        };
        let bounds = ImageRectangle {
            left: columns.start as u16,
            right: (columns.end - 1) as u16,
            top: rows.start as u16,
            bottom: (rows.end - 1) as u16,
        };
        Some(SetupSplat { end: false, footprint, attributes: splat.attributes, bounds })
    }

    /// The footprint in a floating-point format.
    fn footprint(&self, format: Format, projection: &Projection, depths: &Depths) -> Footprint {
        let coefficient =
            |value: Number| if format == self.geometry { value.bits() } else { value.convert(format).bits() };
        let Projection { center, a, b, delta, m } = *projection;
        let slope = depths.slope(self.division, delta, m);
        let plane = DepthPlane {
            center: coefficient(depths.center),
            slope: slope.map(coefficient),
            range: depths.range.map(coefficient),
            epsilon: coefficient(depths.epsilon),
        };
        Footprint {
            center: center.map(coefficient),
            ax: coefficient(a[0]),
            bx: coefficient(b[0]),
            ay: coefficient(a[1]),
            by: coefficient(b[1]),
            delta: delta.map_or(format.quiet_nan() as u32, coefficient),
            mx: coefficient(m[0]),
            my: coefficient(m[1]),
            shift: 0,
            band: depths.band(),
            plane,
        }
    }

    /// Whether a difference is rounding alone, by the exponents of it and of its first term.
    fn is_cancelled(&self, difference: Number, term: Number) -> bool {
        let resolution = u64::from(self.geometry.mantissa + 1 - ROUNDING_BITS);
        let exponent = difference.exponent_field();
        exponent == 0 || exponent + resolution < term.exponent_field()
    }

    /// The slant of a splat in camera space, whose centre's reciprocal depth is `r`.
    fn slant(&self, splat: &Splat, r: Number) -> Slant {
        let [alpha, beta] = splat.tangents.map(|[.., z]| self.number(z) * r);
        let squared = alpha * alpha + beta * beta;
        let e = self.constant(1, 0) - squared;
        let is_fine = self.geometry.mantissa >= FINE_MANTISSA_BITS;
        let clearance = if is_fine { CLEARANCE_FRACTION_BITS } else { COARSE_CLEARANCE_FRACTION_BITS };
        let is_whole = self.constant(1, clearance).is_below(e);
        let reciprocal = (is_whole || !self.eye_plane.is_on()).then(|| recip(self.division, e));
        Slant { alpha, beta, squared, is_whole, reciprocal }
    }

    /// How far a splat in camera space leans towards the eye.
    #[must_use]
    pub fn slant_of(&self, splat: &Splat) -> Slant {
        self.slant(splat, recip(self.division, self.number(splat.center[2])))
    }

    /// Rows or columns of samples that may lie inside the splat; all of a pixel's, or none.
    fn bounds(
        &self,
        axis: usize,
        c: Number,
        a: Number,
        b: Number,
        slant: &Slant,
        uniforms: &SetupUniforms,
    ) -> Range<u64> {
        let edge = self.edges[axis];
        let Some(f) = slant.reciprocal else { return 0..edge };
        let t = (a * slant.alpha + b * slant.beta) * f;
        let h = sqrt(self.division, t * t + (a * a + b * b) * f);
        let (mut low, mut high) = ((c - t) - h, (c - t) + h);
        if self.has_screen_filter {
            let radius = self.number(uniforms.filter_radius);
            low = low.min(c - radius);
            high = high.max(c + radius);
        }
        let zero = self.number(0);
        let low = low.max(zero).to_fixed(BOUND_BITS, BOUND_FRACTION_BITS);
        let high = high.min(self.constant(BOUND_MAX_PX, 0)).max(zero).to_fixed(BOUND_BITS, BOUND_FRACTION_BITS);
        // From its corner, the nearest and farthest of a pixel's samples.
        let (nearest, farthest) = match self.sampling {
            Sampling::Center => (PIXEL / 2, PIXEL / 2),
            Sampling::Flipquad => (0, PIXEL * 5 / 8),
        };
        let first = (low + (PIXEL - 1) - farthest - FIRST_MARGIN) / PIXEL;
        let past = (high + PIXEL - nearest + LAST_MARGIN) / PIXEL;
        let samples = [u64::from(self.sampling.columns()), 1][axis];
        first * samples..(past * samples).min(edge)
    }

    /// Depth range and ε (eqs. 5.8, 5.9); `None` behind the far plane.
    fn depths(&self, r: Number, slant: &Slant, uniforms: &SetupUniforms) -> Option<Depths> {
        let (zero, one) = (self.number(0), self.constant(1, 0));
        let scale = self.number(uniforms.viewport.depth_b) * r;
        let center = self.number(uniforms.viewport.depth_a) + scale;
        if !center.is_at_most(one) {
            return None;
        }
        let reach = sqrt(self.division, slant.squared);
        let range = slant.reciprocal.map(|f| (center + scale * (slant.squared * f), scale.abs() * (reach * f)));
        let beyond_near = range.filter(|(depth, half)| zero.is_at_most(*depth - *half));
        let (middle, half) = beyond_near.unwrap_or((center, scale.abs().min(one)));
        let range = beyond_near.map_or([zero, one], |(depth, half)| [depth - half, depth + half]);
        let epsilon = half * self.number(uniforms.epsilon.scale) + self.number(uniforms.epsilon.bias);
        Some(Depths { zero, scale, center, middle, range, epsilon })
    }
}

/// Depths of a splat.
struct Depths {
    zero: Number,
    /// `b`: the depth is `depth_a + b·u_z/z`.
    scale: Number,
    center: Number,
    middle: Number,
    range: [Number; 2],
    epsilon: Number,
}

impl Depths {
    fn band(&self) -> Band {
        let fixed = |depth: Number| depth.max(self.zero).to_fixed(DEPTH_BITS, DEPTH_BITS) as u32;
        let Self { middle, epsilon, .. } = *self;
        Band { depth: fixed(middle), low: fixed(middle - epsilon), high: fixed(middle + epsilon) }
    }

    /// By the pixel over the plane, where `u_z/z = D/Δ`; level without a `Δ`.
    fn slope(&self, division: Division, delta: Option<Number>, m: [Number; 2]) -> [Number; 2] {
        delta.map_or([self.zero; 2], |delta| {
            let scale = self.scale * recip(division, delta);
            m.map(|m| scale * m)
        })
    }
}

/// Whether the eye sees the front: `Δ` has the sign of `⟨u, a1 × a2⟩`, unless the image is mirrored.
fn is_front(delta: Number, scale_x: Number, scale_y: Number) -> bool {
    delta.is_negative() ^ scale_x.is_negative() ^ scale_y.is_negative()
}

impl Model for Setup {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.datapath.in_ready(), out: self.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready());
        let In { viewport, epsilon, filter_radius, .. } = *inputs;
        let uniforms = SetupUniforms { viewport, epsilon, filter_radius };
        let accepted = accepted.and_then(|splat| self.setup(splat, &uniforms));
        self.datapath.step(accepted, inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::records::{EpsilonScale, Viewport};

    fn uniforms() -> SetupUniforms {
        let bits = f32::to_bits;
        SetupUniforms {
            viewport: Viewport {
                scale: [bits(100.0); 2],
                origin: [bits(128.0), bits(64.0)],
                depth_a: bits(1.0),
                depth_b: bits(-1.0),
            },
            epsilon: EpsilonScale { scale: bits(1.0), bias: bits(0.0) },
            filter_radius: bits(1.0),
        }
    }

    /// A splat at depth 2 on the axis, with the given tangents.
    fn setup(tangents: [[f32; 3]; 2]) -> Option<SetupSplat> {
        setup_in(Format::F32, Feature::Off, tangents, &uniforms())
    }

    fn setup_in(
        geometry: Format,
        culling: Feature,
        tangents: [[f32; 3]; 2],
        uniforms: &SetupUniforms,
    ) -> Option<SetupSplat> {
        let unit = Setup::new(&Config { height: 128, geometry, culling, ..Config::default() }, 1);
        let encode = |value: f32| Number::new(Format::F32, value.to_bits()).convert(geometry).bits();
        let center = [0.0, 0.0, 2.0].map(encode);
        let tangents = tangents.map(|tangent| tangent.map(encode));
        let encode = |bits| encode(f32::from_bits(bits));
        let uniforms = SetupUniforms {
            viewport: Viewport {
                scale: uniforms.viewport.scale.map(encode),
                origin: uniforms.viewport.origin.map(encode),
                depth_a: encode(uniforms.viewport.depth_a),
                depth_b: encode(uniforms.viewport.depth_b),
            },
            epsilon: EpsilonScale { scale: encode(uniforms.epsilon.scale), bias: encode(uniforms.epsilon.bias) },
            filter_radius: encode(uniforms.filter_radius),
        };
        unit.setup(&Splat { end: false, center, tangents, attributes: [0; 14] }, &uniforms)
    }

    fn bounds(splat: &SetupSplat) -> [u16; 4] {
        let ImageRectangle { left, right, top, bottom } = splat.bounds;
        [left, right, top, bottom]
    }

    #[test]
    fn a_facing_disc_has_the_bounds_of_its_circle() {
        // 0.2 at distance 2: 10 px about (128, 64); samples lie at half pixels.
        let splat = setup([[0.2, 0.0, 0.0], [0.0, 0.2, 0.0]]).expect("it is in view");
        assert_eq!(bounds(&splat), [118, 137, 54, 73]);
        let Band { depth, low, high } = splat.footprint.band;
        assert_eq!([depth, low, high], [1 << 23; 3], "all of it lies at depth ½");
        let tiny = setup([[1e-6, 0.0, 0.0], [0.0, 1e-6, 0.0]]).expect("the filter shows it");
        assert_eq!(bounds(&tiny), [127, 128, 63, 64]);
    }

    #[test]
    fn a_slanted_disc_has_a_depth_range() {
        let splat = setup([[0.2, 0.0, 0.5], [0.0, 0.2, 0.0]]).expect("it is in view");
        let Band { low, high, .. } = splat.footprint.band;
        // It reaches from z = 1½ to z = 2½: depths ⅓ and ⅗.
        let error = [(low, 1.0 / 3.0), (high, 3.0 / 5.0)]
            .map(|(bits, depth)| (f64::from(bits) / f64::from(1 << 24) - depth).abs());
        assert!(error.into_iter().all(|error| error < 1e-6), "{low}, {high}");
    }

    #[test]
    fn a_splat_across_the_near_plane_is_tested_at_its_center() {
        // It reaches from z = ½ to z = 3½.
        let splat = setup([[0.2, 0.0, 1.5], [0.0, 0.2, 0.0]]).expect("it is in view");
        assert_ne!(bounds(&splat), [0, 255, 0, 127]);
        assert_eq!(splat.footprint.band, Band { depth: 1 << 23, low: 0, high: (1 << 24) - 1 });
    }

    #[test]
    fn without_the_part_for_the_eye_plane_whole_splats_are_what_they_were() {
        let unit =
            |eye_plane| Setup::new(&Config { height: 128, geometry: Format::F32, eye_plane, ..Config::default() }, 1);
        let [with, without] = [Feature::On, Feature::Off].map(unit);
        let splat = |reach: f32| {
            let tangents = [[0.0, 0.2, 0.0], [0.2, 0.0, 2.0 * reach]].map(|tangent| tangent.map(f32::to_bits));
            Splat { center: [0.0, 0.0, 2.0].map(f32::to_bits), tangents, ..Splat::default() }
        };
        for (reach, is_whole) in [(0.0, true), (0.9, true), (0.999_94, false), (1.5, false)] {
            let splat = splat(reach);
            assert_eq!(with.slant_of(&splat).is_whole, is_whole, "{reach}");
            let same = with.setup(&splat, &uniforms()) == without.setup(&splat, &uniforms());
            assert_eq!(same, is_whole, "{reach}: only splats across the eye plane need the part");
        }
    }

    #[test]
    fn back_faces_are_culled_in_any_size_and_image() {
        let [upright, upside_down] = [1.0, -1.0].map(|sign| {
            let scale = [100.0_f32, sign * 100.0].map(f32::to_bits);
            SetupUniforms { viewport: Viewport { scale, ..uniforms().viewport }, ..uniforms() }
        });
        let is_drawn = |tangents, culling, uniforms| setup_in(Format::F32, culling, tangents, uniforms).is_some();
        for size in [0.2_f32, 1e-12, 1e12] {
            // The cross product of the front's tangents points towards the eye, along −z.
            let front = [[0.0, size, 0.0], [size, 0.0, 0.0]];
            let back = [front[1], front[0]];
            for uniforms in [&upright, &upside_down] {
                assert!(is_drawn(front, Feature::On, uniforms) && !is_drawn(back, Feature::On, uniforms), "{size}");
                assert!(is_drawn(front, Feature::Off, uniforms) && is_drawn(back, Feature::Off, uniforms));
            }
            let edge_on = [front[0], front[0]];
            assert!(is_drawn(edge_on, Feature::On, &upright), "its disc is drawn");
        }
    }

    #[test]
    fn a_splat_seen_edge_on_has_no_delta() {
        // Tangents a little apart from parallel: more and less than rounding takes.
        for (format, apart) in [(Format::F32, 1e-5_f32), (Format::F24, 1e-3)] {
            let delta = |tilt: f32| {
                let splat = setup_in(format, Feature::On, [[0.3, 0.3, 0.0], [0.3 + tilt, 0.3, 0.0]], &uniforms());
                Number::new(format, splat.expect("it is in view").footprint.delta)
            };
            assert!(delta(0.0).is_nan() && delta(apart / 128.0).is_nan());
            assert!(delta(apart).is_negative());
        }
    }

    #[test]
    fn coarse_formats_keep_away_from_the_eye_plane() {
        let has_viewport = |format, reach: f32| {
            let splat = setup_in(format, Feature::Off, [[0.2, 0.0, 2.0 * reach], [0.0, 0.2, 0.0]], &uniforms());
            bounds(&splat.expect("it is in view")) == [0, 255, 0, 127]
        };
        // `e = 1 − reach²`: 0.06, 0.02, 2^−13.
        for (reach, fine, coarse) in [(0.97, false, false), (0.99, false, true), (0.999_94, true, true)] {
            assert_eq!((has_viewport(Format::F32, reach), has_viewport(Format::F24, reach)), (fine, coarse), "{reach}");
        }
    }

    #[test]
    fn the_footprint_alone_has_the_rasterizers_format() {
        let setup = |rasterizer: Option<Format>| {
            let rasterizer = rasterizer.map(RasterFormat::Float);
            let unit = Setup::new(&Config { geometry: Format::F32, rasterizer, ..Config::default() }, 1);
            let encode = f32::to_bits;
            let (center, tangents) =
                ([0.3, 0.1, 2.0].map(encode), [[0.0, 0.3, 0.1], [0.2, 0.0, 0.7]].map(|t| t.map(encode)));
            unit.setup(&Splat { end: false, center, tangents, attributes: [0; 14] }, &uniforms())
                .expect("it is in view")
        };
        let (wide, narrow) = (setup(None), setup(Some(Format::BF16)));
        let rounded = |bits| Number::new(Format::F32, bits).convert(Format::BF16).bits();
        let Footprint { center, ax, bx, ay, by, delta, mx, my, shift, band, plane } = wide.footprint;
        let center = center.map(rounded);
        let [ax, bx, ay, by, delta, mx, my] = [ax, bx, ay, by, delta, mx, my].map(rounded);
        let plane = DepthPlane {
            center: rounded(plane.center),
            slope: plane.slope.map(rounded),
            range: plane.range.map(rounded),
            epsilon: rounded(plane.epsilon),
        };
        let rounded = Footprint { center, ax, bx, ay, by, delta, mx, my, shift, band, plane };
        assert_eq!(narrow.footprint, rounded);
        assert_eq!(narrow.bounds, wide.bounds);
    }

    #[test]
    fn a_splat_across_the_eye_plane_has_the_viewport() {
        let splat = setup([[0.2, 0.0, 2.0], [0.0, 0.2, 0.0]]).expect("it is in view");
        assert_eq!(bounds(&splat), [0, 255, 0, 127]);
        assert_eq!(splat.footprint.band, Band { depth: 1 << 23, low: 0, high: (1 << 24) - 1 });
    }
}
