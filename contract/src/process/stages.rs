//! The units that lead queries from block to block, at their ports.

use super::config::{Config, ITERATION_BITS};
use super::queries::{
    Again, FinalInput, FinalSettings, Finished, Found, Fresh, InitInput, InitSettings, Listed, Numbered, Outcome,
    Query, Start, Stores, Update, Wanted,
};
use super::records::{Gather, Gathered, KernelInput, LineFetch, Neighbor, Settings, Sums, Thread};
use super::units::{GatherEvents, gatherer, kernel};
use crate::{Unit, record, unit};

/// Gives queries to threads, keeps their neighbors, and says which block each goes to next.
#[unit(process_control, config: Config)]
pub struct Control {
    /// Queries.
    query: In<Query>,
    /// A thread takes up a query.
    start: PulseOut<Start>,
    /// Threads that want the neighbors of their position.
    want: Out<Thread>,
    /// Neighbors found.
    found: In<Found>,
    /// A thread's neighbors are complete.
    listed: PulseOut<Listed>,
    /// Threads for `init`.
    #[when(config.has_init() && !config.has_farthest())]
    prepare: Out<Thread>,
    /// A thread has been through `init`.
    #[when(config.has_init())]
    prepared: PulseIn<Thread>,
    /// Neighbors wanted, for `kernel` a query after the other.
    gather: Out<Gather>,
    /// A query is not done.
    again: PulseIn<Again>,
    /// A thread's query has left.
    released: PulseIn<Thread>,
    /// No thread has a query.
    idle: Output<bool>,
    /// A query waits for a thread.
    event_query_wait: Output<bool>,
}

/// The register bank: words of queries by thread, a copy of each for each block that reads it.
#[unit(process_bank, config: Config)]
pub struct Bank {
    /// A thread takes up a query.
    fresh: PulseIn<Fresh>,
    /// A thread's neighbors are complete.
    listed: PulseIn<Listed>,
    /// What `init` writes.
    #[when(config.has_init())]
    stores: In<Stores>,
    /// It is written.
    #[when(config.has_init())]
    prepared: PulseOut<Thread>,
    /// What is written of a query that goes on.
    update: In<Update>,
    /// It is written.
    again: PulseOut<Again>,
    /// Threads that want the neighbors of their position.
    want: In<Thread>,
    /// The position.
    wanted: Out<Wanted>,
    /// Threads for `init`.
    #[when(config.has_init() && !config.has_farthest())]
    prepare: In<Thread>,
    /// Neighbors for `kernel`, and the farthest for `init`.
    gathered: In<Gathered>,
    /// What `init` takes.
    #[when(config.has_init())]
    init: Out<InitInput>,
    /// What `kernel` takes.
    kernel: Out<KernelInput>,
    /// Sums for `final`.
    sums: In<Sums>,
    /// What `final` takes.
    finish: Out<FinalInput>,
}

/// The block `init` of the program.
#[unit(process_init, config: Config)]
#[when(config.has_init())]
pub struct Init {
    /// Constants of the run.
    #[port("setting")]
    settings: Input<InitSettings>,
    /// What it takes.
    #[port("in")]
    input: In<InitInput>,
    /// What it writes.
    #[port("out")]
    output: Out<Stores>,
}

/// The block `final` of the program.
#[unit(process_finish, config: Config)]
pub struct Finish {
    /// Constants of the run.
    #[port("setting")]
    settings: Input<FinalSettings>,
    /// What it takes.
    #[port("in")]
    input: In<FinalInput>,
    /// What comes of it.
    #[port("out")]
    output: Out<Finished>,
}

/// Counts iterations, and lets queries leave that are done or have had as many as they may.
#[unit(process_output, config: Config)]
pub struct Output {
    /// Iterations that a query has at most, at least one.
    #[bits(ITERATION_BITS)]
    iterations_max: Input<u16>,
    /// A thread takes up a query; not in two cycles in a row.
    numbered: PulseIn<Numbered>,
    /// What comes of `final`.
    finished: In<Finished>,
    /// What is written of a query that goes on.
    update: Out<Update>,
    /// Queries that leave.
    result: Out<Outcome>,
    /// A thread's query has left.
    released: PulseOut<Thread>,
}

/// Queries and their threads with all that goes on between searching, gathering and `kernel`: control, register bank,
/// `init`, `final` and output.
#[unit(process_threads, config: Config)]
pub struct Threads {
    /// Constants of the run.
    #[port("setting")]
    settings: Input<Settings>,
    /// Iterations that a query has at most, at least one.
    #[bits(ITERATION_BITS)]
    iterations_max: Input<u16>,
    /// Queries.
    query: In<Query>,
    /// Searches.
    wanted: Out<Wanted>,
    /// Neighbors found.
    found: In<Found>,
    /// Neighbors wanted.
    gather: Out<Gather>,
    /// Neighbors in the order in which they were wanted.
    gathered: In<Gathered>,
    /// What `kernel` takes.
    kernel: Out<KernelInput>,
    /// What comes of it.
    sums: In<Sums>,
    /// Queries that leave, in any order.
    result: Out<Outcome>,
    /// Nothing is under way.
    idle: Output<bool>,
    /// A query waits for a thread.
    event_query_wait: Output<bool>,
    /// A query is not done.
    event_again: Output<bool>,
}

/// What the process core did.
#[record(config: Config)]
pub struct Events {
    /// A query waited for a thread.
    #[name("event_query_wait")]
    pub query_wait: bool,
    /// The kernel took a neighbor.
    #[name("event_kernel")]
    pub kernel: bool,
    /// A neighbor waited for the kernel.
    #[name("event_kernel_wait")]
    pub kernel_wait: bool,
    /// A query was not done after an iteration.
    #[name("event_again")]
    pub again: bool,
    /// What the gathering did.
    pub gather: GatherEvents,
}

/// The process core.
#[unit(process_top, config: Config)]
pub struct Top {
    /// Constants of the run.
    #[port("setting")]
    settings: Input<Settings>,
    /// Iterations that a query has at most, at least one.
    #[bits(ITERATION_BITS)]
    iterations_max: Input<u16>,
    /// The points have changed. Not while a query is under way.
    forget: Input<bool>,
    /// Queries.
    query: In<Query>,
    /// Searches.
    wanted: Out<Wanted>,
    /// Neighbors found.
    found: In<Found>,
    /// Requests to the memory of the points.
    fetch: Out<LineFetch>,
    /// The points of the lines from memory, in the order of the requests.
    fill: In<Neighbor>,
    /// Queries that leave, in any order.
    result: Out<Outcome>,
    /// Nothing is under way.
    idle: Output<bool>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<Events>,
}

/// Every unit of the process core, the core itself last.
pub static UNITS: [&Unit<Config>; 9] = [
    &control::UNIT,
    &bank::UNIT,
    &init::UNIT,
    &finish::UNIT,
    &output::UNIT,
    &threads::UNIT,
    &gatherer::UNIT,
    &kernel::UNIT,
    &top::UNIT,
];
