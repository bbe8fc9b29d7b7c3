//! The contract between the golden models and the hardware descriptions: number formats, configurations, what travels between units,
//! and the units' ports. Nothing here computes a result of the hardware.

// The macros name this crate by its name, here as elsewhere.
extern crate self as pointcore_contract;

pub mod bus;
pub mod camera;
pub mod configuration;
pub mod format;
pub mod places;
pub mod points;
pub mod process;
pub mod record;
pub mod rendering;
pub mod search;
pub mod splat;
pub mod surface;
pub mod table;
pub mod unit;

pub use camera::Camera;
pub use format::{Fixed, Format, Signedness, Subnormals};
pub use places::{Places, places};
pub use pointcore_contract_macros::{ports, record, unit};
pub use record::{
    Domain, Field, Record, Visit, Visitor, Word, Words, fields, read, visit_optional, width, words, write,
};
pub use rendering::{FragmentDepth, Rendering, Sampling};
pub use rtl_port::{Direction, Port};
pub use surface::Splat;
pub use table::TableShape;
pub use unit::{Interface, Unit, count};
