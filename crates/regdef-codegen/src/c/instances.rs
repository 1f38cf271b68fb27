//! Known chips: base addresses and interrupt numbers.

use regdef::model::{Ident, Instance};

use super::Context;
use super::write::Writer;
use crate::text;

/// `PIC32_CAN_CAN1`: in front of the macros of an instance.
pub(super) fn stem(context: &Context<'_>, instance: &Instance) -> String {
    format!("{}_{}", context.upper, Ident::new(&instance.name).upper.trim_start_matches('_'))
}

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    for instance in &context.model.instances {
        let stem = stem(context, instance);
        out.comment(&[
            format!("{} of {}.", instance.name, instance.chips.join(", ")),
            text::sentence(&instance.doc),
            text::cites(&instance.cites),
        ]);
        out.line(&format!("#ifndef {stem}_BASE"));
        out.define(&format!("{stem}_BASE"), &address(instance.base));
        out.line("#endif");
        out.define(&stem, &format!("(({} *)(uintptr_t){stem}_BASE)", context.block()));
        if let Some(memory) = instance.memory {
            out.define(&format!("{stem}_MEMORY"), &address(memory));
        }
        for (line, number) in &instance.interrupts {
            out.define(&format!("{stem}_{}_IRQ", Ident::new(line).upper), &format!("{number}"));
        }
        out.blank();
    }
}

fn address(value: u64) -> String {
    super::literal::hex(value, if value > u64::from(u32::MAX) { 64 } else { 32 })
}
