//! Where samples lie; golden twin: `pointcore_golden::splat::parts::place`.

use crate::compiler::{Program, Value};
use pointcore_contract::Sampling;

/// An axis of the image.
#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
}

/// Place of the sample in a column and a row along both axes, px, as fixed-point numbers with their fraction bits.
pub(crate) fn places(sampling: Sampling, program: &Program, sample: [Value; 2]) -> [(Value, u32); 2] {
    [Axis::X, Axis::Y].map(|axis| place(sampling, program, sample, axis))
}

fn place(sampling: Sampling, program: &Program, [column, row]: [Value; 2], axis: Axis) -> (Value, u32) {
    let index = match axis {
        Axis::X => column,
        Axis::Y => row,
    };
    match sampling {
        Sampling::Center => (index.cat(program.lit(1, 1)), 1),
        Sampling::Flipquad => {
            let is_top = column.bits(0, 0);
            let odd = column.bits(1, 1) ^ row.bits(0, 0);
            let [none, three, five] = [0, 3, 5].map(|eighths| program.lit(3, eighths));
            let (pixel, eighths) = match axis {
                Axis::X => (index >> 1, is_top.mux(odd.mux(five, three), none)),
                Axis::Y => (index, is_top.mux(none, odd.mux(three, five))),
            };
            (pixel.cat(eighths), 3)
        }
    }
}
