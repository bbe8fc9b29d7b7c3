//! Neighbor search.

use crate::arguments::{array, borrowed, copy, drop_handle, hand_over, place, text};
use crate::status::{Status, call, engine};
use pointcore_bindings::SearchSettings;
use std::ffi::c_char;

/// Points in a tree, and a core that searches it.
pub struct Search(pointcore_bindings::Search);

/// Sorts `count` points, three numbers each, into a tree, and generates a core for up to `k` neighbors of each query.
///
/// `configuration` is the hardware's, as TOML, or NULL for one that follows from the points; `back_end` is one of
/// `PointcoreBackEnd`. `pointcore_search_close` ends it.
///
/// # Safety
/// `points` holds 3 * `count` numbers, `configuration` is NULL or a C string, `search` a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_search_open(
    points: *const f64,
    count: usize,
    k: u32,
    configuration: *const c_char,
    back_end: u32,
    search: *mut *mut Search,
) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (points, configuration, search) = unsafe {
            (array("points", points, count)?, text("configuration", configuration)?, place("search", search)?)
        };
        let settings = SearchSettings { k, configuration, back_end: engine(back_end)? };
        hand_over(Search(pointcore_bindings::Search::open(points.to_vec(), settings)?), search);
        Ok(())
    })
}

/// The nearest `k` neighbors of each of `count` queries, nearer than `radius`; INFINITY for all.
///
/// For each query `indices` and `distances2` are given `k` numbers, nearest first: indices of points, -1 where there
/// are fewer, and squared distances, INFINITY there; `counts` is given how many there are, and `cycles` the cycles of
/// the whole run. Any of these may be NULL.
///
/// # Safety
/// `search` is open, `queries` holds 3 * `count` numbers, `indices` and `distances2` have places for `k` * `count`,
/// `counts` for `count`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_search(
    search: *const Search,
    queries: *const f64,
    count: usize,
    k: u32,
    radius: f64,
    indices: *mut i64,
    distances2: *mut f32,
    counts: *mut u32,
    cycles: *mut u64,
) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (Search(search), queries) = unsafe { (borrowed("search", search)?, array("queries", queries, count)?) };
        let found = search.search(queries, k, (radius != f64::INFINITY).then_some(radius))?;
        // SAFETY: as the caller says.
        unsafe {
            copy(&found.indices, indices);
            copy(&found.distances2, distances2);
            copy(&found.counts, counts);
            copy(&[found.cycles], cycles);
        }
        Ok(())
    })
}

/// Ends a search; NULL is none.
///
/// # Safety
/// `search` is NULL or open, and no thread uses it any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_search_close(search: *mut Search) {
    // SAFETY: as the caller says.
    unsafe { drop_handle(search) };
}
