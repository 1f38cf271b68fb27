//! Bit timing and message memory on the command line: what `cargo xtask bit-timing` and `cargo xtask memory` run.
//!
//! A program of its own, so that `cargo xtask codegen` never depends on the crates that it generates.

mod memory;
mod picture;
mod quantity;
mod timing;

use clap::{Parser, Subcommand, ValueEnum};

/// Computes with the limits and layouts of the descriptions.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", version, arg_required_else_help = true)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Finds a bit timing and shows registers, errors, tolerance, alternatives and a picture of the bit.
    BitTiming(timing::Arguments),
    /// Plans the message memory and draws the map.
    Memory(Box<memory::Arguments>),
}

/// The controllers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Controller {
    /// Bosch M_CAN.
    MCan,
    /// Microchip dsPIC33 CAN FD.
    #[value(name = "dspic33_canfd")]
    DsPic33CanFd,
    /// Microchip dsPIC33F/PIC24H ECAN.
    #[value(name = "dspic33_ecan")]
    DsPic33Ecan,
    /// Microchip PIC32 CAN.
    #[value(name = "pic32_can")]
    Pic32Can,
}

/// What a command made.
#[derive(Debug)]
pub struct Output {
    /// For standard output.
    pub text: String,
    /// A file to write: its path and its content.
    pub file: Option<(std::path::PathBuf, String)>,
}

/// Runs a command.
///
/// # Errors
///
/// Why what was asked for is impossible, in one or a few lines.
pub fn run(cli: &Cli) -> Result<Output, String> {
    match &cli.command {
        Command::BitTiming(arguments) => timing::run(arguments),
        Command::Memory(arguments) => memory::run(arguments).map(|text| Output { text, file: None }),
    }
}
