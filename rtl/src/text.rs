//! Small pieces of Verilog text.

/// A concatenation longer than this is written over several lines.
const LINE_CHARACTERS: usize = 100;
/// Literals from here on are written in hexadecimal.
const HEXADECIMAL_FROM: u128 = 1024;

/// `[7:0] ` before the name of a declaration, nothing for one bit.
pub(super) fn range(width: u32) -> String {
    if width == 1 { String::new() } else { format!("[{}:0] ", width - 1) }
}

/// A literal of exact width.
pub(super) fn literal(width: u32, value: u128) -> String {
    if value < HEXADECIMAL_FROM { format!("{width}'d{value}") } else { format!("{width}'h{value:x}") }
}

/// `{a, b}`, over several lines where it is long.
pub(super) fn braced(parts: &[String]) -> String {
    let length: usize = parts.iter().map(|part| part.len() + 2).sum();
    if length > LINE_CHARACTERS {
        format!("{{\n    {}\n}}", parts.join(",\n    "))
    } else {
        format!("{{{}}}", parts.join(", "))
    }
}
