//! The first page of a controller, and the index over the controllers.

use minijinja::{Value, context};
use regdef::model::{AccessCode, AliasOp, ClusterId, Model, RegisterId, WindowId};

use super::access;
use super::book::{Book, label};
use super::field::grouped;
use super::register::{address, codes, short_reset};
use super::text::{link, offset, safe};
use super::xref::Xref;

/// A page that a controller has if it has something for it: file, title, number of entries.
pub(super) fn pages(model: &Model) -> Vec<(&'static str, &'static str, usize)> {
    let timing = usize::from(model.bit_timing.is_some());
    let interrupts = model.interrupts.sources.len() + model.interrupts.lines.len();
    let all = [
        ("interrupts.html", "Interrupts", interrupts),
        ("messages.html", "Message layouts", model.messages.len()),
        ("memory.html", "Message memory", model.memory.sections.len()),
        ("timing.html", "Bit timing", timing),
        ("enums.html", "Enumerations", model.enums.len()),
        ("conditions.html", "Conditions", model.conditions.len()),
        ("effects.html", "Effects", model.effects.len()),
        ("joined.html", "Joined values", model.joined.len()),
        ("chips.html", "Known chips", model.instances.len()),
        ("conflicts.html", "Conflicts of the manual", model.conflicts.len()),
        ("choices.html", "What the manual leaves open", model.choices.len()),
    ];
    all.into_iter().filter(|(_, _, count)| *count > 0).collect()
}

/// The entries of the navigation of a controller.
pub(super) fn navigation(book: &Book<'_>) -> Value {
    let model = book.model;
    let entry = |(id, register): (RegisterId, &regdef::model::Register)| {
        context! { link => book.register(id), name => label(model, register), title => register.title.clone() }
    };
    let mut groups =
        vec![context! { title => "Registers", registers => model.block_registers().map(entry).collect::<Vec<_>>() }];
    for (index, cluster) in model.clusters.iter().enumerate() {
        let registers = model.cluster_registers(ClusterId(index)).map(entry).collect::<Vec<_>>();
        groups.push(context! { title => format!("{} (×{})", cluster.title, cluster.dim.count), registers });
    }
    let pages =
        pages(model).into_iter().map(|(link, title, count)| context! { link, title, count }).collect::<Vec<_>>();
    context! { id => model.names.id.clone(), title => model.title.clone(), pages, groups }
}

/// The card of a controller on the first page of the site.
pub(super) fn card(book: &Book<'_>) -> Value {
    let model = book.model;
    let fields: usize = model.registers.iter().map(|r| r.fields.len()).sum();
    context! {
        id => model.names.id.clone(), title => model.title.clone(), doc => model.doc.clone(),
        manual => context! {
            title => model.manual.title.clone(), publisher => model.manual.publisher.clone(),
            document => model.manual.document.clone(),
            revision => model.manual.revision.clone(), date => model.manual.date.clone(),
        },
        counts => vec![
            (model.instances_of_registers().len(), "registers"), (fields, "fields"), (model.enums.len(), "enumerations"),
            (model.messages.len(), "message layouts"), (model.conflicts.len(), "conflicts"),
        ].into_iter().map(|(count, what)| context! { count, what }).collect::<Vec<_>>(),
        pages => pages(model).into_iter().map(|(link, title, _)| context! { link, title }).collect::<Vec<_>>(),
    }
}

/// What the first page of a controller shows.
pub(super) fn view(book: &Book<'_>, xref: &Xref) -> Value {
    let model = book.model;
    let op = |op| match op {
        AliasOp::Clear => "cleared",
        AliasOp::Set => "set",
        AliasOp::Invert => "inverted",
    };
    let widths: Vec<String> = model.access_widths.iter().map(u8::to_string).collect();
    context! {
        card => card(book),
        doc => safe(book.paragraphs(&model.doc, None)),
        manual_doc => model.manual.doc.as_ref().map(|d| safe(book.paragraphs(d, None))),
        widths => access::list(&widths.iter().map(String::as_str).collect::<Vec<_>>()),
        span => format!("{} (0x{:X})", bytes(model.span), model.span),
        prefix => model.prefix.clone(),
        krate => model.names.krate.clone(),
        type_name => model.names.ident.pascal.clone(),
        sources => model.sources.iter().map(|(key, s)| context! {
            id => Book::source(key).split_once('#').map(|(_, id)| id.to_owned()),
            key, title => s.title.clone(), locator => s.locator.clone(),
            doc => s.doc.as_ref().map(|d| safe(book.inline(d, None))),
        }).collect::<Vec<_>>(),
        aliases => model.aliases.iter().map(|a| context! {
            name => a.name.clone(), offset => format!("0x{:X}", a.offset), op => op(a.op),
            doc => safe(book.inline(&a.doc, None)), cites => safe(book.cites(&a.cites)),
        }).collect::<Vec<_>>(),
        windows => model.windows.iter().enumerate().map(|(i, w)| context! {
            id => anchor(&book.window(WindowId(i))), name => w.name.clone(),
            select => safe(book.field_link(w.select)), value => w.value,
            doc => safe(book.inline(&w.doc, None)), cites => safe(book.cites(&w.cites)),
            registers => model.registers.iter().filter(|r| r.window == Some(WindowId(i))).count(),
        }).collect::<Vec<_>>(),
        clusters => model.clusters.iter().enumerate().map(|(i, c)| cluster(book, xref, ClusterId(i), c)).collect::<Vec<_>>(),
        map => map(book),
        device => model.block_registers().filter(|(_, r)| r.offset.is_none()).map(|(id, _)| row(book, id)).collect::<Vec<_>>(),
        codes => AccessCode::ALL.into_iter().map(|c| context! {
            code => c.as_str(), words => access::words(c), meaning => c.meaning(),
        }).collect::<Vec<_>>(),
        windowed => !model.windows.is_empty(),
        has_reserved => !model.reserved.is_empty(),
    }
}

fn cluster(book: &Book<'_>, xref: &Xref, id: ClusterId, cluster: &regdef::model::Cluster) -> Value {
    let last = cluster.dim.first + cluster.dim.count - 1;
    context! {
        id => anchor(&book.cluster(id)), name => cluster.name.clone(), title => cluster.title.clone(),
        doc => safe(book.paragraphs(&cluster.doc, None)),
        cites => safe(book.cites(&cluster.cites)),
        repeats => format!(
            "{} elements, numbered {} to {last}, {} bytes apart from {}",
            cluster.dim.count, cluster.dim.first, cluster.dim.stride, offset(cluster.offset)
        ),
        registers => book.model.cluster_registers(id).map(|(id, _)| safe(book.register_link(id))).collect::<Vec<_>>(),
        mentions => grouped(xref.of_cluster(id)),
    }
}

fn bytes(count: u64) -> String {
    if count == 1 { "1 byte".to_owned() } else { format!("{count} bytes") }
}

/// The part of an address behind `#`.
pub(super) fn anchor(address: &str) -> String {
    address.split_once('#').map_or(address, |(_, id)| id).to_owned()
}

fn row(book: &Book<'_>, id: RegisterId) -> Value {
    let register = book.model.register(id);
    let dim = register.dim.as_ref().or_else(|| register.cluster.map(|c| &book.model.clusters[c.0].dim));
    context! {
        link => book.register(id), name => label(book.model, register), title => register.title.clone(),
        width => register.width,
        address => address(book.model, register), reset => short_reset(register), codes => codes(register),
        range => dim.map(|d| format!("{}…{}", d.first, d.first + d.count - 1)),
        impure => !register.capabilities.pure,
        window => register.window.map(|w| context! { link => book.window(w), name => book.model.windows[w.0].name.clone() }),
        cluster => register.cluster.map(|c| book.model.clusters[c.0].title.clone()),
        reserved => false,
    }
}

/// The register map in order of address, reserved ranges among the registers.
fn map(book: &Book<'_>) -> Vec<Value> {
    let model = book.model;
    let mut rows: Vec<(u64, usize, Value)> = Vec::new();
    for (index, register) in model.registers.iter().enumerate() {
        let Some(at) = register.offset else { continue };
        let base = register.cluster.map_or(0, |c| model.clusters[c.0].offset);
        rows.push((base + at, register.window.map_or(0, |w| w.0 + 1), row(book, RegisterId(index))));
    }
    for range in &model.reserved {
        let mut notes = Vec::new();
        if let Some(value) = range.reads {
            notes.push(format!(
                "reads as <code>{}</code>",
                if value == 0 { "0".to_owned() } else { format!("0x{value:X}") }
            ));
        }
        if let Some(at) = range.sets {
            notes.push(format!("an access sets {}", book.field_link(at)));
        }
        if !range.doc.is_empty() {
            notes.push(book.inline(&range.doc, None));
        }
        let value = context! {
            reserved => true, address => format!("{}…{}", offset(range.from), offset(range.to)),
            bytes => bytes(range.to - range.from + 1),
            notes => safe(notes.join("; ")), cites => safe(book.cites(&range.cites)),
            window => range.window.map(|w| context! { link => book.window(w), name => model.windows[w.0].name.clone() }),
        };
        rows.push((range.from, range.window.map_or(0, |w| w.0 + 1), value));
    }
    rows.sort_by_key(|(at, window, _)| (*at, *window));
    rows.into_iter().map(|(_, _, value)| value).collect()
}

/// The registers before and after one, in the order of the description.
pub(super) fn neighbours(book: &Book<'_>, id: RegisterId) -> Value {
    let at = |index: Option<usize>| {
        index.filter(|&i| i < book.model.registers.len()).map(|i| {
            let register = &book.model.registers[i];
            context! { link => book.register(RegisterId(i)), name => label(book.model, register), title => register.title.clone() }
        })
    };
    context! { previous => at(id.0.checked_sub(1)), next => at(Some(id.0 + 1)) }
}

/// Breadcrumbs of a page of a controller.
pub(super) fn crumbs(book: &Book<'_>, here: &str) -> Value {
    let up = [link("../index.html", "Controllers"), link("index.html", &book.model.title), super::text::escape(here)];
    up.into_iter().map(safe).collect::<Vec<_>>().into()
}
