//! Records as beats: which bits of which beat hold which field.

use pointcore_contract::bus::Layout;
use pointcore_contract::{Field, Record, fields, record};

use crate::units::ports::held;
use rtl::{Expr, Module, Reg, cat, lit};

/// A beat on its way.
#[record(bits: u32)]
pub(crate) struct Beat {
    /// Its bits.
    #[bits(*bits)]
    pub data: u64,
    /// Closes its burst or packet.
    pub last: bool,
}

/// Bits of a field that one beat holds.
#[derive(Clone)]
pub(crate) struct Part {
    /// The field's number in its record.
    field: usize,
    /// The beat.
    beat: u32,
    /// First bit within the beat.
    low: u32,
    /// Its bits.
    width: u32,
}

/// A record over beats of so many bits.
#[derive(Clone)]
pub(crate) struct Beats {
    fields: Vec<Field>,
    parts: Vec<Part>,
    beat_bits: u32,
    /// How many beats there are.
    pub count: u32,
    /// Bits of a beat that hold something in some beat: first and width of each run of them.
    used: Vec<(u32, u32)>,
}

impl Beats {
    /// A record padded to whole beats.
    pub fn packet<R: Record>(config: &R::Config, beat_bits: u32) -> Self {
        let layout = Layout::record::<R>(config);
        Self::new(fields::<R>(config), &layout, beat_bits, layout.beats(beat_bits))
    }

    /// A record padded to its stride in memory.
    pub fn memory<R: Record>(config: &R::Config, beat_bits: u32) -> Self {
        let layout = Layout::record::<R>(config);
        Self::new(fields::<R>(config), &layout, beat_bits, layout.stride(beat_bits) / (beat_bits / 8))
    }

    fn new(fields: Vec<Field>, layout: &Layout, beat_bits: u32, count: u32) -> Self {
        let mut parts = vec![];
        for (field, place) in layout.places.iter().enumerate() {
            let end = place.bit() + place.width;
            let mut bit = place.bit();
            while bit < end {
                let next = (bit + 1).next_multiple_of(beat_bits).min(end);
                let (beat, low) = (bit / beat_bits, bit % beat_bits);
                parts.push(Part { field, beat, low, width: next - bit });
                bit = next;
            }
        }
        let is_used = |bit: u32| parts.iter().any(|part| (part.low..part.low + part.width).contains(&bit));
        let mut used: Vec<(u32, u32)> = vec![];
        for bit in (0..beat_bits).filter(|&bit| is_used(bit)) {
            match used.last_mut() {
                Some((low, width)) if *low + *width == bit => *width += 1,
                _ => used.push((bit, 1)),
            }
        }
        Self { fields, parts, beat_bits, count, used }
    }

    /// Bits of a beat.
    pub const fn beat_bits(&self) -> u32 {
        self.beat_bits
    }

    /// Bits that number the beats, none for a single one.
    pub const fn place_bits(&self) -> u32 {
        if self.count == 1 { 0 } else { u32::BITS - (self.count - 1).leading_zeros() }
    }

    /// Bits of a beat without those that never hold anything.
    pub fn used_bits(&self) -> u32 {
        self.used.iter().map(|(_, width)| width).sum()
    }

    /// A beat without the bits that never hold anything.
    pub fn squeeze(&self, beat: Expr) -> Expr {
        cat(self.used.iter().rev().map(|(low, width)| beat.bits(low + width - 1, *low)))
    }

    /// A part's bits of a squeezed beat.
    fn part_of(&self, squeezed: Expr, part: &Part) -> Expr {
        let mut at = 0;
        for &(low, width) in &self.used {
            if (low..low + width).contains(&part.low) {
                at += part.low - low;
                break;
            }
            at += width;
        }
        squeezed.bits(at + part.width - 1, at)
    }

    /// The bits of the field at a place, in a beat that holds it whole, and that beat's number.
    pub fn field_in(&self, field: usize, beat: Expr) -> (u32, Expr) {
        let part = self.parts.iter().find(|part| part.field == field).expect("every field has a part");
        (part.beat, beat.bits(part.low + part.width - 1, part.low))
    }

    /// Registers that gather a record from squeezed beats, each where `enable` is set and `place` says that it comes; returns
    /// what its fields hold.
    pub fn gather(&self, m: &mut Module, squeezed: Expr, place: Option<Expr>, enable: Expr) -> Vec<Expr> {
        let enables: Vec<Expr> = (0..self.count)
            .map(|beat| match place {
                Some(place) => m.wire(&format!("takes_beat_{beat}"), enable & place.eq_lit(beat.into())),
                None => enable,
            })
            .collect();
        let mut registers: Vec<Vec<Reg>> = self.fields.iter().map(|_| vec![]).collect();
        for part in &self.parts {
            let gathered = &mut registers[part.field];
            let name = format!("held_{}_{}", self.fields[part.field].name, gathered.len());
            let register = m.reg(&name, part.width);
            m.next_if(register, enables[part.beat as usize], self.part_of(squeezed, part));
            gathered.push(register);
        }
        registers.iter().map(|parts| cat(parts.iter().rev().copied())).collect()
    }

    /// Registers that take what a record's fields hold where `enable` is set.
    pub fn hold(&self, m: &mut Module, values: &[Expr], enable: Expr) -> Vec<Expr> {
        let fields = self.fields.iter().zip(values);
        fields.map(|(field, value)| held(m, &format!("held_{}", field.name), enable, *value)).collect()
    }

    /// The beats of a record whose fields hold these values, first to last, padding zero.
    pub fn spread(&self, values: &[Expr]) -> Vec<Expr> {
        let mut done = vec![0; self.fields.len()];
        let mut beats: Vec<(Vec<Expr>, u32)> = (0..self.count).map(|_| (vec![], 0)).collect();
        for part in &self.parts {
            let value = values[part.field];
            let low = done[part.field];
            done[part.field] += part.width;
            let (pieces, end) = &mut beats[part.beat as usize];
            if part.low > *end {
                pieces.push(lit(part.low - *end, 0));
            }
            pieces.push(value.bits(low + part.width - 1, low));
            *end = part.low + part.width;
        }
        let word = |(mut pieces, end): (Vec<Expr>, u32)| {
            if end < self.beat_bits {
                pieces.push(lit(self.beat_bits - end, 0));
            }
            cat(pieces.into_iter().rev())
        };
        beats.into_iter().map(word).collect()
    }
}
