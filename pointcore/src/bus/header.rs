//! `registers.h`: the same for C and C++.

use super::Interface;
use super::constants::Constant;
use pointcore_contract::bus::packets::NamedRecord;
use pointcore_contract::bus::{Access, Layout};
use std::fmt::Write;

/// A size that the compiler is to agree with.
const SIZE_CHECK: &str = "\
#ifdef __cplusplus
#define POINTCORE_STATIC_ASSERT static_assert
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define POINTCORE_STATIC_ASSERT _Static_assert
#else
#define POINTCORE_STATIC_ASSERT(holds, text) extern int pointcore_static_assert[(holds) ? 1 : -1]
#endif
";

/// The document.
pub(super) fn document(interface: &Interface) -> String {
    let Interface { core, config, registers, packets, constants } = interface;
    let (lower, upper) = (core.name(), core.name().to_uppercase());
    let mut out = format!(
        "/* {lower}_axi: registers, packets and memory records. Written by pointcore; docs/interfaces.md says how they are used. */\n"
    );
    // Writing to a string cannot fail, so the results below carry no information.
    let _ = writeln!(
        out,
        "#ifndef POINTCORE_{upper}_REGISTERS_H\n#define POINTCORE_{upper}_REGISTERS_H\n\n#include <stdint.h>\n"
    );
    let _ = writeln!(out, "#ifndef POINTCORE_STATIC_ASSERT\n{SIZE_CHECK}#endif\n");
    let _ = writeln!(
        out,
        "#define {upper}_STREAM_BITS {}\n#define {upper}_MEMORY_BITS {}\n",
        config.stream_bits, config.memory_bits
    );
    out += "/* Byte addresses of registers, and their bits. */\n";
    for register in registers {
        let access = match register.access() {
            Access::Read => "read",
            Access::Write => "write",
            Access::ReadWrite => "read, write",
        };
        let name = format!("{upper}_{}", register.name.to_uppercase());
        let _ = writeln!(out, "#define {name} 0x{:03x}u /* {access}: {} */", register.address, register.doc);
        for (bit, (field, doc)) in register.bits().iter().enumerate() {
            let _ = writeln!(out, "#define {name}_{} (UINT32_C(1) << {bit}) /* {doc} */", field.to_uppercase());
        }
    }
    let identity = registers.iter().find(|register| register.name == "id").map_or(0, |register| register.reset());
    let _ = writeln!(out, "#define {upper}_IDENTITY UINT32_C(0x{identity:08x}) /* what {upper}_ID reads */");
    out += "\n/* What the configuration fixes. */\n";
    for Constant { name, value, doc, .. } in constants {
        let _ = writeln!(out, "#define {upper}_{name} {value} /* {doc} */");
    }
    for packet in packets {
        structure(lower, packet, &mut out);
    }
    let _ = writeln!(out, "\n#endif");
    out
}

/// A record as a struct, its padding named so that nothing is left to the compiler.
fn structure(core: &str, packet: &NamedRecord, out: &mut String) {
    let name = format!("{core}_{}", packet.name);
    let _ = writeln!(out, "\n/* {} */\nstruct {name} {{", packet.doc);
    let (mut end, mut gaps) = (0, 0);
    let mut pad = |to: u32, end: u32, out: &mut String| {
        if to > end {
            let _ = writeln!(out, "    uint8_t padding_{gaps}[{}];", to - end);
            gaps += 1;
        }
    };
    for place in Layout::of(&packet.fields).places {
        pad(place.byte, end, out);
        let bits = place.bytes * 8;
        let _ = writeln!(out, "    uint{bits}_t {}; /* {} bits */", place.name, place.width);
        end = place.byte + place.bytes;
    }
    pad(packet.bytes, end, out);
    let bytes = packet.bytes;
    let upper = name.to_uppercase();
    let _ = writeln!(
        out,
        "}};\nPOINTCORE_STATIC_ASSERT(sizeof(struct {name}) == {bytes}, \"{name} takes {bytes} bytes\");"
    );
    let _ = writeln!(out, "#define {upper}_BYTES {bytes}u");
    for field in &packet.fields {
        let _ = writeln!(out, "#define {upper}_{}_BITS {}u", field.name.to_uppercase(), field.width);
    }
}
