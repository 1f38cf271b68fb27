//! The project's commands: `cargo xtask --help`.

mod artefacts;
mod codegen;
mod demo;
mod descriptions;
mod diff;
mod dump;
mod project;
mod report;
mod tool;

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};

/// Turns register descriptions into Rust, C, SVD and HTML; shows what runs on them.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", version, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Generates everything from regdefs/: crates, C headers, SVD, HTML reference, schema, language reference.
    ///
    /// Prints a table of what was written, was unchanged, or was stale and is removed. Unchanged files are not touched.
    Codegen {
        /// Writes nothing; fails with a diff if a generated file is not what it would be.
        #[arg(long)]
        check: bool,
        /// A description of your own; everything that is made from it goes to the folder of --out.
        #[arg(requires = "out")]
        file: Option<PathBuf>,
        /// The folder for a description of your own.
        #[arg(long, value_name = "DIR", requires = "file")]
        out: Option<PathBuf>,
    },
    /// Checks descriptions and prints everything that is wrong with them.
    Check {
        /// The descriptions; all of regdefs/ if left out.
        files: Vec<PathBuf>,
    },
    /// Prints every field of a controller, one row each, message elements included.
    Dump {
        /// Its name, such as m_can, or the path of a description.
        controller: String,
        /// The format.
        #[arg(long, value_enum, default_value_t = Format::Csv)]
        format: Format,
    },
    /// Tells what differs between two descriptions: registers and fields added, removed, moved, changed in access or reset.
    ///
    /// Exits with 1 if something differs.
    Diff {
        /// The old description: a path, or the name of a controller.
        old: String,
        /// The new description.
        new: String,
    },
    /// Shows two controllers on a simulated bus: frames, a fault, error passive, bus off, and the way back.
    ///
    /// Prints a timeline and writes report.html, bus.vcd (GTKWave, PulseView), bus.pcapng (Wireshark) and candump.log.
    Demo {
        /// The folder for the files; target/demo/ if left out.
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Writes the JSON schema for editors to regdefs/schema.json.
    Schema,
    /// Writes the HTML reference to target/reference/ and the language reference to docs/.
    Docs,
    /// Finds a bit timing: registers, errors, tolerance, alternatives and a picture; bit-timing --help lists the options.
    #[command(disable_help_flag = true)]
    BitTiming {
        /// For the program that computes.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
    /// Plans message memory and draws the map; memory --help lists the options.
    #[command(disable_help_flag = true)]
    Memory {
        /// For the program that computes.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// Comma-separated values with a header line.
    Csv,
    /// JSON with numbers as numbers.
    Json,
}

fn main() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::Codegen { check, file: Some(file), out: Some(out) } => codegen::single(&file, &out, check),
        Command::Codegen { check, .. } => codegen::project(check),
        Command::Check { files } => descriptions::check(&files),
        Command::Dump { controller, format } => dump::print(&controller, matches!(format, Format::Json)),
        Command::Diff { old, new } => diff::print(&old, &new),
        Command::Demo { out } => demo::run(out),
        Command::Schema => codegen::schema(),
        Command::Docs => codegen::docs(),
        Command::BitTiming { arguments } => return handed_on(tool::run("bit-timing", &arguments)),
        Command::Memory { arguments } => return handed_on(tool::run("memory", &arguments)),
    };
    handed_on(outcome.map(|good| if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }))
}

fn handed_on(outcome: Result<ExitCode, String>) -> ExitCode {
    outcome.unwrap_or_else(|error| {
        report::error(&error);
        ExitCode::from(2)
    })
}
