//! What the model says of valid descriptions, one for each part of the language, in `tests/features`.
#![allow(clippy::unwrap_used)]

mod behaviour;
mod registers;

use std::fs;
use std::path::{Path, PathBuf};

use annotate_snippets::Renderer;
use regdef::diagnostic::report;
use regdef::load_file;
use regdef::model::*;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/features")
}

fn descriptions() -> impl Iterator<Item = PathBuf> {
    let files = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|path| path.extension().is_some_and(|extension| extension == "yaml"))
}

fn load(name: &str) -> Model {
    let path = folder().join(name).with_extension("yaml");
    let loaded = load_file(&path);
    assert!(loaded.findings.is_empty(), "{}", report(&loaded.findings, &loaded.source, &Renderer::plain()));
    loaded.model.unwrap()
}

fn register<'a>(model: &'a Model, name: &str) -> &'a Register {
    model.registers.iter().find(|r| r.name == name).unwrap()
}

fn field<'a>(model: &'a Model, path: &str) -> &'a Field {
    let (holder, name) = path.split_once('.').unwrap();
    register(model, holder).field(name).unwrap()
}

fn place(model: &Model, path: &str) -> FieldRef {
    let (holder, name) = path.split_once('.').unwrap();
    let register = model.registers.iter().position(|r| r.name == holder).unwrap();
    FieldRef {
        register: RegisterId(register),
        field: model.registers[register].fields.iter().position(|f| f.name == name).unwrap(),
    }
}

fn notation(model: &Model, path: &str) -> String {
    field(model, path).access.notation(|id| model.condition(id).name.clone())
}

fn shown(model: &Model, condition: Option<ConditionId>) -> String {
    model.condition(condition.unwrap()).expr.display(model)
}

#[test]
fn every_feature_loads_without_a_finding() {
    let mut count = 0;
    for path in descriptions() {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let model = load(&name);
        assert_eq!(format!("{}.yaml", model.names.id), name);
        count += 1;
    }
    assert!(count >= 10, "only {count} descriptions");
}
#[test]
fn yaml_may_be_written_in_any_style() {
    let model = load("unusual_yaml");
    assert_eq!(model.title, "Unusual YAML, folded over lines");
    assert_eq!(model.doc, "A literal block: with \"quotes\", # no comment,\n  and indentation.\n");
    assert_eq!((model.span, model.access_widths.as_slice()), (4, &[32][..]));
    assert_eq!(model.manual.publisher, "It's nobody");
    assert_eq!(register(&model, "CTRL").title, "Title");
    assert_eq!(register(&model, "CTRL").doc, "plain text that goes on");
    assert_eq!(field(&model, "CTRL.RUN").doc, "宽字符 and 🙂 are text.");
}

#[test]
fn targets_are_of_every_kind() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/features/messages.yaml")).unwrap();
    let targets = "RXF0C, RXF0C.EN, address, length, TX, TX.T1, TX.T1.MM";
    let conflict = format!(
        "conflicts:\n  - {{id: all, at: [{targets}], what: w, says: [{{cite: {{section: '1'}}, says: a}}], taken: a, because: b}}\n"
    );
    let loaded = regdef::load_str("messages.yaml", &(text + &conflict));
    let model = loaded.model.unwrap();
    let (tx, first) = (MessageId(0), RegisterId(0));
    let expected = [
        Target::Register(first),
        Target::Field(FieldRef { register: first, field: 3 }),
        Target::Joined(0),
        Target::Enum(EnumId(0)),
        Target::Message(tx),
        Target::Word(tx, 1),
        Target::WordField(tx, 1, 1),
    ];
    assert_eq!(model.conflicts[0].at, expected);
}

#[test]
fn the_schema_accepts_what_loads() {
    let schema = regdef::schema();
    let validator = jsonschema::validator_for(&schema).unwrap();
    for path in descriptions() {
        let tree: serde_json::Value = serde_yaml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        assert!(validator.is_valid(&tree), "{}", path.display());
    }
}
