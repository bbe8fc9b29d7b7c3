//! Accumulates samples in the pixels of the tile slots (thesis 5.5.3, eq. 5.8 to 5.12), one a cycle unless an earlier
//! sample of the same pixel is on its way; golden twin: `pointcore_golden::splat::accumulator`.
//!
//! A sample reads its pixel in its slot's memory when it issues and chooses among the slots' registers in stage 2: in one cycle a
//! block RAM only gets as far as a register. It writes the pixel from stage `accumulate_stages + 1`.

mod blend;

use pointcore_contract::splat::config::{SAMPLE_QUEUE_DEPTH, TILE_PIXELS};
use pointcore_contract::splat::ports::EVENTS;
use pointcore_contract::splat::records::PIXEL_BITS;
use pointcore_contract::splat::{Config, Field, records};

use crate::stream::{fifo, fifo_distributed};
use crate::units::records::{Head, Record, layout, stream_in, width};
use blend::blend;
use rtl::{Expr, Module, Reg, Stream, bit, cat};

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
    fn enter(&self, m: &mut Module, head: &Head, issue: &Issue) {
        m.next(self.valid, issue.sample);
        m.next(self.inside, issue.inside);
        for (register, name) in [(&self.last, "last"), (&self.slot, "slot"), (&self.pixel, "pixel")] {
            m.next(*register, head.record.get(name));
        }
    }

    /// Takes what the stage before holds.
    fn follow(&self, m: &mut Module, before: &Self) {
        let registers =
            |stage: &Self| [&stage.valid, &stage.inside, &stage.last, &stage.slot, &stage.pixel].map(Reg::clone);
        for (register, value) in registers(self).iter().zip(registers(before)) {
            m.next(*register, value);
        }
    }
}

/// A bit for each stage that holds an inside sample of the head's pixel, known without comparing in the cycle in which the head
/// issues or waits: compared when the sample came in, shifted as the stages move.
fn collisions(m: &mut Module, head: &Head, stages: &[Stage]) -> Expr {
    let place = |record: &Record| cat([record.get("slot"), record.get("pixel")]);
    let arriving = place(&head.arriving);
    let inside = head.valid & (head.record.get("inside") & !head.record.get("end"));
    // Bit i: what will be in stage i + 1 in the next cycle.
    let mut collide = vec![inside & arriving.eq(place(&head.record))];
    let moving = &stages[..stages.len() - 1];
    collide.extend(moving.iter().map(|stage| stage.inside & arriving.eq(cat([stage.slot, stage.pixel]))));
    let collide = cat(collide.iter().rev().copied());
    let collisions = m.reg("collisions", stages.len() as u32);
    // A head that stays sees the others move on, and none follow.
    m.next(collisions, head.takes.mux(collide, collisions << 1));
    collisions.expr()
}

/// What becomes of the sample at the head.
struct Issue {
    /// A sample enters stage 1.
    sample: Expr,
    /// It lies inside its splat.
    inside: Expr,
    end: Expr,
    hazard: Expr,
    slot_wait: Expr,
}

impl Issue {
    fn new(m: &mut Module, head: &Head, slot_ready: Expr, stages: &[Stage]) -> Self {
        let on_the_way = collisions(m, head, stages).any();
        let on_the_way = m.wire("on_the_way", on_the_way);
        let occupied = stages.iter().fold(bit(false), |any, stage| any | stage.valid);
        // Chosen a cycle before it is asked for: what the head's going depends on reaches as far as the queue's memories.
        let arrived = m.reg("arrived", 1);
        let is_ready = |record: &Record| slot_ready.shr_by(record.get("slot")).bit(0);
        m.next(arrived, head.takes.mux(is_ready(&head.arriving), is_ready(&head.record)));

        let end = head.valid & head.record.get("end");
        let sample = head.valid & !head.record.get("end");
        let inside = m.wire("may_issue_inside", sample & head.record.get("inside"));
        let slot_wait = m.wire("slot_wait", inside & !arrived);
        let hazard = m.wire("hazard", inside & (arrived & on_the_way));
        let inside = m.wire("issue_inside", inside & (arrived & !on_the_way));
        let sample = m.wire("issue", sample & !(slot_wait | hazard));
        let end = m.wire("issue_end", end & !occupied);
        Self { sample, inside, end, hazard, slot_wait }
    }
}

/// What decides when and where a sample issues.
const PLACE: [&str; 5] = ["end", "last", "inside", "slot", "pixel"];

/// The queue of samples: two that move together, as what decides comes out of flip-flops and the rest out of block memory.
fn queue(m: &mut Module, input: &Stream, fields: &[Field]) -> Stream {
    let (place, rest): (Vec<_>, Vec<_>) = fields.iter().cloned().partition(|(name, _)| PLACE.contains(&name.as_str()));
    let depth = SAMPLE_QUEUE_DEPTH;
    let places = m.instance("places", fifo_distributed(depth, &layout(&place)));
    let samples = m.instance("samples", fifo(depth, &layout(&rest)));
    for (queue, fields) in [(&places, &place), (&samples, &rest)] {
        m.connect(*queue, "in_valid", input.valid);
        fields.iter().for_each(|(name, _)| m.connect(*queue, &format!("in_{name}"), input.field(name)));
    }
    let has_room = m.out(places, "in_ready");
    m.ready(input, has_room);
    let [places, samples] = [&places, &samples].map(|queue| m.stream_from(*queue, "out"));
    m.assert("queues_move_together", places.valid.eq(samples.valid));
    let ready = m.forward("queue_ready", 1);
    m.ready(&places, ready);
    m.ready(&samples, ready);
    let fields = places.fields.into_iter().chain(samples.fields).collect();
    Stream { valid: places.valid, fields, ready }
}

/// The ports through which the tile cache reaches the slots.
struct SlotPorts {
    ready: Expr,
    fill_valid: Expr,
    fill_slot: Expr,
    fill_pixel: Expr,
    fill: Expr,
    drain_enable: Expr,
    drain_slot: Expr,
    drain_pixel: Expr,
}

/// Accesses of the samples to the slots.
struct Accesses {
    read: Expr,
    read_slot: Expr,
    read_pixel: Expr,
    write: Expr,
    write_slot: Expr,
    write_pixel: Expr,
    result: Expr,
}

/// A memory for each slot, read and written by samples when it is ready and by the tile cache when it is not; returns
/// the register behind each: what was read a cycle ago, or before the tile cache's last read.
fn slots(m: &mut Module, config: &Config, ports: &SlotPorts, accesses: &Accesses) -> Vec<Expr> {
    let pixel_bits = width(&records::pixel(config));
    let mut slot = |number: u32| {
        let is = |slot: Expr| slot.eq_lit(number.into());
        let memory = m.memory_unordered(&format!("slot_{number}_pixels"), TILE_PIXELS, pixel_bits);
        let filling = m.wire(&format!("filling_{number}"), ports.fill_valid & is(ports.fill_slot));
        let write = filling | (accesses.write & is(accesses.write_slot));
        let address = filling.mux(ports.fill_pixel, accesses.write_pixel);
        m.write(memory, write, address, filling.mux(ports.fill, accesses.result));

        let ready = ports.ready.bit(number);
        let read = accesses.read & is(accesses.read_slot);
        let drain = ports.drain_enable & is(ports.drain_slot);
        let address = ready.mux(accesses.read_pixel, ports.drain_pixel);
        let read = m.read_if(memory, &format!("slot_{number}_read"), ready.mux(read, drain), address);
        let register = m.reg(&format!("slot_{number}_pixel"), pixel_bits);
        m.next_if(register, ready | drain, read);
        register.expr()
    };
    (0..config.tile_slots).map(&mut slot).collect()
}

/// The unit; ports as in `contract::splat::ports::accumulator`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let slot_bits = config.slot_bits();
    let (sample_fields, pixel_fields) = (records::weighted_sample(config), records::pixel(config));
    let mut m = Module::new("splat_accumulator", "Blends samples into the pixels of the tile slots.");
    m.parameter("slots", config.tile_slots);
    m.parameter("stages", config.accumulate_stages);
    let input = stream_in(&mut m, "in", &sample_fields);
    let queued = queue(&mut m, &input, &sample_fields);

    let ready = m.input("slot_ready", config.tile_slots);
    let retire_valid = m.reg_reset("retire_valid", 1, 0);
    let retire_slot = m.reg("retire_slot", slot_bits);
    let frame_end = m.reg_reset("frame_end", 1, 0);
    m.pulse_out("retire", "valid", retire_valid, [("slot", retire_slot)]);
    m.output("frame_end", frame_end);
    let place = [("slot".to_owned(), slot_bits), ("pixel".to_owned(), PIXEL_BITS)];
    let (fill_valid, fill) = m.pulse_in("fill", "valid", &[place.as_slice(), &pixel_fields].concat());
    let (drain_enable, drain) = m.pulse_in("drain", "enable", &place);
    let ports = SlotPorts {
        ready,
        fill_valid,
        fill_slot: fill[0],
        fill_pixel: fill[1],
        fill: cat(fill[2..].iter().copied()),
        drain_enable,
        drain_slot: drain[0],
        drain_pixel: drain[1],
    };

    let stages: Vec<_> = (1..=config.accumulate_stages + 1).map(|number| Stage::new(&mut m, config, number)).collect();
    let head = Head::new(&mut m, &queued);
    let issue = Issue::new(&mut m, &head, ports.ready, &stages);
    head.leaves(&mut m, issue.sample | issue.end);
    m.next(frame_end, issue.end);
    stages[0].enter(&mut m, &head, &issue);
    for pair in stages.windows(2) {
        pair[1].follow(&mut m, &pair[0]);
    }
    let last_stage = &stages[stages.len() - 1];
    m.next(retire_valid, last_stage.valid & last_stage.last);
    m.next(retire_slot, last_stage.slot);

    let result = m.forward("result", width(&pixel_fields));
    let writes = m.forward("writes", 1);
    let accesses = Accesses {
        read: issue.inside,
        read_slot: head.record.get("slot"),
        read_pixel: head.record.get("pixel"),
        write: *writes,
        write_slot: *last_stage.slot,
        write_pixel: *last_stage.pixel,
        result: *result,
    };
    let read = slots(&mut m, config, &ports, &accesses);
    let stored = m.reg("stored", width(&pixel_fields));
    m.next(stored, stages[1].slot.pick(read.iter().copied()));
    let drained_slot = m.reg("drained_slot", slot_bits);
    m.next_if(drained_slot, ports.drain_enable, ports.drain_slot);
    let drained = m.wire("drained", drained_slot.pick(read));
    Record::unpack(&pixel_fields, drained).output(&mut m, "drain_");

    let carried: Vec<_> = sample_fields.into_iter().filter(|(name, _)| !PLACE.contains(&name.as_str())).collect();
    let sample = head.record.only(&carried).register(&mut m, "sample_1_", bit(true));
    let sample = sample.register(&mut m, "sample_2_", bit(true));
    let sample = sample.register(&mut m, "sample_3_", bit(true));
    let blend = blend(&mut m, config, &sample, &Record::unpack(&pixel_fields, stored));
    m.drive(writes, last_stage.inside & blend.writes);
    m.drive(result, blend.pixel.pack());

    let events = [issue.inside, issue.hazard, issue.slot_wait];
    for (name, event) in EVENTS[3..].iter().zip(events) {
        let register = m.reg_reset(name, 1, 0);
        m.next(register, event);
        m.output(name, register);
    }
    m
}
