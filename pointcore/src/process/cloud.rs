//! Points with their attributes.

use super::ProcessError;
use crate::scene::{InvalidPoints, Model, NormalSource};
use crate::search::{PointSet, PointSource};
use glam::DVec3;
use pointcore_contract::Format;
use std::collections::BTreeMap;

/// What is right where a file's normals are of no use.
const ESTIMATE: &str = ": expected normals, or to have them estimated (--normals estimate)";

/// Points in a program's format, with what else is known of each.
#[derive(Clone, Debug)]
pub struct Cloud {
    /// The points.
    pub(super) set: PointSet,
    /// A normal each, of length 1.
    pub(super) normals: Option<Vec<DVec3>>,
    /// Where the normals come from, in words.
    pub(super) normals_from: String,
    /// Numbers of each by their names, lower case.
    pub(super) columns: BTreeMap<String, Vec<f64>>,
    /// Where numbers come from that are not the file's, in words.
    pub(super) sources: BTreeMap<String, String>,
    /// Where the sensor stood.
    pub(super) sensor: Option<DVec3>,
    /// What errors and reports call it.
    pub(super) name: String,
    /// The place of each point in its file.
    pub(super) places: Vec<u32>,
    /// Points of the file that were left out.
    pub(super) left_out: usize,
}

impl Cloud {
    /// Loads or makes the points of a source; of a file's normals `normals` says whether they count.
    ///
    /// # Errors
    /// The file cannot be used, or does not have the normals that it is asked for.
    pub fn load(
        format: Format,
        source: &PointSource,
        invalid: InvalidPoints,
        normals: NormalSource,
    ) -> Result<Self, ProcessError> {
        let PointSource::File(path) = source else {
            return Self::of(format, source.to_string(), source.points(invalid)?, BTreeMap::new());
        };
        let model = Model::load_with(path, invalid)?;
        let wrong = |problem: String| crate::scene::SceneError::Model { path: path.clone(), problem };
        let given =
            model.given_normals(normals).map_err(|_| wrong(format!("holds neither normals nor faces{ESTIMATE}")))?;
        let unit = |(given, origin): (Vec<DVec3>, crate::scene::NormalOrigin)| {
            Ok::<_, String>((
                crate::scene::normals::normalize(&model.points, &given)
                    .map_err(|_| format!("has normals, but all are zero{ESTIMATE}"))?,
                origin.to_string(),
            ))
        };
        let normals = given.map(unit).transpose().map_err(wrong)?;
        let left_out = model.dropped.clone();
        let mut cloud = Self::of(format, path.display().to_string(), model.points, model.attributes)?;
        if let Some((normals, origin)) = normals {
            (cloud.normals, cloud.normals_from) = (Some(normals), origin);
        }
        cloud.sensor = model.sensor;
        cloud.left_out = left_out.len();
        let mut left_out = left_out.into_iter().peekable();
        let is_kept = |place: &u32| left_out.next_if_eq(place).is_none();
        cloud.places = (0..).filter(is_kept).take(cloud.len()).collect();
        Ok(cloud)
    }

    /// Points in memory, with numbers of each by name: `nx`, `ny` and `nz` are normals of any length; where they are zero,
    /// the nearest point's count.
    ///
    /// # Errors
    /// There is no point, one that is not finite in the format, a column of another length, or no normal of any length.
    pub fn of(
        format: Format,
        name: String,
        points: Vec<DVec3>,
        mut columns: BTreeMap<String, Vec<f64>>,
    ) -> Result<Self, ProcessError> {
        let count = points.len();
        if let Some((column, values)) = columns.iter().find(|(_, values)| values.len() != count) {
            let problem = format!("has {} numbers: expected {count}, one a point", values.len());
            return Err(ProcessError::Value { what: "column", program: name, name: column.clone(), problem });
        }
        let normals = match ["nx", "ny", "nz"].map(|axis| columns.remove(axis)) {
            [Some(x), Some(y), Some(z)] => Some((0..count).map(|i| DVec3::new(x[i], y[i], z[i])).collect::<Vec<_>>()),
            [None, None, None] => None,
            _ => {
                let problem = "is not whole: expected nx, ny and nz, or none of them".to_owned();
                return Err(ProcessError::Value { what: "column", program: name, name: "normal".to_owned(), problem });
            }
        };
        let set = PointSet::recentered(format, points)?;
        Ok(Self {
            normals: normals.map(|normals| units(&name, set.given(), &normals)).transpose()?,
            set,
            normals_from: "nx, ny, nz of the points".to_owned(),
            columns,
            sources: BTreeMap::new(),
            sensor: None,
            name,
            places: (0..count as u32).collect(),
            left_out: 0,
        })
    }

    /// Number of points, one at least.
    #[must_use]
    pub fn len(&self) -> usize {
        self.set.points().len()
    }

    /// Whether there is no point, which there never is.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.set.points().is_empty()
    }

    /// The points.
    #[must_use]
    pub const fn points(&self) -> &PointSet {
        &self.set
    }

    /// What errors and reports call it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Points of the file that were left out.
    #[must_use]
    pub const fn left_out(&self) -> usize {
        self.left_out
    }

    /// The same points elsewhere.
    ///
    /// # Errors
    /// A place that is not finite in the format.
    pub fn moved(&self, points: Vec<DVec3>) -> Result<Self, ProcessError> {
        Ok(Self { set: PointSet::recentered(self.set.format(), points)?, ..self.clone() })
    }

    /// The first points, or all.
    ///
    /// # Errors
    /// There is none left.
    pub fn limited(&self, limit: Option<usize>) -> Result<Self, ProcessError> {
        let count = limit.unwrap_or(usize::MAX).min(self.len());
        let mut limited = self.moved(self.set.given()[..count].to_vec())?;
        limited.normals.iter_mut().for_each(|normals| normals.truncate(count));
        limited.columns.values_mut().for_each(|values| values.truncate(count));
        limited.places.truncate(count);
        Ok(limited)
    }

    /// Gives numbers of each point a name; `from` says where they come from.
    pub(super) fn insert(&mut self, name: &str, values: Vec<f64>, from: &str) {
        self.columns.insert(name.to_owned(), values);
        self.sources.insert(name.to_owned(), from.to_owned());
    }
}

/// Normals in memory, of length 1.
fn units(name: &str, points: &[DVec3], normals: &[DVec3]) -> Result<Vec<DVec3>, ProcessError> {
    let wrong = |problem: String| {
        let (program, name) = (name.to_owned(), "normal".to_owned());
        ProcessError::Value { what: "column", program, name, problem }
    };
    if let Some(index) = normals.iter().position(|normal| !normal.is_finite()) {
        return Err(wrong(format!("is {} at vertex {index}: expected numbers that are finite", normals[index])));
    }
    crate::scene::normals::normalize(points, normals)
        .map_err(|_| wrong("is zero at all points: expected directions, or no normals".to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cloud(normals: [[f64; 3]; 3]) -> Result<Cloud, ProcessError> {
        let points = (0..3).map(|index| DVec3::X * f64::from(index)).collect();
        let column = |axis: usize| normals.iter().map(|normal| normal[axis]).collect();
        let columns = [("nx", 0), ("ny", 1), ("nz", 2)].map(|(name, axis)| (name.to_owned(), column(axis)));
        Cloud::of(Format::F32, "test".to_owned(), points, columns.into())
    }

    #[test]
    fn normals_in_memory_are_made_ones_of_length_1() {
        let normals = cloud([[0.0, 0.0, 4.0], [0.0, -0.5, 0.0], [0.0; 3]]).map(|cloud| cloud.normals);
        assert_eq!(normals.ok().flatten(), Some(vec![DVec3::Z, -DVec3::Y, -DVec3::Y]), "the third has the nearest's");
        for (normals, part) in [
            ([[0.0; 3]; 3], "column `normal` of `test` is zero at all points"),
            ([[1.0; 3], [0.0, f64::NAN, 0.0], [1.0; 3]], "is [0, NaN, 0] at vertex 1"),
        ] {
            let message = cloud(normals).expect_err("these are no normals").to_string();
            assert!(message.contains(part), "`{part}` is missing in: {message}");
        }
    }
}
