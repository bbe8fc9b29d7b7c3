//! No text makes the parser of programs panic or run on.

use pointcore_contract::process::Program;
use pointcore_contract::process::library::PROGRAMS;
use proptest::prelude::*;

/// Parts that lines are made of, more or less.
const PARTS: [&str; 40] = [
    ".program ",
    ".query ",
    ".neighbor ",
    ".state ",
    ".setting ",
    ".init",
    ".kernel",
    ".final",
    ".repeat ",
    ".end",
    "\n",
    "\n",
    "\n",
    "a",
    "b",
    "i ",
    "0 ",
    "3 ",
    "1.5",
    "-",
    "=",
    " = add ",
    " = dot ",
    " = select ",
    ",",
    "[",
    "]",
    "+",
    ": float",
    ": float3",
    "query.position",
    "neighbor",
    ".x",
    "accumulate ",
    "output ",
    "store ",
    "move ",
    " if ",
    "true",
    "9e99",
];

proptest! {
    #[test]
    fn any_characters_have_an_answer(text in ".{0,200}") {
        let _ = Program::parse("garbage", &text);
    }

    #[test]
    fn any_parts_have_an_answer(parts in prop::collection::vec(prop::sample::select(&PARTS[..]), 0..120)) {
        let _ = Program::parse("garbage", &format!(".program a\n{}", parts.concat()));
    }

    #[test]
    fn programs_with_a_part_replaced_have_an_answer(
        index in 0..PROGRAMS.len(),
        at: prop::sample::Index,
        length in 0..12_usize,
        part in prop::sample::select(&PARTS[..]),
    ) {
        let characters: Vec<char> = PROGRAMS[index].1.chars().collect();
        let from = at.index(characters.len());
        let behind = (from + length).min(characters.len());
        let [before, after] = [&characters[..from], &characters[behind..]].map(|part| part.iter().collect::<String>());
        let text = format!("{before}{part}{after}");
        if let Err(error) = Program::parse("mutant", &text) {
            prop_assert!(error.line >= 1 && error.line <= text.lines().count() && error.column >= 1, "{error}");
        }
    }
}
