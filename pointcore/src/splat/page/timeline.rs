//! The timeline of the units: a strip each, and their shares of the frame.

use crate::page::{Page, escape, grid};
use crate::splat::activity::{Activity, State, Timeline, Unit};
use crate::splat::report::SplatReport;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// States that a strip shows, from its ground up; the rest stays blank.
const SHOWN: [State; 5] = [State::Busy, State::Pixel, State::Tile, State::Held, State::Starved];

const fn label(state: State) -> &'static str {
    match state {
        State::Busy => "busy",
        State::Pixel => "waits for a pixel (hazard)",
        State::Tile => "waits for a tile",
        State::Held => "held back by what follows",
        State::Starved => "starved",
        State::Other => "none of these",
    }
}

const fn key(state: State) -> &'static str {
    match state {
        State::Busy => "busy",
        State::Pixel => "pixel",
        State::Tile => "tile",
        State::Held => "held",
        State::Starved => "starved",
        State::Other => "other",
    }
}

fn strips(units: &[Unit], share: impl Fn(Unit, State) -> String) -> String {
    let mut html = "<p class=\"legend\">".to_owned();
    for state in SHOWN {
        _ = write!(html, "<span><i class=\"{}\"></i>{}</span> ", key(state), label(state));
    }
    html += "</p>\n<div class=\"bars strips\" id=\"strips\">\n";
    for (index, &unit) in units.iter().enumerate() {
        let (name, busy) = (escape(unit.name()), share(unit, State::Busy));
        _ = writeln!(
            html,
            "<div><span>{name}</span><canvas class=\"track\" data-unit=\"{index}\" aria-label=\"{name}\"></canvas><b>{busy}</b></div>"
        );
    }
    html + "<div class=\"axis\"><span>cycles</span><span class=\"track\"></span><b>busy</b></div>\n</div>\n<p class=\"words\" id=\"slice\"></p>\n"
}

fn data(timeline: &Timeline, units: &[Unit]) -> Value {
    let row = |unit: &Unit| {
        let states = SHOWN.map(|state| timeline.row(*unit, state).collect::<Vec<_>>());
        json!({ "name": unit.name(), "count": timeline.count(*unit), "states": states })
    };
    json!({
        "slice": timeline.slice_cycles(),
        "cycles": timeline.cycles(),
        "states": SHOWN.map(|state| json!({ "key": key(state), "label": label(state) })),
        "units": units.iter().map(row).collect::<Vec<_>>(),
    })
}

/// Adds the section.
pub fn add(page: Page, activity: &Activity, report: &SplatReport) -> Page {
    let (timeline, units) = (activity.timeline(), activity.units());
    let share = |unit: Unit, state: State| {
        let cycles = report.cycles.max(1) * u64::from(timeline.count(unit));
        format!("{:.1} %", 100.0 * timeline.total(unit, state) as f64 / cycles as f64)
    };
    let rows: Vec<Vec<String>> = units
        .iter()
        .map(|&unit| std::iter::once(unit.name().to_owned()).chain(SHOWN.map(|state| share(unit, state))).collect())
        .collect();
    let mut sentence = format!(
        "What each unit does, in slices of {} cycles, from the {} cycles in which the frame's constants are written to its last fragment. A \
         datapath is busy for its interval with every item; the reconstruction buffer is busy when a pixel moves either way. Shares are of the frame's cycles.",
        timeline.slice_cycles(),
        timeline.cycles().saturating_sub(report.cycles)
    );
    if timeline.count(Unit::Rasterizer) > 1 {
        _ = write!(
            sentence,
            " Of reorder stage to accumulator there are {}: a strip shows them together.",
            timeline.count(Unit::Rasterizer)
        );
    }
    if activity.samples().is_none() {
        sentence += " Hardware without its golden model shows its ports alone: of the other units nothing is known.";
    }
    let heads = ["unit", "busy", "pixel", "tile", "held", "starved"];
    let html = strips(units, share) + &grid(&heads, &rows);
    page.section("When it is done", &sentence, &html)
        .data("timeline", data(timeline, units))
        .script(include_str!("timeline.js"))
}
