//! Point sets in the core's format: from files, procedural, or given.

use super::SearchError;
use crate::number::{decode, encode};
use crate::scene::{InvalidPoints, Model, trefoil};
use glam::DVec3;
use pointcore_contract::Format;
use pointcore_contract::search::records::Point;
use rayon::prelude::*;
use std::path::PathBuf;
use std::str::FromStr;

/// Points whose coordinates are numbers of the core's format: what a search refers to, and what it is checked against.
///
/// They are relative to an origin, and remember where they were given.
#[derive(Clone, Debug, PartialEq)]
pub struct PointSet {
    format: Format,
    origin: DVec3,
    points: Vec<[f32; 3]>,
    given: Vec<DVec3>,
    left_out: Vec<u32>,
}

impl PointSet {
    /// Rounds points to the core's format where they are.
    ///
    /// # Errors
    /// There is no point, or one whose coordinates are not finite in that format.
    pub fn new(format: Format, points: &[[f32; 3]]) -> Result<Self, SearchError> {
        let given = points.iter().map(|point| DVec3::from_array(point.map(f64::from))).collect();
        Self::about(format, DVec3::ZERO, given)
    }

    /// Rounds points to the core's format, relative to an origin among them where they lie far from zero: what is near a point
    /// with large coordinates is lost in their rounding.
    ///
    /// # Errors
    /// There is no point, or one whose coordinates are not finite in that format.
    pub fn recentered(format: Format, points: Vec<DVec3>) -> Result<Self, SearchError> {
        Self::about(format, origin(format, &points), points)
    }

    pub(super) fn about(format: Format, origin: DVec3, given: Vec<DVec3>) -> Result<Self, SearchError> {
        if given.is_empty() {
            return Err(SearchError::NoPoint);
        }
        let mut set = Self { format, origin, points: Vec::new(), given, left_out: Vec::new() };
        set.points = set.given.par_iter().map(|point| set.rounded(*point)).collect();
        match set.points.iter().position(|point| !point.iter().all(|number| number.is_finite())) {
            Some(index) => Err(SearchError::Coordinate { index, point: set.given[index].as_vec3().to_array(), format }),
            None => Ok(set),
        }
    }

    /// Loads or makes the points of a source.
    ///
    /// # Errors
    /// The file cannot be used.
    pub fn load(format: Format, source: &PointSource) -> Result<Self, SearchError> {
        Self::load_with(format, source, InvalidPoints::Refuse)
    }

    /// Loads or makes the points of a source; of a file's points those that are no numbers may be left out.
    ///
    /// # Errors
    /// The file cannot be used.
    pub fn load_with(format: Format, source: &PointSource, invalid: InvalidPoints) -> Result<Self, SearchError> {
        let (points, left_out) = source.points_with(invalid)?;
        Ok(Self { left_out, ..Self::recentered(format, points)? })
    }

    /// How many points of the file were left out.
    #[must_use]
    pub fn left_out(&self) -> usize {
        self.left_out.len()
    }

    /// The place of each point in its file, those that were left out counted.
    #[must_use]
    pub fn places(&self) -> Vec<u32> {
        let mut left_out = self.left_out.iter().peekable();
        let is_kept = |place: &u32| left_out.next_if_eq(&place).is_none();
        (0..).filter(is_kept).take(self.points.len()).collect()
    }

    /// A place in the given coordinates as the core sees it: relative to the origin, rounded to the core's format.
    #[must_use]
    pub fn rounded(&self, place: DVec3) -> [f32; 3] {
        (place - self.origin).as_vec3().to_array().map(|number| decode(self.format, encode(self.format, number)))
    }

    /// What the core's coordinates are relative to, in the given ones.
    #[must_use]
    pub const fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The points as they were given.
    #[must_use]
    pub fn given(&self) -> &[DVec3] {
        &self.given
    }

    /// The core's format.
    #[must_use]
    pub const fn format(&self) -> Format {
        self.format
    }

    /// The points in the core's coordinates, in the order in which they were given.
    #[must_use]
    pub fn points(&self) -> &[[f32; 3]] {
        &self.points
    }

    /// The points as the core encodes them.
    #[must_use]
    pub fn encoded(&self) -> Vec<Point> {
        self.points.iter().map(|point| point.map(|number| encode(self.format, number))).collect()
    }
}

/// Where points come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PointSource {
    /// A model file.
    File(PathBuf),
    /// So many points of a procedural surface, a trefoil knot.
    Surface(usize),
}

impl PointSource {
    /// The most points of a procedural surface.
    pub const SURFACE_LIMIT: usize = 4_000_000;
    const SURFACE: &str = "surface:";

    /// The points, as they are in the file.
    ///
    /// # Errors
    /// The file cannot be used.
    pub fn points(&self, invalid: InvalidPoints) -> Result<Vec<DVec3>, SearchError> {
        Ok(self.points_with(invalid)?.0)
    }

    /// The points, and the places in the file of those that were left out.
    fn points_with(&self, invalid: InvalidPoints) -> Result<(Vec<DVec3>, Vec<u32>), SearchError> {
        Ok(match self {
            Self::File(path) => {
                let model = Model::load_with(path, invalid)?;
                (model.points, model.dropped)
            }
            Self::Surface(count) => (trefoil(*count), Vec::new()),
        })
    }
}

/// An origin near the middle of points: zero where they lie around it, or lose nothing there. Its coordinates are round numbers,
/// and those of the points relative to it are exact.
fn origin(format: Format, points: &[DVec3]) -> DVec3 {
    let exact = |number: f64| f64::from(decode(format, encode(format, number as f32))) == number;
    let [low, high] = bounds(points);
    let side = (high - low).max_element();
    let is_far = low.abs().max(high.abs()).max_element() > side;
    if !is_far || !side.is_finite() || points.par_iter().all(|point| point.to_array().into_iter().all(exact)) {
        return DVec3::ZERO;
    }
    let middle = low.midpoint(high);
    if side == 0.0 { middle } else { (middle / decade(side)).round() * decade(side) }
}

/// The greatest power of ten that a length reaches.
fn decade(length: f64) -> f64 {
    10_f64.powf(length.log10().floor())
}

/// Opposite corners of the points' box.
pub(super) fn bounds(points: &[DVec3]) -> [DVec3; 2] {
    let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    points.iter().fold(empty, |[low, high], point| [low.min(*point), high.max(*point)])
}

impl FromStr for PointSource {
    type Err = String;

    /// `surface:COUNT` or a path.
    fn from_str(text: &str) -> Result<Self, String> {
        if text.is_empty() {
            return Err(format!("expected a model file, or {}COUNT", Self::SURFACE));
        }
        let Some(count) = text.strip_prefix(Self::SURFACE) else { return Ok(Self::File(text.into())) };
        match count.parse() {
            Ok(count) if (1..=Self::SURFACE_LIMIT).contains(&count) => Ok(Self::Surface(count)),
            _ => Err(format!("`{count}` points: expected a number from 1 to {}", Self::SURFACE_LIMIT)),
        }
    }
}

impl std::fmt::Display for PointSource {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::File(path) => write!(f, "{}", path.display()),
            Self::Surface(count) => write!(f, "{}{count}", Self::SURFACE),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_rounded_to_the_format_once() {
        let points = [[1.0, -0.1, 1e-40]];
        let in_format = |format| PointSet::new(format, &points).expect("the points are finite").points()[0];
        assert_eq!(in_format(Format::F32), points[0]);
        assert_eq!(in_format(Format::F32.flushed()), [1.0, -0.1, 0.0]);
        let [one, tenth, _] = in_format(Format::F24);
        assert_eq!(one, 1.0);
        assert!(tenth != -0.1 && (tenth + 0.1).abs() < 0.1 / f32::from(1_u16 << 15));
        let again = PointSet::new(Format::F24, &[in_format(Format::F24)]).expect("the points are finite");
        assert_eq!(again.points()[0], in_format(Format::F24));
    }

    #[test]
    fn points_far_from_zero_are_seen_from_among_them() {
        let map = DVec3::new(412_345.67, 5_654_321.09, 120.0);
        let scan: Vec<_> = (0..50).map(|i| map + DVec3::new(0.31 * f64::from(i), 0.1, 0.02)).collect();
        let set = PointSet::recentered(Format::F32, scan.clone()).expect("the points are finite");
        assert_eq!(set.origin(), DVec3::new(412_350.0, 5_654_320.0, 120.0), "round numbers");
        for (point, given) in set.points().iter().zip(&scan) {
            let back = DVec3::from_array(point.map(f64::from)) + set.origin();
            assert!(back.distance(*given) < 1e-6, "{back} {given}");
        }
        assert_eq!(set.rounded(scan[7]), set.points()[7]);
        let alone = PointSet::recentered(Format::F32, vec![map; 3]).expect("the points are finite");
        assert_eq!((alone.origin(), alone.points()[0]), (map, [0.0; 3]));
    }

    #[test]
    fn points_that_lose_nothing_or_little_stay_where_they_are() {
        let origin = |points: &[[f64; 3]]| {
            let points = points.iter().map(|point| DVec3::from_array(*point)).collect();
            PointSet::recentered(Format::F32, points).expect("the points are finite").origin()
        };
        assert_eq!(origin(&[[4e6, 0.0, 0.0], [4e6 + 1.0, 0.0, 0.0]]), DVec3::ZERO, "they are numbers of f32");
        assert_eq!(origin(&[[0.1, 0.0, 0.0], [-0.3, 0.2, 0.9]]), DVec3::ZERO, "they lie around zero");
    }

    #[test]
    fn points_that_are_nowhere_are_named() {
        let message = |points: &[[f32; 3]]| PointSet::new(Format::F24, points).unwrap_err().to_string();
        assert!(message(&[]).contains("empty"));
        assert!(message(&[[0.0; 3], [0.0, f32::NAN, 0.0]]).contains("vertex 1"));
        assert!(message(&[[f32::INFINITY, 0.0, 0.0]]).contains("vertex 0"));
        assert!(message(&[[f32::MAX; 3]]).contains("f24"), "what rounds to infinity is not finite");
    }

    #[test]
    fn points_left_out_keep_the_places_of_the_others() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("scan.xyz");
        std::fs::write(&path, "nan 0 0\n1 0 0\n2 0 0\n0 nan 0\n4 0 0\n").expect("the folder is writable");
        let load = |invalid| PointSet::load_with(Format::F32, &PointSource::File(path.clone()), invalid);
        let points = load(InvalidPoints::Drop).expect("three are numbers");
        assert_eq!((points.left_out(), points.places()), (2, vec![1, 2, 4]));
        assert!(load(InvalidPoints::Refuse).is_err_and(|error| error.to_string().contains("vertex 0")));
    }

    #[test]
    fn sources_are_paths_or_surfaces() {
        assert_eq!("surface:7".parse(), Ok(PointSource::Surface(7)));
        assert_eq!("a/b.ply".parse(), Ok(PointSource::File("a/b.ply".into())));
        assert!("surface:0".parse::<PointSource>().is_err() && "surface:x".parse::<PointSource>().is_err());
        let surface = PointSet::load(Format::F32, &PointSource::Surface(500)).expect("the surface is finite");
        assert_eq!(surface.points().len(), 500);
    }
}
