//! How far apart points lie, from which settings are derived.

use crate::scene::neighbors::{self, Distinct, NearPoint};
use crate::search::PointSet;
use glam::DVec3;
use rayon::prelude::*;

/// Points that are measured, evenly chosen.
const MEASURED: usize = 2000;

/// How much farther than the k-th neighbor a weight reaches: neighbors there still weigh `(1 − 1/1.5²)⁴`, a tenth of the
/// nearest.
const REACH: f64 = 1.5;

/// Lengths of a point set. Medians over evenly chosen points; points in one place count once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// From where on a neighbor weighs nothing: the radius of the neighborhoods, or 1.5 times the distance of the k-th
    /// neighbor.
    pub radius: f64,
    /// Distance of the nearest other point.
    pub nearest: f64,
    /// Side of the square that a point stands for on a surface: of its k neighbors' disc, πr²/k.
    pub side: f64,
    /// Edges of the points' box.
    pub extent: DVec3,
    /// Middle of the points' box.
    pub middle: DVec3,
}

impl Scale {
    /// That of points whose queries have `k` neighbors, or those within a radius; `None` where all lie in one place and there
    /// is no radius.
    #[must_use]
    pub fn of(points: &PointSet, k: u32, radius: Option<f64>) -> Option<Self> {
        let distinct = Distinct::of(points.given()).points;
        let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [low, high] = distinct.iter().fold(empty, |[low, high], point| [low.min(*point), high.max(*point)]);
        // The query itself is the nearest of its neighbors.
        let others = (k.max(2) as usize - 1).min(distinct.len() - 1);
        if others == 0 {
            // A single place has the radius for its only length.
            let lengths = |radius| Self { radius, nearest: radius, side: radius, extent: DVec3::ZERO, middle: low };
            return radius.map(lengths);
        }
        let count = distinct.len().min(MEASURED);
        let chosen: Vec<usize> = (0..count).map(|index| index * distinct.len() / count).collect();
        let near = neighbors::nearest_of(&distinct, &chosen, others);
        let reach = median(near.par_iter().filter_map(|near| near.last()).map(|last| last.distance).collect());
        let nearest = median(near.par_iter().filter_map(|near| near.first()).map(|first| first.distance).collect());
        let side = side(reach, others);
        let radius = radius.unwrap_or(REACH * reach);
        Some(Self { radius, nearest, side, extent: high - low, middle: low.midpoint(high) })
    }
}

/// Side of the square that a point stands for whose neighbors' disc has that radius.
fn side(radius: f64, others: usize) -> f64 {
    (std::f64::consts::PI * radius * radius / (others as f64 + 1.0)).sqrt()
}

/// Sides of the squares that points stand for, each by its own `k` neighbors; points in one place stand for one square.
pub fn sides(points: &[DVec3], k: u32) -> Vec<f64> {
    let Distinct { points, places } = Distinct::of(points);
    let others = (k.max(2) as usize - 1).min(points.len() - 1);
    let near = neighbors::nearest(&points, others);
    let side = |near: &Vec<NearPoint>| near.last().map_or(0.0, |last| side(last.distance, others));
    let sides: Vec<f64> = near.par_iter().map(side).collect();
    places.iter().map(|place| sides[*place as usize]).collect()
}

fn median(mut lengths: Vec<f64>) -> f64 {
    let middle = lengths.len() / 2;
    *lengths.select_nth_unstable_by(middle, f64::total_cmp).1
}
