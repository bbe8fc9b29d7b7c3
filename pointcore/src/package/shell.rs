//! A unit between registers, behind few pins: so its own logic is what is timed, and units with more ports than a package
//! has pins can be placed.

use crate::generated::GenerateError;
use rtl::{Direction, Expr, Module, cat, elaborate};
use std::rc::Rc;

/// Inputs of one lookup table: no path of the shell's own goes through more.
const LUT_INPUTS: u32 = 4;

/// Name of the unit in the shell.
pub const UNIT_INSTANCE: &str = "unit";

/// A unit inside its shell, as Verilog.
#[derive(Debug, Clone)]
pub struct Shelled {
    /// Both modules and all below.
    pub verilog: String,
    /// Name of the shell's module.
    pub shell: String,
    /// Name of the unit's module.
    pub unit: String,
}

impl Shelled {
    /// The text of the shell's module alone, without the unit.
    #[must_use]
    pub fn outermost(&self) -> String {
        let end = "endmodule\n";
        let length = self.verilog.find(end).map_or(self.verilog.len(), |place| place + end.len());
        // The design is in another file; this one is named after its only module.
        self.verilog[..length].to_owned()
    }
}

/// Puts a unit between a shift register that drives its inputs and registers that catch its outputs and are folded into one bit.
///
/// # Errors
/// A fault of the generator.
pub fn wrap(unit: impl Into<Rc<Module>>) -> Result<Shelled, GenerateError> {
    wrap_named("synthesis_shell", unit)
}

/// As [`wrap`], in a module of this name.
///
/// # Errors
/// A fault of the generator.
pub fn wrap_named(name: &str, unit: impl Into<Rc<Module>>) -> Result<Shelled, GenerateError> {
    let unit = unit.into();
    let ports = elaborate(&unit)?.ports().to_vec();
    let mut m = Module::new(name, "A unit between registers, behind few pins.");
    let instance = m.instance(UNIT_INSTANCE, unit);
    let mut last = m.input("serial_in", 1);
    let mut caught = Vec::new();
    for port in ports.iter().filter(|port| !["clk", "rst"].contains(&port.name.as_str())) {
        match port.direction {
            Direction::Input => {
                let register = m.reg(&format!("drive_{}", port.name), port.width);
                let shifted = cat([*register, last]).trunc(port.width);
                m.next(register, shifted);
                m.connect(instance, &port.name, register);
                last = register.bit(port.width - 1);
            }
            Direction::Output => {
                let value = m.out(instance, &port.name);
                let register = m.reg(&format!("catch_{}", port.name), port.width);
                m.next(register, value);
                caught.push(register.expr());
            }
        }
    }
    // The last bit of the chain is caught too: nothing of it may be optimized away.
    caught.push(last);
    let folded = fold(&mut m, cat(caught));
    m.output("serial_out", folded);
    let design = elaborate(&m)?;
    let [.., unit, shell] = design.modules() else {
        unreachable!("the shell contains the unit, and parents come last")
    };
    Ok(Shelled { verilog: design.verilog().to_owned(), shell: shell.name.clone(), unit: unit.name.clone() })
}

/// The parity of all bits, through a tree of registers one lookup table apart.
fn fold(m: &mut Module, bits: Expr) -> Expr {
    let mut bits = bits;
    for level in 0.. {
        if bits.width() == 1 {
            break;
        }
        let parities: Vec<_> = (0..bits.width())
            .step_by(LUT_INPUTS as usize)
            .map(|low| {
                let group = low..bits.width().min(low + LUT_INPUTS);
                group.map(|index| bits.bit(index)).reduce(|a, b| a ^ b).expect("groups are not empty")
            })
            .collect();
        let parities = cat(parities);
        let register = m.reg(&format!("fold_{level}"), parities.width());
        m.next(register, parities);
        bits = register.expr();
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::Format;
    use pointcore_hdl::float::add;

    #[test]
    fn a_shell_has_one_pin_each_way_and_no_path_through() {
        let operator = add::module(Format::BF16, add::stages(Format::BF16));
        let wrapped = wrap(operator.module).unwrap_or_else(|error| panic!("{error}"));
        let shell = wrapped.verilog.split("endmodule").next().unwrap_or_default();
        for part in [format!("module {}", wrapped.shell), format!("{} {UNIT_INSTANCE}", wrapped.unit)] {
            assert!(shell.contains(&part), "`{part}` is missing in: {shell}");
        }
        let [inputs, outputs] = ["input ", "output "].map(|kind| shell.matches(kind).count());
        assert_eq!([inputs, outputs], [3, 1], "clk, rst, serial_in, serial_out: {shell}");
    }
}
