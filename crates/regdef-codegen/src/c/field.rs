//! Macros and helpers of a field of a register or of a message word.

use regdef::model::{Field, WriteEffect};

use super::Context;
use super::literal::{ctype, decimal, hex};
use super::write::Writer;
use crate::text;

/// Where a field is.
pub(super) struct Holder<'a> {
    /// Width of the register or word in bits.
    pub(super) width: u32,
    /// What the field's macros begin with.
    pub(super) name: &'a str,
}

pub(super) fn emit(context: &Context<'_>, out: &mut Writer, holder: &Holder<'_>, field: &Field, more: &[String]) {
    let mut first = format!("{}: {}", field.label.replace("{n}", "n"), text::sentence(&field.doc));
    for note in text::access_notes(context.model, field) {
        first.push(' ');
        first.push_str(&note);
    }
    if let Some(lanes) = field.lanes {
        first.push_str(&format!(" Lane 0 is number {} in the first register.", lanes.first));
    }
    let mut paragraphs = vec![first];
    paragraphs.extend_from_slice(more);
    out.comment(&paragraphs);
    macros(context, out, holder, field);
    if field.access.code.readable() {
        getter(context, out, holder, field);
    }
    if field.access.code.write_effect() == WriteEffect::Stores {
        setter(context, out, holder, field);
    }
}

fn macros(context: &Context<'_>, out: &mut Writer, holder: &Holder<'_>, field: &Field) {
    let Holder { width, name } = *holder;
    let container = ctype(width);
    let mask = hex(field.lane_mask(0), width);
    match field.lanes {
        None => {
            out.define(&format!("{name}_Pos"), &format!("{}U", field.lsb));
            out.define(&format!("{name}_Msk"), &mask);
        }
        Some(lanes) => {
            out.define(&format!("{name}_Pos(lane)"), &format!("({}U + {}U * (lane))", field.lsb, lanes.stride));
            out.define(
                &format!("{name}_Msk(lane)"),
                &format!("(({container})({mask} << ({}U * (lane))))", lanes.stride),
            );
            out.define(&format!("{name}_Lanes"), &format!("{}U", lanes.count));
        }
    }
    out.define(&format!("{name}_Width"), &format!("{}U", field.width));
    let notation = text::notation(context.model, field).replace('\\', "\\\\").replace('"', "\\\"");
    out.define(&format!("{name}_Access"), &format!("\"{notation}\""));
    if matches!(field.access.code.write_effect(), WriteEffect::Stores | WriteEffect::Requests) {
        let (head, lane) = if field.lanes.is_some() { ("(lane, value)", "(lane)") } else { ("(value)", "") };
        let shifted = format!("({container})(value) << {name}_Pos{lane}");
        out.define(&format!("{name}_SET{head}"), &format!("(({container})(({shifted}) & {name}_Msk{lane}))"));
    }
    if let Some(value) = field.access.must_write {
        out.define(&format!("{name}_MustWrite"), &decimal(value, width));
    }
}

/// The parameter, the argument and the check of a lane.
fn lane(context: &Context<'_>, field: &Field) -> (String, &'static str, Vec<String>) {
    match field.lanes {
        None => (String::new(), "", Vec::new()),
        Some(lanes) => (
            ", unsigned int lane".to_owned(),
            "(lane)",
            vec![format!("{}_ASSERT(lane < {}U);", context.upper, lanes.count)],
        ),
    }
}

fn getter(context: &Context<'_>, out: &mut Writer, holder: &Holder<'_>, field: &Field) {
    let Holder { width, name } = *holder;
    let container = ctype(width);
    let (parameter, argument, mut body) = lane(context, field);
    body.push(format!("return ({container})((reg & {name}_Msk{argument}) >> {name}_Pos{argument});"));
    out.function(&format!("{container} {}_get({container} reg{parameter})", name.to_ascii_lowercase()), &body);
}

fn setter(context: &Context<'_>, out: &mut Writer, holder: &Holder<'_>, field: &Field) {
    let Holder { width, name } = *holder;
    let container = ctype(width);
    let (parameter, argument, mut body) = lane(context, field);
    let assert = &context.upper;
    if field.min > 0 {
        body.push(format!("{assert}_ASSERT(value >= {});", decimal(field.min, width)));
    }
    if field.max < regdef::model::bit_mask(0, width) {
        body.push(format!("{assert}_ASSERT(value <= {});", decimal(field.max, width)));
    }
    let lane_value = if field.lanes.is_some() { "lane, value" } else { "value" };
    body.push(format!("return ({container})((reg & ({container})~{name}_Msk{argument}) | {name}_SET({lane_value}));"));
    out.function(
        &format!("{container} {}_set({container} reg{parameter}, {container} value)", name.to_ascii_lowercase()),
        &body,
    );
}
