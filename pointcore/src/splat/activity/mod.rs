//! What the core did in a frame, cycle by cycle: a timeline of its units, and maps of the image.
//!
//! It is seen from outside, in the streams between the units. The golden model shows all of them; hardware shows its ports alone.

mod maps;
mod states;
mod timeline;

pub use maps::{Map, SampleMaps};
pub use timeline::{State, Timeline, Unit};

use maps::Layout;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::StoredPixel;
use pointcore_golden::splat::Top;
use pointcore_golden::splat::top::{In, Out, Shown};
use pointcore_golden::unit::Model;
use states::States;

/// What the core did in a frame.
#[derive(Clone, Debug)]
pub struct Activity {
    config: Config,
    layout: Layout,
    timeline: Timeline,
    /// By tile: how many of its pixels were written back.
    written_back: Vec<u32>,
    states: States,
    /// Absent where only ports are seen.
    samples: Option<SampleMaps>,
}

impl Activity {
    /// Nothing yet; only what the core's ports tell is going to be seen.
    #[must_use]
    pub fn at_ports(config: &Config) -> Self {
        let layout = Layout::new(config);
        let written_back = layout.zeros_by_tile();
        Self {
            config: config.clone(),
            layout,
            timeline: Timeline::new(config.rasterizers, config.memory_ports),
            written_back,
            states: States::new(config),
            samples: None,
        }
    }

    /// Nothing yet; what passes between the units is going to be seen.
    #[must_use]
    pub fn of_units(config: &Config) -> Self {
        Self { samples: Some(SampleMaps::new(config)), ..Self::at_ports(config) }
    }

    /// Sees a cycle at the core's ports.
    pub fn see_ports(&mut self, inputs: &In, outputs: &Out) {
        outputs.write.iter().zip(inputs.write_ready).for_each(|(write, ready)| self.see_write(write.as_ref(), ready));
        self.timeline.push(&states::at_ports(&self.config, inputs, outputs));
    }

    /// Sees a cycle of all units.
    pub fn see_units(&mut self, inputs: &In, shown: &Shown) {
        for (port, ready) in shown.lanes.at_ports().zip(inputs.write_ready) {
            self.see_write(port.write.as_ref(), ready);
        }
        self.timeline.push(&self.states.see(inputs, shown));
        let Some(samples) = &mut self.samples else { return };
        for (number, lane) in shown.lanes.lanes.iter().enumerate() {
            // Events tell of the cycle before: they come before what is handed over in this one.
            let events = &lane.accumulator.events;
            if events.accumulate {
                samples.accumulated(number);
            } else if events.hazard {
                samples.hazard(number);
            }
            if let Some(copy) = lane.payloads.out.as_ref().filter(|_| lane.rasterizer.in_ready) {
                samples.copy(number, copy);
            }
            if let Some(sample) = lane.weighting.out.as_ref().filter(|_| lane.accumulator.in_ready) {
                samples.sample(number, &sample.place);
            }
        }
    }

    fn see_write(&mut self, write: Option<&StoredPixel>, ready: bool) {
        if let Some(write) = write.filter(|_| ready) {
            self.written_back[write.placed.tile as usize] += 1;
        }
    }

    /// What units did over the run.
    #[must_use]
    pub const fn timeline(&self) -> &Timeline {
        &self.timeline
    }

    /// The units of which it tells.
    #[must_use]
    pub const fn units(&self) -> &'static [Unit] {
        if self.samples.is_some() { &Unit::ALL } else { &Unit::AT_PORTS }
    }

    /// Maps of samples; absent where only ports were seen.
    #[must_use]
    pub const fn samples(&self) -> Option<&SampleMaps> {
        self.samples.as_ref()
    }

    /// How many pixels of each tile were written back to the reconstruction buffer, as an image of tiles.
    #[must_use]
    pub fn written_back(&self) -> Map {
        self.layout.by_tile(&self.written_back)
    }
}

/// A golden model whose units are watched.
#[derive(Clone)]
pub struct Watched {
    top: Top,
    /// What it did so far.
    pub activity: Activity,
}

impl Watched {
    /// The model after reset.
    #[must_use]
    pub fn new(config: &Config, top: Top) -> Self {
        Self { top, activity: Activity::of_units(config) }
    }
}

impl Model for Watched {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        self.top.outputs()
    }

    fn clock(&mut self, inputs: &In) {
        let shown = self.top.shown();
        self.activity.see_units(inputs, &shown);
        self.top.step(inputs, &shown);
    }
}
