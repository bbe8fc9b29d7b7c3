//! Normals of points: from triangles, or estimated from neighbors and oriented consistently.

use super::neighbors::{self, Distinct, NearPoint};
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Neighbors that a tangent plane is fitted to: enough to average noise, few enough to follow curvature.
pub const FITTED_NEIGHBORS: usize = 16;

/// The sum of the normals of the triangles around each point, weighted by their areas.
#[must_use]
pub fn of_triangles(points: &[DVec3], triangles: &[[u32; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; points.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|index| points[index as usize]);
        let twice_area = (b - a).cross(c - a);
        for index in triangle {
            normals[*index as usize] += twice_area;
        }
    }
    normals
}

/// Normals of unit length; a point without one, such as a vertex of no face, takes that of the nearest point with one.
///
/// # Errors
/// No point has a normal.
pub fn normalize(points: &[DVec3], normals: &[DVec3]) -> Result<Vec<DVec3>, String> {
    let known: Vec<_> = (0..points.len()).filter(|&index| normals[index].try_normalize().is_some()).collect();
    if known.is_empty() {
        return Err("all normals are zero: use `normals = \"estimate\"`".to_owned());
    }
    let coordinates: Vec<[f64; 3]> = known.iter().map(|&index| points[index].to_array()).collect();
    let tree = kiddo::ImmutableKdTree::<f64, 3>::new_from_slice(&coordinates);
    let unit = |(point, normal): (&DVec3, &DVec3)| {
        normal.try_normalize().unwrap_or_else(|| {
            let nearest = tree.nearest_one::<kiddo::SquaredEuclidean>(&point.to_array());
            normals[known[nearest.item as usize]].normalize()
        })
    };
    Ok(points.par_iter().zip(normals).map(unit).collect())
}

/// Estimates unit normals: the direction in which the nearest neighbors spread least, oriented so that neighbors
/// agree, outwards at the highest point of every connected part (Hoppe et al. 1992).
///
/// # Errors
/// There are too few points to span a plane.
pub fn estimate(points: &[DVec3]) -> Result<Vec<DVec3>, String> {
    const PLANE: usize = 3;
    if points.len() < PLANE {
        return Err(format!(
            "has no normals, and its {} vertices are too few to estimate them: add normals, or at least {PLANE} vertices",
            points.len()
        ));
    }
    let neighbors = neighbors::nearest(points, FITTED_NEIGHBORS);
    let mut normals: Vec<_> =
        (0..points.len()).into_par_iter().map(|index| fit(points, index, &neighbors[index])).collect();
    orient(points, &neighbors, &mut normals);
    Ok(normals)
}

/// Turns normals so that neighbors agree, as [`estimate`] does; points in one place have the normal of the first of them.
#[must_use]
pub fn oriented(points: &[DVec3], normals: &[DVec3]) -> Vec<DVec3> {
    let distinct = Distinct::of(points);
    let mut found = vec![None; distinct.points.len()];
    for (place, normal) in distinct.places.iter().zip(normals) {
        found[*place as usize].get_or_insert(*normal);
    }
    let mut normals: Vec<DVec3> = found.into_iter().flatten().collect();
    let neighbors = neighbors::nearest(&distinct.points, FITTED_NEIGHBORS);
    orient(&distinct.points, &neighbors, &mut normals);
    distinct.spread(&normals)
}

/// How points spread in space: along three axes across each other, by these variances, the least first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Variances along the axes.
    pub variances: [f64; 3],
    /// Unit vectors.
    pub axes: [DVec3; 3],
}

/// Of points on a line, the share of the greatest variance that the middle one may have by rounding.
const LINE_SHARE: f64 = 1e-10;

impl Spread {
    /// That of a point and its neighbors around their mean.
    #[must_use]
    pub fn of(points: &[DVec3], index: usize, neighbors: &[NearPoint]) -> Self {
        let near: Vec<_> =
            neighbors.iter().map(|neighbor| points[neighbor.index as usize]).chain([points[index]]).collect();
        let mean = near.iter().sum::<DVec3>() / near.len() as f64;
        let product = |v: &DVec3| {
            DMat3::from_cols((v - mean) * (v - mean).x, (v - mean) * (v - mean).y, (v - mean) * (v - mean).z)
        };
        let (values, vectors) = eigen(near.iter().map(product).fold(DMat3::ZERO, |sum, term| sum + term));
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
        Self {
            variances: order.map(|axis| values[axis].max(0.0) / near.len() as f64),
            axes: order.map(|axis| vectors.col(axis).normalize()),
        }
    }

    /// Whether the points span a plane: those of a line, or of one place, have no normal.
    #[must_use]
    pub fn is_plane(&self) -> bool {
        self.variances[1] > LINE_SHARE * self.variances[2]
    }
}

/// The unit normal of the plane that a point and its neighbors spread around least, pointing to either side.
#[must_use]
pub fn fit(points: &[DVec3], index: usize, neighbors: &[NearPoint]) -> DVec3 {
    Spread::of(points, index, neighbors).axes[0]
}

/// The eigenvalues and unit eigenvectors of a symmetric matrix, by cyclic Jacobi rotations.
fn eigen(mut matrix: DMat3) -> ([f64; 3], DMat3) {
    // Convergence is quadratic: a 3×3 matrix is diagonal to the last bit after about five sweeps.
    const SWEEPS: usize = 8;
    let mut vectors = DMat3::IDENTITY;
    for (row, column) in [(0, 1), (0, 2), (1, 2)].into_iter().cycle().take(3 * SWEEPS) {
        let off_diagonal = matrix.col(column)[row];
        if off_diagonal == 0.0 {
            continue;
        }
        let slope = (matrix.col(column)[column] - matrix.col(row)[row]) / (2.0 * off_diagonal);
        let tangent = slope.signum() / (slope.abs() + (slope * slope + 1.0).sqrt());
        let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
        let sine = tangent * cosine;
        let mut rotation = DMat3::IDENTITY;
        rotation.col_mut(row)[row] = cosine;
        rotation.col_mut(column)[column] = cosine;
        rotation.col_mut(column)[row] = sine;
        rotation.col_mut(row)[column] = -sine;
        matrix = rotation.transpose() * matrix * rotation;
        vectors *= rotation;
    }
    ([0, 1, 2].map(|axis| matrix.col(axis)[axis]), vectors)
}

/// Which side normals point to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Orientation {
    /// To that of their neighbors, along a minimum spanning tree.
    Tree,
    /// Towards a sensor at this place.
    Viewpoint(DVec3),
}

/// Normals estimated from neighbors, where there is a plane to have one.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Unit normals; zero where neighbors lie on a line or in one place.
    pub normals: Vec<DVec3>,
    /// Points whose normal points to the other side than at least half of their neighbors' do.
    pub disagreeing: usize,
}

/// Neighbors whose normals are asked whether they agree.
const ASKED_NEIGHBORS: usize = 6;

impl Estimate {
    /// Estimates the normals of any points, few or repeated as they may be.
    #[must_use]
    pub fn of(points: &[DVec3], orientation: Orientation) -> Self {
        let distinct = Distinct::of(points);
        let neighbors = neighbors::nearest(&distinct.points, FITTED_NEIGHBORS);
        let normal = |index: usize| {
            let spread = Spread::of(&distinct.points, index, &neighbors[index]);
            if spread.is_plane() { spread.axes[0] } else { DVec3::ZERO }
        };
        let mut normals: Vec<_> = (0..distinct.points.len()).into_par_iter().map(normal).collect();
        match orientation {
            Orientation::Tree => orient(&distinct.points, &neighbors, &mut normals),
            Orientation::Viewpoint(sensor) => {
                for (normal, point) in normals.iter_mut().zip(&distinct.points) {
                    if normal.dot(sensor - point) < 0.0 {
                        *normal = -*normal;
                    }
                }
            }
        }
        let disagrees = |(normal, neighbors): (&DVec3, &Vec<NearPoint>)| {
            let asked = neighbors.iter().take(ASKED_NEIGHBORS);
            let turned = asked.map(|neighbor| normal.dot(normals[neighbor.index as usize])).filter(|dot| *dot < 0.0);
            let turned = turned.count();
            turned > 0 && 2 * turned >= neighbors.len().min(ASKED_NEIGHBORS)
        };
        let disagreeing = normals.iter().zip(&neighbors).filter(|pair| disagrees(*pair)).count();
        Self { normals: distinct.spread(&normals), disagreeing }
    }
}

/// An edge of the neighborhood graph from an oriented point to one that may not be oriented yet.
struct Edge {
    /// `1 − |cos|` of the angle between the normals.
    cost: f64,
    from: u32,
    to: u32,
}

impl Ord for Edge {
    /// The heap's greatest edge is that of the least cost; indices make the order total and so the result unique.
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost).then((other.from, other.to).cmp(&(self.from, self.to)))
    }
}

impl PartialOrd for Edge {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Edge {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Edge {}

/// Flips normals along a minimum spanning tree (Prim's) of the symmetric neighborhood graph, so that orientation
/// travels where the surface is flat and crosses sharp edges last.
fn orient(points: &[DVec3], neighbors: &[Vec<NearPoint>], normals: &mut [DVec3]) {
    let mut adjacent: Vec<Vec<u32>> = vec![Vec::new(); points.len()];
    for (from, neighbors) in (0..).zip(neighbors) {
        for neighbor in neighbors {
            adjacent[from as usize].push(neighbor.index);
            adjacent[neighbor.index as usize].push(from);
        }
    }
    // The highest point of a part that is not reached yet lies on its outside, whose normal points up there.
    let mut highest_first: Vec<_> = (0..points.len()).collect();
    highest_first.sort_by(|&a, &b| points[b].z.total_cmp(&points[a].z));
    let mut oriented = vec![false; points.len()];
    let mut frontier = BinaryHeap::new();
    for start in highest_first {
        if oriented[start] {
            continue;
        }
        if normals[start].z < 0.0 {
            normals[start] = -normals[start];
        }
        oriented[start] = true;
        let mut newest = start;
        loop {
            for &to in &adjacent[newest] {
                if !oriented[to as usize] {
                    let cost = 1.0 - normals[newest].dot(normals[to as usize]).abs();
                    frontier.push(Edge { cost, from: newest as u32, to });
                }
            }
            let next = std::iter::from_fn(|| frontier.pop()).find(|edge: &Edge| !oriented[edge.to as usize]);
            let Some(Edge { from, to, .. }) = next else { break };
            newest = to as usize;
            if normals[newest].dot(normals[from as usize]) < 0.0 {
                normals[newest] = -normals[newest];
            }
            oriented[newest] = true;
        }
    }
}
