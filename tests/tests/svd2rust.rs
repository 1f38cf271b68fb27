//! svd2rust, which no one here wrote, reads every SVD file and what it makes of it compiles.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use canpac_tests::{all_descriptions, model};
use svd_parser::ValidateLevel;

/// A crate that holds the given modules and depends on `vcell` alone, which the lock file of this workspace pins.
fn scratch_crate(dir: &Path, modules: &[(String, String)]) -> std::io::Result<()> {
    std::fs::create_dir_all(dir.join("src"))?;
    let manifest = "[package]\nname = \"scratch\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\n[workspace]\n\n\
                    [dependencies]\nvcell = \"0.1\"\n";
    std::fs::write(dir.join("Cargo.toml"), manifest)?;
    let mut lib = String::from("#![no_std]\n");
    for (name, code) in modules {
        writeln!(lib, "pub mod {name};").expect("a string takes any text");
        std::fs::write(dir.join("src").join(format!("{name}.rs")), code)?;
    }
    std::fs::write(dir.join("src/lib.rs"), lib)
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
    config.make_mod = true;
    config.skip_crate_attributes = true;
    config.strict = true;
    match svd2rust::generate(&svd, &config) {
        Ok(generation) => (model.names.id, generation.lib_rs),
        Err(error) => panic!("{}: {error:#}", file.display()),
    }
}

#[test]
fn what_svd2rust_makes_of_the_svd_files_compiles() {
    let files: Vec<PathBuf> = all_descriptions();
    assert!(!files.is_empty(), "no description found");
    let modules: Vec<(String, String)> = files.iter().map(|file| generated(file)).collect();
    let dir = tempfile::tempdir().expect("a folder for the scratch crate");
    scratch_crate(dir.path(), &modules).expect("a writable folder");
    let output = Command::new(env!("CARGO"))
        .args(["check", "--offline", "--quiet"])
        .current_dir(dir.path())
        .env("CARGO_TARGET_DIR", dir.path().join("target"))
        .env("RUSTFLAGS", "-Awarnings")
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
