//! Interrupt lines: flags, enables and line selection as the description says.

use super::{FieldAt, RegisterFile, Slot};

/// Sources of one line whose flags, enables and selections stand in the same bits of three registers.
#[derive(Clone, Debug)]
struct Group {
    flags: Slot,
    enables: Option<Slot>,
    selects: Option<Slot>,
    mask: u32,
}

#[derive(Clone, Debug)]
struct Line {
    enable: Option<FieldAt>,
    /// Flips a selection register so that a 1 means this line.
    invert: u32,
    groups: Vec<Group>,
    /// Sources whose bits do not line up.
    others: Vec<Source>,
}

#[derive(Clone, Debug)]
struct Source {
    flag: FieldAt,
    enable: Option<FieldAt>,
    /// The selection, and its value for this line.
    select: Option<(FieldAt, u32)>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    lines: Vec<Line>,
}

impl Lines {
    pub(super) fn new(file: &RegisterFile) -> Self {
        let meta = file.meta();
        let line = |(index, line): (usize, &regbus::meta::InterruptLine)| {
            let mut built = Line {
                enable: line.enable.map(|field| file.field_at(field)),
                invert: if line.select == Some(0) { u32::MAX } else { 0 },
                groups: Vec::new(),
                others: Vec::new(),
            };
            let reaches = |source: &&regbus::meta::InterruptSource| source.lines.contains(&(index as u16));
            for source in meta.interrupts.iter().filter(reaches) {
                let flag = file.field_at(source.flag);
                let enable = source.enable.map(|field| file.field_at(field));
                let select = source.select.map(|field| file.field_at(field));
                built.add(flag, enable, select, line.select);
            }
            built
        };
        Self { lines: meta.lines.iter().enumerate().map(line).collect() }
    }

    #[inline]
    pub(super) fn active(&self, file: &RegisterFile) -> u32 {
        let mut active = 0;
        for (index, line) in self.lines.iter().enumerate() {
            let enabled = line.enable.is_none_or(|enable| file.is_set(enable));
            active |= u32::from(enabled && line.is_requested(file)) << index;
        }
        active
    }

    pub(super) fn unrouted(&self, file: &RegisterFile, flags: Slot) -> u32 {
        let mut asking = 0;
        let mut heard = 0;
        for line in &self.lines {
            for group in line.groups.iter().filter(|group| group.flags == flags) {
                let bits = group.requested(file, line.invert);
                asking |= bits;
                if line.enable.is_none_or(|enable| file.is_set(enable)) {
                    heard |= bits;
                }
            }
        }
        asking & !heard
    }
}

impl Group {
    #[inline]
    fn requested(&self, file: &RegisterFile, invert: u32) -> u32 {
        let enables = self.enables.map_or(u32::MAX, |slot| file.get(slot));
        let selects = self.selects.map_or(u32::MAX, |slot| file.get(slot) ^ invert);
        file.get(self.flags) & enables & selects & self.mask
    }
}

impl Line {
    fn add(&mut self, flag: FieldAt, enable: Option<FieldAt>, select: Option<FieldAt>, value: Option<u32>) {
        let bits = flag.bits();
        let aligned = bits.is_power_of_two()
            && enable.is_none_or(|enable| enable.bits() == bits)
            && select.is_none_or(|select| select.bits() == bits);
        if !aligned {
            self.others.push(Source { flag, enable, select: select.zip(value) });
            return;
        }
        let (flags, enables, selects) = (flag.slot(), enable.map(FieldAt::slot), select.map(FieldAt::slot));
        let same = |group: &&mut Group| (group.flags, group.enables, group.selects) == (flags, enables, selects);
        match self.groups.iter_mut().find(same) {
            Some(group) => group.mask |= bits,
            None => self.groups.push(Group { flags, enables, selects, mask: bits }),
        }
    }

    #[inline]
    fn is_requested(&self, file: &RegisterFile) -> bool {
        self.groups.iter().any(|group| group.requested(file, self.invert) != 0)
            || self.others.iter().any(|source| {
                file.is_set(source.flag)
                    && source.enable.is_none_or(|enable| file.is_set(enable))
                    && source.select.is_none_or(|(field, value)| file.field(field) == value)
            })
    }
}
