//! Field tables: one row per field, as CSV and as JSON.
//!
//! Both carry the same rows; JSON has numbers where CSV has text, and the controller in front.

mod rows;

use std::fmt::Write as _;

use regdef::model::{Model, ResetKind};
use serde_json::{Value, json};

pub use rows::{Repeat, Row, RowReset, RowValue, rows};

/// The columns in their order.
pub const COLUMNS: [&str; 11] =
    ["register", "array", "offset", "width", "field", "msb", "lsb", "access", "reset", "values", "source"];

/// The table as CSV with a header line.
#[must_use]
pub fn csv(model: &Model) -> String {
    let mut writer = csv::WriterBuilder::new().terminator(csv::Terminator::Any(b'\n')).from_writer(Vec::new());
    let lines = rows(model).into_iter().map(|row| cells(&row));
    for line in std::iter::once(COLUMNS.map(str::to_owned)).chain(lines) {
        writer.write_record(&line).expect("writing to memory does not fail, and all rows are equally long");
    }
    let bytes = writer.into_inner().expect("flushing to memory does not fail");
    String::from_utf8(bytes).expect("every cell was a string")
}

/// The table as JSON, with the controller's identity in front of the rows.
#[must_use]
pub fn json(model: &Model) -> String {
    let manual = &model.manual;
    let table = json!({
        "controller": model.names.id,
        "title": model.title,
        "manual": {
            "title": manual.title,
            "publisher": manual.publisher,
            "document": manual.document,
            "revision": manual.revision,
            "date": manual.date,
        },
        "prefix": model.prefix,
        "access_widths": model.access_widths,
        "span": model.span,
        "sources": model.sources.iter().map(|(key, source)| {
            json!({"key": key, "title": source.title, "locator": source.locator})
        }).collect::<Vec<_>>(),
        "fields": rows(model).iter().map(object).collect::<Vec<_>>(),
    });
    let mut text = serde_json::to_string_pretty(&table).expect("a tree of strings and numbers has a JSON form");
    text.push('\n');
    text
}

fn cells(row: &Row) -> [String; 11] {
    let array = |repeat: &Repeat| format!("{};{};{}", repeat.count, repeat.stride, repeat.first);
    [
        row.register.clone(),
        row.array.as_ref().map_or_else(String::new, array),
        row.offset.map_or_else(String::new, |offset| format!("{offset:#05x}")),
        row.width.to_string(),
        row.field.clone(),
        row.msb.to_string(),
        row.lsb.to_string(),
        row.access.clone(),
        reset_text(row.reset),
        values_text(&row.values),
        row.source.clone(),
    ]
}

fn reset_text(reset: RowReset) -> String {
    match reset {
        RowReset::Value(value) => format!("{value:#x}"),
        RowReset::None(kind) => kind_text(kind).to_owned(),
    }
}

const fn kind_text(kind: ResetKind) -> &'static str {
    match kind {
        ResetKind::Unknown => "x",
        ResetKind::Product => "product",
        ResetKind::Pin => "pin",
    }
}

fn values_text(values: &[RowValue]) -> String {
    let mut text = String::new();
    for value in values {
        let separator = if text.is_empty() { "" } else { ";" };
        let written = match value.first == value.last {
            true => write!(text, "{separator}{}={}", value.first, value.name),
            false => write!(text, "{separator}{}..{}={}", value.first, value.last, value.name),
        };
        written.expect("a string takes any text");
    }
    text
}

fn object(row: &Row) -> Value {
    json!({
        "register": row.register,
        "array": row.array.as_ref().map(|r| json!({"count": r.count, "stride": r.stride, "first": r.first})),
        "offset": row.offset,
        "width": row.width,
        "field": row.field,
        "msb": row.msb,
        "lsb": row.lsb,
        "access": row.access,
        "reset": match row.reset {
            RowReset::Value(value) => json!(value),
            RowReset::None(kind) => json!(kind_text(kind)),
        },
        "values": row.values.iter().map(|v| json!({"first": v.first, "last": v.last, "name": v.name})).collect::<Vec<_>>(),
        "source": row.source,
    })
}
