//! The host and the search around the neighbor cache: queries near each other and by a hair covered, searches that answer out of
//! order.

use std::ops::RangeInclusive;

use pointcore_contract::search::Config;

use super::environment::{Feeds, Rule};
use super::memory::Memory;
use super::{number, safety, word};

/// Queries of a phase; between phases settings and points change.
pub const QUERIES: usize = 100;
/// Powers of two within which the distances of a phase lie.
const SIZES: RangeInclusive<i32> = -30..=30;
/// Bits of a mantissa that differ at least among points that are far away.
const NEAR_BITS: i32 = 7;
/// How much farther than a ball query asks its neighborhood reaches.
const EXTENSION: f32 = 1.3;

/// Bits of an index.
pub const INDEX_BITS: u32 = 10;
/// What spreads places over all indices, and what gathers them again: their product ends with a one and as many zeros.
const SPREAD: u64 = 409;
const GATHER: u64 = 681;

pub type Point = [f32; 3];

/// What the host asks for in a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Nearest neighbors, exactly.
    Nearest,
    /// Nearest neighbors within a radius, which no cache can promise to answer exactly.
    NearestWithin(f32),
    /// All within a radius.
    Ball,
}

/// Many points and few in every mode.
pub const PHASES: [(Mode, bool); 5] = [
    (Mode::Nearest, true),
    (Mode::Ball, true),
    (Mode::Nearest, false),
    (Mode::Ball, false),
    (Mode::NearestWithin(0.75), true),
];

/// Most cycles between the queries of each phase: with none, many wait for one neighborhood.
const PAUSES: [u32; PHASES.len()] = [100, 0, 20, 0, 100];

/// Most cycles before searches are answered in a phase: with none, many neighborhoods come within the time that one takes to be
/// judged.
const LONGEST: [u32; 3] = [0, 10, 50];

/// Index and squared distance of a neighbor.
pub type Neighbor = (u64, f32);

/// A query, and what came of it.
#[derive(Clone, Debug)]
pub struct Query {
    /// When it was asked.
    pub phase: usize,
    /// Neighbors wanted.
    pub wanted: usize,
    /// The squared radius within which they count.
    pub radius2: f32,
    /// Where it is.
    pub point: Point,
    /// The radius within which a neighborhood must be complete to be reused.
    pub reach: f32,
    /// The neighbors that came.
    pub answer: Vec<Neighbor>,
    /// They came from the cache.
    pub cached: bool,
    /// All of them came.
    pub closed: bool,
}

/// The host and the search.
#[derive(Clone)]
pub struct Surroundings {
    config: Config,
    /// Points of each phase so far.
    pub clouds: Vec<Vec<Point>>,
    /// Where queries come from next, as many as there are entries.
    places: Vec<Point>,
    /// The k that the host sends.
    wanted: usize,
    /// Most cycles between queries.
    pause: u32,
    /// Where points are, and how far apart.
    center: Point,
    size: f32,
    /// Most cycles before a search is answered.
    longest: u32,
    /// Factors of the distance to the farthest neighbor, and of what is left of it.
    scales: [f32; 2],
    /// The queries so far, and how many of them are answered.
    pub queries: Vec<Query>,
    pub closed: usize,
    searches: Memory,
}

fn random_point(random: &mut fastrand::Rng, size: f32) -> Point {
    std::array::from_fn(|_| (random.f32() * 2.0 - 1.0) * size)
}

/// The number that the format holds in its place.
fn held(config: &Config, value: f32) -> f32 {
    number(config, word(config, value))
}

/// The index that a point or a query has by its place, in all of its bits.
const fn index(place: usize) -> u64 {
    place as u64 * SPREAD % (1 << INDEX_BITS)
}

/// The place that has an index.
pub const fn place(index: u64) -> usize {
    (index * GATHER % (1 << INDEX_BITS)) as usize
}

pub fn distance2(config: &Config, a: Point, b: Point) -> f32 {
    let [x, y, z] = std::array::from_fn(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis]));
    held(config, x + y + z)
}

/// Up to `k` points nearer than the radius, nearest first.
pub fn nearest(config: &Config, cloud: &[Point], point: Point, k: usize, radius2: f32) -> Vec<Neighbor> {
    let distance2 = |&other: &Point| distance2(config, other, point);
    let mut near: Vec<_> = cloud.iter().enumerate().map(|(place, other)| (index(place), distance2(other))).collect();
    near.retain(|(_, distance2)| *distance2 < radius2);
    near.sort_by(|a, b| a.1.total_cmp(&b.1));
    near.truncate(k);
    near
}

/// Sends the results of a search, after a while.
fn answer(config: &Config, cloud: &[Point], longest: u32, feeds: &mut Feeds, search: &[u64]) {
    let &[ticket, k, radius2, x, y, z] = search else { panic!("a search has six fields") };
    let point = [x, y, z].map(|word| number(config, word));
    let found = nearest(config, cloud, point, k as usize, number(config, radius2));
    let mut delay = feeds.random.u32(..=longest);
    for (rank, &(index, distance2)) in (1..).zip(&found) {
        let last = u64::from(rank == found.len());
        feeds.feed_after(std::mem::take(&mut delay), "found", vec![ticket, last, 1, index, word(config, distance2)]);
    }
    if found.is_empty() {
        feeds.feed_after(delay, "found", vec![ticket, 1, 0, 0, radius2]);
    }
}

impl Surroundings {
    /// Before the first query.
    pub fn begin(config: &Config, feeds: &mut Feeds) -> Self {
        let mut surroundings = Self {
            config: config.clone(),
            clouds: vec![],
            places: vec![],
            wanted: 0,
            pause: 0,
            center: [0.0; 3],
            size: 1.0,
            longest: 0,
            scales: [0.0; 2],
            queries: vec![],
            closed: 0,
            searches: Memory::default(),
        };
        surroundings.set_up(feeds);
        surroundings
    }

    fn mode(&self) -> Mode {
        PHASES[self.clouds.len() - 1].0
    }

    /// A point that is so far from where points are.
    fn around(&self, offset: Point) -> Point {
        std::array::from_fn(|axis| held(&self.config, self.center[axis] + offset[axis]))
    }

    /// Changes to the next phase.
    fn set_up(&mut self, feeds: &mut Feeds) {
        let Some(&(mode, many)) = PHASES.get(self.clouds.len()) else { return };
        self.pause = PAUSES[self.clouds.len()];
        self.longest = LONGEST[feeds.random.usize(..LONGEST.len())];
        let neighbors = self.config.neighbors as usize;
        let count = if many { 40 } else { feeds.random.usize(..neighbors) };
        self.size = 2.0_f32.powi(feeds.random.i32(SIZES));
        // Far away, the last bits of coordinates are what tells queries from each other.
        let farthest = 2.0_f32.powi(self.config.geometry.mantissa as i32 - NEAR_BITS);
        let away = self.size * [0.0, 0.0, farthest * feeds.random.f32(), farthest][feeds.random.usize(..4)];
        self.center = random_point(&mut feeds.random, away);
        let cloud: Vec<_> = (0..count).map(|_| random_point(&mut feeds.random, self.size)).collect();
        self.clouds.push(cloud.into_iter().map(|point| self.around(point)).collect());
        // Next to zero, queries differ from each other in all bits of their distance.
        let places = (0..self.config.neighbor_cache).map(|_| {
            let size = [1.0, 1.0, 0.01, 0.0][feeds.random.usize(..4)];
            random_point(&mut feeds.random, size * self.size)
        });
        let places: Vec<_> = places.collect();
        self.places = places.into_iter().map(|point| self.around(point)).collect();
        self.wanted = if !many || feeds.random.bool() { neighbors } else { feeds.random.usize(2..=neighbors) };
        let safety = safety(&self.config);
        let (ball, far_scale, margin_scale) = match mode {
            Mode::Nearest => (0, safety, 0.5),
            Mode::NearestWithin(_) => (0, 1.5, 1.0 / 2.5),
            Mode::Ball => (1, safety, 1.0),
        };
        // Smaller ones promise less.
        let somewhat_less = |scale: f32| held(&self.config, scale * (1.0 - feeds.random.f32() / 16.0));
        self.scales = [far_scale, margin_scale].map(somewhat_less);
        let scales = self.scales.map(|scale| word(&self.config, scale));
        feeds.feed("setup", vec![ball, scales[0], scales[1]]);
    }

    /// About how far the neighborhood of a query reaches.
    fn cover(&self, query: &Query) -> f32 {
        let cloud = &self.clouds[query.phase];
        let near = nearest(&self.config, cloud, query.point, query.wanted, query.radius2);
        let distance2 = |place: usize| near.get(place).map_or(0.0, |(_, distance2)| *distance2);
        let last_but = |less: usize| near.len().checked_sub(less).map_or(0.0, distance2);
        let [far2, near2] = match query.wanted - near.len() {
            0 => [last_but(1), last_but(2)],
            1 => [query.radius2, last_but(1)],
            _ => [query.radius2; 2],
        };
        let near2 = if self.mode() == Mode::Ball { 0.0 } else { near2 };
        far2.sqrt() * self.scales[0] - near2.sqrt()
    }

    /// A query that a neighborhood covers or not by a hair: its point, or the radius within which it must be complete.
    fn by_a_hair(&self, random: &mut fastrand::Rng) -> Option<(Point, f32)> {
        let phase = self.clouds.len() - 1;
        let searched = |query: &&Query| query.phase == phase && query.closed && !query.cached;
        let latest: Vec<_> = self.queries.iter().rev().filter(searched).take(self.places.len()).collect();
        let query = latest.get(random.usize(..latest.len().max(1)))?;
        let cover = self.cover(query);
        let mantissa = self.config.geometry.mantissa as i32;
        let hair = 0.5_f32.powi(random.i32(2..mantissa + 2));
        let nearly = 1.0 + [-hair, 0.0, hair][random.usize(..3)];
        if self.mode() == Mode::Ball && random.bool() {
            return Some((query.point, cover * nearly));
        }
        let reach = if self.mode() == Mode::Ball { cover * random.f32() } else { 0.0 };
        let margin = (cover - reach) * self.scales[1];
        let direction = match random.u8(..2) {
            0 => [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]][random.usize(..3)],
            _ => {
                let [x, y, z] = random_point(random, 1.0);
                let length = (x * x + y * y + z * z).sqrt();
                [x, y, z].map(|part| part / length)
            }
        };
        Some((std::array::from_fn(|axis| query.point[axis] + direction[axis] * margin * nearly), reach))
    }

    /// Asks for the neighbors of a point near one of the places.
    fn ask(&mut self, feeds: &mut Feeds) {
        if self.queries.len() == self.clouds.len() * QUERIES {
            return;
        }
        let random = &mut feeds.random;
        let by_a_hair = if random.u8(..3) == 0 { self.by_a_hair(random) } else { None };
        let by_a_hair = by_a_hair.filter(|(point, reach)| {
            let mut offsets = (0..3).map(|axis| point[axis] - self.center[axis]).chain([*reach]);
            offsets.all(|offset| offset.abs() < 2.0 * self.size)
        });
        let size = [0.0, 0.001, 0.02, 0.2][random.usize(..4)];
        let step = random_point(random, size * self.size);
        // Without pauses so many come from a place that not all of them find room to wait.
        let places = if self.pause == 0 { self.places.len().min(2) } else { self.places.len() };
        let place = random.usize(..places);
        let beside = std::array::from_fn(|axis| self.places[place][axis] + step[axis]);
        let point = by_a_hair.map_or(beside, |(point, _)| point).map(|part| held(&self.config, part));
        self.places[place] = point;
        let (radius2, reach) = match self.mode() {
            Mode::Nearest => (f32::INFINITY, 0.0),
            Mode::NearestWithin(radius) => (self.size * self.size * (radius * radius), 0.0),
            Mode::Ball => {
                let reach = self.size * [0.125, 0.375, 0.875][random.usize(..3)];
                let reach = by_a_hair.map_or(reach, |(_, reach)| held(&self.config, reach));
                (held(&self.config, (EXTENSION * reach) * (EXTENSION * reach)), reach)
            }
        };
        let word = |value| word(&self.config, value);
        let mut item = vec![index(self.queries.len()), self.wanted as u64, word(radius2)];
        item.extend(point.map(word));
        item.push(word(reach));
        let pause = feeds.random.u32(..=self.pause);
        feeds.feed_after(pause, "query", item);
        let phase = self.clouds.len() - 1;
        let wanted = self.wanted;
        self.queries.push(Query { phase, wanted, radius2, point, reach, answer: vec![], cached: false, closed: false });
    }

    fn result(&mut self, feeds: &mut Feeds, fields: &[u64]) {
        let &[query, last, found, index, distance2, cached] = fields else { panic!("a result has six fields") };
        let query = &mut self.queries[place(query)];
        assert!(!query.closed, "a result after the last: {query:?}");
        assert!(query.answer.is_empty() || query.cached == (cached == 1), "{query:?}");
        query.cached = cached == 1;
        if found == 1 {
            query.answer.push((index, number(&self.config, distance2)));
        }
        if last == 1 {
            query.closed = true;
            self.closed += 1;
            if self.closed == self.clouds.len() * QUERIES {
                self.set_up(feeds);
            } else {
                self.ask(feeds);
            }
        }
    }
}

impl Rule for Surroundings {
    const SEEDS: u64 = 45;

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "setup" => {
                let under_way = [1, 5, 20, QUERIES][feeds.random.usize(..4)];
                (0..under_way).for_each(|_| self.ask(feeds));
            }
            "search" => {
                let Self { config, clouds, searches, longest, .. } = self;
                searches.request(feeds, fields, |feeds, search| {
                    answer(config, &clouds[clouds.len() - 1], *longest, feeds, search)
                });
            }
            "found" if fields[1] == 1 => {
                let Self { config, clouds, searches, longest, .. } = self;
                searches.answered(feeds, |feeds, search| {
                    answer(config, &clouds[clouds.len() - 1], *longest, feeds, search)
                });
            }
            "result" => self.result(feeds, fields),
            _ => {}
        }
    }
}
