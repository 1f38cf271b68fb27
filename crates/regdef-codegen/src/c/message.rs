//! Message layouts: words, fields, payload and sizes.

use regdef::model::{Message, MessageId, Payload};

use super::joined::{gathered, holders, mask, scattered, whole};
use super::layout::identifier;
use super::literal::{ctype, hex, offset};
use super::write::{Writer, remark};
use super::{Context, field};
use crate::text;

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    for index in 0..context.model.messages.len() {
        one(context, out, MessageId(index));
    }
}

/// A member of the struct: the words that share an offset, or the payload.
struct Member {
    offset: u64,
    bytes: u64,
    declaration: String,
    name: String,
}

fn one(context: &Context<'_>, out: &mut Writer, id: MessageId) {
    let message = &context.model.messages[id.0];
    let name = context.names.message(id);
    let stem = name.to_ascii_lowercase();
    out.comment(&[
        format!("{}: {}", message.name, text::sentence(&message.title)),
        text::sentence(&message.doc),
        message.payload.as_ref().map_or_else(String::new, |payload| text::sentence(&payload.doc)),
        text::cites(&message.cites),
    ]);
    let members = members(message);
    let size = members.last().map_or(0, |last| last.offset + last.bytes);
    out.line("typedef struct {");
    let mut at = 0;
    for member in &members {
        if member.offset > at {
            out.line(&format!("    uint8_t RESERVED_{at:03X}[{}];", member.offset - at));
        }
        out.line(&format!("    {}", member.declaration));
        at = member.offset + member.bytes;
    }
    out.line(&format!("}} {stem}_t;"));
    for member in &members {
        let place = offset(member.offset);
        out.line(&format!(
            "{}_STATIC_ASSERT(offsetof({stem}_t, {}) == {place}, {stem}_at_{});",
            context.upper, member.name, member.name
        ));
    }
    out.line(&format!("{}_STATIC_ASSERT(sizeof({stem}_t) == {}, {stem}_size);", context.upper, offset(size)));
    out.define(&format!("{name}_HEADER_BYTES"), &format!("{}U", message.header_bytes));
    for (word, of) in message.words.iter().enumerate() {
        words(context, out, id, word);
        for (index, field) in of.fields.iter().enumerate() {
            let holder = field::Holder { width: message.word_width, name: context.names.word_field(id, word, index) };
            let cites = if field.cites == of.cites { String::new() } else { text::cites(&field.cites) };
            field::emit(context, out, &holder, field, &[cites]);
        }
    }
    if let Some(payload) = &message.payload {
        sizes(out, message, payload, name);
        copies(context, out, message, payload, &stem);
    }
    joined(out, message, &stem);
    out.blank();
}

fn words(context: &Context<'_>, out: &mut Writer, id: MessageId, word: usize) {
    let message = &context.model.messages[id.0];
    let of = &message.words[word];
    let mut paragraphs = vec![format!("Word {} of {}: {}", of.name, message.name, text::sentence(&of.doc))];
    if let Some(condition) = of.present_when {
        paragraphs.push(format!("Has this layout only if {}.", context.model.condition(condition).text));
    }
    paragraphs.push(text::cites(&of.cites));
    out.comment(&paragraphs);
    out.define(&format!("{}_OFFSET", context.names.word(id, word)), &offset(of.offset));
}

/// Name of the member that holds a word: words at one offset share it.
fn member_name(message: &Message, word: usize) -> String {
    let at = message.words[word].offset;
    let names = message.words.iter().filter(|word| word.offset == at).map(|word| identifier(&word.name));
    names.collect::<Vec<_>>().join("_")
}

fn members(message: &Message) -> Vec<Member> {
    let container = ctype(message.word_width);
    let bytes = u64::from(message.word_width / 8);
    let mut members: Vec<Member> = Vec::new();
    for (index, word) in message.words.iter().enumerate() {
        if members.iter().any(|member| member.offset == word.offset) {
            continue;
        }
        let name = member_name(message, index);
        let declaration = format!("volatile {container} {name};{}", remark(&word.doc));
        members.push(Member { offset: word.offset, bytes, declaration, name });
    }
    if let Some(payload) = &message.payload {
        let count = u64::from(largest(payload)).div_ceil(bytes);
        let declaration = format!("volatile {container} PAYLOAD[{count}];");
        let name = "PAYLOAD".to_owned();
        members.push(Member { offset: payload.offset, bytes: count * bytes, declaration, name });
    }
    members.sort_by_key(|member| member.offset);
    members
}

fn largest(payload: &Payload) -> u32 {
    payload.sizes.iter().copied().max().unwrap_or(0)
}

fn sizes(out: &mut Writer, message: &Message, payload: &Payload, name: &str) {
    let stem = name.to_ascii_lowercase();
    out.define(&format!("{name}_PAYLOAD_MAX"), &format!("{}U", largest(payload)));
    let bytes = format!("({}U + (payload))", message.header_bytes);
    out.comment(&["Bytes of an element that is configured for a payload of so many bytes.".to_owned()]);
    out.define(&format!("{name}_BYTES(payload)"), &bytes);
    out.comment(&["Payload in bytes for a code of the size field; 0 for a code that has none.".to_owned()]);
    let mut body = vec!["switch (code) {".to_owned()];
    body.extend(payload.sizes.iter().enumerate().map(|(code, size)| format!("case {code}U: return {size}U;")));
    body.extend(["default: return 0U;".to_owned(), "}".to_owned()]);
    out.function(&format!("unsigned int {stem}_payload_bytes(unsigned int code)"), &body);
}

/// Copies between bytes and words, one access to a word at a time.
fn copies(context: &Context<'_>, out: &mut Writer, message: &Message, payload: &Payload, stem: &str) {
    let container = ctype(message.word_width);
    let bytes = message.word_width / 8;
    let assert = format!("{}_ASSERT(count <= {}U);", context.upper, largest(payload));
    let lines = |lines: &[&str]| -> Vec<String> {
        let fill = |line: &&str| line.replace("CONTAINER", container).replace("BYTES", &bytes.to_string());
        std::iter::once(assert.clone()).chain(lines.iter().map(fill)).collect()
    };
    out.comment(&[
        "Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word.".to_owned()
    ]);
    let read = lines(&[
        "for (size_t at = 0; at < count; at += BYTESU) {",
        "    const CONTAINER word = element->PAYLOAD[at / BYTESU];",
        "    for (size_t byte = 0; byte < BYTESU && at + byte < count; ++byte) {",
        "        data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);",
        "    }",
        "}",
    ]);
    out.function(&format!("void {stem}_read_payload(const {stem}_t *element, uint8_t *data, size_t count)"), &read);
    out.comment(&[
        "Writes the first bytes of the payload, every word once; the rest of the last word becomes 0.".to_owned()
    ]);
    let write = lines(&[
        "for (size_t at = 0; at < count; at += BYTESU) {",
        "    CONTAINER word = 0;",
        "    for (size_t byte = 0; byte < BYTESU && at + byte < count; ++byte) {",
        "        word = (CONTAINER)(word | (CONTAINER)((CONTAINER)data[at + byte] << (8U * byte)));",
        "    }",
        "    element->PAYLOAD[at / BYTESU] = word;",
        "}",
    ]);
    out.function(&format!("void {stem}_write_payload({stem}_t *element, const uint8_t *data, size_t count)"), &write);
}

fn joined(out: &mut Writer, message: &Message, stem: &str) {
    let width = message.word_width;
    for joined in &message.joined {
        let holders = holders(joined);
        let whole = whole(joined.width);
        let name = format!("{stem}_{}", joined.ident.upper.to_ascii_lowercase());
        out.comment(&[format!("{}: {}", joined.name, text::sentence(&joined.doc)), text::cites(&joined.cites)]);
        let mut read: Vec<String> = holders
            .iter()
            .enumerate()
            .map(|(number, &word)| {
                format!("const {} part{number} = element->{};", ctype(width), member_name(message, word))
            })
            .collect();
        read.push(gathered(joined, &holders, |_| width));
        out.function(&format!("{whole} {name}_read(const {stem}_t *element)"), &read);
        let write: Vec<String> = holders
            .iter()
            .map(|&word| {
                let parts = joined.parts.iter().filter(|part| part.holder == word);
                let (clear, bits) = parts.fold((0, String::new()), |(clear, bits), part| {
                    (clear | mask(part), format!("{bits} | {}", scattered(part, width, "value")))
                });
                let member = member_name(message, word);
                let container = ctype(width);
                format!(
                    "element->{member} = ({container})((element->{member} & ({container})~{}){bits});",
                    hex(clear, width)
                )
            })
            .collect();
        out.function(&format!("void {name}_write({stem}_t *element, {whole} value)"), &write);
    }
}
