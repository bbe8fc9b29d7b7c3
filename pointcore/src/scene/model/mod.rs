//! Point models from PLY and OBJ files.

mod obj;
mod ply;

use super::error::SceneError;
use super::normals;
use glam::DVec3;
use std::path::Path;

/// Coordinates beyond this have squares that leave `f32` in later arithmetic; no scan comes near it.
pub(super) const COORDINATE_LIMIT: f64 = 1e9;

/// A point set as read from a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Positions, at least one, all finite.
    pub points: Vec<DVec3>,
    /// One outward normal a point (not necessarily of unit length), if the file has them.
    pub normals: Option<Vec<DVec3>>,
    /// One linear RGB color a point, if the file has them.
    pub colors: Option<Vec<[f32; 3]>>,
    /// Triangles as indices of points, counter-clockwise seen from outside; empty for a plain point set.
    pub triangles: Vec<[u32; 3]>,
}

/// Where normals are to come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum NormalSource {
    /// From the file if it holds any, else estimated.
    #[default]
    Auto,
    /// The file's vertex normals or, failing these, its faces.
    File,
    /// Estimated from neighboring points even if the file has normals.
    Estimate,
}

impl Model {
    /// Reads a `.ply` or `.obj` file.
    ///
    /// # Errors
    /// The file is missing, of another kind, malformed, holds no point, or one that is not finite.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        let bytes = || std::fs::read(path).map_err(|source| SceneError::Read { path: path.to_owned(), source });
        let model = match extension.as_deref() {
            Some("ply") => ply::parse(&bytes()?),
            Some("obj") => obj::parse(&bytes()?),
            _ => Err("a model's name must end in .ply or .obj".to_owned()),
        };
        model.and_then(Self::checked).map_err(|problem| SceneError::model(path, problem))
    }

    /// One unit normal a point, and what they were made from.
    ///
    /// # Errors
    /// `source` asks for normals that the file lacks, or there are too few points to estimate them.
    pub fn unit_normals(&self, source: NormalSource) -> Result<(Vec<DVec3>, NormalOrigin), String> {
        let from_file = || match &self.normals {
            Some(normals) => Some((normals.clone(), NormalOrigin::Vertices)),
            None if !self.triangles.is_empty() => {
                Some((normals::of_triangles(&self.points, &self.triangles), NormalOrigin::Faces))
            }
            None => None,
        };
        let given = match source {
            NormalSource::Estimate => None,
            NormalSource::Auto => from_file(),
            NormalSource::File => {
                Some(from_file().ok_or("holds neither normals nor faces: use `normals = \"estimate\"`")?)
            }
        };
        match given {
            Some((normals, origin)) => Ok((normals::normalize(&self.points, &normals)?, origin)),
            None => Ok((normals::estimate(&self.points)?, NormalOrigin::Estimated)),
        }
    }

    fn checked(self) -> Result<Self, String> {
        if self.points.is_empty() {
            return Err("holds no vertex: a model needs at least one".to_owned());
        }
        let unusable = |vector: &DVec3| !vector.is_finite() || vector.abs().max_element() > COORDINATE_LIMIT;
        if let Some(index) = self.points.iter().position(unusable) {
            let point = self.points[index].to_array();
            return Err(format!(
                "vertex {index} lies at {point:?}: coordinates must be finite and below {COORDINATE_LIMIT:e}"
            ));
        }
        if let Some(index) = self.normals.iter().flatten().position(unusable) {
            return Err(format!("the normal of vertex {index} is not finite"));
        }
        let count = self.points.len();
        let stray = |triangle: &[u32; 3]| triangle.iter().any(|&index| index as usize >= count);
        if let Some(index) = self.triangles.iter().position(stray) {
            let triangle = self.triangles[index];
            return Err(format!("triangle {index} joins the vertices {triangle:?}, but there are only {count}"));
        }
        Ok(self)
    }
}

/// What a model's normals were made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalOrigin {
    /// Vertex normals in the file.
    Vertices,
    /// The file's faces.
    Faces,
    /// The points alone.
    Estimated,
}

impl std::fmt::Display for NormalOrigin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Vertices => "vertex normals of the file",
            Self::Faces => "from the file's faces",
            Self::Estimated => "estimated from neighboring points",
        })
    }
}

/// The triangles of a convex polygon.
fn fan(polygon: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    polygon.windows(2).skip(1).map(|edge| [polygon[0], edge[0], edge[1]])
}

#[cfg(test)]
pub(crate) mod tests;
