//! The crate's front page and the manual's contradictions and silences.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{Model, Target};

use super::{doc, ident};
use crate::text;

pub(super) fn lib(model: &Model) -> TokenStream {
    let front = doc::inner(&front_page(model));
    // The attribute stands in a literal of its own: rustfmt obeys it even inside a macro.
    let skip: TokenStream = "#[rustfmt::skip]".parse().expect("an attribute is a token stream");
    let messages = (!model.messages.is_empty()).then(|| quote!(#skip pub mod messages;));
    let instances = (!model.instances.is_empty()).then(|| quote!(#skip pub mod instances;));
    let peripheral = ident(&model.names.ident.pascal);
    let clusters = model.clusters.iter().map(|c| ident(&c.ident.pascal));
    let resting = super::peripheral::resting_window(model);
    let windows = model.windows.iter().enumerate().filter(|(index, _)| resting.is_none_or(|id| id.0 != *index));
    let windows = windows.map(|(_, w)| ident(&format!("{}Window", w.ident.pascal)));
    let notes = notes(model).map(|module| quote!(#skip #module));
    quote! {
        #front
        #![no_std]
        #![allow(
            clippy::cast_lossless,
            clippy::identity_op,
            clippy::module_inception,
            clippy::unnecessary_cast,
            rustdoc::redundant_explicit_links,
            reason = "one form of body serves all widths"
        )]

        #skip
        pub mod enums;
        #skip
        pub mod guards;
        #instances
        #notes
        #messages
        #[cfg(feature = "meta")]
        #skip
        pub mod meta;
        #skip
        mod peripheral;
        #skip
        pub mod registers;

        #skip
        pub use peripheral::{#peripheral, #(#clusters,)* #(#windows,)*};
        pub use regbus::{Bus, Mmio, Reg};
    }
}

fn front_page(model: &Model) -> String {
    let manual = &model.manual;
    let krate = model.names.krate.replace('-', "_");
    let peripheral = &model.names.ident.pascal;
    let document = manual.document.as_ref().map_or(String::new(), |d| format!(" ({})", doc::md(d)));
    let first = model
        .block_registers()
        .find(|(_, r)| r.offset.is_some() && r.capabilities.readable && r.dim.is_none() && r.window.is_none())
        .map_or(String::new(), |(_, r)| {
            format!("let value = can.{0}().read(); // {1}\n", r.ident.snake, text::one_line(&r.title))
        });
    let mut out = format!(
        "Registers of {title}.\n\n{about}\n\nTranscribed from *{manual}*{document}, {publisher}, revision {revision}, {date}. Every \
         register and field names the place where it stands. What a register does not allow, such as a read-modify-write that \
         would clear flags, does not compile, and the message says what to do instead.\n\n\
         # Example\n\n\
         ```no_run\nuse {krate}::{{{peripheral}, Mmio}};\n\n\
         // SAFETY: the address is this chip's, and nothing else in the program uses the block.\n\
         let can = {peripheral}::new(unsafe {{ Mmio::new(0x4000_0000) }});\n{first}```\n\n\
         # Where to find what\n\n\
         - [`{peripheral}`]: the register block, with the table of all registers.\n\
         - [`registers`]: the value of each register: fields, reset, access rules, traps.\n\
         - [`enums`]: named values of fields.\n",
        title = doc::md(&model.title),
        about = doc::sentence(&model.doc),
        manual = doc::md(&manual.title),
        publisher = doc::md(&manual.publisher),
        revision = doc::md(&manual.revision),
        date = doc::md(&manual.date),
    );
    if !model.messages.is_empty() {
        out += "- [`messages`]: messages in memory, word by word.\n";
    }
    if !model.instances.is_empty() {
        out += "- [`instances`]: where known chips have the controller.\n";
    }
    if !model.conflicts.is_empty() || !model.choices.is_empty() {
        out += "- [`manual_notes`]: where the manual contradicts itself or is silent, and what is taken.\n";
    }
    if let Some(text) = &manual.doc {
        out += &format!("\n# About the manual\n\n{}\n", doc::sentence(text));
    }
    out += "\n# Features\n\n\
            - `meta`: the description as data, in the module `meta`.\n\
            - `defmt`: `defmt::Format` for all values.\n\
            - `critical-section`: window access that takes a critical-section token.\n";
    out
}

fn notes(model: &Model) -> Option<TokenStream> {
    if model.conflicts.is_empty() && model.choices.is_empty() {
        return None;
    }
    let mut out = String::from("Where the manual contradicts itself or is silent, and what is taken.\n");
    if !model.conflicts.is_empty() {
        out += "\n# Contradictions and damage\n";
    }
    for conflict in &model.conflicts {
        out += &format!("\n## `{}`\n\n{}\n\n", conflict.id, doc::sentence(&conflict.what));
        let at = targets(model, &conflict.at);
        if !at.is_empty() {
            out += &format!("About {at}.\n\n");
        }
        for reading in &conflict.says {
            out += &format!(
                "- {}: {}\n",
                doc::md(&text::cites(std::slice::from_ref(&reading.cite))),
                doc::sentence(&reading.says)
            );
        }
        out += &format!("\nTaken: {} {}\n", doc::sentence(&conflict.taken), doc::sentence(&conflict.because));
    }
    if !model.choices.is_empty() {
        out += "\n# Silences\n";
    }
    for choice in &model.choices {
        out += &format!("\n## `{}`\n\n{}\n\n", choice.id, doc::sentence(&choice.question));
        let at = targets(model, &choice.at);
        if !at.is_empty() {
            out += &format!("About {at}.\n\n");
        }
        if !choice.nearest.is_empty() {
            out += &format!("Nearest words: {}\n\n", doc::sentence(&choice.nearest));
        }
        out += &format!("Choice: {} {}\n", doc::sentence(&choice.choice), doc::sentence(&choice.because));
        if !choice.alternatives.is_empty() {
            let list: Vec<_> = choice.alternatives.iter().map(|a| doc::sentence(a)).collect();
            out += &format!("\nAlternatives: {}\n", list.join(" "));
        }
    }
    let docs = doc::inner(out.trim_end());
    Some(quote!(pub mod manual_notes { #docs }))
}

fn targets(model: &Model, at: &[Target]) -> String {
    let one = |target: &Target| match target {
        Target::Register(id) => {
            let r = model.register(*id);
            format!("[`{}`](crate::registers::{})", r.name, r.ident.pascal)
        }
        Target::Field(at) => {
            let (r, f) = (model.register(at.register), model.field(*at));
            let method = if f.access.code.readable() { format!("::{}", f.ident.snake) } else { String::new() };
            format!("[`{}.{}`](crate::registers::{}{method})", r.name, f.name, r.ident.pascal)
        }
        Target::Cluster(id) => {
            let c = &model.clusters[id.0];
            format!("[`{}`](crate::{})", c.name, c.ident.pascal)
        }
        Target::Joined(index) => format!("`{}`", model.joined[*index].name),
        Target::Enum(id) => {
            let e = model.enumeration(*id);
            format!("[`{}`](crate::enums::{})", e.name, e.ident.pascal)
        }
        Target::Message(id) => {
            let m = &model.messages[id.0];
            format!("[`{}`](crate::messages::{})", m.name, m.ident.pascal)
        }
        Target::Word(id, word) | Target::WordField(id, word, _) => {
            let m = &model.messages[id.0];
            let owner =
                m.words[*word].same_as.map_or(&m.words[*word].ident, |(m, w)| &model.messages[m.0].words[w].ident);
            format!("[`{}.{}`](crate::messages::{})", m.name, m.words[*word].name, owner.pascal)
        }
    };
    at.iter().map(one).collect::<Vec<_>>().join(", ")
}
