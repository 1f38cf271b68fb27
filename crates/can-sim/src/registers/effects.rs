//! What states of the registers do to other registers.

use regbus::meta::{Effect, FieldRef, Index};

use super::{FieldAt, RegisterFile, Slot, conditions};

/// One effect for one number that `[n]` can stand for.
#[derive(Clone, Copy, Debug)]
struct Instance {
    effect: &'static Effect,
    own: Option<u32>,
    /// The element of its cluster that an effect of one element's state concerns.
    element: Option<u32>,
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
            let clustered = clustered(file, expr);
            for own in numbers(file, conditions::own_field(expr).or(clustered)) {
                let first = clustered.and_then(|field| file.meta.registers[field.register as usize].cluster);
                let element = first.zip(own).map(|(cluster, own)| own - cluster.first);
                effects.add(file, effect, own, element);
            }
        }
        effects.held = vec![false; effects.instances.len()];
        effects
    }

    fn add(&mut self, file: &RegisterFile, effect: &'static Effect, own: Option<u32>, element: Option<u32>) {
        let index = self.instances.len() as u16;
        let mut slots = Vec::new();
        let mut fields = Vec::new();
        conditions::fields(&file.meta.conditions[effect.on as usize].expr, &mut fields);
        slots.extend(fields.iter().filter_map(|(field, at)| file.numbered(*field, *at, own)).map(FieldAt::slot));
        if effect.holds {
            let targets = effect.resets_fields.iter().chain(effect.sets.iter().map(|(field, _)| field));
            let moved = effect.loads.iter().flat_map(|(target, origin)| [target, origin]);
            let registers = targets.chain(moved).map(|field| field.register);
            let registers = registers.chain(effect.resets.iter().copied());
            slots.extend(registers.flat_map(|register| file.concerned(register, element)));
        }
        slots.sort_unstable();
        slots.dedup();
        for slot in slots {
            self.touched[slot.0 as usize].push(index);
        }
        self.instances.push(Instance { effect, own, element });
    }
}

/// A field of a cluster in an expression: what it says is meant of every element by itself.
fn clustered(file: &RegisterFile, expr: &regbus::meta::Expr) -> Option<FieldRef> {
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
            let Instance { effect, own, .. } = self.effects.instances[index];
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

    /// The registers that an effect of one element of a cluster, or of anything else, concerns.
    fn concerned(&self, register: u16, element: Option<u32>) -> impl Iterator<Item = Slot> + use<> {
        let info = &self.meta.registers[register as usize];
        let inners = info.array.map_or(1, |array| array.count) as u16;
        let first = self.first[register as usize];
        let (first, count) = match element.filter(|_| info.cluster.is_some()) {
            Some(element) => (first + element as u16 * inners, inners),
            None => (first, info.count() as u16),
        };
        (first..first + count).map(Slot)
    }

    fn look_at(&mut self, index: usize) {
        let Instance { effect, own, element } = self.effects.instances[index];
        let holds = self.holds(effect.on, own);
        let held = core::mem::replace(&mut self.effects.held[index], holds);
        if !holds || (held && !effect.holds) {
            return;
        }
        for register in effect.resets {
            for slot in self.concerned(*register, element) {
                let value = self.reset_value(slot);
                self.set(slot, value);
            }
        }
        for field in effect.resets_fields {
            if own.is_some() && element.is_none() {
                let at = self.target(*field, own);
                let value = self.reset_value(at.slot) >> at.lsb;
                self.set_field(at, value);
                continue;
            }
            let bits = self.field_info(*field).all();
            for slot in self.concerned(field.register, element) {
                let value = self.get(slot) & !bits | self.reset_value(slot) & bits;
                self.set(slot, value);
            }
        }
        for (target, origin) in effect.loads {
            let value = self.field(self.target(*origin, own));
            self.set_field(self.target(*target, own), value);
        }
        for (field, value) in effect.sets {
            self.set_field(self.target(*field, own), *value);
        }
    }

    /// Where an effect acts: of a repeated field on the one with the number that `[n]` stands for.
    fn target(&self, field: FieldRef, own: Option<u32>) -> FieldAt {
        let numbered = own.and_then(|_| self.numbered(field, Index::Own, own));
        numbered.unwrap_or_else(|| self.field_at(field))
    }
}
