//! Message elements in memory.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{Ident, Message, MessageId, Model, Word};

use super::fields::{self, Holder};
use super::{doc, hex, ident, int_type, joined, number, offset, word_type};

pub(super) fn module(model: &Model) -> TokenStream {
    let messages = model.messages.iter().enumerate().map(|(index, message)| {
        let words = message.words.iter().filter(|w| w.same_as.is_none()).map(|word| word_value(model, message, word));
        let element = element(model, MessageId(index), message);
        quote!(#(#words)* #element)
    });
    let head = doc::inner(&format!(
        "Messages in memory: {}\n\nAn element is reached through a [`Bus`](regbus::Bus) over its memory. Every access is one \
         volatile access of a whole word.",
        doc::sentence(&model.memory.doc)
    ));
    quote! {
        #head
        #[allow(unused_imports, reason = "not every message has a payload")]
        use regbus::{Bus, Mmio, Payload, Reg};
        use regbus::meta::{Access, Field};

        #(#messages)*
    }
}

/// The identifier of a word's type: its own, or that of the word it equals.
fn type_of<'a>(model: &'a Model, word: &'a Word) -> &'a Ident {
    match word.same_as {
        Some((message, index)) => &model.messages[message.0].words[index].ident,
        None => &word.ident,
    }
}

fn word_value(model: &Model, message: &Message, word: &Word) -> TokenStream {
    let present = word.present_when.map_or(String::new(), |id| {
        format!("The word has this layout if `{}`.", model.condition(id).expr.display(model))
    });
    let docs = doc::doc(&[
        format!("Word `{}` of a {}, at byte {:#x}.", word.name, doc::md(&message.title), word.offset),
        doc::sentence(&word.doc),
        present,
        doc::source(model, &word.cites),
    ]);
    let shown = format!("{}.{}", message.name, word.name);
    let holder = Holder { name: &shown, ident: &word.ident, width: message.word_width };
    let value = fields::value(model, &holder, &docs, &shown, 0, &word.fields);
    let name = ident(&word.ident.pascal);
    let keep = hex(word.fields.iter().fold(0, |m, f| m | f.mask()), message.word_width);
    quote! {
        #value
        impl regbus::Readable for #name {}
        impl regbus::Pure for #name {}
        impl regbus::Writable for #name {}
        impl<B: Bus> regbus::Modify<B> for #name {
            const KEEP: u32 = #keep;
            const ONES: u32 = 0;
        }
    }
}

fn element(model: &Model, id: MessageId, message: &Message) -> TokenStream {
    let name = ident(&message.ident.pascal);
    let header = number(message.header_bytes);
    let sections: Vec<_> =
        model.memory.sections.iter().filter(|s| s.elements.contains(&id)).map(|s| format!("`{}`", s.name)).collect();
    let used =
        if sections.is_empty() { String::new() } else { format!("Sections of memory: {}.", sections.join(", ")) };
    let docs = doc::doc(&[
        format!("{}.", doc::md(message.title.trim_end_matches('.'))),
        doc::sentence(&message.doc),
        used,
        word_table(model, message),
        doc::source(model, &message.cites),
    ]);
    let words = message.words.iter().map(|word| {
        let method = ident(&Ident::new(&word.name).snake);
        let value = ident(&type_of(model, word).pascal);
        let at = offset(word.offset);
        let docs = doc::doc(&[format!("Word `{}`.", word.name), doc::sentence(&word.doc)]);
        quote! {
            #docs
            #[inline(always)]
            #[must_use]
            pub fn #method(&self) -> Reg<#value, B> { Reg::new(self.bus, self.offset + #at) }
        }
    });
    let payload = payload(message);
    let values = message.joined.iter().map(|j| joined_methods(model, message, j));
    let bytes = bytes(message);
    quote! {
        #docs
        #[derive(Clone, Copy, Debug)]
        pub struct #name<B: Bus = Mmio> {
            bus: B,
            offset: usize,
        }

        impl<B: Bus> #name<B> {
            /// The element at a byte offset of a memory.
            #[inline(always)]
            #[must_use]
            pub const fn new(memory: B, offset: usize) -> Self {
                Self { bus: memory, offset }
            }
            /// Byte offset in the memory.
            #[inline]
            #[must_use]
            pub const fn offset(&self) -> usize {
                self.offset
            }
            /// Bytes in front of the data, or of the whole element if it has none.
            pub const HEADER_BYTES: usize = #header;
            #bytes
            #(#words)*
            #payload
            #(#values)*
        }
    }
}

fn word_table(model: &Model, message: &Message) -> String {
    let mut out = String::from("| byte | word | layout if |\n|---|---|---|");
    for word in &message.words {
        let present = word
            .present_when
            .map_or(String::new(), |id| format!("`{}`", model.condition(id).expr.display(model).replace('|', "\\|")));
        out += &format!("\n| {:#x} | [`{}`]({}) | {present} |", word.offset, word.name, type_of(model, word).pascal);
    }
    if let Some(payload) = &message.payload {
        let sizes: Vec<_> = payload.sizes.iter().map(ToString::to_string).collect();
        out += &format!("\n| {:#x} | data, {} bytes | |", payload.offset, sizes.join(", "));
    }
    out
}

fn bytes(message: &Message) -> TokenStream {
    let whole = |data: u32| number(message.element_bytes(data));
    match &message.payload {
        None => {
            let bytes = whole(0);
            quote! {
                /// Bytes of an element.
                pub const BYTES: usize = #bytes;
            }
        }
        Some(payload) if payload.sizes.len() == 1 => {
            let bytes = whole(payload.sizes[0]);
            quote! {
                /// Bytes of an element.
                pub const BYTES: usize = #bytes;
            }
        }
        Some(payload) => {
            let sizes = payload.sizes.iter().map(|s| number(*s));
            let count = payload.sizes.len();
            let header = number(message.header_bytes);
            quote! {
                /// Sizes in bytes the data can be configured for, in the order of the codes of the size field.
                pub const PAYLOAD_BYTES: [usize; #count] = [#(#sizes),*];
                /// Bytes of an element whose data has the size with this code.
                ///
                /// # Panics
                ///
                /// If there is no such code.
                #[inline]
                #[must_use]
                pub const fn bytes(code: usize) -> usize { #header + Self::PAYLOAD_BYTES[code] }
            }
        }
    }
}

fn payload(message: &Message) -> Option<TokenStream> {
    let payload = message.payload.as_ref()?;
    let word = word_type(message.word_width);
    let at = offset(payload.offset);
    let text = doc::sentence(&payload.doc);
    Some(if let [size] = payload.sizes[..] {
        let docs = doc::doc(&[format!("The {size} data bytes."), text]);
        let size = number(size);
        quote! {
            #docs
            #[inline(always)]
            #[must_use]
            pub const fn payload(&self) -> Payload<#word, B> { Payload::new(self.bus, self.offset + #at, #size) }
        }
    } else {
        let docs = doc::doc(&[
            "The data bytes; `code` is that of the size the element is configured for.".to_owned(),
            text,
            "# Panics".to_owned(),
            "If there is no such code.".to_owned(),
        ]);
        quote! {
            #docs
            #[inline(always)]
            #[must_use]
            pub const fn payload(&self, code: usize) -> Payload<#word, B> {
                Payload::new(self.bus, self.offset + #at, Self::PAYLOAD_BYTES[code])
            }
        }
    })
}

/// `read_NAME` and `write_NAME` of a value over words of the element.
fn joined_methods(model: &Model, message: &Message, value: &regdef::model::Joined<usize>) -> TokenStream {
    let read = ident(&format!("read_{}", value.ident.snake.trim_end_matches('_')));
    let write = ident(&format!("write_{}", value.ident.snake.trim_end_matches('_')));
    let int = int_type(value.width, false);
    let word = word_type(message.word_width);
    let halves: Vec<_> = value
        .parts
        .iter()
        .map(|part| {
            let at = offset(message.words[part.holder].offset);
            let (lsb, width, shift) = (number(part.lsb), number(part.width), number(part.shift));
            quote!(regbus::Half { offset: self.offset + #at, lsb: #lsb, width: #width, shift: #shift })
        })
        .collect();
    let keep: Vec<_> = value
        .parts
        .iter()
        .map(|part| {
            let fields = &message.words[part.holder].fields;
            hex(fields.iter().fold(0, |m, f| m | f.mask()), message.word_width)
        })
        .collect();
    let from: Vec<_> = value
        .parts
        .iter()
        .map(|part| {
            let word = &message.words[part.holder];
            let field = part.field.map_or(String::new(), |f| format!(".{}", word.fields[f].name));
            format!("`{}{field}`", word.name)
        })
        .collect();
    let text = format!("{} bits, of {}.", value.width, from.join(", "));
    let read_docs = doc::doc(&[format!("Reads `{}`: {}", value.name, doc::sentence(&value.doc)), text.clone()]);
    let check = joined::check(value);
    let panics = check.as_ref().map(|_| format!("If the value has more than {} bits.", value.width));
    let mut paragraphs = vec![format!("Writes `{}`: {}", value.name, doc::sentence(&value.doc)), text];
    paragraphs.extend(panics.into_iter().flat_map(|text| ["# Panics".to_owned(), text]));
    paragraphs.push(doc::source(model, &value.cites));
    let write_docs = doc::doc(&paragraphs);
    quote! {
        #read_docs
        #[inline]
        #[must_use]
        pub fn #read(&self) -> #int {
            let mut value = 0;
            #(value |= #halves.read::<#word, B>(self.bus);)*
            value as #int
        }
        #write_docs
        #[inline]
        pub fn #write(&self, value: #int) {
            #check
            #(#halves.modify::<#word, B>(self.bus, value as u64, #keep, 0);)*
        }
    }
}
