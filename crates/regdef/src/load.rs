//! Loading: read, walk, shape, types, lowering, checks.

use std::fs::File;
use std::io::Read;
use std::path::Path as FilePath;

use crate::check;
use crate::diagnostic::{Code, Diagnostic, Severity, Spot};
use crate::lower::lower;
use crate::model::Model;
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
        return Loaded { source: Source::new(name, ""), findings: vec![too_large(length)], model: None };
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
    let mut findings = Vec::new();
    let (source, tree) = Source::read(name, bytes, &mut findings);
    let Some(tree) = tree else { return Loaded { source, findings, model: None } };
    shape::check(&tree, &mut findings);
    if has_errors(&findings) {
        return Loaded { source, findings, model: None };
    }
    let description = match serde_yaml::from_str::<Description>(source.text()) {
        Ok(description) => description,
        Err(error) => {
            let at = error.location().map_or(0, |location| location.index());
            findings.push(Diagnostic::new(Code::WrongType, Spot::Bytes(at..at), error.to_string()));
            return Loaded { source, findings, model: None };
        }
    };
    let lowered = lower(&description, &mut findings);
    check::check(&lowered, &mut findings);
    let model = (!has_errors(&findings)).then_some(lowered.model);
    Loaded { source, findings, model }
}

fn has_errors(findings: &[Diagnostic]) -> bool {
    findings.iter().any(|f| f.code.severity() == Severity::Error)
}
