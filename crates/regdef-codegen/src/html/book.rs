//! Addresses: where on the site everything of one controller stands.
//!
//! Addresses are part of what a reader bookmarks, so they come from the manual's names, not from positions.

use std::collections::{HashMap, HashSet};

use regdef::model::{
    ClusterId, ConditionId, EnumId, FieldRef, InterruptId, LineId, MessageId, Model, Register, RegisterId, Target,
    WindowId,
};

/// Pages that every controller can have; a register whose name is one of them gets a number.
const PAGES: &[&str] = &[
    "index",
    "conditions",
    "enums",
    "joined",
    "effects",
    "interrupts",
    "messages",
    "memory",
    "timing",
    "chips",
    "conflicts",
    "choices",
];

/// Anchors of the overview that a cluster or window must not take.
const OVERVIEW: &[&str] = &["map", "reserved", "device", "clusters", "windows", "aliases", "sources"];

/// Where everything of one controller stands, relative to the controller's folder.
pub(super) struct Book<'a> {
    pub model: &'a Model,
    registers: Vec<String>,
    fields: Vec<Vec<String>>,
    clusters: Vec<String>,
    windows: Vec<String>,
    enums: Vec<String>,
    conditions: Vec<String>,
    joined: Vec<String>,
    effects: Vec<String>,
    messages: Vec<String>,
    words: Vec<Vec<String>>,
    word_fields: Vec<Vec<Vec<String>>>,
    sections: Vec<String>,
    lines: Vec<String>,
    interrupts: Vec<String>,
    instances: Vec<String>,
    conflicts: Vec<String>,
    choices: Vec<String>,
    /// Names of prose that become links: `NAME`, `PREFIXNAME`.
    names: HashMap<String, RegisterId>,
}

/// Anchors of one page, no two the same.
#[derive(Default)]
struct Slugs(HashSet<String>);

impl Slugs {
    fn make(&mut self, name: &str) -> String {
        let mut slug = String::new();
        for c in name.chars() {
            match c {
                'a'..='z' | '0'..='9' => slug.push(c),
                'A'..='Z' => slug.push(c.to_ascii_lowercase()),
                _ if slug.is_empty() || slug.ends_with('_') => {}
                _ => slug.push('_'),
            }
        }
        let base = match slug.trim_end_matches('_') {
            "" => "item",
            slug => slug,
        };
        let mut unique = base.to_owned();
        let mut number = 2;
        while !self.0.insert(unique.clone()) {
            unique = format!("{base}_{number}");
            number += 1;
        }
        unique
    }

    fn all<'t, T>(of: &'t [T], name: impl Fn(&'t T) -> &'t str) -> Vec<String> {
        let mut slugs = Self::default();
        of.iter().map(|one| slugs.make(name(one))).collect()
    }
}

impl<'a> Book<'a> {
    pub fn new(model: &'a Model) -> Self {
        let mut pages = Slugs(PAGES.iter().map(|&p| p.to_owned()).collect());
        let mut overview = Slugs(OVERVIEW.iter().map(|&p| p.to_owned()).collect());
        let mut lines = Slugs::default();
        let mut names = HashMap::new();
        for (index, register) in model.registers.iter().enumerate() {
            names.entry(register.name.clone()).or_insert(RegisterId(index));
            if !register.label.contains('{') {
                names.entry(register.label.clone()).or_insert(RegisterId(index));
            }
            if !model.prefix.is_empty() {
                names.entry(format!("{}{}", model.prefix, register.name)).or_insert(RegisterId(index));
                let label = register.label.replace("{n}", "n");
                names.entry(format!("{}{label}", model.prefix)).or_insert(RegisterId(index));
            }
        }
        Self {
            model,
            registers: model.registers.iter().map(|r| pages.make(&r.name)).collect(),
            fields: model.registers.iter().map(|r| Slugs::all(&r.fields, |f| &f.name)).collect(),
            clusters: model.clusters.iter().map(|c| overview.make(&c.name)).collect(),
            windows: model.windows.iter().map(|w| overview.make(&w.name)).collect(),
            enums: Slugs::all(&model.enums, |e| &e.name),
            conditions: Slugs::all(&model.conditions, |c| &c.name),
            joined: Slugs::all(&model.joined, |j| &j.name),
            effects: Slugs::all(&model.effects, |e| &model.condition(e.on).name),
            messages: Slugs::all(&model.messages, |m| &m.name),
            words: model.messages.iter().map(|m| Slugs::all(&m.words, |w| &w.name)).collect(),
            word_fields: model
                .messages
                .iter()
                .map(|m| m.words.iter().map(|w| Slugs::all(&w.fields, |f| &f.name)).collect())
                .collect(),
            sections: Slugs::all(&model.memory.sections, |s| &s.name),
            lines: model.interrupts.lines.iter().map(|l| lines.make(&l.name)).collect(),
            interrupts: model.interrupts.sources.iter().map(|s| lines.make(&s.name)).collect(),
            instances: Slugs::all(&model.instances, |i| &i.name),
            conflicts: Slugs::all(&model.conflicts, |c| &c.id),
            choices: Slugs::all(&model.choices, |c| &c.id),
            names,
        }
    }

    /// The folder of the controller.
    pub fn folder(&self) -> &str {
        &self.model.names.id
    }

    pub fn register(&self, id: RegisterId) -> String {
        format!("{}.html", self.registers[id.0])
    }

    pub fn field_id(&self, at: FieldRef) -> &str {
        &self.fields[at.register.0][at.field]
    }

    pub fn field(&self, at: FieldRef) -> String {
        format!("{}#{}", self.register(at.register), self.field_id(at))
    }

    pub fn cluster(&self, id: ClusterId) -> String {
        format!("index.html#{}", self.clusters[id.0])
    }

    pub fn window(&self, id: WindowId) -> String {
        format!("index.html#{}", self.windows[id.0])
    }

    pub fn enumeration(&self, id: EnumId) -> String {
        format!("enums.html#{}", self.enums[id.0])
    }

    pub fn condition(&self, id: ConditionId) -> String {
        format!("conditions.html#{}", self.conditions[id.0])
    }

    pub fn joined(&self, index: usize) -> String {
        format!("joined.html#{}", self.joined[index])
    }

    pub fn effect(&self, index: usize) -> String {
        format!("effects.html#{}", self.effects[index])
    }

    pub fn message(&self, id: MessageId) -> String {
        format!("messages.html#{}", self.messages[id.0])
    }

    pub fn word(&self, id: MessageId, word: usize) -> String {
        format!("{}.{}", self.message(id), self.words[id.0][word])
    }

    pub fn word_field(&self, id: MessageId, word: usize, field: usize) -> String {
        format!("{}.{}", self.word(id, word), self.word_fields[id.0][word][field])
    }

    pub fn section(&self, index: usize) -> String {
        format!("memory.html#{}", self.sections[index])
    }

    pub fn line(&self, id: LineId) -> String {
        format!("interrupts.html#{}", self.lines[id.0])
    }

    pub fn interrupt(&self, id: InterruptId) -> String {
        format!("interrupts.html#{}", self.interrupts[id.0])
    }

    pub fn instance(&self, index: usize) -> String {
        format!("chips.html#{}", self.instances[index])
    }

    pub fn conflict(&self, index: usize) -> String {
        format!("conflicts.html#{}", self.conflicts[index])
    }

    pub fn choice(&self, index: usize) -> String {
        format!("choices.html#{}", self.choices[index])
    }

    pub fn source(key: &str) -> String {
        let mut slugs = Slugs::default();
        format!("index.html#source-{}", slugs.make(key))
    }

    /// Address and name of what a conflict or choice is about.
    pub fn target(&self, target: Target) -> (String, String) {
        let model = self.model;
        match target {
            Target::Register(id) => (self.register(id), label(model, model.register(id))),
            Target::Cluster(id) => (self.cluster(id), model.clusters[id.0].name.clone()),
            Target::Joined(index) => (self.joined(index), model.joined[index].name.clone()),
            Target::Field(at) => (self.field(at), model.field_path(at)),
            Target::Enum(id) => (self.enumeration(id), model.enumeration(id).name.clone()),
            Target::Message(id) => (self.message(id), model.messages[id.0].name.clone()),
            Target::Word(id, word) => {
                let message = &model.messages[id.0];
                (self.word(id, word), format!("{}.{}", message.name, message.words[word].name))
            }
            Target::WordField(id, word, field) => {
                let message = &model.messages[id.0];
                let name = &message.words[word].fields[field].name;
                (self.word_field(id, word, field), format!("{}.{}.{name}", message.name, message.words[word].name))
            }
        }
    }

    /// The register or field that a name of prose means; `here` is the register whose fields need no prefix.
    pub fn named(&self, name: &str, here: Option<RegisterId>) -> Option<Target> {
        if let Some((register, field)) = name.split_once('.') {
            let register = *self.names.get(register)?;
            let field =
                self.model.register(register).fields.iter().position(|f| f.name == field || f.label == field)?;
            return Some(Target::Field(FieldRef { register, field }));
        }
        if let Some(register) = here
            && let Some(field) = self.model.register(register).fields.iter().position(|f| f.name == name)
        {
            return Some(Target::Field(FieldRef { register, field }));
        }
        self.names.get(name).map(|&id| Target::Register(id))
    }
}

/// The manual's spelling of a register with `n` for the number, without the prefix.
pub(super) fn label(model: &Model, register: &Register) -> String {
    let dim = register.dim.as_ref().or_else(|| register.cluster.map(|id| &model.clusters[id.0].dim));
    match dim {
        None => register.label.clone(),
        Some(dim) if !dim.labels.is_empty() && !register.label.contains("{n}") => register.name.clone(),
        Some(_) if register.label.contains("{n}") => register.label.replace("{n}", "n"),
        Some(_) => format!("{}n", register.label),
    }
}

#[cfg(test)]
mod tests {
    use super::Slugs;

    #[test]
    fn anchors_are_plain_and_unique() {
        let mut slugs = Slugs::default();
        let made: Vec<_> = ["MM[7:0]", "mm_7_0", "FLTCON.FLTEN[n] == 0", "!!", "ÄÖ"].map(|n| slugs.make(n)).into();
        assert_eq!(made, ["mm_7_0", "mm_7_0_2", "fltcon_flten_n_0", "item", "item_2"]);
    }
}
