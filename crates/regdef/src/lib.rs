//! Register descriptions: a language to transcribe a controller's manual in, its loader and its checked model.
//!
//! A description is a YAML file. [`load_file`] reads it, reports everything that is wrong with it as
//! [`diagnostic::Diagnostic`]s with file, line and column, and gives the [`model::Model`] that emitters work from.
//!
//! ```
//! let loaded = regdef::load_str("demo.yaml", "
//! controller: demo
//! title: Demonstration
//! manual: {title: Demo Manual, publisher: Nobody, revision: '1', date: 2026-01-01}
//! register_width: 32
//! access_widths: [32]
//! span: 4
//! registers:
//!   CTRL:
//!     title: Control Register
//!     offset: 0
//!     reset: 1
//!     cite: {section: '1.1', page: 3}
//!     doc: Starts and stops the demonstration.
//!     fields:
//!       INIT: {bits: 0, access: rw, doc: Holds the controller in initialization while 1.}
//! ");
//! let model = loaded.model.expect("no errors");
//! assert_eq!(model.registers[0].field("INIT").map(|f| f.width), Some(1));
//! ```

mod check;
pub mod diagnostic;
pub mod diff;
mod load;
mod lower;
pub mod model;
mod path;
mod shape;
mod source;
pub mod syntax;

pub use load::{Loaded, load_bytes, load_file, load_str};
pub use path::Path;
pub use shape::schema;
pub use source::{MAX_BYTES, MAX_DEPTH, Source};
