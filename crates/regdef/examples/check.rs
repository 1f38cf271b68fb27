//! Checks descriptions: `cargo run -p regdef --example check -- FILE...`

use std::path::Path;
use std::process::ExitCode;

use annotate_snippets::Renderer;

fn main() -> ExitCode {
    let mut failed = false;
    for file in std::env::args_os().skip(1) {
        let loaded = regdef::load_file(Path::new(&file));
        print!("{}", regdef::diagnostic::report(&loaded.findings, &loaded.source, &Renderer::plain()));
        match loaded.model {
            Some(model) => println!("{}: {} registers", model.title, model.registers.len()),
            None => failed = true,
        }
    }
    ExitCode::from(u8::from(failed))
}
