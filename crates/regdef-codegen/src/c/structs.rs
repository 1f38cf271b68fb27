//! The struct of the register block, and the proof of its layout.

use super::Context;
use super::layout::{Slot, SlotKind};
use super::literal::ctype;
use super::write::Writer;

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    let mut asserts = Vec::new();
    for slot in every_group(&context.layout.slots) {
        let SlotKind::Group { type_name, stride, members, title, .. } = &slot.kind else { continue };
        if !type_name.is_empty() {
            out.comment(&[crate::text::sentence(title)]);
            out.line("typedef struct {");
            body(context, out, members, *stride, 1);
            out.line(&format!("}} {type_name};"));
            out.blank();
        }
    }
    let block = context.block();
    out.comment(&["The register block.".to_owned()]);
    out.line(&format!("typedef struct {}_regs {{", context.lower));
    body(context, out, &context.layout.slots, context.model.span, 1);
    out.line(&format!("}} {block};"));
    out.blank();
    places(context, &context.layout.slots, 0, "", &mut asserts);
    for (path, offset) in asserts {
        let name = format!("{}_at_{}", context.lower, super::layout::identifier(&path));
        out.line(&format!(
            "{}_STATIC_ASSERT(offsetof({block}, {path}) == {}, {name});",
            context.upper,
            super::literal::offset(offset)
        ));
    }
    out.line(&format!(
        "{}_STATIC_ASSERT(sizeof({block}) == {}, {}_span);",
        context.upper,
        super::literal::offset(context.model.span),
        context.lower
    ));
    out.blank();
}

/// All arrays of structs, inner ones first.
fn every_group(slots: &[Slot]) -> Vec<&Slot> {
    let mut found = Vec::new();
    for slot in slots {
        match &slot.kind {
            SlotKind::Register { .. } => {}
            SlotKind::Group { members, .. } => {
                found.extend(every_group(members));
                found.push(slot);
            }
            SlotKind::Windows(views) => views.iter().for_each(|(_, view)| found.extend(every_group(view))),
        }
    }
    found
}

/// Members with the gaps between them filled, up to `bytes`.
fn body(context: &Context<'_>, out: &mut Writer, slots: &[Slot], bytes: u64, depth: usize) {
    let indent = "    ".repeat(depth);
    let mut at = 0;
    let pad = |out: &mut Writer, from: u64, to: u64| {
        if to > from {
            out.line(&format!("{indent}uint8_t RESERVED_{from:03X}[{}];", to - from));
        }
    };
    for slot in slots {
        pad(out, at, slot.offset);
        at = slot.offset + slot.bytes;
        match &slot.kind {
            SlotKind::Register { width, read_only, count, title } => {
                let qualifier = if *read_only { format!("{}_READ_ONLY", context.upper) } else { "volatile".to_owned() };
                let array = count.map_or_else(String::new, |count| format!("[{count}]"));
                let title = super::write::remark(title);
                out.line(&format!("{indent}{qualifier} {} {}{array};{title}", ctype(*width), slot.name));
            }
            SlotKind::Group { count, type_name, .. } if !type_name.is_empty() => {
                out.line(&format!("{indent}{type_name} {}[{count}];", slot.name));
            }
            SlotKind::Group { count, stride, members, .. } => {
                out.line(&format!("{indent}struct {{"));
                body(context, out, members, *stride, depth + 1);
                out.line(&format!("{indent}}} {}[{count}];", slot.name));
            }
            SlotKind::Windows(views) => {
                out.line(&format!("{indent}union {{"));
                for (window, view) in views {
                    let window = &context.model.windows[window.0];
                    let end = view.iter().map(|slot| slot.offset + slot.bytes).max().unwrap_or(0);
                    out.line(&format!("{indent}    struct {{"));
                    body(context, out, view, end, depth + 2);
                    out.line(&format!("{indent}    }} {};", window.ident.upper));
                }
                out.line(&format!("{indent}}} {};", slot.name));
            }
        }
    }
    pad(out, at, bytes);
}

/// Path and offset of every register, of the second element of arrays too.
fn places(context: &Context<'_>, slots: &[Slot], base: u64, prefix: &str, found: &mut Vec<(String, u64)>) {
    for slot in slots {
        let path = format!("{prefix}{}", slot.name);
        let at = base + slot.offset;
        match &slot.kind {
            SlotKind::Register { count: None, .. } => found.push((path, at)),
            SlotKind::Register { width, count: Some(count), .. } => {
                found.push((format!("{path}[0]"), at));
                if *count > 1 {
                    found.push((format!("{path}[1]"), at + u64::from(width / 8)));
                }
            }
            SlotKind::Group { count, stride, members, .. } => {
                places(context, members, at, &format!("{path}[0]."), found);
                if *count > 1 {
                    places(context, members, at + stride, &format!("{path}[1]."), found);
                }
            }
            SlotKind::Windows(views) => {
                for (window, view) in views {
                    let name = &context.model.windows[window.0].ident.upper;
                    places(context, view, at, &format!("{path}.{name}."), found);
                }
            }
        }
    }
}
