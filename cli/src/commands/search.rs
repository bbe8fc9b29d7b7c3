//! What is searched, on which hardware: the arguments that `knn` and `vectors` share.

use super::{Failure, choices, numbers};
use glam::DVec3;
use pointcore::configuration;
use pointcore::scene::InvalidPoints;
use pointcore::search::{Order, PointSet, PointSource, Query, Reuse, SearchError, Splitting, config_for};
use pointcore_contract::search::Config;
use std::path::PathBuf;

/// Neighborhoods of the thesis' neighbor cache.
const CACHE_ENTRIES: u32 = 8;

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
    /// Neighborhoods that a coherent neighbor cache holds, up to 32; 0 leaves it out. By default 8 with --epsilon or --alpha, else 0.
    #[arg(long, value_name = "COUNT", conflicts_with = "config", value_parser = numbers::within(0_u32..=32, "0 to 32 neighborhoods"))]
    cache: Option<u32>,
    /// How much farther than the true ones neighbors from the neighbor cache may be, as a share; by default not at all.
    #[arg(long, value_name = "SHARE", value_parser = numbers::within(Reuse::EPSILON, "0 to 10"))]
    epsilon: Option<f32>,
    /// The factor by which balls are searched larger for the neighbor cache; by default 1.25.
    #[arg(long, value_name = "FACTOR", value_parser = numbers::within(Reuse::ALPHA, "1 to 10"))]
    alpha: Option<f32>,
    /// Seed of everything random: shuffles, and in a simulation stalls, the memory's order and uninitialized values.
    #[arg(long, default_value_t = 1, value_parser = numbers::whole())]
    pub seed: u64,
}

impl SearchArguments {
    /// Checks what goes together.
    pub fn check(&self) -> Result<(), Failure> {
        let usage = |message| Err(Failure::Usage(message));
        if self.cache == Some(0) && self.wants_reuse() {
            return usage(
                "--cache 0: --epsilon and --alpha go with a neighbor cache of 1 to 32 neighborhoods".to_owned(),
            );
        }
        Ok(self.reuse().validate()?)
    }

    /// What the neighbor cache may answer.
    pub fn reuse(&self) -> Reuse {
        let Reuse { epsilon, alpha } = Reuse::default();
        Reuse { epsilon: self.epsilon.unwrap_or(epsilon), alpha: self.alpha.unwrap_or(alpha) }
    }

    /// Whether something is said that only a neighbor cache heeds.
    const fn wants_reuse(&self) -> bool {
        self.epsilon.is_some() || self.alpha.is_some()
    }

    /// Neighborhoods in the neighbor cache, where no configuration says.
    fn cache(&self) -> u32 {
        self.cache.unwrap_or(if self.wants_reuse() { CACHE_ENTRIES } else { 0 })
    }

    /// The hardware, and the points in its format.
    pub fn hardware(&self, points: &PointSource, invalid: InvalidPoints) -> Result<(Config, PointSet), Failure> {
        if let Some(path) = &self.config {
            let config = configuration::parse_search(path, &configuration::read_text(path)?)?;
            if config.neighbor_cache == 0 && self.wants_reuse() {
                let message = "--epsilon and --alpha go with a neighbor cache: set `neighbor_cache` in";
                return Err(Failure::Usage(format!("{message} {}", path.display())));
            }
            let points = PointSet::load_with(config.geometry, points, invalid)?;
            return Ok((config, points));
        }
        let points = PointSet::load_with(Config::default().geometry, points, invalid)?;
        // The neighbor cache needs one neighbor more to tell how far a neighborhood reaches.
        let cache = self.cache();
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
