//! The text of a description and the position of every key and value in it.

mod walk;

use std::collections::HashMap;
use std::ops::Range;

use serde_json::Value;

use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::path::Path;

/// Largest description that is read, in bytes. The largest of the four controllers takes about 0.2 MB.
pub const MAX_BYTES: u64 = 8 << 20;

/// Deepest nesting of mappings and lists. The language itself needs 9.
pub const MAX_DEPTH: usize = 64;

/// A description's text with the positions of its nodes.
#[derive(Debug, Clone)]
pub struct Source {
    name: String,
    text: String,
    spans: HashMap<Path, Span>,
}

/// Where a node stands.
#[derive(Debug, Clone, Default)]
pub(crate) struct Span {
    key: Option<Range<usize>>,
    value: Range<usize>,
}

impl Source {
    /// A text without positions: all that can be said of it is said by byte offset.
    #[must_use]
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into(), spans: HashMap::new() }
    }

    /// The name shown in diagnostics: the path of the file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The bytes a place covers; `None` for the file as a whole. A path that is not in the file falls back to
    /// the nearest node above it.
    #[must_use]
    pub fn range(&self, at: &Spot) -> Option<Range<usize>> {
        let lookup = |path: &Path, key: bool| {
            let mut path = path.clone();
            let mut key = key;
            loop {
                if let Some(span) = self.spans.get(&path) {
                    let range =
                        if key { span.key.clone().unwrap_or_else(|| span.value.clone()) } else { span.value.clone() };
                    return Some(range);
                }
                if path == Path::root() {
                    return None;
                }
                path = path.parent();
                key = true;
            }
        };
        match at {
            Spot::Key(path) => lookup(path, true),
            Spot::Value(path) => lookup(path, false),
            Spot::Bytes(range) => Some(self.clamp(range.clone())),
            Spot::File => None,
        }
    }

    /// Moves a range onto character boundaries inside the text.
    fn clamp(&self, range: Range<usize>) -> Range<usize> {
        let start = self.text.floor_char_boundary(range.start);
        let end = self.text.ceil_char_boundary(range.end.max(start));
        start..end
    }

    /// Reads bytes as text and walks it once: positions, duplicate keys, nesting, anchors, documents.
    ///
    /// Returns the tree as JSON for the check of its shape, unless the text is not one YAML mapping.
    pub(crate) fn read(name: &str, bytes: &[u8], findings: &mut Vec<Diagnostic>) -> (Self, Option<Value>) {
        if bytes.len() as u64 > MAX_BYTES {
            findings.push(too_large(bytes.len() as u64));
            return (Self::new(name, ""), None);
        }
        let text = match std::str::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => {
                let good = error.valid_up_to();
                let text = String::from_utf8_lossy(bytes).into_owned();
                findings.push(
                    Diagnostic::new(
                        Code::NotUtf8,
                        Spot::Bytes(good..good + '\u{fffd}'.len_utf8()),
                        format!("byte 0x{:02x} at offset {good} is not UTF-8", bytes[good]),
                    )
                    .help("save the file in the encoding UTF-8"),
                );
                return (Self::new(name, text), None);
            }
        };
        let mut source = Self::new(name, text);
        if let Some(at) = text.find("\r\n") {
            findings.push(
                Diagnostic::new(Code::CrLf, Spot::Bytes(at..at), "the lines end with CRLF")
                    .help("convert the file to LF line ends, as `dos2unix` does"),
            );
        }
        let tree = walk::walk(text, &mut source.spans, findings);
        (source, tree)
    }
}

/// The finding for a file over the limit.
pub(crate) fn too_large(bytes: u64) -> Diagnostic {
    Diagnostic::new(
        Code::TooLarge,
        Spot::File,
        format!("the file has {bytes} bytes; a description may have {MAX_BYTES} at the most"),
    )
    .help("this is not a register description, or it repeats what `like`, arrays and lanes could say once")
}
