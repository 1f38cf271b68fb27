//! Diagnostics: what is wrong, where, and what to do about it.

mod code;
mod findings;
mod render;

pub use code::{Code, Severity};
pub(crate) use findings::Findings;
pub use findings::MAX_FINDINGS;
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
    // Names that differ much in length are not alike, and the comparison takes time with the product of the lengths.
    let allowed = |candidate: &str| 1 + candidate.len().min(name.len()) / 3;
    let close = |candidate: &&str| candidate.len().abs_diff(name.len()) <= allowed(candidate);
    let lower = name.to_lowercase();
    known
        .into_iter()
        .filter(|candidate| name.len() <= LONGEST_NAME && close(candidate))
        .take(MOST_NAMES)
        .map(|candidate| (strsim::damerau_levenshtein(&lower, &candidate.to_lowercase()), candidate))
        .filter(|(distance, candidate)| *distance <= allowed(candidate) && *distance < lower.chars().count())
        .min()
        .map(|(_, candidate)| format!("did you mean `{candidate}`?"))
}

/// Most names that one is compared with.
const MOST_NAMES: usize = 1000;

/// Longest name that is worth a suggestion.
const LONGEST_NAME: usize = 80;

#[cfg(test)]
mod tests {
    use super::suggestion;

    #[test]
    fn suggestions_are_near() {
        let known = ["title", "offset", "reset", "x"];
        assert_eq!(suggestion("titel", known).as_deref(), Some("did you mean `title`?"));
        assert_eq!(suggestion("OFFSET", known).as_deref(), Some("did you mean `offset`?"));
        assert_eq!(suggestion("frobnicate", known), None);
        assert_eq!(suggestion("q", known), None, "nothing of `q` is left in `x`");
        assert_eq!(suggestion("", known), None);
        assert_eq!(suggestion(&"title".repeat(1000), known), None);
    }
}
