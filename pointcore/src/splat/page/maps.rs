//! Maps of the image: a canvas each, with the counts as an image that a script reads.

use crate::page::{Page, embedded, escape};
use crate::picture::png;
use crate::splat::activity::{Activity, Map};
use pointcore_contract::splat::config::TILE_SIZE;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// A map with its words.
struct Titled {
    title: &'static str,
    /// What is counted.
    meaning: &'static str,
    /// Places along the edge of a cell.
    cell: u32,
    map: Map,
}

impl Titled {
    fn height(&self) -> usize {
        self.map.counts.len() / self.map.width
    }

    /// The counts as red, green and blue of a lossless image, the largest digit in red.
    fn data(&self) -> Value {
        const LARGEST: u32 = 0x00ff_ffff;
        let bytes = |count: &u32| {
            let [_, red, green, blue] = (*count).min(LARGEST).to_be_bytes();
            [red, green, blue]
        };
        let bytes: Vec<u8> = self.map.counts.iter().flat_map(bytes).collect();
        let Self { title, cell, .. } = *self;
        let size = [self.map.width, self.height()];
        json!({ "title": title, "cell": cell, "size": size, "sum": self.map.sum(), "image": embedded(&png(&bytes, size)) })
    }

    fn figure(&self, index: usize) -> String {
        let (title, meaning) = (escape(self.title), escape(self.meaning));
        let (width, height) = (self.map.width, self.height());
        format!(
            "<figure class=\"map\" data-map=\"{index}\" style=\"--width:{width};--height:{height}\">\n<h3>{title}</h3>\n<p>{meaning}</p>\n\
             <canvas aria-label=\"{title}\"></canvas>\n<span class=\"scale\"></span><p class=\"ticks\"><span></span><span></span><span></span></p>\n\
             <p class=\"words\"></p>\n</figure>\n"
        )
    }
}

fn maps(activity: &Activity) -> Vec<Titled> {
    let samples = activity.samples().into_iter().flat_map(|samples| {
        [
            (
                "Samples evaluated",
                "Samples that the rasterizer evaluates, inside their splat or not.",
                samples.evaluated(),
            ),
            ("Overdraw", "Samples inside their splat: those that reach the pixel.", samples.inside()),
            ("Hazards", "Cycles in which a sample waits for an earlier one of the same pixel.", samples.hazards()),
        ]
    });
    let written_back = (
        "Pixels written back",
        "Pixels of a tile that leave the tile cache for the reconstruction buffer.",
        activity.written_back(),
    );
    let mut maps: Vec<_> = samples.map(|(title, meaning, map)| Titled { title, meaning, cell: 1, map }).collect();
    let (title, meaning, map) = written_back;
    maps.push(Titled { title, meaning, cell: TILE_SIZE, map });
    maps
}

/// Adds the section.
pub fn add(page: Page, activity: &Activity) -> Page {
    let maps = maps(activity);
    let sentence = if activity.samples().is_some() {
        "Counts by pixel of the reconstruction buffer, seen in the streams between the units of the golden model, which keeps step with the hardware in every cycle. \
         Each has a color scale of its own."
    } else {
        "Hardware without its golden model shows its ports alone: pixels written back are seen there. Samples, overdraw and hazards by place need \
         the model: run with --model golden, or in lockstep without a waveform."
    };
    let mut html = String::new();
    if activity.samples().is_some() {
        html += "<p class=\"choices\"><label><input type=\"radio\" name=\"cells\" value=\"pixel\" checked> by pixel</label>\n\
                 <label><input type=\"radio\" name=\"cells\" value=\"tile\"> by tile</label></p>\n";
    }
    html += "<div class=\"maps\">\n";
    for (index, map) in maps.iter().enumerate() {
        _ = write!(html, "{}", map.figure(index));
    }
    html += "</div>";
    let data = json!({ "tile": TILE_SIZE, "maps": maps.iter().map(Titled::data).collect::<Vec<_>>() });
    page.section("Where the work is", sentence, &html).data("maps", data).script(include_str!("maps.js"))
}
