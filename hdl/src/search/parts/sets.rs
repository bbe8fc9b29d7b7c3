//! Sets of threads or lanes, a bit each.

use rtl::{Expr, bit, cat, lit};

/// The members' bits side by side, the first lowest.
#[track_caller]
pub(crate) fn set(members: &[Expr]) -> Expr {
    cat(members.iter().rev().copied())
}

/// The set of one number where `valid`, else of none, whatever the number: a shift would be unknown where that is.
#[track_caller]
pub(crate) fn decode(valid: impl Into<Expr>, number: impl Into<Expr>, count: u32) -> Expr {
    let (valid, number) = (valid.into(), number.into());
    let width = number.width();
    let member = |member: u32| match width {
        0..4 => valid & number.eq_lit(member.into()),
        // In two halves, so that few ask for `valid`.
        _ => {
            let half = width / 2;
            let high = valid & number.bits(width - 1, half).eq_lit((member >> half).into());
            high & number.trunc(half).eq_lit((member & ((1 << half) - 1)).into())
        }
    };
    set(&(0..count).map(member).collect::<Vec<_>>())
}

/// Whether a number is in a set.
#[track_caller]
pub(crate) fn contains(set: impl Into<Expr>, number: impl Into<Expr>) -> Expr {
    let (set, number) = (set.into(), number.into());
    set.shr_by(number).bit(0)
}

/// The set's lowest member alone.
#[track_caller]
pub(crate) fn lowest(set: impl Into<Expr>) -> Expr {
    let set = set.into();
    set & (lit(set.width(), 0) - set)
}

/// The number of a set's only member.
#[track_caller]
pub(crate) fn index_of(single: impl Into<Expr>, bits: u32) -> Expr {
    let single = single.into();
    let digits: Vec<Expr> = (0..bits)
        .map(|digit| {
            let with_digit = (0..single.width()).filter(|number| number >> digit & 1 == 1);
            let mask = with_digit.fold(0, |mask, number| mask | 1 << number);
            (single & lit(single.width(), mask)).any()
        })
        .collect();
    set(&digits)
}

/// Whether a set has more than one member, each against those before it: sooner known than which is the lowest.
#[track_caller]
pub(crate) fn several(set: impl Into<Expr>) -> Expr {
    let set = set.into();
    let pair = |member: u32| set.bit(member) & set.trunc(member).any();
    (1..set.width()).map(pair).fold(bit(false), |any, pair| any | pair)
}
