//! What the SVD says about each field of each physical register, parsed back.

use std::collections::HashMap;

use regdef::model::{AccessCode, AliasOp, Field, Model, OnRead, Placed, ReadEffect, bit_mask};
use svd_parser::ValidateLevel;
use svd_parser::svd::{Access, FieldInfo, ModifiedWriteValues, ReadAction, RegisterInfo};

/// Registers of a window stand at the same addresses as others.
type Place = (u64, Option<String>);

/// Compares every field and gives their number.
pub fn compare(model: &Model) -> usize {
    let text = regdef_codegen::svd::svd(model).unwrap_or_else(|error| panic!("{}: {error}", model.names.id));
    let strict = svd_parser::Config::default().validate_level(ValidateLevel::Strict).expand(true);
    let device = match svd_parser::parse_with_config(&text, &strict) {
        Ok(device) => device,
        Err(error) => panic!("{}: {error:#}", model.names.id),
    };
    let peripheral = device.peripherals.first().expect("a peripheral");
    assert_eq!(peripheral.base_address, model.instances.first().map_or(0, |instance| instance.base));
    let mut registers: HashMap<Place, RegisterInfo> = HashMap::new();
    for register in peripheral.all_registers() {
        let place = (u64::from(register.address_offset), register.alternate_group.clone());
        let name = register.name.clone();
        let before = registers.insert(place, (**register).clone());
        assert!(before.is_none(), "{name} stands where {:?} stands", before.map(|other| other.name));
    }
    let mut compared = 0;
    for placed in model.instances_of_registers() {
        let register = model.register(placed.register);
        let group = register.window.map(|window| model.windows[window.0].name.clone());
        let found = registers.remove(&(placed.offset, group.clone()));
        let found = found.unwrap_or_else(|| panic!("{} is missing at {:#x}", placed.label(model), placed.offset));
        compared += one(model, placed, &found);
        for alias in model.aliases.iter().filter(|_| register.aliased) {
            let found = registers.remove(&(placed.offset + alias.offset, group.clone()));
            let found = found.unwrap_or_else(|| panic!("{}{} is missing", placed.label(model), alias.name));
            let effect = match alias.op {
                AliasOp::Clear => ModifiedWriteValues::OneToClear,
                AliasOp::Set => ModifiedWriteValues::OneToSet,
                AliasOp::Invert => ModifiedWriteValues::OneToToggle,
            };
            assert_eq!(found.modified_write_values, Some(effect), "{}", found.name);
            assert_eq!(found.properties.access, Some(Access::WriteOnly), "{}", found.name);
            let bits: u64 = found.fields().map(|field| field.bitmask()).fold(0, |all, bits| all | bits);
            assert_eq!(bits, register.writable_bits(), "{}", found.name);
        }
    }
    let left: Vec<&String> = registers.values().map(|register| &register.name).collect();
    assert!(left.is_empty(), "registers that the model has not: {left:?}");
    compared
}

fn one(model: &Model, placed: Placed, found: &RegisterInfo) -> usize {
    let register = model.register(placed.register);
    let label = placed.label(model);
    assert_eq!(found.properties.size, Some(register.width), "{label}: width");
    let mut fields: HashMap<u32, FieldInfo> = found.fields().map(|field| (field.lsb(), (**field).clone())).collect();
    let mut compared = 0;
    for field in &register.fields {
        for lane in 0..field.lane_count() {
            let lsb = field.lsb + lane * field.lanes.map_or(0, |lanes| lanes.stride);
            let what = format!("{label}.{}", field.label_of(placed.position(model), lane));
            let found_field = fields.remove(&lsb).unwrap_or_else(|| panic!("{what} is missing at bit {lsb}"));
            same(field, &found_field, &what);
            if register.cluster.is_none() {
                let name: String = what[label.len() + 1..].chars().filter(char::is_ascii_alphanumeric).collect();
                let svd_name: String = found_field.name.chars().filter(char::is_ascii_alphanumeric).collect();
                assert_eq!(svd_name, name, "{what}: name");
            }
            let mask = bit_mask(0, field.width) << lsb;
            let known = found.properties.reset_mask.unwrap_or(0) & mask;
            assert_eq!(known, mask & !register.reset.unknown, "{what}: known bits of the reset");
            let reset = found.properties.reset_value.unwrap_or(0) & known;
            assert_eq!(reset, register.reset.value & known, "{what}: reset");
            compared += 1;
        }
    }
    assert!(
        fields.is_empty(),
        "{label}: fields that the model has not: {:?}",
        fields.values().map(|f| &f.name).collect::<Vec<_>>()
    );
    compared
}

/// Width, access and effects of one field. The table is written out here once more, so that a slip in the emitter's
/// own shows.
fn same(field: &Field, found: &FieldInfo, what: &str) {
    use {AccessCode as Code, ModifiedWriteValues as Write};
    assert_eq!(found.bit_width(), field.width, "{what}: width");
    let (access, write) = match field.access.code {
        Code::Rw | Code::Rwh => (Access::ReadWrite, None),
        Code::Ro => (Access::ReadOnly, None),
        Code::Wo => (Access::WriteOnly, None),
        Code::W1c => (Access::ReadWrite, Some(Write::OneToClear)),
        Code::W0c => (Access::ReadWrite, Some(Write::ZeroToClear)),
        Code::W1s => (Access::ReadWrite, Some(Write::OneToSet)),
        Code::Rwhc => (Access::ReadWrite, Some(Write::Modify)),
        Code::Wclr if field.access.loads.is_some() => (Access::ReadWrite, Some(Write::Modify)),
        Code::Wclr => (Access::ReadWrite, Some(Write::Clear)),
    };
    assert_eq!(found.access, Some(access), "{what}: access");
    assert_eq!(found.modified_write_values, write, "{what}: modifiedWriteValues");
    let read = field.access.on_read.map(|OnRead { effect, .. }| match effect {
        ReadEffect::Clear => ReadAction::Clear,
        ReadEffect::Set => ReadAction::Set,
    });
    assert_eq!(found.read_action, read, "{what}: readAction");
    for values in &found.enumerated_values {
        for value in &values.values {
            assert!(value.value.is_some_and(|value| value <= field.capacity()), "{what}: {} does not fit", value.name);
        }
    }
}
