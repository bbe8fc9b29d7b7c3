//! The laboratory measures what it says.
mod configurations;
mod soak;
mod stability;
mod synthesis;
