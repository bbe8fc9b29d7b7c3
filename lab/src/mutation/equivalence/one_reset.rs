//! A reset that comes once, in the first cycle: from a register, so that a prover sees what follows it in turns.

use pointcore_tb::verilated::RESET;

/// What resets a module, in place of its input.
pub const FIRST_CYCLE: &str = "module first_cycle (input clk, output first);\nreg later;\n\
    always @(posedge clk) later <= 1'd1;\nassign first = !later;\nendmodule\n";

/// What stands before a module's ports, its ports, its body, and what follows it.
fn parts<'a>(verilog: &'a str, module: &str) -> Option<[&'a str; 4]> {
    let (before, found) = verilog.split_once(&format!("module {module} "))?;
    let (head, rest) = found.split_once(");")?;
    let (body, after) = rest.split_once("endmodule")?;
    Some([before, head, body, after])
}

const fn is_of_word(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

/// Whether a module has a reset.
pub fn has_reset(verilog: &str, module: &str) -> bool {
    parts(verilog, module).is_some_and(|[_, head, ..]| head.split(|c| !is_of_word(c)).any(|word| word == RESET))
}

/// The design with a reset in the first cycle of a module, and in no other, wherever the module looks at it.
pub fn with_one_reset(verilog: &str, module: &str) -> String {
    const ONE_RESET: &str = "one_reset";
    let Some([before, head, body, after]) = parts(verilog, module) else { return verilog.to_owned() };
    let mut pieces = body.split(RESET);
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        // Not that of an instance's port, nor within another name.
        let is_reset = !text.ends_with(|c| is_of_word(c) || c == '.') && !piece.starts_with(is_of_word);
        text += if is_reset { ONE_RESET } else { RESET };
        text += piece;
    }
    format!(
        "{before}module {module} {head}); wire {ONE_RESET}; first_cycle first_cycle (.clk(clk), .first({ONE_RESET}));\
         {text}endmodule{after}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_module_is_reset_once_wherever_it_looks_at_its_reset() {
        let text = "module other (input clk, input rst);\nendmodule\nmodule unit (input clk, input rst, input ends);\n\
            wire rst_or_ends = rst | ends;\ninner inner (.clk(clk), .rst(rst | rst_or_ends), .first_rst(!rst));\nendmodule\n";
        let expected = "module other (input clk, input rst);\nendmodule\nmodule unit (input clk, input rst, input ends); \
            wire one_reset; first_cycle first_cycle (.clk(clk), .first(one_reset));\n\
            wire rst_or_ends = one_reset | ends;\n\
            inner inner (.clk(clk), .rst(one_reset | rst_or_ends), .first_rst(!one_reset));\nendmodule\n";
        assert_eq!(with_one_reset(text, "unit"), expected);
        assert!(
            has_reset(text, "unit") && !has_reset("module unit (input clk, input first_rst);\nendmodule\n", "unit")
        );
    }
}
