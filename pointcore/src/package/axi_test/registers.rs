//! What a host tries on the registers of either core: every one of them, every access that is refused, and the counters of it.

use super::operations::{Channel, Pauses, Refusal};
use super::script::Script;
use pointcore_contract::bus::config::REGISTER_BITS;
use pointcore_contract::bus::registers::{CONTROL, INTERRUPT_ENABLE};
use pointcore_contract::bus::units::QUIET_CYCLES;
use pointcore_contract::bus::{Access, Register, RegisterKind};

/// The last word of the registers' addresses.
const LAST_WORD: u32 = 0xffc;
/// Bits of `control`.
pub const START: u32 = 1;
pub const RESET: u32 = 2;
pub const CLEAR_ERRORS: u32 = 4;
pub const ABORT: u32 = 8;
/// Bits of `status`.
pub const BUSY: u32 = 1;
pub const DONE: u32 = 2;
pub const WAITING: u32 = 8;
/// Cycles of a reset.
const RESET_CYCLES: u32 = 5;
/// A channel that all others wait for.
const LATE: u8 = 200;
/// Values with bits in all places.
const PATTERNS: [u32; 6] = [0x5555_5555, 0xaaaa_aaaa, 0x0f0f_f0f0, 0x3333_cccc, u32::MAX, 0];

/// The bits that a register holds.
fn kept(register: &Register) -> u32 {
    let bits = u32::MAX >> (REGISTER_BITS - register.width);
    match register.kind {
        RegisterKind::Setting { multiple } => bits & !(multiple - 1),
        _ => bits,
    }
}

/// What a register takes of a pattern: a multiple of what it must be one of, and above it anything.
fn sensible(register: &Register, value: u32) -> u32 {
    match register.kind {
        RegisterKind::Setting { multiple } => value & !(multiple - 1),
        RegisterKind::Range { low, high } => {
            let bits = value & kept(register);
            value ^ bits ^ (low + if high - low == u32::MAX { bits } else { bits % (high - low + 1) })
        }
        _ => value,
    }
}

/// What else a register holds than what makes sense: the bits that are not those of a multiple, and the ends of a range.
fn senseless(register: &Register) -> Vec<u32> {
    match register.kind {
        RegisterKind::Range { low, high } => {
            let all = kept(register);
            let beyond = [low.checked_sub(1), high.checked_add(1), Some(all)];
            beyond.into_iter().flatten().filter(|value| *value <= all && !(low..=high).contains(value)).collect()
        }
        _ => {
            let bits = sensible(register, u32::MAX) ^ u32::MAX;
            (0..REGISTER_BITS).map(|bit| 1 << bit).filter(|value| bits & value != 0).collect()
        }
    }
}

const fn is_control(register: &Register) -> bool {
    matches!(register.kind, RegisterKind::Control(_))
}

fn held(map: &[Register]) -> impl Iterator<Item = &Register> {
    map.iter().filter(|register| register.access() == Access::ReadWrite)
}

/// Every register is as after a reset.
pub fn check_reset(script: &mut Script, map: &[Register]) {
    script.interrupt(0);
    for register in map.iter().filter(|register| register.access() != Access::Write) {
        script.begin_read(register.address, register.reset());
    }
    script.sync();
}

/// Accesses without a run: all that are refused, and all bits of what is held.
pub fn check_accesses(script: &mut Script, map: &[Register]) {
    refuse_unknown(script, map);
    script.errors(0);
    for register in map {
        let address = register.address;
        if register.access() == Access::Read {
            script.refuse_write(address, u32::MAX, 0xf, Refusal::Access);
            // Error counters have counted by now.
            if matches!(register.kind, RegisterKind::Identity(_) | RegisterKind::Run(_)) {
                script.begin_read(address, register.reset());
            }
        } else if register.access() == Access::Write {
            script.refuse_read(address);
        }
        (1..4).for_each(|byte| script.refuse_read(address + byte));
        script.sync();
        if is_control(register) {
            continue;
        }
        (1..4).for_each(|byte| script.refuse_write(address + byte, u32::MAX, 0xf, Refusal::Access));
        (0..15).for_each(|strobes| script.refuse_write(address, u32::MAX, strobes, Refusal::Access));
        script.sync();
    }
    clear(script);
    for register in held(map) {
        for pattern in PATTERNS {
            script.write(register.address, sensible(register, pattern));
            script.read(register.address, sensible(register, pattern) & kept(register));
        }
        for value in senseless(register) {
            script.refuse(register.address, value, Refusal::Access);
        }
        script.read(register.address, sensible(register, 0));
    }
    script.errors(0);
    keep_apart(script, map);
    refuse_commands(script, map);
    // What `id` and others hold has not changed.
    script.errors(0);
    clear(script);
    script.errors(0);
}

/// Addresses between and behind the registers.
fn refuse_unknown(script: &mut Script, map: &[Register]) {
    let mut next = 0;
    for register in map {
        if register.address > next {
            script.refuse_words(next, register.address - 4);
        }
        next = register.address + 4;
    }
    script.refuse_words(next, LAST_WORD);
    script.sync();
}

/// Writes of one register do not touch the others, nor reads under way at the same time.
fn keep_apart(script: &mut Script, map: &[Register]) {
    let mut values: Vec<u32> = held(map).map(|register| sensible(register, 0)).collect();
    for _ in 0..8 {
        for (place, register) in held(map).enumerate() {
            let value = script.random.u32(..);
            script.begin_write(register.address, sensible(register, value));
            for (other, register) in held(map).enumerate().filter(|(other, _)| *other != place) {
                script.begin_read(register.address, values[other]);
            }
            script.sync();
            values[place] = sensible(register, value) & kept(register);
        }
    }
    for register in held(map) {
        script.write(register.address, sensible(register, 0));
    }
}

/// Addresses, values and answers that wait for each other stay as they are.
pub fn check_late(script: &mut Script, map: &[Register]) {
    let channels =
        [Channel::WriteAddress, Channel::WriteValue, Channel::Written, Channel::ReadAddress, Channel::ReadValue];
    for channel in channels {
        script.pauses(Pauses::None);
        script.share(channel, LATE);
        keep_apart(script, map);
    }
}

/// A run that begins right after a reset, and is ended at once: what may have been under way before is not, and the end waits for
/// the buses.
pub fn start_after_reset(script: &mut Script, map: &[Register]) {
    script.pauses(Pauses::None);
    script.begin_reset();
    let queries = map.iter().find(|register| register.kind == RegisterKind::Queries);
    queries.into_iter().for_each(|queries| script.begin_write(queries.address, 1));
    script.begin_write(CONTROL, START);
    script.reset(RESET_CYCLES);
    script.sync();
    script.write(INTERRUPT_ENABLE, 1);
    script.write(CONTROL, ABORT);
    script.wait_interrupt_after(QUIET_CYCLES);
    script.errors(DONE);
}

/// Commands that make no sense do nothing at all; others do without a run what they say.
fn refuse_commands(script: &mut Script, map: &[Register]) {
    let needs_queries = map.iter().any(|register| register.kind == RegisterKind::Queries);
    for strobes in 0..15 {
        script.refuse_write(CONTROL, CLEAR_ERRORS | START, strobes, Refusal::Access);
    }
    (1..4).for_each(|byte| script.refuse_write(CONTROL + byte, CLEAR_ERRORS | START, 0xf, Refusal::Access));
    script.sync();
    if needs_queries {
        for others in [0, RESET, CLEAR_ERRORS, ABORT, RESET | CLEAR_ERRORS | ABORT] {
            script.refuse(CONTROL, START | others, Refusal::Access);
        }
    }
    script.write(CONTROL, 0);
    // Bits that it does not have.
    script.write(CONTROL, !0xf);
    script.write(CONTROL, RESET);
    script.write(CONTROL, ABORT);
    script.wait(20);
    script.errors(0);
}

/// Clears the error counters.
pub fn clear(script: &mut Script) {
    script.write(CONTROL, CLEAR_ERRORS);
    script.cleared();
}

/// During a run, and where starts may wait while one does: all that must not be done then is refused, and counted as such.
pub fn refuse_while_busy(script: &mut Script, map: &[Register]) {
    for command in
        [START, RESET, START | RESET, START | CLEAR_ERRORS, RESET | ABORT, START | RESET | CLEAR_ERRORS | ABORT]
    {
        script.refuse(CONTROL, command, Refusal::Busy);
    }
    let locked = |register: &&Register| register.access() != Access::Read && !is_control(register);
    for register in map.iter().filter(locked).filter(|register| register.address != INTERRUPT_ENABLE) {
        // A run under way is judged before the value.
        script.refuse(register.address, u32::MAX, Refusal::Busy);
        script.refuse(register.address, 0, Refusal::Busy);
        // What the access is comes first.
        script.refuse_write(register.address, 0, 0x7, Refusal::Access);
        script.refuse_write(register.address + 2, 0, 0xf, Refusal::Access);
        script.sync();
    }
    for interrupt_enable in [0, 1] {
        script.write(INTERRUPT_ENABLE, interrupt_enable);
    }
}
