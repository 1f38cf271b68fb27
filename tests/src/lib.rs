//! What the tests that cross crates have in common.

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod readme {}

use std::path::{Path, PathBuf};

use regdef::model::Model;

/// The root of the workspace.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The descriptions in a folder of the workspace, in order of name; none if there is no such folder.
#[must_use]
pub fn descriptions(folder: &str) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(root().join(folder)) else { return Vec::new() };
    let mut files: Vec<PathBuf> = entries
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "yaml"))
        .collect();
    files.sort();
    files
}

/// The controllers of the project and the small descriptions that each show one feature of the language.
#[must_use]
pub fn all_descriptions() -> Vec<PathBuf> {
    let mut files = descriptions("regdefs");
    files.extend(descriptions("crates/regdef-codegen/tests/features"));
    files
}

/// The model of a description.
///
/// # Panics
/// If the description has errors; the message holds them.
#[must_use]
pub fn model(file: &Path) -> Model {
    let loaded = regdef::load_file(file);
    let findings: Vec<&str> = loaded.findings.iter().map(|finding| finding.title.as_str()).collect();
    match loaded.model {
        Some(model) => model,
        None => panic!("{} has errors: {}", file.display(), findings.join("; ")),
    }
}
