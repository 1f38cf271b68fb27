//! What the author of a description is told.
//!
//! Every folder of `tests/ui` holds a description, `input.yaml`, and the report that it gets, `expected.txt`. Where
//! the input is large or no text it is made here instead, by the function that [`GENERATED`] gives for the folder.
//!
//! `UPDATE_EXPECT=1 cargo test -p regdef --test ui` accepts the reports as they are now; read the diff before you
//! commit it. The question is always the same: does the report alone let the author correct the file?

#![allow(clippy::unwrap_used)]

use std::collections::HashSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use annotate_snippets::Renderer;
use regdef::diagnostic::{Code, report};
use regdef::{Loaded, load_bytes, load_file};

const SHOWN: &str = "input.yaml";

type Make = fn() -> Loaded;

const GENERATED: &[(&str, Make)] = &[
    ("file_not_found", || load_file(Path::new("no such folder/input.yaml"))),
    ("file_is_a_folder", || load_file(Path::new(env!("CARGO_MANIFEST_DIR")))),
    ("empty_file", || load_bytes(SHOWN, b"")),
    ("file_of_100_megabytes", || {
        // A file with a hole: it has the length, but takes no space.
        let file = tempfile::NamedTempFile::new().unwrap();
        file.as_file().set_len(100 << 20).unwrap();
        load_file(file.path())
    }),
    ("scalar_of_100_megabytes", || {
        let mut text = b"controller: ".to_vec();
        text.resize(100 << 20, b'a');
        load_bytes(SHOWN, &text)
    }),
    ("scalar_of_4_megabytes", || {
        let mut text = b"controller: ".to_vec();
        text.resize(4 << 20, b'A');
        load_bytes(SHOWN, &text)
    }),
    ("a_million_values", || load_bytes(SHOWN, format!("title: [{}]", "1,".repeat(1_000_000)).as_bytes())),
    ("key_of_a_megabyte", || load_bytes(SHOWN, format!("? {}\n: 1\n", "k".repeat(1 << 20)).as_bytes())),
    ("nesting_of_10000", || load_bytes(SHOWN, format!("registers: {}", "[".repeat(10_000)).as_bytes())),
    ("nesting_of_10000_mappings", || {
        let mut text = String::new();
        for depth in 0..10_000 {
            text += &" ".repeat(depth.min(100));
            text += if depth < 100 { "a:\n" } else { "- " };
        }
        load_bytes(SHOWN, text.as_bytes())
    }),
    ("alias_bomb", || {
        let mut text = "a: &a [x, x, x, x, x, x, x, x, x]\n".to_owned();
        for (name, of) in ('b'..='z').zip('a'..) {
            writeln!(text, "{name}: &{name} [*{of}, *{of}, *{of}, *{of}, *{of}, *{of}, *{of}, *{of}, *{of}]").unwrap();
        }
        first_findings(load_bytes(SHOWN, text.as_bytes()), 3)
    }),
    ("invalid_utf8", || load_bytes(SHOWN, b"controller: demo\ntitle: 10 \xb5s after reset\n")),
    ("utf16", || load_bytes(SHOWN, b"\xff\xfec\0o\0n\0t\0r\0o\0l\0l\0e\0r\0:\0")),
    ("crlf", || {
        let text = fs::read_to_string(folder("crlf").join("unix.yaml")).unwrap();
        load_bytes(SHOWN, text.replace('\n', "\r\n").as_bytes())
    }),
    ("old_mac_line_ends", || {
        let text = fs::read_to_string(folder("crlf").join("unix.yaml")).unwrap();
        load_bytes(SHOWN, text.replace('\n', "\r").as_bytes())
    }),
    ("control_characters", || {
        load_bytes(
            SHOWN,
            "controller: demo\ntitle: De\u{0}mo\u{1b}[31m\nprefix: a\u{2028}b\ndoc: x\u{feff}y\n".as_bytes(),
        )
    }),
    ("more_errors_than_listed", || {
        let mut text = "registers:\n".to_owned();
        for n in 0..2000 {
            writeln!(text, "  R{n}: {{titel: x}}").unwrap();
        }
        let mut loaded = load_bytes(SHOWN, text.as_bytes());
        let last = loaded.findings.pop().unwrap();
        loaded.findings.truncate(1);
        loaded.findings.push(last);
        loaded
    }),
    ("conditions_that_explode", || {
        let mut text = fs::read_to_string(folder("conditions_that_explode").join("head.yaml")).unwrap();
        for n in 1..40 {
            writeln!(text, "  c{n}: c{} && c{}", n - 1, n - 1).unwrap();
        }
        load_bytes(SHOWN, text.as_bytes())
    }),
    ("conditions_in_a_long_chain", || {
        let mut text = fs::read_to_string(folder("conditions_that_explode").join("head.yaml")).unwrap();
        for n in (1..5000).rev() {
            writeln!(text, "  c{n}: \"!c{}\"", n - 1).unwrap();
        }
        first_findings(load_bytes(SHOWN, text.as_bytes()), 2)
    }),
    ("like_in_a_long_chain", || {
        let mut text = fs::read_to_string(folder("like_in_a_long_chain").join("head.yaml")).unwrap();
        for n in 1..12 {
            let cite = "cite: {section: \"1\"}";
            writeln!(text, "  R{n}: {{title: R, offset: {}, {cite}, like: {{register: R{}}}}}", 4 * n, n - 1).unwrap();
        }
        load_bytes(SHOWN, text.as_bytes())
    }),
    ("like_that_explodes", || {
        let text = fs::read_to_string(folder("like_in_a_long_chain").join("head.yaml")).unwrap();
        let long = "x".repeat(100_000);
        let replace = format!("replace: {{\"a\": \"{long}\"}}");
        let like = format!("like: {{register: R0, {replace}}}");
        let text = text.replace("A number.", &"a".repeat(1000));
        let loaded = load_bytes(SHOWN, format!("{text}  R1: {{title: R, offset: 4, {like}}}\n").as_bytes());
        first_findings(loaded, 1)
    }),
    ("line_of_a_megabyte", || {
        let doc = "long ".repeat(200_000);
        load_bytes(SHOWN, format!("{{controller: demo, doc: \"{doc}\", titel: Demo}}").as_bytes())
    }),
];

/// The first findings alone, where the others are of the same kind.
fn first_findings(loaded: Loaded, count: usize) -> Loaded {
    Loaded { findings: loaded.findings.into_iter().take(count).collect(), ..loaded }
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui").join(name)
}

fn folders() -> Vec<String> {
    let list = fs::read_dir(folder("")).unwrap();
    let mut names: Vec<_> = list.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn load(name: &str) -> Loaded {
    match GENERATED.iter().find(|(folder, _)| *folder == name) {
        Some((_, make)) => make(),
        None => load_bytes(SHOWN, &fs::read(folder(name).join("input.yaml")).unwrap()),
    }
}

/// Every fixture, loaded once for all tests.
fn all() -> &'static [(String, Loaded)] {
    static ALL: OnceLock<Vec<(String, Loaded)>> = OnceLock::new();
    ALL.get_or_init(|| {
        for (name, _) in GENERATED {
            fs::create_dir_all(folder(name)).unwrap();
        }
        folders().into_iter().map(|name| (name.clone(), load(&name))).collect()
    })
}

fn shown(loaded: &Loaded) -> String {
    let text = report(&loaded.findings, &loaded.source, &Renderer::plain());
    let text = text.replace(loaded.source.name(), SHOWN);
    text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n") + "\n"
}

#[test]
fn reports() {
    let accept = std::env::var_os("UPDATE_EXPECT").is_some();
    let mut wrong = String::new();
    for (name, loaded) in all() {
        assert_eq!(loaded.model.is_some(), loaded.counts().0 == 0, "{name}: a model exists if there is no error");
        let text = shown(loaded);
        let file = folder(name).join("expected.txt");
        if accept {
            fs::write(&file, text).unwrap();
            continue;
        }
        let expected = fs::read_to_string(&file).unwrap_or_default();
        if text != expected {
            write!(wrong, "== {name}: expected\n{expected}== {name}: got\n{text}\n").unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}\n`UPDATE_EXPECT=1 cargo test -p regdef --test ui` accepts these reports");
}

#[test]
fn every_code_has_a_fixture() {
    let all: String =
        folders().iter().map(|name| fs::read_to_string(folder(name).join("expected.txt")).unwrap()).collect();
    let missing: Vec<_> = Code::ALL.iter().map(|c| c.as_str()).filter(|c| !all.contains(&format!("[{c}]"))).collect();
    assert!(missing.is_empty(), "no fixture shows {missing:?}");
}

#[test]
fn codes_are_unique_and_explained() {
    let mut seen = HashSet::new();
    for code in Code::ALL {
        assert!(seen.insert(code.as_str()), "{} stands twice", code.as_str());
        assert!(code.explanation().ends_with('.'), "{}: {}", code.as_str(), code.explanation());
    }
}

#[test]
fn places_are_inside_the_text() {
    for (name, loaded) in all() {
        for finding in &loaded.findings {
            for label in &finding.labels {
                if let Some(range) = loaded.source.range(&label.at) {
                    assert!(loaded.source.text().get(range.clone()).is_some(), "{name}: {range:?} of {finding:?}");
                }
            }
        }
    }
}

#[test]
fn nothing_is_reported_twice() {
    for (name, loaded) in all() {
        let findings = &loaded.findings;
        for (index, finding) in findings.iter().enumerate() {
            assert!(!findings[..index].contains(finding), "{name}: {finding:?}");
        }
    }
}
