//! Doc comments.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{Cite, Encoding, EnumId, Field, Kind, Model, Register, Target};

use crate::text;

/// Paragraphs as doc attributes. Empty paragraphs are left out.
pub(super) fn doc(paragraphs: &[String]) -> TokenStream {
    let text = paragraphs.iter().filter(|p| !p.is_empty()).map(String::as_str).collect::<Vec<_>>().join("\n\n");
    lines(&text)
}

/// Text as inner doc attributes of a file.
pub(super) fn inner(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote!(#(#![doc = #lines])*)
}

fn lines(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote!(#(#[doc = #lines])*)
}

/// Text of a description as Markdown: brackets and the like would otherwise be links and markup.
pub(super) fn md(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for (index, piece) in text::one_line(text).split('`').enumerate() {
        if index > 0 {
            out.push('`');
        }
        if index % 2 == 1 {
            out += piece;
            continue;
        }
        for letter in piece.chars() {
            if matches!(letter, '[' | ']' | '<' | '>' | '*' | '|' | '\\' | '_') {
                out.push('\\');
            }
            out.push(letter);
        }
    }
    if out.matches('`').count() % 2 == 1 {
        out = out.replace('`', "\\`");
    }
    out
}

/// The same, ending like a sentence.
pub(super) fn sentence(text: &str) -> String {
    md(&text::sentence(text))
}

/// Citations as a closing line.
pub(super) fn source(model: &Model, cites: &[Cite]) -> String {
    if cites.is_empty() {
        return String::new();
    }
    let title = &model.manual.title;
    let external = cites.iter().all(|c| c.source.is_some());
    let text = md(&text::cites(cites));
    if external { format!("Source outside the manual: {text}") } else { format!("*{}*, {text}", md(title)) }
}

/// `31:25` or `5`.
pub(super) fn bits(field: &Field, lane: u32) -> String {
    let lsb = field.lane_lsb(lane);
    if field.width == 1 { lsb.to_string() } else { format!("{}:{lsb}", lsb + field.width - 1) }
}

/// One line that introduces a field: bits and access.
pub(super) fn headline(model: &Model, field: &Field) -> String {
    let place = match field.lanes {
        None if field.width == 1 => format!("bit {}", bits(field, 0)),
        None => format!("bits {}", bits(field, 0)),
        Some(lanes) => format!("{} lanes, the first at bits {}", lanes.count, bits(field, 0)),
    };
    format!("`{}` ({place}, `{}`): {}", field.label, text::notation(model, field), sentence(&field.doc))
}

/// What else there is to say about a field, as paragraphs.
pub(super) fn details(model: &Model, field: &Field) -> Vec<String> {
    let notes = text::access_notes(model, field);
    // The first note repeats the access code that the headline has.
    let mut paragraphs = vec![notes.iter().skip(1).map(|n| md(n)).collect::<Vec<_>>().join(" ")];
    paragraphs
        .push(conflicts(model, |target| matches!(target, Target::Field(at) if std::ptr::eq(model.field(*at), field))));
    paragraphs
}

/// The contradictions of the manual about something, each with its resolution.
pub(super) fn conflicts(model: &Model, about: impl Fn(&Target) -> bool) -> String {
    let concerned = model.conflicts.iter().filter(|c| c.at.iter().any(&about));
    concerned
        .map(|c| {
            format!(
                "The manual contradicts itself (`{}`): {} Taken: {} Because: {}",
                c.id,
                sentence(&c.what),
                sentence(&c.taken),
                sentence(&c.because)
            )
        })
        .collect::<Vec<_>>()
        .join("\n\n")
}

/// Meaning of the number in a field, for setters and getters: range and unit.
pub(super) fn encoding(encoding: &Encoding) -> Option<String> {
    encoding.unit.as_ref().map(|unit| format!("in {unit}"))
}

/// Type of a field's value in words and links, for the field table.
fn value_type(model: &Model, field: &Field) -> String {
    match field.kind {
        Kind::Bool => "bool".to_owned(),
        Kind::Int => match field.encoding.as_ref().and_then(encoding) {
            Some(unit) => format!("{} bits, {unit}", field.width),
            None => format!("{} bits", field.width),
        },
        Kind::Enum(id) => format!("[`{0}`](crate::enums::{0})", enum_type(model, id)),
    }
}

pub(super) fn enum_type(model: &Model, id: EnumId) -> String {
    model.enumeration(id).ident.pascal.clone()
}

/// The register's fields as a table.
pub(super) fn field_table(model: &Model, register: &Register) -> String {
    let mut out = String::from("| bits | field | access | reset | value |\n|---|---|---|---|---|");
    for field in &register.fields {
        let bits = match field.lanes {
            None => bits(field, 0),
            Some(lanes) => format!("{} × {}", lanes.count, bits(field, 0)),
        };
        let reset = match field.reset_of_lane(register.reset, 0) {
            Some(value) => format!("{value:#x}"),
            None => "x".to_owned(),
        };
        out += &format!(
            "\n| {bits} | `{}` | `{}` | {reset} | {} |",
            field.label,
            text::notation(model, field).replace('|', "\\|"),
            value_type(model, field)
        );
    }
    out
}
