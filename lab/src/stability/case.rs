//! One hard case: a splat in camera space, in a number format, with the camera that looks at it.

use super::family::Family;
use pointcore::number::encode;
use pointcore_contract::Format;
use pointcore_contract::splat::Feature;
use pointcore_contract::splat::records::{EpsilonScale, ModelView, Splat, Viewport};
use pointcore_golden::number::Number;
use pointcore_golden::splat::uniforms::{SetupUniforms, TransformUniforms};
use serde::Serialize;

/// Pixels along an edge of the image of every case.
pub const IMAGE_EDGE_PX: u32 = 512;
/// Radius of the screen filter, whose square and reciprocal are exact.
pub const FILTER_RADIUS_PX: f32 = 1.0;
/// ε of eq. 5.9 is the splat's own range and this.
const EPSILON_BIAS: f32 = 1.0 / 65536.0;

/// A camera at the origin. All numbers are those of the format.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Lens {
    /// Pixels by tangent of the angle from the axis, both ways.
    pub scale: f64,
    /// Where the axis meets the image (px).
    pub origin: [f64; 2],
    /// Distance of the near plane.
    pub near: f64,
    /// Depth is `depth_a + depth_b/z`.
    pub depth_a: f64,
    /// See `depth_a`.
    pub depth_b: f64,
}

/// A splat before a lens.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// What makes it hard.
    pub family: Family,
    /// How hard, below [`super::families::LEVELS`].
    pub level: u8,
    /// Number format of the geometry.
    pub format: Format,
    /// The splat, encoded.
    pub splat: Splat,
    /// The camera.
    pub lens: Lens,
    /// Whether the screen filter is on.
    pub filter: Feature,
}

/// The nearest number of a format.
#[must_use]
pub fn nearest(format: Format, value: f32) -> f64 {
    Number::new(format, encode(format, value)).value().into()
}

impl Lens {
    /// A lens that sees from `near` on, to `reach` times as far.
    #[must_use]
    pub fn new(format: Format, near: f32, reach: f32) -> Self {
        let edge = IMAGE_EDGE_PX as f32;
        let number = |value| nearest(format, value);
        Self {
            scale: number(0.9 * edge),
            origin: [number(edge / 2.0); 2],
            near: number(near),
            depth_a: number(reach / (reach - 1.0)),
            depth_b: number(-reach * near / (reach - 1.0)),
        }
    }
}

impl Case {
    /// Centre, first and second tangent.
    #[must_use]
    pub fn numbers(&self) -> [f64; 9] {
        let Splat { center, tangents: [a1, a2], .. } = self.splat;
        let bits = [center, a1, a2];
        std::array::from_fn(|i| Number::new(self.format, bits[i / 3][i % 3]).value().into())
    }

    /// The case with another number in one place of [`Case::numbers`].
    #[must_use]
    pub fn with_number(mut self, place: usize, value: f64) -> Self {
        let bits = encode(self.format, value as f32);
        match place / 3 {
            0 => self.splat.center[place % 3] = bits,
            tangent => self.splat.tangents[tangent - 1][place % 3] = bits,
        }
        self
    }

    fn encode(&self, value: f64) -> u32 {
        encode(self.format, value as f32)
    }

    /// Constants of the transform unit that leave a splat where it is.
    #[must_use]
    pub fn transform_uniforms(&self) -> TransformUniforms {
        let entry = |row: usize, column: usize| self.encode(f64::from(u8::from(row == column)));
        let rows = std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)));
        TransformUniforms { model_view: ModelView { rows }, near_plane: self.encode(self.lens.near) }
    }

    /// Constants of the setup unit.
    #[must_use]
    pub fn setup_uniforms(&self) -> SetupUniforms {
        SetupUniforms {
            viewport: Viewport {
                scale: [self.encode(self.lens.scale); 2],
                origin: self.lens.origin.map(|value| self.encode(value)),
                depth_a: self.encode(self.lens.depth_a),
                depth_b: self.encode(self.lens.depth_b),
            },
            epsilon: EpsilonScale { scale: self.encode(1.0), bias: self.encode(EPSILON_BIAS.into()) },
            near_plane: self.encode(self.lens.near),
            filter_radius: self.encode(FILTER_RADIUS_PX.into()),
        }
    }

    /// The rasterizer's constant.
    #[must_use]
    pub fn filter_scale(&self) -> u32 {
        self.encode(FILTER_RADIUS_PX.powi(-2).into())
    }
}
