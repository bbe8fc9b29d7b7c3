//! Ternary depth test: is a sample hidden by what its pixel holds, does it hide it, or do both blend (eq. 5.8)?
//!
//! The stored depth is a weighted sum; instead of dividing it by the stored weight, the limits of the sample's ε-band are
//! multiplied by it, in exact integers. Equality with a limit blends, and so does an empty pixel, onto zeros.

use crate::unit::Model;
use pointcore_contract::splat::Config;
pub use pointcore_contract::splat::units::depth_test::{In, Out};

/// The result of the test.
#[must_use]
pub fn test(inputs: &In) -> Out {
    let limit = |depth: u32| u64::from(depth) * u64::from(inputs.weight);
    Out { fail: inputs.depth < limit(inputs.depth_low), pass: inputs.depth > limit(inputs.depth_high) }
}

/// The depth test: a pipeline of three stages that never stops.
#[derive(Clone, Debug, Default)]
pub struct DepthTest {
    partial: In,
    products: In,
    result: Out,
}

impl Model for DepthTest {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        self.result
    }

    fn clock(&mut self, inputs: &In) {
        self.result = test(&self.products);
        self.products = std::mem::replace(&mut self.partial, *inputs);
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
        let mut unit = DepthTest::default();
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
