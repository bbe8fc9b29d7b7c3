//! A query on its way through a program: iterations of `init`, `kernel` and `final` (thesis listing 6.3).
//!
//! State and sums begin as zeros of all bits, the sums in every iteration. State that a block stores is seen by the
//! blocks behind it. A query that is not done begins its next iteration with the neighbors it has, or with those of its
//! position if the program asks for them. One that is not done after the last iteration it may have leaves with its
//! outputs as they are, and is marked.

use super::block::Blocks;
use pointcore_contract::Format;
use pointcore_contract::process::{PARTIAL_SUMS, Program, Scalar, Section, Source, Store};

/// The neighbors of a query, in the order in which they come.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Neighborhood {
    /// Words of each, as the program's layout has them.
    pub neighbors: Vec<Vec<u32>>,
    /// Position of the farthest one, if there is one.
    pub farthest: usize,
}

/// A query that left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Words of the outputs.
    pub outputs: Vec<u32>,
    /// Iterations that it took.
    pub iterations: u32,
    /// It was not done, but had no iteration left.
    pub capped: bool,
}

/// A program with its settings.
#[derive(Clone, Debug)]
pub struct Interpreter {
    blocks: Blocks,
    settings: Vec<u32>,
    iterations_max: u32,
    /// Types of the sums' words.
    sums: Vec<Scalar>,
}

/// What blocks read of a query.
struct Query {
    words: Vec<u32>,
    state: Vec<u32>,
    count: u32,
    neighbors: Neighborhood,
    partial: Vec<[u32; PARTIAL_SUMS]>,
}

impl Interpreter {
    /// The program with floats of `format`, a word for each of its settings, and so many iterations at most.
    ///
    /// # Panics
    /// If there are not as many words as the settings have, or no iteration.
    #[must_use]
    pub fn new(program: Program, format: Format, settings: Vec<u32>, iterations_max: u32) -> Self {
        assert_eq!(settings.len(), program.settings.len(), "a word for each of the settings");
        assert!(iterations_max > 0, "a query has an iteration");
        let sums = program.sums.words().into_iter().map(|word| word.ty).collect();
        Self { blocks: Blocks::new(program, format), settings, iterations_max, sums }
    }

    /// The way of a query, given by its words. `search` answers the neighbors of a position.
    ///
    /// # Panics
    /// If the query or a neighbor does not have as many words as its layout.
    #[must_use]
    pub fn run(&self, words: &[u32], mut search: impl FnMut([u32; 3]) -> Neighborhood) -> Outcome {
        let program = self.blocks.program();
        assert_eq!(words.len(), program.query.len(), "a word for each of the query");
        let neighbors = self.found(search(position(words)));
        let state = vec![0; program.state.len()];
        let mut query = Query { words: words.to_vec(), state, count: 0, neighbors, partial: vec![] };
        loop {
            let (outputs, done, anew) = self.iterate(&mut query);
            query.count += 1;
            let capped = !done && query.count == self.iterations_max;
            if done || capped {
                return Outcome { outputs, iterations: query.count, capped };
            }
            if anew {
                query.neighbors = self.found(search(position(&query.words)));
            }
        }
    }

    fn found(&self, neighborhood: Neighborhood) -> Neighborhood {
        let words = self.blocks.program().neighbor.len();
        let fits = neighborhood.neighbors.iter().all(|neighbor| neighbor.len() == words);
        assert!(fits, "a word for each of a neighbor");
        neighborhood
    }

    /// The three blocks; returns outputs, whether the query is done and whether it needs other neighbors.
    fn iterate(&self, query: &mut Query) -> (Vec<u32>, bool, bool) {
        let program = self.blocks.program();
        let values = self.evaluate(Section::Init, query, None);
        store(&mut query.state, &program.block(Section::Init).results().stores, &values);

        query.partial = vec![[0; PARTIAL_SUMS]; self.sums.len()];
        for index in 0..query.neighbors.neighbors.len() {
            let values = self.evaluate(Section::Kernel, query, Some(index));
            let addends = &program.block(Section::Kernel).results().addends;
            for ((partial, &ty), addend) in query.partial.iter_mut().zip(&self.sums).zip(addends) {
                let partial = &mut partial[index % PARTIAL_SUMS];
                *partial = self.blocks.add(ty, *partial, values[addend.index()]);
            }
        }

        let values = self.evaluate(Section::Final, query, None);
        let results = program.block(Section::Final).results();
        store(&mut query.state, &results.stores, &values);
        store(&mut query.words, results.movement.as_slice(), &values);
        let outputs = results.outputs.iter().map(|id| values[id.index()]).collect();
        let done = results.done.is_none_or(|id| values[id.index()] == 1);
        let anew = results.search.is_some_and(|id| values[id.index()] == 1);
        (outputs, done, anew)
    }

    fn evaluate(&self, section: Section, query: &Query, neighbor: Option<usize>) -> Vec<u32> {
        let Neighborhood { neighbors, farthest } = &query.neighbors;
        self.blocks.evaluate(section, |source, partial| match source {
            Source::Query(word) => query.words[word],
            Source::Neighbor(word) => neighbors[neighbor.expect("the kernel alone reads a neighbor")][word],
            Source::Farthest(word) => neighbors.get(*farthest).map_or(0, |neighbor| neighbor[word]),
            Source::State(word) => query.state[word],
            Source::Sum(word) => query.partial[word][partial],
            Source::Neighbors => neighbors.len() as u32,
            Source::Count => query.count,
            Source::Setting(word) => self.settings[word],
        })
    }
}

/// Writes what is stored where its condition holds.
fn store(words: &mut [u32], stores: &[Store], values: &[u32]) {
    for Store { first, words: stored, condition, .. } in stores {
        if condition.is_none_or(|id| values[id.index()] == 1) {
            let target = &mut words[*first..*first + stored.len()];
            target.iter_mut().zip(stored).for_each(|(word, id)| *word = values[id.index()]);
        }
    }
}

/// The first three words.
fn position(words: &[u32]) -> [u32; 3] {
    [words[0], words[1], words[2]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interpreter(text: &str, iterations_max: u32) -> Interpreter {
        let program = Program::parse("test.pasm", text).unwrap_or_else(|error| panic!("{error}"));
        Interpreter::new(program, Format::F32, vec![], iterations_max)
    }

    fn words(values: &[f32]) -> Vec<u32> {
        values.iter().map(|value| value.to_bits()).collect()
    }

    /// Neighbors on the x axis.
    fn on_axis(places: &[f32]) -> Neighborhood {
        Neighborhood { neighbors: places.iter().map(|&x| words(&[x, 0.0, 0.0])).collect(), farthest: 0 }
    }

    /// From left to right, 1 + ε/2 + ε/2 … would be 1; partial sums and their tree keep small addends apart from the
    /// large one.
    #[test]
    fn sums_are_those_of_a_tree_over_eight_partial_sums() {
        let text = ".program sum\n.kernel\naccumulate x, neighbor.position.x\n.final\noutput x, x\noutput n, neighbors";
        let sum = |small: usize| {
            let mut places = vec![1.0];
            places.extend(vec![f32::EPSILON / 2.0; small]);
            interpreter(text, 1).run(&words(&[0.0; 3]), |_| on_axis(&places))
        };
        // ((1 + ½ε) + (½ε + ½ε)) + 2ε.
        assert_eq!(sum(7).outputs, [(1.0 + 3.0 * f32::EPSILON).to_bits(), 8]);
        // p0 = (1 + ½ε) + ½ε = 1, the others are ε: ((1 + ε) + 2ε) + 4ε.
        assert_eq!(sum(16).outputs, [(1.0 + 7.0 * f32::EPSILON).to_bits(), 17]);
        assert_eq!((sum(7).iterations, sum(7).capped), (1, false));
    }

    #[test]
    fn iterations_keep_state_move_and_search_anew_until_done_or_capped() {
        let text = ".program walk\n.state best: int\n.init\nfirst = equal count, 0
            ten = add 10, 0\nstore best, ten if first
            .kernel\naccumulate x, neighbor.position.x\n.final\nbest_now = add best, 1\nstore best, best_now
            y = add query.position.y, 1.0\np = vector x, y, 0.0\nmove p
            is_last = less 3, count\nlate = less_or_equal 2, count
            output best, best\noutput y, query.position.y\noutput x, x\ndone is_last\nsearch late";
        let searches = std::cell::RefCell::new(vec![]);
        let search = |position: [u32; 3]| {
            searches.borrow_mut().push(f32::from_bits(position[1]));
            on_axis(&[searches.borrow().len() as f32])
        };
        let outcome = interpreter(text, 9).run(&words(&[0.0; 3]), search);
        // Iterations 0, 1 and 2 have the first neighbor, 3 and 4 one each.
        assert_eq!(outcome.outputs, [14, 4_f32.to_bits(), 3_f32.to_bits()]);
        assert_eq!((outcome.iterations, outcome.capped), (5, false));
        assert_eq!(searches.take(), [0.0, 3.0, 4.0]);
        let capped = interpreter(text, 2).run(&words(&[0.0; 3]), |_| on_axis(&[1.0]));
        assert_eq!((capped.outputs[0], capped.iterations, capped.capped), (11, 2, true));
    }

    #[test]
    fn a_query_without_neighbors_has_a_farthest_of_zeros_and_sums_of_zero() {
        let text = ".program none\n.state f: float3\n.init\nf1 = add farthest.position, query.position\nstore f, f1
            .kernel\naccumulate p, neighbor.position\n.final\noutput f, f\noutput p, p\noutput n, neighbors";
        let outcome = interpreter(text, 1).run(&words(&[1.0, 2.0, 3.0]), |_| Neighborhood::default());
        assert_eq!(outcome.outputs, [words(&[1.0, 2.0, 3.0, 0.0, 0.0, 0.0]), vec![0]].concat());
    }

    #[test]
    fn exponentials_are_within_their_bound() {
        let text =
            ".program exp\n.kernel\ne = exp_neg neighbor.position.x\naccumulate e_sum, e\n.final\noutput e, e_sum";
        let program = interpreter(text, 1);
        let exp = |x: f32| f32::from_bits(program.run(&words(&[0.0; 3]), |_| on_axis(&[x])).outputs[0]);
        for index in 0..4000 {
            let x = index as f32 / 200.0 + 0.0013;
            let error = (f64::from(exp(x)) - (-f64::from(x)).exp()).abs();
            assert!(error < 2_f64.powi(-13), "exp_neg {x} is off by {error}");
        }
        assert_eq!((exp(-3.0), exp(f32::INFINITY)), (1.0 - 2_f32.powi(-16), 0.0));
        assert!(exp(f32::NAN).is_nan());
    }
}
