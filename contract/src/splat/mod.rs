//! The renderer, the surface-splat renderer: its configuration, the records that flow between its units and their ports.

pub mod attribute;
pub mod config;
pub mod division;
pub mod ports;
pub mod raster;
pub mod records;

pub use attribute::{AttributeFormat, Fraction};
pub use config::{Config, ConfigError, Feature};
pub use division::Division;
pub use ports::{Direction, Port};
pub use raster::{Coefficient, RasterFormat, UniformFormat};
pub use records::Field;
