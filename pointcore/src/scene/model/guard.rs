//! Readers of others panic on some files that no program writes; here that is an error like any other.

use std::cell::Cell;
use std::panic::{catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// Whether a panic on this thread is caught, and so nobody's business.
    static IS_GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// Calls a reader of a crate; its panic is an error that says so, without a word on the error stream.
pub(super) fn guarded<T>(read: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    static SILENCE: Once = Once::new();
    SILENCE.call_once(|| {
        let hook = take_hook();
        set_hook(Box::new(move |panic| {
            if !IS_GUARDED.get() {
                hook(panic);
            }
        }));
    });
    IS_GUARDED.set(true);
    // What a reader leaves half done on its panic is dropped with it.
    let outcome = catch_unwind(std::panic::AssertUnwindSafe(read));
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
        assert_eq!(guarded(|| Ok(7)), Ok(7));
        assert_eq!(guarded::<()>(|| Err("short".to_owned())), Err("short".to_owned()));
    }
}
