//! Floating-point operators on encoded values.
