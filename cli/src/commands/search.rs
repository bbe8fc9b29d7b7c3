//! What is searched, on which hardware: the arguments that `knn` and `vectors` share.

use super::reuse::ReuseArguments;
use super::{Failure, choices, numbers};
use glam::DVec3;
use pointcore::configuration;
use pointcore::scene::InvalidPoints;
use pointcore::search::{Order, PointSet, PointSource, Query, Reuse, SearchError, Splitting, config_for};
use pointcore_contract::search::Config;
use std::path::PathBuf;

/// How many queries are asked.
#[derive(Clone, Copy)]
pub struct Limit(pub Option<usize>);

impl std::str::FromStr for Limit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let count = text.parse().ok().filter(|count| *count > 0);
        match (text, count) {
            ("all", _) => Ok(Self(None)),
            (_, Some(count)) => Ok(Self(Some(count))),
            _ => Err("expected a number of queries from 1 up, or `all`".to_owned()),
        }
    }
}

/// What is asked.
pub struct Questions {
    /// As the hardware takes it.
    pub queries: Vec<Query>,
    /// Where, in the coordinates of the points' file.
    pub places: Vec<DVec3>,
    /// Where they come from, in words.
    pub source: String,
}

/// A search but for its points.
#[derive(clap::Args)]
pub struct SearchArguments {
    /// Neighbors of each query, 1 to 64.
    #[arg(long, value_name = "COUNT", default_value_t = 10, value_parser = numbers::within(1_u32..=64, "1 to 64 neighbors"))]
    pub k: u32,
    /// Only neighbors nearer than this count.
    #[arg(long, value_name = "LENGTH", value_parser = numbers::within(f32::MIN_POSITIVE..=f32::MAX, numbers::POSITIVE))]
    pub radius: Option<f32>,
    /// Query points, the vertices of a model file in their order.
    #[arg(long, value_name = "FILE", conflicts_with = "order")]
    queries: Option<PathBuf>,
    /// Ask for the points themselves: `random`, `file` or `morton` order, or `grid:BxB` queries around each.
    #[arg(long, default_value_t = Order::Random)]
    order: Order,
    /// How many queries to ask, or `all`.
    #[arg(long, value_name = "COUNT", default_value = "2000")]
    limit: Limit,
    /// How the tree divides points.
    #[arg(long, value_parser = choices::splittings(), default_value = "packed")]
    pub tree: Splitting,
    /// The hardware's configuration, such as configs/knn.toml.
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    #[command(flatten)]
    reuse: ReuseArguments,
    /// Seed of everything random: shuffles, and in a simulation stalls, the memory's order and uninitialized values.
    #[arg(long, default_value_t = 1, value_parser = numbers::whole())]
    pub seed: u64,
}

impl SearchArguments {
    /// Checks what goes together.
    pub fn check(&self) -> Result<(), Failure> {
        self.reuse.check()
    }

    /// What the neighbor cache may answer.
    pub fn reuse(&self) -> Reuse {
        self.reuse.factors()
    }

    /// The hardware, and the points in its format.
    pub fn hardware(&self, points: &PointSource, invalid: InvalidPoints) -> Result<(Config, PointSet), Failure> {
        if let Some(path) = &self.config {
            let config = configuration::parse_search(path, &configuration::read_text(path)?)?;
            self.reuse.check_hardware(config.neighbor_cache, path)?;
            let points = PointSet::load_with(config.geometry, points, invalid)?;
            return Ok((config, points));
        }
        let points = PointSet::load_with(Config::default().geometry, points, invalid)?;
        // The neighbor cache needs one neighbor more to tell how far a neighborhood reaches.
        let cache = self.reuse.neighborhoods();
        let searched = if cache > 0 && self.radius.is_none() { self.k + 1 } else { self.k };
        let config = config_for(points.points().len(), searched, self.tree);
        let config = Config { neighbor_cache: cache, ..config };
        config.validate().map_err(SearchError::from)?;
        Ok((config, points))
    }

    /// Queries that the hardware can answer.
    pub fn questions(&self, config: &Config, points: &PointSet, invalid: InvalidPoints) -> Result<Questions, Failure> {
        let Limit(limit) = self.limit;
        let (mut places, source) = match &self.queries {
            Some(path) => (PointSource::File(path.clone()).points(invalid)?, path.display().to_string()),
            None => (self.order.places(points, limit, self.seed), format!("{} order", self.order)),
        };
        places.truncate(limit.unwrap_or(usize::MAX));
        let query = |place: &DVec3| Query { point: points.rounded(*place), k: self.k, radius: self.radius };
        let queries: Vec<Query> = places.iter().map(query).collect();
        queries.iter().enumerate().try_for_each(|(index, query)| query.check(config, index))?;
        let limited = limit.filter(|limit| *limit == queries.len());
        let limited = limited.map_or(String::new(), |limit| format!(" (--limit {limit})"));
        Ok(Questions { queries, places, source: source + &limited })
    }
}
