//! What a bin of the exposure holds besides its nearest surface (thesis chapter 4): what is hidden joins the rest, and so does what was
//! nearest until something nearer came. What is hidden for all of its time is never seen, and joins nothing.
//!
//! Both sums are made before it is known which of them is wanted, so that the loop is no longer than without.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::WEIGHT_SUM_BITS;
use pointcore_contract::splat::records::{Bin, Pixel, attribute_name};

use super::blend::{Adder, CHOICE, delay};
use super::cover::Cover;
use super::sample::Contribution;
use crate::units::wires::Wires;
use rtl::{Expr, Module};

/// What was found out of a pixel and a sample, in the last stage.
pub(super) struct Outcome {
    /// The pixel hides the sample.
    pub fail: Expr,
    /// The sample hides the pixel.
    pub pass: Expr,
    /// The nearest surface, unless the sample is hidden.
    pub blended: Pixel<Wires>,
}

/// How the rest comes to its new value.
struct Joining {
    cycles: u32,
    /// What was nearest joins it, else the sample.
    pass: Expr,
    /// Either does.
    joins: Expr,
}

impl Joining {
    /// The rest as it was, or with what joins it; the choices are those of the last stage.
    fn choose(&self, m: &mut Module, name: &str, rest: Expr, [of_sample, of_nearest]: [Expr; 2]) -> Expr {
        let before = delay(m, &format!("rest_{name}_before"), rest, self.cycles);
        self.joins.mux(self.pass.mux(of_nearest, of_sample), before)
    }

    /// An integer sum.
    fn sum(&self, m: &mut Module, name: &str, rest: Expr, others: [Expr; 2]) -> Expr {
        let sums =
            of_each(others).map(|(of, other)| delay(m, &format!("rest_{name}_and_{of}"), rest + other, self.cycles));
        self.choose(m, name, rest, sums)
    }
}

/// What may join the rest, by name.
fn of_each<T>([of_sample, of_nearest]: [T; 2]) -> [(&'static str, T); 2] {
    [("sample", of_sample), ("nearest", of_nearest)]
}

/// The pixel with the sample in it or behind it: `sample` and `stored` are those of stage 3.
pub(super) fn pixel(
    m: &mut Module,
    config: &Config,
    sample: &Contribution<Wires>,
    stored: &Pixel<Wires>,
    outcome: Outcome,
) -> Pixel<Wires> {
    let Outcome { fail, pass, blended } = outcome;
    let cycles = config.accumulate_stages - CHOICE;
    let rest = stored.bin;
    let own = Cover::of_sample(m, sample.time);
    let nearest = Cover { span: rest.nearest, parts: rest.nearest_parts };
    let any = Cover { span: rest.any, parts: rest.any_parts };
    let candidates =
        [(sample.weight.zext(WEIGHT_SUM_BITS), own.is_within(nearest)), (stored.weight, nearest.is_within_sample(own))];
    let weights = candidates.map(|(weight, _)| weight);
    let may_join = of_each(candidates).map(|(of, (weight, is_hidden))| {
        let overflows = rest.weight.add_carry(weight).msb();
        delay(m, &format!("rest_may_take_{of}"), !(overflows | is_hidden), cycles)
    });
    let joins = m.wire("joins_rest", (fail & may_join[0]) | (pass & may_join[1]));
    let joining = Joining { cycles, pass, joins };

    let weight = joining.sum(m, "weight", rest.weight, weights);
    let depths = [sample.weighted_depth.zext(stored.depth.width()), stored.depth];
    let depth = joining.sum(m, "depth", rest.depth, depths);
    let mut bin = Bin { weight, depth, ..Bin::default() };
    // The cardinal attributes are those of the larger peak.
    let stronger = (config.cardinal > 0).then(|| {
        let peaks = [sample.weight, stored.peak];
        let largest = of_each(peaks).map(|(of, peak)| {
            let largest = rest.peak.lt(peak).mux(peak, rest.peak);
            delay(m, &format!("rest_peak_with_{of}"), largest, cycles)
        });
        bin.peak = joining.choose(m, "peak", rest.peak, largest);
        let [of_sample, of_nearest] =
            of_each(peaks).map(|(of, peak)| delay(m, &format!("rest_less_than_{of}"), rest.peak.lt(peak), cycles));
        let joins = m.wire("rest_selects", pass.mux(of_nearest, of_sample) & joins);
        Joining { cycles, pass, joins }
    });
    let adder = Adder::new(config.attribute, cycles);
    for place in 0..config.attributes() as usize {
        let name = attribute_name(config, place);
        let (of_rest, others) = (rest.attributes[place], [sample.attributes[place], stored.attributes[place]]);
        bin.attributes[place] = match stronger.as_ref().filter(|_| place >= config.continuous as usize) {
            Some(stronger) => {
                let late = of_each(others).map(|(of, other)| delay(m, &format!("{name}_of_{of}"), other, cycles));
                stronger.choose(m, &name, of_rest, late)
            }
            None => {
                let sums = of_each(others)
                    .map(|(of, other)| adder.sum(m, &format!("rest_{name}_and_{of}"), [of_rest, other], cycles));
                joining.choose(m, &name, of_rest, sums)
            }
        };
    }
    let any = any.with(own).map(|name, seen| delay(m, &format!("any_{name}"), seen, cycles));
    let late = own.map(|name, seen| delay(m, &format!("sample_{name}"), seen, cycles));
    let together = nearest.with(own).map(|name, seen| delay(m, &format!("together_{name}"), seen, cycles));
    let before = nearest.map(|name, seen| delay(m, &format!("nearest_{name}_before"), seen, cycles));
    let seen = |before: Expr, late: Expr, together: Expr| fail.mux(before, pass.mux(late, together));
    bin.any = any.span;
    bin.any_parts = any.parts;
    bin.nearest = [0, 1].map(|end: usize| seen(before.span[end], late.span[end], together.span[end]));
    bin.nearest_parts = seen(before.parts, late.parts, together.parts);

    // What hides the sample stays.
    let mut kept = |name: &str, stored: Expr, new: Expr| {
        let stored = delay(m, &format!("kept_{name}"), stored, cycles);
        fail.mux(stored, new)
    };
    let mut pixel = Pixel {
        weight: kept("weight", stored.weight, blended.weight),
        depth: kept("depth", stored.depth, blended.depth),
        bin,
        ..blended
    };
    if config.cardinal > 0 {
        pixel.peak = kept("peak", stored.peak, blended.peak);
    }
    for place in 0..config.attributes() as usize {
        let name = attribute_name(config, place);
        pixel.attributes[place] = kept(&name, stored.attributes[place], blended.attributes[place]);
    }
    pixel
}
