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
/// The description says what each step [takes](Pipe::takes). It is followed twice: first without registers, to learn how long
/// the segments between the cuts are; then with the registers where the slowest stage comes out fastest. Every segment ends
/// at a cut, the last one at the output, which is always a register.
pub struct Pipe {
    /// The module, for anything beside cuts.
    pub module: Module,
    enable: Expr,
    /// Which cuts are registers; none while the segments are measured.
    registered: Vec<bool>,
    /// Delays of the segments so far, the current one's last.
    segments: Vec<u32>,
}

/// The operator of that description with a register at `stages` of its cuts; at least at the output, at most at all.
#[must_use]
#[track_caller]
pub(crate) fn operator(unit: &str, summary: &str, stages: u32, describe: impl Fn(&mut Pipe) -> Expr) -> Operator {
    let registered = place(&segments(&describe), stages as usize);
    let mut pipe = Pipe::new(unit, summary, registered);
    let result = describe(&mut pipe);
    pipe.finish(result)
}

/// The fewest stages that keep every stage of that description within [`delay::STAGE`], as far as single segments do.
#[must_use]
pub(crate) fn stages_for(describe: impl Fn(&mut Pipe) -> Expr) -> u32 {
    count(&fill(&segments(describe), delay::STAGE)) as u32
}

/// The cuts of that description, the output's included: the most stages it can have.
#[must_use]
pub(crate) fn cuts(describe: impl Fn(&mut Pipe) -> Expr) -> u32 {
    segments(describe).len() as u32
}

/// Delays of a description's segments.
fn segments(describe: impl Fn(&mut Pipe) -> Expr) -> Vec<u32> {
    let mut pipe = Pipe::new("measured", "A description without registers.", vec![]);
    describe(&mut pipe);
    pipe.segments
}

/// A value on its way down a [`Pipe`], registered as far as it is followed.
pub struct Carried {
    name: String,
    value: Expr,
    cuts_passed: usize,
}

impl Pipe {
    /// A module with port `enable`.
    #[track_caller]
    fn new(unit: &str, summary: &str, registered: Vec<bool>) -> Self {
        let mut module = Module::new(unit, summary);
        module.variant("stages", count(&registered));
        let enable = module.input("enable", 1);
        Self { module, enable, registered, segments: vec![0] }
    }

    /// What is described next takes that long, behind what the current segment has had before.
    pub fn takes(&mut self, delay: u32) {
        *self.segments.last_mut().expect("a pipe begins with a segment") += delay;
    }

    /// [`takes`](Self::takes) the longest of the paths that lie side by side.
    pub fn takes_longest<const N: usize>(&mut self, paths: [u32; N]) {
        self.takes(paths.into_iter().max().unwrap_or(0));
    }

    fn cuts_passed(&self) -> usize {
        self.segments.len() - 1
    }

    /// Ends the current segment and takes these values into the next.
    #[track_caller]
    pub fn cut<const N: usize>(&mut self, values: [(&str, Expr); N]) -> [Expr; N] {
        let mut carried = values.map(|(name, value)| self.carry(name, value));
        self.segments.push(0);
        carried.each_mut().map(|value| self.arrive(value))
    }

    /// A value of the current segment for use in later ones.
    #[must_use]
    #[track_caller]
    pub fn carry(&self, name: &str, value: Expr) -> Carried {
        Carried { name: name.into(), value, cuts_passed: self.cuts_passed() }
    }

    /// A carried value in the current segment.
    #[track_caller]
    pub fn arrive(&mut self, carried: &mut Carried) -> Expr {
        for cut in carried.cuts_passed..self.cuts_passed() {
            if self.registered.get(cut) == Some(&true) && carried.value.literal_value().is_none() {
                let stage = count(&self.registered[..=cut]);
                let register = self.module.reg(&format!("{}_s{stage}", carried.name), carried.value.width());
                self.module.next_if(register, self.enable, carried.value);
                carried.value = register.expr();
            }
        }
        carried.cuts_passed = self.cuts_passed();
        carried.value
    }

    /// Registers the result and drives port `y` with it.
    #[track_caller]
    fn finish(mut self, result: Expr) -> Operator {
        let y = self.module.reg("y", result.width());
        self.module.next_if(y, self.enable, result);
        self.module.output("y", y);
        Operator { module: Rc::new(self.module), latency: count(&self.registered) as u32 }
    }
}

fn count(registered: &[bool]) -> usize {
    registered.iter().filter(|&&registered| registered).count()
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

    /// The segments of those delays, a register of one bit wherever a cut becomes one.
    fn chain(pipe: &mut Pipe, delays: &[u32]) -> Expr {
        let mut value = pipe.module.input("a", 1);
        for (segment, &delay) in delays.iter().enumerate() {
            if segment > 0 {
                [value] = pipe.cut([("value", value)]);
            }
            pipe.takes(delay);
        }
        value
    }

    #[test]
    fn default_keeps_to_the_budget() {
        let stages = |delays: &[u32]| stages_for(|pipe| chain(pipe, delays));
        assert_eq!(stages(&[delay::STAGE, delay::STAGE]), 2);
        assert_eq!(stages(&[delay::STAGE / 2, delay::STAGE / 2]), 1);
        assert_eq!(stages(&[2 * delay::STAGE, 1]), 2);
    }

    #[test]
    fn segments_are_what_the_description_takes() {
        let found = segments(|pipe| {
            let a = pipe.module.input("a", 1);
            pipe.takes(3);
            pipe.takes_longest([4, 9]);
            let [a] = pipe.cut([("a", a)]);
            pipe.cut([]);
            pipe.takes(5);
            a
        });
        assert_eq!(found, [12, 0, 5]);
        assert_eq!(operator("chain", "A chain.", 2, |pipe| chain(pipe, &[9, 1, 1])).latency, 2);
    }
}
