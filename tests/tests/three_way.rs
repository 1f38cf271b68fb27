//! Rust metadata, SVD and C header agree with the model on every field: place, mask, width, access and reset.
//!
//! The SVD is parsed back by a parser that no one here wrote; the header is compiled by five compilers, and what it
//! says is read out of the object files.

#[path = "three_way/c.rs"]
mod c;
#[path = "three_way/compiler.rs"]
mod compiler;
#[path = "three_way/rust.rs"]
mod rust;
#[path = "three_way/svd.rs"]
mod svd;

use std::path::PathBuf;

use canpac_tests::{all_descriptions, model};
use compiler::COMPILERS;

fn files() -> Vec<PathBuf> {
    let files = all_descriptions();
    assert!(!files.is_empty(), "no description found");
    files
}

#[test]
fn the_metadata_of_the_crates_says_what_the_model_says() {
    let mut controllers = 0;
    for file in canpac_tests::descriptions("regdefs") {
        let model = model(&file);
        let controller = rust::controller(&model).expect("every description in regdefs/ has a crate");
        assert!(rust::compare(&model, controller) > 50, "{}: too few fields compared", file.display());
        controllers += 1;
    }
    assert_eq!(controllers, 4);
}

#[test]
fn the_svd_says_what_the_model_says() {
    for file in files() {
        let model = model(&file);
        let fields = svd::compare(&model);
        assert!(fields > 0, "{}: no field compared", file.display());
    }
}

#[test]
fn the_header_says_what_the_model_says_on_every_compiler() {
    for file in files() {
        let model = model(&file);
        for compiler in COMPILERS {
            let fields = c::compare(&model, compiler);
            assert!(fields > 0, "{}: no field compared", file.display());
        }
    }
}

#[test]
fn the_header_compiles_by_itself_in_every_dialect() {
    let dir = tempfile::tempdir().expect("a folder for objects");
    for file in files() {
        let model = model(&file);
        let header = regdef_codegen::c::header(&model);
        let name = format!("{}.h", model.names.id);
        for compiler in COMPILERS {
            for dialect in compiler.dialects {
                // Twice, because a header may be included by two others.
                let source = format!("#include \"{name}\"\n#include \"{name}\"\nint canpac_unit;\n");
                compiler.compile(
                    dir.path(),
                    &[(&name, &header)],
                    &source,
                    dialect,
                    &format!("{}, {dialect}", file.display()),
                );
            }
        }
    }
}
