//! Fields of queries and neighbors, bound to attributes of the points by their names.

use super::ProcessError;
use super::cloud::Cloud;
use super::operation::Operation;
use super::scale::Scale;
use super::settings::REST_DENSITY;
use super::words::encode_word;
use glam::DVec3;
use pointcore_contract::process::{Field, Program, Type};
use std::collections::BTreeMap;

/// Numbers of each point for a field.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The field's name.
    pub name: String,
    /// Where they come from, in words.
    pub from: String,
    /// Those of each point.
    pub values: Vec<Vec<f64>>,
}

/// Whose fields are bound.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Whose {
    /// Queries carry them.
    Query,
    /// Neighbors have them.
    Neighbor,
}

impl Whose {
    const fn name(self) -> &'static str {
        match self {
            Self::Query => "query",
            Self::Neighbor => "neighbor",
        }
    }
}

/// Checks that every name is a field's of the operation, and of one that no program of it finds.
pub fn check_names(operation: &Operation, given: &BTreeMap<String, Vec<f64>>) -> Result<(), ProcessError> {
    given.keys().try_for_each(|name| operation.field(name).map(drop))
}

/// Numbers for a field besides the position.
///
/// In this order: what the user gives all points, the points' own attribute of the name, what is estimated.
pub fn bind(
    program: &Program,
    whose: Whose,
    field: &Field,
    cloud: &Cloud,
    scale: Option<Scale>,
    given: &BTreeMap<String, Vec<f64>>,
) -> Result<Bound, ProcessError> {
    let bound = |from: String, values| Ok(Bound { name: field.name.clone(), from, values });
    let all = |value: Vec<f64>| vec![value; cloud.len()];
    if let Some(value) = given.get(&field.name) {
        return bound("given".to_owned(), all(constant(program, field, value)?));
    }
    if let ("normal", Type::Float3, Some(normals)) = (field.name.as_str(), field.ty, &cloud.normals) {
        let values = normals.iter().map(|normal| normal.to_array().to_vec()).collect();
        return bound(cloud.normals_from.clone(), values);
    }
    if let Some(names) =
        columns(field).into_iter().find(|names| names.iter().all(|name| cloud.columns.contains_key(name)))
    {
        let columns: Vec<&Vec<f64>> = names.iter().map(|name| &cloud.columns[name]).collect();
        let values = (0..cloud.len()).map(|index| columns.iter().map(|column| column[index]).collect()).collect();
        let from = names.first().and_then(|name| cloud.sources.get(name)).cloned();
        return bound(from.unwrap_or_else(|| format!("{} of the points", names.join(", "))), values);
    }
    match (field.name.as_str(), field.ty, scale) {
        ("area", Type::Float, Some(scale)) => {
            bound("estimated: πr²/k of the disc that k neighbors take".to_owned(), all(vec![scale.side * scale.side]))
        }
        ("mass", Type::Float, Some(scale)) => {
            let from = "estimated: the rest density in a cube to the nearest particle".to_owned();
            bound(from, all(vec![REST_DENSITY * scale.nearest.powi(3)]))
        }
        ("velocity", Type::Float3, _) => bound("at rest".to_owned(), all(vec![0.0; 3])),
        _ => Err(missing(program, whose, field, cloud)),
    }
}

/// What is given to all points; a normal is made one of length 1, as those of points are.
fn constant(program: &Program, field: &Field, value: &[f64]) -> Result<Vec<f64>, ProcessError> {
    let wrong = |problem: String| {
        let (program, name) = (program.name().to_owned(), field.name.clone());
        ProcessError::Value { what: "attribute", program, name, problem }
    };
    if value.len() != field.ty.words() {
        return Err(wrong(format!("has {} numbers: expected {} for a {}", value.len(), field.ty.words(), field.ty)));
    }
    if (field.name.as_str(), field.ty) != ("normal", Type::Float3) {
        return Ok(value.to_vec());
    }
    let unit = DVec3::from_slice(value).try_normalize();
    unit.map(|normal| normal.to_array().to_vec()).ok_or_else(|| wrong(format!("is {value:?}: expected a direction")))
}

/// The words of each point: its position and its fields.
pub fn words(cloud: &Cloud, fields: &[&Field], bound: &[&Bound]) -> Result<Vec<Vec<u32>>, ProcessError> {
    let format = cloud.set.format();
    let point = |(index, position): (usize, [u32; 3])| {
        let mut words = position.to_vec();
        for (field, bound) in fields.iter().zip(bound) {
            for value in &bound.values[index] {
                let word = encode_word(format, field.ty.scalar(), *value);
                words.push(word.map_err(|problem| ProcessError::Attribute {
                    points: cloud.name.clone(),
                    name: field.name.clone(),
                    index: cloud.places[index],
                    problem,
                })?);
            }
        }
        Ok(words)
    };
    cloud.set.encoded().into_iter().enumerate().map(point).collect()
}

/// Names that the columns of a field may have, those of one spelling together.
fn columns(field: &Field) -> Vec<Vec<String>> {
    if field.ty != Type::Float3 {
        return vec![vec![field.name.clone()]];
    }
    let spelled =
        |prefix: &str, separator: &str| ["x", "y", "z"].map(|axis| format!("{prefix}{separator}{axis}")).to_vec();
    let initial = field.name.get(..1).unwrap_or_default();
    vec![spelled(&field.name, "_"), spelled(&field.name, "."), spelled(&field.name, ""), spelled(initial, "")]
}

/// The columns that a field may have, in words.
pub fn spelled(field: &Field) -> String {
    let spelled: Vec<String> = columns(field).iter().map(|names| names.join(", ")).collect();
    format!("{} {}", if field.ty == Type::Float3 { "columns" } else { "column" }, spelled.join(" or "))
}

fn missing(program: &Program, whose: Whose, field: &Field, cloud: &Cloud) -> ProcessError {
    let (points, program) = (cloud.name.clone(), program.name().to_owned());
    ProcessError::MissingAttribute { points, program, whose: whose.name(), field: field.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::{Interpreted, Process, ProcessError, Processed, Queries, process};
    use pointcore_contract::Format;

    type Given = BTreeMap<String, Vec<f64>>;

    fn run(name: &str, queries: &Queries, attributes: &[(&str, &[f64])]) -> Result<Processed, ProcessError> {
        let points = (0..64).map(|i| DVec3::new((i % 8).into(), (i / 8).into(), 0.1 * f64::from(i % 3))).collect();
        let cloud = Cloud::of(Format::F32, "test".to_owned(), points, BTreeMap::new())?;
        let attributes: Given = attributes.iter().map(|(name, value)| ((*name).to_owned(), value.to_vec())).collect();
        let operation = Operation::named(name)?;
        let (operation, settings, attributes) = (&operation, &Given::new(), &attributes);
        let asked = Process { operation, k: 9, radius: None, iterations: 4, passes: 1, settings, attributes };
        process(&cloud, queries, &asked, &Interpreted, &|_| ())
    }

    fn message(result: Result<Processed, ProcessError>) -> String {
        result.expect_err("it cannot be carried out").to_string()
    }

    #[test]
    fn a_normal_for_all_points_is_made_one_of_length_1() {
        let places = |normal: [f64; 3]| {
            let all = Queries::Points((0..64).collect());
            run("smooth", &all, &[("normal", &normal)]).unwrap_or_else(|error| panic!("{error}")).places
        };
        let unit = places([0.0, 0.0, 1.0]);
        assert_eq!(places([0.0, 0.0, 8.0]), unit);
        assert_ne!(places([1.0, 0.0, 1.0]), unit);
        let none = message(run("smooth", &Queries::Points(vec![0]), &[("normal", &[0.0; 3])]));
        assert!(none.contains("attribute `normal` of `smooth` is [0.0, 0.0, 0.0]: expected a direction"), "{none}");
    }

    #[test]
    fn what_an_earlier_program_finds_is_not_given() {
        let all = Queries::Points((0..64).collect());
        let found = message(run("sph", &all, &[("density", &[1000.0])]));
        for part in ["`density` of `sph`", "`sph_density` finds", "or `sph_forces` alone"] {
            assert!(found.contains(part), "`{part}` is missing in: {found}");
        }
        let unknown = message(run("sph", &all, &[("weight", &[1.0])]));
        assert!(unknown.contains("its fields are mass (float), velocity (float3)") && !unknown.contains("pressure"));
        let both: [(&str, &[f64]); 2] = [("density", &[1000.0]), ("pressure", &[0.0])];
        let alone = run("sph_forces", &all, &both).unwrap_or_else(|error| panic!("{error}"));
        assert!(alone.column("acceleration").is_some() && alone.stages.len() == 1);
    }

    /// Places have no attributes: each field of theirs is given, or missing.
    #[test]
    fn places_have_every_field_or_none() {
        let places = Queries::Places(vec![DVec3::ONE]);
        let half = message(run("resample", &places, &[("u", &[0.5])]));
        assert!(half.contains("reads query.v (float)") && half.contains("--attribute v=NUMBER"), "{half}");
        let both: [(&str, &[f64]); 2] = [("u", &[0.5]), ("v", &[0.5])];
        assert!(run("resample", &places, &both).is_ok_and(|processed| processed.places.len() == 1));
    }
}
