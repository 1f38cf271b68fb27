//! Builds the HTML reference from description files: `site OUT FILE...`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs, io};

fn main() -> ExitCode {
    let mut arguments = env::args_os().skip(1).map(PathBuf::from);
    let Some(out) = arguments.next() else {
        eprintln!("usage: site OUT FILE...");
        return ExitCode::FAILURE;
    };
    let mut models = Vec::new();
    for file in arguments {
        let loaded = regdef::load_file(&file);
        match loaded.model {
            Some(model) => models.push(model),
            None => eprintln!("{}: {} findings, left out", file.display(), loaded.findings.len()),
        }
    }
    let files = regdef_codegen::html::site(&models.iter().collect::<Vec<_>>());
    match files.iter().try_for_each(|file| write(&out, &file.path, &file.content)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn write(out: &Path, path: &str, content: &str) -> io::Result<()> {
    let path = out.join(path);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, content)
}
