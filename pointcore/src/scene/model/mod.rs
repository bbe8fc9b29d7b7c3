//! Point models from files: PLY, OBJ, glTF, PCD, LAS, and columns of text.

mod colors;
mod columns;
mod gltf;
mod guard;
mod las;
mod obj;
mod pcd;
mod ply;
mod sampled;

use super::error::SceneError;
use super::normals;
use glam::DVec3;
use guard::guarded;
pub use guard::is_guarded;
use std::borrow::Cow;
use std::collections::BTreeMap;
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
    /// Where the sensor stood, if the file says so.
    pub sensor: Option<DVec3>,
    /// Further numbers of each point, by their names in the file, lower case: properties of a PLY file's vertices, named columns of text. NaN
    /// where a point has none.
    pub attributes: BTreeMap<String, Vec<f64>>,
    /// Places in the file of the points that were left out since they are no numbers, in their order.
    pub dropped: Vec<u32>,
}

/// What becomes of points whose coordinates are no numbers, such as those that a scanner did not hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InvalidPoints {
    /// The first of them is an error.
    Refuse,
    /// They are left out, and counted.
    Drop,
}

/// The direction that a format's files call up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Up {
    Y,
    Z,
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

/// Reads a whole file; an error says what is wrong with it.
type Parse = fn(&[u8], &Path) -> Result<Model, String>;

/// Formats by the endings of their files.
const FORMATS: [(&[&str], Parse, Up); 6] = [
    (&["ply"], |bytes, _| ply::parse(bytes), Up::Y),
    (&["obj"], |bytes, _| obj::parse(bytes), Up::Y),
    (&["gltf", "glb"], |bytes, path| guarded(|| gltf::parse(bytes, path)), Up::Y),
    (&["pcd"], |bytes, _| guarded(|| pcd::parse(bytes)), Up::Z),
    (&["las", "laz"], |bytes, _| guarded(|| las::parse(bytes)), Up::Z),
    (&["xyz", "csv", "txt", "asc", "pts"], |bytes, _| columns::parse(bytes), Up::Z),
];

/// The format of a file, by its ending.
fn format(path: &Path) -> Option<(Parse, Up)> {
    let extension = path.extension()?.to_string_lossy().to_lowercase();
    let found = FORMATS.iter().find(|(extensions, ..)| extensions.contains(&extension.as_str()));
    found.map(|(_, parse, up)| (*parse, *up))
}

/// Which way is up in files like this one.
pub(super) fn up(path: &Path) -> Option<Up> {
    format(path).map(|(_, up)| up)
}

impl Model {
    /// Whether a file's name ends like that of a model.
    #[must_use]
    pub fn is_model(path: &Path) -> bool {
        format(path).is_some()
    }

    /// Reads a model of which every point is a number.
    ///
    /// # Errors
    /// The file is missing, of another kind, malformed, holds no point, or one that is not finite.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::load_with(path, InvalidPoints::Refuse)
    }

    /// Reads a model.
    ///
    /// # Errors
    /// The file is missing, of another kind, malformed, or holds no point.
    pub fn load_with(path: &Path, invalid: InvalidPoints) -> Result<Self, SceneError> {
        let problem = |problem| SceneError::model(path, problem);
        let (parse, _) = format(path).ok_or_else(|| problem(format!("a model's name must end in {}", endings())))?;
        let bytes = std::fs::read(path).map_err(|source| SceneError::Read { path: path.to_owned(), source })?;
        let model = parse(&bytes, path).map_err(problem)?;
        let model = match invalid {
            InvalidPoints::Refuse => model,
            InvalidPoints::Drop => model.without_invalid(),
        };
        model.checked(path)
    }

    /// One unit normal a point, and what they were made from.
    ///
    /// # Errors
    /// `source` asks for normals that the file lacks, or there are too few points to estimate them.
    pub fn unit_normals(&self, source: NormalSource) -> Result<(Vec<DVec3>, NormalOrigin), String> {
        match self.given_normals(source)? {
            Some((normals, origin)) => Ok((normals::normalize(&self.points, &normals)?, origin)),
            None => Ok((normals::estimate(&self.points)?, NormalOrigin::Estimated)),
        }
    }

    /// The file's normals, of any length, and what they were made from; `None` where they are to be estimated.
    ///
    /// # Errors
    /// `source` asks for normals that the file lacks.
    pub fn given_normals(&self, source: NormalSource) -> Result<Option<(Vec<DVec3>, NormalOrigin)>, String> {
        let from_file = || match &self.normals {
            Some(normals) => Some((normals.clone(), NormalOrigin::Vertices)),
            None if !self.triangles.is_empty() => {
                Some((normals::of_triangles(&self.points, &self.triangles), NormalOrigin::Faces))
            }
            None => None,
        };
        match source {
            NormalSource::Estimate => Ok(None),
            NormalSource::Auto => Ok(from_file()),
            NormalSource::File => match from_file() {
                None => Err("holds neither normals nor faces: use `normals = \"estimate\"`".to_owned()),
                given => Ok(given),
            },
        }
    }

    /// The model without the points that are no numbers, and without the faces at them.
    fn without_invalid(mut self) -> Self {
        let is_kept: Vec<bool> = self.points.iter().map(|point| is_usable(*point)).collect();
        let place = |kept: &mut u32, is_kept: &bool| {
            let place = *kept;
            *kept += u32::from(*is_kept);
            Some(place)
        };
        let places: Vec<u32> = is_kept.iter().scan(0, place).collect();
        self.dropped = (0..).zip(&is_kept).filter(|(_, is_kept)| !**is_kept).map(|(place, _)| place).collect();
        if !self.dropped.is_empty() {
            let is_whole = |triangle: &[u32; 3]| {
                // A face at a vertex that there is none of is an error, which is found later.
                triangle.iter().all(|&index| is_kept.get(index as usize).copied().unwrap_or(true))
            };
            self.triangles.retain(is_whole);
            for index in self.triangles.iter_mut().flatten() {
                *index = places.get(*index as usize).copied().unwrap_or(u32::MAX);
            }
            keep(&mut self.points, &is_kept);
            self.normals.iter_mut().for_each(|normals| keep(normals, &is_kept));
            self.colors.iter_mut().for_each(|colors| keep(colors, &is_kept));
            self.attributes.values_mut().for_each(|values| keep(values, &is_kept));
        }
        // A point without a normal takes its neighbors'.
        for normal in self.normals.iter_mut().flatten().filter(|normal| !is_usable(**normal)) {
            *normal = DVec3::ZERO;
        }
        self
    }

    fn checked(self, path: &Path) -> Result<Self, SceneError> {
        if let Some(index) = self.points.iter().position(|point| !is_usable(*point)) {
            let point = self.points[index].to_array();
            return Err(SceneError::Point { path: path.to_owned(), index, point, remedy: "" });
        }
        self.consistent().map_err(|problem| SceneError::model(path, problem))
    }

    fn consistent(self) -> Result<Self, String> {
        if self.points.is_empty() {
            let dropped = match self.dropped.len() {
                0 => String::new(),
                dropped => format!(" besides {dropped} that are no numbers"),
            };
            return Err(format!("holds no vertex{dropped}: a model needs at least one"));
        }
        if let Some(index) = self.normals.iter().flatten().position(|normal| !is_usable(*normal)) {
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

/// The text of a file. Comments and names may be in any encoding of single bytes; what a model needs is ASCII.
fn text(bytes: &[u8]) -> Result<Cow<'_, str>, String> {
    // UTF-16 has them in every other place, and binary files somewhere.
    if bytes.contains(&0) {
        return Err("is no text, or text in UTF-16: expected UTF-8 or ASCII".to_owned());
    }
    Ok(String::from_utf8_lossy(bytes))
}

/// Endings of models' names, as a sentence has them.
pub(super) fn endings() -> String {
    let all: Vec<_> =
        FORMATS.iter().flat_map(|(extensions, ..)| *extensions).map(|ending| format!(".{ending}")).collect();
    let (last, others) = all.split_last().expect("there are formats");
    format!("{} or {last}", others.join(", "))
}

fn is_usable(vector: DVec3) -> bool {
    vector.is_finite() && vector.abs().max_element() <= COORDINATE_LIMIT
}

/// Keeps what is marked.
fn keep<T>(items: &mut Vec<T>, is_kept: &[bool]) {
    let mut marks = is_kept.iter();
    items.retain(|_| marks.next().copied().unwrap_or(false));
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

/// The triangles of a strip, of which every second one turns the other way round. Strips repeat vertices to turn a corner, which leaves
/// triangles without area.
fn strip(strip: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    let oriented = |(index, corner): (usize, &[u32])| match index % 2 {
        0 => [corner[0], corner[1], corner[2]],
        _ => [corner[1], corner[0], corner[2]],
    };
    strip.windows(3).enumerate().map(oriented).filter(|[a, b, c]| a != b && b != c && a != c)
}

#[cfg(test)]
pub(crate) mod tests;
