//! What the tests of the point processor share: small random trees with attributes, and what the interpreter says that queries among
//! them leave with.

use std::sync::Arc;

use fastrand::Rng;
use pointcore_contract::points::Config;
use pointcore_contract::process::library::program;
use pointcore_contract::process::{self, Program};
use pointcore_contract::search;
use pointcore_golden::process::{Interpreter, Neighborhood};
use pointcore_golden::search::leaf::squared_distance;

use crate::process::scene::{self, settings, tame, within};
use crate::search::tree::Tree;
use crate::search::{Coordinate, configs, number, word};

const ITERATIONS_MAX: u32 = 3;
/// Now and then they may be so many that their count has most of its bits that a test has time for.
const MANY_ITERATIONS: std::ops::Range<u32> = 64..80;
/// How much farther than a ball query asks its cached neighborhood reaches.
const EXTENSION: f32 = 1.25;
/// How many times some attributes are doubled.
const MAGNITUDES: std::ops::Range<i32> = -24..24;
/// Sums that do not hang on the order of neighbors.
const TAGS: &str = include_str!("../process/tags.pasm");
/// Looks at the farthest neighbor, moves, searches now and then.
const FARTHEST: &str = include_str!("../process/farthest.pasm");

/// Points, and what is asked of all of them.
#[derive(Clone)]
pub struct World {
    /// The core.
    pub config: Config,
    /// A coordinate of a point.
    pub coordinate: Coordinate,
    /// The points' tree.
    pub tree: Tree,
    /// By index, as the program sees it.
    pub points: Vec<Vec<u32>>,
    /// What is asked in a run.
    pub asked: Asked,
    interpreter: Interpreter,
}

/// What all queries of a run have in common.
#[derive(Clone)]
pub struct Asked {
    /// Words of the settings.
    pub settings: Vec<u32>,
    /// Neighbors wanted.
    pub k: u32,
    /// Squared radius.
    pub radius2: u64,
    /// How far a query looks, if a neighbor cache answers it with a ball searched around another.
    pub reach: Option<f32>,
    /// Iterations at most.
    pub iterations_max: u32,
}

impl Asked {
    fn random(Config { search, process }: &Config, random: &mut Rng) -> Self {
        let has_cache = search.neighbor_cache > 0;
        let k = if has_cache { search.neighbors } else { random.u32(1..=search.neighbors) };
        let radius2 = if has_cache || random.bool() { f32::INFINITY } else { 3.0 + 2.0 * random.f32() };
        let settings = settings(&process.program, process.format, random);
        let has_many = random.u8(..8) == 0;
        let iterations_max = if has_many { random.u32(MANY_ITERATIONS) } else { random.u32(1..=ITERATIONS_MAX) };
        Self { settings, k, radius2: word(search, radius2), reach: None, iterations_max }
    }

    /// What a core with a neighbor cache is told: whether queries are balls, how far it looks, how much of what a search leaves counts.
    pub fn cache(&self, config: &search::Config) -> [u64; 3] {
        let margin_scale = if self.reach.is_some() { 1.0 } else { 0.5 };
        [self.reach.is_some().into(), word(config, self.reach.unwrap_or(0.0)), word(config, margin_scale)]
    }
}

/// What a query is to leave with.
pub struct Expected {
    /// Number, iterations, whether it is capped, outputs; nothing where two neighbors are equally far, or the neighbors may be another query's.
    pub outcome: Option<Vec<u64>>,
    /// Searches that it takes.
    pub searches: u64,
}

/// A coordinate that hardly any other one equals.
pub fn anywhere(random: &mut Rng) -> f32 {
    3.0 - 6.0 * random.f32()
}

impl World {
    /// Some points with such coordinates, and what is asked of them in the first run.
    pub fn random(config: &Config, coordinate: Coordinate, random: &mut Rng) -> Self {
        let Config { search, process } = config;
        let program = &process.program;
        let tree = Tree::over(coordinate, search, random);
        let types: Vec<_> = program.neighbor.words()[3..].iter().map(|word| word.ty).collect();
        let mut point = |position: &[f32; 3]| {
            let position = position.iter().map(|&coordinate| word(search, coordinate) as u32);
            let magnitude = if random.bool() { 1.0 } else { 2_f64.powi(random.i32(MAGNITUDES)) };
            let attributes = types.iter().map(|&ty| within(magnitude, random, process.format, ty));
            position.chain(attributes).collect()
        };
        let points = tree.points.iter().map(&mut point).collect();
        let asked = Asked::random(config, random);
        let interpreter = interpreter(config, &asked);
        Self { config: config.clone(), coordinate, tree, points, asked, interpreter }
    }

    /// Another run is to ask for something else.
    pub fn ask_anew(&mut self, random: &mut Rng) {
        self.asked = Asked::random(&self.config, random);
        self.interpreter = interpreter(&self.config, &self.asked);
    }

    /// A core with a neighbor cache is asked for balls instead.
    pub fn ask_for_balls(&mut self, random: &mut Rng) {
        let reach = 0.5 + 2.0 * random.f32();
        self.asked.reach = Some(reach);
        self.asked.radius2 = word(&self.config.search, (EXTENSION * reach) * (EXTENSION * reach));
    }

    /// Queries near as many places as the neighbor cache has entries, else anywhere.
    pub fn queries(&self, count: u64, random: &mut Rng) -> Vec<Vec<u64>> {
        let Config { search, process } = &self.config;
        let places: Vec<[f32; 3]> =
            (0..search.neighbor_cache).map(|_| std::array::from_fn(|_| (self.coordinate)(random))).collect();
        let types: Vec<_> = process.program.query.words()[3..].iter().map(|word| word.ty).collect();
        let query = |index| {
            let place = match places.len() {
                0 => [(); 3].map(|()| (self.coordinate)(random)),
                count => places[random.usize(..count)].map(|coordinate| coordinate + anywhere(random) / 32.0),
            };
            let position = place.map(|coordinate| word(search, coordinate));
            let words = types.iter().map(|&ty| tame(random, process.format, ty).into());
            [scene::number(process, index)].into_iter().chain(position).chain(words).collect()
        };
        (0..count).map(query).collect()
    }

    /// The neighbors of a position, and whether two of those that matter are equally far.
    fn near(&self, position: [u32; 3]) -> (Vec<usize>, bool) {
        let (search, &Asked { k, radius2, .. }) = (&self.config.search, &self.asked);
        let distance2 = |index: &usize| {
            let point = self.points[*index][..3].try_into().expect("a point has a position");
            number(search, squared_distance(search.geometry, point, position).into())
        };
        let radius2 = number(search, radius2);
        let is_near = |index: &usize| !self.tree.points[*index][0].is_nan() && distance2(index) < radius2;
        let mut near: Vec<usize> = (0..self.points.len()).filter(is_near).collect();
        near.sort_by(|a, b| distance2(a).total_cmp(&distance2(b)));
        let first = &near[..near.len().min(k as usize + 1)];
        let ties = first.windows(2).any(|pair| distance2(&pair[0]).to_bits() == distance2(&pair[1]).to_bits());
        near.truncate(k as usize);
        if search.neighbor_cache > 0 && near.len() == k as usize {
            // The last one says how far the neighborhood reaches.
            near.pop();
        }
        (near, ties)
    }

    /// Has the radius, if there is one, end at a neighbor of one of these queries, or just beyond.
    pub fn touch(&mut self, queries: &[Vec<u64>], random: &mut Rng) {
        let query = &queries[random.usize(..queries.len())];
        let position = [1, 2, 3].map(|word| query[word] as u32);
        let (near, _) = self.near(position);
        if number(&self.config.search, self.asked.radius2).is_infinite() || near.is_empty() {
            return;
        }
        let point = self.points[near[random.usize(..near.len())]][..3].try_into().expect("a point has a position");
        let distance2 = squared_distance(self.config.search.geometry, point, position);
        self.asked.radius2 = (distance2 + random.u32(..2)).into();
        let radius = number(&self.config.search, self.asked.radius2).sqrt();
        self.asked.reach = self.asked.reach.map(|_| radius / EXTENSION);
    }

    /// What a query is to leave with.
    pub fn expect(&self, query: &[u64]) -> Expected {
        let words: Vec<u32> = query[1..].iter().map(|&word| word as u32).collect();
        let (mut ties, mut searches) = (self.asked.reach.is_some(), 0);
        let outcome = self.interpreter.run(&words, |position| {
            searches += 1;
            let (near, equal) = self.near(position);
            ties |= equal;
            let farthest = near.len().saturating_sub(1);
            Neighborhood { neighbors: near.into_iter().map(|index| self.points[index].clone()).collect(), farthest }
        });
        let first = [query[0], outcome.iterations.into(), outcome.capped.into()];
        let outputs = outcome.outputs.iter().map(|&word| word.into());
        Expected { outcome: (!ties).then(|| first.into_iter().chain(outputs).collect()), searches }
    }
}

fn interpreter(Config { process, .. }: &Config, asked: &Asked) -> Interpreter {
    Interpreter::new((*process.program).clone(), process.format, asked.settings.clone(), asked.iterations_max)
}

/// Without caches, with the tree in external memory and points in a cache, and with a neighbor cache.
pub fn cores() -> [Config; 3] {
    let core = |search: search::Config, program: Program, threads, line_points| {
        let process = process::Config {
            program: Arc::new(program),
            format: search.geometry,
            index_bits: search.index_bits,
            neighbors: search.neighbors,
            threads,
            rate: 1,
            line_points,
            cache_lines: 8,
        };
        Config { search, process }
    };
    let parse = |text| Program::parse("test.pasm", text).unwrap_or_else(|error| panic!("{error}"));
    let [bare, points, tree, _] = configs();
    [
        core(bare, parse(FARTHEST), 5, 4),
        core(search::Config { point_cache: 4, neighbor_cache: 8, ..points }, parse(TAGS), 3, 1),
        core(search::Config { tree_cache: 16, neighbors: 12, ..tree }, program("mls"), 16, 8),
    ]
}
