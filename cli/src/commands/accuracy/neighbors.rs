//! `pointcore accuracy --neighbors POINTS`.

use super::{Arguments, report};
use crate::commands::shard::spread;
use crate::commands::{Failure, Output, write};
use pointcore::search::{PointSet, PointSource, Rounding};
use pointcore_contract::search::Config;
use pointcore_lab::accuracy::estimator;
use pointcore_lab::accuracy::neighbors::{NeighborSetting, Task, markdown, rank};
use pointcore_lab::note;
use pointcore_tb::cache::Cache;
use serde_json::json;
use std::path::Path;

/// Sweeps what trades accuracy of neighbors for time and hardware.
pub fn run(source: &PointSource, arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let points = PointSet::load(Config::default().geometry, source)?;
    Rounding::of(&points, arguments.k).check()?;
    let task = Task { points: &points, k: arguments.k, limit: arguments.queries as usize, engine: arguments.engine() };
    let cache = Cache::new(arguments.folder());
    let mut settings = NeighborSetting::all();
    if let Some(shard) = arguments.shard {
        settings = shard.of(settings);
    }
    let measure = |setting: &NeighborSetting| {
        let found = task.measure(&cache, *setting)?;
        note!("{}: {:.1} cycles a query", setting.name(), found.cycles_per_query);
        Ok::<_, Failure>(found)
    };
    let found: Result<Vec<_>, Failure> = spread(&settings, arguments.jobs, measure).into_iter().collect();
    let found = found?;
    if arguments.shard.is_some() {
        return report(found.len(), cache.folder(), output);
    }
    let ranked = rank(found, &estimator(&arguments.record, &cache)?);
    let folder = arguments.output.clone().unwrap_or_else(|| Path::new("out/accuracy/neighbors").to_owned());
    let text = format!(
        "# {source}: what accuracy costs in neighbor search\n\n{} nearest neighbors, {} queries, 8×8 around a point.\n\n{}",
        arguments.k,
        arguments.queries,
        markdown(&ranked)
    );
    let result =
        json!({ "points": source.to_string(), "k": arguments.k, "queries": arguments.queries, "sweep": ranked });
    write(&folder.join("README.md"), &text)?;
    write(&folder.join("accuracy.json"), &serde_json::to_string_pretty(&result).expect("results have string keys"))?;
    output.print(&result, &format!("{text}\nWritten to {}.", folder.display()))
}
