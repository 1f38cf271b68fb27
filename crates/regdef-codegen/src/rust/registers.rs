//! Value types of registers.

use std::ops::Range;

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{Field, Model, Neutral, NoModify, Register, RegisterId, Target, WriteEffect};

use super::{doc, fields, hex, ident, literal};
use crate::text;

/// What stands above the values.
pub(super) fn head(model: &Model) -> TokenStream {
    let head = doc::inner(&format!(
        "Values of the registers of {}.\n\nEach type is a transparent copy of the register's word. The accessors of the \
         peripheral hand out [`Reg`](regbus::Reg)s of them.",
        doc::md(&model.title)
    ));
    quote! {
        #head
        #[allow(unused_imports, reason = "not every block has fields with read effects")]
        use regbus::meta::{Access, Field, ReadEffect};
    }
}

/// The values of some of the registers.
pub(super) fn values(model: &Model, range: Range<usize>) -> TokenStream {
    let values = range.map(|index| {
        let register = &model.registers[index];
        let value = value_type(model, RegisterId(index), register);
        let capabilities = capabilities(model, register);
        quote!(#value #capabilities)
    });
    quote!(#(#values)*)
}

/// The value type: docs, struct, common part, fields.
fn value_type(model: &Model, id: RegisterId, register: &Register) -> TokenStream {
    let docs = doc::doc(&paragraphs(model, id, register));
    let body = fields::Holder { name: &register.name, ident: &register.ident, width: register.width };
    let name = register.label.replace("{n}", "n");
    fields::value(model, &body, &docs, &name, register.reset.value, &register.fields)
}

fn paragraphs(model: &Model, id: RegisterId, register: &Register) -> Vec<String> {
    let width = register.width;
    let digits = width as usize / 4 + 2;
    let place = match (register.offset, register.cluster) {
        (None, _) => "a register of the device; its address is not part of this description".to_owned(),
        (Some(offset), None) => format!("offset `{offset:#05x}`"),
        (Some(offset), Some(cluster)) => {
            format!("offset `{offset:#x}` of each `{}`", model.clusters[cluster.0].name)
        }
    };
    let array = register.dim.as_ref().map_or(String::new(), |dim| {
        format!(", {} registers {:#x} bytes apart, numbered from {}", dim.count, dim.stride, dim.first)
    });
    let unknown = if register.reset.unknown == 0 {
        String::new()
    } else {
        format!(" (bits `{:#0digits$x}` have no defined value)", register.reset.unknown)
    };
    let facts = format!(
        "`{}{}`, {width} bits, {place}{array}, reset `{:#0digits$x}`{unknown}.",
        model.prefix,
        register.label.replace("{n}", "n"),
        register.reset.value
    );
    let mut paragraphs =
        vec![format!("{}.", doc::md(register.title.trim_end_matches('.'))), facts, doc::sentence(&register.doc)];
    paragraphs.extend(text::register_notes(model, register).iter().map(|note| doc::md(note)));
    paragraphs.push(modify_note(model, register));
    if let Some(reason) = &register.unsafe_write {
        paragraphs.push("# Safety of writes".to_owned());
        paragraphs.push(doc::sentence(reason));
    }
    if !register.fields.is_empty() {
        paragraphs.push("# Fields".to_owned());
        paragraphs.push(doc::field_table(model, register));
    }
    paragraphs.push(doc::conflicts(model, |target| *target == Target::Register(id)));
    paragraphs.push(doc::source(model, &register.cites));
    paragraphs
}

/// Why there is no `modify`, in words.
pub(super) fn no_modify_reason(model: &Model, register: &Register, reason: &NoModify) -> (String, String) {
    let name = &register.ident.pascal;
    let caps = &register.capabilities;
    let list = |names: &[String]| match names {
        [] => "its fields".to_owned(),
        [one] => one.clone(),
        [a, b] => format!("{a} and {b}"),
        [a, b, c] => format!("{a}, {b} and {c}"),
        [a, b, rest @ ..] => format!("{a}, {b} and {} more", rest.len()),
    };
    let clear = can_clear(register);
    match reason {
        NoModify::NotReadWrite => {
            let what = if caps.readable { "read-only" } else { "write-only" };
            (
                format!("`{name}` cannot be read-modified-written: it is {what}"),
                format!("use `{}`", if caps.readable { "read" } else { "write" }),
            )
        }
        NoModify::OnlyFlags(flags) => {
            let (what, instead) = match (clear, can_request(register)) {
                (true, _) => ("would be cleared", "use `clear(flags)`: one store that touches only these flags"),
                (false, true) => {
                    ("would be requested again", "use `request(bits)`: one store that makes only these requests")
                }
                (false, false) => ("would be written back", "use `write` with the value you mean"),
            };
            (format!("`{name}` cannot be read-modified-written: {} {what}", list(flags)), instead.to_owned())
        }
        NoModify::ReadHasEffects(fields) => (
            format!("`{name}` cannot be read-modified-written: the read changes {}", list(fields)),
            if clear {
                "use `clear(flags)`, or `read` once and pass the value on".to_owned()
            } else {
                alternatives(model, register, "`read` it once, keep the value, and `write` what you mean")
            },
        ),
        NoModify::NoNeutral(fields) => {
            let of_these = |field: &&Field| fields.contains(&field.name);
            let any_write_clears =
                register.fields.iter().filter(of_these).all(|f| f.access.code.write_effect() == WriteEffect::Resets);
            if any_write_clears {
                (
                    format!("`{name}` cannot be read-modified-written: any write clears or presets {}", list(fields)),
                    format!("use `write({name}::ZERO)` if that is what you want"),
                )
            } else {
                (
                    format!(
                        "`{name}` cannot be read-modified-written: hardware changes {} between the read and the write",
                        list(fields)
                    ),
                    alternatives(
                        model,
                        register,
                        "say what each of these fields becomes: `reg.write(reg.read().with_..(..))`",
                    ),
                )
            }
        }
    }
}

fn alternatives(model: &Model, register: &Register, otherwise: &str) -> String {
    if has_aliases(model, register) {
        "use `set_bits`, `clear_bits` or `invert_bits`: one store that touches only these bits".to_owned()
    } else {
        otherwise.to_owned()
    }
}

fn modify_note(model: &Model, register: &Register) -> String {
    match &register.capabilities.modify {
        Ok(()) | Err(NoModify::NotReadWrite) => String::new(),
        Err(reason) => {
            let (why, instead) = no_modify_reason(model, register, reason);
            format!("No `modify`: {why}; {instead}.")
        }
    }
}

/// Alias registers may change it without a promise: an address behind which the hardware writes is not changed bit by bit.
fn has_aliases(model: &Model, register: &Register) -> bool {
    register.aliased && !model.aliases.is_empty() && register.unsafe_write.is_none()
}

/// One store can clear flags: nothing else in the register is stored or has no neutral value.
pub(super) fn can_clear(register: &Register) -> bool {
    let caps = &register.capabilities;
    caps.one_clears | caps.zero_clears != 0 && others_are_neutral(register)
}

/// One store can make requests.
pub(super) fn can_request(register: &Register) -> bool {
    register.capabilities.one_sets != 0 && others_are_neutral(register)
}

fn others_are_neutral(register: &Register) -> bool {
    let neutral = |f: &Field| matches!(f.access.neutral(), Neutral::Zero | Neutral::Ones);
    register.fields.iter().all(neutral)
}

fn capabilities(model: &Model, register: &Register) -> TokenStream {
    let name = ident(&register.ident.pascal);
    let caps = &register.capabilities;
    let mut out = TokenStream::new();
    if caps.readable {
        out.extend(quote!(impl regbus::Readable for #name {}));
        if caps.pure {
            out.extend(quote!(impl regbus::Pure for #name {}));
        }
    }
    if caps.writable {
        out.extend(if register.unsafe_write.is_some() {
            quote!(impl regbus::UnsafeWritable for #name {})
        } else {
            quote!(impl regbus::Writable for #name {})
        });
    }
    match &caps.modify {
        Ok(()) => {
            let (keep, ones) = keep_and_ones(register);
            out.extend(quote! {
                impl<B: regbus::Bus> regbus::Modify<B> for #name {
                    const KEEP: u32 = #keep;
                    const ONES: u32 = #ones;
                }
            });
        }
        Err(_) => {
            let guard = ident(&format!("{}HasNoModify", register.ident.pascal));
            out.extend(quote! {
                impl<B: regbus::Bus + crate::guards::#guard> regbus::Modify<B> for #name {
                    const KEEP: u32 = 0;
                    const ONES: u32 = 0;
                }
            });
        }
    }
    let ones = hex(caps.neutral_ones, register.width);
    if can_clear(register) {
        let flags = hex(caps.one_clears | caps.zero_clears, register.width);
        let by_zero = hex(caps.zero_clears, register.width);
        let others = hex(caps.neutral_ones & !caps.zero_clears, register.width);
        out.extend(quote! {
            impl regbus::Clear for #name {
                const FLAGS: u32 = #flags;
                const BY_ZERO: u32 = #by_zero;
                const ONES: u32 = #others;
            }
        });
    }
    if can_request(register) {
        let requests = hex(caps.one_sets, register.width);
        out.extend(quote! {
            impl regbus::Request for #name {
                const REQUESTS: u32 = #requests;
                const ONES: u32 = #ones;
            }
        });
    }
    if has_aliases(model, register) && caps.writable {
        for alias in &model.aliases {
            use regdef::model::AliasOp;
            let kind = match alias.op {
                AliasOp::Clear => ident("AliasClear"),
                AliasOp::Set => ident("AliasSet"),
                AliasOp::Invert => ident("AliasInvert"),
            };
            let offset = literal(&format!("{:#x}", alias.offset));
            out.extend(quote!(impl regbus::#kind for #name { const OFFSET: usize = #offset; }));
        }
    }
    out
}

/// Bits a read-modify-write keeps, and bits it writes as 1.
pub(super) fn keep_and_ones(register: &Register) -> (TokenStream, TokenStream) {
    let keep = register
        .fields
        .iter()
        .filter(|f| f.access.code.writable() && f.access.neutral() == Neutral::AsRead)
        .fold(0, |mask, f| mask | f.mask());
    (hex(keep, register.width), hex(register.capabilities.neutral_ones, register.width))
}
