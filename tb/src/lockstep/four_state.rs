//! The same run once more in Icarus Verilog, where what nothing has set is unknown.
//!
//! Verilator knows zeros and ones alone. It begins with random ones, so hardware that depends on them shows there only if it
//! works with one and not with another. In four states an output that depends on them is unknown, and that is a difference.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use super::stimulus::{Flow, RESET_CYCLES, Stimulus};
use super::stream::Streams;
use crate::cache::file;
use crate::verilated::{Direction, Library, Port, RESET, VerilatedError, substitute};

/// A stimulus that keeps what it did and what came out.
#[derive(Debug, Clone)]
pub struct Recorded<S> {
    /// The stimulus.
    pub stimulus: S,
    /// Inputs and outputs of each cycle after the reset.
    cycles: Vec<[Vec<u64>; 2]>,
}

impl<S> Recorded<S> {
    /// With no cycles yet.
    pub const fn new(stimulus: S) -> Self {
        Self { stimulus, cycles: vec![] }
    }
}

impl<S: Stimulus> Stimulus for Recorded<S> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        if cycle > 0 {
            self.cycles.push([inputs.to_vec(), outputs.to_vec()]);
        }
        self.stimulus.drive(cycle, outputs, inputs)
    }
}

/// Why a run in four states did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum FourStateError {
    /// A tool is missing, or does not take the text.
    #[error(transparent)]
    Tool(#[from] VerilatedError),
    /// An output is another one, or unknown.
    #[error("`{top}` in four states, inputs and registers unknown where nothing says what they are: {difference}")]
    Differs {
        /// The top module.
        top: String,
        /// Cycle, output, what it is and what it should be.
        difference: String,
    },
    /// There was nothing to compare.
    #[error("no cycle of `{top}` was recorded")]
    Empty {
        /// The top module.
        top: String,
    },
}

impl<S> Recorded<S> {
    /// Runs the hardware on the inputs of the recording, and compares its outputs with those of the recording. Fields count
    /// while their stream offers them; those that go in are unknown while it does not.
    ///
    /// # Errors
    /// The first difference, or a tool that fails.
    pub fn replay(&self, library: &Library) -> Result<(), FourStateError> {
        let top = &library.source().top;
        if self.cycles.is_empty() {
            return Err(FourStateError::Empty { top: top.clone() });
        }
        let scratch = tempfile::tempdir().map_err(|error| failed("tempdir", top, error.to_string()))?;
        let folder = scratch.path();
        let text = format!("{}{}", library.source().verilog, bench(library, self.cycles.len()));
        let [driven, expected] = self.vectors(library);
        for (name, text) in [("bench.v", text), ("inputs", driven), ("outputs", expected)] {
            let path = folder.join(name);
            fs::write(&path, text).map_err(file("write", &path)).map_err(VerilatedError::from)?;
        }
        run("iverilog", &["-g2005-sv", "-s", "bench", "-o", "bench", "bench.v"], top, folder)?;
        let argument = std::env::var_os(substitute::ARGUMENT);
        let arguments: Vec<_> = ["-n", "bench"].map(OsStr::new).into_iter().chain(argument.as_deref()).collect();
        let output = run("vvp", &arguments, top, folder)?;
        let printed = String::from_utf8_lossy(&output.stdout);
        let last = printed.lines().last().unwrap_or_default();
        if last == PASSED {
            return Ok(());
        }
        let difference = difference(last, library.outputs()).unwrap_or_else(|| printed.clone().into_owned());
        Err(FourStateError::Differs { top: top.clone(), difference })
    }

    /// Lines of bits for inputs and for outputs, the reset first. What is unknown of inputs is `x`, of outputs what may be
    /// anything is.
    fn vectors(&self, library: &Library) -> [String; 2] {
        let sides = [(Direction::Input, library.inputs()), (Direction::Output, library.outputs())];
        let streams = Streams::of(library);
        let reset = |port: &Port| if port.name == RESET { "1".to_owned() } else { unknown(port) };
        let open = sides.map(|(_, ports)| ports.iter().map(reset).collect::<String>() + "\n");
        let mut texts = open.map(|line| line.repeat(RESET_CYCLES as usize));
        for words in &self.cycles {
            for ((text, words), (direction, ports)) in texts.iter_mut().zip(words).zip(sides) {
                let mut bits: Vec<_> = ports.iter().zip(words).map(binary).collect();
                for stream in streams.iter().filter(|stream| stream.direction == direction && words[stream.valid] == 0)
                {
                    stream.fields.iter().for_each(|&field| bits[field] = unknown(&ports[field]));
                }
                text.extend(bits.into_iter().chain(["\n".to_owned()]));
            }
        }
        texts
    }
}

/// What a run that agrees ends with.
const PASSED: &str = "PASSED";

fn unknown(port: &Port) -> String {
    "x".repeat(port.width as usize)
}

fn binary((port, word): (&Port, &u64)) -> String {
    format!("{word:0width$b}", width = port.width as usize)
}

/// A module that replays so many cycles, and ends with a line of cycle, outputs and expected outputs if they differ.
fn bench(library: &Library, cycles: usize) -> String {
    let top = &library.source().top;
    let connect = |ports: &[Port], vector: &str| {
        let width: u32 = ports.iter().map(|port| port.width).sum();
        let mut left = width;
        let connection = |port: &Port| {
            left -= port.width;
            format!(", .{}({vector}[{left} +: {}])", port.name, port.width)
        };
        (width, ports.iter().map(connection).collect::<String>())
    };
    let (driven_bits, inputs) = connect(library.inputs(), "driven");
    let (found_bits, outputs) = connect(library.outputs(), "found");
    let cycles = cycles + RESET_CYCLES as usize;
    format!(
        "
module bench;
    reg clk = 1'b0;
    reg [{driven_bits}-1:0] all_driven [0:{cycles}-1];
    reg [{found_bits}-1:0] all_expected [0:{cycles}-1];
    reg [{driven_bits}-1:0] driven;
    reg [{found_bits}-1:0] expected;
    wire [{found_bits}-1:0] found;
    integer cycle, place;
    {top} dut (.clk(clk){inputs}{outputs});
    initial begin
        $readmemb(\"inputs\", all_driven);
        $readmemb(\"outputs\", all_expected);
        for (cycle = 0; cycle < {cycles}; cycle = cycle + 1) begin
            driven = all_driven[cycle];
            expected = all_expected[cycle];
            #5;
            for (place = 0; place < {found_bits}; place = place + 1)
                if (expected[place] !== 1'bx && expected[place] !== found[place]) begin
                    $display(\"%0d %b %b\", cycle - {RESET_CYCLES}, found, expected);
                    $finish;
                end
            #1 clk = 1'b1;
            #5 clk = 1'b0;
        end
        $display(\"{PASSED}\");
        $finish;
    end
endmodule
"
    )
}

/// What a line of [`bench`] says of the first port that differs.
fn difference(line: &str, outputs: &[Port]) -> Option<String> {
    let [cycle, mut found, mut expected] = line.split(' ').collect::<Vec<_>>().try_into().ok()?;
    for Port { name, width, .. } in outputs {
        let ([is, found_left], [should, expected_left]) = (split(found, *width)?, split(expected, *width)?);
        if is.chars().zip(should.chars()).any(|(is, should)| should != 'x' && is != should) {
            return Some(format!("in cycle {cycle} `{name}` is {is} and should be {should}"));
        }
        (found, expected) = (found_left, expected_left);
    }
    None
}

fn split(bits: &str, width: u32) -> Option<[&str; 2]> {
    bits.split_at_checked(width as usize).map(|(first, rest)| [first, rest])
}

fn failed(tool: &str, top: &str, output: String) -> VerilatedError {
    VerilatedError::Tool { tool: tool.to_owned(), top: top.to_owned(), output }
}

/// What a tool prints that succeeds.
fn run(tool: &str, arguments: &[impl AsRef<OsStr>], top: &str, folder: &Path) -> Result<Output, VerilatedError> {
    let run = Command::new(tool).args(arguments).current_dir(folder).output();
    let output =
        run.map_err(|error| failed(tool, top, format!("cannot be started ({error}): apt-get install iverilog")))?;
    if output.status.success() {
        return Ok(output);
    }
    Err(failed(tool, top, String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned()))
}
