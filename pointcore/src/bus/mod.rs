//! A core's bus: the file of its AXI top beside the core's own, and what a driver's author needs to know of it.

mod constants;
mod header;
mod markdown;

use crate::configuration::Configuration;
use crate::generated::GenerateError;
use constants::Constant;
use pointcore_contract::bus::packets::{self, NamedRecord};
use pointcore_contract::bus::registers::{PointsRegisters, RegisterMap, SearchRegisters, SplatRegisters};
use pointcore_contract::bus::{Config, Register};
use pointcore_contract::{points, search, splat};
use pointcore_hdl::bus;
use pointcore_hdl::compiler::Options;
use rtl::{Design, elaborate, elaborate_beside};

/// Which of the cores a bus belongs to, as names have it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Splat,
    Search,
    Points,
}

impl Kind {
    /// `splat`, `search`, `points`.
    const fn name(self) -> &'static str {
        match self {
            Self::Splat => "splat",
            Self::Search => "search",
            Self::Points => "points",
        }
    }
}

/// What software meets: registers, packets and memory records of a core.
pub struct Interface {
    core: Kind,
    config: Config,
    registers: Vec<Register>,
    packets: Vec<NamedRecord>,
    constants: Vec<Constant>,
}

impl Interface {
    /// The renderer's.
    #[must_use]
    pub fn splat(config: &splat::Config) -> Self {
        let (registers, packets) = (SplatRegisters::registers(config), packets::splat(config));
        let constants = constants::splat(config);
        Self { core: Kind::Splat, config: config.bus, registers, packets, constants }
    }

    /// The search core's.
    #[must_use]
    pub fn search(config: &search::Config) -> Self {
        let (registers, packets) = (SearchRegisters::registers(config), packets::search(config));
        let constants = constants::search(config);
        Self { core: Kind::Search, config: config.bus, registers, packets, constants }
    }

    /// The point processor's.
    #[must_use]
    pub fn points(config: &points::Config) -> Self {
        let (registers, packets) = (PointsRegisters::registers(config), packets::points(config));
        let constants = constants::points(config);
        Self { core: Kind::Points, config: config.search.bus, registers, packets, constants }
    }

    /// `registers.md`.
    #[must_use]
    pub fn markdown(&self) -> String {
        markdown::document(self)
    }

    /// `registers.h`.
    #[must_use]
    pub fn header(&self) -> String {
        header::document(self)
    }
}

/// A top on AXI.
pub struct Bus {
    /// What the core's own file does not have; its ports are the top's.
    pub design: Design,
    core: Design,
}

impl Bus {
    /// Generates the top of a configuration.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn new(configuration: &Configuration) -> Result<Self, GenerateError> {
        match configuration {
            Configuration::Splat(config) => Self::splat(config),
            Configuration::Search(config) => Self::search(config),
            Configuration::Points(config) => Self::points(config),
        }
    }

    /// Generates `splat_axi`.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn splat(config: &splat::Config) -> Result<Self, GenerateError> {
        Self::of(&bus::splat::core(config, &Options::default())?)
    }

    /// Generates `search_axi`.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn search(config: &search::Config) -> Result<Self, GenerateError> {
        Self::of(&bus::search::core(config, &Options::default())?)
    }

    /// Generates `points_axi`.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn points(config: &points::Config) -> Result<Self, GenerateError> {
        Self::of(&bus::points::core(config, &Options::default())?)
    }

    fn of(top: &bus::Top) -> Result<Self, GenerateError> {
        Ok(Self { design: elaborate_beside(&top.module, &top.core)?, core: elaborate(&top.core)? })
    }

    /// The whole design: the top's file and the core's.
    #[must_use]
    pub fn verilog(&self) -> String {
        format!("{}\n{}", self.design.verilog(), self.core.verilog())
    }
}
