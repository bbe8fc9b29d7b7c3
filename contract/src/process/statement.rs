//! The lines of blocks: `d = sub neighbor.position, query.position` and what becomes of values.

use super::block::Store;
use super::builder::{Builder, Value};
use super::declaration::add;
use super::error::Fault;
use super::instruction::{apply, expected, list, names};
use super::layout::{COMPONENTS, Type};
use super::lexer::{Cursor, Kind, Line, Located};
use super::operation::Literal;
use super::program::Section;

/// Reads one of them.
pub(super) fn statement(builder: &mut Builder<'_>, line: &Line) -> Located<()> {
    let mut cursor = Cursor::new(line);
    let column = cursor.column();
    let first = cursor.word(
        "a name to give, or what becomes of a value: `accumulate`, `output`, `store`, `move`, `done`, `search`",
    )?;
    if matches!(cursor.peek(), Some(Kind::Mark('=' | '['))) {
        return assignment(builder, &mut cursor, first);
    }
    let (in_kernel, in_final, in_both) = ("`.kernel`", "`.final`", "`.init` and `.final`");
    let section = builder.section;
    let (has_place, place) = match first {
        "accumulate" => (section == Section::Kernel, in_kernel),
        "store" => (section != Section::Kernel, in_both),
        "output" | "move" | "done" | "search" => (section == Section::Final, in_final),
        _ => return cursor.expected(format!("`=` behind the name `{first}`")),
    };
    if !has_place {
        let (statement, section) = (first.to_owned(), section.name().to_owned());
        return Err((column, Fault::Misplaced { statement, section, place }));
    }
    match first {
        "accumulate" => accumulate(builder, &mut cursor)?,
        "output" => output(builder, &mut cursor)?,
        "store" => store(builder, &mut cursor)?,
        "move" => movement(builder, &mut cursor, column)?,
        _ => {
            let condition = typed(builder, &mut cursor, Type::Bool, first)?.words[0];
            let results = &mut builder.block.results;
            let flag = if first == "done" { &mut results.done } else { &mut results.search };
            if flag.replace(condition).is_some() {
                return Err((column, Fault::Twice(first.to_owned())));
            }
        }
    }
    cursor.end()
}

/// `name = operation operand, operand`.
fn assignment(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>, name: &str) -> Located<()> {
    // The name is the line's first part.
    let name = indexed(builder, cursor, name)?;
    builder.check_free(&name).map_err(|fault| (1, fault))?;
    cursor.mark('=')?;
    let column = cursor.column();
    let operation = cursor.word("an operation")?;
    let Some(forms) = expected(operation) else {
        return Err((column, Fault::unknown(operation, names())));
    };
    let mut operands = vec![operand(builder, cursor)?];
    while cursor.take_mark(',') {
        operands.push(operand(builder, cursor)?);
    }
    cursor.end()?;
    let Some(value) = apply(builder, operation, &operands) else {
        let types: Vec<Type> = operands.iter().map(|operand| operand.ty).collect();
        let (operation, found) = (operation.to_owned(), list(&types));
        return Err((column, Fault::Operands { operation, found, expected: forms }));
    };
    builder.give(name, value);
    Ok(())
}

/// `accumulate name, value`.
fn accumulate(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>) -> Located<()> {
    let (column, name) = declared(cursor)?;
    builder.check_free(name).map_err(|fault| (column, fault))?;
    let value = operand(builder, cursor)?;
    if value.ty == Type::Bool {
        return Err((column, mistyped(format!("the addend of `{name}`"), value.ty, "float, float3 or int")));
    }
    add(&mut builder.program.sums, name, value.ty).map_err(|fault| (column, fault))?;
    builder.block.results.addends.extend(value.words);
    Ok(())
}

/// `output name, value`.
fn output(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>) -> Located<()> {
    let (column, name) = declared(cursor)?;
    let value = operand(builder, cursor)?;
    add(&mut builder.program.outputs, name, value.ty).map_err(|fault| (column, fault))?;
    builder.block.results.outputs.extend(value.words);
    Ok(())
}

/// `store name, value if condition`.
fn store(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>) -> Located<()> {
    let (column, name) = declared(cursor)?;
    let Some(place) = builder.program.state.find(name) else {
        let known = builder.program.state.fields().iter().map(|field| field.name.clone());
        return Err((column, Fault::unknown(name, known)));
    };
    let words = typed(builder, cursor, place.ty, &format!("what is stored to `{name}`"))?.words;
    let condition = condition(builder, cursor)?;
    let stores = &mut builder.block.results.stores;
    if stores.iter().any(|store| store.field == name) {
        return Err((column, Fault::Twice(format!("store {name}"))));
    }
    stores.push(Store { field: name.to_owned(), first: place.first, words, condition });
    Ok(())
}

/// `move position if condition`.
fn movement(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>, column: usize) -> Located<()> {
    let words = typed(builder, cursor, Type::Float3, "the new position")?.words;
    let condition = condition(builder, cursor)?;
    let store = Store { field: "position".to_owned(), first: 0, words, condition };
    if builder.block.results.movement.replace(store).is_some() {
        return Err((column, Fault::Twice("move".to_owned())));
    }
    Ok(())
}

/// The name of what a statement writes, the comma behind it passed.
fn declared<'a>(cursor: &mut Cursor<'a>) -> Located<(usize, &'a str)> {
    let column = cursor.column();
    let name = cursor.word("a name")?;
    cursor.mark(',')?;
    Ok((column, name))
}

fn condition(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>) -> Located<Option<super::NodeId>> {
    if !cursor.take_word("if") {
        return Ok(None);
    }
    Ok(Some(typed(builder, cursor, Type::Bool, "the condition")?.words[0]))
}

fn mistyped(value: String, found: Type, expected: impl ToString) -> Fault {
    Fault::Type { value, found: found.to_string(), expected: expected.to_string() }
}

/// An operand of a given type.
fn typed(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>, ty: Type, what: &str) -> Located<Value> {
    let column = cursor.column();
    let value = operand(builder, cursor)?;
    if value.ty != ty {
        return Err((column, mistyped(what.to_owned(), value.ty, ty)));
    }
    Ok(value)
}

/// A literal, or a value by its name.
fn operand(builder: &mut Builder<'_>, cursor: &mut Cursor<'_>) -> Located<Value> {
    let column = cursor.column();
    let negative = cursor.take_mark('-');
    if let Some(text) = cursor.take_number() {
        let text = if negative { format!("-{text}") } else { text.to_owned() };
        return Ok(builder.literal(number(&text).map_err(|fault| (column, fault))?));
    }
    if negative {
        return cursor.expected("a number behind the sign (of a value: `neg`)");
    }
    let name = cursor.word("a value: a name or a number")?;
    let place = |fault| (column, fault);
    let mut value = match name {
        "true" | "false" => builder.literal(Literal::Bool(name == "true")),
        "query" | "neighbor" | "farthest" => {
            if !cursor.take_mark('.') {
                return cursor.expected(format!("`.position` or another field of `{name}`"));
            }
            let field = cursor.word("the name of a field")?;
            builder.field(name, field).map_err(place)?
        }
        _ => {
            let name = indexed(builder, cursor, name)?;
            builder.look_up(&name).map_err(place)?
        }
    };
    if cursor.take_mark('.') {
        if value.ty != Type::Float3 {
            return Err((column, mistyped(format!("`{name}`"), value.ty, "float3 in front of a component")));
        }
        let Some(axis) = COMPONENTS.iter().position(|axis| cursor.take_word(axis)) else {
            return cursor.expected("a component: `x`, `y` or `z`");
        };
        value = Value { ty: Type::Float, words: vec![value.words[axis]] };
    }
    Ok(value)
}

/// A name with its index, if there is one, as `name[3]`.
fn indexed(builder: &Builder<'_>, cursor: &mut Cursor<'_>, name: &str) -> Located<String> {
    if !cursor.take_mark('[') {
        return Ok(name.to_owned());
    }
    let column = cursor.column();
    let index = index(builder, cursor)?;
    cursor.mark(']')?;
    if index < 0 {
        return Err((column, Fault::Number { number: index.to_string(), ty: "index", range: "0 or more" }));
    }
    Ok(format!("{name}[{index}]"))
}

/// A number, or a repetition's variable and a number behind it: `2`, `i`, `i+1`, `i-1`.
pub(super) fn index(builder: &Builder<'_>, cursor: &mut Cursor<'_>) -> Located<i64> {
    let column = cursor.column();
    if let Some(text) = cursor.take_number() {
        return small(text).map_err(|fault| (column, fault));
    }
    let variable = match cursor.peek() {
        Some(Kind::Word(word)) => builder.variables.iter().find(|(variable, _)| variable == word),
        _ => None,
    };
    let Some((_, base)) = variable else {
        return cursor.expected("a whole number or the variable of a `.repeat`");
    };
    cursor.word("the variable")?;
    let sign = if cursor.take_mark('+') {
        1
    } else if cursor.take_mark('-') {
        -1
    } else {
        return Ok(*base);
    };
    let column = cursor.column();
    match cursor.take_number() {
        Some(text) => Ok(base + sign * small(text).map_err(|fault| (column, fault))?),
        None => cursor.expected("a whole number"),
    }
}

/// A whole number of a repetition or an index.
fn small(text: &str) -> Result<i64, Fault> {
    const RANGE: &str = "0 to 9999";
    let number = text.parse::<i64>().ok().filter(|number| (0..10_000).contains(number));
    number.ok_or_else(|| Fault::Number { number: text.to_owned(), ty: "index", range: RANGE })
}

/// A literal: whole numbers are integers.
fn number(text: &str) -> Result<Literal, Fault> {
    let wrong = |ty, range| Fault::Number { number: text.to_owned(), ty, range };
    if !text.contains(['.', 'e']) {
        let range = "-2147483648 to 2147483647 (a float has a point: `1.0`)";
        return text.parse().map(Literal::Int).map_err(|_| wrong("int", range));
    }
    let range = "0.0, or magnitudes from 1.2e-38 to 3.4e38";
    let value: f32 = text.parse().map_err(|_| wrong("float", range))?;
    let digits = text.split('e').next().unwrap_or(text);
    let is_zero = !digits.contains(|digit| matches!(digit, '1'..='9'));
    if is_zero || value.is_normal() { Ok(Literal::Float(value.to_bits())) } else { Err(wrong("float", range)) }
}
