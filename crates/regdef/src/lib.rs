//! Register descriptions.
pub mod diagnostic;
pub mod model;
mod path;
mod source;
pub mod syntax;
pub use path::Path;
pub use source::Source;
