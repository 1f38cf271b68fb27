//! Emitters: a checked [`regdef::model::Model`] in, text out. No emitter reads or writes a file.

pub mod c;
pub mod html;
pub mod language;
pub mod rust;
pub mod svd;
pub mod table;
mod text;

/// A file that an emitter made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    /// Path relative to the folder the emitter writes to, with `/` between its parts.
    pub path: String,
    /// The text.
    pub content: String,
}
