//! The methods that the thesis measures itself against, in the hardware's number format: what they would visit, and what they would draw.
//!
//! - *Conic* \[ZRB+04\]: the splat's outline as a conic `Q = M⁻ᵀ·diag(1, 1, −1)·M⁻¹`, centred; adjugate in the inverse's place.
//! - *Square* \[BSK04\]: a square about the projected centre, half as wide as the longer tangent seen head-on at the centre's distance; samples
//!   are projected to the splat's plane and measured by reciprocally scaled tangents.
//! - *Affine* (thesis ch. 3): the projection's Jacobian at the centre in the projection's place.

use super::case::{Case, IMAGE_EDGE_PX};
use pointcore_contract::Format;
use pointcore_golden::number::Number;
use serde::Serialize;
use std::ops::Range;

/// Bounds are rounded outwards by as much as the hardware's.
const MARGIN_PX: f64 = 1.0 / 256.0;

/// A method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// The hardware's.
    Ours,
    /// See the module.
    Conic,
    /// See the module.
    Square,
    /// See the module.
    Affine,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Ours, Self::Conic, Self::Square, Self::Affine];

    /// Its name in keys and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ours => "ours",
            Self::Conic => "conic",
            Self::Square => "square",
            Self::Affine => "affine",
        }
    }
}

type Vector = [Number; 3];

fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn dot(a: Vector, b: Vector) -> Number {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A splat, and its lens, as numbers of the format.
struct Input {
    u: Vector,
    tangents: [Vector; 2],
    scale: Number,
    origin: [Number; 2],
}

impl Input {
    fn new(case: &Case, format: Format) -> Self {
        let number = |bits| Number::new(case.format, bits).convert(format);
        let uniforms = case.setup_uniforms();
        Self {
            u: case.splat.center.map(number),
            tangents: case.splat.tangents.map(|tangent| tangent.map(number)),
            scale: number(uniforms.viewport.scale[0]),
            origin: uniforms.viewport.origin.map(number),
        }
    }

    fn zero(&self) -> Number {
        self.u[0].of(0.0)
    }
}

/// A method's setup of one splat.
pub struct Prepared {
    /// Columns and rows to visit.
    pub bounds: [Range<u32>; 2],
    samples: Samples,
}

enum Samples {
    Conic {
        center: [Number; 2],
        /// `A`, `B`, `C` of the centred conic, and minus its constant.
        form: [Number; 4],
    },
    Plane {
        input: Box<Input>,
        normal: Vector,
        /// `⟨u, n⟩`.
        height: Number,
        reciprocals: [Number; 2],
    },
    Affine {
        center: [Number; 2],
        variances: [Number; 3],
        determinant: Number,
    },
}

/// Pixels whose samples lie between two bounds, on the safe side of NaNs.
fn pixels(low: Number, high: Number) -> Range<u32> {
    let (low, high) = (f64::from(low.value()), f64::from(high.value()));
    let first = (low - 0.5 - MARGIN_PX).ceil().max(0.0);
    let past = if high.is_nan() { f64::INFINITY } else { (high - 0.5 + MARGIN_PX).floor() + 1.0 };
    // Casts saturate.
    (first as u32)..(past as u32).min(IMAGE_EDGE_PX)
}

impl Prepared {
    /// Setup by a method that is not the hardware's.
    #[must_use]
    pub fn new(method: Method, case: &Case) -> Self {
        Self::in_format(method, case, case.format)
    }

    /// The same with the case's numbers, but all arithmetic in another format.
    #[must_use]
    pub fn in_format(method: Method, case: &Case, format: Format) -> Self {
        let input = Input::new(case, format);
        match method {
            Method::Ours | Method::Affine => affine(&input),
            Method::Conic => conic(&input),
            Method::Square => square(input),
        }
    }

    /// Samples to visit.
    #[must_use]
    pub fn visited(&self) -> u64 {
        self.bounds.iter().map(|range| range.len() as u64).product()
    }

    /// What stands for `ρ²` at a pixel: below one inside the splat.
    #[must_use]
    pub fn squared_distance(&self, pixel: [u32; 2]) -> f64 {
        let away = |center: Number, axis: usize| center.of(pixel[axis] as f32 + 0.5) - center;
        let squared = match &self.samples {
            Samples::Conic { center, form: [xx, xy, yy, constant] } => {
                let (x, y) = (away(center[0], 0), away(center[1], 1));
                let mixed = *xy * x * y;
                (*xx * x * x + (mixed + mixed) + *yy * y * y) / *constant
            }
            Samples::Plane { input, normal, height, reciprocals } => {
                let [x, y] = [0, 1].map(|axis| away(input.origin[axis], axis) / input.scale);
                let ray = [x, y, x.of(1.0)];
                let along = *height / dot(ray, *normal);
                if !input.zero().is_below(along) {
                    return f64::INFINITY;
                }
                let point = [0, 1, 2].map(|i| ray[i] * along - input.u[i]);
                let [s, t] = [0, 1].map(|i| dot(point, input.tangents[i]) * reciprocals[i]);
                s * s + t * t
            }
            Samples::Affine { center, variances: [xx, xy, yy], determinant } => {
                let (x, y) = (away(center[0], 0), away(center[1], 1));
                let mixed = *xy * x * y;
                (*yy * x * x - (mixed + mixed) + *xx * y * y) / *determinant
            }
        };
        squared.value().into()
    }
}

fn conic(input: &Input) -> Prepared {
    let zero = input.zero();
    let [a1, a2] = input.tangents;
    // The rows of M take (s, t, 1) to the sample, homogeneous.
    let row = |axis: usize| [a1, a2, input.u].map(|v| input.scale * v[axis] + input.origin[axis] * v[2]);
    let (x, y, w) = (row(0), row(1), [a1[2], a2[2], input.u[2]]);
    // The columns of the adjugate are the cross products of M's rows.
    let columns = [cross(y, w), cross(w, x), cross(x, y)];
    let form = |i: usize, j: usize| {
        let (p, q) = (columns[i], columns[j]);
        p[0] * q[0] + p[1] * q[1] - p[2] * q[2]
    };
    let (xx, xy, yy, xw, yw, ww) = (form(0, 0), form(0, 1), form(1, 1), form(0, 2), form(1, 2), form(2, 2));
    let determinant = xx * yy - xy * xy;
    let center = [(xy * yw - yy * xw) / determinant, (xy * xw - xx * yw) / determinant];
    let constant = zero - (ww + xw * center[0] + yw * center[1]);
    let extent = |form: Number| (constant * form / determinant).sqrt();
    let half = [extent(yy), extent(xx)];
    let bounds = [0, 1].map(|axis| pixels(center[axis] - half[axis], center[axis] + half[axis]));
    Prepared { bounds, samples: Samples::Conic { center, form: [xx, xy, yy, constant] } }
}

fn projected(input: &Input) -> [Number; 2] {
    [0, 1].map(|axis| input.scale * (input.u[axis] / input.u[2]) + input.origin[axis])
}

fn square(input: Input) -> Prepared {
    let [a1, a2] = input.tangents;
    let squares = [dot(a1, a1), dot(a2, a2)];
    let half = input.scale * (squares[0].max(squares[1]).sqrt() / input.u[2]);
    let bounds = projected(&input).map(|center| pixels(center - half, center + half));
    let normal = cross(a1, a2);
    let (height, reciprocals) = (dot(input.u, normal), squares.map(Number::recip));
    Prepared { bounds, samples: Samples::Plane { input: Box::new(input), normal, height, reciprocals } }
}

fn affine(input: &Input) -> Prepared {
    let r = input.u[2].recip();
    let [a1, a2] = input.tangents;
    let along = |tangent: Vector, axis: usize| input.scale * (tangent[axis] * r - input.u[axis] * r * (tangent[2] * r));
    let [[ax, bx], [ay, by]] = [0, 1].map(|axis| [along(a1, axis), along(a2, axis)]);
    let variances = [ax * ax + bx * bx, ax * ay + bx * by, ay * ay + by * by];
    let center = projected(input);
    let half = [variances[0].sqrt(), variances[2].sqrt()];
    let bounds = [0, 1].map(|axis| pixels(center[axis] - half[axis], center[axis] + half[axis]));
    let determinant = variances[0] * variances[2] - variances[1] * variances[1];
    Prepared { bounds, samples: Samples::Affine { center, variances, determinant } }
}
