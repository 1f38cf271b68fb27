//! Diagnostics: what is wrong, where, and what to do about it.

mod code;
mod render;

pub use code::{Code, Severity};
pub use render::report;

use std::ops::Range;

use crate::path::Path;

/// A place in the description.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Spot {
    /// The key that a path ends with.
    Key(Path),
    /// The value behind a path.
    Value(Path),
    /// Bytes of the text.
    Bytes(Range<usize>),
    /// The file as a whole.
    File,
}

/// A place with what is to be said about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub at: Spot,
    /// What is to be said; empty if the title says it all.
    pub text: String,
}

/// One finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Which kind of finding.
    pub code: Code,
    /// What is wrong, with the names and numbers of this case.
    pub title: String,
    /// The places, the most telling first.
    pub labels: Vec<Label>,
    /// What to do.
    pub help: Vec<String>,
}

impl Diagnostic {
    /// A finding at one place.
    #[must_use]
    pub fn new(code: Code, at: Spot, title: impl Into<String>) -> Self {
        Self { code, title: title.into(), labels: vec![Label { at, text: String::new() }], help: Vec::new() }
    }

    /// Says something about the first place.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        if let Some(first) = self.labels.first_mut() {
            first.text = text.into();
        }
        self
    }

    /// Adds another place.
    #[must_use]
    pub fn also(mut self, at: Spot, text: impl Into<String>) -> Self {
        self.labels.push(Label { at, text: text.into() });
        self
    }

    /// Adds a hint.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help.push(text.into());
        self
    }

    /// Adds a hint if there is one.
    #[must_use]
    pub fn maybe_help(self, text: Option<String>) -> Self {
        match text {
            Some(text) => self.help(text),
            None => self,
        }
    }
}

/// "did you mean" for a name that is not among the known ones.
#[must_use]
pub fn suggestion<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    known
        .into_iter()
        .map(|candidate| (strsim::damerau_levenshtein(&name.to_lowercase(), &candidate.to_lowercase()), candidate))
        .filter(|(distance, candidate)| *distance <= 1 + candidate.len().min(name.len()) / 3)
        .min()
        .map(|(_, candidate)| format!("did you mean `{candidate}`?"))
}
