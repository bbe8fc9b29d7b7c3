//! The memories that units place, against arrays: writes and reads in any cycle, words kept while nothing is read.

use pointcore_tb::lockstep::{Flow, Lockstep, seeds};
use rtl::{Memory, Module, address_width};

use crate::support;

const CYCLES: u64 = 10_000;
const WIDTH: u32 = 21;

/// How a memory is described, and how many words it has.
struct Shape {
    depth: u32,
    reads: usize,
    /// A word that is read while it is written is the old one.
    is_ordered: bool,
    describe: fn(&mut Module, u32) -> Memory,
}

const SHAPES: [Shape; 4] = [
    Shape { depth: 16, reads: 1, is_ordered: true, describe: |m, depth| m.memory("store", depth, WIDTH) },
    Shape { depth: 5, reads: 1, is_ordered: false, describe: |m, depth| m.memory_unordered("store", depth, WIDTH) },
    Shape { depth: 33, reads: 1, is_ordered: false, describe: |m, depth| m.memory_sliced("store", depth, WIDTH, 8) },
    Shape { depth: 8, reads: 2, is_ordered: true, describe: |m, depth| m.memory("store", depth, WIDTH) },
];

impl Shape {
    /// The memory between ports. What it holds before the first read of a port is unknown, and zero here.
    fn module(&self) -> Module {
        let mut m = Module::new("memory_ports", "A memory with its ports.");
        let bits = address_width(self.depth);
        let memory = (self.describe)(&mut m, self.depth);
        let [write, address, data] =
            [("write", 1), ("write_address", bits), ("write_data", WIDTH)].map(|(name, bits)| m.input(name, bits));
        m.write(memory, write, address, data);
        for port in 0..self.reads {
            let [read, address] =
                [("read", 1), ("address", bits)].map(|(name, bits)| m.input(&format!("{name}_{port}"), bits));
            let word = m.read_if(memory, &format!("word_{port}"), read, address);
            let known = m.reg_reset(&format!("known_{port}"), 1, 0);
            m.next(known, known | read);
            m.output(&format!("data_{port}"), known.mux(word, rtl::lit(WIDTH, 0)));
        }
        m
    }

    /// Inputs `rst, write, write_address, write_data` and `read, address` of each port.
    fn golden(&self) -> impl FnMut(&[u64], &mut [u64]) + use<> {
        let (mut words, mut shown) = (vec![0; self.depth as usize], vec![0; self.reads]);
        move |inputs, outputs| {
            outputs.copy_from_slice(&shown);
            let (&[rst, write, address, data], reads) = inputs.split_at(4) else {
                panic!("too few inputs: {inputs:?}")
            };
            for (shown, read) in shown.iter_mut().zip(reads.chunks(2)) {
                match (rst, read[0]) {
                    (0, 0) => {}
                    (0, _) => *shown = words[read[1] as usize],
                    _ => *shown = 0,
                }
            }
            if rst == 0 && write != 0 {
                words[address as usize] = data;
            }
        }
    }

    /// All words are written, then some are written or read in each cycle: the same ones where that has an order.
    fn stimulus(&self, seed: u64) -> impl FnMut(u64, &[u64], &mut [u64]) -> Flow + Clone + use<> {
        let mut random = fastrand::Rng::with_seed(seed);
        let (depth, is_ordered) = (u64::from(self.depth), self.is_ordered);
        move |cycle, _, inputs| {
            let (write, reads) = inputs.split_at_mut(4);
            let is_first = cycle < depth;
            write[1] = u64::from(is_first || random.bool());
            write[2] = if is_first { cycle } else { random.u64(..depth) };
            write[3] = random.u64(..1 << WIDTH);
            for read in reads.chunks_mut(2) {
                read[1] = random.u64(..depth);
                let is_apart = is_ordered || write[1] == 0 || read[1] != write[2];
                read[0] = u64::from(!is_first && is_apart && random.bool());
            }
            if cycle < CYCLES { Flow::Continue } else { Flow::Done }
        }
    }
}

#[test]
fn words_are_read_as_they_were_written() {
    for shape in SHAPES {
        let library = support::verilate(&shape.module());
        for seed in seeds(3).unwrap() {
            let run = Lockstep::new(&library, shape.golden(), seed).run(shape.stimulus(seed));
            assert_eq!(run.unwrap_or_else(|error| panic!("{error}")).report.cycles, CYCLES);
        }
    }
}
