//! `[overrides]`: a scene's own word on the parameters of its hardware.

use super::PlanError;
use pointcore_contract::splat::Config;
use serde::Deserialize;

/// Keys of the configuration that follow from the scene alone, and where it says them.
const SCENE_KEYS: [(&str, &str); 8] = [
    ("width", "set `image.width`"),
    ("height", "set `image.height`"),
    ("sampling", "set `image.sampling`"),
    ("depth", "set `splatting.depth`"),
    ("time_bins", "set `splatting.motion`, e.g. to \"bins:4\"; it is 0 where nothing moves"),
    (
        "merge",
        "it is \"on\" with `object.draw = \"triangles\"`, `splatting.surfaces = \"objects\"`, or what stands still beside what moves",
    ),
    ("kernel_gamma", "set `splatting.kernel_gamma`"),
    ("cardinal", "it is 1 where splats differ in `material`"),
];

/// A configuration with some of its keys replaced. Their names are unique, so overrides do without the configuration's tables.
pub(super) fn overridden(config: &Config, overrides: &toml::Table) -> Result<Config, PlanError> {
    let mut file = toml::Table::try_from(config).expect("a configuration is a TOML table");
    for (key, value) in overrides {
        if let Some(&(key, place)) = SCENE_KEYS.iter().find(|(determined, _)| determined == key) {
            return Err(PlanError::Determined { key, place });
        }
        if let Some(table) = Config::TABLES.iter().find(|table| table.name == key) {
            return Err(PlanError::Table { table: table.name });
        }
        let wrong = |problem| PlanError::Value { key: key.clone(), value: value.clone(), problem };
        let Some(planned) = place(&mut file, key) else {
            let determined = |key: &str| SCENE_KEYS.iter().any(|(determined, _)| *determined == key);
            let keys = Config::TABLES.iter().flat_map(|table| table.keys).map(|key| key.name);
            let keys: Vec<_> = keys.filter(|key| !determined(key)).map(|key| format!("`{key}`")).collect();
            return Err(PlanError::Unknown { key: key.clone(), expected: keys.join(", ") });
        };
        if !planned.same_type(value) {
            return Err(wrong(format!("expected a value such as {planned}")));
        }
        *planned = value.clone();
        // Key by key, so that the error is that of this key; its first line leaves out the key, which stands there already.
        Config::deserialize(file.clone())
            .map_err(|error| wrong(error.message().lines().next().unwrap_or_default().to_owned()))?;
    }
    Ok(file.try_into().expect("every replaced key was tried"))
}

/// Where a configuration's file has a key.
fn place<'file>(file: &'file mut toml::Table, key: &str) -> Option<&'file mut toml::Value> {
    let table = Config::TABLES.iter().find(|table| table.keys.iter().any(|known| known.name == key))?;
    file.get_mut(table.name)?.get_mut(key)
}

#[cfg(test)]
mod tests {
    use super::SCENE_KEYS;
    use crate::plan::Effect;
    use pointcore_contract::configuration::SetBy;
    use pointcore_contract::splat::Config;
    use std::collections::BTreeSet;

    #[test]
    fn the_reference_marks_what_follows_from_the_scene() {
        let sizes = ["splat_levels", "transform_interval", "setup_interval", "memory_ports"];
        let effects = Effect::STILL.map(Effect::key).into_iter().chain(sizes);
        let planned = SCENE_KEYS.map(|(key, _)| key).into_iter().chain(effects);
        let marked = Config::TABLES.iter().flat_map(|table| table.keys).filter(|key| key.set_by == SetBy::Input);
        assert_eq!(planned.collect::<BTreeSet<_>>(), marked.map(|key| key.name).collect());
    }
}
