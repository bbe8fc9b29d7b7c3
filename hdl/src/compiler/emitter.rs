//! The module under construction and what all its parts share.
//!
//! Everything steps in every cycle. With an initiation interval above one, a register that holds a token's value for that
//! long loads in one [phase](super::phases).

use super::phases::{Counter, LOADS, Phases};
use rtl::{Expr, Module, bit, cat};
use std::collections::HashSet;

/// A module with its phases.
pub(super) struct Emitter {
    pub module: Module,
    initiation_interval: u32,
    phases: Phases,
    names: HashSet<String>,
    register_bits: u64,
}

impl Emitter {
    /// For a module that has the signals `names` already.
    pub fn new(module: Module, initiation_interval: u32, names: HashSet<String>) -> Self {
        Self { module, initiation_interval, phases: Phases::new(initiation_interval), names, register_bits: 0 }
    }

    pub const fn initiation_interval(&self) -> u32 {
        self.initiation_interval
    }

    /// The phase in which something happens in that cycle of a token.
    pub const fn phase_of(&self, cycle: u32) -> u32 {
        cycle % self.initiation_interval
    }

    /// It is that phase, for no more than [`LOADS`].
    pub fn in_phase(&mut self, phase: u32, loads: u32) -> Expr {
        if self.initiation_interval == 1 { bit(true) } else { self.phases.bit(&mut self.module, phase, loads) }
    }

    /// The phase's source for each operator: as many as its choices take.
    pub fn chooser(&self, operator: String) -> Chooser {
        Chooser { name: format!("{operator}_phase"), counter: None }
    }

    /// A register that loads in one phase.
    pub fn register(&mut self, name: &str, phase: u32, data: Expr) -> Expr {
        let enable = self.in_phase(phase, data.width());
        let name = self.unique(name);
        let register = self.module.reg(&name, data.width());
        self.module.next_if(register, enable, data);
        self.count_registers(data.width());
        register.expr()
    }

    /// A register that loads in every cycle.
    pub fn step(&mut self, name: &str, data: Expr) -> Expr {
        let name = self.unique(name);
        let register = self.module.reg(&name, data.width());
        self.module.next(register, data);
        self.count_registers(data.width());
        register.expr()
    }

    /// A bit after so many registers, which load in phase 0 and are cleared by reset.
    pub fn shift_register(&mut self, name: &str, stages: u32, data: Expr) -> Expr {
        let mut data = data;
        for first in (0..stages).step_by(LOADS as usize) {
            let part = LOADS.min(stages - first);
            let enable = self.in_phase(0, part);
            let name = self.unique(name);
            let register = self.module.reg_reset(&name, part, 0);
            let next = if part == 1 { data } else { cat([register.trunc(part - 1), data]) };
            self.module.next_if(register, enable, next);
            self.count_registers(part);
            data = register.msb();
        }
        data
    }

    /// Adds to the manifest's count.
    pub fn count_registers(&mut self, bits: u32) {
        self.register_bits += bits as u64;
    }

    /// The module, once all is in it, and how many flip-flops were counted.
    pub fn finish(mut self) -> (Module, u64) {
        let phases = self.phases.finish(&mut self.module);
        (self.module, self.register_bits + u64::from(phases))
    }

    /// A name that nothing else in the module has, close to the one wanted.
    pub fn unique(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut copy = 1;
        while !self.names.insert(name.clone()) {
            copy += 1;
            name = format!("{wanted}_copy{copy}");
        }
        name
    }
}

/// What chooses an operator's operands.
pub(super) struct Chooser {
    name: String,
    counter: Option<Counter>,
}

impl Chooser {
    /// Of the sources by phase the one of the current phase; in phases without one, whichever takes no choice. Wide ones are cut, so
    /// that no counter has more than its share of the choices.
    pub fn choose(&mut self, emitter: &mut Emitter, sources: &[Option<Expr>]) -> Expr {
        let operations: Vec<Expr> = sources.iter().flatten().copied().collect();
        if let [only] = operations[..] {
            return only;
        }
        let width = operations[0].width();
        // A bit is chosen among so many by half as many choices between two of the lowest bit of the phase.
        let choices = (operations.len() as u32).div_ceil(2);
        let part = (LOADS / choices).clamp(1, width);
        let parts = (0..width).step_by(part as usize).map(|low| (low, (low + part).min(width) - 1));
        let chosen: Vec<Expr> = parts
            .map(|(low, high)| {
                let phase = self.phase(emitter, (high + 1 - low) * choices);
                phase.pick_some(sources.iter().map(|source| source.map(|source| source.bits(high, low))))
            })
            .collect();
        cat(chosen.into_iter().rev())
    }

    fn phase(&mut self, emitter: &mut Emitter, loads: u32) -> Expr {
        if let Some(phase) = self.counter.as_mut().and_then(|counter| counter.drive(loads)) {
            return phase;
        }
        let name = emitter.unique(&self.name);
        let mut counter = emitter.phases.counter(&mut emitter.module, &name);
        let phase = counter.drive(loads).expect("a new counter has room for a part");
        self.counter = Some(counter);
        phase
    }
}
