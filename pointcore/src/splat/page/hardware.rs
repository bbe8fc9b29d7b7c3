//! What the scene called for, and what was left out.

use crate::page::{Page, grid_of_text};
use crate::plan::{Choice, Effect, Plan};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;

/// Continuous attributes in the order of [`pointcore_contract::surface`].
const ATTRIBUTES: [&str; CONTINUOUS_ATTRIBUTES] =
    ["normal x", "normal y", "normal z", "color red", "color green", "color blue"];

/// The choices that left something out, and the others.
fn is_left_out(choice: &Choice) -> bool {
    choice.chosen == "left out" || (choice.effect == Some(Effect::Cardinal) && choice.chosen == "0")
}

fn cells(choice: &Choice) -> Vec<String> {
    vec![choice.part.to_owned(), choice.chosen.clone(), choice.reason.clone()]
}

/// Which attributes the hardware carries, and which the host knows.
fn attributes(plan: &Plan) -> Vec<Vec<String>> {
    let row = |(index, name): (usize, &&str)| {
        let (carried, why) = match plan.constants[index] {
            _ if plan.attributes.contains(&index) => ("carried".to_owned(), "differs between splats".to_owned()),
            Some(constant) => ("left out".to_owned(), format!("is {constant} everywhere")),
            None => ("left out".to_owned(), "nothing reads it".to_owned()),
        };
        vec![(*name).to_owned(), carried, why]
    };
    ATTRIBUTES.iter().enumerate().map(row).collect()
}

/// Adds the section of a plan.
pub fn add(page: Page, title: &str, plan: &Plan) -> Page {
    let attributes = grid_of_text(&["attribute", "", "why"], &attributes(plan));
    if plan.choices.is_empty() {
        let config = &plan.config;
        let feature = |name: &str, is_on: bool| {
            vec![name.to_owned(), if is_on { "there" } else { "not there" }.to_owned(), String::new()]
        };
        let size = |name: &str, size: u32| vec![name.to_owned(), size.to_string(), String::new()];
        let rows = [
            feature(Effect::Culling.name(), config.culling.is_on()),
            feature(Effect::ScreenFilter.name(), config.screen_filter.is_on()),
            feature(Effect::EyePlane.name(), config.eye_plane.is_on()),
            size(Effect::Continuous.name(), config.continuous),
            size(Effect::Cardinal.name(), config.cardinal),
            size("heap levels", config.heap_levels),
            size("payloads", config.splats_held()),
            size(Effect::TileSlots.name(), config.tile_slots),
        ];
        let html = grid_of_text(&["part", "", ""], &rows) + "<h3>Attributes</h3>\n" + &attributes;
        return page.section(
            title,
            "That of the configuration given, as it is: nothing was left out for the scene.",
            &html,
        );
    }
    let (without, with): (Vec<&Choice>, Vec<&Choice>) = plan.choices.iter().partition(|choice| is_left_out(choice));
    let rows = |choices: &[&Choice]| choices.iter().map(|choice| cells(choice)).collect::<Vec<_>>();
    let mut html = grid_of_text(&["the scene calls for", "", "why"], &rows(&with));
    if !without.is_empty() {
        html += "<h3>Left out</h3>\n";
        html += &grid_of_text(&["part", "", "why"], &rows(&without));
    }
    html += "<h3>Attributes</h3>\n";
    html += &attributes;
    page.section(title, "What the scene calls for and what it does without, as `pointcore plan` has it.", &html)
}
