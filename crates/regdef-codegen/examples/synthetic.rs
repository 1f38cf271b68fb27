//! Writes the synthetic description of the benchmarks, and the crate and the SVD file that are made from it, to a folder.
//!
//! `cargo run --release -p regdef-codegen --example synthetic DIR REGBUS`, where REGBUS is the path of `crates/regbus`.

#[path = "../benches/synthetic.rs"]
mod synthetic;

use std::path::{Path, PathBuf};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(out), Some(regbus)) = (arguments.next(), arguments.next()) else {
        return Err("usage: synthetic DIR REGBUS".into());
    };
    let text = synthetic::yaml();
    let start = Instant::now();
    let model = regdef::load_str("synthetic.yaml", &text).model.ok_or("the description has errors")?;
    let loaded = start.elapsed();
    let files = regdef_codegen::rust::crate_files(&model)?;
    let made = start.elapsed();
    for file in &files {
        write(&out.join(&file.path), &file.content)?;
    }
    let svd = regdef_codegen::svd::svd(&model)?;
    write(&out.join("synthetic.svd"), &svd)?;
    write(&out.join("synthetic.yaml"), &text)?;
    let manifest = regdef_codegen::rust::manifest(&model)
        .replace("regbus = \"0.1\"", &format!("regbus = {{ path = {:?} }}\n\n[workspace]", regbus.canonicalize()?));
    write(&out.join("Cargo.toml"), &manifest)?;
    println!(
        "{} registers: loaded in {loaded:.2?}, Rust with formatting in {:.2?}",
        synthetic::REGISTERS,
        made - loaded
    );
    Ok(())
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    std::fs::create_dir_all(path.parent().unwrap_or(Path::new(".")))?;
    std::fs::write(path, text)
}
