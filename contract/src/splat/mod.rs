//! The renderer of surface splats: its configuration, the records that flow between its units and their ports.

pub mod attribute;
pub mod config;
pub mod division;
pub mod motion;
pub mod raster;
pub mod records;
pub mod units;

pub use attribute::{AttributeFormat, Fraction};
pub use config::{Config, ConfigError, Feature};
pub use division::Division;
pub use raster::{Coefficient, RasterFormat, UniformFormat};
