//! `cargo xtask bit-timing` and `cargo xtask memory`.
//!
//! Exits with 1 if what was asked for is impossible, and with 2 if it was not understood or a file could not be written.

use std::io::{ErrorKind, Write};
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};
use clap::Parser;

const ERROR: Style = AnsiColor::Red.on_default().bold();

fn main() -> ExitCode {
    let output = match can_tool::run(&can_tool::Cli::parse()) {
        Ok(output) => output,
        Err(error) => return fail(&error, 1),
    };
    if let Some((path, content)) = output.file
        && let Err(error) = std::fs::write(&path, content)
    {
        return fail(&format!("{}: {error}", path.display()), 2);
    }
    match std::io::stdout().lock().write_all(output.text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => fail(&format!("standard output: {error}"), 2),
        _ => ExitCode::SUCCESS,
    }
}

fn fail(error: &str, code: u8) -> ExitCode {
    anstream::eprintln!("{ERROR}error{ERROR:#}: {error}");
    ExitCode::from(code)
}
