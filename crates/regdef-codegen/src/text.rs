//! Text that several emitters put into comments, descriptions and cells.

use regdef::model::{AccessCode, Cite, ConditionId, Encoding, Field, Model, OnRead, ReadEffect, Register, Target};

/// Citations in one line: `§2.3.7 p.11; external: KEY`.
pub(crate) fn cites(cites: &[Cite]) -> String {
    cites.iter().map(cite).filter(|text| !text.is_empty()).collect::<Vec<_>>().join("; ")
}

fn cite(cite: &Cite) -> String {
    let place = [
        ("external: ", &cite.source),
        ("\u{a7}", &cite.section),
        ("Register ", &cite.register),
        ("Table ", &cite.table),
        ("Figure ", &cite.figure),
        ("Example ", &cite.example),
        ("Equation ", &cite.equation),
    ];
    let mut parts: Vec<String> =
        place.iter().filter_map(|(kind, value)| value.as_ref().map(|value| format!("{kind}{value}"))).collect();
    parts.extend(cite.page.map(|page| format!("p.{page}")));
    parts.extend(cite.subject.as_ref().map(|subject| format!("({subject})")));
    parts.join(" ")
}

/// Name of a condition as the access notation shows it.
pub(crate) fn condition_name(model: &Model, id: ConditionId) -> String {
    model.condition(id).name.clone()
}

/// The access code with modifiers and conditions: `rw:config`.
pub(crate) fn notation(model: &Model, field: &Field) -> String {
    field.access.notation(|id| condition_name(model, id))
}

/// Text on one line, with single spaces.
pub(crate) fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A sentence that ends like one; empty stays empty.
pub(crate) fn sentence(text: &str) -> String {
    let text = one_line(text);
    if text.is_empty() || text.ends_with(['.', '!', '?', ':']) { text } else { text + "." }
}

/// What is to be known about accesses to a field beyond its description, one sentence each.
pub(crate) fn access_notes(model: &Model, field: &Field) -> Vec<String> {
    let code = field.access.code;
    let mut notes = vec![format!("Access {}.", notation(model, field))];
    if !matches!(code, AccessCode::Rw | AccessCode::Ro | AccessCode::Wo) {
        notes.push(code.meaning().to_owned());
    }
    let shown = |id: ConditionId| {
        let condition = model.condition(id);
        if condition.named { format!("{} ({})", condition.name, condition.text) } else { condition.text.clone() }
    };
    if let Some(id) = field.access.when {
        notes.push(format!("A write has an effect only if {}.", shown(id)));
    }
    if let Some(id) = field.access.set_when {
        notes.push(format!("Can be set only if {}, and cleared at any time.", shown(id)));
    }
    if let Some(OnRead { effect, byte }) = field.access.on_read {
        let what = match effect {
            ReadEffect::Clear => "clears it",
            ReadEffect::Set => "sets every bit of it",
        };
        notes.push(match byte {
            Some(byte) => format!("A read of byte {byte} of the register {what}."),
            None => format!("A read of the register {what}."),
        });
    }
    if let Some(origin) = field.access.loads {
        notes.push(format!("A write loads the value of {}.", model.field_path(origin)));
    }
    if let Some(value) = field.access.must_write {
        notes.push(format!("Software has to write {value:#x}."));
    }
    if let Some(reason) = &field.access.safe_to_write_back {
        notes.push(sentence(&format!("Writing back what was read is harmless: {reason}")));
    }
    if field.min > 0 || field.max < field.capacity() {
        notes.push(format!("May be programmed with {} to {}.", field.min, field.max));
    }
    notes.extend(field.encoding.as_ref().map(encoding));
    notes
}

/// How a programmed number relates to its meaning.
fn encoding(encoding: &Encoding) -> String {
    let number = if encoding.signed { "value as two's complement" } else { "value" };
    let sum = match encoding.add {
        0 => number.to_owned(),
        add if add < 0 => format!("{number} - {}", add.unsigned_abs()),
        add => format!("{number} + {add}"),
    };
    let product = match encoding.times {
        None | Some(1) => sum,
        Some(times) if encoding.add == 0 => format!("{sum} * {times}"),
        Some(times) => format!("({sum}) * {times}"),
    };
    match &encoding.unit {
        Some(unit) => format!("Means {product} {unit}."),
        None => format!("Means {product}."),
    }
}

/// What is to be known about a register beyond its description, one sentence each.
pub(crate) fn register_notes(model: &Model, register: &Register) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(id) = register.window {
        let window = &model.windows[id.0];
        notes.push(format!(
            "Visible only in the window {}, while {} is {}.",
            window.name,
            model.field_path(window.select),
            window.value
        ));
    }
    notes.extend(register.hazards.iter().map(|hazard| sentence(&format!("Hazard: {hazard}"))));
    notes.extend(register.unsafe_write.iter().map(|reason| sentence(&format!("A write is dangerous: {reason}"))));
    notes
}

/// Names of the manual's contradictions about one target, as one sentence; empty if there are none.
pub(crate) fn conflicts(model: &Model, about: impl Fn(&Target) -> bool) -> String {
    let concerned = model.conflicts.iter().filter(|conflict| conflict.at.iter().any(&about));
    let names: Vec<&str> = concerned.map(|conflict| conflict.id.as_str()).collect();
    if names.is_empty() { String::new() } else { format!("Contradictions of the manual: {}.", names.join(", ")) }
}

/// The part of a label before `{n}` and the part after it; without `{n}`, everything is before it.
pub(crate) fn split_label(label: &str) -> (&str, &str) {
    label.split_once("{n}").unwrap_or((label, ""))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn blank() -> Cite {
        Cite {
            section: None,
            register: None,
            table: None,
            figure: None,
            example: None,
            equation: None,
            page: None,
            source: None,
            subject: None,
            note: None,
        }
    }

    #[test]
    fn citations_are_compact() {
        let manual = Cite { section: Some("2.3.7".to_owned()), page: Some(11), ..blank() };
        let outside = Cite { source: Some("KEY".to_owned()), subject: Some("offset".to_owned()), ..blank() };
        assert_eq!(cites(&[manual, outside]), "\u{a7}2.3.7 p.11; external: KEY (offset)");
        assert_eq!(cites(&[]), "");
    }

    #[test]
    fn encodings_read_as_formulas() {
        let of = |add, times, signed| Encoding { add, times, signed, unit: Some("tq".to_owned()) };
        assert_eq!(encoding(&of(1, None, false)), "Means value + 1 tq.");
        assert_eq!(encoding(&of(1, Some(2), false)), "Means (value + 1) * 2 tq.");
        assert_eq!(encoding(&of(-3, None, true)), "Means value as two's complement - 3 tq.");
    }

    #[test]
    fn sentences_end() {
        assert_eq!(sentence(" a\n  b "), "a b.");
        assert_eq!(sentence("done!"), "done!");
        assert_eq!(sentence(""), "");
    }
}
