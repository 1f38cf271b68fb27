//! Loading of descriptions.

use std::path::{Path, PathBuf};

use regdef::model::Model;

use crate::{project, report};

/// Loads a description and prints what was found; `None` if there were errors.
pub fn load(path: &Path) -> Option<Model> {
    let loaded = regdef::load_file(Path::new(&project::shown(path)));
    report::findings(&loaded);
    loaded.model
}

/// The model of a controller given by name or by path.
pub fn find(name: &str) -> Result<Option<Model>, String> {
    let path = Path::new(name);
    if path.extension().is_some() || path.exists() {
        return Ok(load(path));
    }
    let files = project::descriptions()?;
    let wanted = name.replace('-', "_");
    let stem = |file: &PathBuf| file.file_stem().map(|s| s.to_string_lossy().replace('-', "_")).unwrap_or_default();
    match files.iter().find(|file| stem(file) == wanted) {
        Some(file) => Ok(load(file)),
        None => {
            let known = files.iter().map(stem).collect::<Vec<_>>().join(", ");
            Err(format!("there is no controller `{name}`; known are {known}"))
        }
    }
}

/// `cargo xtask check`.
pub fn check(files: &[PathBuf]) -> Result<bool, String> {
    let files = if files.is_empty() { project::descriptions()? } else { files.to_vec() };
    let mut good = true;
    for file in files {
        match load(&file) {
            Some(model) => {
                let fields: usize = model.registers.iter().map(|r| r.fields.len()).sum();
                let physical = model.instances_of_registers().len();
                anstream::println!(
                    "{}: {} registers described, {physical} in the block, {fields} fields, {} messages, {} conflicts, {} choices",
                    project::shown(&file),
                    model.registers.len(),
                    model.messages.len(),
                    model.conflicts.len(),
                    model.choices.len(),
                );
            }
            None => good = false,
        }
    }
    Ok(good)
}
