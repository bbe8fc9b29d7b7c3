//! How a scene file is read: as it stands, with settings applied, or made for a model.

use super::error::SceneError;
use super::file::SceneFile;
use super::model::{self, Model};
use super::settings::{self, apply};
use crate::wording::plain;
use std::io::ErrorKind;
use std::path::Path;

fn read(path: &Path) -> Result<String, SceneError> {
    if Model::is_model(path) {
        return settings::model_scene(path);
    }
    std::fs::read_to_string(path).map_err(|source| match source.kind() {
        ErrorKind::InvalidData => neither(path, "it is no text in UTF-8"),
        _ => SceneError::Read { path: path.to_owned(), source },
    })
}

fn syntax(path: &Path, error: &toml::de::Error) -> SceneError {
    let message = plain(error);
    if is_toml(path) { SceneError::Syntax { path: path.to_owned(), message } } else { neither(path, &message) }
}

fn is_toml(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// A file that is no scene, and by its name no model either.
fn neither(path: &Path, problem: &str) -> SceneError {
    let message = if is_toml(path) {
        problem.to_owned()
    } else {
        format!("is no scene: {problem}\nNor is it a model: a model's name must end in {}", model::endings())
    };
    SceneError::Syntax { path: path.to_owned(), message }
}

impl SceneFile {
    /// Reads a scene file, or makes one for a model, with `key.path=value` settings replacing what it says.
    pub(super) fn load(path: &Path, settings: &[String]) -> Result<Self, SceneError> {
        let text = read(path)?;
        let syntax = |error| syntax(path, &error);
        // The text itself is always checked, since only its errors can tell the line.
        let scene = toml::from_str(&text).map_err(syntax);
        if settings.is_empty() {
            return scene;
        }
        Self::table(path, settings)?.try_into().map_err(syntax)
    }

    /// The file's tables with settings applied.
    fn table(path: &Path, settings: &[String]) -> Result<toml::Value, SceneError> {
        let text = read(path)?;
        let table = toml::from_str(&text).map_err(|error| syntax(path, &error))?;
        let mut table = toml::Value::Table(table);
        for setting in settings {
            apply(&mut table, setting).map_err(|problem| SceneError::Setting { setting: setting.clone(), problem })?;
        }
        Ok(table)
    }

    /// The file's text with settings applied and the models' paths made absolute.
    pub(super) fn text(path: &Path, settings: &[String]) -> Result<String, SceneError> {
        Self::load(path, settings)?;
        let mut table = Self::table(path, settings)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        for object in table.get_mut("object").and_then(toml::Value::as_array_mut).into_iter().flatten() {
            let Some(toml::Value::String(model)) = object.get_mut("path") else { continue };
            let absolute = std::path::absolute(folder.join(&*model));
            *model = absolute.unwrap_or_else(|_| folder.join(&*model)).to_string_lossy().into_owned();
        }
        Ok(toml::to_string(&table).expect("it was TOML before"))
    }
}
