//! `bus_frames` against its model, in every cycle.

use pointcore_contract::bus::units::FRAMES_MAX;
use pointcore_contract::fields;
use pointcore_contract::splat::records::{UNIFORM_ADDRESS_BITS, UniformWrite, Uniforms, late_uniforms};
use pointcore_contract::splat::{Config, Feature};
use pointcore_golden::bus::{Frames, FramesIn};
use pointcore_hdl::bus::frames;
use pointcore_tb::lockstep::seeds;

use crate::bus::{Bench, SEEDS};

const CYCLES: u32 = 60_000;
/// Addresses of uniforms, more than there are.
const ADDRESSES: u8 = 1 << UNIFORM_ADDRESS_BITS;

/// A host that asks for frames ahead, and a core that takes its time.
struct World {
    random: fastrand::Rng,
    /// A start waits.
    waiting: bool,
    /// Frames that are set up, and those that may leave.
    to_set_up: u32,
    to_send: u32,
    /// Uniforms that were never written hold anything.
    unwritten: u8,
    /// What was last written, by address, at which there need not be a uniform.
    written: Vec<u32>,
}

impl World {
    fn inputs(&mut self, config: &Config, begun: bool) -> FramesIn {
        self.waiting &= !begun;
        self.to_set_up += u32::from(begun);
        let is_first = self.unwritten > 0;
        let start = !self.waiting && !is_first && self.random.u8(..50) == 0;
        let writes = !self.waiting && (is_first || self.random.u8(..20) == 0);
        let write = writes.then(|| {
            self.unwritten = self.unwritten.saturating_sub(1);
            let late = late_uniforms(config);
            let any = match self.random.bool() {
                true => late[self.random.usize(..late.len())] as u8,
                false => self.random.u8(..ADDRESSES),
            };
            let address = if is_first { self.unwritten } else { any };
            // What the uniform holds, which changes nothing; the same but for a bit; or anything.
            let last = &mut self.written[usize::from(address)];
            *last = match self.random.u8(..3) {
                0 => *last,
                1 => *last ^ 1 << self.random.u32(..u32::BITS),
                _ => self.random.u32(..),
            };
            UniformWrite { address, data: *last }
        });
        self.waiting |= start;
        let set_up = self.to_set_up > 0 && self.random.u8(..90) == 0;
        self.to_set_up -= u32::from(set_up);
        let sent = self.to_send > 0 && self.random.u8(..100) == 0;
        self.to_send = self.to_send + u32::from(set_up) - u32::from(sent);
        FramesIn { start, write, set_up, sent }
    }
}

/// A run in which frames begin one after the other.
fn exchange(config: &Config, seed: u64) {
    let mut bench = Bench::new(frames::module(config), seed);
    let mut model = Frames::new(config);
    let unwritten = fields::<Uniforms>(config).len() as u8;
    let random = fastrand::Rng::with_seed(seed);
    let written = vec![0; ADDRESSES.into()];
    let mut world = World { random, waiting: false, to_set_up: 0, to_send: 0, unwritten, written };
    let (mut begun, mut most) = (0, 0);
    for _ in 0..CYCLES {
        let inputs = world.inputs(config, model.begun());
        let FramesIn { start, write, set_up, sent } = inputs;
        for (name, value) in [("start", start), ("set_up", set_up), ("sent", sent), ("write_valid", write.is_some())] {
            bench.set(name, value.into());
        }
        let UniformWrite { address, data } = write.unwrap_or_default();
        bench.set("write_address", address.into());
        bench.set("write_data", data.into());
        bench.step();
        let shown = ["begun", "idle", "uniform_valid"].map(|name| bench.get(name) == 1);
        assert_eq!(shown, [model.begun(), model.idle(), model.uniform().is_some()], "cycle {}", bench.cycle);
        if let Some(UniformWrite { address, data }) = model.uniform() {
            let shown = ["uniform_address", "uniform_data"].map(|name| bench.get(name));
            assert_eq!(shown, [u64::from(address), u64::from(data)], "cycle {}", bench.cycle);
        }
        begun += u32::from(model.begun());
        most = most.max(world.to_set_up + world.to_send);
        model.clock(inputs);
    }
    assert!(begun > CYCLES / 300 && most == FRAMES_MAX, "{begun} frames, {most} at a time");
}

#[test]
fn frames_begin_as_in_the_model() {
    let still = [Feature::On, Feature::Off].map(|screen_filter| Config { screen_filter, ..Config::default() });
    let moving = Config { screen_filter: Feature::Off, time_bins: 4, ..Config::default() };
    let configs = still.into_iter().chain([moving]).collect::<Vec<_>>();
    for seed in seeds(SEEDS).unwrap() {
        configs.iter().for_each(|config| exchange(config, seed));
    }
}
