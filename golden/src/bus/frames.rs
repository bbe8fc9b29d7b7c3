//! Frames of the renderer, begun one after the other.

use pointcore_contract::bus::units::FRAMES_MAX;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{UniformWrite, Uniforms};
use pointcore_contract::{fields, places};

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
/// one before are set up; where the screen filter's scale was changed, which samples are weighted by, when all frames have left.
#[derive(Clone, Debug)]
pub struct Frames {
    /// The uniforms as they were written last.
    values: Vec<u32>,
    /// The place of `filter_scale` among them, and its bits.
    filter: Option<(usize, u32)>,
    filter_changes: bool,
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
        let mask = u32::MAX >> (u32::BITS - config.filter_scale_format().width());
        Self {
            values: vec![0; fields::<Uniforms>(config).len()],
            filter: places::<Uniforms>(config).filter_scale.map(|place| (place, mask)),
            filter_changes: false,
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
        let begins = self.waiting && may_begin && (self.under_way == 0 || !self.filter_changes);
        let ends = self.copied == Some(self.values.len() - 1);
        self.uniform = self.copied.map(|place| UniformWrite { address: place as u8, data: self.values[place] });
        self.begun = ends;
        self.copied = if begins { Some(0) } else { self.copied.filter(|_| !ends).map(|place| place + 1) };
        self.waiting = inputs.start || (self.waiting && !ends);
        self.setting_up = begins || (self.setting_up && !inputs.set_up);
        self.under_way = self.under_way + u32::from(begins) - u32::from(inputs.sent);
        self.filter_changes &= !begins;
        if let Some(UniformWrite { address, data }) = inputs.write {
            let value = &mut self.values[usize::from(address)];
            let changed = |(place, mask)| place == usize::from(address) && (*value ^ data) & mask != 0;
            self.filter_changes |= self.filter.is_some_and(changed);
            *value = data;
        }
    }
}
