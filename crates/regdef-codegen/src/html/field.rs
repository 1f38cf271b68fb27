//! One row of a table of fields, for registers and for words of messages.

use minijinja::{Value, context};
use regdef::model::{Cite, Encoding, Enum, Field, FieldRef, FieldReset, MessageId, RegisterId, Reset, ResetKind};

use super::access;
use super::book::Book;
use super::text::{bit_range, hex, safe};
use super::xref::{Mentions, Xref};

/// What holds the fields of a table.
#[derive(Clone, Copy)]
pub(super) enum Holder<'a> {
    /// A register with its value after reset.
    Register(RegisterId, Reset),
    /// A word of a message.
    Word(MessageId, usize, &'a [Cite]),
}

impl Holder<'_> {
    /// The address of a field.
    pub fn link(self, book: &Book<'_>, field: usize) -> String {
        match self {
            Holder::Register(register, _) => book.field(FieldRef { register, field }),
            Holder::Word(message, word, _) => book.word_field(message, word, field),
        }
    }

    fn register(self) -> Option<RegisterId> {
        match self {
            Holder::Register(id, _) => Some(id),
            Holder::Word(..) => None,
        }
    }
}

/// The rows of the table of fields.
pub(super) fn rows(book: &Book<'_>, xref: &Xref, holder: Holder<'_>, fields: &[Field]) -> Vec<Value> {
    fields.iter().enumerate().map(|(index, field)| row(book, xref, holder, index, field)).collect()
}

fn row(book: &Book<'_>, xref: &Xref, holder: Holder<'_>, index: usize, field: &Field) -> Value {
    let here = holder.register();
    let (inherited, mentions) = match holder {
        Holder::Register(register, _) => {
            (&book.model.register(register).cites[..], xref.of_field(FieldRef { register, field: index }))
        }
        Holder::Word(message, word, cites) => (cites, xref.of_word_field(message, word, index)),
    };
    let link = holder.link(book, index);
    let mut notes: Mentions = Vec::new();
    if let Some(lanes) = lanes_in_words(field) {
        notes.push(("Lanes", lanes));
    }
    notes.extend(access::rules(book, &field.access));
    if field.min != 0 || field.max != field.capacity() {
        notes.push(("Allowed values", format!("{} to {}", field.min, field.max)));
    }
    if let Some(encoding) = &field.encoding {
        let limits = meaning_of_limits(field);
        let plain = encoding.add == 0 && encoding.times.unwrap_or(1) == 1 && !encoding.signed;
        let means = if plain { limits } else { format!("{}: {limits}", super::text::escape(&formula(encoding))) };
        notes.push(("Meaning", means));
    }
    if field.cites != inherited && !field.cites.is_empty() {
        notes.push(("Stands in", book.cites(&field.cites)));
    }
    let values = field.enumeration().map(|id| {
        let one = book.model.enumeration(id);
        context! {
            rows => values(book, one), count => one.variants.len(), link => book.enumeration(id),
            name => one.name.clone(), shared => one.shared,
        }
    });
    context! {
        id => link.split_once('#').map(|(_, id)| id),
        bits => all_bits(field),
        name => shown_name(field),
        code => access::cell(&field.access),
        class => field.access.code.as_str(),
        words => access::words(field.access.code),
        reset => match holder {
            Holder::Register(_, reset) => Some(reset_of(field, reset)),
            Holder::Word(..) => None,
        },
        doc => safe(book.inline(&field.doc, here)),
        notes => notes.into_iter().map(|(term, html)| context! { term, html => safe(html) }).collect::<Vec<_>>(),
        values,
        mentions => grouped(mentions),
    }
}

/// The manual's spelling, with `n` for the number of the lane.
pub(super) fn shown_name(field: &Field) -> String {
    match field.lanes {
        None => field.label.clone(),
        Some(_) if field.label.contains("{n}") => field.label.replace("{n}", "n"),
        Some(_) => format!("{}n", field.label),
    }
}

fn all_bits(field: &Field) -> String {
    match field.lanes {
        Some(lanes) if lanes.stride == field.width => bit_range(field.lsb, field.width * lanes.count),
        Some(lanes) if lanes.count <= 4 => {
            let lanes = (0..lanes.count).rev().map(|lane| bit_range(field.lane_lsb(lane), field.width));
            lanes.collect::<Vec<_>>().join(", ")
        }
        Some(lanes) => format!(
            "{} … {}",
            bit_range(field.lane_lsb(lanes.count - 1), field.width),
            bit_range(field.lsb, field.width)
        ),
        None => bit_range(field.lsb, field.width),
    }
}

fn lanes_in_words(field: &Field) -> Option<String> {
    let lanes = field.lanes?;
    let bits = if field.width == 1 { "one bit" } else { &format!("{} bits", field.width) };
    let (first, last) = (field.label_of(0, 0), field.label_of(0, lanes.count - 1));
    let apart =
        if lanes.stride == field.width { "side by side".to_owned() } else { format!("{} bits apart", lanes.stride) };
    let text = format!(
        "{} of {bits} each, {apart}: {first} (bit {}) to {last} (bit {})",
        lanes.count,
        field.lsb,
        field.lane_lsb(lanes.count - 1)
    );
    Some(super::text::escape(&text))
}

fn reset_of(field: &Field, reset: Reset) -> String {
    if let FieldReset::None(kind) = field.reset {
        return match kind {
            ResetKind::Unknown => "x",
            ResetKind::Product => "product",
            ResetKind::Pin => "pin",
        }
        .to_owned();
    }
    let one = |value: Option<u64>| match value {
        None => "x".to_owned(),
        Some(value) if field.width > 3 => hex(value, field.width),
        Some(value) => value.to_string(),
    };
    let lanes: Vec<_> = (0..field.lane_count()).map(|lane| one(field.reset_of_lane(reset, lane))).collect();
    if lanes.iter().all(|l| *l == lanes[0]) {
        lanes.into_iter().next().unwrap_or_default()
    } else {
        lanes.into_iter().rev().collect::<Vec<_>>().join(" ")
    }
}

/// The values of an enumeration in ascending order, reserved ones among them.
pub(super) fn values(book: &Book<'_>, one: &Enum) -> Vec<Value> {
    let range = |first: u64, last: u64| if first == last { first.to_string() } else { format!("{first}–{last}") };
    let mut all: Vec<(u64, Value)> = one
        .variants
        .iter()
        .map(|v| {
            let doc = safe(book.inline(&v.doc, None));
            (v.first, context! { range => range(v.first, v.last), name => v.name.clone(), doc, reserved => false })
        })
        .collect();
    for &(first, last) in &one.reserved {
        let doc = safe("must not be used");
        all.push((first, context! { range => range(first, last), name => "reserved", doc, reserved => true }));
    }
    all.sort_by_key(|(first, _)| *first);
    all.into_iter().map(|(_, value)| value).collect()
}

/// `(value + 1) × 2 tq`.
pub(super) fn formula(encoding: &Encoding) -> String {
    let mut text = match encoding.add {
        0 => "value".to_owned(),
        add if add > 0 => format!("value + {add}"),
        add => format!("value − {}", add.unsigned_abs()),
    };
    if let Some(times) = encoding.times.filter(|&t| t != 1) {
        text = if encoding.add == 0 { format!("{text} × {times}") } else { format!("({text}) × {times}") };
    }
    if let Some(unit) = &encoding.unit {
        text = if text.contains(' ') && !text.starts_with('(') {
            format!("({text}) {unit}")
        } else {
            format!("{text} {unit}")
        };
    }
    if encoding.signed { format!("{text}, two's complement") } else { text }
}

/// What the limits of a field mean: `1 to 512 tq`.
pub(super) fn meaning_of_limits(field: &Field) -> String {
    let Some(encoding) = &field.encoding else { return format!("{} to {}", field.min, field.max) };
    let sign = 1_i128 << (field.width - 1);
    let wrap = |v: u64| if encoding.signed && i128::from(v) >= sign { i128::from(v) - 2 * sign } else { i128::from(v) };
    let (low, high) = match encoding.signed {
        true if field.min == 0 && field.max == field.capacity() => (-sign, sign - 1),
        _ => (wrap(field.min), wrap(field.max)),
    };
    let mean = |v: i128| (v + i128::from(encoding.add)) * i128::from(encoding.times.unwrap_or(1));
    let unit = encoding.unit.as_deref().map(|u| format!(" {u}")).unwrap_or_default();
    super::text::escape(&format!("{} to {}{unit}", mean(low), mean(high)))
}

/// Mentions with one line for each term.
pub(super) fn grouped(mentions: &[(&'static str, String)]) -> Vec<Value> {
    let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
    for (term, html) in mentions {
        match groups.iter_mut().find(|(t, _)| t == term) {
            Some((_, items)) if items.contains(&html.as_str()) => {}
            Some((_, items)) => items.push(html),
            None => groups.push((term, vec![html])),
        }
    }
    groups
        .into_iter()
        .map(|(term, items)| context! { term, items => items.into_iter().map(safe).collect::<Vec<_>>() })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Encoding, formula};

    #[test]
    fn formulas_read_as_arithmetic() {
        let encoding = |add, times, unit: &str| Encoding { add, times, signed: false, unit: Some(unit.to_owned()) };
        assert_eq!(formula(&encoding(1, None, "tq")), "(value + 1) tq");
        assert_eq!(formula(&encoding(0, Some(4), "bytes")), "(value × 4) bytes");
        assert_eq!(formula(&encoding(1, Some(2), "tq")), "(value + 1) × 2 tq");
        assert_eq!(formula(&encoding(0, None, "words")), "value words");
    }
}
