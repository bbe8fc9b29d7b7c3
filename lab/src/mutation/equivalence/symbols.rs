//! What bits hold, as symbols and gates of them: two that hold the same are found to do so.

use batsat::{BasicSolver, Lit, SolverInterface, Var, lbool};
use rustc_hash::{FxHashMap, FxHashSet};
use std::time::{Duration, Instant};

/// A symbol or gate, with the lowest bit set its opposite.
pub type Literal = u32;

pub const FALSE: Literal = 0;
const TRUE: Literal = 1;

/// How long it may take to find out whether two are the same: where they are not, their examples mostly tell.
const PATIENCE: Duration = Duration::from_secs(2);

/// One if both operands are, or if one of them is.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Gate {
    And([Literal; 2]),
    Xor([Literal; 2]),
}

/// Symbols and gates; a gate's operands come before it.
pub struct Symbols {
    all: Vec<Option<Gate>>,
    /// What they are in 64 examples.
    examples: Vec<u64>,
    gates: FxHashMap<Gate, Literal>,
    random: fastrand::Rng,
}

impl Symbols {
    pub fn new() -> Self {
        Self { all: vec![None], examples: vec![0], gates: FxHashMap::default(), random: fastrand::Rng::with_seed(0) }
    }

    /// One of which nothing is known.
    pub fn fresh(&mut self) -> Literal {
        let example = self.random.u64(..);
        self.push(None, example)
    }

    fn push(&mut self, gate: Option<Gate>, example: u64) -> Literal {
        self.all.push(gate);
        self.examples.push(example);
        2 * (self.all.len() - 1) as Literal
    }

    fn example(&self, literal: Literal) -> u64 {
        self.examples[literal as usize / 2] ^ 0_u64.wrapping_sub(u64::from(literal & 1))
    }

    fn gate(&mut self, gate: Gate) -> Literal {
        if let Some(&known) = self.gates.get(&gate) {
            return known;
        }
        let example = match gate {
            Gate::And([a, b]) => self.example(a) & self.example(b),
            Gate::Xor([a, b]) => self.example(a) ^ self.example(b),
        };
        let new = self.push(Some(gate), example);
        self.gates.insert(gate, new);
        new
    }

    /// All that are true where one is, as far as it is made of them; it is one of them.
    pub fn parts(&self, literal: Literal) -> Vec<Literal> {
        let mut parts = vec![literal];
        let mut seen = 0;
        while let Some(&part) = parts.get(seen) {
            seen += 1;
            for part in self.conjunction(part).filter(|_| part & 1 == 0).into_iter().flatten() {
                if !parts.contains(&part) {
                    parts.push(part);
                }
            }
        }
        parts
    }

    pub fn xor(&mut self, a: Literal, b: Literal) -> Literal {
        let sign = (a ^ b) & 1;
        let [a, b] = [a & !1, b & !1];
        if a == b || a == FALSE || b == FALSE {
            return if a == b { sign } else { (a | b) ^ sign };
        }
        for [a, b] in [[a, b], [b, a]] {
            if let Some(Gate::Xor(operands)) = self.all[b as usize / 2]
                && let Some(place) = operands.iter().position(|&operand| operand == a)
            {
                return operands[1 - place] ^ sign;
            }
        }
        self.gate(Gate::Xor([a.min(b), a.max(b)])) ^ sign
    }

    /// The operands, if it or its opposite is a conjunction.
    fn conjunction(&self, literal: Literal) -> Option<[Literal; 2]> {
        match self.all[literal as usize / 2] {
            Some(Gate::And(operands)) => Some(operands),
            _ => None,
        }
    }

    pub fn and(&mut self, a: Literal, b: Literal) -> Literal {
        let [a, b] = [a.min(b), a.max(b)];
        match (a, b) {
            (FALSE, _) => return FALSE,
            (TRUE, _) => return b,
            _ if a == b => return a,
            _ if a == b ^ 1 => return FALSE,
            _ => (),
        }
        for [a, b] in [[a, b], [b, a]] {
            let Some(operands) = self.conjunction(b) else { continue };
            let has = |operand| operands.contains(&operand);
            match b & 1 {
                0 if has(a) => return b,
                0 if has(a ^ 1) => return FALSE,
                1 if has(a ^ 1) => return a,
                1 if has(a) => {
                    let other = operands[usize::from(operands[0] == a)];
                    return self.and(a, other ^ 1);
                }
                _ => (),
            }
        }
        // Neither of two conjunctions whose operands exclude each other: a choice between one and the same, or its opposite.
        if let (1, Some([p, q]), Some([r, s])) = (a & b & 1, self.conjunction(a), self.conjunction(b)) {
            for [p, q, r, s] in [[p, q, r, s], [p, q, s, r], [q, p, r, s], [q, p, s, r]] {
                if p == r ^ 1 && q == s {
                    return q ^ 1;
                }
                if p == r ^ 1 && q == s ^ 1 {
                    return self.xor(p, q);
                }
            }
        }
        self.gate(Gate::And([a, b]))
    }

    /// Whether one is false, whatever symbols are. In doubt it is not. What is one of many is asked of each, which is easier.
    pub fn is_never(&self, literal: Literal) -> bool {
        let mut seen = FxHashSet::default();
        let mut open = vec![literal];
        while let Some(literal) = open.pop() {
            if !seen.insert(literal) {
                continue;
            }
            match self.conjunction(literal) {
                Some(operands) if literal & 1 == 1 => open.extend(operands.map(|operand| operand ^ 1)),
                _ if self.are_same(literal, FALSE) => {}
                _ => return false,
            }
        }
        true
    }

    /// Whether both are the same, whatever symbols are. In doubt they are not.
    pub fn are_same(&self, a: Literal, b: Literal) -> bool {
        a == b || (self.example(a) == self.example(b) && self.is_shown_same(a, b))
    }

    fn is_shown_same(&self, a: Literal, b: Literal) -> bool {
        let mut question = Question::new(self, &[a, b]);
        question.assume(&[a, b]);
        question.assume(&[a ^ 1, b ^ 1]);
        question.answer() == lbool::FALSE
    }

    /// Those of some that are true wherever one is. In doubt none is.
    pub fn implied(&self, literal: Literal, mut others: Vec<Literal>) -> Vec<Literal> {
        others.retain(|&other| self.example(literal) & !self.example(other) == 0);
        let mut question = Question::new(self, &[&[literal], others.as_slice()].concat());
        question.assume(&[literal]);
        while !others.is_empty() {
            // One of them is not.
            let opposites: Vec<Literal> = others.iter().map(|other| other ^ 1).collect();
            let answer = question.answer_if_one_of(&opposites);
            if answer == lbool::FALSE {
                break;
            }
            others.retain(|&other| answer == lbool::TRUE && question.is_true(other));
        }
        others
    }
}

/// What a solver is asked about some symbols and what they are made of.
struct Question {
    solver: BasicSolver,
    variables: FxHashMap<u32, Var>,
}

impl Question {
    fn new(symbols: &Symbols, asked: &[Literal]) -> Self {
        let mut solver = BasicSolver::default();
        let end = Instant::now() + PATIENCE;
        solver.cb_mut().set_stop(move || Instant::now() > end);
        let mut variables: FxHashMap<u32, Var> = FxHashMap::default();
        let mut open: Vec<u32> = asked.iter().map(|literal| literal / 2).collect();
        while let Some(symbol) = open.pop() {
            if variables.contains_key(&symbol) {
                continue;
            }
            variables.insert(symbol, solver.new_var_default());
            if let Some(Gate::And(operands) | Gate::Xor(operands)) = symbols.all[symbol as usize] {
                open.extend(operands.map(|operand| operand / 2));
            }
        }
        let mut question = Self { solver, variables };
        let all: Vec<u32> = question.variables.keys().copied().collect();
        for symbol in all {
            let y = 2 * symbol;
            match symbols.all[symbol as usize] {
                None if y == FALSE => question.assume(&[TRUE]),
                None => {}
                Some(Gate::And([p, q])) => {
                    for clause in [&[y ^ 1, p][..], &[y ^ 1, q], &[y, p ^ 1, q ^ 1]] {
                        question.assume(clause);
                    }
                }
                Some(Gate::Xor([p, q])) => {
                    for clause in [[y ^ 1, p, q], [y ^ 1, p ^ 1, q ^ 1], [y, p ^ 1, q], [y, p, q ^ 1]] {
                        question.assume(&clause);
                    }
                }
            }
        }
        question
    }

    fn of(&self, literal: Literal) -> Lit {
        Lit::new(self.variables[&(literal / 2)], literal & 1 == 0)
    }

    /// One of these is true.
    fn assume(&mut self, literals: &[Literal]) {
        let mut clause: Vec<Lit> = literals.iter().map(|&literal| self.of(literal)).collect();
        // What cannot be is found when it is asked.
        self.solver.add_clause_reuse(&mut clause);
    }

    fn answer(&mut self) -> lbool {
        self.solver.solve_limited(&[])
    }

    /// The answer where one of these is true, too.
    fn answer_if_one_of(&mut self, literals: &[Literal]) -> lbool {
        let asked = Lit::new(self.solver.new_var_default(), true);
        let mut clause: Vec<Lit> = literals.iter().map(|&literal| self.of(literal)).chain([!asked]).collect();
        self.solver.add_clause_reuse(&mut clause);
        self.solver.solve_limited(&[asked])
    }

    /// In the example that the last answer gave.
    fn is_true(&self, literal: Literal) -> bool {
        self.solver.value_lit(self.of(literal)) == lbool::TRUE
    }
}
