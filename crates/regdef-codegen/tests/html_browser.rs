//! The scripts of the site do in a browser what they are for: search, decode, theme. From `file://`, without a network.

mod common;

use std::path::Path;
use std::process::Command;
use std::fs;

use regdef_codegen::html::site;
use scraper::{Html, Selector};
use tempfile::TempDir;

/// The site over the small descriptions, in a folder.
fn written() -> TempDir {
    let folder = TempDir::new().expect("a temporary folder");
    let models = common::features();
    for file in site(&models.iter().map(|(_, model)| model).collect::<Vec<_>>()) {
        let path = folder.path().join(&file.path);
        fs::create_dir_all(path.parent().expect("inside the folder")).expect("the folder can be made");
        fs::write(path, file.content).expect("the file can be written");
    }
    folder
}

/// The document as the browser sees it after the scripts have run.
fn visit(site: &Path, page: &str) -> Html {
    let profile = TempDir::new().expect("a temporary folder");
    let output = Command::new("chromium")
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync", "--dump-dom"])
        .args(["--virtual-time-budget=4000", "--window-size=1200,900"])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(format!("file://{}/{page}", site.display()))
        .output()
        .unwrap_or_else(|e| panic!("chromium: {e}; it is the Debian package `chromium`"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Html::parse_document(&String::from_utf8_lossy(&output.stdout))
}

fn texts(page: &Html, selector: &str) -> Vec<String> {
    let selector = Selector::parse(selector).unwrap_or_else(|e| panic!("{selector}: {e}"));
    page.select(&selector).map(|e| e.text().collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn search_finds_fields_by_name_and_by_meaning() {
    let site = written();
    let page = visit(site.path(), "access/plain.html?q=plain.niso");
    assert_eq!(texts(&page, "#site-results .name").first().map(String::as_str), Some("PLAIN.NISOStored fields"));
    let first = Selector::parse("#site-results a[aria-selected='true']").expect("a selector");
    let hit = page.select(&first).next().expect("the first match is chosen");
    assert_eq!(hit.attr("href"), Some("../access/plain.html#niso"));

    let page = visit(site.path(), "index.html?q=bus+off");
    assert!(texts(&page, "#site-results .name").iter().any(|name| name.starts_with("IR.BO")), "Bus_Off is bus off");
    assert!(texts(&page, "#site-results mark").iter().any(|text| text == "Bus"), "what matches is marked");

    let page = visit(site.path(), "index.html?q=no+such+thing+anywhere");
    assert_eq!(texts(&page, "#site-results"), ["Nothing is called that or says that."]);

    // Text of a description stays text in the list of matches.
    let page = visit(site.path(), "index.html?q=onerror+alert");
    assert_eq!(texts(&page, "#site-results img").len(), 0);
    let page = visit(site.path(), "index.html?q=alert");
    assert!(texts(&page, "#site-results .text").iter().any(|text| text.contains("<script>")));
}

#[test]
fn a_value_is_decoded_into_fields() {
    let site = written();
    // 0x0f25: OPMOD 1 is in the run `listen`, REQOP 7 has a name, bit 2 belongs to no field, FORM is 1.
    let page = visit(site.path(), "values/con.html?value=0x0725");
    let fields = texts(&page, ".decode .field");
    let says = |name: &str| fields.iter().find(|f| f.starts_with(name)).unwrap_or_else(|| panic!("{name}: {fields:?}")).clone();
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
    let site = written();
    // OPMOD 5 is reserved; REQOP 3 has no name at all.
    let page = visit(site.path(), "values/con.html?value=0b0000_0011_1010_0000");
    let bad = texts(&page, ".decode .bad .says");
    assert_eq!(bad, ["no such value in the manual", "reserved: must not be used"]);
    // BRP 32 is above its limit, SEG 3 means 4 tq, OFS 15 is -1.
    let page = visit(site.path(), "values/cfg.html?value=62240");
    assert_eq!(texts(&page, ".decode .bad .says"), ["illegal: only 0 to 31 may be programmed"]);
    let says = texts(&page, ".decode .says");
    assert_eq!(says[0], "= -1 tq");
    assert_eq!(says[1], "= 4 tq");
    // MARK must be 5 whenever the register is written.
    let page = visit(site.path(), "access/plain.html?value=0");
    assert_eq!(texts(&page, ".decode .bad .says"), ["must be written 5"]);
}

#[test]
fn lanes_are_told_apart_and_words_of_messages_decode_too() {
    let site = written();
    let page = visit(site.path(), "lanes/fltcon.html?value=0x80000003");
    let names = texts(&page, ".decode .field label");
    assert_eq!(names.first().map(String::as_str), Some("FLTEN3 [31]"));
    assert_eq!(names.last().map(String::as_str), Some("F0BP [4:0]"));
    assert_eq!(texts(&page, ".decode .field.changed label"), ["FLTEN3 [31]", "F0BP [4:0]"]);
    let page = visit(site.path(), "messages/messages.html");
    assert_eq!(texts(&page, ".decode h2").len(), 3, "one box for each word");
}

#[test]
fn the_theme_can_be_chosen() {
    let site = written();
    let dark = Selector::parse("html[data-theme='dark']").expect("a selector");
    assert!(visit(site.path(), "index.html?theme=dark").select(&dark).next().is_some());
    assert!(visit(site.path(), "index.html?theme=nonsense").select(&dark).next().is_none());
}
