//! One pass over the YAML events: positions of all nodes, and what serde would not see or not survive.

use std::collections::HashMap;
use std::ops::Range;

use saphyr_parser::{Event, Parser, ScalarStyle, Span as EventSpan};
use serde_json::{Map, Number, Value};

use super::{MAX_DEPTH, MAX_KEY, MAX_NODES, Nodes, Span, too_large};
use crate::diagnostic::{Code, Diagnostic, Findings, Spot};

/// A mapping or list that is still open.
struct Open {
    node: usize,
    start: usize,
    content: Content,
}

enum Content {
    List(Vec<Value>),
    Mapping {
        entries: Map<String, Value>,
        keys: HashMap<String, Range<usize>>,
        pending: Option<(String, Range<usize>)>,
    },
}

struct Walk<'a> {
    text: &'a str,
    /// Byte offset of every line, as YAML counts lines.
    lines: Vec<usize>,
    /// The last offset that was looked up: line, column and byte. Events come in the order of the text, so that
    /// the next one is found from here, however long the line is.
    last: (usize, usize, usize),
    nodes: &'a mut Nodes,
    findings: &'a mut Findings,
    open: Vec<Open>,
    root: Option<Value>,
    documents: usize,
    /// Something was left out of the tree, so that its shape says nothing.
    broken: bool,
}

pub(super) fn walk(text: &str, nodes: &mut Nodes, findings: &mut Findings) -> Option<Value> {
    let bytes = text.as_bytes();
    let ends = |at: usize| bytes[at] == b'\n' || (bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n'));
    let lines = std::iter::once(0).chain((0..bytes.len()).filter(|at| ends(*at)).map(|at| at + 1)).collect();
    let mut walk = Walk {
        text,
        lines,
        last: (0, 0, 0),
        nodes,
        findings,
        open: Vec::new(),
        root: None,
        documents: 0,
        broken: false,
    };
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
    if walk.broken {
        return None;
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
    fn offset(&mut self, marker: saphyr_parser::Marker) -> usize {
        let line = marker.line().saturating_sub(1);
        let Some(start) = self.lines.get(line).copied() else { return self.text.len() };
        let (column, from) = match self.last {
            (last, column, at) if last == line && column <= marker.col() => (column, at),
            _ => (0, start),
        };
        let end = self.lines.get(line + 1).copied().unwrap_or(self.text.len());
        let rest = &self.text[from..end];
        let at = from + rest.char_indices().nth(marker.col() - column).map_or(rest.len(), |(at, _)| at);
        self.last = (line, marker.col(), at);
        at
    }

    fn range(&mut self, span: EventSpan) -> Range<usize> {
        let start = self.offset(span.start);
        start..self.offset(span.end).max(start)
    }

    fn syntax_error(&mut self, marker: saphyr_parser::Marker, info: &str) {
        let at = self.offset(marker);
        if info == "recursion limit exceeded" {
            self.too_deep(at);
            return;
        }
        let line_start = self.text[..at].rfind(['\n', '\r']).map_or(0, |at| at + 1);
        let indent_end =
            self.text[line_start..].find(|c| c != ' ' && c != '\t').map_or(self.text.len(), |n| line_start + n);
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
                .label("noticed here; the cause may stand before it")
                .help("a mapping is written `key: value`, its entries indented alike")
                .help("text that holds `: ` or ` #`, or starts with one of `[]{}&*!|>%@`, has to be quoted"),
        );
    }

    /// Takes one event; `false` stops the walk.
    fn event(&mut self, event: Event<'_>, span: EventSpan) -> bool {
        let range = self.range(span);
        if let Event::Scalar(_, _, anchor, tag) | Event::SequenceStart(anchor, tag) | Event::MappingStart(anchor, tag) =
            &event
        {
            if *anchor > 0 {
                self.refuse_anchor(range.clone());
            }
            if tag.is_some() {
                self.broken = true;
                self.findings.push(
                    Diagnostic::new(Code::Tag, Spot::Bytes(range.clone()), "tags are not part of the language")
                        .label("the value behind the tag")
                        .help("leave the tag (`!...`) out; quote a value that has to be text"),
                );
            }
        }
        match event {
            Event::DocumentStart(_) => {
                self.documents += 1;
                if self.documents > 1 {
                    self.findings.push(
                        Diagnostic::new(
                            Code::SeveralDocuments,
                            Spot::Bytes(range),
                            "a second YAML document starts here",
                        )
                        .help("put each controller into a file of its own"),
                    );
                    return false;
                }
                true
            }
            Event::Alias(_) => {
                self.refuse_anchor(range.clone());
                self.scalar("", ScalarStyle::Plain, range)
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

    fn refuse_anchor(&mut self, range: Range<usize>) {
        self.broken = true;
        let what = if self.text[range.start..].starts_with('*') { "an alias" } else { "a value with an anchor" };
        self.findings.push(
            Diagnostic::new(Code::Alias, Spot::Bytes(range), "anchors and aliases are not part of the language")
                .label(what)
                .help("say it once with `like`, a shared entry of `enums` or `conditions`, an array or lanes"),
        );
    }

    /// The node that holds the one that starts now and the key it has there, and the position of the key.
    fn here(&self) -> (Option<(usize, String)>, Option<Range<usize>>) {
        match self.open.last() {
            None => (None, None),
            Some(Open { node, content: Content::List(items), .. }) => (Some((*node, items.len().to_string())), None),
            Some(Open { node, content: Content::Mapping { pending, .. }, .. }) => match pending {
                Some((key, range)) => (Some((*node, key.clone())), Some(range.clone())),
                None => (Some((*node, String::new())), None),
            },
        }
    }

    /// Files the position of a node; `None` if there are too many.
    fn add(&mut self, value: Range<usize>) -> Option<usize> {
        if self.nodes.spans.len() >= MAX_NODES {
            self.findings.push(too_large(&format!("holds more than {MAX_NODES} keys and values")));
            return None;
        }
        let (place, key) = self.here();
        Some(self.nodes.add(place, Span { key, value }))
    }

    fn too_deep(&mut self, at: usize) {
        let bracket = Spot::Bytes(at..at + usize::from(at < self.text.len()));
        self.findings.push(
            Diagnostic::new(Code::TooDeep, bracket, format!("nesting is deeper than {MAX_DEPTH}"))
                .label("too many levels")
                .help("no construct of the language is nested this deep; look for unbalanced brackets"),
        );
    }

    fn start(&mut self, start: usize, content: Content) -> bool {
        if self.open.len() >= MAX_DEPTH {
            self.too_deep(start);
            return false;
        }
        let bracket = Spot::Bytes(start..start + usize::from(start < self.text.len()));
        if let Some(Open { content: Content::Mapping { pending: None, .. }, .. }) = self.open.last() {
            self.findings.push(
                Diagnostic::new(Code::WrongType, bracket, "a mapping or list cannot be a key")
                    .help("keys are plain names or numbers; text in braces or brackets has to be quoted"),
            );
            return false;
        }
        let Some(node) = self.add(start..start) else { return false };
        self.open.push(Open { node, start, content });
        true
    }

    fn end(&mut self, end: usize) -> bool {
        let Some(open) = self.open.pop() else { return true };
        let end = self.text[..end].trim_end().len().max(open.start);
        self.nodes.spans[open.node].value = open.start..end;
        self.put(match open.content {
            Content::List(items) => Value::Array(items),
            Content::Mapping { entries, .. } => Value::Object(entries),
        });
        true
    }

    fn scalar(&mut self, text: &str, style: ScalarStyle, range: Range<usize>) -> bool {
        let value = match typed(text, style) {
            Ok(value) => value,
            Err(odd) => {
                self.odd(odd, text, range.clone());
                Value::String(text.to_owned())
            }
        };
        if let Some(Open { content: Content::Mapping { keys, pending: pending @ None, .. }, .. }) = self.open.last_mut()
        {
            if text.len() > MAX_KEY {
                self.findings.push(
                    Diagnostic::new(Code::TooLarge, Spot::Bytes(range), format!("a key of {} bytes", text.len()))
                        .label(format!("a key may have {MAX_KEY} bytes"))
                        .help("long text belongs behind a key such as `doc`"),
                );
                return false;
            }
            let key = match value {
                Value::Number(number) => number.to_string(),
                Value::Null | Value::Bool(_) => {
                    self.broken = true;
                    let what =
                        if text.is_empty() { "a key is missing".to_owned() } else { format!("`{text}` is no key") };
                    let finding = Diagnostic::new(Code::WrongType, Spot::Bytes(range.clone()), what);
                    self.findings.push(
                        finding.help("keys are names or numbers; quote a name that YAML takes for something else"),
                    );
                    text.to_owned()
                }
                _ => text.to_owned(),
            };
            if let Some(first) = keys.get(&key) {
                self.broken = true;
                self.findings.push(
                    Diagnostic::new(
                        Code::DuplicateKey,
                        Spot::Bytes(range.clone()),
                        format!("the key `{text}` stands twice"),
                    )
                    .label("again here")
                    .also(Spot::Bytes(first.clone()), "first here")
                    .help("remove or rename one of the two"),
                );
            } else {
                keys.insert(key.clone(), range.clone());
            }
            *pending = Some((key, range));
            return true;
        }
        if self.add(range).is_none() {
            return false;
        }
        self.put(value);
        true
    }

    fn odd(&mut self, odd: Odd, text: &str, range: Range<usize>) {
        self.findings.push(match odd {
            Odd::Fraction => Diagnostic::new(
                Code::WrongType,
                Spot::Bytes(range),
                format!("YAML takes `{text}` for a number with a fraction"),
            )
            .label(format!("write \"{text}\""))
            .help("the language has no fractions; a section or a revision is text and has to be quoted"),
            Odd::TooLarge => {
                Diagnostic::new(Code::OutOfRange, Spot::Bytes(range), format!("`{text}` has more than 64 bits"))
                    .label("has to be at most 0xffff_ffff_ffff_ffff")
                    .help("quote it if it is no number but text")
            }
        });
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

/// A plain number that the language has no use for.
enum Odd {
    Fraction,
    TooLarge,
}

/// A scalar with the type YAML gives it; serde_yaml's own reading decides what is a number.
fn typed(text: &str, style: ScalarStyle) -> Result<Value, Odd> {
    if style != ScalarStyle::Plain {
        return Ok(Value::String(text.to_owned()));
    }
    match text {
        "" | "~" | "null" | "Null" | "NULL" => return Ok(Value::Null),
        "true" | "True" | "TRUE" => return Ok(Value::Bool(true)),
        "false" | "False" | "FALSE" => return Ok(Value::Bool(false)),
        _ => {}
    }
    if let Ok(number) = text.parse::<serde_yaml::Number>() {
        let integer = number.as_u64().map(Number::from).or_else(|| number.as_i64().map(Number::from));
        return integer.map(Value::Number).ok_or(Odd::Fraction);
    }
    if wide(text) { Err(Odd::TooLarge) } else { Ok(Value::String(text.to_owned())) }
}

/// An integer of more than 64 bits, which serde_yaml reads as one of 128.
fn wide(text: &str) -> bool {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (digits, radix) = match digits.get(..2) {
        Some("0x") => (&digits[2..], 16),
        Some("0o") => (&digits[2..], 8),
        Some("0b") => (&digits[2..], 2),
        _ if digits.starts_with('0') => return false,
        _ => (digits, 10),
    };
    !digits.starts_with(['+', '-']) && u128::from_str_radix(digits, radix).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scalars_are_read_as_serde_yaml_reads_them() {
        for text in [
            "",
            "~",
            "null",
            "Null",
            "nULL",
            "true",
            "True",
            "yes",
            "on",
            "0",
            "00",
            "007",
            "08",
            "1",
            "-1",
            "+1",
            "--1",
            "1_000",
            "0x10",
            "0X10",
            "0x+5",
            "0x",
            "-0x10",
            "0o17",
            "0b11",
            "0b2",
            "0x_1",
            "18446744073709551615",
            "-9223372036854775808",
            "x",
            "0..3",
            "1:2",
            "2.3.7",
            "+",
            ".",
            "..",
            "1e",
            "e1",
            "0xg",
            "1 2",
        ] {
            let Ok(value) = typed(text, ScalarStyle::Plain) else { panic!("{text} is odd") };
            let reference: serde_yaml::Value = serde_yaml::from_str(text).expect(text);
            assert_eq!(serde_json::to_value(reference).expect(text), value, "{text}");
        }
        for text in ["1.0", "2.10", "1e5", "-.inf", ".nan", ".5", "1.", "1e999999"] {
            let odd = typed(text, ScalarStyle::Plain);
            let reference: serde_yaml::Value = serde_yaml::from_str(text).expect(text);
            assert_eq!(matches!(odd, Err(Odd::Fraction)), reference.is_f64(), "{text}");
        }
        for text in ["18446744073709551616", "-9223372036854775809", "0x10000000000000000", "+99999999999999999999"] {
            assert!(matches!(typed(text, ScalarStyle::Plain), Err(Odd::TooLarge)), "{text}");
            assert!(serde_yaml::from_str::<serde_yaml::Value>(text).is_err(), "{text}");
        }
    }
}
