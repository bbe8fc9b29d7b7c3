//! Which points are asked for, and in which order: coherence decides how well caches do.

use super::PointSet;
use super::points::bounds;
use crate::scene::{neighbors, normals};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::fmt;
use std::str::FromStr;

/// Neighbors whose mean distance is the side of a point's cell: those of a square lattice.
const CELL_NEIGHBORS: usize = 4;
/// The most queries on a side of a grid.
const GRID_LIMIT: u32 = 64;
/// Bits of a cell's number along each axis; three of them fit a word.
const MORTON_BITS: u32 = 21;

/// An order of queries made from points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Every point, shuffled: no coherence at all, as the thesis measures (6.7.1).
    Random,
    /// Every point, as the file has them.
    File,
    /// Every point, along a Morton curve.
    Morton,
    /// For every point in the file's order so many columns and rows of queries, spread evenly over its cell of the local tangent
    /// plane, along a Hilbert curve: the thesis' up-sampling (6.7.1).
    Grid {
        /// Queries across a cell.
        columns: u32,
        /// Queries along a cell.
        rows: u32,
    },
}

impl FromStr for Order {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |text: &str| text.parse().ok().filter(|side| (1..=GRID_LIMIT).contains(side));
        match text {
            "random" => Ok(Self::Random),
            "file" => Ok(Self::File),
            "morton" => Ok(Self::Morton),
            _ => {
                let sides = text.strip_prefix("grid:").and_then(|sides| sides.split_once('x'));
                let sides = sides.and_then(|(columns, rows)| Some((side(columns)?, side(rows)?)));
                let grid = sides.map(|(columns, rows)| Self::Grid { columns, rows });
                grid.ok_or_else(|| {
                    format!("expected random, file, morton, or a grid from grid:1x1 to grid:{GRID_LIMIT}x{GRID_LIMIT}")
                })
            }
        }
    }
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Random => f.write_str("random"),
            Self::File => f.write_str("file"),
            Self::Morton => f.write_str("morton"),
            Self::Grid { columns, rows } => write!(f, "grid:{columns}x{rows}"),
        }
    }
}

impl Order {
    /// The first `limit` places asked for, or all of them, in the coordinates in which the points were given; `seed` shuffles.
    #[must_use]
    pub fn places(self, points: &PointSet, limit: Option<usize>, seed: u64) -> Vec<DVec3> {
        match self {
            Self::Grid { columns, rows } => grid(points.given(), [columns, rows], limit),
            _ => self.indices(points, limit, seed).into_iter().map(|index| points.given()[index]).collect(),
        }
    }

    /// The first `limit` points asked for, or all of them, by their indices; for a grid the points that it lies around.
    #[must_use]
    pub fn indices(self, points: &PointSet, limit: Option<usize>, seed: u64) -> Vec<usize> {
        let places = points.given();
        let mut indices: Vec<usize> = (0..places.len()).collect();
        match self {
            Self::Random => fastrand::Rng::with_seed(seed).shuffle(&mut indices),
            Self::File | Self::Grid { .. } => {}
            Self::Morton => {
                let bounds = bounds(places);
                indices.par_sort_by_cached_key(|&index| morton(places[index], bounds));
            }
        }
        indices.truncate(limit.unwrap_or(usize::MAX));
        indices
    }
}

/// The order in which `count` queries are asked when cut into `runs` of equal length that take turns, so that neighbors in a run are
/// not under way at the same time (thesis 6.6.3).
pub(super) fn interleaved(count: usize, runs: usize) -> Vec<usize> {
    let length = count.div_ceil(runs.max(1)).max(1);
    (0..length).flat_map(|place| (place..count).step_by(length)).collect()
}

/// The number of a point's cell along the curve through all cells of the bounding cube.
fn morton(point: DVec3, [low, high]: [DVec3; 2]) -> u64 {
    let cells = (1_u64 << MORTON_BITS) - 1;
    let side = (high - low).max_element().max(f64::MIN_POSITIVE);
    let place = (point - low) / side * cells as f64;
    let spread = |cell: f64| (0..MORTON_BITS).fold(0, |code, bit| code | (cell as u64 >> bit & 1) << (3 * bit));
    spread(place.x) | spread(place.y) << 1 | spread(place.z) << 2
}

/// The cells of a grid along a Hilbert curve, by column and row: each next to the one before where the grid is square and its
/// side a power of two, and near it elsewhere.
fn cells(columns: u32, rows: u32) -> Vec<DVec2> {
    let order = columns.max(rows).next_power_of_two().ilog2();
    let curve = (0..1_u64 << (2 * order)).map(|place| fast_hilbert::h2xy::<u32>(place, order as u8));
    let inside = curve.filter(|(column, row)| *column < columns && *row < rows);
    inside.map(|(column, row)| DVec2::new(column.into(), row.into())).collect()
}

fn grid(positions: &[DVec3], [columns, rows]: [u32; 2], limit: Option<usize>) -> Vec<DVec3> {
    let (cells, sides) = (cells(columns, rows), DVec2::new(columns.into(), rows.into()));
    let cells = &cells;
    let neighbors = neighbors::nearest(positions, normals::FITTED_NEIGHBORS);
    let count = limit.map_or(positions.len(), |limit| limit.div_ceil(cells.len()).min(positions.len()));
    let around = |index: usize| {
        let (first, second) = normals::fit(positions, index, &neighbors[index]).any_orthonormal_pair();
        let near = neighbors[index].iter().take(CELL_NEIGHBORS);
        let side = near.clone().map(|neighbor| neighbor.distance).sum::<f64>() / near.len().max(1) as f64;
        let position = positions[index];
        cells.iter().map(move |cell| {
            let offset = side * ((*cell + 0.5) / sides - 0.5);
            position + offset.x * first + offset.y * second
        })
    };
    let mut places: Vec<_> = (0..count).into_par_iter().flat_map_iter(around).collect();
    places.truncate(limit.unwrap_or(usize::MAX));
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::PointSource;
    use pointcore_contract::Format;

    fn plane() -> PointSet {
        let points: Vec<_> = (0..100_u8).map(|index| [f32::from(index % 10), 2.0, f32::from(index / 10)]).collect();
        PointSet::new(Format::F32, &points).expect("the points are finite")
    }

    #[test]
    fn orders_are_read_as_they_are_written() {
        for text in ["random", "file", "morton", "grid:8x8", "grid:1x64"] {
            assert_eq!(text.parse::<Order>().map(|order| order.to_string()), Ok(text.to_owned()));
        }
        for text in ["sorted", "grid:", "grid:8", "grid:0x8", "grid:8x65", "grid:-1x2"] {
            assert!(text.parse::<Order>().is_err(), "{text}");
        }
    }

    #[test]
    fn every_point_is_asked_for_once() {
        let points = plane();
        let sorted = |mut places: Vec<DVec3>| {
            places.sort_by(|a, b| a[2].total_cmp(&b[2]).then(a[0].total_cmp(&b[0])));
            places
        };
        for order in [Order::Random, Order::File, Order::Morton] {
            let places = order.places(&points, None, 1);
            assert_eq!(sorted(places.clone()), points.given(), "{order}");
            assert_eq!(order.places(&points, Some(7), 1), places[..7], "{order}");
        }
        assert_ne!(Order::Random.places(&points, None, 1), Order::Random.places(&points, None, 2));
    }

    #[test]
    fn a_grid_is_walked_cell_by_cell() {
        for (columns, rows) in [(1, 1), (2, 2), (8, 8), (3, 5), (64, 1)] {
            let cells = cells(columns, rows);
            assert_eq!(cells.len(), (columns * rows) as usize);
            assert!((0..cells.len()).all(|index| !cells[index + 1..].contains(&cells[index])), "{columns}×{rows}");
        }
        assert!(cells(8, 8).windows(2).all(|pair| pair[0].distance(pair[1]) == 1.0));
    }

    #[test]
    fn a_morton_curve_keeps_neighbors_together() {
        let points = PointSet::load(Format::F32, &PointSource::Surface(4000)).expect("the surface is finite");
        let length = |order: Order| {
            let places = order.places(&points, None, 1);
            let step = |pair: &[DVec3]| pair[0].distance(pair[1]);
            places.windows(2).map(step).sum::<f64>()
        };
        assert!(length(Order::Morton) * 10.0 < length(Order::Random));
        assert_eq!(morton(DVec3::ONE, [DVec3::ZERO, DVec3::ONE]), (1 << (3 * MORTON_BITS)) - 1);
        assert_eq!(morton(DVec3::ONE, [DVec3::ONE, DVec3::ONE]), 0, "a single point has a cell");
    }

    #[test]
    fn grids_cover_the_cells_of_a_plane() {
        let places = Order::Grid { columns: 2, rows: 4 }.places(&plane(), None, 1);
        assert_eq!(places.len(), 800);
        assert!(places.iter().all(|place| (place[1] - 2.0).abs() < 1e-5), "queries lie in the plane");
        // An inner point's four neighbors are 1 away: its cell has side 1.
        let around: Vec<_> = places[8 * 55..][..8].iter().map(|place| [place[0] - 5.0, place[2] - 5.0]).collect();
        let widest = around.iter().flatten().fold(0.0_f64, |widest, offset| widest.max(offset.abs()));
        assert!((widest - 0.375).abs() < 1e-5, "{around:?}");
        assert_eq!(Order::Grid { columns: 2, rows: 4 }.places(&plane(), Some(13), 1), places[..13]);
    }

    #[test]
    fn interleaved_runs_take_turns() {
        assert_eq!(interleaved(7, 3), [0, 3, 6, 1, 4, 2, 5]);
        assert_eq!(interleaved(4, 1), [0, 1, 2, 3]);
        assert_eq!(interleaved(3, 9), [0, 1, 2]);
        assert!(interleaved(0, 4).is_empty());
    }
}
