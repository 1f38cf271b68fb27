//! The manufacturer's names (`C1CON`, `C1CONbits.REQOP`, `C1CONSET`) over the same layout.
//!
//! A bit-field assignment reads the register and writes all of it back. Where that would clear flags, or where the
//! read alone changes something, the view is const: its fields can be read, and an assignment does not compile.

use regdef::model::{Neutral, NoModify, Placed, Register, WriteEffect};

use super::Context;
use super::layout::identifier;
use super::literal::{ctype, offset};
use super::write::Writer;

/// Modules of one chip that can have names at the same time.
const MODULES: std::ops::RangeInclusive<u32> = 1..=2;

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    let Some(letter) = letter(context) else { return };
    let upper = &context.upper;
    out.comment(&[
        format!("The manufacturer's names, such as {letter}1CON and {letter}1CONbits, over the same layout."),
        format!(
            "Define {upper}_MICROCHIP_NAMES before including this header, and {upper}_{letter}1_BASE, \
             {upper}_{letter}2_BASE with the base addresses where no default stands below."
        ),
        "Containers have fixed width. A register with flags that a bit-field assignment would clear, or with fields \
         that the read changes, has a const view: clear its flags with the functions above."
            .to_owned(),
    ]);
    out.line(&format!("#ifdef {upper}_MICROCHIP_NAMES"));
    out.line(
        "#if defined(__BYTE_ORDER__) && defined(__ORDER_LITTLE_ENDIAN__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__",
    );
    out.line("#error \"bit-fields are laid out for little-endian compilers\"");
    out.line("#endif");
    let placed: Vec<Placed> =
        context.model.instances_of_registers().into_iter().filter(|at| unique(context, *at)).collect();
    for at in &placed {
        if first_of_view(context, at) {
            view(context, out, at);
        }
    }
    for module in MODULES {
        names(context, out, &placed, &format!("{letter}{module}"), module);
    }
    out.line("#endif");
    out.blank();
}

/// The prefix without the placeholder of the number; only controllers that have one have these names.
fn letter<'m>(context: &Context<'m>) -> Option<&'m str> {
    context.model.prefix.strip_suffix(['x', 'i', 'n']).filter(|letter| !letter.is_empty())
}

/// Arrays inside clusters have no name of their own in these headers.
fn unique(context: &Context<'_>, at: Placed) -> bool {
    let register = context.model.register(at.register);
    register.cluster.is_none() || register.dim.is_none()
}

/// Elements of an array share a view unless the names of their fields run on.
fn first_of_view(context: &Context<'_>, at: &Placed) -> bool {
    context.model.register(at.register).lanes_run_on() || at.position(context.model) == 0
}

fn view_name(context: &Context<'_>, at: &Placed) -> String {
    let register = context.model.register(at.register);
    let of = if register.lanes_run_on() { identifier(&at.label(context.model)) } else { register.ident.upper.clone() };
    format!("{}_{}_bits_t", context.lower, of.to_ascii_lowercase())
}

/// Assigning to one bit-field of the register may harm none of the others.
fn assignable(register: &Register) -> bool {
    register.capabilities.readable
        && register.capabilities.writable
        && register.capabilities.pure
        && !matches!(register.capabilities.modify, Err(NoModify::OnlyFlags(_)))
        && register.fields.iter().all(|field| {
            !matches!(
                field.access.code.write_effect(),
                WriteEffect::OneClears | WriteEffect::ZeroClears | WriteEffect::Resets
            ) && (field.access.neutral() != Neutral::None || field.access.code.write_effect() == WriteEffect::Requests)
        })
}

/// One field of a bit-field view.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BitField {
    /// The type of the view.
    pub view: String,
    /// The member.
    pub member: String,
    /// The bits it has to have.
    pub mask: u64,
    /// Width of the container.
    pub width: u32,
}

/// Every field of every view in the header, in order; empty for a controller without these names.
pub(super) fn bit_fields(context: &Context<'_>) -> Vec<BitField> {
    if letter(context).is_none() {
        return Vec::new();
    }
    let mut all = Vec::new();
    for at in context.model.instances_of_registers() {
        if !unique(context, at) || !first_of_view(context, &at) {
            continue;
        }
        let register = context.model.register(at.register);
        for field in &register.fields {
            for lane in 0..field.lane_count() {
                all.push(BitField {
                    view: view_name(context, &at),
                    member: identifier(&field.label_of(at.position(context.model), lane)),
                    mask: field.lane_mask(lane),
                    width: register.width,
                });
            }
        }
    }
    all
}

fn view(context: &Context<'_>, out: &mut Writer, at: &Placed) {
    let register = context.model.register(at.register);
    let container = ctype(register.width);
    let position = at.position(context.model);
    let mut lanes: Vec<(u32, u32, String)> = Vec::new();
    for field in &register.fields {
        for lane in 0..field.lane_count() {
            lanes.push((field.lane_lsb(lane), field.width, identifier(&field.label_of(position, lane))));
        }
    }
    lanes.sort_unstable();
    let name = view_name(context, at);
    out.line("typedef struct {");
    let mut bit = 0;
    for (lsb, width, field) in lanes {
        if lsb > bit {
            out.line(&format!("    {container} : {};", lsb - bit));
        }
        out.line(&format!("    {container} {field} : {width};"));
        bit = lsb + width;
    }
    if bit < register.width {
        out.line(&format!("    {container} : {};", register.width - bit));
    }
    out.line(&format!("}} {name};"));
    let bytes = register.width / 8;
    out.line(&format!("{}_STATIC_ASSERT(sizeof({name}) == {bytes}U, {name}_size);", context.upper));
}

fn names(context: &Context<'_>, out: &mut Writer, placed: &[Placed], module: &str, number: u32) {
    let upper = &context.upper;
    let base = format!("{upper}_{module}_BASE");
    let mut matching = context.model.instances.iter().filter(|instance| {
        let digits = instance.name.trim_start_matches(|c: char| !c.is_ascii_digit());
        digits == number.to_string()
    });
    if let (Some(instance), None) = (matching.next(), matching.next()) {
        out.line(&format!("#ifndef {base}"));
        out.define(&base, &format!("{}_BASE", super::instances::stem(context, instance)));
        out.line("#endif");
    }
    out.line(&format!("#ifdef {base}"));
    for at in placed {
        let register = context.model.register(at.register);
        let label = format!("{module}{}", identifier(&at.label(context.model)));
        let container = ctype(register.width);
        let lvalue = |more: u64, ty: &str| format!("(*({ty} *)((uintptr_t){base} + {}))", offset(at.offset + more));
        let qualifier = if register.capabilities.writable { "volatile" } else { "const volatile" };
        out.define(&label, &lvalue(0, &format!("{qualifier} {container}")));
        let qualifier = if assignable(register) { "volatile" } else { "const volatile" };
        out.define(&format!("{label}bits"), &lvalue(0, &format!("{qualifier} {}", view_name(context, at))));
        if register.aliased {
            for alias in &context.model.aliases {
                out.define(&format!("{label}{}", alias.name), &lvalue(alias.offset, &format!("volatile {container}")));
            }
        }
    }
    out.line("#endif");
}
