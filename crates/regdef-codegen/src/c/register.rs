//! Macros and functions of every register.

use regdef::model::{FieldRef, Model, Register, RegisterId, Target, bit_mask};

use super::write::Writer;
use super::{Context, access, field, literal};
use crate::text;

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    for index in 0..context.model.registers.len() {
        one(context, out, RegisterId(index));
    }
}

fn one(context: &Context<'_>, out: &mut Writer, id: RegisterId) {
    let register = context.model.register(id);
    let name = context.names.register(id);
    let mut paragraphs = vec![format!("{}: {}", register.label.replace("{n}", "n"), text::sentence(&register.title))];
    paragraphs.push(text::sentence(&register.doc));
    paragraphs.extend(text::register_notes(context.model, register));
    if register.offset.is_none() {
        paragraphs.push("Belongs to the chip around the controller: its address is not known here.".to_owned());
    }
    paragraphs.push(text::conflicts(context.model, |target| *target == Target::Register(id)));
    paragraphs.push(text::cites(&register.cites));
    out.comment(&paragraphs);
    place(context.model, out, register, name);
    let known = bit_mask(0, register.width) & !register.reset.unknown;
    out.define(&format!("{name}_RESET"), &literal::hex(register.reset.value & known, register.width));
    out.define(&format!("{name}_RESET_MASK"), &literal::hex(known, register.width));
    for (index, of) in register.fields.iter().enumerate() {
        let at = FieldRef { register: id, field: index };
        let notes = text::conflicts(context.model, |target| *target == Target::Field(at));
        let cites = if of.cites == register.cites { String::new() } else { text::cites(&of.cites) };
        field::emit(
            context,
            out,
            &field::Holder { width: register.width, name: context.names.field(at) },
            of,
            &[notes, cites],
        );
    }
    access::emit(context, out, id);
    out.blank();
}

/// Offset from the base of the block, and the repetition.
fn place(model: &Model, out: &mut Writer, register: &Register, name: &str) {
    let Some(offset) = register.offset else { return };
    let cluster = register.cluster.map(|id| &model.clusters[id.0]);
    let base = cluster.map_or(0, |cluster| cluster.offset);
    out.define(&format!("{name}_OFFSET"), &literal::offset(base + offset));
    if let Some(dim) = register.dim.as_ref().or(cluster.map(|cluster| &cluster.dim)) {
        out.define(&format!("{name}_COUNT"), &format!("{}U", dim.count));
        out.define(&format!("{name}_STRIDE"), &literal::offset(dim.stride));
        out.define(&format!("{name}_FIRST"), &format!("{}U", dim.first));
    }
}
