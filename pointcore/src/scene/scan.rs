//! The points of a file as a surface: normals, sizes, and what is to be said about them.

use super::error::SceneError;
use super::file::{
    DerivedPoints, DerivedRadius, DerivedSides, ObjectTable, Orientation as Orient, Points, Radius, TwoSided,
};
use super::model::{InvalidPoints, Model, NormalSource};
use super::neighbors::{self, Distinct};
use super::normals::{self, Estimate, FITTED_NEIGHBORS, Orientation, Spread};
use super::object::Surface;
use glam::DVec3;
use rayon::prelude::*;
use std::collections::HashSet;
use std::path::Path;

/// Meshes of fewer vertices are drawn as points of their faces: a cube's eight would be no cube.
const SPARSE_VERTICES: usize = 10_000;
/// So many points make a surface of a few hundred pixels without holes.
const SAMPLED_POINTS: usize = 30_000;
/// More points than pixels cost time and show nothing.
const AUTO_POINTS_LIMIT: usize = 300_000;
/// The share of points whose normals may disagree with their neighbors' without a word.
const DISAGREEING_SHARE: f64 = 0.005;
/// A single place has no size: it is this long, and a camera that fits sees it as large as any.
const LONE_RADIUS: f64 = 1.0;
/// Radius of points that spread evenly in a plane by their mean distance, in units of their standard deviation along an axis: a disc of
/// radius R has a deviation of R/2 and a mean distance of 2R/3.
const SPACING_PER_DEVIATION: f64 = 4.0 / 3.0;
/// An ellipse as narrow as this share of its length has hardly any pixel of its own.
const NARROWEST: f64 = 0.125;

/// Loads an object's file; `points_key` is how a user sets the number of its points.
pub(super) fn surface(
    object: &ObjectTable,
    path: &Path,
    color: [f32; 3],
    points_key: &str,
    notes: &mut Vec<String>,
) -> Result<Surface, SceneError> {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let drops = object.drop_invalid.unwrap_or(false);
    let model = Model::load_with(path, if drops { InvalidPoints::Drop } else { InvalidPoints::Refuse });
    let model = model.map_err(|error| error.remedied("; `drop_invalid = true` leaves such points out"))?;
    let mut note = |text: String| notes.push(format!("{name}: {text}"));
    if !model.dropped.is_empty() {
        note(format!("{} points are no numbers and were left out", model.dropped.len()));
    }
    let model = resampled(model, object.points, points_key, &mut note);
    let fault = |problem| SceneError::model(path, problem);
    let source = object.normals.unwrap_or_default();
    let (normals, is_estimated) = match model.given_normals(source).map_err(fault)? {
        Some((normals, _)) if normals.iter().any(|normal| *normal != DVec3::ZERO) => {
            (normals::normalize(&model.points, &normals).map_err(fault)?, false)
        }
        Some(_) if source == NormalSource::File => {
            return Err(fault("all normals are zero: use `normals = \"estimate\"`".to_owned()));
        }
        _ => (estimated(object, &model, &mut note).map_err(fault)?, true),
    };
    let is_two_sided = match object.two_sided {
        Some(TwoSided::Always(always)) => always,
        Some(TwoSided::Derived(DerivedSides::Estimated)) => is_estimated,
        None => false,
    };
    let uniform = vec![color; model.points.len()];
    let colors = if object.color.is_some() { uniform } else { model.colors.unwrap_or(uniform) };
    let (points, normals, colors) = without_repeated(model.points, normals, colors, &mut note);
    let distinct = Distinct::of(&points);
    let (radii, axes) = sizes(object, &distinct, &normals, &mut note);
    Ok(Surface { points, normals, colors, radii, axes, is_two_sided })
}

/// Points, normals and colors.
type Columns = (Vec<DVec3>, Vec<DVec3>, Vec<[f32; 3]>);

/// Leaves out points that are another one in every respect: they cost as much again and change nothing.
fn without_repeated(
    points: Vec<DVec3>,
    normals: Vec<DVec3>,
    colors: Vec<[f32; 3]>,
    note: &mut impl FnMut(String),
) -> Columns {
    let mut known = HashSet::with_capacity(points.len());
    let bits = |vector: DVec3| (vector + DVec3::ZERO).to_array().map(f64::to_bits);
    let is_new: Vec<bool> = (0..points.len())
        .map(|index| known.insert((bits(points[index]), bits(normals[index]), colors[index].map(f32::to_bits))))
        .collect();
    let repeated = is_new.iter().filter(|is_new| !**is_new).count();
    if repeated == 0 {
        return (points, normals, colors);
    }
    note(format!("{repeated} of {} points are the same as others, and are drawn once", points.len()));
    let keep = |index: &usize| is_new[*index];
    let kept: Vec<usize> = (0..points.len()).filter(keep).collect();
    let vectors = |vectors: Vec<DVec3>| kept.iter().map(|&index| vectors[index]).collect();
    (vectors(points), vectors(normals), kept.iter().map(|&index| colors[index]).collect())
}

fn resampled(model: Model, points: Option<Points>, key: &str, note: &mut impl FnMut(String)) -> Model {
    let (before, is_mesh) = (model.points.len(), !model.triangles.is_empty());
    let count = match points {
        None => return model,
        Some(Points::Count(count)) => count,
        Some(Points::Derived(DerivedPoints::Auto)) if is_mesh && before < SPARSE_VERTICES => SAMPLED_POINTS,
        Some(Points::Derived(DerivedPoints::Auto)) if before > AUTO_POINTS_LIMIT => AUTO_POINTS_LIMIT,
        Some(Points::Derived(DerivedPoints::Auto)) => return model,
    };
    let sampled = model.sampled(count);
    let (what, now) = (if is_mesh { "vertices" } else { "points" }, sampled.points.len());
    if now != before {
        let instead = if is_mesh { "points of its faces are" } else { "of them, evenly chosen, are" };
        note(format!("{before} {what}, in whose place {now} {instead} drawn: `{key}` says another number"));
    }
    sampled
}

fn estimated(object: &ObjectTable, model: &Model, note: &mut impl FnMut(String)) -> Result<Vec<DVec3>, String> {
    let sensor = object.viewpoint.map(DVec3::from_array).or(model.sensor);
    let orientation = match (object.orient, sensor) {
        (Some(Orient::Tree), _) | (None, None) => Orientation::Tree,
        (_, Some(sensor)) => Orientation::Viewpoint(sensor),
        (Some(Orient::Viewpoint), None) => {
            return Err("does not say where its sensor stood: `orient = \"viewpoint\"` needs `viewpoint = [x, y, z]`"
                .to_owned());
        }
    };
    let Estimate { normals, disagreeing } = Estimate::of(&model.points, orientation);
    let total = normals.len();
    let undefined = normals.iter().filter(|normal| **normal == DVec3::ZERO).count();
    if undefined > 0 {
        note(format!("{undefined} of {total} points span no surface with their neighbors: their splats face the eye"));
    }
    if disagreeing as f64 > DISAGREEING_SHARE * total as f64 {
        note(format!(
            "{disagreeing} of {total} estimated normals point to the other side than their neighbors': where the surface has holes, \
             `two_sided = true` closes them, `orient = \"viewpoint\"` with the place of the sensor turns them, and normals in the file are \
             better than any estimate"
        ));
    }
    Ok(normals)
}

/// Radii, and half axes in the place of radii where discs are to be ellipses.
type Sizes = (Vec<f64>, Option<Vec<[DVec3; 2]>>);

fn sizes(object: &ObjectTable, distinct: &Distinct, normals: &[DVec3], note: &mut impl FnMut(String)) -> Sizes {
    let count = distinct.places.len();
    let derived = match object.radius {
        Radius::Length(length) => return (vec![length; count], None),
        Radius::Derived(derived) => derived,
    };
    // Of distinct points only a single one has no spacing.
    let mut radii = neighbors::spacing(&distinct.points).unwrap_or_else(|_| vec![LONE_RADIUS; distinct.points.len()]);
    if let Some(limit) = object.radius_limit {
        let mut sorted = radii.clone();
        let (_, median, _) = sorted.select_nth_unstable_by(radii.len() / 2, f64::total_cmp);
        let largest = limit * *median;
        let cut = radii.iter().filter(|radius| **radius > largest).count();
        radii.iter_mut().for_each(|radius| *radius = radius.min(largest));
        if cut > 0 {
            note(format!("{cut} points lie {limit} times farther apart than most, and are drawn no larger than that"));
        }
    }
    let axes = matches!(derived, DerivedRadius::Elliptic).then(|| {
        let neighbors = neighbors::nearest(&distinct.points, FITTED_NEIGHBORS);
        let spreads: Vec<Spread> = (0..radii.len())
            .into_par_iter()
            .map(|index| Spread::of(&distinct.points, index, &neighbors[index]))
            .collect();
        let ellipse =
            |(place, normal): (&u32, &DVec3)| ellipse(&spreads[*place as usize], *normal, radii[*place as usize]);
        distinct.places.iter().zip(normals).map(ellipse).collect()
    });
    (distinct.spread(&radii), axes)
}

/// Half axes across a normal, as long as the points spread along them, and no longer than twice the spacing.
fn ellipse(spread: &Spread, normal: DVec3, spacing: f64) -> [DVec3; 2] {
    let long = spread.axes[2].reject_from(normal).try_normalize();
    let Some(long) = long.filter(|_| spread.is_plane() && normal != DVec3::ZERO) else {
        let (first, second) = normal.try_normalize().unwrap_or(DVec3::Z).any_orthonormal_pair();
        return [spacing * first, spacing * second];
    };
    let [_, minor, major] = spread.variances.map(|variance| SPACING_PER_DEVIATION * variance.sqrt());
    let major = major.min(2.0 * spacing);
    let minor = minor.clamp(NARROWEST * major, major);
    [major * long, minor * normal.cross(long)]
}
