//! What the schema allows at a place, in words.

use serde_json::Value;

use super::SCHEMA;

pub(super) const TEXT: &str = "text";
pub(super) const WHOLE: &str = "a whole number";

/// The forms that a value may take.
pub(super) fn of(schema: Option<&Value>) -> Vec<String> {
    let mut forms = Vec::new();
    if let Some(schema) = schema {
        collect(schema, &mut forms);
    }
    forms.dedup();
    if forms.is_empty() {
        forms.push("of another form".to_owned());
    }
    forms
}

fn collect(schema: &Value, forms: &mut Vec<String>) {
    let get = |key: &str| schema.get(key);
    let text = |key: &str| get(key).and_then(Value::as_str);
    if let Some(target) = text("$ref").and_then(|at| SCHEMA.pointer(at.strip_prefix('#')?)) {
        return collect(target, forms);
    }
    let branches = || ["anyOf", "oneOf"].into_iter().filter_map(get).filter_map(Value::as_array).flatten();
    // Scalars with several spellings say themselves what they are.
    if branches().any(|branch| branch.get("pattern").is_some()) {
        let text = text("description").unwrap_or_default().trim_end_matches('.');
        let mut letters = text.chars();
        forms.push(letters.next().map(|first| first.to_ascii_lowercase()).into_iter().chain(letters).collect());
        return;
    }
    let constants = constants(schema);
    if !constants.is_empty() {
        forms.push(constants.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "));
        return;
    }
    for branch in branches() {
        collect(branch, forms);
    }
    let types = match get("type") {
        Some(Value::String(one)) => vec![one.as_str()],
        Some(Value::Array(many)) => many.iter().filter_map(Value::as_str).collect(),
        _ => Vec::new(),
    };
    for kind in types {
        match kind {
            "string" => forms.push(TEXT.to_owned()),
            "integer" => forms.push(WHOLE.to_owned()),
            "boolean" => forms.push("`true` or `false`".to_owned()),
            "array" => forms.push("a list: `[...]`".to_owned()),
            "object" => forms.push(mapping(schema)),
            _ => {}
        }
    }
}

/// The names that a value is chosen from.
fn constants(schema: &Value) -> Vec<&str> {
    let listed = schema.get("enum").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str);
    let single = schema.get("const").and_then(Value::as_str);
    let branches = schema.get("oneOf").and_then(Value::as_array).into_iter().flatten();
    listed.chain(single).chain(branches.flat_map(constants)).collect()
}

fn mapping(schema: &Value) -> String {
    let required: Vec<_> =
        schema.get("required").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str).collect();
    let Some(keys) = schema.get("properties").and_then(Value::as_object) else { return "a mapping".to_owned() };
    let needed: Vec<_> =
        keys.keys().filter(|key| required.contains(&key.as_str())).map(|key| format!("{key}: ...")).collect();
    if needed.is_empty() {
        let known: Vec<_> = keys.keys().map(|key| format!("`{key}`")).collect();
        return format!("a mapping with keys among {}", known.join(", "));
    }
    format!("a mapping {{{}}}", needed.join(", "))
}
