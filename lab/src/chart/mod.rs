//! Charts as SVG, written by hand: points over what they cost, and lines over settings.

pub mod front;
pub mod lines;
mod names;

/// Room around the points, as a share of their range.
const HEADROOM: f64 = 0.06;
/// Lines of the grid, about.
const GRID: f64 = 6.0;

/// Steps of a logarithmic grid within a decade.
const COARSE: &[f64] = &[1.0, 2.0, 5.0];
/// Those where a chart spans less than a decade.
const FINE: &[f64] = &[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0];

/// Text as it stands in HTML and SVG.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Where values lie on one axis.
pub(crate) struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    /// Around some values.
    pub(crate) fn new(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        // A single value gets some room, too.
        let room = ((high - low) * HEADROOM).max(high.abs() * 1e-3).max(1e-6);
        Self { low: low - room, high: high + room, from, to }
    }

    /// Between two values.
    pub(crate) const fn between([low, high]: [f64; 2], from: f64, to: f64) -> Self {
        Self { low, high, from, to }
    }

    /// From zero to some way above the largest value.
    pub(crate) fn from_zero(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let largest = values.fold(0.0, f64::max);
        let high = if largest > 0.0 { largest * (1.0 + HEADROOM) } else { 1.0 };
        Self { low: 0.0, high, from, to }
    }

    /// Where a value is drawn.
    pub(crate) fn place(&self, value: f64) -> f64 {
        self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// Round numbers within.
    pub(crate) fn ticks(&self) -> Vec<f64> {
        let raw = (self.high - self.low) / GRID;
        let magnitude = 10_f64.powf(raw.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * magnitude).into_iter().find(|step| *step >= raw);
        let step = step.unwrap_or(raw);
        let first = (self.low / step).ceil() as i64;
        (first..).map(|index| index as f64 * step).take_while(|tick| *tick <= self.high).collect()
    }

    /// Numbers of one or two digits whose logarithms lie within.
    pub(crate) fn decimal_ticks(&self) -> Vec<f64> {
        let decades = self.low.floor() as i32..=self.high.ceil() as i32;
        let candidates = |steps: &'static [f64]| {
            let all = decades.clone().flat_map(|decade| steps.iter().map(move |step| step * 10_f64.powi(decade)));
            all.filter(|tick| (self.low..=self.high).contains(&tick.log10())).collect::<Vec<_>>()
        };
        let coarse = candidates(COARSE);
        if coarse.len() < 3 { candidates(FINE) } else { coarse }
    }
}

/// A number without needless digits.
pub(crate) fn number(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    if rounded.abs() >= 1e4 { format!("{}k", rounded / 1e3) } else { rounded.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_within() {
        let axis = Axis::new([0.3_f64, 2.1].into_iter(), 0.0, 100.0);
        let ticks = axis.decimal_ticks();
        assert!(ticks.contains(&2.0) && ticks.contains(&100.0), "{ticks:?}");
        let linear = Axis::new([31.0, 84.0].into_iter(), 0.0, 100.0);
        assert!(linear.ticks().iter().all(|tick| tick % 10.0 == 0.0), "{:?}", linear.ticks());
    }
}
