//! Small pieces of Verilog text.

use std::collections::BTreeMap;

/// A concatenation longer than this is written over several lines.
pub(super) const LINE_CHARACTERS: usize = 100;
/// Connections of an instance that fit one line together.
const CONNECTION_CHARACTERS: usize = 72;
/// What stands before a comment behind a declaration.
pub(super) const COMMENT: &str = "  // ";
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
        format!("{{\n    {}\n}}", wrapped(parts).join(",\n    "))
    } else {
        format!("{{{}}}", parts.join(", "))
    }
}

/// Connections of an instance in parentheses: on one line where they fit, else a line for those of each group of ports, which begin
/// alike; those of no group stand before the next one.
pub(super) fn filled(connections: &[(String, String)]) -> String {
    let texts: Vec<String> = connections.iter().map(|(port, value)| format!(".{port}({value})")).collect();
    let whole = texts.join(", ");
    if whole.len() <= CONNECTION_CHARACTERS && !whole.contains('\n') {
        return format!("({whole});");
    }
    let group = |port: &str| {
        let first = format!("{}_", port.split('_').next().unwrap_or(port));
        let is_group = connections.iter().any(|(other, _)| other.starts_with(&first));
        is_group.then_some(first)
    };
    let mut lines: Vec<String> = vec![];
    let mut before: Option<Option<String>> = None;
    for ((port, _), text) in connections.iter().zip(texts) {
        let group = Some(group(port));
        match lines.last_mut() {
            Some(line)
                if (before == group || before == Some(None))
                    && line.len() + text.len() < LINE_CHARACTERS
                    && !line.contains('\n')
                    && !text.contains('\n') =>
            {
                *line += &format!(", {text}");
            }
            _ => lines.push(text),
        }
        before = group;
    }
    let lines: Vec<String> = lines.iter().map(|line| format!("    {}", line.replace('\n', "\n    "))).collect();
    format!("(\n{}\n);", lines.join(",\n"))
}

/// The parts with commas between, as many on each line as it holds.
pub(super) fn wrapped(parts: &[String]) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for part in parts {
        match lines.last_mut() {
            Some(line) if line.len() + part.len() < LINE_CHARACTERS && !part.contains('\n') && !line.contains('\n') => {
                *line += &format!(", {part}");
            }
            _ => lines.push(part.clone()),
        }
    }
    lines
}

/// Declarations of one kind and width after each other, which share lines.
#[derive(Default)]
pub(super) struct Declarations(Vec<(String, Vec<String>)>);

impl Declarations {
    /// A declaration behind those before.
    pub fn add(&mut self, kind: &str, width: u32, name: &str) {
        let head = format!("{kind} {}", range(width));
        match self.0.last_mut() {
            Some((last, names)) if *last == head => names.push(name.into()),
            _ => self.0.push((head, vec![name.into()])),
        }
    }

    /// A statement for as many names as fit a line, and one for each of which something is said.
    pub fn text(&self, documents: &BTreeMap<String, String>) -> String {
        let mut out = String::new();
        for (head, names) in &self.0 {
            let runs = names.chunk_by(|a, b| !documents.contains_key(a) && !documents.contains_key(b));
            for run in runs {
                let comment = documents.get(&run[0]).map_or(String::new(), |text| format!("{COMMENT}{text}"));
                wrapped(run).iter().for_each(|names| out += &format!("{head}{names};{comment}\n"));
            }
        }
        out
    }
}
