//! Devices by name, and what a core needs of one.

use super::count::total;
use rtl::{Design, Storage};
use serde::Serialize;
use std::fmt;
use std::str::FromStr;

/// What a device has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Device {
    /// As its maker calls it.
    pub name: &'static str,
    /// Look-up tables.
    pub luts: u64,
    /// Flip-flops.
    pub flip_flops: u64,
    /// Block RAMs of 18 kbit.
    pub block_rams: u64,
    /// Multipliers of 18 by 18 bits or more.
    pub multipliers: u64,
    /// The document that says so.
    pub source: &'static str,
}

const ECP5: &str = "Lattice FPGA-DS-02012, ECP5 and ECP5-5G Family, table 1.1; look-up tables as nextpnr counts them";
const ARTIX7: &str = "AMD DS180, 7 Series FPGAs Overview, table 4";

const fn device(
    name: &'static str,
    source: &'static str,
    [luts, flip_flops, block_rams, multipliers]: [u64; 4],
) -> Device {
    Device { name, luts, flip_flops, block_rams, multipliers, source }
}

/// Devices that are known, families apart, the smallest of a family first.
pub const DEVICES: [Device; 7] = [
    device("LFE5U-12F", ECP5, [12_144, 12_144, 32, 28]),
    device("LFE5U-25F", ECP5, [24_288, 24_288, 56, 28]),
    device("LFE5U-45F", ECP5, [43_848, 43_848, 108, 72]),
    device("LFE5U-85F", ECP5, [83_640, 83_640, 208, 156]),
    device("XC7A35T", ARTIX7, [20_800, 41_600, 100, 90]),
    device("XC7A100T", ARTIX7, [63_400, 126_800, 270, 240]),
    device("XC7A200T", ARTIX7, [134_600, 269_200, 730, 740]),
];

impl FromStr for Device {
    type Err = String;

    /// A device by its name or the end of it, such as `85F`.
    fn from_str(text: &str) -> Result<Self, String> {
        let upper = text.to_uppercase();
        let named = |device: &&Self| {
            let short = device.name.trim_start_matches("LFE5U-").trim_start_matches("XC7");
            device.name == upper || short == upper
        };
        DEVICES.iter().find(named).copied().ok_or_else(|| {
            let names = DEVICES.map(|device| device.name).join(", ");
            format!("expected one of {names}")
        })
    }
}

/// Where a core's needs come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Evidence {
    /// Counted in the generated hardware, before synthesis.
    Counted,
    /// Synthesis of this configuration, as recorded.
    Recorded,
}

/// What a core takes of a device.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Needs {
    /// Look-up tables of four inputs, where they were synthesized or can be estimated.
    pub lut4: Option<f64>,
    /// Flip-flops.
    pub flip_flops: u64,
    /// Block RAMs of 18 kbit.
    pub block_rams: u64,
    /// Multipliers of 18 by 18 bits.
    pub multipliers: u64,
    /// Where the figures come from.
    pub evidence: Evidence,
}

/// What a device has too little of.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shortage {
    /// Of what.
    pub of: &'static str,
    /// How many a core takes.
    pub needed: u64,
    /// How many there are.
    pub available: u64,
}

impl Device {
    /// One that holds anything.
    pub const UNLIMITED: Self = device("any device", "", [u64::MAX; 4]);
}

impl Shortage {
    /// Whether it is of block RAM, which smaller memories take less of.
    #[must_use]
    pub fn is_of_block_ram(&self) -> bool {
        self.of == BLOCK_RAMS
    }
}

impl fmt::Display for Shortage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} of {}", self.needed, self.of, self.available)
    }
}

/// What memories take.
const BLOCK_RAMS: &str = "block RAMs of 18 kbit";
/// Widths of a block RAM's words, with as many words.
const BLOCK_SHAPES: [(u32, u32); 6] = [(1, 16_384), (2, 8_192), (4, 4_096), (9, 2_048), (18, 1_024), (36, 512)];
/// Memories of fewer bits, and with fewer words, lie in look-up tables.
const BLOCK_BITS_LEAST: u64 = 2_048;
const BLOCK_WORDS_LEAST: u32 = 64;

/// Block RAMs of a memory.
fn block_rams(memory: &Storage) -> u64 {
    if memory.is_distributed || memory.bits() < BLOCK_BITS_LEAST || memory.depth < BLOCK_WORDS_LEAST {
        return 0;
    }
    let blocks = BLOCK_SHAPES.map(|(width, depth)| memory.width.div_ceil(width) * memory.depth.div_ceil(depth));
    u64::from(blocks.into_iter().min().unwrap_or_default()) * u64::from(memory.reads.max(1))
}

impl Needs {
    /// Counts what a design takes, before synthesis. A product takes as many multipliers as its factors have times 18 bits; synthesis
    /// makes small ones of look-up tables.
    #[must_use]
    pub fn counted(design: &Design, lut4: Option<f64>) -> Self {
        let area = total(design);
        let blocks =
            |module: &rtl::ModuleSummary| module.instances * module.memories.iter().map(block_rams).sum::<u64>();
        Self {
            lut4,
            flip_flops: area.register_bits,
            block_rams: design.modules().iter().map(blocks).sum(),
            multipliers: area.multiplier_blocks,
            evidence: Evidence::Counted,
        }
    }

    /// What a device has too little of; nothing where the core fits, as far as can be told.
    #[must_use]
    pub fn shortages(&self, device: &Device) -> Vec<Shortage> {
        let shortage = |of, needed, available| (needed > available).then_some(Shortage { of, needed, available });
        let all = [
            shortage("look-up tables", self.lut4.map_or(0, |lut4| lut4.round() as u64), device.luts),
            shortage("flip-flops", self.flip_flops, device.flip_flops),
            shortage(BLOCK_RAMS, self.block_rams, device.block_rams),
            shortage("multipliers", self.multipliers, device.multipliers),
        ];
        all.into_iter().flatten().collect()
    }
}
