//! What a description says of a register, worked out from its fields bit by bit, in another way than the storage does it.

use can_sim::registers::{RegisterFile, Slot};
use regbus::meta::{Access, Controller, Expr, Field, FieldRef, Index, RegisterInfo};

/// One register of a controller: which of its description, which element of its cluster and of its array.
#[derive(Clone, Copy)]
pub struct At {
    pub info: &'static RegisterInfo,
    pub element: u32,
    pub inner: u32,
}

impl At {
    pub fn slot(self, file: &RegisterFile) -> Slot {
        file.find(self.info.name, self.element, self.inner).unwrap()
    }

    /// The number that `[n]` stands for at a lane.
    pub fn own_number(self, field: &Field, lane: u8) -> u32 {
        if field.lanes > 1 {
            return u32::from(field.first_lane) + u32::from(lane) + self.inner * u32::from(field.lanes);
        }
        match (self.info.cluster, self.info.array) {
            (Some(cluster), _) => cluster.first + self.element,
            (None, Some(array)) => array.first + self.inner,
            (None, None) => 0,
        }
    }

    /// The bits of the fields that `choose` takes.
    pub fn bits(self, choose: impl Fn(&Field) -> bool) -> u32 {
        self.info.fields.iter().filter(|field| choose(field)).fold(0, |mask, field| mask | field.all())
    }

    /// Every lane of every field.
    pub fn lanes(self) -> impl Iterator<Item = (&'static Field, u8)> {
        self.info.fields.iter().flat_map(|field| (0..field.lanes).map(move |lane| (field, lane)))
    }
}

/// Every register of a description.
pub fn registers(meta: &'static Controller) -> impl Iterator<Item = At> {
    meta.registers.iter().flat_map(|info| {
        let inners = info.array.map_or(1, |array| array.count);
        let elements = info.cluster.map_or(1, |cluster| cluster.count);
        (0..elements * inners).map(move |n| At { info, element: n / inners, inner: n % inners })
    })
}

/// The register and the lane that a field with an index means.
pub fn find(meta: &'static Controller, at: FieldRef, index: Index, own: u32) -> (At, &'static Field, u8) {
    let info = &meta.registers[at.register as usize];
    let field = &info.fields[at.field as usize];
    let number = match index {
        Index::Single => return (At { info, element: 0, inner: 0 }, field, 0),
        Index::Own => own,
        Index::Fixed(number) => number,
    };
    let mut all = registers(meta)
        .filter(|at| core::ptr::eq(at.info, info))
        .flat_map(|at| (0..field.lanes).map(move |lane| (at, lane)));
    let (at, lane) = all.find(|(at, lane)| at.own_number(field, *lane) == number).expect("the loader checks numbers");
    (at, field, lane)
}

pub fn value(file: &RegisterFile, at: FieldRef, index: Index, own: u32) -> u32 {
    let (at, field, lane) = find(file.meta(), at, index, own);
    field.get(file.get(at.slot(file)), lane)
}

pub fn holds(file: &RegisterFile, condition: Option<u16>, own: u32) -> bool {
    let Some(condition) = condition else { return true };
    file.meta().conditions[condition as usize].expr.holds(&mut |field, index| value(file, field, index, own))
}

/// One bit of a register after a write of `data`, in which the operation of an alias register is worked out already.
fn bit_after(file: &RegisterFile, at: At, bit: u32, data: u32, lanes: u32) -> bool {
    let old = file.get(at.slot(file)) >> bit & 1 == 1;
    let one = data >> bit & 1 == 1;
    let Some((field, lane)) = at.lanes().find(|(field, lane)| field.mask(*lane) >> bit & 1 == 1) else { return old };
    let own = at.own_number(field, lane);
    if !holds(file, field.when, own) {
        return old;
    }
    if field.access == Access::Wclr {
        let from = field.loads.map_or(0, |at| value(file, at, Index::Single, 0));
        return from >> (bit - u32::from(field.lsb)) & 1 == 1;
    }
    if lanes >> bit & 1 == 0 {
        return old;
    }
    let new = match field.access {
        Access::Ro | Access::Wclr => old,
        Access::Rw | Access::Wo | Access::Rwh | Access::Rwhc => one,
        Access::W1c => old && !one,
        Access::W0c => old && one,
        Access::W1s => old || one,
    };
    if holds(file, field.set_when, own) { new } else { new && old }
}

/// A register after a write of the bytes that `lanes` masks.
pub fn after_write(file: &RegisterFile, at: At, data: u32, lanes: u32) -> u32 {
    let bits = (0..u32::from(at.info.width)).filter(|bit| bit_after(file, at, *bit, data, lanes));
    bits.fold(0, |word, bit| word | 1 << bit)
}

/// The field values that make an expression true, or false: the first way there is.
pub fn way(expr: &Expr, holds: bool) -> Vec<(FieldRef, Index, Compared)> {
    match *expr {
        Expr::Always => {
            assert!(holds, "a condition that always holds cannot be made false");
            Vec::new()
        }
        Expr::Compare { field, index, comparison, value } => {
            vec![(field, index, Compared { comparison, value, holds })]
        }
        Expr::Word { .. } => panic!("a condition on a message's word is no write condition"),
        Expr::Not(inner) => way(inner, !holds),
        Expr::All(of) if holds => of.iter().flat_map(|expr| way(expr, true)).collect(),
        Expr::Any(of) if !holds => of.iter().flat_map(|expr| way(expr, false)).collect(),
        Expr::All(of) | Expr::Any(of) => way(&of[0], holds),
    }
}

/// What a field has to be.
#[derive(Clone, Copy)]
pub struct Compared {
    comparison: regbus::meta::Comparison,
    value: u32,
    holds: bool,
}

impl Compared {
    /// The smallest value of a field that is as it has to be.
    pub fn value(self, field: &Field) -> u32 {
        let mut values = 0..=regbus::bits::mask(u32::from(field.width));
        values
            .find(|value| self.comparison.holds(*value, self.value) == self.holds)
            .expect("a comparison can be met and missed")
    }
}
