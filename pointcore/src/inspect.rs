//! What `pointcore inspect` says about a model file.

use crate::scene::neighbors::{self, Distinct};
use crate::scene::{InvalidPoints, Model, NormalOrigin, NormalSource, SceneError};
use glam::DVec3;
use std::fmt;
use std::path::{Path, PathBuf};

/// A model's figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// The file.
    pub path: PathBuf,
    /// Number of points that are numbers.
    pub points: usize,
    /// Number of points that are none.
    pub invalid: usize,
    /// Number of points that lie where another one does.
    pub repeated: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Whether points have colors.
    pub colors: bool,
    /// Opposite corners of the bounding box.
    pub bounds: [DVec3; 2],
    /// What normals are made from unless the scene says otherwise.
    pub normals: NormalOrigin,
    /// Least, mean and greatest distance to the nearest neighbors, which is the splat radius by spacing; of points that lie in one place
    /// none.
    pub spacing: Option<[f64; 3]>,
}

/// Reads and measures a model.
///
/// # Errors
/// The model cannot be used: it is damaged, or none of its points is a number.
pub fn inspect(path: &Path) -> Result<Inspection, SceneError> {
    let model = Model::load_with(path, InvalidPoints::Drop)?;
    let fault = |problem| SceneError::Model { path: path.to_owned(), problem };
    let normals = model.given_normals(NormalSource::Auto).map_err(fault)?;
    let distinct = Distinct::of(&model.points);
    let [first, ..] = model.points[..] else { unreachable!("a loaded model holds at least one point") };
    let bounds = model.points.iter().fold([first; 2], |[low, high], point| [low.min(*point), high.max(*point)]);
    Ok(Inspection {
        path: path.to_owned(),
        points: model.points.len(),
        invalid: model.dropped.len(),
        repeated: model.points.len() - distinct.points.len(),
        triangles: model.triangles.len(),
        colors: model.colors.is_some(),
        bounds,
        normals: normals.map_or(NormalOrigin::Estimated, |(_, origin)| origin),
        spacing: spacing(&distinct.points),
    })
}

/// Least, mean and greatest spacing; of distinct points only a single one has none.
fn spacing(points: &[DVec3]) -> Option<[f64; 3]> {
    let spacing = neighbors::spacing(points).ok()?;
    Some([
        spacing.iter().copied().fold(f64::INFINITY, f64::min),
        spacing.iter().sum::<f64>() / spacing.len() as f64,
        spacing.iter().copied().fold(0.0, f64::max),
    ])
}

impl fmt::Display for Inspection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [low, high] = self.bounds;
        writeln!(f, "{}", self.path.display())?;
        let note = |count: usize, what| if count > 0 { format!(", {count} {what}") } else { String::new() };
        let (invalid, repeated) =
            (note(self.invalid, "more are no numbers"), note(self.repeated, "of them repeat others"));
        writeln!(f, "  points     {}{repeated}{invalid}", self.points)?;
        writeln!(f, "  triangles  {}", self.triangles)?;
        // As single precision, in which most scans come: no digits that the file does not have.
        if [low, high].iter().all(|corner| corner.as_vec3().as_dvec3() == *corner) {
            writeln!(f, "  bounds     {} to {}", low.as_vec3(), high.as_vec3())?;
        } else {
            writeln!(f, "  bounds     {low} to {high}")?;
        }
        writeln!(f, "  normals    {}", self.normals)?;
        writeln!(f, "  colors     {}", if self.colors { "in the file" } else { "none" })?;
        match self.spacing {
            Some([least, mean, greatest]) => {
                write!(f, "  spacing    {least:.3e} least, {mean:.3e} mean, {greatest:.3e} greatest")
            }
            None => write!(f, "  spacing    none: all points lie in one place"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_drawn_is_described() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let said = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).expect("the folder is writable");
            inspect(&path).map_or_else(|error| error.to_string(), |inspection| inspection.to_string())
        };
        assert!(said("point.xyz", "1 2 3\n").contains("spacing    none: all points lie in one place"));
        assert!(said("repeated.xyz", "1 2 3\n1 2 3\n1 2 4\n").contains("points     3, 1 of them repeat others\n"));
        assert!(said("scan.xyz", "nan 0 0\n0 0 0\n1 0 0\n").contains("points     2, 1 more are no numbers\n"));
        assert!(said("none.xyz", "nan 0 0\n").contains("besides 1 that are no numbers"));
    }

    #[test]
    fn a_square_of_points_is_measured() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("square.obj");
        std::fs::write(&path, "v 0 0 1\nv 3 0 1\nv 3 4 1\nv 0 4 1\nf 1 2 3 4\n").expect("the folder is writable");
        let inspection = inspect(&path).expect("the model is good");
        assert_eq!((inspection.points, inspection.triangles, inspection.colors), (4, 2, false));
        assert_eq!(inspection.bounds, [DVec3::new(0.0, 0.0, 1.0), DVec3::new(3.0, 4.0, 1.0)]);
        // Each corner's neighbors lie 3, 4 and 5 away.
        assert_eq!((inspection.normals, inspection.spacing), (NormalOrigin::Faces, Some([4.0; 3])));
        assert!(inspection.to_string().contains("from the file's faces"));
        assert!(inspect(&folder.path().join("missing.obj")).is_err());
    }
}
