//! A core's bus: the file of its AXI top beside the core's own, and what a driver's author needs to know of it.

mod header;
mod markdown;

use crate::generated::GenerateError;
use pointcore_hdl::bus;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::rtl::{Design, elaborate, elaborate_beside};
use pointcore_spec::bus::packets::{self, Packet};
use pointcore_spec::bus::registers;
use pointcore_spec::bus::{Config, Register};
use pointcore_spec::{core_a, core_b};

/// Which of the cores a bus belongs to, as names have it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Core {
    A,
    B,
}

impl Core {
    /// `core_a`, `core_b`.
    const fn name(self) -> &'static str {
        match self {
            Self::A => "core_a",
            Self::B => "core_b",
        }
    }
}

/// What software meets: registers, packets and memory records of a core.
pub struct Interface {
    core: Core,
    config: Config,
    registers: Vec<Register>,
    packets: Vec<Packet>,
}

impl Interface {
    /// Core A's.
    #[must_use]
    pub fn core_a(config: &core_a::Config) -> Self {
        let (registers, packets) = (registers::core_a(config), packets::core_a(config));
        Self { core: Core::A, config: config.bus, registers, packets }
    }

    /// Core B's.
    #[must_use]
    pub fn core_b(config: &core_b::Config) -> Self {
        let (registers, packets) = (registers::core_b(config), packets::core_b(config));
        Self { core: Core::B, config: config.bus, registers, packets }
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
    /// Generates `core_a_axi`.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn core_a(config: &core_a::Config) -> Result<Self, GenerateError> {
        Self::of(&bus::core_a::core(config, &Options::default())?)
    }

    /// Generates `core_b_axi`.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn core_b(config: &core_b::Config) -> Result<Self, GenerateError> {
        Self::of(&bus::core_b::core(config, &Options::default())?)
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
