//! What the tests of the emitters share: the small descriptions, one per feature of the language.

use std::fs;
use std::path::PathBuf;

use regdef::model::Model;

/// Every small description by name, in order of name.
pub fn features() -> Vec<(String, Model)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/features");
    let mut files: Vec<PathBuf> = fs::read_dir(&folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .map(|entry| entry.expect("the folder can be listed").path())
        .filter(|path| path.extension().is_some_and(|e| e == "yaml"))
        .collect();
    files.sort();
    files.iter().map(|path| (path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), load(path))).collect()
}

/// A description that has no errors.
pub fn load(path: &std::path::Path) -> Model {
    let loaded = regdef::load_file(path);
    loaded.model.unwrap_or_else(|| panic!("{}: {:#?}", path.display(), loaded.findings))
}
