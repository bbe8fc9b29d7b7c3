//! Leading zeros and shifts that keep track of what they lose.

use super::delay;
use super::pipe::Pipe;
use rtl::{Expr, bit, cat, lit};

/// Number of zeros above the highest one, `⌈log2(width)⌉` bits wide; of no meaning for the value zero.
#[must_use]
pub(crate) fn leading_zeros(value: Expr) -> Expr {
    let padding = value.width().next_power_of_two() - value.width();
    if padding == 0 { count(value).1 } else { count(cat([value, bit(true).repeat(padding)])).1 }
}

/// Whether a value of 2^k bits is zero, and the zeros above its highest one in k bits; one bit has an empty count,
/// given as one bit of zero.
fn count(value: Expr) -> (Expr, Expr) {
    if value.width() == 1 {
        return (!value, bit(false));
    }
    let half = value.width() / 2;
    let (high_zero, high) = count(value.bits(2 * half - 1, half));
    let (low_zero, low) = count(value.bits(half - 1, 0));
    let zero = high_zero & low_zero;
    if half == 1 { (zero, high_zero) } else { (zero, cat([high_zero, high_zero.mux(low, high)])) }
}

/// Values wider than this lose their leading zeros in two steps.
const WIDE: u32 = 32;
/// Places of the first step's unit.
const GROUP: u32 = 16;

/// `value` shifted left by the number of leading zeros of `marked`, which is as wide, and that number.
///
/// Takes one cut behind the count, or two for wide values: one behind the counts in each group, one behind the shift by
/// whole groups.
pub(crate) fn shift_out_zeros(pipe: &mut Pipe, value: Expr, marked: Expr) -> (Expr, Expr) {
    let width = value.width();
    if width <= WIDE {
        pipe.takes(delay::leading_zeros(width));
        let [value, zeros] = pipe.cut([("value", value), ("zeros", leading_zeros(marked))]);
        pipe.takes(delay::shifter(width));
        return (value.shl_by(zeros), zeros);
    }
    let missing = width.next_multiple_of(GROUP) - width;
    let padded = if missing == 0 { marked } else { cat([marked, lit(missing, 0)]) };
    let groups = padded.width() / GROUP;
    let mut counts: Vec<_> = (0..groups)
        .map(|group| {
            let low = padded.width() - GROUP * (group + 1);
            let (empty, zeros) = count(padded.bits(low + GROUP - 1, low));
            (pipe.carry(&format!("empty_{group}"), empty), pipe.carry(&format!("zeros_{group}"), zeros))
        })
        .collect();
    pipe.takes(delay::leading_zeros(GROUP));
    let [value] = pipe.cut([("value", value)]);

    pipe.takes(delay::leading_zeros(groups) + delay::shifter(groups));
    let index_bits = groups.next_power_of_two().trailing_zeros();
    let place = |group: u32, zeros: Expr| cat([lit(index_bits, group.into()), zeros]);
    let mut zeros = place(groups - 1, pipe.arrive(&mut counts[groups as usize - 1].1));
    for (group, (empty, of_group)) in (0..groups - 1).zip(&mut counts).rev() {
        zeros = pipe.arrive(empty).mux(zeros, place(group, pipe.arrive(of_group)));
    }
    let group_bits = zeros.width() - index_bits;
    let whole_groups = cat([zeros.bits(zeros.width() - 1, group_bits), lit(group_bits, 0)]);
    let [value, zeros] = pipe.cut([("value", value.shl_by(whole_groups)), ("zeros", zeros)]);
    pipe.takes(delay::shifter(GROUP));
    (value.shl_by(zeros.trunc(group_bits)), zeros)
}

/// `value` shifted right; the lowest bit of the result is set if any one was shifted out of it.
#[must_use]
pub(crate) fn shift_right_sticky(value: Expr, amount: Expr) -> Expr {
    let width = value.width();
    let levels = amount.width().min(width.next_power_of_two().trailing_zeros());
    let (mut shifted, mut sticky) = (value, bit(false));
    for level in (0..levels).rev() {
        let (distance, enabled) = (1 << level, amount.bit(level));
        sticky = sticky | (enabled & shifted.trunc(distance.min(width)).any());
        shifted = enabled.mux(shifted >> distance, shifted);
    }
    let result = cat([shifted.bits(width - 1, 1), (shifted.bit(0) | sticky)]);
    if amount.width() == levels {
        return result;
    }
    let beyond = amount.bits(amount.width() - 1, levels).any();
    beyond.mux(value.any().zext(width), result)
}

/// The top `width − 1` bits of `value` and whether any below is set; padded if `value` is narrower.
#[must_use]
pub(crate) fn keep_sticky(value: Expr, width: u32) -> Expr {
    let lost = (value.width() + 1).saturating_sub(width);
    match lost {
        0 => cat([value, lit(width - value.width(), 0)]),
        _ => cat([value.bits(value.width() - 1, lost), value.trunc(lost).any()]),
    }
}

/// `left − right` where `subtract` is set, else `left + right`, from one carry chain.
#[must_use]
pub(crate) fn add_or_subtract(left: Expr, right: Expr, subtract: Expr) -> Expr {
    let width = left.width();
    let addend = right ^ subtract.repeat(width);
    (cat([left, bit(true)]) + cat([addend, subtract])).bits(width, 1)
}
