//! Registers, fields and enumerations of the model.

use super::{
    Access, AccessCode, Cite, ClusterId, Encoding, EnumId, FieldRef, Ident, Neutral, ResetKind, WindowId, WriteEffect,
};

/// Repetition: `count` elements `stride` bytes apart, numbered from `first`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dim {
    /// Number of elements.
    pub count: u32,
    /// Distance in bytes.
    pub stride: u64,
    /// The manual's number of the first element.
    pub first: u32,
    /// The manual's own names of the elements; empty where they are the label and a number.
    pub labels: Vec<String>,
}

/// A register, or an array of equal registers.
#[derive(Debug, Clone)]
pub struct Register {
    /// The key in the description: the manual's name without prefix and number.
    pub name: String,
    /// The manual's spelling without prefix; `{n}` stands for the number in an array or cluster.
    pub label: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// Title.
    pub title: String,
    /// What it is for; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
    /// Width in bits: 8, 16 or 32.
    pub width: u32,
    /// Byte offset from the base of the block or of the cluster element; `None` for a register of the device.
    pub offset: Option<u64>,
    /// Repetition of the register itself.
    pub dim: Option<Dim>,
    /// The cluster it belongs to.
    pub cluster: Option<ClusterId>,
    /// The window it is visible in; `None` for all.
    pub window: Option<WindowId>,
    /// Value after reset.
    pub reset: Reset,
    /// The fields in the manual's order.
    pub fields: Vec<Field>,
    /// What generated code may offer.
    pub capabilities: Capabilities,
    /// Why a write needs `unsafe`.
    pub unsafe_write: Option<String>,
    /// Traps.
    pub hazards: Vec<String>,
    /// Alias registers stand beside it.
    pub aliased: bool,
}

/// Value of a register after reset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Reset {
    /// Value of the known bits, 0 in the others.
    pub value: u64,
    /// Bits without a defined value.
    pub unknown: u64,
}

/// What generated code may offer for a register.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Capabilities {
    /// At least one field can be read.
    pub readable: bool,
    /// At least one field can be written.
    pub writable: bool,
    /// A read changes nothing.
    pub pure: bool,
    /// Read-modify-write, or why not.
    pub modify: Result<(), NoModify>,
    /// Bits of write-1-to-clear flags.
    pub one_clears: u64,
    /// Bits of write-0-to-clear flags.
    pub zero_clears: u64,
    /// Bits that a 1 sets or requests and a 0 leaves alone.
    pub one_sets: u64,
    /// Bits that a read-modify-write writes as 0: the neutral value of flags and requests.
    pub neutral_zeros: u64,
    /// Bits that a read-modify-write writes as 1.
    pub neutral_ones: u64,
}

/// Why a register has no read-modify-write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoModify {
    /// It cannot be read and written.
    NotReadWrite,
    /// It holds nothing that is plainly stored: only flags and requests. The names are those of the flags.
    OnlyFlags(Vec<String>),
    /// A read changes the named fields.
    ReadHasEffects(Vec<String>),
    /// The named fields have no neutral write value.
    NoNeutral(Vec<String>),
}

/// A field.
#[derive(Debug, Clone)]
pub struct Field {
    /// The key in the description.
    pub name: String,
    /// The manual's spelling; `{n}` stands for the number of the lane.
    pub label: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// Least significant bit, of lane 0 if there are lanes.
    pub lsb: u32,
    /// Width in bits of one lane.
    pub width: u32,
    /// Repetition inside the register.
    pub lanes: Option<Lanes>,
    /// What it means.
    pub doc: String,
    /// Where it stands: the register's citation, unless it has its own.
    pub cites: Vec<Cite>,
    /// Access rules.
    pub access: Access,
    /// Value after reset, the same for every lane.
    pub reset: FieldReset,
    /// Type of the value.
    pub kind: Kind,
    /// Smallest value that may be programmed.
    pub min: u64,
    /// Largest value that may be programmed.
    pub max: u64,
    /// How the programmed number relates to its meaning.
    pub encoding: Option<Encoding>,
}

/// Repetition of a field inside its register.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lanes {
    /// Number of lanes in one register.
    pub count: u32,
    /// Distance in bits.
    pub stride: u32,
    /// The manual's number of lane 0 in the first register of an array.
    pub first: u32,
}

/// Type of a field's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// One bit.
    Bool,
    /// A number.
    Int,
    /// An enumeration.
    Enum(EnumId),
}

/// Value of a field after reset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldReset {
    /// A value. Lanes can differ; this is lane 0.
    Value(u64),
    /// None to be relied on.
    None(ResetKind),
}

/// An enumeration.
#[derive(Debug, Clone)]
pub struct Enum {
    /// Its name in the description; for one written at a field, made from register and field.
    pub name: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// Whether it stands under `enums`.
    pub shared: bool,
    /// What it is about; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
    /// Width in bits of the widest field that uses it.
    pub width: u32,
    /// Named values in ascending order.
    pub variants: Vec<EnumVariant>,
    /// Values that must not be used, in ascending order; both ends included.
    pub reserved: Vec<(u64, u64)>,
    /// The fields of registers that use it.
    pub used_by: Vec<FieldRef>,
}

/// A named value, or a named run of values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EnumVariant {
    /// Name, lower case with underscores.
    pub name: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// What it means; may be empty.
    pub doc: String,
    /// First value.
    pub first: u64,
    /// Last value; equal to `first` for a single value.
    pub last: u64,
    /// The quantity the value stands for, where it is one.
    pub number: Option<u64>,
}

impl Enum {
    /// The variant that a value belongs to.
    #[must_use]
    pub fn variant(&self, value: u64) -> Option<&EnumVariant> {
        self.variants.iter().find(|v| v.first <= value && value <= v.last)
    }

    /// Every value that the widest field can hold has a name.
    #[must_use]
    pub fn is_total(&self) -> bool {
        let named: u128 = self.variants.iter().map(|v| u128::from(v.last - v.first) + 1).sum();
        named == 1 << self.width.min(64)
    }
}

/// Registers that repeat together.
#[derive(Debug, Clone)]
pub struct Cluster {
    /// The key in the description.
    pub name: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// Title.
    pub title: String,
    /// What it is; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
    /// Byte offset of the first element.
    pub offset: u64,
    /// The repetition.
    pub dim: Dim,
}

/// A register window.
#[derive(Debug, Clone)]
pub struct Window {
    /// The key in the description.
    pub name: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// The field that selects it.
    pub select: FieldRef,
    /// The value that selects it.
    pub value: u64,
    /// What is in it.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// A range of addresses without a register.
#[derive(Debug, Clone)]
pub struct ReservedRange {
    /// First byte offset.
    pub from: u64,
    /// Last byte offset, included.
    pub to: u64,
    /// The window in which it is reserved; `None` for all.
    pub window: Option<WindowId>,
    /// What a read returns, where the manual says.
    pub reads: Option<u64>,
    /// The flag an access sets.
    pub sets: Option<FieldRef>,
    /// What else an access does; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// `count` ones from bit `lsb` up.
#[must_use]
pub const fn bit_mask(lsb: u32, width: u32) -> u64 {
    (if width >= 64 { u64::MAX } else { (1 << width) - 1 }) << lsb
}

impl Register {
    /// The field with a name.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|f| f.name == name)
    }

    /// The manual's name of an element, counted from 0.
    #[must_use]
    pub fn label_of(&self, dim: &Dim, element: u32) -> String {
        let number = dim.first + element;
        match dim.labels.get(element as usize) {
            Some(label) => label.clone(),
            None if self.label.contains("{n}") => self.label.replace("{n}", &number.to_string()),
            None => format!("{}{number}", self.label),
        }
    }

    /// Some field's name changes from one element of the array to the next, because its lanes run on.
    #[must_use]
    pub fn lanes_run_on(&self) -> bool {
        (self.dim.is_some() || self.cluster.is_some()) && self.fields.iter().any(|f| f.lanes.is_some())
    }

    /// Bits that belong to some field.
    #[must_use]
    pub fn implemented(&self) -> u64 {
        self.fields.iter().map(Field::mask).fold(0, |a, b| a | b)
    }

    /// Bits that a field allows software to write.
    #[must_use]
    pub fn writable_bits(&self) -> u64 {
        self.fields.iter().filter(|f| f.access.code.writable()).map(Field::mask).fold(0, |a, b| a | b)
    }
}

impl Field {
    /// Number of lanes; 1 for a field that is not repeated.
    #[must_use]
    pub fn lane_count(&self) -> u32 {
        self.lanes.map_or(1, |l| l.count)
    }

    /// Least significant bit of a lane, counted from 0.
    #[must_use]
    pub fn lane_lsb(&self, lane: u32) -> u32 {
        self.lsb + lane * self.lanes.map_or(0, |l| l.stride)
    }

    /// Mask of one lane.
    #[must_use]
    pub fn lane_mask(&self, lane: u32) -> u64 {
        bit_mask(self.lane_lsb(lane), self.width)
    }

    /// Mask of the whole field, all lanes included.
    #[must_use]
    pub fn mask(&self) -> u64 {
        (0..self.lane_count()).map(|lane| self.lane_mask(lane)).fold(0, |a, b| a | b)
    }

    /// The manual's name of a lane of an element of an array of registers, both counted from 0.
    #[must_use]
    pub fn label_of(&self, element: u32, lane: u32) -> String {
        let Some(lanes) = self.lanes else { return self.label.clone() };
        let number = (lanes.first + element * lanes.count + lane).to_string();
        if self.label.contains("{n}") { self.label.replace("{n}", &number) } else { format!("{}{number}", self.label) }
    }

    /// The enumeration of its values.
    #[must_use]
    pub const fn enumeration(&self) -> Option<EnumId> {
        match self.kind {
            Kind::Enum(id) => Some(id),
            Kind::Bool | Kind::Int => None,
        }
    }

    /// Largest value the bits can hold.
    #[must_use]
    pub fn capacity(&self) -> u64 {
        bit_mask(0, self.width)
    }

    /// Value of a lane in a register's reset.
    #[must_use]
    pub fn reset_of_lane(&self, reset: Reset, lane: u32) -> Option<u64> {
        let mask = self.lane_mask(lane);
        (reset.unknown & mask == 0).then(|| (reset.value & mask) >> self.lane_lsb(lane))
    }
}

impl Capabilities {
    /// Derives what may be offered from the access rules of the fields.
    #[must_use]
    pub fn of(fields: &[Field]) -> Self {
        let names = |pick: &dyn Fn(&Field) -> bool| -> Vec<String> {
            fields.iter().filter(|f| pick(f)).map(|f| f.name.clone()).collect()
        };
        let bits = |pick: &dyn Fn(&Field) -> bool| fields.iter().filter(|f| pick(f)).fold(0, |m, f| m | f.mask());
        let effect = |f: &Field| f.access.code.write_effect();
        let readable = fields.iter().any(|f| f.access.code.readable());
        let writable = fields.iter().any(|f| f.access.code.writable());
        let impure = names(&|f| f.access.on_read.is_some());
        let no_neutral = names(&|f| f.access.neutral() == Neutral::None);
        let stored = fields.iter().any(|f| f.access.code != AccessCode::Ro && f.access.neutral() == Neutral::AsRead);
        let modify = if !readable || !writable {
            Err(NoModify::NotReadWrite)
        } else if !impure.is_empty() {
            Err(NoModify::ReadHasEffects(impure.clone()))
        } else if !no_neutral.is_empty() {
            Err(NoModify::NoNeutral(no_neutral))
        } else if !stored {
            Err(NoModify::OnlyFlags(names(&|f| f.access.code.writable())))
        } else {
            Ok(())
        };
        Self {
            readable,
            writable,
            pure: impure.is_empty(),
            modify,
            one_clears: bits(&|f| effect(f) == WriteEffect::OneClears),
            zero_clears: bits(&|f| effect(f) == WriteEffect::ZeroClears),
            one_sets: bits(&|f| effect(f) == WriteEffect::OneSets),
            neutral_zeros: bits(&|f| f.access.neutral() == Neutral::Zero),
            neutral_ones: bits(&|f| f.access.neutral() == Neutral::Ones),
        }
    }
}
