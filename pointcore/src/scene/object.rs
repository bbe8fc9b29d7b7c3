//! An object of the scene file becomes splats: shape, radius, placement, color.

use super::camera::Problem;
use super::disc::{Disc, Sides};
use super::error::SceneError;
use super::file::{DerivedRadius, Kind, ObjectTable, Points, Radius};
use super::model::{COORDINATE_LIMIT, Model};
use super::{SPLAT_LIMIT, neighbors, scan, shapes};
use crate::color::linear_from_srgb;
use glam::{DQuat, DVec2, DVec3, EulerRot};
use std::ops::RangeInclusive;
use std::path::Path;

/// Radii of splats after scaling: no atom is as small, and no scan larger.
const SPLAT_RADIUS_RANGE: RangeInclusive<f64> = 1e-30..=COORDINATE_LIMIT;
/// Windings beyond this leave no room between the turns of a tube.
const WINDING_LIMIT: u32 = 1000;
/// sRGB gray of objects without any color.
pub(super) const DEFAULT_COLOR: [f64; 3] = [0.8; 3];

/// An object's points before placement.
pub(super) struct Surface {
    pub points: Vec<DVec3>,
    /// Of unit length, or zero where there is none.
    pub normals: Vec<DVec3>,
    pub colors: Vec<[f32; 3]>,
    pub radii: Vec<f64>,
    /// Half axes in the place of radii.
    pub axes: Option<Vec<[DVec3; 2]>>,
    pub is_two_sided: bool,
}

/// How an object stands in the world.
pub(super) struct Posture {
    pub rotation: DQuat,
    scale: f64,
    translation: DVec3,
}

impl Posture {
    pub fn of(object: &ObjectTable) -> Self {
        let [x, y, z] = object.rotate_degrees.map(f64::to_radians);
        let rotation = DQuat::from_euler(EulerRot::XYZEx, x, y, z);
        Self { rotation, scale: object.scale, translation: DVec3::from_array(object.translate) }
    }

    /// A place of the object in the world.
    pub fn place(&self, own: DVec3) -> DVec3 {
        self.rotation * (self.scale * own) + self.translation
    }
}

/// Builds the discs of an object; `scene` is the path of its scene file, `key` names it there. What is to be said of it is added to `notes`.
pub(super) fn build(
    object: &ObjectTable,
    scene: &Path,
    key: &str,
    notes: &mut Vec<String>,
) -> Result<Vec<Disc>, SceneError> {
    let value =
        |(name, problem): Problem| SceneError::Value { path: scene.to_owned(), key: format!("{key}.{name}"), problem };
    let color = linear(object.color.unwrap_or(DEFAULT_COLOR));
    // A model alone has no scene file to be edited.
    let points_key = format!("{}{key}.points", if Model::is_model(scene) { "--set " } else { "" });
    let points_key = if Model::is_model(scene) { points_key + "=COUNT" } else { points_key };
    let surface = if object.kind == Kind::File {
        let relative = required(object.path.as_deref(), "path", Kind::File).map_err(value)?;
        let path = scene.parent().unwrap_or(Path::new("")).join(relative);
        scan::surface(object, &path, color, &points_key, notes).map_err(|error| match error {
            // A model without a scene has no key that leads to it.
            SceneError::Read { path, source } if !Model::is_model(scene) => {
                let (path, example) = (path.display(), format!("--set {key}.path=FILE"));
                let problem =
                    format!("leads to {path}, which cannot be read ({source}): set another, e.g. by `{example}`");
                value(("path", problem))
            }
            other => other,
        })?
    } else {
        shape_surface(object, color).map_err(value)?
    };

    let posture = Posture::of(object);
    let rotation = posture.rotation;
    let disc = |index: usize| {
        let center = posture.place(surface.points[index]);
        let normal = rotation * surface.normals[index];
        let scale = object.scale * object.radius_scale;
        let radius = scale * surface.radii[index];
        if !SPLAT_RADIUS_RANGE.contains(&radius) || center.abs().max_element() > COORDINATE_LIMIT {
            let (low, high) = SPLAT_RADIUS_RANGE.into_inner();
            let center = center.to_array();
            let problem = format!(
                "and the object's size put splat {index} of radius {radius:e} at {center:?}: expected radii from {low:e} \
                 to {high:e} and coordinates up to {COORDINATE_LIMIT:e}"
            );
            return Err(value(("scale", problem)));
        }
        let disc = match normal {
            DVec3::ZERO => Disc::new(center, normal, radius),
            unit => Disc::about(center, unit, radius),
        };
        let sides = if surface.is_two_sided && disc.sides == Sides::Front { Sides::Both } else { disc.sides };
        let tangents = match &surface.axes {
            Some(axes) => axes[index].map(|axis| rotation * (scale * axis)),
            None => disc.tangents,
        };
        Ok(Disc { tangents, sides, color: surface.colors[index], material: object.material, ..disc })
    };
    (0..surface.points.len()).map(disc).collect()
}

pub(super) fn linear(color: [f64; 3]) -> [f32; 3] {
    color.map(|component| linear_from_srgb(component) as f32)
}

/// Rejects values that make no sense, whatever the object is made of.
pub(super) fn check(object: &ObjectTable) -> Result<(), Problem> {
    check_keys(object)?;
    check_placement(object)
}

/// Rejects keys that belong to other kinds of objects: they would be ignored silently.
fn check_keys(object: &ObjectTable) -> Result<(), Problem> {
    use Kind::{File, Plane, Sphere, Torus, TorusKnot};
    let procedural: &[Kind] = &[Sphere, Torus, TorusKnot, Plane];
    let is_elliptic = matches!(object.radius, Radius::Derived(DerivedRadius::Elliptic));
    let is_derived = matches!(object.points, Some(Points::Derived(_)));
    let uses: [(&'static str, bool, &[Kind]); 16] = [
        ("points = \"auto\"", is_derived, &[File]),
        ("radius = \"elliptic\"", is_elliptic, &[File]),
        ("outer_radius", object.outer_radius.is_some(), &[Sphere, Torus, TorusKnot]),
        ("tube_radius", object.tube_radius.is_some(), &[Torus, TorusKnot]),
        ("knot_radius", object.knot_radius.is_some(), &[TorusKnot]),
        ("windings", object.windings.is_some(), &[TorusKnot]),
        ("size", object.size.is_some(), &[Plane]),
        ("checks", object.checks.is_some(), procedural),
        ("checker_color", object.checker_color.is_some(), procedural),
        ("path", object.path.is_some(), &[File]),
        ("normals", object.normals.is_some(), &[File]),
        ("orient", object.orient.is_some(), &[File]),
        ("viewpoint", object.viewpoint.is_some(), &[File]),
        ("drop_invalid", object.drop_invalid.is_some(), &[File]),
        ("two_sided", object.two_sided.is_some(), &[File]),
        ("radius_limit", object.radius_limit.is_some(), &[File]),
    ];
    match uses.iter().find(|(_, given, kinds)| *given && !kinds.contains(&object.kind)) {
        Some((key, _, kinds)) => {
            let kinds: Vec<_> = kinds.iter().map(|kind| format!("`{}`", kind.name())).collect();
            Err((key, format!("belongs to {}, but the object is a `{}`", kinds.join(", "), object.kind.name())))
        }
        None if object.checks.is_some() != object.checker_color.is_some() => {
            Err(("checks", "and `checker_color` need each other: give both or none".to_owned()))
        }
        None => Ok(()),
    }
}

fn check_placement(object: &ObjectTable) -> Result<(), Problem> {
    positive(object.scale, "scale")?;
    positive(object.radius_scale, "radius_scale")?;
    if let Radius::Length(length) = object.radius {
        positive(length, "radius")?;
    }
    if let Some(limit) = object.radius_limit {
        positive(limit, "radius_limit")?;
    }
    if let Some(Points::Count(count)) = object.points
        && !(1..=SPLAT_LIMIT).contains(&count)
    {
        return Err(("points", format!("is {count}: expected 1 to {SPLAT_LIMIT}")));
    }
    let viewpoint = object.viewpoint.unwrap_or_default();
    for (key, vector) in
        [("translate", object.translate), ("rotate_degrees", object.rotate_degrees), ("viewpoint", viewpoint)]
    {
        if !vector.iter().all(|component| component.abs() <= COORDINATE_LIMIT) {
            return Err((key, format!("is {vector:?}: expected numbers up to {COORDINATE_LIMIT:e}")));
        }
    }
    for (key, color) in [("color", object.color), ("checker_color", object.checker_color)] {
        check_color(color.unwrap_or_default()).map_err(|problem| (key, problem))?;
    }
    Ok(())
}

/// Colors are written as sRGB components from 0 to 1.
pub(super) fn check_color(color: [f64; 3]) -> Result<(), String> {
    let valid = color.iter().all(|component| (0.0..=1.0).contains(component));
    valid.then_some(()).ok_or_else(|| format!("is {color:?}: expected red, green and blue from 0 to 1"))
}

pub(super) fn positive(value: f64, key: &'static str) -> Result<f64, Problem> {
    let valid = value > 0.0 && value <= COORDINATE_LIMIT;
    valid
        .then_some(value)
        .ok_or_else(|| (key, format!("is {value}: expected a positive number up to {COORDINATE_LIMIT:e}")))
}

pub(super) fn required<T>(value: Option<T>, key: &'static str, kind: Kind) -> Result<T, Problem> {
    value.ok_or_else(|| (key, format!("is missing: a `{}` needs it", kind.name())))
}

fn shape_surface(object: &ObjectTable, color: [f32; 3]) -> Result<Surface, Problem> {
    let kind = object.kind;
    let count = required(object.points, "points", kind)?;
    let Points::Count(count) = count else { unreachable!("`check_keys` leaves derived numbers to files") };
    let length = |value: Option<f64>, key| positive(required(value, key, kind)?, key);
    let samples = match kind {
        Kind::Sphere => shapes::sphere(count, length(object.outer_radius, "outer_radius")?),
        Kind::Plane => shapes::plane(count, length(object.size, "size")?),
        Kind::Torus | Kind::TorusKnot => {
            let (knot_radius, windings) = if kind == Kind::Torus {
                (0.0, [1, 0])
            } else {
                (length(object.knot_radius, "knot_radius")?, required(object.windings, "windings", kind)?)
            };
            if windings[0] == 0 || windings.iter().any(|turns| *turns > WINDING_LIMIT) {
                let problem = format!("is {windings:?}: expected up to {WINDING_LIMIT} turns, the first at least 1");
                return Err(("windings", problem));
            }
            let outer_radius = length(object.outer_radius, "outer_radius")?;
            let tube_radius = length(object.tube_radius, "tube_radius")?;
            shapes::Tube { outer_radius, knot_radius, tube_radius, windings }.sample(count)
        }
        Kind::File => unreachable!("files are loaded by `scan::surface`"),
    };
    let colors = match object.checks.zip(object.checker_color) {
        None => vec![color; samples.len()],
        Some((checks, other)) => {
            let checks = DVec2::new(f64::from(checks[0]), f64::from(checks[1]));
            let odd = |sample: &shapes::SurfaceSample| (sample.parameters * checks).floor().element_sum() % 2.0 != 0.0;
            samples.iter().map(|sample| if odd(sample) { linear(other) } else { color }).collect()
        }
    };
    let points: Vec<_> = samples.iter().map(|sample| sample.point).collect();
    let radii = match object.radius {
        Radius::Length(length) => vec![length; points.len()],
        Radius::Derived(_) => neighbors::spacing(&points).map_err(|problem| ("points", problem))?,
    };
    let normals = samples.iter().map(|sample| sample.normal).collect();
    Ok(Surface { points, normals, colors, radii, axes: None, is_two_sided: false })
}
