//! Fields of queries and neighbors, bound to attributes of the points by their names.

use super::ProcessError;
use super::cloud::Cloud;
use super::operation::{Operation, shown};
use super::scale::Scale;
use super::settings::REST_DENSITY;
use super::words::encode_word;
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

/// Checks that every name is a field's of the operation.
pub fn check_names(operation: &Operation, given: &BTreeMap<String, Vec<f64>>) -> Result<(), ProcessError> {
    let fields = operation.fields();
    let unknown = given.keys().find(|name| !fields.iter().any(|field| field.name == **name));
    unknown.map_or(Ok(()), |name| {
        let (program, known) = (operation.name().to_owned(), shown(&fields));
        Err(ProcessError::UnknownAttribute { program, name: name.clone(), known })
    })
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
        if value.len() != field.ty.words() {
            let problem = format!("has {} numbers: expected {} for a {}", value.len(), field.ty.words(), field.ty);
            let (program, name) = (program.name().to_owned(), field.name.clone());
            return Err(ProcessError::Value { what: "attribute", program, name, problem });
        }
        return bound("given".to_owned(), all(value.clone()));
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

fn missing(program: &Program, whose: Whose, field: &Field, cloud: &Cloud) -> ProcessError {
    let spelled: Vec<String> = columns(field).iter().map(|names| names.join(", ")).collect();
    let what = if field.ty == Type::Float3 { "columns" } else { "column" };
    let example = if field.ty == Type::Float3 { "X,Y,Z" } else { "NUMBER" };
    let remedy = format!("--attribute {}={example} gives all points one value", field.name);
    ProcessError::MissingAttribute {
        points: cloud.name.clone(),
        program: program.name().to_owned(),
        field: format!("{}.{} ({})", whose.name(), field.name, field.ty),
        columns: format!("{what} {}: {remedy}", spelled.join(" or ")),
    }
}
