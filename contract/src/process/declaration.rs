//! The lines before the blocks: `.query normal: float3` and its like.

use super::STATE_WORDS_MAX;
use super::builder::check_reserved;
use super::error::Fault;
use super::layout::{Field, Layout, Type};
use super::lexer::{Cursor, Line, Located};
use super::parser::directive;
use super::program::Program;

/// Reads one of them.
pub(super) fn declare(program: &mut Program, line: &Line) -> Located<()> {
    let mut cursor = Cursor::new(line);
    let word = directive(&mut cursor)?;
    let Program { query, neighbor, state, settings, .. } = program;
    let (target, others): (_, &[&Layout]) = match word {
        "query" => (query, &[]),
        "neighbor" => (neighbor, &[]),
        "state" => (state, &[settings]),
        "setting" => (settings, &[state]),
        _ => {
            return Cursor::new(line)
                .expected("`.query`, `.neighbor`, `.state`, `.setting`, or the first block: `.init` or `.kernel`");
        }
    };
    let column = cursor.column();
    let name = cursor.word("a name")?;
    cursor.mark(':')?;
    let ty = ty(&mut cursor)?;
    cursor.end()?;
    let place = |fault| (column, fault);
    check_reserved(name).map_err(place)?;
    if others.iter().any(|layout| layout.find(name).is_some()) {
        return Err(place(Fault::Taken(name.to_owned())));
    }
    add(target, name, ty).map_err(place)?;
    let words = program.state.len();
    if words > STATE_WORDS_MAX {
        return Err(place(Fault::TooMany { what: "words of state", found: words, maximum: STATE_WORDS_MAX }));
    }
    Ok(())
}

fn ty(cursor: &mut Cursor<'_>) -> Located<Type> {
    let names = Type::NAMED.map(|(name, _)| format!("`{name}`")).join(", ");
    match Type::NAMED.iter().find(|(name, _)| cursor.take_word(name)) {
        Some((_, ty)) => Ok(*ty),
        None => cursor.expected(format!("a type: {names}")),
    }
}

/// Adds a field whose words have names of their own.
pub(super) fn add(layout: &mut Layout, name: &str, ty: Type) -> Result<(), Fault> {
    let field = Field { name: name.to_owned(), ty };
    let taken = layout.words();
    let is_taken = layout.find(name).is_some()
        || field.words().iter().any(|word| taken.iter().any(|other| other.name == word.name));
    if is_taken {
        return Err(Fault::Taken(name.to_owned()));
    }
    layout.push(field);
    Ok(())
}
