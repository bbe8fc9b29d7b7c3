//! A rendered frame as a page: its pictures, where in the image and when its cycles go, and which hardware drew it.

mod hardware;
mod maps;
mod timeline;

use super::activity::Activity;
use super::report::SplatReport;
use super::sequence::FrameFigures;
use crate::page::{Bar, Page, bars, embedded, escape, grid, table};
use crate::picture::Picture;
use crate::plan::Plan;

/// Bytes of an animation that a page holds at most; a larger one is only named.
const ANIMATION_LIMIT: usize = 16 << 20;

/// A frame beside the f64 reference.
#[derive(Clone, Debug)]
pub struct FramePictures {
    /// The frame.
    pub frame: Picture,
    /// The reference.
    pub reference: Picture,
}

impl FramePictures {
    /// How much their difference is magnified to be seen: by a power of two that brings all but a hundredth of what differs into the
    /// picture's range. Beside it the largest difference, as a share of that range.
    fn magnification(&self) -> (f64, f64) {
        const LARGEST_EXPONENT: i32 = 16;
        let difference = self.frame.difference(&self.reference, 1.0);
        let mut apart: Vec<f64> = difference.pixels.into_iter().flatten().filter(|apart| *apart > 0.0).collect();
        apart.sort_by(f64::total_cmp);
        let Some(largest) = apart.last() else { return (1.0, 0.0) };
        let high = apart[(apart.len() - 1) * 99 / 100];
        (2.0_f64.powi((-high.log2().ceil() as i32).clamp(0, LARGEST_EXPONENT)), *largest)
    }
}

/// What stands still in a scene that moves, drawn by a core of its own.
#[derive(Clone, Debug)]
pub struct StillPart<'a> {
    /// Its figures.
    pub report: SplatReport,
    /// Its hardware.
    pub plan: &'a Plan,
}

/// What a page is made of.
pub struct RunPage<'a> {
    /// The frame's figures.
    pub report: &'a SplatReport,
    /// The frame's pictures.
    pub pictures: &'a FramePictures,
    /// What the core did.
    pub activity: &'a Activity,
    /// The hardware.
    pub plan: &'a Plan,
    /// What stands still, where the page tells of what moves.
    pub still: Option<&'a StillPart<'a>>,
    /// What is to be known of the scene.
    pub notes: &'a [String],
    /// All frames, if there are several; the page's frame is the first.
    pub sequence: &'a [FrameFigures],
    /// All frames' pictures as an animated PNG, if there are several.
    pub animation: Option<&'a [u8]>,
}

impl RunPage<'_> {
    /// The file.
    #[must_use]
    pub fn html(&self) -> String {
        let report = self.report;
        let page = Page::new(self.title()).figures(&self.figures()).section(
            "Picture",
            "Drag the slider: the frame lies to its left, what it is compared with to its right.",
            &self.comparison(),
        );
        let page = self.motion(page);
        let page = maps::add(page, self.activity);
        let page = timeline::add(page, self.activity, report);
        let page = page.section("Splats", &fates_sentence(report), &fates(report));
        let page = hardware::add(page, "Hardware", self.plan);
        let page = match self.still {
            Some(StillPart { report, plan }) => {
                let sentence = "Another core draws it, and the host lays it behind what moves, of which the rest of this page tells.";
                let page = page.section("What stands still", sentence, &report_table(report));
                hardware::add(page, "Hardware for what stands still", plan)
            }
            None => page,
        };
        let page = if self.notes.is_empty() {
            page
        } else {
            let items: String = self.notes.iter().map(|note| format!("<li>{}</li>\n", escape(note))).collect();
            page.section("To be known", "What was done to the model.", &format!("<ul>\n{items}</ul>"))
        };
        page.section("Report", "As in report.md and report.json.", &report_table(report))
            .style(include_str!("page.css"))
            .script(include_str!("compare.js"))
            .html()
    }

    fn title(&self) -> String {
        match self.sequence.len() {
            0 | 1 => format!("{}, drawn by the renderer", self.report.scene),
            frames => format!("{}, drawn by the renderer: the first of {frames} frames", self.report.scene),
        }
    }

    fn figures(&self) -> Vec<(&'static str, String)> {
        let report = self.report;
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let psnr = match report.psnr_db {
            Some(psnr_db) if psnr_db.is_finite() => format!("{psnr_db:.1} dB"),
            Some(_) => "equal".to_owned(),
            None => "–".to_owned(),
        };
        let mismatches = match report.mismatches {
            Some(count) => ("mismatches in lockstep", count.to_string()),
            None => ("mismatches, not compared", "–".to_owned()),
        };
        vec![
            ("splats drawn", report.fates.drawn.to_string()),
            ("cycles", report.cycles.to_string()),
            ("bound of the cycles", format!("{}, {}", percent(report.bound_fraction), report.bound.name)),
            ("cycles a sample", format!("{:.3}", report.cycles_per_sample)),
            ("PSNR against f64", psnr),
            mismatches,
            ("samples evaluated", report.samples.to_string()),
            ("fragments", report.fragments.to_string()),
            ("pixels", format!("{} × {}", report.width, report.height)),
            ("rasterizer busy", percent(report.rasterizer_utilisation)),
            ("accumulator busy", percent(report.accumulator_utilisation)),
        ]
    }

    /// Frame, reference and difference, two at a time.
    fn comparison(&self) -> String {
        let FramePictures { frame, reference } = self.pictures;
        let (magnification, largest) = self.pictures.magnification();
        let image = |name: &str, alt: &str, picture: &Picture| {
            format!("<img class=\"{name}\" alt=\"{alt}\" src=\"{}\">\n", embedded(&picture.png()))
        };
        let images = [
            image("reference", "f64 reference", reference),
            image("difference", "difference", &frame.difference(reference, magnification)),
            image("frame", "frame", frame),
        ]
        .concat();
        let (width, height) = (frame.width, frame.height);
        format!(
            "<div class=\"compare\" id=\"compare\" style=\"--width:{width};--height:{height}\">\n<div class=\"views\">\n{images}</div>\n\
             <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"where the frame ends\">\n\
             <p class=\"sides\"><span>frame</span><span class=\"other\"></span></p>\n\
             <p class=\"choices\"><label><input type=\"radio\" name=\"other\" value=\"reference\" checked> f64 reference</label>\n\
             <label><input type=\"radio\" name=\"other\" value=\"difference\" data-label=\"difference × {magnification}\"> \
             absolute difference, magnified {magnification} times; the largest is {:.3} % of the range</label></p>\n</div>",
            100.0 * largest
        )
    }

    /// All frames of a sequence.
    fn motion(&self, page: Page) -> Page {
        if self.sequence.len() < 2 {
            return page;
        }
        let animation = match self.animation {
            Some(bytes) if bytes.len() <= ANIMATION_LIMIT => {
                let FramePictures { frame: Picture { width, height, .. }, .. } = self.pictures;
                format!(
                    "<img class=\"animation\" style=\"--width:{width};--height:{height}\" alt=\"all frames\" src=\"{}\">\n",
                    embedded(bytes)
                )
            }
            _ => "<p>The animation is too large for this page: animation.png, beside it.</p>\n".to_owned(),
        };
        let rows: Vec<Vec<String>> = self
            .sequence
            .iter()
            .enumerate()
            .map(|(index, frame)| std::iter::once(index.to_string()).chain(frame.cells()).collect())
            .collect();
        let heads: Vec<&str> = std::iter::once("frame").chain(FrameFigures::HEADS).collect();
        let sentence = "All frames, as in animation.png. The rest of this page is about the first, as the figures of report.json are.";
        page.section("Sequence", sentence, &format!("{animation}{}", grid(&heads, &rows)))
    }
}

fn report_table(report: &SplatReport) -> String {
    let rows: Vec<_> = report.rows().into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    table(&rows)
}

fn fates_sentence(report: &SplatReport) -> String {
    format!(
        "What became of {} splats. Those drawn were cut into {} copies, one for each tile that they touch.",
        report.splats, report.fates.copies
    )
}

fn fates(report: &SplatReport) -> String {
    let fates = &report.fates;
    let bar = |(name, count): (&str, u64)| Bar {
        name: name.to_owned(),
        share: count as f64 / report.splats.max(1) as f64,
        figure: count.to_string(),
        is_marked: false,
    };
    let all = [
        ("drawn", fates.drawn),
        ("facing away", fates.facing),
        ("before the near plane", fates.near),
        ("behind the far plane", fates.far),
        ("beside the image", fates.beside),
    ];
    bars(&all.map(bar))
}

#[cfg(test)]
mod tests;
