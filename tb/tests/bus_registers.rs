//! `bus_registers` against its model: accesses of every kind between events, errors and ends of runs.

use pointcore_contract::bus::registers::{
    CONTROL, ErrorCounter, ErrorInputs, ErrorSources, RegisterMap, RunCounter, STATUS, UniformBits,
};
use pointcore_contract::bus::units::registers::Ports;
use pointcore_contract::bus::{Register, RegisterKind, When};
use pointcore_contract::{fields, points, search, splat};
use pointcore_golden::bus::{Registers, Response};
use pointcore_hdl::bus::registers;
use pointcore_tb::lockstep::seeds;

use crate::bus::tally::{TALLY_BITS, TalliedPoints, TalliedSearch, TalliedSplat};
use crate::bus::{Bench, Drain, Feed, SEEDS, stalls};

const ACCESSES: usize = 1500;
/// Cycles of events in one of a test's runs.
const LONG_CYCLES: u32 = 500_000;
/// Bits of `control`.
const START: u32 = 1;
const CLEAR_ERRORS: u32 = 4;
/// Cycles that a read takes at most.
const CYCLES_OF_A_READ: u64 = 80;
/// Accesses of a kind at most that the host makes before it is answered.
const AT_ONCE: usize = 4;
/// Cycles between two accesses in which anything may happen.
const EVENTFUL_CYCLES: u32 = 40;

/// The inputs for errors, their counters, and how many sources each has.
fn errors(sources: ErrorSources) -> Vec<(String, ErrorCounter, u32)> {
    let counters = [
        (ErrorCounter::Busy, sources.busy),
        (ErrorCounter::Burst, sources.burst),
        (ErrorCounter::Packet, sources.packet),
        (ErrorCounter::Memory, sources.memory),
    ];
    let present = counters.into_iter().filter(|(_, count)| *count > 0);
    let names = fields::<ErrorInputs>(&sources).into_iter().map(|field| field.name);
    names.zip(present).map(|(name, (counter, count))| (name, counter, count)).collect()
}

/// The inputs that count in a run, their counters, and their bits.
fn counted<M: RegisterMap>(config: &M::Config) -> Vec<(String, RunCounter, u32)> {
    let ports = Ports::<M>::ALL;
    let events = fields::<M::Events>(config).into_iter().enumerate();
    let events = events.map(|(place, field)| (field.name, RunCounter::Event(place), field.width));
    let packets = [(ports.packet_taken, RunCounter::PacketsIn), (ports.packet_sent, RunCounter::PacketsOut)];
    events.chain(packets.map(|(port, counter)| (port.name.to_owned(), counter, 1))).collect()
}

/// What an answer's two bits say (AXI: OKAY, SLVERR).
fn response(bits: u64) -> Response {
    match bits {
        0 => Response::Okay,
        2 => Response::Refused,
        _ => panic!("no response of this bus is {bits}"),
    }
}

/// A host that makes one access at a time, and the core's side.
struct Host {
    bench: Bench,
    address: Feed,
    data: Feed,
    answer: Drain,
    read_address: Feed,
    read_data: Drain,
    model: Registers,
    /// Cycles of the run, counted where the unit shows it.
    cycles: u64,
    was_busy: bool,
    has_uniforms: bool,
    starts_ahead: bool,
    /// Uniforms, resets and aborts that the core was told of.
    uniforms: Vec<(u32, u32)>,
    resets: u32,
    aborts: u32,
    random: fastrand::Rng,
}

impl Host {
    fn new<M: RegisterMap>(config: &M::Config, sources: ErrorSources, seed: u64) -> Self {
        let (map, host) = (&M::registers(config), Ports::<M>::ALL.host);
        let mut random = fastrand::Rng::with_seed(seed);
        let bench = Bench::new(registers::module::<M>(config, sources), seed);
        let patterns: Vec<_> = (0..5).map(|_| stalls(&mut random)).collect();
        let [a, w, b, ar, r] = <[_; 5]>::try_from(patterns).unwrap();
        let address = Feed::new(&bench, host.write_address, &(), &mut random, a);
        let data = Feed::new(&bench, host.write_data, &(), &mut random, w);
        let answer = Drain::new(&bench, host.write_answer, &(), b);
        let read_address = Feed::new(&bench, host.read_address, &(), &mut random, ar);
        let read_data = Drain::new(&bench, host.read_value, &(), r);
        let (model, has_uniforms) = (Registers::new(map), UniformBits::of(map).is_some());
        let (cycles, uniforms, resets, aborts) = (0, vec![], 0, 0);
        Self {
            bench,
            address,
            data,
            answer,
            read_address,
            read_data,
            model,
            cycles,
            was_busy: false,
            has_uniforms,
            starts_ahead: M::STARTS == When::Ahead,
            uniforms,
            resets,
            aborts,
            random,
        }
    }

    fn step(&mut self) {
        [&mut self.address, &mut self.data, &mut self.read_address]
            .into_iter()
            .for_each(|feed| feed.offer(&mut self.bench));
        [&mut self.answer, &mut self.read_data].into_iter().for_each(|drain| drain.offer(&mut self.bench));
        self.bench.step();
        let (start, busy) = (self.bench.get("start"), self.bench.get("busy"));
        self.cycles = if start == 1 && !self.was_busy { 0 } else { self.cycles } + busy;
        self.was_busy = busy == 1;
        self.resets += self.bench.get("core_reset") as u32;
        self.aborts += self.bench.get("aborts") as u32;
        if self.has_uniforms && self.bench.get("uniform_valid") == 1 {
            self.uniforms.push(["uniform_address", "uniform_data"].map(|name| self.bench.get(name) as u32).into());
        }
        [&mut self.address, &mut self.data, &mut self.read_address]
            .into_iter()
            .for_each(|feed| _ = feed.taken(&self.bench));
    }

    /// Writes to addresses, with strobes, that the host makes without waiting for their answers.
    fn write(&mut self, writes: &[(u32, u32, u8)]) -> Vec<Response> {
        for &(address, data, strobes) in writes {
            self.address.items.push_back(vec![address.into()]);
            self.data.items.push_back(vec![data.into(), strobes.into()]);
        }
        let mut responses = vec![];
        while responses.len() < writes.len() {
            self.step();
            responses.extend(self.answer.taken(&self.bench).map(|answer| response(answer[0])));
            assert_eq!(self.read_data.taken(&self.bench), None);
        }
        responses
    }

    /// The same with reads.
    fn read(&mut self, addresses: &[u32]) -> Vec<(u32, Response)> {
        self.read_address.items.extend(addresses.iter().map(|address| vec![(*address).into()]));
        let mut values = vec![];
        while values.len() < addresses.len() {
            self.step();
            let answer = self.read_data.taken(&self.bench);
            values.extend(answer.map(|answer| (answer[0] as u32, response(answer[1]))));
            assert_eq!(self.answer.taken(&self.bench), None);
        }
        values
    }

    /// Events, errors, and now and then the end of a run.
    fn happens(&mut self, counted: &[(String, RunCounter, u32)], errors: &[(String, ErrorCounter, u32)]) {
        // What is tallied is small and large.
        let scale = if self.random.bool() { 0 } else { self.random.u32(..TALLY_BITS) };
        // Now and then nothing goes wrong, so that a single refusal shows.
        let goes_wrong = self.random.bool();
        for _ in 0..self.random.u32(..EVENTFUL_CYCLES) {
            for (name, counter, width) in counted {
                let events = self.random.u64(..1 << width) >> if *width == TALLY_BITS { scale } else { 0 };
                self.bench.set(name, events);
                self.model.event(*counter, events as u32);
            }
            for (name, error, count) in errors {
                let errors = if goes_wrong && self.random.u8(..4) == 0 { self.random.u64(..1 << count) } else { 0 };
                self.bench.set(name, errors);
                (0..errors.count_ones()).for_each(|_| self.model.error(*error));
            }
            let finishes = self.random.u8(..200) == 0;
            self.bench.set("finished", finishes.into());
            let begins = self.starts_ahead && self.random.u8(..15) == 0;
            if self.starts_ahead {
                self.bench.set("begun", begins.into());
            }
            self.step();
            if begins {
                self.model.begin();
            }
            if finishes {
                self.model.finish();
            }
        }
        self.rest(counted, errors);
    }

    /// Nothing happens.
    fn rest(&mut self, counted: &[(String, RunCounter, u32)], errors: &[(String, ErrorCounter, u32)]) {
        let inputs = counted.iter().map(|(name, ..)| name).chain(errors.iter().map(|(name, ..)| name));
        inputs.for_each(|name| self.bench.set(name, 0));
        self.bench.set("finished", 0);
        if self.starts_ahead {
            self.bench.set("begun", 0);
        }
    }

    /// As many events and errors a cycle as there can be, for so long that counters have many of their bits, or all. Meanwhile the
    /// host reads a counter over and over, which keeps others from their turn; what it reads grows.
    fn run_on(&mut self, counted: &[(String, RunCounter, u32)], errors: &[(String, ErrorCounter, u32)], cycles: u32) {
        for (name, counter, width) in counted {
            let events = (1 << width) - 1;
            self.bench.set(name, events.into());
            self.model.event(*counter, u32::saturating_mul(events, LONG_CYCLES));
        }
        for (name, error, count) in errors {
            self.bench.set(name, (1 << count) - 1);
            (0..count * LONG_CYCLES).for_each(|_| self.model.error(*error));
        }
        let mut latest = 0;
        for cycle in 0..LONG_CYCLES {
            let reads = cycle < LONG_CYCLES - CYCLES_OF_A_READ as u32;
            if reads && self.read_address.items.len() < AT_ONCE {
                self.read_address.items.push_back(vec![cycles.into()]);
            }
            self.step();
            if let Some(answer) = self.read_data.taken(&self.bench) {
                assert!(latest < answer[0] && response(answer[1]) == Response::Okay, "{latest}, then {answer:x?}");
                latest = answer[0];
            }
        }
        assert!(self.read_address.items.is_empty());
    }
}

/// An address: most often a register's.
fn address(map: &[Register], random: &mut fastrand::Rng) -> u32 {
    match random.u8(..8) {
        0 => random.u32(..1 << 12),
        1 => map[random.usize(..map.len())].address + random.u32(1..4),
        2 | 3 => CONTROL,
        _ => map[random.usize(..map.len())].address,
    }
}

/// Whether a register holds something for the core.
fn is_setting(register: &&Register) -> bool {
    matches!(register.kind, RegisterKind::Setting { .. } | RegisterKind::Range { .. } | RegisterKind::Queries)
}

/// A value that makes sense for some register, or about where a range ends.
fn value(map: &[Register], address: u32, random: &mut fastrand::Rng) -> u32 {
    let ends = map.iter().find(|register| register.address == address).and_then(|register| match register.kind {
        RegisterKind::Range { low, high } => Some([low.wrapping_sub(1), low, high, high.wrapping_add(1)]),
        _ => None,
    });
    let sense = [random.u32(..16), random.u32(..) & !0xfff, random.u32(..)];
    match ends {
        None if address == CONTROL && random.bool() => START,
        Some(ends) if random.bool() => ends[random.usize(..4)],
        _ => sense[random.usize(..3)],
    }
}

fn exchange<M: RegisterMap>(config: &M::Config, [busy, burst, packet, memory]: [u32; 4], seed: u64) {
    let sources = ErrorSources { busy, burst, packet, memory };
    let map = &M::registers(config);
    let mut host = Host::new::<M>(config, sources, seed);
    let (counted, errors) = (counted::<M>(config), errors(sources));
    let of_kind = |kind| map.iter().find(|register| register.kind == kind).map(|register| register.address);
    let cycles = of_kind(RegisterKind::Run(RunCounter::Cycles)).unwrap();
    let settings: Vec<_> = map.iter().filter(is_setting).collect();
    let (mut refused, mut runs, mut ahead) = (0, 0, 0);
    // With some seeds one run goes on; then all registers are read.
    let goes_on = seed.is_multiple_of(SEEDS);
    let mut has_run_on = false;
    let mut to_read = vec![];
    // Now and then errors are cleared, something is written, and the status is read, while nothing happens.
    let mut calm = 0;
    for access in 0..ACCESSES {
        if goes_on && host.model.busy && !has_run_on && access > ACCESSES / 2 {
            (has_run_on, calm) = (true, 0);
            host.run_on(&counted, &errors, cycles);
            host.rest(&counted, &errors);
            to_read = map.iter().map(|register| register.address).collect();
        } else if to_read.is_empty() {
            calm = if calm == 0 && host.random.u8(..16) == 0 { 3 } else { u32::saturating_sub(calm, 1) };
            if calm == 0 {
                host.happens(&counted, &errors);
            }
        }
        let next = to_read.pop().or([None, Some(STATUS), None, Some(CONTROL)][calm as usize]);
        let at_once = if next.is_none() && host.random.u8(..4) == 0 { host.random.usize(2..=AT_ONCE) } else { 1 };
        let addresses: Vec<_> = (0..at_once).map(|_| next.unwrap_or_else(|| address(map, &mut host.random))).collect();
        if calm > 1 || (next.is_none() && host.random.bool()) {
            let write = |address: u32| {
                if calm == 3 {
                    return (address, CLEAR_ERRORS, 0xf);
                }
                let strobes = if host.random.u8(..8) == 0 { 0xf ^ (1 << host.random.u8(..4)) } else { 0xf };
                (address, value(map, address, &mut host.random), strobes)
            };
            let writes: Vec<_> = addresses.into_iter().map(write).collect();
            let occupied = host.random.u8(..8) == 0;
            host.bench.set("occupied", occupied.into());
            let mut expected = vec![];
            for &(address, data, strobes) in &writes {
                let (was_busy, was_waiting) = (host.model.busy, host.model.waiting);
                expected.push(host.model.write(address, data, strobes, occupied));
                refused += u32::from(expected.last() == Some(&Response::Refused));
                runs += u32::from(host.model.busy && !was_busy);
                ahead += u32::from(was_busy && host.model.waiting && !was_waiting);
            }
            assert_eq!(host.write(&writes), expected, "access {access}: writes {writes:x?}");
        } else {
            let expected: Vec<_> = addresses.iter().map(|address| host.model.read(*address)).collect();
            let answers = host.read(&addresses);
            for ((address, (value, response)), (shown, answer)) in addresses.into_iter().zip(expected).zip(answers) {
                assert_eq!(answer, response, "access {access}: read of {address:x}");
                let is_cycles = address == cycles;
                // While a run is under way, cycles pass between the answer and here.
                let most = if host.was_busy { CYCLES_OF_A_READ * at_once as u64 } else { 0 };
                let is_right = if is_cycles { u64::from(shown).abs_diff(host.cycles) <= most } else { shown == value };
                assert!(
                    is_right,
                    "access {access}: {address:x} reads {shown:x}, not {value:x} (cycles {})",
                    host.cycles
                );
                refused += u32::from(response == Response::Refused);
            }
        }
        // What was accepted has shown by the time of the answer, or does so in the next cycle.
        host.step();
        for Register { name, address, .. } in &settings {
            assert_eq!(host.bench.get(name), u64::from(host.model.setting(*address)), "access {access}: {name}");
        }
        assert_eq!(host.bench.get("busy"), u64::from(host.model.busy), "access {access}");
        assert_eq!(host.bench.get("irq"), u64::from(host.model.interrupt()), "access {access}");
    }
    assert_eq!(host.uniforms, host.model.uniforms);
    assert_eq!(host.resets, host.model.resets);
    assert_eq!(host.aborts, host.model.aborts);
    let (resets, aborts) = (host.resets, host.aborts);
    assert_eq!(has_run_on, goes_on, "seed {seed}");
    assert!(refused > 100 && runs > 5, "{refused} refused, {runs} runs");
    assert_eq!(ahead > 5, host.starts_ahead, "{ahead} starts in a run");
    assert!(resets > 5 && aborts > 5, "{resets} resets, {aborts} aborts");
}

#[test]
fn accesses_do_what_the_model_does() {
    let wide = splat::Config { rasterizers: 8, ..splat::Config::default() };
    let b = search::Config { tree_cache: 16, neighbor_cache: 2, ..search::Config::default() };
    for seed in seeds(SEEDS).unwrap() {
        exchange::<TalliedSplat>(&splat::Config::default(), [0, 1, 1, 2], seed);
        exchange::<TalliedSplat>(&wide, [0, 1, 1, 2], seed);
        exchange::<TalliedSearch>(&b, [1, 2, 1, 2], seed);
        exchange::<TalliedPoints>(
            &points::Config { search: b.clone(), ..points::Config::default() },
            [0, 4, 1, 3],
            seed,
        );
    }
}
