//! What GTKWave needs to show a waveform as what travels: a save file with a group for each record, and for each number format a
//! filter that turns words into numbers.

use pointcore_contract::splat::AttributeFormat;
use pointcore_contract::unit::{Group, Interface};
use pointcore_contract::{Format, search, splat};
use std::fmt::Write as _;
use std::path::Path;

/// How GTKWave's save files spell what a trace is: hexadecimal, on the right side; the same through a filter; a group's two ends.
const WORD: &str = "@22";
const NUMBER: &str = "@4022";
const GROUP_BEGIN: &str = "@800200";
const GROUP_END: &str = "@1000200";
/// The scope that Verilator puts the top module in.
const SCOPE: &str = "TOP";

/// A view of a core's ports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct View {
    groups: Vec<ShownGroup>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct ShownGroup {
    title: String,
    signals: Vec<Signal>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Signal {
    name: String,
    width: u32,
    format: Option<Format>,
}

/// A field's name without the number of its lane or attribute.
fn stem(field: &str) -> &str {
    field.trim_end_matches(|c: char| c.is_ascii_digit())
}

/// Names of the search core's fields that are numbers of its geometry; all others are integers.
const SEARCH_NUMBERS: [&str; 9] = ["x", "y", "z", "radius", "distance", "split", "reach", "far_scale", "margin_scale"];

/// The ports of a search core.
#[must_use]
pub fn search_view(config: &search::Config) -> View {
    let format = |_: &Group, field: &str| SEARCH_NUMBERS.contains(&stem(field)).then_some(config.geometry);
    View::of(&(search::units::top::UNIT.interface)(config), format)
}

/// The ports of a renderer.
#[must_use]
pub fn splat_view(config: &splat::Config) -> View {
    let attribute = match config.attribute {
        AttributeFormat::Float(format) => Some(format),
        AttributeFormat::Fixed(_) => None,
    };
    let format = |group: &Group, field: &str| match (group.name, stem(field)) {
        ("splat", field) if field.starts_with("center_") || field.starts_with("tangent") => Some(config.geometry),
        ("fragment", "depth") => Some(config.geometry),
        ("splat" | "fragment", "attribute_") => attribute,
        _ => None,
    };
    View::of(&(splat::units::top::UNIT.interface)(config), format)
}

impl View {
    fn of(interface: &Interface, format: impl Fn(&Group, &str) -> Option<Format>) -> Self {
        let shown = |group: &Group| {
            let flag = group.kind.has_flag().then_some(group.flag);
            let ready = group.kind.has_ready().then_some("ready");
            let bit = |part: &str| Signal { name: group.port_name(part), width: 1, format: None };
            let field = |field: &pointcore_contract::Field| Signal {
                name: group.port_name(&field.name),
                width: field.width,
                format: format(group, &field.name),
            };
            let signals = flag.into_iter().chain(ready).map(bit).chain(group.fields.iter().map(field)).collect();
            let title = if group.name.is_empty() { group.record } else { group.name }.to_owned();
            ShownGroup { title, signals }
        };
        let clock = ["clk", "rst"].map(|name| Signal { name: name.to_owned(), width: 1, format: None }).into();
        let clock = ShownGroup { title: "clock".to_owned(), signals: clock };
        Self { groups: std::iter::once(clock).chain(interface.groups.iter().map(shown)).collect() }
    }

    /// The number formats that are shown, each once.
    #[must_use]
    pub fn formats(&self) -> Vec<Format> {
        let mut formats = Vec::new();
        for format in self.groups.iter().flat_map(|group| &group.signals).filter_map(|signal| signal.format) {
            if !formats.contains(&format) {
                formats.push(format);
            }
        }
        formats
    }

    /// The save file for a waveform; `filters` is the folder of the filters. Both are absolute: GTKWave looks from where it is started.
    #[must_use]
    pub fn save_file(&self, waveform: &Path, filters: &Path) -> String {
        let formats = self.formats();
        let mut text = format!("[dumpfile] \"{}\"\n[sst_expanded] 1\n", waveform.display());
        for ShownGroup { title, signals } in &self.groups {
            _ = writeln!(text, "{GROUP_BEGIN}\n-{title}");
            for Signal { name, width, format } in signals {
                let place = format.and_then(|format| formats.iter().position(|known| *known == format));
                if let (Some(format), Some(place)) = (format, place) {
                    // A filter is loaded when its number first occurs.
                    _ = writeln!(text, "{NUMBER}\n^>{} {}", place + 1, filters.join(filter_name(*format)).display());
                } else {
                    _ = writeln!(text, "{WORD}");
                }
                let range = if *width > 1 { format!("[{}:0]", width - 1) } else { String::new() };
                _ = writeln!(text, "{SCOPE}.{name}{range}");
            }
            _ = writeln!(text, "{GROUP_END}\n-{title}");
        }
        text
    }

    /// Names and texts of the filters: each has `program`, this command, turn words into numbers.
    pub fn filters(&self, program: &Path) -> impl Iterator<Item = (String, String)> {
        let program = program.display().to_string().replace('\'', "'\\''");
        let filter = move |format| (filter_name(format), format!("#!/bin/sh\nexec '{program}' translate {format}\n"));
        self.formats().into_iter().map(filter)
    }
}

fn filter_name(format: Format) -> String {
    format.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::{ecp5, knn};

    #[test]
    fn records_are_groups_and_numbers_have_filters() {
        let text = search_view(&knn()).save_file(Path::new("/there/search.fst"), Path::new("/there"));
        assert!(text.starts_with("[dumpfile] \"/there/search.fst\""));
        for part in [
            "@800200\n-query\n@22\nTOP.query_valid\n@22\nTOP.query_ready\n",
            "@4022\n^>1 /there/f32-ftz\nTOP.query_x[31:0]\n",
            "@22\nTOP.query_number[23:0]\n",
            "^>1 /there/f32-ftz\nTOP.beat_z3[31:0]\n",
            "^>1 /there/f32-ftz\nTOP.result_distance2[31:0]\n",
        ] {
            assert!(text.contains(part), "{part} is missing in: {text}");
        }
        let known: Vec<_> = search::units::top::UNIT.ports(&knn());
        assert!(known.iter().all(|port| text.contains(&format!("TOP.{}", port.name))), "every port is there");
    }

    #[test]
    fn both_formats_of_a_renderer_are_told_apart() {
        let view = splat_view(&ecp5());
        assert_eq!(view.formats(), [ecp5().geometry, Format::F16]);
        let text = view.save_file(Path::new("/there/frame.fst"), Path::new("/there"));
        assert!(text.contains("TOP.fragment_depth[23:0]\n") && text.contains("^>2 /there/f16"), "{text}");
        assert!(text.contains("@22\nTOP.fragment_cardinal_0[15:0]"), "{text}");
        let filters: Vec<_> = view.filters(Path::new("/a b/point'core")).collect();
        assert_eq!(filters[1].1, "#!/bin/sh\nexec '/a b/point'\\''core' translate f16\n");
    }
}
