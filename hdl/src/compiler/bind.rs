//! Which instance of its class carries out each operation.

use super::cost::stages;
use super::graph::{Graph, ValueId};
use super::plan::{Plan, Timing};
use super::schedule::Schedule;

/// One operator in hardware: the node that starts in each phase.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub class: usize,
    pub by_phase: Vec<Option<usize>>,
}

/// Where an operand is read: the value and the register it has reached.
type Source = (ValueId, u32);

/// Distributes the operations, each to the free instance that already reads most of its operands: such instances need
/// fewer choices in front of them.
pub(super) fn bind(graph: &Graph, plan: &Plan, schedule: &Schedule, initiation_interval: u32) -> Vec<Unit> {
    let phases = initiation_interval as usize;
    let mut units = Vec::new();
    for (class, description) in plan.classes.iter().enumerate() {
        let first = units.len();
        let idle = Unit { class, by_phase: vec![None; phases] };
        units.extend(std::iter::repeat_n(idle, description.instances as usize));
        for (index, timing) in plan.timing.iter().enumerate() {
            if *timing != (Timing::Pipelined { class }) {
                continue;
            }
            let phase = schedule.start[index] as usize % phases;
            let wanted = sources(graph, plan, schedule, initiation_interval, index);
            let shared = |unit: &Unit| {
                let others = unit.by_phase.iter().flatten();
                let others = others.map(|&other| sources(graph, plan, schedule, initiation_interval, other));
                others.map(|other| wanted.iter().zip(&other).filter(|(a, b)| a == b).count()).sum::<usize>()
            };
            // Where each has an instance of its own, all phases of it are.
            let is_free = |unit: &Unit| match description.operand_registers {
                true => unit.by_phase[phase].is_none(),
                false => unit.by_phase.iter().all(Option::is_none),
            };
            let free = (first..units.len()).filter(|&unit| is_free(&units[unit]));
            let best = free.max_by_key(|&unit| (shared(&units[unit]), std::cmp::Reverse(unit)));
            let best = best.expect("the schedule starts no more operations in a phase than there are instances");
            units[best].by_phase[phase] = Some(index);
        }
    }
    units
}

/// Where an operation reads its operands.
fn sources(graph: &Graph, plan: &Plan, schedule: &Schedule, initiation_interval: u32, index: usize) -> Vec<Source> {
    let operands = graph.nodes()[index].operands.iter().enumerate();
    operands
        .map(|(position, &operand)| {
            let taken = schedule.start[index] + plan.offset(index, position);
            let held = match plan.of(operand) {
                Timing::Static { .. } => 0,
                _ => stages(taken - schedule.available[operand.0], initiation_interval),
            };
            (operand, held)
        })
        .collect()
}
