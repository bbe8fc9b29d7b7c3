//! The golden model of a block, and tokens for it: what real neighborhoods give, with something hard among it now and
//! then.

use crate::compiler::generator::sample;
use crate::compiler::model::Source as Compared;
use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::process::{NodeId, Operation, PARTIAL_SUMS, Port, Program, Scalar, Section, Source};
use pointcore_golden::float;
use pointcore_golden::process::Blocks;
use pointcore_hdl::compiler::Type;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// Settings are between these: neighbors lie on both sides of `1/√inverse_radius2`, neighborhoods on both of
/// `least_spread`.
const SETTINGS: [f64; 2] = [0.02, 0.2];
/// Neighbors of a query at most.
const NEIGHBORS_MAX: usize = 20;
/// One token of so many is of nothing but random bits, and one has a word of them.
const HARD_SHARE: u32 = 5;

/// A block with its settings.
pub struct Golden {
    blocks: Blocks,
    section: Section,
    format: Format,
    ports: Vec<Port>,
    settings: Vec<u32>,
    counts: Counts,
}

/// How often each output of one bit was low, and high.
#[derive(Clone, Default)]
pub struct Counts(Rc<RefCell<Vec<Flag>>>);

/// Name of an output, and how often it was low and high.
type Flag = (String, [u32; 2]);

impl Counts {
    /// Every flag that a program decides on was seen low and high.
    pub fn check(&self, unit: &str) {
        for (name, counts) in self.0.borrow().iter() {
            assert!(counts[0] > 0 && counts[1] > 0, "{unit}: {name} was low and high {counts:?} times");
        }
    }
}

impl Golden {
    pub fn new(program: Program, section: Section, format: Format, settings: Vec<u32>) -> Self {
        let ports = program.inputs(section);
        let blocks = Blocks::new(program, format);
        Self { blocks, section, format, ports, settings, counts: Counts::default() }
    }

    pub fn counts(&self) -> Counts {
        self.counts.clone()
    }

    /// The settings that the block reads, in the order of its ports.
    pub fn uniforms(&self) -> Vec<u64> {
        let setting = |port: &Port| match port.source {
            Source::Setting(word) => Some(self.settings[word].into()),
            _ => None,
        };
        self.ports.iter().filter_map(setting).collect()
    }

    /// What a block reads, of a random query with random neighbors.
    fn scene(&self, rng: &mut Rng) -> HashMap<(Source, usize), u32> {
        let program = self.blocks.program();
        let mut scene = HashMap::new();
        let neighbors = rng.usize(1..=NEIGHBORS_MAX);
        let mut fill = |make: fn(usize) -> Source, words: Vec<Scalar>| {
            for (word, ty) in words.into_iter().enumerate() {
                scene.insert((make(word), 0), tame(rng, self.format, ty));
            }
        };
        let types = |layout: &pointcore_contract::process::Layout| {
            layout.words().into_iter().map(|word| word.ty).collect::<Vec<_>>()
        };
        fill(Source::Query, types(&program.query));
        fill(Source::State, types(&program.state));
        fill(Source::Farthest, types(&program.neighbor));
        scene.extend(self.settings.iter().enumerate().map(|(word, &value)| ((Source::Setting(word), 0), value)));
        scene.insert((Source::Neighbors, 0), neighbors as u32);
        scene.insert((Source::Count, 0), rng.u32(..3));
        for index in 0..neighbors {
            for (word, ty) in types(&program.neighbor).into_iter().enumerate() {
                scene.insert((Source::Neighbor(word), 0), tame(rng, self.format, ty));
            }
            if self.section == Section::Final {
                self.accumulate(&mut scene, index);
            }
        }
        scene
    }

    /// The kernel's addends of the neighbor in the scene.
    fn accumulate(&self, scene: &mut HashMap<(Source, usize), u32>, index: usize) {
        let ports = self.blocks.program().inputs(Section::Kernel);
        let inputs: Vec<u32> = ports.iter().map(|port| scene[&(port.source, 0)]).collect();
        let addends = self.blocks.step(Section::Kernel, &inputs);
        let types = self.blocks.program().sums.words();
        for (word, (addend, ty)) in addends.into_iter().zip(types).enumerate() {
            for partial in 0..PARTIAL_SUMS {
                let sum = scene.entry((Source::Sum(word), partial)).or_insert(0);
                if partial == index % PARTIAL_SUMS {
                    *sum = match ty.ty {
                        Scalar::Float => float::add(self.format, (*sum).into(), addend.into()) as u32,
                        Scalar::Int | Scalar::Bool => sum.wrapping_add(addend),
                    };
                }
            }
        }
    }
}

/// A moderate value: floats within ±1, few of them very small.
pub fn tame(rng: &mut Rng, format: Format, ty: Scalar) -> u32 {
    within(1.0, rng, format, ty)
}

/// The same with floats of another magnitude.
pub fn within(magnitude: f64, rng: &mut Rng, format: Format, ty: Scalar) -> u32 {
    match ty {
        Scalar::Float => encode(format, magnitude * (rng.f64() * 2.0 - 1.0)),
        Scalar::Int => rng.i32(-9..10) as u32,
        Scalar::Bool => rng.u32(..2),
    }
}

fn encode(format: Format, value: f64) -> u32 {
    float::convert(Format::F32, format, (value as f32).to_bits().into()) as u32
}

/// Settings of a program, with such numbers.
pub fn settings(program: &Program, format: Format, rng: &mut Rng, number: fn(&mut Rng) -> f64) -> Vec<u32> {
    let value = |ty| match ty {
        Scalar::Float => encode(format, number(rng)),
        _ => tame(rng, format, ty),
    };
    program.settings.words().into_iter().map(|word| word.ty).map(value).collect()
}

/// A setting under which little is degenerate.
pub fn moderate(rng: &mut Rng) -> f64 {
    SETTINGS[0] + rng.f64() * (SETTINGS[1] - SETTINGS[0])
}

impl Compared for Golden {
    fn token(&self, rng: &mut Rng) -> Vec<u64> {
        let ports: Vec<&Port> = self.ports.iter().filter(|port| !matches!(port.source, Source::Setting(_))).collect();
        let scene = self.scene(rng);
        let mut token: Vec<u64> = ports.iter().map(|port| scene[&(port.source, port.partial)].into()).collect();
        let mut harden = |rng: &mut Rng, index: usize| {
            token[index] = match ports[index].ty {
                Scalar::Float if rng.bool() => hard(rng, self.format),
                Scalar::Float => sample(rng, Type::Float(self.format)),
                Scalar::Int => rng.u32(..).into(),
                Scalar::Bool => rng.u64(..2),
            };
        };
        match rng.u32(..HARD_SHARE) {
            0 => (0..ports.len()).for_each(|index| harden(rng, index)),
            1 if !ports.is_empty() => {
                let index = rng.usize(..ports.len());
                harden(rng, index);
            }
            _ => {}
        }
        token
    }

    fn results(&self, inputs: &[u64], uniforms: &[u64]) -> Vec<u64> {
        let (mut inputs, mut uniforms) = (inputs.iter(), uniforms.iter());
        let mut word = |port: &Port| match port.source {
            Source::Setting(_) => *uniforms.next().expect("a uniform for every setting") as u32,
            _ => *inputs.next().expect("a word for every port") as u32,
        };
        let words: Vec<u32> = self.ports.iter().map(&mut word).collect();
        let results = self.blocks.step(self.section, &words);
        let outgoing = self.blocks.program().results(self.section);
        let flags = outgoing.iter().zip(&results);
        let is_decided = |id: NodeId| {
            let node = self.blocks.program().block(self.section).node(id);
            node.ty == Scalar::Bool && !matches!(node.operation, Operation::Literal(_))
        };
        let flags = flags.filter(|(outgoing, _)| outgoing.value.is_some_and(is_decided));
        let mut counts = self.counts.0.borrow_mut();
        for (index, (outgoing, &value)) in flags.enumerate() {
            if counts.len() == index {
                counts.push((outgoing.name.clone(), [0; 2]));
            }
            counts[index].1[value as usize] += 1;
        }
        results.into_iter().map(u64::from).collect()
    }
}

/// Zeros, infinities, NaNs, and the ends of the normal and of the subnormal numbers.
fn hard(rng: &mut Rng, format: Format) -> u64 {
    let smallest = 1 << format.mantissa;
    let magnitudes =
        [0, 1, smallest - 1, smallest, format.one(), format.infinity() - 1, format.infinity(), format.quiet_nan()];
    magnitudes[rng.usize(..magnitudes.len())] | if rng.bool() { format.sign_mask() } else { 0 }
}
