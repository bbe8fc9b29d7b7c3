//! What rounding may do to a case on its way through setup and rasterizer, by the operations of docs/units/splat.

use super::case::{Case, FILTER_RADIUS_PX};
use super::rounding::Bounded;
use pointcore_contract::Format;
use pointcore_contract::splat::{Division, Feature};

/// Powers of two by which a centre lies farther aside than away that is no origin.
const ASIDE: i64 = 10;
/// The same in formats with fewer bits than `f32`.
const COARSE_ASIDE: i64 = 4;
/// Powers of two by which a tangent is longer than the centre is deep that setup makes shorter: nothing is promised of these.
const LONGEST: i64 = 60;
/// Lengths, `Δ` and `m` stay below this power of two times what setup scales to one.
const FARTHEST: i32 = 100;
/// Least numbers that a coefficient and the two products of a sum have lost, in terms that are the sum's.
const VANISHED_TERMS: f64 = 4.0;
/// Of shorter tangents setup makes splats that are seen edge-on, of some a little longer, too.
const VANISHING_PX: f64 = 1e-28;
/// What is a smaller share of a tangent's other component vanishes when the tangent is scaled to about one.
const VANISHING_SHARE: f64 = 1e-36;

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
    /// What becomes one when setup scales all of these by one power of two, or less.
    one: f64,
    /// `D` at near and far plane, and whether setup leaves the limit out, if rounding cannot have changed that.
    limits: [(Bounded, Option<bool>); 2],
    /// A tangent is in the centre's place; and the sign of the depth of what is there.
    pub turned: bool,
    depth_sign: f64,
    /// The filter's disc is drawn, if rounding cannot have changed that.
    disc: Option<bool>,
    /// Setup has made tangents shorter.
    is_lowered: bool,
    /// The origin is the centre, and lies beyond the near plane.
    pub is_centered: bool,
    /// Setup takes the splat for one before the eye, if rounding cannot have changed that.
    pub is_whole: Option<bool>,
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
        let Origin { numbers, turned, is_lowered, is_centered } = Origin::new(case);
        let [ux, uy, uz, a1x, a1y, a1z, a2x, a2y, a2z] = numbers.map(exact);
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
        let base = exact(case.lens.depth_a);
        let depth = exact(case.lens.depth_b) * r;
        let center_depth = base + depth;
        let middle_depth = center_depth + depth * (q * f);
        let half_depth = depth.abs() * (q.sqrt(division) * f);
        let (near_depth, far_depth) = (middle_depth - half_depth, middle_depth + half_depth);
        let delta = a[0] * b[1] - b[0] * a[1];
        let by_depth = delta * depth.recip(division);
        let mut near_limit = by_depth * exact(-case.lens.depth_a);
        // Where depth is 0 and where the near plane is are two numbers, each rounded.
        near_limit.error +=
            near_limit.value.abs() * (case.lens.near * case.lens.depth_a / case.lens.depth_b + 1.0).abs();
        let far_limit = by_depth * (one - base);
        let m = [beta * a[1] - alpha * b[1], alpha * b[0] - beta * a[0]];
        let length = |[x, y]: [Bounded; 2]| x.most().max(y.most());
        let slope = (length(a) * beta.most()).max(length(b) * alpha.most());
        let farthest = delta.most().max(length(a)).max(length(b)).max(slope) * 0.5_f64.powi(FARTHEST);
        let clearance = super::hardware::crossing_clearance(format);
        let is_whole = if turned || is_lowered { Some(false) } else { e.is_above(clearance) };
        let left_out = |is_within: Option<bool>| match (is_whole, is_within) {
            (Some(false), _) | (_, Some(false)) => Some(false),
            (Some(true), Some(true)) => Some(true),
            _ => None,
        };
        let limits = [
            (near_limit, left_out(near_depth.is_above(0.0))),
            (far_limit, left_out(far_depth.is_above(1.0).map(|is_beyond| !is_beyond))),
        ];
        let disc = if is_centered { center_depth.is_above(1.0).map(|is_far| !is_far) } else { Some(false) };
        Self {
            format,
            division,
            center,
            a,
            b,
            delta,
            limits,
            turned,
            depth_sign: numbers[2].signum(),
            disc,
            is_lowered,
            is_centered,
            is_whole,
            diagonal: a[0] * b[1],
            m,
            // A ratio of exponents is less than twice that of numbers.
            one: 2.0 * by_depth.most().max(farthest),
            filter: case.filter,
            bounds,
            clearance: e,
            center_depth,
            middle_depth,
            near_depth,
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
        // Too short, or with a component that vanishes where the other is about one.
        let vanishing = [self.a, self.b].iter().any(|[x, y]| {
            let (x, y) = (x.value.abs(), y.value.abs());
            let (shorter, longer) = (x.min(y), x.max(y));
            longer < VANISHING_PX || (shorter > 0.0 && shorter < longer * VANISHING_SHARE)
        });
        let mistaken = vanishing || known <= resolution * (self.diagonal.value.abs() + self.diagonal.error);
        mistaken || known.is_nan()
    }

    /// `ρ²` at a pixel; the error is infinite where rounding may have any effect.
    #[must_use]
    pub fn squared_distance(&self, pixel: [u32; 2]) -> Bounded {
        let exact = |value| Bounded::exact(self.format, value);
        let [x, y] = [0, 1].map(|axis| exact(f64::from(pixel[axis]) + 0.5) - self.center[axis]);
        let [delta, mx, my] = [self.delta, self.m[0], self.m[1]].map(|number| self.scaled(number));
        let determinant = self.scaled(delta + x * mx + y * my);
        let s = [self.a, self.b].map(|[along_x, along_y]| {
            let [along_x, along_y] = [along_x, along_y].map(|number| self.scaled(number));
            self.scaled(x * along_y - y * along_x)
        });
        let (across, divisor) = if self.turned { (determinant, s[0]) } else { (s[0], determinant) };
        let distance = match self.division {
            Division::Rounded => (across * across + s[1] * s[1]) / (divisor * divisor),
            Division::Newton => {
                let [q1, q2] = [across, s[1]].map(|s| s * divisor.recip(Division::Newton));
                q1 * q1 + q2 * q2
            }
        };
        let on_splat = match self.is_seen(divisor) {
            _ if self.may_be_edge_on() || self.is_lowered => Bounded { error: f64::INFINITY, ..distance },
            Some(true) => Bounded { error: distance.error + self.vanished(distance, divisor), ..distance },
            Some(false) => Bounded { value: f64::INFINITY, error: 0.0, ..distance },
            None => Bounded { error: f64::INFINITY, ..distance },
        };
        match self.disc {
            _ if !self.filter.is_on() => on_splat,
            Some(true) => extreme(on_splat, x * x + y * y, f64::min),
            Some(false) => on_splat,
            None => Bounded { error: f64::INFINITY, ..on_splat },
        }
    }

    /// A number that setup scales, or a sum of the rasterizer's: what falls below the least number is a matter of that scale.
    fn scaled(&self, number: Bounded) -> Bounded {
        Bounded { error: number.error + VANISHED_TERMS * f64::from(f32::MIN_POSITIVE) * self.one, ..number }
    }

    /// What `ρ²` is off by for squares that fall below the least number.
    fn vanished(&self, distance: Bounded, divisor: Bounded) -> f64 {
        let least = f64::from(f32::MIN_POSITIVE) * (self.one / divisor.least()).powi(2);
        // Two of the numerator, and the divisor's as a share.
        if least < 0.5 { (2.0 + 2.0 * distance.value) * least } else { f64::INFINITY }
    }

    /// Whether a sample with such a `D`, or `s1` in its place, lies between near and far plane, if rounding cannot have changed that.
    fn is_seen(&self, divisor: Bounded) -> Option<bool> {
        // `s1` comes with the other sign.
        let sign = if self.turned { -divisor.sign()? } else { divisor.sign()? };
        if sign != self.delta.sign()? * self.depth_sign {
            return Some(false);
        }
        let sides = [1.0, -1.0].into_iter().zip(self.limits).map(|(side, (limit, is_left_out))| {
            let inside = (limit.abs() - divisor.abs()).sign().map(|sign| sign == side);
            match (is_left_out, inside) {
                (Some(true), _) | (_, Some(true)) => Some(true),
                (Some(false), inside) => inside,
                (None, _) => None,
            }
        });
        let sides: Vec<Option<bool>> = sides.collect();
        if sides.contains(&Some(false)) {
            return Some(false);
        }
        sides.iter().all(Option::is_some).then_some(true)
    }
}

/// What setup projects, by comparisons, which are exact.
struct Origin {
    numbers: [f64; 9],
    turned: bool,
    is_lowered: bool,
    is_centered: bool,
}

/// The exponent of a number, of zero and of what reads as zero the least.
fn exponent(number: f64) -> i64 {
    let exponent = (number.to_bits() >> 52 & 0x7ff) as i64 - 1023;
    exponent.max(i64::from(f32::MIN_EXP) - 2)
}

impl Origin {
    fn new(case: &Case) -> Self {
        let numbers = case.numbers();
        let [u, first, second] = [0, 3, 6].map(|place| [numbers[place], numbers[place + 1], numbers[place + 2]]);
        let is_beyond_near = case.lens.near < u[2];
        let is_coarse = case.format.mantissa < Format::F32.mantissa;
        let aside = if is_coarse { COARSE_ASIDE } else { ASIDE };
        let is_aside = exponent(u[2]) + aside < exponent(u[0]).max(exponent(u[1]));
        let deepest = first[2].abs().max(second[2].abs());
        let turned = u[2] < deepest && (!is_beyond_near || is_aside);
        let (leading, other) = if first[2].abs() < second[2].abs() { (second, first) } else { (first, second) };
        let vectors = if turned { [leading, other, u] } else { [u, first, second] };
        let numbers: [f64; 9] = std::array::from_fn(|i| vectors[i / 3][i % 3]);
        let longest = numbers[3..].iter().map(|&number| exponent(number)).fold(i64::MIN, i64::max);
        let is_lowered = longest - exponent(numbers[2]) > LONGEST;
        Self { numbers, turned, is_lowered, is_centered: is_beyond_near && !turned }
    }
}

/// The least or greatest of two, which is off by no more than the worse of them.
fn extreme(a: Bounded, b: Bounded, choose: fn(f64, f64) -> f64) -> Bounded {
    Bounded { value: choose(a.value, b.value), error: a.error.max(b.error), ..a }
}
