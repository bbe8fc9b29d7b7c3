//! The sweep as one HTML file that needs nothing besides: charts, pictures beside the truth, the table.

use super::choice::Rated;
use super::sweep::{DIFFERENCE, FRAME};
use super::table::{COLUMNS, cells, decibels};
use crate::LabError;
use crate::chart::escape;
use crate::chart::front::{FrontChart, Mark};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use pointcore_tb::cache::file;
use serde_json::{Value, json};
use std::path::Path;

/// Bytes of pictures, beyond which those of points that others better are left out.
const PICTURES_LIMIT: usize = 16 << 20;

/// What a page is made of.
pub struct SweepPage<'a> {
    /// The scene's name.
    pub scene: &'a str,
    /// The points.
    pub rated: &'a [Rated],
    /// What the figures are.
    pub legend: &'a str,
    /// Sentences on what to choose.
    pub advice: &'a [String],
    /// Folder of the truth's picture.
    pub truth: &'a Path,
}

/// A picture as the address of itself.
fn embedded(path: &Path) -> Result<String, LabError> {
    let bytes = std::fs::read(path).map_err(file("read", path))?;
    Ok("data:image/png;base64,".to_owned() + &STANDARD.encode(bytes))
}

/// A point's settings and figures, a line each.
fn hint(rated: &Rated) -> String {
    let arguments = rated.measured.point.arguments();
    let settings = if arguments.is_empty() { "as the scene says".to_owned() } else { arguments.join("\n") };
    let figures = COLUMNS.iter().zip(cells(rated)).skip(2).map(|(name, cell)| format!("{name}: {cell}"));
    let figures: Vec<_> = figures.collect();
    format!("{}\n{settings}\n{}", rated.measured.point.name, figures.join("\n"))
}

impl SweepPage<'_> {
    /// Pictures by the point's place, those of the front first, as many as there is room for.
    fn pictures(&self) -> Result<Vec<Value>, LabError> {
        let mut order: Vec<usize> = (0..self.rated.len()).collect();
        order.sort_by_key(|&index| !self.rated[index].on_front);
        let mut pictures = vec![Value::Null; self.rated.len()];
        let mut bytes = 0;
        for index in order {
            let folder = &self.rated[index].measured.folder;
            let [frame, difference] = [FRAME, DIFFERENCE].map(|name| embedded(&folder.join(name)));
            let (frame, difference) = (frame?, difference?);
            bytes += frame.len() + difference.len();
            if bytes > PICTURES_LIMIT {
                break;
            }
            pictures[index] = json!({ "frame": frame, "difference": difference });
        }
        Ok(pictures)
    }

    fn chart(&self, title: &str, x: &str, value: impl Fn(&Rated) -> Option<f64>) -> String {
        let mark = |(index, rated): (usize, &Rated)| {
            let (name, hint) = (rated.measured.point.name.clone(), hint(rated));
            let (x, y, on_front) = (value(rated)?, rated.measured.figures.psnr_db, rated.on_front);
            Some(Mark { name, hint, x, y, on_front, index })
        };
        let marks: Vec<_> = self.rated.iter().enumerate().filter_map(mark).collect();
        if marks.is_empty() {
            return String::new();
        }
        FrontChart { title, x, y: "PSNR against the truth, dB", marks }.svg()
    }

    fn table(&self) -> String {
        let head: String = COLUMNS.iter().map(|name| format!("<th>{}</th>", escape(name))).collect();
        let row = |(index, rated): (usize, &Rated)| {
            let cells: String = cells(rated).iter().map(|cell| format!("<td>{}</td>", escape(cell))).collect();
            format!("<tr data-index=\"{index}\" tabindex=\"0\">{cells}</tr>\n")
        };
        let rows: String = self.rated.iter().enumerate().map(row).collect();
        format!("<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>")
    }

    /// The page.
    ///
    /// # Errors
    /// A picture cannot be read.
    pub fn html(&self) -> Result<String, LabError> {
        let points: Vec<_> = self.rated.iter().zip(self.pictures()?).map(|(rated, pictures)| {
            json!({ "name": rated.measured.point.name, "hint": hint(rated), "psnr": decibels(rated.measured.figures.psnr_db), "pictures": pictures })
        }).collect();
        let data = serde_json::to_string(&json!({ "truth": embedded(&self.truth.join(FRAME))?, "points": points }));
        // What ends a script may not stand in one.
        let data = data.expect("the page's data are JSON").replace("</", "<\\/");
        let advice: String = self.advice.iter().map(|line| format!("<li>{}</li>\n", escape(line))).collect();
        let area = self.chart("Accuracy over area", "LUT4", Rated::lut4);
        let time = self.chart("Accuracy over time", "ms a frame", |rated| rated.time_ms);
        let parts = [
            ("SCENE", escape(self.scene)),
            ("LEGEND", escape(self.legend)),
            ("ADVICE", advice),
            ("TIME", time),
            ("AREA", area),
            ("TABLE", self.table()),
            ("DATA", data),
        ];
        let mut html = String::new();
        for piece in include_str!("page.html").split("{{") {
            match piece.split_once("}}") {
                Some((name, rest)) => {
                    let part =
                        parts.iter().find(|(part, _)| *part == name).expect("the page has parts of its own only");
                    html += &part.1;
                    html += rest;
                }
                None => html += piece,
            }
        }
        Ok(html)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::choice::tests::rated;
    use pointcore::picture::Picture;

    #[test]
    fn a_page_has_everything_in_it() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let picture = Picture { width: 8, height: 8, pixels: vec![[0.5; 3]; 64] };
        for name in [FRAME, DIFFERENCE] {
            picture.save_png(&folder.path().join(name)).expect("the folder can be written");
        }
        let mut points = rated(&[("base", 41.0, 1000, 500), ("f64 </script>", 44.0, 0, 0)]);
        points.iter_mut().for_each(|point| point.measured.folder = folder.path().to_owned());
        let page = SweepPage {
            scene: "a<b",
            rated: &points,
            legend: "L",
            advice: &["take base".into()],
            truth: folder.path(),
        };
        let html = page.html().expect("the pictures are there");
        assert_eq!(html.matches("data:image/png;base64,").count(), 5);
        assert_eq!((html.matches("<svg").count(), html.matches("<tr data-index").count()), (2, 2));
        assert!(html.contains("a&lt;b") && html.contains("<li>take base</li>") && !html.contains("{{"));
        assert_eq!(html.matches("</script>").count(), 2, "names cannot end a script");
        for address in ["http://", "https://", "src=\"/", "@import"] {
            let foreign = html.replace("http://www.w3.org/2000/svg", "");
            assert!(!foreign.contains(address), "the page refers to {address}");
        }
    }
}
