//! Line charts as SVG, from a run's own figures.

use plotters::coord::Shift;
use plotters::prelude::*;
use std::path::{Path, PathBuf};

/// Size of a chart in px.
const SIZE_PX: (u32, u32) = (640, 400);
/// Room above the largest value, as a share of it.
const HEADROOM: f64 = 0.1;
/// A palette that stays distinct in print and for the colour-blind (Okabe and Ito).
const COLORS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

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
pub struct Chart {
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

/// A chart that cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: the chart cannot be written: {reason}", path.display())]
pub struct PlotError {
    path: PathBuf,
    reason: String,
}

impl Chart {
    /// Writes the chart.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn save_svg(&self, path: &Path) -> Result<(), PlotError> {
        let area = SVGBackend::new(path, SIZE_PX).into_drawing_area();
        self.draw(&area).map_err(|reason| PlotError { path: path.to_owned(), reason: reason.to_string() })
    }

    fn largest(&self) -> f64 {
        let values = self.series.iter().flat_map(|series| series.values.iter().flatten());
        values.copied().fold(0.0, f64::max).max(f64::MIN_POSITIVE)
    }

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        area.fill(&WHITE)?;
        let last = self.categories.len().saturating_sub(1) as f64;
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, ("sans-serif", 18))
            .margin(12)
            .x_label_area_size(40)
            .y_label_area_size(56)
            .build_cartesian_2d(-0.25..last + 0.25, 0.0..self.largest() * (1.0 + HEADROOM))?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .x_desc(&self.x)
            .y_desc(&self.y)
            .x_labels(self.categories.len())
            .x_label_formatter(&|x| self.label(*x))
            .draw()?;
        for (series, color) in self.series.iter().zip(COLORS.iter().cycle()) {
            let points: Vec<_> =
                series.values.iter().enumerate().filter_map(|(x, y)| y.map(|y| (x as f64, y))).collect();
            let style = color.stroke_width(2);
            chart
                .draw_series(LineSeries::new(points, style).point_size(4))?
                .label(&series.name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
        }
        chart
            .configure_series_labels()
            .background_style(WHITE.mix(0.8))
            .border_style(BLACK.mix(0.2))
            .position(self.free_corner())
            .draw()?;
        area.present()
    }

    /// Where lines that fall, or lines that rise, leave room on the right.
    fn free_corner(&self) -> SeriesLabelPosition {
        let rises = |series: &Series| series.values.first() < series.values.last();
        if self.series.iter().any(rises) { SeriesLabelPosition::LowerRight } else { SeriesLabelPosition::UpperRight }
    }

    /// The category at a tick; ticks between categories stay bare.
    fn label(&self, x: f64) -> String {
        let on_category = (x - x.round()).abs() < 1e-6 && x >= 0.0;
        on_category.then(|| self.categories.get(x.round() as usize)).flatten().cloned().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_shows_every_name_and_value() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("chart.svg");
        let chart = Chart {
            title: "Cycles a query".to_owned(),
            x: "threads".to_owned(),
            y: "cycles".to_owned(),
            categories: ["1", "2", "4"].map(str::to_owned).to_vec(),
            series: vec![
                Series { name: "one lane".to_owned(), values: vec![Some(4.0), Some(2.0), Some(1.0)] },
                Series { name: "four lanes".to_owned(), values: vec![Some(3.0), None, Some(0.5)] },
            ],
        };
        chart.save_svg(&path).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        for word in ["Cycles a query", "threads", "one lane", "four lanes"] {
            assert!(text.contains(word), "{word} is missing");
        }
        assert_eq!(text.matches("<circle").count(), 5);
        let nowhere = folder.path().join("missing").join("chart.svg");
        assert!(chart.save_svg(&nowhere).unwrap_err().to_string().contains("chart.svg"));
    }
}
