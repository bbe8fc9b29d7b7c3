//! Points over what they cost, as SVG: those that nothing betters are named and joined by a line, the others tell their names and
//! settings on hovering.

use super::names::{Area, GAP, LETTER, Taken, nearest};
use super::{Axis, escape, number};
use std::fmt::Write as _;

/// Left, right, top and bottom.
const MARGINS: [f64; 4] = [50.0, 14.0, 34.0, 44.0];
/// Half the side of a point's box.
const POINT: f64 = 5.0;
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
    /// Width and height in px.
    pub size: [f64; 2],
}

impl FrontChart<'_> {
    /// Draws the chart.
    #[must_use]
    pub fn svg(&self) -> String {
        let [left, right, top, bottom] = MARGINS;
        let [width, height] = self.size;
        let x_axis = Axis::new(self.marks.iter().map(|mark| mark.x.log10()), left, width - right);
        let y_axis = Axis::new(self.marks.iter().map(|mark| mark.y), height - bottom, top);
        let mut svg = format!(
            "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">\n<g class=\"grid\">\n",
            escape(self.title)
        );
        let mut last = f64::NEG_INFINITY;
        for tick in x_axis.decimal_ticks() {
            let (x, low) = (x_axis.place(tick.log10()), height - bottom);
            let (text, half) = (number(tick), LETTER[0] * number(tick).chars().count() as f64 / 2.0);
            // Numbers keep apart, and within the chart.
            let text = if x - half > last + LETTER[0] && x + half < width { text } else { String::new() };
            last = if text.is_empty() { last } else { x + half };
            _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {top}V{low}\"/><text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                low + 16.0,
                escape(&text)
            );
        }
        for tick in y_axis.ticks() {
            let (y, high) = (y_axis.place(tick), width - right);
            _ = writeln!(
                svg,
                "<path d=\"M{left} {y:.1}H{high}\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                left - 6.0,
                y + 3.5,
                number(tick)
            );
        }
        let (middle_x, middle_y) = ((left + width - right) / 2.0, (top + height - bottom) / 2.0);
        _ = writeln!(
            svg,
            "</g>\n<text class=\"title\" x=\"{left}\" y=\"18\">{}</text><text x=\"{middle_x}\" y=\"{}\" text-anchor=\"middle\">{}</text><text transform=\"translate(14 {middle_y}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            escape(self.title),
            height - 10.0,
            escape(self.x),
            escape(self.y)
        );
        let front = self.front(&x_axis, &y_axis);
        let line: Vec<String> = front.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        _ = writeln!(svg, "<polyline class=\"front\" points=\"{}\"/>", line.join(" "));
        self.points(&mut svg, &x_axis, &y_axis, &front);
        svg + "</svg>\n"
    }

    /// The corners of a staircase through the points of which none is both cheaper and better.
    fn front(&self, x_axis: &Axis, y_axis: &Axis) -> Vec<[f64; 2]> {
        let mut marks: Vec<&Mark> = self.marks.iter().collect();
        marks.sort_by(|a, b| a.x.total_cmp(&b.x).then(b.y.total_cmp(&a.y)));
        let mut best = f64::NEG_INFINITY;
        let mut corners: Vec<[f64; 2]> = Vec::new();
        for mark in marks {
            if mark.y > best {
                let (x, y) = (x_axis.place(mark.x.log10()), y_axis.place(mark.y));
                corners.extend(corners.last().map(|last| [x, last[1]]));
                corners.push([x, y]);
                best = mark.y;
            }
        }
        corners
    }

    fn points(&self, svg: &mut String, x_axis: &Axis, y_axis: &Axis, front: &[[f64; 2]]) {
        let place = |mark: &Mark| (x_axis.place(mark.x.log10()), y_axis.place(mark.y));
        let [left, _, top, bottom] = MARGINS;
        let points = self.marks.iter().map(place).map(|(x, y)| [x - POINT, y - POINT, x + POINT, y + POINT]).collect();
        let room = [left + 2.0, top, self.size[0], self.size[1] - bottom - 2.0];
        let line = |ends: &[[f64; 2]]| {
            let [[x, y], [other_x, other_y]] = [ends[0], ends[1]];
            [x.min(other_x) - 1.0, y.min(other_y) - 1.0, x.max(other_x) + 1.0, y.max(other_y) + 1.0]
        };
        let lines = front.windows(2).map(line).collect();
        let mut taken = Taken::new(room, points, lines);
        // What is drawn last lies on top: the front.
        let mut marks: Vec<&Mark> = self.marks.iter().collect();
        marks.sort_by_key(|mark| mark.on_front);
        for mark in marks {
            let (x, y) = place(mark);
            let area = if mark.on_front { taken.place(&mark.name, x, y) } else { None };
            let class = if mark.on_front { "point best" } else { "point" };
            _ = write!(
                svg,
                "<g class=\"{class}\" data-index=\"{}\" tabindex=\"0\"><title>{}</title>",
                mark.index,
                escape(&mark.hint)
            );
            if let Some(area) = area {
                let [lead_x, lead_y] = nearest(&area, x, y);
                if (lead_x - x).hypot(lead_y - y) > 1.5 * GAP {
                    _ = write!(svg, "<path class=\"lead\" d=\"M{x:.1} {y:.1}L{lead_x:.1} {lead_y:.1}\"/>");
                }
            }
            _ = write!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>");
            _ = writeln!(svg, "{}</g>", self.name(mark, area, [x, y]));
        }
    }

    /// A point's name: where it has room, else over all others, for as long as the point is chosen.
    fn name(&self, mark: &Mark, area: Option<Area>, [x, y]: [f64; 2]) -> String {
        let (class, x, y) = match area {
            Some([left, _, right, low]) => ("name", (left + right) / 2.0, low - 2.5),
            None => {
                let half = LETTER[0] * mark.name.chars().count() as f64 / 2.0;
                let (low, high) = (half, (self.size[0] - half).max(half));
                let above = y - GAP - 2.0;
                (
                    "name hidden",
                    x.clamp(low, high),
                    if above - LETTER[1] > MARGINS[2] { above } else { y + GAP + LETTER[1] },
                )
            }
        };
        let name = escape(&mark.name);
        format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">{name}</text>")
    }
}

#[cfg(test)]
mod tests {
    use super::super::names::overlap;
    use super::*;

    fn mark(index: usize, x: f64, y: f64) -> Mark {
        let on_front = index == 0;
        Mark { name: format!("point<{index}>"), hint: format!("settings {index}"), x, y, on_front, index }
    }

    /// What follows each occurrence of some text.
    fn after<'a>(svg: &'a str, text: &'a str) -> impl Iterator<Item = &'a str> {
        svg.split(text).skip(1)
    }

    fn leading(text: &str) -> f64 {
        text.split('"').next().and_then(|text| text.parse().ok()).expect("an attribute is a number")
    }

    /// The boxes of the names that are always there, a little smaller: coordinates are rounded.
    fn names(svg: &str) -> Vec<Area> {
        let area = |name: &str| {
            let rest = after(name, "y=\"").next().expect("it has a place");
            let text = after(rest, ">").next().and_then(|text| text.split('<').next()).expect("it has a text");
            let (x, low) = (leading(name), leading(rest) + 2.5);
            let half = LETTER[0] * text.chars().count() as f64 / 2.0 - 0.1;
            [x - half, low - LETTER[1] + 0.1, x + half, low - 0.1]
        };
        after(svg, "<text class=\"name\" x=\"").map(area).collect()
    }

    #[test]
    fn every_point_is_there_and_tells_its_settings() {
        let marks: Vec<_> =
            (0..30_u8).map(|i| mark(i.into(), 1.0 + f64::from(i % 3), 40.0 + f64::from(i % 2))).collect();
        let svg = FrontChart { title: "T", x: "ms", y: "dB", marks, size: [560.0, 400.0] }.svg();
        assert_eq!((svg.matches("<circle").count(), svg.matches("<title>").count()), (30, 30));
        for index in 0..30 {
            assert_eq!(svg.matches(&format!(">point&lt;{index}&gt;</text>")).count(), 1, "{index}");
            assert!(svg.contains(&format!("<title>settings {index}</title>")), "{index}");
        }
        assert_eq!(svg.matches("class=\"name hidden\"").count(), 29, "only the front is named");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }

    #[test]
    fn one_point_alone_can_be_drawn() {
        let marks = vec![mark(0, 3.0, 0.0)];
        let svg = FrontChart { title: "T", x: "ms", y: "dB", marks, size: [560.0, 400.0] }.svg();
        assert!(!svg.contains("NaN") && svg.contains("class=\"point best\""), "{svg}");
    }

    #[test]
    fn names_cover_neither_each_other_nor_points_nor_the_title() {
        for size in [[560.0, 400.0], [360.0, 380.0]] {
            let best = |i: u8| {
                let mark = mark(i.into(), 1.0 + f64::from(i / 5) / 9.0, 40.0 + f64::from(i));
                Mark { on_front: true, name: format!("a point {i}"), ..mark }
            };
            let marks: Vec<_> = (0..40).map(best).collect();
            let chart = FrontChart { title: "T", x: "ms", y: "dB", marks, size };
            let svg = chart.svg();
            let names = names(&svg);
            assert!(names.len() >= 10, "{} of 40 found room", names.len());
            let point = |circle: &str| {
                let (x, y) = (leading(circle), leading(after(circle, "cy=\"").next().expect("it has a place")));
                [x - 3.9, y - 3.9, x + 3.9, y + 3.9]
            };
            let points: Vec<Area> = after(&svg, "<circle cx=\"").map(point).collect();
            assert_eq!(points.len(), 40);
            for (index, name) in names.iter().enumerate() {
                assert!(!names[..index].iter().chain(&points).any(|other| overlap(name, other)), "{name:?}");
                assert!(name[1] >= MARGINS[2] && name[0] >= MARGINS[0] && name[2] <= size[0], "{name:?}");
            }
        }
    }
}
