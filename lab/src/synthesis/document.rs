//! The tables of a document, made from the record of measurements.

use super::{AreaEntry, AreaLine, AreaRecord, Style, Target, table};

/// What a line begins with that stands before a table; the target follows.
const TABLE_BEGIN: &str = "<!-- area ";
/// The line that stands after a table.
const TABLE_END: &str = "<!-- end of area -->";

impl AreaRecord {
    /// A document with its tables written anew: whatever stands between a line `<!-- area TARGET … -->` and `<!-- end of area -->`.
    ///
    /// # Errors
    /// There is no table, or one has no end or is of an unknown target.
    pub fn tabulate(&self, document: &str) -> Result<String, String> {
        let mut written = String::new();
        let mut lines = document.lines().enumerate();
        let mut tables = 0;
        while let Some((number, line)) = lines.next() {
            written += line;
            written.push('\n');
            let Some(rest) = line.strip_prefix(TABLE_BEGIN) else { continue };
            let place = format!("line {}", number + 1);
            let name = rest.split([' ', ':']).next().unwrap_or_default();
            let target = Target::ALL.into_iter().find(|target| target.name() == name);
            let target = target
                .ok_or_else(|| format!("{place}: unknown target `{name}`: expected ecp5, ice40, xilinx7 or gates"))?;
            let entries = self.entries().iter().filter(|entry| entry.target == target);
            let line =
                |entry: &AreaEntry| AreaLine { measurement: entry.measurement(), revision: entry.revision.clone() };
            let lines_of_target: Vec<_> = entries.map(line).collect();
            written += &format!("\n{}\n{TABLE_END}\n", table(target, &lines_of_target, Style::Markdown));
            lines
                .by_ref()
                .find(|(_, line)| *line == TABLE_END)
                .ok_or_else(|| format!("{place}: the table has no end: expected a line `{TABLE_END}`"))?;
            tables += 1;
        }
        if tables == 0 {
            return Err(format!("no table: expected a line `{TABLE_BEGIN}TARGET -->`, and `{TABLE_END}` after it"));
        }
        Ok(written)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::{DeviceArea, Measurement};

    #[test]
    fn a_table_is_written_between_its_marks() {
        let area = DeviceArea { lut: 42, ..DeviceArea::default() };
        let measurement =
            Measurement { unit: "f32_add".into(), area, timing: None, fmax_mhz: Vec::new(), first_seed: 1 };
        let mut record = AreaRecord::default();
        record.insert(AreaEntry::new(Target::Ecp5, None, String::new(), Vec::new(), measurement));
        let text = record.tabulate("before\n<!-- area ecp5: made by a command -->\nold\n<!-- end of area -->\nafter\n");
        let text = text.unwrap_or_else(|error| panic!("{error}"));
        assert!(text.starts_with("before\n<!-- area ecp5: made by a command -->\n\n| unit |"), "{text}");
        assert!(text.ends_with("|\n\n<!-- end of area -->\nafter\n") && text.contains("| `f32_add` | 42 |"), "{text}");
        assert_eq!(record.tabulate(&text), Ok(text.clone()), "writing it again changes nothing");
        for (document, part) in [
            ("nothing", "no table"),
            ("<!-- area ecp6 -->\n<!-- end of area -->", "line 1: unknown target `ecp6`"),
            ("\n<!-- area ecp5 -->\n", "line 2: the table has no end"),
        ] {
            let error = record.tabulate(document).unwrap_err();
            assert!(error.contains(part), "{error}");
        }
    }
}
