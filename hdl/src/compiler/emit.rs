//! The hardware of a scheduled program: operators, what chooses their operands, delays, and the streams at both ends.
//!
//! A token's validity runs beside its data, one register an initiation interval; what data registers hold besides valid
//! tokens is never looked at. Nothing stalls, so that nothing but phases has to reach all registers.

use super::bind::{Unit, bind};
use super::cost::stages;
use super::delay::Delays;
use super::emitter::Emitter;
use super::graph::{Graph, ValueId};
use super::labels::labels;
use super::lower::combinational;
use super::manifest::{Manifest, OperatorUse};
use super::operation::Operation;
use super::operators::OPERAND_PORTS;
use super::plan::{Plan, Timing};
use super::schedule::Schedule;
use super::types::Type;
use super::{Options, output};
use output::{Output, Tokens};
use rtl::{Expr, Instance, Module, bit, lit};
use std::collections::{BTreeMap, HashMap};

/// What a datapath has besides its values.
const CONTROL: [&str; 7] = ["clk", "rst", "credits", "dropped", "left", "kept", "shown"];

/// Builds the module and its manifest.
pub(super) fn emit(graph: &Graph, plan: &Plan, schedule: &Schedule, options: &Options) -> (Module, Manifest) {
    let initiation_interval = options.initiation_interval;
    let mut module = Module::new(graph.unit(), graph.doc());
    module.parameter("latency", schedule.latency);
    module.parameter("initiation_interval", initiation_interval);
    let inputs = ports(graph, &Operation::Input);
    let input = module.stream_in("in", &layout(graph, &inputs));
    let uniforms = ports(graph, &Operation::Uniform);
    let results: Vec<(String, ValueId)> = graph.outputs().to_vec();
    let places = output::places(schedule.latency, initiation_interval);
    let output = Output::new(&mut module, options.taking, places);

    let mut names: Vec<String> =
        ["in", "out"].iter().flat_map(|s| [format!("{s}_valid"), format!("{s}_ready")]).collect();
    names.extend(inputs.iter().map(|(name, _)| format!("in_{name}")));
    names.extend(results.iter().map(|(name, _)| format!("out_{name}")));
    names.extend(uniforms.iter().map(|(name, _)| name.clone()));
    names.extend(results.iter().map(|(name, _)| format!("shown_{name}")));
    names.extend((1..=results.len()).map(|part| format!("queue_{part}")));
    names.extend(CONTROL.map(str::to_owned));
    let values: HashMap<ValueId, Expr> = inputs
        .iter()
        .map(|(name, id)| (*id, input.field(name)))
        .chain(uniforms.iter().map(|(name, id)| (*id, module.input(name, width(graph, *id)))))
        .collect();
    let mut emitter = Emitter::new(module, initiation_interval, names.into_iter().collect());
    let ready = output.admits() & emitter.in_phase(0, 1);
    emitter.module.ready(&input, ready);

    let delays = Delays::new(graph, plan, schedule, &mut emitter);
    let mut body = Body { graph, plan, schedule, emitter, delays, values, labels: labels(graph) };
    let units = bind(graph, plan, schedule, initiation_interval);
    let instances: Vec<Instance> = units.iter().map(|unit| body.instance(unit)).collect();
    for index in 0..graph.nodes().len() {
        body.value(ValueId(index));
    }
    for (unit, instance) in units.iter().zip(&instances) {
        body.operands(unit, *instance);
    }
    body.results(output, input.valid & ready, &results);
    body.finish()
}

/// Ports of one kind with their names.
fn ports(graph: &Graph, kind: &Operation) -> Vec<(String, ValueId)> {
    let nodes = graph.nodes().iter().enumerate().filter(|(_, node)| node.operation == *kind);
    nodes.map(|(index, _)| (graph.label(ValueId(index)), ValueId(index))).collect()
}

fn layout(graph: &Graph, fields: &[(String, ValueId)]) -> Vec<(String, u32)> {
    fields.iter().map(|(name, id)| (name.clone(), width(graph, *id))).collect()
}

fn width(graph: &Graph, id: ValueId) -> u32 {
    graph.node(id).ty.width()
}

/// The datapath between the streams.
struct Body<'a> {
    graph: &'a Graph,
    plan: &'a Plan,
    schedule: &'a Schedule,
    emitter: Emitter,
    delays: Delays,
    /// Values in the cycle in which they are there.
    values: HashMap<ValueId, Expr>,
    /// What values are called.
    labels: Vec<String>,
}

impl Body<'_> {
    /// An operator; its output is the value of every operation it carries out.
    fn instance(&mut self, unit: &Unit) -> Instance {
        let class = &self.plan.classes[unit.class];
        let name = self.emitter.unique(&format!("{}_unit", class.name.replace(['.', '-'], "_")));
        let module = &mut self.emitter.module;
        let instance = module.instance(&name, class.operator.module.clone());
        module.connect(instance, "enable", bit(true));
        let result = module.out(instance, "y");
        self.values.extend(unit.by_phase.iter().flatten().map(|&index| (ValueId(index), result)));
        instance
    }

    /// Makes a value and holds it as long as needed.
    fn value(&mut self, id: ValueId) {
        let node = self.graph.node(id);
        let label = self.labels[id.0].clone();
        let live = match self.values.get(&id) {
            Some(live) => *live,
            None => self.combinational(id, &label),
        };
        if !self.plan.is_static(id) {
            self.delays.hold(&mut self.emitter, id, &label, live, self.schedule.available[id.0]);
        }
        debug_assert_eq!(live.width(), node.ty.width(), "{label}");
        self.values.insert(id, live);
    }

    fn combinational(&mut self, id: ValueId, label: &str) -> Expr {
        let node = self.graph.node(id);
        if let Operation::Constant(value) = node.operation {
            return lit(width(self.graph, id), value.into());
        }
        let operands: Vec<Expr> = (0..node.operands.len()).map(|position| self.operand(id.0, position)).collect();
        let types: Vec<Type> = node.operands.iter().map(|&operand| self.graph.node(operand).ty).collect();
        let value = combinational(&node.operation, &operands, &types, node.ty);
        let is_wiring = matches!(self.plan.of(id), Timing::Static { levels: 0 } | Timing::Combinational { levels: 0 });
        if is_wiring && node.name.is_none() {
            return value;
        }
        let name = self.emitter.unique(label);
        self.emitter.module.wire(&name, value)
    }

    /// An operand when the node `user` takes it.
    fn operand(&self, user: usize, position: usize) -> Expr {
        let operand = self.graph.nodes()[user].operands[position];
        self.read(operand, self.schedule.start[user] + self.plan.offset(user, position))
    }

    /// A value in some cycle of its token.
    fn read(&self, id: ValueId, cycle: u32) -> Expr {
        if self.plan.is_static(id) {
            return self.values[&id];
        }
        self.delays.tap(id, stages(cycle - self.schedule.available[id.0], self.emitter.initiation_interval()))
    }

    /// Leads the operands of all its operations to an operator.
    fn operands(&mut self, unit: &Unit, instance: Instance) {
        let class = &self.plan.classes[unit.class];
        let count = unit.by_phase.iter().flatten().map(|&index| self.graph.nodes()[index].operands.len()).max();
        let mut chooser = self.emitter.chooser(instance.name());
        for (position, port) in OPERAND_PORTS.iter().enumerate().take(count.unwrap_or(0)) {
            let by_phase = unit.by_phase.iter();
            let mut sources: Vec<Option<Expr>> =
                by_phase.map(|slot| slot.map(|index| self.operand(index, position))).collect();
            let later = self.emitter.phase_of(class.offset(position));
            sources.rotate_right(later as usize);
            let mut chosen = chooser.choose(&mut self.emitter, &sources);
            if class.operand_registers {
                chosen = self.emitter.step(&format!("{}_{port}", instance.name()), chosen);
            }
            self.emitter.module.connect(instance, port, chosen);
        }
    }

    /// Sends finished tokens to the output.
    fn results(&mut self, output: Output, enters: Expr, results: &[(String, ValueId)]) {
        let latency = self.schedule.latency;
        let stages = stages(latency, self.emitter.initiation_interval());
        let in_flight = self.emitter.shift_register("in_flight", stages, enters);
        let phase = self.emitter.phase_of(latency);
        let arrives = in_flight & self.emitter.in_phase(phase, 1);
        let keep = self.graph.keep().map_or_else(|| bit(true), |condition| self.read(condition, latency));
        let read = |(name, id): &(String, ValueId)| (name.clone(), self.read(*id, latency));
        let results: Vec<(String, Expr)> = results.iter().map(read).collect();
        output.finish(&mut self.emitter.module, &Tokens { enters, arrives, keep }, &results);
    }

    fn finish(mut self) -> (Module, Manifest) {
        let delay_memory_bits = self.delays.finish(&mut self.emitter);
        let mut operators: BTreeMap<String, OperatorUse> = BTreeMap::new();
        for class in &self.plan.classes {
            for part in &class.parts {
                let total = operators.entry(part.clone()).or_default();
                total.instances += class.instances;
                total.operations += class.operations;
            }
        }
        let initiation_interval = self.emitter.initiation_interval();
        let (module, register_bits) = self.emitter.finish();
        let manifest = Manifest {
            unit: self.graph.unit().to_owned(),
            latency: self.schedule.latency,
            initiation_interval,
            operators,
            register_bits,
            delay_memory_bits,
        };
        (module, manifest)
    }
}
