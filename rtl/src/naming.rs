//! What a wire is called that its author gave no name: by what it is made of, `phase_is_4`, or where that grows long by what it is
//! for, `found_choice`.

use std::collections::HashSet;

use super::canonical::{Graph, Need};
use super::expression::{Expr, Primitive};
use super::memory::Content;
use super::module::{Module, PortDeclaration, Source};
use super::names;

/// A name made of operands' names is no longer than this.
const COMPOSED_CHARACTERS: usize = 30;
/// Literals up to this stand in names.
const LITERAL_MAX: u128 = 999;

/// Finds names for the nodes of a module.
pub(super) struct Namer {
    /// By node: what one of those that read it is called.
    purposes: Vec<String>,
    taken: HashSet<String>,
}

impl Namer {
    pub fn new(graph: &Graph) -> Self {
        let mut taken = graph.module.names.clone();
        taken.insert("_unused".into());
        Self { purposes: purposes(graph), taken }
    }

    /// A name that nothing else has. `operand` says what another node is called, if it is called anything.
    pub fn name(&mut self, graph: &Graph, node: usize, operand: impl Fn(usize) -> Option<String>) -> String {
        let stem = composed(graph, node, operand)
            .filter(|name| name.len() <= COMPOSED_CHARACTERS && names::fault(name).is_none())
            .unwrap_or_else(|| format!("{}_{}", self.purposes[node], noun(&graph.nodes[node].operation)));
        let copies = (2..).map(|copy| format!("{stem}_{copy}"));
        let mut candidates = std::iter::once(stem.clone()).chain(copies);
        candidates.find(|name| self.taken.insert(name.clone())).expect("there is always another number")
    }
}

/// A short name from those of the operands.
fn composed(graph: &Graph, node: usize, name: impl Fn(usize) -> Option<String>) -> Option<String> {
    let operands = &graph.nodes[node].operands;
    let operand = |position: usize| part(graph, *operands.get(position)?, &name);
    let between = |word: &str| Some(format!("{}_{word}_{}", operand(0)?, operand(1)?));
    match &graph.nodes[node].operation {
        Primitive::And => between("and"),
        Primitive::Or => between("or"),
        Primitive::Xor => between("xor"),
        Primitive::Add => between("plus"),
        Primitive::Subtract => between("minus"),
        Primitive::Multiply | Primitive::MultiplySigned => between("times"),
        Primitive::Equal => between("is"),
        Primitive::NotEqual => between("is_not"),
        Primitive::Less | Primitive::LessSigned => between("below"),
        Primitive::LessOrEqual => between("up_to"),
        Primitive::ShiftLeft | Primitive::ShiftRight => between("shifted_by"),
        Primitive::Not => Some(format!("not_{}", operand(0)?)),
        Primitive::Any => Some(format!("any_{}", operand(0)?)),
        Primitive::All => Some(format!("all_{}", operand(0)?)),
        // Floats: the sign flipped.
        Primitive::Cat => negated(graph, operands, &name),
        _ => None,
    }
}

/// What an operand is called in names: a signal, bits of one, or a small number.
fn part(graph: &Graph, node: usize, name: &impl Fn(usize) -> Option<String>) -> Option<String> {
    if let Some(name) = name(node) {
        return Some(name);
    }
    let description = &graph.nodes[node];
    match description.operation {
        Primitive::Literal(value) => (value <= LITERAL_MAX).then(|| value.to_string()),
        Primitive::Slice(low) => {
            let whole = name(description.operands[0])?;
            let high = low + description.width - 1;
            let range = if high == low { format!("_{low}") } else { format!("_{high}_{low}") };
            Some(whole + &range)
        }
        Primitive::Not => Some(format!("not_{}", part(graph, description.operands[0], name)?)),
        // A number extended with zeros is that number.
        Primitive::Cat if description.operands.len() == 2 => {
            let [high, low] = [description.operands[0], description.operands[1]];
            (graph.nodes[high].operation == Primitive::Literal(0)).then(|| part(graph, low, name))?
        }
        _ => None,
    }
}

/// `minus_x` of `{~x[23], x[22:0]}`.
fn negated(graph: &Graph, operands: &[usize], name: &impl Fn(usize) -> Option<String>) -> Option<String> {
    let &[sign, rest] = operands else { return None };
    let (sign, rest) = (&graph.nodes[sign], &graph.nodes[rest]);
    let inner = &graph.nodes[*sign.operands.first()?];
    let is_negation = sign.operation == Primitive::Not
        && inner.operation == Primitive::Slice(rest.width)
        && rest.operation == Primitive::Slice(0)
        && inner.operands == rest.operands;
    is_negation.then(|| name(rest.operands[0])).flatten().map(|name| format!("minus_{name}"))
}

/// What a node makes, as a noun.
const fn noun(operation: &Primitive) -> &'static str {
    match operation {
        Primitive::Add => "sum",
        Primitive::Subtract => "difference",
        Primitive::Multiply | Primitive::MultiplySigned => "product",
        Primitive::Mux => "choice",
        Primitive::Cat | Primitive::Repeat(_) => "bits",
        Primitive::ShiftLeft | Primitive::ShiftRight => "shifted",
        Primitive::And => "both",
        Primitive::Or => "either",
        Primitive::Equal => "same",
        Primitive::NotEqual | Primitive::Xor => "unequal",
        Primitive::Less | Primitive::LessSigned | Primitive::LessOrEqual => "in_order",
        Primitive::Not => "inverted",
        _ => "value",
    }
}

/// By node: what it is for, by the signal, port or pin that takes it or what is made of it.
fn purposes(graph: &Graph) -> Vec<String> {
    let mut purposes: Vec<Option<String>> = vec![None; graph.nodes.len()];
    let mut takes = |expr: Expr, purpose: &dyn Fn() -> String| {
        if let Some(node) = graph.find(expr) {
            purposes[node].get_or_insert_with(purpose);
        }
    };
    let module = graph.module;
    for (signal, _) in module.signals.iter().zip(&graph.signals).filter(|(_, need)| **need != Need::Nobody) {
        let name = || signal.name.to_string();
        match &signal.source {
            Source::Wire(Some(driver)) => takes(*driver, &name),
            Source::Register { next: Some(next), .. } => {
                takes(next.data, &name);
                next.enable.iter().for_each(|enable| takes(*enable, &|| format!("{}_enable", signal.name)));
            }
            Source::Read { address, .. } | Source::ReadNow { address, .. } | Source::Lookup { address, .. } => {
                takes(*address, &|| format!("{}_address", signal.name));
            }
            _ => {}
        }
    }
    ports(module, graph, &mut takes);
    // Operands come before what is made of them.
    for node in (0..graph.nodes.len()).rev() {
        for &operand in &graph.nodes[node].operands {
            if purposes[operand].is_none() {
                purposes[operand] = purposes[node].clone();
            }
        }
    }
    purposes.into_iter().map(|purpose| purpose.unwrap_or_else(|| "check".into())).collect()
}

/// What goes to memories, children and out.
fn ports(module: &Module, graph: &Graph, takes: &mut dyn FnMut(Expr, &dyn Fn() -> String)) {
    for store in &module.stores {
        if let Content::Written(Some(port)) = &store.content {
            takes(port.data, &|| format!("{}_data", store.name));
            takes(port.address, &|| format!("{}_address", store.name));
            takes(port.enable, &|| format!("{}_write", store.name));
        }
    }
    for child in &module.children {
        for (pin, input) in child.inputs.iter().enumerate() {
            input.iter().for_each(|input| takes(*input, &|| format!("{}_{}", child.name, child.pin(pin))));
        }
    }
    for port in &module.ports {
        if let PortDeclaration::Output { name, value, .. } = port {
            takes(graph.outputs[&value.number()], &|| name.clone());
        }
    }
}
