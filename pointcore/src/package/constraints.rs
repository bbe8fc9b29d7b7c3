//! Constraints of a module with one clock.

/// The clock's frequency, and its period, that designs aim at.
const CLOCK_MHZ: u32 = 100;
const CLOCK_NS: &str = "10.000";

/// The constraint files of a module, by ending.
pub fn of(module: &str) -> [(&'static str, String); 3] {
    let clock = format!("create_clock -name clk -period {CLOCK_NS} [get_ports clk]\n");
    [
        (
            "lpf",
            format!(
                "# {module} on a Lattice ECP5 (nextpnr-ecp5, Diamond): the one clock.\n\
                 # Pins belong to the board: add LOCATE and IOBUF lines for yours.\n\
                 FREQUENCY PORT \"clk\" {CLOCK_MHZ} MHZ;\n"
            ),
        ),
        (
            "xdc",
            format!(
                "# {module} on an AMD 7-series device (Vivado): the one clock.\n\
                 # Pins belong to the board: add PACKAGE_PIN and IOSTANDARD lines for yours.\n{clock}"
            ),
        ),
        ("sdc", format!("# {module}, Synopsys design constraints (Quartus, OpenSTA): the one clock.\n{clock}")),
    ]
}
