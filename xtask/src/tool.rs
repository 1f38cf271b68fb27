//! `cargo xtask bit-timing` and `memory`: a program of their own, because they are built on generated crates, and this one
//! has to work when a generated crate is broken.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

use crate::project;

/// Runs a command of can-tool and hands on its exit code.
pub fn run(command: &str, arguments: &[OsString]) -> Result<ExitCode, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["run", "--quiet", "--package", "can-tool", "--manifest-path"])
        .arg(project::root().join("Cargo.toml"))
        .args(["--", command])
        .args(arguments)
        .status()
        .map_err(|error| format!("cargo: {error}"))?;
    Ok(status.code().and_then(|code| u8::try_from(code).ok()).map_or(ExitCode::FAILURE, ExitCode::from))
}
