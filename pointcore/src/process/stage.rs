//! A program over queries: its settings and fields bound, carried out, and what left by name.

use super::ProcessError;
use super::attributes::{self, Bound, Whose};
use super::cloud::Cloud;
use super::engine::{Answer, Carried, Engine, Job};
use super::neighborhoods::Neighborhoods;
use super::operation::Operation;
use super::outcome::{Column, Numbers, Processed, Summary};
use super::run::{Process, Queries};
use super::scale::{Scale, sides};
use super::settings::{self, is_place};
use super::timing::Timing;
use super::words::{decode_word, encode_word};
use crate::scene::normals::oriented;
use glam::DVec3;
use pointcore_contract::Format;
use pointcore_contract::process::{Field, Program, Scalar, Type};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Where the offsets of queries come from, in words.
const PATTERN: &str = "the pattern: over the square that a point stands for";

/// The program whose normals are mollified.
const SMOOTHING: &str = "smooth";
/// How many times more neighbors they are estimated from, within twice the radius.
const MOLLIFYING: u32 = 4;

/// A program as it was run: what it read, and what left.
#[derive(Clone, Debug)]
pub struct Stage {
    /// The program.
    pub program: Arc<Program>,
    /// The format of its floats.
    pub format: Format,
    /// A word for each of the settings'.
    pub settings: Vec<u32>,
    /// The words of each query.
    pub queries: Vec<Vec<u32>>,
    /// The words of each point as a neighbor.
    pub points: Vec<Vec<u32>>,
    /// The neighbors of a position.
    pub neighborhoods: Arc<Neighborhoods>,
    /// What left.
    pub answers: Vec<Answer>,
    /// What it took, if time was counted.
    pub timing: Option<Timing>,
}

/// What the stages of a pass share.
pub(super) struct Pass<'a> {
    pub(super) process: &'a Process<'a>,
    pub(super) scale: Option<Scale>,
    pub(super) neighborhoods: &'a Arc<Neighborhoods>,
    pub(super) engine: &'a dyn Engine,
    pub(super) progress: &'a (dyn Fn(u64) + Sync),
}

/// Queries as a program takes them.
struct Asked {
    places: Vec<DVec3>,
    words: Vec<Vec<u32>>,
}

impl Pass<'_> {
    pub(super) fn stage(
        &self,
        program: &Arc<Program>,
        cloud: &mut Cloud,
        queries: &Queries,
        summary: &mut Summary,
    ) -> Result<Processed, ProcessError> {
        self.add_normals(program, cloud, summary)?;
        let cloud = &*cloud;
        let chosen = settings::settings(program, cloud, self.scale, self.process.settings)?;
        let settings = settings::encoded(program, cloud, &chosen)?;
        summary.settings.push((program.name().to_owned(), chosen));
        let (fields, bound) = self.bound(program, Whose::Neighbor, cloud, summary)?;
        let points = attributes::words(cloud, &fields, &bound.iter().collect::<Vec<_>>())?;
        let asked = self.asked(program, cloud, queries, summary)?;
        let job = Job {
            program,
            format: cloud.set.format(),
            settings: &settings,
            iterations: self.process.iterations,
            queries: &asked.words,
            points: &points,
            set: &cloud.set,
            neighborhoods: self.neighborhoods,
        };
        let Carried { answers, timing } = self.engine.run(&job, self.progress)?;
        summary.timings.extend(timing.clone());
        let Asked { places, words: queries } = asked;
        let neighborhoods = Arc::clone(self.neighborhoods);
        let format = cloud.set.format();
        let program = Arc::clone(program);
        let stage = Stage { program, format, settings, queries, points, neighborhoods, answers, timing };
        Ok(named(cloud, places, stage, summary.clone()))
    }

    /// Estimates normals that a program reads and the points do not have.
    fn add_normals(&self, program: &Program, cloud: &mut Cloud, summary: &mut Summary) -> Result<(), ProcessError> {
        let reads = |field: &Field| field.name == "normal" && field.ty == Type::Float3;
        let is_read = program.neighbor.fields().iter().chain(program.query.fields()).any(reads);
        if !is_read || cloud.normals.is_some() || self.process.attributes.contains_key("normal") {
            return Ok(());
        }
        let operation = Operation::named("normals")?;
        let none = BTreeMap::new();
        let process = Process {
            operation: &operation,
            iterations: 1,
            passes: 1,
            settings: &none,
            attributes: &none,
            ..*self.process
        };
        // Normals by which points are smoothed are mollified: those of the noise would keep it (Jones, Durand and Desbrun 2003).
        let is_smoothing = program.name() == SMOOTHING;
        let wide = if is_smoothing { MOLLIFYING * process.k } else { process.k }.min(super::NEIGHBORS_LIMIT);
        let radius = process.radius.map(|radius| if is_smoothing { 2.0 * radius } else { radius });
        let neighborhoods = Arc::new(Neighborhoods::new(&cloud.set, wide, radius)?);
        let scale = Scale::of(&cloud.set, wide, radius);
        let pass = Pass { process: &process, scale, neighborhoods: &neighborhoods, ..*self };
        let all = Queries::Points((0..cloud.len()).collect());
        let found = pass.stage(&operation.stages()[0], cloud, &all, &mut process.summary(cloud, self.engine))?;
        summary.timings.extend(found.summary.timings.iter().cloned());
        let column = found.column("normal").expect("the program `normals` has them");
        let component = |axis: usize, index: usize| column.numbers[axis].number(index);
        let normals: Vec<DVec3> =
            (0..cloud.len()).map(|index| DVec3::from_array([0, 1, 2].map(|axis| component(axis, index)))).collect();
        let (normals, side) = match cloud.sensor {
            Some(_) => (normals, "towards the sensor"),
            None => (oriented(cloud.set.given(), &normals), "turned so that neighbors agree"),
        };
        cloud.normals = Some(normals);
        cloud.normals_from = format!("estimated by `normals` from {wide} neighbors, {side}");
        Ok(())
    }

    fn bound<'p>(
        &self,
        program: &'p Program,
        whose: Whose,
        cloud: &Cloud,
        summary: &mut Summary,
    ) -> Result<(Vec<&'p Field>, Vec<Bound>), ProcessError> {
        let layout = if whose == Whose::Query { &program.query } else { &program.neighbor };
        let fields: Vec<&Field> = layout.fields().iter().skip(1).collect();
        let given = self.process.attributes;
        let bind = |field: &&Field| attributes::bind(program, whose, field, cloud, self.scale, given);
        let bound = fields.iter().map(bind).collect::<Result<Vec<_>, _>>()?;
        bound.iter().for_each(|bound| summary.note(bound));
        Ok((fields, bound))
    }

    fn asked(
        &self,
        program: &Program,
        cloud: &Cloud,
        queries: &Queries,
        summary: &mut Summary,
    ) -> Result<Asked, ProcessError> {
        let given = cloud.set.given();
        match queries {
            Queries::Points(chosen) => {
                let (fields, bound) = self.bound(program, Whose::Query, cloud, summary)?;
                let words = attributes::words(cloud, &fields, &bound.iter().collect::<Vec<_>>())?;
                let (places, words) = chosen.iter().map(|&index| (given[index], words[index].clone())).unzip();
                Ok(Asked { places, words })
            }
            Queries::Cloud(others) => {
                // They are rounded as the points are, relative to the same origin.
                let (fields, bound) = self.bound(program, Whose::Query, others, summary)?;
                let mut words = attributes::words(others, &fields, &bound.iter().collect::<Vec<_>>())?;
                for (words, place) in words.iter_mut().zip(others.set.given()) {
                    words[..3].copy_from_slice(&position(cloud, *place)?);
                }
                Ok(Asked { places: others.set.given().to_vec(), words })
            }
            Queries::Places(places) => {
                let no_points = Cloud { normals: None, columns: BTreeMap::new(), ..cloud.clone() };
                let mut tail = vec![];
                for field in program.query.fields().iter().skip(1) {
                    let given = self.process.attributes;
                    let bound = attributes::bind(program, Whose::Query, field, &no_points, None, given)?;
                    for value in &bound.values[0] {
                        tail.push(encode_word(cloud.set.format(), field.ty.scalar(), *value).map_err(|problem| {
                            let (program, name) = (program.name().to_owned(), field.name.clone());
                            ProcessError::Value { what: "attribute", program, name, problem }
                        })?);
                    }
                }
                let words = |place: &DVec3| Ok([&position(cloud, *place)?[..], &tail].concat());
                let words = places.iter().map(words).collect::<Result<_, ProcessError>>()?;
                Ok(Asked { places: places.clone(), words })
            }
            Queries::Pattern { points, sides } => self.pattern(program, cloud, points, *sides, summary),
        }
    }

    /// Around each point so many columns and rows, spread evenly over the square about the circle about the one that it stands for:
    /// neighbors' squares are turned as they come, and are to leave no gap.
    fn pattern(
        &self,
        program: &Program,
        cloud: &Cloud,
        points: &[usize],
        [columns, rows]: [u32; 2],
        summary: &mut Summary,
    ) -> Result<Asked, ProcessError> {
        let sides = sides(cloud.set.given(), self.process.k);
        let offset = |place: u32, count: u32| -> Vec<f64> {
            let share = (f64::from(place) + 0.5) / f64::from(count) - 0.5;
            sides.iter().map(|side| std::f64::consts::SQRT_2 * side * share).collect()
        };
        let mut asked = Asked { places: vec![], words: vec![] };
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let mut own = cloud.clone();
            own.insert("u", offset(column, columns), PATTERN);
            own.insert("v", offset(row, rows), PATTERN);
            let Asked { places, words } = self.asked(program, &own, &Queries::Points(points.to_vec()), summary)?;
            asked.places.extend(places);
            asked.words.extend(words);
        }
        Ok(asked)
    }
}

/// A place in the words of the points' format.
fn position(cloud: &Cloud, place: DVec3) -> Result<[u32; 3], ProcessError> {
    let format = cloud.set.format();
    let mut words = [0; 3];
    for (word, value) in words.iter_mut().zip(cloud.set.rounded(place)) {
        *word = encode_word(format, Scalar::Float, value.into()).map_err(|problem| ProcessError::Value {
            what: "query",
            program: cloud.name.clone(),
            name: "position".to_owned(),
            problem,
        })?;
    }
    Ok(words)
}

/// What left, by name, places in the coordinates of the points.
fn named(cloud: &Cloud, places: Vec<DVec3>, stage: Stage, mut summary: Summary) -> Processed {
    let Stage { program, format, answers, .. } = &stage;
    let mut columns = vec![];
    for field in program.outputs.fields() {
        let first = program.outputs.find(&field.name).expect("a layout finds its fields").first;
        let part = |axis: usize| {
            let origin = if is_place(&field.name) { cloud.set.origin()[axis] } else { 0.0 };
            numbers(*format, field, origin, answers.iter().map(|answer| answer.outputs[first + axis]))
        };
        let parts = match field.ty {
            Type::Float3 => ["x", "y", "z"].map(|axis| format!("{}_{axis}", field.name)).to_vec(),
            _ => vec![field.name.clone()],
        };
        columns.push(Column { name: field.name.clone(), parts, numbers: (0..field.ty.words()).map(part).collect() });
    }
    summary.queries = answers.len();
    summary.iterations = answers.iter().map(|answer| u64::from(answer.iterations)).sum();
    summary.iterations_max = answers.iter().map(|answer| answer.iterations).max().unwrap_or_default();
    summary.capped = answers.iter().filter(|answer| answer.capped).count();
    let counted: Option<Vec<u32>> = answers.iter().map(|answer| answer.neighbors).collect();
    summary.neighbors = counted.as_ref().map(|counts| counts.iter().copied().map(u64::from).sum());
    summary.lonely = counted.map(|counts| counts.iter().filter(|count| **count == 0).count());
    let column = |name: &str| columns.iter().find(|column| column.name == name);
    summary.invalid = column("valid").map(|valid| match &valid.numbers[0] {
        Numbers::Bool(flags) => flags.iter().filter(|flag| !**flag).count(),
        _ => 0,
    });
    let places = match column("position") {
        Some(Column { numbers, .. }) if numbers.len() == 3 => {
            let place = |index: usize| DVec3::from_array([0, 1, 2].map(|axis| numbers[axis].number(index)));
            (0..answers.len()).map(place).collect()
        }
        _ => places,
    };
    Processed { columns, places, stages: vec![stage], summary }
}

fn numbers(format: Format, field: &Field, origin: f64, words: impl Iterator<Item = u32>) -> Numbers {
    match field.ty.scalar() {
        Scalar::Float if is_place(&field.name) => {
            Numbers::Double(words.map(|word| decode_word(format, Scalar::Float, word) + origin).collect())
        }
        Scalar::Float => Numbers::Float(words.map(|word| decode_word(format, Scalar::Float, word) as f32).collect()),
        Scalar::Int => Numbers::Int(words.map(|word| word as i32).collect()),
        Scalar::Bool => Numbers::Bool(words.map(|word| word == 1).collect()),
    }
}
