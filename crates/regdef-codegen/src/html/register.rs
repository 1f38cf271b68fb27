//! The page of a register.

use minijinja::{Value, context};
use regdef::model::{AliasOp, ClusterId, Model, ReadEffect, Register, RegisterId, Reset, bit_mask};

use super::book::{Book, label};
use super::field::{Holder, grouped, rows};
use super::text::{offset, reset, safe};
use super::xref::Xref;
use super::{access, decode, diagram};

/// What the page of a register shows.
pub(super) fn view(book: &Book<'_>, xref: &Xref, id: RegisterId) -> Value {
    let model = book.model;
    let register = model.register(id);
    let holder = Holder::Register(id, register.reset);
    let name = label(model, register);
    let elements = elements(model, register);
    let draw = |layout| {
        let link = |field| format!("#{}", book.field_id(regdef::model::FieldRef { register: id, field }));
        safe(diagram::draw(layout, &name, register.width, &register.fields, Some(register.reset), link))
    };
    let labels: Vec<String> = elements.iter().map(|e| e.label.clone()).collect();
    let data = decode::data(model, &name, register.width, &register.fields, Some(register.reset), &labels);
    let mut mentions = xref.of_register(id).to_vec();
    if let Some(cluster) = register.cluster {
        mentions.extend(xref.of_cluster(cluster).iter().cloned());
    }
    let alert = |term: &str| {
        let items = mentions.iter().filter(|(t, _)| *t == term).map(|(_, html)| html.clone());
        let of_fields = (0..register.fields.len()).flat_map(|field| {
            let at = regdef::model::FieldRef { register: id, field };
            xref.of_field(at).iter().filter(|(t, _)| *t == term).map(|(_, html)| html.clone())
        });
        let mut all: Vec<String> = Vec::new();
        for html in items.chain(of_fields) {
            if !all.contains(&html) {
                all.push(html);
            }
        }
        all.into_iter().map(safe).collect::<Vec<_>>()
    };
    let others: Vec<_> = mentions.iter().filter(|(t, _)| !matches!(*t, "Conflict" | "Not stated")).cloned().collect();
    context! {
        name => name.clone(),
        spelling => spelling(model, register),
        title => register.title.clone(),
        doc => safe(book.paragraphs(&register.doc, Some(id))),
        cites => safe(book.cites(&register.cites)),
        width => register.width,
        address => address(model, register),
        reset => reset(register.reset, register.width),
        reset_partial => register.reset.unknown != 0 && register.reset.unknown != bit_mask(0, register.width),
        codes => codes(register),
        marks => marks(register),
        window => register.window.map(|w| {
            let window = &model.windows[w.0];
            let select = safe(book.field_link(window.select));
            context! { link => book.window(w), name => window.name.clone(), select, value => window.value }
        }),
        cluster => register.cluster.map(|c| context! { link => book.cluster(c), title => model.clusters[c.0].title.clone() }),
        device => register.offset.is_none(),
        hazards => register.hazards.iter().map(|h| safe(book.inline(h, Some(id)))).collect::<Vec<_>>(),
        unsafe_write => register.unsafe_write.as_ref().map(|why| safe(book.inline(why, Some(id)))),
        conflicts => alert("Conflict"),
        silences => alert("Not stated"),
        diagrams => diagram::PAGE.map(draw).to_vec(),
        lanes_run_on => register.lanes_run_on(),
        decode => safe(data),
        rules => write_conditions(book, register),
        fields => rows(book, xref, holder, &register.fields),
        elements => elements.iter().map(|e| context! {
            label => e.label.clone(), offset => offset(e.offset), aliases => aliases(model, register, e.offset),
        }).collect::<Vec<_>>(),
        aliases => aliases(model, register, register.offset.unwrap_or(0)),
        alias_names => model.aliases.iter().map(|a| a.name.clone()).collect::<Vec<_>>(),
        capabilities => access::capabilities(book, id)
            .into_iter()
            .map(|(name, has, text)| context! { name, has, text => safe(text) })
            .collect::<Vec<_>>(),
        mentions => grouped(&others),
    }
}

/// The manual's spelling, prefix included, where it is another than that of these pages.
fn spelling(model: &Model, register: &Register) -> Option<String> {
    let with_prefix = |label: &str| format!("{}{label}", model.prefix);
    match register.dim.as_ref().map(|dim| &dim.labels[..]) {
        Some([first, .., last]) => Some(format!("{} … {}", with_prefix(first), with_prefix(last))),
        _ if model.prefix.is_empty() => None,
        _ => Some(with_prefix(&label(model, register))),
    }
}

/// What the marks in the register's diagram mean.
fn marks(register: &Register) -> Vec<Vec<&'static str>> {
    let reads = |effect| register.fields.iter().any(|f| f.access.on_read.is_some_and(|r| r.effect == effect));
    let conditional = register.fields.iter().any(|f| f.access.when.is_some() || f.access.set_when.is_some());
    let by_byte = register.fields.iter().any(|f| f.access.on_read.is_some_and(|r| r.byte.is_some()));
    [
        (conditional, vec!["*", "written only under a condition"]),
        (reads(ReadEffect::Clear), vec!["+rc", "a read clears it"]),
        (reads(ReadEffect::Set), vec!["+rs", "a read sets it"]),
        (by_byte, vec!["@n", "if byte n is read"]),
        (register.reset.unknown != 0, vec!["x", "unknown after reset"]),
    ]
    .into_iter()
    .filter_map(|(is, mark)| is.then_some(mark))
    .collect()
}

/// The named conditions that the register's fields wait for, once each.
fn write_conditions(book: &Book<'_>, register: &Register) -> Vec<Value> {
    let mut all = Vec::new();
    let used = register.fields.iter().flat_map(|f| [f.access.when, f.access.set_when]).flatten();
    for id in used.filter(|&id| book.model.condition(id).named) {
        if !all.contains(&id) {
            all.push(id);
        }
    }
    let one = |id| {
        let condition = book.model.condition(id);
        let doc = if condition.doc == condition.text { String::new() } else { book.inline(&condition.doc, None) };
        context! { link => safe(book.condition_link(id)), text => condition.text.clone(), doc => safe(doc) }
    };
    all.into_iter().map(one).collect()
}

/// One element of an array.
struct Element {
    label: String,
    offset: u64,
}

fn elements(model: &Model, register: &Register) -> Vec<Element> {
    let Some(base) = register.offset else { return Vec::new() };
    let (start, dim) = match (&register.dim, register.cluster) {
        (Some(dim), _) => (0, dim),
        (None, Some(ClusterId(id))) => (model.clusters[id].offset, &model.clusters[id].dim),
        (None, None) => return Vec::new(),
    };
    (0..dim.count)
        .map(|n| Element { label: register.label_of(dim, n), offset: start + base + dim.stride * u64::from(n) })
        .collect()
}

/// `0x018`, or with the number of the element: `0x300 + 0x10·n`.
pub(super) fn address(model: &Model, register: &Register) -> Option<String> {
    let mut at = register.offset?;
    let mut steps = String::new();
    let mut step = |dim: &regdef::model::Dim, letter: &str| {
        let number = if dim.first == 0 { letter.to_owned() } else { format!("({letter} − {})", dim.first) };
        steps += &format!(" + 0x{:X}·{number}", dim.stride);
    };
    if let Some(ClusterId(id)) = register.cluster {
        at += model.clusters[id].offset;
        step(&model.clusters[id].dim, "n");
    }
    if let Some(dim) = &register.dim {
        step(dim, if register.cluster.is_some() { "m" } else { "n" });
    }
    Some(format!("{}{steps}", offset(at)))
}

/// The access codes in a register, each once.
pub(super) fn codes(register: &Register) -> Vec<&'static str> {
    let mut all = Vec::new();
    for field in &register.fields {
        if !all.contains(&field.access.code.as_str()) {
            all.push(field.access.code.as_str());
        }
    }
    all
}

fn aliases(model: &Model, register: &Register, at: u64) -> Vec<Value> {
    if !register.aliased || register.offset.is_none() {
        return Vec::new();
    }
    let op = |op| match op {
        AliasOp::Clear => "bits written 1 are cleared",
        AliasOp::Set => "bits written 1 are set",
        AliasOp::Invert => "bits written 1 are inverted",
    };
    let one =
        |a: &regdef::model::Alias| context! { name => a.name.clone(), offset => offset(at + a.offset), op => op(a.op) };
    model.aliases.iter().map(one).collect()
}

/// The value of a register after reset, short enough for a table: a digit with an unknown bit is `?`.
pub(super) fn short_reset(register: &Register) -> String {
    let digits = (0..register.width.div_ceil(4)).map(|n| bit_mask(4 * n, 4));
    let unknown = digits.filter(|digit| digit & register.reset.unknown != 0).fold(0, |all, digit| all | digit);
    reset(Reset { value: register.reset.value, unknown }, register.width)
}
