//! The uniform registers as the units read them, and writes to them.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{EpsilonScale, ModelView, UniformWrite, Uniforms, Viewport};
use pointcore_contract::{Visit, Visitor, Word, Words, fields};

/// What the transform unit reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TransformUniforms {
    /// Model-view matrix.
    pub model_view: ModelView,
    /// Near plane.
    pub near_plane: u32,
}

/// What the setup unit reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SetupUniforms {
    /// From camera space to pixels and depths.
    pub viewport: Viewport,
    /// What ε is made of.
    pub epsilon: EpsilonScale,
    /// Near plane.
    pub near_plane: u32,
    /// Radius of the screen filter (px).
    pub filter_radius: u32,
}

/// Writes the bits that a register has; there is nothing at addresses beyond the last.
pub fn write_uniform(uniforms: &mut Uniforms, config: &Config, write: UniformWrite) {
    let UniformWrite { address, data } = write;
    if let Some(field) = fields::<Uniforms>(config).get(usize::from(address)) {
        let data = data & (u32::MAX >> (u32::BITS - field.width));
        uniforms.visit(config, &mut RegisterWrite { countdown: Some(address), data });
    }
}

/// Replaces the value that is met when the countdown has run out.
struct RegisterWrite {
    countdown: Option<u8>,
    data: u32,
}

impl Visitor<Words> for RegisterWrite {
    fn bits<W: Word>(&mut self, value: &mut W) {
        if self.countdown == Some(0) {
            *value = W::from_word(self.data.into());
        }
        self.countdown = self.countdown.and_then(|count| count.checked_sub(1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_follow_the_order_of_the_registers() {
        let config = Config::default();
        let mut uniforms = Uniforms::default();
        for (address, data) in [(12, 7), (18, 8), (22, 9), (23, 10)] {
            write_uniform(&mut uniforms, &config, UniformWrite { address, data });
        }
        let viewport = Viewport { scale: [7, 0], ..Viewport::default() };
        assert_eq!(uniforms, Uniforms { viewport, near_plane: 8, filter_scale: 9, ..Uniforms::default() });
    }
}
