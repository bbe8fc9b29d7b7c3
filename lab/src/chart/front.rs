//! Points over what they cost, as SVG: every one named, those that nothing betters joined by a line, settings on hovering.

use super::{Axis, escape, number};
use std::fmt::Write as _;

/// Size in px.
const SIZE: [f64; 2] = [760.0, 460.0];
/// Left, right, top and bottom.
const MARGINS: [f64; 4] = [56.0, 20.0, 34.0, 46.0];
/// Width of a letter of a name, rather more than it takes, and its height.
const LETTER: [f64; 2] = [6.0, 10.0];
/// A point of a chart.
pub struct Mark {
    /// Beside it.
    pub name: String,
    /// Shown on hovering.
    pub hint: String,
    /// What it costs.
    pub x: f64,
    /// How good it is.
    pub y: f64,
    /// Whether nothing betters it.
    pub on_front: bool,
    /// Names it for scripts.
    pub index: usize,
}

/// A chart: `y` over the logarithm of `x`.
pub struct FrontChart<'a> {
    /// Above it.
    pub title: &'a str,
    /// Below it.
    pub x: &'a str,
    /// Beside it.
    pub y: &'a str,
    /// The points.
    pub marks: Vec<Mark>,
}

/// Boxes that names may not cover.
#[derive(Default)]
struct Taken(Vec<[f64; 4]>);

impl Taken {
    fn is_free(&self, area: &[f64; 4]) -> bool {
        let apart =
            |other: &[f64; 4]| area[2] <= other[0] || other[2] <= area[0] || area[3] <= other[1] || other[3] <= area[1];
        area[0] >= MARGINS[0]
            && area[2] <= SIZE[0]
            && area[1] >= 0.0
            && area[3] <= SIZE[1] - MARGINS[3]
            && self.0.iter().all(apart)
    }

    /// The corner where a name next to `(x, y)` covers nothing, or least far away; takes it.
    fn place(&mut self, name: &str, x: f64, y: f64) -> [f64; 2] {
        let width = LETTER[0] * name.chars().count() as f64;
        let area = |left: f64, top: f64| [left, top, left + width, top + LETTER[1]];
        let mut candidates = (0..40).flat_map(|ring| {
            let shift = 4.0 + 5.0 * f64::from(ring / 2);
            let up = [y - LETTER[1] / 2.0 - shift, y - LETTER[1] / 2.0 + shift];
            [x + 7.0, x - 7.0 - width, x - width / 2.0].into_iter().flat_map(move |left| up.map(|top| area(left, top)))
        });
        let place = candidates.find(|area| self.is_free(area));
        let place = place.unwrap_or_else(|| area((x + 7.0).min(SIZE[0] - width), y));
        self.0.push(place);
        [place[0], place[1] + LETTER[1] - 2.0]
    }
}

impl FrontChart<'_> {
    /// Draws the chart.
    #[must_use]
    pub fn svg(&self) -> String {
        let [left, right, top, bottom] = MARGINS;
        let x_axis = Axis::new(self.marks.iter().map(|mark| mark.x.log10()), left, SIZE[0] - right);
        let y_axis = Axis::new(self.marks.iter().map(|mark| mark.y), SIZE[1] - bottom, top);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n<g class=\"grid\">\n",
            SIZE[0],
            SIZE[1],
            escape(self.title)
        );
        for tick in x_axis.decimal_ticks() {
            let (x, low) = (x_axis.place(tick.log10()), SIZE[1] - bottom);
            _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {top}V{low}\"/><text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                low + 15.0,
                number(tick)
            );
        }
        for tick in y_axis.ticks() {
            let (y, high) = (y_axis.place(tick), SIZE[0] - right);
            _ = writeln!(
                svg,
                "<path d=\"M{left} {y:.1}H{high}\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                left - 6.0,
                y + 3.5,
                number(tick)
            );
        }
        let (middle_x, middle_y) = ((left + SIZE[0] - right) / 2.0, (top + SIZE[1] - bottom) / 2.0);
        _ = writeln!(
            svg,
            "</g>\n<text class=\"title\" x=\"{left}\" y=\"18\">{}</text><text x=\"{middle_x}\" y=\"{}\" text-anchor=\"middle\">{}</text><text transform=\"translate(14 {middle_y}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            escape(self.title),
            SIZE[1] - 10.0,
            escape(self.x),
            escape(self.y)
        );
        self.front(&mut svg, &x_axis, &y_axis);
        self.points(&mut svg, &x_axis, &y_axis);
        svg + "</svg>\n"
    }

    /// A staircase through the points of which none is both cheaper and better.
    fn front(&self, svg: &mut String, x_axis: &Axis, y_axis: &Axis) {
        let mut marks: Vec<&Mark> = self.marks.iter().collect();
        marks.sort_by(|a, b| a.x.total_cmp(&b.x).then(b.y.total_cmp(&a.y)));
        let mut best = f64::NEG_INFINITY;
        let mut path = String::new();
        for mark in marks {
            if mark.y > best {
                let (x, y) = (x_axis.place(mark.x.log10()), y_axis.place(mark.y));
                _ = if path.is_empty() { write!(path, "M{x:.1} {y:.1}") } else { write!(path, "H{x:.1}V{y:.1}") };
                best = mark.y;
            }
        }
        _ = writeln!(svg, "<path class=\"front\" d=\"{path}\"/>");
    }

    fn points(&self, svg: &mut String, x_axis: &Axis, y_axis: &Axis) {
        let place = |mark: &Mark| (x_axis.place(mark.x.log10()), y_axis.place(mark.y));
        let mut taken = Taken::default();
        for (x, y) in self.marks.iter().map(place) {
            taken.0.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
        }
        // The front's names find their places first.
        let mut marks: Vec<&Mark> = self.marks.iter().collect();
        marks.sort_by_key(|mark| !mark.on_front);
        for mark in marks {
            let (x, y) = place(mark);
            let [name_x, name_y] = taken.place(&mark.name, x, y);
            let class = if mark.on_front { "point best" } else { "point" };
            _ = writeln!(
                svg,
                "<g class=\"{class}\" data-index=\"{}\" tabindex=\"0\"><title>{}</title><path class=\"lead\" d=\"M{x:.1} {y:.1}L{name_x:.1} {:.1}\"/><circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/><text x=\"{name_x:.1}\" y=\"{name_y:.1}\">{}</text></g>",
                mark.index,
                escape(&mark.hint),
                name_y - 3.0,
                escape(&mark.name)
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(index: usize, x: f64, y: f64) -> Mark {
        let on_front = index == 0;
        Mark { name: format!("point<{index}>"), hint: format!("settings {index}"), x, y, on_front, index }
    }

    #[test]
    fn every_point_is_named_and_hinted_at_once() {
        let marks: Vec<_> =
            (0..30_u8).map(|i| mark(i.into(), 1.0 + f64::from(i % 3), 40.0 + f64::from(i % 2))).collect();
        let svg = FrontChart { title: "T", x: "ms", y: "dB", marks }.svg();
        assert_eq!((svg.matches("<circle").count(), svg.matches("<title>").count()), (30, 30));
        for index in 0..30 {
            assert_eq!(svg.matches(&format!(">point&lt;{index}&gt;</text>")).count(), 1, "{index}");
            assert!(svg.contains(&format!("<title>settings {index}</title>")), "{index}");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }

    #[test]
    fn one_point_alone_can_be_drawn() {
        let svg = FrontChart { title: "T", x: "ms", y: "dB", marks: vec![mark(0, 3.0, 0.0)] }.svg();
        assert!(!svg.contains("NaN") && svg.contains("class=\"point best\""), "{svg}");
    }

    #[test]
    fn names_do_not_cover_each_other() {
        let mut taken = Taken::default();
        let first = taken.place("a name", 300.0, 200.0);
        let second = taken.place("a name", 300.0, 200.0);
        assert_ne!(first, second);
        let [a, b] = [taken.0[0], taken.0[1]];
        assert!(a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1], "{a:?} {b:?}");
    }
}
