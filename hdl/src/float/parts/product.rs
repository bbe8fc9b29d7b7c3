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

/// Whether a product of those widths takes several multipliers.
pub(crate) fn is_pieced(left: u32, right: u32) -> bool {
    left.max(right) > MULTIPLIER_WIDTH
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
    pipe.takes(delay::MULTIPLIER);
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
    pipe.takes((terms.len() as u32 - 1) * delay::adder(width));
    terms.into_iter().reduce(|sum, term| sum + term).expect("an operand has a part")
}
