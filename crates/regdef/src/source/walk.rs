//! One pass over the YAML events: positions of all nodes, and what serde would not see or not survive.

use std::collections::HashMap;
use std::ops::Range;

use saphyr_parser::{Event, Parser, ScalarStyle, Span as EventSpan};
use serde_json::{Map, Number, Value};

use super::{MAX_DEPTH, Span};
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::path::Path;

/// A mapping or list that is still open.
struct Open {
    path: Path,
    start: usize,
    content: Content,
}

enum Content {
    List(Vec<Value>),
    Mapping { entries: Map<String, Value>, keys: HashMap<String, Range<usize>>, pending: Option<(String, Range<usize>)> },
}

struct Walk<'a> {
    text: &'a str,
    lines: Vec<usize>,
    spans: &'a mut HashMap<Path, Span>,
    findings: &'a mut Vec<Diagnostic>,
    open: Vec<Open>,
    root: Option<Value>,
    documents: usize,
}

pub(super) fn walk(text: &str, spans: &mut HashMap<Path, Span>, findings: &mut Vec<Diagnostic>) -> Option<Value> {
    let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
    let mut walk = Walk { text, lines, spans, findings, open: Vec::new(), root: None, documents: 0 };
    let mut parser = Parser::new_from_str(text);
    while let Some(event) = parser.next_event() {
        match event {
            Ok((event, span)) => {
                if !walk.event(event, span) {
                    return None;
                }
            }
            Err(error) => {
                walk.syntax_error(*error.marker(), error.info());
                return None;
            }
        }
    }
    match walk.root.take() {
        None | Some(Value::Null) => {
            walk.findings.push(
                Diagnostic::new(Code::Empty, Spot::File, "the file holds no description")
                    .help("start with `controller: NAME`; the language's reference page has a worked example"),
            );
            None
        }
        root => root,
    }
}

impl Walk<'_> {
    /// Byte offset of a marker, which counts lines from 1 and columns in characters from 0.
    fn offset(&self, marker: saphyr_parser::Marker) -> usize {
        let start = self.lines.get(marker.line().saturating_sub(1)).copied().unwrap_or(self.text.len());
        let line = &self.text[start..];
        start + line.char_indices().nth(marker.col()).map_or(line.len(), |(at, _)| at)
    }

    fn range(&self, span: EventSpan) -> Range<usize> {
        let start = self.offset(span.start);
        start..self.offset(span.end).max(start)
    }

    fn syntax_error(&mut self, marker: saphyr_parser::Marker, info: &str) {
        let at = self.offset(marker);
        let line_start = self.text[..at].rfind('\n').map_or(0, |at| at + 1);
        let indent_end = self.text[line_start..].find(|c| c != ' ' && c != '\t').map_or(self.text.len(), |n| line_start + n);
        if let Some(tab) = self.text[line_start..indent_end].find('\t') {
            let tab = line_start + tab;
            self.findings.push(
                Diagnostic::new(Code::Tab, Spot::Bytes(tab..tab + 1), "a tab indents this line")
                    .label("tab")
                    .help("YAML indents with spaces only; replace the tab by spaces"),
            );
            return;
        }
        self.findings.push(
            Diagnostic::new(Code::Syntax, Spot::Bytes(at..at), format!("this is not YAML: {info}"))
                .help("text that holds `: `, ` #` or starts with one of `[]{}&*!|>%@` has to be quoted"),
        );
    }

    /// Takes one event; `false` stops the walk.
    fn event(&mut self, event: Event<'_>, span: EventSpan) -> bool {
        let range = self.range(span);
        match event {
            Event::DocumentStart(_) => {
                self.documents += 1;
                if self.documents > 1 {
                    self.findings.push(
                        Diagnostic::new(Code::SeveralDocuments, Spot::Bytes(range), "a second YAML document starts here")
                            .help("put each controller into a file of its own"),
                    );
                    return false;
                }
                true
            }
            Event::Alias(_) => self.refuse_anchor(range),
            Event::Scalar(_, _, anchor, _) | Event::SequenceStart(anchor, _) | Event::MappingStart(anchor, _)
                if anchor > 0 =>
            {
                self.refuse_anchor(range)
            }
            Event::Scalar(_, _, _, Some(_)) | Event::SequenceStart(_, Some(_)) | Event::MappingStart(_, Some(_)) => {
                self.findings.push(
                    Diagnostic::new(Code::Tag, Spot::Bytes(range), "tags are not part of this language")
                        .help("leave the tag out; quote a value that has to be text"),
                );
                false
            }
            Event::Scalar(value, style, _, _) => self.scalar(&value, style, range),
            Event::SequenceStart(..) => self.start(range.start, Content::List(Vec::new())),
            Event::MappingStart(..) => {
                self.start(range.start, Content::Mapping { entries: Map::new(), keys: HashMap::new(), pending: None })
            }
            Event::SequenceEnd | Event::MappingEnd => self.end(range.end),
            Event::Nothing | Event::StreamStart | Event::StreamEnd | Event::DocumentEnd => true,
        }
    }

    fn refuse_anchor(&mut self, range: Range<usize>) -> bool {
        self.findings.push(
            Diagnostic::new(Code::Alias, Spot::Bytes(range), "anchors and aliases are not part of this language")
                .help("say it once with `like`, a shared entry of `enums` or `conditions`, an array or lanes"),
        );
        false
    }

    /// Path of the node that starts now, with the position of its key.
    fn here(&self) -> (Path, Option<Range<usize>>) {
        match self.open.last() {
            None => (Path::root(), None),
            Some(Open { path, content: Content::List(items), .. }) => (path.index(items.len()), None),
            Some(Open { path, content: Content::Mapping { pending, .. }, .. }) => match pending {
                Some((key, range)) => (path.key(key), Some(range.clone())),
                None => (path.clone(), None),
            },
        }
    }

    fn start(&mut self, start: usize, content: Content) -> bool {
        if self.open.len() >= MAX_DEPTH {
            self.findings.push(
                Diagnostic::new(Code::TooDeep, Spot::Bytes(start..start + 1), format!("nesting is deeper than {MAX_DEPTH}"))
                    .help("no construct of the language is nested this deep; look for unbalanced brackets"),
            );
            return false;
        }
        if let Some(Open { content: Content::Mapping { pending: None, .. }, .. }) = self.open.last() {
            self.findings.push(
                Diagnostic::new(Code::WrongType, Spot::Bytes(start..start + 1), "a mapping or list cannot be a key")
                    .help("keys are plain names or numbers"),
            );
            return false;
        }
        let (path, key) = self.here();
        self.spans.insert(path.clone(), Span { key, value: start..start });
        self.open.push(Open { path, start, content });
        true
    }

    fn end(&mut self, end: usize) -> bool {
        let Some(open) = self.open.pop() else { return true };
        let end = self.text[..end].trim_end().len().max(open.start);
        if let Some(span) = self.spans.get_mut(&open.path) {
            span.value = open.start..end;
        }
        self.put(match open.content {
            Content::List(items) => Value::Array(items),
            Content::Mapping { entries, .. } => Value::Object(entries),
        });
        true
    }

    fn scalar(&mut self, text: &str, style: ScalarStyle, range: Range<usize>) -> bool {
        if let Some(Open { content: Content::Mapping { keys, pending: pending @ None, .. }, .. }) = self.open.last_mut() {
            let key = match typed(text, style) {
                Value::Number(number) => number.to_string(),
                _ => text.to_owned(),
            };
            if let Some(first) = keys.get(&key) {
                self.findings.push(
                    Diagnostic::new(Code::DuplicateKey, Spot::Bytes(range), format!("the key `{text}` stands twice"))
                        .label("again here")
                        .also(Spot::Bytes(first.clone()), "first here")
                        .help("remove or rename one of the two"),
                );
                return false;
            }
            keys.insert(key.clone(), range.clone());
            *pending = Some((key, range));
            return true;
        }
        let (path, key) = self.here();
        self.spans.insert(path, Span { key, value: range });
        self.put(typed(text, style));
        true
    }

    fn put(&mut self, value: Value) {
        match self.open.last_mut() {
            None => self.root = Some(value),
            Some(Open { content: Content::List(items), .. }) => items.push(value),
            Some(Open { content: Content::Mapping { entries, pending, .. }, .. }) => {
                if let Some((key, _)) = pending.take() {
                    entries.insert(key, value);
                }
            }
        }
    }
}

/// A scalar with the type YAML gives it.
fn typed(text: &str, style: ScalarStyle) -> Value {
    if style != ScalarStyle::Plain {
        return Value::String(text.to_owned());
    }
    match text {
        "" | "~" | "null" | "Null" | "NULL" => return Value::Null,
        "true" | "True" | "TRUE" => return Value::Bool(true),
        "false" | "False" | "FALSE" => return Value::Bool(false),
        _ => {}
    }
    let unsigned = match text.get(..2) {
        Some("0x") => u64::from_str_radix(&text[2..], 16).ok(),
        Some("0o") => u64::from_str_radix(&text[2..], 8).ok(),
        Some("0b") => u64::from_str_radix(&text[2..], 2).ok(),
        _ => text.parse().ok().filter(|_| !text.starts_with('+') && (text == "0" || !text.starts_with('0'))),
    };
    if let Some(number) = unsigned {
        return Value::Number(number.into());
    }
    if let Ok(number) = text.parse::<i64>() {
        return Value::Number(number.into());
    }
    let looks_float = text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) && text.contains(['.', 'e', 'E']);
    if looks_float && let Some(number) = text.parse().ok().and_then(Number::from_f64) {
        return Value::Number(number);
    }
    Value::String(text.to_owned())
}
