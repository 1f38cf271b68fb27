//! `like`: a register described as another one with changed names.

use indexmap::IndexMap;

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::path::Path;
use crate::syntax::{EnumValue, Field, Register};

/// A register with everything that `like` copies, and the place each field comes from.
pub(super) struct Expanded {
    pub register: Register,
    pub origins: IndexMap<String, Path>,
}

/// Longest chain of copies of copies.
pub(super) const MAX_STEPS: usize = 8;

/// Bytes of text that a copy of a register repeats.
fn weight(register: &Register) -> usize {
    let maybe = |text: &Option<String>| text.as_ref().map_or(0, String::len);
    let field = |(key, field): (&String, &Field)| {
        let values = field.values.iter().flat_map(|values| values.values()).map(|value| match value {
            EnumValue::Name(name) => 32 + name.len(),
            EnumValue::Full(full) => 32 + full.name.len() + maybe(&full.doc),
        });
        let texts =
            [&field.label, &field.name, &field.when, &field.set_when, &field.write_loads, &field.safe_to_write_back];
        let cited = field.cite.as_ref().map_or(0, |cite| super::references::weight(cite.as_slice()));
        256 + key.len() + field.doc.len() + texts.into_iter().map(maybe).sum::<usize>() + values.sum::<usize>() + cited
    };
    let texts = [&register.doc, &register.when, &register.unsafe_write];
    texts.into_iter().map(maybe).sum::<usize>()
        + register.hazards.iter().map(String::len).sum::<usize>()
        + register.fields.iter().map(field).sum::<usize>()
}

impl Lowering<'_> {
    /// Resolves `like` for one register of a list, through any number of steps.
    pub(super) fn expand(&mut self, name: &str, list: &IndexMap<String, Register>, base: &Path) -> Option<Expanded> {
        let mut chain = vec![name.to_owned()];
        loop {
            let last = &chain[chain.len() - 1];
            let Some(like) = list.get(last).and_then(|r| r.like.as_ref()) else { break };
            let at = base.key(last).key("like").key("register");
            if self.lost_registers.contains(&like.register) {
                return None;
            }
            if chain.contains(&like.register) {
                let cycle = chain.join(" → ");
                self.find(
                    Diagnostic::new(
                        Code::LikeCycle,
                        Spot::Value(at),
                        format!("`like` leads back to `{}`", like.register),
                    )
                    .label(format!("{cycle} → {}", like.register))
                    .help("one register of the circle has to list its fields itself"),
                );
                return None;
            }
            if !list.contains_key(&like.register) {
                let hint = self.hint(&like.register, list.keys().map(String::as_str), "unknown register");
                self.find(
                    Diagnostic::new(
                        Code::UnknownReference,
                        Spot::Value(at),
                        format!("there is no register `{}` in this list", like.register),
                    )
                    .label(hint)
                    .help("`like` copies a register of the same list: of `registers`, or of the same cluster"),
                );
                return None;
            }
            if chain.len() == MAX_STEPS {
                self.find(
                    Diagnostic::new(
                        Code::LikeCycle,
                        Spot::Value(at),
                        format!("`like` leads through more than {MAX_STEPS} registers"),
                    )
                    .help("copy the register that lists the fields itself"),
                );
                return None;
            }
            chain.push(like.register.clone());
        }
        let origin = chain.pop()?;
        let mut register = list.get(&origin)?.clone();
        let here = base.key(&origin).key("fields");
        let mut origins: IndexMap<String, Path> = register.fields.keys().map(|f| (f.clone(), here.key(f))).collect();
        while let Some(next) = chain.pop() {
            let own = list.get(&next)?;
            let pairs = own.like.as_ref().map(|l| l.replace.clone()).unwrap_or_default();
            let replace = Replace::new(&pairs);
            let like_at = base.key(&next).key("like");
            if !self.repeat(weight(&register).saturating_mul(1 + replace.growth()), &like_at) {
                return None;
            }
            let empty = own.like.iter().flat_map(|l| l.replace.keys()).any(String::is_empty);
            if empty {
                let title = "the empty text cannot be replaced";
                self.find(Diagnostic::new(Code::OutOfRange, Spot::Key(like_at.key("replace").key("")), title));
            }
            let copied = std::mem::take(&mut register.fields);
            let moved = std::mem::take(&mut origins);
            let mut fields = IndexMap::new();
            let mut originals: IndexMap<String, String> = IndexMap::new();
            for ((key, field), origin) in copied.into_iter().zip(moved.into_values()) {
                let copied_as = replace.text(&key);
                if let Some(other) = originals.get(&copied_as) {
                    self.find(
                        Diagnostic::new(
                            Code::DuplicateName,
                            Spot::Value(like_at.key("replace")),
                            format!("two fields of `{next}` would be named `{copied_as}`"),
                        )
                        .label(format!("`{other}` and `{key}` both become `{copied_as}`"))
                        .also(Spot::Key(origin), format!("`{key}`"))
                        .help("replace a longer text that only one of them contains"),
                    );
                    continue;
                }
                originals.insert(copied_as.clone(), key);
                let key = copied_as;
                fields.insert(key.clone(), replace.field(field));
                origins.insert(key, origin);
            }
            let here = base.key(&next).key("fields");
            for (key, field) in &own.fields {
                fields.insert(key.clone(), field.clone());
                origins.insert(key.clone(), here.key(key));
            }
            let inherit = |mine: &Option<String>, theirs: &Option<String>| {
                mine.clone().or_else(|| theirs.as_ref().map(|text| replace.text(text)))
            };
            register = Register {
                title: own.title.clone(),
                offset: own.offset,
                width: own.width.or(register.width),
                array: own.array.clone(),
                device: own.device,
                window: own.window.clone().or(register.window),
                label: own.label.clone(),
                name: own.name.clone(),
                doc: inherit(&own.doc, &register.doc),
                cite: own.cite.clone(),
                access: own.access.or(register.access),
                when: inherit(&own.when, &register.when),
                reset: own.reset.clone().or(register.reset),
                like: None,
                unsafe_write: inherit(&own.unsafe_write, &register.unsafe_write),
                hazards: if own.hazards.is_empty() {
                    register.hazards.iter().map(|text| replace.text(text)).collect()
                } else {
                    own.hazards.clone()
                },
                no_aliases: own.no_aliases || register.no_aliases,
                fields,
            };
        }
        Some(Expanded { register, origins })
    }
}

/// Replaces several texts at once, the longest match first.
pub(super) struct Replace<'a> {
    pairs: Vec<(&'a str, &'a str)>,
}

impl<'a> Replace<'a> {
    pub(super) fn new(pairs: &'a IndexMap<String, String>) -> Self {
        let mut pairs: Vec<_> =
            pairs.iter().map(|(a, b)| (a.as_str(), b.as_str())).filter(|(a, _)| !a.is_empty()).collect();
        pairs.sort_by_key(|(from, _)| std::cmp::Reverse(from.len()));
        Self { pairs }
    }

    /// How many times longer a text can become.
    fn growth(&self) -> usize {
        self.pairs.iter().map(|(from, to)| to.len() / from.len()).max().unwrap_or(0)
    }

    pub(super) fn text(&self, text: &str) -> String {
        let mut out = String::with_capacity(text.len());
        let mut rest = text;
        'outer: while let Some(letter) = rest.chars().next() {
            for (from, to) in &self.pairs {
                if let Some(after) = rest.strip_prefix(from) {
                    out += to;
                    rest = after;
                    continue 'outer;
                }
            }
            out.push(letter);
            rest = &rest[letter.len_utf8()..];
        }
        out
    }

    fn maybe(&self, text: Option<String>) -> Option<String> {
        text.map(|text| self.text(&text))
    }

    fn field(&self, mut field: Field) -> Field {
        field.label = self.maybe(field.label);
        field.name = self.maybe(field.name);
        field.doc = self.text(&field.doc);
        field.when = self.maybe(field.when);
        field.set_when = self.maybe(field.set_when);
        field.write_loads = self.maybe(field.write_loads);
        field.safe_to_write_back = self.maybe(field.safe_to_write_back);
        for value in field.values.iter_mut().flat_map(|values| values.values_mut()) {
            match value {
                EnumValue::Name(_) => {}
                EnumValue::Full(full) => full.doc = self.maybe(full.doc.take()),
            }
        }
        field
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_all_at_once_and_the_longest_first() {
        let pairs = IndexMap::from([
            ("F0".to_owned(), "F1".to_owned()),
            ("F0S".to_owned(), "F1SX".to_owned()),
            ("F1".to_owned(), "F0".to_owned()),
        ]);
        assert_eq!(Replace::new(&pairs).text("F0SA F0 F1 ÄF0"), "F1SXA F1 F0 ÄF1");
    }
}
