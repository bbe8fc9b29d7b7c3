//! Run-time-sized modules beside rust-hdl.
//!
//! A [`Module`] is described by calls: ports, width-checked expressions, registers, memories, instances and
//! `valid`/`ready` streams, with every size a run-time value. [`elaborate`] checks the whole hierarchy, reports all
//! errors together, and lowers it to plain Verilog-2005: one module per distinct description, named by unit and
//! parameters.
//!
//! `clk` and `rst` (synchronous, active high) are implicit: a module with state in or below it has `clk`, one with a reset in or below
//! it has `rst`, a top with state has both, and instances connect them by themselves. Larger memories are instances of one module,
//! whose depth and width are Verilog parameters.
//!
//! rust-hdl's blocks and these modules stand in each other: [`Module::from_block`] makes a child of a rust-hdl block, and
//! [`Design::wrapper`] and [`Design::rust_hdl_struct`] make a rust-hdl block of a design.

mod area;
mod arena;
mod atoms;
mod block;
mod canonical;
mod check;
mod clocked;
mod compose;
mod dependencies;
mod elaborate;
mod emit;
mod error;
mod expression;
mod foreign;
mod frame;
mod handle;
mod instance;
mod interface;
mod links;
mod lower;
mod memory;
mod memory_module;
mod module;
mod names;
mod naming;
mod operators;
mod packed;
mod resolve;
mod simplify;
mod slices;
mod stream;
mod text;
mod writer;

pub use area::{Area, Storage};
pub use block::{BlockError, block_ports};
pub use elaborate::{Design, Direction, ModuleInterface, ModuleSummary, Port, elaborate, elaborate_beside};
pub use error::{ElaborationError, Fault, FaultKind};
pub use expression::{Expr, bit, cat, lit};
pub use handle::{Reg, Wire};
pub use instance::Instance;
pub use interface::StreamDeclaration;
pub use links::{Link, Terminal};
pub use memory::{Memory, address_width};
pub use module::Module;
pub use packed::PackedStream;
pub use stream::{Stream, StreamIn};
