//! What a campaign comes to, as figures and as a document.

use super::campaign::Sums;
use super::check::Property;
use super::family::Family;
use super::methods::Method;
use crate::Figures;
use pointcore_contract::Format;
use serde_json::{Value, json};

/// Number formats that are checked: the default's and the one that saves multipliers.
pub const FORMATS: [Format; 2] = [Format::F32.flushed(), Format::F24.flushed()];

/// Share of compared cases in which a method failed, over a format's hard families.
pub(super) fn failure_rate(sums: &Sums, method: usize) -> f64 {
    let hard = Family::ALL.into_iter().filter(|family| *family != Family::Ordinary);
    let (failures, compared) = hard.map(|family| sums.family(family)).fold((0, 0), |(failures, compared), cell| {
        (failures + cell.methods[method].failures, compared + cell.compared)
    });
    failures as f64 / compared.max(1) as f64
}

/// Samples that a method visits in ordinary cases, as a multiple of the hardware's.
pub(super) fn samples_ratio(sums: &Sums, method: usize) -> f64 {
    let methods = sums.family(Family::Ordinary).methods;
    methods[method].visited as f64 / methods[0].visited.max(1) as f64
}

/// The figures of a campaign, by key.
#[must_use]
pub fn figures(all: &[Sums]) -> Figures {
    let mut figures = Figures::new();
    let cases: u64 = all.iter().flat_map(|sums| sums.cells.iter().flatten()).map(|cell| cell.cases).sum();
    figures.insert("stability.golden_cases".to_owned(), cases.into());
    let violated = |property: Property| all.iter().map(|sums| sums.violated(property)).sum::<u64>();
    for property in Property::ALL {
        figures.insert(format!("stability.violations.{}", property.name()), violated(property).into());
    }
    let proved: u64 = Property::ALL.into_iter().filter(|property| property.is_proved()).map(violated).sum();
    let total: u64 = Property::ALL.into_iter().map(violated).sum();
    figures.insert("stability.proved_violations".to_owned(), proved.into());
    figures.insert("stability.violations".to_owned(), total.into());
    for sums in all {
        // The default format's figures have the short keys.
        let prefix =
            if sums.format == FORMATS[0] { "stability".to_owned() } else { format!("stability.{}", sums.format) };
        for (place, method) in Method::ALL.into_iter().enumerate() {
            let key = format!("{prefix}.{}", method.name());
            figures.insert(format!("{key}.failure_rate"), failure_rate(sums, place).into());
            if method != Method::Ours {
                figures.insert(format!("{key}.samples_ratio"), samples_ratio(sums, place).into());
            }
        }
    }
    figures
}

/// A campaign as JSON.
#[must_use]
pub fn document(all: &[Sums]) -> Value {
    let formats = all.iter().map(|sums| {
        let families: serde_json::Map<_, _> = Family::ALL
            .into_iter()
            .zip(&sums.cells)
            .map(|(family, cells)| (family.name().to_owned(), json!(cells)))
            .collect();
        let violations: Vec<_> = sums
            .violations
            .iter()
            .map(|((property, family), count)| json!({ "property": property, "family": family, "count": count }))
            .collect();
        json!({
            "format": sums.format, "families": families, "violations": violations, "examples": sums.examples,
        })
    });
    json!({ "methods": Method::ALL, "formats": formats.collect::<Vec<_>>() })
}
