//! Faults put into Verilog on purpose, to see that a test finds them.

use super::LockstepError;

/// `verilog` with `from` replaced by `to` in the one line that contains `line`.
///
/// # Errors
/// When not exactly one line contains `line`, or that line does not contain `from` exactly once.
pub fn inject(verilog: &str, line: &str, from: &str, to: &str) -> Result<String, LockstepError> {
    let fault = |reason| LockstepError::Fault { line: line.to_owned(), from: from.to_owned(), reason };
    let mut starts = verilog.match_indices(line).map(|(at, _)| verilog[..at].rfind('\n').map_or(0, |end| end + 1));
    let start = starts.next().ok_or(fault("no line contains it"))?;
    if starts.any(|other| other != start) {
        return Err(fault("several lines contain it"));
    }
    let length = verilog[start..].find('\n').unwrap_or(verilog.len() - start);
    let (before, rest) = verilog.split_at(start);
    let (original, after) = rest.split_at(length);
    match original.matches(from).count() {
        1 => Ok([before, &original.replace(from, to), after].concat()),
        0 => Err(fault("the line does not contain it")),
        _ => Err(fault("the line contains it more than once")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_named_line_changes() {
        let text = "assign a = b + c;\nassign d = b + e;\n";
        assert_eq!(inject(text, "assign d", "+", "-").unwrap(), "assign a = b + c;\nassign d = b - e;\n");
    }

    #[test]
    fn ambiguous_and_absent_targets_are_refused() {
        let text = "assign a = b + c;\nassign d = b + e + f;\n";
        for (line, from) in [("assign", "+"), ("nothing", "+"), ("assign a", "*"), ("assign d", "+")] {
            assert!(inject(text, line, from, "-").is_err(), "{line} {from}");
        }
    }
}
