//! Value types and their fields, for registers and for message words.

use proc_macro2::{Ident as Token, TokenStream};
use quote::quote;
use regdef::model::{AccessCode, Field, Ident, Kind, Model};

use super::{doc, hex, ident, int_type, meta, number, word_type};

/// What holds the fields.
pub(super) struct Holder<'a> {
    /// Name for messages.
    pub name: &'a str,
    pub ident: &'a Ident,
    pub width: u32,
}

/// Name of the constant that holds the table of fields.
pub(super) fn table_name(holder: &Ident) -> Token {
    ident(&format!("{}_FIELDS", holder.upper))
}

/// The value type with its getters, setters and constants.
pub(super) fn value(
    model: &Model,
    holder: &Holder<'_>,
    docs: &TokenStream,
    shown: &str,
    reset: u64,
    fields: &[Field],
) -> TokenStream {
    let name = ident(&holder.ident.pascal);
    let word = word_type(holder.width);
    let table = table_name(holder.ident);
    let reset = hex(reset, holder.width);
    let entries = fields.iter().map(|field| meta::field(model, field));
    let accessors = fields.iter().map(|field| accessors(model, holder, field));
    let accessors = (!fields.is_empty()).then(|| quote!(impl #name { #(#accessors)* }));
    quote! {
        #docs
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        #[repr(transparent)]
        pub struct #name(#word);
        pub(crate) const #table: &[Field] = &[#(#entries),*];
        regbus::register!(#name, #word, #shown, #reset, #table);
        #accessors
    }
}

fn accessors(model: &Model, holder: &Holder<'_>, field: &Field) -> TokenStream {
    let getter = field.access.code.readable().then(|| getter(model, holder, field));
    let setter = has_setter(field.access.code).then(|| setter(model, holder, field));
    let flag = flag(model, holder, field);
    quote!(#getter #setter #flag)
}

/// Flags that a write clears have no setter: a value that holds them is given to `clear`.
fn has_setter(code: AccessCode) -> bool {
    !matches!(code, AccessCode::Ro | AccessCode::W1c | AccessCode::W0c | AccessCode::Wclr)
}

/// The parameter, its check and the position of the lane that is meant.
struct Lane {
    parameter: TokenStream,
    lsb: TokenStream,
    doc: Vec<String>,
}

fn lane(holder: &Holder<'_>, field: &Field) -> Lane {
    let Some(lanes) = field.lanes else {
        return Lane { parameter: TokenStream::new(), lsb: number(field.lsb), doc: Vec::new() };
    };
    let (first, count) = (lanes.first, lanes.count);
    let last = first + count - 1;
    let what = format!("{}.{} takes {first}..={last}", holder.name, field.name);
    let (lsb, stride) = (number(field.lsb), number(lanes.stride));
    let (first, count) = (number(first), number(count));
    let position = quote!(regbus::bits::position(n, #first, #count, #what) as u32);
    let lsb = match (field.lsb, lanes.stride) {
        (0, 1) => position,
        (0, _) => quote!(#stride * #position),
        (_, 1) => quote!(#lsb + #position),
        _ => quote!(#lsb + #stride * #position),
    };
    Lane {
        parameter: quote!(n: usize,),
        lsb,
        doc: vec![
            "# Panics".to_owned(),
            format!("If `n`, the number of the lane in this register, is not in {}..={last}.", lanes.first),
        ],
    }
}

fn getter(model: &Model, holder: &Holder<'_>, field: &Field) -> TokenStream {
    let name = ident(&field.ident.snake);
    let Lane { parameter, lsb, doc: lane_doc } = lane(holder, field);
    let mut paragraphs = vec![doc::headline(model, field)];
    paragraphs.extend(doc::details(model, field));
    let width = number(field.width);
    let signed = field.encoding.as_ref().is_some_and(|e| e.signed);
    let raw = quote!(regbus::bits::get(self.0 as u32, #lsb, #width));
    let (result, body) = match field.kind {
        Kind::Bool => (quote!(bool), quote!(#raw != 0)),
        Kind::Int if signed => {
            let int = int_type(field.width, true);
            (quote!(#int), quote!(regbus::bits::get_signed(self.0 as u32, #lsb, #width) as #int))
        }
        Kind::Int => {
            let int = int_type(field.width, false);
            (quote!(#int), quote!(#raw as #int))
        }
        Kind::Enum(id) => {
            let entry = model.enumeration(id);
            let name = ident(&entry.ident.pascal);
            let int = int_type(entry.width, false);
            let result = if entry.is_total() {
                quote!(crate::enums::#name)
            } else {
                paragraphs.push("# Errors".to_owned());
                paragraphs.push("The bits themselves, if they are reserved or have no name.".to_owned());
                quote!(Result<crate::enums::#name, #int>)
            };
            (result, quote!(crate::enums::#name::from_bits(#raw as #int)))
        }
    };
    paragraphs.extend(lane_doc);
    let docs = doc::doc(&paragraphs);
    let must_use =
        (!matches!(field.kind, Kind::Enum(id) if !model.enumeration(id).is_total())).then(|| quote!(#[must_use]));
    quote! {
        #docs
        #[inline(always)]
        #must_use
        pub const fn #name(self, #parameter) -> #result { #body }
    }
}

fn setter(model: &Model, holder: &Holder<'_>, field: &Field) -> TokenStream {
    let name = ident(&format!("with_{}", field.ident.snake.trim_end_matches('_')));
    let Lane { parameter, lsb, doc: lane_doc } = lane(holder, field);
    let width = number(field.width);
    let signed = field.encoding.as_ref().is_some_and(|e| e.signed);
    let mut paragraphs = vec![format!("This value with another `{}`: {}", field.label, doc::sentence(&field.doc))];
    if let Some(value) = field.access.must_write {
        paragraphs.push(format!("Software has to write {value:#x}."));
    }
    let (value_type, value) = match field.kind {
        Kind::Bool => (quote!(bool), quote!(value as u32)),
        Kind::Int if signed => {
            let limit = 1i64 << (field.width - 1);
            let range = format!("{}..={}", -limit, limit - 1);
            paragraphs.extend(panics(&lane_doc, &format!("If the value is not in {range}.")));
            let what = format!("{}.{} takes {range}", holder.name, field.name);
            (int_type(field.width, true), quote!(regbus::bits::within_signed(value as i32, #width, #what)))
        }
        Kind::Int => {
            let int = int_type(field.width, false);
            let fills = field.min == 0 && field.max == u64::MAX >> (64 - type_width(field.width));
            if fills {
                (int, quote!(value as u32))
            } else {
                let range = format!("{}..={}", field.min, field.max);
                paragraphs.extend(panics(&lane_doc, &format!("If the value is not in {range}.")));
                let (min, max) = (number(field.min), number(field.max));
                let what = format!("{}.{} takes {range}", holder.name, field.name);
                (int, quote!(regbus::bits::within(value as u32, #min, #max, #what)))
            }
        }
        Kind::Enum(id) => {
            let entry = model.enumeration(id);
            let name = ident(&entry.ident.pascal);
            let raw = quote!(value.bits() as u32);
            let value = if field.width < entry.width {
                let max = number(field.capacity());
                let what = format!("{}.{} has {} bits", holder.name, field.name, field.width);
                paragraphs.extend(panics(&lane_doc, "If the value does not fit the field."));
                quote!(regbus::bits::within(#raw, 0, #max, #what))
            } else {
                raw
            };
            (quote!(crate::enums::#name), value)
        }
    };
    if paragraphs.iter().all(|p| p != "# Panics") {
        paragraphs.extend(lane_doc);
    }
    let word = word_type(holder.width);
    let docs = doc::doc(&paragraphs);
    quote! {
        #docs
        #[inline(always)]
        #[must_use]
        pub const fn #name(self, #parameter value: #value_type) -> Self {
            Self(regbus::bits::put(self.0 as u32, #lsb, #width, #value) as #word)
        }
    }
}

fn panics(lane_doc: &[String], text: &str) -> Vec<String> {
    let mut paragraphs = vec!["# Panics".to_owned(), text.to_owned()];
    paragraphs.extend(lane_doc.iter().skip(1).cloned());
    paragraphs
}

const fn type_width(width: u32) -> u32 {
    match width {
        0..=8 => 8,
        9..=16 => 16,
        17..=32 => 32,
        _ => 64,
    }
}

/// Fields of one bit as constants that can be combined with `|`.
fn flag(model: &Model, holder: &Holder<'_>, field: &Field) -> Option<TokenStream> {
    if field.width != 1 {
        return None;
    }
    let word = word_type(holder.width);
    let headline = doc::headline(model, field);
    Some(match field.lanes {
        None => {
            // Every value type has constants of these names.
            let taken = matches!(field.ident.upper.as_str(), "ZERO" | "RESET");
            let name = ident(&if taken { format!("{}_BIT", field.ident.upper) } else { field.ident.upper.clone() });
            let mask = hex(field.mask(), holder.width);
            let docs = doc::doc(&[headline]);
            quote!(#docs pub const #name: Self = Self(#mask);)
        }
        Some(_) => {
            let name = ident(&format!("{}_bit", field.ident.snake.trim_end_matches('_')));
            let Lane { parameter, lsb, doc: lane_doc } = lane(holder, field);
            let all = ident(&format!("{}_ALL", field.ident.upper));
            let mask = hex(field.mask(), holder.width);
            let mut paragraphs = vec![format!("The bit of one lane of {headline}")];
            paragraphs.extend(lane_doc);
            let docs = doc::doc(&paragraphs);
            let all_docs = doc::doc(&[format!("The bits of all lanes of `{}`.", field.label)]);
            quote! {
                #docs
                #[inline(always)]
                #[must_use]
                pub const fn #name(#parameter) -> Self { Self(1 << (#lsb) as #word) }
                #all_docs
                pub const #all: Self = Self(#mask);
            }
        }
    })
}
