//! The ternary depth test against the normalized stored depth, cross-multiplied instead of divided (eq. 5.8, 5.9); golden
//! twin: `pointcore_golden::core_a::depth_test`.

use pointcore_spec::core_a::config::{Config, DEPTH_BITS, DEPTH_SUM_BITS, WEIGHT_SUM_BITS};

use crate::rtl::{Expr, Module};

/// Cycles from inputs to outputs.
pub(super) const LATENCY: u32 = 2;

/// The unit; ports as in `spec::core_a::ports::depth_test`.
#[must_use]
pub fn module(_config: &Config) -> Module {
    let mut m = Module::new("core_a_depth_test", "Compares a pixel's normalized depth with a splat's depth band.");
    let weight = m.input("weight", WEIGHT_SUM_BITS as usize);
    let depth = m.input("depth", DEPTH_SUM_BITS as usize);
    let low = m.input("depth_low", DEPTH_BITS as usize);
    let high = m.input("depth_high", DEPTH_BITS as usize);

    let mut delayed = |name: &str, value: Expr| {
        let register = m.reg(name, value.width());
        m.next(&register, &value);
        register
    };
    let stored = delayed("stored", depth);
    let low_bound = delayed("low_bound", &low * &weight);
    let high_bound = delayed("high_bound", &high * &weight);
    let fail = delayed("fail", stored.lt(&low_bound));
    let pass = delayed("pass", stored.gt(&high_bound));
    m.output("fail", &fail);
    m.output("pass", &pass);
    m
}
