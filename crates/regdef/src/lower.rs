//! From the typed text to the model: names become references, defaults are filled in.
//!
//! The passes run in the order of their dependencies; each reports all it finds and goes on with what is usable.

mod behaviour;
mod conditions;
mod enums;
mod expression;
mod fields;
mod joined;
mod like;
mod memory;
mod registers;

pub(crate) use registers::bit_list;

use std::collections::HashMap;

use crate::diagnostic::{Code, Diagnostic, Spot, suggestion};
use crate::model::{
    Alias, Cite, ConditionId, EnumId, FieldRef, Interrupts, Memory, MessageId, Model, Names, RegisterId, WindowId,
};
use crate::path::Path;
use crate::syntax::{Description, OneOrMany};

/// Where a register and its fields stand in the file.
#[derive(Debug, Clone)]
pub(crate) struct Origin {
    pub path: Path,
    pub fields: Vec<Path>,
}

/// The model with the places its parts come from.
#[derive(Debug)]
pub(crate) struct Lowered {
    pub model: Model,
    /// Parallel to [`Model::registers`].
    pub registers: Vec<Origin>,
    /// Parallel to [`Model::enums`].
    pub enums: Vec<Path>,
    /// Parallel to [`Model::conditions`].
    pub conditions: Vec<Path>,
    /// Parallel to [`Model::messages`], then to their words.
    pub words: Vec<Vec<Origin>>,
}

/// The state that the passes share.
pub(crate) struct Lowering<'a> {
    pub text: &'a Description,
    pub findings: &'a mut Vec<Diagnostic>,
    pub out: Lowered,
    /// Names of registers and members of clusters.
    pub register_names: HashMap<String, RegisterId>,
    pub enum_names: HashMap<String, EnumId>,
    pub condition_names: HashMap<String, ConditionId>,
    pub window_names: HashMap<String, WindowId>,
    pub message_names: HashMap<String, MessageId>,
    /// Write conditions of fields, to be resolved once all fields are known.
    pub pending: Vec<fields::PendingRules>,
}

pub(crate) fn lower(text: &Description, findings: &mut Vec<Diagnostic>) -> Lowered {
    let model = Model {
        names: Names::new(&text.controller),
        title: text.title.clone(),
        doc: text.doc.clone().unwrap_or_default(),
        manual: text.manual.clone(),
        sources: text.sources.clone(),
        prefix: text.prefix.clone().unwrap_or_default(),
        access_widths: {
            let mut widths = text.access_widths.clone();
            widths.sort_unstable();
            widths.dedup();
            widths
        },
        span: text.span.0,
        aliases: Vec::new(),
        windows: Vec::new(),
        conditions: Vec::new(),
        enums: Vec::new(),
        registers: Vec::new(),
        clusters: Vec::new(),
        joined: Vec::new(),
        reserved: Vec::new(),
        effects: Vec::new(),
        interrupts: Interrupts::default(),
        messages: Vec::new(),
        memory: Memory::default(),
        bit_timing: None,
        instances: Vec::new(),
        conflicts: Vec::new(),
        choices: Vec::new(),
    };
    let out = Lowered { model, registers: Vec::new(), enums: Vec::new(), conditions: Vec::new(), words: Vec::new() };
    let mut lowering = Lowering {
        text,
        findings,
        out,
        register_names: HashMap::new(),
        enum_names: HashMap::new(),
        condition_names: HashMap::new(),
        window_names: HashMap::new(),
        message_names: HashMap::new(),
        pending: Vec::new(),
    };
    lowering.header();
    lowering.enums();
    lowering.window_names();
    lowering.registers();
    lowering.windows();
    lowering.conditions();
    lowering.rules();
    lowering.joined();
    lowering.reserved();
    lowering.messages();
    lowering.memory();
    lowering.behaviour();
    lowering.capabilities();
    lowering.out
}

/// The citations of a node as a list.
pub(crate) fn cites(cite: Option<&OneOrMany<Cite>>) -> Vec<Cite> {
    cite.map(|c| c.as_slice().to_vec()).unwrap_or_default()
}

impl Lowering<'_> {
    pub(crate) fn find(&mut self, finding: Diagnostic) {
        self.findings.push(finding);
    }

    /// Citations of a node, each checked for its source.
    pub(crate) fn cite(&mut self, cite: Option<&OneOrMany<Cite>>, at: &Path) -> Vec<Cite> {
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

    pub(crate) fn one_cite(&mut self, cite: &Cite, place: &Path) {
        match &cite.source {
            Some(key) if !self.text.sources.contains_key(key) => {
                let hint = suggestion(key, self.text.sources.keys().map(String::as_str));
                self.find(
                    Diagnostic::new(
                        Code::UnknownSource,
                        Spot::Value(place.key("source")),
                        format!("there is no source `{key}`"),
                    )
                    .label(hint.unwrap_or_default())
                    .help(format!("declare it under `sources: {{{key}: {{title: ...}}}}`")),
                );
            }
            None if [&cite.section, &cite.register, &cite.table, &cite.figure, &cite.example, &cite.equation, &cite.note]
                .iter()
                .all(|part| part.is_none()) =>
            {
                self.find(
                    Diagnostic::new(Code::VagueCitation, Spot::Value(place.clone()), "the citation names no place")
                        .help("give a section, register, table, figure, example or equation of the manual, a source, or a note"),
                );
            }
            _ => {}
        }
    }

    fn header(&mut self) {
        let text = self.text;
        let id = &text.controller;
        let fine = id.starts_with(|c: char| c.is_ascii_lowercase())
            && id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        if !fine {
            self.find(
                Diagnostic::new(
                    Code::BadIdentifier,
                    Spot::Value(Path::root().key("controller")),
                    format!("`{id}` cannot name a crate and a C header"),
                )
                .help("use lower case letters, digits and underscores, starting with a letter: `m_can`"),
            );
        }
        for (index, width) in text.access_widths.iter().enumerate() {
            if !matches!(width, 8 | 16 | 32) {
                let at = Path::root().key("access_widths").index(index);
                self.find(
                    Diagnostic::new(Code::OutOfRange, Spot::Value(at), format!("an access cannot be {width} bits wide"))
                        .label("has to be 8, 16 or 32"),
                );
            }
        }
        self.check_width(text.register_width, &Path::root().key("register_width"));
        for (name, alias) in &text.aliases {
            let at = Path::root().key("aliases").key(name);
            let cites = self.cite(alias.cite.as_ref(), &at);
            self.out.model.aliases.push(Alias {
                name: name.clone(),
                offset: alias.offset.0,
                op: alias.op,
                doc: alias.doc.clone().unwrap_or_default(),
                cites,
            });
        }
    }

    pub(crate) fn check_width(&mut self, width: u8, at: &Path) -> bool {
        let fine = matches!(width, 8 | 16 | 32);
        if !fine {
            self.find(
                Diagnostic::new(Code::OutOfRange, Spot::Value(at.clone()), format!("a register cannot be {width} bits wide"))
                    .label("has to be 8, 16 or 32"),
            );
        }
        fine
    }

    /// Finds a register by name, or reports that there is none.
    pub(crate) fn register_ref(&mut self, name: &str, at: &Path) -> Option<RegisterId> {
        if let Some(id) = self.register_names.get(name) {
            return Some(*id);
        }
        let hint = suggestion(name, self.register_names.keys().map(String::as_str));
        self.find(
            Diagnostic::new(Code::UnknownReference, Spot::Value(at.clone()), format!("there is no register `{name}`"))
                .label(hint.unwrap_or_else(|| "unknown register".to_owned()))
                .help("references use the keys of `registers` and of the members of `clusters`"),
        );
        None
    }

    /// Finds `REG.FIELD`, or reports what is missing.
    pub(crate) fn field_ref(&mut self, reference: &str, at: &Path) -> Option<FieldRef> {
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

    pub(crate) fn field_of(&mut self, id: RegisterId, field: &str, at: &Path) -> Option<FieldRef> {
        let register = &self.out.model.registers[id.0];
        if let Some(index) = register.fields.iter().position(|f| f.name == field) {
            return Some(FieldRef { register: id, field: index });
        }
        let hint = suggestion(field, register.fields.iter().map(|f| f.name.as_str()));
        let name = register.name.clone();
        let declared = self.out.registers[id.0].path.clone();
        self.find(
            Diagnostic::new(
                Code::UnknownReference,
                Spot::Value(at.clone()),
                format!("the register `{name}` has no field `{field}`"),
            )
            .label(hint.unwrap_or_else(|| "unknown field".to_owned()))
            .also(Spot::Key(declared), "the register is declared here"),
        );
        None
    }

    /// Reports a name that is declared twice; `true` if it is new.
    pub(crate) fn declare<T>(
        &mut self,
        known: fn(&mut Self) -> &mut HashMap<String, T>,
        name: &str,
        id: T,
        what: &str,
        at: &Path,
    ) -> bool {
        if known(self).contains_key(name) {
            self.find(
                Diagnostic::new(Code::DuplicateName, Spot::Key(at.clone()), format!("there are two {what}s named `{name}`"))
                    .help("references use this name alone, so it has to be unique"),
            );
            return false;
        }
        known(self).insert(name.to_owned(), id);
        true
    }
}
