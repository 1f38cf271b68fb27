//! What the metadata of the generated crates says, against the model.

use regbus::meta::{Access, Controller, Field as Meta, ReadEffect, RegisterInfo};
use regdef::model::{AccessCode, Dim, Field, FieldReset, Model, OnRead, Register};

/// The metadata of the controller a model is of; `None` for the small descriptions, which have no crate.
pub fn controller(model: &Model) -> Option<&'static Controller> {
    let all = [
        &m_can_pac::meta::CONTROLLER,
        &dspic33_canfd_pac::meta::CONTROLLER,
        &dspic33_ecan_pac::meta::CONTROLLER,
        &pic32_can_pac::meta::CONTROLLER,
    ];
    all.into_iter().find(|controller| controller.name == model.names.id)
}

/// Compares every register and field; returns the number of fields.
pub fn compare(model: &Model, controller: &Controller) -> usize {
    assert_eq!(u64::from(controller.span), model.span, "{}", model.names.id);
    assert_eq!(controller.access_widths, model.access_widths.as_slice(), "{}", model.names.id);
    assert_eq!(controller.registers.len(), model.registers.len(), "{}", model.names.id);
    let mut count = 0;
    for (info, register) in controller.registers.iter().zip(&model.registers) {
        place(model, info, register);
        assert_eq!(info.fields.len(), register.fields.len(), "{}", register.name);
        for (meta, field) in info.fields.iter().zip(&register.fields) {
            compare_field(&format!("{}.{}", register.name, field.name), meta, field, model);
            count += 1;
        }
    }
    for (meta, message) in controller.messages.iter().zip(&model.messages) {
        for (word, expected) in meta.words.iter().zip(&message.words) {
            assert_eq!((word.name, u64::from(word.offset)), (expected.name.as_str(), expected.offset), "{}", message.name);
            assert_eq!(word.fields.len(), expected.fields.len(), "{}.{}", message.name, expected.name);
            for (meta, field) in word.fields.iter().zip(&expected.fields) {
                compare_field(&format!("{}.{}.{}", message.name, expected.name, field.name), meta, field, model);
                count += 1;
            }
        }
    }
    count
}

fn place(model: &Model, info: &RegisterInfo, register: &Register) {
    let name = &register.name;
    assert_eq!(info.name, name);
    assert_eq!(u32::from(info.width), register.width, "{name}");
    let cluster = register.cluster.map(|id| &model.clusters[id.0]);
    let offset = register.offset.map(|at| at + cluster.map_or(0, |c| c.offset));
    assert_eq!(info.offset.map(u64::from), offset, "{name}");
    let array = |dim: &Dim| (dim.count, dim.stride, dim.first);
    let meta = |array: regbus::meta::Array| (array.count, u64::from(array.stride), array.first);
    assert_eq!(info.array.map(meta), register.dim.as_ref().map(array), "{name}");
    assert_eq!(info.cluster.map(meta), cluster.map(|c| array(&c.dim)), "{name}");
    assert_eq!(u64::from(info.reset), register.reset.value, "{name}");
    assert_eq!(u64::from(info.reset_unknown), register.reset.unknown, "{name}");
    assert_eq!(info.aliased, register.aliased, "{name}");
    assert_eq!(info.window.map(usize::from), register.window.map(|id| id.0), "{name}");
}

fn compare_field(path: &str, meta: &Meta, field: &Field, model: &Model) {
    assert_eq!(meta.name, field.name, "{path}");
    assert_eq!((u32::from(meta.lsb), u32::from(meta.width)), (field.lsb, field.width), "{path}");
    assert_eq!(u32::from(meta.lanes), field.lane_count(), "{path}");
    assert_eq!(u64::from(meta.all()), field.mask(), "{path}");
    let code = match meta.access {
        Access::Rw => AccessCode::Rw,
        Access::Ro => AccessCode::Ro,
        Access::Wo => AccessCode::Wo,
        Access::W1c => AccessCode::W1c,
        Access::W0c => AccessCode::W0c,
        Access::W1s => AccessCode::W1s,
        Access::Rwhc => AccessCode::Rwhc,
        Access::Rwh => AccessCode::Rwh,
        Access::Wclr => AccessCode::Wclr,
    };
    assert_eq!(code, field.access.code, "{path}");
    let effect = match meta.on_read {
        ReadEffect::None => None,
        ReadEffect::Clear(byte) => Some(OnRead { effect: regdef::model::ReadEffect::Clear, byte }),
        ReadEffect::Set(byte) => Some(OnRead { effect: regdef::model::ReadEffect::Set, byte }),
    };
    assert_eq!(effect, field.access.on_read, "{path}");
    let reset = match field.reset {
        FieldReset::Value(value) => Some(value),
        FieldReset::None(_) => None,
    };
    assert_eq!(meta.reset.map(u64::from), reset, "{path}");
    assert_eq!((u64::from(meta.min), u64::from(meta.max)), (field.min, field.max), "{path}");
    assert_eq!(meta.when.map(usize::from), field.access.when.map(|id| id.0), "{path}");
    assert_eq!(meta.set_when.map(usize::from), field.access.set_when.map(|id| id.0), "{path}");
    let names = field.enumeration().map(|id| model.enumeration(id));
    assert_eq!(meta.values.map(|v| v.name), names.map(|e| e.name.as_str()), "{path}");
    for variant in names.into_iter().flat_map(|e| &e.variants) {
        let name = meta.values.and_then(|v| v.name_of(u32::try_from(variant.first).unwrap_or(u32::MAX)));
        assert_eq!(name, Some(variant.name.as_str()), "{path}");
    }
}
