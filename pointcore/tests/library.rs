//! The library as its users see it.
mod parsers;
mod plan;
mod search_session;
