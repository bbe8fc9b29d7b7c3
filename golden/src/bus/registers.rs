//! Registers of a core as a host meets them: every access at once, in order.

use pointcore_contract::bus::registers::{ERRORS, ErrorCounter, INTERRUPT_ENABLE, RunCounter};
use pointcore_contract::bus::{Access, Register, RegisterKind, When};
use std::collections::BTreeMap;

/// The bits of a whole register.
const ALL_STROBES: u8 = 0xf;
/// Bits of `control`.
const START: u32 = 1;
const RESET: u32 = 2;
const CLEAR_ERRORS: u32 = 4;
const ABORT: u32 = 8;

/// An answer on the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Response {
    /// OKAY.
    Okay,
    /// SLVERR.
    Refused,
}

/// The registers of a core.
#[derive(Clone, Debug)]
pub struct Registers {
    map: Vec<Register>,
    /// Values of settings, by address.
    values: BTreeMap<u32, u32>,
    errors: [u32; ERRORS.len()],
    /// Counters of the run.
    counters: BTreeMap<RunCounter, u32>,
    /// A run is under way.
    pub busy: bool,
    /// A run has ended since the last start.
    pub done: bool,
    /// A start waits until its frame begins, in a core that may be started ahead.
    pub waiting: bool,
    /// Uniforms as they were written: number and value.
    pub uniforms: Vec<(u32, u32)>,
    /// Resets of the core.
    pub resets: u32,
    /// How often the end of the run was asked for.
    pub aborts: u32,
}

impl Registers {
    /// The registers after reset.
    #[must_use]
    pub fn new(map: &[Register]) -> Self {
        Self {
            map: map.to_vec(),
            values: BTreeMap::new(),
            errors: [0; ERRORS.len()],
            counters: BTreeMap::new(),
            busy: false,
            done: false,
            waiting: false,
            uniforms: vec![],
            resets: 0,
            aborts: 0,
        }
    }

    /// Something elsewhere went wrong.
    pub fn error(&mut self, error: ErrorCounter) {
        let count = &mut self.errors[error as usize];
        *count = count.saturating_add(1);
    }

    /// Something happened in the run, so many times; nothing counts outside of one.
    pub fn event(&mut self, counter: RunCounter, times: u32) {
        if self.busy {
            let count = self.counters.entry(counter).or_default();
            *count = count.saturating_add(times);
        }
    }

    /// The frame of the start that waited has begun.
    pub const fn begin(&mut self) {
        self.waiting = false;
    }

    /// The run ended, and with it whatever waits.
    pub const fn finish(&mut self) {
        self.done |= self.busy;
        (self.busy, self.waiting) = (false, false);
    }

    /// A setting's value by its address.
    #[must_use]
    pub fn setting(&self, address: u32) -> u32 {
        let reset = || self.register(address).map_or(0, |register| register.reset());
        self.values.get(&address).copied().unwrap_or_else(reset)
    }

    /// `irq`.
    #[must_use]
    pub fn interrupt(&self) -> bool {
        self.done && self.setting(INTERRUPT_ENABLE) == 1
    }

    fn register(&self, address: u32) -> Option<Register> {
        self.map.iter().find(|register| register.address == address).cloned()
    }

    /// A write; `occupied` while a burst to the tree is under way.
    pub fn write(&mut self, address: u32, data: u32, strobes: u8, occupied: bool) -> Response {
        let register = self.register(address).filter(|register| register.access() != Access::Read);
        let Some(register) = register.filter(|_| strobes == ALL_STROBES) else {
            return self.refuse(ErrorCounter::Access);
        };
        let is_control = matches!(register.kind, RegisterKind::Control(_));
        let (starts, resets) = (is_control && data & START != 0, is_control && data & RESET != 0);
        let is_free = match register.when() {
            When::Always => true,
            When::Ahead => !self.waiting,
            When::Idle => !self.busy,
        };
        let needs_it = !is_control || starts;
        if (needs_it && !is_free) || (resets && self.busy) || (starts && occupied) {
            return self.refuse(ErrorCounter::Busy);
        }
        let value = data & (u32::MAX >> (32 - register.width));
        match register.kind {
            RegisterKind::Control(when) => {
                if starts && self.lacks_queries() {
                    return self.refuse(ErrorCounter::Access);
                }
                self.command(data, when);
            }
            RegisterKind::Setting { multiple } if !value.is_multiple_of(multiple) => {
                return self.refuse(ErrorCounter::Access);
            }
            RegisterKind::Range { low, high } if !(low..=high).contains(&value) => {
                return self.refuse(ErrorCounter::Access);
            }
            RegisterKind::Uniform => {
                let first =
                    self.map.iter().find(|other| other.kind == RegisterKind::Uniform).map_or(0, |first| first.address);
                self.uniforms.push(((address - first) / 4, value));
            }
            _ => _ = self.values.insert(address, value),
        }
        Response::Okay
    }

    fn command(&mut self, data: u32, starts: When) {
        if data & START != 0 {
            self.waiting = starts == When::Ahead;
            if !self.busy {
                self.done = false;
                self.counters.clear();
            }
            self.busy = true;
        }
        self.resets += u32::from(data & RESET != 0);
        self.aborts += u32::from(data & ABORT != 0);
        if data & CLEAR_ERRORS != 0 {
            self.errors = [0; ERRORS.len()];
        }
    }

    fn lacks_queries(&self) -> bool {
        self.map.iter().any(|register| register.kind == RegisterKind::Queries && self.setting(register.address) == 0)
    }

    fn refuse(&mut self, error: ErrorCounter) -> Response {
        self.error(error);
        Response::Refused
    }

    /// A read.
    pub fn read(&mut self, address: u32) -> (u32, Response) {
        let Some(register) = self.register(address).filter(|register| register.access() != Access::Write) else {
            return (0, self.refuse(ErrorCounter::Access));
        };
        let value = match register.kind {
            RegisterKind::Identity(value) => value,
            RegisterKind::Status(_) => {
                let error = self.errors.iter().any(|count| *count > 0);
                let bits = [self.busy, self.done, error, self.waiting];
                bits.iter().rev().fold(0, |status, bit| status << 1 | u32::from(*bit))
            }
            RegisterKind::Errors(error) => self.errors[error as usize],
            RegisterKind::Run(counter) => self.counters.get(&counter).copied().unwrap_or(0),
            _ => self.setting(address),
        };
        (value, Response::Okay)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::bus::registers::{CONTROL, RegisterMap, SETTINGS, STATUS, SearchRegisters};
    use pointcore_contract::search::Config;

    #[test]
    fn what_is_refused_changes_nothing_and_counts_once() {
        let mut unit = Registers::new(&SearchRegisters::registers(&Config::default()));
        let queries = SETTINGS + 8;
        assert_eq!(unit.write(CONTROL, START, 0xf, false), Response::Refused, "no queries");
        assert_eq!(unit.write(queries, 3, 0xf, false), Response::Okay);
        assert_eq!(unit.write(SETTINGS, 0x800, 0xf, false), Response::Refused, "a base between borders");
        assert_eq!(unit.write(CONTROL, START | CLEAR_ERRORS, 0xf, true), Response::Refused, "the tree is written");
        assert_eq!(unit.write(CONTROL, START, 0xf, false), Response::Okay);
        assert_eq!(unit.write(queries, 4, 0xf, false), Response::Refused, "a run is under way");
        assert_eq!(unit.read(queries), (3, Response::Okay));
        assert_eq!(unit.read(2), (0, Response::Refused));
        assert_eq!([0x10, 0x14].map(|address| unit.read(address).0), [3, 2]);
        assert_eq!(unit.read(STATUS).0, 0b101);
        assert_eq!(unit.write(CONTROL, CLEAR_ERRORS, 0xf, false), Response::Okay);
        unit.finish();
        assert_eq!(unit.read(STATUS).0, 0b010);
    }
}
