//! Products as wide as hardware multipliers allow, and pieced together from such.

use super::delay;
use super::pipe::Pipe;
use rtl::Expr;

/// Widest unsigned operand of one hardware multiplier.
const MULTIPLIER_WIDTH: u32 = 18;

/// An operand in parts that fit a multiplier, lowest first, each with its place.
fn parts(operand: Expr) -> Vec<(u32, Expr)> {
    let width = operand.width();
    if width <= MULTIPLIER_WIDTH {
        return vec![(0, operand)];
    }
    let half = width.div_ceil(2);
    vec![(0, operand.trunc(half)), (half, operand.bits(width - 1, half))]
}

/// `left · right`, the full width. Takes a cut behind the multipliers if more than one is needed.
pub(crate) fn product(pipe: &mut Pipe, left: Expr, right: Expr) -> Expr {
    let width = left.width() + right.width();
    let mut partial = vec![];
    for (left_place, left_part) in parts(left) {
        for (right_place, right_part) in parts(right) {
            let place = left_place + right_place;
            let name = format!("partial_{left_place}_{right_place}");
            partial.push((place, pipe.carry(&name, left_part * right_part)));
        }
    }
    if partial.len() > 1 {
        pipe.cut([]);
    }
    let mut terms: Vec<Expr> =
        partial.iter_mut().map(|(place, value)| pipe.arrive(value).zext(width) << *place).collect();
    if terms.len() == 4 {
        // The outer two do not overlap: one addition less.
        let high = terms.remove(3);
        terms[0] = terms[0] | high;
    }
    terms.into_iter().reduce(|sum, term| sum + term).expect("an operand has a part")
}

/// Delays of [`product`]'s segments.
pub(crate) fn product_delays(left: u32, right: u32) -> Vec<u32> {
    let wide = |width: u32| width > MULTIPLIER_WIDTH;
    match (wide(left), wide(right)) {
        (false, false) => vec![delay::MULTIPLIER],
        (true, true) => vec![delay::MULTIPLIER, 2 * delay::adder(left + right)],
        _ => vec![delay::MULTIPLIER, delay::adder(left + right)],
    }
}
