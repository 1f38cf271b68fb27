//! The whole site is well-formed HTML, every link leads somewhere, and nothing of a description becomes markup.

mod common;

use std::collections::{HashMap, HashSet};

use regdef_codegen::OutputFile;
use regdef_codegen::html::site;
use scraper::{Html, Selector};

fn features_site() -> Vec<OutputFile> {
    let models = common::features();
    site(&models.iter().map(|(_, model)| model).collect::<Vec<_>>())
}

fn pages(files: &[OutputFile]) -> Vec<(&str, Html)> {
    let html = files.iter().filter(|f| f.path.ends_with(".html"));
    html.map(|f| (f.path.as_str(), Html::parse_document(&f.content))).collect()
}

fn select(selector: &str) -> Selector {
    Selector::parse(selector).unwrap_or_else(|e| panic!("{selector}: {e}"))
}

fn ids<'a>(page: &'a Html, path: &str) -> HashSet<&'a str> {
    let mut ids = HashSet::new();
    for element in page.select(&select("[id]")) {
        let id = element.attr("id").unwrap_or_default();
        assert!(!id.is_empty() && !id.contains(char::is_whitespace), "{path}: the id {id:?}");
        assert!(ids.insert(id), "{path}: the id {id} stands twice");
    }
    ids
}

/// The path a link on a page leads to, and its anchor.
fn resolve(from: &str, link: &str) -> (String, Option<String>) {
    let (path, anchor) = match link.split_once('#') {
        Some((path, anchor)) => (path, Some(anchor.to_owned())),
        None => (link, None),
    };
    if path.is_empty() {
        return (from.to_owned(), anchor);
    }
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            ".." => assert!(parts.pop().is_some(), "{from}: {link} leads out of the site"),
            part => parts.push(part),
        }
    }
    (parts.join("/"), anchor)
}

/// Checks every page, and gives the number of links.
fn check(files: &[OutputFile]) -> usize {
    let pages = pages(files);
    let anchors: HashMap<&str, HashSet<&str>> = pages.iter().map(|(path, page)| (*path, ids(page, path))).collect();
    let others: HashSet<&str> = files.iter().map(|f| f.path.as_str()).collect();
    let mut links = 0;
    for (path, page) in &pages {
        assert!(page.errors.is_empty(), "{path}: {:?}", page.errors);
        for once in ["h1", "head title", "main", "html[lang]"] {
            assert_eq!(page.select(&select(once)).count(), 1, "{path}: {once}");
        }
        for (selector, attribute) in [("a[href]", "href"), ("link[rel=stylesheet]", "href"), ("script[src]", "src")] {
            for element in page.select(&select(selector)) {
                let link = element.attr(attribute).unwrap_or_default();
                assert!(!link.contains(':'), "{path}: {link} leaves the site");
                let (target, anchor) = resolve(path, link);
                assert!(others.contains(target.as_str()), "{path}: {link} leads nowhere");
                if let Some(anchor) = anchor {
                    assert!(anchors[target.as_str()].contains(anchor.as_str()), "{path}: {link} has no anchor");
                }
                links += 1;
            }
        }
        for element in page.select(&select("[aria-controls]")) {
            let id = element.attr("aria-controls").unwrap_or_default();
            assert!(anchors[path].contains(id), "{path}: aria-controls {id}");
        }
        for script in page.select(&select("script[type='application/json']")) {
            let text: String = script.text().collect();
            serde_json::from_str::<serde_json::Value>(&text).unwrap_or_else(|e| panic!("{path}: {e}: {text}"));
        }
    }
    links
}

#[test]
fn pages_are_well_formed_and_every_link_resolves() {
    let links = check(&features_site());
    assert!(links > 1000, "only {links} links were found");
}

#[test]
fn the_reference_of_the_real_controllers_is_well_formed() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../regdefs");
    let names = ["m_can", "dspic33-canfd", "dspic33-ecan", "pic32-can"];
    let models = names.map(|name| common::load(&folder.join(name).with_extension("yaml")));
    let links = check(&site(&models.each_ref()));
    assert!(links > 20_000, "only {links} links were found");
}

#[test]
fn the_search_index_names_everything_and_resolves() {
    let files = features_site();
    let pages = pages(&files);
    let anchors: HashMap<&str, HashSet<&str>> = pages.iter().map(|(path, page)| (*path, ids(page, path))).collect();
    let index = files.iter().find(|f| f.path == "assets/search.js").expect("the site has a search index");
    let json = index.content.trim().strip_prefix("window.REGDEF_INDEX=").and_then(|t| t.strip_suffix(';'));
    let index: serde_json::Value =
        serde_json::from_str(json.expect("the index is one assignment")).expect("the index is JSON");
    let mut names = HashSet::new();
    for entry in index["entries"].as_array().expect("entries") {
        let (target, anchor) = resolve("index.html", entry[4].as_str().expect("an address"));
        assert!(anchors.contains_key(target.as_str()), "{entry}");
        assert!(anchor.is_none_or(|a| anchors[target.as_str()].contains(a.as_str())), "{entry}");
        names.insert(entry[2].as_str().unwrap_or_default().to_owned());
    }
    for (_, model) in common::features() {
        for register in &model.registers {
            for field in &register.fields {
                let name = format!("{}.{}", register.name, field.label.replace("{n}", "n"));
                let lanes = format!("{name}n");
                assert!(names.contains(&name) || names.contains(&lanes), "{name} cannot be found");
            }
        }
        for conflict in &model.conflicts {
            assert!(names.contains(&conflict.id), "{} cannot be found", conflict.id);
        }
    }
}

#[test]
fn text_of_a_description_never_becomes_markup() {
    for (path, page) in pages(&features_site()) {
        let own_scripts = if page.select(&select("script[src$='decode.js']")).next().is_some() { 3 } else { 2 };
        assert_eq!(page.select(&select("script:not([type])")).count(), own_scripts, "{path}");
        for element in ["img", "main i", "script[type] *"] {
            assert!(page.select(&select(element)).next().is_none(), "{path}: a {element}");
        }
        let comments = page.tree.nodes().filter(|node| node.value().is_comment()).count();
        assert_eq!(comments, 0, "{path}");
    }
}

#[test]
fn cross_links_lead_in_both_directions() {
    let files = features_site();
    let has = |path: &str, at: &str, link: &str| {
        let file = files.iter().find(|f| f.path == path).unwrap_or_else(|| panic!("{path} is missing"));
        let page = Html::parse_document(&file.content);
        let selector = format!("{at} a[href='{link}']");
        assert!(page.select(&select(&selector)).next().is_some(), "{path} has no {selector}");
    };
    // Register, field and conflict.
    has("behaviour/cccr.html", "aside.conflict", "conflicts.html#two_resets");
    has("behaviour/ir.html", "[id='bo']", "conflicts.html#two_resets");
    has("behaviour/conflicts.html", "[id='two_resets']", "cccr.html");
    has("behaviour/conflicts.html", "[id='two_resets']", "ir.html#bo");
    // Field and condition.
    has("access/plain.html", "[id='niso']", "conditions.html#config");
    has("access/conditions.html", "[id='config']", "plain.html#niso");
    has("access/plain.html", "[id='cce']", "conditions.html#config");
    // Field and enumeration.
    has("values/con.html", "[id='opmod']", "enums.html#mode");
    has("values/enums.html", "[id='mode']", "con.html#opmod");
    // Interrupt, effect, memory, joined value.
    has("behaviour/ie.html", "[id='rf0ne']", "interrupts.html#rf0n");
    has("behaviour/interrupts.html", "[id='rf0n']", "ie.html#rf0ne");
    has("behaviour/ie.html", "[id='boe']", "effects.html#cccr_cce");
    has("messages/rxf0c.html", "[id='f0sa']", "memory.html#rx_fifo_0");
    has("messages/messages.html", "[id='rx_element']", "memory.html#rx_fifo_0");
    has("clusters/joined.html", "[id='fifoua']", "fifoual.html");
    has("clusters/fifoual.html", ".refs", "joined.html#fifoua");
    // Names in prose.
    has("arrays/dma.html", ".lead", "rxf.html#sid");
}

#[test]
fn the_same_models_give_the_same_bytes() {
    assert_eq!(features_site(), features_site());
}
