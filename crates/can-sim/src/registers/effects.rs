//! What states of the registers do to other registers.

use regbus::meta::{Effect, Expr, FieldRef, Index};

use super::{FieldAt, RegisterFile, Slot, conditions};

/// One effect for one number that `[n]` can stand for.
#[derive(Clone, Debug)]
struct Instance {
    effect: &'static Effect,
    own: Option<u32>,
}

/// The effects of a description, and which registers each depends on.
#[derive(Clone, Debug, Default)]
pub(super) struct Effects {
    instances: Vec<Instance>,
    /// Per register: effects to look at when it changes.
    touched: Vec<Vec<u16>>,
    /// Per effect: its condition held when it was looked at last.
    held: Vec<bool>,
    work: Vec<Slot>,
    running: bool,
}

/// Register changes that one write may cause before the description is called contradictory.
const LIMIT: usize = 10_000;

impl Effects {
    pub(super) fn new(file: &RegisterFile) -> Self {
        let mut effects = Self { touched: vec![Vec::new(); file.values.len()], ..Self::default() };
        for effect in file.meta.effects {
            let expr = &file.meta.conditions[effect.on as usize].expr;
            for own in numbers(file, conditions::own_field(expr).or_else(|| clustered(file, expr))) {
                effects.add(file, effect, own);
            }
        }
        effects.held = vec![false; effects.instances.len()];
        effects
    }

    fn add(&mut self, file: &RegisterFile, effect: &'static Effect, own: Option<u32>) {
        let index = self.instances.len() as u16;
        let mut slots = Vec::new();
        let mut fields = Vec::new();
        conditions::fields(&file.meta.conditions[effect.on as usize].expr, &mut fields);
        slots.extend(fields.iter().filter_map(|(field, at)| file.numbered(*field, *at, own)).map(FieldAt::slot));
        if effect.holds {
            let targets = effect.resets_fields.iter().chain(effect.sets.iter().map(|(field, _)| field));
            let moved = effect.loads.iter().flat_map(|(target, origin)| [target, origin]);
            let registers = targets.chain(moved).map(|field| field.register).chain(effect.resets.iter().copied());
            slots.extend(registers.flat_map(|register| file.elements(register, own)));
        }
        slots.sort_unstable();
        slots.dedup();
        for slot in slots {
            self.touched[slot.0 as usize].push(index);
        }
        self.instances.push(Instance { effect, own });
    }
}

/// A field of a cluster in an expression: what it says is meant of every element by itself.
fn clustered(file: &RegisterFile, expr: &Expr) -> Option<FieldRef> {
    let mut found = Vec::new();
    conditions::fields(expr, &mut found);
    let of_cluster = |field: &FieldRef| file.meta.registers[field.register as usize].cluster.is_some();
    found.into_iter().map(|(field, _)| field).find(of_cluster)
}

/// The numbers that a field with an own number can have.
fn numbers(file: &RegisterFile, field: Option<FieldRef>) -> Vec<Option<u32>> {
    let Some(field) = field else { return vec![None] };
    let info = &file.meta.registers[field.register as usize];
    let of = file.field_info(field);
    let (first, count) = if of.lanes > 1 {
        (u32::from(of.first_lane), u32::from(of.lanes) * info.array.map_or(1, |a| a.count))
    } else {
        let array = info.cluster.or(info.array);
        array.map_or((0, 1), |array| (array.first, array.count))
    };
    (first..first + count).map(Some).collect()
}

impl RegisterFile {
    /// After a reset: states that hold now have no edge, those that are held act.
    pub(super) fn restart_effects(&mut self) {
        for index in 0..self.effects.instances.len() {
            let Instance { effect, own } = self.effects.instances[index].clone();
            self.effects.held[index] = self.holds(effect.on, own);
        }
        for slot in self.slots() {
            self.changed(slot);
        }
    }

    /// A register has changed: carries out what follows, until nothing changes any more.
    ///
    /// # Panics
    /// If effects undo each other for ever: the description contradicts itself.
    pub(super) fn changed(&mut self, slot: Slot) {
        if self.effects.touched[slot.0 as usize].is_empty() {
            return;
        }
        self.effects.work.push(slot);
        if core::mem::replace(&mut self.effects.running, true) {
            return;
        }
        let mut steps = 0;
        while let Some(slot) = self.effects.work.pop() {
            steps += 1;
            assert!(steps < LIMIT, "the effects of {} undo each other at {}", self.meta.name, self.name(slot));
            for at in 0..self.effects.touched[slot.0 as usize].len() {
                let index = self.effects.touched[slot.0 as usize][at];
                self.look_at(index as usize);
            }
        }
        self.effects.running = false;
    }

    fn look_at(&mut self, index: usize) {
        let (effect, own) = (self.effects.instances[index].effect, self.effects.instances[index].own);
        let holds = self.holds(effect.on, own);
        let held = core::mem::replace(&mut self.effects.held[index], holds);
        if !holds || (held && !effect.holds) {
            return;
        }
        for register in effect.resets {
            for slot in self.elements(*register, own) {
                let value = self.reset_value(slot);
                self.set(slot, value);
            }
        }
        for field in effect.resets_fields {
            for at in self.targets(*field, own) {
                let value = self.reset_value(at.slot) >> at.lsb;
                self.set_field(at, value);
            }
        }
        for (target, origin) in effect.loads {
            let value = self.field(self.target(*origin, own));
            self.set_field(self.target(*target, own), value);
        }
        for (field, value) in effect.sets {
            for at in self.targets(*field, own) {
                self.set_field(at, *value);
            }
        }
    }

    /// Where an effect acts: on the element or lane with the number that `[n]` stands for in its condition, and in all
    /// elements where the condition has none.
    fn targets(&self, field: FieldRef, own: Option<u32>) -> impl Iterator<Item = FieldAt> + use<> {
        let first = self.target(field, own);
        let (own, info) = (own.map(|_| first), self.field_info(field));
        let elements = self.elements(field.register, None).map(move |slot| FieldAt { slot, ..first });
        debug_assert!(own.is_some() || info.lanes == 1, "{} has lanes and no number", info.name);
        own.into_iter().chain(elements.filter(move |_| own.is_none()))
    }

    /// The elements of a register: the one with the number that `[n]` stands for, all of them without a number.
    fn elements(&self, register: u16, own: Option<u32>) -> impl Iterator<Item = Slot> + use<> {
        let info = &self.meta.registers[register as usize];
        let first = self.first[register as usize];
        // Where a register has lanes, the number is that of a lane.
        let numbered = info.fields.iter().all(|field| field.lanes == 1);
        let one = match (info.cluster.or(info.array), own) {
            (Some(array), Some(own)) if numbered && info.count() == array.count => own.checked_sub(array.first),
            _ => None,
        };
        let (from, count) = one.filter(|one| *one < info.count()).map_or((0, info.count()), |one| (one, 1));
        (from..from + count).map(move |element| Slot(first + element as u16))
    }

    /// Of a repeated field on the one with the number that `[n]` stands for.
    fn target(&self, field: FieldRef, own: Option<u32>) -> FieldAt {
        let numbered = own.and_then(|_| self.numbered(field, Index::Own, own));
        numbered.unwrap_or_else(|| self.field_at(field))
    }
}
