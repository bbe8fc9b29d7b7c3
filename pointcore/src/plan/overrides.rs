//! `[overrides]`: a scene's own word on the parameters of its hardware.

use super::PlanError;
use pointcore_contract::splat::Config;
use serde::Deserialize;

/// Keys of the configuration that follow from the scene alone, and where it says them.
const SCENE_KEYS: [(&str, &str); 7] = [
    ("width", "set `image.width`"),
    ("height", "set `image.height`"),
    ("sampling", "set `image.sampling`"),
    ("depth", "set `splatting.depth`"),
    ("kernel_gamma", "set `splatting.kernel_gamma`"),
    ("continuous", "it counts the components of normal and color that differ between splats"),
    ("cardinal", "it is 1 where splats differ in `material`"),
];

/// A configuration with some of its keys replaced.
pub(super) fn overridden(config: &Config, overrides: &toml::Table) -> Result<Config, PlanError> {
    let mut table = toml::Table::try_from(config).expect("a configuration is a TOML table");
    for (key, value) in overrides {
        if let Some(&(key, place)) = SCENE_KEYS.iter().find(|(determined, _)| determined == key) {
            return Err(PlanError::Determined { key, place });
        }
        let wrong = |problem| PlanError::Value { key: key.clone(), value: value.clone(), problem };
        let Some(planned) = table.get(key) else {
            let determined = |key: &str| SCENE_KEYS.iter().any(|(determined, _)| *determined == key);
            let keys: Vec<_> = table.keys().filter(|key| !determined(key)).map(|key| format!("`{key}`")).collect();
            return Err(PlanError::Unknown { key: key.clone(), expected: keys.join(", ") });
        };
        if !planned.same_type(value) {
            return Err(wrong(format!("expected a value such as {planned}")));
        }
        table.insert(key.clone(), value.clone());
        // Key by key, so that the error is that of this key; its first line leaves out the key, which stands there already.
        Config::deserialize(table.clone())
            .map_err(|error| wrong(error.message().lines().next().unwrap_or_default().to_owned()))?;
    }
    Ok(table.try_into().expect("every replaced key was tried"))
}
