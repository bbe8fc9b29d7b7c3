//! How a call ended, and what computes.

use pointcore_bindings::{BackEnd as Engine, BindingError, ErrorKind, guarded};
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};

/// How a call ended.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// As it should.
    Ok = 0,
    /// What was given makes no sense.
    Input = 1,
    /// A file cannot be read or written.
    File = 2,
    /// The hardware could not be generated, built or run, a tool is missing, or hardware and model differ.
    Hardware = 3,
    /// A fault of pointcore itself.
    Internal = 4,
}

/// What computes. There will be more.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BackEnd {
    /// The bit-exact, cycle-accurate golden model; needs no tools.
    Golden = 0,
    /// The generated Verilog under Verilator.
    Verilog = 1,
    /// The generated Verilog under Verilator, every output compared with the golden model in every cycle.
    VerilogInLockstep = 2,
    /// The golden interpreter of programs: bit-exact, without time.
    Interpreter = 3,
}

/// The back end of a number, which C may have from anywhere.
pub(crate) fn engine(back_end: u32) -> Result<Engine, BindingError> {
    let known = [
        (BackEnd::Golden, Engine::Golden),
        (BackEnd::Verilog, Engine::Verilog),
        (BackEnd::VerilogInLockstep, Engine::VerilogInLockstep),
        (BackEnd::Interpreter, Engine::Interpreter),
    ];
    let found = known.into_iter().find(|(number, _)| *number as u32 == back_end);
    let wrong = || BindingError::input(format!("the back end is {back_end}: expected a value of PointcoreBackEnd"));
    found.map(|(_, engine)| engine).ok_or_else(wrong)
}

thread_local! {
    static MESSAGE: RefCell<CString> = RefCell::default();
}

/// Text for C, which ends at its first NUL.
pub(crate) fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', " ")).unwrap_or_default()
}

/// Runs a call's body: its error becomes a status and this thread's message.
pub(crate) fn call(run: impl FnOnce() -> Result<(), BindingError>) -> Status {
    let Err(error) = guarded(run) else { return Status::Ok };
    MESSAGE.with_borrow_mut(|message| *message = c_text(&error.message));
    match error.kind {
        ErrorKind::Input => Status::Input,
        ErrorKind::File => Status::File,
        ErrorKind::Hardware => Status::Hardware,
        _ => Status::Internal,
    }
}

/// What was wrong with this thread's last call that failed; valid until its next one does. Empty if none did.
#[unsafe(no_mangle)]
pub extern "C" fn pointcore_error_message() -> *const c_char {
    MESSAGE.with_borrow(|message| message.as_ptr())
}

/// The library's version, such as "0.1.0".
#[unsafe(no_mangle)]
pub extern "C" fn pointcore_version() -> *const c_char {
    const VERSION: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => panic!("a version has no NUL"),
    };
    VERSION.as_ptr()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message() -> String {
        // SAFETY: the message is a C string of this thread, which nothing changes meanwhile.
        unsafe { CStr::from_ptr(pointcore_error_message()) }.to_string_lossy().into_owned()
    }

    #[test]
    fn each_thread_has_its_own_message() {
        assert_eq!(call(|| Err(BindingError::input("here \0 it is"))), Status::Input);
        std::thread::spawn(|| assert_eq!(message(), "")).join().expect("the other thread has no message");
        assert_eq!(call(|| Ok(())), Status::Ok);
        assert_eq!(message(), "here   it is", "a call that succeeds leaves it");
    }

    #[test]
    fn panics_stay_inside() {
        assert_eq!(call(|| panic!("a fault")), Status::Internal);
        assert!(message().contains("a fault"));
    }

    #[test]
    fn back_ends_are_known_by_number() {
        assert_eq!(engine(BackEnd::VerilogInLockstep as u32), Ok(Engine::VerilogInLockstep));
        assert!(engine(4).is_err());
    }
}
