//! The Rust front end: values with operators and methods that write a [`Graph`].
//!
//! The first mistake is remembered and reported by [`compile`](super::compile); values derived from it are inert.

use super::error::CompileError;
use super::ir::{Graph, Operation, ValueId};
use super::table::Table;
use super::types::Type;
use pointcore_spec::{Fixed, Format};
use std::cell::RefCell;
use std::rc::Rc;

#[derive(Debug)]
struct State {
    graph: Graph,
    error: Option<CompileError>,
}

impl State {
    /// The result, unless it is the mistake to remember.
    fn note<T>(&mut self, result: Result<T, CompileError>) -> Option<T> {
        result.map_err(|error| self.error.get_or_insert(error)).ok()
    }
}

/// A program under construction; clones are handles to the same program.
#[derive(Clone, Debug)]
pub struct Program {
    state: Rc<RefCell<State>>,
}

impl Program {
    /// An empty program for the unit of that name; `doc` becomes the line above its Verilog.
    #[must_use]
    pub fn new(unit: &str, doc: &str) -> Self {
        Self { state: Rc::new(RefCell::new(State { graph: Graph::new(unit, doc), error: None })) }
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
    pub fn unsigned(&self, width: u32, value: u64) -> Value {
        self.constant(Type::Unsigned(width), value)
    }

    /// The number of `format` nearest to `value`; subnormal numbers become zero.
    #[must_use]
    pub fn float(&self, format: Format, value: f64) -> Value {
        self.constant(Type::Float(format), super::encode::encode(format, value))
    }

    /// Declares port `out_<name>`.
    pub fn output(&self, name: &str, value: &Value) {
        self.declare("output", value, |graph, id| graph.output(name, id));
    }

    /// Drops tokens for which `condition` is 0 at the end of the pipeline; of several conditions, all must hold.
    pub fn keep_if(&self, condition: &Value) {
        self.declare("keep_if", condition, Graph::keep_if);
    }

    fn record(&self, build: impl FnOnce(&mut Graph) -> Result<ValueId, CompileError>) -> Value {
        let mut state = self.state.borrow_mut();
        let result = build(&mut state.graph);
        let id = state.note(result);
        Value { program: self.clone(), id }
    }

    fn declare<T>(
        &self,
        operation: &'static str,
        value: &Value,
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

    /// The value's identity in this program; `None` when it derives from a mistake.
    fn own(&self, operation: &'static str, value: &Value) -> Result<Option<ValueId>, CompileError> {
        if Rc::ptr_eq(&self.state, &value.program.state) {
            return Ok(value.id);
        }
        let unit = self.state.borrow().graph.unit().to_owned();
        let other = value.program.state.borrow().graph.unit().to_owned();
        Err(CompileError::ForeignValue { unit, operation, other })
    }
}

/// A value of a [`Program`]. Clones are the same value.
#[derive(Clone, Debug)]
pub struct Value {
    program: Program,
    /// `None` when a mistake led here.
    id: Option<ValueId>,
}

impl Value {
    /// Applies any operation to this value and others.
    #[must_use]
    pub fn apply(&self, operation: Operation, others: &[&Self]) -> Self {
        let mnemonic = operation.mnemonic();
        let all = std::iter::once(self).chain(others.iter().copied());
        let operands: Result<Option<Vec<_>>, _> = all.map(|value| self.program.own(mnemonic, value)).collect();
        match operands {
            Ok(Some(operands)) => self.program.record(|graph| graph.apply(operation, &operands)),
            Ok(None) => Self { program: self.program.clone(), id: None },
            Err(error) => self.program.record(|_| Err(error)),
        }
    }

    /// Names the value for messages and for the Verilog; a port keeps its name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        if let Some(id) = self.id {
            self.program.state.borrow_mut().graph.name(id, name);
        }
        self
    }

    /// The value's type; `None` when a mistake led here.
    #[must_use]
    pub fn ty(&self) -> Option<Type> {
        self.id.map(|id| self.program.state.borrow().graph.node(id).ty)
    }

    /// `self · factor + addend`, rounded once.
    #[must_use]
    pub fn fma(&self, factor: &Self, addend: &Self) -> Self {
        self.apply(Operation::MultiplyAdd, &[factor, addend])
    }

    /// Converts to another floating-point format.
    #[must_use]
    pub fn convert(&self, format: Format) -> Self {
        self.apply(Operation::Convert(format), &[])
    }

    /// Float to fixed point, truncated and saturated.
    #[must_use]
    pub fn to_fixed(&self, fixed: Fixed) -> Self {
        self.apply(Operation::ToFixed(fixed), &[])
    }

    /// An integer times `2^−fraction` as a float.
    #[must_use]
    pub fn to_float(&self, format: Format, fraction: u32) -> Self {
        self.apply(Operation::ToFloat { format, fraction }, &[])
    }

    /// Looks the value up in `table`, with linear interpolation.
    #[must_use]
    pub fn kernel(&self, table: &Rc<Table>) -> Self {
        self.apply(Operation::Interpolate(Rc::clone(table)), &[])
    }

    /// `when_true` where this truth value is 1, else `when_false`.
    #[must_use]
    pub fn select(&self, when_true: &Self, when_false: &Self) -> Self {
        self.apply(Operation::Select, &[when_true, when_false])
    }

    /// Bits `high` down to `low`, unsigned.
    #[must_use]
    pub fn bits(&self, high: u32, low: u32) -> Self {
        self.apply(Operation::Bits { high, low }, &[])
    }

    /// This value above `lower`.
    #[must_use]
    pub fn concat(&self, lower: &Self) -> Self {
        self.apply(Operation::Concatenate, &[lower])
    }

    /// Shifted left by a constant.
    #[must_use]
    pub fn shl(&self, by: u32) -> Self {
        self.apply(Operation::ShiftLeft(by), &[])
    }

    /// Shifted right by a constant, keeping a signed value's sign.
    #[must_use]
    pub fn shr(&self, by: u32) -> Self {
        self.apply(Operation::ShiftRight(by), &[])
    }

    /// Truncated or extended to `width` bits, as the value's signedness says.
    #[must_use]
    pub fn resize(&self, width: u32) -> Self {
        self.apply(Operation::Resize(width), &[])
    }

    /// The value's bits as an unsigned integer, extended with zeros or truncated to `width` bits.
    #[must_use]
    pub fn zext(&self, width: u32) -> Self {
        let bits = self.ty().map_or(1, Type::width);
        self.reinterpret(Type::Unsigned(bits)).resize(width)
    }

    /// The same bits under another type.
    #[must_use]
    pub fn reinterpret(&self, ty: Type) -> Self {
        self.apply(Operation::Reinterpret(ty), &[])
    }
}

/// Methods of one operation, without parameters or with one more operand.
macro_rules! methods {
    ($($(#[$doc:meta])* $name:ident($($other:ident)?) = $operation:ident;)*) => {
        impl Value {$(
            $(#[$doc])*
            #[must_use]
            pub fn $name(&self $(, $other: &Self)?) -> Self {
                self.apply(Operation::$operation, &[$($other)?])
            }
        )*}
    };
}

methods! {
    /// Absolute value of a float.
    abs() = Absolute;
    /// `√self`.
    sqrt() = SquareRoot;
    /// `1 / self`.
    recip() = Reciprocal;
    /// `1 / √self`.
    rsqrt() = ReciprocalSquareRoot;
    /// `1 / self` from a table and Newton steps.
    recip_newton() = ReciprocalNewton;
    /// `1 / √self` from a table and Newton steps.
    rsqrt_newton() = ReciprocalSquareRootNewton;
    /// The smaller of both.
    min(other) = Minimum;
    /// The larger of both.
    max(other) = Maximum;
    /// `self < other`.
    lt(other) = Less;
    /// `self ≤ other`.
    le(other) = LessEqual;
    /// `self = other`; of floats as IEEE 754 has it.
    equal(other) = Equal;
}

/// Rust's operators, on values and references to them.
macro_rules! binary_operators {
    ($($operator:ident::$method:ident = $operation:ident;)*) => {$(
        impl<T: std::borrow::Borrow<Value>> std::ops::$operator<T> for &Value {
            type Output = Value;
            fn $method(self, other: T) -> Value {
                self.apply(Operation::$operation, &[other.borrow()])
            }
        }
        impl<T: std::borrow::Borrow<Value>> std::ops::$operator<T> for Value {
            type Output = Value;
            fn $method(self, other: T) -> Value {
                self.apply(Operation::$operation, &[other.borrow()])
            }
        }
    )*};
}

binary_operators! {
    Add::add = Add;
    Sub::sub = Subtract;
    Mul::mul = Multiply;
    Div::div = Divide;
    BitAnd::bitand = And;
    BitOr::bitor = Or;
    BitXor::bitxor = Xor;
}

macro_rules! unary_operators {
    ($($operator:ident::$method:ident = $operation:ident;)*) => {$(
        impl std::ops::$operator for &Value {
            type Output = Value;
            fn $method(self) -> Value {
                self.apply(Operation::$operation, &[])
            }
        }
        impl std::ops::$operator for Value {
            type Output = Value;
            fn $method(self) -> Value {
                self.apply(Operation::$operation, &[])
            }
        }
    )*};
}

unary_operators! {
    Neg::neg = Negate;
    Not::not = Not;
}
