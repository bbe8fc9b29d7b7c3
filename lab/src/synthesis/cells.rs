//! The cells that yosys counts, by what they are.

use super::{DeviceArea, Target};
use serde::Deserialize;
use std::collections::BTreeMap;

/// What yosys' `stat -json` says of a design.
#[derive(Deserialize)]
struct Report {
    design: Counts,
}

#[derive(Deserialize)]
struct Counts {
    num_memory_bits: u64,
    num_cells_by_type: BTreeMap<String, u64>,
}

/// Reads yosys' `stat -json`.
///
/// # Errors
/// A report of another form, or a cell of a kind that is not known.
pub(super) fn parse(target: Target, report: &str) -> Result<DeviceArea, String> {
    let Report { design } = serde_json::from_str(report).map_err(|error| format!("stat: {error}"))?;
    let mut area = DeviceArea { memory_bits: design.num_memory_bits, ..DeviceArea::default() };
    for (cell, count) in design.num_cells_by_type {
        add(&mut area, target, &cell, count).ok_or_else(|| format!("{target:?}: unknown cell `{cell}`"))?;
    }
    Ok(area)
}

/// Adds cells of one kind; none if the kind is unknown.
fn add(area: &mut DeviceArea, target: Target, cell: &str, count: u64) -> Option<()> {
    let place = match (target, cell) {
        (Target::Ecp5, "LUT4") | (Target::Ice40, "SB_LUT4") => &mut area.lut,
        (Target::Ecp5, "CCU2C") | (Target::Ice40, "SB_CARRY") | (Target::Xilinx7, "CARRY4") => &mut area.carry,
        (Target::Ecp5, "TRELLIS_FF") => &mut area.flip_flop,
        (Target::Ecp5, "TRELLIS_DPR16X4") => &mut area.distributed_ram,
        (Target::Ecp5, "DP16KD" | "PDPW16KD") | (Target::Ice40, "SB_RAM40_4K") => &mut area.block_ram,
        (Target::Ecp5, "MULT18X18D") | (Target::Xilinx7, "DSP48E1") => &mut area.dsp,
        // They join lookup tables of one slice and take none themselves.
        (Target::Ecp5, "PFUMX" | "L6MUX21") | (Target::Xilinx7, "MUXF7" | "MUXF8") => return Some(()),
        (Target::Ice40, _) if cell.starts_with("SB_DFF") => &mut area.flip_flop,
        (Target::Xilinx7, "FDRE" | "FDSE" | "FDCE" | "FDPE") => &mut area.flip_flop,
        (Target::Xilinx7, "RAMB18E1") => &mut area.block_ram,
        (Target::Xilinx7, "RAMB36E1") => {
            area.block_ram += 2 * count;
            return Some(());
        }
        // A mark of where a module was before flattening.
        (_, "$scopeinfo") => return Some(()),
        // Clock buffers and pads are the board's.
        (Target::Xilinx7, "BUFG" | "IBUF" | "OBUF") => return Some(()),
        (Target::Xilinx7, _) if cell.starts_with("LUT") || cell == "INV" => &mut area.lut,
        (Target::Xilinx7, _) if cell.starts_with("RAM") || cell.starts_with("SRL") => &mut area.distributed_ram,
        (Target::Gates, _) if cell.starts_with("$_") && cell.contains("DFF") => &mut area.flip_flop,
        (Target::Gates, _) if cell.starts_with("$_") => &mut area.gate,
        // Ports of memories, whose bits are counted.
        (Target::Gates, _) if cell.starts_with("$mem") => return Some(()),
        _ => return None,
    };
    *place += count;
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What yosys 0.70 says of `f32_add`.
    const ECP5: &str = include_str!("fixtures/ecp5_cells.json");

    fn report(cell: &str) -> String {
        format!(r#"{{"design": {{"num_memory_bits": 0, "num_cells_by_type": {{"{cell}": 3}}}}}}"#)
    }

    #[test]
    fn a_report_is_read() {
        let expected = DeviceArea { lut: 599, carry: 59, flip_flop: 344, ..DeviceArea::default() };
        assert_eq!(parse(Target::Ecp5, ECP5), Ok(expected));
    }

    #[test]
    fn cells_go_where_they_belong() {
        let area = |target, cell: &str| parse(target, &report(cell)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(area(Target::Xilinx7, "RAMB36E1").block_ram, 6, "a RAMB36 is two RAMB18");
        assert_eq!(area(Target::Xilinx7, "LUT6").lut, 3);
        assert_eq!(area(Target::Xilinx7, "MUXF8"), DeviceArea::default());
        assert_eq!(area(Target::Ice40, "SB_DFFESR").flip_flop, 3);
        assert_eq!(area(Target::Gates, "$_DFFE_PP_").flip_flop, 3);
        assert_eq!(area(Target::Gates, "$_NAND_").gate, 3);
        assert_eq!(area(Target::Gates, "$mem_v2"), DeviceArea::default());
    }

    #[test]
    fn what_cannot_be_counted_is_an_error() {
        let unknown = parse(Target::Ecp5, &report("SB_LUT4")).unwrap_err();
        assert!(unknown.contains("SB_LUT4"), "{unknown}");
        assert!(parse(Target::Gates, &report("$mul")).is_err(), "a multiplier that was not mapped");
        let form = parse(Target::Ecp5, "{}").unwrap_err();
        assert!(form.contains("design"), "{form}");
    }
}
