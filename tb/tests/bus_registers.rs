//! `bus_registers` against its model: accesses of every kind between events, errors and ends of runs.

use pointcore_contract::bus::registers::{
    CONTROL, ErrorCounter, ErrorInputs, ErrorSources, PointsRegisters, RegisterMap, RunCounter, SearchRegisters,
    SplatRegisters, UniformBits,
};
use pointcore_contract::bus::units::registers::Ports;
use pointcore_contract::bus::{Register, RegisterKind, When};
use pointcore_contract::{fields, points, record, search, splat};
use pointcore_golden::bus::{Registers, Response};
use pointcore_hdl::bus::registers;
use pointcore_tb::lockstep::seeds;

use crate::bus::{Bench, Drain, Feed, SEEDS, stalls};

const ACCESSES: usize = 1500;
/// Cycles of events in one of a test's runs.
const LONG_CYCLES: u32 = 500_000;
/// Bits of the event that has its counter run through all its bits.
const TALLY_BITS: u32 = 24;
/// A bit of `control`.
const START: u32 = 1;
/// Cycles that a read takes at most.
const CYCLES_OF_A_READ: u64 = 80;
/// Cycles between two accesses in which anything may happen.
const EVENTFUL_CYCLES: u32 = 40;

/// A core's registers and one more, the counter of an event of so many bits that it soon has all of its own: those of the
/// core have a few, and a counter counts for minutes until it is full.
macro_rules! tallied {
    ($map:ident is $core:ty, $events:ident are [$($own:tt)+], [$($config:tt)+]) => {
        #[record(config: $($config)+)]
        pub struct $events {
            /// The core's own.
            #[with(config)]
            pub core: $($own)+,
            /// Anything.
            #[name("event_tally")]
            #[bits(TALLY_BITS)]
            pub tally: u32,
        }

        struct $map;

        impl RegisterMap for $map {
            type Config = $($config)+;
            type Settings = <$core as RegisterMap>::Settings;
            type Events = $events;

            const STARTS: When = <$core as RegisterMap>::STARTS;

            fn registers(config: &Self::Config) -> Vec<Register> {
                with_tally(<$core as RegisterMap>::registers(config))
            }
        }
    };
}

tallied!(TalliedSplat is SplatRegisters, TalliedSplatEvents are [splat::units::Events], [splat::Config]);
tallied!(TalliedSearch is SearchRegisters, TalliedSearchEvents are [search::units::Events], [search::Config]);
tallied!(TalliedPoints is PointsRegisters, TalliedPointsEvents are [points::units::Events], [points::Config]);

/// Registers with one more, behind the counters of events.
fn with_tally(mut map: Vec<Register>) -> Vec<Register> {
    let place_of = |register: &Register| match register.kind {
        RegisterKind::Run(RunCounter::Event(place)) => Some(place),
        _ => None,
    };
    let last = map.iter().rposition(|register| place_of(register).is_some()).unwrap();
    let place = place_of(&map[last]).unwrap() + 1;
    let kind = RegisterKind::Run(RunCounter::Event(place));
    let tally = Register { name: "event_tally".into(), address: map[last].address + 4, kind, ..map[last].clone() };
    assert!(map.iter().all(|register| register.address != tally.address), "{:x} is taken", tally.address);
    map.insert(last + 1, tally);
    map
}

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

    fn write(&mut self, address: u32, data: u32, strobes: u8) -> Response {
        self.address.items.push_back(vec![address.into()]);
        self.data.items.push_back(vec![data.into(), strobes.into()]);
        loop {
            self.step();
            if let Some(answer) = self.answer.taken(&self.bench) {
                return response(answer[0]);
            }
            assert_eq!(self.read_data.taken(&self.bench), None);
        }
    }

    fn read(&mut self, address: u32) -> (u32, Response) {
        self.read_address.items.push_back(vec![address.into()]);
        loop {
            self.step();
            if let Some(answer) = self.read_data.taken(&self.bench) {
                return (answer[0] as u32, response(answer[1]));
            }
            assert_eq!(self.answer.taken(&self.bench), None);
        }
    }

    /// Events, errors, and now and then the end of a run.
    fn happens(&mut self, counted: &[(String, RunCounter, u32)], errors: &[(String, ErrorCounter, u32)]) {
        // What is tallied is small and large.
        let scale = if self.random.bool() { 0 } else { self.random.u32(..TALLY_BITS) };
        for _ in 0..self.random.u32(..EVENTFUL_CYCLES) {
            for (name, counter, width) in counted {
                let events = self.random.u64(..1 << width) >> if *width == TALLY_BITS { scale } else { 0 };
                self.bench.set(name, events);
                self.model.event(*counter, events as u32);
            }
            for (name, error, count) in errors {
                let errors = if self.random.u8(..4) == 0 { self.random.u64(..1 << count) } else { 0 };
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

    /// As many events a cycle as there can be, for so long that counters have many of their bits, or all.
    fn run_on(&mut self, counted: &[(String, RunCounter, u32)]) {
        for (name, counter, width) in counted {
            let events = (1 << width) - 1;
            self.bench.set(name, events.into());
            self.model.event(*counter, u32::saturating_mul(events, LONG_CYCLES));
        }
        (0..LONG_CYCLES).for_each(|_| self.step());
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
    let settings: Vec<_> =
        map.iter().filter(is_setting).collect();
    let (mut refused, mut runs, mut ahead) = (0, 0, 0);
    // With some seeds one run goes on; then all registers are read.
    let goes_on = seed.is_multiple_of(SEEDS);
    let mut has_run_on = false;
    let mut to_read = vec![];
    for access in 0..ACCESSES {
        if goes_on && host.model.busy && !has_run_on && access > ACCESSES / 2 {
            has_run_on = true;
            host.run_on(&counted);
            host.rest(&counted, &errors);
            to_read = map.iter().map(|register| register.address).collect();
        } else if to_read.is_empty() {
            host.happens(&counted, &errors);
        }
        let next = to_read.pop();
        let address = next.unwrap_or_else(|| address(map, &mut host.random));
        if next.is_none() && host.random.bool() {
            let data = value(map, address, &mut host.random);
            let strobes = if host.random.u8(..8) == 0 { 7 } else { 0xf };
            let occupied = host.random.u8(..8) == 0;
            host.bench.set("occupied", occupied.into());
            let (was_busy, was_waiting) = (host.model.busy, host.model.waiting);
            let expected = host.model.write(address, data, strobes, occupied);
            assert_eq!(host.write(address, data, strobes), expected, "access {access}: write {data:x} to {address:x}");
            refused += u32::from(expected == Response::Refused);
            runs += u32::from(host.model.busy && !was_busy);
            ahead += u32::from(was_busy && host.model.waiting && !was_waiting);
        } else {
            let (value, response) = host.model.read(address);
            let (shown, answer) = host.read(address);
            assert_eq!(answer, response, "access {access}: read of {address:x}");
            let is_cycles = address == cycles;
            // While a run is under way, cycles pass between the answer and here.
            let most = if host.was_busy { CYCLES_OF_A_READ } else { 0 };
            let is_right = if is_cycles { u64::from(shown).abs_diff(host.cycles) <= most } else { shown == value };
            assert!(is_right, "access {access}: {address:x} reads {shown:x}, not {value:x} (cycles {})", host.cycles);
            refused += u32::from(response == Response::Refused);
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
        exchange::<TalliedPoints>(&points::Config { search: b.clone(), ..points::Config::default() }, [0, 4, 1, 3], seed);
    }
}
