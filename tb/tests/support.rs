//! What the tests of units share.

use std::collections::HashSet;
use std::sync::Arc;

use pointcore_contract::{Direction, Interface, Port};
use pointcore_golden::unit::Unit;
pub use pointcore_tb::verilated::substitute::cases;
use pointcore_tb::verilated::{BuildOptions, Builder, Library, StreamDeclaration, VerilogSource};
use rtl::{self, Design, Module, elaborate};

/// A unit, elaborated; its outputs must be functions of registers only.
pub fn elaborated(unit: &Module) -> Design {
    let design = elaborate(unit).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(design.combinational_paths(), [], "{} has a path from input to output", design.top());
    design
}

/// A unit, elaborated and verilated.
pub fn verilate(unit: &Module) -> Arc<Library> {
    build(&VerilogSource::from(&elaborated(unit)))
}

/// A design, verilated so that it builds soonest.
pub fn build(source: &VerilogSource) -> Arc<Library> {
    let builder = Builder::new().unwrap_or_else(|error| panic!("{error}"));
    builder.build(source, BuildOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The hardware declares the streams and pulses of a unit's interface, fields in the records' order, and no others.
pub fn check_streams(library: &Library, interface: &Interface) {
    let specified = interface.groups.iter().filter(|group| group.kind.has_flag()).map(|group| {
        let direction = match group.kind.direction() {
            Direction::Input => rtl::Direction::Input,
            Direction::Output => rtl::Direction::Output,
        };
        let names = group.fields.iter().map(|field| field.name.clone());
        let pulse = StreamDeclaration::pulse(group.name, group.flag, direction, names);
        StreamDeclaration { has_ready: group.kind.has_ready(), ..pulse }
    });
    let [declared, specified]: [HashSet<_>; 2] =
        [library.source().streams.iter().cloned().collect(), specified.collect()];
    assert_eq!(declared, specified, "{}", library.source().top);
}

/// For each of the specified ports of a direction, its place among the hardware's.
pub fn places(library: &Library, specified: &[Port], direction: Direction) -> Vec<usize> {
    let side = if direction == Direction::Input { library.inputs() } else { library.outputs() };
    let of_direction = specified.iter().filter(|port| port.direction == direction);
    let place = |port: &Port| side.iter().position(|other| other.name == port.name);
    of_direction.map(|port| place(port).unwrap_or_else(|| panic!("the hardware has no port {}", port.name))).collect()
}

/// A model that finds its words by the names of the ports: the hardware's order need not be the specification's.
pub fn by_name<U: Unit>(
    library: &Library,
    specified: &[Port],
    mut model: U,
) -> impl FnMut(&[u64], &mut [u64]) + use<U> {
    let [input_places, output_places] =
        [Direction::Input, Direction::Output].map(|direction| places(library, specified, direction));
    let (mut inputs, mut outputs) = (vec![0; input_places.len()], vec![0; output_places.len()]);
    move |hardware_inputs, hardware_outputs| {
        inputs.iter_mut().zip(&input_places).for_each(|(input, &place)| *input = hardware_inputs[place]);
        model.step(&inputs, &mut outputs);
        outputs.iter().zip(&output_places).for_each(|(output, &place)| hardware_outputs[place] = *output);
    }
}
