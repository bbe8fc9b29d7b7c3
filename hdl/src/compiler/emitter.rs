//! The module under construction and what all its parts share.
//!
//! Everything steps with `advance`, which is high while the output queue has room; `phase` counts the steps modulo the
//! initiation interval. Thousands of registers load in one phase each, so what enables them comes from a register as well and is found
//! in the cycle before.

use rtl::{Expr, Module, Wire, address_width, cat};
use std::collections::HashSet;

/// A module with its pipeline control.
pub(super) struct Emitter {
    pub module: Module,
    initiation_interval: u32,
    advance: Expr,
    phase: Option<Expr>,
    advance_next: Option<Wire>,
    loads: Vec<Expr>,
    names: HashSet<String>,
    register_bits: u64,
}

impl Emitter {
    /// Adds phase counter and enables to a module that has the signals `names` already.
    pub fn new(module: Module, initiation_interval: u32, advance: Expr, names: HashSet<String>) -> Self {
        let mut emitter = Self {
            module,
            initiation_interval,
            advance,
            phase: None,
            advance_next: None,
            loads: vec![advance],
            names,
            register_bits: 0,
        };
        if initiation_interval > 1 {
            emitter.count_phases();
        }
        emitter
    }

    fn count_phases(&mut self) {
        let Self { ref mut module, initiation_interval, advance, .. } = *self;
        let phase = module.reg_reset("phase", address_width(initiation_interval), 0);
        let last = u128::from(initiation_interval - 1);
        let following = phase.eq_lit(last).mux(phase.sub_lit(last), phase.add_lit(1));
        let phase_next = module.wire("phase_next", advance.mux(following, phase));
        module.next(phase, phase_next);
        let advance_next = module.forward("advance_next", 1);
        let load = |index: u32| {
            let name = format!("load_{index}");
            let load = module.reg_reset(&name, 1, u128::from(index == 0));
            module.next(load, advance_next & phase_next.eq_lit(index.into()));
            module.assert(&format!("{name}_in_phase"), load.eq(advance & phase.eq_lit(index.into())));
            load.expr()
        };
        self.loads = (0..initiation_interval).map(load).collect();
        self.names.extend(["phase", "phase_next", "advance_next"].map(str::to_owned));
        self.names.extend((0..initiation_interval).map(|index| format!("load_{index}")));
        self.register_bits += phase.width() as u64 + u64::from(initiation_interval);
        self.phase = Some(phase.expr());
        self.advance_next = Some(advance_next);
    }

    pub const fn initiation_interval(&self) -> u32 {
        self.initiation_interval
    }

    /// The phase in which something happens in that cycle of a token.
    pub const fn phase_of(&self, cycle: u32) -> u32 {
        cycle % self.initiation_interval
    }

    /// The pipeline steps.
    pub const fn advance(&self) -> Expr {
        self.advance
    }

    /// To be driven, once, if there is a phase counter: the pipeline steps in the next cycle.
    pub const fn advance_next(&self) -> Option<Wire> {
        self.advance_next
    }

    /// The phase counter; there is none when there is only one phase.
    pub const fn phase(&self) -> Option<Expr> {
        self.phase
    }

    /// The pipeline steps, in that phase.
    pub fn load(&self, phase: u32) -> Expr {
        self.loads[phase as usize]
    }

    /// The pipeline is in that phase.
    pub fn in_phase(&self, phase: u32) -> Option<Expr> {
        self.phase.as_ref().map(|counter| counter.eq_lit(phase.into()))
    }

    /// A register that loads in one phase.
    pub fn register(&mut self, name: &str, phase: u32, data: Expr) -> Expr {
        let enable = self.load(phase);
        self.register_if(name, enable, data)
    }

    /// A register with an enable of its own.
    pub fn register_if(&mut self, name: &str, enable: Expr, data: Expr) -> Expr {
        let name = self.unique(name);
        let register = self.module.reg(&name, data.width());
        self.module.next_if(register, enable, data);
        self.count_registers(data.width());
        register.expr()
    }

    /// A bit after so many registers, which load in phase 0 and are cleared by reset.
    pub fn shift_register(&mut self, name: &str, stages: u32, data: Expr) -> Expr {
        if stages == 0 {
            return data;
        }
        let name = self.unique(name);
        let register = self.module.reg_reset(&name, stages, 0);
        let next = if stages == 1 { data } else { cat([register.trunc(stages - 1), data]) };
        self.module.next_if(register, self.loads[0], next);
        self.count_registers(stages);
        register.msb()
    }

    /// Adds to the manifest's count.
    pub fn count_registers(&mut self, bits: u32) {
        self.register_bits += bits as u64;
    }

    /// Flip-flops so far.
    pub const fn register_bits(&self) -> u64 {
        self.register_bits
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
