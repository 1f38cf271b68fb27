//! What the README claims: its examples work as printed. Its Rust is a doc test of this crate.

use std::fs;
use std::process::Command;

use annotate_snippets::Renderer;
use canpac_tests::root;

/// The code blocks of one language.
fn blocks(language: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join("README.md")).expect("the README is there");
    let fence = format!("```{language}\n");
    let blocks: Vec<_> =
        text.split(&fence).skip(1).filter_map(|rest| Some(rest.split_once("```")?.0.to_owned())).collect();
    assert!(!blocks.is_empty(), "the README has no {language} block");
    blocks
}

#[test]
fn the_description_loads_without_findings() {
    for text in blocks("yaml") {
        let loaded = regdef::load_str("my_can.yaml", &text);
        assert!(loaded.findings.is_empty(), "{:#?}", loaded.findings);
        assert!(loaded.model.is_some());
    }
}

#[test]
fn the_mistake_is_reported_as_printed() {
    let description = &blocks("yaml")[0];
    let broken = description.replace("INIT: {bits: 0,", "INIT: {bits: 4,");
    assert_ne!(description, &broken);
    let loaded = regdef::load_str("my_can.yaml", &broken);
    let report = regdef::diagnostic::report(&loaded.findings, &loaded.source, &Renderer::plain());
    let printed = blocks("text").into_iter().find(|text| text.contains("E201")).expect("the README shows the report");
    assert!(report.contains(printed.trim_end()), "{report}");
}

/// The excerpt of the demo is what the demo's own snapshot says.
#[test]
fn the_demo_is_as_printed() {
    let snapshot = root().join("crates/can-demo/tests/snapshots/story__the_timeline.snap");
    let told = fs::read_to_string(snapshot).expect("the demo has a snapshot");
    let printed =
        blocks("text").into_iter().find(|text| text.contains("One CAN bus")).expect("the README shows the demo");
    assert!(printed.lines().count() > 5);
    for line in printed.lines() {
        assert!(told.lines().any(|of_demo| of_demo == line), "the demo does not print `{line}`");
    }
}

#[test]
fn the_c_compiles() {
    let folder = tempfile::tempdir().expect("a folder for the object");
    for (number, text) in blocks("c").iter().enumerate() {
        let source = folder.path().join(format!("readme{number}.c"));
        fs::write(&source, text).expect("the folder is ours");
        let compiler = Command::new("gcc")
            .args(["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c"])
            .arg("-I")
            .arg(root().join("crates/m-can-pac/include"))
            .arg(&source)
            .arg("-o")
            .arg(folder.path().join("readme.o"))
            .output()
            .expect("gcc is needed; it is in the Debian package gcc");
        assert!(compiler.status.success(), "{}", String::from_utf8_lossy(&compiler.stderr));
    }
}
