//! Frames of the renderer, begun one after the other.

use pointcore_contract::bus::units::FRAMES_MAX;
use pointcore_contract::fields;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{UniformWrite, Uniforms, late_uniforms};

/// What comes into the unit in a cycle.
#[derive(Clone, Copy, Debug, Default)]
pub struct FramesIn {
    /// A frame is asked for.
    pub start: bool,
    /// A write to a uniform.
    pub write: Option<UniformWrite>,
    /// The frame that began last is set up.
    pub set_up: bool,
    /// A frame has left.
    pub sent: bool,
}

/// Begins frames, each with the uniforms that were written before its start, cycle by cycle. A frame begins when all splats of the
/// one before are set up; where one was changed that is read until a frame has left, when all have.
#[derive(Clone, Debug)]
pub struct Frames {
    /// The uniforms as they were written last.
    values: Vec<u32>,
    /// The places among them of those that are read late, and their bits.
    late: Vec<(usize, u32)>,
    late_changes: bool,
    waiting: bool,
    setting_up: bool,
    under_way: u32,
    /// The uniform that is copied in this cycle.
    copied: Option<usize>,
    uniform: Option<UniformWrite>,
    begun: bool,
}

impl Frames {
    /// The unit after reset; uniforms are zero.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let uniforms = fields::<Uniforms>(config);
        let late = |place: usize| (place, u32::MAX >> (u32::BITS - uniforms[place].width));
        Self {
            values: vec![0; uniforms.len()],
            late: late_uniforms(config).into_iter().map(late).collect(),
            late_changes: false,
            waiting: false,
            setting_up: false,
            under_way: 0,
            copied: None,
            uniform: None,
            begun: false,
        }
    }

    /// The uniform that the core is told.
    #[must_use]
    pub const fn uniform(&self) -> Option<UniformWrite> {
        self.uniform
    }

    /// Whether a frame's uniforms are written, so that its splats may come.
    #[must_use]
    pub const fn begun(&self) -> bool {
        self.begun
    }

    /// Whether no frame is asked for or under way.
    #[must_use]
    pub const fn idle(&self) -> bool {
        !self.waiting && self.under_way == 0
    }

    /// A cycle.
    pub fn clock(&mut self, inputs: FramesIn) {
        let may_begin = !self.setting_up && self.under_way < FRAMES_MAX;
        let begins = self.waiting && may_begin && (self.under_way == 0 || !self.late_changes);
        let ends = self.copied == Some(self.values.len() - 1);
        self.uniform = self.copied.map(|place| UniformWrite { address: place as u8, data: self.values[place] });
        self.begun = ends;
        self.copied = if begins { Some(0) } else { self.copied.filter(|_| !ends).map(|place| place + 1) };
        self.waiting = inputs.start || (self.waiting && !ends);
        self.setting_up = begins || (self.setting_up && !inputs.set_up);
        self.under_way = self.under_way + u32::from(begins) - u32::from(inputs.sent);
        self.late_changes &= !begins;
        // Where there is no uniform, nothing is written.
        if let Some(UniformWrite { address, data }) = inputs.write
            && let Some(value) = self.values.get_mut(usize::from(address))
        {
            let changed = |&(place, mask): &(usize, u32)| place == usize::from(address) && (*value ^ data) & mask != 0;
            self.late_changes |= self.late.iter().any(changed);
            *value = data;
        }
    }
}
