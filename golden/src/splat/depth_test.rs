//! Ternary depth test: is a sample hidden by what its pixel holds, does it hide it, or do both blend (eq. 5.8)?
//!
//! The stored depth is a weighted sum; instead of dividing it by the stored weight, the limits of the sample's ε-band are
//! multiplied by it, in exact integers. Equality with a limit blends, and so does an empty pixel, onto zeros.

use super::records::Shape;
use crate::unit::{Model, Record, Visitor};
use pointcore_contract::splat::Config;

/// What the unit sees: a pixel and the band of a sample.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Stored weight.
    pub weight: u32,
    /// Stored weighted depth.
    pub depth: u64,
    /// Near end of the sample's band.
    pub depth_low: u32,
    /// Far end of the sample's band.
    pub depth_high: u32,
}

/// What the unit shows of the inputs three cycles before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Out {
    /// The stored surface hides the sample.
    pub fail: bool,
    /// The sample hides the stored surface.
    pub pass: bool,
}

/// The result of the test.
#[must_use]
pub fn test(inputs: &In) -> Out {
    let limit = |depth: u32| u64::from(depth) * u64::from(inputs.weight);
    Out { fail: inputs.depth < limit(inputs.depth_low), pass: inputs.depth > limit(inputs.depth_high) }
}

/// The depth test: a pipeline of three stages that never stops.
#[derive(Clone, Debug)]
pub struct DepthTest {
    shape: Shape,
    partial: In,
    products: In,
    result: Out,
}

impl DepthTest {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self { shape: Shape::new(config), partial: In::default(), products: In::default(), result: Out::default() }
    }
}

impl Model for DepthTest {
    type Shape = Shape;
    type In = In;
    type Out = Out;

    fn shape(&self) -> Shape {
        self.shape
    }

    fn outputs(&self) -> Out {
        self.result
    }

    fn clock(&mut self, inputs: &In) {
        self.result = test(&self.products);
        self.products = std::mem::replace(&mut self.partial, *inputs);
    }
}

impl Record<Shape> for In {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("weight", &mut self.weight);
        visitor.field("depth", &mut self.depth);
        visitor.field("depth_low", &mut self.depth_low);
        visitor.field("depth_high", &mut self.depth_high);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, _shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("fail", &mut self.fail);
        visitor.field("pass", &mut self.pass);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compares_with_the_normalized_depth() {
        let outcome = |depth| {
            let result = test(&In { weight: 3, depth, depth_low: 100, depth_high: 200 });
            (result.fail, result.pass)
        };
        assert_eq!([299, 300, 600, 601].map(outcome), [(true, false), (false, false), (false, false), (false, true)]);
        assert_eq!(test(&In { depth_low: 1, depth_high: 2, ..In::default() }), Out::default(), "an empty pixel blends");
    }

    #[test]
    fn takes_three_cycles() {
        let mut unit = DepthTest::new(&Config::default());
        let hidden = In { weight: 1, depth: 0, depth_low: 1, depth_high: 1 };
        let shown: Vec<_> = (0..5)
            .map(|cycle| {
                let out = unit.outputs();
                unit.clock(&if cycle == 0 { hidden } else { In::default() });
                out.fail
            })
            .collect();
        assert_eq!(shown, [false, false, false, true, false]);
    }
}
