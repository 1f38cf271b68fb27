//! The shape of a description against the schema that is derived from the language's types.

mod forms;

use std::sync::LazyLock;

use jsonschema::error::ValidationErrorKind;
use jsonschema::{ValidationError, Validator};
use serde_json::Value;

use crate::diagnostic::{Code, Diagnostic, Findings, Spot, suggestion};
use crate::path::Path;
use crate::source::Source;
use crate::syntax::{Description, Int};

/// The JSON schema of the language, for editors and for the check of shape.
#[must_use]
pub fn schema() -> Value {
    let mut schema = schemars::schema_for!(Description).to_value();
    limits(&mut schema);
    schema
}

/// States the limits of the integer types, which the derived schema names as a `format` only.
fn limits(schema: &mut Value) {
    match schema {
        Value::Array(items) => items.iter_mut().for_each(limits),
        Value::Object(members) => {
            let (low, high) = match members.get("format").and_then(Value::as_str) {
                Some("uint32") => (0, i64::from(u32::MAX)),
                Some("int64") => (i64::MIN, i64::MAX),
                _ => return members.values_mut().for_each(limits),
            };
            members.entry("minimum").or_insert(low.into());
            members.entry("maximum").or_insert(high.into());
        }
        _ => {}
    }
}

static SCHEMA: LazyLock<Value> = LazyLock::new(schema);

static VALIDATOR: LazyLock<Validator> =
    LazyLock::new(|| jsonschema::validator_for(&SCHEMA).expect("the schema is made from our own types"));

/// Reports every unknown key, missing key and value of the wrong form.
pub(crate) fn check(tree: &Value, source: &Source, findings: &mut Findings) {
    for error in VALIDATOR.iter_errors(tree) {
        explain(&error, source, findings);
    }
}

fn explain(error: &ValidationError<'_>, source: &Source, findings: &mut Findings) {
    let at = Path::from_pointer(error.instance_path().as_str());
    match error.kind() {
        ValidationErrorKind::AdditionalProperties { unexpected } => {
            let known = keys_at(error, "properties");
            for key in unexpected {
                // Further ones are only counted.
                let names = if findings.full() { &[] } else { &known[..] };
                findings.push(unknown_key(&at, key, names));
            }
        }
        ValidationErrorKind::Required { property } => {
            let key = property.as_str().unwrap_or_default();
            let meaning = description_of(error, key);
            findings.push(
                Diagnostic::new(Code::MissingKey, Spot::Key(at.clone()), format!("{} has no `{key}`", subject(&at)))
                    .label(format!("`{key}` is missing here"))
                    .maybe_help(meaning.map(|text| format!("`{key}`: {text}"))),
            );
        }
        ValidationErrorKind::AnyOf { context } | ValidationErrorKind::OneOfNotValid { context } => {
            match best_branch(context, &at) {
                Some(branch) => {
                    for inner in branch {
                        explain(inner, source, findings);
                    }
                }
                None => wrong_form(&at, error, source, findings),
            }
        }
        ValidationErrorKind::Minimum { limit } => {
            findings.push(out_of_range(&at, source, &format!("at least {limit}")));
        }
        ValidationErrorKind::Maximum { limit } => {
            findings.push(out_of_range(&at, source, &format!("at most {limit}")));
        }
        ValidationErrorKind::Enum { .. } | ValidationErrorKind::Type { .. } => {
            wrong_form(&at, error, source, findings);
        }
        ValidationErrorKind::PropertyNames { error: inner } => {
            let key = inner.instance().as_str().unwrap_or_default().to_owned();
            findings.push(
                Diagnostic::new(Code::WrongType, Spot::Key(at.key(&key)), format!("`{key}` cannot be a key here"))
                    .help(format!("a key here is {}", forms::of(schema_of(inner)).join(" or "))),
            );
        }
        _ => findings.push(Diagnostic::new(Code::WrongType, Spot::Value(at), error.to_string())),
    }
}

/// Among the forms a value may take, the one its author meant: same JSON type, and errors further inside.
fn best_branch<'a>(
    context: &'a [Vec<ValidationError<'static>>],
    at: &Path,
) -> Option<&'a Vec<ValidationError<'static>>> {
    let here = |e: &ValidationError<'_>| Path::from_pointer(e.instance_path().as_str()) == *at;
    let of_another_form = |e: &ValidationError<'static>| match e.kind() {
        _ if !here(e) => false,
        ValidationErrorKind::Type { .. }
        | ValidationErrorKind::Pattern { .. }
        | ValidationErrorKind::Constant { .. }
        | ValidationErrorKind::Enum { .. } => true,
        ValidationErrorKind::AnyOf { context } | ValidationErrorKind::OneOfNotValid { context } => {
            best_branch(context, at).is_none()
        }
        _ => false,
    };
    // What is wrong at the place itself, such as an unknown key, tells more than what is wrong further inside.
    let here_count = |e: &ValidationError<'_>| match e.kind() {
        _ if !here(e) => 0,
        ValidationErrorKind::AdditionalProperties { unexpected } => unexpected.len(),
        _ => 1,
    };
    context
        .iter()
        .filter(|branch| !branch.is_empty() && !branch.iter().any(of_another_form))
        .min_by_key(|branch| (branch.iter().map(here_count).sum::<usize>(), branch.len()))
}

fn unknown_key(at: &Path, key: &str, known: &[String]) -> Diagnostic {
    let known_text = known.iter().map(|k| format!("`{k}`")).collect::<Vec<_>>().join(", ");
    let hint = suggestion(key, known.iter().map(String::as_str));
    Diagnostic::new(Code::UnknownKey, Spot::Key(at.key(key)), format!("{} has no key `{key}`", kind_of(at)))
        .label(hint.unwrap_or_else(|| "unknown key".to_owned()))
        .help(format!("the keys here are {known_text}"))
}

fn wrong_form(at: &Path, error: &ValidationError<'_>, source: &Source, findings: &mut Findings) {
    let finding = wrong_type(at, error, source);
    // A number that YAML reads as something that nothing here takes is reported already.
    let reported = source.range(&finding.labels[0].at).is_some_and(|range| findings.has_at(&range));
    if !reported {
        findings.push(finding);
    }
}

fn wrong_type(at: &Path, error: &ValidationError<'_>, source: &Source) -> Diagnostic {
    let found = error.instance().as_ref();
    if *at == Path::root() {
        return Diagnostic::new(
            Code::WrongType,
            Spot::Value(at.clone()),
            "the file holds no mapping of keys and values",
        )
        .help("start with `controller: NAME`; the language's reference page has a worked example");
    }
    let name = at.last();
    let name = if name.bytes().all(|b| b.is_ascii_digit()) { at.parent().last() } else { name };
    let (title, spot) = match found {
        Value::Null => (format!("`{name}` has no value"), Spot::Key(at.clone())),
        Value::Object(_) => (format!("a mapping is no value of `{name}`"), Spot::Value(at.clone())),
        Value::Array(_) => (format!("a list is no value of `{name}`"), Spot::Value(at.clone())),
        _ => (format!("`{}` is no value of `{name}`", text_at(at, source)), Spot::Value(at.clone())),
    };
    let forms = forms::of(schema_of(error));
    let words: Vec<&str> = forms.iter().flat_map(|form| form.split('`').skip(1).step_by(2)).collect();
    let label = match found {
        Value::Number(_) | Value::Bool(_) if forms.iter().any(|form| form == forms::TEXT) => {
            format!("write \"{}\" if text is meant", text_at(at, source))
        }
        Value::String(text) if forms.iter().any(|form| form == forms::WHOLE) && Int::parse(text).is_some() => {
            format!("write {} without quotes and underscores", text.replace('_', ""))
        }
        Value::String(text) => suggestion(text, words.iter().copied()).unwrap_or_default(),
        _ => String::new(),
    };
    Diagnostic::new(Code::WrongType, spot, title).label(label).help(format!("it has to be {}", forms.join(", or ")))
}

fn out_of_range(at: &Path, source: &Source, limit: &str) -> Diagnostic {
    Diagnostic::new(Code::OutOfRange, Spot::Value(at.clone()), format!("`{}` is {}", at.last(), text_at(at, source)))
        .label(format!("has to be {limit}"))
}

/// A scalar as its author wrote it, quotes included.
fn text_at<'a>(at: &Path, source: &'a Source) -> &'a str {
    source.range(&Spot::Value(at.clone())).map_or("", |range| &source.text()[range])
}

/// The mapping a path ends in, in words: "the register `CCCR`".
fn subject(at: &Path) -> String {
    let name = at.last();
    if *at == Path::root() {
        return "the description".to_owned();
    }
    match at.parent().last().as_str() {
        "registers" => format!("the register `{name}`"),
        "fields" => format!("the field `{name}`"),
        "clusters" => format!("the cluster `{name}`"),
        "messages" => format!("the message `{name}`"),
        "words" => format!("the word `{name}`"),
        "conflicts" => "this conflict".to_owned(),
        "choices" => "this choice".to_owned(),
        _ => format!("`{name}`"),
    }
}

/// What kind of mapping a path ends in: "a register".
fn kind_of(at: &Path) -> String {
    if *at == Path::root() {
        return "a description".to_owned();
    }
    match at.parent().last().as_str() {
        "registers" => "a register".to_owned(),
        "fields" => "a field".to_owned(),
        "clusters" => "a cluster".to_owned(),
        "messages" => "a message".to_owned(),
        "words" => "a word of a message".to_owned(),
        _ => format!("`{}`", at.last()),
    }
}

/// The schema that an error's keyword stands in.
fn schema_of<'a>(error: &ValidationError<'_>) -> Option<&'a Value> {
    let location = error.schema_path().as_str();
    let keyword_parent = location.rsplit_once('/').map_or("", |(parent, _)| parent);
    SCHEMA.pointer(keyword_parent).or_else(|| follow(location))
}

/// Walks a schema location that passes through `$ref`s.
fn follow<'a>(location: &str) -> Option<&'a Value> {
    let mut node: &Value = &SCHEMA;
    let mut steps: Vec<_> = location.split('/').skip(1).collect();
    steps.pop();
    for step in steps {
        if step == "$ref" {
            node = SCHEMA.pointer(node.get("$ref")?.as_str()?.strip_prefix('#')?)?;
            continue;
        }
        let step = step.replace("~1", "/").replace("~0", "~");
        node = match node {
            Value::Array(items) => items.get(step.parse::<usize>().ok()?)?,
            other => other.get(&step)?,
        };
    }
    Some(node)
}

fn keys_at(error: &ValidationError<'_>, member: &str) -> Vec<String> {
    let schema = schema_of(error);
    let properties = schema.and_then(|s| s.get(member)).and_then(Value::as_object);
    properties.into_iter().flat_map(|p| p.keys().cloned()).collect()
}

fn description_of(error: &ValidationError<'_>, key: &str) -> Option<String> {
    let text = schema_of(error)?.get("properties")?.get(key)?.get("description")?.as_str()?;
    Some(text.replace('\n', " "))
}
