//! The pages of the message layouts and of their placement in memory.

use minijinja::{Value, context};
use regdef::model::{FieldRef, Message, MessageId, Payload, SectionStart, Target};

use super::book::Book;
use super::field::{Holder, grouped, rows};
use super::overview::anchor;
use super::text::{bit_range, escape, safe};
use super::xref::Xref;
use super::{decode, diagram};

/// Message layouts, word by word.
pub(super) fn messages(book: &Book<'_>, xref: &Xref) -> Value {
    let one = |(index, message): (usize, &Message)| {
        let id = MessageId(index);
        let words = (0..message.words.len()).map(|word| view_word(book, xref, id, word)).collect::<Vec<_>>();
        context! {
            id => anchor(&book.message(id)), name => message.name.clone(), title => message.title.clone(),
            word_width => message.word_width,
            doc => safe(book.paragraphs(&message.doc, None)), cites => safe(book.cites(&message.cites)),
            header => message.header_bytes,
            words, payload => message.payload.as_ref().map(|p| payload(book, message, p)),
            // The data bytes stand in front of the words behind them, as in the memory.
            words_before => message.payload.as_ref().map_or(0, |p| message.words.iter().filter(|w| w.offset < p.offset).count()),
            mentions => grouped(xref.of_message(id)),
            joined => message.joined.iter().map(|j| context! {
                name => j.name.clone(), doc => safe(book.inline(&j.doc, None)), width => j.width,
                parts => j.parts.iter().map(|part| {
                    let holder = match part.field {
                        Some(field) => book.target_link(Target::WordField(id, part.holder, field)),
                        None => book.target_link(Target::Word(id, part.holder)),
                    };
                    safe(format!("bits {} in {holder}", bit_range(part.shift, part.width)))
                }).collect::<Vec<_>>(),
            }).collect::<Vec<_>>(),
        }
    };
    book.model.messages.iter().enumerate().map(one).collect::<Vec<_>>().into()
}

fn view_word(book: &Book<'_>, xref: &Xref, id: MessageId, index: usize) -> Value {
    let message = &book.model.messages[id.0];
    let word = &message.words[index];
    let name = format!("{} {}", message.title, word.name);
    let draw = |layout| {
        let link = |field| format!("#{}", anchor(&book.word_field(id, index, field)));
        safe(diagram::draw(layout, &name, message.word_width, &word.fields, None, link))
    };
    let same = word.same_as.map(|(m, w)| safe(book.target_link(Target::Word(m, w))));
    context! {
        id => anchor(&book.word(id, index)), name => word.name.clone(), offset => format!("0x{:02X}", word.offset),
        bytes => word.offset,
        doc => safe(book.paragraphs(&word.doc, None)), cites => safe(book.cites(&word.cites)),
        inherits => word.cites == message.cites,
        present_when => word.present_when.map(|c| safe(book.condition_link(c))), same,
        row => draw(diagram::row(message.word_width)), narrow => draw(diagram::PAGE[1]),
        fields => rows(book, xref, Holder::Word(id, index, &word.cites), &word.fields),
        decode => safe(decode::data(book.model, &name, message.word_width, &word.fields, None, &[])),
        mentions => grouped(xref.of_word(id, index)),
    }
}

fn payload(book: &Book<'_>, message: &Message, payload: &Payload) -> Value {
    let bytes_per_word = message.word_width / 8;
    let sizes = payload.sizes.iter().enumerate().map(|(code, &size)| {
        let last = payload.first_word + size.div_ceil(bytes_per_word).max(1) - 1;
        context! {
            code, size, words => size.div_ceil(bytes_per_word),
            labels => format!("{} … {}", numbered(&payload.word_label, payload.first_word), numbered(&payload.word_label, last)),
            element => message.element_bytes(size),
            element_words => message.element_bytes(size).div_ceil(u64::from(bytes_per_word)),
        }
    });
    let bytes: Vec<String> = (0..bytes_per_word).rev().map(|n| numbered(&payload.byte_label, n)).collect();
    context! {
        offset => format!("0x{:02X}", payload.offset), sizes => sizes.collect::<Vec<_>>(),
        doc => safe(book.paragraphs(&payload.doc, None)),
        cites => safe(book.cites(&payload.cites)), bytes, first => numbered(&payload.word_label, payload.first_word),
    }
}

fn numbered(label: &str, number: u32) -> String {
    if label.contains("{n}") { label.replace("{n}", &number.to_string()) } else { format!("{label}{number}") }
}

/// Where messages lie in memory.
pub(super) fn memory(book: &Book<'_>) -> Value {
    let model = book.model;
    let sections = model.memory.sections.iter().enumerate().map(|(index, section)| {
        let start = match &section.start {
            SectionStart::Follows if index == 0 => "at the start of the memory".to_owned(),
            SectionStart::Follows => "behind the section before it".to_owned(),
            SectionStart::At { parts, unit } => {
                let name = |part: &regdef::model::Part<_>| match part.field {
                    Some(field) => book.field_link(FieldRef { register: part.holder, field }),
                    None => book.register_link(part.holder),
                };
                let parts = parts.iter().rev().map(name).collect::<Vec<_>>().join(" : ");
                if *unit == 1 { format!("{parts} (bytes)") } else { format!("{parts} × {unit} bytes") }
            }
        };
        let count: Vec<_> = section.count.iter().map(|&at| book.field_link(at)).collect();
        let elements = section.elements.iter().map(|&id| safe(book.target_link(Target::Message(id))));
        context! {
            id => anchor(&book.section(index)), name => section.name.clone(),
            doc => safe(book.inline(&section.doc, None)), start => safe(start),
            elements => elements.collect::<Vec<_>>(), count => safe(count.join(" + ")), max => section.max,
            payload_size => section.payload_size.map(|at| safe(book.field_link(at))),
            exists_when => section.exists_when.map(|c| safe(book.condition_link(c))),
            repeats => section.dim.as_ref().map(|d| {
                escape(&format!("{} sections, numbered {} to {}", d.count, d.first, d.first + d.count - 1))
            }),
            cites => safe(book.cites(&section.cites)),
        }
    });
    context! {
        doc => safe(book.paragraphs(&model.memory.doc, None)), limit => model.memory.limit,
        cites => safe(book.cites(&model.memory.cites)),
        sections => sections.collect::<Vec<_>>(),
    }
}
