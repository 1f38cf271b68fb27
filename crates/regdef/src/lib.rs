//! Register descriptions.
pub mod syntax;
