//! A block while its statements are read: nodes, and what their names stand for.

use super::block::{Block, Node, NodeId};
use super::error::Fault;
use super::layout::{Layout, Place, Scalar, Type};
use super::operation::{Literal, Operation, Source};
use super::program::{Program, Section};
use std::collections::HashMap;

/// A value of a statement: as many nodes as its type has words.
#[derive(Clone, Debug)]
pub(super) struct Value {
    pub ty: Type,
    pub words: Vec<NodeId>,
}

/// Words that are no names.
const RESERVED: [&str; 8] = ["query", "neighbor", "farthest", "count", "neighbors", "if", "true", "false"];

/// A block under construction.
pub(super) struct Builder<'a> {
    /// What is declared so far; what the block itself declares is added to it.
    pub program: &'a mut Program,
    pub section: Section,
    pub block: Block,
    shared: HashMap<Operation, NodeId>,
    names: HashMap<String, Value>,
    /// Names of each open repetition that end with its turn.
    passing: Vec<Vec<String>>,
    /// Variables of open repetitions.
    pub variables: Vec<(String, i64)>,
}

impl<'a> Builder<'a> {
    pub fn new(program: &'a mut Program, section: Section) -> Self {
        Self {
            program,
            section,
            block: Block::default(),
            shared: HashMap::new(),
            names: HashMap::new(),
            passing: vec![],
            variables: vec![],
        }
    }

    pub fn node(&mut self, operation: Operation, operands: Vec<NodeId>, ty: Scalar) -> NodeId {
        self.block.nodes.push(Node { operation, operands, ty, name: None });
        NodeId(self.block.nodes.len() - 1)
    }

    /// An operation on two floats that makes a float.
    pub fn float(&mut self, operation: Operation, a: NodeId, b: NodeId) -> NodeId {
        self.node(operation, vec![a, b], Scalar::Float)
    }

    /// A node without operands, once a block.
    fn leaf(&mut self, operation: Operation, ty: Scalar) -> NodeId {
        if let Some(&known) = self.shared.get(&operation) {
            return known;
        }
        let id = self.node(operation, vec![], ty);
        self.shared.insert(operation, id);
        id
    }

    pub fn literal(&mut self, literal: Literal) -> Value {
        let (ty, scalar) = match literal {
            Literal::Float(_) => (Type::Float, Scalar::Float),
            Literal::Int(_) => (Type::Int, Scalar::Int),
            Literal::Bool(_) => (Type::Bool, Scalar::Bool),
        };
        Value { ty, words: vec![self.leaf(Operation::Literal(literal), scalar)] }
    }

    pub fn source(&mut self, place: Place, source: fn(usize) -> Source) -> Value {
        let words = place.first..place.first + place.ty.words();
        let words = words.map(|word| self.leaf(Operation::Input(source(word)), place.ty.scalar())).collect();
        Value { ty: place.ty, words }
    }

    /// Whether a name may be given to a value, a field or a variable.
    pub fn check_free(&self, name: &str) -> Result<(), Fault> {
        check_reserved(name)?;
        let declared = [&self.program.settings, &self.program.state, &self.program.sums];
        let is_declared = declared.iter().any(|layout| layout.find(name).is_some());
        let is_variable = self.variables.iter().any(|(variable, _)| variable == name);
        if is_declared || is_variable || self.names.contains_key(name) {
            return Err(Fault::Taken(name.to_owned()));
        }
        Ok(())
    }

    /// Gives a name; one without an index ends with the turn of the repetition that it is given in.
    pub fn give(&mut self, name: String, value: Value) {
        let identifier = name.replace('[', "_").replace(']', "");
        for (index, word) in value.words.iter().enumerate() {
            let own = &mut self.block.nodes[word.index()].name;
            let axis = if value.words.len() > 1 { ["_x", "_y", "_z"][index] } else { "" };
            own.get_or_insert_with(|| format!("{identifier}{axis}"));
        }
        if let Some(passing) = self.passing.last_mut().filter(|_| !name.contains('[')) {
            passing.push(name.clone());
        }
        self.names.insert(name, value);
    }

    pub fn begin_turn(&mut self, variable: &str, number: i64) {
        self.variables.push((variable.to_owned(), number));
        self.passing.push(vec![]);
    }

    pub fn end_turn(&mut self) {
        self.variables.pop();
        for name in self.passing.pop().unwrap_or_default() {
            self.names.remove(&name);
        }
    }

    /// The value of a name that stands alone.
    pub fn look_up(&mut self, name: &str) -> Result<Value, Fault> {
        if let Some(value) = self.names.get(name) {
            return Ok(value.clone());
        }
        if let Some((_, number)) = self.variables.iter().find(|(variable, _)| variable == name) {
            let number =
                i32::try_from(*number).map_err(|_| Fault::expected("a number of 32 bits", number.to_string()))?;
            return Ok(self.literal(Literal::Int(number)));
        }
        if let Some(place) = self.program.settings.find(name) {
            return Ok(self.source(place, Source::Setting));
        }
        if let Some(place) = self.program.state.find(name) {
            return Ok(self.source(place, Source::State));
        }
        let not_here = |seen| Fault::NotHere { section: self.section.name(), name: name.to_owned(), seen };
        let whole = Place { first: 0, ty: Type::Int };
        match (name, self.section) {
            ("count", Section::Init | Section::Final) => Ok(self.source(whole, |_| Source::Count)),
            ("count", _) => Err(not_here("`.init` and `.final`")),
            ("neighbors", Section::Final) => Ok(self.source(whole, |_| Source::Neighbors)),
            ("neighbors", _) => Err(not_here("`.final`")),
            _ => match (self.program.sums.find(name), self.section) {
                (Some(place), Section::Final) => Ok(self.source(place, Source::Sum)),
                (Some(_), _) => Err(not_here("`.final`")),
                (None, _) => Err(self.unknown(name)),
            },
        }
    }

    /// A field of the query or of a neighbor: `query.position`.
    pub fn field(&mut self, record: &str, field: &str) -> Result<Value, Fault> {
        let not_here = |seen| Err(Fault::NotHere { section: self.section.name(), name: record.to_owned(), seen });
        let (layout, source): (&Layout, fn(usize) -> Source) = match (record, self.section) {
            ("query", _) => (&self.program.query, Source::Query),
            ("neighbor", Section::Kernel) => (&self.program.neighbor, Source::Neighbor),
            ("neighbor", _) => return not_here("`.kernel`"),
            (_, Section::Init) => (&self.program.neighbor, Source::Farthest),
            _ => return not_here("`.init`"),
        };
        let Some(place) = layout.find(field) else {
            let known = layout.fields().iter().map(|field| format!("{record}.{}", field.name));
            return Err(Fault::unknown(&format!("{record}.{field}"), known));
        };
        Ok(self.source(place, source))
    }

    fn unknown(&self, name: &str) -> Fault {
        let declared = [&self.program.settings, &self.program.state];
        let mut known: Vec<String> = self.names.keys().cloned().collect();
        known.extend(declared.iter().flat_map(|layout| layout.fields()).map(|field| field.name.clone()));
        known.extend(self.variables.iter().map(|(variable, _)| variable.clone()));
        let (own, record): (&[&str], _) = match self.section {
            Section::Init => (&["count"], "farthest.position"),
            Section::Kernel => (&[], "neighbor.position"),
            Section::Final => (&["count", "neighbors"], "query.position"),
        };
        if self.section == Section::Final {
            known.extend(self.program.sums.fields().iter().map(|field| field.name.clone()));
        }
        known.extend(own.iter().chain(&["query.position"]).map(|&name| name.to_owned()));
        known.push(record.to_owned());
        Fault::unknown(name, known)
    }
}

/// Words of the language are no names.
pub(super) fn check_reserved(name: &str) -> Result<(), Fault> {
    if RESERVED.contains(&name) { Err(Fault::Reserved(name.to_owned())) } else { Ok(()) }
}
