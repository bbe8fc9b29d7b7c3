//! `registers.md`: registers, packets and memory records as tables.

use super::Interface;
use super::constants::Constant;
use pointcore_contract::bus::{Access, Layout, Register};
use std::fmt::Write;

fn access(register: &Register) -> &'static str {
    match register.access() {
        Access::Read => "R",
        Access::Write => "W",
        Access::ReadWrite => "RW",
    }
}

/// What a register is, with its bits.
fn meaning(register: &Register) -> String {
    let bits = register.bits().iter().enumerate().map(|(bit, (name, doc))| format!("bit {bit} `{name}`: {doc}"));
    std::iter::once(register.doc.clone()).chain(bits).collect::<Vec<_>>().join("; ")
}

/// The document.
pub(super) fn document(interface: &Interface) -> String {
    let Interface { core, config, registers, packets, constants } = interface;
    let name = core.name();
    let mut out = format!("# `{name}_axi`: registers, packets, memory\n\n");
    // Writing to a string cannot fail, so the results below carry no information.
    let _ = writeln!(
        out,
        "Written by pointcore for streams of {} bits and memory of {} bits. `docs/interfaces.md` says how all of it is used;\n\
         `registers.h` is the same for C.\n\n## Registers\n",
        config.stream_bits, config.memory_bits
    );
    out += "| address | name | access | bits | reset | what |\n|---|---|---|---|---|---|\n";
    for register in registers {
        let (address, width, reset) = (register.address, register.width, register.reset());
        let (name, access, what) = (&register.name, access(register), meaning(register));
        let _ = writeln!(out, "| 0x{address:03x} | `{name}` | {access} | {width} | 0x{reset:x} | {what} |");
    }
    out += "\n## Constants\n\n| name | value | what |\n|---|---|---|\n";
    for Constant { name, number, doc, .. } in constants {
        let _ = writeln!(out, "| `{}` | {number} | {doc} |", name.to_lowercase());
    }
    out += "\n## Packets and memory records\n";
    for packet in packets {
        let _ = write!(out, "\n### `{}`\n\n{} {} bytes.\n\n", packet.name, packet.doc, packet.bytes);
        out += "| byte | field | bits | container |\n|---|---|---|---|\n";
        for place in Layout::of(&packet.fields).places {
            let container = place.bytes * 8;
            let _ = writeln!(out, "| {} | `{}` | {} | uint{container}_t |", place.byte, place.name, place.width);
        }
    }
    out
}
