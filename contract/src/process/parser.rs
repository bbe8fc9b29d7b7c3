//! From a text to a program: declarations, then the blocks in order.

use super::block::Block;
use super::builder::Builder;
use super::declaration::declare;
use super::error::{Fault, ProgramError};
use super::layout::Layout;
use super::lexer::{Cursor, Kind, Line, Located, lines};
use super::program::{Program, Section};
use super::statement::statement;

/// Statements of a block after its repetitions are unrolled, turns without any included: more is a mistake, not a data
/// path.
const STATEMENTS_MAX: usize = 10_000;

/// Repetitions within each other.
const REPETITIONS_MAX: usize = 8;

impl Program {
    /// The program of a text; `file` is what errors call it.
    ///
    /// # Errors
    /// The first mistake of the text, with its place.
    pub fn parse(file: &str, text: &str) -> Result<Self, ProgramError> {
        let lines = lines(file, text)?;
        let end = text.lines().count().max(1);
        let mut program = Self {
            name: String::new(),
            text: text.to_owned(),
            query: Layout::of_point(),
            neighbor: Layout::of_point(),
            state: Layout::default(),
            settings: Layout::default(),
            sums: Layout::default(),
            outputs: Layout::default(),
            blocks: Default::default(),
        };
        let read = read(&mut program, &lines);
        read.map_err(|(line, (column, fault))| {
            let line = line.unwrap_or(end);
            ProgramError { file: file.to_owned(), line, column, fault }
        })?;
        Ok(program)
    }
}

/// As [`Located`], with the line; without one it is the end of the text.
type Placed<T> = Result<T, (Option<usize>, (usize, Fault))>;

fn on<T>(line: &Line, result: Located<T>) -> Placed<T> {
    result.map_err(|error| (Some(line.number), error))
}

fn missing<T>(what: &'static str) -> Placed<T> {
    Err((None, (1, Fault::Missing(what))))
}

fn read(program: &mut Program, lines: &[Line]) -> Placed<()> {
    let Some((first, rest)) = lines.split_first() else { return missing("`.program`, its name") };
    program.name = on(first, header(first))?;
    let blocks = rest.iter().position(|line| section(line).is_some()).unwrap_or(rest.len());
    let (declarations, mut rest) = rest.split_at(blocks);
    for line in declarations {
        on(line, declare(program, line))?;
    }
    let mut last = None;
    while let Some((line, behind)) = rest.split_first() {
        let Some(section) = section(line) else { unreachable!("the lines are split where blocks begin") };
        if last >= Some(section) {
            let fault = Fault::Misplaced {
                statement: format!(".{}", section.name()),
                section: last.map_or("", Section::name).to_owned(),
                place: "the order of `.init`, `.kernel`, `.final`",
            };
            return on(line, Err((1, fault)));
        }
        last = Some(section);
        let mut cursor = Cursor::new(line);
        on(line, directive(&mut cursor).and_then(|_| cursor.end()))?;
        let length = behind.iter().position(|line| self::section(line).is_some()).unwrap_or(behind.len());
        let (body, after) = behind.split_at(length);
        program.blocks[section as usize] = block(program, section, body)?;
        rest = after;
    }
    let [_, kernel, last] = &program.blocks;
    if kernel.results.addends.is_empty() {
        return missing("`.kernel` and an `accumulate` in it");
    }
    if last.results.outputs.is_empty() {
        return missing("`.final` and an `output` in it");
    }
    Ok(())
}

/// `.program mls`.
fn header(line: &Line) -> Located<String> {
    let mut cursor = Cursor::new(line);
    if !(cursor.take_mark('.') && cursor.take_word("program")) {
        return Cursor::new(line).expected("`.program` and a name");
    }
    let name = cursor.word("the program's name")?.to_owned();
    cursor.end()?;
    Ok(name)
}

/// The word of a line that begins with a dot.
pub(super) fn directive<'a>(cursor: &mut Cursor<'a>) -> Located<&'a str> {
    cursor.mark('.')?;
    cursor.word("a word behind the dot")
}

/// The word of a line, if it is such a line.
fn directive_of(line: &Line) -> Option<&str> {
    match line.tokens.as_slice() {
        [first, second, ..] if first.kind == Kind::Mark('.') => match &second.kind {
            Kind::Word(word) => Some(word),
            _ => None,
        },
        _ => None,
    }
}

/// The block that begins in a line.
fn section(line: &Line) -> Option<Section> {
    let word = directive_of(line)?;
    Section::ALL.into_iter().find(|section| section.name() == word)
}

fn block(program: &mut Program, section: Section, lines: &[Line]) -> Placed<Block> {
    let mut builder = Builder::new(program, section);
    let mut room = STATEMENTS_MAX;
    run(&mut builder, lines, &mut room)?;
    Ok(builder.block)
}

/// Carries out the lines of a block, or of a turn of a repetition.
fn run(builder: &mut Builder<'_>, lines: &[Line], room: &mut usize) -> Placed<()> {
    let mut rest = lines;
    while let Some((line, behind)) = rest.split_first() {
        on(line, take(room))?;
        rest = behind;
        match directive_of(line) {
            Some("repeat") => {
                let length = body_length(behind);
                let Some(length) = length else {
                    return on(line, Err((1, Fault::expected("an `.end` to this `.repeat`", "the end of the block"))));
                };
                repeat(builder, line, &behind[..length], room)?;
                rest = &behind[length + 1..];
            }
            Some(_) => {
                return on(
                    line,
                    Cursor::new(line).expected("a statement, `.repeat` or the `.end` of one, or the next block"),
                );
            }
            None => on(line, statement(builder, line))?,
        }
    }
    Ok(())
}

fn take(room: &mut usize) -> Located<()> {
    let what = "statements of a block, repetitions unrolled";
    let full = Fault::TooMany { what, found: STATEMENTS_MAX + 1, maximum: STATEMENTS_MAX };
    *room = room.checked_sub(1).ok_or((1, full))?;
    Ok(())
}

/// Lines up to the `.end` that closes a repetition.
fn body_length(lines: &[Line]) -> Option<usize> {
    let mut open = 1;
    lines.iter().position(|line| {
        match directive_of(line) {
            Some("repeat") => open += 1,
            Some("end") => open -= 1,
            _ => {}
        }
        open == 0
    })
}

/// `.repeat i 0 8`: the lines with each number from the first to the one before the last.
fn repeat(builder: &mut Builder<'_>, line: &Line, body: &[Line], room: &mut usize) -> Placed<()> {
    let depth = builder.variables.len() + 1;
    if depth > REPETITIONS_MAX {
        let what = "repetitions within each other";
        return on(line, Err((1, Fault::TooMany { what, found: depth, maximum: REPETITIONS_MAX })));
    }
    let bounds = || -> Located<(&str, i64, i64)> {
        let mut cursor = Cursor::new(line);
        directive(&mut cursor)?;
        let column = cursor.column();
        let variable = cursor.word("the name of the repetition's variable")?;
        builder.check_free(variable).map_err(|fault| (column, fault))?;
        let first = super::statement::index(builder, &mut cursor)?;
        let end = super::statement::index(builder, &mut cursor)?;
        cursor.end()?;
        Ok((variable, first, end))
    };
    let (variable, first, end) = on(line, bounds())?;
    for number in first..end {
        on(line, take(room))?;
        builder.begin_turn(variable, number);
        run(builder, body, room)?;
        builder.end_turn();
    }
    Ok(())
}
