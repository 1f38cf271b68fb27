//! The list of findings while a file is loaded.

use std::ops::Range;

use super::{Code, Diagnostic, Label, Severity, Spot};

/// Most errors, and most warnings, that are kept: a file that is wrong everywhere is not worth a longer list, and
/// a hostile one must not fill the memory.
pub const MAX_FINDINGS: usize = 500;

/// The findings so far.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    kept: Vec<Diagnostic>,
    errors: usize,
    warnings: usize,
}

impl Findings {
    /// Adds a finding, unless it is there already, as for a field that `like` copies, or there are too many.
    pub(crate) fn push(&mut self, finding: Diagnostic) {
        let count = match finding.code.severity() {
            Severity::Error => &mut self.errors,
            Severity::Warning => &mut self.warnings,
        };
        if *count < MAX_FINDINGS && self.kept.contains(&finding) {
            return;
        }
        *count += 1;
        if *count <= MAX_FINDINGS {
            self.kept.push(finding);
        }
    }

    /// Changes the last finding, if it is about a place.
    pub(crate) fn amend(&mut self, at: &Spot, change: impl FnOnce(&mut Diagnostic)) {
        if let Some(last) = self.kept.last_mut()
            && last.labels.first().is_some_and(|label| label.at == *at)
        {
            change(last);
        }
    }

    /// Some finding is about exactly these bytes.
    pub(crate) fn has_at(&self, range: &Range<usize>) -> bool {
        self.kept
            .iter()
            .any(|finding| matches!(&finding.labels[..], [Label { at: Spot::Bytes(at), .. }, ..] if at == range))
    }

    /// Some finding is an error.
    pub(crate) fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// Further errors are not kept, so it is not worth looking for hints.
    pub(crate) fn full(&self) -> bool {
        self.errors >= MAX_FINDINGS
    }

    /// The list, with a note of what was left out.
    pub(crate) fn finish(mut self) -> Vec<Diagnostic> {
        let over = |count: usize| count.saturating_sub(MAX_FINDINGS);
        let left_out = [(over(self.errors), "errors"), (over(self.warnings), "warnings")];
        let text: Vec<_> =
            left_out.iter().filter(|(n, _)| *n > 0).map(|(n, what)| format!("{n} more {what}")).collect();
        if !text.is_empty() {
            self.kept.push(
                Diagnostic::new(Code::TooMany, Spot::File, format!("there are {}", text.join(" and ")))
                    .help(format!("the first {MAX_FINDINGS} of each kind are listed; correct those and run again")),
            );
        }
        self.kept
    }
}
