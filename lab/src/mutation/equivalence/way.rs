//! Ways to compare a module with its mutant.

use super::DELAY;
use super::planted::FAULT;
use crate::mutation::side_by_side::Border;

/// How a module is compared with its mutant.
#[derive(Clone, Copy)]
pub(super) enum Way<'a> {
    /// At its border, if that is known.
    At(Option<&'a Border>),
    /// There, too, with one reset of the module and what is in it, which comes first: where a phase then tells when something is
    /// looked at, all cycles of its turn become one. A reset may come at any other time; nothing depends on what registers hold
    /// then, as tests say that begin with random values. Of a fault in this cell that a reset goes through nothing is claimed.
    InTurns(Option<&'a Border>),
    /// At the registers near the mutated cell: these and those that have a reset are registers in both, all others inputs,
    /// equal in both, and what they take next is compared, with one reset and in turns, too. That is small in a module of
    /// any size. It shows that what holds is as it was when it is looked at.
    Around(Around<'a>),
    /// At its border, with one reset, too, but followed from there on instead of searched for what is always so: in a module of any
    /// size. Circular buffers that delay are shift registers then, which have no pointers to follow.
    Followed(Option<&'a Border>),
}

impl Way<'_> {
    /// Whether there is one reset, where the module has any.
    pub const fn has_one_reset(self) -> bool {
        !matches!(self, Self::At(_))
    }

    /// What yosys makes of memories: registers, or what they are until it is known which of them are near.
    pub const fn memory(self) -> &'static str {
        match self {
            Self::At(_) | Self::InTurns(_) => "memory",
            Self::Around(_) | Self::Followed(_) => "memory -nordff -nomap",
        }
    }

    /// Has the memories of circular buffers stay in a module, where others of their kind are taken out.
    pub fn kept(self, module: &str) -> String {
        match self {
            Self::Followed(_) => format!("hierarchy -top {module}\nuniquify {module}/c:{DELAY}*\n"),
            Self::At(_) | Self::InTurns(_) | Self::Around(_) => String::new(),
        }
    }

    /// What yosys makes of circular buffers once all is flat: shift registers, but for those whose pointer or enable sees the fault. Which
    /// they are is known of the mutant, which comes first.
    pub fn delays(self, is_mutant: bool) -> String {
        let told = if is_mutant { BUFFERS_OF_THE_FAULT } else { "" };
        match self {
            Self::Followed(_) => format!("{told}{BUFFERS}"),
            Self::At(_) | Self::InTurns(_) | Self::Around(_) => String::new(),
        }
    }
}

/// Near what, and how.
#[derive(Clone, Copy)]
pub(super) struct Around<'a> {
    /// The mutated cell, if it is no instance.
    pub cell: Option<&'a str>,
    pub operators: Operators,
    /// So many registers behind it are near it.
    pub near: usize,
    /// The bit that is mutated in a register's output begins the other way.
    pub begins_set: bool,
}

/// What operators may be given.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Operators {
    /// The same in every cycle.
    Strict,
    /// Something else, which they then answer to.
    Tolerant,
}

impl Operators {
    /// So many of them, one behind the other, may be given something else: what is near is small.
    pub const fn in_a_row(self) -> u32 {
        match self {
            Self::Strict => 0,
            Self::Tolerant => 3,
        }
    }
}

/// So many registers behind a mutated cell are near it: what looks at a register in every cycle may itself not be looked at.
pub(super) const NEAR: usize = 3;
/// As many where conversions and comparisons stay in, with the registers in one of them.
pub(super) const NEAR_WITH_COMPARISONS: usize = 7;

/// What yosys calls the bit of a port that it mutates, before it is mutated.
const MUTATED_BIT: &str = "gate/w:*$auto$mutate.cc:*";

/// In yosys' words, the next registers behind what is selected.
const NEXT: &str = " %co*:-$dff %co2:+$dff[D,Q]";

/// Registers that have a reset tell the time: phases, pointers, counts.
const CONTROL: &str = "select -set control */w:one_reset */w:first_cycle.first %u %co2:+$mux[S,Y] %co2:+$dff[D,Q]\n";

/// Writes down the memories of which the fault may have a say in where, or when, is read or written: no buffer goes round in one version
/// and not in the other.
const BUFFERS_OF_THE_FAULT: &str = "select -write kept */c:*planted_fault_* %co* */w:* %i \
    %co1:+$mem_v2[RD_ADDR,WR_ADDR,WR_EN] */t:$mem_v2 %i\n";

/// Makes shift registers of circular buffers, but for those.
const BUFFERS: &str = "select -set kept -read kept\n\
    techmap -autoproc -map delays.v */t:$mem_v2 */c:*delay_*_from_* %i @kept %d\n";

/// Has both versions show their registers but for these and those that are marked as near.
const SHOWN: &str = "expose -cut -dff -shared */w:* */w:first_cycle.* %d @control %d */a:near %d\n";

/// Lists the outputs that see what is near, or an operator's answer, one of `answers`: all others depend on the same in both.
pub(super) fn reached(answers: &[String]) -> String {
    let answers: String = answers.iter().map(|answer| format!(" gate/i:{answer} %u")).collect();
    format!("tee -q -o reached select -list gate/a:near{answers} %co* gate/o:* %i\n")
}

/// What a way has yosys do with the mutant.
#[derive(Default)]
pub(super) struct Marks {
    /// Before and after what is open is turned round, where near registers are marked: what operators answer is near what they are
    /// given where that may differ.
    pub before: String,
    pub after: String,
    /// With both versions.
    pub shown: String,
}

impl Way<'_> {
    /// What is marked as near, and shown.
    pub fn marks(self) -> Marks {
        let Self::Around(around) = self else { return Marks::default() };
        let shown = format!("{CONTROL}{SHOWN}{}", reached(&[]));
        match around.operators {
            Operators::Strict => Marks { after: around.mark(), shown, ..Marks::default() },
            Operators::Tolerant => Marks { before: around.mark(), shown, ..Marks::default() },
        }
    }
}

impl Around<'_> {
    /// Marks what is near. Where nothing looks at the fault, that may be nothing.
    fn mark(self) -> String {
        let Self { cell, near, begins_set, .. } = self;
        let cell = cell.map(|cell| format!("gate/c:{cell}"));
        let mut seeds = format!("gate/{FAULT}");
        let mut bit = String::new();
        if let Some(cell) = cell {
            if begins_set {
                bit = format!("setattr -set init 1'b1 {cell} %co:+$dff[Q] {MUTATED_BIT} %i\n");
            }
            seeds += &format!(" {cell} %u");
        }
        format!("{bit}setattr -set near 1 {seeds}{}\n", NEXT.repeat(near))
    }
}
