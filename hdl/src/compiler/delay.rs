//! Holding values until they are needed.
//!
//! A value is there in one cycle; a register catches it and holds it for one initiation interval, after which the next
//! token's value arrives. A chain of registers that load in the same phase holds it longer. A chain of [`MEMORY_STAGES`]
//! and more becomes a circular buffer, and chains of equal length and phase share one: it costs a pointer instead of a
//! flip-flop a bit and cycle.

use super::cost::{MEMORY_STAGES, stages};
use super::emitter::Emitter;
use super::graph::{Graph, ValueId};
use super::plan::Plan;
use super::schedule::Schedule;
use rtl::{Expr, Memory, address_width, cat};
use std::collections::{BTreeMap, BTreeSet};

/// Deepest delay kept in look-up tables; deeper ones take block memory.
const DISTRIBUTED_DEPTH: u32 = 64;

/// Memories are shared by chains that load in the same phase and are equally long.
type LineKey = (u32, u32);

/// A circular buffer under construction: everything but its input.
struct Line {
    memory: Memory,
    enable: Expr,
    pointer: Expr,
    output: Expr,
    /// Inputs so far, in the order in which their chains take bits from `output`, lowest first.
    inputs: Vec<Expr>,
    used: u32,
}

/// The held values of a datapath.
pub(super) struct Delays {
    /// Numbers of registers after which each value is read, besides 0.
    needs: Vec<BTreeSet<u32>>,
    lines: BTreeMap<LineKey, Line>,
    taps: BTreeMap<(ValueId, u32), Expr>,
}

impl Delays {
    /// Finds out what must be held how long, and makes the memories.
    pub fn new(graph: &Graph, plan: &Plan, schedule: &Schedule, emitter: &mut Emitter) -> Self {
        let mut needs = vec![BTreeSet::new(); graph.nodes().len()];
        let mut need = |value: ValueId, cycle: u32| {
            if !plan.is_static(value) {
                needs[value.0].insert(stages(cycle - schedule.available[value.0], emitter.initiation_interval()));
            }
        };
        for (index, node) in graph.nodes().iter().enumerate() {
            node.operands.iter().for_each(|&operand| need(operand, schedule.start[index]));
        }
        graph.outputs().iter().map(|(_, id)| *id).chain(graph.keep()).for_each(|id| need(id, schedule.latency));

        let mut widths: BTreeMap<LineKey, u32> = BTreeMap::new();
        for (index, taps) in needs.iter().enumerate() {
            for (from, to) in segments(taps).filter(|(from, to)| to - from >= MEMORY_STAGES) {
                let key = (emitter.phase_of(schedule.available[index]), to - from);
                *widths.entry(key).or_default() += graph.nodes()[index].ty.width();
            }
        }
        let lines = widths.into_iter().map(|(key, width)| (key, Line::new(key, width, emitter))).collect();
        Self { needs, lines, taps: BTreeMap::new() }
    }

    /// Makes the registers behind a value that is there as `live` in cycle `available`.
    pub fn hold(&mut self, emitter: &mut Emitter, value: ValueId, name: &str, live: Expr, available: u32) {
        let phase = emitter.phase_of(available);
        self.taps.insert((value, 0), live);
        let mut data = live;
        for (from, to) in segments(&self.needs[value.0]) {
            if to - from >= MEMORY_STAGES {
                let line = self.lines.get_mut(&(phase, to - from)).expect("`new` made a line for every long segment");
                let held = line.take(data);
                let label = emitter.unique(&format!("{name}_d{to}"));
                data = emitter.module.wire(&label, held);
            } else {
                for stage in from + 1..=to {
                    data = emitter.register(&format!("{name}_d{stage}"), phase, data);
                }
            }
            self.taps.insert((value, to), data);
        }
    }

    /// The value after so many registers.
    pub fn tap(&self, value: ValueId, stages: u32) -> Expr {
        self.taps[&(value, stages)]
    }

    /// Connects the memories' inputs, once all values are held; returns the bits in memories.
    pub fn finish(self, emitter: &mut Emitter) -> u64 {
        let mut bits = 0;
        for ((_, length), line) in self.lines {
            emitter.module.write(line.memory, line.enable, line.pointer, cat(line.inputs.into_iter().rev()));
            bits += u64::from(length - 1) * line.used as u64;
        }
        bits
    }
}

/// Stretches between the points at which a value is read.
fn segments(taps: &BTreeSet<u32>) -> impl Iterator<Item = (u32, u32)> + '_ {
    let ends = taps.iter().copied().filter(|&stage| stage > 0);
    ends.scan(0, |from, to| Some((std::mem::replace(from, to), to)))
}

impl Line {
    /// A buffer of one entry less than its delay: the registered read is the last step.
    fn new((phase, length): LineKey, width: u32, emitter: &mut Emitter) -> Self {
        let depth = length - 1;
        let name = emitter.unique(&format!("delay_{length}_from_{phase}"));
        let enable = emitter.load(phase);
        let module = &mut emitter.module;
        let pointer = module.reg_reset(&format!("{name}_pointer"), address_width(depth), 0);
        let at_end = pointer.eq_lit(u128::from(depth - 1));
        let next = at_end.mux(pointer.sub_lit(u128::from(depth - 1)), pointer.add_lit(1));
        module.next_if(pointer, enable, next);
        let memory = if depth <= DISTRIBUTED_DEPTH {
            module.memory_distributed(&name, depth, width)
        } else {
            module.memory(&name, depth, width)
        };
        let output = module.read_if(memory, &format!("{name}_out"), enable, pointer);
        emitter.count_registers(pointer.width() + width);
        Self { memory, enable, pointer: pointer.expr(), output, inputs: Vec::new(), used: 0 }
    }

    /// Puts `data` in; returns it as it comes out.
    fn take(&mut self, data: Expr) -> Expr {
        let low = self.used;
        self.used += data.width();
        self.inputs.push(data);
        self.output.bits(self.used - 1, low)
    }
}
