//! Rendering with rustc's own renderer.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

use annotate_snippets::{Annotation, AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};

use super::{Diagnostic, Severity};
use crate::source::Source;

/// Longest line in bytes that is shown with its text.
const LONGEST_LINE: usize = 2000;

/// Places further apart than this many lines are shown apart.
const NEAR: usize = 500;

/// Longest text of a title, label or hint in bytes.
const LONGEST_TEXT: usize = 2000;

/// A place of the text, cut to its first line.
struct Place<'a> {
    range: Range<usize>,
    line: usize,
    primary: bool,
    text: Cow<'a, str>,
}

impl Diagnostic {
    /// The finding as text: title and code, line, column, excerpt and hints.
    #[must_use]
    pub fn render(&self, source: &Source, renderer: &Renderer) -> String {
        let level = match self.code.severity() {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut group = Group::with_title(level.primary_title(clip(&self.title)).id(self.code.as_str()));
        let places = self.places(source);
        if places.is_empty() {
            group = group.element(Element::from(Origin::path(source.name())));
        }
        let long = places.iter().any(|place| source.line(place.line).len() > LONGEST_LINE);
        for near in apart(&places) {
            group = if long { without_text(group, near, source) } else { group.element(with_text(near, source)) };
        }
        for help in &self.help {
            group = group.element(Level::HELP.message(clip(help)));
        }
        renderer.render(&[group])
    }

    fn places(&self, source: &Source) -> Vec<Place<'_>> {
        let mut places = Vec::new();
        for (index, label) in self.labels.iter().enumerate() {
            let Some(range) = source.range(&label.at) else { continue };
            let line = source.line_of(range.start);
            let range = range.start..range.end.min(source.line(line).end).max(range.start);
            places.push(Place { range, line, primary: index == 0, text: clip(&label.text) });
        }
        places
    }
}

/// The places in groups of those that are near each other, the group of the first place in front.
fn apart<'p, 'a>(places: &'p [Place<'a>]) -> Vec<Vec<&'p Place<'a>>> {
    let mut sorted: Vec<_> = places.iter().collect();
    sorted.sort_by_key(|place| place.range.start);
    let mut groups: Vec<Vec<&Place<'_>>> = Vec::new();
    for place in sorted {
        match groups.last_mut() {
            Some(group) if group.last().is_some_and(|last| place.line - last.line <= NEAR) => group.push(place),
            _ => groups.push(vec![place]),
        }
    }
    groups.sort_by_key(|group| !group.iter().any(|place| place.primary));
    groups
}

fn with_text<'a>(places: Vec<&Place<'a>>, source: &'a Source) -> Snippet<'a, Annotation<'a>> {
    let first = places.iter().map(|place| place.line).min().unwrap_or(0);
    let last = places.iter().map(|place| place.line).max().unwrap_or(0);
    let start = source.line(first).start;
    let text = &source.text()[start..source.line(last).end];
    let snippet = Snippet::source(text).path(source.name()).line_start(first + 1);
    places.into_iter().fold(snippet, |snippet, place| {
        let kind = if place.primary { AnnotationKind::Primary } else { AnnotationKind::Context };
        let annotation = kind.span(place.range.start - start..place.range.end - start);
        let label = (!place.text.is_empty()).then(|| place.text.clone());
        snippet.annotation(annotation.label(label))
    })
}

/// Line and column alone, where an excerpt would be longer than anyone reads.
fn without_text<'a>(group: Group<'a>, places: Vec<&Place<'a>>, source: &'a Source) -> Group<'a> {
    places.into_iter().fold(group, |group, place| {
        let before = &source.text()[source.line(place.line).start..place.range.start];
        let origin = Origin::path(source.name()).line(place.line + 1).char_column(before.chars().count() + 1);
        let group = group.element(Element::from(origin));
        if place.text.is_empty() { group } else { group.element(Level::NOTE.message(place.text.clone())) }
    })
}

/// A text of bearable length.
fn clip(text: &str) -> Cow<'_, str> {
    if text.len() <= LONGEST_TEXT {
        return Cow::Borrowed(text);
    }
    let half = LONGEST_TEXT / 2;
    let (start, end) = (text.floor_char_boundary(half), text.ceil_char_boundary(text.len() - half));
    Cow::Owned(format!("{} … {}", &text[..start], &text[end..]))
}

/// All findings as text, errors first, each kind in the order of the file, with a closing count.
#[must_use]
pub fn report(findings: &[Diagnostic], source: &Source, renderer: &Renderer) -> String {
    let mut ordered: Vec<_> = findings
        .iter()
        .map(|finding| {
            let at = finding.labels.first().and_then(|label| source.range(&label.at)).map_or(0, |range| range.start);
            (finding.code.severity(), at, finding.code, finding)
        })
        .collect();
    ordered.sort_by_key(|(severity, at, code, _)| (*severity, *at, *code));
    let mut text = String::new();
    let mut counts = BTreeMap::<Severity, usize>::new();
    for (severity, .., finding) in ordered {
        *counts.entry(severity).or_default() += 1;
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
