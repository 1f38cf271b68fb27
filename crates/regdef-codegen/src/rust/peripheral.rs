//! The peripheral, its clusters and its windows.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{ClusterId, Dim, Joined, Model, Neutral, Register, WindowId};

use super::guards::window_guard;
use super::{doc, hex, ident, joined, number, offset, word_type};

/// The window that is selected after reset: its registers are reached without a guard.
pub(super) fn resting_window(model: &Model) -> Option<WindowId> {
    let first = model.windows.first()?;
    let field = model.field(first.select);
    let reset = field.reset_of_lane(model.register(first.select.register).reset, 0)?;
    model.windows.iter().position(|w| w.value == reset).map(WindowId)
}

pub(super) fn module(model: &Model) -> TokenStream {
    let name = ident(&model.names.ident.pascal);
    let registers = model.block_registers().filter(|(_, r)| r.offset.is_some()).map(|(_, r)| accessor(model, r, None));
    let clusters = model.clusters.iter().enumerate().map(|(index, _)| cluster_accessor(model, ClusterId(index)));
    let cluster_types = model.clusters.iter().enumerate().map(|(index, _)| cluster_type(model, ClusterId(index)));
    let values = model.joined.iter().filter(|j| j.cluster.is_none() && !in_guarded_window(model, j));
    let values = values.map(|j| joined::accessors(model, j));
    let resting = resting_window(model);
    let windows = (0..model.windows.len()).map(WindowId).filter(|id| Some(*id) != resting);
    let opening = windows.clone().map(|id| window_method(model, id));
    let window_types = windows.map(|id| window_type(model, id));
    let docs = doc::doc(&[
        format!("{}.", doc::md(model.title.trim_end_matches('.'))),
        doc::sentence(&model.doc),
        "Its registers are reached through a [`Bus`](regbus::Bus): [`Mmio`](regbus::Mmio) on hardware, a model in a simulation."
            .to_owned(),
        "# Registers".to_owned(),
        register_table(model),
    ]);
    let head = doc::inner(&format!("The register block of {}.", doc::md(&model.title)));
    quote! {
        #head
        use regbus::{Bus, Mmio, Reg};

        use crate::registers::*;

        #docs
        #[derive(Debug)]
        pub struct #name<B: Bus = Mmio> {
            bus: B,
        }

        impl<B: Bus> #name<B> {
            /// The controller behind a bus whose offset 0 is the base of the register block.
            #[inline]
            #[must_use]
            pub const fn new(bus: B) -> Self {
                Self { bus }
            }

            /// The bus.
            #[inline]
            #[must_use]
            pub const fn bus(&self) -> B {
                self.bus
            }

            #(#registers)*
            #(#clusters)*
            #(#values)*
            #(#opening)*
        }

        #(#cluster_types)*
        #(#window_types)*
    }
}

fn register_table(model: &Model) -> String {
    let mut rows: Vec<(u64, String)> = Vec::new();
    let repeated = |dim: Option<&Dim>| dim.map_or(String::new(), |d| format!(" × {}", d.count));
    for (_, register) in model.block_registers() {
        let Some(at) = register.offset else { continue };
        let window = register.window.map_or(String::new(), |id| format!(", window `{}`", model.windows[id.0].name));
        let row = format!(
            "| `{at:#05x}`{}{window} | [`{}`](crate::registers::{}) | {} |",
            repeated(register.dim.as_ref()),
            register.label.replace("{n}", "n"),
            register.ident.pascal,
            doc::md(&register.title)
        );
        rows.push((at, row));
    }
    for (index, cluster) in model.clusters.iter().enumerate() {
        for (_, register) in model.cluster_registers(ClusterId(index)) {
            let at = cluster.offset + register.offset.unwrap_or(0);
            let row = format!(
                "| `{at:#05x}`{} | [`{}`](crate::registers::{}) | {} |",
                repeated(Some(&cluster.dim)),
                register.label.replace("{n}", "n"),
                register.ident.pascal,
                doc::md(&register.title)
            );
            rows.push((at, row));
        }
    }
    rows.sort_by_key(|(at, _)| *at);
    let lines: Vec<_> = rows.into_iter().map(|(_, row)| row).collect();
    format!("| offset | register | |\n|---|---|---|\n{}", lines.join("\n"))
}

/// The methods that reach one register: alone, or as an array with its length, iterator and lanes.
fn accessor(model: &Model, register: &Register, within: Option<ClusterId>) -> TokenStream {
    let method = match within {
        Some(id) => register.ident.within(&model.clusters[id.0].ident),
        None => register.ident.clone(),
    };
    let name = ident(&method.snake);
    let value = ident(&register.ident.pascal);
    let at = offset(register.offset.unwrap_or(0));
    let base = within.map(|_| quote!(self.offset +));
    let outside = register.window.filter(|id| within.is_none() && Some(*id) != resting_window(model));
    let bound = outside.map(|id| {
        let guard = ident(&window_guard(register, &model.windows[id.0]));
        quote!(where B: crate::guards::#guard)
    });
    let title = format!("`{}`: {}.", register.label.replace("{n}", "n"), doc::md(register.title.trim_end_matches('.')));
    let Some(dim) = &register.dim else {
        let docs = doc::doc(&[title]);
        return quote! {
            #docs
            #[inline(always)]
            #[must_use]
            pub fn #name(&self) -> Reg<#value, B> #bound { Reg::new(self.bus, #base #at) }
        };
    };
    let numbers = format!("{}..={}", dim.first, dim.first + dim.count - 1);
    let what = format!("{} takes {numbers}", method.snake);
    let (first, count, stride) = (number(dim.first), number(dim.count), offset(dim.stride));
    let docs = doc::doc(&[
        title,
        "# Panics".to_owned(),
        format!("If `n`, the manual's number of the register, is not in {numbers}."),
    ]);
    let length = ident(&format!("{}_LEN", method.upper));
    let length_docs =
        doc::doc(&[format!("Number of [`{}`](Self::{name}) registers.", register.label.replace("{n}", "n"))]);
    let iter = ident(&format!("{}_iter", method.snake));
    let iter_docs = doc::doc(&[format!("All [`{name}`](Self::{name}) registers with their numbers.")]);
    let end = number(dim.first + dim.count);
    let lanes = lanes(register, &method.snake, dim, bound.as_ref());
    quote! {
        #docs
        #[inline(always)]
        #[must_use]
        pub fn #name(&self, n: usize) -> Reg<#value, B> #bound {
            Reg::new(self.bus, #base #at + #stride * regbus::bits::position(n, #first, #count, #what))
        }
        #length_docs
        pub const #length: usize = #count;
        #iter_docs
        pub fn #iter(&self) -> impl Iterator<Item = (usize, Reg<#value, B>)> + '_ #bound {
            (#first..#end).map(|n| (n, self.#name(n)))
        }
        #lanes
    }
}

/// For an array whose registers each hold several lanes: the register and the lane of a number that runs through all.
fn lanes(register: &Register, method: &str, dim: &Dim, bound: Option<&TokenStream>) -> Option<TokenStream> {
    let mut found = register.fields.iter().filter_map(|f| f.lanes.map(|l| (l.first, l.count)));
    let (first, count) = found.next()?;
    if found.any(|other| other != (first, count)) {
        return None;
    }
    let name = ident(&format!("{method}_of"));
    let array = ident(method);
    let value = ident(&register.ident.pascal);
    let total = count * dim.count;
    let numbers = format!("{first}..={}", first + total - 1);
    let what = format!("{method}_of takes {numbers}");
    let docs = doc::doc(&[
        format!(
            "The `{}` register that holds lane `n`, where the numbers run on through all registers, and the number of the \
             lane in it, as its getters and setters take it.",
            register.label.replace("{n}", "n")
        ),
        "# Panics".to_owned(),
        format!("If `n` is not in {numbers}."),
    ]);
    let (first, count, total, first_register) = (number(first), number(count), number(total), number(dim.first));
    Some(quote! {
        #docs
        #[inline]
        #[must_use]
        pub fn #name(&self, n: usize) -> (Reg<#value, B>, usize) #bound {
            let position = regbus::bits::position(n, #first, #total, #what);
            (self.#array(#first_register + position / #count), #first + position % #count)
        }
    })
}

fn cluster_accessor(model: &Model, id: ClusterId) -> TokenStream {
    let cluster = &model.clusters[id.0];
    let name = ident(&cluster.ident.snake);
    let value = ident(&cluster.ident.pascal);
    let dim = &cluster.dim;
    let numbers = format!("{}..={}", dim.first, dim.first + dim.count - 1);
    let what = format!("{} takes {numbers}", cluster.ident.snake);
    let docs = doc::doc(&[
        format!("`{}` n: {}.", cluster.name, doc::md(cluster.title.trim_end_matches('.'))),
        "# Panics".to_owned(),
        format!("If `n`, the manual's number, is not in {numbers}."),
    ]);
    let (at, first, count, stride) = (offset(cluster.offset), number(dim.first), number(dim.count), offset(dim.stride));
    let length = ident(&format!("{}_LEN", cluster.ident.upper));
    let length_docs = doc::doc(&[format!("Number of [`{name}`](Self::{name}) elements.")]);
    let iter = ident(&format!("{}_iter", cluster.ident.snake));
    let iter_docs = doc::doc(&[format!("All [`{name}`](Self::{name}) elements with their numbers.")]);
    let end = number(dim.first + dim.count);
    quote! {
        #docs
        #[inline(always)]
        #[must_use]
        pub fn #name(&self, n: usize) -> #value<B> {
            let position = regbus::bits::position(n, #first, #count, #what);
            #value { bus: self.bus, offset: #at + #stride * position }
        }
        #length_docs
        pub const #length: usize = #count;
        #iter_docs
        pub fn #iter(&self) -> impl Iterator<Item = (usize, #value<B>)> + '_ {
            (#first..#end).map(|n| (n, self.#name(n)))
        }
    }
}

fn cluster_type(model: &Model, id: ClusterId) -> TokenStream {
    let cluster = &model.clusters[id.0];
    let name = ident(&cluster.ident.pascal);
    let docs = doc::doc(&[
        format!("{}.", doc::md(cluster.title.trim_end_matches('.'))),
        doc::sentence(&cluster.doc),
        doc::source(model, &cluster.cites),
    ]);
    let registers = model.cluster_registers(id).map(|(_, register)| accessor(model, register, Some(id)));
    let values = model.joined.iter().filter(|j| j.cluster == Some(id)).map(|j| joined::accessors(model, j));
    quote! {
        #docs
        #[derive(Clone, Copy, Debug)]
        pub struct #name<B: Bus = Mmio> {
            bus: B,
            offset: usize,
        }

        impl<B: Bus> #name<B> {
            #(#registers)*
            #(#values)*
        }
    }
}

/// Some part of a joined value is visible only in a window that has to be opened.
fn in_guarded_window(model: &Model, joined: &Joined) -> bool {
    let resting = resting_window(model);
    joined.parts.iter().any(|p| model.register(p.holder).window.is_some_and(|w| Some(w) != resting))
}

fn window_method(model: &Model, id: WindowId) -> TokenStream {
    let window = &model.windows[id.0];
    let select = model.register(window.select.register);
    let field = model.field(window.select);
    let word = word_type(select.width);
    let mask = field.mask();
    let kept = select
        .fields
        .iter()
        .filter(|f| f.access.code.writable() && matches!(f.access.neutral(), Neutral::AsRead | Neutral::None))
        .fold(0, |kept, f| kept | f.mask());
    let resting = resting_window(model).map_or(0, |id| model.windows[id.0].value);
    let keep = hex(kept & !mask, select.width);
    let ones = hex(select.capabilities.neutral_ones & !mask, select.width);
    let open = hex(window.value << field.lsb, select.width);
    let closed = hex(resting << field.lsb, select.width);
    let at = offset(select.offset.unwrap_or(0));
    let name = ident(&format!("{}_window", window.ident.snake));
    let with_token = ident(&format!("{}_window_in", window.ident.snake));
    let guard = ident(&format!("{}Window", window.ident.pascal));
    let path = model.field_path(window.select);
    let docs = doc::doc(&[
        format!("Opens the window `{}` for the closure: {}", window.name, doc::sentence(&window.doc)),
        format!("One read-modify-write of `{path}` opens it, one more closes it when the closure returns or unwinds."),
        format!(
            "# Interrupts\n\nWhile the window is open, an interrupt handler that uses this controller would reach the wrong \
             registers. Keep its interrupts masked, or use `{with_token}` (feature `critical-section`)."
        ),
        doc::source(model, &window.cites),
    ]);
    let token_docs =
        doc::doc(&[format!("The same as [`{name}`](Self::{name}) with the proof that no interrupt can come between.")]);
    quote! {
        #docs
        #[inline]
        pub fn #name<T>(&mut self, access: impl FnOnce(&#guard<B>) -> T) -> T {
            let window = #guard { bus: self.bus };
            let _open = regbus::Bracket::<#word, B>::open(self.bus, #at, #keep, #ones, #open, #closed);
            access(&window)
        }

        #token_docs
        #[cfg(feature = "critical-section")]
        #[inline]
        pub fn #with_token<T>(
            &mut self,
            _token: regbus::CriticalSection<'_>,
            access: impl FnOnce(&#guard<B>) -> T,
        ) -> T {
            self.#name(access)
        }
    }
}

fn window_type(model: &Model, id: WindowId) -> TokenStream {
    let window = &model.windows[id.0];
    let guard = ident(&format!("{}Window", window.ident.pascal));
    let method = format!("{}_window", window.ident.snake);
    let peripheral = &model.names.ident.pascal;
    let docs = doc::doc(&[
        format!("The open window `{}`: {}", window.name, doc::sentence(&window.doc)),
        format!("[`{peripheral}::{method}`] passes it to its closure."),
    ]);
    let registers: Vec<_> = model
        .block_registers()
        .filter(|(_, r)| r.offset.is_some() && (r.window.is_none() || r.window == Some(id)))
        .map(|(_, register)| {
            let mut visible = register.clone();
            visible.window = None;
            accessor(model, &visible, None)
        })
        .collect();
    let inside = |j: &&Joined| {
        j.cluster.is_none() && j.parts.iter().all(|p| model.register(p.holder).window.is_none_or(|w| w == id))
    };
    let values = model.joined.iter().filter(inside).map(|j| joined::accessors(model, j));
    quote! {
        #docs
        #[derive(Debug)]
        pub struct #guard<B: Bus = Mmio> {
            bus: B,
        }

        impl<B: Bus> #guard<B> {
            #(#registers)*
            #(#values)*
        }
    }
}

/// Known chips as constants.
pub(super) fn instances(model: &Model) -> TokenStream {
    let items = model.instances.iter().map(|instance| {
        let name = ident(&regdef::model::Ident::new(&instance.name).snake);
        let docs = doc::doc(&[
            format!("`{}` of {}.", instance.name, instance.chips.join(", ")),
            doc::sentence(&instance.doc),
            doc::source(model, &instance.cites),
        ]);
        let base = hex(instance.base, 32);
        let memory = instance.memory.map(|at| {
            let at = hex(at, 32);
            quote! {
                /// Base address of the message memory.
                pub const MEMORY: usize = #at;
            }
        });
        let interrupts = instance.interrupts.iter().map(|(line, n)| {
            let docs = doc::doc(&[format!("Number of the interrupt `{line}`.")]);
            let name = ident(&format!("{}_INTERRUPT", regdef::model::Ident::new(line).upper));
            let n = number(*n);
            quote!(#docs pub const #name: u16 = #n;)
        });
        quote! {
            #docs
            pub mod #name {
                /// Base address of the register block.
                pub const BASE: usize = #base;
                #memory
                #(#interrupts)*
            }
        }
    });
    let head = doc::inner(
        "Where the controller is on known chips.\n\nThese are facts of the chips, not of the controller's manual; each names its \
         source.",
    );
    quote!(#head #(#items)*)
}
