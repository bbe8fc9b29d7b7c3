//! What holds of every unit's ports.

use pointcore_contract::{Direction, Port};
use rtl::{self, Module, elaborate};

fn spec_port(port: &rtl::Port) -> Port {
    let direction = match port.direction {
        rtl::Direction::Input => Direction::Input,
        rtl::Direction::Output => Direction::Output,
    };
    Port { name: port.name.clone(), width: port.width, direction }
}

/// The ports without the clock; there must be no path from input to output.
fn ports(module: &Module) -> Vec<Port> {
    let design = elaborate(module).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(design.combinational_paths(), [], "{}", module.unit());
    design.ports().iter().filter(|port| port.name != "clk").map(spec_port).collect()
}

/// Ports as specified, in any order since the harness finds them by name, and no path from input to output.
pub(crate) fn check(module: &Module, mut specified: Vec<Port>) {
    let mut found = ports(module);
    found.sort_by(|a, b| a.name.cmp(&b.name));
    specified.sort_by(|a, b| a.name.cmp(&b.name));
    assert_eq!(found, specified, "{}", module.unit());
}

/// Ports as specified, in that order, and no path from input to output.
pub(crate) fn check_in_order(module: &Module, specified: &[Port]) {
    assert_eq!(ports(module), specified, "{}", module.unit());
}
