//! Enumerations.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{Enum, Model};

use super::{doc, ident, int_type, meta, number};

pub(super) fn module(model: &Model) -> TokenStream {
    let enums = model.enums.iter().map(|entry| enumeration(model, entry));
    let head = doc::inner(&format!("Named values of the fields of {}.", doc::md(&model.title)));
    quote!(#head #(#enums)*)
}

fn enumeration(model: &Model, entry: &Enum) -> TokenStream {
    let name = ident(&entry.ident.pascal);
    let width = entry.width.max(1);
    let int = int_type(width, false);
    let plain = entry.variants.iter().all(|v| v.first == v.last);
    let users: Vec<_> = entry
        .used_by
        .iter()
        .map(|at| {
            let (register, field) = (model.register(at.register), model.field(*at));
            format!("[`{0}::{1}`](crate::registers::{0}::{1})", register.ident.pascal, field.ident.snake)
        })
        .collect();
    let headline =
        if entry.doc.is_empty() { format!("Values of `{}`.", entry.name) } else { doc::sentence(&entry.doc) };
    let reserved = if entry.reserved.is_empty() {
        String::new()
    } else {
        let list = entry.reserved.iter().map(|(a, b)| if a == b { a.to_string() } else { format!("{a} to {b}") });
        format!("Reserved, never to be used: {}.", list.collect::<Vec<_>>().join(", "))
    };
    let used = if users.is_empty() { String::new() } else { format!("Used by {}.", users.join(", ")) };
    let docs = doc::doc(&[headline, reserved, used, doc::source(model, &entry.cites)]);
    let variants = entry.variants.iter().map(|variant| {
        let name = ident(&variant.ident.pascal);
        let value = number(variant.first);
        let text = if variant.doc.is_empty() { format!("`{}`", variant.name) } else { doc::sentence(&variant.doc) };
        let quantity = variant.number.map_or(String::new(), |n| format!("Stands for {n}."));
        if variant.first == variant.last {
            let docs = doc::doc(&[format!("{}: {text}", variant.first), quantity]);
            let value = plain.then(|| quote!(= #value));
            quote!(#docs #name #value,)
        } else {
            let docs = doc::doc(&[
                format!("{} to {}: {text} It holds the value itself.", variant.first, variant.last),
                quantity,
            ]);
            quote!(#docs #name(#int),)
        }
    });
    let repr = plain.then(|| quote!(#[repr(#int)]));
    let total = entry.is_total();
    let arms = entry.variants.iter().enumerate().map(|(index, variant)| {
        let name = ident(&variant.ident.pascal);
        let (first, last) = (number(variant.first), number(variant.last));
        let value = if variant.first == variant.last { quote!(Self::#name) } else { quote!(Self::#name(bits)) };
        let value = if total { value } else { quote!(Ok(#value)) };
        let wild = total && index + 1 == entry.variants.len();
        match (wild, variant.first == variant.last) {
            (true, _) => quote!(_ => #value,),
            (false, true) => quote!(#first => #value,),
            (false, false) => quote!(#first..=#last => #value,),
        }
    });
    let body = match (total, &entry.variants[..]) {
        (true, [only]) => {
            let name = ident(&only.ident.pascal);
            quote!(Self::#name(bits))
        }
        (true, _) => quote!(match bits { #(#arms)* }),
        (false, _) => quote!(match bits { #(#arms)* _ => Err(bits), }),
    };
    let from_bits = if total {
        quote! {
            /// The value of a field's bits; bits above the field are ignored where they decide nothing.
            #[inline]
            #[must_use]
            pub const fn from_bits(bits: #int) -> Self {
                #body
            }
        }
    } else {
        quote! {
            /// The value of a field's bits.
            ///
            /// # Errors
            ///
            /// The bits themselves, if they are reserved or have no name.
            #[inline]
            pub const fn from_bits(bits: #int) -> Result<Self, #int> {
                #body
            }
        }
    };
    let to_bits = if plain {
        quote!(self as #int)
    } else {
        let arms = entry.variants.iter().map(|variant| {
            let name = ident(&variant.ident.pascal);
            let (first, last) = (number(variant.first), number(variant.last));
            if variant.first == variant.last {
                quote!(Self::#name => #first,)
            } else {
                let what = format!(
                    "{}::{} takes {}..={}",
                    entry.ident.pascal, variant.ident.pascal, variant.first, variant.last
                );
                quote!(Self::#name(value) => regbus::bits::within(value as u32, #first, #last, #what) as #int,)
            }
        });
        quote!(match self { #(#arms)* })
    };
    let numbers = entry.variants.iter().any(|v| v.number.is_some()).then(|| {
        let arms = entry.variants.iter().map(|variant| {
            let name = ident(&variant.ident.pascal);
            let pattern = if variant.first == variant.last { quote!(Self::#name) } else { quote!(Self::#name(_)) };
            match variant.number {
                Some(n) => {
                    let n = number(n);
                    quote!(#pattern => Some(#n),)
                }
                None => quote!(#pattern => None,),
            }
        });
        quote! {
            /// The quantity the value stands for, if it is one.
            #[inline]
            #[must_use]
            pub const fn number(self) -> Option<u32> {
                match self { #(#arms)* }
            }
        }
    });
    let panics = (!plain)
        .then(|| doc::doc(&["# Panics".to_owned(), "If a variant holds a value outside its range.".to_owned()]));
    let gap = (!plain).then(|| quote!(#[doc = ""]));
    let values = meta::values(entry);
    let constant = meta::values_name(entry);
    quote! {
        #values
        #docs
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #repr
        pub enum #name { #(#variants)* }

        impl #name {
            #from_bits

            /// The bits of the value.
            #gap
            #panics
            #[inline]
            #[must_use]
            pub const fn bits(self) -> #int { #to_bits }

            #numbers
        }

        regbus::enumeration!(#name, #constant);
    }
}
