//! Values that are split over registers or words.

use regdef::model::{HalfOrder, Joined, Model, Part, RegisterId, WriteEffect};

use super::literal::{ctype, hex};
use super::write::Writer;
use super::{Context, access};
use crate::text;

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    for (index, joined) in context.model.joined.iter().enumerate() {
        one(context, out, joined, &context.names.joined(index).to_ascii_lowercase());
    }
}

/// The type that holds the whole value.
pub(super) const fn whole(width: u32) -> &'static str {
    if width > 32 { "uint64_t" } else { "uint32_t" }
}

/// `value` taken out of `part0` and its fellows, where `number` gives the variable of a holder.
pub(super) fn gathered<R: Copy + PartialEq>(joined: &Joined<R>, holders: &[R], width_of: impl Fn(R) -> u32) -> String {
    let whole = whole(joined.width);
    let terms: Vec<String> = joined
        .parts
        .iter()
        .map(|part| {
            let number = holders.iter().position(|holder| *holder == part.holder).unwrap_or(0);
            let mask = hex(mask(part), width_of(part.holder));
            format!("(({whole})((part{number} & {mask}) >> {}U) << {}U)", part.lsb, part.shift)
        })
        .collect();
    format!("return {};", terms.join(" | "))
}

/// The bits of a part, in place, out of the whole value in the variable `from`.
pub(super) fn scattered<R>(part: &Part<R>, width: u32, from: &str) -> String {
    let container = ctype(width);
    format!("({container})((({container})({from} >> {}U) << {}U) & {})", part.shift, part.lsb, hex(mask(part), width))
}

pub(super) fn mask<R>(part: &Part<R>) -> u64 {
    regdef::model::bit_mask(part.lsb, part.width)
}

/// The holders without repetition, in the order of access.
pub(super) fn holders<R: Copy + PartialEq>(joined: &Joined<R>) -> Vec<R> {
    let mut holders: Vec<R> = Vec::new();
    for part in &joined.parts {
        if !holders.contains(&part.holder) {
            holders.push(part.holder);
        }
    }
    if joined.order == HalfOrder::HighFirst {
        holders.reverse();
    }
    holders
}

fn one(context: &Context<'_>, out: &mut Writer, joined: &Joined, stem: &str) {
    let model = context.model;
    let holders = holders(joined);
    let targets: Option<Vec<access::Target>> = holders.iter().map(|&id| access::target(context, id)).collect();
    let Some(targets) = targets else { return };
    let Some(lead) = targets.first() else { return };
    let order: Vec<&str> = holders.iter().map(|&id| model.register(id).label.as_str()).collect();
    let order = format!("Accessed in the order {}.", order.join(", ").replace("{n}", "n"));
    out.comment(&[format!("{}: {}", joined.name, text::sentence(&joined.doc)), order, text::cites(&joined.cites)]);
    let width_of = |id: RegisterId| model.register(id).width;
    if holders.iter().all(|&id| model.register(id).capabilities.readable) {
        let mut body = Vec::new();
        body.extend(lead.checks.clone());
        for (number, (&id, target)) in holders.iter().zip(&targets).enumerate() {
            body.push(format!("const {} part{number} = {};", ctype(width_of(id)), target.lvalue));
        }
        body.push(gathered(joined, &holders, width_of));
        out.function(&format!("{} {stem}_read({})", whole(joined.width), lead.parameters), &body);
    }
    if let Some(body) = write(model, context, joined, &holders, &targets) {
        let mut lines = lead.checks.clone();
        lines.extend(body);
        out.function(&format!("void {stem}_write({}, {} value)", lead.parameters, whole(joined.width)), &lines);
    }
    for (verb, parameter) in [("clear", "flags"), ("request", "requests")] {
        if let Some(body) = split(context, joined, lead.arguments, verb, parameter) {
            let head = format!("void {stem}_{verb}({}, {} {parameter})", lead.parameters, whole(joined.width));
            out.function(&head, &body);
        }
    }
    out.blank();
}

/// Stores of all holders; `None` if a part is not simply stored or a holder has more than the parts and cannot be
/// read first.
fn write(
    model: &Model,
    context: &Context<'_>,
    joined: &Joined,
    holders: &[RegisterId],
    targets: &[access::Target],
) -> Option<Vec<String>> {
    let mut lines = Vec::new();
    for (&id, target) in holders.iter().zip(targets) {
        let register = model.register(id);
        let parts: Vec<&Part<RegisterId>> = joined.parts.iter().filter(|part| part.holder == id).collect();
        let covered = parts.iter().fold(0, |bits, part| bits | mask(part));
        let writable = || register.fields.iter().filter(|field| field.access.code.writable());
        let mut concerned = writable().filter(|field| field.mask() & covered != 0).peekable();
        concerned.peek()?;
        if !concerned.all(|field| field.access.code.write_effect() == WriteEffect::Stores) {
            return None;
        }
        let bits = parts.iter().map(|part| scattered(part, register.width, "value")).collect::<Vec<_>>().join(" | ");
        if writable().all(|field| field.mask() & !covered == 0) {
            lines.push(format!("{} = ({})({bits});", target.lvalue, ctype(register.width)));
        } else if register.capabilities.modify.is_ok() {
            let stem = context.names.register(id).to_ascii_lowercase();
            let clear = hex(covered, register.width);
            lines.push(format!("{stem}_modify({}, {clear}, ({})({bits}));", target.arguments, ctype(register.width)));
        } else {
            return None;
        }
    }
    Some(lines)
}

/// The same operation on every holder, if all of them have it.
fn split(context: &Context<'_>, joined: &Joined, arguments: &str, verb: &str, parameter: &str) -> Option<Vec<String>> {
    let mut lines = Vec::new();
    for part in &joined.parts {
        let register = context.model.register(part.holder);
        let (able, bits) = match verb {
            "clear" => {
                (access::clearable(register), register.capabilities.one_clears | register.capabilities.zero_clears)
            }
            _ => (access::requestable(register), register.capabilities.one_sets),
        };
        if !able || bits & mask(part) == 0 {
            return None;
        }
        let stem = context.names.register(part.holder).to_ascii_lowercase();
        lines.push(format!("{stem}_{verb}({arguments}, {});", scattered(part, register.width, parameter)));
    }
    Some(lines)
}
