//! The sweep as one HTML file that needs nothing besides: charts, pictures beside the truth, the table.

use super::choice::Rated;
use super::sweep::{DIFFERENCE, FRAME};
use super::table::{COLUMNS, cells, decibels};
use crate::LabError;
use crate::chart::front::{FrontChart, Mark};
use pointcore::page::{self, Page, escape};
use pointcore_tb::cache::file;
use serde_json::{Value, json};
use std::path::Path;

/// Bytes of pictures, beyond which those of points that others better are left out.
const PICTURES_LIMIT: usize = 16 << 20;

/// Sizes of a chart in px, on wide screens and on narrow ones.
const SIZES: [(&str, [f64; 2]); 2] = [("wide", [560.0, 430.0]), ("narrow", [380.0, 380.0])];

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
    Ok(page::embedded(&bytes))
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
        let drawn = SIZES.map(|(class, size)| {
            let marks: Vec<_> = self.rated.iter().enumerate().filter_map(mark).collect();
            if marks.is_empty() {
                return String::new();
            }
            let svg = FrontChart { title, x, y: "PSNR against the truth, dB", marks, size }.svg();
            svg.replacen("<svg", &format!("<svg class=\"{class}\""), 1)
        });
        format!("<div>{}</div>\n", drawn.concat())
    }

    fn table(&self) -> String {
        let head: String = COLUMNS.iter().map(|name| format!("<th>{}</th>", escape(name))).collect();
        let row = |(index, rated): (usize, &Rated)| {
            let cells: String = cells(rated).iter().map(|cell| format!("<td>{}</td>", escape(cell))).collect();
            format!("<tr data-index=\"{index}\" tabindex=\"0\">{cells}</tr>\n")
        };
        let rows: String = self.rated.iter().enumerate().map(row).collect();
        format!(
            "<div class=\"scroll\"><table class=\"numbers\">\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>"
        )
    }

    /// The page.
    ///
    /// # Errors
    /// A picture cannot be read.
    pub fn html(&self) -> Result<String, LabError> {
        let point = |(rated, pictures): (&Rated, Value)| {
            let (name, psnr) = (&rated.measured.point.name, decibels(rated.measured.figures.psnr_db));
            json!({ "name": name, "hint": hint(rated), "psnr": psnr, "is_on_front": rated.on_front, "pictures": pictures })
        };
        let points: Vec<_> = self.rated.iter().zip(self.pictures()?).map(point).collect();
        let data = json!({ "truth": embedded(&self.truth.join(FRAME))?, "points": points });
        let advice: String = self.advice.iter().map(|line| format!("<li>{}</li>\n", escape(line))).collect();
        let charts = [
            self.chart("Accuracy over time", "ms a frame", |rated| rated.time_ms),
            self.chart("Accuracy over area", "LUT4", Rated::lut4),
        ];
        let points = "Points that nothing betters in accuracy, time and area together are filled, and named where there is room. \
                      Point at any for its name, its settings and its pictures.";
        let pictures = "<div id=\"panel\">\n<h3 id=\"name\"></h3>\n<div id=\"settings\"></div>\n<div class=\"pictures\">\n\
            <figure><img id=\"truth\" alt=\"truth\"><figcaption>Truth: 16 samples a pixel in f64</figcaption></figure>\n\
            <figure><img id=\"frame\" alt=\"frame\"><figcaption id=\"frame-caption\"></figcaption></figure>\n\
            <figure><img id=\"difference\" alt=\"difference\"><figcaption>Difference, magnified 16 times</figcaption></figure>\n\
            </div>\n</div>";
        let page = Page::new(format!("{}: what accuracy costs", self.scene))
            .style(include_str!("page.css"))
            .section("What to choose", "The cheapest points for some accuracies.", &format!("<ul>\n{advice}</ul>"))
            .section("What it costs", points, &format!("<div class=\"charts\">\n{}</div>", charts.concat()))
            .section("The chosen point", "Its settings, its figures, and what it draws.", pictures)
            .section("All points", self.legend, &self.table());
        Ok(page.data("sweep", data).script(include_str!("page.js")).html())
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
        assert_eq!(
            (html.matches("<svg").count(), html.matches("<tr data-index").count()),
            (4, 2),
            "two charts of two sizes"
        );
        assert!(html.contains("a&lt;b") && html.contains("<li>take base</li>"));
        assert_eq!(html.matches("</script>").count(), 2, "names cannot end a script");
        for address in ["http://", "https://", "src=\"/", "@import"] {
            assert!(!html.contains(address), "the page refers to {address}");
        }
    }
}
