//! The search index: everything that has a name, as a script that works without a server.

use regdef::model::{ConditionId, EnumId, FieldRef, InterruptId, LineId, MessageId, RegisterId, Target};
use serde_json::{Value, json};

use super::book::{Book, label};
use super::field::shown_name;
use super::overview::pages;

/// Kinds of entries, in the order in which equal matches are shown.
const KINDS: [&str; 14] = [
    "controller",
    "register",
    "field",
    "enumeration",
    "message",
    "word",
    "condition",
    "interrupt",
    "joined value",
    "memory",
    "chip",
    "conflict",
    "not stated",
    "page",
];

/// The index of the whole site: `REGDEF_INDEX = {kinds, controllers, entries}`, each entry being
/// `[kind, controller, name, title, url, text]`.
pub(super) fn index(books: &[Book<'_>], language: &[(String, String, String)]) -> String {
    let mut entries = Vec::new();
    for (number, book) in books.iter().enumerate() {
        let mut all = Entries { book, number, entries: &mut entries };
        all.registers();
        all.layouts();
        all.rest();
    }
    let page = KINDS.len() - 1;
    for (name, url, text) in language {
        entries.push(json!([page, -1, name, "Description language", url, text]));
    }
    let controllers: Vec<_> = books.iter().map(|b| json!([b.folder(), b.model.title])).collect();
    let mut script = format!(
        "window.REGDEF_INDEX={{\"kinds\":{},\"controllers\":{},\"entries\":[\n",
        json!(KINDS),
        json!(controllers)
    );
    let lines: Vec<_> = entries.iter().map(Value::to_string).collect();
    script += &lines.join(",\n");
    script += "\n]};\n";
    // A line separator is a line end to old scripts, even in a string.
    script.replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029")
}

struct Entries<'a, 'b> {
    book: &'a Book<'b>,
    number: usize,
    entries: &'a mut Vec<Value>,
}

impl Entries<'_, '_> {
    fn add(&mut self, kind: &str, name: &str, title: &str, url: &str, text: &str) {
        let kind = KINDS.iter().position(|k| *k == kind).expect("the kinds are those of the table above");
        let url = format!("{}/{url}", self.book.folder());
        self.entries.push(json!([kind, self.number, name, title, url, text.trim_start_matches(" ·").trim()]));
    }

    fn values(&self, id: Option<EnumId>) -> String {
        let names =
            id.map(|id| self.book.model.enumeration(id).variants.iter().map(|v| v.name.as_str()).collect::<Vec<_>>());
        names.map(|n| format!(" · {}", n.join(" "))).unwrap_or_default()
    }

    fn registers(&mut self) {
        let book = self.book;
        let model = book.model;
        self.add("controller", &model.names.id, &model.title, "index.html", &model.doc);
        for (index, register) in model.registers.iter().enumerate() {
            let id = RegisterId(index);
            self.add("register", &label(model, register), &register.title, &book.register(id), &register.doc);
            for (field, one) in register.fields.iter().enumerate() {
                let at = FieldRef { register: id, field };
                let name = format!("{}.{}", register.name, shown_name(one));
                let text = format!("{}{}", one.doc, self.values(one.enumeration()));
                self.add("field", &name, &register.title, &book.field(at), &text);
            }
        }
    }

    fn layouts(&mut self) {
        let book = self.book;
        let model = book.model;
        for (m, message) in model.messages.iter().enumerate() {
            let id = MessageId(m);
            self.add("message", &message.name, &message.title, &book.message(id), &message.doc);
            for (w, word) in message.words.iter().enumerate() {
                let name = format!("{}.{}", message.name, word.name);
                self.add("word", &name, &message.title, &book.word(id, w), &word.doc);
                for (f, field) in word.fields.iter().enumerate() {
                    let (url, _) = book.target(Target::WordField(id, w, f));
                    let text = format!("{}{}", field.doc, self.values(field.enumeration()));
                    self.add("field", &format!("{name}.{}", shown_name(field)), &message.title, &url, &text);
                }
            }
        }
        for (index, section) in model.memory.sections.iter().enumerate() {
            self.add("memory", &section.name, "Section of the message memory", &book.section(index), &section.doc);
        }
    }

    fn rest(&mut self) {
        let book = self.book;
        let model = book.model;
        for (index, one) in model.enums.iter().enumerate() {
            let text = format!("{}{}", one.doc, self.values(Some(EnumId(index))));
            self.add("enumeration", &one.name, "", &book.enumeration(EnumId(index)), &text);
        }
        for (index, one) in model.conditions.iter().enumerate() {
            self.add("condition", &one.name, &one.text, &book.condition(ConditionId(index)), &one.doc);
        }
        for (index, one) in model.interrupts.lines.iter().enumerate() {
            self.add("interrupt", &one.name, "Interrupt line", &book.line(LineId(index)), &one.doc);
        }
        for (index, one) in model.interrupts.sources.iter().enumerate() {
            self.add("interrupt", &one.name, "Interrupt source", &book.interrupt(InterruptId(index)), &one.doc);
        }
        for (index, one) in model.joined.iter().enumerate() {
            self.add("joined value", &one.name, "", &book.joined(index), &one.doc);
        }
        for (index, one) in model.instances.iter().enumerate() {
            let text = format!("{} {}", one.chips.join(" "), one.doc);
            self.add("chip", &one.name, &format!("base {:#010x}", one.base), &book.instance(index), &text);
        }
        for (index, one) in model.conflicts.iter().enumerate() {
            let text = format!("{} {}", one.taken, one.because);
            self.add("conflict", &one.id, &one.what, &book.conflict(index), &text);
        }
        for (index, one) in model.choices.iter().enumerate() {
            self.add("not stated", &one.id, &one.question, &book.choice(index), &one.choice);
        }
        for (url, title, _) in pages(model) {
            self.add("page", title, &model.title, url, "");
        }
    }
}
