//! The `pointcore` command.

mod commands;
mod exit;

use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};
use commands::{
    Failure, accuracy, area, bench, diagram, generate, inspect, knn, mutate, plan, process, run, soak, stability,
    translate, vectors,
};
use pointcore_lab::note;
use std::process::ExitCode;

/// Generates, simulates and measures hardware for point-based graphics.
///
/// Start with `pointcore run scenes/knot.toml`: it derives the hardware the scene calls for, writes its Verilog, runs it under
/// Verilator in lockstep with a bit-exact model, and leaves picture and report in out/knot/. `pointcore run scan.ply` does so with a model of your own,
/// without a scene: PLY, OBJ, glTF, PCD, LAS, LAZ, XYZ, CSV. `pointcore knn --points surface:100000` does the
/// same for nearest neighbors.
///
/// Exit codes: 0 success, 1 the hardware and its model, or the record of its figures, disagree, 2 wrong input or a folder that cannot be written, 3 a tool is missing or failed, 130 interrupted.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct Arguments {
    /// Print one JSON document instead of text.
    #[arg(long, global = true)]
    json: bool,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Show which hardware a scene calls for, what is left out, and why.
    Plan(plan::Arguments),
    /// Write Verilog, manifest and constraints for a scene or a configuration.
    Gen(generate::Arguments),
    /// Render a scene, or a model alone, on the generated hardware and report on it.
    ///
    /// Exit code 2 where nothing is to be seen: the message counts why.
    Run(run::Arguments),
    /// Search the nearest neighbors of points on the generated hardware and report on it.
    ///
    /// Hardware and model search together, every output compared in every cycle, which takes its time: only the first 2000 queries are
    /// asked unless --limit says otherwise. Without --config the hardware is derived: four points a cycle, the tree as deep as the points
    /// need, the queues as long as k. Neighbors go to out/knn/neighbors.csv, the report beside them.
    Knn(Box<knn::Arguments>),
    /// Carry out an operator on the neighborhoods of points: normals, projections, smoothing, resampling, a fluid's forces.
    ///
    /// Each query has the k nearest points as its neighbors, or all within --radius, and goes through a program (docs/programs.md): one of the
    /// project's by --op, or your own by --program. Settings follow from the points unless --set gives them; what a program reads of each point
    /// is the points' attribute of that name: `normal` is nx, ny, nz, `area` a column of that name. Normals that a file does not have are
    /// estimated. Points as they leave go to out/process/points.ply, the report beside them.
    ///
    /// Estimate normals:        pointcore process --op normals --points scan.ply --set viewpoint=0,0,2
    /// Project onto planes:     pointcore process --op mls --points scan.ply --k 24
    /// Smooth, eight times:     pointcore process --op smooth --points scan.ply --k 16 --passes 8
    /// Four points of each:     pointcore process --op resample --points scan.ply --pattern 2x2
    /// Forces in a fluid:       pointcore process --op sph --points particles.csv --radius 0.1 --k 30
    ///
    /// The bit-exact golden model carries it out. Exit code 1 where --check finds an output off by more than its bound.
    #[command(verbatim_doc_comment)]
    Process(Box<process::Arguments>),
    /// Write what a driver sends to a core over AXI and what must come back, from the golden model.
    ///
    /// For bringing up a board. vectors.json names the registers to write (docs/interfaces.md), the packets to send and to expect, and
    /// the memory images, each a binary file beside it: packets one after the other, in the layout of registers.h. config.toml is the
    /// hardware they are for: `pointcore gen DIR/config.toml -o DIR/verilog`. Fragments come in the given order; results of a query too, but
    /// queries in any order. Of a packet with `end` set nothing else counts.
    Vectors(Box<vectors::Arguments>),
    /// Draw a configuration's core as a block diagram: its units and the records that pass between them.
    Diagram(diagram::Arguments),
    /// Describe a model file: points, normals, spacing.
    Inspect(inspect::Arguments),
    /// Measure the project's figures and merge them into out/bench.json.
    Bench(bench::Arguments),
    /// Check the arithmetic of the renderer's geometry on hard cases, beside an exact truth and other methods (docs/stability.md).
    Stability(stability::Arguments),
    /// Plant single faults in the generated Verilog, and count those that the tests find.
    ///
    /// Faults are yosys' mutations of the netlist. A unit's are tried by its lockstep tests, a package's by the test that ships with
    /// it. Of those that are missed, a proof sorts out the ones that change nothing. Run it in the project's folder.
    Mutate(mutate::Arguments),
    /// Run random configurations of both cores under random stimuli, every output compared with the model's in every cycle.
    ///
    /// Finished cases are kept: the same command goes on where it was interrupted. Exit code 1 where a run was not clean: the message
    /// says what differed, on which configuration, and the command that makes the run again.
    Soak(Box<soak::Arguments>),
    /// Sweep the knobs that trade accuracy for time and hardware, and find the cheapest configuration that is accurate enough (docs/accuracy.md).
    Accuracy(Box<accuracy::Arguments>),
    /// Measure area and clock of units on FPGA tools.
    Area(area::Arguments),
    /// Turn words of a number format into numbers, line by line, as waveform viewers ask for it.
    Translate(translate::Arguments),
}

/// The exit code of a run that was interrupted.
const INTERRUPTED: i32 = 130;

/// The arguments given. A negative number is a value, and a wrong one is told so by its option.
fn arguments() -> Arguments {
    let command = Arguments::command().mut_subcommands(|command| command.allow_negative_numbers(true));
    let found = command.get_matches();
    Arguments::from_arg_matches(&found).unwrap_or_else(|error| error.exit())
}

/// Panics of readers of model files become errors, and are not spoken of twice.
fn silence_readers() {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !pointcore::scene::is_guarded() {
            hook(panic);
        }
    }));
}

fn main() -> ExitCode {
    silence_readers();
    let Arguments { json, command } = arguments();
    // Without the handler an interruption leaves folders of unfinished work, which the next run removes.
    _ = ctrlc::set_handler(|| {
        pointcore_tb::scratch::remove_all();
        std::process::exit(INTERRUPTED);
    });
    let output = if json { commands::Output::Json } else { commands::Output::Text };
    let result = match command {
        Command::Plan(arguments) => plan::run(&arguments, output),
        Command::Gen(arguments) => generate::run(&arguments, output),
        Command::Run(arguments) => run::run(&arguments, output),
        Command::Knn(arguments) => knn::run(&arguments, output),
        Command::Process(arguments) => process::run(&arguments, output),
        Command::Vectors(arguments) => vectors::run(&arguments, output),
        Command::Diagram(arguments) => diagram::run(&arguments, output),
        Command::Inspect(arguments) => inspect::run(&arguments, output),
        Command::Bench(arguments) => bench::run(&arguments, output),
        Command::Stability(arguments) => stability::run(&arguments, output),
        Command::Mutate(arguments) => mutate::run(&arguments, output),
        Command::Soak(arguments) => soak::run(&arguments, output),
        Command::Accuracy(arguments) => accuracy::run(&arguments, output),
        Command::Area(arguments) => area::run(&arguments, output),
        Command::Translate(arguments) => translate::run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever read the result has had enough of it.
        Err(Failure::Print(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            note!("error: {failure}");
            exit::code(&failure)
        }
    }
}
