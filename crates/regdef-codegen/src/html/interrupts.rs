//! The page of the interrupts.

use minijinja::{Value, context};
use regdef::model::{InterruptId, LineId};

use super::book::Book;
use super::overview::anchor;
use super::text::{code_link, safe};

/// Lines, the tree of sources below them, and a table of all sources.
pub(super) fn view(book: &Book<'_>) -> Value {
    let interrupts = &book.model.interrupts;
    let line_link = |id: LineId| code_link(&book.line(id), &interrupts.lines[id.0].name);
    let source_link = |id: InterruptId| code_link(&book.interrupt(id), &interrupts.sources[id.0].name);
    let lines = interrupts.lines.iter().enumerate().map(|(index, line)| {
        let reach = interrupts.sources.iter().filter(|s| s.lines.contains(&LineId(index))).count();
        context! {
            id => anchor(&book.line(LineId(index))), name => line.name.clone(),
            doc => safe(book.inline(&line.doc, None)),
            enable => line.enable.map(|at| safe(book.field_link(at))), select => line.select, reach,
            cites => safe(book.cites(&line.cites)),
        }
    });
    let sources = interrupts.sources.iter().enumerate().map(|(index, source)| {
        let reaches = source.lines.iter().map(|&l| line_link(l)).chain(source.feeds.iter().map(|&s| source_link(s)));
        let fed = interrupts.sources.iter().enumerate().filter(|(_, s)| s.feeds.contains(&InterruptId(index)));
        context! {
            id => anchor(&book.interrupt(InterruptId(index))), name => source.name.clone(),
            doc => safe(book.inline(&source.doc, None)),
            flag => safe(book.field_link(source.flag)), enable => source.enable.map(|at| safe(book.field_link(at))),
            select => source.select.map(|at| safe(book.field_link(at))),
            reaches => safe(reaches.collect::<Vec<_>>().join(", ")),
            fed_by => safe(fed.map(|(i, _)| source_link(InterruptId(i))).collect::<Vec<_>>().join(", ")),
            code => source.code.map(|(first, last)| if first == last { first.to_string() } else { format!("{first}–{last}") }),
            cleared_by => safe(book.inline(&source.cleared_by, None)), cites => safe(book.cites(&source.cites)),
        }
    });
    context! {
        doc => safe(book.paragraphs(&interrupts.doc, None)), cites => safe(book.cites(&interrupts.cites)),
        lines => lines.collect::<Vec<_>>(), sources => sources.collect::<Vec<_>>(), tree => safe(tree(book)),
        has_select => interrupts.sources.iter().any(|s| s.select.is_some()),
        has_code => interrupts.sources.iter().any(|s| s.code.is_some()),
    }
}

/// The tree as nested lists: lines, the sources that reach them, the sources that feed those. Sources that reach
/// the same lines and are fed by nothing stand in one entry.
fn tree(book: &Book<'_>) -> String {
    let interrupts = &book.model.interrupts;
    let mut groups: Vec<(&[LineId], Vec<InterruptId>)> = Vec::new();
    for (index, source) in interrupts.sources.iter().enumerate().filter(|(_, s)| !s.lines.is_empty()) {
        match groups.iter_mut().find(|(lines, _)| *lines == source.lines) {
            Some((_, all)) => all.push(InterruptId(index)),
            None => groups.push((&source.lines, vec![InterruptId(index)])),
        }
    }
    let mut html = String::new();
    for (lines, sources) in groups {
        let names: Vec<_> = lines.iter().map(|&l| code_link(&book.line(l), &interrupts.lines[l.0].name)).collect();
        let selected = sources.iter().any(|s| interrupts.sources[s.0].select.is_some());
        let which =
            if lines.len() > 1 && selected { " <span class=\"dim\">as the line-select bit says</span>" } else { "" };
        html +=
            &format!("<li>Line {}{which}<ul>{}</ul></li>", names.join(" or "), branch(book, &sources, &mut Vec::new()));
    }
    html
}

fn branch(book: &Book<'_>, sources: &[InterruptId], above: &mut Vec<InterruptId>) -> String {
    let interrupts = &book.model.interrupts;
    let mut html = String::new();
    for &id in sources {
        let source = &interrupts.sources[id.0];
        let below: Vec<_> = (0..interrupts.sources.len())
            .map(InterruptId)
            .filter(|&s| interrupts.sources[s.0].feeds.contains(&id) && !above.contains(&s) && s != id)
            .collect();
        let mut line = format!(
            "{} <span class=\"dim\">flag</span> {}",
            code_link(&book.interrupt(id), &source.name),
            book.field_link(source.flag)
        );
        if let Some(at) = source.enable {
            line += &format!(" <span class=\"dim\">enable</span> {}", book.field_link(at));
        }
        if below.is_empty() {
            html += &format!("<li>{line}</li>");
        } else {
            above.push(id);
            html += &format!("<li>{line}<ul>{}</ul></li>", branch(book, &below, above));
            above.pop();
        }
    }
    html
}
