//! One self-contained C header per controller, C99 and C++11.
//!
//! The header has the register block as a struct whose layout is asserted, macros for every field, helpers that
//! do no more than one access where one access is enough, message layouts and, for controllers whose users expect
//! them, the manufacturer's names over the same layout.

mod access;
mod enums;
mod field;
mod instances;
mod joined;
mod layout;
mod literal;
mod message;
mod microchip;
mod names;
mod register;
mod structs;
mod window;
mod write;

use regdef::model::Model;

use crate::text;
use layout::Layout;
use write::Writer;

pub use microchip::BitField;
pub use names::Names;

/// What every part of the header needs.
struct Context<'m> {
    model: &'m Model,
    names: Names,
    layout: Layout,
    /// `m_can`: in front of types and functions.
    lower: String,
    /// `M_CAN`: in front of macros.
    upper: String,
}

impl<'m> Context<'m> {
    fn new(model: &'m Model) -> Self {
        let upper = model.names.ident.upper.clone();
        let (names, layout) = (Names::new(model), Layout::new(model));
        Self { model, names, layout, lower: upper.to_ascii_lowercase(), upper }
    }

    /// The type of the register block.
    fn block(&self) -> String {
        format!("{}_regs_t", self.lower)
    }
}

/// The controller as a C header.
#[must_use]
pub fn header(model: &Model) -> String {
    let context = Context::new(model);
    let mut out = Writer::default();
    prologue(&context, &mut out);
    enums::emit(&context, &mut out);
    structs::emit(&context, &mut out);
    register::emit(&context, &mut out);
    window::emit(&context, &mut out);
    joined::emit(&context, &mut out);
    message::emit(&context, &mut out);
    instances::emit(&context, &mut out);
    microchip::emit(&context, &mut out);
    out.line("#ifdef __cplusplus");
    out.line("}");
    out.line("#endif");
    out.blank();
    out.line(&format!("#endif /* {}_H */", context.upper));
    out.finish()
}

/// The fields of the manufacturer's bit-field views; empty for a controller without them.
#[must_use]
pub fn bit_fields(model: &Model) -> Vec<BitField> {
    microchip::bit_fields(&Context::new(model))
}

fn prologue(context: &Context<'_>, out: &mut Writer) {
    let Context { model, upper, .. } = context;
    let manual = &model.manual;
    out.comment(&[
        format!("{}: registers and message layouts.", model.title),
        text::one_line(&model.doc),
        text::sentence(&format!(
            "Described after {}, {}, revision {}",
            manual.title, manual.publisher, manual.revision
        )),
        "Generated from the description of the controller; changes belong there.".to_owned(),
        format!(
            "C99 or C++11. A field FIELD of a register REG has {upper}_REG_FIELD_Pos, _Msk, _Width and _Access; a \
             field that is repeated in its register takes the number of the lane, counted from 0, as an argument."
        ),
        "Access codes: rw, ro, wo; w1c and w0c are flags cleared by writing 1 or 0; w1s is a request made by writing \
         1; rwhc a request that 0 withdraws; rwh is changed by hardware too; wclr is cleared or preset by any write; \
         +rc and +rs are cleared or set by a read, @n of byte n; a condition for writing stands behind the colon."
            .to_owned(),
        format!("Define {upper}_ASSERT(condition) to have ranges and indices checked at run time."),
        "SPDX-License-Identifier: MIT OR Apache-2.0".to_owned(),
    ]);
    out.line(&format!("#ifndef {upper}_H"));
    out.line(&format!("#define {upper}_H"));
    out.blank();
    out.line("#include <stddef.h>");
    out.line("#include <stdint.h>");
    out.blank();
    out.line("#ifdef __cplusplus");
    out.line("extern \"C\" {");
    out.line("#endif");
    out.blank();
    out.line("#if defined(__cplusplus)");
    out.line(&format!("#define {upper}_STATIC_ASSERT(condition, name) static_assert(condition, #name)"));
    out.line("#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L");
    out.line(&format!("#define {upper}_STATIC_ASSERT(condition, name) _Static_assert(condition, #name)"));
    out.line("#else");
    out.line(&format!("#define {upper}_STATIC_ASSERT(condition, name) typedef char name[(condition) ? 1 : -1]"));
    out.line("#endif");
    out.blank();
    out.line(&format!("#ifndef {upper}_ASSERT"));
    out.line(&format!("#define {upper}_ASSERT(condition) ((void)0)"));
    out.line("#endif");
    out.blank();
    out.comment(&["A register that software can only read. C++ wants every const member initialized.".to_owned()]);
    out.line("#ifdef __cplusplus");
    out.line(&format!("#define {upper}_READ_ONLY volatile"));
    out.line("#else");
    out.line(&format!("#define {upper}_READ_ONLY volatile const"));
    out.line("#endif");
    out.blank();
}
