//! The f64 reference renderer.
