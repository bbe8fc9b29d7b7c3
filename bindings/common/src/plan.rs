//! Which hardware a scene or points call for, and why.

use crate::search::{check_k, check_points, derived};
use crate::{BindingError, Scene};
use pointcore::area::count;
use pointcore::configuration::Configuration;
use pointcore::plan::Plan as ScenePlan;
use pointcore::search::{HardwareSize, SearchCore};
use pointcore::splat::SplatCore;
use pointcore_contract::search::Config;
use std::fmt::Write as _;

/// Hardware that something calls for.
#[derive(Clone, Debug)]
pub struct Plan {
    configuration: Configuration,
    text: String,
}

impl Plan {
    /// The renderer for a scene.
    ///
    /// # Errors
    /// The scene's overrides do not go with it.
    pub fn scene(scene: &Scene) -> Result<Self, BindingError> {
        let plan = ScenePlan::of(&scene.0)?;
        let design = SplatCore::generate(&plan.config)?.design;
        let everything = SplatCore::generate(&plan.with_everything().config)?.design;
        let mut text = format!("{} splats\n\n", scene.splats());
        for made in &plan.choices {
            choice(&mut text, made.part, &made.chosen, &made.reason);
        }
        _ = write!(text, "\n  {:22} {:>12} {:>12}\n", "area proxy", "this scene", "everything");
        for (name, planned, full) in count::rows(&design, &everything) {
            _ = writeln!(text, "  {name:22} {planned:>12} {full:>12}");
        }
        Ok(Self { configuration: Configuration::Splat(plan.config), text })
    }

    /// The search core for so many points and so many neighbors of each query.
    ///
    /// # Errors
    /// No core holds that.
    pub fn search(points: usize, k: u32) -> Result<Self, BindingError> {
        let config = derived(points, k);
        check_points(points, &config)?;
        check_k(k, &config)?;
        let size = HardwareSize::of(&SearchCore::generate(&config)?, &config, None, None)?;
        let mut text = format!("{points} points, up to {k} neighbors of each query\n\n");
        for (part, chosen, reason) in reasons(&config, points) {
            choice(&mut text, part, &chosen, &reason);
        }
        text.push('\n');
        for (name, figure) in size.rows() {
            _ = writeln!(text, "  {name:22} {figure}");
        }
        Ok(Self { configuration: Configuration::Search(config), text })
    }

    /// What was chosen and why, and what it takes, for people.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The hardware's configuration, a TOML file that [`generate`](crate::generate()) and the `pointcore` command take.
    #[must_use]
    pub fn toml(&self) -> String {
        self.configuration.text()
    }
}

/// What was chosen for a search, and why.
fn reasons(config: &Config, points: usize) -> [(&'static str, String, String); 4] {
    let Config { tree_depth, bucket, neighbors, lanes, threads, leaves_in_flight, .. } = config;
    let leaves = 1_u64 << tree_depth;
    [
        ("tree_depth", tree_depth.to_string(), format!("{leaves} buckets of {bucket} points hold all {points}")),
        ("neighbors", neighbors.to_string(), "the priority queues hold so many of each query".to_owned()),
        ("lanes", lanes.to_string(), "points whose distance is computed in a cycle".to_owned()),
        (
            "threads",
            threads.to_string(),
            format!(
                "queries under way at a time, each with up to {leaves_in_flight} leaves: they hide the memory's latency"
            ),
        ),
    ]
}

fn choice(text: &mut String, part: &str, chosen: &str, reason: &str) {
    _ = writeln!(text, "  {part:22} {chosen:14} {reason}");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BackEnd, ErrorKind, Search, SearchSettings};

    #[test]
    fn a_plan_is_the_hardware_of_a_search() {
        let plan = Plan::search(1000, 20).expect("a core holds that");
        assert!(plan.text().contains("tree_depth") && plan.text().contains("flip-flops"), "{}", plan.text());
        let text = plan.toml();
        assert!(text.contains("neighbors = 20"), "{text}");
        let points = (0..1000_u16).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        let settings = SearchSettings { k: 20, configuration: Some(&text), back_end: BackEnd::Golden };
        assert!(Search::open(points, settings).is_ok());
    }

    #[test]
    fn what_no_core_holds_is_refused() {
        for (points, k, part) in [(0, 1, "empty"), (100, 65, "k is 65"), (1 << 40, 1, "points")] {
            let error = Plan::search(points, k).expect_err(part);
            assert_eq!(error.kind, ErrorKind::Input);
            assert!(error.message.contains(part), "{error}");
        }
    }
}
