//! Who refers to whom: the other direction of every link.

use std::collections::HashMap;

use regdef::model::{
    ClusterId, ConditionId, EnumId, FieldRef, InterruptId, Joined, LineId, MessageId, Model, RegisterId, SectionStart,
    Target, TimingPhase,
};

use super::book::Book;
use super::text::{code_link, link};

/// What refers to a thing: a term such as `Interrupt`, and HTML with a link.
pub(super) type Mentions = Vec<(&'static str, String)>;

/// All mentions, in the order of the description.
#[derive(Default)]
pub(super) struct Xref {
    registers: HashMap<RegisterId, Mentions>,
    fields: HashMap<FieldRef, Mentions>,
    enums: HashMap<EnumId, Mentions>,
    conditions: HashMap<ConditionId, Mentions>,
    clusters: HashMap<ClusterId, Mentions>,
    joined: HashMap<usize, Mentions>,
    messages: HashMap<MessageId, Mentions>,
    words: HashMap<(MessageId, usize), Mentions>,
    word_fields: HashMap<(MessageId, usize, usize), Mentions>,
}

impl Xref {
    pub fn new(book: &Book<'_>) -> Self {
        let mut all = Self::default();
        all.access(book);
        all.conditions_and_windows(book);
        all.effects(book);
        all.joined(book);
        all.interrupts(book);
        all.memory(book);
        all.timing(book);
        all.findings(book);
        all
    }

    pub fn of_register(&self, id: RegisterId) -> &[(&'static str, String)] {
        self.registers.get(&id).map_or(&[], Vec::as_slice)
    }

    pub fn of_field(&self, at: FieldRef) -> &[(&'static str, String)] {
        self.fields.get(&at).map_or(&[], Vec::as_slice)
    }

    pub fn of_enum(&self, id: EnumId) -> &[(&'static str, String)] {
        self.enums.get(&id).map_or(&[], Vec::as_slice)
    }

    pub fn of_condition(&self, id: ConditionId) -> &[(&'static str, String)] {
        self.conditions.get(&id).map_or(&[], Vec::as_slice)
    }

    pub fn of_cluster(&self, id: ClusterId) -> &[(&'static str, String)] {
        self.clusters.get(&id).map_or(&[], Vec::as_slice)
    }

    pub fn of_joined(&self, index: usize) -> &[(&'static str, String)] {
        self.joined.get(&index).map_or(&[], Vec::as_slice)
    }

    pub fn of_message(&self, id: MessageId) -> &[(&'static str, String)] {
        self.messages.get(&id).map_or(&[], Vec::as_slice)
    }

    pub fn of_word(&self, id: MessageId, word: usize) -> &[(&'static str, String)] {
        self.words.get(&(id, word)).map_or(&[], Vec::as_slice)
    }

    pub fn of_word_field(&self, id: MessageId, word: usize, field: usize) -> &[(&'static str, String)] {
        self.word_fields.get(&(id, word, field)).map_or(&[], Vec::as_slice)
    }

    fn field(&mut self, at: FieldRef, term: &'static str, html: String) {
        self.fields.entry(at).or_default().push((term, html));
    }

    fn access(&mut self, book: &Book<'_>) {
        for (at, field) in all_fields(book.model) {
            let user = book.field_link(at);
            for id in [field.access.when, field.access.set_when].into_iter().flatten() {
                self.conditions.entry(id).or_default().push(("Write condition of", user.clone()));
            }
            if let Some(id) = field.enumeration() {
                self.enums.entry(id).or_default().push(("Used by", user.clone()));
            }
            if let Some(origin) = field.access.loads {
                self.field(origin, "Loaded by", format!("a write of {user}"));
            }
        }
        for (m, message) in book.model.messages.iter().enumerate() {
            for (w, word) in message.words.iter().enumerate() {
                let id = MessageId(m);
                if let Some(condition) = word.present_when {
                    let user = code_link(&book.word(id, w), &format!("{}.{}", message.name, word.name));
                    self.conditions.entry(condition).or_default().push(("Layout of", user));
                }
                for (f, field) in word.fields.iter().enumerate() {
                    let user = book.target_link(Target::WordField(id, w, f));
                    if let Some(id) = field.enumeration() {
                        self.enums.entry(id).or_default().push(("Used by", user.clone()));
                    }
                }
            }
        }
    }

    fn conditions_and_windows(&mut self, book: &Book<'_>) {
        for (index, condition) in book.model.conditions.iter().enumerate() {
            let mut seen = Vec::new();
            for at in condition.expr.fields() {
                if !seen.contains(&at) {
                    seen.push(at);
                    self.field(at, "Looked at by condition", book.condition_link(ConditionId(index)));
                }
            }
        }
        for (index, window) in book.model.windows.iter().enumerate() {
            let to = code_link(&book.window(regdef::model::WindowId(index)), &window.name);
            self.field(window.select, "Selects window", format!("{to} with {}", window.value));
        }
        for range in &book.model.reserved {
            if let Some(at) = range.sets {
                let text = format!("an access to {:#05x} to {:#05x}", range.from, range.to);
                self.field(at, "Set by", link("index.html#reserved", &text));
            }
        }
    }

    fn effects(&mut self, book: &Book<'_>) {
        for (index, effect) in book.model.effects.iter().enumerate() {
            let name = &book.model.condition(effect.on).name;
            let to = code_link(&book.effect(index), name);
            self.conditions
                .entry(effect.on)
                .or_default()
                .push(("Has an effect", link(&book.effect(index), "see effects")));
            for &id in &effect.resets {
                self.registers.entry(id).or_default().push(("Reset by", to.clone()));
            }
            for &at in &effect.resets_fields {
                self.field(at, "Reset by", to.clone());
            }
            for &(target, origin) in &effect.loads {
                self.field(target, "Loaded by", format!("{to} from {}", book.field_link(origin)));
                self.field(origin, "Is loaded", format!("into {} by {to}", book.field_link(target)));
            }
            for &(at, value) in &effect.sets {
                let verb = if effect.holds { "Held by" } else { "Set by" };
                self.field(at, verb, format!("{to} at {value}"));
            }
        }
    }

    fn joined(&mut self, book: &Book<'_>) {
        for (index, joined) in book.model.joined.iter().enumerate() {
            let to = code_link(&book.joined(index), &joined.name);
            for part in &joined.parts {
                let bits = super::text::bit_range(part.shift, part.width);
                let html = format!("bits {bits} of {to}");
                match part.field {
                    Some(field) => self.field(FieldRef { register: part.holder, field }, "Part of", html),
                    None => self.registers.entry(part.holder).or_default().push(("Part of", html)),
                }
            }
        }
        for (m, message) in book.model.messages.iter().enumerate() {
            for Joined { name, parts, .. } in &message.joined {
                for part in parts {
                    let html = format!("<code>{}</code>", super::text::escape(name));
                    if let Some(field) = part.field {
                        self.word_fields.entry((MessageId(m), part.holder, field)).or_default().push(("Part of", html));
                    } else {
                        self.words.entry((MessageId(m), part.holder)).or_default().push(("Part of", html));
                    }
                }
            }
        }
    }

    fn interrupts(&mut self, book: &Book<'_>) {
        let interrupts = &book.model.interrupts;
        for (index, line) in interrupts.lines.iter().enumerate() {
            if let Some(at) = line.enable {
                let to = code_link(&book.line(LineId(index)), &line.name);
                self.field(at, "Interrupt", format!("enables line {to}"));
            }
        }
        for (index, source) in interrupts.sources.iter().enumerate() {
            let to = code_link(&book.interrupt(InterruptId(index)), &source.name);
            self.field(source.flag, "Interrupt", format!("flag of {to}"));
            if let Some(at) = source.enable {
                self.field(at, "Interrupt", format!("enables {to}"));
            }
            if let Some(at) = source.select {
                self.field(at, "Interrupt", format!("selects the line of {to}"));
            }
        }
    }

    fn memory(&mut self, book: &Book<'_>) {
        for (index, section) in book.model.memory.sections.iter().enumerate() {
            let to = code_link(&book.section(index), &section.name);
            if let SectionStart::At { parts, .. } = &section.start {
                for part in parts {
                    let html = format!("start of {to}");
                    match part.field {
                        Some(field) => self.field(FieldRef { register: part.holder, field }, "Memory", html),
                        None => self.registers.entry(part.holder).or_default().push(("Memory", html)),
                    }
                }
            }
            for &at in &section.count {
                self.field(at, "Memory", format!("number of elements of {to}"));
            }
            if let Some(at) = section.payload_size {
                self.field(at, "Memory", format!("payload size of {to}"));
            }
            if let Some(id) = section.exists_when {
                self.conditions.entry(id).or_default().push(("Existence of", to.clone()));
            }
            for &id in &section.elements {
                self.messages.entry(id).or_default().push(("Stored in", to.clone()));
            }
        }
    }

    fn timing(&mut self, book: &Book<'_>) {
        let Some(timing) = &book.model.bit_timing else { return };
        let mut phase = |phase: &TimingPhase, name: &str, id: &str| {
            for (at, role) in super::timing::roles(phase) {
                self.field(at, "Bit timing", format!("{role}, {}", link(&format!("timing.html#{id}"), name)));
            }
        };
        phase(&timing.nominal, "nominal phase", "nominal");
        if let Some(data) = &timing.data {
            phase(data, "data phase", "data");
        }
        if let Some(delay) = &timing.transmitter_delay {
            for (at, role) in super::timing::delay_roles(delay) {
                let to = link("timing.html#transmitter_delay", "transmitter delay compensation");
                self.field(at, "Bit timing", format!("{role}, {to}"));
            }
        }
    }

    fn findings(&mut self, book: &Book<'_>) {
        for (index, conflict) in book.model.conflicts.iter().enumerate() {
            let html = link(&book.conflict(index), conflict.what.trim_end_matches('.'));
            for &target in &conflict.at {
                self.target(target, "Conflict", html.clone());
            }
        }
        for (index, choice) in book.model.choices.iter().enumerate() {
            let html = link(&book.choice(index), &choice.question);
            for &target in &choice.at {
                self.target(target, "Not stated", html.clone());
            }
        }
    }

    fn target(&mut self, target: Target, term: &'static str, html: String) {
        let mentions = match target {
            Target::Register(id) => self.registers.entry(id).or_default(),
            Target::Cluster(id) => self.clusters.entry(id).or_default(),
            Target::Joined(index) => self.joined.entry(index).or_default(),
            Target::Field(at) => self.fields.entry(at).or_default(),
            Target::Enum(id) => self.enums.entry(id).or_default(),
            Target::Message(id) => self.messages.entry(id).or_default(),
            Target::Word(id, word) => self.words.entry((id, word)).or_default(),
            Target::WordField(id, word, field) => self.word_fields.entry((id, word, field)).or_default(),
        };
        mentions.push((term, html));
    }
}

/// Every field of every register.
pub(super) fn all_fields(model: &Model) -> impl Iterator<Item = (FieldRef, &regdef::model::Field)> {
    model.registers.iter().enumerate().flat_map(|(r, register)| {
        let at = move |field| FieldRef { register: RegisterId(r), field };
        register.fields.iter().enumerate().map(move |(f, field)| (at(f), field))
    })
}
