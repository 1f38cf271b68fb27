//! The description as data.

use proc_macro2::TokenStream;
use quote::quote;
use regdef::model::{
    AccessCode, AliasOp, Comparison, ConditionId, Dim, Enum, Expr, Field, FieldRef, FieldReset, Joined, LaneIndex,
    Message, Model, OffsetReference, OnRead, Part, Phase2Within, ReadEffect, Register, SectionStart, TimingPhase,
};

use super::{doc, fields, hex, ident, number};
use crate::text;

fn option<T>(value: Option<T>, emit: impl FnOnce(T) -> TokenStream) -> TokenStream {
    match value {
        Some(value) => {
            let value = emit(value);
            quote!(Some(#value))
        }
        None => quote!(None),
    }
}

fn field_ref(at: FieldRef) -> TokenStream {
    let (register, field) = (number(at.register.0 as u64), number(at.field as u64));
    quote!(regbus::meta::FieldRef { register: #register, field: #field })
}

fn condition_ref(id: ConditionId) -> TokenStream {
    number(id.0 as u64)
}

/// A field as an entry of its register's table.
pub(super) fn field(model: &Model, field: &Field) -> TokenStream {
    let name = &field.name;
    let (lsb, width) = (number(field.lsb), number(field.width));
    let access = ident(match field.access.code {
        AccessCode::Rw => "Rw",
        AccessCode::Ro => "Ro",
        AccessCode::Wo => "Wo",
        AccessCode::W1c => "W1c",
        AccessCode::W0c => "W0c",
        AccessCode::W1s => "W1s",
        AccessCode::Rwhc => "Rwhc",
        AccessCode::Rwh => "Rwh",
        AccessCode::Wclr => "Wclr",
    });
    let mut out = quote!(Field::new(#name, #lsb, #width, Access::#access));
    if let Some(lanes) = field.lanes {
        let (count, stride, first) = (number(lanes.count), number(lanes.stride), number(lanes.first));
        out.extend(quote!(.lanes(#count, #stride, #first)));
    }
    if let Some(OnRead { effect, byte }) = field.access.on_read {
        let byte = option(byte, number);
        out.extend(match effect {
            ReadEffect::Clear => quote!(.on_read(ReadEffect::Clear(#byte))),
            ReadEffect::Set => quote!(.on_read(ReadEffect::Set(#byte))),
        });
    }
    match field.reset {
        FieldReset::Value(0) => {}
        FieldReset::Value(value) => {
            let value = number(value);
            out.extend(quote!(.reset(Some(#value))));
        }
        FieldReset::None(_) => out.extend(quote!(.reset(None))),
    }
    if field.min > 0 || field.max < field.capacity() {
        let (min, max) = (number(field.min), number(field.max));
        out.extend(quote!(.limits(#min, #max)));
    }
    if let Some(encoding) = &field.encoding {
        // An addend beyond 32 bits is no encoding of a 32-bit field; the checks of the description refuse it.
        let add = proc_macro2::Literal::i32_unsuffixed(i32::try_from(encoding.add).unwrap_or(0));
        let (times, signed) = (number(encoding.times.unwrap_or(1)), encoding.signed);
        let unit = encoding.unit.as_deref().unwrap_or("");
        out.extend(quote!(.encoding(#add, #times, #signed, #unit)));
    }
    if let Some(id) = field.enumeration() {
        let values = values_name(model.enumeration(id));
        out.extend(quote!(.values(crate::enums::#values)));
    }
    if let Some(id) = field.access.when {
        let id = condition_ref(id);
        out.extend(quote!(.when(#id)));
    }
    if let Some(id) = field.access.set_when {
        let id = condition_ref(id);
        out.extend(quote!(.set_when(#id)));
    }
    if let Some(at) = field.access.loads {
        let (register, field) = (number(at.register.0 as u64), number(at.field as u64));
        out.extend(quote!(.loads(#register, #field)));
    }
    if let Some(value) = field.access.must_write {
        let value = number(value);
        out.extend(quote!(.must_write(#value)));
    }
    if field.access.safe_to_write_back.is_some() {
        out.extend(quote!(.safe_to_write_back()));
    }
    out
}

/// Name of the constant with an enumeration's names.
pub(super) fn values_name(entry: &Enum) -> proc_macro2::Ident {
    ident(&format!("{}_VALUES", entry.ident.upper))
}

/// An enumeration's names.
pub(super) fn values(entry: &Enum) -> TokenStream {
    let constant = values_name(entry);
    let name = &entry.name;
    let values = entry.variants.iter().map(|v| {
        let (first, last, name) = (number(v.first), number(v.last), &v.name);
        quote!((#first, #last, #name))
    });
    let reserved = entry.reserved.iter().map(|(first, last)| {
        let (first, last) = (number(*first), number(*last));
        quote!((#first, #last))
    });
    quote! {
        pub(crate) const #constant: &regbus::meta::Enum =
            &regbus::meta::Enum { name: #name, values: &[#(#values),*], reserved: &[#(#reserved),*] };
    }
}

fn dim(dim: &Dim) -> TokenStream {
    let (count, stride, first) = (number(dim.count), number(dim.stride), number(dim.first));
    quote!(regbus::meta::Array { count: #count, stride: #stride, first: #first })
}

fn register(model: &Model, register: &Register) -> TokenStream {
    let (name, label) = (&register.name, &register.label);
    let width = number(register.width);
    let cluster = register.cluster.map(|id| &model.clusters[id.0]);
    let offset = option(register.offset, |at| hex(at + cluster.map_or(0, |c| c.offset), 16));
    let cluster = option(cluster, |c| dim(&c.dim));
    let array = option(register.dim.as_ref(), dim);
    let labels = register.dim.iter().flat_map(|d| &d.labels);
    let window = option(register.window, |id| number(id.0 as u64));
    let reset = hex(register.reset.value, register.width);
    let unknown = hex(register.reset.unknown, register.width);
    let aliased = register.aliased && !model.aliases.is_empty();
    let table = fields::table_name(&register.ident);
    let source = text::cites(&register.cites);
    quote! {
        RegisterInfo {
            name: #name, label: #label, width: #width, offset: #offset, cluster: #cluster, array: #array,
            labels: &[#(#labels),*], window: #window, reset: #reset, reset_unknown: #unknown, aliased: #aliased,
            fields: crate::registers::#table, source: #source,
        }
    }
}

fn expr(expression: &Expr) -> TokenStream {
    match expression {
        Expr::Always => quote!(Expr::Always),
        Expr::Not(inner) => {
            let inner = expr(inner);
            quote!(Expr::Not(&#inner))
        }
        Expr::All(of) => {
            let of = of.iter().map(expr);
            quote!(Expr::All(&[#(#of),*]))
        }
        Expr::Any(of) => {
            let of = of.iter().map(expr);
            quote!(Expr::Any(&[#(#of),*]))
        }
        Expr::Compare { field, index, comparison: how, value } => {
            let (field, how, value) = (field_ref(*field), comparison(*how), number(*value));
            let index = match index {
                LaneIndex::Single => quote!(Index::Single),
                LaneIndex::Own => quote!(Index::Own),
                LaneIndex::Fixed(n) => {
                    let n = number(*n);
                    quote!(Index::Fixed(#n))
                }
            };
            quote!(Expr::Compare { field: #field, index: #index, comparison: #how, value: #value })
        }
        Expr::Word { message, word, field, comparison: how, value } => {
            let (message, word, field) = (number(message.0 as u64), number(*word as u64), number(*field as u64));
            let (how, value) = (comparison(*how), number(*value));
            quote!(Expr::Word { message: #message, word: #word, field: #field, comparison: #how, value: #value })
        }
    }
}

fn comparison(how: Comparison) -> TokenStream {
    let name = ident(match how {
        Comparison::Equal => "Equal",
        Comparison::NotEqual => "NotEqual",
        Comparison::Less => "Less",
        Comparison::LessOrEqual => "LessOrEqual",
        Comparison::Greater => "Greater",
        Comparison::GreaterOrEqual => "GreaterOrEqual",
    });
    quote!(Comparison::#name)
}

fn part<R>(part: &Part<R>, holder: usize) -> TokenStream {
    let (holder, lsb, width, shift) = (number(holder as u64), number(part.lsb), number(part.width), number(part.shift));
    quote!(Part { holder: #holder, lsb: #lsb, width: #width, shift: #shift })
}

fn joined<R>(value: &Joined<R>, holder: impl Fn(&R) -> usize) -> TokenStream {
    let name = &value.name;
    let width = number(value.width);
    let parts = value.parts.iter().map(|p| part(p, holder(&p.holder)));
    quote!(Joined { name: #name, width: #width, parts: &[#(#parts),*] })
}

fn message(model: &Model, message: &Message) -> TokenStream {
    let name = &message.name;
    let (width, header) = (number(message.word_width), number(message.header_bytes));
    let words = message.words.iter().map(|word| {
        let name = &word.name;
        let at = number(word.offset);
        let present = option(word.present_when, condition_ref);
        let owner = word.same_as.map_or(&word.ident, |(m, w)| &model.messages[m.0].words[w].ident);
        let table = fields::table_name(owner);
        quote!(MessageWord { name: #name, offset: #at, present_when: #present, fields: crate::messages::#table })
    });
    let payload = option(message.payload.as_ref(), |payload| {
        let at = number(payload.offset);
        let sizes = payload.sizes.iter().map(|s| number(*s));
        quote!(Payload { offset: #at, sizes: &[#(#sizes),*] })
    });
    let values = message.joined.iter().map(|j| joined(j, |word| *word));
    quote! {
        Message {
            name: #name, word_width: #width, header_bytes: #header, words: &[#(#words),*], payload: #payload,
            joined: &[#(#values),*],
        }
    }
}

fn phase(phase: &TimingPhase) -> TokenStream {
    let prescaler = field_ref(phase.prescaler);
    let propagation = option(phase.propagation, field_ref);
    let (segment1, segment2) = (field_ref(phase.segment1), field_ref(phase.segment2));
    let jump_width = field_ref(phase.jump_width);
    let (min, max) = (number(phase.min_quanta), number(phase.max_quanta));
    let rate = option(phase.max_bit_rate, number);
    let within = ident(match phase.phase2_within {
        None => "Anything",
        Some(Phase2Within::Phase1) => "Phase1",
        Some(Phase2Within::PropagationAndPhase1) => "PropagationAndPhase1",
    });
    let below = phase.jump_width_below_phase2;
    let samples = option(phase.three_samples, |(at, least)| {
        let (at, least) = (field_ref(at), number(least));
        quote!(ThreeSamples { field: #at, min_prescaler: #least })
    });
    quote! {
        TimingPhase {
            prescaler: #prescaler, propagation: #propagation, segment1: #segment1, segment2: #segment2,
            jump_width: #jump_width, min_quanta: #min, max_quanta: #max, max_bit_rate: #rate,
            phase2_within: Phase2Within::#within, jump_width_below_phase2: #below, three_samples: #samples,
        }
    }
}

pub(super) fn module(model: &Model) -> TokenStream {
    let head = doc::inner(&format!("The description of {} as data.", doc::md(&model.title)));
    let (name, title) = (&model.names.id, &model.title);
    let span = hex(model.span, 16);
    let widths = model.access_widths.iter().map(|w| number(*w));
    let aliases = model.aliases.iter().map(|alias| {
        let name = &alias.name;
        let at = number(alias.offset);
        let op = ident(match alias.op {
            AliasOp::Clear => "Clear",
            AliasOp::Set => "Set",
            AliasOp::Invert => "Invert",
        });
        quote!(Alias { name: #name, offset: #at, op: AliasOp::#op })
    });
    let windows = model.windows.iter().map(|window| {
        let (name, select, value) = (&window.name, field_ref(window.select), number(window.value));
        quote!(Window { name: #name, select: #select, value: #value })
    });
    let registers = model.registers.iter().map(|r| register(model, r));
    let conditions = model.conditions.iter().map(|condition| {
        let (name, text) = (&condition.name, text::one_line(&condition.doc));
        let (tree, source) = (expr(&condition.expr), text::cites(&condition.cites));
        quote!(Condition { name: #name, doc: #text, expr: #tree, source: #source })
    });
    let values = model.joined.iter().map(|j| joined(j, |register| register.0));
    let reserved = model.reserved.iter().map(|range| {
        let (from, to) = (hex(range.from, 16), hex(range.to, 16));
        let window = option(range.window, |id| number(id.0 as u64));
        let reads = option(range.reads, number);
        let sets = option(range.sets, field_ref);
        quote!(Reserved { from: #from, to: #to, window: #window, reads: #reads, sets: #sets })
    });
    let effects = model.effects.iter().map(|effect| {
        let (on, text, holds) = (condition_ref(effect.on), text::one_line(&effect.doc), effect.holds);
        let resets = effect.resets.iter().map(|r| number(r.0 as u64));
        let resets_fields = effect.resets_fields.iter().map(|f| field_ref(*f));
        let loads = effect.loads.iter().map(|(to, from)| {
            let (to, from) = (field_ref(*to), field_ref(*from));
            quote!((#to, #from))
        });
        let sets = effect.sets.iter().map(|(to, value)| {
            let (to, value) = (field_ref(*to), number(*value));
            quote!((#to, #value))
        });
        quote! {
            Effect {
                on: #on, doc: #text, resets: &[#(#resets),*], resets_fields: &[#(#resets_fields),*],
                loads: &[#(#loads),*], sets: &[#(#sets),*], holds: #holds,
            }
        }
    });
    let lines = model.interrupts.lines.iter().map(|line| {
        let name = &line.name;
        let (enable, select) = (option(line.enable, field_ref), option(line.select, number));
        quote!(InterruptLine { name: #name, enable: #enable, select: #select })
    });
    let sources = model.interrupts.sources.iter().map(|source| {
        let (name, flag) = (&source.name, field_ref(source.flag));
        let (enable, select) = (option(source.enable, field_ref), option(source.select, field_ref));
        let lines = source.lines.iter().map(|id| number(id.0 as u64));
        let feeds = source.feeds.iter().map(|id| number(id.0 as u64));
        let code = option(source.code, |(first, last)| {
            let (first, last) = (number(first), number(last));
            quote!((#first, #last))
        });
        quote! {
            InterruptSource {
                name: #name, flag: #flag, enable: #enable, select: #select, lines: &[#(#lines),*], feeds: &[#(#feeds),*],
                code: #code,
            }
        }
    });
    let messages = model.messages.iter().map(|m| message(model, m));
    let sections = model.memory.sections.iter().map(|section| {
        let name = &section.name;
        let elements = section.elements.iter().map(|id| number(id.0 as u64));
        let (parts, unit) = match &section.start {
            SectionStart::Follows => (Vec::new(), 1),
            SectionStart::At { parts, unit } => (parts.iter().map(|p| part(p, p.holder.0)).collect(), *unit),
        };
        let unit = number(unit);
        let count = section.count.iter().map(|f| field_ref(*f));
        let max = option(section.max, number);
        let size = option(section.payload_size, field_ref);
        let exists = option(section.exists_when, condition_ref);
        quote! {
            Section {
                name: #name, elements: &[#(#elements),*], start: &[#(#parts),*], start_unit: #unit, count: &[#(#count),*],
                max: #max, payload_size: #size, exists_when: #exists,
            }
        }
    });
    let bit_timing = option(model.bit_timing.as_ref(), |timing| {
        let (clock, divider) = (&timing.clock.name, number(timing.clock.divider));
        let max = option(timing.clock.max_hz, number);
        let nominal = phase(&timing.nominal);
        let data = option(timing.data.as_ref(), phase);
        let delay = option(timing.transmitter_delay.as_ref(), |tdc| {
            let (enable, at) = (field_ref(tdc.enable), field_ref(tdc.offset));
            let (filter, value) = (option(tdc.filter, field_ref), option(tdc.value, field_ref));
            let reference = ident(match tdc.reference {
                OffsetReference::SamplePoint => "SamplePoint",
                OffsetReference::Segment1 => "Segment1",
            });
            let (prescaler, position) = (option(tdc.max_prescaler, number), option(tdc.max_position, number));
            let bits = option(tdc.max_bits, number);
            quote! {
                TransmitterDelay {
                    enable: #enable, offset: #at, filter: #filter, value: #value,
                    reference: OffsetReference::#reference, max_prescaler: #prescaler, max_position: #position,
                    max_bits: #bits,
                }
            }
        });
        quote! {
            BitTiming {
                clock: #clock, divider: #divider, max_clock: #max, nominal: #nominal, data: #data,
                transmitter_delay: #delay,
            }
        }
    });
    quote! {
        #head
        #[allow(unused_imports, reason = "not every controller has everything")]
        use regbus::meta::{
            Alias, AliasOp, Array, BitTiming, Comparison, Condition, Controller, Effect, Expr, Index, InterruptLine,
            InterruptSource, Joined, Message, MessageWord, OffsetReference, Part, Payload, Phase2Within, RegisterInfo,
            Reserved, Section, ThreeSamples, TimingPhase, TransmitterDelay, Window,
        };

        /// The whole description.
        pub static CONTROLLER: Controller = Controller {
            name: #name, title: #title, span: #span, access_widths: &[#(#widths),*], aliases: &[#(#aliases),*],
            windows: &[#(#windows),*], registers: &[#(#registers),*], conditions: &[#(#conditions),*],
            joined: &[#(#values),*], reserved: &[#(#reserved),*], effects: &[#(#effects),*], lines: &[#(#lines),*],
            interrupts: &[#(#sources),*], messages: &[#(#messages),*], sections: &[#(#sections),*],
            bit_timing: #bit_timing,
        };
    }
}
