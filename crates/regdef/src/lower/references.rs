//! Names become references; citations are checked.

use super::Lowering;
use super::fields::Holder;
use crate::diagnostic::{Code, Diagnostic, Spot, suggestion};
use crate::model::{Cite, FieldRef, RegisterId};
use crate::path::Path;
use crate::syntax::OneOrMany;

/// The citations of a node as a list.
pub(super) fn cites(cite: Option<&OneOrMany<Cite>>) -> Vec<Cite> {
    cite.map(|c| c.as_slice().to_vec()).unwrap_or_default()
}

/// Bytes of text in citations.
pub(super) fn weight(cites: &[Cite]) -> usize {
    cites.iter().map(|c| 64 + c.note.as_ref().map_or(0, String::len) + c.section.as_ref().map_or(0, String::len)).sum()
}

impl Lowering<'_> {
    pub(super) fn find(&mut self, finding: Diagnostic) {
        self.findings.push(finding);
    }

    /// "did you mean", or `otherwise`.
    pub(super) fn hint<'n>(&self, name: &str, known: impl IntoIterator<Item = &'n str>, otherwise: &str) -> String {
        let found = if self.findings.full() { None } else { suggestion(name, known) };
        found.unwrap_or_else(|| otherwise.to_owned())
    }

    /// Citations of a node, each checked for its source.
    pub(super) fn cite(&mut self, cite: Option<&OneOrMany<Cite>>, at: &Path) -> Vec<Cite> {
        let list = cites(cite);
        for (index, one) in list.iter().enumerate() {
            let place = match cite {
                Some(OneOrMany::Many(_)) => at.key("cite").index(index),
                _ => at.key("cite"),
            };
            self.one_cite(one, &place);
        }
        list
    }

    pub(super) fn one_cite(&mut self, cite: &Cite, place: &Path) {
        match &cite.source {
            Some(key) if !self.text.sources.contains_key(key) => {
                let hint = self.hint(key, self.text.sources.keys().map(String::as_str), "unknown source");
                self.find(
                    Diagnostic::new(
                        Code::UnknownSource,
                        Spot::Value(place.key("source")),
                        format!("there is no source `{key}`"),
                    )
                    .label(hint)
                    .help(format!("declare it under `sources: {{{key}: {{title: ...}}}}`")),
                );
            }
            None if [
                &cite.section,
                &cite.register,
                &cite.table,
                &cite.figure,
                &cite.example,
                &cite.equation,
                &cite.note,
            ]
            .iter()
            .all(|part| part.is_none()) =>
            {
                self.find(
                    Diagnostic::new(Code::VagueCitation, Spot::Value(place.clone()), "the citation gives no section, register, table or the like")
                        .label("a page alone moves with every revision")
                        .help("give a section, register, table, figure, example or equation of the manual, a source, or a note"),
                );
            }
            _ => {}
        }
    }

    /// Finds a register by name, or reports that there is none.
    pub(super) fn register_ref(&mut self, name: &str, at: &Path) -> Option<RegisterId> {
        if let Some(id) = self.register_names.get(name) {
            return Some(*id);
        }
        if self.lost_registers.contains(name) {
            return None;
        }
        let hint = self.hint(name, self.register_names.keys().map(String::as_str), "unknown register");
        self.find(
            Diagnostic::new(Code::UnknownReference, Spot::Value(at.clone()), format!("there is no register `{name}`"))
                .label(hint)
                .help("references use the keys of `registers` and of the members of `clusters`"),
        );
        None
    }

    /// Finds `REG.FIELD`, or reports what is missing.
    pub(super) fn field_ref(&mut self, reference: &str, at: &Path) -> Option<FieldRef> {
        let Some((register, field)) = reference.split_once('.') else {
            self.find(
                Diagnostic::new(
                    Code::UnknownReference,
                    Spot::Value(at.clone()),
                    format!("`{reference}` does not name a field"),
                )
                .help("write the register and the field: `CCCR.INIT`"),
            );
            return None;
        };
        let id = self.register_ref(register.trim(), at)?;
        self.field_of(id, field.trim(), at)
    }

    pub(super) fn field_of(&mut self, id: RegisterId, field: &str, at: &Path) -> Option<FieldRef> {
        let register = &self.out.model.registers[id.0];
        if let Some(index) = register.fields.iter().position(|f| f.name == field) {
            return Some(FieldRef { register: id, field: index });
        }
        if self.lost_fields.contains(&(Holder::Register(id), field.to_owned())) {
            return None;
        }
        let hint = self.hint(field, register.fields.iter().map(|f| f.name.as_str()), "unknown field");
        let name = register.name.clone();
        let declared = self.out.registers[id.0].path.clone();
        self.find(
            Diagnostic::new(
                Code::UnknownReference,
                Spot::Value(at.clone()),
                format!("the register `{name}` has no field `{field}`"),
            )
            .label(hint)
            .also(Spot::Key(declared), "the register is declared here"),
        );
        None
    }
}
