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
    artefacts.file(&root.join("docs/language.md"), &regdef_codegen::language::page())?;
    for (model, files) in &made {
        write_package(&mut artefacts, &root.join("crates").join(&model.names.krate), files)?;
    }
    let good = artefacts.summary();
    if !check {
        reference(&models.iter().collect::<Vec<_>>(), &root.join("target/reference"))?;
    }
    Ok(good)
}

/// Writes the HTML reference, which is not committed and so is no part of a check.
fn reference(models: &[&Model], folder: &Path) -> Result<(), String> {
    let mut artefacts = Artefacts::new(false);
    for file in regdef_codegen::html::site(models) {
        artefacts.file(&folder.join(&file.path), &file.content)?;
    }
    artefacts.sweep(folder)?;
    anstream::println!("HTML reference: {} ({})", project::shown(&folder.join("index.html")), artefacts.counts());
    Ok(())
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
    let good = artefacts.summary();
    if !check {
        reference(&[&model], &out.join("reference"))?;
    }
    Ok(good)
}

/// The schema alone.
pub fn schema() -> Result<bool, String> {
    let mut artefacts = Artefacts::new(false);
    artefacts.file(&project::root().join("regdefs/schema.json"), &schema_text())?;
    Ok(artefacts.summary())
}

/// The references alone.
pub fn docs() -> Result<bool, String> {
    let root = project::root();
    let models: Vec<_> = project::descriptions()?.iter().map(|file| descriptions::load(file)).collect();
    let Some(models) = models.into_iter().collect::<Option<Vec<_>>>() else { return Ok(false) };
    let mut artefacts = Artefacts::new(false);
    artefacts.file(&root.join("docs/language.md"), &regdef_codegen::language::page())?;
    let good = artefacts.summary();
    reference(&models.iter().collect::<Vec<_>>(), &root.join("target/reference"))?;
    Ok(good)
}

fn schema_text() -> String {
    format!("{:#}\n", regdef::schema())
}

/// All files of a generated crate.
fn package(model: &Model) -> Result<Vec<OutputFile>, String> {
    let mut files = regdef_codegen::rust::crate_files(model)?;
    let svd = regdef_codegen::svd::svd(model).map_err(|error| format!("{}: {error}", model.names.id))?;
    let header = regdef_codegen::c::header(model);
    files.push(OutputFile { path: format!("include/{}.h", model.names.id), content: header });
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
