//! From checked modules to Verilog: identical ones are folded, the rest are named by unit and variants.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::fmt::Write as _;
use std::ops::Range;
use std::rc::Rc;

use super::area::{Area, Storage};
use super::canonical::Graph;
use super::emit::{self, Body, Implicit, PortKind};
use super::foreign::ForeignBlock;
use super::frame::{Frame, FramePort};
use super::interface::StreamDeclaration;
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
    /// Names of those that are part of its name.
    variants: Vec<String>,
    pub area: Area,
    pub memories: Vec<Storage>,
    /// Indices of the modules of its children.
    pub children: Vec<usize>,
    summary: String,
    /// Those that its ports form.
    pub streams: Vec<StreamDeclaration>,
    /// What is said of ports, by their names: no part of what makes two modules one.
    documents: BTreeMap<String, String>,
    foreign: Option<Rc<ForeignBlock>>,
    body: Body,
    implicit: Implicit,
}

impl Lowered {
    /// `_d16_w64` from the variants: first letters, or words where those begin alike; names of formats and the like stand alone.
    fn suffix(&self) -> String {
        let stands_alone = |value: &str| value.starts_with(|c: char| c.is_ascii_alphabetic());
        let variants = self.parameters.iter().filter(|(name, _)| self.variants.contains(name));
        let keyed = |initial: &str| {
            let alike = variants.clone().filter(|(name, value)| name.starts_with(initial) && !stands_alone(value));
            alike.count()
        };
        let part = |(name, value): &(String, String)| {
            let text: String = value.chars().filter(char::is_ascii_alphanumeric).collect();
            match &name[..1] {
                _ if stands_alone(value) => format!("_{text}"),
                initial if keyed(initial) > 1 => format!("_{name}{text}"),
                initial => format!("_{initial}{text}"),
            }
        };
        variants.clone().map(part).collect()
    }
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
        let (body, implicit) = match &module.foreign {
            Some(foreign) => (foreign.body(&module.unit), Implicit { clk: foreign.is_clocked(), rst: false }),
            None => emit::body(&graph, &below, is_top),
        };
        let content = (module.unit.clone(), module.parameters.clone(), children.clone(), body.without_comments());
        let index = *self.by_content.entry(content).or_insert(self.modules.len());
        if index == self.modules.len() {
            self.modules.push(Lowered {
                unit: module.unit.clone(),
                parameters: module.parameters.clone(),
                variants: module.variants.clone(),
                area: Area::of(&graph),
                memories: Storage::of(&graph),
                children,
                summary: module.summary.clone(),
                streams: module.streams.clone(),
                documents: module.documents.clone(),
                foreign: module.foreign.clone(),
                body,
                implicit,
            });
        }
        self.by_address.insert(std::ptr::from_ref(module), index);
        index
    }

    /// The name of every module: its unit, and its variants behind, whatever else is in the design. Tops have their unit's name. Should
    /// two modules still be of one name, those after the first get a number; the first `beside` modules do not depend on the others.
    pub fn names(&self, beside: usize) -> Vec<String> {
        let is_top = |index: usize| index + 1 == beside || index + 1 == self.modules.len();
        let tops = self.modules.iter().enumerate().filter(|(index, _)| is_top(*index));
        let mut taken: HashSet<String> = tops.map(|(_, module)| module.unit.clone()).collect();
        let name = |(index, module): (usize, &Lowered)| {
            if is_top(index) {
                return module.unit.clone();
            }
            let base = format!("{}{}", module.unit, module.suffix());
            let copies = (2..).map(|copy| format!("{base}_v{copy}"));
            let mut candidates = std::iter::once(base.clone()).chain(copies);
            candidates.find(|name| taken.insert(name.clone())).expect("there is always another number")
        };
        self.modules.iter().enumerate().map(name).collect()
    }

    /// Names and Verilog texts of all modules but the first `beside`, parents before children.
    pub fn files(&self, names: &[String], beside: usize) -> Vec<(String, String)> {
        let modules = self.modules.iter().zip(names).skip(beside);
        let file = |(module, name): (&Lowered, &String)| {
            let text = match &module.foreign {
                Some(foreign) => foreign.verilog(name, &header(module)),
                None => frame(module, name, names).verilog(),
            };
            (name.clone(), text)
        };
        let mut files: Vec<_> = modules.rev().map(file).collect();
        let known = self.memory_modules(0..beside);
        let memories = self.memory_modules(beside..self.modules.len());
        files.extend(memories.difference(&known).map(|memory| (memory.name(), memory.verilog())));
        files
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

/// The modules' texts as one file: named after the top, it starts with it.
pub(super) fn single_file(files: &[(String, String)]) -> String {
    let texts: Vec<&str> = files.iter().map(|(_, text)| text.as_str()).collect();
    let text = texts.join("\n");
    if files.len() > 1 { format!("{ONE_FILE}{text}") } else { text }
}

/// What stands above a module: its summary and its parameters.
fn header(module: &Lowered) -> Vec<String> {
    let parameters = module.parameters.iter().map(|(name, value)| format!("{name} = {value}"));
    [module.summary.clone()].into_iter().chain(parameters).collect()
}

fn frame(module: &Lowered, name: &str, names: &[String]) -> Frame {
    let mut body = module.body.before.clone();
    let mut after_short = None;
    for ((instance, connections), &child) in module.body.instances.iter().zip(&module.children) {
        let text = format!("{} {instance} {}", names[child], filled(connections));
        // Instances of a line each stand together.
        let (is_short, after_short) = (!text.contains('\n'), after_short.replace(!text.contains('\n')));
        let stands_together = body.is_empty() || (is_short && after_short == Some(true));
        if !stands_together {
            body.push('\n');
        }
        let _ = writeln!(body, "{text}");
    }
    if !body.is_empty() && !module.body.after.is_empty() {
        body.push('\n');
    }
    body += &module.body.after;
    let port = |(name, width, kind): &(String, u32, PortKind)| FramePort {
        name: name.clone(),
        width: *width,
        kind: *kind,
        document: module.documents.get(name).cloned(),
    };
    Frame { name: name.into(), header: header(module), ports: module.body.ports.iter().map(port).collect(), body }
}
