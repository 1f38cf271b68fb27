//! The report: well formed, complete, and nothing from elsewhere.
#![allow(clippy::unwrap_used)]

use std::sync::LazyLock;

use can_demo::{Options, Story, html, run, story::Fate};
use scraper::{Html, Selector};

static STORY: LazyLock<Story> = LazyLock::new(|| run(&Options::default()).unwrap());
static TEXT: LazyLock<String> = LazyLock::new(|| html::report(&STORY).unwrap());

fn all(page: &Html, selector: &str) -> Vec<String> {
    let selector = Selector::parse(selector).unwrap();
    page.select(&selector).map(|element| element.text().collect()).collect()
}

fn attributes(page: &Html, name: &str) -> Vec<String> {
    let selector = Selector::parse(&format!("[{name}]")).unwrap();
    page.select(&selector).filter_map(|element| element.attr(name)).map(str::to_owned).collect()
}

#[test]
fn it_is_well_formed() {
    let page = Html::parse_document(&TEXT);
    assert!(page.errors.is_empty(), "{:?}", page.errors);
    let mut ids = attributes(&page, "id");
    let count = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), count, "every id stands once");
    assert!(!TEXT.contains("NaN") && !TEXT.contains("inf "), "every coordinate is a number");
}

#[test]
fn it_needs_nothing_from_elsewhere() {
    let page = Html::parse_document(&TEXT);
    let ids = attributes(&page, "id");
    for link in attributes(&page, "href").iter().chain(&attributes(&page, "src")) {
        let inside = link.strip_prefix('#').is_some_and(|id| ids.iter().any(|known| known == id));
        assert!(inside || link == "data:,", "{link}");
    }
    // The one address is the name of the SVG language.
    assert_eq!(TEXT.matches("://").count(), TEXT.matches("http://www.w3.org/2000/svg").count());
    assert!(!TEXT.contains("url(") && !TEXT.contains("@import"));
    assert!(TEXT.contains("default-src 'none'"), "the browser is told so too");
}

#[test]
fn it_shows_the_whole_run() {
    let page = Html::parse_document(&TEXT);
    assert_eq!(all(&page, "svg.bus").len(), 1 + STORY.acts.len());
    assert_eq!(all(&page, "svg.frame").len(), 2, "arbitration and the disturbed frame");
    assert_eq!(all(&page, ".step").len(), STORY.steps.len());
    let accesses: usize = STORY.steps.iter().map(|step| step.records.len()).sum();
    let times = attributes(&page, "data-times");
    assert_eq!(times.iter().map(|times| times.parse::<usize>().unwrap()).sum::<usize>(), accesses);
    assert!(times.len() < accesses, "polls that see the same stand in one row");
    assert_eq!(
        all(&page, ".step tr.w").len(),
        STORY.steps.iter().flat_map(|step| &step.records).filter(|r| r.write).count()
    );
    let texts = all(&page, "dd");
    let sent = STORY.attempts().iter().filter(|attempt| matches!(attempt.fate, Fate::Sent(_))).count();
    let failed = STORY.attempts().iter().filter(|attempt| matches!(attempt.fate, Fate::Failed(_))).count();
    assert_eq!(texts[..2], [sent.to_string(), failed.to_string()]);
    // The overview has a box for every attempt that was not stopped at once, and a mark for every bit that was hit.
    let overview = Selector::parse("svg.bus").unwrap();
    let first = page.select(&overview).next().unwrap();
    let boxes = first.select(&Selector::parse("rect.sends").unwrap()).count();
    assert_eq!(boxes, STORY.attempts().len());
    let hits: usize = STORY.faults.iter().map(|fault| STORY.hits(fault).len()).sum();
    assert_eq!(first.select(&Selector::parse("path.hit").unwrap()).count(), hits);
}

/// Registers and values of both controllers stand there under the manual's names.
#[test]
fn the_trace_is_decoded() {
    let page = Html::parse_document(&TEXT);
    let rows = all(&page, ".step tr");
    for expected in ["CCCR", "NBTP", "ECR", "TREC", "FIFOUA"] {
        assert!(rows.iter().any(|row| row.contains(expected)), "{expected}");
    }
    assert!(rows.iter().any(|row| row.contains("TEC=135")), "the motor's driver reads the counter at error passive");
    assert!(rows.iter().any(|row| row.contains("TERRCNT") || row.contains("RERRCNT=32")), "so does the panel's");
}
