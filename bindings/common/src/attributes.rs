//! Numbers that have a name: attributes of points, and settings.

use crate::BindingError;
use pointcore::process::Operation;
use pointcore_contract::process::Type;
use std::collections::BTreeMap;

/// Points, and what is known of each.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// Where they are.
    pub places: Vec<[f64; 3]>,
    /// Their attributes.
    pub attributes: Vec<Named>,
}

/// Numbers that have a name.
#[derive(Clone, Debug)]
pub struct Named {
    /// The name.
    pub name: String,
    /// The numbers, row by row.
    pub values: Vec<f64>,
    /// Of an attribute (N,) or (N, 3), a number or three for each point; without the N, or with N = 1, for all points.
    pub shape: Vec<usize>,
}

impl Points {
    /// Whether there is an attribute of the name.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.attributes.iter().any(|attribute| attribute.name == name)
    }
}

/// Attributes as columns, by the names that the library looks for.
pub(crate) fn columns(
    operation: &Operation,
    what: &str,
    points: &Points,
) -> Result<BTreeMap<String, Vec<f64>>, BindingError> {
    let count = points.places.len();
    let mut columns = BTreeMap::new();
    for attribute in &points.attributes {
        let Named { name, values, shape } = attribute;
        let field = operation.field(name)?;
        let components = field.ty.words();
        let is_vector = field.ty == Type::Float3;
        let is_for_all = match shape[..] {
            [] | [1] => !is_vector,
            [3] | [1, 3] => is_vector,
            _ => false,
        };
        let is_for_each = shape[..] == if is_vector { vec![count, 3] } else { vec![count] };
        if !is_for_all && !is_for_each {
            let expected =
                if is_vector { format!("({count}, 3), or (3,)") } else { format!("({count},), or a number") };
            let shape = shape_text(shape);
            let ty = field.ty;
            let message = format!("attribute `{name}` of {what}, a {ty}, has shape {shape}: expected {expected}");
            return Err(BindingError::input(message));
        }
        for component in 0..components {
            let column = (0..count).map(|point| values[if is_for_each { point * components } else { 0 } + component]);
            if columns.insert(column_name(name, is_vector, component), column.collect()).is_some() {
                return Err(twice(name));
            }
        }
    }
    Ok(columns)
}

/// Settings by their names.
pub(crate) fn settings_of(settings: &[Named]) -> Result<BTreeMap<String, Vec<f64>>, BindingError> {
    let mut all = BTreeMap::new();
    for setting in settings {
        if all.insert(setting.name.clone(), setting.values.clone()).is_some() {
            return Err(twice(&setting.name));
        }
    }
    Ok(all)
}

/// A shape as Python writes it.
#[must_use]
pub fn shape_text(shape: &[usize]) -> String {
    let sizes: Vec<_> = shape.iter().map(usize::to_string).collect();
    let comma = if sizes.len() == 1 { "," } else { "" };
    format!("({}{comma})", sizes.join(", "))
}

fn column_name(name: &str, is_vector: bool, component: usize) -> String {
    let axis = ["x", "y", "z"][component];
    match (name, is_vector) {
        ("normal", true) => format!("n{axis}"),
        (_, true) => format!("{name}_{axis}"),
        (_, false) => name.to_owned(),
    }
}

fn twice(name: &str) -> BindingError {
    BindingError::input(format!("`{name}` is given twice: expected once"))
}
