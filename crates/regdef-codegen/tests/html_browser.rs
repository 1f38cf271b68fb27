//! The scripts of the site do in a browser what they are for: search, decode, theme. From `file://`, without a network.

mod common;

use std::fs;
use std::process::Command;
use std::sync::LazyLock;

use regdef_codegen::html::site;
use scraper::{Html, Selector};
use tempfile::TempDir;

/// The pages the tests look at.
const VISITS: &[&str] = &[
    "access/plain.html?q=plain.niso",
    "index.html?q=bus+off",
    "index.html?q=no+such+thing+anywhere",
    "index.html?q=onerror+alert",
    "index.html?q=alert",
    "values/con.html?value=0x0725",
    "values/con.html?value=0b0000_0011_1010_0000",
    "values/cfg.html?value=62240",
    "access/plain.html?value=0",
    "lanes/fltcon.html?value=0x80000003",
    "messages/messages.html",
    "index.html?theme=dark",
    "index.html?theme=nonsense",
    "windows/ctrl.html",
    "aliases/con.html",
    "values/cfg.html",
    "access/flags.html",
];

/// All visits in one run of the browser: a page that holds each of them in a frame and, when everything has
/// loaded and a reader has acted on some of them, writes down what the scripts have made of it.
const HARNESS: &str = include_str!("browser/harness.html");

/// The documents of [`VISITS`] after the scripts have run.
static SEEN: LazyLock<Vec<String>> = LazyLock::new(|| {
    let folder = TempDir::new().expect("a temporary folder");
    let models = common::features();
    for file in site(&models.iter().map(|(_, model)| model).collect::<Vec<_>>()) {
        let path = folder.path().join(&file.path);
        fs::create_dir_all(path.parent().expect("inside the folder")).expect("the folder can be made");
        fs::write(path, file.content).expect("the file can be written");
    }
    let harness = folder.path().join("harness.html");
    fs::write(&harness, HARNESS.replace("VISITS", &serde_json::json!(VISITS).to_string()))
        .expect("the file can be written");
    let output = Command::new("chromium")
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync", "--dump-dom"])
        .args(["--allow-file-access-from-files", "--virtual-time-budget=20000", "--window-size=1200,900"])
        .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
        .arg(format!("file://{}", harness.display()))
        .output()
        .unwrap_or_else(|e| panic!("chromium: {e}; it is the Debian package `chromium`"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let dump = Html::parse_document(&String::from_utf8_lossy(&output.stdout));
    let seen = Selector::parse("pre").expect("a selector");
    dump.select(&seen).map(|pre| pre.text().collect()).collect()
});

/// The document as the browser sees it after the scripts have run.
fn visit(page: &str) -> Html {
    let at = VISITS.iter().position(|v| *v == page).unwrap_or_else(|| panic!("{page} is not among the visits"));
    assert_eq!(SEEN.len(), VISITS.len(), "the browser did not get to the end");
    Html::parse_document(&SEEN[at])
}

fn texts(page: &Html, selector: &str) -> Vec<String> {
    let selector = Selector::parse(selector).unwrap_or_else(|e| panic!("{selector}: {e}"));
    page.select(&selector)
        .map(|e| e.text().collect::<String>().split_whitespace().collect::<Vec<_>>().join(" "))
        .collect()
}

#[test]
fn search_finds_fields_by_name_and_by_meaning() {
    let page = visit("access/plain.html?q=plain.niso");
    assert_eq!(texts(&page, "#site-results .name").first().map(String::as_str), Some("PLAIN.NISOStored fields"));
    let first = Selector::parse("#site-results a[aria-selected='true']").expect("a selector");
    let hit = page.select(&first).next().expect("the first match is chosen");
    assert_eq!(hit.attr("href"), Some("../access/plain.html#niso"));

    let page = visit("index.html?q=bus+off");
    assert!(texts(&page, "#site-results .name").iter().any(|name| name.starts_with("IR.BO")), "Bus_Off is bus off");
    assert!(texts(&page, "#site-results mark").iter().any(|text| text == "Bus"), "what matches is marked");

    let page = visit("index.html?q=no+such+thing+anywhere");
    assert_eq!(texts(&page, "#site-results"), ["Nothing is called that or says that."]);

    // Text of a description stays text in the list of matches.
    let page = visit("index.html?q=onerror+alert");
    assert_eq!(texts(&page, "#site-results img").len(), 0);
    let page = visit("index.html?q=alert");
    assert!(texts(&page, "#site-results .text").iter().any(|text| text.contains("<script>")));
}

#[test]
fn a_value_is_decoded_into_fields() {
    // 0x0725: OPMOD 1 is in the run `listen`, REQOP 7 has a name, bit 2 belongs to no field, FORM is 1.
    let page = visit("values/con.html?value=0x0725");
    let fields = texts(&page, ".decode .field");
    let says = |name: &str| {
        fields.iter().find(|f| f.starts_with(name)).unwrap_or_else(|| panic!("{name}: {fields:?}")).clone()
    };
    assert!(says("OPMOD [7:5]").ends_with("listen: Silent."), "{fields:?}");
    assert!(says("REQOP [10:8]").ends_with("listen_all"), "{fields:?}");
    assert!(says("FORM [0]").ends_with("other"), "{fields:?}");
    assert_eq!(texts(&page, ".decode .problem"), ["Not implemented, but 1: bit 2"]);
    assert_eq!(texts(&page, ".decode .forms"), ["0x0725 · 1829 · 0b0000_0111_0010_0101"]);
    assert_eq!(texts(&page, ".decode .bad").len(), 0);
    let set = texts(&page, ".decode .strip button[aria-pressed='true']");
    assert_eq!(set, ["101", "91", "81", "51", "21", "01"], "number and value of each bit that is 1");
}

#[test]
fn reserved_and_illegal_values_are_marked() {
    // OPMOD 5 is reserved; REQOP 3 has no name at all.
    let page = visit("values/con.html?value=0b0000_0011_1010_0000");
    let bad = texts(&page, ".decode .bad .says");
    assert_eq!(bad, ["no such value in the manual", "reserved: must not be used"]);
    // BRP 32 is above its limit, SEG 3 means 4 tq, OFS 15 is -1.
    let page = visit("values/cfg.html?value=62240");
    assert_eq!(texts(&page, ".decode .bad .says"), ["illegal: only 0 to 31 may be programmed"]);
    let says = texts(&page, ".decode .says");
    assert_eq!(says[0], "= -1 tq");
    assert_eq!(says[1], "= 4 tq");
    // MARK must be 5 whenever the register is written.
    let page = visit("access/plain.html?value=0");
    assert_eq!(texts(&page, ".decode .bad .says"), ["must be written 5"]);
}

#[test]
fn lanes_are_told_apart_and_words_of_messages_decode_too() {
    let page = visit("lanes/fltcon.html?value=0x80000003");
    let names = texts(&page, ".decode .field label");
    assert_eq!(names.first().map(String::as_str), Some("FLTEN3 [31]"));
    assert_eq!(names.last().map(String::as_str), Some("F0BP [4:0]"));
    assert_eq!(texts(&page, ".decode .field.changed label"), ["FLTEN3 [31]", "F0BP [4:0]"]);
    let page = visit("messages/messages.html");
    assert_eq!(texts(&page, ".decode h2").len(), 3, "one box for each word");
}

#[test]
fn the_theme_can_be_chosen() {
    let dark = Selector::parse("html[data-theme='dark']").expect("a selector");
    assert!(visit("index.html?theme=dark").select(&dark).next().is_some());
    assert!(visit("index.html?theme=nonsense").select(&dark).next().is_none());
    let light = Selector::parse("html[data-theme='light']").expect("a selector");
    assert!(
        visit("values/cfg.html").select(&light).next().is_some(),
        "the button goes from the system's choice to light"
    );
}

#[test]
fn the_keyboard_reaches_search_and_its_matches() {
    let page = visit("windows/ctrl.html");
    assert_eq!(
        texts(&page, "#site-search[data-focused][aria-expanded='true']").len(),
        1,
        "`/` did not focus the search"
    );
    let chosen = Selector::parse("#site-results a[aria-selected='true']").expect("a selector");
    let ids: Vec<_> = page.select(&chosen).map(|hit| hit.attr("id").unwrap_or_default()).collect();
    assert_eq!(ids, ["site-hit-1"], "the arrow did not move to the second match");
}

#[test]
fn fields_set_the_value_and_a_button_resets_it() {
    // ON is the only bit that is 1 after reset.
    assert_eq!(
        texts(&visit("aliases/con.html"), ".decode .forms"),
        ["0x00000000 · 0 · 0b0000_0000_0000_0000_0000_0000_0000_0000"]
    );
    // Bit 0 is 1 after reset and toggled, bits 15:12 do not take 16.
    let page = visit("values/cfg.html");
    assert_eq!(texts(&page, ".decode .forms"), ["0x0100 · 256 · 0b0000_0001_0000_0000"]);
    assert_eq!(texts(&page, ".decode .field .says").first().map(String::as_str), Some("does not fit: 0 to 15"));
    let page = visit("access/flags.html");
    assert_eq!(texts(&page, ".decode .problem"), ["Does not fit in 32 bits."]);
    assert_eq!(texts(&page, ".decode .forms"), ["0x00000000 · 0 · 0b0000_0000_0000_0000_0000_0000_0000_0000"]);
}
