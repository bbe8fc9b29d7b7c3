//! The parts of a line.

use super::error::{Fault, ProgramError};
use std::fmt;

/// A part of a line and where it begins.
#[derive(Clone, Debug)]
pub(super) struct Token {
    pub kind: Kind,
    /// Character of the line, counted from 1.
    pub column: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Word(String),
    Number(String),
    Mark(char),
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(text) | Self::Number(text) => write!(f, "`{text}`"),
            Self::Mark(mark) => write!(f, "`{mark}`"),
        }
    }
}

/// What is wrong, and at which character of the line.
pub(super) type Located<T> = Result<T, (usize, Fault)>;

/// A line with something on it.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// Counted from 1.
    pub number: usize,
    pub tokens: Vec<Token>,
    /// The character behind the last.
    pub end: usize,
}

/// All lines that have more than comments.
pub(super) fn lines(file: &str, text: &str) -> Result<Vec<Line>, ProgramError> {
    let mut lines = vec![];
    for (index, line) in text.lines().enumerate() {
        let number = index + 1;
        let place = |(column, fault)| ProgramError { file: file.to_owned(), line: number, column, fault };
        let (tokens, end) = tokens(line).map_err(place)?;
        if !tokens.is_empty() {
            lines.push(Line { number, tokens, end });
        }
    }
    Ok(lines)
}

fn tokens(line: &str) -> Located<(Vec<Token>, usize)> {
    let characters: Vec<char> = line.chars().take_while(|&character| character != ';').collect();
    let mut tokens = vec![];
    let mut at = 0;
    while let Some(&first) = characters.get(at) {
        let column = at + 1;
        if first.is_whitespace() {
            at += 1;
            continue;
        }
        let rest = &characters[at..];
        let kind = match first {
            'a'..='z' => Kind::Word(rest.iter().take_while(|character| is_of_name(**character)).collect()),
            '0'..='9' => Kind::Number(number(rest)),
            '=' | ',' | '.' | ':' | '[' | ']' | '+' | '-' => Kind::Mark(first),
            _ => return Err((column, Fault::Character(first))),
        };
        at += match &kind {
            Kind::Word(text) | Kind::Number(text) => text.len(),
            Kind::Mark(_) => 1,
        };
        tokens.push(Token { kind, column });
    }
    let end = tokens.last().map_or(1, |last| last.column + last.kind.to_string().chars().count() - 2);
    Ok((tokens, end))
}

const fn is_of_name(character: char) -> bool {
    matches!(character, 'a'..='z' | '0'..='9' | '_')
}

/// Digits, with a fraction and an exponent where there are any.
fn number(characters: &[char]) -> String {
    let digits = |from: usize| characters[from..].iter().take_while(|character| character.is_ascii_digit()).count();
    let mut length = digits(0);
    if characters.get(length) == Some(&'.') && digits(length + 1) > 0 {
        length += 1 + digits(length + 1);
    }
    if characters.get(length) == Some(&'e') {
        let sign = usize::from(matches!(characters.get(length + 1), Some('+' | '-')));
        let exponent = characters.get(length + 1 + sign).map_or(0, |_| digits(length + 1 + sign));
        if exponent > 0 {
            length += 1 + sign + exponent;
        }
    }
    characters[..length].iter().collect()
}

/// A line that is read from left to right.
pub(super) struct Cursor<'a> {
    line: &'a Line,
    at: usize,
}

impl<'a> Cursor<'a> {
    pub const fn new(line: &'a Line) -> Self {
        Self { line, at: 0 }
    }

    /// The next part.
    pub fn peek(&self) -> Option<&'a Kind> {
        self.line.tokens.get(self.at).map(|token| &token.kind)
    }

    /// Where the next part begins, or the line ends.
    pub fn column(&self) -> usize {
        self.line.tokens.get(self.at).map_or(self.line.end, |token| token.column)
    }

    /// The error that something else belongs here.
    pub fn expected<T>(&self, expected: impl Into<String>) -> Located<T> {
        let found = self.peek().map_or_else(|| "the end of the line".to_owned(), ToString::to_string);
        Err((self.column(), Fault::expected(expected, found)))
    }

    /// Whether the next part is this mark, which is then passed.
    pub fn take_mark(&mut self, mark: char) -> bool {
        let taken = self.peek() == Some(&Kind::Mark(mark));
        self.at += usize::from(taken);
        taken
    }

    /// Whether the next part is this word, which is then passed.
    pub fn take_word(&mut self, word: &str) -> bool {
        let taken = matches!(self.peek(), Some(Kind::Word(text)) if text == word);
        self.at += usize::from(taken);
        taken
    }

    pub fn mark(&mut self, mark: char) -> Located<()> {
        if self.take_mark(mark) { Ok(()) } else { self.expected(format!("`{mark}`")) }
    }

    pub fn word(&mut self, expected: &str) -> Located<&'a str> {
        match self.peek() {
            Some(Kind::Word(text)) => {
                self.at += 1;
                Ok(text)
            }
            _ => self.expected(expected),
        }
    }

    /// The next number, if there is one.
    pub fn take_number(&mut self) -> Option<&'a str> {
        match self.peek() {
            Some(Kind::Number(text)) => {
                self.at += 1;
                Some(text)
            }
            _ => None,
        }
    }

    pub fn end(&self) -> Located<()> {
        if self.peek().is_none() { Ok(()) } else { self.expected("the end of the line") }
    }
}
