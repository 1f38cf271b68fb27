//! The language as it is written: one Rust type per YAML mapping.
//!
//! These types are the only definition of the format. The JSON schema that editors use, the checks of
//! shape (unknown key, missing key, wrong type) and the reference page of the language are derived from
//! them, their doc comments included.

mod access;
mod behaviour;
mod field;
mod memory;
mod register;
mod scalar;

pub use access::{AccessCode, OnRead, ReadEffect};
pub use behaviour::{
    BitTiming, Choice, Clock, Conflict, Effect, Instance, InterruptGroup, InterruptLine, InterruptSource, Interrupts,
    OffsetReference, Phase2Within, Says, ThreeSamples, TimingPhase, TransmitterDelay,
};
pub use field::{Encoding, EnumDef, EnumFull, EnumValue, EnumValueFull, Field, FieldReset, Lanes, Range, ResetKind};
pub use memory::{Memory, Message, MessageWord, Payload, Section};
pub use register::{
    Alias, AliasOp, Array, Cluster, Condition, ConditionFull, HalfOrder, Joined, Like, Register, ReservedRange, Reset,
    ResetParts, Window,
};
pub use scalar::{BitRange, Int, OneOrMany, ValueKey};

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Deserialize;

/// One controller, transcribed from its manual: the top level of a description file.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Identifier of the controller in lower case with underscores, such as `m_can`. It names the generated
    /// crate (`m-can-pac`), the C header (`m_can.h`), the SVD file and the peripheral type (`MCan`).
    pub controller: String,
    /// The controller's name as a person would say it.
    pub title: String,
    /// What the controller is, in a few sentences of your own.
    #[serde(default)]
    pub doc: Option<String>,
    /// The manual that this file transcribes.
    pub manual: Manual,
    /// Sources outside the manual, by a short key that a citation names with `source`.
    #[serde(default)]
    pub sources: IndexMap<String, Source>,
    /// The placeholder in front of the manual's register names (`Cx`, `Ci`), left out of the names here.
    #[serde(default)]
    pub prefix: Option<String>,
    /// Width in bits of a register that does not say otherwise: 8, 16 or 32.
    pub register_width: u8,
    /// Widths in bits of the bus accesses that are legal on a register.
    pub access_widths: Vec<u8>,
    /// Number of bytes the register block occupies, reserved ranges included.
    pub span: Int,
    /// Registers that stand beside every register and change its bits: PIC32 `CLR`, `SET`, `INV`.
    #[serde(default)]
    pub aliases: IndexMap<String, Alias>,
    /// Register windows: sets of registers that share addresses and are selected by a field.
    #[serde(default)]
    pub windows: IndexMap<String, Window>,
    /// Conditions by name, for `when` and `set_when`.
    #[serde(default)]
    pub conditions: IndexMap<String, Condition>,
    /// Enumerations by name, shared by the fields that say `enum: NAME`.
    #[serde(default)]
    pub enums: IndexMap<String, EnumDef>,
    /// The registers by their manual name without the prefix, in the manual's order.
    #[serde(default)]
    pub registers: IndexMap<String, Register>,
    /// Blocks of registers that repeat together, such as a FIFO's control, status and address.
    #[serde(default)]
    pub clusters: IndexMap<String, Cluster>,
    /// Values that are split over several registers or fields and mean one number.
    #[serde(default)]
    pub joined: IndexMap<String, Joined>,
    /// Address ranges that hold no register, and what an access to them does.
    #[serde(default)]
    pub reserved: Vec<ReservedRange>,
    /// What one register's state does to others: resets, presets, holds.
    #[serde(default)]
    pub effects: Vec<Effect>,
    /// Interrupt lines and sources.
    #[serde(default)]
    pub interrupts: Option<Interrupts>,
    /// Message memory layouts, word by word.
    #[serde(default)]
    pub messages: IndexMap<String, Message>,
    /// How messages are placed in memory.
    #[serde(default)]
    pub memory: Option<Memory>,
    /// Which fields make up the bit timing, and their limits.
    #[serde(default)]
    pub bit_timing: Option<BitTiming>,
    /// Known chips that carry the controller: base address and interrupt numbers.
    #[serde(default)]
    pub instances: IndexMap<String, Instance>,
    /// Where the manual contradicts itself or is damaged, and what this file takes.
    #[serde(default)]
    pub conflicts: Vec<Conflict>,
    /// Where the manual is silent and a model of the controller has to choose.
    #[serde(default)]
    pub choices: Vec<Choice>,
}

/// The manual a description is transcribed from.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Manual {
    /// Title on the cover.
    pub title: String,
    /// Who publishes it.
    pub publisher: String,
    /// Document number, if one is printed.
    #[serde(default)]
    pub document: Option<String>,
    /// Revision as printed.
    pub revision: String,
    /// Date of the revision, as printed or as `YYYY-MM-DD`.
    pub date: String,
    /// What is particular about this manual or its text: lost pages, missing address columns.
    #[serde(default)]
    pub doc: Option<String>,
}

/// A source outside the manual.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Title of the document or name of the public file.
    pub title: String,
    /// Where it can be found: document number, repository and path, section.
    #[serde(default)]
    pub locator: Option<String>,
    /// How far it can be trusted for this controller and why it is used.
    #[serde(default)]
    pub doc: Option<String>,
}

/// Where a fact stands. A register's citation also holds for its fields, unless a field has its own.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cite {
    /// Section number, quoted: `"2.3.7"`.
    #[serde(default)]
    pub section: Option<String>,
    /// Register number as the manual counts them: `"3-1"`.
    #[serde(default)]
    pub register: Option<String>,
    /// Table number.
    #[serde(default)]
    pub table: Option<String>,
    /// Figure number.
    #[serde(default)]
    pub figure: Option<String>,
    /// Example number.
    #[serde(default)]
    pub example: Option<String>,
    /// Equation number.
    #[serde(default)]
    pub equation: Option<String>,
    /// Printed page number.
    #[serde(default)]
    pub page: Option<u32>,
    /// Key of an entry of `sources`: the fact does not come from the manual.
    #[serde(default)]
    pub source: Option<String>,
    /// Which fact this citation is for, where it is not for everything: `offset`, `reset`, `names`.
    #[serde(default, rename = "for")]
    pub subject: Option<String>,
    /// Where in the source, or how the fact was derived from what is printed.
    #[serde(default)]
    pub note: Option<String>,
}
