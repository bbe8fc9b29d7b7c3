//! What commands write into documents that people write: tables between two lines of comment.

/// A document without the place for a table.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MarkError {
    /// No line begins it.
    #[error("no table: expected a line `<!-- {0} -->`, and `<!-- end of {1} -->` after it")]
    Missing(String, String),
    /// No line ends it.
    #[error("line {0}: the table has no end: expected a line `<!-- end of {1} -->`")]
    Unended(usize, String),
}

/// The document with `table` in the place of what is between a line that begins with `<!-- NAME` and the next
/// `<!-- end of WORD -->`, where the word is the name's first.
///
/// # Errors
/// The lines are not there.
pub fn replace(document: &str, name: &str, table: &str) -> Result<String, MarkError> {
    let word = name.split(' ').next().unwrap_or(name).to_owned();
    let end = format!("<!-- end of {word} -->");
    let begins = |line: &str| {
        let rest = line.strip_prefix("<!-- ").and_then(|line| line.strip_prefix(name));
        rest.is_some_and(|rest| rest.starts_with([' ', ':']))
    };
    let mut lines = document.lines().enumerate();
    let mut written = String::new();
    let mut tables = 0;
    while let Some((number, line)) = lines.next() {
        written += &format!("{line}\n");
        if begins(line) {
            lines
                .by_ref()
                .find(|(_, line)| *line == end)
                .ok_or_else(|| MarkError::Unended(number + 1, word.clone()))?;
            written += &format!("\n{}\n\n{end}\n", table.trim_end());
            tables += 1;
        }
    }
    if tables == 0 { Err(MarkError::Missing(name.to_owned(), word)) } else { Ok(written) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_written_between_its_marks() {
        let document = "before\n<!-- soak: by a command -->\nold\n<!-- end of soak -->\nafter\n";
        let written = replace(document, "soak", "| a |\n").unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(written, "before\n<!-- soak: by a command -->\n\n| a |\n\n<!-- end of soak -->\nafter\n");
        assert_eq!(replace(&written, "soak", "| a |\n"), Ok(written.clone()), "writing it again changes nothing");
        assert_eq!(replace("nothing", "soak", ""), Err(MarkError::Missing("soak".into(), "soak".into())));
        assert_eq!(replace("\n<!-- soak units -->\n", "soak units", ""), Err(MarkError::Unended(2, "soak".into())));
    }
}
