//! Enumerations.

use indexmap::IndexMap;

use super::Lowering;
use super::references::cites;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{Cite, Enum, EnumId, EnumVariant, Ident};
use crate::path::Path;
use crate::syntax::{EnumDef, EnumValue, ValueKey};

/// Most entries of an enumeration: the frame lengths of CAN FD have 16, an interrupt code 128.
const MAX_VALUES: usize = 1024;

impl Lowering<'_> {
    pub(super) fn enums(&mut self) {
        let text = self.text;
        for (name, def) in &text.enums {
            let at = Path::root().key("enums").key(name);
            let (doc, cite, values, values_at) = match def {
                EnumDef::Short(values) => (String::new(), None, values, at.clone()),
                EnumDef::Full(full) => {
                    (full.doc.clone().unwrap_or_default(), full.cite.as_ref(), &full.values, at.key("values"))
                }
            };
            self.cite(cite, &at);
            self.check_identifier(name, &at);
            let id = self.add_enum(name, true, doc, cites(cite), values, &values_at);
            self.enum_names.insert(name.clone(), id);
        }
    }

    /// Adds an enumeration; `at` is the place of its values.
    pub(super) fn add_enum(
        &mut self,
        name: &str,
        shared: bool,
        doc: String,
        cites: Vec<Cite>,
        values: &IndexMap<ValueKey, EnumValue>,
        at: &Path,
    ) -> EnumId {
        let mut variants: Vec<EnumVariant> = Vec::new();
        let mut reserved = Vec::new();
        let mut taken: Vec<(ValueKey, String)> = Vec::new();
        if values.len() > MAX_VALUES {
            let title = format!("the enumeration `{name}` has {} entries; {MAX_VALUES} is the most", values.len());
            self.find(
                Diagnostic::new(Code::OutOfRange, Spot::Key(at.clone()), title)
                    .help("a field with so many values holds a number; ranges such as \"0..31\" name many at once"),
            );
        }
        for (key, value) in values.iter().take(MAX_VALUES) {
            let (value_name, value_doc, number) = match value {
                EnumValue::Name(name) => (name, String::new(), None),
                EnumValue::Full(full) => (&full.name, full.doc.clone().unwrap_or_default(), full.number.map(|n| n.0)),
            };
            let place = at.key(&key.spelling);
            if key.first > key.last {
                self.find(
                    Diagnostic::new(Code::BadRange, Spot::Key(place.clone()), "the range ends before it starts")
                        .label(format!("write \"{}..{}\"", key.last, key.first))
                        .help("the smaller value comes first; both ends are included"),
                );
                continue;
            }
            if let Some((first, other)) = taken.iter().find(|(k, _)| k.first <= key.last && key.first <= k.last) {
                let title = format!("`{value_name}` has a value that `{other}` has already");
                self.find(
                    Diagnostic::new(Code::DuplicateEnumValue, Spot::Key(place.clone()), title)
                        .label("again here")
                        .also(Spot::Key(at.key(&first.spelling)), "first here")
                        .help("every value can have one name; note a second meaning in `doc`"),
                );
            }
            taken.push((key.clone(), value_name.clone()));
            if value_name == "reserved" {
                reserved.push((key.first, key.last));
                continue;
            }
            self.check_value_name(value_name, &place);
            if let Some(other) = variants.iter().find(|v| v.ident.pascal == Ident::new(value_name).pascal) {
                let first = taken.iter().find(|(key, _)| key.first == other.first);
                let first = first.map_or_else(|| at.clone(), |(key, _)| at.key(&key.spelling));
                let title = format!("the enumeration has two values named `{value_name}`");
                let title =
                    if other.name == *value_name { title } else { format!("{title} (the other is `{}`)", other.name) };
                self.find(
                    Diagnostic::new(Code::DuplicateName, Spot::Value(place), title)
                        .label("again here")
                        .also(Spot::Value(first), "first here")
                        .help("give each value a name of its own, or one entry with a range of values"),
                );
                continue;
            }
            variants.push(EnumVariant {
                name: value_name.clone(),
                ident: Ident::new(value_name),
                doc: value_doc,
                first: key.first,
                last: key.last,
                number,
            });
        }
        variants.sort_by_key(|v| v.first);
        reserved.sort_unstable();
        let id = EnumId(self.out.model.enums.len());
        self.out.model.enums.push(Enum {
            name: name.to_owned(),
            ident: Ident::new(name),
            shared,
            doc,
            cites,
            width: 0,
            variants,
            reserved,
            used_by: Vec::new(),
        });
        self.out.enums.push(at.clone());
        id
    }

    fn check_value_name(&mut self, name: &str, at: &Path) {
        let fine = name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
            && name.contains(|c: char| c.is_ascii_alphanumeric());
        if !fine {
            let lower: String = name
                .chars()
                .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' })
                .take(64)
                .collect();
            let hint = if lower.contains(|c: char| c.is_ascii_alphanumeric()) {
                format!("perhaps `{lower}`")
            } else {
                String::new()
            };
            self.find(
                Diagnostic::new(Code::BadIdentifier, Spot::Value(at.clone()), format!("`{name}` cannot name a value"))
                    .label(hint)
                    .help(
                        "use lower case ASCII letters, digits and underscores; what the value means belongs into `doc`",
                    ),
            );
        }
    }
}
