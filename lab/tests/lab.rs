//! The laboratory measures what it says.
mod configurations;
mod stability;
mod synthesis;
