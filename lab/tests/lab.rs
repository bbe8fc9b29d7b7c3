//! The laboratory measures what it says.
mod stability;
mod synthesis;
