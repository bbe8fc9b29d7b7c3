//! The program as a graph of typed values. Front ends build it; everything behind them sees only this.

use super::error::CompileError;
use super::operation::Operation;
use super::types::{Type, WIDTH_MAX};
use super::typing::result_type;

/// A value of a [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ValueId(pub(super) usize);

impl ValueId {
    /// Position in [`Graph::nodes`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}

/// One value and how it comes about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// What computes it.
    pub operation: Operation,
    /// What it is computed from; all earlier in the graph.
    pub operands: Vec<ValueId>,
    /// Type of the value.
    pub ty: Type,
    /// Name given by the author; ports always have one.
    pub name: Option<String>,
}

/// A straight-line program.
#[derive(Clone, Debug)]
pub struct Graph {
    unit: String,
    doc: String,
    nodes: Vec<Node>,
    outputs: Vec<(String, ValueId)>,
    keep: Option<ValueId>,
}

impl Graph {
    /// An empty program for the unit of that name; `doc` becomes the line above its Verilog.
    #[must_use]
    pub fn new(unit: &str, doc: &str) -> Self {
        Self { unit: unit.to_owned(), doc: doc.to_owned(), nodes: Vec::new(), outputs: Vec::new(), keep: None }
    }

    /// Name of the unit.
    #[must_use]
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// One line about the unit.
    #[must_use]
    pub fn doc(&self) -> &str {
        &self.doc
    }

    /// All values; operands come before their users.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// All values, in the order of [`Self::nodes`].
    pub fn ids(&self) -> impl Iterator<Item = ValueId> + use<> {
        (0..self.nodes.len()).map(ValueId)
    }

    /// What leaves the datapath, in the order of declaration.
    #[must_use]
    pub fn outputs(&self) -> &[(String, ValueId)] {
        &self.outputs
    }

    /// The condition under which a token leaves the datapath at all.
    #[must_use]
    pub const fn keep(&self) -> Option<ValueId> {
        self.keep
    }

    pub(super) fn node(&self, id: ValueId) -> &Node {
        &self.nodes[id.0]
    }

    /// Declares a field of the token.
    ///
    /// # Errors
    /// When the name is taken or no identifier, or the type too wide.
    pub fn input(&mut self, name: &str, ty: Type) -> Result<ValueId, CompileError> {
        self.port(Operation::Input, name, ty)
    }

    /// Declares a port that is constant while a token is under way.
    ///
    /// # Errors
    /// When the name is taken or no identifier, or the type too wide.
    pub fn uniform(&mut self, name: &str, ty: Type) -> Result<ValueId, CompileError> {
        self.port(Operation::Uniform, name, ty)
    }

    /// An encoded constant.
    ///
    /// # Errors
    /// When it does not fit its type.
    pub fn constant(&mut self, ty: Type, value: u64) -> Result<ValueId, CompileError> {
        self.check_width("constant", ty)?;
        if value & !ty.mask() != 0 {
            return Err(CompileError::Constant { unit: self.unit.clone(), value, ty: ty.to_string() });
        }
        Ok(self.push(Operation::Constant(value), Vec::new(), ty, None))
    }

    /// The result of an operation on earlier values.
    ///
    /// # Errors
    /// When the operands' types do not suit the operation, or its result is too wide.
    pub fn apply(&mut self, operation: Operation, operands: &[ValueId]) -> Result<ValueId, CompileError> {
        let types: Vec<Type> = operands.iter().map(|&id| self.node(id).ty).collect();
        let ty = result_type(&operation, &types).map_err(|expected| CompileError::Operands {
            unit: self.unit.clone(),
            operation: operation.mnemonic(),
            operands: self.describe(operands),
            expected,
        })?;
        self.check_width(operation.mnemonic(), ty)?;
        Ok(self.push(operation, operands.to_vec(), ty, None))
    }

    /// Declares an output of the token.
    ///
    /// # Errors
    /// When the name is taken or no identifier.
    pub fn output(&mut self, name: &str, value: ValueId) -> Result<(), CompileError> {
        let taken = self.outputs.iter().any(|(other, _)| other == name);
        self.check_name(name, taken)?;
        self.outputs.push((name.to_owned(), value));
        Ok(())
    }

    /// Drops tokens for which `condition` is 0; with an earlier condition, those for which either is.
    ///
    /// # Errors
    /// When the condition is not one bit.
    pub fn keep_if(&mut self, condition: ValueId) -> Result<(), CompileError> {
        if self.node(condition).ty != Type::BOOL {
            return Err(CompileError::Operands {
                unit: self.unit.clone(),
                operation: "keep_if",
                operands: self.describe(&[condition]),
                expected: "the condition must be u1",
            });
        }
        self.keep = Some(match self.keep {
            Some(earlier) => self.apply(Operation::And, &[earlier, condition])?,
            None => condition,
        });
        Ok(())
    }

    /// Names a value, for messages and for the Verilog.
    pub fn name(&mut self, value: ValueId, name: &str) {
        let node = &mut self.nodes[value.0];
        if !matches!(node.operation, Operation::Input | Operation::Uniform) {
            node.name = Some(name.to_owned());
        }
    }

    /// What to call a value: its name, or its operation and position.
    pub(super) fn label(&self, id: ValueId) -> String {
        let node = self.node(id);
        node.name.clone().unwrap_or_else(|| format!("{}_{}", node.operation.mnemonic(), id.0))
    }

    /// Adds a node that is known to be well typed.
    pub(super) fn push(
        &mut self,
        operation: Operation,
        operands: Vec<ValueId>,
        ty: Type,
        name: Option<String>,
    ) -> ValueId {
        self.nodes.push(Node { operation, operands, ty, name });
        ValueId(self.nodes.len() - 1)
    }

    /// The same program over other nodes; `renamed` says where each old value went.
    pub(super) fn with_nodes(&self, nodes: Vec<Node>, renamed: impl Fn(ValueId) -> ValueId) -> Self {
        Self {
            unit: self.unit.clone(),
            doc: self.doc.clone(),
            nodes,
            outputs: self.outputs.iter().map(|(name, id)| (name.clone(), renamed(*id))).collect(),
            keep: self.keep.map(renamed),
        }
    }

    fn port(&mut self, operation: Operation, name: &str, ty: Type) -> Result<ValueId, CompileError> {
        let is_port = |node: &Node| matches!(node.operation, Operation::Input | Operation::Uniform);
        let taken = self.nodes.iter().any(|node| is_port(node) && node.name.as_deref() == Some(name));
        self.check_name(name, taken)?;
        self.check_width(name, ty)?;
        Ok(self.push(operation, Vec::new(), ty, Some(name.to_owned())))
    }

    fn check_name(&self, name: &str, taken: bool) -> Result<(), CompileError> {
        let starts_well = name.starts_with(|first: char| first.is_ascii_lowercase());
        let identifier = starts_well && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        let reason = match (identifier, taken) {
            (false, _) => "it must be lower-case letters, digits and underscores, a letter first",
            (true, true) => "it is taken",
            (true, false) => return Ok(()),
        };
        Err(CompileError::PortName { unit: self.unit.clone(), name: name.to_owned(), reason })
    }

    fn check_width(&self, value: &str, ty: Type) -> Result<(), CompileError> {
        if (1..=WIDTH_MAX).contains(&ty.width()) {
            return Ok(());
        }
        Err(CompileError::Width { unit: self.unit.clone(), value: value.to_owned(), width: ty.width() })
    }

    fn describe(&self, operands: &[ValueId]) -> String {
        let one = |&id: &ValueId| format!("{}: {}", self.label(id), self.node(id).ty);
        operands.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}
