//! Peripherals: one for each known instance, and the registers in the first of them.

use regdef::model::{ClusterId, Instance, Model, RegisterId, Target};
use svd_rs::{AddressBlock, AddressBlockUsage, ClusterInfo, Interrupt, Peripheral, PeripheralInfo, RegisterCluster};

use super::enums::Shared;
use super::{At, Error, LEVEL, alias, join, name, offset32, plain, register};
use crate::text;

pub(super) fn all(model: &Model, shared: &mut Shared) -> Result<Vec<Peripheral>, Error> {
    let block = AddressBlock::builder()
        .offset(0)
        .size(offset32("span", model.span)?)
        .usage(AddressBlockUsage::Registers)
        .build(LEVEL)
        .at("span")?;
    let first_name =
        model.instances.first().map_or_else(|| name::identifier(&model.names.ident.upper), peripheral_name);
    shared.begin(&first_name);
    let first = PeripheralInfo::builder()
        .name(first_name.clone())
        .group_name(Some(name::identifier(&model.names.ident.upper)))
        .address_block(Some(vec![block]))
        .registers(Some(registers(model, shared)?));
    if model.instances.is_empty() {
        let at = "The base address depends on the chip and is 0 here.";
        let text = join(vec![text::sentence(&model.title), at.to_owned()]);
        let info = first.description(Some(text)).base_address(0).build(LEVEL).at(&first_name)?;
        return Ok(vec![Peripheral::Single(info)]);
    }
    let mut peripherals: Vec<Peripheral> = Vec::new();
    for (index, instance) in model.instances.iter().enumerate() {
        let at = peripheral_name(instance);
        let builder = match index {
            0 => first.clone(),
            _ => PeripheralInfo::builder().name(at.clone()).derived_from(Some(first_name.clone())),
        };
        let same = model.instances[..index].iter().find(|earlier| earlier.base == instance.base);
        let info = builder
            .description(Some(described(instance)))
            .base_address(instance.base)
            .alternate_peripheral(same.map(peripheral_name))
            .interrupt(Some(interrupts(instance, &at)?))
            .build(LEVEL)
            .at(&at)?;
        peripherals.push(Peripheral::Single(info));
    }
    Ok(peripherals)
}

fn peripheral_name(instance: &Instance) -> String {
    name::identifier(&instance.name)
}

fn described(instance: &Instance) -> String {
    let mut sentences =
        vec![format!("{} of {}.", instance.name, instance.chips.join(", ")), text::sentence(&instance.doc)];
    if let Some(memory) = instance.memory {
        sentences.push(format!("Message memory at {memory:#x}."));
    }
    sentences.push(text::sentence(&text::cites(&instance.cites)));
    join(sentences)
}

fn interrupts(instance: &Instance, peripheral: &str) -> Result<Vec<Interrupt>, Error> {
    let one = |(line, number): &(String, u64)| {
        let at = name::identifier(&format!("{peripheral}_{line}"));
        Interrupt::builder()
            .name(at.clone())
            .description(Some(plain(&format!("Line {line} of {peripheral}."))))
            .value(offset32(&at, *number)?)
            .build(LEVEL)
            .at(&at)
    };
    instance.interrupts.iter().map(one).collect()
}

/// Registers, alias registers and clusters in order of address.
fn registers(model: &Model, shared: &mut Shared) -> Result<Vec<RegisterCluster>, Error> {
    let mut order: Vec<(u64, Item)> =
        model.block_registers().filter_map(|(id, r)| r.offset.map(|offset| (offset, Item::Register(id)))).collect();
    order.extend(model.clusters.iter().enumerate().map(|(i, c)| (c.offset, Item::Cluster(ClusterId(i)))));
    order.sort_by_key(|(offset, _)| *offset);
    let mut members = Vec::new();
    for (_, item) in order {
        match item {
            Item::Register(id) => add_register(model, shared, id, &mut members)?,
            Item::Cluster(id) => members.push(cluster(model, shared, id)?),
        }
    }
    Ok(members)
}

enum Item {
    Register(RegisterId),
    Cluster(ClusterId),
}

fn add_register(
    model: &Model,
    shared: &mut Shared,
    id: RegisterId,
    members: &mut Vec<RegisterCluster>,
) -> Result<(), Error> {
    for place in register::places(model.register(id))? {
        members.push(RegisterCluster::Register(register::build(model, shared, id, &place)?));
        for of in model.aliases.iter().filter(|_| model.register(id).aliased) {
            members.push(RegisterCluster::Register(alias::build(model, id, &place, of)?));
        }
    }
    Ok(())
}

fn cluster(model: &Model, shared: &mut Shared, id: ClusterId) -> Result<RegisterCluster, Error> {
    let cluster = &model.clusters[id.0];
    let (name, dim) = name::array(&cluster.name, &cluster.dim)?;
    let mut members = Vec::new();
    shared.enter(&name, false);
    for (register, _) in model.cluster_registers(id) {
        add_register(model, shared, register, &mut members)?;
    }
    shared.leave();
    let mut sentences = vec![text::sentence(&cluster.title), text::sentence(&cluster.doc)];
    sentences.push(text::conflicts(model, |target| *target == Target::Cluster(id)));
    sentences.push(text::sentence(&text::cites(&cluster.cites)));
    let info = ClusterInfo::builder()
        .name(name)
        .description(Some(join(sentences)))
        .address_offset(offset32(&cluster.name, cluster.offset)?)
        .children(members)
        .build(LEVEL)
        .at(&cluster.name)?;
    Ok(RegisterCluster::Cluster(info.array(dim)))
}
