//! The streams' queues pass through every tool, and large ones are block RAM.

use pointcore_hdl::stream::{fifo, skid};
use rtl::elaborate;

use crate::lint::{accepts, lint};

#[test]
fn tools_take_the_stream_units() {
    let layout = [("x", 16), ("y", 1)];
    for depth in [2, 5, 64] {
        let design = elaborate(&fifo(depth, &layout)).expect("the unit has no fault");
        lint(&design);
        assert_eq!(design.combinational_paths(), []);
    }
    let design = elaborate(&skid(&layout)).expect("the unit has no fault");
    lint(&design);
    assert_eq!(design.combinational_paths(), []);
}

#[test]
fn synthesis_finds_block_ram() {
    let design = elaborate(&fifo(512, &[("item", 36)])).expect("the unit has no fault");
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::write(folder.path().join("fifo.v"), design.verilog()).expect("a temporary folder can be written");
    for (flow, block_ram) in [("synth_ecp5", "DP16KD"), ("synth_ice40", "SB_RAM40_4K"), ("synth_xilinx", "RAMB18E1")] {
        let script = format!(
            "read_verilog fifo.v; {flow} -top stream_fifo -run begin:map_ffram; select -assert-min 1 t:{block_ram}"
        );
        accepts("yosys", &["-q", "-p", &script], folder.path(), design.verilog());
    }
}
