//! Many cases, on all cores, and what they add up to.

use super::case::Case;
use super::check::{BrokenProperty, Findings, Property, check};
use super::compare::{MethodOutcome, compare};
use super::families::{LEVELS, case};
use super::family::Family;
use super::hardware::Units;
use super::methods::Method;
use super::shrink::shrink;
use pointcore_contract::Format;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// One case in so many is compared with the other methods.
const COMPARED_ONE_IN: u64 = 8;
/// Cases that one task checks.
const CHUNK: u64 = 2048;

/// What to run.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Cases of each format.
    pub cases: u64,
    /// Where they begin.
    pub seed: u64,
    /// No case is begun after that time; what was done until then counts.
    pub budget: Option<Duration>,
}

/// Sums over the cases of one family and severity.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Cell {
    /// Cases.
    pub cases: u64,
    /// Samples checked.
    pub samples: u64,
    /// Of these, samples about which rounding leaves nothing to say.
    pub undetermined: u64,
    /// The largest error of a `ρ²` as a share of its bound.
    pub used: f64,
    /// Cases compared with other methods.
    pub compared: u64,
    /// How each of [`Method::ALL`] did.
    pub methods: [MethodSums; Method::ALL.len()],
}

/// Sums over the compared cases.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct MethodSums {
    /// Cases in which it failed.
    pub failures: u64,
    /// Samples inside their splats.
    pub inside: u64,
    /// Their squared errors of `ρ²`.
    pub squared_error: f64,
    /// Samples it visits.
    pub visited: u64,
}

impl Cell {
    fn note(&mut self, findings: &Findings) {
        self.cases += 1;
        self.samples += u64::from(findings.samples);
        self.undetermined += u64::from(findings.undetermined);
        self.used = self.used.max(findings.used);
    }

    fn compare(&mut self, outcomes: &[MethodOutcome]) {
        self.compared += 1;
        for (sums, outcome) in self.methods.iter_mut().zip(outcomes) {
            sums.failures += u64::from(outcome.failed);
            sums.inside += u64::from(outcome.inside);
            sums.squared_error += outcome.squared_error;
            sums.visited += outcome.visited;
        }
    }

    /// Both.
    pub fn add(&mut self, other: &Self) {
        self.cases += other.cases;
        self.samples += other.samples;
        self.undetermined += other.undetermined;
        self.used = self.used.max(other.used);
        self.compared += other.compared;
        for (sums, others) in self.methods.iter_mut().zip(&other.methods) {
            sums.failures += others.failures;
            sums.inside += others.inside;
            sums.squared_error += others.squared_error;
            sums.visited += others.visited;
        }
    }
}

/// A property that did not hold.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Count {
    /// Cases.
    pub cases: u64,
    /// The first one.
    #[serde(skip)]
    pub first: Option<u64>,
    /// The worst one's measure.
    pub worst: f64,
}

impl Count {
    fn note(&mut self, index: u64, excess: f64) {
        self.cases += 1;
        self.first = Some(self.first.map_or(index, |first| first.min(index)));
        self.worst = self.worst.max(excess);
    }

    fn add(&mut self, other: &Self) {
        self.cases += other.cases;
        self.first = [self.first, other.first].into_iter().flatten().min();
        self.worst = self.worst.max(other.worst);
    }
}

/// The smallest case found in which a property does not hold.
#[derive(Clone, Debug, Serialize)]
pub struct Example {
    /// Number format.
    pub format: Format,
    /// What does not hold, and where.
    pub violation: BrokenProperty,
    /// Where it came from.
    pub family: Family,
    /// See there.
    pub level: u8,
    /// Whether with screen filter.
    pub filter: bool,
    /// Centre and tangents in camera space; as text, since not all are numbers.
    pub numbers: [String; 9],
    /// Attributes, encoded.
    pub attributes: Vec<u32>,
    /// The camera.
    pub lens: super::case::Lens,
}

/// What the cases of one format add up to.
#[derive(Clone, Debug)]
pub struct Sums {
    /// Number format.
    pub format: Format,
    /// By family, then by severity.
    pub cells: Vec<[Cell; LEVELS as usize]>,
    /// What did not hold.
    pub violations: BTreeMap<(Property, Family), Count>,
    /// A small example of each property that did not hold.
    pub examples: Vec<Example>,
}

impl Sums {
    fn new(format: Format) -> Self {
        let cells = vec![[Cell::default(); LEVELS as usize]; Family::ALL.len()];
        Self { format, cells, violations: BTreeMap::new(), examples: Vec::new() }
    }

    fn add(mut self, other: Self) -> Self {
        for (cells, others) in self.cells.iter_mut().flatten().zip(other.cells.iter().flatten()) {
            cells.add(others);
        }
        for (key, count) in &other.violations {
            self.violations.entry(*key).or_default().add(count);
        }
        self
    }

    /// Cases in which a property did not hold.
    #[must_use]
    pub fn violated(&self, property: Property) -> u64 {
        self.violations.iter().filter(|((other, _), _)| *other == property).map(|(_, count)| count.cases).sum()
    }

    /// All cells of a family.
    #[must_use]
    pub fn family(&self, family: Family) -> Cell {
        let place = Family::ALL.iter().position(|other| *other == family).expect("every family is listed");
        let mut sum = Cell::default();
        self.cells[place].iter().for_each(|cell| sum.add(cell));
        sum
    }
}

/// The case of an index, and the seed of its samples.
fn indexed(format: Format, seed: u64, index: u64) -> (usize, u8, Case, u64) {
    let families = Family::ALL.len() as u64;
    let family = (index % families) as usize;
    let level = ((index / families) % u64::from(LEVELS)) as u8;
    let seed = (seed << 40) ^ index;
    (family, level, case(Family::ALL[family], level, format, seed), !seed)
}

/// Runs the cases of one format; `progress` hears how many are done.
#[must_use]
pub fn run(format: Format, settings: Settings, progress: &(dyn Fn(u64) + Sync)) -> Sums {
    let Settings { cases, seed, budget } = settings;
    let started = Instant::now();
    let done = AtomicU64::new(0);
    let chunks = cases.div_ceil(CHUNK);
    let sums = (0..chunks).into_par_iter().map(|chunk| {
        let mut sums = Sums::new(format);
        if budget.is_some_and(|budget| started.elapsed() > budget) {
            return sums;
        }
        let units = Units::new(format);
        let indices = chunk * CHUNK..((chunk + 1) * CHUNK).min(cases);
        let count = indices.end - indices.start;
        for index in indices {
            one(&units, seed, index, &mut sums);
        }
        progress(done.fetch_add(count, Ordering::Relaxed) + count);
        sums
    });
    let mut sums = sums.reduce(|| Sums::new(format), Sums::add);
    sums.examples = examples(&sums, seed);
    sums
}

fn one(units: &Units, seed: u64, index: u64, sums: &mut Sums) {
    let (family, level, case, samples) = indexed(sums.format, seed, index);
    let cell = &mut sums.cells[family][usize::from(level)];
    let findings = check(units, &case, samples);
    cell.note(&findings);
    for violation in &findings.violations {
        let key = (violation.property, case.family);
        sums.violations.entry(key).or_default().note(index, violation.excess);
    }
    // Families and severities take turns; counting rounds compares as many of each.
    if (index / (Family::ALL.len() as u64 * u64::from(LEVELS))).is_multiple_of(COMPARED_ONE_IN)
        && let Some(outcomes) = compare(units, &case, samples)
    {
        cell.compare(&outcomes);
    }
}

/// The first case of each violated property and family, made small; of each property the one with the fewest digits.
fn examples(sums: &Sums, seed: u64) -> Vec<Example> {
    let units = Units::new(sums.format);
    let shrunk = sums.violations.iter().filter_map(|((property, _), count)| {
        let (_, _, case, samples) = indexed(sums.format, seed, count.first?);
        let (case, violation) = shrink(&units, &case, samples, *property)?;
        let numbers = case.numbers().map(|number| format!("{number:e}"));
        let attributes = case.splat.attributes[..6].to_vec();
        let Case { family, level, format, lens, filter, .. } = case;
        Some(Example { format, violation, family, level, filter: filter.is_on(), numbers, attributes, lens })
    });
    let mut smallest: BTreeMap<Property, Example> = BTreeMap::new();
    for example in shrunk {
        let digits = |example: &Example| example.numbers.iter().map(String::len).sum::<usize>();
        let known = smallest.get(&example.violation.property);
        if known.is_none_or(|known| digits(&example) < digits(known)) {
            smallest.insert(example.violation.property, example);
        }
    }
    smallest.into_values().collect()
}
