//! Alias registers: written out, because SVD has no word for them.

use regdef::model::{Alias, AliasOp, Field, Model, RegisterId};
use svd_rs::{Access, FieldInfo, ModifiedWriteValues, Register, RegisterInfo, RegisterProperties};

use super::register::Place;
use super::{At, Error, LEVEL, join, name, offset32};
use crate::text;

/// The alias `of` the register at `place`, with the fields that software can write.
pub(super) fn build(model: &Model, id: RegisterId, place: &Place, of: &Alias) -> Result<Register, Error> {
    let register = model.register(id);
    let effect = match of.op {
        AliasOp::Clear => ModifiedWriteValues::OneToClear,
        AliasOp::Set => ModifiedWriteValues::OneToSet,
        AliasOp::Invert => ModifiedWriteValues::OneToToggle,
    };
    let name = format!("{}{}", place.name, of.name);
    let fields = register
        .fields
        .iter()
        .filter(|of| of.access.code.writable())
        .map(|of| field(of, place.position, effect))
        .collect::<Result<Vec<_>, _>>()?;
    let verb = match of.op {
        AliasOp::Clear => "clears",
        AliasOp::Set => "sets",
        AliasOp::Invert => "inverts",
    };
    let what = format!("A bit written 1 {verb} the same bit of {}.", register.label.replace("{n}", "n"));
    let info = RegisterInfo::builder()
        .name(name.clone())
        .description(Some(join(vec![what, text::sentence(&of.doc), text::sentence(&text::cites(&of.cites))])))
        .alternate_group(register.window.map(|window| name::identifier(&model.windows[window.0].name)))
        .address_offset(offset32(&register.name, place.offset + of.offset)?)
        .properties(
            RegisterProperties::new()
                .size(Some(register.width))
                .access(Some(Access::WriteOnly))
                .reset_value(Some(0))
                .reset_mask(Some(0)),
        )
        .modified_write_values(Some(effect))
        .fields(Some(fields).filter(|fields| !fields.is_empty()))
        .build(LEVEL)
        .at(&name)?;
    Ok(info.maybe_array(place.dim.clone()))
}

fn field(of: &Field, position: u32, effect: ModifiedWriteValues) -> Result<svd_rs::Field, Error> {
    let (name, dim) = super::field::name_and_lanes(of, position)?;
    let info = FieldInfo::builder()
        .name(name)
        .bit_offset(of.lsb)
        .bit_width(of.width)
        .access(Some(Access::WriteOnly))
        .modified_write_values(Some(effect))
        .build(LEVEL)
        .at(&of.name)?;
    Ok(info.maybe_array(dim))
}
