//! Readers of others panic on some files that no program writes; here that is an error like any other.
//!
//! What a panic prints is the program's business, not a library's: a program with a panic hook asks [`is_guarded`].

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

thread_local! {
    /// Whether a panic on this thread is caught, and so nobody's business.
    static IS_GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// Whether a panic on this thread becomes an error of a model file, of which a program's panic hook need not speak.
#[must_use]
pub fn is_guarded() -> bool {
    IS_GUARDED.get()
}

/// Calls a reader of a crate; its panic is an error that says so.
pub(super) fn guarded<T>(read: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    IS_GUARDED.set(true);
    // What a reader leaves half done on its panic is dropped with it.
    let outcome = catch_unwind(AssertUnwindSafe(read));
    IS_GUARDED.set(false);
    outcome.unwrap_or_else(|_| Err("is damaged: its parts contradict each other".to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_are_errors() {
        let nothing: Vec<u32> = Vec::new();
        let place = nothing.len();
        assert!(guarded(|| Ok(nothing[place])).is_err_and(|problem| problem.contains("damaged")));
        assert_eq!(guarded(|| Ok((7, is_guarded()))), Ok((7, true)));
        assert!(!is_guarded());
        assert_eq!(guarded::<()>(|| Err("short".to_owned())), Err("short".to_owned()));
    }
}
