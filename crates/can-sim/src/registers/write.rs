//! What a write does to each bit of a register.

use regbus::meta::{Access, AliasOp, Controller, Field, FieldRef, RegisterInfo};

use super::{RegisterFile, Slot, conditions::own_field};

/// A write of the host while it is carried out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WriteAccess {
    /// The register.
    pub slot: Slot,
    /// Mask of the bytes that are written.
    pub lanes: u32,
    /// The operation, for a write through an alias register.
    pub alias: Option<AliasOp>,
    /// What the host wrote, in place; bytes that are not written are 0.
    pub written: u32,
    /// The value before.
    pub old: u32,
    /// The value after, as the access rules say. A model may change it before it is stored.
    pub new: u32,
    /// Bits that the host tried to change and could not.
    pub refused: Option<WriteRefused>,
}

impl WriteAccess {
    /// The bits that were written as 1.
    #[must_use]
    pub const fn ones(&self) -> u32 {
        self.written & self.lanes
    }
}

/// A part of a write that its condition forbade.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WriteRefused {
    /// The bits.
    pub bits: u32,
    /// The condition that does not hold: index into the controller's conditions.
    pub condition: u16,
}

/// Bits of a register that behave alike.
#[derive(Clone, Debug)]
struct Group {
    access: Access,
    mask: u32,
    when: Option<u16>,
    set_when: Option<u16>,
    /// Field and lane that give the own number.
    field: u16,
    lane: u8,
    loads: Option<FieldRef>,
}

/// What a write does to a register, from its description.
#[derive(Clone, Debug)]
pub(super) struct WritePlan {
    groups: Vec<Group>,
}

impl WritePlan {
    pub(super) fn new(meta: &Controller, info: &RegisterInfo) -> Self {
        let own = |condition: Option<u16>| {
            condition.is_some_and(|at| own_field(&meta.conditions[at as usize].expr).is_some())
        };
        let mut groups: Vec<Group> = Vec::new();
        for (index, field) in info.fields.iter().enumerate() {
            let apart = field.lanes > 1 && (own(field.when) || own(field.set_when));
            for lane in 0..field.lanes {
                let same = |group: &&mut Group| {
                    let rule = (group.access, group.when, group.set_when, group.loads);
                    rule == (field.access, field.when, field.set_when, field.loads)
                        && field.access != Access::Wclr
                        && !apart
                };
                match groups.iter_mut().find(same) {
                    Some(group) => group.mask |= field.mask(lane),
                    None => groups.push(Group {
                        access: field.access,
                        mask: field.mask(lane),
                        when: field.when,
                        set_when: field.set_when,
                        field: index as u16,
                        lane,
                        loads: field.loads,
                    }),
                }
            }
        }
        Self { groups }
    }
}

impl RegisterFile {
    /// Works out a write of the bytes that `lanes` masks, without storing anything. Through an alias register the
    /// written bits clear, set or invert those of the register.
    #[must_use]
    pub fn plan_write(&self, slot: Slot, lanes: u32, written: u32, alias: Option<AliasOp>) -> WriteAccess {
        let old = self.get(slot);
        let written = written & lanes;
        let data = match alias {
            None => written,
            Some(AliasOp::Clear) => old & !written,
            Some(AliasOp::Set) => old | written,
            Some(AliasOp::Invert) => old ^ written,
        };
        let mut access = WriteAccess { slot, lanes, alias, written, old, new: old, refused: None };
        let info = self.info(slot);
        let plan = &self.plans[self.physical[slot.0 as usize].register as usize];
        for group in &plan.groups {
            let field = &info.fields[group.field as usize];
            self.write_group(group, field, data, &mut access);
        }
        access
    }

    fn write_group(&self, group: &Group, field: &Field, data: u32, access: &mut WriteAccess) {
        let (old, mask) = (access.old, group.mask & access.lanes);
        let proposed = match group.access {
            Access::Ro => return,
            Access::Rw | Access::Wo | Access::Rwh | Access::Rwhc => old & !mask | data & mask,
            Access::W1c => old & !(data & mask),
            Access::W0c => old & (data | !mask),
            Access::W1s => old | data & mask,
            // Any write counts, also one to a byte that holds no bit of the field.
            Access::Wclr => old & !group.mask | self.preset(group.loads) << field.lsb & group.mask,
        };
        let own = || self.own_number(access.slot, field, group.lane);
        let refuse = |bits: u32, condition: u16, access: &mut WriteAccess| {
            if bits != 0 && access.refused.is_none() {
                access.refused = Some(WriteRefused { bits, condition });
            }
        };
        let mut accepted = proposed;
        if let Some(condition) = group.when
            && !self.holds(condition, own())
        {
            refuse((proposed ^ old) & group.mask, condition, access);
            return;
        }
        if let Some(condition) = group.set_when
            && !self.holds(condition, own())
        {
            accepted &= old | !group.mask;
            refuse((proposed ^ accepted) & group.mask, condition, access);
        }
        access.new = access.new & !group.mask | accepted & group.mask;
    }

    fn preset(&self, loads: Option<FieldRef>) -> u32 {
        loads.map_or(0, |field| self.field(self.field_at(field)))
    }

    /// Stores the outcome of a write.
    pub fn commit(&mut self, access: &WriteAccess) {
        self.set(access.slot, access.new);
    }
}
