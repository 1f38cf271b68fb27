//! The project's commands: `cargo xtask --help`.

use std::path::PathBuf;
use std::process::ExitCode;

use annotate_snippets::Renderer;

fn main() -> ExitCode {
    let mut failed = false;
    for path in std::env::args_os().skip(1).map(PathBuf::from) {
        let loaded = regdef::load_file(&path);
        let text = regdef::diagnostic::report(&loaded.findings, &loaded.source, &Renderer::styled());
        anstream::eprint!("{text}");
        match &loaded.model {
            Some(model) => {
                let fields: usize = model.registers.iter().map(|r| r.fields.len()).sum();
                anstream::println!("{}: {} registers, {fields} fields", path.display(), model.registers.len());
            }
            None => failed = true,
        }
    }
    ExitCode::from(u8::from(failed))
}
