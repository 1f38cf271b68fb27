//! Whatever the bytes: loading and reporting never panic, never take long, and name places inside the text.
//!
//! The inputs are made from the descriptions of `tests/features`, `tests/ui` and `tests/corpus` by taking out,
//! repeating and exchanging lines, names, numbers and bytes. Inputs that once failed are kept in `tests/corpus`.
//!
//! `cargo test -p regdef --test fuzz` runs for 15 seconds. `FUZZ_SECONDS=3600 FUZZ_SEED=7` looks longer and
//! elsewhere; `FUZZ_MORE=FOLDER` adds the `.yaml` files of a folder. An input that fails is named in the message.

#![allow(clippy::unwrap_used)]

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use annotate_snippets::Renderer;
use regdef::diagnostic::report;
use regdef::load_bytes;
use regdef::model::{FieldRef, Model, RegisterId};

/// Longest time for one input of the size that is tried here, without optimization on a busy machine.
const LONGEST: Duration = Duration::from_secs(5);

/// Largest input in bytes.
const LARGEST: usize = 256 << 10;

/// A xorshift generator: the inputs of a seed are the same everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit.max(1) as u64) as usize
    }

    fn pick<'a, T: ?Sized>(&mut self, items: &[&'a T]) -> &'a T {
        items[self.below(items.len())]
    }
}

const NUMBERS: &[&str] = &[
    "0",
    "1",
    "2",
    "3",
    "4",
    "7",
    "8",
    "15",
    "16",
    "31",
    "32",
    "33",
    "63",
    "64",
    "65",
    "255",
    "256",
    "4095",
    "4096",
    "4097",
    "65535",
    "65536",
    "65537",
    "4294967295",
    "4294967296",
    "18446744073709551615",
    "18446744073709551616",
    "-1",
    "-0",
    "9223372036854775807",
    "-9223372036854775808",
    "0x7fff_ffff_ffff_ffff",
    "0xffff_ffff_ffff_fffc",
    "0x1_0000_0000",
    "0x",
    "0b1",
    "0o7",
    "1.5",
    "1e9",
    "00",
    "0..3",
    "3..0",
    "0..18446744073709551615",
    "\"31:0\"",
    "\"0:31\"",
    "\"63:0\"",
    "\"1:1\"",
];

const VALUES: &[&str] = &[
    "",
    "~",
    "null",
    "true",
    "[]",
    "{}",
    "\"\"",
    "''",
    "[[[]]]",
    "{a: {b: c}}",
    "*a",
    "&a x",
    "!!str x",
    "!x",
    "|",
    ">-",
    "- x",
    "? x",
    "<<: {}",
    "---",
    "...",
    "%YAML 1.3",
    "# comment",
    "\t",
    "\r",
    "\r\n",
    "\u{2028}",
    "\u{85}",
    "\u{feff}",
    "\u{0}",
    "宽字符",
    "e\u{301}\u{301}\u{301}",
    "🙂",
    "\u{202e}abc",
    "\u{1b}[31m",
    "\"\\u0000\"",
    "\"\\ud800\"",
    "a: b: c",
    "always",
    "reserved",
    "unknown",
    "product",
    "pin",
    "n",
    "[n]",
    "A.B[n] && !C",
    "((((((((((A.B))))))))))",
    "rw",
    "ro",
    "wo",
    "w1c",
    "w0c",
    "w1s",
    "rwhc",
    "rwh",
    "wclr",
    "{n}",
    "name: self",
    "name: \"\"",
    "label: \"{n}\"",
    "lanes: {count: 64, stride: 1}",
    "array: {count: 4096, stride: 0xffff_ffff}",
    "on_read: {effect: clear, byte: 3}",
    "like: {register: A, replace: {A: AAAA}}",
    "when: \"A.B || A.B\"",
    "reset: {value: 1, unknown: 1}",
    "values: {0: a, \"1..9\": b}",
    "extends: RX",
    "window: w",
];

fn yaml_files(folder: &Path, seeds: &mut Vec<Vec<u8>>) {
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            yaml_files(&path, seeds);
        } else if path.extension().is_some_and(|e| e == "yaml" || e == "bin") {
            seeds.push(fs::read(path).unwrap());
        }
    }
}

fn seeds() -> Vec<Vec<u8>> {
    let mut seeds = Vec::new();
    for folder in ["features", "ui", "corpus"] {
        yaml_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder), &mut seeds);
    }
    if let Some(more) = std::env::var_os("FUZZ_MORE") {
        yaml_files(Path::new(&more), &mut seeds);
    }
    seeds
}

/// The start and end of a word of the text around or behind a place.
fn word(text: &str, near: usize, of: fn(char) -> bool) -> Option<(usize, usize)> {
    let near = text.floor_char_boundary(near);
    let start = near + text[near..].find(of)?;
    let end = start + text[start..].find(|c| !of(c)).unwrap_or(text.len() - start);
    Some((start, end))
}

fn name_letter(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

fn digit(c: char) -> bool {
    c.is_ascii_digit()
}

/// One change of the text as a description.
fn change(text: &mut String, other: &str, random: &mut Random) {
    let lines: Vec<&str> = text.split('\n').collect();
    let (one, two) = (random.below(lines.len()), random.below(lines.len()));
    let place = random.below(text.len() + 1);
    match random.below(14) {
        0 => {
            let count = 1 + random.below(4);
            *text = [&lines[..one], &lines[(one + count).min(lines.len())..]].concat().join("\n");
        }
        1 => {
            let count = 1 + random.below(6);
            let part = &lines[one..(one + count).min(lines.len())];
            *text = [&lines[..two], part, &lines[two..]].concat().join("\n");
        }
        2 => {
            let mut lines = lines;
            lines.swap(one, two);
            *text = lines.join("\n");
        }
        3 => {
            let others: Vec<&str> = other.split('\n').collect();
            let from = random.below(others.len());
            let part = &others[from..(from + 1 + random.below(12)).min(others.len())];
            *text = [&lines[..one], part, &lines[two.max(one)..]].concat().join("\n");
        }
        4 => {
            let indent = " ".repeat(random.below(9));
            let changed = format!("{indent}{}", lines[one].trim_start());
            *text = [&lines[..one], &[changed.as_str()], &lines[one + 1..]].concat().join("\n");
        }
        5..=7 => {
            if let Some((start, end)) = word(text, place, digit) {
                text.replace_range(start..end, random.pick(NUMBERS));
            }
        }
        8 | 9 => {
            let from = random.below(other.len() + 1);
            let source = word(other, from, name_letter).map(|(start, end)| &other[start..end]);
            if let (Some((start, end)), Some(name)) = (word(text, place, name_letter), source) {
                text.replace_range(start..end, name);
            }
        }
        10 => {
            let own = random.below(text.len() + 1);
            let source = word(text, own, name_letter).map(|(start, end)| text[start..end].to_owned());
            if let (Some((start, end)), Some(name)) = (word(text, place, name_letter), source) {
                text.replace_range(start..end, &name);
            }
        }
        11 => {
            if let Some(at) = text[text.floor_char_boundary(place)..].find(": ") {
                let start = text.floor_char_boundary(place) + at + 2;
                let end = start + text[start..].find([',', '}', '\n']).unwrap_or(0);
                text.replace_range(start..end, random.pick(VALUES));
            }
        }
        12 => text.insert_str(text.floor_char_boundary(place), random.pick(VALUES)),
        _ => {
            let letter = random
                .pick(&["{", "}", "[", "]", ":", ",", "\"", "'", "\n", " ", "-", "#", "&", "*", "?", "|", ">", "~"]);
            let at = text.floor_char_boundary(place);
            match random.below(2) {
                0 => text.insert_str(at, letter),
                _ => text.truncate(at),
            }
        }
    }
}

fn input(seeds: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let seed = &seeds[random.below(seeds.len())];
    let other = &seeds[random.below(seeds.len())];
    if random.below(8) > 0
        && let (Ok(text), Ok(other)) = (std::str::from_utf8(seed), std::str::from_utf8(other))
    {
        let mut text = text.to_owned();
        for _ in 0..=random.below(5) {
            change(&mut text, other, random);
        }
        text.truncate(text.floor_char_boundary(LARGEST));
        return text.into_bytes();
    }
    let mut bytes = seed.clone();
    for _ in 0..=random.below(16) {
        let at = random.below(bytes.len() + 1);
        match random.below(4) {
            0 => bytes.insert(at, random.next() as u8),
            1 => bytes.truncate(at.max(1)),
            2 => {
                let from = random.below(other.len());
                let part = other[from..(from + random.below(200)).min(other.len())].to_vec();
                bytes.splice(at..at, part);
            }
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
    }
    bytes.truncate(LARGEST);
    bytes
}

/// Asks a model everything that emitters ask.
fn ask(model: &Model) -> usize {
    let mut size = 0;
    for placed in model.instances_of_registers() {
        size += placed.label(model).len();
        let position = placed.position(model);
        for field in &model.register(placed.register).fields {
            size += (0..field.lane_count()).map(|lane| field.label_of(position, lane).len()).sum::<usize>();
        }
    }
    for (index, register) in model.registers.iter().enumerate() {
        size += (register.implemented() | register.writable_bits()).count_ones() as usize;
        for (field_index, field) in register.fields.iter().enumerate() {
            let at = FieldRef { register: RegisterId(index), field: field_index };
            size += model.field_path(at).len();
            size += field.access.notation(|id| model.condition(id).expr.display(model)).len();
            size += (0..field.lane_count()).filter_map(|lane| field.reset_of_lane(register.reset, lane)).count();
        }
    }
    size += model.enums.iter().filter(|e| e.is_total()).count();
    size += model.conditions.iter().map(|c| c.expr.display(model).len() + c.expr.fields().len()).sum::<usize>();
    size += model.messages.iter().map(|m| m.element_bytes(64) as usize).sum::<usize>();
    for message in &model.messages {
        for part in message.joined.iter().flat_map(|joined| &joined.parts) {
            size += part.field.map_or(0, |field| message.words[part.holder].fields[field].name.len());
        }
    }
    size
}

fn check(bytes: &[u8]) {
    let loaded = load_bytes("fuzz.yaml", bytes);
    for finding in &loaded.findings {
        for label in &finding.labels {
            if let Some(range) = loaded.source.range(&label.at) {
                assert!(loaded.source.text().get(range.clone()).is_some(), "{range:?} is outside: {finding:?}");
            }
        }
    }
    let plain = report(&loaded.findings, &loaded.source, &Renderer::plain());
    let styled = report(&loaded.findings, &loaded.source, &Renderer::styled());
    assert!(styled.len() >= plain.len());
    assert_eq!(loaded.model.is_some(), loaded.counts().0 == 0);
    if let Some(model) = &loaded.model {
        ask(model);
    }
}

/// The time of one input; a machine that is busy with other things gets a second and a third chance.
fn check_in_time(bytes: &[u8]) -> Duration {
    let measure = || {
        let start = Instant::now();
        check(bytes);
        start.elapsed()
    };
    let first = measure();
    if first < LONGEST { first } else { measure().min(measure()) }
}

fn number(variable: &str, default: u64) -> u64 {
    std::env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

#[test]
fn nothing_makes_the_loader_fail() {
    let seeds = seeds();
    assert!(seeds.len() > 50, "the descriptions to start from are missing");
    let end = Instant::now() + Duration::from_secs(number("FUZZ_SECONDS", 15));
    let mut random = Random(number("FUZZ_SEED", 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{}.yaml", std::process::id()));
    let (mut count, mut valid, mut slowest) = (0_u64, 0_u64, Duration::ZERO);
    let mut queue = seeds.clone();
    while Instant::now() < end {
        let bytes = queue.pop().unwrap_or_else(|| input(&seeds, &mut random));
        // Also there when the process dies, as it would of a stack that is too deep.
        fs::write(&kept, &bytes).unwrap();
        let outcome = catch_unwind(AssertUnwindSafe(|| check_in_time(&bytes)));
        let Ok(time) = outcome else { panic!("the input that failed is {}", kept.display()) };
        assert!(time < LONGEST, "{time:?} for {}", kept.display());
        slowest = slowest.max(time);
        count += 1;
        valid += u64::from(count.is_multiple_of(64) && load_bytes("fuzz.yaml", &bytes).model.is_some());
    }
    fs::remove_file(&kept).unwrap();
    println!("{count} inputs, about {} of them valid, the slowest {slowest:?}", valid * 64);
    assert!(count > seeds.len() as u64, "not even the descriptions to start from were tried");
}

#[test]
fn the_corpus_is_loaded() {
    for bytes in seeds() {
        check(&bytes);
    }
}
