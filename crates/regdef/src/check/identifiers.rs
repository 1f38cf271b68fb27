//! Names stay different after they have become identifiers of generated code.

use std::collections::HashMap;

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;
use crate::model::Field;
use crate::path::Path;

/// Names the generated Rust needs for itself.
const TYPES: [&str; 12] =
    ["Reg", "Mmio", "Bus", "Register", "Readable", "Writable", "Modify", "Clear", "Request", "Pure", "Alias", "Word"];
const METHODS: [&str; 10] =
    ["bits", "from_bits", "contains", "is_empty", "reset", "eq", "fmt", "clone", "read", "write"];

struct Names<'a> {
    seen: HashMap<String, (String, Path)>,
    findings: &'a mut Findings,
}

impl Names<'_> {
    fn add(&mut self, identifier: &str, name: &str, at: &Path) {
        if let Some((other, first)) = self.seen.get(identifier) {
            self.findings.push(
                Diagnostic::new(
                    Code::IdentifierClash,
                    Spot::Key(at.clone()),
                    format!("`{other}` and `{name}` both become `{identifier}` in generated code"),
                )
                .also(Spot::Key(first.clone()), format!("`{other}`"))
                .help("give one of them another identifier with `name: ...`"),
            );
        } else {
            self.seen.insert(identifier.to_owned(), (name.to_owned(), at.clone()));
        }
    }

    fn reserve(&mut self, identifiers: &[&str], why: &str) {
        for identifier in identifiers {
            self.seen.insert((*identifier).to_owned(), (why.to_owned(), Path::root()));
        }
    }
}

pub(super) fn clashes(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    types(lowered, findings);
    let mut methods = Names { seen: HashMap::new(), findings };
    for (index, register) in model.registers.iter().enumerate().filter(|(_, r)| r.cluster.is_none()) {
        methods.add(&register.ident.snake, &register.name, &lowered.registers[index].path);
    }
    for cluster in &model.clusters {
        methods.add(&cluster.ident.snake, &cluster.name, &Path::root().key("clusters").key(&cluster.name));
    }
    for joined in model.joined.iter().filter(|j| j.cluster.is_none()) {
        methods.add(&joined.ident.snake, &joined.name, &Path::root().key("joined").key(&joined.name));
    }
    for (id, cluster) in model.clusters.iter().enumerate() {
        let base = Path::root().key("clusters").key(&cluster.name);
        let mut members = Names { seen: HashMap::new(), findings };
        for (index, register) in
            model.registers.iter().enumerate().filter(|(_, r)| r.cluster.is_some_and(|c| c.0 == id))
        {
            let ident = register.ident.within(&cluster.ident);
            members.add(&ident.snake, &register.name, &lowered.registers[index].path);
        }
        for joined in model.joined.iter().filter(|j| j.cluster.is_some_and(|c| c.0 == id)) {
            let ident = joined.ident.within(&cluster.ident);
            members.add(&ident.snake, &joined.name, &base.key("joined").key(&joined.name));
        }
    }
    for (register, origin) in model.registers.iter().zip(&lowered.registers) {
        fields(&register.fields, &origin.fields, findings);
    }
    for (message, origins) in model.messages.iter().zip(&lowered.words) {
        for (word, origin) in message.words.iter().zip(origins) {
            fields(&word.fields, &origin.fields, findings);
        }
    }
}

fn types(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    let mut types = Names { seen: HashMap::new(), findings };
    types.reserve(&TYPES, "a type of the generated code");
    types.add(&model.names.ident.pascal, &model.names.id, &Path::root().key("controller"));
    for (register, origin) in model.registers.iter().zip(&lowered.registers) {
        types.add(&register.ident.pascal, &register.name, &origin.path);
    }
    for cluster in &model.clusters {
        types.add(&cluster.ident.pascal, &cluster.name, &Path::root().key("clusters").key(&cluster.name));
    }
    for (entry, path) in model.enums.iter().zip(&lowered.enums) {
        types.add(&entry.ident.pascal, &entry.name, path);
    }
    for window in &model.windows {
        let name = format!("{}Window", window.ident.pascal);
        types.add(&name, &window.name, &Path::root().key("windows").key(&window.name));
    }
    for message in &model.messages {
        let at = Path::root().key("messages").key(&message.name);
        types.add(&message.ident.pascal, &message.name, &at);
        for word in message.words.iter().filter(|w| w.same_as.is_none()) {
            types.add(&word.ident.pascal, &word.name, &at.key("words").key(&word.name));
        }
    }
}

fn fields(fields: &[Field], paths: &[Path], findings: &mut Findings) {
    let mut names = Names { seen: HashMap::new(), findings };
    names.reserve(&METHODS, "a method of every register value");
    for (field, path) in fields.iter().zip(paths) {
        names.add(&field.ident.snake, &field.name, path);
    }
}
