//! Registers that behave as their description says.
//!
//! A [`RegisterFile`] is built from the generated metadata of a controller and from nothing else: which addresses hold
//! which bits, what they are after reset, what a write of each bit does and under which condition, what a read does,
//! and what states of some registers do to others. A model adds what no table can say.

mod conditions;
mod effects;
mod lines;
mod map;
pub(crate) mod names;
mod write;

use regbus::meta::{Access, Controller, Field, FieldRef, ReadEffect, RegisterInfo};

use effects::Effects;
use lines::Lines;
use map::Map;
pub use map::Place;
use write::WritePlan;
pub use write::{WriteAccess, WriteRefused};

/// One physical register of a [`RegisterFile`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Slot(pub(crate) u16);

/// One field, or one lane of a repeated field, of one physical register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldAt {
    slot: Slot,
    lsb: u8,
    mask: u32,
}

impl FieldAt {
    /// The register.
    #[must_use]
    pub const fn slot(self) -> Slot {
        self.slot
    }

    /// The bits of the field in its register.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.mask << self.lsb
    }
}

/// What bits without a defined reset value hold after a reset.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum UnknownReset {
    /// Zero.
    #[default]
    Zeros,
    /// One.
    Ones,
    /// Bits of a pattern that differs from register to register: the seed is mixed with the register's address, so that
    /// a driver which relies on such bits fails on some seed.
    Pattern(u32),
}

impl UnknownReset {
    fn bits(self, offset: u32) -> u32 {
        match self {
            Self::Zeros => 0,
            Self::Ones => u32::MAX,
            Self::Pattern(seed) => {
                let mixed = (seed ^ offset.rotate_left(16)).wrapping_mul(0x9E37_79B1);
                mixed ^ mixed >> 15
            }
        }
    }
}

/// What a read of a register did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReadAccess {
    /// The register.
    pub slot: Slot,
    /// Mask of the bytes that were read.
    pub lanes: u32,
    /// The value that was read, all bytes of the register.
    pub value: u32,
    /// The value that the read left behind.
    pub left: u32,
}

/// A physical register: which register of the description, which element of its cluster and array.
#[derive(Clone, Copy, Debug)]
struct Physical {
    register: u16,
    element: u32,
    inner: u32,
    offset: Option<u32>,
}

/// The registers of one controller.
#[derive(Clone, Debug)]
pub struct RegisterFile {
    meta: &'static Controller,
    physical: Vec<Physical>,
    first: Vec<u16>,
    values: Vec<u32>,
    resets: Vec<u32>,
    map: Map,
    plans: Vec<WritePlan>,
    reads: Vec<Vec<(u32, u32, bool)>>,
    unreadable: Vec<u32>,
    widths: &'static [u8],
    effects: Effects,
    lines: Lines,
}

impl RegisterFile {
    /// The registers of a controller after its reset.
    ///
    /// # Panics
    /// If the description has more registers than a 16-bit number counts, which its loader refuses.
    #[must_use]
    pub fn new(meta: &'static Controller, unknown: UnknownReset) -> Self {
        let mut physical = Vec::new();
        let mut first = Vec::new();
        for (register, info) in meta.registers.iter().enumerate() {
            first.push(u16::try_from(physical.len()).expect("a controller has fewer than 65,536 registers"));
            for element in 0..info.cluster.map_or(1, |c| c.count) {
                for inner in 0..info.array.map_or(1, |a| a.count) {
                    let offset = info.offset_of(element, inner);
                    physical.push(Physical { register: register as u16, element, inner, offset });
                }
            }
        }
        let mut file = Self {
            meta,
            values: vec![0; physical.len()],
            resets: physical.iter().map(|at| reset_value(meta, at, unknown)).collect(),
            map: Map::new(meta, &first, &physical),
            plans: meta.registers.iter().map(|info| WritePlan::new(meta, info)).collect(),
            reads: meta.registers.iter().map(read_effects).collect(),
            unreadable: meta.registers.iter().map(unreadable).collect(),
            widths: meta.access_widths,
            effects: Effects::default(),
            lines: Lines::default(),
            physical,
            first,
        };
        file.effects = Effects::new(&file);
        file.lines = Lines::new(&file);
        file.reset();
        file
    }

    /// Returns every register to its reset value.
    pub fn reset(&mut self) {
        self.values.copy_from_slice(&self.resets);
        self.restart_effects();
    }

    /// The value of a register after reset, bits without a defined value as chosen.
    #[must_use]
    pub fn reset_value(&self, slot: Slot) -> u32 {
        self.resets[slot.0 as usize]
    }

    /// Allows other access widths in bits than the description, for a choice that a model has.
    pub const fn set_access_widths(&mut self, widths: &'static [u8]) {
        self.widths = widths;
    }

    /// Legal access widths in bits.
    #[must_use]
    pub const fn access_widths(&self) -> &'static [u8] {
        self.widths
    }

    /// The description.
    #[must_use]
    pub const fn meta(&self) -> &'static Controller {
        self.meta
    }

    /// All physical registers, in the order of the description.
    pub fn slots(&self) -> impl Iterator<Item = Slot> + use<> {
        (0..self.values.len() as u16).map(Slot)
    }

    /// The description of a register.
    #[must_use]
    pub fn info(&self, slot: Slot) -> &'static RegisterInfo {
        &self.meta.registers[self.physical[slot.0 as usize].register as usize]
    }

    /// The byte offset of a register; `None` for one that belongs to the device.
    #[must_use]
    pub fn offset(&self, slot: Slot) -> Option<u32> {
        self.physical[slot.0 as usize].offset
    }

    /// The name of a register, elements of arrays with their number.
    #[must_use]
    pub fn name(&self, slot: Slot) -> String {
        let at = self.physical[slot.0 as usize];
        let info = self.info(slot);
        let cluster = info.cluster.map(|c| c.first + at.element);
        let array = info.array.map(|a| a.first + at.inner);
        match (cluster, array) {
            (None, None) => info.name.to_owned(),
            (Some(n), None) | (None, Some(n)) => format!("{}[{n}]", info.name),
            (Some(n), Some(m)) => format!("{}[{n}][{m}]", info.name),
        }
    }

    /// A register by its name in the description, and the numbers of its elements in cluster and array counted from 0.
    #[must_use]
    pub fn find(&self, name: &str, element: u32, inner: u32) -> Option<Slot> {
        let register = self.meta.registers.iter().position(|info| info.name == name)?;
        self.slot_of(register as u16, element, inner)
    }

    fn slot_of(&self, register: u16, element: u32, inner: u32) -> Option<Slot> {
        let info = &self.meta.registers[register as usize];
        let inners = info.array.map_or(1, |a| a.count);
        let elements = info.cluster.map_or(1, |c| c.count);
        (element < elements && inner < inners)
            .then(|| Slot(self.first[register as usize] + (element * inners + inner) as u16))
    }

    /// A field by its name.
    #[must_use]
    pub fn find_field(&self, slot: Slot, name: &str, lane: u8) -> Option<FieldAt> {
        let field = self.info(slot).fields.iter().find(|field| field.name == name)?;
        (lane < field.lanes).then(|| self.at(slot, field, lane))
    }

    fn at(&self, slot: Slot, field: &Field, lane: u8) -> FieldAt {
        FieldAt { slot, lsb: field.lsb_of(lane) as u8, mask: regbus::bits::mask(u32::from(field.width)) }
    }

    /// The field that a reference of the description means: its first lane, in the first register of an array.
    #[must_use]
    pub fn field_at(&self, field: FieldRef) -> FieldAt {
        let slot = Slot(self.first[field.register as usize]);
        self.at(slot, self.field_info(field), 0)
    }

    fn field_info(&self, field: FieldRef) -> &'static Field {
        &self.meta.registers[field.register as usize].fields[field.field as usize]
    }

    /// The value of a register, without any effect.
    #[inline]
    #[must_use]
    pub fn get(&self, slot: Slot) -> u32 {
        self.values[slot.0 as usize]
    }

    /// The value of a field, without any effect.
    #[inline]
    #[must_use]
    pub fn field(&self, at: FieldAt) -> u32 {
        self.values[at.slot.0 as usize] >> at.lsb & at.mask
    }

    /// True if a field is not zero.
    #[inline]
    #[must_use]
    pub fn is_set(&self, at: FieldAt) -> bool {
        self.field(at) != 0
    }

    /// Sets a register from the hardware's side, with what that does to other registers.
    #[inline]
    pub fn set(&mut self, slot: Slot, value: u32) {
        if self.values[slot.0 as usize] != value {
            self.values[slot.0 as usize] = value;
            self.changed(slot);
        }
    }

    /// Sets a field from the hardware's side, with what that does to other registers. Bits that do not fit are dropped.
    #[inline]
    pub fn set_field(&mut self, at: FieldAt, value: u32) {
        let old = self.get(at.slot);
        self.set(at.slot, old & !at.bits() | (value & at.mask) << at.lsb);
    }

    /// Sets a field without any effect on other registers, and without theirs on it: for what shows a pin.
    pub fn poke_field(&mut self, at: FieldAt, value: u32) {
        let register = &mut self.values[at.slot.0 as usize];
        *register = *register & !at.bits() | (value & at.mask) << at.lsb;
    }

    /// What is at a byte offset now, as windows select it.
    #[must_use]
    pub fn place(&self, offset: u32) -> Place {
        self.map.place(offset, self)
    }

    /// Reads the bytes of a register that `lanes` masks, with the side effects of that read.
    #[inline]
    pub fn read(&mut self, slot: Slot, lanes: u32) -> ReadAccess {
        let register = self.physical[slot.0 as usize].register as usize;
        let stored = self.get(slot);
        let mut left = stored;
        for &(trigger, mask, sets) in &self.reads[register] {
            if lanes & trigger != 0 {
                left = if sets { left | mask } else { left & !mask };
            }
        }
        if left != stored {
            self.set(slot, left);
        }
        ReadAccess { slot, lanes, value: stored & !self.unreadable[register], left }
    }

    /// What a read of a register would show, without its side effects.
    #[must_use]
    pub fn peek(&self, slot: Slot) -> u32 {
        self.get(slot) & !self.unreadable[self.physical[slot.0 as usize].register as usize]
    }

    /// Mask of the interrupt lines that are active, bit 0 for the first line of the description.
    #[inline]
    #[must_use]
    pub fn active_lines(&self) -> u32 {
        self.lines.active(self)
    }

    /// The bits of a register whose flags are enabled in the description's sense and reach no enabled line.
    #[must_use]
    pub fn unrouted(&self, slot: Slot) -> u32 {
        self.lines.unrouted(self, slot)
    }
}

fn reset_value(meta: &Controller, at: &Physical, unknown: UnknownReset) -> u32 {
    let info = &meta.registers[at.register as usize];
    let bits = unknown.bits(at.offset.unwrap_or(0)) & info.implemented();
    info.reset & !info.reset_unknown | bits & info.reset_unknown
}

/// Per field with a read effect: the bytes whose read triggers it, its bits, and whether they are set.
fn read_effects(info: &RegisterInfo) -> Vec<(u32, u32, bool)> {
    let trigger = |byte: Option<u8>| byte.map_or(u32::MAX, |byte| 0xFF << (byte * 8));
    let effect = |field: &Field| match field.on_read {
        ReadEffect::None => None,
        ReadEffect::Clear(byte) => Some((trigger(byte), field.all(), false)),
        ReadEffect::Set(byte) => Some((trigger(byte), field.all(), true)),
    };
    info.fields.iter().filter_map(effect).collect()
}

fn unreadable(info: &RegisterInfo) -> u32 {
    let write_only = info.fields.iter().filter(|field| field.access == Access::Wo);
    write_only.fold(0, |mask, field| mask | field.all()) | !info.implemented()
}
