//! Traits that nothing implements: the compile errors of what a register does not allow.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{Model, Register, Window};

use super::registers::no_modify_reason;
use super::{doc, ident, peripheral};

pub(super) fn module(model: &Model) -> TokenStream {
    let modify = model.registers.iter().filter_map(|register| {
        let reason = register.capabilities.modify.as_ref().err()?;
        let (message, note) = no_modify_reason(model, register, reason);
        let name = ident(&format!("{}HasNoModify", register.ident.pascal));
        let docs = doc::doc(&[format!("{message}; {note}.")]);
        Some(guard(&docs, &name, &message, "no `modify` for this register", &note))
    });
    let resting = peripheral::resting_window(model);
    let windows = model.registers.iter().filter_map(|register| {
        let id = register.window.filter(|id| Some(*id) != resting)?;
        let window = &model.windows[id.0];
        let method = &register.ident.snake;
        let message = format!("`{method}` is visible only in the window `{}`", window.name);
        let note = format!(
            "reach it through the guard: `{0}_window(|w| w.{method}(..))`, which opens the window, and closes it when the \
             closure returns",
            window.ident.snake
        );
        let docs = doc::doc(&[format!("{message}; {note}.")]);
        Some(guard(&docs, &ident(&window_guard(register, window)), &message, "the window is not open here", &note))
    });
    let head = doc::inner(
        "What registers do not allow, as traits that no bus implements.\n\nThey stand in bounds of methods that cannot be \
         called, so that the compiler's message says why, and what to do instead.",
    );
    let guards: Vec<TokenStream> = modify.chain(windows).collect();
    // Without a guard, nothing would use it.
    let sealed = (!guards.is_empty()).then(|| {
        quote!(
            mod sealed {
                pub trait Never {}
            }
        )
    });
    quote! {
        #head
        #sealed
        #(#guards)*
    }
}

/// Name of the guard of a register outside its window.
pub(super) fn window_guard(register: &Register, window: &Window) -> String {
    format!("{}IsIn{}Window", register.ident.pascal, window.ident.pascal)
}

fn guard(docs: &TokenStream, name: &proc_macro2::Ident, message: &str, label: &str, note: &str) -> TokenStream {
    // The attribute is a format string.
    let escape = |text: &str| text.replace('{', "{{").replace('}', "}}");
    let (message, note) = (escape(message), escape(note));
    quote! {
        #docs
        #[diagnostic::on_unimplemented(message = #message, label = #label, note = #note)]
        pub trait #name: sealed::Never {}
    }
}
