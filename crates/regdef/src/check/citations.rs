//! Every fact says where it stands, and every description says something.

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;
use crate::model::Cite;
use crate::path::Path;

pub(super) fn present(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    let mut need = |cites: &[Cite], what: &str, name: &str, at: Path| {
        if cites.is_empty() {
            findings.push(
                Diagnostic::new(Code::NoCitation, Spot::Key(at), format!("the {what} `{name}` has no citation"))
                    .label("`cite` is missing here")
                    .help("say where it stands: `cite: {section: \"2.3.7\", page: 11}`, or name an external `source`"),
            );
        }
    };
    for (register, origin) in model.registers.iter().zip(&lowered.registers) {
        need(&register.cites, "register", &register.name, origin.path.clone());
        if register.cites.is_empty() {
            continue;
        }
        for (field, path) in register.fields.iter().zip(&origin.fields) {
            need(&field.cites, "field", &field.name, path.clone());
        }
    }
    for cluster in &model.clusters {
        need(&cluster.cites, "cluster", &cluster.name, Path::root().key("clusters").key(&cluster.name));
    }
    for message in &model.messages {
        need(&message.cites, "message", &message.name, Path::root().key("messages").key(&message.name));
    }
    for window in &model.windows {
        need(&window.cites, "window", &window.name, Path::root().key("windows").key(&window.name));
    }
    docs(lowered, findings);
}

fn docs(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    let mut empty = |doc: &str, what: &str, at: &Path| {
        if doc.trim().is_empty() {
            findings.push(
                Diagnostic::new(Code::EmptyDoc, Spot::Key(at.clone()), format!("nothing is said about {what}"))
                    .help("write one sentence in `doc`: what it means to whoever programs it"),
            );
        }
    };
    for (register, origin) in model.registers.iter().zip(&lowered.registers) {
        empty(&register.doc, &format!("the register `{}`", register.name), &origin.path);
        for (field, path) in register.fields.iter().zip(&origin.fields) {
            empty(&field.doc, &format!("`{}.{}`", register.name, field.name), path);
        }
    }
    for (message, origins) in model.messages.iter().zip(&lowered.words) {
        for (word, origin) in message.words.iter().zip(origins) {
            for (field, path) in word.fields.iter().zip(&origin.fields) {
                empty(&field.doc, &format!("`{}.{}.{}`", message.name, word.name, field.name), path);
            }
        }
    }
}
