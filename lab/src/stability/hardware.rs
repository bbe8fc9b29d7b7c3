//! A case through the arithmetic of the golden models, and beside it what rounding may do to it.

use super::case::{Case, FILTER_RADIUS_PX, IMAGE_EDGE_PX};
use super::rounding::Bounded;
use pointcore_contract::Format;
use pointcore_contract::splat::records::{Footprint, Pixel, Sample, SamplePlace, SetupSplat};
use pointcore_contract::splat::{Config, Division, Feature};
use pointcore_golden::number::Number;
use pointcore_golden::splat::{Accumulator, Rasterizer, Setup, Transform, Weighting};

/// `e` at or below which setup takes a splat for one that crosses the eye plane.
#[must_use]
pub fn crossing_clearance(format: Format) -> f64 {
    if format.mantissa + 1 >= 24 { 1.0 / 4096.0 } else { 1.0 / 32.0 }
}

/// What became of a splat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// Its centre is not beyond the near plane, or it was taken for one that faces away.
    Culled,
    /// It lies behind the far plane, or has no pixel.
    Empty,
    /// It is drawn.
    Drawn(SetupSplat),
}

/// The units, with and without a screen filter, setup also with and without culling.
pub struct Units {
    /// How they divide.
    pub division: Division,
    transform: Transform,
    setup: [[Setup; 2]; 2],
    rasterizer: [Rasterizer; 2],
    weighting: Weighting,
    accumulator: Accumulator,
}

impl Units {
    /// The units of a number format, dividing as the default configuration does.
    #[must_use]
    pub fn new(format: Format) -> Self {
        Self::with_division(format, Config::default().division)
    }

    /// The units of a number format that divide in one way or the other.
    #[must_use]
    pub fn with_division(format: Format, division: Division) -> Self {
        let config = |screen_filter, culling| Config {
            width: IMAGE_EDGE_PX,
            height: IMAGE_EDGE_PX,
            geometry: format,
            division,
            screen_filter,
            culling,
            transform_interval: 1,
            setup_interval: 1,
            ..Config::default()
        };
        let features = [Feature::Off, Feature::On];
        let [off, on] = features.map(|filter| config(filter, Feature::On));
        Self {
            division,
            transform: Transform::new(&on, 1),
            setup: features.map(|filter| features.map(|culling| Setup::new(&config(filter, culling), 1))),
            rasterizer: [Rasterizer::new(&off, 1), Rasterizer::new(&on, 1)],
            weighting: Weighting::new(&on, 1),
            accumulator: Accumulator::new(&on),
        }
    }

    /// Transform and setup.
    #[must_use]
    pub fn fate(&self, case: &Case) -> Fate {
        let Some(splat) = self.transform.transform(&case.splat, &case.transform_uniforms()) else {
            return Fate::Culled;
        };
        let [keeping, culling] = &self.setup[usize::from(case.filter.is_on())];
        let uniforms = case.setup_uniforms();
        match culling.setup(&splat, &uniforms) {
            Some(drawn) => Fate::Drawn(drawn),
            None if keeping.setup(&splat, &uniforms).is_some() => Fate::Culled,
            None => Fate::Empty,
        }
    }

    /// The rasterizer's `ρ²` at a pixel.
    #[must_use]
    pub fn squared_distance(&self, case: &Case, footprint: &Footprint, pixel: [u32; 2]) -> Number {
        self.rasterizer[usize::from(case.filter.is_on())].squared_distance(footprint, pixel, case.filter_scale())
    }

    /// The kernel's weight there; `None` outside the splat.
    #[must_use]
    pub fn weight(&self, squared: Number) -> Option<u16> {
        Rasterizer::is_inside(squared).then(|| self.rasterizer[0].weight(squared))
    }

    /// What a pixel holds after so many samples of one splat.
    #[must_use]
    pub fn accumulated(&self, drawn: &SetupSplat, weight: u16, samples: u32) -> Pixel {
        let place = SamplePlace { inside: true, weight, ..SamplePlace::default() };
        let sample = Sample { place, band: drawn.footprint.band, attributes: drawn.attributes };
        let weighted = self.weighting.weigh(&sample);
        let mut pixel = Pixel::default();
        for _ in 0..samples {
            pixel = self.accumulator.accumulate(&pixel, &weighted).unwrap_or(pixel);
        }
        pixel
    }
}

/// Rounding of setup and rasterizer, by the operations of docs/units/splat.
pub struct Analysis {
    format: Format,
    division: Division,
    center: [Bounded; 2],
    a: [Bounded; 2],
    b: [Bounded; 2],
    delta: Bounded,
    /// `Δ`'s first term.
    diagonal: Bounded,
    m: [Bounded; 2],
    filter: Feature,
    /// Low and high bounds in pixels, both axes; of splats that setup takes for whole.
    pub bounds: [[Bounded; 2]; 2],
    /// `e`.
    pub clearance: Bounded,
    /// Depth of the centre.
    pub center_depth: Bounded,
    /// The middle of the depth range.
    pub middle_depth: Bounded,
    /// The near end of the depth range.
    pub near_depth: Bounded,
}

impl Analysis {
    /// The analysis of a case whose numbers are finite, on units that divide so.
    #[must_use]
    pub fn new(case: &Case, division: Division) -> Self {
        let format = case.format;
        let exact = |value| Bounded::exact(format, value);
        let [ux, uy, uz, a1x, a1y, a1z, a2x, a2y, a2z] = case.numbers().map(exact);
        let (scale, one) = (exact(case.lens.scale), exact(1.0));
        let r = uz.recip(division);
        let (alpha, beta) = (a1z * r, a2z * r);
        let q = alpha * alpha + beta * beta;
        let e = one - q;
        let f = e.recip(division);
        let axes = [(ux, a1x, a2x), (uy, a1y, a2y)].map(|(u, a1, a2)| {
            let v = u * r;
            (scale * v, scale * (a1 * r - v * alpha), scale * (a2 * r - v * beta))
        });
        let center = [0, 1].map(|axis| axes[axis].0 + exact(case.lens.origin[axis]));
        let (a, b) = (axes.map(|axis| axis.1), axes.map(|axis| axis.2));
        let filter_radius = exact(FILTER_RADIUS_PX.into());
        let bounds = [0, 1].map(|axis| {
            let (c, a, b) = (center[axis], a[axis], b[axis]);
            let t = (a * alpha + b * beta) * f;
            let h = (t * t + (a * a + b * b) * f).sqrt(division);
            let (low, high) = ((c - t) - h, (c - t) + h);
            if case.filter.is_on() {
                let (disc_low, disc_high) = (c - filter_radius, c + filter_radius);
                [extreme(low, disc_low, f64::min), extreme(high, disc_high, f64::max)]
            } else {
                [low, high]
            }
        });
        let depth = exact(case.lens.depth_b) * r;
        let center_depth = exact(case.lens.depth_a) + depth;
        let middle_depth = center_depth + depth * (q * f);
        Self {
            format,
            division,
            center,
            a,
            b,
            delta: a[0] * b[1] - b[0] * a[1],
            diagonal: a[0] * b[1],
            m: [beta * a[1] - alpha * b[1], alpha * b[0] - beta * a[0]],
            filter: case.filter,
            bounds,
            clearance: e,
            center_depth,
            middle_depth,
            near_depth: middle_depth - depth.abs() * (q.sqrt(division) * f),
        }
    }

    /// The projected centre (px).
    #[must_use]
    pub fn center(&self) -> [f64; 2] {
        self.center.map(|center| center.value)
    }

    /// Whether rounding may make setup take the splat for one seen edge-on.
    fn may_be_edge_on(&self) -> bool {
        // Exponents that differ by more than `p − 4` mean a ratio below that power of ½.
        let resolution = 0.5_f64.powi(self.format.mantissa as i32 - 3);
        let known = self.delta.value.abs() - self.delta.error;
        let mistaken = known <= resolution * (self.diagonal.value.abs() + self.diagonal.error);
        mistaken || known.is_nan()
    }

    /// `ρ²` at a pixel; the error is infinite where rounding may have any effect.
    #[must_use]
    pub fn squared_distance(&self, pixel: [u32; 2]) -> Bounded {
        let exact = |value| Bounded::exact(self.format, value);
        let [x, y] = [0, 1].map(|axis| exact(f64::from(pixel[axis]) + 0.5) - self.center[axis]);
        let determinant = self.delta + x * self.m[0] + y * self.m[1];
        let s = [self.a, self.b].map(|[along_x, along_y]| x * along_y - y * along_x);
        let distance = match self.division {
            Division::Rounded => (s[0] * s[0] + s[1] * s[1]) / (determinant * determinant),
            Division::Newton => {
                let [q1, q2] = s.map(|s| s * determinant.recip(Division::Newton));
                q1 * q1 + q2 * q2
            }
        };
        let on_splat = match (determinant.sign(), self.delta.sign()) {
            _ if self.may_be_edge_on() => Bounded { error: f64::INFINITY, ..distance },
            (Some(sample), Some(center)) if sample == center => distance,
            (Some(_), Some(_)) => Bounded { value: f64::INFINITY, error: 0.0, ..distance },
            _ => Bounded { error: f64::INFINITY, ..distance },
        };
        if self.filter.is_on() { extreme(on_splat, x * x + y * y, f64::min) } else { on_splat }
    }
}

/// The least or greatest of two, which is off by no more than the worse of them.
fn extreme(a: Bounded, b: Bounded, choose: fn(f64, f64) -> f64) -> Bounded {
    Bounded { value: choose(a.value, b.value), error: a.error.max(b.error), ..a }
}
