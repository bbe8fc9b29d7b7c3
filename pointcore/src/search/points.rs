//! Point sets in the core's format: from files, procedural, or given.

use super::SearchError;
use crate::number::{decode, encode};
use crate::scene::{Model, trefoil};
use glam::DVec3;
use pointcore_contract::Format;
use pointcore_contract::search::records::Point;
use rayon::prelude::*;
use std::path::PathBuf;
use std::str::FromStr;

/// Points whose coordinates are numbers of the core's format: what a search refers to, and what it is checked against.
#[derive(Clone, Debug, PartialEq)]
pub struct PointSet {
    format: Format,
    points: Vec<[f32; 3]>,
}

impl PointSet {
    /// Rounds points to the core's format.
    ///
    /// # Errors
    /// There is no point, or one whose coordinates are not finite in that format.
    pub fn new(format: Format, points: &[[f32; 3]]) -> Result<Self, SearchError> {
        if points.is_empty() {
            return Err(SearchError::NoPoint);
        }
        let round = |point: &[f32; 3]| point.map(|number| decode(format, encode(format, number)));
        let rounded: Vec<[f32; 3]> = points.par_iter().map(round).collect();
        match rounded.iter().position(|point| !point.iter().all(|number| number.is_finite())) {
            Some(index) => Err(SearchError::Coordinate { index, point: points[index], format }),
            None => Ok(Self { format, points: rounded }),
        }
    }

    /// Loads or makes the points of a source.
    ///
    /// # Errors
    /// The file cannot be used.
    pub fn load(format: Format, source: &PointSource) -> Result<Self, SearchError> {
        let points = match source {
            PointSource::File(path) => Model::load(path)?.points,
            PointSource::Surface(count) => trefoil(*count),
        };
        let single: Vec<[f32; 3]> = points.iter().map(|point: &DVec3| point.as_vec3().to_array()).collect();
        Self::new(format, &single)
    }

    /// The core's format.
    #[must_use]
    pub const fn format(&self) -> Format {
        self.format
    }

    /// The points in the order in which they were given.
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
    /// A PLY or OBJ file.
    File(PathBuf),
    /// So many points of a procedural surface, a trefoil knot.
    Surface(usize),
}

impl PointSource {
    /// The most points of a procedural surface.
    pub const SURFACE_LIMIT: usize = 4_000_000;
    const SURFACE: &str = "surface:";
}

impl FromStr for PointSource {
    type Err = String;

    /// `surface:COUNT` or a path.
    fn from_str(text: &str) -> Result<Self, String> {
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
    fn points_that_are_nowhere_are_named() {
        let message = |points: &[[f32; 3]]| PointSet::new(Format::F24, points).unwrap_err().to_string();
        assert!(message(&[]).contains("empty"));
        assert!(message(&[[0.0; 3], [0.0, f32::NAN, 0.0]]).contains("vertex 1"));
        assert!(message(&[[f32::INFINITY, 0.0, 0.0]]).contains("vertex 0"));
        assert!(message(&[[f32::MAX; 3]]).contains("f24"), "what rounds to infinity is not finite");
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
