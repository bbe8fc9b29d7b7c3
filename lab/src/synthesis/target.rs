//! What a unit is synthesized for: devices and their tools' arguments.

use super::area::DeviceArea;
use super::units::Scope;
use pointcore::package::place_and_route;
use pointcore::package::shell::Shelled;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

/// A clock in MHz beyond what the units reach, so that the tools do not stop early.
const ALONE: &[&str] = &["--freq", "160"];
/// A technology.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Target {
    /// Lattice ECP5 LFE5U-85F, speed grade 6: synthesis, place and route.
    Ecp5,
    /// Lattice iCE40 HX8K: synthesis, place and route of small units.
    Ice40,
    /// AMD 7-series: synthesis.
    Xilinx7,
    /// Two-input gates and multiplexers, memories left whole: synthesis.
    Gates,
}

/// What a device has of something.
pub(super) struct Capacity {
    /// As a reader calls it.
    pub name: &'static str,
    /// How many a design of that area takes.
    pub taken: fn(&DeviceArea) -> u64,
    /// How many there are.
    pub available: u64,
}

/// A device that can be placed and routed.
pub(super) struct Device {
    /// As a reader calls it.
    pub name: &'static str,
    /// The program that places and routes it.
    pub program: &'static str,
    /// Its arguments for the device.
    pub arguments: &'static [&'static str],
    /// What is checked before.
    pub capacities: &'static [Capacity],
}

static ECP5: Device = Device {
    name: "LFE5U-85F",
    program: "nextpnr-ecp5",
    arguments: place_and_route::ECP5,
    capacities: &[
        Capacity {
            name: "LUT4",
            taken: |area| area.lut + 2 * area.carry + 4 * area.distributed_ram,
            available: 83_640,
        },
        Capacity { name: "flip-flops", taken: |area| area.flip_flop, available: 83_640 },
        Capacity { name: "block RAMs", taken: |area| area.block_ram, available: 208 },
        Capacity { name: "multipliers", taken: |area| area.dsp, available: 156 },
    ],
};

const ICE40: Device = Device {
    name: "iCE40HX8K",
    program: "nextpnr-ice40",
    arguments: &["--hx8k", "--package", "ct256", "--pcf-allow-unconstrained"],
    capacities: &[
        // A logic cell holds a LUT, a flip-flop and a carry; they are not always in the same cell, so this is what is needed at least.
        Capacity { name: "LUT4", taken: |area| area.lut, available: 7_680 },
        Capacity { name: "flip-flops", taken: |area| area.flip_flop, available: 7_680 },
        Capacity { name: "block RAMs", taken: |area| area.block_ram, available: 32 },
    ],
};

impl Device {
    /// The arguments of place and route, beside files and seed, for a unit alone or a whole core.
    pub(super) fn arguments(&self, scope: Scope) -> impl Iterator<Item = &str> {
        let effort = match scope {
            Scope::Unit => ALONE,
            Scope::Core(crowding) => crowding.arguments(),
        };
        self.arguments.iter().chain(effort).copied()
    }
}

impl Target {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Ecp5, Self::Ice40, Self::Xilinx7, Self::Gates];

    /// Its name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ecp5 => "ecp5",
            Self::Ice40 => "ice40",
            Self::Xilinx7 => "xilinx7",
            Self::Gates => "gates",
        }
    }

    /// The device to place and route, where a tool exists.
    pub(super) const fn device(self) -> Option<&'static Device> {
        match self {
            Self::Ecp5 => Some(&ECP5),
            Self::Ice40 => Some(&ICE40),
            Self::Xilinx7 | Self::Gates => None,
        }
    }

    /// The yosys script: from `design.v` to the unit's own cells in `cells.json` and, for a device, the unit in its shell in
    /// `netlist.json`. The shell is synthesized apart, so that nothing is optimized across the border.
    pub(super) fn script(self, design: &Shelled) -> String {
        let Shelled { unit, shell, .. } = design;
        let mut script = "read_verilog design.v\ndesign -save source\n".to_owned();
        let synthesis = match self {
            Self::Ecp5 => "synth_ecp5",
            Self::Ice40 => "synth_ice40",
            Self::Xilinx7 => "synth_xilinx -family xc7 -flatten",
            Self::Gates => "synth -flatten -run begin:fine",
        };
        _ = writeln!(script, "{synthesis} -top {unit}");
        if self == Self::Gates {
            script += "opt -full\ntechmap\nopt\nabc -g AND,NAND,OR,NOR,XOR,XNOR,MUX\nopt_clean\nmemory_unpack\n";
        }
        script += "tee -q -o cells.json stat -json\n";
        if self.device().is_some() {
            _ = write!(
                script,
                "design -stash unit\ndesign -load source\nblackbox {unit}\n{synthesis} -top {shell}\n\
                 design -copy-from unit {unit}\nhierarchy -top {shell}\nflatten\nwrite_json netlist.json\n"
            );
        }
        script
    }
}
