//! Settings by name: what the user says, else what follows from the points (docs/programs.md lists it).

use super::ProcessError;
use super::cloud::Cloud;
use super::operation::{Operation, shown};
use super::scale::Scale;
use super::words::encode_word;
use glam::DVec3;
use pointcore_contract::process::{Field, Program};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// A step that is done is shorter than this share of the radius.
const TOLERANCE_SHARE: f64 = 1e-3;
/// Half the weight of curvature, of spheres.
const HALF_BETA: f64 = 0.5;
/// Sum of products of the variances' shares below which neighbors count as a line.
const LEAST_SPREAD: f64 = 1.0 / 256.0;
/// Standard deviation of distances from neighbors, as a share of the radius.
const SPATIAL_SHARE: f64 = 1.0 / 3.0;
/// Standard deviation of distances from predictions, as a share of the radius.
const INFLUENCE_SHARE: f64 = 1.0 / 6.0;
/// Diagonals of the points' box that a viewpoint lies above its middle.
const VIEWPOINT_DIAGONALS: f64 = 10.0;
/// The pull of gravity, along −z.
const GRAVITY: f64 = 9.81;
/// Density of water.
pub(super) const REST_DENSITY: f64 = 1000.0;
/// Pressure by density, in units of gravity times the fluid's height: sound that is some times faster than its fall.
const STIFFNESS_FALLS: f64 = 20.0;
/// Viscosity, in units of density, speed of sound and radius.
const VISCOSITY_SHARE: f64 = 0.05;

/// The value of a setting, and where it comes from.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Setting {
    /// Its name.
    pub name: String,
    /// Its words as numbers, before they are rounded.
    pub values: Vec<f64>,
    /// The user gave it.
    pub given: bool,
}

/// Checks that every name is a setting's of the operation.
pub fn check_names(operation: &Operation, given: &BTreeMap<String, Vec<f64>>) -> Result<(), ProcessError> {
    let settings = operation.settings();
    let unknown = given.keys().find(|name| !settings.iter().any(|setting| setting.name == **name));
    unknown.map_or(Ok(()), |name| {
        let (program, known) = (operation.name().to_owned(), shown(&settings));
        Err(ProcessError::UnknownSetting { program, name: name.clone(), known })
    })
}

/// The settings of a program, in order.
pub fn settings(
    program: &Program,
    cloud: &Cloud,
    scale: Option<Scale>,
    given: &BTreeMap<String, Vec<f64>>,
) -> Result<Vec<Setting>, ProcessError> {
    let value = |field: &Field| {
        let values = match given.get(&field.name) {
            Some(values) => values.clone(),
            None => derived(program, field, cloud, scale)?,
        };
        if values.len() != field.ty.words() {
            let problem = format!("has {} numbers: expected {} for a {}", values.len(), field.ty.words(), field.ty);
            return Err(fault(program, field, problem));
        }
        Ok(Setting { name: field.name.clone(), values, given: given.contains_key(&field.name) })
    };
    program.settings.fields().iter().map(value).collect()
}

/// Settings as the program takes them, places relative to the points' origin.
pub fn encoded(program: &Program, cloud: &Cloud, settings: &[Setting]) -> Result<Vec<u32>, ProcessError> {
    let mut words = vec![];
    for (field, setting) in program.settings.fields().iter().zip(settings) {
        let origin = if is_place(&field.name) { cloud.set.origin() } else { DVec3::ZERO };
        for (value, origin) in setting.values.iter().zip(origin.to_array()) {
            let word = encode_word(cloud.set.format(), field.ty.scalar(), value - origin);
            words.push(word.map_err(|problem| fault(program, field, problem))?);
        }
    }
    Ok(words)
}

/// Whether a field of this name is a place, to be told relative to the points' origin.
pub fn is_place(name: &str) -> bool {
    matches!(name, "position" | "mean" | "viewpoint")
}

fn fault(program: &Program, field: &Field, problem: String) -> ProcessError {
    let (program, name) = (program.name().to_owned(), field.name.clone());
    ProcessError::Value { what: "setting", program, name, problem }
}

/// What follows from the points. Programs of the library have one for each of their settings; others for those that
/// they call the same.
fn derived(program: &Program, field: &Field, cloud: &Cloud, scale: Option<Scale>) -> Result<Vec<f64>, ProcessError> {
    let name = field.name.as_str();
    let fixed = match name {
        "half_beta" => Some(vec![HALF_BETA]),
        "least_spread" => Some(vec![LEAST_SPREAD]),
        "rest_density" => Some(vec![REST_DENSITY]),
        "gravity" => Some(vec![0.0, 0.0, -GRAVITY]),
        "viewpoint" => cloud.sensor.map(|sensor| sensor.to_array().to_vec()),
        _ => None,
    };
    if let Some(values) = fixed {
        return Ok(values);
    }
    let of_scale: fn(&Scale) -> Vec<f64> = match (program.name(), name) {
        (_, "inverse_radius2") => |scale| vec![scale.radius.powi(-2)],
        (_, "radius") => |scale| vec![scale.radius],
        (_, "tolerance") => |scale| vec![TOLERANCE_SHARE * scale.radius],
        (_, "spatial") => |scale| vec![0.5 * (SPATIAL_SHARE * scale.radius).powi(-2)],
        (_, "influence") => |scale| vec![0.5 * (INFLUENCE_SHARE * scale.radius).powi(-2)],
        (_, "viewpoint") => |scale| {
            let above = VIEWPOINT_DIAGONALS * scale.extent.length() * DVec3::Z;
            (scale.middle + above).to_array().to_vec()
        },
        ("sph_density", "normalization") => |scale| vec![315.0 / (64.0 * PI * scale.radius.powi(3))],
        ("sph_forces", "normalization") => |scale| vec![45.0 / (PI * scale.radius.powi(6))],
        (_, "stiffness") => |scale| vec![stiffness(scale)],
        (_, "viscosity") => |scale| vec![VISCOSITY_SHARE * REST_DENSITY * scale.radius * stiffness(scale).sqrt()],
        _ => {
            return Err(ProcessError::MissingSetting { program: program.name().to_owned(), field: field.clone() });
        }
    };
    let scale = scale.ok_or_else(|| ProcessError::NoScale { points: cloud.name.clone(), setting: name.to_owned() })?;
    Ok(of_scale(&scale))
}

fn stiffness(scale: &Scale) -> f64 {
    STIFFNESS_FALLS * GRAVITY * scale.extent.z.max(scale.radius)
}
