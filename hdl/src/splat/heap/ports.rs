//! The ports of a stage that are no records.

use pointcore_contract::unit::{Input, Output};

/// The lap of the entry that left last.
pub(super) const LAP: Input<bool> = Input::new("lap", "", "");
/// The epoch of the entry that came last.
pub(super) const LAST_EPOCH: Input<bool> = Input::new("last_epoch", "", "");
/// The lap of the entry that the upmost stage is given, a tick after the entry.
pub(super) const NEWCOMER_LAP: Input<bool> = Input::new("newcomer_lap", "", "");
/// The upmost stage's entry that leaves next.
pub(super) const ROOT: Output<u64> = Output::new("root", "", "");

/// The row that a step from above reads.
pub(super) const STEP_ROW: Input<u32> = Input::new("step_row", "", "");
/// The row that a step reads in the stage below.
pub(super) const BELOW_ROW: Output<u32> = Output::new("below_row", "", "");

/// The node that promotes to the stage above.
pub(super) const PROMOTED_NODE: Output<u32> = Output::new("promoted_node", "", "");
/// The node below that promotes.
pub(super) const BELOW_PROMOTED_NODE: Input<u32> = Input::new("below_promoted_node", "", "");
