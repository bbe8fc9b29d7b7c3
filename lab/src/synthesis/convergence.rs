//! Whether a router will come to an end, by what it says on its way.
//!
//! nextpnr's usual router gives one arc after the other a way, and rips up others for it; it counts the arcs that have none. It is given
//! up if the fewest were [`RIPPING_ITERATIONS`] ago. Its other router negotiates, and counts in each iteration the wires that are
//! used more than once. They become fewer, or the router goes on for ever. It is given up if the fewest were [`RISING_ITERATIONS`]
//! iterations ago or more and there are more than [`RISEN`] times as many now, and as [`FEW`]; or if they were
//! [`STANDING_ITERATIONS`] ago.

use std::fmt;

/// So long a router that rips up goes on without fewer arcs left, an arc in each: a third of those of a whole core.
const RIPPING_ITERATIONS: u32 = 100_000;
/// So long a router that converges rises no higher than [`RISEN`] times the fewest.
const RISING_ITERATIONS: u32 = 16;
/// See there.
const RISEN: u32 = 2;
/// So few come and go before the end: a router that had one in round 78 had three in round 90, and none in round 95.
const FEW: u32 = 100;
/// So long no router finds nothing and then the end.
const STANDING_ITERATIONS: u32 = 200;

/// What an iteration says of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Iteration {
    /// Its number, from one.
    pub number: u32,
    /// Wires that have no way of their own after it.
    pub left: u32,
}

/// A router that does not converge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Divergence {
    /// The last iteration.
    pub last: Iteration,
    /// The first of those after which the fewest wires were left.
    pub best: Iteration,
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { last, best } = self;
        let [(last, now), (best, then)] = [last, best].map(|iteration| (iteration.number, iteration.left));
        write!(
            f,
            "after iteration {last} of the router {now} wires have no way of their own, after iteration {best} {then} had none"
        )
    }
}

impl Iteration {
    /// Reads a line of the negotiating router's log.
    fn negotiating(line: &str) -> Option<Self> {
        let number = |name: &str| line.split_whitespace().find_map(|word| word.strip_prefix(name)?.parse().ok());
        Some(Self { number: number("iter=")?, left: number("overused=")? })
    }

    /// Reads a line of the other's, a row of a table.
    fn ripping(line: &str) -> Option<Self> {
        let mut columns = line.strip_prefix("Info:")?.split('|').map(str::trim);
        Some(Self { number: columns.next()?.parse().ok()?, left: columns.nth(2)?.parse().ok()? })
    }
}

/// Whether the router whose log this is so far goes on for ever.
pub(super) fn divergence(log: &str) -> Option<Divergence> {
    let so_far = |parse: fn(&str) -> Option<Iteration>| {
        let iterations: Vec<Iteration> = log.lines().filter_map(parse).collect();
        let last = *iterations.last()?;
        let best = *iterations.iter().min_by_key(|iteration| iteration.left)?;
        Some((Divergence { last, best }, last.number.saturating_sub(best.number)))
    };
    let negotiating = so_far(Iteration::negotiating).filter(|(Divergence { last, best }, since)| {
        let rises = *since >= RISING_ITERATIONS && last.left > RISEN * best.left.max(FEW);
        rises || *since >= STANDING_ITERATIONS
    });
    let ripping = so_far(Iteration::ripping).filter(|(_, since)| *since >= RIPPING_ITERATIONS);
    negotiating.or(ripping).map(|(divergence, _)| divergence)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What nextpnr-ecp5 says of an adder of `f16`.
    const RECORDED: &str = include_str!("fixtures/router2.log");

    /// Iterations of nextpnr's form with so many overused wires, from the first on.
    fn log(overused: impl IntoIterator<Item = u32>) -> String {
        let line = |(index, overused): (usize, u32)| {
            let wires = 500_000 + overused;
            let iteration = index + 1;
            format!(
                "Info:     iter={iteration} wires={wires} overused={overused} overuse={overused} tmgfail=0 archfail=NA\n"
            )
        };
        std::iter::once("Info: Running main router loop...\n".to_owned())
            .chain(overused.into_iter().enumerate().map(line))
            .collect()
    }

    #[test]
    fn a_router_that_comes_to_its_end_is_left_alone() {
        let last = RECORDED.lines().filter_map(Iteration::negotiating).next_back();
        assert_eq!(last, Some(Iteration { number: 11, left: 0 }));
        for end in 0..RECORDED.lines().count() {
            let begin: Vec<&str> = RECORDED.lines().take(end).collect();
            assert_eq!(divergence(&begin.join("\n")), None, "after {end} lines");
        }
        let slow = (0..400).map(|iteration| 400 - iteration + 30 * (iteration % 3));
        assert_eq!(divergence(&log(slow)), None, "slowly, and not in every iteration");
        assert_eq!(divergence("Info: Placing design\n"), None, "it has not begun");
    }

    #[test]
    fn a_router_whose_wires_become_more_is_given_up_and_not_before_it_had_time() {
        let falling = (0..25).map(|iteration| 50_000 - 2_000 * iteration);
        let rising = |count: u32| (1..=count).map(|iteration| 2_000 + 1_050 * iteration);
        let given_up = |count| divergence(&log(falling.clone().chain(rising(count))));
        assert_eq!(given_up(RISING_ITERATIONS - 1), None);
        let divergence = given_up(RISING_ITERATIONS).expect("it rises");
        assert_eq!(divergence.best, Iteration { number: 25, left: 2_000 });
        assert_eq!(divergence.last, Iteration { number: 41, left: 18_800 });
        assert!(divergence.to_string().contains("iteration 41 of the router 18800 wires"), "{divergence}");
    }

    #[test]
    fn a_router_near_its_end_is_left_alone() {
        let last_wires = [245, 48, 13, 1].into_iter().chain((0..RISING_ITERATIONS).map(|iteration| 1 + iteration % 3));
        assert_eq!(divergence(&log(last_wires.chain([3]))), None);
    }

    #[test]
    fn a_router_that_stands_still_is_given_up() {
        let standing = |count: u32| divergence(&log([60, 9, 3].into_iter().chain((0..count).map(|_| 3))));
        assert_eq!(standing(STANDING_ITERATIONS - 1), None);
        assert_eq!(standing(STANDING_ITERATIONS).map(|divergence| divergence.best.number), Some(3));
    }

    #[test]
    fn a_router_that_rips_up_is_given_up_when_it_gets_no_further() {
        let row = |(number, left): (u32, u32)| {
            format!("Info: {number:>10} |{number:>9} {number:>10} |  115   743 |{left:>10}|       1.28     310.62|\n")
        };
        let falling = (1..230).map(|step| (1000 * step, 233_000 - 1000 * step));
        let standing = |rows: u32| (1..=rows).map(|step| (230_000 + 1000 * step, 3000 + step % 3));
        let log = |rows| falling.clone().chain(standing(rows)).map(row).collect::<String>();
        assert_eq!(Iteration::ripping(&row((5000, 12))), Some(Iteration { number: 5000, left: 12 }));
        let rows = RIPPING_ITERATIONS / 1000;
        assert_eq!(divergence(&log(rows + 2)), None, "it came to fewer in its third row");
        let divergence = divergence(&log(rows + 3)).expect("it stands still");
        assert_eq!(divergence.best, Iteration { number: 233_000, left: 3000 });
    }
}
