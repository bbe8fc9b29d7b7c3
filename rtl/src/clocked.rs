//! Clocked blocks: registers with and without reset, and the ports of memories in the shape that synthesis recognizes.

use std::fmt::Write as _;

use super::canonical::Need;
use super::expression::{Expr, Primitive};
use super::memory::{Content, Style};
use super::module::Source;
use super::text::literal;
use super::writer::Writer;

/// A guarded assignment that is longer stands below its condition.
const GUARDED_CHARACTERS: usize = 88;

/// Assignments that happen under one condition, or always.
struct Guarded {
    enable: Option<String>,
    lines: Vec<String>,
}

/// Appends to the group of that condition, in order of first appearance.
fn add_guarded(groups: &mut Vec<Guarded>, enable: Option<String>, line: String) {
    match groups.iter_mut().find(|group| group.enable == enable) {
        Some(group) => group.lines.push(line),
        None => groups.push(Guarded { enable, lines: vec![line] }),
    }
}

fn write_guarded(groups: &[Guarded], indent: &str, out: &mut String) {
    let mut write = |indent: &str, line: &str| {
        let _ = writeln!(out, "{indent}{}", line.replace('\n', &format!("\n{indent}")));
    };
    let inner = format!("{indent}    ");
    for Guarded { enable, lines } in groups {
        match enable {
            None => lines.iter().for_each(|line| write(indent, line)),
            Some(enable) => {
                if let [line] = &lines[..]
                    && !line.contains('\n')
                    && indent.len() + enable.len() + line.len() <= GUARDED_CHARACTERS
                {
                    write(indent, &format!("if ({enable}) {line}"));
                    continue;
                }
                write(indent, &format!("if ({enable}) begin"));
                lines.iter().for_each(|line| write(&inner, line));
                write(indent, "end");
            }
        }
    }
}

impl Writer<'_> {
    /// The clocked blocks of the registers and memories that are there for `need`.
    pub fn clocked(&mut self, need: Need) -> String {
        let module = self.graph.module;
        let (mut free, mut resets, mut running) = (vec![], vec![], vec![]);
        for (index, signal) in module.signals.iter().enumerate() {
            let Source::Register { reset, next: Some(next) } = &signal.source else { continue };
            if self.graph.signals[index] != need {
                continue;
            }
            let enable = next.enable.as_ref().and_then(|enable| self.condition(*enable));
            let line = format!("{} <= {};", signal.name, self.expression(next.data));
            match reset {
                None => add_guarded(&mut free, enable, line),
                Some(value) => {
                    resets.push(format!("{} <= {};", signal.name, literal(signal.reference.width(), *value)));
                    add_guarded(&mut running, enable, line);
                }
            }
        }
        let mut out = String::new();
        if !resets.is_empty() {
            self.read_all("rst");
            write_reset_block(&resets, &running, &mut out);
        }
        write_block(&free, &[], &mut out);
        for index in 0..module.stores.len() {
            if self.graph.stores[index] == need && self.graph.memory_module(index).is_none() {
                let (groups, collisions) = self.store_ports(index);
                write_block(&groups, &collisions, &mut out);
            }
        }
        out
    }

    /// The text of an enable; none where it is always set.
    pub(super) fn condition(&mut self, enable: Expr) -> Option<String> {
        let always = self.graph.nodes[self.graph.node_of(enable)].operation == Primitive::Literal(1);
        (!always).then(|| self.expression(enable))
    }

    /// Write and registered reads of a memory, in the shape that synthesis recognizes, and what is read besides where both meet.
    fn store_ports(&mut self, index: usize) -> (Vec<Guarded>, Vec<Guarded>) {
        let module = self.graph.module;
        let store = &module.stores[index];
        let mut groups = vec![];
        let mut written = None;
        if let Content::Written(Some(port)) = &store.content {
            let enable = self.condition(port.enable);
            let (address, data) = (self.expression(port.address), self.expression(port.data));
            if store.style == Style::Unordered {
                written = Some((enable.clone(), address.clone()));
            }
            groups.push(Guarded { enable, lines: vec![format!("{}[{address}] <= {data};", store.name)] });
        }
        let (mut reads, mut collisions) = (vec![], vec![]);
        for (signal, record) in module.signals.iter().enumerate() {
            match &record.source {
                Source::Read { store: read, enable, address }
                    if *read == index && self.graph.signals[signal] != Need::Nobody =>
                {
                    let enable = enable.as_ref().and_then(|enable| self.condition(*enable));
                    let address = self.expression(*address);
                    if let Some((written, write_address)) = &written {
                        let enables = written.iter().chain(&enable).map(|enable| format!("({enable}) && "));
                        let meet = enables.collect::<String>() + &format!("({write_address}) == ({address})");
                        let line = format!("{} <= ~{}[{address}];", record.name, store.name);
                        collisions.push(Guarded { enable: Some(meet), lines: vec![line] });
                    }
                    add_guarded(&mut reads, enable, format!("{} <= {}[{address}];", record.name, store.name));
                }
                _ => {}
            }
        }
        groups.extend(reads);
        (groups, collisions)
    }
}

/// A clocked block, on a line if it is one statement; with assertions, `checked` comes last in it.
fn write_block(groups: &[Guarded], checked: &[Guarded], out: &mut String) {
    if groups.is_empty() {
        return;
    }
    let mut statements = String::new();
    write_guarded(groups, "    ", &mut statements);
    if checked.is_empty() && statements.lines().count() == 1 {
        let _ = writeln!(out, "always @(posedge clk) {}", statements.trim());
        return;
    }
    out.push_str("always @(posedge clk) begin\n");
    out.push_str(&statements);
    if !checked.is_empty() {
        out.push_str("`ifdef RTL_ASSERT\n");
        write_guarded(checked, "    ", out);
        out.push_str("`endif\n");
    }
    out.push_str("end\n");
}

fn write_reset_block(resets: &[String], running: &[Guarded], out: &mut String) {
    if let ([reset], [Guarded { enable, lines }]) = (resets, running)
        && let [line] = &lines[..]
        && !line.contains('\n')
        && line.len() + enable.as_ref().map_or(0, String::len) <= GUARDED_CHARACTERS
    {
        let condition = enable.as_ref().map_or(String::new(), |enable| format!("if ({enable}) "));
        let _ = writeln!(out, "always @(posedge clk) begin\n    if (rst) {reset}\n    else {condition}{line}\nend");
        return;
    }
    out.push_str("always @(posedge clk) begin\n    if (rst) begin\n");
    for line in resets {
        let _ = writeln!(out, "        {line}");
    }
    match running {
        [Guarded { enable: Some(enable), lines }] => {
            let _ = writeln!(out, "    end else if ({enable}) begin");
            write_guarded(&[Guarded { enable: None, lines: lines.clone() }], "        ", out);
        }
        _ => {
            out.push_str("    end else begin\n");
            write_guarded(running, "        ", out);
        }
    }
    out.push_str("    end\nend\n");
}
