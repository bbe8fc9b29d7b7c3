//! The programs of the library in the interpreter against operators in f64: on surfaces, a
//! line, noise, without weight, far from the origin, and with attributes that are no numbers.
//!
//! The bounds are derived step by step from the unit of rounding `u`, from the sums of magnitudes that the program adds
//! up ([`Sums`](pointcore_golden::reference::operators::weights::Sums)) and from what the result is divided by; each test says how. An iteration is compared with one
//! in f64 from the same position, so that bounds do not pile up.

mod covariance;
mod fluid;
mod normals;
mod projection;
mod smooth;
mod sphere;
mod surfaces;

use fastrand::Rng;
use glam::DVec3;
use pointcore_contract::Format;
use pointcore_contract::process::{Program, library};
use pointcore_golden::number::Number;
use pointcore_golden::process::{Interpreter, Neighborhood, Outcome};
use pointcore_golden::reference::operators::{Point, unit};

/// Formats that programs are tried in.
const FORMATS: [Format; 4] = [Format::F32, Format::F32.flushed(), Format::F24, Format::F24.flushed()];

fn random() -> Rng {
    let seed = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-golden --test process");
    Rng::with_seed(seed)
}

fn encode(format: Format, value: f64) -> u32 {
    Number::new(Format::F32, (value as f32).to_bits()).convert(format).bits()
}

fn decode(format: Format, bits: u32) -> f64 {
    Number::new(format, bits).value().into()
}

/// A vector as the format has it.
fn rounded(format: Format, vector: DVec3) -> DVec3 {
    DVec3::from_array(vector.to_array().map(|value| decode(format, encode(format, value))))
}

/// A point in a format.
trait Encoded {
    fn words(&self, format: Format) -> Vec<u32>;

    /// As the format has it.
    fn rounded(&self, format: Format) -> Self;
}

impl Encoded for Point {
    fn words(&self, format: Format) -> Vec<u32> {
        self.position.to_array().iter().chain(&self.attributes).map(|&value| encode(format, value)).collect()
    }

    fn rounded(&self, format: Format) -> Self {
        let attributes = self.attributes.iter().map(|&value| decode(format, encode(format, value))).collect();
        Self { position: rounded(format, self.position), attributes }
    }
}

/// A program in a format, with its settings.
struct Operator {
    program: Program,
    format: Format,
    settings: Vec<u32>,
}

impl Operator {
    fn new(name: &str, format: Format, settings: &[f64]) -> Self {
        let settings = settings.iter().map(|&value| encode(format, value)).collect();
        Self { program: library::program(name), format, settings }
    }

    fn setting(&self, index: usize) -> f64 {
        decode(self.format, self.settings[index])
    }

    /// The way of a query among points that all are its neighbors.
    fn outcome(&self, query: &Point, cloud: &[Point], iterations_max: u32) -> Outcome {
        // What a program does not ask of its neighbors is left out.
        let words = self.program.neighbor.len();
        let neighbors = cloud.iter().map(|point| point.words(self.format)[..words].to_vec()).collect();
        let neighborhood = Neighborhood { neighbors, farthest: 0 };
        let interpreter = Interpreter::new(self.program.clone(), self.format, self.settings.clone(), iterations_max);
        interpreter.run(&query.words(self.format), |_| neighborhood.clone())
    }

    fn run(&self, query: &Point, cloud: &[Point], iterations_max: u32) -> Outputs<'_> {
        Outputs { operator: self, outcome: self.outcome(query, cloud, iterations_max) }
    }
}

/// What left, by name.
struct Outputs<'a> {
    operator: &'a Operator,
    outcome: Outcome,
}

impl Outputs<'_> {
    fn first(&self, name: &str) -> usize {
        self.operator.program.outputs.find(name).unwrap_or_else(|| panic!("the program has an output {name}")).first
    }

    fn flag(&self, name: &str) -> bool {
        self.outcome.outputs[self.first(name)] == 1
    }

    fn number(&self, name: &str) -> f64 {
        decode(self.operator.format, self.outcome.outputs[self.first(name)])
    }

    fn vector(&self, name: &str) -> DVec3 {
        let first = self.first(name);
        let words = &self.outcome.outputs[first..first + 3];
        DVec3::from_array([0, 1, 2].map(|axis| decode(self.operator.format, words[axis])))
    }
}
