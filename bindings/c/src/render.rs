//! Rendering.

use crate::arguments::{borrowed, drop_handle, hand_over, place, text};
use crate::scene::Scene;
use crate::status::{Status, c_text, call, engine};
use std::ffi::{CString, c_char};
use std::ptr;

/// A scene, and the core that renders it.
pub struct Render(pointcore_bindings::Render);

/// A frame.
pub struct Frame {
    frame: pointcore_bindings::Frame,
    report: CString,
}

/// The arrays of a frame, row by row from the top left, valid until it is closed.
#[repr(C)]
pub struct FrameArrays {
    /// Samples a row: one a pixel, unless a scene file asks for more.
    pub width: usize,
    /// Rows of samples.
    pub height: usize,
    /// Linear RGB of the surface, three a sample, not shaded; zero where there is none.
    pub color: *const f32,
    /// Distance from the eye's plane; INFINITY where there is no surface.
    pub depth: *const f32,
    /// World-space normal, three a sample, of a length up to one; zero where there is no surface.
    pub normal: *const f32,
    /// 1 where there is a surface, 0 elsewhere.
    pub mask: *const u8,
    /// Pixels a row of the picture.
    pub picture_width: usize,
    /// Rows of the picture.
    pub picture_height: usize,
    /// The shaded picture on its background: sRGB, three bytes a pixel.
    pub picture: *const u8,
    /// Cycles from the first splat to the end of the frame.
    pub cycles: u64,
    /// The report's figures, a JSON object.
    pub report: *const c_char,
}

/// Those of no frame.
const NO_ARRAYS: FrameArrays = FrameArrays {
    width: 0,
    height: 0,
    color: ptr::null(),
    depth: ptr::null(),
    normal: ptr::null(),
    mask: ptr::null(),
    picture_width: 0,
    picture_height: 0,
    picture: ptr::null(),
    cycles: 0,
    report: ptr::null(),
};

/// Generates the core of a scene, or of a configuration given as TOML instead of NULL; `back_end` is one of
/// `PointcoreBackEnd`. `pointcore_render_close` ends it.
///
/// # Safety
/// `scene` is open, `configuration` NULL or a C string, `render` a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_render_open(
    scene: *const Scene,
    configuration: *const c_char,
    back_end: u32,
    render: *mut *mut Render,
) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (Scene(scene), configuration, render) =
            unsafe { (borrowed("scene", scene)?, text("configuration", configuration)?, place("render", render)?) };
        hand_over(Render(pointcore_bindings::Render::open(scene, configuration, engine(back_end)?)?), render);
        Ok(())
    })
}

/// Frames of the scene's sequence, one at least; 0 for NULL.
///
/// # Safety
/// `render` is NULL or open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_render_frames(render: *const Render) -> usize {
    // SAFETY: as the caller says.
    unsafe { render.as_ref() }.map_or(0, |Render(render)| render.frames())
}

/// Renders a frame of the sequence, which counts from 0. `pointcore_frame_close` ends it.
///
/// # Safety
/// `render` is open, `frame` a place for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_render_frame(render: *const Render, index: usize, frame: *mut *mut Frame) -> Status {
    call(|| {
        // SAFETY: as the caller says.
        let (Render(render), place) = unsafe { (borrowed("render", render)?, place("frame", frame)?) };
        let frame = render.frame(index)?;
        let report = c_text(&frame.report);
        hand_over(Frame { frame, report }, place);
        Ok(())
    })
}

/// The arrays of a frame; all NULL and 0 for NULL.
///
/// # Safety
/// `frame` is NULL or open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_frame_arrays(frame: *const Frame) -> FrameArrays {
    // SAFETY: as the caller says.
    let Some(Frame { frame, report }) = (unsafe { frame.as_ref() }) else { return NO_ARRAYS };
    let [picture_width, picture_height] = frame.picture_size;
    FrameArrays {
        width: frame.width,
        height: frame.height,
        color: frame.color.as_ptr(),
        depth: frame.depth.as_ptr(),
        normal: frame.normal.as_ptr(),
        mask: frame.mask.as_ptr(),
        picture_width,
        picture_height,
        picture: frame.picture.as_ptr(),
        cycles: frame.cycles,
        report: report.as_ptr(),
    }
}

/// Ends a frame; NULL is none.
///
/// # Safety
/// `frame` is NULL or open, and no thread uses it or its arrays any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_frame_close(frame: *mut Frame) {
    // SAFETY: as the caller says.
    unsafe { drop_handle(frame) };
}

/// Ends a rendering; NULL is none. Its frames stay.
///
/// # Safety
/// `render` is NULL or open, and no thread uses it any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pointcore_render_close(render: *mut Render) {
    // SAFETY: as the caller says.
    unsafe { drop_handle(render) };
}
