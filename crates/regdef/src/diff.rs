//! What changed between two descriptions, in words a reviewer can use.

mod parts;

use std::fmt;

use crate::model::{Dim, Enum, Field, FieldReset, Kind, Model, Register, ResetKind};

/// The changes of one thing: a register, a message word, an enumeration, the controller as a whole.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    /// What it is: "register `CCCR`".
    pub what: String,
    /// What happened to it.
    pub lines: Vec<Line>,
}

/// One change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Line {
    /// Something is new.
    Added(String),
    /// Something is gone.
    Removed(String),
    /// Something is different.
    Changed(String),
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Added(text) => write!(f, "+ {text}"),
            Self::Removed(text) => write!(f, "- {text}"),
            Self::Changed(text) => write!(f, "~ {text}"),
        }
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.what)?;
        self.lines.iter().try_for_each(|line| writeln!(f, "  {line}"))
    }
}

/// Everything that differs in what the hardware is said to do. Descriptions in words and citations are not compared.
#[must_use]
pub fn diff(old: &Model, new: &Model) -> Vec<Change> {
    let mut changes = Vec::new();
    add(&mut changes, format!("controller `{}`", new.names.id), controller(old, new));
    let renamed = |r: &Register| r.name.clone();
    let pairs =
        matched(&old.registers, &new.registers, renamed, |a, b| place(old, a) == place(new, b) && a.width == b.width);
    for pair in pairs {
        match pair {
            Pair::Both(a, b) => add(&mut changes, format!("register `{}`", b.name), register(old, a, new, b)),
            Pair::Old(a) => {
                let text = format!("the register, which was {}, with its {} fields", place(old, a), a.fields.len());
                add(&mut changes, format!("register `{}`", a.name), vec![Line::Removed(text)]);
            }
            Pair::New(b) => {
                let text = format!("the register, {}, {} bits, with {} fields", place(new, b), b.width, b.fields.len());
                add(&mut changes, format!("register `{}`", b.name), vec![Line::Added(text)]);
            }
        }
    }
    for pair in matched(&shared(old), &shared(new), |e| e.name.clone(), |_, _| false) {
        match pair {
            Pair::Both(a, b) => add(&mut changes, format!("enumeration `{}`", b.name), values(Some(a), Some(b), "")),
            Pair::Old(a) => {
                add(&mut changes, format!("enumeration `{}`", a.name), vec![Line::Removed("the enumeration".into())])
            }
            Pair::New(b) => {
                add(&mut changes, format!("enumeration `{}`", b.name), vec![Line::Added("the enumeration".into())])
            }
        }
    }
    parts::messages(old, new, &mut changes);
    parts::rest(old, new, &mut changes);
    changes
}

fn add(changes: &mut Vec<Change>, what: String, lines: Vec<Line>) {
    if !lines.is_empty() {
        changes.push(Change { what, lines });
    }
}

fn shared(model: &Model) -> Vec<&Enum> {
    model.enums.iter().filter(|e| e.shared).collect()
}

/// Two lists side by side.
enum Pair<'a, T> {
    Both(&'a T, &'a T),
    Old(&'a T),
    New(&'a T),
}

/// Matches by name, then what is left by `same`: a thing that only changed its name.
fn matched<'a, T>(
    old: &'a [T],
    new: &'a [T],
    name: impl Fn(&T) -> String,
    same: impl Fn(&T, &T) -> bool,
) -> Vec<Pair<'a, T>> {
    let in_old = |b: &T| old.iter().find(|a| name(a) == name(b));
    let in_new = |a: &T| new.iter().find(|b| name(a) == name(b));
    let mut left: Vec<&T> = old.iter().filter(|a| in_new(a).is_none()).collect();
    let mut pairs = Vec::new();
    for b in new {
        if let Some(a) = in_old(b) {
            pairs.push(Pair::Both(a, b));
        } else if let Some(position) = left.iter().position(|a| same(a, b)) {
            pairs.push(Pair::Both(left.remove(position), b));
        } else {
            pairs.push(Pair::New(b));
        }
    }
    pairs.extend(left.into_iter().map(Pair::Old));
    pairs
}

/// Adds a line if two facts differ.
fn compare(lines: &mut Vec<Line>, what: &str, old: &str, new: &str) {
    if old != new {
        lines.push(Line::Changed(format!("{what}: {old} → {new}")));
    }
}

fn controller(old: &Model, new: &Model) -> Vec<Line> {
    let mut lines = Vec::new();
    compare(&mut lines, "name", &old.names.id, &new.names.id);
    let manual = |m: &Model| format!("{} {}", m.manual.title, m.manual.revision);
    compare(&mut lines, "manual", &manual(old), &manual(new));
    compare(&mut lines, "size of the block", &format!("{:#x} bytes", old.span), &format!("{:#x} bytes", new.span));
    let widths = |m: &Model| m.access_widths.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    compare(&mut lines, "access widths", &widths(old), &widths(new));
    let aliases = |m: &Model| {
        let one = |a: &crate::model::Alias| format!("{} at +{:#x} ({:?})", a.name, a.offset, a.op);
        m.aliases.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    compare(&mut lines, "alias registers", &none(aliases(old)), &none(aliases(new)));
    lines
}

fn none(text: String) -> String {
    if text.is_empty() { "none".to_owned() } else { text }
}

fn dim(dim: Option<&Dim>) -> String {
    dim.map_or("single".to_owned(), |d| {
        format!("{} elements {:#x} apart, numbered from {}", d.count, d.stride, d.first)
    })
}

/// Where a register is, in words.
fn place(model: &Model, register: &Register) -> String {
    match (register.offset, register.cluster) {
        (None, _) => "in the device".to_owned(),
        (Some(at), None) => format!("at {at:#05x}"),
        (Some(at), Some(id)) => {
            let cluster = &model.clusters[id.0];
            format!("at {:#05x} in `{}`, {}", cluster.offset + at, cluster.name, dim(Some(&cluster.dim)))
        }
    }
}

fn register(old: &Model, a: &Register, new: &Model, b: &Register) -> Vec<Line> {
    let mut lines = Vec::new();
    compare(&mut lines, "renamed", &format!("`{}`", a.name), &format!("`{}`", b.name));
    compare(&mut lines, "moved", &place(old, a), &place(new, b));
    compare(&mut lines, "array", &dim(a.dim.as_ref()), &dim(b.dim.as_ref()));
    compare(&mut lines, "width", &format!("{} bits", a.width), &format!("{} bits", b.width));
    let window =
        |m: &Model, r: &Register| r.window.map_or("all windows".to_owned(), |id| format!("`{}`", m.windows[id.0].name));
    compare(&mut lines, "visible in", &window(old, a), &window(new, b));
    let reset = |r: &Register| {
        let digits = r.width as usize / 4 + 2;
        let unknown =
            if r.reset.unknown == 0 { String::new() } else { format!(" (unknown {:#0digits$x})", r.reset.unknown) };
        format!("{:#0digits$x}{unknown}", r.reset.value)
    };
    compare(&mut lines, "reset", &reset(a), &reset(b));
    let aliased = |m: &Model, r: &Register| if r.aliased && !m.aliases.is_empty() { "yes" } else { "no" };
    compare(&mut lines, "has alias registers", aliased(old, a), aliased(new, b));
    let hazard = |r: &Register| if r.unsafe_write.is_some() { "unsafe" } else { "safe" };
    compare(&mut lines, "a write is", hazard(a), hazard(b));
    lines.extend(fields(old, &a.fields, new, &b.fields));
    lines
}

fn bits(field: &Field) -> String {
    let range = if field.width == 1 {
        format!("bit {}", field.lsb)
    } else {
        format!("bits {}:{}", field.lsb + field.width - 1, field.lsb)
    };
    match field.lanes {
        None => range,
        Some(l) => format!("{range}, {} lanes {} apart, numbered from {}", l.count, l.stride, l.first),
    }
}

fn access(model: &Model, field: &Field) -> String {
    field.access.notation(|id| model.condition(id).name.clone())
}

fn field_reset(field: &Field) -> String {
    match field.reset {
        FieldReset::Value(value) => format!("{value:#x}"),
        FieldReset::None(ResetKind::Unknown) => "unknown".to_owned(),
        FieldReset::None(ResetKind::Product) => "of the product".to_owned(),
        FieldReset::None(ResetKind::Pin) => "of a pin".to_owned(),
    }
}

fn fields(old: &Model, a: &[Field], new: &Model, b: &[Field]) -> Vec<Line> {
    let mut lines = Vec::new();
    for pair in matched(a, b, |f| f.name.clone(), |a, b| a.mask() == b.mask()) {
        match pair {
            Pair::Both(a, b) => lines.extend(field(old, a, new, b)),
            Pair::Old(a) => lines.push(Line::Removed(format!("field `{}`, {}, `{}`", a.name, bits(a), access(old, a)))),
            Pair::New(b) => lines.push(Line::Added(format!(
                "field `{}`, {}, `{}`, reset {}",
                b.name,
                bits(b),
                access(new, b),
                field_reset(b)
            ))),
        }
    }
    lines
}

fn field(old: &Model, a: &Field, new: &Model, b: &Field) -> Vec<Line> {
    let mut lines = Vec::new();
    let what = |fact: &str| format!("field `{}`, {fact}", b.name);
    compare(&mut lines, &what("renamed"), &format!("`{}`", a.name), &format!("`{}`", b.name));
    compare(&mut lines, &what("moved"), &bits(a), &bits(b));
    compare(&mut lines, &what("access"), &format!("`{}`", access(old, a)), &format!("`{}`", access(new, b)));
    compare(&mut lines, &what("reset"), &field_reset(a), &field_reset(b));
    compare(&mut lines, &what("limits"), &format!("{}..={}", a.min, a.max), &format!("{}..={}", b.min, b.max));
    let must = |f: &Field| f.access.must_write.map_or("anything".to_owned(), |v| format!("{v:#x}"));
    compare(&mut lines, &what("software has to write"), &must(a), &must(b));
    let meaning = |f: &Field| {
        f.encoding.as_ref().map_or("the value".to_owned(), |e| {
            let sign = if e.signed { "two's complement " } else { "" };
            let unit = e.unit.as_deref().unwrap_or("");
            format!("({sign}value + {}) × {} {unit}", e.add, e.times.unwrap_or(1)).trim_end().to_owned()
        })
    };
    compare(&mut lines, &what("meaning"), &meaning(a), &meaning(b));
    let own = |m: &Model, f: &Field| match f.kind {
        Kind::Enum(id) if !m.enumeration(id).shared => Some(m.enumeration(id).clone()),
        _ => None,
    };
    let named = |m: &Model, f: &Field| match f.kind {
        Kind::Enum(id) if m.enumeration(id).shared => format!("`{}`", m.enumeration(id).name),
        Kind::Enum(_) => "its own enumeration".to_owned(),
        Kind::Bool | Kind::Int => "a number".to_owned(),
    };
    compare(&mut lines, &what("values are of"), &named(old, a), &named(new, b));
    if let (Some(x), Some(y)) = (own(old, a), own(new, b)) {
        lines.extend(values(Some(&x), Some(&y), &format!("field `{}`, ", b.name)));
    }
    lines
}

/// Changes of the values of an enumeration; `of` introduces each line.
fn values(a: Option<&Enum>, b: Option<&Enum>, of: &str) -> Vec<Line> {
    let list = |e: Option<&Enum>| -> Vec<((u64, u64), String)> {
        let Some(e) = e else { return Vec::new() };
        let named = e.variants.iter().map(|v| ((v.first, v.last), format!("`{}`", v.name)));
        let mut all: Vec<_> = named.chain(e.reserved.iter().map(|r| (*r, "reserved".to_owned()))).collect();
        all.sort();
        all
    };
    let (a, b) = (list(a), list(b));
    let range = |(first, last): (u64, u64)| if first == last { first.to_string() } else { format!("{first}..{last}") };
    let mut lines = Vec::new();
    for (key, name) in &b {
        match a.iter().find(|(k, _)| k == key) {
            Some((_, before)) => compare(&mut lines, &format!("{of}value {}", range(*key)), before, name),
            None => lines.push(Line::Added(format!("{of}value {}: {name}", range(*key)))),
        }
    }
    for (key, name) in a.iter().filter(|(key, _)| !b.iter().any(|(k, _)| k == key)) {
        lines.push(Line::Removed(format!("{of}value {}: {name}", range(*key))));
    }
    lines
}
