//! A line for a scene: what its hardware has, and what that saves.

use super::Costs;
use crate::plan::Plan;

/// The head of the table.
pub const TABLE_HEAD: &str = "| scene | culling | filter | eye plane | attributes | cardinal | heap | slots | interval | LUT4 saved | memory | multipliers | cycles |\n\
                              |---|---|---|---|---|---|---|---|---|---|---|---|---|";

/// What is chosen for a scene, as the first cells of its line.
#[must_use]
pub fn choices_row(name: &str, plan: &Plan) -> String {
    let config = &plan.config;
    let [culling, filter, eye_plane] = [config.culling, config.screen_filter, config.eye_plane]
        .map(|feature| if feature.is_on() { "on" } else { "–" });
    let (levels, slots, interval) = (config.heap_levels, config.tile_slots, config.setup_interval);
    let numbers = [config.continuous, config.cardinal, levels, slots, interval].map(|number| number.to_string());
    format!("| {name} | {culling} | {filter} | {eye_plane} | {} |", numbers.join(" | "))
}

/// The line of a scene.
#[must_use]
pub fn table_row(name: &str, plan: &Plan, costs: &Costs) -> String {
    // Rounded first, and zero added: what is lost below a tenth is no "-0.0".
    let rounded = |share: f64| (1000.0 * share).round() / 10.0 + 0.0;
    let percent = |share: Option<f64>| share.map_or_else(|| "?".to_owned(), |share| format!("{:.1} %", rounded(share)));
    let saved = [costs.area_saved(), Some(costs.memory_saved()), Some(costs.multipliers_saved()), costs.cycles_saved()];
    format!("{} {} |", choices_row(name, plan), saved.map(percent).join(" | "))
}
