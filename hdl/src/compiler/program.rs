//! The Rust front end: values with operators and methods that write a [`Graph`].
//!
//! The first mistake is remembered and reported by [`compile`](super::compile); values derived from it are inert.

use super::error::CompileError;
use super::graph::{Graph, ValueId};
use super::types::Type;
use super::value::Value;
use pointcore_contract::Format;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::rc::{Rc, Weak};

#[derive(Debug)]
struct State {
    id: ProgramId,
    graph: Graph,
    error: Option<CompileError>,
}

impl State {
    /// The result, unless it is the mistake to remember.
    fn note<T>(&mut self, result: Result<T, CompileError>) -> Option<T> {
        result.map_err(|error| self.error.get_or_insert(error)).ok()
    }
}

/// Tells one program of a thread from another; what a value keeps of its program, so that values can be copied. The default is none's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct ProgramId(u64);

thread_local! {
    /// The programs of this thread that are still there.
    static PROGRAMS: RefCell<HashMap<ProgramId, Weak<RefCell<State>>>> = RefCell::default();
    static NEXT_ID: Cell<u64> = const { Cell::new(1) };
}

impl ProgramId {
    /// The program, while something holds it.
    pub fn find(self) -> Option<Program> {
        let state = PROGRAMS.with_borrow(|programs| programs.get(&self).and_then(Weak::upgrade))?;
        Some(Program { id: self, state })
    }
}

impl Drop for State {
    fn drop(&mut self) {
        // At the end of the thread the list may be gone before the program.
        let _ = PROGRAMS.try_with(|programs| programs.borrow_mut().remove(&self.id));
    }
}

/// A program under construction; clones are handles to the same program. Its values are of use as long as it is there.
#[derive(Clone, Debug)]
pub struct Program {
    id: ProgramId,
    state: Rc<RefCell<State>>,
}

impl Program {
    /// An empty program for the unit of that name; `doc` becomes the line above its Verilog.
    #[must_use]
    pub fn new(unit: &str, doc: &str) -> Self {
        let id = ProgramId(NEXT_ID.replace(NEXT_ID.get() + 1));
        let state = Rc::new(RefCell::new(State { id, graph: Graph::new(unit, doc), error: None }));
        PROGRAMS.with_borrow_mut(|programs| programs.insert(id, Rc::downgrade(&state)));
        Self { id, state }
    }

    /// The program so far.
    ///
    /// # Errors
    /// The first mistake made while building it.
    pub fn graph(&self) -> Result<Graph, CompileError> {
        let state = self.state.borrow();
        state.error.clone().map_or_else(|| Ok(state.graph.clone()), Err)
    }

    /// A field of the token: port `in_<name>`.
    #[must_use]
    pub fn input(&self, name: &str, ty: Type) -> Value {
        self.record(|graph| graph.input(name, ty))
    }

    /// A port that is constant while a token is under way, and so needs no registers.
    #[must_use]
    pub fn uniform(&self, name: &str, ty: Type) -> Value {
        self.record(|graph| graph.uniform(name, ty))
    }

    /// An encoded constant of any type.
    #[must_use]
    pub fn constant(&self, ty: Type, value: u64) -> Value {
        self.record(|graph| graph.constant(ty, value))
    }

    /// An unsigned constant.
    #[must_use]
    pub fn lit(&self, width: u32, value: u64) -> Value {
        self.constant(Type::Unsigned(width), value)
    }

    /// The number of `format` nearest to `value`; subnormal numbers become zero.
    #[must_use]
    pub fn float(&self, format: Format, value: f64) -> Value {
        self.constant(Type::Float(format), super::encode::encode(format, value))
    }

    /// Declares port `out_<name>`.
    pub fn output(&self, name: &str, value: Value) {
        self.declare("output", value, |graph, id| graph.output(name, id));
    }

    /// Drops tokens for which `condition` is 0 at the end of the pipeline; of several conditions, all must hold.
    pub fn keep_if(&self, condition: Value) {
        self.declare("keep_if", condition, Graph::keep_if);
    }

    pub(super) fn record(&self, build: impl FnOnce(&mut Graph) -> Result<ValueId, CompileError>) -> Value {
        let mut state = self.state.borrow_mut();
        let result = build(&mut state.graph);
        let id = state.note(result);
        Value { program: self.id, id }
    }

    fn declare<T>(
        &self,
        operation: &'static str,
        value: Value,
        declare: impl FnOnce(&mut Graph, ValueId) -> Result<T, CompileError>,
    ) {
        let own = self.own(operation, value);
        let mut state = self.state.borrow_mut();
        let result = own.map(|own| own.map(|id| declare(&mut state.graph, id)));
        match result {
            Ok(Some(result)) => _ = state.note(result),
            Ok(None) => {}
            Err(error) => _ = state.note::<T>(Err(error)),
        }
    }

    pub(super) fn name(&self, id: ValueId, name: &str) {
        self.state.borrow_mut().graph.name(id, name);
    }

    pub(super) fn type_of(&self, id: ValueId) -> Type {
        self.state.borrow().graph.node(id).ty
    }

    /// The value's identity in this program; `None` when it derives from a mistake.
    pub(super) fn own(&self, operation: &'static str, value: Value) -> Result<Option<ValueId>, CompileError> {
        if self.id == value.program {
            return Ok(value.id);
        }
        let unit = self.state.borrow().graph.unit().to_owned();
        let other = value.program.find();
        let other =
            other.map_or_else(|| "a program that is gone".into(), |other| other.state.borrow().graph.unit().to_owned());
        Err(CompileError::ForeignValue { unit, operation, other })
    }
}
