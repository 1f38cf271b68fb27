//! The text of a description and the position of every key and value in it.

mod text;
mod walk;

use std::collections::HashMap;
use std::ops::Range;

use serde_json::Value;

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::path::Path;

/// Largest description that is read, in bytes. The largest of the four controllers takes about 0.2 MB.
pub const MAX_BYTES: u64 = 8 << 20;

/// Deepest nesting of mappings and lists. The language itself needs 9.
pub const MAX_DEPTH: usize = 64;

/// Most mappings, lists and scalars together. The largest of the four controllers has about 20,000.
pub const MAX_NODES: usize = 500_000;

/// Longest key in bytes.
pub const MAX_KEY: usize = 256;

/// A description's text with the positions of its nodes.
#[derive(Debug, Clone)]
pub struct Source {
    name: String,
    text: String,
    /// Byte offset of every line.
    lines: Vec<usize>,
    nodes: Nodes,
}

/// Where a node stands.
#[derive(Debug, Clone, Default)]
struct Span {
    key: Option<Range<usize>>,
    value: Range<usize>,
}

/// The positions as a tree, so that a node costs no more than its own key however deep it stands.
#[derive(Debug, Clone, Default)]
struct Nodes {
    spans: Vec<Span>,
    children: HashMap<(usize, String), usize>,
}

impl Nodes {
    /// Adds a node, the first one as the root; a second one under the same key replaces the first.
    fn add(&mut self, parent: Option<(usize, String)>, span: Span) -> usize {
        let id = self.spans.len();
        self.spans.push(span);
        if let Some(place) = parent {
            self.children.insert(place, id);
        }
        id
    }

    /// The node a path leads to, or the nearest one above it; `true` if it is the node itself.
    fn find(&self, path: &Path) -> Option<(&Span, bool)> {
        let mut at = 0;
        let mut span = self.spans.first()?;
        for key in path.keys() {
            let Some(child) = self.children.get(&(at, key)) else { return Some((span, false)) };
            at = *child;
            span = &self.spans[at];
        }
        Some((span, true))
    }
}

impl Source {
    /// A text without positions: all that can be said of it is said by byte offset.
    #[must_use]
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Self { name: name.into(), text, lines, nodes: Nodes::default() }
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

    /// The line that holds a byte offset, counted from 0.
    #[must_use]
    pub fn line_of(&self, at: usize) -> usize {
        self.lines.partition_point(|start| *start <= at).saturating_sub(1)
    }

    /// The bytes of a line without its end, or of the last line if there are fewer.
    #[must_use]
    pub fn line(&self, line: usize) -> Range<usize> {
        let line = line.min(self.lines.len() - 1);
        let end = self.lines.get(line + 1).map_or(self.text.len(), |next| next - 1);
        self.lines[line]..end
    }

    /// The bytes a place covers; `None` for the file as a whole. A path that is not in the file falls back to
    /// the nearest node above it.
    #[must_use]
    pub fn range(&self, at: &Spot) -> Option<Range<usize>> {
        let lookup = |path: &Path, key: bool| {
            let (span, exact) = self.nodes.find(path)?;
            let of_key = span.key.clone().filter(|_| key || !exact);
            Some(of_key.unwrap_or_else(|| span.value.clone()))
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
    pub(crate) fn read(name: &str, bytes: &[u8], findings: &mut Findings) -> (Self, Option<Value>) {
        if bytes.len() as u64 > MAX_BYTES {
            findings.push(too_large(&format!("has {} bytes", bytes.len())));
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
                        format!("the byte 0x{:02x} at offset {good} is not UTF-8", bytes[good]),
                    )
                    .label("the text is good up to here")
                    .help("save the file in the encoding UTF-8"),
                );
                return (Self::new(name, text), None);
            }
        };
        let mut source = Self::new(name, text);
        if !text::check(text, findings) {
            return (source, None);
        }
        let tree = walk::walk(text, &mut source.nodes, findings);
        (source, tree)
    }
}

/// The finding for a file over a limit; `what` says which.
pub(crate) fn too_large(what: &str) -> Diagnostic {
    Diagnostic::new(
        Code::TooLarge,
        Spot::File,
        format!(
            "the file {what}; a description may have {MAX_BYTES} bytes and {MAX_NODES} keys and values at the most"
        ),
    )
    .help("this is not a register description, or it repeats what `like`, arrays and lanes could say once")
}
