//! Records as lists of names and widths.

use super::config::Config;
use super::records as typed;
use crate::Record;
use crate::splat::Field;

fn list<R: Record<Config = Config>>(config: &Config) -> Vec<Field> {
    crate::fields::<R>(config).into_iter().map(|field| (field.name, field.width)).collect()
}

macro_rules! lists {
    ($($name:ident: $record:ident),* $(,)?) => {
        $(
            /// The fields of that record.
            #[must_use]
            pub fn $name(config: &Config) -> Vec<Field> {
                list::<typed::$record>(config)
            }
        )*
    };
}

lists! {
    query: Query,
    result: QueryResult,
    cached_query: CachedQuery,
    cached_result: CachedResult,
    cache_setup: CacheSetup,
    lookup: Lookup,
    tree_record: TreeRecord,
    node: Node,
    bucket: Bucket,
    node_record: NodeRecord,
    tree_write: TreeWrite,
    start: Start,
    descent: Descent,
    path: Path,
    thread_only: Thread,
    leaf: LeafVisit,
    fetch: Fetch,
    beat: Beat,
    candidates: Candidates,
    radius: Radius,
}
