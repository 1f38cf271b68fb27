//! The data of a decode box: what the script on a page has to know of a register or word.

use regdef::model::{Field, Model, Reset};
use serde_json::{Value, json};

/// The data as JSON that may stand inside a `script` element.
pub(super) fn data(
    model: &Model,
    name: &str,
    width: u32,
    fields: &[Field],
    reset: Option<Reset>,
    elements: &[String],
) -> String {
    let value = json!({
        "name": name,
        "width": width,
        "reset": reset.map(|r| r.value),
        "unknown": reset.map_or(0, |r| r.unknown),
        "elements": elements,
        "fields": fields.iter().map(|f| field(model, f)).collect::<Vec<_>>(),
    });
    // Keeps the text from ending the element or opening a comment in it.
    value.to_string().replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

fn field(model: &Model, field: &Field) -> Value {
    let numbered = field.lanes.is_some() && !field.label.contains("{n}");
    let mut data = json!({
        "name": if numbered { format!("{}{{n}}", field.label) } else { field.label.clone() },
        "lsb": field.lsb,
        "width": field.width,
        "code": field.access.code.as_str(),
    });
    if let Some(lanes) = field.lanes {
        data["lanes"] = json!([lanes.count, lanes.stride, lanes.first]);
    }
    if let Some(id) = field.enumeration() {
        let one = model.enumeration(id);
        data["values"] = one.variants.iter().map(|v| json!([v.first, v.last, v.name, v.doc])).collect();
        data["reserved"] = one.reserved.iter().map(|&(a, b)| json!([a, b])).collect();
    }
    if field.min != 0 || field.max != field.capacity() {
        data["range"] = json!([field.min, field.max]);
    }
    if let Some(encoding) = &field.encoding {
        data["encoding"] =
            json!([encoding.add, encoding.times.unwrap_or(1), encoding.signed, encoding.unit.as_deref().unwrap_or("")]);
    }
    if let Some(value) = field.access.must_write {
        data["must"] = json!(value);
    }
    data
}
