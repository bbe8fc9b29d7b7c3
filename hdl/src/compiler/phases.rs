//! Which phase it is, where an initiation interval is above one. Registers all over a device load in one phase each, and operands are
//! chosen by it; but a wire's delay grows with what hangs on it. As nothing but the clock is needed to count phases, they are counted
//! in many places, each for its share of the loads: by rings, a bit a phase, for what loads, by counters for what is chosen. Synthesis
//! merges none of them, for each follows from itself alone.

use rtl::{Expr, Module, address_width, bit, cat};

/// Flip-flops, or choices between two bits, that one register enables or decides.
pub(super) const LOADS: u32 = 128;

/// A bit goes round in it.
struct Ring {
    register: Expr,
    /// Of each of its bits.
    loads: Vec<u32>,
}

/// What tells the phase.
pub(super) struct Phases {
    interval: u32,
    rings: Vec<Ring>,
    /// All go with the first ring.
    in_step: Expr,
    register_bits: u32,
}

impl Phases {
    /// Of an interval above one.
    pub fn new(interval: u32) -> Self {
        Self { interval, rings: Vec::new(), in_step: bit(true), register_bits: 0 }
    }

    /// It is that phase: a bit with room for so many loads, no more than [`LOADS`].
    pub fn bit(&mut self, module: &mut Module, phase: u32, loads: u32) -> Expr {
        assert!(loads <= LOADS, "{loads} loads of one bit");
        let has_room = |ring: &Ring| ring.loads[phase as usize] + loads <= LOADS;
        let found = self.rings.iter().position(has_room);
        let place = found.unwrap_or_else(|| self.ring(module));
        let ring = &mut self.rings[place];
        ring.loads[phase as usize] += loads;
        ring.register.bit(phase)
    }

    /// A counter of that name.
    pub fn counter(&mut self, module: &mut Module, name: &str) -> Counter {
        let width = address_width(self.interval);
        let phase = module.reg_reset(name, width, 0);
        let last = u128::from(self.interval - 1);
        module.next(phase, phase.eq_lit(last).mux(phase.sub_lit(last), phase.add_lit(1)));
        self.register_bits += width;
        let is_first = self.bit(module, 0, 0);
        self.in_step = self.in_step & phase.is_zero().eq(is_first);
        Counter { phase: phase.expr(), loads: 0 }
    }

    /// Has them checked, once all are there; returns how many flip-flops they have.
    pub fn finish(self, module: &mut Module) -> u32 {
        if self.in_step.literal_value().is_none() {
            module.assert("phases_are_in_step", self.in_step);
        }
        self.register_bits
    }

    /// Adds a ring; returns its place among them.
    fn ring(&mut self, module: &mut Module) -> usize {
        let name = format!("phases_{}", self.rings.len() + 1);
        let register = module.reg_reset(&name, self.interval, 1);
        module.next(register, cat([register.trunc(self.interval - 1), register.msb()]));
        self.register_bits += self.interval;
        if let Some(first) = self.rings.first() {
            self.in_step = self.in_step & register.eq(first.register);
        }
        self.rings.push(Ring { register: register.expr(), loads: vec![0; self.interval as usize] });
        self.rings.len() - 1
    }
}

/// A counter of phases for what is chosen by it.
pub(super) struct Counter {
    phase: Expr,
    loads: u32,
}

impl Counter {
    /// The phase, if there is room for so many loads more.
    pub fn drive(&mut self, loads: u32) -> Option<Expr> {
        (self.loads + loads <= LOADS).then(|| {
            self.loads += loads;
            self.phase
        })
    }
}
