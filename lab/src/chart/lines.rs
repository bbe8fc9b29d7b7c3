//! Values over a few named settings, as lines: colors, a legend where there is room, nothing that a page must add.

use super::{Axis, escape, number};
use crate::{LabError, write};
use std::fmt::Write as _;
use std::path::Path;

/// Size in px.
const SIZE: [f64; 2] = [640.0, 400.0];
/// Left, right, top and bottom.
const MARGINS: [f64; 4] = [64.0, 16.0, 40.0, 52.0];
/// Room beside the first and the last setting, of the distance of two.
const SIDE: f64 = 0.25;
/// Radius of a dot.
const DOT: f64 = 4.0;
/// Line height of the legend, width of a letter, and length of its strokes.
const LEGEND: [f64; 3] = [17.0, 6.6, 18.0];
/// A palette that stays distinct in print and for the colour-blind (Okabe and Ito).
const COLORS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

/// Values of one kind, in the order of a chart's categories; a category may lack one.
#[derive(Clone, Debug)]
pub struct Series {
    /// What the legend says.
    pub name: String,
    /// A value for each category.
    pub values: Vec<Option<f64>>,
}

/// Values over a few named settings.
#[derive(Clone, Debug)]
pub struct LineChart {
    /// Above the chart.
    pub title: String,
    /// Below it: what the categories are.
    pub x: String,
    /// Beside it: what the values are.
    pub y: String,
    /// The settings.
    pub categories: Vec<String>,
    /// What was measured at each.
    pub series: Vec<Series>,
}

impl LineChart {
    /// Writes the chart.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn save_svg(&self, path: &Path) -> Result<(), LabError> {
        write(path, &self.svg())
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.series.iter().flat_map(|series| series.values.iter().copied().flatten())
    }

    /// Draws the chart: values from zero on.
    #[must_use]
    pub fn svg(&self) -> String {
        let [left, right, top, bottom] = MARGINS;
        let [width, height] = SIZE;
        let last = self.categories.len().saturating_sub(1) as f64;
        let x_axis = Axis::between([-SIDE, last + SIDE], left, width - right);
        let y_axis = Axis::from_zero(self.values(), height - bottom, top);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n\
             <text x=\"{}\" y=\"24\" font-size=\"17\" text-anchor=\"middle\">{}</text>\n",
            width / 2.0,
            escape(&self.title)
        );
        for tick in y_axis.ticks() {
            let y = y_axis.place(tick);
            _ = writeln!(
                svg,
                "<path d=\"M{left} {y:.1}H{}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                width - right,
                left - 6.0,
                y + 4.0,
                number(tick)
            );
        }
        _ = writeln!(
            svg,
            "<path d=\"M{left} {top}V{}H{}\" fill=\"none\" stroke=\"#555\"/>",
            height - bottom,
            width - right
        );
        for (index, category) in self.categories.iter().enumerate() {
            let (x, y) = (x_axis.place(index as f64), height - bottom);
            _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {y}v5\" stroke=\"#555\"/><text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                y + 18.0,
                escape(category)
            );
        }
        let (middle_x, middle_y) = ((left + width - right) / 2.0, (top + height - bottom) / 2.0);
        _ = writeln!(
            svg,
            "<text x=\"{middle_x}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n\
             <text transform=\"translate(16 {middle_y}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            height - 12.0,
            escape(&self.x),
            escape(&self.y)
        );
        let mut points = vec![];
        for (series, color) in self.series.iter().zip(COLORS.iter().cycle()) {
            points.extend(line(&mut svg, series, color, &x_axis, &y_axis));
        }
        if self.series.len() > 1 {
            self.legend(&mut svg, &points);
        }
        svg + "</svg>\n"
    }

    /// What each color is, in the corner with the fewest points.
    fn legend(&self, svg: &mut String, points: &[(f64, f64)]) {
        let [left, right, top, bottom] = MARGINS;
        let [line_height, letter, stroke] = LEGEND;
        let letters = self.series.iter().map(|series| series.name.chars().count()).max().unwrap_or(0) as f64;
        let width = (stroke + 22.0 + letter * letters).min(SIZE[0] - left - right);
        let height = line_height * self.series.len() as f64 + 8.0;
        let covered = |&(x, y): &(f64, f64)| {
            let is_in = |&&(px, py): &&(f64, f64)| {
                (x - DOT..=x + width + DOT).contains(&px) && (y - DOT..=y + height + DOT).contains(&py)
            };
            points.iter().filter(is_in).count()
        };
        let [left, right] = [left + 8.0, SIZE[0] - right - width - 8.0];
        let [top, bottom] = [top + 8.0, SIZE[1] - bottom - height - 8.0];
        let corners = [(right, top), (right, bottom), (left, top), (left, bottom)];
        let (x, y) = corners.into_iter().min_by_key(covered).expect("there are four");
        _ = writeln!(
            svg,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"white\" fill-opacity=\"0.8\" stroke=\"#ccc\"/>"
        );
        for (index, (series, color)) in self.series.iter().zip(COLORS.iter().cycle()).enumerate() {
            let middle = y + 4.0 + line_height * (index as f64 + 0.5);
            _ = writeln!(
                svg,
                "<path d=\"M{:.1} {middle:.1}h{stroke}\" stroke=\"{color}\" stroke-width=\"2\"/><text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                x + 7.0,
                x + stroke + 14.0,
                middle + 4.0,
                escape(&series.name)
            );
        }
    }
}

/// A line through the values there are, and a dot at each; where the dots are.
fn line(svg: &mut String, series: &Series, color: &str, x_axis: &Axis, y_axis: &Axis) -> Vec<(f64, f64)> {
    let known =
        series.values.iter().enumerate().filter_map(|(x, y)| Some((x_axis.place(x as f64), y_axis.place((*y)?))));
    let points: Vec<(f64, f64)> = known.collect();
    let path: Vec<_> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    _ = writeln!(svg, "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>", path.join(" "));
    for (x, y) in &points {
        _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{DOT}\" fill=\"{color}\"/>");
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(values: [[Option<f64>; 3]; 2]) -> LineChart {
        let [one, four] = values.map(Vec::from);
        LineChart {
            title: "Cycles a query".to_owned(),
            x: "threads".to_owned(),
            y: "cycles".to_owned(),
            categories: ["1", "2", "4"].map(str::to_owned).to_vec(),
            series: vec![
                Series { name: "one <lane>".to_owned(), values: one },
                Series { name: "four lanes".to_owned(), values: four },
            ],
        }
    }

    #[test]
    fn a_chart_shows_every_name_and_value() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("charts/chart.svg");
        let chart = chart([[Some(4.0), Some(2.0), Some(1.0)], [Some(3.0), None, Some(0.5)]]);
        chart.save_svg(&path).unwrap_or_else(|error| panic!("{error}"));
        let text = std::fs::read_to_string(&path).expect("it was just written");
        for word in ["Cycles a query", "threads", ">cycles<", "one &lt;lane&gt;", "four lanes", ">4<"] {
            assert!(text.contains(word), "{word} is missing");
        }
        assert_eq!((text.matches("<circle").count(), text.matches("<polyline").count()), (5, 2));
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        std::fs::write(folder.path().join("file"), "").expect("the folder is writable");
        let nowhere = folder.path().join("file/chart.svg");
        assert!(chart.save_svg(&nowhere).is_err_and(|error| error.to_string().contains("chart.svg")));
    }

    #[test]
    fn values_lie_within_and_nothing_can_be_drawn() {
        let text = chart([[Some(0.0), Some(2e6), Some(3e-7)], [None; 3]]).svg();
        let heights = text.split("cy=\"").skip(1).filter_map(|rest| rest.split('"').next()?.parse::<f64>().ok());
        let heights: Vec<_> = heights.collect();
        assert_eq!(heights.len(), 3);
        assert!(heights.iter().all(|y| (MARGINS[2]..=SIZE[1] - MARGINS[3]).contains(y)), "{heights:?}");
        let empty = chart([[None; 3]; 2]).svg();
        assert!(!empty.contains("NaN") && !empty.contains("inf"), "{empty}");
    }
}
