//! From checked modules to Verilog: identical ones are folded, the rest are named by unit and parameters.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::fmt::Write as _;
use std::ops::Range;

use super::area::{Area, Storage};
use super::canonical::Graph;
use super::emit::{self, Body, Implicit, PortKind};
use super::frame::{Frame, FramePort};
use super::memory_module::MemoryModule;
use super::module::Module;
use super::text::filled;

/// The one lint rule that is about files and not about hardware.
const ONE_FILE: &str =
    "// The whole design is one file, named after its top.\n/* verilator lint_off DECLFILENAME */\n\n";

/// A module of the design, by content.
pub(super) struct Lowered {
    pub unit: String,
    pub parameters: Parameters,
    pub area: Area,
    pub memories: Vec<Storage>,
    /// Indices of the modules of its children.
    pub children: Vec<usize>,
    summary: String,
    body: Body,
    implicit: Implicit,
}

/// What makes two modules one: unit, parameters, the modules of the children, text.
type Content = (String, Parameters, Vec<usize>, Body);

/// Names and values.
type Parameters = Vec<(String, String)>;

/// All modules of a design, children before parents.
#[derive(Default)]
pub(super) struct Library {
    pub modules: Vec<Lowered>,
    by_address: HashMap<*const Module, usize>,
    by_content: HashMap<Content, usize>,
}

impl Library {
    /// Adds a module that stands on top of a file, and all below it; returns its index.
    pub fn add_top(&mut self, module: &Module) -> usize {
        self.add(module, true)
    }

    fn add(&mut self, module: &Module, is_top: bool) -> usize {
        if let Some(&known) = self.by_address.get(&std::ptr::from_ref(module)) {
            return known;
        }
        let children: Vec<usize> = module.children.iter().map(|child| self.add(&child.module, false)).collect();
        let below: Vec<Implicit> = children.iter().map(|&child| self.modules[child].implicit).collect();
        let graph = Graph::of(module);
        let (body, implicit) = emit::body(&graph, &below, is_top);
        let content = (module.unit.clone(), module.parameters.clone(), children.clone(), body.clone());
        let index = *self.by_content.entry(content).or_insert(self.modules.len());
        if index == self.modules.len() {
            self.modules.push(Lowered {
                unit: module.unit.clone(),
                parameters: module.parameters.clone(),
                area: Area::of(&graph),
                memories: Storage::of(&graph),
                children,
                summary: module.summary.clone(),
                body,
                implicit,
            });
        }
        self.by_address.insert(std::ptr::from_ref(module), index);
        index
    }

    /// The name of every module: its unit, and where a unit has several, what tells them apart. The first `beside` modules have the
    /// names that they have without the others.
    pub fn names(&self, beside: usize) -> Vec<String> {
        let (mut names, mut taken) = (vec![], HashSet::new());
        for end in [beside, self.modules.len()] {
            self.name_up_to(end, &mut names, &mut taken);
        }
        names
    }

    /// Names the modules that follow those named, up to `end`.
    fn name_up_to(&self, end: usize, names: &mut Vec<String>, taken: &mut HashSet<String>) {
        let mut units: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (index, module) in self.modules[..end].iter().enumerate() {
            units.entry(&module.unit).or_default().push(index);
        }
        let first = names.len();
        names.extend(self.modules[first..end].iter().map(|module| module.unit.clone()));
        taken.extend(units.keys().map(|unit| unit.to_string()));
        for members in units.values().filter(|members| members.len() > 1) {
            for &member in members.iter().filter(|member| **member >= first) {
                let base = format!("{}{}", self.modules[member].unit, self.suffix(member, members));
                let mut name = base.clone();
                let mut ordinal = 1;
                while !taken.insert(name.clone()) {
                    ordinal += 1;
                    name = format!("{base}_v{ordinal}");
                }
                names[member] = name;
            }
        }
    }

    /// `_d16_w64` from the parameters in which the members of a unit differ.
    fn suffix(&self, member: usize, members: &[usize]) -> String {
        let parameters = &self.modules[member].parameters;
        let differs = |name: &str, value: &str| {
            let same = |&other: &usize| self.modules[other].parameters.iter().any(|(n, v)| n == name && v == value);
            !members.iter().all(same)
        };
        let mut suffix = String::new();
        for (name, value) in parameters.iter().filter(|(name, value)| differs(name, value)) {
            let initial = &name[..1];
            let ambiguous = parameters.iter().filter(|(other, _)| other.starts_with(initial)).count() > 1;
            let value: String = value.chars().filter(char::is_ascii_alphanumeric).collect();
            let _ = write!(suffix, "_{}{value}", if ambiguous { name } else { initial });
        }
        suffix
    }

    /// Verilog text of all modules but the first `beside`, parents before children: a file named after the top starts with it.
    pub fn verilog(&self, names: &[String], beside: usize) -> String {
        let modules = self.modules.iter().zip(names).skip(beside);
        let mut frames: Vec<_> = modules.rev().map(|(module, name)| frame(module, name, names).verilog()).collect();
        let known = self.memory_modules(0..beside);
        let memories = self.memory_modules(beside..self.modules.len());
        frames.extend(memories.difference(&known).map(|memory| memory.verilog()));
        let text = frames.join("\n");
        if frames.len() > 1 { format!("{ONE_FILE}{text}") } else { text }
    }

    /// The modules of the memories in some of the modules.
    pub fn memory_modules(&self, modules: Range<usize>) -> BTreeSet<MemoryModule> {
        self.modules[modules].iter().flat_map(|module| module.body.memories.iter().copied()).collect()
    }

    /// Ports of a module in order.
    pub fn ports(&self, index: usize) -> &[(String, u32, PortKind)] {
        &self.modules[index].body.ports
    }

    /// How often each module occurs below (and as) the top, which is the last.
    pub fn instance_counts(&self) -> Vec<u64> {
        let mut counts = vec![0; self.modules.len()];
        if let Some(top) = counts.last_mut() {
            *top = 1;
        }
        for index in (0..self.modules.len()).rev() {
            for &child in &self.modules[index].children {
                counts[child] += counts[index];
            }
        }
        counts
    }
}

fn frame(module: &Lowered, name: &str, names: &[String]) -> Frame {
    let mut header = vec![module.summary.clone()];
    header.extend(module.parameters.iter().map(|(name, value)| format!("{name} = {value}")));
    let mut body = module.body.before.clone();
    let mut after_short = None;
    for ((instance, connections), &child) in module.body.instances.iter().zip(&module.children) {
        let text = format!("{} {instance} {}", names[child], filled(connections));
        // Instances of a line each stand together.
        let (is_short, after_short) = (!text.contains('\n'), after_short.replace(!text.contains('\n')));
        if !body.is_empty() && !(is_short && after_short == Some(true)) {
            body.push('\n');
        }
        let _ = writeln!(body, "{text}");
    }
    if !body.is_empty() && !module.body.after.is_empty() {
        body.push('\n');
    }
    body += &module.body.after;
    let ports = module.body.ports.iter();
    let ports = ports.map(|(name, width, kind)| FramePort { name: name.clone(), width: *width, kind: *kind }).collect();
    Frame { name: name.into(), header, ports, body }
}
