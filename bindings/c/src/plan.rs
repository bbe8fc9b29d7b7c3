//! Which hardware something calls for, and its files.

use crate::arguments::{drop_handle, hand_over, place, required_text};
use crate::status::{Status, c_text, call};
use std::ffi::{CString, c_char};
use std::path::Path;

/// Hardware that something calls for.
pub struct Plan {
    text: CString,
    toml: CString,
}

impl From<pointcore_bindings::Plan> for Plan {
    fn from(plan: pointcore_bindings::Plan) -> Self {
        Self { text: c_text(plan.text()), toml: c_text(&plan.toml()) }
    }
}

/// Plans the search core for so many points and up to `k` neighbors of each query. `pointcore_plan_close` ends it.
///
/// # Safety
/// `plan` is a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_plan_search(points: usize, k: u32, plan: *mut *mut Plan) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let plan = unsafe { place("plan", plan)? };
        hand_over(pointcore_bindings::Plan::search(points, k)?.into(), plan);
        Ok(())
    })
}

/// What was chosen and why, and what it takes, for people; valid until the plan is closed. NULL for NULL.
///
/// # Safety
/// `plan` is NULL or open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_plan_text(plan: *const Plan) -> *const c_char {
    // SAFETY: as the caller says.
    unsafe { plan.as_ref() }.map_or(std::ptr::null(), |plan| plan.text.as_ptr())
}

/// The hardware's configuration as TOML; valid until the plan is closed. NULL for NULL.
///
/// # Safety
/// `plan` is NULL or open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_plan_toml(plan: *const Plan) -> *const c_char {
    // SAFETY: as the caller says.
    unsafe { plan.as_ref() }.map_or(std::ptr::null(), |plan| plan.toml.as_ptr())
}

/// Ends a plan; NULL is none.
///
/// # Safety
/// `plan` is NULL or open, and no thread uses it any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_plan_close(plan: *mut Plan) {
    // SAFETY: as the caller says.
    unsafe { drop_handle(plan) };
}

/// Writes the Verilog of a configuration, given as TOML, and what goes with it, into a folder, which is made if it is
/// missing. The FuseSoC core among the files bears `name`: letters, digits, `_` and `-`.
///
/// # Safety
/// `configuration`, `folder` and `name` are C strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_generate(
    configuration: *const c_char,
    folder: *const c_char,
    name: *const c_char,
) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (configuration, folder, name) = unsafe {
            (
                required_text("configuration", configuration)?,
                required_text("folder", folder)?,
                required_text("name", name)?,
            )
        };
        pointcore_bindings::generate(configuration, Path::new(folder), name).map(drop)
    })
}
