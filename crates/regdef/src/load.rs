//! Loading: read, walk, shape, types, lowering, checks.

use std::fs::File;
use std::io::Read;
use std::path::Path as FilePath;

use crate::check;
use crate::diagnostic::{Code, Diagnostic, Findings, Severity, Spot};
use crate::lower::lower;
use crate::model::Model;
use crate::path::Path;
use crate::shape;
use crate::source::{MAX_BYTES, Source, too_large};
use crate::syntax::Description;

/// What came of a file.
#[derive(Debug)]
pub struct Loaded {
    /// The text, for rendering the findings.
    pub source: Source,
    /// Everything there is to say about the file.
    pub findings: Vec<Diagnostic>,
    /// The model; `None` if there is an error among the findings.
    pub model: Option<Model>,
}

impl Loaded {
    /// Number of errors and of warnings.
    #[must_use]
    pub fn counts(&self) -> (usize, usize) {
        let errors = self.findings.iter().filter(|f| f.code.severity() == Severity::Error).count();
        (errors, self.findings.len() - errors)
    }
}

/// Loads a description from a file. Reads no more than [`MAX_BYTES`].
#[must_use]
pub fn load_file(path: &FilePath) -> Loaded {
    let name = path.display().to_string();
    let unreadable = |error: &std::io::Error| Loaded {
        source: Source::new(name.clone(), ""),
        findings: vec![
            Diagnostic::new(Code::Unreadable, Spot::File, format!("the file cannot be read: {error}"))
                .help("give the path of a description, such as regdefs/m_can.yaml"),
        ],
        model: None,
    };
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) => return unreadable(&error),
    };
    let length = file.metadata().map_or(0, |meta| meta.len());
    if length > MAX_BYTES {
        let findings = vec![too_large(&format!("has {length} bytes"))];
        return Loaded { source: Source::new(name, ""), findings, model: None };
    }
    let mut bytes = Vec::new();
    if let Err(error) = file.take(MAX_BYTES + 1).read_to_end(&mut bytes) {
        return unreadable(&error);
    }
    load_bytes(&name, &bytes)
}

/// Loads a description from a text.
#[must_use]
pub fn load_str(name: &str, text: &str) -> Loaded {
    load_bytes(name, text.as_bytes())
}

/// Loads a description from bytes that need not be text.
#[must_use]
pub fn load_bytes(name: &str, bytes: &[u8]) -> Loaded {
    let mut findings = Findings::default();
    let (source, tree) = Source::read(name, bytes, &mut findings);
    let model = tree.and_then(|tree| {
        shape::check(&tree, &source, &mut findings);
        if findings.has_errors() {
            return None;
        }
        let description = typed(&source, &tree, &mut findings)?;
        let lowered = lower(&description, &mut findings);
        check::check(&lowered, &mut findings);
        (!findings.has_errors()).then_some(lowered.model)
    });
    Loaded { source, findings: findings.finish(), model }
}

/// The typed description. serde_yaml reads YAML 1.1, the walk YAML 1.2: what they read differently is refused,
/// because the positions and the checks of shape would belong to another text than the one that is used.
fn typed(source: &Source, tree: &serde_json::Value, findings: &mut Findings) -> Option<Description> {
    let wrong = |error: &serde_yaml::Error| {
        let at = error.location().map_or(0, |location| {
            let line = source.line(location.line().saturating_sub(1));
            let column = location.column().saturating_sub(1);
            source.text()[line.clone()].char_indices().nth(column).map_or(line.end, |(at, _)| line.start + at)
        });
        Diagnostic::new(Code::Syntax, Spot::Bytes(at..at), format!("this cannot be read: {error}"))
    };
    let value: serde_yaml::Value = match serde_yaml::from_str(source.text()) {
        Ok(value) => value,
        Err(error) => {
            findings.push(wrong(&error).help("write it in a simpler form of YAML, or quote the text"));
            return None;
        }
    };
    if let Some(at) = difference(&value, tree, &Path::root()) {
        findings.push(
            Diagnostic::new(Code::Syntax, Spot::Value(at), "readers of YAML 1.1 and of YAML 1.2 do not agree on this")
                .help("quote the text, or write it on one line"),
        );
        return None;
    }
    match serde_yaml::from_value(value) {
        Ok(description) => Some(description),
        Err(error) => {
            // Only the reading from the text knows a place.
            let located = serde_yaml::from_str::<Description>(source.text()).err().unwrap_or(error);
            findings.push(wrong(&located));
            None
        }
    }
}

/// The first place where two readings of the file are not the same.
fn difference(yaml: &serde_yaml::Value, json: &serde_json::Value, at: &Path) -> Option<Path> {
    use serde_json::Value as Json;
    use serde_yaml::Value as Yaml;
    let same = match (yaml, json) {
        (Yaml::Null, Json::Null) => true,
        (Yaml::Bool(a), Json::Bool(b)) => a == b,
        (Yaml::String(a), Json::String(b)) => a == b,
        (Yaml::Number(a), Json::Number(b)) => (a.as_u64(), a.as_i64()) == (b.as_u64(), b.as_i64()),
        (Yaml::Sequence(a), Json::Array(b)) if a.len() == b.len() => {
            return a.iter().zip(b).enumerate().find_map(|(index, (a, b))| difference(a, b, &at.index(index)));
        }
        (Yaml::Mapping(a), Json::Object(b)) if a.len() == b.len() => {
            return a.iter().find_map(|(key, value)| {
                let key = match key {
                    Yaml::String(key) => key.clone(),
                    Yaml::Number(number) => number.to_string(),
                    _ => return Some(at.clone()),
                };
                b.get(&key).map_or_else(|| Some(at.clone()), |other| difference(value, other, &at.key(&key)))
            });
        }
        _ => false,
    };
    (!same).then(|| at.clone())
}
