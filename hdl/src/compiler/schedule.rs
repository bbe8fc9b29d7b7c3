//! When each operation takes its operands: modulo scheduling of a graph without cycles.
//!
//! An operation of a class with `n` instances may start in a cycle only if fewer than `n` others start in cycles equal to
//! it modulo the initiation interval. As every class has enough instances for one round and no value depends on itself,
//! going through the operations by urgency and taking the first free cycle always succeeds. Afterwards operations move
//! within their slack to where fewer registers are needed.

use super::cost::{CYCLE_LEVELS, MEMORY_STAGES, stages};
use super::graph::Graph;
use super::plan::{Plan, Timing};

/// Rounds of moving every operation once; the gain of later ones is small.
const MOVING_ROUNDS: usize = 6;
/// Cost of a flip-flop in units of a bit of a delay memory.
const REGISTER_COST: u64 = 8;

/// Start cycles, counted from the token's acceptance.
pub(super) struct Schedule {
    /// Cycle in which a node takes its operands.
    pub start: Vec<u32>,
    /// Cycle in which its value is there.
    pub available: Vec<u32>,
    /// Cycle in which the results enter the output queue.
    pub latency: u32,
}

/// Finds a schedule.
pub(super) fn schedule(graph: &Graph, plan: &Plan, initiation_interval: u32) -> Schedule {
    let mut scheduler = Scheduler::new(graph, plan, initiation_interval);
    scheduler.place_all();
    scheduler.finish = scheduler.latest_result().max(1);
    scheduler.save_registers();
    let available = (0..graph.nodes().len()).map(|index| scheduler.available(index)).collect();
    Schedule { start: scheduler.start, available, latency: scheduler.finish }
}

struct Scheduler<'a> {
    graph: &'a Graph,
    plan: &'a Plan,
    initiation_interval: u32,
    /// Users of each node's value, and how many cycles after their start they take it.
    users: Vec<Vec<(usize, u32)>>,
    /// Whether a node's value leaves the datapath.
    is_result: Vec<bool>,
    start: Vec<u32>,
    /// How far into its cycle a node's value is ready.
    level: Vec<u32>,
    /// Operations that start in a phase, by class and phase.
    reserved: Vec<Vec<u32>>,
    finish: u32,
}

impl<'a> Scheduler<'a> {
    fn new(graph: &'a Graph, plan: &'a Plan, initiation_interval: u32) -> Self {
        let count = graph.nodes().len();
        let mut users = vec![Vec::new(); count];
        for (index, node) in graph.nodes().iter().enumerate() {
            for (position, operand) in node.operands.iter().enumerate() {
                users[operand.0].push((index, plan.offset(index, position)));
            }
        }
        let mut is_result = vec![false; count];
        graph.outputs().iter().map(|(_, id)| *id).chain(graph.keep()).for_each(|id| is_result[id.0] = true);
        let level = |timing: &Timing| if let Timing::Static { levels } = timing { *levels } else { 0 };
        Self {
            graph,
            plan,
            initiation_interval,
            users,
            is_result,
            start: vec![0; count],
            level: plan.timing.iter().map(level).collect(),
            reserved: vec![vec![0; initiation_interval as usize]; plan.classes.len()],
            finish: 0,
        }
    }

    fn available(&self, index: usize) -> u32 {
        self.start[index] + self.plan.latency(index)
    }

    /// Operands that change from token to token, and how many cycles after the start they are taken.
    fn moving_operands(&self, index: usize) -> impl Iterator<Item = (usize, u32)> + '_ {
        let operands = self.graph.nodes()[index].operands.iter().enumerate();
        let moving = operands.filter(|(_, id)| !self.plan.is_static(**id));
        moving.map(move |(position, id)| (id.0, self.plan.offset(index, position)))
    }

    /// First cycle in which it may start, as all operands are there when they are taken.
    fn operands_available(&self, index: usize) -> u32 {
        let operands = self.moving_operands(index);
        operands.map(|(operand, offset)| self.available(operand).saturating_sub(offset)).max().unwrap_or(0)
    }

    /// How far into `cycle` the node's value is ready, if its operands leave enough of the cycle.
    fn level_at(&self, index: usize, cycle: u32) -> Option<u32> {
        let operands = self.moving_operands(index);
        let fresh = operands.filter(|&(operand, offset)| self.available(operand) == cycle + offset);
        let moving = fresh.map(|(operand, _)| self.level[operand]).max().unwrap_or(0);
        let operands = self.graph.nodes()[index].operands.iter();
        let fixed = operands.filter(|id| self.plan.is_static(**id)).map(|id| self.level[id.0]).max().unwrap_or(0);
        let before = moving.max(fixed);
        // With registers before it, an operation always fits: nothing could be split off.
        match self.plan.timing[index] {
            Timing::Static { levels } => Some(levels),
            Timing::Input => Some(self.plan.input_levels),
            Timing::Combinational { levels } if before + levels <= CYCLE_LEVELS => Some(before + levels),
            Timing::Combinational { .. } => (moving == 0).then_some(CYCLE_LEVELS),
            Timing::Pipelined { class } => {
                (moving == 0 || before <= self.plan.classes[class].input_levels()).then_some(0)
            }
        }
    }

    /// Whether the node's class has an instance to spare in that cycle's phase.
    fn has_instance(&self, index: usize, cycle: u32) -> bool {
        match self.plan.timing[index] {
            Timing::Pipelined { class } => self.reserved[class][self.phase(cycle)] < self.plan.classes[class].instances,
            Timing::Static { .. } | Timing::Input | Timing::Combinational { .. } => true,
        }
    }

    fn phase(&self, cycle: u32) -> usize {
        (cycle % self.initiation_interval) as usize
    }

    fn place(&mut self, index: usize, cycle: u32) {
        self.start[index] = cycle;
        if let Timing::Pipelined { class } = self.plan.timing[index] {
            let phase = self.phase(cycle);
            self.reserved[class][phase] += 1;
        }
    }

    fn unplace(&mut self, index: usize) {
        if let Timing::Pipelined { class } = self.plan.timing[index] {
            let phase = self.phase(self.start[index]);
            self.reserved[class][phase] -= 1;
        }
    }

    /// Places every node in its first free cycle, the most urgent first.
    fn place_all(&mut self) {
        let count = self.graph.nodes().len();
        let mut distance = vec![0; count];
        for index in (0..count).rev() {
            let rest = self.users[index].iter().map(|&(user, _)| distance[user]).max().unwrap_or(0);
            distance[index] = rest + self.plan.latency(index);
        }
        // Users are never farther from the end than their operands and come later, so operands are placed first.
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|&index| (std::cmp::Reverse(distance[index]), index));
        for index in order {
            let mut cycle = self.operands_available(index);
            loop {
                if self.has_instance(index, cycle)
                    && let Some(level) = self.level_at(index, cycle)
                {
                    self.level[index] = level;
                    break self.place(index, cycle);
                }
                cycle += 1;
            }
        }
    }

    fn latest_result(&self) -> u32 {
        let results = (0..self.graph.nodes().len()).filter(|&index| self.is_result[index]);
        results.map(|index| self.available(index)).max().unwrap_or(0)
    }

    /// Moves nodes, one at a time, to the cycle in which the registers around them are fewest.
    fn save_registers(&mut self) {
        let count = self.graph.nodes().len();
        for round in 0..MOVING_ROUNDS {
            let mut moved = false;
            for step in 0..count {
                let index = if round % 2 == 0 { count - 1 - step } else { step };
                moved |= self.improve(index);
            }
            if !moved {
                return;
            }
        }
    }

    /// Moves one node if that saves registers; says whether it did.
    fn improve(&mut self, index: usize) -> bool {
        if matches!(self.plan.timing[index], Timing::Static { .. } | Timing::Input) {
            return false;
        }
        let home = self.start[index];
        let here = self.cost_around(index);
        let earliest = self.operands_available(index);
        let latest = self.first_use(index).saturating_sub(self.plan.latency(index));
        self.unplace(index);
        let mut better: Vec<(u64, u32)> = Vec::new();
        for cycle in earliest..=latest {
            if cycle == home || !self.has_instance(index, cycle) {
                continue;
            }
            self.start[index] = cycle;
            let cost = self.cost_around(index);
            if cost < here {
                better.push((cost, cycle));
            }
        }
        better.sort_unstable();
        for &(_, cycle) in &better {
            self.start[index] = cycle;
            if self.update_levels() {
                self.place(index, cycle);
                return true;
            }
        }
        self.place(index, home);
        if !better.is_empty() {
            let feasible = self.update_levels();
            debug_assert!(feasible, "the schedule was feasible before the attempts");
        }
        false
    }

    /// The first cycle in which something takes the node's value.
    fn first_use(&self, index: usize) -> u32 {
        let users = self.users[index].iter().map(|&(user, offset)| self.start[user] + offset);
        users.chain(self.is_result[index].then_some(self.finish)).min().unwrap_or(self.finish)
    }

    /// Recomputes all levels; false when some cycle would be overfull.
    fn update_levels(&mut self) -> bool {
        for index in 0..self.graph.nodes().len() {
            match self.level_at(index, self.start[index]) {
                Some(level) => self.level[index] = level,
                None => return false,
            }
        }
        true
    }

    /// Cost of holding the node's value and its operands.
    fn cost_around(&self, index: usize) -> u64 {
        let operands = self.moving_operands(index).map(|(operand, _)| operand);
        operands.chain([index]).map(|value| self.holding_cost(value)).sum()
    }

    /// Cost of holding a value until its last use.
    fn holding_cost(&self, index: usize) -> u64 {
        let users = self.users[index].iter().map(|&(user, offset)| self.start[user] + offset);
        let last = users.chain(self.is_result[index].then_some(self.finish)).max().unwrap_or(0);
        let held = stages(last.saturating_sub(self.available(index)), self.initiation_interval);
        let width = u64::from(self.graph.nodes()[index].ty.width());
        let in_registers = u64::from(held.min(MEMORY_STAGES));
        let in_memory = u64::from(held.saturating_sub(MEMORY_STAGES));
        width * (REGISTER_COST * in_registers + in_memory)
    }
}

#[cfg(test)]
mod tests {
    use super::super::combine::combine;
    use super::super::cost::CYCLE_LEVELS;
    use super::super::graph::ValueId;
    use super::super::operators::OperatorStages;
    use super::super::optimize::optimize;
    use super::super::program::Program;
    use super::super::types::Type;
    use super::super::value::Value;
    use super::*;
    use pointcore_contract::Format;

    /// Sums of products, a root, and integers in long chains.
    fn graph() -> Graph {
        let p = Program::new("test", "");
        let x: Vec<Value> = (0..6).map(|i| p.input(&format!("x{i}"), Type::Float(Format::F16))).collect();
        let m = p.uniform("m", Type::Float(Format::F16));
        let sum = x.iter().map(|x| *x * m).reduce(|sum, product| sum + product).expect("there are six");
        p.output("root", sum.sqrt() * x[0] - x[5]);
        // Held to the end anyway, so its product is better computed late.
        p.output("last", x[5]);
        let n = p.input("n", Type::Unsigned(16));
        let chain = x.iter().fold(n, |n, x| (n + x.zext(16)).min(n ^ x.zext(16)));
        p.output("chain", chain);
        optimize(&p.graph().expect("the test's program is well typed"))
    }

    #[test]
    fn operands_are_there_and_instances_suffice() {
        for initiation_interval in 1..=7 {
            let graph = combine(graph(), initiation_interval);
            let plan = Plan::new(&graph, initiation_interval, &OperatorStages::default());
            let schedule = schedule(&graph, &plan, initiation_interval);
            let mut starts = vec![vec![0; initiation_interval as usize]; plan.classes.len()];
            let mut levels = vec![0; graph.nodes().len()];
            for (index, node) in graph.nodes().iter().enumerate() {
                let start = schedule.start[index];
                let moving = node.operands.iter().enumerate().filter(|(_, id)| !plan.is_static(**id));
                let before = moving.map(|(position, &ValueId(operand))| {
                    let taken = start + plan.offset(index, position);
                    assert!(schedule.available[operand] <= taken, "node {index} waits for {operand}");
                    if schedule.available[operand] == taken { levels[operand] } else { 0 }
                });
                let before = before.max().unwrap_or(0);
                match plan.timing[index] {
                    Timing::Pipelined { class } => starts[class][(start % initiation_interval) as usize] += 1,
                    Timing::Combinational { levels: own } => levels[index] = before + own,
                    Timing::Static { .. } | Timing::Input => {}
                }
                assert!(levels[index] <= CYCLE_LEVELS, "node {index} is at the end of too long a chain");
                assert!(schedule.available[index] <= schedule.latency);
            }
            for (class, phases) in plan.classes.iter().zip(&starts) {
                assert!(phases.iter().all(|&count| count <= class.instances), "{}: {phases:?}", class.name);
            }
        }
    }

    #[test]
    fn moving_operations_saves_registers_and_no_time() {
        for initiation_interval in [1, 2, 5] {
            let graph = combine(graph(), initiation_interval);
            let plan = Plan::new(&graph, initiation_interval, &OperatorStages::default());
            let mut scheduler = Scheduler::new(&graph, &plan, initiation_interval);
            scheduler.place_all();
            scheduler.finish = scheduler.latest_result();
            let cost = |scheduler: &Scheduler| {
                let moving =
                    (0..graph.nodes().len()).filter(|&index| !matches!(plan.timing[index], Timing::Static { .. }));
                moving.map(|index| scheduler.holding_cost(index)).sum::<u64>()
            };
            let before = cost(&scheduler);
            scheduler.save_registers();
            assert!(cost(&scheduler) < before, "{before} at interval {initiation_interval}");
            assert_eq!(scheduler.latest_result(), scheduler.finish);
        }
    }
}
