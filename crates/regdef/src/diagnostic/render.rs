//! Rendering with rustc's own renderer.

use std::collections::BTreeMap;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};

use super::{Diagnostic, Severity};
use crate::source::Source;

impl Diagnostic {
    /// The finding as text: title and code, line, column, excerpt and hints.
    #[must_use]
    pub fn render(&self, source: &Source, renderer: &Renderer) -> String {
        let level = match self.code.severity() {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut group = Group::with_title(level.primary_title(self.title.as_str()).id(self.code.as_str()));
        let placed: Vec<_> =
            self.labels.iter().filter_map(|label| Some((source.range(&label.at)?, label.text.as_str()))).collect();
        if placed.is_empty() {
            group = group.element(Element::from(Origin::path(source.name())));
        } else {
            let (text, first_line, start) = excerpt(source.text(), &placed);
            let mut snippet = Snippet::source(text).path(source.name()).line_start(first_line);
            for (index, (range, label)) in placed.iter().enumerate() {
                let kind = if index == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
                let mut annotation = kind.span(range.start - start..range.end - start);
                if !label.is_empty() {
                    annotation = annotation.label(*label);
                }
                snippet = snippet.annotation(annotation);
            }
            group = group.element(snippet);
        }
        for help in &self.help {
            group = group.element(Level::HELP.message(help.as_str()));
        }
        renderer.render(&[group])
    }
}

/// The lines that hold all places, so that the renderer need not walk a large file: text, number of its first
/// line, and byte offset of its start.
fn excerpt<'a>(text: &'a str, placed: &[(Range<usize>, &str)]) -> (&'a str, usize, usize) {
    let low = placed.iter().map(|(r, _)| r.start).min().unwrap_or(0);
    let high = placed.iter().map(|(r, _)| r.end).max().unwrap_or(0);
    let start = text[..low].rfind('\n').map_or(0, |at| at + 1);
    let end = text[high..].find('\n').map_or(text.len(), |at| high + at);
    let first_line = text[..start].matches('\n').count() + 1;
    (&text[start..end], first_line, start)
}

/// All findings as text, errors first, each kind in the order of the file, with a closing count.
#[must_use]
pub fn report(findings: &[Diagnostic], source: &Source, renderer: &Renderer) -> String {
    let mut ordered: Vec<_> = findings.iter().collect();
    ordered.sort_by_key(|d| {
        let at = d.labels.first().and_then(|label| source.range(&label.at)).map_or(0, |range| range.start);
        (d.code.severity(), at, d.code)
    });
    let mut text = String::new();
    let mut counts = BTreeMap::<Severity, usize>::new();
    for finding in ordered {
        *counts.entry(finding.code.severity()).or_default() += 1;
        text += &finding.render(source, renderer);
        text += "\n\n";
    }
    let count = |severity, one: &str| match counts.get(&severity).copied().unwrap_or(0) {
        0 => None,
        1 => Some(format!("1 {one}")),
        n => Some(format!("{n} {one}s")),
    };
    let summary: Vec<_> =
        [count(Severity::Error, "error"), count(Severity::Warning, "warning")].into_iter().flatten().collect();
    if !summary.is_empty() {
        text += &format!("{}: {}\n", source.name(), summary.join(", "));
    }
    text
}
