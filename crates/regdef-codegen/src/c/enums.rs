//! Enumerated values.

use regdef::model::EnumId;

use super::write::Writer;
use super::{Context, literal};
use crate::text;

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    for (index, of) in context.model.enums.iter().enumerate() {
        let id = EnumId(index);
        let users: Vec<String> = of.used_by.iter().map(|at| context.model.field_path(*at)).collect();
        let users = if users.is_empty() { String::new() } else { format!("Values of {}.", users.join(", ")) };
        out.comment(&[users, text::sentence(&of.doc), text::cites(&of.cites)]);
        for (variant, value) in of.variants.iter().enumerate() {
            let name = context.names.variant(id, variant);
            if !value.doc.is_empty() {
                out.comment(&[text::sentence(&value.doc)]);
            }
            if value.first == value.last {
                out.define(name, &literal::decimal(value.first, of.width));
            } else {
                out.define(&format!("{name}_FIRST"), &literal::decimal(value.first, of.width));
                out.define(&format!("{name}_LAST"), &literal::decimal(value.last, of.width));
            }
        }
        out.blank();
    }
}
