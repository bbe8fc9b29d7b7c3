//! What a scene file may be without: the scene of a model alone, and settings in the place of its values.

use super::error::SceneError;
use std::io::ErrorKind;
use std::path::Path;

/// What a model without a scene is drawn in: a camera around it, a light over the shoulder, and its points as they are good for.
const MODEL_SCENE: &str = "\
camera = { fit = true }
image = { width = 512, height = 512, background = [0.13, 0.14, 0.16] }
light = { direction = \"camera\", ambient = 0.10, diffuse = 0.90 }
material = [{ specular = 0.10, shininess = 20.0 }]

[[object]]
kind = \"file\"
points = \"auto\"
drop_invalid = true
two_sided = \"estimated\"
radius_limit = 4.0
";

/// The scene of a model's file.
pub(super) fn model_scene(path: &Path) -> Result<String, SceneError> {
    // The scene lies beside its model. What is not there is the model's fault, not the scene's.
    let unreadable = |source| SceneError::Read { path: path.to_owned(), source };
    if std::fs::metadata(path).map_err(unreadable)?.is_dir() {
        return Err(unreadable(ErrorKind::IsADirectory.into()));
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(format!("{MODEL_SCENE}path = {}\n", toml::Value::String(name)))
}

/// Replaces or adds the value that a setting such as `object.0.path=scan.ply` names.
pub(super) fn apply(root: &mut toml::Value, setting: &str) -> Result<(), String> {
    let pair = setting.split_once('=').filter(|(keys, _)| keys.split('.').all(|key| !key.is_empty()));
    let (keys, text) = pair.ok_or("expected `key=value`, e.g. `object.0.path=scan.ply`")?;
    // What is not a TOML value is a string that the shell has stripped of its quotes.
    let parsed = toml::from_str::<toml::Table>(&format!("value = {text}")).ok().filter(|table| table.len() == 1);
    let value = parsed.and_then(|mut table| table.remove("value")).unwrap_or_else(|| text.into());

    let (parents, last) = keys.rsplit_once('.').unwrap_or(("", keys));
    let mut place = root;
    for key in parents.split('.').filter(|key| !key.is_empty()) {
        place = match place {
            toml::Value::Array(items) => {
                let count = items.len();
                let item = key.parse().ok().and_then(|index: usize| items.get_mut(index));
                item.ok_or_else(|| format!("`{key}` is not an index below {count}"))?
            }
            toml::Value::Table(table) => table.entry(key).or_insert_with(|| toml::Value::Table(toml::Table::new())),
            _ => return Err(format!("`{key}` lies below what is no table: leave it out")),
        };
    }
    let toml::Value::Table(table) = place else {
        return Err(format!("`{parents}` is no table, and has no key `{last}`: leave it out"));
    };
    table.insert(last.to_owned(), value);
    Ok(())
}
