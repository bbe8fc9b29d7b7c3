//! The picture: boxes in a column, and lines in lanes beside it.

use std::fmt::Write as _;

use super::{Edge, Node};
use crate::chart::escape;

/// Everything in pixels.
const BOX_WIDTH: u32 = 250;
/// From one line that ends at a box's side to the next.
const PITCH: u32 = 20;
const BOX_HEIGHT_MIN: u32 = 62;
const GAP: u32 = 34;
const MARGIN: u32 = 14;
/// What a label beside a box takes: room for the longest is left.
const LETTER: u32 = 7;
const LABEL_MIN: u32 = 96;
const LABEL_GAP: u32 = 12;
const LANE: u32 = 12;
const HEADING: u32 = 12;
/// Letters of a box's description a line, and lines.
const LINE_LETTERS: usize = 36;
const LINES: usize = 2;

const STYLE: &str = "<style>\
text{font:13px system-ui,sans-serif;fill:#1b2733}.name{font-weight:600}.doc{font-size:11px;fill:#51606e}.label{font-size:11.5px;fill:#0b5c8a}\
rect{fill:#f2f6fa;stroke:#7b8a99}path{fill:none;stroke:#0b7bb8;stroke-width:1.4}.head{fill:#0b7bb8;stroke:none}\
@media(prefers-color-scheme:dark){text{fill:#e6edf3}.doc{fill:#a5b4c3}.label{fill:#7cc4ef}rect{fill:#1c2733;stroke:#66788a}path{stroke:#58b1e6}.head{fill:#58b1e6}}\
</style>";

/// The side of the boxes along which a line runs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

/// A line in the picture.
struct Line<'a> {
    edge: &'a Edge,
    route: Route,
}

enum Route {
    /// To the box below.
    Down { from: usize, to: usize },
    /// Along a side, in a lane of its own: the boxes and slots where it begins and ends.
    Lane { side: Side, lane: u32, ends: [(usize, u32); 2] },
    /// In or out of the core.
    Outside { node: usize, slot: u32, comes_in: bool },
}

/// What stands at one side of the boxes.
#[derive(Default)]
struct Beside {
    /// By box: lines that end there.
    slots: Vec<u32>,
    /// Lines that do not overlap share a lane.
    lanes: Vec<Vec<[usize; 2]>>,
    /// The longest label.
    label: u32,
}

impl Beside {
    fn new(nodes: usize) -> Self {
        Self { slots: vec![0; nodes], lanes: vec![], label: LABEL_MIN }
    }

    /// The next place for a line that ends at a box.
    fn slot(&mut self, node: usize, label: &str) -> u32 {
        self.label = self.label.max(label.chars().count() as u32 * LETTER + LABEL_GAP);
        self.slots[node] += 1;
        self.slots[node] - 1
    }

    /// The first lane in which no line overlaps `span`.
    fn lane(&mut self, span: [usize; 2]) -> u32 {
        let is_free = |lane: &Vec<[usize; 2]>| lane.iter().all(|other| other[1] < span[0] || span[1] < other[0]);
        let lane = self.lanes.iter().position(is_free).unwrap_or_else(|| {
            self.lanes.push(vec![]);
            self.lanes.len() - 1
        });
        self.lanes[lane].push(span);
        lane as u32
    }

    /// How far a lane is from the boxes.
    fn offset(&self, lane: u32) -> u32 {
        self.label + MARGIN + lane * LANE
    }

    fn width(&self) -> u32 {
        self.offset(self.lanes.len() as u32) + MARGIN
    }
}

struct Layout<'a> {
    lines: Vec<Line<'a>>,
    heights: Vec<u32>,
    tops: Vec<u32>,
    sides: [Beside; 2],
}

impl<'a> Layout<'a> {
    fn new(nodes: usize, edges: &'a [Edge]) -> Self {
        let mut sides = [Beside::new(nodes), Beside::new(nodes)];
        let mut sorted: Vec<&Edge> = edges.iter().collect();
        // Short lines lie inside long ones.
        sorted.sort_by_key(|edge| edge.from.zip(edge.to).map_or(0, |(from, to)| from.abs_diff(to)));
        let route = |edge: &'a Edge| Line { edge, route: Route::of(edge, &mut sides) };
        let lines: Vec<_> = sorted.into_iter().map(route).collect();
        let slots = |node: usize| sides.iter().map(|side| side.slots[node]).fold(0, u32::max);
        let heights: Vec<_> = (0..nodes).map(|node| (slots(node) * PITCH + PITCH).max(BOX_HEIGHT_MIN)).collect();
        let tops = heights.iter().scan(HEADING, |top, height| {
            let here = *top;
            *top += height + GAP;
            Some(here)
        });
        Self { lines, tops: tops.collect(), heights, sides }
    }

    fn left(&self) -> u32 {
        self.sides[Side::Left as usize].width()
    }

    fn right(&self) -> u32 {
        self.left() + BOX_WIDTH
    }

    fn size(&self) -> [u32; 2] {
        let bottom = self.tops.last().zip(self.heights.last()).map_or(0, |(top, height)| top + height);
        [self.right() + self.sides[Side::Right as usize].width(), bottom + MARGIN]
    }

    /// The height at which a slot of a box lies.
    fn slot(&self, node: usize, slot: u32) -> u32 {
        self.tops[node] + PITCH + slot * PITCH
    }

    /// A line's path, and where its label stands.
    fn geometry(&self, line: &Line) -> (String, [u32; 2], &'static str) {
        let (left, right) = (self.left(), self.right());
        match line.route {
            Route::Down { from, to } => {
                let (x, y) = (left + BOX_WIDTH / 2, self.tops[from] + self.heights[from]);
                (format!("M{x} {y}V{}", self.tops[to]), [x + 8, y + GAP / 2 + 4], "start")
            }
            Route::Lane { side, lane, ends } => {
                let [begin, end] = ends.map(|(node, slot)| self.slot(node, slot));
                let offset = self.sides[side as usize].offset(lane);
                let (edge, far, text, anchor) = match side {
                    Side::Right => (right, right + offset, right + LABEL_GAP, "start"),
                    Side::Left => (left, left - offset, left - LABEL_GAP, "end"),
                };
                (format!("M{edge} {begin}H{far}V{end}H{edge}"), [text, end - 4], anchor)
            }
            Route::Outside { node, slot, comes_in } => {
                let (y, far) = (self.slot(node, slot), left - self.sides[Side::Left as usize].label);
                let path = if comes_in { format!("M{far} {y}H{left}") } else { format!("M{left} {y}H{far}") };
                (path, [left - LABEL_GAP, y - 4], "end")
            }
        }
    }
}

impl Route {
    fn of(edge: &Edge, sides: &mut [Beside; 2]) -> Self {
        match (edge.from, edge.to) {
            (Some(from), Some(to)) if to == from + 1 => Self::Down { from, to },
            (Some(from), Some(to)) => {
                let side = if from < to { Side::Right } else { Side::Left };
                let beside = &mut sides[side as usize];
                let lane = beside.lane([from.min(to), from.max(to)]);
                let ends = [(from, beside.slot(from, "")), (to, beside.slot(to, &edge.label))];
                Self::Lane { side, lane, ends }
            }
            (from, to) => {
                let node = from.or(to).unwrap_or_default();
                let slot = sides[Side::Left as usize].slot(node, &edge.label);
                Self::Outside { node, slot, comes_in: to.is_some() }
            }
        }
    }
}

/// A description in lines that fit a box; what does not is left out.
fn lines(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("there is a line");
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > LINE_LETTERS {
            lines.push(word.to_owned());
        } else {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    if lines.len() > LINES {
        lines.truncate(LINES);
        lines[LINES - 1].push_str(" …");
    }
    lines
}

/// The picture as SVG.
pub(super) fn draw(title: &str, nodes: &[Node], edges: &[Edge]) -> String {
    let layout = Layout::new(nodes.len(), edges);
    let [width, height] = layout.size();
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <title>{}</title>\n{STYLE}\n\
         <marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">\
         <polygon class=\"head\" points=\"0 0,8 4,0 8\"/></marker>\n",
        escape(title)
    );
    for (node, (top, height)) in nodes.iter().zip(layout.tops.iter().zip(&layout.heights)) {
        let (x, y) = (layout.left(), top);
        let _ = writeln!(out, r#"<rect x="{x}" y="{y}" width="{BOX_WIDTH}" height="{height}" rx="6"/>"#);
        let text = x + MARGIN;
        let _ = writeln!(
            out,
            r#"<text class="name" x="{text}" y="{}">{}</text>"#,
            y + 20,
            escape(&node.name.replace('_', " "))
        );
        for (line, number) in lines(node.doc).iter().zip(0..) {
            let y = y + 37 + number * 14;
            let _ = writeln!(out, r#"<text class="doc" x="{text}" y="{y}">{}</text>"#, escape(line));
        }
    }
    for line in &layout.lines {
        let (path, [x, y], anchor) = layout.geometry(line);
        let label = escape(&line.edge.label);
        let _ = writeln!(out, r#"<path d="{path}" marker-end="url(#head)"/>"#);
        let _ = writeln!(out, r#"<text class="label" x="{x}" y="{y}" text-anchor="{anchor}">{label}</text>"#);
    }
    out + "</svg>\n"
}
