//! Functions that access a register: each does no more accesses than its comment says.

use regdef::model::{AliasOp, Model, Neutral, NoModify, Register, RegisterId, WriteEffect};

use super::Context;
use super::layout::Reach;
use super::literal::{ctype, hex};
use super::write::Writer;

/// How functions reach a register.
pub(super) struct Target {
    /// Parameters: the block, and the number of an element.
    pub(super) parameters: String,
    /// Arguments that pass them on.
    pub(super) arguments: &'static str,
    /// Checks of the number.
    pub(super) checks: Vec<String>,
    /// The register.
    pub(super) lvalue: String,
}

/// How functions reach a register; `None` for one without an address or deep in nested arrays.
pub(super) fn target(context: &Context<'_>, id: RegisterId) -> Option<Target> {
    let reach = context.layout.reach.get(&id)?;
    let register = context.model.register(id);
    Some(Target {
        parameters: match reach.index {
            Some(_) => format!("{} *regs, unsigned int n", context.block()),
            None => format!("{} *regs", context.block()),
        },
        arguments: if reach.index.is_some() { "regs, n" } else { "regs" },
        checks: checks(context, reach),
        lvalue: lvalue(register, reach, 0),
    })
}

fn checks(context: &Context<'_>, reach: &Reach) -> Vec<String> {
    reach.index.map_or_else(Vec::new, |(first, count)| {
        let index = if first == 0 { "n".to_owned() } else { format!("n - {first}U") };
        vec![format!("{}_ASSERT({index} < {count}U);", context.upper)]
    })
}

/// The register, or the address `more` bytes behind it for an array reached by address.
fn lvalue(register: &Register, reach: &Reach, more: u64) -> String {
    match (reach.address, reach.index) {
        (Some((offset, stride)), Some((first, _))) => {
            let index = if first == 0 { "n".to_owned() } else { format!("(n - {first}U)") };
            let at = format!("{}U + {stride}U * {index}", offset + more);
            format!("*(volatile {} *)((volatile uint8_t *)regs + ({at}))", ctype(register.width))
        }
        _ => reach.lvalue.clone(),
    }
}

/// Every writable field has a value that leaves it alone without a read.
pub(super) fn constant_neutral(register: &Register) -> bool {
    let writable = register.fields.iter().filter(|field| field.access.code.writable());
    writable.into_iter().all(|field| matches!(field.access.neutral(), Neutral::Zero | Neutral::Ones))
}

/// The register has a function `_clear`.
pub(super) fn clearable(register: &Register) -> bool {
    constant_neutral(register) && register.capabilities.one_clears | register.capabilities.zero_clears != 0
}

/// The register has a function `_request`.
pub(super) fn requestable(register: &Register) -> bool {
    constant_neutral(register) && register.capabilities.one_sets != 0
}

pub(super) fn emit(context: &Context<'_>, out: &mut Writer, id: RegisterId) {
    let register = context.model.register(id);
    let Some(target) = target(context, id) else { return };
    let stem = context.names.register(id).to_ascii_lowercase();
    if context.layout.reach.get(&id).is_some_and(|reach| reach.index.is_some()) {
        pointer(out, register, &target, &stem);
    }
    flags(out, register, &target, &stem);
    modify(out, register, &target, &stem);
    any_write(out, register, &target, &stem);
    aliases(context, out, id, &target, &stem);
    refused(context.model, out, register);
}

fn with(target: &Target, line: String) -> Vec<String> {
    let mut body = target.checks.clone();
    body.push(line);
    body
}

/// The address of an element by the manual's number.
fn pointer(out: &mut Writer, register: &Register, target: &Target, stem: &str) {
    let qualifier = if register.capabilities.writable { "volatile" } else { "const volatile" };
    let body = with(target, format!("return &{};", target.lvalue));
    out.comment(&["The register with the manual's number n.".to_owned()]);
    out.function(&format!("{qualifier} {} *{stem}({})", ctype(register.width), target.parameters), &body);
}

fn flags(out: &mut Writer, register: &Register, target: &Target, stem: &str) {
    let container = ctype(register.width);
    let literal = |bits: u64| hex(bits, register.width);
    let can = &register.capabilities;
    if clearable(register) {
        let mut terms = Vec::new();
        if can.one_clears != 0 {
            terms.push(format!("flags & {}", literal(can.one_clears)));
        }
        if can.neutral_ones != 0 {
            terms.push(format!("{} & ({container})~flags", literal(can.neutral_ones)));
        }
        out.comment(&["Clears the given flags and no others: one store, no read.".to_owned()]);
        let body = with(target, format!("{} = ({container})({});", target.lvalue, join(&terms)));
        out.function(&format!("void {stem}_clear({}, {container} flags)", target.parameters), &body);
    }
    if requestable(register) {
        out.comment(&["Makes the given requests and withdraws none: one store, no read.".to_owned()]);
        let ones = if can.neutral_ones == 0 { String::new() } else { format!(" | {}", literal(can.neutral_ones)) };
        let line = format!("{} = ({container})((requests & {}){ones});", target.lvalue, literal(can.one_sets));
        out.function(&format!("void {stem}_request({}, {container} requests)", target.parameters), &with(target, line));
    }
}

/// Terms joined with `|`, in parentheses where there are several.
fn join(terms: &[String]) -> String {
    match terms {
        [one] => one.clone(),
        several => format!("({})", several.join(") | (")),
    }
}

fn modify(out: &mut Writer, register: &Register, target: &Target, stem: &str) {
    if register.capabilities.modify.is_err() {
        return;
    }
    let container = ctype(register.width);
    let can = &register.capabilities;
    let mut body = target.checks.clone();
    body.push(format!("{container} value = {};", target.lvalue));
    if can.neutral_zeros | can.neutral_ones != 0 {
        let zeros = hex(can.neutral_zeros, register.width);
        let ones = hex(can.neutral_ones, register.width);
        body.push(format!("value = ({container})((value & ({container})~{zeros}) | {ones});"));
    }
    body.push(format!("{} = ({container})((value & ({container})~clear) | set);", target.lvalue));
    let flags = "Flags and requests that are not among the given bits are left alone.";
    out.comment(&[format!("Clears and sets the given bits: one read and one store. {flags}")]);
    out.function(&format!("void {stem}_modify({}, {container} clear, {container} set)", target.parameters), &body);
}

/// A register that any write clears or presets.
fn any_write(out: &mut Writer, register: &Register, target: &Target, stem: &str) {
    let mut writable = register.fields.iter().filter(|field| field.access.code.writable()).peekable();
    if writable.peek().is_none() || !writable.all(|field| field.access.code.write_effect() == WriteEffect::Resets) {
        return;
    }
    out.comment(&["Clears or presets the register, as any write does: one store.".to_owned()]);
    out.function(
        &format!("void {stem}_restart({})", target.parameters),
        &with(target, format!("{} = 0U;", target.lvalue)),
    );
}

/// One store to an alias register.
fn aliases(context: &Context<'_>, out: &mut Writer, id: RegisterId, target: &Target, stem: &str) {
    let register = context.model.register(id);
    let Some(reach) = context.layout.reach.get(&id) else { return };
    if !register.aliased || !register.capabilities.writable {
        return;
    }
    for alias in &context.model.aliases {
        let verb = match alias.op {
            AliasOp::Clear => "Clears",
            AliasOp::Set => "Sets",
            AliasOp::Invert => "Inverts",
        };
        let lvalue = match reach.address {
            Some(_) => lvalue(register, reach, alias.offset),
            None => format!("{}{}", target.lvalue, alias.name),
        };
        let container = ctype(register.width);
        out.comment(&[format!("{verb} the given bits: one store to the {} register.", alias.name)]);
        let name = format!("{stem}_{}", alias.name.to_ascii_lowercase());
        out.function(
            &format!("void {name}({}, {container} bits)", target.parameters),
            &with(target, format!("{lvalue} = bits;")),
        );
    }
}

/// Why there is no `_modify`, where one would look for it.
fn refused(model: &Model, out: &mut Writer, register: &Register) {
    let reason = match &register.capabilities.modify {
        Err(NoModify::ReadHasEffects(fields)) => format!("the read changes {}", fields.join(", ")),
        Err(NoModify::NoNeutral(fields)) => {
            format!("no value written to {} leaves it alone", fields.join(", "))
        }
        Ok(()) | Err(NoModify::NotReadWrite | NoModify::OnlyFlags(_)) => return,
    };
    let instead = match register.aliased && !model.aliases.is_empty() {
        true => "Use the functions for single bits above.",
        false => "Compose the whole value and store it.",
    };
    if register.capabilities.writable {
        out.comment(&[format!("No read-modify-write: {reason}. {instead}")]);
    }
}
