//! The uniform registers: constants of a frame, in the order of the specification's `UNIFORMS`.

use super::records::Shape;
use crate::unit::{Record, Visitor, Word};

/// What the transform unit reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TransformUniforms {
    /// Model-view matrix by rows.
    pub model_view: [[u32; 4]; 3],
    /// Near plane.
    pub near_plane: u32,
}

/// What the setup unit reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SetupUniforms {
    /// Viewport scale (px).
    pub scale: [u32; 2],
    /// Where the optical axis meets the image (px).
    pub origin: [u32; 2],
    /// Depth is `depth_a + depth_b/z`.
    pub depth_a: u32,
    /// See `depth_a`.
    pub depth_b: u32,
    /// Scale of the splat's own depth range in ε.
    pub epsilon_scale: u32,
    /// Constant part of ε.
    pub epsilon_bias: u32,
    /// Radius of the screen filter (px).
    pub filter_radius: u32,
}

/// All uniform registers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uniforms {
    /// Those of the transform unit.
    pub transform: TransformUniforms,
    /// Those of the setup unit.
    pub setup: SetupUniforms,
    /// That of the rasterizer: the reciprocal of the squared filter radius.
    pub filter_scale: u32,
}

const MODEL_VIEW: [[&str; 4]; 3] =
    [["m00", "m01", "m02", "m03"], ["m10", "m11", "m12", "m13"], ["m20", "m21", "m22", "m23"]];

impl TransformUniforms {
    fn visit_matrix(&mut self, visitor: &mut impl Visitor) {
        for (value, name) in self.model_view.iter_mut().flatten().zip(MODEL_VIEW.as_flattened()) {
            visitor.field(name, value);
        }
    }
}

impl Record<Shape> for TransformUniforms {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        self.visit_matrix(visitor);
        visitor.field("near_plane", &mut self.near_plane);
    }
}

impl SetupUniforms {
    fn visit_viewport(&mut self, visitor: &mut impl Visitor) {
        visitor.field("scale_x", &mut self.scale[0]);
        visitor.field("scale_y", &mut self.scale[1]);
        visitor.field("origin_x", &mut self.origin[0]);
        visitor.field("origin_y", &mut self.origin[1]);
        visitor.field("depth_a", &mut self.depth_a);
        visitor.field("depth_b", &mut self.depth_b);
    }

    fn visit_epsilon(&mut self, visitor: &mut impl Visitor) {
        visitor.field("epsilon_scale", &mut self.epsilon_scale);
        visitor.field("epsilon_bias", &mut self.epsilon_bias);
    }
}

impl Record<Shape> for SetupUniforms {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        self.visit_viewport(visitor);
        self.visit_epsilon(visitor);
        if shape.screen_filter.is_on() {
            visitor.field("filter_radius", &mut self.filter_radius);
        }
    }
}

impl Uniforms {
    /// Writes the register at `address`; there is nothing at addresses beyond the last.
    pub fn write(&mut self, address: u8, data: u32) {
        self.visit(&mut RegisterWrite { countdown: Some(address), data });
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        self.transform.visit_matrix(visitor);
        self.setup.visit_viewport(visitor);
        visitor.field("near_plane", &mut self.transform.near_plane);
        self.setup.visit_epsilon(visitor);
        visitor.field("filter_radius", &mut self.setup.filter_radius);
        visitor.field("filter_scale", &mut self.filter_scale);
    }
}

/// Replaces the field that is met when the countdown has run out.
struct RegisterWrite {
    countdown: Option<u8>,
    data: u32,
}

impl Visitor for RegisterWrite {
    fn field(&mut self, _name: &str, value: &mut impl Word) {
        if self.countdown == Some(0) {
            *value = Word::from_word(u64::from(self.data));
        }
        self.countdown = self.countdown.and_then(|count| count.checked_sub(1));
    }

    fn fields(&mut self, name: &str, values: &mut [impl Word]) {
        values.iter_mut().for_each(|value| self.field(name, value));
    }

    fn prefix(&mut self, _prefix: &'static str) {}
}

/// A write to a uniform register.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UniformWrite {
    /// Index in the list of uniforms.
    pub address: u8,
    /// Its new value.
    pub data: u32,
}

impl Record<Shape> for UniformWrite {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("address", &mut self.address);
        visitor.field("data", &mut self.data);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Names;
    use pointcore_contract::splat::ports::UNIFORMS;

    #[test]
    fn addresses_follow_the_list() {
        let mut names = Names::default();
        Uniforms::default().visit(&mut names);
        assert_eq!(names.0, UNIFORMS);

        let mut uniforms = Uniforms::default();
        uniforms.write(12, 7);
        uniforms.write(18, 8);
        uniforms.write(22, 9);
        uniforms.write(23, 10);
        let transform = TransformUniforms { near_plane: 8, ..TransformUniforms::default() };
        let setup = SetupUniforms { scale: [7, 0], ..SetupUniforms::default() };
        assert_eq!(uniforms, Uniforms { transform, setup, filter_scale: 9 });
    }
}
