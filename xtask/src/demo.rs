//! The demo, as a program of its own: these commands have to work while generated code does not compile.

use std::path::PathBuf;
use std::process::Command;

use crate::project;

/// Builds and runs the demo; its files go to `out`.
pub fn run(out: Option<PathBuf>) -> Result<bool, String> {
    let out = out.unwrap_or_else(|| PathBuf::from(project::shown(&project::root().join("target").join("demo"))));
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let manifest = project::root().join("Cargo.toml");
    let status = Command::new(cargo)
        .args(["run", "--quiet", "--package", "can-demo", "--manifest-path"])
        .arg(manifest)
        .args(["--", "--out"])
        .arg(out)
        .status()
        .map_err(|error| format!("cargo run --package can-demo: {error}"))?;
    Ok(status.success())
}
