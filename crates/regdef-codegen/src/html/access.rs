//! Access rules in words.

use regdef::model::{Access, AccessCode, Capabilities, Field, NoModify, ReadEffect, RegisterId};

use super::book::Book;
use super::text::{escape, hex};

/// The access code in the two to five words that fit a table cell.
pub(super) const fn words(code: AccessCode) -> &'static str {
    match code {
        AccessCode::Rw => "read and write",
        AccessCode::Ro => "read only",
        AccessCode::Wo => "write only",
        AccessCode::W1c => "write 1 to clear",
        AccessCode::W0c => "write 0 to clear",
        AccessCode::W1s => "write 1 to request",
        AccessCode::Rwhc => "request, 0 withdraws it",
        AccessCode::Rwh => "hardware changes it too",
        AccessCode::Wclr => "any write clears or presets it",
    }
}

/// Code, read effect and a star for a condition, as the cells of the diagrams print it.
pub(super) fn cell(access: &Access) -> String {
    let short = Access { when: None, set_when: None, ..access.clone() };
    let star = if access.when.is_some() || access.set_when.is_some() { "*" } else { "" };
    format!("{}{star}", short.notation(|_| String::new()))
}

/// The rules of a field beyond its code, as terms and HTML.
pub(super) fn rules(book: &Book<'_>, access: &Access) -> Vec<(&'static str, String)> {
    let mut all = Vec::new();
    if let Some(id) = access.when {
        all.push(("Writable only if", book.condition_link(id)));
    }
    if let Some(id) = access.set_when {
        all.push(("Can be set only if", format!("{}; it can be cleared at any time", book.condition_link(id))));
    }
    if let Some(on_read) = access.on_read {
        let effect = match on_read.effect {
            ReadEffect::Clear => "clears the field",
            ReadEffect::Set => "sets every bit of the field",
        };
        let which = match on_read.byte {
            Some(byte) => {
                let low = u32::from(byte) * 8;
                format!("Reading byte {byte} (bits {}:{low}) {effect}; reading only other bytes does not.", low + 7)
            }
            None => format!("Any read of the register {effect}."),
        };
        all.push(("A read has an effect", which));
    }
    if let Some(at) = access.loads {
        all.push(("A write loads", format!("the value of {}", book.field_link(at))));
    }
    if let Some(value) = access.must_write {
        all.push(("Must be written", format!("always <code>{value}</code>")));
    }
    if let Some(reason) = &access.safe_to_write_back {
        all.push(("Safe to write back", book.inline(reason, None)));
    }
    all
}

/// Whether reading the register is harmless, in words, or the fields that a read changes.
pub(super) fn read_sentence(fields: &[Field], capabilities: &Capabilities) -> String {
    if !capabilities.readable {
        return "No field can be read.".to_owned();
    }
    let touched: Vec<_> = fields.iter().filter(|f| f.access.on_read.is_some()).map(|f| f.name.as_str()).collect();
    if touched.is_empty() {
        "A read changes nothing.".to_owned()
    } else {
        format!("A read changes {}.", list(&touched))
    }
}

/// What generated code offers for a register: a word, whether it is there, and an explanation in HTML.
pub(super) fn capabilities(book: &Book<'_>, id: RegisterId) -> Vec<(&'static str, bool, String)> {
    let register = book.model.register(id);
    let has = &register.capabilities;
    let mask = |bits: u64| format!("<code>{}</code>", hex(bits, register.width));
    let mut all = vec![
        ("read", has.readable, escape(&read_sentence(&register.fields, has))),
        (
            "write",
            has.writable,
            if has.writable {
                format!("Bits that software can write: {}.", mask(register.writable_bits()))
            } else {
                "No field can be written.".to_owned()
            },
        ),
    ];
    let modify = match &has.modify {
        Ok(()) => {
            let mut text = "A read-modify-write is safe".to_owned();
            let writable = register.writable_bits();
            let (zeros, ones) = (has.neutral_zeros & writable, has.neutral_ones & writable);
            match (zeros, ones) {
                (0, 0) => {}
                (zeros, 0) => text += &format!(": it writes {} as 0", mask(zeros)),
                (0, ones) => text += &format!(": it writes {} as 1", mask(ones)),
                (zeros, ones) => text += &format!(": it writes {} as 0 and {} as 1", mask(zeros), mask(ones)),
            }
            if zeros | ones != 0 {
                text += ", so that nothing is cleared, requested or commanded";
            }
            text + "."
        }
        Err(NoModify::NotReadWrite) => "It cannot be both read and written.".to_owned(),
        Err(NoModify::OnlyFlags(names)) => {
            format!("It holds only flags and requests ({}): write them directly.", names_of(names))
        }
        Err(NoModify::ReadHasEffects(names)) => format!("The read would change {}.", names_of(names)),
        Err(NoModify::NoNeutral(names)) => {
            format!("Nothing can be written back to {} without an effect.", names_of(names))
        }
    };
    all.push(("modify", has.modify.is_ok(), modify));
    let mut clear = Vec::new();
    if has.one_clears != 0 {
        clear.push(format!("1 in {} clears a flag, 0 leaves it.", mask(has.one_clears)));
    }
    if has.zero_clears != 0 {
        clear.push(format!("0 in {} clears a flag, 1 leaves it.", mask(has.zero_clears)));
    }
    if !clear.is_empty() {
        all.push(("clear", true, format!("One store clears flags. {}", clear.join(" "))));
    }
    if has.one_sets != 0 {
        all.push(("request", true, format!("1 in {} makes a request, 0 leaves everything alone.", mask(has.one_sets))));
    }
    if register.aliased && !book.model.aliases.is_empty() {
        let names: Vec<_> = book.model.aliases.iter().map(|a| a.name.as_str()).collect();
        let text = format!("One store to an alias register changes single bits: {}.", list(&names));
        all.push(("alias", true, escape(&text)));
    }
    if let Some(reason) = &register.unsafe_write {
        all.push(("unsafe write", true, book.inline(reason, Some(id))));
    }
    all
}

fn names_of(names: &[String]) -> String {
    escape(&list(&names.iter().map(String::as_str).collect::<Vec<_>>()))
}

/// `A`, `A and B`, `A, B and C`; a long list is cut.
pub(super) fn list(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] if names.len() <= 12 => format!("{} and {last}", first.join(", ")),
        _ => format!("{} and {} more", names[..10].join(", "), names.len() - 10),
    }
}

#[cfg(test)]
mod tests {
    use super::list;

    #[test]
    fn lists_read_as_sentences() {
        assert_eq!(list(&["A"]), "A");
        assert_eq!(list(&["A", "B", "C"]), "A, B and C");
        assert!(list(&["X"; 32]).ends_with("X and 22 more"));
    }
}
