//! Pipeline registers at marked cuts.

use super::delay;
use rtl::{Expr, Module};
use std::rc::Rc;

/// A pipelined operator.
#[derive(Clone)]
pub struct Operator {
    /// Ports `enable`, `a`, `b`, `c` as far as it has them, and `y`.
    pub module: Rc<Module>,
    /// Enabled cycles from operands to result.
    pub latency: u32,
}

/// A module under description whose logic is a chain with marked cuts, some of which become registers.
///
/// The delays of all segments are given beforehand, so the requested registers can be placed where the slowest stage
/// comes out fastest. Every segment ends at a cut, the last one at the output, which is always a register.
pub struct Pipe {
    /// The module, for anything beside cuts.
    pub module: Module,
    enable: Expr,
    registered: Vec<bool>,
    cuts_passed: usize,
}

/// A value on its way down a [`Pipe`], registered as far as it is followed.
pub struct Carried {
    name: String,
    value: Expr,
    cuts_passed: usize,
}

impl Pipe {
    /// A module with port `enable` and a register at `stages` of the cuts that end the segments of those `delays`; at
    /// least at the last one, at most at all.
    ///
    /// # Panics
    /// If `delays` is empty.
    #[must_use]
    #[track_caller]
    pub fn new(unit: &str, summary: &str, delays: &[u32], stages: u32) -> Self {
        assert!(!delays.is_empty(), "a pipe has at least the output's cut");
        let mut module = Module::new(unit, summary);
        let registered = place(delays, stages as usize);
        module.variant("stages", count(&registered));
        let enable = module.input("enable", 1);
        Self { module, enable, registered, cuts_passed: 0 }
    }

    /// Ends the current segment and takes these values into the next.
    #[track_caller]
    pub fn cut<const N: usize>(&mut self, values: [(&str, Expr); N]) -> [Expr; N] {
        let mut carried = values.map(|(name, value)| self.carry(name, value));
        self.cuts_passed += 1;
        carried.each_mut().map(|value| self.arrive(value))
    }

    /// A value of the current segment for use in later ones.
    #[must_use]
    #[track_caller]
    pub fn carry(&self, name: &str, value: Expr) -> Carried {
        Carried { name: name.into(), value, cuts_passed: self.cuts_passed }
    }

    /// A carried value in the current segment.
    #[track_caller]
    pub fn arrive(&mut self, carried: &mut Carried) -> Expr {
        for cut in carried.cuts_passed..self.cuts_passed {
            if self.registered[cut] && carried.value.literal_value().is_none() {
                let stage = count(&self.registered[..=cut]);
                let register = self.module.reg(&format!("{}_s{stage}", carried.name), carried.value.width());
                self.module.next_if(register, self.enable, carried.value);
                carried.value = register.expr();
            }
        }
        carried.cuts_passed = self.cuts_passed;
        carried.value
    }

    /// Registers the result and drives port `y` with it.
    ///
    /// # Panics
    /// If the description has not as many segments as there are delays.
    #[must_use]
    #[track_caller]
    pub fn finish(mut self, result: Expr) -> Operator {
        assert_eq!(self.cuts_passed + 1, self.registered.len(), "segments and delays of {} differ", self.module.unit());
        let y = self.module.reg("y", result.width());
        self.module.next_if(y, self.enable, result);
        self.module.output("y", y);
        Operator { module: Rc::new(self.module), latency: count(&self.registered) as u32 }
    }
}

fn count(registered: &[bool]) -> usize {
    registered.iter().filter(|&&registered| registered).count()
}

/// The fewest stages that keep every stage within [`delay::STAGE`], as far as single segments do.
#[must_use]
pub(crate) fn stages_for(delays: &[u32]) -> u32 {
    count(&fill(delays, delay::STAGE)) as u32
}

/// Which cuts become registers so that the longest stage is as short as it can be.
fn place(delays: &[u32], stages: usize) -> Vec<bool> {
    let wanted = stages.clamp(1, delays.len());
    let total: u32 = delays.iter().sum();
    let slowest = delays.iter().copied().max().unwrap_or(0);
    let mut registered = (slowest..=total)
        .map(|budget| fill(delays, budget))
        .find(|registered| count(registered) <= wanted)
        .expect("the budget that takes everything needs one stage");
    let spare = wanted - count(&registered);
    for cut in registered.iter_mut().filter(|registered| !**registered).take(spare) {
        *cut = true;
    }
    registered
}

/// Fills stage after stage up to `budget`; a longer segment has a stage of its own.
fn fill(delays: &[u32], budget: u32) -> Vec<bool> {
    let mut registered = vec![false; delays.len()];
    let mut stage = 0;
    for (segment, &delay) in delays.iter().enumerate() {
        if stage > 0 && stage + delay > budget {
            registered[segment - 1] = true;
            stage = 0;
        }
        stage += delay;
    }
    registered[delays.len() - 1] = true;
    registered
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn registers_balance_the_stages() {
        assert_eq!(place(&[3, 3, 3, 3], 2), [false, true, false, true]);
        assert_eq!(place(&[1, 9, 1, 1], 2), [false, true, false, true]);
        assert_eq!(place(&[9, 1, 1, 1], 2), [true, false, false, true]);
    }

    #[test]
    fn stages_are_clamped_and_all_used() {
        let delays = [5, 1, 1, 1];
        for (asked, got) in [(0, 1), (1, 1), (2, 2), (3, 3), (4, 4), (9, 4)] {
            let registered = place(&delays, asked);
            assert_eq!(count(&registered), got);
            assert!(registered[3]);
        }
    }

    #[test]
    fn default_keeps_to_the_budget() {
        assert_eq!(stages_for(&[delay::STAGE, delay::STAGE]), 2);
        assert_eq!(stages_for(&[delay::STAGE / 2, delay::STAGE / 2]), 1);
        assert_eq!(stages_for(&[2 * delay::STAGE, 1]), 2);
    }
}
