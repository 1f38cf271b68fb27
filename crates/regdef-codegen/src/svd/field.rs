//! Fields.

use regdef::model::{AccessCode, Field, Kind, Model, OnRead, ReadEffect, Register, Target, WriteEffect};
use svd_rs::{Access, DimElement, FieldInfo, ModifiedWriteValues, ReadAction, WriteConstraint, WriteConstraintRange};

use super::enums::Shared;
use super::{At, Error, LEVEL, join, name};
use crate::text;

/// Name of a field, with `%s` and the `dim` element if it has lanes.
pub(super) fn name_and_lanes(field: &Field, position: u32) -> Result<(String, Option<DimElement>), Error> {
    Ok(match field.lanes {
        Some(lanes) => (name::indexed(&field.label), Some(name::lanes(&field.label, lanes, position)?)),
        None => (name::identifier(&field.label), None),
    })
}

pub(super) fn build(
    model: &Model,
    shared: &mut Shared,
    register: &Register,
    field: &Field,
    position: u32,
) -> Result<svd_rs::Field, Error> {
    let (name, dim) = name_and_lanes(field, position)?;
    let values = match field.kind {
        Kind::Enum(id) => shared.values(model, id, field, &name)?,
        Kind::Bool | Kind::Int => None,
    };
    let constraint = constraint(field, values.is_some());
    let info = FieldInfo::builder()
        .name(name)
        .description(Some(description(model, register, field)))
        .bit_offset(field.lsb)
        .bit_width(field.width)
        .access(Some(access(field.access.code)))
        .modified_write_values(modified_write_values(field))
        .write_constraint(constraint)
        .read_action(field.access.on_read.map(|OnRead { effect, .. }| match effect {
            ReadEffect::Clear => ReadAction::Clear,
            ReadEffect::Set => ReadAction::Set,
        }))
        .enumerated_values(values.into_iter().collect())
        .build(LEVEL)
        .at(&format!("{}.{}", register.name, field.name))?;
    Ok(info.maybe_array(dim))
}

/// SVD's word for what software may do.
pub(super) const fn access(code: AccessCode) -> Access {
    match (code.readable(), code.writable()) {
        (true, true) => Access::ReadWrite,
        (true, false) => Access::ReadOnly,
        (false, _) => Access::WriteOnly,
    }
}

/// SVD's word for what a write does, where it is not simply stored.
fn modified_write_values(field: &Field) -> Option<ModifiedWriteValues> {
    match field.access.code.write_effect() {
        WriteEffect::Ignored | WriteEffect::Stores => None,
        WriteEffect::OneClears => Some(ModifiedWriteValues::OneToClear),
        WriteEffect::ZeroClears => Some(ModifiedWriteValues::ZeroToClear),
        WriteEffect::OneSets => Some(ModifiedWriteValues::OneToSet),
        WriteEffect::Requests => Some(ModifiedWriteValues::Modify),
        WriteEffect::Resets if field.access.loads.is_some() => Some(ModifiedWriteValues::Modify),
        WriteEffect::Resets => Some(ModifiedWriteValues::Clear),
    }
}

fn constraint(field: &Field, enumerated: bool) -> Option<WriteConstraint> {
    let stores = matches!(field.access.code.write_effect(), WriteEffect::Stores | WriteEffect::Requests);
    match field.kind {
        _ if !stores => None,
        Kind::Enum(_) if enumerated => Some(WriteConstraint::UseEnumeratedValues(true)),
        Kind::Bool => None,
        Kind::Enum(_) | Kind::Int => {
            Some(WriteConstraint::Range(WriteConstraintRange { min: field.min, max: field.max }))
        }
    }
}

fn description(model: &Model, register: &Register, field: &Field) -> String {
    let mut sentences = vec![text::sentence(&field.doc)];
    sentences.extend(text::access_notes(model, field));
    sentences.push(text::conflicts(
        model,
        |target| matches!(target, Target::Field(at) if std::ptr::eq(model.field(*at), field)),
    ));
    if field.cites != register.cites {
        sentences.push(text::sentence(&text::cites(&field.cites)));
    }
    join(sentences)
}
