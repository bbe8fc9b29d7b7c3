//! `splat_prefetch` against its model, in every cycle: no payload is asked for before there is room for it.

use pointcore_contract::splat::config::PayloadStore;
use pointcore_contract::splat::records::{PayloadPlace, TileCopy};
use pointcore_contract::splat::{Config, units};
use pointcore_contract::words;
use pointcore_golden::splat::Prefetch;
use pointcore_golden::unit::Ported;
use pointcore_hdl::splat::prefetch;
use pointcore_tb::lockstep::{Flow, Stall, Stalls, Stimulus, StreamPorts, Streams, seeds};

use crate::splat::{Device, configs, moved, offer, scene};
use crate::support::cases;

const COPIES: usize = 1200;
const SEEDS: u64 = 12;

/// Copies on their way through, and payloads that come and leave in the meantime.
#[derive(Clone)]
struct Around {
    config: Config,
    input: StreamPorts,
    out: StreamPorts,
    reads: StreamPorts,
    /// The place of `left` among the inputs.
    left: usize,
    copies: std::vec::IntoIter<TileCopy>,
    received: Vec<TileCopy>,
    asked: Vec<PayloadPlace>,
    /// Payloads that have left.
    gone: usize,
    /// As many as were under way at a time.
    most: usize,
    stalls: [Stalls; 4],
}

impl Around {
    fn new(config: &Config, device: &Device, copies: &[TileCopy], seed: u64) -> Self {
        let streams = Streams::of(device.library());
        let stream = |name| streams.get(name).expect("the unit has it").clone();
        let kinds = [
            [Stall::Never; 4],
            [Stall::Varied; 4],
            [Stall::Never, Stall::Never, Stall::Never, Stall::Random(0.8)],
            [Stall::Never, Stall::Bursts(40), Stall::Random(0.2), Stall::Never],
            [Stall::Random(0.2), Stall::Random(0.2), Stall::Bursts(40), Stall::Never],
            [Stall::Random(0.5); 4],
        ];
        let mut random = fastrand::Rng::with_seed(seed);
        let left = device.library().inputs().iter().position(|port| port.name == "left");
        Self {
            config: config.clone(),
            input: stream("in"),
            out: stream("out"),
            reads: stream("read"),
            left: left.expect("the unit has it"),
            copies: Vec::from(copies).into_iter(),
            received: vec![],
            asked: vec![],
            gone: 0,
            most: 0,
            stalls: kinds[seed as usize % kinds.len()].map(|stall| Stalls::new(stall, random.fork())),
        }
    }

    /// Payloads that were asked for and have not left.
    fn under_way(&self) -> usize {
        self.asked.len() - self.gone
    }
}

impl Stimulus for Around {
    fn drive(&mut self, _cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        self.received.extend(moved::<TileCopy>(&self.config, &self.out, inputs, outputs));
        self.asked.extend(moved::<PayloadPlace>(&self.config, &self.reads, inputs, outputs));
        self.most = self.most.max(self.under_way());
        let [source, sink, reads, leaves] = self.stalls.each_mut().map(Stalls::stalled);
        if !self.input.offers(inputs, outputs) || self.input.transfers(inputs, outputs) {
            let copy = if source { None } else { self.copies.next() };
            offer(&self.input, inputs, copy.map(|copy| words(&self.config, copy)));
        }
        for (stream, stalled) in [(&self.out, sink), (&self.reads, reads)] {
            inputs[stream.ready.expect("the stream has one")] = u64::from(!stalled);
        }
        // What has been asked for comes, and leaves with a copy.
        let copies = self.received.iter().filter(|copy| !copy.end).count();
        let leaves = !leaves && self.gone < copies.min(self.asked.len());
        inputs[self.left] = u64::from(leaves);
        self.gone += usize::from(leaves);
        if self.received.len() == COPIES && self.gone == copies { Flow::Done } else { Flow::Continue }
    }
}

/// Noise with an end here and there.
fn copies(config: &Config) -> Vec<TileCopy> {
    let mut random = scene::random();
    let copy = |index| TileCopy { end: index % 90 == 50 || index == 51, ..scene::noise(config, &mut random) };
    (0..COPIES).map(copy).collect()
}

#[test]
fn it_agrees_with_the_model_and_asks_for_no_more_than_there_is_room_for() {
    for (config, payload_ahead) in cases(configs().into_iter().zip([1, 5, 16])) {
        let config = Config { payload: PayloadStore::Memory, payload_ahead, ..config };
        let device = Device::new(&config, &prefetch::module(&config), &units::prefetch::UNIT);
        let copies = copies(&config);
        let asked: Vec<_> = copies.iter().filter(|copy| !copy.end).map(|copy| copy.splat).collect();
        let mut most = 0;
        for seed in seeds(SEEDS).expect("POINTCORE_SEED is a number") {
            let around = Around::new(&config, &device, &copies, seed);
            let run = device.lockstep(Ported::new(&config, Prefetch::new(&config)), seed).run(around);
            let around = run.unwrap_or_else(|error| panic!("{error}")).stimulus;
            let mut received = around.received.iter().zip(&copies);
            assert!(received.all(|(left, sent)| left.end && sent.end || left == sent), "seed {seed}");
            assert!(around.asked.iter().map(|place| place.splat).eq(asked.iter().copied()), "seed {seed}");
            most = most.max(around.most);
        }
        assert_eq!(most, payload_ahead as usize, "as many payloads are under way as may be");
    }
}
