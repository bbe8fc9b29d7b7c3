//! The area proxy of a generated core: what its modules hold, counted before synthesis.

use rtl::{Area, Design};
use serde_json::{Value, json};

/// Totals over a design, every instance counted.
#[must_use]
pub fn total(design: &Design) -> Area {
    design.modules().iter().fold(Area::default(), |sum, module| Area {
        register_bits: sum.register_bits + module.instances * module.area.register_bits,
        memory_bits: sum.memory_bits + module.instances * module.area.memory_bits,
        multipliers: sum.multipliers + module.instances * module.area.multipliers,
        multiplier_blocks: sum.multiplier_blocks + module.instances * module.area.multiplier_blocks,
        multiplier_bits: sum.multiplier_bits + module.instances * module.area.multiplier_bits,
        adder_bits: sum.adder_bits + module.instances * module.area.adder_bits,
        mux_bits: sum.mux_bits + module.instances * module.area.mux_bits,
    })
}

fn entries(area: &Area) -> [(&'static str, u64); 6] {
    [
        ("register bits", area.register_bits),
        ("memory bits", area.memory_bits),
        ("multipliers", area.multipliers),
        ("product bits", area.multiplier_bits),
        ("adder bits", area.adder_bits),
        ("multiplexer bits", area.mux_bits),
    ]
}

/// Two designs side by side: name, figure of the first, figure of the second.
#[must_use]
pub fn rows(first: &Design, second: &Design) -> Vec<(&'static str, u64, u64)> {
    let (first, second) = (entries(&total(first)), entries(&total(second)));
    first.into_iter().zip(second).map(|((name, first), (_, second))| (name, first, second)).collect()
}

/// The totals as JSON.
#[must_use]
pub fn document(design: &Design) -> Value {
    entries(&total(design)).into_iter().map(|(name, figure)| (name.replace(' ', "_"), Value::from(figure))).collect()
}

/// Every module with its parameters and area as JSON.
#[must_use]
pub fn modules(design: &Design) -> Value {
    let module = |module: &rtl::ModuleSummary| {
        let parameters: Value =
            module.parameters.iter().map(|(name, value)| (name.clone(), Value::from(value.as_str()))).collect();
        let area: Value = entries(&module.area)
            .into_iter()
            .map(|(name, figure)| (name.replace(' ', "_"), Value::from(figure)))
            .collect();
        json!({ "name": module.name, "unit": module.unit, "instances": module.instances, "parameters": parameters, "area": area })
    };
    design.modules().iter().map(module).collect()
}
