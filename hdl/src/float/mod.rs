//! Pipelined floating-point operators.
//!
//! Each operator is a module of its own: unpack, raw operation, one shared rounder. Ports are `enable` (every register
//! holds while it is low), the operands `a`, `b`, `c` and the result `y`; a result appears [`Operator::latency`] enabled
//! cycles after its operands. There is no reset and no `valid`: whoever instantiates an operator knows the latency.
//!
//! `stages` asks for a number of pipeline registers, the last of which is the output. Registers go only where the
//! description allows a cut, so the number is clamped; [`Operator::latency`] is what came out. Every operator's `stages`
//! function gives the fewest registers that keep each stage within [`delay::STAGE`].
//!
//! Results are those of the functions of the same names in the golden model; formats that flush subnormals have no
//! shifter for them.

pub mod add;
pub mod compare;
pub mod convert;
pub mod delay;
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
pub mod table;
pub mod to_fixed;

mod newton;
mod operand;
mod pipe;
mod product;
mod round;
mod shift;

pub use pipe::{Operator, Pipe};
