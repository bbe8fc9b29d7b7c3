//! What is done to neighborhoods: a program, or several after another.

use super::ProcessError;
use pointcore_contract::Format;
use pointcore_contract::process::config::Config;
use pointcore_contract::process::{Field, Program, library};
use std::path::Path;
use std::sync::Arc;

/// Names of operations and the library's programs that each runs, one after the other.
const OPERATIONS: [(&str, &[&str]); 7] = [
    ("normals", &["normals"]),
    ("covariance", &["covariance"]),
    ("mls", &["mls"]),
    ("apss", &["apss"]),
    ("smooth", &["smooth"]),
    ("resample", &["resample"]),
    ("sph", &["sph_density", "sph_forces"]),
];

/// Programs that run one after the other; outputs of one are attributes of the points for the next.
#[derive(Clone, Debug)]
pub struct Operation {
    name: String,
    stages: Vec<Arc<Program>>,
}

impl Operation {
    /// The names of those that come with the project.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        OPERATIONS.iter().map(|(name, _)| *name).collect()
    }

    /// The one of that name, or the library's program of that name alone.
    ///
    /// # Errors
    /// There is none.
    pub fn named(name: &str) -> Result<Self, ProcessError> {
        let found = OPERATIONS.iter().find(|(known, _)| *known == name).map(|(_, stages)| *stages);
        let alone =
            library::PROGRAMS.iter().find(|(known, _)| *known == name).map(|(known, _)| std::slice::from_ref(known));
        let unknown = || ProcessError::Operation { name: name.to_owned(), known: Self::names() };
        let stages = found.or(alone).ok_or_else(unknown)?;
        let stages = stages.iter().map(|program| Arc::new(library::program(program))).collect();
        Ok(Self { name: name.to_owned(), stages })
    }

    /// A program of a file.
    ///
    /// # Errors
    /// The file cannot be read, is no program, or one that the hardware has no room for.
    pub fn load(path: &Path) -> Result<Self, ProcessError> {
        let text =
            std::fs::read_to_string(path).map_err(|source| ProcessError::Read { path: path.to_owned(), source })?;
        Self::parse(&path.display().to_string(), &text)
    }

    /// A program of a text, which errors call `file`.
    ///
    /// # Errors
    /// It is no program, or one that the hardware has no room for.
    pub fn parse(file: &str, text: &str) -> Result<Self, ProcessError> {
        let program = Arc::new(Program::parse(file, text)?);
        config(Arc::clone(&program), Format::F32).validate()?;
        Ok(Self { name: program.name().to_owned(), stages: vec![program] })
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its programs in their order, one at least.
    #[must_use]
    pub fn stages(&self) -> &[Arc<Program>] {
        &self.stages
    }

    /// Whether each query carries its offsets in a pattern.
    #[must_use]
    pub fn has_pattern(&self) -> bool {
        self.stages.iter().any(|program| ["u", "v"].iter().all(|name| program.query.find(name).is_some()))
    }

    /// Whether it says where its queries lie in the end.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.stages.last().is_some_and(|program| program.outputs.find("position").is_some())
    }

    /// The settings of all programs, each name once.
    #[must_use]
    pub fn settings(&self) -> Vec<Field> {
        distinct(self.stages.iter().flat_map(|program| program.settings.fields()))
    }

    /// The fields of queries and neighbors besides positions, each name once, but for what an earlier program finds.
    #[must_use]
    pub fn fields(&self) -> Vec<Field> {
        let fields = self.stages.iter().enumerate().flat_map(|(stage, program)| {
            let fields = program.query.fields().iter().chain(program.neighbor.fields());
            fields.filter(move |field| self.finder(stage, &field.name).is_none())
        });
        distinct(fields.filter(|field| field.name != "position"))
    }

    /// The field that an attribute of this name gives.
    ///
    /// # Errors
    /// No program reads it, or an earlier program finds it.
    pub fn field(&self, name: &str) -> Result<Field, ProcessError> {
        let fields = self.fields();
        if let Some(field) = fields.iter().find(|field| field.name == name) {
            return Ok(field.clone());
        }
        let (program, name) = (self.name.clone(), name.to_owned());
        let reads = |reader: &Program| [&reader.query, &reader.neighbor].iter().any(|of| of.find(&name).is_some());
        let found = self.stages.iter().enumerate().filter(|(_, reader)| reads(reader));
        match found.into_iter().find_map(|(stage, reader)| Some((self.finder(stage, &name)?, reader))) {
            Some((finder, reader)) => {
                let (finder, reader) = (finder.name().to_owned(), reader.name().to_owned());
                Err(ProcessError::Found { program, name, finder, reader })
            }
            None => Err(ProcessError::UnknownAttribute { program, name, known: shown(&fields) }),
        }
    }

    /// The program before this stage that has an output of the name.
    fn finder(&self, stage: usize, name: &str) -> Option<&Program> {
        self.stages[..stage].iter().find(|program| program.outputs.find(name).is_some()).map(|program| &**program)
    }
}

/// A core for a program: it says which programs and formats the hardware has room for.
pub(super) const fn config(program: Arc<Program>, format: Format) -> Config {
    Config {
        program,
        format,
        index_bits: 24,
        neighbors: super::NEIGHBORS_LIMIT,
        threads: 128,
        rate: 1,
        line_points: 4,
        cache_lines: 256,
    }
}

fn distinct<'a>(fields: impl Iterator<Item = &'a Field>) -> Vec<Field> {
    let mut all: Vec<Field> = vec![];
    for field in fields {
        if !all.iter().any(|known| known.name == field.name) {
            all.push(field.clone());
        }
    }
    all
}

/// A field as messages show it: `tolerance (float)`.
pub(super) fn shown(fields: &[Field]) -> Vec<String> {
    fields.iter().map(|field| format!("{} ({})", field.name, field.ty)).collect()
}
