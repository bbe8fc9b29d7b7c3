//! Results on their way back to the queries they belong to.

use super::query::{Asked, Neighbor};
use super::work::Work;
use crate::number::decode;
use pointcore_contract::search::records::{CachedQuery, CachedResult, Query, QueryResult};
use pointcore_golden::search::leaf::squared_distance;

/// A query that is not answered yet.
#[derive(Clone, Copy)]
struct UnderWay {
    number: u32,
    index: usize,
    /// When it was offered.
    since: u64,
}

/// Queries under way, and the neighbors of those that are answered.
#[derive(Clone)]
pub struct Answers<'a> {
    work: Work<'a>,
    under_way: Vec<UnderWay>,
    answered: usize,
    neighbors: Vec<Vec<Neighbor>>,
    cycles: Vec<u32>,
}

impl<'a> Answers<'a> {
    pub fn new(work: Work<'a>) -> Self {
        Self {
            work,
            under_way: Vec::new(),
            answered: 0,
            neighbors: vec![Vec::new(); work.queries.len()],
            cycles: vec![0; work.queries.len()],
        }
    }

    pub const fn answered(&self) -> usize {
        self.answered
    }

    /// Neighbors by query, and cycles from a query's offer to its last result.
    pub fn into_results(self) -> (Vec<Vec<Neighbor>>, Vec<u32>) {
        (self.neighbors, self.cycles)
    }

    /// The query of this index with a number; `None` while its number is under way, for numbers repeat.
    pub fn number(&self, index: usize) -> Option<CachedQuery> {
        let sent = self.work.queries.get(index)?.sent;
        let number = (index as u64 & ((1 << self.work.config.index_bits) - 1)) as u32;
        let free = self.under_way.iter().all(|other| other.number != number);
        free.then_some(CachedQuery { query: Query { number, ..sent.query }, ..sent })
    }

    /// The query of this index is on offer.
    pub fn offered(&mut self, query: &CachedQuery, index: usize, since: u64) {
        self.under_way.push(UnderWay { number: query.query.number, index, since });
    }

    /// Takes a result of a cycle.
    pub fn collect(&mut self, CachedResult { result, cached }: CachedResult, cycle: u64) {
        let place = self.under_way.iter().position(|query| query.number == result.number);
        let place = place.expect("results bear the number of a query under way");
        let UnderWay { index, since, .. } = self.under_way[place];
        if result.found {
            let neighbor = self.neighbor(&result, cached, &self.work.queries[index]);
            self.neighbors[index].push(neighbor);
        }
        if result.last {
            self.under_way.swap_remove(place);
            self.answered += 1;
            self.cycles[index] = u32::try_from(cycle + 1 - since).unwrap_or(u32::MAX);
            if self.work.config.neighbor_cache > 0 {
                self.trim(index);
            }
        }
    }

    fn neighbor(&self, result: &QueryResult, cached: bool, asked: &Asked) -> Neighbor {
        let (tree, format) = (self.work.tree, self.work.config.geometry);
        let point = tree.source(result.index).expect("neighbors are points, not places without one");
        // A reused neighborhood bears the distances to another query.
        let distance2 = if cached {
            squared_distance(format, tree.memory()[result.index as usize], asked.sent.query.point)
        } else {
            result.distance2
        };
        Neighbor { point, distance2: decode(format, distance2) }
    }

    /// A neighbor cache answers with more than was wanted, in the order of another query.
    fn trim(&mut self, index: usize) {
        let Asked { k, radius2, .. } = self.work.queries[index];
        let radius2 = decode(self.work.config.geometry, radius2);
        let neighbors = &mut self.neighbors[index];
        neighbors.retain(|neighbor| neighbor.distance2 < radius2);
        neighbors.sort_by(|a, b| a.distance2.total_cmp(&b.distance2));
        neighbors.truncate(k);
    }
}
