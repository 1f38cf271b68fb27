//! What is printed. Colours appear only on a terminal: `anstream` removes them elsewhere.

use annotate_snippets::Renderer;
use anstyle::{AnsiColor, Style};
use regdef::Loaded;

const ERROR: Style = AnsiColor::Red.on_default().bold();

/// An error of the command itself.
pub fn error(text: &str) {
    anstream::eprintln!("{ERROR}error{ERROR:#}: {text}");
}

/// Everything that was found in a description.
pub fn findings(loaded: &Loaded) {
    if !loaded.findings.is_empty() {
        let text = regdef::diagnostic::report(&loaded.findings, &loaded.source, &Renderer::styled());
        anstream::eprint!("{text}");
    }
}
