//! `cargo xtask codegen`, `schema` and `docs`.

use std::path::Path;

use regdef::model::Model;
use regdef_codegen::OutputFile;

use crate::artefacts::Artefacts;
use crate::{descriptions, project};

/// Everything from regdefs/.
pub fn project(check: bool) -> Result<bool, String> {
    let root = project::root();
    let mut models = Vec::new();
    let mut good = true;
    for file in project::descriptions()? {
        match descriptions::load(&file) {
            Some(model) => models.push(model),
            None => good = false,
        }
    }
    if !good {
        return Ok(false);
    }
    // Everything is made before anything is written: an error leaves no half of a new state.
    let made: Vec<_> = models.iter().map(|model| Ok((model, package(model)?))).collect::<Result<_, String>>()?;
    let mut artefacts = Artefacts::new(check);
    artefacts.file(&root.join("regdefs/schema.json"), &schema_text())?;
    for (model, files) in &made {
        write_package(&mut artefacts, &root.join("crates").join(&model.names.krate), files)?;
    }
    Ok(artefacts.summary())
}

/// A description of a user's own.
pub fn single(file: &Path, out: &Path, check: bool) -> Result<bool, String> {
    let Some(model) = descriptions::load(file) else { return Ok(false) };
    let files = package(&model)?;
    let mut artefacts = Artefacts::new(check);
    write_package(&mut artefacts, out, &files)?;
    let manifest = out.join("Cargo.toml");
    if !manifest.exists() {
        artefacts.file(&manifest, &regdef_codegen::rust::manifest(&model))?;
    }
    Ok(artefacts.summary())
}

/// The schema alone.
pub fn schema() -> Result<bool, String> {
    let mut artefacts = Artefacts::new(false);
    artefacts.file(&project::root().join("regdefs/schema.json"), &schema_text())?;
    Ok(artefacts.summary())
}

/// The references alone.
pub fn docs() -> Result<bool, String> {
    Err("not there yet".to_owned())
}

fn schema_text() -> String {
    format!("{:#}\n", regdef::schema())
}

/// All files of a generated crate.
fn package(model: &Model) -> Result<Vec<OutputFile>, String> {
    let mut files = regdef_codegen::rust::crate_files(model)?;
    let svd = regdef_codegen::svd::svd(model).map_err(|error| format!("{}: {error}", model.names.id))?;
    files.push(OutputFile { path: format!("svd/{}.svd", model.names.id), content: svd });
    Ok(files)
}

fn write_package(artefacts: &mut Artefacts, folder: &Path, files: &[OutputFile]) -> Result<(), String> {
    for file in files {
        artefacts.file(&folder.join(&file.path), &file.content)?;
    }
    for generated in ["src", "include", "svd"] {
        artefacts.sweep(&folder.join(generated))?;
    }
    Ok(())
}
