//! Modules inside modules.

use std::collections::{BTreeMap, HashMap};
use std::panic::Location;
use std::rc::Rc;

use super::arena::Name;
use super::error::{FaultKind, Place};
use super::expression::Expr;
use super::module::{Module, PortDeclaration, Source};

/// A child of a module.
#[derive(Clone, Copy)]
pub struct Instance {
    module: u64,
    index: usize,
    name: Name,
}

impl Instance {
    /// Its name in the module.
    #[must_use]
    pub fn name(self) -> String {
        self.name.text()
    }
}

/// What a module holds for a child.
pub(super) struct Child {
    pub name: String,
    pub place: Place,
    pub module: Rc<Module>,
    /// What resets it, where that is not its parent's reset.
    pub reset: Option<Expr>,
    /// By port of the child: what drives it, for inputs.
    pub inputs: Vec<Option<Expr>>,
    /// By port of the child: the signal that shows it here, for outputs.
    pub outputs: Vec<Option<usize>>,
    /// By port of the child that fields share: what drives each of them.
    pub parts: BTreeMap<usize, Vec<Option<Expr>>>,
    /// Fields of such outputs, by name.
    pub shown: HashMap<String, Expr>,
}

impl Child {
    /// What drives an input of the child here, by the child's signal; none for its reset, which is the parent's.
    pub(super) fn driver_of(&self, input: usize) -> Option<Expr> {
        let is_input = |port: &PortDeclaration| matches!(port, PortDeclaration::Input(signal) if *signal == input);
        self.module.ports.iter().position(is_input).and_then(|port| self.inputs[port])
    }
}

impl PortDeclaration {
    /// Name and width of a port of `module`.
    pub(super) fn shape<'a>(&'a self, module: &'a Module) -> (&'a str, u32) {
        match self {
            Self::Input(signal) => (&module.signals[*signal].name, module.signals[*signal].reference.width()),
            Self::Output { name, value, .. } => (name, value.width()),
        }
    }
}

impl Module {
    /// Places a child; its `clk` and `rst` are connected by themselves.
    #[track_caller]
    pub fn instance(&mut self, name: &str, module: impl Into<Rc<Module>>) -> Instance {
        self.claim(name);
        let module = module.into();
        let mut outputs = vec![];
        for port in 0..module.ports.len() {
            outputs.push(self.child_output(name, &module, port));
        }
        let inputs = module.ports.iter().map(|_| None).collect();
        let (parts, shown) = (BTreeMap::new(), HashMap::new());
        let place = Location::caller();
        self.children.push(Child { name: name.into(), place, module, reset: None, inputs, outputs, parts, shown });
        Instance { module: self.identity, index: self.children.len() - 1, name: Name::new(name) }
    }

    /// What the module holds for an instance of its own.
    pub(super) fn child(&self, instance: Instance) -> Option<&Child> {
        self.children.get(instance.index).filter(|_| instance.module == self.identity)
    }

    pub(super) fn child_mut(&mut self, instance: Instance) -> Option<&mut Child> {
        self.children.get_mut(instance.index).filter(|_| instance.module == self.identity)
    }

    /// The signal `<instance>_<port>`, where the port is an output.
    #[track_caller]
    fn child_output(&mut self, name: &str, child: &Module, port: usize) -> Option<usize> {
        let declaration = &child.ports[port];
        if matches!(declaration, PortDeclaration::Input(_)) {
            return None;
        }
        let (port_name, width) = declaration.shape(child);
        self.declare(&format!("{name}_{port_name}"), width, Source::ChildOutput { child: self.children.len(), port });
        Some(self.signals.len() - 1)
    }

    /// Drives an input of a child.
    #[track_caller]
    pub fn connect(&mut self, instance: Instance, port: &str, value: impl Into<Expr>) {
        let value = value.into();
        if self.connect_field(instance, port, value) {
            return;
        }
        let Some(index) = self.child_port(instance, port, "input") else { return };
        let child = &self.children[instance.index];
        let (_, width) = child.module.ports[index].shape(&child.module);
        let name = format!("{}.{port}", instance.name());
        self.check_width(&name, width, value);
        match &mut self.children[instance.index].inputs[index] {
            slot @ None => *slot = Some(value),
            Some(_) => self.fault(FaultKind::DoublyDriven(name)),
        }
    }

    /// Resets a child by a condition of its own, which holds wherever the parent's reset does.
    #[track_caller]
    pub fn reset_by(&mut self, instance: Instance, condition: impl Into<Expr>) {
        if instance.module != self.identity {
            self.fault(FaultKind::ForeignHandle(instance.name()));
            return;
        }
        if self.children[instance.index].module.foreign.is_some() {
            let unit = self.children[instance.index].module.unit.clone();
            let (instance, port) = (instance.name(), "rst".into());
            self.fault(FaultKind::UnknownPort { instance, unit, direction: "input", port });
            return;
        }
        let condition = self.rst() | condition.into().as_condition("reset");
        match &mut self.children[instance.index].reset {
            slot @ None => *slot = Some(condition),
            Some(_) => self.fault(FaultKind::DoublyDriven(format!("{}.rst", instance.name()))),
        }
    }

    /// An output of a child.
    #[track_caller]
    pub fn out(&mut self, instance: Instance, port: &str) -> Expr {
        if let Some(field) = self.field_of(instance, port) {
            return field;
        }
        let index = self.child_port(instance, port, "output");
        let signal = index.and_then(|index| self.children[instance.index].outputs[index]);
        match signal {
            Some(signal) => self.signals[signal].reference,
            None => Expr::poison(1, format!("instance `{}` has no output `{port}`", instance.name())),
        }
    }

    /// A port of a child, of the wanted direction; a fault where there is none.
    #[track_caller]
    fn child_port(&mut self, instance: Instance, port: &str, direction: &'static str) -> Option<usize> {
        if instance.module != self.identity {
            self.fault(FaultKind::ForeignHandle(instance.name()));
            return None;
        }
        let child = &self.children[instance.index];
        let found = child.module.ports.iter().position(|declaration| {
            matches!(declaration, PortDeclaration::Input(_)) == (direction == "input")
                && declaration.shape(&child.module).0 == port
        });
        if found.is_none() {
            let (instance, unit) = (instance.name(), child.module.unit.clone());
            self.fault(FaultKind::UnknownPort { instance, unit, direction, port: port.into() });
        }
        found
    }
}
