//! `cargo xtask dump`.

use std::io::{ErrorKind, Write};

use crate::descriptions;

/// Prints the table of a controller.
pub fn print(controller: &str, json: bool) -> Result<bool, String> {
    let Some(model) = descriptions::find(controller)? else { return Ok(false) };
    let text = if json { regdef_codegen::table::json(&model) } else { regdef_codegen::table::csv(&model) };
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!("standard output: {error}")),
        _ => Ok(true),
    }
}
