//! Values split over several registers or words, as methods that read and write them whole.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{HalfOrder, Joined, Model, Part, Register, RegisterId};

use super::registers::keep_and_ones;
use super::{doc, hex, ident, int_type, number, offset, word_type};

/// `read_NAME` and `write_NAME` of a value over registers.
pub(super) fn accessors(model: &Model, joined: &Joined) -> TokenStream {
    let first = model.register(joined.parts[0].holder);
    let dim = first.dim.as_ref().filter(|_| joined.cluster.is_none() || first.dim.is_some());
    let name = match joined.cluster {
        Some(id) => joined.ident.within(&model.clusters[id.0].ident),
        None => joined.ident.clone(),
    };
    let parameter = dim.map(|_| quote!(n: usize,));
    let position = dim.map(|dim| {
        let numbers = format!("{}..={}", dim.first, dim.first + dim.count - 1);
        let what = format!("{} takes {numbers}", joined.name);
        let (first, count) = (number(dim.first), number(dim.count));
        quote!(let position = regbus::bits::position(n, #first, #count, #what);)
    });
    let base = joined.cluster.map(|_| quote!(self.offset +));
    let halves: Vec<Half<'_>> = ordered(joined)
        .into_iter()
        .map(|part| {
            let register = model.register(part.holder);
            let at = offset(register.offset.unwrap_or(0));
            let step = register.dim.as_ref().map(|dim| {
                let stride = offset(dim.stride);
                quote!(+ #stride * position)
            });
            Half { part, register, at: quote!(#base #at #step) }
        })
        .collect();
    let panics = dim.map(|dim| format!("If `n` is not in {}..={}.", dim.first, dim.first + dim.count - 1));
    let read = halves
        .iter()
        .all(|h| h.register.capabilities.readable)
        .then(|| read(model, joined, &name.snake, &halves, parameter.as_ref(), position.as_ref(), panics.as_deref()));
    let write = halves
        .iter()
        .all(Half::writable)
        .then(|| write(model, joined, &name.snake, &halves, parameter.as_ref(), position.as_ref(), panics.as_deref()));
    quote!(#read #write)
}

/// The parts in the order of access.
fn ordered(joined: &Joined) -> Vec<Part<RegisterId>> {
    let mut parts = joined.parts.clone();
    if joined.order == HalfOrder::HighFirst {
        parts.reverse();
    }
    parts
}

struct Half<'a> {
    part: Part<RegisterId>,
    register: &'a Register,
    at: TokenStream,
}

impl Half<'_> {
    fn literal(&self) -> TokenStream {
        let (at, part) = (&self.at, &self.part);
        let (lsb, width, shift) = (number(part.lsb), number(part.width), number(part.shift));
        quote!(regbus::Half { offset: #at, lsb: #lsb, width: #width, shift: #shift })
    }

    /// The register holds nothing writable besides the part, so that a plain store is enough.
    fn alone(&self) -> bool {
        let part = regdef::model::bit_mask(self.part.lsb, self.part.width);
        self.register.writable_bits() & !part == 0
    }

    fn writable(&self) -> bool {
        let part = regdef::model::bit_mask(self.part.lsb, self.part.width);
        let whole = self.register.writable_bits() & part != 0;
        whole && self.register.capabilities.writable && (self.alone() || self.register.capabilities.modify.is_ok())
    }
}

fn read(
    model: &Model,
    joined: &Joined,
    name: &str,
    halves: &[Half<'_>],
    parameter: Option<&TokenStream>,
    position: Option<&TokenStream>,
    panics: Option<&str>,
) -> TokenStream {
    let method = ident(&format!("read_{}", name.trim_end_matches('_')));
    let int = int_type(joined.width, false);
    let steps = halves.iter().map(|half| {
        let (literal, word) = (half.literal(), word_type(half.register.width));
        quote!(value |= #literal.read::<#word, B>(self.bus);)
    });
    let mut paragraphs = vec![
        format!("Reads `{}`: {}", joined.name, doc::sentence(&joined.doc)),
        format!("{} bits from {}, read in this order.", joined.width, names(model, halves)),
    ];
    if halves.iter().any(|h| !h.register.capabilities.pure) {
        paragraphs.push("Reading these registers has side effects.".to_owned());
    }
    paragraphs.extend(panics.into_iter().flat_map(|text| ["# Panics".to_owned(), text.to_owned()]));
    paragraphs.push(doc::source(model, &joined.cites));
    let docs = doc::doc(&paragraphs);
    quote! {
        #docs
        #[inline]
        #[must_use]
        pub fn #method(&self, #parameter) -> #int {
            #position
            let mut value = 0;
            #(#steps)*
            value as #int
        }
    }
}

fn write(
    model: &Model,
    joined: &Joined,
    name: &str,
    halves: &[Half<'_>],
    parameter: Option<&TokenStream>,
    position: Option<&TokenStream>,
    panics: Option<&str>,
) -> TokenStream {
    let method = ident(&format!("write_{}", name.trim_end_matches('_')));
    let int = int_type(joined.width, false);
    let steps = halves.iter().map(|half| {
        let (literal, word) = (half.literal(), word_type(half.register.width));
        if half.alone() {
            quote!(#literal.write::<#word, B>(self.bus, value as u64);)
        } else {
            let (keep, ones) = keep_and_ones(half.register);
            quote!(#literal.modify::<#word, B>(self.bus, value as u64, #keep, #ones);)
        }
    });
    let hazard = halves.iter().find_map(|h| h.register.unsafe_write.as_deref());
    let mut paragraphs = vec![
        format!("Writes `{}`: {}", joined.name, doc::sentence(&joined.doc)),
        format!("{} bits to {}, written in this order.", joined.width, names(model, halves)),
    ];
    if halves.iter().any(|h| !h.alone()) {
        paragraphs.push("Registers that hold other fields too are read, changed and written back.".to_owned());
    }
    if let Some(reason) = hazard {
        paragraphs.push("# Safety".to_owned());
        paragraphs.push(doc::sentence(reason));
    }
    let check = check(joined);
    if check.is_some() || panics.is_some() {
        paragraphs.push("# Panics".to_owned());
        let width = check.is_some().then(|| format!("If the value has more than {} bits.", joined.width));
        paragraphs.extend(width.into_iter().chain(panics.map(ToOwned::to_owned)));
    }
    paragraphs.push(doc::source(model, &joined.cites));
    let docs = doc::doc(&paragraphs);
    let qualifier = hazard.map(|_| quote!(unsafe));
    let allow = hazard.map(|_| quote!(#[allow(unsafe_code, reason = "the hardware uses the value as an address")]));
    quote! {
        #docs
        #allow
        #[inline]
        pub #qualifier fn #method(&self, #parameter value: #int) {
            #position
            #check
            #(#steps)*
        }
    }
}

/// The check that a value fits, where its type holds more.
pub(super) fn check<R>(joined: &Joined<R>) -> Option<TokenStream> {
    (!matches!(joined.width, 8 | 16 | 32 | 64)).then(|| {
        let max = hex(regdef::model::bit_mask(0, joined.width), joined.width.next_multiple_of(4));
        let what = format!("{} has {} bits", joined.name, joined.width);
        quote!(assert!(value <= #max, #what);)
    })
}

fn names(model: &Model, halves: &[Half<'_>]) -> String {
    let name = |half: &Half<'_>| match half.part.field {
        Some(field) => {
            let field = &model.register(half.part.holder).fields[field];
            format!(
                "[`{0}.{1}`](crate::registers::{2}::{3})",
                half.register.name, field.name, half.register.ident.pascal, field.ident.snake
            )
        }
        None => format!("[`{0}`](crate::registers::{1})", half.register.name, half.register.ident.pascal),
    };
    halves.iter().map(name).collect::<Vec<_>>().join(", ")
}
