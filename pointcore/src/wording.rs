//! What is wrong with a TOML file, in the words of its format: the parser's own speak of types of this program.

use std::fmt::Display;

/// How the parser calls what it expects, and what a reader of the file calls it.
const WORDS: [(&[&str], &str); 5] = [
    (&["u8", "u16", "u32", "u64", "usize"], "a whole number from 0 up"),
    (&["i8", "i16", "i32", "i64", "isize"], "a whole number"),
    (&["f32", "f64"], "a number"),
    (&["a map"], "a table"),
    (&["a sequence"], "a list"),
];
const EXPECTED: &str = "expected ";

/// The message of an error, without types of this program.
#[must_use]
pub fn plain(error: &impl Display) -> String {
    let message = error.to_string();
    let lines: Vec<String> = message.trim_end().lines().map(line).collect();
    lines.join("\n")
}

fn line(line: &str) -> String {
    // Quoted text is the user's own.
    if line.contains(" | ") {
        return line.to_owned();
    }
    let line = line
        .replace("` as i128", "`")
        .replace("unit variant, expected string only", "not text, expected a word in quotes")
        .replace("invalid digit found in string", "expected a whole number from 0 up")
        .replace("invalid float literal", "expected a number");
    let line = line.replace("wanted string or table", "expected a word in quotes");
    let Some((found, expected)) = line.split_once(EXPECTED) else { return line };
    let word = expected.trim_end();
    let known = WORDS.iter().find(|(types, _)| types.contains(&word)).map(|(_, plain)| *plain);
    let plain = if word.starts_with("struct ") { Some("a table") } else { known };
    plain.map_or_else(|| line.clone(), |plain| format!("{found}{EXPECTED}{plain}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_of_the_program_become_words_of_the_file() {
        for (message, words) in [
            ("invalid type: integer `3`, expected struct ImageTable", "invalid type: integer `3`, expected a table"),
            ("invalid length 0, expected struct Light with 6 elements", "invalid length 0, expected a table"),
            (
                "invalid value: integer `-3`, expected usize\nin `a`",
                "invalid value: integer `-3`, expected a whole number from 0 up\nin `a`",
            ),
            ("invalid type: unit variant, expected string only", "invalid type: not text, expected a word in quotes"),
            ("1 | a = \"expected u32\"\n  |   ^\nunknown", "1 | a = \"expected u32\"\n  |   ^\nunknown"),
            ("invalid type: integer `9` as i128, expected f64", "invalid type: integer `9`, expected a number"),
            ("expected an array of length 3", "expected an array of length 3"),
        ] {
            assert_eq!(plain(&message), words);
        }
    }
}
