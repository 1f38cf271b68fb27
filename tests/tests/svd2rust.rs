//! svd2rust, which no one here wrote, reads every SVD file and what it makes of it compiles.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use canpac_tests::{all_descriptions, model};
use svd_parser::ValidateLevel;

/// A workspace with a crate for each SVD; all depend on `vcell` alone, which this workspace has fetched.
fn scratch_workspace(dir: &Path, crates: &[(String, String)]) -> std::io::Result<()> {
    let mut members = String::new();
    for (name, code) in crates {
        write!(members, "\"{name}\", ").expect("a string takes any text");
        std::fs::create_dir_all(dir.join(name).join("src"))?;
        let manifest = format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\n\
             [features]\nrt = []\n\n[dependencies]\nvcell = \"0.1\"\n"
        );
        std::fs::write(dir.join(name).join("Cargo.toml"), manifest)?;
        std::fs::write(dir.join(name).join("src/lib.rs"), code)?;
    }
    std::fs::write(dir.join("Cargo.toml"), format!("[workspace]\nresolver = \"2\"\nmembers = [{members}]\n"))
}

fn generated(file: &Path) -> (String, String) {
    let model = model(file);
    let svd = regdef_codegen::svd::svd(&model).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let strict = svd_parser::Config::default().validate_level(ValidateLevel::Strict);
    if let Err(error) = svd_parser::parse_with_config(&svd, &strict) {
        panic!("{}: {error:#}", file.display());
    }
    let mut config = svd2rust::Config::default();
    config.target = svd2rust::Target::None;
    config.strict = true;
    match svd2rust::generate(&svd, &config) {
        // svd2rust writes one line; the compiler's messages would each repeat it.
        Ok(generation) => match syn::parse_file(&generation.lib_rs) {
            Ok(parsed) => (model.names.id, prettyplease::unparse(&parsed)),
            Err(error) => panic!("{}: {error}", file.display()),
        },
        Err(error) => panic!("{}: {error:#}", file.display()),
    }
}

#[test]
fn what_svd2rust_makes_of_the_svd_files_compiles() {
    let files: Vec<PathBuf> = all_descriptions();
    assert!(!files.is_empty(), "no description found");
    let crates: Vec<(String, String)> = files.iter().map(|file| generated(file)).collect();
    let dir = tempfile::tempdir().expect("a folder for the scratch crates");
    scratch_workspace(dir.path(), &crates).expect("a writable folder");
    let output = Command::new(env!("CARGO"))
        .args(["check", "--offline", "--quiet", "--workspace"])
        .current_dir(dir.path())
        .env("CARGO_TARGET_DIR", dir.path().join("target"))
        .env("RUSTFLAGS", "-Awarnings")
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
