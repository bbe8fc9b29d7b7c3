//! Pipelined floating-point operators.
//!
//! Each operator is a module of its own: unpack, raw operation, one shared rounder. Ports are `enable` (every register
//! holds while it is low), the operands `a`, `b`, `c` and the result `y`; a result appears [`Operator::latency`] enabled
//! cycles after its operands. There is no reset and no `valid`: whoever instantiates an operator knows the latency.
//!
//! `stages` asks for a number of pipeline registers, the last of which is the output. Registers go only where the
//! description allows a cut, so the number is clamped; [`Operator::latency`] is what came out. Every operator's `stages`
//! function gives the fewest registers for about 130 MHz on a small FPGA (ECP5, speed grade 6).
//!
//! Results are those of the functions of the same names in the golden model; formats that flush subnormals have no
//! shifter for them.
//!
//! Three operators are for programs and for units to come, and no unit of the cores has them: [`fma`] and [`rsqrt`] (the processing
//! module, which normalizes vectors) and [`erf`] (the kernel's integral over an exposure, thesis chapter 4). Those with Newton steps
//! are there for `division = "newton"`.

pub mod add;
pub mod compare;
pub mod convert;
pub mod div;
pub mod erf;
pub mod exp_neg;
pub mod fma;
pub mod from_fixed;
pub mod minmax;
pub mod mul;
pub mod recip_newton;
pub mod rsqrt;
pub mod rsqrt_newton;
pub mod sqrt;
pub mod to_fixed;

pub(crate) mod parts;

pub use parts::pipe::Operator;
pub use parts::table;

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::{Fixed, Format, Signedness, TableShape};
    use rtl::elaborate;

    fn every_operator(format: Format, stages: u32) -> Vec<Operator> {
        let fixed = Fixed { width: 24, fraction: 8, signed: Signedness::Signed };
        let shape = TableShape { index_bits: 5, fraction_bits: 8, value_bits: 10 };
        vec![
            add::module(format, stages),
            mul::module(format, stages),
            fma::module(format, stages),
            div::module(format, stages),
            div::recip(format, stages),
            sqrt::module(format, stages),
            rsqrt::module(format, stages),
            recip_newton::module(format, stages),
            rsqrt_newton::module(format, stages),
            minmax::min(format, stages),
            minmax::max(format, stages),
            compare::lt(format, stages),
            compare::le(format, stages),
            compare::eq(format, stages),
            convert::module(format, Format::F16, stages),
            to_fixed::module(format, fixed, stages),
            from_fixed::module(format, fixed, stages),
            table::module(shape, &exp_neg::samples(2.0, shape), stages),
        ]
    }

    #[test]
    fn every_operator_elaborates_at_any_latency() {
        for (_, kept) in Format::NAMED {
            for format in [kept, kept.flushed()] {
                for stages in [1, 2, 4, 9, 100] {
                    for operator in every_operator(format, stages) {
                        let design = elaborate(&operator.module).unwrap_or_else(|error| panic!("{format}: {error}"));
                        assert!((1..=stages).contains(&operator.latency), "{} of {format}", design.top());
                        assert_eq!(design.combinational_paths(), [], "{} of {format}", design.top());
                    }
                }
            }
        }
    }

    #[test]
    fn flushing_formats_cost_less() {
        let register_bits = |operator: &Operator| {
            let design = elaborate(&operator.module).expect("operators elaborate");
            design.modules().iter().map(|module| module.area.register_bits).sum::<u64>()
        };
        let kept = every_operator(Format::F32, 100);
        let flushed = every_operator(Format::F32.flushed(), 100);
        for (kept, flushed) in kept.iter().zip(&flushed) {
            assert!(register_bits(flushed) <= register_bits(kept), "{}", kept.module.unit());
        }
        assert!(register_bits(&flushed[1]) < register_bits(&kept[1]));
    }
}
