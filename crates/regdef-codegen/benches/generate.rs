//! Time to load and check descriptions and to make everything from them.
//!
//! `cargo bench -p regdef-codegen`

mod synthetic;

use std::path::PathBuf;

use divan::{Bencher, black_box};
use regdef::model::Model;

fn main() {
    divan::main();
}

const CONTROLLERS: [&str; 4] = ["m_can", "dspic33-canfd", "dspic33-ecan", "pic32-can"];

/// The text of one of the project's descriptions.
fn text(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../regdefs").join(format!("{name}.yaml"));
    match std::fs::read_to_string(&path) {
        Ok(text) => text,
        Err(error) => panic!("{}: {error}", path.display()),
    }
}

fn load(name: &str, text: &str) -> Model {
    regdef::load_str(name, text).model.expect("a description without errors")
}

fn models() -> Vec<Model> {
    CONTROLLERS.iter().map(|name| load(name, &text(name))).collect()
}

/// Everything of one controller but the HTML; the number of bytes.
fn package(model: &Model) -> usize {
    let rust: usize = regdef_codegen::rust::crate_files(model).expect("Rust").iter().map(|f| f.content.len()).sum();
    let svd = regdef_codegen::svd::svd(model).expect("SVD").len();
    rust + svd + regdef_codegen::c::header(model).len() + regdef_codegen::table::csv(model).len()
}

mod m_can {
    use super::*;

    #[divan::bench]
    fn load_and_check(bencher: Bencher<'_, '_>) {
        let text = text("m_can");
        bencher.bench_local(|| load("m_can", black_box(&text)));
    }

    #[divan::bench]
    fn rust(bencher: Bencher<'_, '_>) {
        let model = load("m_can", &text("m_can"));
        bencher.bench_local(|| regdef_codegen::rust::crate_files(black_box(&model)));
    }

    #[divan::bench]
    fn c(bencher: Bencher<'_, '_>) {
        let model = load("m_can", &text("m_can"));
        bencher.bench_local(|| regdef_codegen::c::header(black_box(&model)));
    }

    #[divan::bench]
    fn svd(bencher: Bencher<'_, '_>) {
        let model = load("m_can", &text("m_can"));
        bencher.bench_local(|| regdef_codegen::svd::svd(black_box(&model)));
    }

    #[divan::bench]
    fn csv(bencher: Bencher<'_, '_>) {
        let model = load("m_can", &text("m_can"));
        bencher.bench_local(|| regdef_codegen::table::csv(black_box(&model)));
    }

    #[divan::bench]
    fn html(bencher: Bencher<'_, '_>) {
        let model = load("m_can", &text("m_can"));
        bencher.bench_local(|| regdef_codegen::html::site(black_box(&[&model])));
    }
}

mod all_four {
    use super::*;

    #[divan::bench]
    fn load_and_check() -> Vec<Model> {
        models()
    }

    /// From text to Rust, C, SVD and tables.
    #[divan::bench]
    fn generate() -> usize {
        models().iter().map(package).sum()
    }

    #[divan::bench]
    fn html(bencher: Bencher<'_, '_>) {
        let models = models();
        let models: Vec<_> = models.iter().collect();
        bencher.bench_local(|| regdef_codegen::html::site(black_box(&models)));
    }
}

/// 2,000 registers with 20,000 fields.
#[divan::bench_group(sample_count = 5, sample_size = 1)]
mod synthetic_20000_fields {
    use super::*;

    #[divan::bench]
    fn load_and_check(bencher: Bencher<'_, '_>) {
        let text = synthetic::yaml();
        bencher.bench_local(|| load("synthetic", black_box(&text)));
    }

    #[divan::bench]
    fn rust(bencher: Bencher<'_, '_>) {
        let model = load("synthetic", &synthetic::yaml());
        bencher.bench_local(|| regdef_codegen::rust::crate_files(black_box(&model)));
    }

    #[divan::bench]
    fn c(bencher: Bencher<'_, '_>) {
        let model = load("synthetic", &synthetic::yaml());
        bencher.bench_local(|| regdef_codegen::c::header(black_box(&model)));
    }

    #[divan::bench]
    fn svd(bencher: Bencher<'_, '_>) {
        let model = load("synthetic", &synthetic::yaml());
        bencher.bench_local(|| regdef_codegen::svd::svd(black_box(&model)));
    }
}
