//! Accumulates samples in the pixels of the tile slots (thesis 5.5.3, eq. 5.8 to 5.12), one a cycle unless an earlier
//! sample of the same pixel is on its way; golden twin: `pointcore_golden::core_a::accumulator`.
//!
//! A sample reads its pixel when it issues, has it in stage 1, and writes it from stage `accumulate_stages + 1`.

use pointcore_spec::core_a::config::{SAMPLE_QUEUE_DEPTH, TILE_PIXELS, WEIGHT_SUM_BITS};
use pointcore_spec::core_a::ports::EVENTS;
use pointcore_spec::core_a::records::PIXEL_BITS;
use pointcore_spec::core_a::{Config, records};

use super::depth_test;
use crate::float::add;
use crate::rtl::{Expr, Module, Reg, Stream, bit, select};
use crate::stream::fifo;
use crate::units::records::{Record, layout, stream_in, width};

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
            slot: m.reg(&format!("slot_{number}"), config.slot_bits() as usize),
            pixel: m.reg(&format!("pixel_{number}"), PIXEL_BITS as usize),
        }
    }

    /// Takes a sample that issues.
    fn enter(&self, m: &mut Module, head: &Stream, issue: &Issue) {
        m.next(&self.valid, &issue.sample);
        m.next(&self.inside, &issue.inside);
        for (register, name) in [(&self.last, "last"), (&self.slot, "slot"), (&self.pixel, "pixel")] {
            m.next(register, &head.field(name));
        }
    }

    /// Takes what the stage before holds.
    fn follow(&self, m: &mut Module, before: &Self) {
        let registers =
            |stage: &Self| [&stage.valid, &stage.inside, &stage.last, &stage.slot, &stage.pixel].map(Reg::clone);
        for (register, value) in registers(self).iter().zip(registers(before)) {
            m.next(register, &value);
        }
    }
}

/// What becomes of the sample at the head of the queue.
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
    fn new(m: &mut Module, head: &Stream, slot_ready: &Expr, stages: &[Stage]) -> Self {
        let (slot, pixel) = (head.field("slot"), head.field("pixel"));
        let on_the_way = stages
            .iter()
            .fold(bit(false), |any, stage| any | (&stage.inside & (stage.slot.eq(&slot) & stage.pixel.eq(&pixel))));
        let on_the_way = m.wire("on_the_way", &on_the_way);
        let occupied = stages.iter().fold(bit(false), |any, stage| any | &stage.valid);
        let arrived = m.wire("arrived", &slot_ready.shr_by(&slot).bit(0));

        let end = &head.valid & head.field("end");
        let sample = &head.valid & !head.field("end");
        let inside = m.wire("head_inside", &(&sample & head.field("inside")));
        let slot_wait = m.wire("slot_wait", &(&inside & !&arrived));
        let hazard = m.wire("hazard", &(&inside & (&arrived & &on_the_way)));
        let inside = m.wire("issue_inside", &(&inside & (&arrived & !&on_the_way)));
        let sample = m.wire("issue", &(&sample & !(&slot_wait | &hazard)));
        let end = m.wire("issue_end", &(&end & !occupied));
        Self { sample, inside, end, hazard, slot_wait }
    }
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
struct Accesses<'a> {
    read: &'a Expr,
    read_slot: &'a Expr,
    read_pixel: &'a Expr,
    write: &'a Expr,
    write_slot: &'a Expr,
    write_pixel: &'a Expr,
    result: &'a Expr,
}

/// A memory for each slot, read and written by samples when it is ready and by the tile cache when it is not; returns
/// the pixel that each has read last.
fn slots(m: &mut Module, config: &Config, ports: &SlotPorts, accesses: &Accesses<'_>) -> Vec<Expr> {
    let pixel_bits = width(&records::pixel(config));
    let mut slot = |number: u32| {
        let is = |slot: &Expr| slot.eq_lit(number.into());
        let memory = m.memory(&format!("slot_{number}_pixels"), TILE_PIXELS as usize, pixel_bits);
        let filling = m.wire(&format!("filling_{number}"), &(&ports.fill_valid & is(&ports.fill_slot)));
        let write = &filling | (accesses.write & is(accesses.write_slot));
        let address = filling.mux(&ports.fill_pixel, accesses.write_pixel);
        m.write(&memory, &write, &address, &filling.mux(&ports.fill, accesses.result));

        let ready = ports.ready.bit(number as usize);
        let read = accesses.read & is(accesses.read_slot);
        let drain = &ports.drain_enable & is(&ports.drain_slot);
        let address = ready.mux(accesses.read_pixel, &ports.drain_pixel);
        m.read_if(&memory, &format!("slot_{number}_read"), &ready.mux(&read, &drain), &address)
    };
    (0..config.tile_slots).map(&mut slot).collect()
}

/// A value from stage 1 as it is in stage `1 + count`.
fn delay(m: &mut Module, name: &str, value: &Expr, count: u32) -> Expr {
    (0..count).fold(value.clone(), |value, index| {
        let register = m.reg(&format!("{name}_{}", index + 2), value.width());
        m.next(&register, &value);
        register.expr()
    })
}

/// The pixel that a sample leaves behind, in the last stage.
struct Blend {
    /// The sample changes the pixel.
    writes: Expr,
    pixel: Record,
}

/// Compares and adds: `sample` and `stored` are those of stage 1.
fn blend(m: &mut Module, config: &Config, sample: &Record, stored: &Record) -> Blend {
    let cycles = config.accumulate_stages;
    let test = m.instance("depth_test", depth_test::module(config));
    m.connect(&test, "weight", &stored.get("weight"));
    m.connect(&test, "depth", &stored.get("depth"));
    for name in ["depth_low", "depth_high"] {
        m.connect(&test, name, &sample.get(name));
    }
    let [fail, pass] = ["fail", "pass"].map(|name| {
        let outcome = m.out(&test, name);
        delay(m, &format!("late_{name}"), &outcome, cycles - depth_test::LATENCY)
    });

    let weight_bits = WEIGHT_SUM_BITS as usize;
    let weight = sample.get("weight");
    let weight_sum = stored.get("weight").add_carry(&weight.zext(weight_bits));
    let weight_sum = delay(m, "weight_sum", &weight_sum, cycles);
    let late_weight = delay(m, "weight", &weight, cycles);
    let weighted_depth = sample.get("weighted_depth");
    let depth_sum = stored.get("depth") + weighted_depth.zext(stored.get("depth").width());
    let depth_sum = delay(m, "depth_sum", &depth_sum, cycles);
    let late_depth = delay(m, "depth", &weighted_depth, cycles);
    let stronger = match config.cardinal {
        0 => pass.clone(),
        _ => {
            let stronger = delay(m, "stronger", &stored.get("peak").lt(&weight), cycles);
            m.wire("selected", &(&pass | &stronger))
        }
    };

    let adder = add::module(config.attribute, cycles);
    let pixel = Record::new(&records::pixel(config), |name| match name {
        "weight" => pass.mux(&late_weight.zext(weight_bits), &weight_sum.trunc(weight_bits)),
        "depth" => pass.mux(&late_depth.zext(depth_sum.width()), &depth_sum),
        "peak" => {
            let late_peak = delay(m, "peak", &stored.get("peak"), cycles);
            stronger.mux(&late_weight, &late_peak)
        }
        attribute => {
            let late = delay(m, attribute, &sample.get(attribute), cycles);
            if attribute.starts_with("cardinal") {
                let late_stored = delay(m, &format!("stored_{attribute}"), &stored.get(attribute), cycles);
                return stronger.mux(&late, &late_stored);
            }
            let add = m.instance(&format!("add_{attribute}"), adder.module.clone());
            m.connect(&add, "enable", &bit(true));
            m.connect(&add, "a", &stored.get(attribute));
            m.connect(&add, "b", &sample.get(attribute));
            let sum = m.out(&add, "y");
            let sum = delay(m, &format!("sum_of_{attribute}"), &sum, cycles - adder.latency);
            pass.mux(&late, &sum)
        }
    });
    let overflows = weight_sum.msb();
    Blend { writes: !fail & (&pass | !overflows), pixel }
}

/// The unit; ports as in `spec::core_a::ports::accumulator`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let slot_bits = config.slot_bits() as usize;
    let (sample_fields, pixel_fields) = (records::weighted_sample(config), records::pixel(config));
    let mut m = Module::new("core_a_accumulator", "Blends samples into the pixels of the tile slots.");
    m.parameter("slots", config.tile_slots);
    m.parameter("stages", config.accumulate_stages);
    let input = stream_in(&mut m, "in", &sample_fields);
    let queue = m.instance("samples", fifo(SAMPLE_QUEUE_DEPTH as usize, &layout(&sample_fields)));
    m.stream_into(&queue, "in", &input);
    let head = m.stream_from(&queue, "out");

    let ready = m.input("slot_ready", config.tile_slots as usize);
    let retire_valid = m.reg_reset("retire_valid", 1, 0);
    let retire_slot = m.reg("retire_slot", slot_bits);
    let frame_end = m.reg_reset("frame_end", 1, 0);
    m.output("retire_valid", &retire_valid);
    m.output("retire_slot", &retire_slot);
    m.output("frame_end", &frame_end);
    let ports = SlotPorts {
        ready,
        fill_valid: m.input("fill_valid", 1),
        fill_slot: m.input("fill_slot", slot_bits),
        fill_pixel: m.input("fill_pixel", PIXEL_BITS as usize),
        fill: Record::input(&mut m, "fill_", &pixel_fields).pack(),
        drain_enable: m.input("drain_enable", 1),
        drain_slot: m.input("drain_slot", slot_bits),
        drain_pixel: m.input("drain_pixel", PIXEL_BITS as usize),
    };

    let stages: Vec<_> = (1..=config.accumulate_stages + 1).map(|number| Stage::new(&mut m, config, number)).collect();
    let issue = Issue::new(&mut m, &head, &ports.ready, &stages);
    m.ready(&head, &(&issue.sample | &issue.end));
    m.next(&frame_end, &issue.end);
    stages[0].enter(&mut m, &head, &issue);
    for pair in stages.windows(2) {
        pair[1].follow(&mut m, &pair[0]);
    }
    let last_stage = &stages[stages.len() - 1];
    m.next(&retire_valid, &(&last_stage.valid & &last_stage.last));
    m.next(&retire_slot, &last_stage.slot);

    let result = m.forward("result", width(&pixel_fields));
    let writes = m.forward("writes", 1);
    let accesses = Accesses {
        read: &issue.inside,
        read_slot: &head.field("slot"),
        read_pixel: &head.field("pixel"),
        write: &writes,
        write_slot: &last_stage.slot,
        write_pixel: &last_stage.pixel,
        result: &result,
    };
    let read = slots(&mut m, config, &ports, &accesses);
    let read: Vec<_> = read.iter().collect();
    let stored = m.wire("stored", &select(&stages[0].slot, &read));
    let drained_slot = m.reg("drained_slot", slot_bits);
    m.next_if(&drained_slot, &ports.drain_enable, &ports.drain_slot);
    let drained = m.wire("drained", &select(&drained_slot, &read));
    Record::unpack(&pixel_fields, &drained).output(&mut m, "drain_");

    let carried: Vec<_> = sample_fields
        .into_iter()
        .filter(|(name, _)| !["end", "last", "inside", "slot", "pixel"].contains(&name.as_str()))
        .collect();
    let sample = Record::from(&head).only(&carried).register(&mut m, "sample_", &issue.inside);
    let blend = blend(&mut m, config, &sample, &Record::unpack(&pixel_fields, &stored));
    m.drive(&writes, &(&last_stage.inside & blend.writes));
    m.drive(&result, &blend.pixel.pack());

    let events = [&issue.inside, &issue.hazard, &issue.slot_wait];
    for (name, event) in EVENTS[3..].iter().zip(events) {
        let register = m.reg_reset(name, 1, 0);
        m.next(&register, event);
        m.output(name, &register);
    }
    m
}
