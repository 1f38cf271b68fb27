//! `cargo xtask diff`.

use anstyle::{AnsiColor, Style};
use regdef::diff::{Line, diff};

use crate::descriptions;

/// Prints what differs between two descriptions; `false` if something does.
pub fn print(old: &str, new: &str) -> Result<bool, String> {
    let (Some(old), Some(new)) = (descriptions::find(old)?, descriptions::find(new)?) else {
        return Err("there is nothing to compare: a description has errors".to_owned());
    };
    let changes = diff(&old, &new);
    for change in &changes {
        let bold = Style::new().bold();
        anstream::println!("{bold}{}{bold:#}", change.what);
        for line in &change.lines {
            let style = match line {
                Line::Added(_) => AnsiColor::Green.on_default(),
                Line::Removed(_) => AnsiColor::Red.on_default(),
                Line::Changed(_) => AnsiColor::Yellow.on_default(),
            };
            anstream::println!("  {style}{line}{style:#}");
        }
    }
    let count: usize = changes.iter().map(|change| change.lines.len()).sum();
    match count {
        0 => anstream::println!("no differences"),
        1 => anstream::println!("1 difference"),
        _ => anstream::println!("{count} differences"),
    }
    Ok(changes.is_empty())
}
