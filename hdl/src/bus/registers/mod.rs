//! AXI4-Lite slave with the registers of a core (`docs/interfaces.md`); golden twin: `pointcore_golden::bus::registers`.
//!
//! Address and data of a write wait for each other in registers and are judged together; every effect shows a cycle later.

mod counters;

use pointcore_contract::bus::axi::{RegisterAnswer, RegisterBus, RegisterValue};
use pointcore_contract::bus::config::REGISTER_ADDRESS_BITS;
use pointcore_contract::bus::registers::{ERRORS, ErrorSources, RegisterMap, RegisterWrite, UniformBits};
use pointcore_contract::bus::units::registers::Ports;
use pointcore_contract::bus::{Access, Register, RegisterKind, When};
use pointcore_contract::unit::PulseOut;

use super::{OKAY, REGISTER_BITS, REGISTER_BYTES, SLAVE_ERROR};
use crate::units::ports::{ChannelInPorts, ChannelOutPorts, InputPorts, OutputPorts, PulseOutPorts, WordPort};
use crate::units::wires::Bundle;
use counters::{Counter, counters};
use rtl::{Expr, Module, Reg, Wire, address_width, bit, cat, lit};

/// Bits of a byte's place in its register.
const BYTE_BITS: u32 = REGISTER_BYTES.ilog2();
const BYTE_ADDRESS_BITS: u32 = REGISTER_ADDRESS_BITS;
/// Bits of a register's number.
const WORD_BITS: u32 = BYTE_ADDRESS_BITS - BYTE_BITS;
/// Bits of a counter's number among the registers at least: most maps have their counters in the first 128 bytes.
const COUNTER_WORD_BITS: u32 = 5;

/// A register that holds what is written.
struct Stored<'a> {
    register: &'a Register,
    bits: Reg,
}

impl<'a> Stored<'a> {
    fn new(m: &mut Module, register: &'a Register) -> Self {
        let kept = register.width - zero_bits(register);
        Self { register, bits: m.reg_reset(&format!("{}_bits", register.name), kept, register.reset().into()) }
    }

    /// The register's value, with the bits that are always zero.
    fn value(&self) -> Expr {
        match zero_bits(self.register) {
            0 => self.bits.expr(),
            zeros => cat([*self.bits, lit(zeros, 0)]),
        }
    }
}

/// Low bits that are zero in every value of a register.
fn zero_bits(register: &Register) -> u32 {
    match register.kind {
        RegisterKind::Setting { multiple } => multiple.ilog2(),
        _ => 0,
    }
}

/// Whether one of several conditions holds.
fn any(conditions: &[Expr]) -> Expr {
    conditions.iter().fold(bit(false), |any, condition| any | *condition)
}

/// Whether a register is one of the counters.
const fn is_counter(register: &Register) -> bool {
    matches!(register.kind, RegisterKind::Errors(_) | RegisterKind::Run(_))
}

/// Whether a register takes commands.
const fn is_control(register: &Register) -> bool {
    matches!(register.kind, RegisterKind::Control(_))
}

/// A register's number.
fn word_of(register: &Register) -> u128 {
    (register.address >> BYTE_BITS).into()
}

/// The number of the register that holds a byte.
fn word_in(address: Expr) -> Expr {
    address.bits(BYTE_ADDRESS_BITS - 1, BYTE_BITS)
}

/// The unit for a map; ports as in `contract::bus::units::registers`.
#[must_use]
pub fn module<M: RegisterMap>(config: &M::Config, sources: ErrorSources) -> Module {
    let ports = Ports::<M>::ALL;
    let map = &M::registers(config);
    let mut m = Module::new("bus_registers", "Registers of a core.");
    m.parameter("registers", map.len());
    let write = Write::new(&mut m, ports.host);
    let finished = ports.finished.declare_word(&mut m, 1);
    let occupied = ports.occupied.declare_word(&mut m, 1);
    let busy = m.reg_reset("busy", 1, 0);
    let is_stored = |register: &&Register| register.access() == Access::ReadWrite;
    let stored: Vec<Stored> = map.iter().filter(is_stored).map(|register| Stored::new(&mut m, register)).collect();
    let waiting = (M::STARTS == When::Ahead).then(|| m.reg_reset("waiting", 1, 0));
    let state = State { busy: *busy, waiting: waiting.map_or(bit(false), |waiting| *waiting), occupied };
    let [refused_access, refused_busy] = write.judge(&mut m, map, &stored, state);
    for Stored { register, bits } in &stored {
        let value = write.data.bits(register.width - 1, zero_bits(register));
        m.next_if(*bits, write.accepted & write.chooses(register), value);
    }
    let control = map.iter().find(|register| is_control(register)).expect("every map has `control`");
    let commands = m.wire("commands", write.accepted & write.chooses(control));
    let pulses = ["start", "core_reset", "clear_errors", "aborts"].map(|name| m.reg_reset(name, 1, 0));
    for (number, pulse) in (0..).zip(pulses) {
        m.next(pulse, commands & write.data.bit(number));
    }
    let [start, core_reset, clear_errors, aborts] = pulses;
    let starts = m.wire("starts", commands & write.data.bit(0));
    m.next(busy, starts | (busy & !finished));
    // A start ahead goes on with the run, and with what it counts.
    let begins_run = waiting.map_or(start.expr(), |waiting| {
        let begun = ports.begun.declare_word(&mut m, 1);
        m.next(waiting, starts | (waiting & !(begun | finished)));
        let begins_run = m.reg_reset("begins_run", 1, 0);
        m.next(begins_run, starts & !busy);
        begins_run.expr()
    });
    let done = m.reg_reset("done", 1, 0);
    m.next(done, !starts & (done | (busy & finished)));
    ports.busy.drive_word(&mut m, busy);
    ports.start.drive_word(&mut m, start);
    ports.core_reset.drive_word(&mut m, core_reset);
    ports.aborts.drive_word(&mut m, aborts);
    uniform_out(&mut m, ports.uniform, map, &write);

    let read = Read::new(&mut m, map);
    let elsewhere = ports.errors.declare(&mut m, &sources);
    let from = |input: Expr, count: u32| (0..count).map(move |source| input.bit(source));
    let errors: [Vec<Expr>; ERRORS.len()] = [
        vec![refused_access, read.refused],
        std::iter::once(refused_busy).chain(from(elsewhere.busy_error, sources.busy)).collect(),
        from(elsewhere.burst_error, sources.burst).collect(),
        from(elsewhere.packet_error, sources.packet).collect(),
        from(elsewhere.memory_error, sources.memory).collect(),
    ];
    let error = m.reg_reset("error", 1, 0);
    m.next(error, any(&errors.concat()) | (error & !clear_errors));
    let [taken, sent] = [ports.packet_taken, ports.packet_sent].map(|port| port.declare_word(&mut m, 1));
    let events = ports.events.declare(&mut m, config).values(config);
    let in_run = [bit(true), taken, sent].into_iter().chain(events);
    let in_run = in_run.map(|event| Counter { sources: vec![event & busy.repeat(event.width())], clear: begins_run });
    let errors = errors.into_iter().map(|sources| Counter { sources, clear: clear_errors.expr() });
    let counted: Vec<Counter> = errors.chain(in_run).collect();

    let status = cat([state.waiting, error.expr(), done.expr(), state.busy]);
    read.answer(&mut m, ports.host, map, &counted, |register| match register.kind {
        RegisterKind::Identity(value) => Some(lit(REGISTER_BITS, value.into())),
        RegisterKind::Status(_) => Some(status),
        _ => stored.iter().find(|stored| stored.register == register).map(Stored::value),
    });
    let (enables, settings): (Vec<_>, Vec<_>) =
        stored.iter().partition(|stored| stored.register.kind == RegisterKind::InterruptEnable);
    enables.iter().for_each(|stored| ports.irq.event(&mut m, done & stored.bits));
    // The map has them in their order.
    let settings = settings.into_iter().map(Stored::value);
    ports.settings.drive(&mut m, config, Bundle::from_values(config, settings));
    m
}

/// What a write may have to wait for.
#[derive(Clone, Copy)]
struct State {
    /// A run is under way.
    busy: Expr,
    /// A start waits.
    waiting: Expr,
    /// No run may begin.
    occupied: Expr,
}

/// The write channels: an address and its data wait in registers until both are there.
struct Write {
    judges: Expr,
    /// The register's number.
    word: Expr,
    /// The access is to a whole aligned register.
    is_whole: Expr,
    data: Expr,
    /// The access is carried out.
    accepted: Wire,
}

impl Write {
    fn new(m: &mut Module, host: RegisterBus) -> Self {
        let [has_address, has_data, bvalid] =
            ["has_address", "has_data", "s_axil_bvalid"].map(|name| m.reg_reset(name, 1, 0));
        let judges = m.wire("judges", has_address & (has_data & !bvalid));
        let (awvalid, asked) = host.write_address.declare(m, &(), !has_address);
        m.next(has_address, has_address.mux(!judges, awvalid));
        let address = m.reg("write_address", BYTE_ADDRESS_BITS);
        m.next_if(address, !has_address, asked.address);
        let (wvalid, written) = host.write_data.declare(m, &(), !has_data);
        m.next(has_data, has_data.mux(!judges, wvalid));
        let data = m.reg("write_data", REGISTER_BITS);
        m.next_if(data, !has_data, written.data);
        let strobes = m.reg("write_strobes", 1);
        m.next_if(strobes, !has_data, written.strobes.all());

        let accepted = m.forward("write_accepted", 1);
        host.write_answer.drive_with(m, &(), bvalid, |m, bready| {
            m.next(bvalid, judges | (bvalid & !bready));
            let is_okay = m.reg("write_is_okay", 1);
            m.next_if(is_okay, judges, accepted);
            RegisterAnswer { response: is_okay.mux(OKAY.expr(), SLAVE_ERROR.expr()) }
        });
        let is_whole = strobes & address.trunc(BYTE_BITS).is_zero();
        let word = word_in(*address);
        Self { judges, word, is_whole, data: data.expr(), accepted }
    }

    /// Whether the access is to a register, if it is to a whole one.
    fn chooses(&self, register: &Register) -> Expr {
        self.word.eq_lit(word_of(register))
    }

    /// Whether the data are a register's value from `low` to `high`.
    fn lies_within(&self, register: &Register, low: u32, high: u32) -> Expr {
        let value = self.data.trunc(register.width);
        let is_least = if low == 0 { bit(true) } else { value.ge_lit(low.into()) };
        let largest = u32::MAX >> (REGISTER_BITS - register.width);
        let is_most = if high == largest { bit(true) } else { !value.ge_lit(u128::from(high) + 1) };
        is_least & is_most
    }

    /// Whether the access is to a uniform, if it is to a whole register; uniforms lie side by side.
    fn chooses_uniform(&self, map: &[Register]) -> Expr {
        let mut words = map.iter().filter(|register| register.kind == RegisterKind::Uniform).map(word_of);
        let Some(first) = words.next() else { return bit(false) };
        let last = words.next_back().unwrap_or(first);
        self.word.ge_lit(first) & !self.word.gt(lit(WORD_BITS, last))
    }

    /// Accepts the access or not; returns whether it is refused for what it is, and because a run is under way.
    fn judge(&self, m: &mut Module, map: &[Register], stored: &[Stored], state: State) -> [Expr; 2] {
        let uniform = self.chooses_uniform(map);
        let writable =
            |register: &&Register| register.access() != Access::Read && register.kind != RegisterKind::Uniform;
        let writable: Vec<&Register> = map.iter().filter(writable).collect();
        let known = writable.iter().map(|register| self.chooses(register)).chain([uniform]);
        let shaped = m.wire("shaped", self.is_whole & any(&known.collect::<Vec<_>>()));
        let commands = |number| {
            let control = map.iter().filter(|register| is_control(register));
            any(&control.map(|register| self.chooses(register) & self.data.bit(number)).collect::<Vec<_>>())
        };
        let starts = m.wire("wants_start", commands(0));
        let needs = |when, others: Expr| {
            let needing = writable.iter().filter(|register| register.when() == when);
            let needing = needing.map(|register| if is_control(register) { starts } else { self.chooses(register) });
            any(&needing.chain([others]).collect::<Vec<_>>())
        };
        let idle_only = m.wire("idle_only", needs(When::Idle, commands(1)));
        let ahead_only = m.wire("ahead_only", needs(When::Ahead, uniform));
        let blocked = (idle_only & state.busy) | (ahead_only & state.waiting) | (starts & state.occupied);
        let blocked = m.wire("blocked", blocked);
        let senseless = stored.iter().map(|Stored { register, bits }| match (register.kind, zero_bits(register)) {
            (RegisterKind::Queries, _) => starts & bits.is_zero(),
            (RegisterKind::Range { low, high }, _) => self.chooses(register) & !self.lies_within(register, low, high),
            (_, 0) => bit(false),
            (_, zeros) => self.chooses(register) & self.data.trunc(zeros).any(),
        });
        let senseless = m.wire("senseless", any(&senseless.collect::<Vec<_>>()));
        m.drive(self.accepted, self.judges & (shaped & !(blocked | senseless)));
        let refused_access = self.judges & (!shaped | (!blocked & senseless));
        let refused_busy = self.judges & (shaped & blocked);
        [m.wire("refused_write", refused_access), m.wire("refused_busy", refused_busy)]
    }
}

/// Hands writes of uniforms to the core, whose addresses begin at zero.
fn uniform_out(m: &mut Module, port: PulseOut<RegisterWrite>, map: &[Register], write: &Write) {
    let Some(bits) = UniformBits::of(map) else { return };
    let record = RegisterWrite { address: write.word.trunc(bits.address), data: write.data.trunc(bits.data) };
    port.registered(m, &bits, write.accepted & write.chooses_uniform(map), record);
}

/// The read channels: an address waits in a register until its value is there.
struct Read {
    has_address: Reg,
    address: Reg,
    /// The access is to a counter, if it is to a whole register, and to which.
    is_counter: Expr,
    counter: Expr,
    /// The access is refused, in the cycle in which it is.
    refused: Expr,
}

impl Read {
    fn new(m: &mut Module, map: &[Register]) -> Self {
        let has_address = m.reg_reset("has_read_address", 1, 0);
        let address = m.reg("read_address", BYTE_ADDRESS_BITS);
        let word = word_in(*address);
        let counters: Vec<&Register> = map.iter().filter(|register| is_counter(register)).collect();
        let index_bits = address_width(counters.len() as u32);
        // Of every number a counter may have: whether it is one's, and which.
        let last = counters.iter().map(|register| register.address >> BYTE_BITS).max().unwrap_or(0);
        let counter_bits = address_width(last + 1).max(COUNTER_WORD_BITS);
        let mut table = vec![0; 1 << counter_bits];
        for (index, register) in counters.into_iter().enumerate() {
            table[word_of(register) as usize] = 1 << index_bits | index as u128;
        }
        let found = m.lookup("found", &table, index_bits + 1, word.trunc(counter_bits));
        let is_low = word.bits(WORD_BITS - 1, counter_bits).is_zero();
        let is_counted = m.wire("reads_counter", found.msb() & is_low);
        let others = map.iter().filter(|register| register.access() != Access::Write && !is_counter(register));
        let known = others.map(|register| word.eq_lit(word_of(register))).chain([is_counted]);
        let shaped = address.trunc(BYTE_BITS).is_zero() & any(&known.collect::<Vec<_>>());
        let refused = m.wire("refused_read", has_address & !shaped);
        Self { has_address, address, is_counter: is_counted, counter: found.trunc(index_bits), refused }
    }

    /// Answers with the values of the registers, of which `value` knows all but the counters.
    fn answer(
        self,
        m: &mut Module,
        host: RegisterBus,
        map: &[Register],
        counted: &[Counter],
        value: impl Fn(&Register) -> Option<Expr>,
    ) {
        let word = word_in(*self.address);
        let asks = m.wire("asks", self.has_address & (self.is_counter & !self.refused));
        let answer = counters(m, counted, asks, self.counter);

        let rvalid = m.reg_reset("s_axil_rvalid", 1, 0);
        let arready = m.wire("read_ready", !(self.has_address | rvalid));
        let (arvalid, asked) = host.read_address.declare(m, &(), arready);
        m.next_if(self.address, arready, asked.address);
        let answers = m.wire("answers", self.has_address & (!asks | answer.valid));
        m.next(self.has_address, (arready & arvalid) | (self.has_address & !answers));
        let others = map.iter().filter_map(|register| {
            let value = value(register)?.zext(REGISTER_BITS);
            Some(word.eq_lit(word_of(register)).repeat(REGISTER_BITS) & value)
        });
        let others = others.fold(lit(REGISTER_BITS, 0), |all, value| all | value);
        let shown = asks.mux(answer.value, others & (!self.refused).repeat(REGISTER_BITS));
        let rdata = m.reg("s_axil_rdata", REGISTER_BITS);
        m.next_if(rdata, answers, shown);
        let is_error = m.reg("read_is_error", 1);
        m.next_if(is_error, answers, self.refused);
        let response = is_error.mux(SLAVE_ERROR.expr(), OKAY.expr());
        let rready = host.read_value.drive(m, &(), rvalid, RegisterValue { data: rdata.expr(), response });
        m.next(rvalid, answers | (rvalid & !rready));
    }
}
