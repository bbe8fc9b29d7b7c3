//! Holding values until they are needed.
//!
//! A value is there in one cycle; a register catches it and holds it for one initiation interval, after which the next
//! token's value arrives. A chain of registers that load in the same phase holds it longer. A chain of [`MEMORY_STAGES`]
//! and more becomes a circular buffer, and chains of equal length and phase share some: they cost a pointer instead of a
//! flip-flop a bit and cycle.

use super::cost::{MEMORY_STAGES, stages};
use super::emitter::Emitter;
use super::graph::{Graph, ValueId};
use super::plan::{Plan, Timing};
use super::schedule::Schedule;
use rtl::{Expr, Memory, address_width, cat};
use std::collections::{BTreeMap, BTreeSet};

/// Deepest delay kept in look-up tables; deeper ones take block memory.
const DISTRIBUTED_DEPTH: u32 = 64;

/// Widest circular buffer: with its pointer no more than what is told its phase by one register; three block RAMs of 36 bits.
const LINE_BITS: u32 = 108;

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
    lines: BTreeMap<LineKey, Vec<Line>>,
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
            for (position, &operand) in node.operands.iter().enumerate() {
                need(operand, schedule.start[index] + plan.offset(index, position));
            }
        }
        graph.outputs().iter().map(|(_, id)| *id).chain(graph.keep()).for_each(|id| need(id, schedule.latency));
        // What comes late goes to a register, not to a memory.
        if plan.input_levels > 0 {
            let inputs = needs.iter_mut().zip(&plan.timing).filter(|(_, timing)| matches!(timing, Timing::Input));
            let held = inputs.map(|(taps, _)| taps).filter(|taps| taps.last() > Some(&0));
            held.for_each(|taps| {
                taps.insert(1);
            });
        }

        let mut widths: BTreeMap<LineKey, Vec<u32>> = BTreeMap::new();
        for (index, taps) in needs.iter().enumerate() {
            for (from, to) in segments(taps).filter(|(from, to)| to - from >= MEMORY_STAGES) {
                let key = (emitter.phase_of(schedule.available[index]), to - from);
                let (lines, width) = (widths.entry(key).or_default(), graph.nodes()[index].ty.width());
                match lines.iter_mut().find(|used| has_room(**used, width)) {
                    Some(used) => *used += width,
                    None => lines.push(width),
                }
            }
        }
        let mut make = |(key, widths): (LineKey, Vec<u32>)| {
            let lines: Vec<Line> = widths.into_iter().map(|width| Line::new(key, width, emitter)).collect();
            (key, lines)
        };
        let lines = widths.into_iter().map(&mut make).collect();
        Self { needs, lines, taps: BTreeMap::new() }
    }

    /// Makes the registers behind a value that is there as `live` in cycle `available`.
    pub fn hold(&mut self, emitter: &mut Emitter, value: ValueId, name: &str, live: Expr, available: u32) {
        let phase = emitter.phase_of(available);
        self.taps.insert((value, 0), live);
        let mut data = live;
        for (from, to) in segments(&self.needs[value.0]) {
            if to - from >= MEMORY_STAGES {
                // In the order of `new`, so that values find the places that they had there.
                let lines = self.lines.get_mut(&(phase, to - from)).into_iter().flatten();
                let line = lines.into_iter().find(|line| has_room(line.used, data.width()));
                let held = line.expect("`new` made room for every long segment").take(data);
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
        let lines =
            self.lines.into_iter().flat_map(|((_, length), lines)| lines.into_iter().map(move |line| (length, line)));
        for (length, line) in lines {
            emitter.module.write(line.memory, line.enable, line.pointer, cat(line.inputs.into_iter().rev()));
            bits += u64::from(length - 1) * line.used as u64;
        }
        bits
    }
}

/// Whether a circular buffer takes a value besides those of so many bits.
const fn has_room(used: u32, width: u32) -> bool {
    used + width <= LINE_BITS
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
        let pointer_bits = address_width(depth);
        let enable = emitter.in_phase(phase, width + pointer_bits);
        let module = &mut emitter.module;
        let pointer = module.reg_reset(&format!("{name}_pointer"), pointer_bits, 0);
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
