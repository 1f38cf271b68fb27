//! Names stay different after they have become identifiers of generated code.

use std::collections::{HashMap, HashSet};

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
    reserved: &'static [&'static str],
    why: &'static str,
    findings: &'a mut Findings,
}

impl<'a> Names<'a> {
    fn new(findings: &'a mut Findings) -> Self {
        Names { seen: HashMap::new(), reserved: &[], why: "", findings }
    }

    /// Names that are taken from the start, and by what.
    fn reserve(mut self, reserved: &'static [&'static str], why: &'static str) -> Self {
        (self.reserved, self.why) = (reserved, why);
        self
    }

    fn add(&mut self, identifier: &str, name: &str, at: &Path) {
        // A name without letters is reported for itself.
        if identifier.is_empty() {
            return;
        }
        let help = "give it another identifier with `name: ...`";
        if self.reserved.contains(&identifier) {
            let title = format!("`{name}` becomes `{identifier}` in generated code, which is {}", self.why);
            self.findings.push(Diagnostic::new(Code::IdentifierClash, Spot::Key(at.clone()), title).help(help));
        } else if let Some((other, first)) = self.seen.get(identifier) {
            self.findings.push(
                Diagnostic::new(
                    Code::IdentifierClash,
                    Spot::Key(at.clone()),
                    format!("`{other}` and `{name}` both become `{identifier}` in generated code"),
                )
                .also(Spot::Key(first.clone()), format!("`{other}`"))
                .help(help),
            );
        } else {
            self.seen.insert(identifier.to_owned(), (name.to_owned(), at.clone()));
        }
    }
}

pub(super) fn clashes(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    types(lowered, findings);
    let mut methods = Names::new(findings);
    // Two registers of one type name are reported already.
    let mut known = HashSet::new();
    for (index, register) in model.registers.iter().enumerate().filter(|(_, r)| r.cluster.is_none()) {
        if !known.insert(&register.ident.pascal) {
            continue;
        }
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
        let mut members = Names::new(findings);
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
    let mut types = Names::new(findings).reserve(&TYPES, "a type of the runtime");
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
    let mut names = Names::new(findings).reserve(&METHODS, "a method of every register value");
    for (field, path) in fields.iter().zip(paths) {
        names.add(&field.ident.snake, &field.name, path);
    }
}
