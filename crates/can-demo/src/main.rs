//! `cargo xtask demo`.

use std::{path::PathBuf, process::ExitCode};

use anstyle::{AnsiColor, Style};
use clap::Parser;

const ERROR: Style = AnsiColor::Red.on_default().bold();

/// Two CAN controllers on a simulated bus: frames, a fault, error passive, bus off, and the way back.
///
/// Prints a timeline and writes what other tools read: report.html, bus.vcd (GTKWave, PulseView), bus.pcapng (Wireshark),
/// candump.log (can-utils).
#[derive(Parser)]
#[command(name = "cargo xtask demo", bin_name = "cargo xtask demo")]
struct Arguments {
    /// The folder for the files.
    #[arg(long, value_name = "DIR", default_value = "target/demo")]
    out: PathBuf,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match can_demo::run(&can_demo::Options { out: Some(arguments.out) }) {
        Ok(story) => {
            anstream::print!("{}", can_demo::terminal::timeline(&story));
            anstream::print!("{}", can_demo::terminal::files(&story));
            ExitCode::SUCCESS
        }
        Err(error) => {
            anstream::eprintln!("{ERROR}error{ERROR:#}: {error}");
            ExitCode::from(2)
        }
    }
}
