//! What C passes: pointers, checked for what can be checked.

use pointcore_bindings::BindingError;
use std::ffi::{CStr, c_char};

fn missing(name: &str) -> BindingError {
    BindingError::input(format!("`{name}` is NULL"))
}

/// An array of `count` elements, such as `[f64; 3]` for points.
///
/// # Safety
/// The pointer is NULL or to that many elements, which nothing changes meanwhile.
pub unsafe fn array<'a, T, E>(name: &str, elements: *const T, count: usize) -> Result<&'a [E], BindingError> {
    const { assert!(align_of::<T>() == align_of::<E>()) };
    match (elements.is_null(), count) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(missing(name)),
        // SAFETY: as the caller says.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts(elements.cast(), count) }),
    }
}

/// A text, or none for NULL.
///
/// # Safety
/// The pointer is NULL or to a C string, which nothing changes meanwhile.
pub unsafe fn text<'a>(name: &str, text: *const c_char) -> Result<Option<&'a str>, BindingError> {
    if text.is_null() {
        return Ok(None);
    }
    // SAFETY: as the caller says.
    let text = unsafe { CStr::from_ptr(text) }.to_str();
    text.map(Some).map_err(|_| BindingError::input(format!("`{name}` is not UTF-8")))
}

/// A text that must be there.
///
/// # Safety
/// As [`text`].
pub unsafe fn required_text<'a>(name: &str, given: *const c_char) -> Result<&'a str, BindingError> {
    // SAFETY: as the caller says.
    unsafe { text(name, given) }?.ok_or_else(|| missing(name))
}

/// What a handle or a pointer to a structure refers to.
///
/// # Safety
/// The pointer is NULL or to a value that lives on.
pub unsafe fn borrowed<'a, T>(name: &str, value: *const T) -> Result<&'a T, BindingError> {
    // SAFETY: as the caller says.
    unsafe { value.as_ref() }.ok_or_else(|| missing(name))
}

/// A place for a result.
///
/// # Safety
/// The pointer is NULL or to a place that nothing else uses meanwhile.
pub unsafe fn place<'a, T>(name: &str, place: *mut *mut T) -> Result<&'a mut *mut T, BindingError> {
    // SAFETY: as the caller says.
    unsafe { place.as_mut() }.ok_or_else(|| missing(name))
}

/// Copies results to where C wants them, or nowhere for NULL.
///
/// # Safety
/// The pointer is NULL or to as many places, which nothing else uses meanwhile.
pub unsafe fn copy<T: Copy>(results: &[T], to: *mut T) {
    if !to.is_null() {
        // SAFETY: as the caller says; what C gave is not what was just made.
        unsafe { std::ptr::copy_nonoverlapping(results.as_ptr(), to, results.len()) };
    }
}

/// Gives a value to C.
pub fn hand_over<T>(value: T, place: &mut *mut T) {
    *place = Box::into_raw(Box::new(value));
}

/// Takes a value back from C; NULL is none.
///
/// # Safety
/// The pointer is NULL or comes from [`hand_over`], and is not used any more.
pub unsafe fn drop_handle<T>(handle: *mut T) {
    if !handle.is_null() {
        // SAFETY: as the caller says.
        drop(unsafe { Box::from_raw(handle) });
    }
}
