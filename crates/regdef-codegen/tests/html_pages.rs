//! What the pages say about small descriptions, one per feature of the language: the content of every page in a
//! plain notation, so that a change of what a reader sees is a change of a snapshot.
//!
//! `[text](address)` is a link, `{rw NAME[7:0] rw*}` a field of a diagram with the class of its colour, `#id` an
//! anchor.

mod common;

use std::fmt::Write as _;

use regdef_codegen::html::site;
use scraper::{ElementRef, Html, Selector};

/// The content of an element, a line for each block.
fn outline(element: ElementRef<'_>, out: &mut String) {
    for child in element.children() {
        if let Some(text) = child.value().as_text() {
            let text: &str = text;
            let words: Vec<_> = text.split_whitespace().collect();
            if words.is_empty() {
                continue;
            }
            if text.starts_with(char::is_whitespace) && !out.ends_with([' ', '\n']) {
                out.push(' ');
            }
            out.push_str(&words.join(" "));
            if text.ends_with(char::is_whitespace) {
                out.push(' ');
            }
            continue;
        }
        let Some(inner) = ElementRef::wrap(child) else { continue };
        match inner.value().name() {
            "svg" => diagram(inner, out),
            // The data of a decode box says nothing that the table does not.
            "script" | "caption" => {}
            "a" if inner.attr("href").is_some() => {
                let text: String = inner.text().collect();
                let _ = write!(out, "[{}]({})", text.trim(), inner.attr("href").unwrap_or_default());
            }
            "td" | "th" | "dt" => {
                outline(inner, out);
                out.push_str(" | ");
            }
            "h1" | "h2" | "h3" | "p" | "tr" | "li" | "dl" | "ul" | "table" | "section" | "aside" | "figure"
            | "details" | "div" => {
                line(out);
                if let Some(id) = inner.attr("id") {
                    let _ = write!(out, "#{id} ");
                }
                outline(inner, out);
                line(out);
            }
            _ => outline(inner, out),
        }
    }
}

fn line(out: &mut String) {
    let end = out.trim_end_matches(' ').len();
    out.truncate(end);
    if !out.is_empty() && !out.ends_with('\n') {
        out.push('\n');
    }
}

/// The wide form of a diagram; the narrow one has the same content.
fn diagram(svg: ElementRef<'_>, out: &mut String) {
    if svg.attr("class").is_some_and(|class| class.contains("narrow")) {
        return;
    }
    let texts = Selector::parse("a, text.none, text.rs").expect("a selector");
    let class = Selector::parse("rect").expect("a selector");
    let (mut cells, mut reset) = (Vec::new(), String::new());
    for element in svg.select(&texts) {
        let text: Vec<_> =
            element.children().filter_map(ElementRef::wrap).filter(|e| e.value().name() == "text").collect();
        match element.value().name() {
            "a" => {
                let kind = element.select(&class).next().and_then(|rect| rect.attr("class")).unwrap_or_default();
                let words: Vec<String> = text.iter().map(|t| t.text().collect()).collect();
                cells.push(format!("{{{} {}}}", kind.trim_start_matches("f-"), words.join(" ")));
            }
            _ if element.attr("class") == Some("none") => cells.push("{-}".to_owned()),
            _ => reset.extend(element.text()),
        }
    }
    line(out);
    let _ = writeln!(out, "{} {reset}", cells.join(""));
}

#[test]
fn pages_of_each_feature() {
    let main = Selector::parse("main").expect("a selector");
    for (name, model) in common::features() {
        let mut all = String::new();
        for file in site(&[&model]).iter().filter(|f| f.path.starts_with(&model.names.id) && f.path.ends_with(".html"))
        {
            let page = Html::parse_document(&file.content);
            let _ = writeln!(all, "\n=== {}", file.path);
            let main = page.select(&main).next().expect("every page has its content in `main`");
            let mut text = String::new();
            outline(main, &mut text);
            // The overview ends with the legend, which is the same for every controller.
            let text = text.split("#how-to-read").next().unwrap_or_default();
            all.push_str(text);
        }
        insta::assert_snapshot!(name, all);
    }
}
