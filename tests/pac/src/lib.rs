//! What the tests of the generated crates have in common.
//!
//! The tests stand apart from the generator and its dependencies, because every compile-fail test builds what its
//! package depends on once more.

mod recorder;

pub use recorder::{Access, Recorder, read, write};
