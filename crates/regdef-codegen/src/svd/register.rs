//! Registers.

use regdef::model::{Model, Register, RegisterId, Target, bit_mask};
use svd_rs::{Access, DimElement, RegisterInfo, RegisterProperties};

use super::enums::Shared;
use super::{At, Error, LEVEL, field, join, name, offset32};
use crate::text;

/// One entry of the register list: a register, an array, or one element of an array whose field names run on.
pub(super) struct Place {
    /// Name, with `%s` for an array.
    pub(super) name: String,
    /// Byte offset in the block or in the cluster.
    pub(super) offset: u64,
    /// The array.
    pub(super) dim: Option<DimElement>,
    /// Position of the element in the array, for the numbers of lanes.
    pub(super) position: u32,
}

/// Where a register stands; empty for a register of the device.
pub(super) fn places(register: &Register) -> Result<Vec<Place>, Error> {
    let Some(offset) = register.offset else { return Ok(Vec::new()) };
    let in_cluster = register.cluster.is_some();
    Ok(match &register.dim {
        Some(dim) if register.lanes_run_on() && !in_cluster => (0..dim.count)
            .map(|position| Place {
                name: name::identifier(&register.label_of(dim, position)),
                offset: offset + dim.stride * u64::from(position),
                dim: None,
                position,
            })
            .collect(),
        Some(dim) => {
            let (name, element) = name::array(&register.label, dim)?;
            vec![Place { name, offset, dim: Some(element), position: 0 }]
        }
        None => {
            let name = if in_cluster { &register.name } else { &register.label };
            vec![Place { name: name::identifier(name), offset, dim: None, position: 0 }]
        }
    })
}

pub(super) fn build(
    model: &Model,
    shared: &mut Shared,
    id: RegisterId,
    place: &Place,
) -> Result<svd_rs::Register, Error> {
    let register = model.register(id);
    shared.enter(&place.name, register.window.is_some());
    let fields = register
        .fields
        .iter()
        .map(|of| field::build(model, shared, register, of, place.position))
        .collect::<Result<Vec<_>, _>>()?;
    shared.leave();
    let mask = bit_mask(0, register.width) & !register.reset.unknown;
    let properties = RegisterProperties::new()
        .size(Some(register.width))
        .access(Some(access(register)))
        .reset_value(Some(register.reset.value & mask))
        .reset_mask(Some(mask));
    let info = RegisterInfo::builder()
        .name(place.name.clone())
        .description(Some(description(model, id)))
        .alternate_group(register.window.map(|window| name::identifier(&model.windows[window.0].name)))
        .address_offset(offset32(&register.name, place.offset)?)
        .properties(properties)
        .fields(Some(fields).filter(|fields| !fields.is_empty()))
        .build(LEVEL)
        .at(&register.name)?;
    Ok(info.maybe_array(place.dim.clone()))
}

fn access(register: &Register) -> Access {
    match (register.capabilities.readable, register.capabilities.writable) {
        (true, true) => Access::ReadWrite,
        (false, true) => Access::WriteOnly,
        (_, false) => Access::ReadOnly,
    }
}

fn description(model: &Model, id: RegisterId) -> String {
    let register = model.register(id);
    let mut sentences = vec![text::sentence(&register.title), text::sentence(&register.doc)];
    sentences.extend(text::register_notes(model, register));
    for joined in &model.joined {
        if joined.parts.iter().any(|part| part.holder == id) {
            sentences.push(format!("Part of the {} bit value {}.", joined.width, joined.name));
        }
    }
    sentences.push(text::conflicts(model, |target| *target == Target::Register(id)));
    sentences.push(text::sentence(&text::cites(&register.cites)));
    join(sentences)
}
