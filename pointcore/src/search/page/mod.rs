//! A search as a page: where its cycles go, and where among the points its queries take long.

use super::report::{Bound, SearchReport};
use super::{PointSet, Query};
use crate::page::{Bar, Page, bars, table};
use serde_json::json;

/// Points and queries that a picture shows at most; evenly spaced ones where there are more.
const SHOWN: usize = 20_000;
/// Steps along the longest side of the points' box, in which places are told.
const STEPS: f64 = 4095.0;

/// Every n-th item, so that no more than [`SHOWN`] are left.
fn thinned<T>(items: &[T]) -> impl Iterator<Item = &T> {
    items.iter().step_by(items.len().div_ceil(SHOWN).max(1))
}

/// Places as whole numbers within a box.
fn places<'a>(points: impl Iterator<Item = &'a [f32; 3]>, low: [f32; 3], side: f32) -> Vec<[i32; 3]> {
    let step = |point: &[f32; 3]| {
        let mut place = [0; 3];
        for axis in 0..3 {
            place[axis] = (f64::from(point[axis] - low[axis]) / f64::from(side) * STEPS).round() as i32;
        }
        place
    };
    points.map(step).collect()
}

/// Where the cycles go: what each resource takes of a query's, then what waits for what.
fn causes(report: &SearchReport) -> String {
    let all = report.cycles_per_query.max(f64::MIN_POSITIVE);
    let resource = |Bound { name, cycles_per_query }: &Bound| Bar {
        name: (*name).to_owned(),
        share: cycles_per_query / all,
        figure: format!("{cycles_per_query:.2}"),
        is_marked: *name == report.bound.name,
    };
    let mut sorted: Vec<_> = report.bounds.iter().filter(|bound| bound.cycles_per_query > 0.0).cloned().collect();
    sorted.sort_by(|a, b| b.cycles_per_query.total_cmp(&a.cycles_per_query));
    let waits = [
        ("query waits for a thread", report.thread_wait),
        ("queues stay for another insertion", report.insert_wait),
        ("memory waits for the core", report.beat_wait),
    ];
    let wait = |(name, share): (&str, f64)| Bar {
        name: name.to_owned(),
        share,
        figure: format!("{:.2}", share * all),
        is_marked: false,
    };
    let waits: Vec<Bar> = waits.into_iter().map(wait).collect();
    format!(
        "{}\n<h2>Waiting</h2>\n<p>Cycles a query in which something stood still; they overlap with each other.</p>\n{}",
        bars(&sorted.iter().map(resource).collect::<Vec<_>>()),
        bars(&waits)
    )
}

/// The page of a search; `query_cycles` are those of each query.
#[must_use]
pub fn page(report: &SearchReport, points: &PointSet, queries: &[Query], query_cycles: &[u32]) -> String {
    let all = points.points();
    let [low, high] = all.iter().fold([[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]], |[mut low, mut high], point| {
        for axis in 0..3 {
            (low[axis], high[axis]) = (low[axis].min(point[axis]), high[axis].max(point[axis]));
        }
        [low, high]
    });
    let side = (0..3).map(|axis| high[axis] - low[axis]).fold(f32::MIN_POSITIVE, f32::max);
    let asked: Vec<([f32; 3], u32)> =
        queries.iter().map(|query| query.point).zip(query_cycles.iter().copied()).collect();
    let shown: Vec<&([f32; 3], u32)> = thinned(&asked).collect();
    let data = json!({
        "points": places(thinned(all), low, side),
        "queries": places(shown.iter().map(|(place, _)| place), low, side),
        "cycles": shown.iter().map(|(_, cycles)| cycles).collect::<Vec<_>>(),
    });
    let rows: Vec<_> = report.rows().into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    let figures = [
        ("cycles a query", format!("{:.2}", report.cycles_per_query)),
        ("million queries a second", format!("{:.2}", report.queries_per_second / 1e6)),
        ("queries", report.queries.to_string()),
        ("points", report.tree.points.to_string()),
        ("of the cycles: the bound", format!("{:.0} %", 100.0 * report.share_of_bound)),
    ];
    let picture = "<figure><canvas id=\"cloud\" aria-label=\"points, and queries by their cycles\"></canvas>\
                   <figcaption><span id=\"least\"></span><span class=\"scale\" id=\"scale\"></span><span id=\"most\"></span>\
                   <span>cycles; drag to turn</span></figcaption></figure>";
    Page::new(format!("Nearest neighbors in {}", report.points))
        .figures(&figures)
        .section(
            "Cycles by cause",
            &format!(
                "Cycles a query in which each resource is at work, of {:.2} in all. They work side by side: the longest bar bounds the search.",
                report.cycles_per_query
            ),
            &causes(report),
        )
        .section(
            "Cycles by place",
            "Queries among the points, colored by the cycles from their offer to their last neighbor, those of other queries under way \
             at the same time included.",
            picture,
        )
        .section("Report", "As in report.md and report.json.", &table(&rows))
        .data("search", data)
        .script(include_str!("cloud.js"))
        .html()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shown_is_few_enough_and_within_the_box() {
        let many: Vec<_> = (0..50_001).collect();
        assert_eq!(thinned(&many).count(), 16_667);
        assert_eq!(thinned(&many[..7]).count(), 7);
        let points = [[1.0, 2.0, 3.0], [3.0, 2.0, 4.0]];
        assert_eq!(places(points.iter(), [1.0, 2.0, 3.0], 2.0), [[0, 0, 0], [4095, 0, 2048]]);
    }
}
