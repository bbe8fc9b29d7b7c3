//! A module under construction: ports, wires, registers and assertions.

use std::collections::{BTreeMap, HashSet};
use std::fmt::Display;
use std::panic::Location;
use std::rc::Rc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::arena::Lease;
use super::error::{FaultKind, Place};
use super::expression::{Expr, Node, Primitive, SignalRef, lit};
use super::foreign::ForeignBlock;
use super::handle::{Reg, Wire};
use super::instance::Child;
use super::interface::StreamDeclaration;
use super::memory::Store;
use super::names;
use super::packed::Packed;

/// Distinguishes the signals of one module from those of another; never part of the output.
static NEXT_IDENTITY: AtomicU64 = AtomicU64::new(0);

/// The signal every module starts with.
pub(super) const RESET: usize = 0;

/// A hardware module whose ports, widths and contents are chosen at run time.
pub struct Module {
    pub(super) identity: u64,
    pub(super) unit: String,
    pub(super) summary: String,
    pub(super) parameters: Vec<(String, String)>,
    /// Those of the parameters that are part of its name.
    pub(super) variants: Vec<String>,
    pub(super) ports: Vec<PortDeclaration>,
    /// What is said of ports, by their names.
    pub(super) documents: BTreeMap<String, String>,
    pub(super) streams: Vec<StreamDeclaration>,
    /// Fields that share ports.
    pub(super) packed: Vec<Packed>,
    pub(super) signals: Vec<Signal>,
    pub(super) stores: Vec<Store>,
    pub(super) children: Vec<Child>,
    pub(super) assertions: Vec<Assertion>,
    pub(super) faults: Vec<(FaultKind, Place)>,
    pub(super) names: HashSet<String>,
    /// The rust-hdl block that this module is, where it has no description of ours.
    pub(super) foreign: Option<Rc<ForeignBlock>>,
    _lease: Lease,
}

/// A port in declaration order.
pub(super) enum PortDeclaration {
    Input(usize),
    Output { name: String, value: Expr, place: Place },
}

/// What is stated of a module.
pub(super) struct Assertion {
    pub name: String,
    pub condition: Expr,
    pub place: Place,
}

/// A named value of a module.
pub(super) struct Signal {
    pub place: Place,
    pub name: Rc<str>,
    pub reference: Expr,
    pub source: Source,
}

/// Where a signal's value comes from.
pub(super) enum Source {
    Reset,
    Input,
    Wire(Option<Expr>),
    Register {
        reset: Option<u128>,
        next: Option<Next>,
    },
    /// The registered output of a memory's read port.
    Read {
        store: usize,
        enable: Option<Expr>,
        address: Expr,
    },
    /// The unregistered output of a distributed memory's read port.
    ReadNow {
        store: usize,
        address: Expr,
    },
    Lookup {
        values: Vec<u128>,
        address: Expr,
    },
    ChildOutput {
        child: usize,
        port: usize,
    },
    /// An output of a rust-hdl block.
    BlockOutput {
        /// The inputs that may reach it within the cycle.
        follows: Vec<usize>,
    },
}

/// What a register takes at the clock edge.
pub(super) struct Next {
    pub enable: Option<Expr>,
    pub data: Expr,
}

impl Module {
    /// An empty module of that unit; `summary` is one line for the header of the Verilog.
    #[must_use]
    #[track_caller]
    pub fn new(unit: &str, summary: &str) -> Self {
        let mut module = Self {
            identity: NEXT_IDENTITY.fetch_add(1, Ordering::Relaxed),
            unit: unit.into(),
            summary: summary.into(),
            parameters: vec![],
            variants: vec![],
            ports: vec![],
            documents: BTreeMap::new(),
            streams: vec![],
            packed: vec![],
            signals: vec![],
            stores: vec![],
            children: vec![],
            assertions: vec![],
            faults: vec![],
            names: HashSet::from(["clk".into(), "rst".into()]),
            foreign: None,
            _lease: Lease::new(),
        };
        module.check_name(unit);
        module.add_signal("rst", 1, Source::Reset);
        module
    }

    /// The unit's name.
    #[must_use]
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Records a parameter that is part of the module's name, where it is not the top: `stream_skid_w25`. For units of which a design
    /// has several.
    #[track_caller]
    pub fn variant(&mut self, name: &str, value: impl Display) {
        self.parameter(name, value);
        self.variants.push(name.into());
    }

    /// Records a parameter, which stands in the header.
    #[track_caller]
    pub fn parameter(&mut self, name: &str, value: impl Display) {
        if self.parameters.iter().any(|(other, _)| other == name) {
            self.fault(FaultKind::NameClash(name.into()));
        }
        self.parameters.push((name.into(), value.to_string()));
    }

    /// The synchronous reset, active high.
    #[must_use]
    pub fn rst(&self) -> Expr {
        self.signals[RESET].reference
    }

    /// Declares an input port.
    #[track_caller]
    pub fn input(&mut self, name: &str, width: u32) -> Expr {
        let value = self.declare(name, width, Source::Input);
        self.ports.push(PortDeclaration::Input(self.signals.len() - 1));
        value
    }

    /// Declares an output port and drives it. A port may share the name of the very signal it shows.
    #[track_caller]
    pub fn output(&mut self, name: &str, value: impl Into<Expr>) {
        let value = value.into();
        let clash =
            self.ports.iter().any(|port| matches!(port, PortDeclaration::Output { name: other, .. } if other == name));
        let shows_itself = !clash
            && matches!(&value.node().operation, Primitive::Signal(signal)
                if signal.module == self.identity && &*signal.name == name
                    && !matches!(self.signals[signal.index].source, Source::Input | Source::Reset));
        if !shows_itself {
            self.claim(name);
        }
        self.ports.push(PortDeclaration::Output { name: name.into(), value, place: Location::caller() });
    }

    /// Gives an intermediate value a name in the Verilog.
    #[track_caller]
    pub fn wire(&mut self, name: &str, value: impl Into<Expr>) -> Expr {
        let value = value.into();
        self.declare(name, value.width(), Source::Wire(Some(value)))
    }

    /// Declares a wire that [`Module::drive`] drives later, once.
    #[track_caller]
    pub fn forward(&mut self, name: &str, width: u32) -> Wire {
        Wire::of(self.declare(name, width, Source::Wire(None)))
    }

    /// Drives a forward wire.
    #[track_caller]
    pub fn drive(&mut self, wire: Wire, value: impl Into<Expr>) {
        let value = value.into();
        let Some((index, name)) = self.own(wire.expr()) else { return };
        self.check_width(&name, wire.width(), value);
        match &mut self.signals[index].source {
            Source::Wire(driver @ None) => *driver = Some(value),
            _ => self.fault(FaultKind::DoublyDriven(name)),
        }
    }

    /// Declares a register without reset.
    #[track_caller]
    pub fn reg(&mut self, name: &str, width: u32) -> Reg {
        Reg::of(self.declare(name, width, Source::Register { reset: None, next: None }))
    }

    /// Declares a register that `rst` sets to `reset`.
    #[track_caller]
    pub fn reg_reset(&mut self, name: &str, width: u32, reset: u128) -> Reg {
        self.check_expression(name, lit(width, reset));
        Reg::of(self.declare(name, width, Source::Register { reset: Some(reset), next: None }))
    }

    /// The register takes `data` at every clock edge.
    #[track_caller]
    pub fn next(&mut self, register: Reg, data: impl Into<Expr>) {
        self.set_next(register, None, data.into());
    }

    /// The register takes `data` at clock edges where `enable` is set.
    #[track_caller]
    pub fn next_if(&mut self, register: Reg, enable: impl Into<Expr>, data: impl Into<Expr>) {
        self.set_next(register, Some(enable.into().as_condition("enable")), data.into());
    }

    #[track_caller]
    fn set_next(&mut self, register: Reg, enable: Option<Expr>, data: Expr) {
        let Some((index, name)) = self.own(register.expr()) else { return };
        self.check_width(&name, register.width(), data);
        match &mut self.signals[index].source {
            Source::Register { next: next @ None, .. } => *next = Some(Next { enable, data }),
            _ => self.fault(FaultKind::DoublyDriven(name)),
        }
    }

    /// States what holds at every clock edge outside reset; checked where `RTL_ASSERT` is defined, to be proved where
    /// `FORMAL` is as well.
    #[track_caller]
    pub fn assert(&mut self, name: &str, condition: impl Into<Expr>) {
        self.claim(name);
        let condition = condition.into().as_condition("assertion");
        self.assertions.push(Assertion { name: name.into(), condition, place: Location::caller() });
    }

    /// Records a fault, made by the line that called.
    #[track_caller]
    pub(super) fn fault(&mut self, kind: FaultKind) {
        self.faults.push((kind, Location::caller()));
    }

    #[track_caller]
    fn check_name(&mut self, name: &str) {
        if let Some(kind) = names::fault(name) {
            self.fault(kind);
        }
    }

    /// Takes a name; a bad or used one is a fault.
    #[track_caller]
    pub(super) fn claim(&mut self, name: &str) {
        self.check_name(name);
        if !self.names.insert(name.into()) {
            self.fault(FaultKind::NameClash(name.into()));
        }
    }

    #[track_caller]
    pub(super) fn declare(&mut self, name: &str, width: u32, source: Source) -> Expr {
        self.claim(name);
        if width == 0 {
            let message = "a signal needs at least one bit".into();
            self.fault(FaultKind::Expression { user: format!("`{name}`"), message });
        }
        self.add_signal(name, width.max(1), source)
    }

    #[track_caller]
    fn add_signal(&mut self, name: &str, width: u32, source: Source) -> Expr {
        let name: Rc<str> = name.into();
        let reference = SignalRef { module: self.identity, index: self.signals.len(), name: name.clone() };
        let reference = Node::new(Primitive::Signal(reference), width, []).keep();
        self.signals.push(Signal { place: Location::caller(), name, reference, source });
        reference
    }

    /// The table index and name behind a handle, unless it is another module's.
    #[track_caller]
    fn own(&mut self, handle: Expr) -> Option<(usize, String)> {
        let Primitive::Signal(signal) = &handle.node().operation else { return None };
        if signal.module != self.identity {
            self.fault(FaultKind::ForeignHandle(signal.name.to_string()));
            return None;
        }
        Some((signal.index, signal.name.to_string()))
    }

    #[track_caller]
    pub(super) fn check_width(&mut self, signal: &str, width: u32, driver: Expr) {
        let driver_width = driver.width();
        if width != driver_width && !driver.node().tainted {
            let (signal, driver) = (signal.into(), driver.to_string());
            self.fault(FaultKind::Width { signal, width, driver, driver_width });
        }
    }

    /// Records the fault of an expression that no signal keeps.
    #[track_caller]
    fn check_expression(&mut self, user: &str, expression: Expr) {
        if let Primitive::Poison(mistake) = &expression.node().operation {
            self.fault(FaultKind::Expression { user: format!("`{user}`"), message: mistake.message.to_string() });
        }
    }
}
