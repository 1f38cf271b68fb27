//! The description as data: what Debug, defmt, traces, simulators and tests work from.
//!
//! Every value type has a table of its [`Field`]s. With the feature `meta` of a generated crate there is also a
//! [`Controller`], the description as a whole.

mod controller;
mod display;

pub use controller::{
    Alias, AliasOp, Array, BitTiming, Comparison, Condition, Controller, Effect, Expr, FieldRef, Index, InterruptLine,
    InterruptSource, Joined, Message, MessageWord, OffsetReference, Part, Payload, Phase2Within, RegisterInfo,
    Reserved, Section, ThreeSamples, TimingPhase, TransmitterDelay, Window,
};
#[doc(hidden)]
pub use display::debug;
#[cfg(feature = "defmt")]
#[doc(hidden)]
pub use display::{format, format_name};

/// What software may do with a field, and what a write of it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Read and write; a write stores.
    Rw,
    /// Read only; a write does nothing.
    Ro,
    /// Write only.
    Wo,
    /// Writing 1 clears, writing 0 does nothing.
    W1c,
    /// Writing 0 clears, writing 1 does nothing.
    W0c,
    /// Writing 1 requests, writing 0 does nothing, hardware clears.
    W1s,
    /// Writing 1 requests, writing 0 aborts, hardware clears.
    Rwhc,
    /// Read and write; hardware changes it too.
    Rwh,
    /// A write of any value clears or presets.
    Wclr,
}

/// What a read does to a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadEffect {
    /// Nothing.
    None,
    /// A read that touches the byte clears the field; `None` is any byte of the register.
    Clear(Option<u8>),
    /// A read that touches the byte sets all bits of the field.
    Set(Option<u8>),
}

/// A field of a register or message word.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Name in the manual.
    pub name: &'static str,
    /// Least significant bit of lane 0.
    pub lsb: u8,
    /// Width in bits of one lane.
    pub width: u8,
    /// Number of lanes; 1 for a field that is not repeated.
    pub lanes: u8,
    /// Distance in bits from lane to lane.
    pub lane_stride: u8,
    /// The manual's number of lane 0.
    pub first_lane: u8,
    /// Access code.
    pub access: Access,
    /// What a read does.
    pub on_read: ReadEffect,
    /// Value after reset, if it is known.
    pub reset: Option<u32>,
    /// Smallest value that may be programmed.
    pub min: u32,
    /// Largest value that may be programmed.
    pub max: u32,
    /// Meaning is `(value + add) * times`.
    pub add: i32,
    /// See `add`.
    pub times: u32,
    /// The value is two's complement.
    pub signed: bool,
    /// Unit of the meaning; may be empty.
    pub unit: &'static str,
    /// Names of the values.
    pub values: Option<&'static Enum>,
    /// Write condition: index into [`Controller::conditions`].
    pub when: Option<u16>,
    /// Condition to set: index into [`Controller::conditions`].
    pub set_when: Option<u16>,
    /// For [`Access::Wclr`]: the field that a write loads.
    pub loads: Option<FieldRef>,
    /// The value that software has to write.
    pub must_write: Option<u32>,
    /// Writing back what was read is harmless although the access code has no neutral value.
    pub safe_to_write_back: bool,
}

impl Field {
    /// A field with the values most fields have: reset 0, no limits, no conditions. The methods below change one each.
    #[must_use]
    pub const fn new(name: &'static str, lsb: u8, width: u8, access: Access) -> Self {
        Self {
            name,
            lsb,
            width,
            lanes: 1,
            lane_stride: 0,
            first_lane: 0,
            access,
            on_read: ReadEffect::None,
            reset: Some(0),
            min: 0,
            max: crate::bits::mask(width as u32),
            add: 0,
            times: 1,
            signed: false,
            unit: "",
            values: None,
            when: None,
            set_when: None,
            loads: None,
            must_write: None,
            safe_to_write_back: false,
        }
    }

    /// Repeated in the register.
    #[must_use]
    pub const fn lanes(mut self, count: u8, stride: u8, first: u8) -> Self {
        self.lanes = count;
        self.lane_stride = stride;
        self.first_lane = first;
        self
    }

    /// With a read effect.
    #[must_use]
    pub const fn on_read(mut self, effect: ReadEffect) -> Self {
        self.on_read = effect;
        self
    }

    /// With a reset value, or without a known one.
    #[must_use]
    pub const fn reset(mut self, reset: Option<u32>) -> Self {
        self.reset = reset;
        self
    }

    /// With limits.
    #[must_use]
    pub const fn limits(mut self, min: u32, max: u32) -> Self {
        self.min = min;
        self.max = max;
        self
    }

    /// With a meaning of `(value + add) * times` units.
    #[must_use]
    pub const fn encoding(mut self, add: i32, times: u32, signed: bool, unit: &'static str) -> Self {
        self.add = add;
        self.times = times;
        self.signed = signed;
        self.unit = unit;
        self
    }

    /// With named values.
    #[must_use]
    pub const fn values(mut self, values: &'static Enum) -> Self {
        self.values = Some(values);
        self
    }

    /// With a write condition.
    #[must_use]
    pub const fn when(mut self, condition: u16) -> Self {
        self.when = Some(condition);
        self
    }

    /// With a condition to set.
    #[must_use]
    pub const fn set_when(mut self, condition: u16) -> Self {
        self.set_when = Some(condition);
        self
    }

    /// With a field that a write loads.
    #[must_use]
    pub const fn loads(mut self, register: u16, field: u16) -> Self {
        self.loads = Some(FieldRef { register, field });
        self
    }

    /// With a value that software has to write.
    #[must_use]
    pub const fn must_write(mut self, value: u32) -> Self {
        self.must_write = Some(value);
        self
    }

    /// Harmless to write back.
    #[must_use]
    pub const fn safe_to_write_back(mut self) -> Self {
        self.safe_to_write_back = true;
        self
    }

    /// Mask of a lane.
    #[must_use]
    pub const fn mask(&self, lane: u8) -> u32 {
        crate::bits::mask(self.width as u32) << self.lsb_of(lane)
    }

    /// Least significant bit of a lane.
    #[must_use]
    pub const fn lsb_of(&self, lane: u8) -> u32 {
        self.lsb as u32 + lane as u32 * self.lane_stride as u32
    }

    /// Mask of all lanes.
    #[must_use]
    pub const fn all(&self) -> u32 {
        let (mut mask, mut lane) = (0, 0);
        while lane < self.lanes {
            mask |= self.mask(lane);
            lane += 1;
        }
        mask
    }

    /// The value of a lane in a word.
    #[must_use]
    pub const fn get(&self, word: u32, lane: u8) -> u32 {
        crate::bits::get(word, self.lsb_of(lane), self.width as u32)
    }
}

/// Names of values.
#[derive(Clone, Copy, Debug)]
pub struct Enum {
    /// Its name in the description.
    pub name: &'static str,
    /// First value, last value, name.
    pub values: &'static [(u32, u32, &'static str)],
    /// First and last of values that must not be used.
    pub reserved: &'static [(u32, u32)],
}

impl Enum {
    /// The name of a value.
    #[must_use]
    pub fn name_of(&self, value: u32) -> Option<&'static str> {
        self.values.iter().find(|(first, last, _)| (*first..=*last).contains(&value)).map(|(_, _, name)| *name)
    }
}
