//! `pointcore translate FORMAT`.

use super::Failure;
use pointcore::number::decode;
use pointcore_contract::Format;
use std::io::{self, BufRead as _, Write as _};

/// Arguments of `translate`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The format: `f32`, `f24`, `f16` or `bf16`, also with `-ftz`.
    format: Format,
}

/// The number that a word in hexadecimal stands for; what is none stays as it is.
fn translate(format: Format, word: &str) -> String {
    u32::from_str_radix(word, 16).map_or_else(|_| word.to_owned(), |bits| decode(format, bits).to_string())
}

/// Answers every line at once: a viewer asks for the next one when it has an answer.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let line = line.map_err(|error| Failure::Usage(format!("standard input cannot be read: {error}")))?;
        let number = translate(arguments.format, line.trim());
        writeln!(out, "{number}").and_then(|()| out.flush()).map_err(Failure::Print)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_become_numbers_and_others_stay() {
        assert_eq!(translate(Format::F24, "3dcccd"), "0.10000038");
        assert_eq!(translate(Format::F32, "7fc00000"), "NaN");
        assert_eq!(translate(Format::F16, "xxxx"), "xxxx");
    }
}
