//! Fields, enumerations and encodings as they are written.

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{AccessCode, BitRange, Cite, Int, OnRead, OneOrMany, ValueKey};

/// A field of a register or of a message word.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Field {
    /// Its bits: `15` or `"7:0"`. With `lanes`, those of the first lane.
    pub bits: BitRange,
    /// The field repeats in the register, such as four filters in one control register or 32 request bits.
    #[serde(default)]
    pub lanes: Option<Lanes>,
    /// The manual's own spelling where it cannot be a key: `"MM[7:0]"`, or `"F{n}BP"` for lanes, where `{n}` is
    /// the number of the lane. Lanes are spelled with the number behind the name if this is left out.
    #[serde(default)]
    pub label: Option<String>,
    /// Identifier in generated code, lower case with underscores, where splitting the name into words helps.
    #[serde(default)]
    pub name: Option<String>,
    /// What the field means, in your own words, with units.
    pub doc: String,
    /// Where it stands, if not where the register stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// Access code, if not the register's.
    #[serde(default)]
    pub access: Option<AccessCode>,
    /// Condition under which a write has an effect: a name from `conditions` or an expression.
    /// `always` lifts the register's condition.
    #[serde(default)]
    pub when: Option<String>,
    /// Condition under which the field may be set; it can be cleared at any time.
    #[serde(default)]
    pub set_when: Option<String>,
    /// What a read does to the field.
    #[serde(default)]
    pub on_read: Option<OnRead>,
    /// With access `wclr`: the field whose value a write loads, where it is not cleared to 0.
    #[serde(default)]
    pub write_loads: Option<String>,
    /// Value after reset, if the register does not give it: a number, `unknown`, `product` (depends on the device)
    /// or `pin` (follows an input).
    #[serde(default)]
    pub reset: Option<FieldReset>,
    /// Values and their names; `reserved` names values that must not be used.
    #[serde(default)]
    pub values: Option<IndexMap<ValueKey, EnumValue>>,
    /// Name of a shared enumeration from `enums`.
    #[serde(default, rename = "enum")]
    pub enum_ref: Option<String>,
    /// Values that may be programmed, where they are fewer than the bits can hold.
    #[serde(default)]
    pub range: Option<Range>,
    /// How the programmed number and its meaning are related.
    #[serde(default)]
    pub encoding: Option<Encoding>,
    /// A value that software has to write whatever it writes elsewhere in the register or word.
    #[serde(default)]
    pub must_write: Option<Int>,
    /// For a field without a neutral write value (`rwh`, `rwhc`): why writing back what was read is harmless.
    #[serde(default)]
    pub safe_to_write_back: Option<String>,
}

/// Reset of one field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum FieldReset {
    /// A value the manual prints.
    Value(Int),
    /// No value that could be relied on.
    Kind(ResetKind),
}

/// Why a reset value is not a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ResetKind {
    /// The manual prints an unknown value.
    Unknown,
    /// The value depends on the device or on a synthesis option.
    Product,
    /// The bit follows an input pin.
    Pin,
}

/// Repetition of a field inside its register.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Lanes {
    /// Number of lanes in one register.
    pub count: u32,
    /// Distance in bits from one lane to the next; the field's width if left out.
    #[serde(default)]
    pub stride: Option<u32>,
    /// The manual's number of the first lane. In an array of registers the numbers run on from one
    /// register to the next. 0 if left out.
    #[serde(default)]
    pub first: u32,
}

/// A range of values, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// Smallest value that may be programmed.
    #[serde(default)]
    pub min: Option<Int>,
    /// Largest value that may be programmed.
    #[serde(default)]
    pub max: Option<Int>,
}

/// How the number in a field maps to what it means: `meaning = (value + add) * times`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Encoding {
    /// Added to the programmed number: 1 for "programmed value + 1".
    #[serde(default)]
    pub add: i64,
    /// Multiplied afterwards; 1 if left out.
    #[serde(default)]
    pub times: Option<u32>,
    /// The programmed number is two's complement.
    #[serde(default)]
    pub signed: bool,
    /// Unit of the result: `tq`, `bit times`, `elements`, `words`, `bytes`.
    #[serde(default)]
    pub unit: Option<String>,
}

/// An enumeration: the values alone, or with a description.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum EnumDef {
    /// With a description.
    Full(Box<EnumFull>),
    /// The values alone: `{0: disabled, 1: enabled}`.
    Short(IndexMap<ValueKey, EnumValue>),
}

/// An enumeration with a description.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EnumFull {
    /// What the enumeration is about.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// Values and their names.
    pub values: IndexMap<ValueKey, EnumValue>,
}

/// A value of an enumeration: its name alone, or with a description.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum EnumValue {
    /// The name alone, lower case with underscores; `reserved` for values that must not be used.
    Name(String),
    /// With a description.
    Full(EnumValueFull),
}

/// A value of an enumeration with its description.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EnumValueFull {
    /// Name, lower case with underscores.
    pub name: String,
    /// The quantity the value stands for, where it is one: 12 for a code that means 12 buffers.
    #[serde(default)]
    pub number: Option<Int>,
    /// What the value means.
    #[serde(default)]
    pub doc: Option<String>,
}
