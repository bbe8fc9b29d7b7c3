//! Objects that are drawn as triangles beside splats: the faces of a file, or a plane.

use super::SPLAT_LIMIT;
use super::camera::Problem;
use super::disc::{Disc, Placement};
use super::error::SceneError;
use super::file::{Kind, ObjectTable};
use super::model::Model;
use super::normals;
use super::object::{DEFAULT_COLOR, Posture, linear, positive, required};
use glam::{DVec2, DVec3};
use std::borrow::Cow;
use std::path::Path;

/// Twice as many as the largest scan of splats: a mesh has as many faces to its vertices.
pub(super) const TRIANGLE_LIMIT: usize = 2 * SPLAT_LIMIT;

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Where it lies.
    pub place: DVec3,
    /// Unit normal of the surface there.
    pub normal: DVec3,
    /// Linear RGB.
    pub color: [f32; 3],
}

/// A triangle, seen from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Its corners.
    pub corners: [Corner; 3],
    /// Index into the scene's materials.
    pub material: u16,
}

impl Triangle {
    /// The same where splats have it.
    #[must_use]
    pub fn placed(&self, placement: &Placement) -> Self {
        let corners = self.corners.map(|corner| Corner { place: placement.place(corner.place), ..corner });
        Self { corners, ..*self }
    }

    /// The faces between points, with their colors as linear RGB. Without normals a point has the mean of those of the faces around it.
    ///
    /// # Errors
    /// A face has a point that there is not; no point has a normal.
    pub fn of_faces(
        points: &[DVec3],
        faces: &[[u32; 3]],
        normals: Option<&[DVec3]>,
        color: impl Fn(usize) -> [f32; 3],
    ) -> Result<Vec<Self>, String> {
        let count = points.len();
        let is_whole = |face: &[u32; 3]| face.iter().all(|index| (*index as usize) < count);
        if let Some(place) = faces.iter().position(|face| !is_whole(face)) {
            return Err(format!("face {place} is {:?}: expected indices below {count}", faces[place]));
        }
        if faces.is_empty() {
            return Ok(vec![]);
        }
        let (normals, problem) = match normals {
            Some(normals) => {
                (Cow::Borrowed(normals), "all normals are zero: without any, those of the faces are taken")
            }
            None => {
                (Cow::Owned(normals::of_triangles(points, faces)), "no face has an area: without one, give normals")
            }
        };
        let normals = normals::normalize(points, &normals).map_err(|_| problem.to_owned())?;
        let corner = |index: u32| {
            let index = index as usize;
            Corner { place: points[index], normal: normals[index], color: color(index) }
        };
        Ok(faces.iter().map(|face| Self { corners: face.map(corner), material: 0 }).collect())
    }

    /// Its corners, for a camera that is to see them.
    pub(super) fn extent(&self) -> [Disc; 3] {
        self.corners.map(|corner| Disc::about(corner.place, corner.normal, 0.0))
    }
}

/// What only splats have, and whether an object says it.
fn keys_of_splats(object: &ObjectTable) -> [(&'static str, bool); 6] {
    [
        ("points", object.points.is_some()),
        ("orient", object.orient.is_some()),
        ("viewpoint", object.viewpoint.is_some()),
        ("two_sided", object.two_sided.is_some()),
        ("radius_limit", object.radius_limit.is_some()),
        ("motion", object.motion.is_some()),
    ]
}

/// The triangles of an object in world space; `scene` is the path of its scene file, `key` names it there.
pub(super) fn build(object: &ObjectTable, scene: &Path, key: &str) -> Result<Vec<Triangle>, SceneError> {
    let value =
        |(name, problem): Problem| SceneError::Value { path: scene.to_owned(), key: format!("{key}.{name}"), problem };
    // Of a model alone nobody has given them.
    let given = keys_of_splats(object).into_iter().find(|(_, is_given)| *is_given);
    if let Some((name, _)) = given.filter(|_| !Model::is_model(scene)) {
        let problem = "belongs to splats, but the object says `draw = \"triangles\"`: give either".to_owned();
        return Err(value((name, problem)));
    }
    let posture = Posture::of(object);
    let triangles = match object.kind {
        Kind::Plane => plane(object).map_err(value)?,
        Kind::File => {
            let relative = required(object.path.as_deref(), "path", Kind::File).map_err(value)?;
            of_file(object, &scene.parent().unwrap_or(Path::new("")).join(relative))?
        }
        kind => {
            let problem =
                format!("is \"triangles\", which `file` and `plane` have, but the object is a `{}`", kind.name());
            return Err(value(("draw", problem)));
        }
    };
    let placed = |corner: Corner| Corner {
        place: posture.place(corner.place),
        normal: posture.rotation * corner.normal,
        ..corner
    };
    let triangle = |Triangle { corners, .. }| Triangle { corners: corners.map(placed), material: object.material };
    Ok(triangles.into_iter().map(triangle).collect())
}

/// The faces of a file.
fn of_file(object: &ObjectTable, path: &Path) -> Result<Vec<Triangle>, SceneError> {
    let fault = |problem| SceneError::model(path, problem);
    let model = Model::load(path)?;
    if model.triangles.is_empty() {
        return Err(fault(
            "holds no faces, which `draw = \"triangles\"` needs: leave it out to draw splats".to_owned(),
        ));
    }
    let normals = model.given_normals(object.normals.unwrap_or_default()).map_err(fault)?.map(|(normals, _)| normals);
    let own = if object.color.is_some() { None } else { model.colors.as_ref() };
    let color = linear(object.color.unwrap_or(DEFAULT_COLOR));
    let color = |index: usize| own.map_or(color, |colors| colors[index]);
    Triangle::of_faces(&model.points, &model.triangles, normals.as_deref(), color).map_err(fault)
}

/// Two triangles for each check of a plane, or for all of it.
fn plane(object: &ObjectTable) -> Result<Vec<Triangle>, Problem> {
    let size = positive(required(object.size, "size", Kind::Plane)?, "size")?;
    let color = linear(object.color.unwrap_or(DEFAULT_COLOR));
    let other = linear(object.checker_color.or(object.color).unwrap_or(DEFAULT_COLOR));
    // No checks along an edge are one.
    let [columns, rows] = object.checks.unwrap_or_default().map(|checks| checks.max(1));
    let count = 2 * u64::from(columns) * u64::from(rows);
    if count > TRIANGLE_LIMIT as u64 {
        return Err(("checks", format!("make {count} triangles: expected up to {TRIANGLE_LIMIT}")));
    }
    let quads = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let quad = |(column, row): (u32, u32)| {
        let color = if (column + row) % 2 == 0 { color } else { other };
        let corner = |[right, down]: [u32; 2]| {
            let [x, y] = [f64::from(column + right) / f64::from(columns), f64::from(row + down) / f64::from(rows)];
            let place = size * (DVec2::new(x, y) - 0.5);
            Corner { place: DVec3::new(place.x, 0.0, place.y), normal: DVec3::Y, color }
        };
        [[[0, 0], [0, 1], [1, 1]], [[0, 0], [1, 1], [1, 0]]]
            .map(|triangle| Triangle { corners: triangle.map(corner), material: 0 })
    };
    Ok(quads.flat_map(quad).collect())
}
