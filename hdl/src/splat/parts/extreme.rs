//! The largest or smallest of some values, all compared with each other at the same time.

use rtl::Expr;

/// Of the values, the first whose place `reaches` those of all others.
pub(crate) fn extreme<const N: usize>(values: [Expr; N], reaches: impl Fn(usize, usize) -> Expr) -> Expr {
    let beats = |place: usize, other: usize| {
        if other < place { !reaches(other, place) } else { reaches(place, other) }
    };
    let chosen = (0..N).map(|place| {
        let is_extreme =
            (0..N).filter(|other| *other != place).map(|other| beats(place, other)).reduce(|all, one| all & one);
        is_extreme.expect("there are others").repeat(values[place].width()) & values[place]
    });
    chosen.reduce(|all, one| all | one).expect("there are values")
}
