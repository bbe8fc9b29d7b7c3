//! Two sides' records, of which some close a frame, through a collector.

use pointcore_contract::splat::Config;
use pointcore_contract::{Unit, read, words};
use pointcore_golden::unit::{Model, Ported};
use pointcore_tb::lockstep::{StreamTestbench, seeds};
use rtl::Module;

use super::{Device, RUNS, Travels, scene, stalls};

/// Records of a side.
const RECORDS: usize = 600;
/// Those of its frame, the end among them.
const FRAME: usize = 150;

/// Two sides' records, of which every so many ends a frame, through a collector: frames end when both sides have, and nothing is lost.
pub fn check<R: Travels, M: Model<Config = Config>>(
    config: &Config,
    (module, unit): (&Module, &Unit<Config>),
    model: &M,
    end: impl Fn(&mut R) -> &mut bool,
) {
    let device = Device::new(config, module, unit);
    for seed in seeds(RUNS).unwrap() {
        let mut random = scene::random();
        let mut records = |side: usize| -> Vec<Vec<u64>> {
            // A side's frames differ in length from the other's.
            let is_end = |index: usize| index % FRAME == FRAME - 1 - side * (index / FRAME);
            let last = (0..RECORDS).rfind(|&index| is_end(index)).expect("frames end");
            let record = |index| {
                let mut record: R = scene::noise(config, &mut random);
                *end(&mut record) = is_end(index);
                words(config, record)
            };
            (0..=last).map(record).collect()
        };
        let [low, high] = [0, 1].map(&mut records);
        let bench = StreamTestbench::new(device.library(), seed);
        let bench = bench.source("low", low.clone(), stalls(seed)).unwrap();
        let bench = bench.source("high", high.clone(), stalls(seed + 1)).unwrap();
        let bench = bench.sink("out", stalls(seed + 2)).unwrap();
        let model = Ported::new(config, model.clone());
        let run = device.lockstep(model, seed).run(bench).unwrap_or_else(|error| panic!("{error}"));

        let is_end = |words: &[u64]| *end(&mut read::<R>(config, words));
        let frames = |records: &[Vec<u64>]| -> Vec<Vec<Vec<u64>>> {
            let frames = records.split_inclusive(|record| is_end(record));
            frames.map(|frame| frame[..frame.len() - 1].to_vec()).collect()
        };
        let [low, high, out] = [&low, &high, run.stimulus.collected("out")].map(frames);
        assert_eq!((low.len(), high.len(), out.len()), (RECORDS / FRAME, RECORDS / FRAME, RECORDS / FRAME));
        for ((low, high), mut out) in low.into_iter().zip(high).zip(out) {
            let mut expected = [low, high].concat();
            expected.sort_unstable();
            out.sort_unstable();
            assert!(out == expected, "seed {seed}: a frame is not that of both sides");
        }
    }
}
