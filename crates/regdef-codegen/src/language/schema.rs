//! The types of the language as the JSON schema tells them.

use minijinja::{Value, context};
use serde_json::Value as Json;

/// A mapping, a choice of forms, or a set of words.
#[derive(Debug, Clone)]
pub(super) struct TypeDoc {
    pub name: String,
    pub doc: String,
    /// The keys of a mapping, required ones first.
    pub keys: Vec<Key>,
    /// The forms of a choice, with what they mean.
    pub forms: Vec<(Vec<Piece>, String)>,
    /// The words that may be written, with what they mean.
    pub words: Vec<(String, String)>,
}

/// A key of a mapping.
#[derive(Debug, Clone)]
pub(super) struct Key {
    pub name: String,
    pub doc: String,
    pub required: bool,
    pub kind: Vec<Piece>,
}

/// A piece of the name of a type: plain text, or a link to a type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Piece {
    Text(String),
    Type(String),
}

/// All types, the top level first, then as they are first mentioned.
pub(super) fn types() -> Vec<TypeDoc> {
    let schema = regdef::schema();
    let root = TypeDoc::new("Description", &schema, &schema["$defs"]);
    let mut all = vec![root];
    let mut next = 0;
    while next < all.len() {
        for name in all[next].mentions() {
            if all.iter().all(|t| t.name != name) {
                all.push(TypeDoc::new(&name, &schema["$defs"][&name], &schema["$defs"]));
            }
        }
        next += 1;
    }
    all
}

impl TypeDoc {
    fn new(name: &str, schema: &Json, definitions: &Json) -> Self {
        let required: Vec<_> = list(&schema["required"]).iter().filter_map(Json::as_str).collect();
        let mut keys: Vec<Key> = Vec::new();
        for (key, value) in schema["properties"].as_object().into_iter().flatten() {
            keys.push(Key {
                name: key.clone(),
                doc: doc(value),
                required: required.contains(&key.as_str()),
                kind: kind(value, definitions),
            });
        }
        let position = |key: &Key| required.iter().position(|r| *r == key.name).unwrap_or(usize::MAX);
        keys.sort_by_key(position);
        let words =
            list(&schema["oneOf"]).iter().filter_map(|w| Some((w["const"].as_str()?.to_owned(), doc(w)))).collect();
        let forms = list(&schema["anyOf"]).iter().map(|form| (kind(form, definitions), doc(form))).collect();
        Self { name: name.to_owned(), doc: doc(schema), keys, forms, words }
    }

    pub fn anchor(&self) -> String {
        anchor(&self.name)
    }

    fn mentions(&self) -> Vec<String> {
        let pieces = self.keys.iter().flat_map(|k| &k.kind).chain(self.forms.iter().flat_map(|(pieces, _)| pieces));
        let named = pieces.filter_map(|piece| match piece {
            Piece::Type(name) => Some(name.clone()),
            Piece::Text(_) => None,
        });
        named.collect()
    }

    /// The type as the templates see it.
    pub fn view(&self) -> Value {
        let pieces = |pieces: &[Piece]| -> Vec<Value> {
            let one = |piece: &Piece| match piece {
                Piece::Text(text) => context! { text, link => () },
                Piece::Type(name) => context! { text => spaced(name), link => anchor(name) },
            };
            pieces.iter().map(one).collect()
        };
        let keys = self.keys.iter().map(|k| {
            context! { name => k.name.clone(), doc => k.doc.clone(), required => k.required, kind => pieces(&k.kind) }
        });
        context! {
            name => spaced(&self.name),
            anchor => self.anchor(),
            doc => self.doc.clone(),
            keys => keys.collect::<Vec<_>>(),
            forms => self.forms.iter().map(|(kind, doc)| context! { kind => pieces(kind), doc }).collect::<Vec<_>>(),
            words => self.words.iter().map(|(word, doc)| context! { word, doc }).collect::<Vec<_>>(),
        }
    }
}

fn list(value: &Json) -> &[Json] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// Lines of one paragraph are joined; paragraphs stay apart.
fn doc(schema: &Json) -> String {
    let text = schema["description"].as_str().unwrap_or_default();
    text.split("\n\n").map(|p| p.replace('\n', " ")).collect::<Vec<_>>().join("\n\n")
}

fn anchor(name: &str) -> String {
    format!("type-{}", spaced(name).replace(' ', "-"))
}

/// `InterruptLine` as `interrupt line`.
fn spaced(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        if c.is_ascii_uppercase() && !out.is_empty() {
            out.push(' ');
        }
        out.push(c.to_ascii_lowercase());
    }
    out
}

/// The type of a value in words.
fn kind(schema: &Json, definitions: &Json) -> Vec<Piece> {
    let text = |text: &str| vec![Piece::Text(text.to_owned())];
    if let Some(name) = schema["$ref"].as_str().and_then(|r| r.rsplit('/').next()) {
        // A helper of the Rust types, not a notion of the language.
        if name.starts_with("OneOrMany") {
            return kind(&definitions[name], definitions);
        }
        return vec![Piece::Type(name.to_owned())];
    }
    let forms: Vec<&Json> = list(&schema["anyOf"]).iter().filter(|form| form["type"] != "null").collect();
    if !forms.is_empty() {
        let mut pieces = Vec::new();
        for form in forms {
            if !pieces.is_empty() {
                pieces.push(Piece::Text(" or ".to_owned()));
            }
            pieces.extend(kind(form, definitions));
        }
        return pieces;
    }
    let plain = match &schema["type"] {
        Json::Array(types) => types.iter().find(|t| *t != "null").and_then(Json::as_str),
        one => one.as_str(),
    };
    let of = |prefix: &str, inner: &Json| {
        let mut pieces = text(prefix);
        pieces.extend(kind(inner, definitions));
        pieces
    };
    match plain {
        Some("array") => of("list of ", &schema["items"]),
        Some("object") => match schema["patternProperties"].as_object().and_then(|p| p.values().next()) {
            Some(inner) => of("mapping of values to ", inner),
            None => of("mapping of names to ", &schema["additionalProperties"]),
        },
        Some("integer") => text("number"),
        Some("boolean") => text("true or false"),
        Some("string") => text("text"),
        Some(other) => text(other),
        None => text("anything"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Piece, types};

    #[test]
    fn every_type_is_explained() {
        let all = types();
        assert_eq!(all[0].name, "Description");
        assert!(all.iter().any(|t| t.name == "AccessCode" && t.words.len() == regdef::model::AccessCode::ALL.len()));
        for one in &all {
            assert!(!one.doc.is_empty(), "{} has no description", one.name);
            assert!(one.keys.iter().all(|k| !k.doc.is_empty()), "a key of {} has no description", one.name);
            let pieces = one.keys.iter().flat_map(|k| &k.kind);
            assert!(
                pieces.into_iter().all(|p| *p != Piece::Text("anything".to_owned())),
                "a key of {} has no type",
                one.name
            );
        }
    }
}
