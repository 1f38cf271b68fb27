//! The generated Rust: of small descriptions, one per feature of the language, and of the project's own.

mod common;

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use regdef_codegen::OutputFile;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn crate_files(path: &Path) -> (String, Vec<OutputFile>) {
    let model = common::load(path);
    let files = regdef_codegen::rust::crate_files(&model).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    (model.names.krate, files)
}

#[test]
fn every_feature() {
    for (name, model) in common::features() {
        let mut text = String::new();
        for file in regdef_codegen::rust::crate_files(&model).unwrap_or_else(|error| panic!("{name}: {error}")) {
            // The front page is prose for people; its text is looked at in the generated crates.
            if file.path != "src/lib.rs" {
                let _ = write!(text, "---- {}\n{}", file.path, file.content);
            }
        }
        insta::assert_snapshot!(format!("rust__{name}"), text);
    }
}

/// The descriptions whose crates are kept in the repository, with the crates' folders.
fn committed() -> Vec<(PathBuf, PathBuf)> {
    let mut all = vec![(root().join("tests/fixture/fixture.yaml"), root().join("tests/fixture"))];
    for entry in fs::read_dir(root().join("regdefs")).expect("regdefs/ can be listed") {
        let path = entry.expect("regdefs/ can be listed").path();
        if path.extension().is_some_and(|extension| extension == "yaml") {
            let (krate, _) = crate_files(&path);
            all.push((path, root().join("crates").join(krate)));
        }
    }
    all
}

#[test]
fn the_committed_crates_are_what_the_descriptions_say() {
    let committed = committed();
    assert!(committed.len() >= 5, "{committed:?}");
    for (description, folder) in committed {
        let (_, files) = crate_files(&description);
        for file in &files {
            let path = folder.join(&file.path);
            let present = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            let differs = present.lines().zip(file.content.lines()).position(|(a, b)| a != b);
            assert!(
                present == file.content,
                "{} differs from line {} on; run `cargo xtask codegen` (for the fixture `cargo xtask codegen \
                 tests/fixture/fixture.yaml --out tests/fixture`)",
                path.display(),
                differs.map_or(present.lines().count().min(file.content.lines().count()), |line| line) + 1
            );
        }
        let mut on_disk: Vec<_> =
            fs::read_dir(folder.join("src")).expect("src/").map(|entry| entry.expect("src/").file_name()).collect();
        on_disk.sort();
        let mut wanted: Vec<_> =
            files.iter().map(|f| Path::new(&f.path).file_name().unwrap_or_default().to_owned()).collect();
        wanted.sort();
        assert_eq!(on_disk, wanted, "{}", folder.display());
    }
}

/// The same text gives the same bytes wherever it lies: nothing of a path, a clock or the order of a hash gets in.
#[test]
fn two_folders_give_the_same_bytes() {
    for (description, _) in committed() {
        let made: Vec<Vec<(String, String)>> = (0..2)
            .map(|_| {
                let folder = tempfile::tempdir().expect("a temporary folder");
                let copy = folder.path().join(description.file_name().unwrap_or_default());
                fs::copy(&description, &copy).expect("a copy of the description");
                let model = common::load(&copy);
                let mut files = regdef_codegen::rust::crate_files(&model).unwrap_or_else(|error| panic!("{error}"));
                files.extend(regdef_codegen::html::site(&[&model]));
                let mut texts: Vec<_> = files.into_iter().map(|file| (file.path, file.content)).collect();
                texts.push(("h".to_owned(), regdef_codegen::c::header(&model)));
                texts.push((
                    "svd".to_owned(),
                    regdef_codegen::svd::svd(&model).unwrap_or_else(|error| panic!("{error}")),
                ));
                texts.push(("csv".to_owned(), regdef_codegen::table::csv(&model)));
                texts.push(("json".to_owned(), regdef_codegen::table::json(&model)));
                texts
            })
            .collect();
        assert!(made[0] == made[1], "{}", description.display());
    }
}
