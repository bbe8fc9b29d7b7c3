//! Accumulates samples in the pixels of the tile slots (thesis 5.5.3, eq. 5.8 to 5.12), one a cycle unless an earlier
//! sample of the same pixel is on its way; golden twin: `pointcore_golden::splat::accumulator`.
//!
//! A sample reads its pixel in its slot's bank when it issues and chooses among the banks' registers in stage 2: in one cycle a
//! block RAM only gets as far as a register. It writes the pixel from stage `accumulate_stages + 1`.

mod behind;
mod blend;
mod cover;
mod sample;
mod slots;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{SAMPLE_QUEUE_DEPTH, SLOT_BANKS, TILE_PIXELS};
use pointcore_contract::splat::records::{PIXEL_BITS, Pixel, Slot, SlotPixel, WeightedSample};
use pointcore_contract::splat::units::AccumulatorEvents;
use pointcore_contract::splat::units::accumulator::PORTS;
use pointcore_contract::width;

use crate::stream::{fifo, fifo_distributed};
use crate::units::ports::{Flow, OutputPorts, PulseOutPorts, StreamInPorts, WordPort};
use crate::units::queue::{Head, Pushed};
use crate::units::wires::{Bundle, Wires, layout};
use blend::blend;
use rtl::{Expr, Module, Reg, bit, cat};
use sample::{Contribution, Place, Queued};
use slots::{Accesses, SlotPorts};

/// What travels with a sample through every stage.
struct Stage {
    valid: Reg,
    inside: Reg,
    last: Reg,
    slot: Reg,
    pixel: Reg,
}

impl Stage {
    fn new(m: &mut Module, config: &Config, number: u32) -> Self {
        Self {
            valid: m.reg_reset(&format!("valid_{number}"), 1, 0),
            inside: m.reg_reset(&format!("inside_{number}"), 1, 0),
            last: m.reg(&format!("last_{number}"), 1),
            slot: m.reg(&format!("slot_{number}"), config.slot_bits()),
            pixel: m.reg(&format!("pixel_{number}"), PIXEL_BITS),
        }
    }

    /// Takes a sample that issues.
    fn enter(&self, m: &mut Module, place: &Place<Wires>, issue: &Issue) {
        m.next(self.valid, issue.sample);
        m.next(self.inside, issue.inside);
        m.next(self.last, place.last);
        m.next(self.slot, place.slot);
        m.next(self.pixel, place.pixel);
    }

    /// Takes what the stage before holds.
    fn follow(&self, m: &mut Module, before: &Self) {
        m.next(self.valid, before.valid);
        m.next(self.inside, before.inside);
        m.next(self.last, before.last);
        m.next(self.slot, before.slot);
        m.next(self.pixel, before.pixel);
    }
}

/// Whether a stage holds an inside sample of the head's pixel, known without comparing in the cycle in which the head issues or waits: a bit
/// for each stage is compared when the sample comes in, and shifted as the stages move.
fn on_the_way(m: &mut Module, head: &Head<Queued<Wires>>, stages: &[Stage]) -> Expr {
    let pixel = |place: Place<Wires>| cat([place.slot, place.pixel]);
    let (place, arriving) = (head.record.place, pixel(head.arriving.place));
    let inside = head.valid & place.inside;
    // Bit i: what will be in stage i + 1 in the next cycle.
    let mut collide = vec![inside & arriving.eq(pixel(place))];
    let moving = &stages[..stages.len() - 1];
    collide.extend(moving.iter().map(|stage| stage.inside & arriving.eq(cat([stage.slot, stage.pixel]))));
    let collide = cat(collide.iter().rev().copied());
    let collisions = m.reg("collisions", stages.len() as u32);
    // A head that stays sees the others move on, and none follow.
    let moved = collisions << 1;
    m.next(collisions, head.takes.mux(collide, moved));
    // Of both before one is chosen: that the head goes is known late.
    let on_the_way = m.reg("on_the_way", 1);
    m.next(on_the_way, head.takes.mux(collide.any(), moved.any()));
    on_the_way.expr()
}

/// What becomes of the sample at the head.
struct Issue {
    /// A sample enters stage 1.
    sample: Expr,
    /// It lies inside its splat.
    inside: Expr,
    /// The head lies inside its splat, and its slot is ready: it issues, or waits for another sample.
    reads: Expr,
    hazard: Expr,
    slot_wait: Expr,
}

impl Issue {
    fn new(m: &mut Module, head: &Head<Queued<Wires>>, slot_ready: Expr, stages: &[Stage]) -> Self {
        let on_the_way = on_the_way(m, head, stages);
        // Chosen a cycle before it is asked for: what the head's going depends on reaches as far as the queue's memories.
        let arrived = m.reg("arrived", 1);
        let place = head.record.place;
        let is_ready = |slot: Expr| slot_ready.shr_by(slot).bit(0);
        m.next(arrived, head.takes.mux(is_ready(head.arriving.place.slot), is_ready(place.slot)));

        let sample = head.valid.expr();
        let inside = m.wire("may_issue_inside", sample & place.inside);
        let slot_wait = m.wire("slot_wait", inside & !arrived);
        let hazard = m.wire("hazard", inside & (arrived & on_the_way));
        let reads = m.wire("reads", inside & arrived);
        let inside = m.wire("issue_inside", inside & (arrived & !on_the_way));
        let sample = m.wire("issue", sample & !(slot_wait | hazard));
        Self { sample, inside, reads, hazard, slot_wait }
    }
}

/// The queue of samples: two that move together, as what decides comes out of flip-flops and the rest out of block memory.
fn queue(m: &mut Module, config: &Config, depth: u32, input: Flow<WeightedSample<Wires>>) -> Flow<Queued<Wires>> {
    let places = fifo_distributed(depth, &layout::<Place>(config));
    let (places, place) = Pushed::<Place>::place(m, config, "places", places);
    let samples = fifo(depth, &layout::<Contribution>(config));
    let (samples, contribution) = Pushed::<Contribution>::place(m, config, "samples", samples);
    let item = Queued::from(input.record);
    m.drive(input.ready, places.room);
    places.push(m, config, input.valid, item.place);
    samples.push(m, config, input.valid, item.contribution);
    m.assert("queues_move_together", place.valid.eq(contribution.valid));
    let ready = m.forward("queue_ready", 1);
    m.drive(place.ready, ready);
    m.drive(contribution.ready, ready);
    let record = Queued { place: place.record, contribution: contribution.record };
    Flow { valid: place.valid, record, ready }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    sized(config, SAMPLE_QUEUE_DEPTH, TILE_PIXELS)
}

/// The unit with a queue for fewer samples, and slots of the first pixels of a tile only, as its proof has it; both are powers of two.
#[must_use]
pub fn sized(config: &Config, queue_depth: u32, pixels: u32) -> Module {
    let mut m = Module::new("splat_accumulator", "Blends samples into the pixels of the tile slots.");
    m.parameter("slots", config.tile_slots);
    m.parameter("banks", SLOT_BANKS);
    m.parameter("stages", config.accumulate_stages);
    let input = PORTS.input.declare(&mut m, config);
    let queued = queue(&mut m, config, queue_depth, input);
    let ready = PORTS.slot_ready.declare_word(&mut m, config.tile_slots);
    let (retires, retired_slot) = (m.reg_reset("retire_valid", 1, 0), m.reg("retire_slot", config.slot_bits()));
    PORTS.retire.drive(&mut m, config, retires, Slot { slot: *retired_slot });
    let ports = SlotPorts::declare(&mut m, config);

    let stages: Vec<_> = (1..=config.accumulate_stages + 1).map(|number| Stage::new(&mut m, config, number)).collect();
    let head = Head::new(&mut m, config, queued);
    let Queued { place, contribution } = head.record;
    let issue = Issue::new(&mut m, &head, ready, &stages);
    head.leaves(&mut m, issue.sample);
    stages[0].enter(&mut m, &place, &issue);
    for pair in stages.windows(2) {
        pair[1].follow(&mut m, &pair[0]);
    }
    let last_stage = &stages[stages.len() - 1];
    m.next(retires, last_stage.valid & last_stage.last);
    m.next(retired_slot, last_stage.slot);

    let pixel_bits = width::<Pixel>(config);
    let result = m.forward("result", pixel_bits);
    let changes = m.forward("changes", 1);
    let next_to_last = &stages[stages.len() - 2];
    let accesses = Accesses {
        reads: issue.reads,
        issues: issue.inside,
        read: SlotPixel { slot: place.slot, pixel: place.pixel },
        comes: *next_to_last.inside,
        coming_pixel: *next_to_last.pixel,
        ends: *last_stage.inside,
        written: SlotPixel { slot: *last_stage.slot, pixel: *last_stage.pixel },
        changes: *changes,
        result: *result,
    };
    let reads = slots::show_precedence(&mut m, &accesses);
    let is_written = slots::masks(&mut m, config, &ports.change, &accesses);
    let banks = slots::banks(&mut m, config, pixels, &ports, &accesses);
    slots::show_drained(&mut m, config, &ports.drain, reads, &banks);
    let stored = m.reg("stored", pixel_bits);
    let read = slots::bank(*stages[1].pixel).pick(banks);
    m.next(stored, is_written.repeat(pixel_bits) & read);

    let stage_3 = ["sample_1_", "sample_2_", "sample_3_"]
        .into_iter()
        .fold(contribution, |sample, name| sample.register(&mut m, config, name, bit(true)));
    let blend = blend(&mut m, config, &stage_3, &Pixel::unpack(config, stored));
    m.drive(changes, blend.writes);
    m.drive(result, blend.pixel.pack(config));
    let Issue { inside: accumulate, hazard, slot_wait, .. } = issue;
    PORTS.events.events(&mut m, config, AccumulatorEvents { accumulate, hazard, slot_wait });
    m
}
