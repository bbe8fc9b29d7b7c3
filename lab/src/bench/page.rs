//! What a part of the benchmark shows to people: charts, and tables of what they show.

use crate::chart::lines::{LineChart, Series};
use crate::{LabError, write};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Values of one kind over the categories of a chart.
pub struct PageLine {
    name: String,
    values: Vec<Option<f64>>,
}

impl PageLine {
    /// A line without values.
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), values: Vec::new() }
    }

    /// The next category's value.
    pub fn push(&mut self, value: f64) {
        self.push_if(Some(value));
    }

    /// The next category's value, if it has one.
    pub fn push_if(&mut self, value: Option<f64>) {
        self.values.push(value);
    }
}

/// A page in the making.
pub struct FigurePage {
    folder: PathBuf,
    pub(super) text: String,
}

impl FigurePage {
    /// A page about what was done among these points.
    pub fn new(folder: &Path, title: &str, points: &str) -> Self {
        let text = format!("# {title}, measured\n\nPoints: {points}\n");
        Self { folder: folder.to_owned(), text }
    }

    /// A chart, and its values as a table.
    pub fn lines(
        &mut self,
        file: &str,
        title: &str,
        x: &str,
        y: &str,
        categories: &[String],
        lines: Vec<PageLine>,
    ) -> Result<(), LabError> {
        _ = writeln!(
            self.text,
            "\n## {title}\n\n| {x} | {} |\n|---|{}",
            categories.join(" | "),
            "---|".repeat(categories.len())
        );
        for PageLine { name, values } in &lines {
            let cell = |value: &Option<f64>| value.map_or(String::new(), |value| format!("{value:.3}"));
            let cells: Vec<_> = values.iter().map(cell).collect();
            _ = writeln!(self.text, "| {name} | {} |", cells.join(" | "));
        }
        _ = writeln!(self.text, "\n![{title}]({file}.svg)");
        let series = lines.into_iter().map(|PageLine { name, values }| Series { name, values }).collect();
        let [title, x, y] = [title, x, y].map(str::to_owned);
        let chart = LineChart { title, x, y, categories: categories.to_vec(), series };
        // The page so far: a run that is interrupted leaves what it has.
        write(&self.folder.join("README.md"), &self.text)?;
        chart.save_svg(&self.folder.join(format!("{file}.svg")))
    }

    /// Text of its own.
    pub fn paragraph(&mut self, text: &str) {
        _ = writeln!(self.text, "\n{text}");
    }

    /// Writes the page.
    pub fn save(self) -> Result<(), LabError> {
        write(&self.folder.join("README.md"), &self.text)
    }
}
