//! Registers, arrays, clusters, windows, aliases and joined values as they are written.

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{AccessCode, Cite, Field, Int, OneOrMany};

/// A register, or an array of equal registers.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Register {
    /// Title of the register's page.
    pub title: String,
    /// Byte offset from the base of the block, or from the base of the cluster. Left out only with `device`.
    #[serde(default)]
    pub offset: Option<Int>,
    /// Width in bits, if not `register_width`.
    #[serde(default)]
    pub width: Option<u8>,
    /// The register repeats.
    #[serde(default)]
    pub array: Option<Array>,
    /// The register belongs to the device, not to the controller's block: its layout is described, but the
    /// generated code gives no access to it, because its address is not known here.
    #[serde(default)]
    pub device: bool,
    /// The window in which it is visible; left out, it is visible in all.
    #[serde(default)]
    pub window: Option<String>,
    /// The manual's own spelling where the key differs from it. `{n}` stands for the number in the array.
    #[serde(default)]
    pub label: Option<String>,
    /// Identifier in generated code, lower case with underscores, where splitting the name into words helps:
    /// `fifo_con` gives the type `FifoCon`.
    #[serde(default)]
    pub name: Option<String>,
    /// What the register is for, in your own words.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands. Also holds for its fields.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// Access code of the fields that do not give their own.
    #[serde(default)]
    pub access: Option<AccessCode>,
    /// Write condition of the fields that do not give their own.
    #[serde(default)]
    pub when: Option<String>,
    /// Value after reset. Left out, every field gives its own.
    #[serde(default)]
    pub reset: Option<Reset>,
    /// Copies another register of the same list, with names replaced; `fields` here add or override.
    #[serde(default)]
    pub like: Option<Like>,
    /// Why a write can make the hardware access memory outside this register, so that it needs `unsafe`.
    #[serde(default)]
    pub unsafe_write: Option<String>,
    /// Traps for whoever writes a driver, one sentence each; they appear in every output.
    #[serde(default)]
    pub hazards: Vec<String>,
    /// The alias registers do not exist for this register, although the controller has them.
    #[serde(default)]
    pub no_aliases: bool,
    /// The fields by their manual names, in the manual's order.
    #[serde(default)]
    pub fields: IndexMap<String, Field>,
}

/// Repetition of a register or cluster.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Array {
    /// Number of elements.
    pub count: u32,
    /// Distance in bytes from one element to the next.
    pub stride: Int,
    /// The manual's number of the first element; 0 if left out.
    #[serde(default)]
    pub first: u32,
    /// The manual's own names of the elements, where they are not the name and a number: `[TR01CON, TR23CON]`.
    #[serde(default)]
    pub labels: Option<Vec<String>>,
}

/// Registers that repeat together.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cluster {
    /// Title.
    pub title: String,
    /// Byte offset of the first element from the base of the block.
    pub offset: Int,
    /// The repetition.
    pub array: Array,
    /// What the cluster is.
    #[serde(default)]
    pub doc: Option<String>,
    /// Identifier in generated code, if not the key in lower case. A member `fifo_con` of a cluster `fifo`
    /// is reached as `fifo(n).con()`.
    #[serde(default)]
    pub name: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// The registers of one element, with offsets from its start.
    pub registers: IndexMap<String, Register>,
    /// Values split over registers of one element.
    #[serde(default)]
    pub joined: IndexMap<String, Joined>,
}

/// A register described as another one with changed names.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Like {
    /// The register to copy, without its offset, citation and array.
    pub register: String,
    /// Text replaced in field names, labels, descriptions, conditions: `{"F0": "F1", "FIFO 0": "FIFO 1"}`.
    /// All are replaced at once, the longest match first.
    #[serde(default)]
    pub replace: IndexMap<String, String>,
}

/// Value of a register after reset.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Reset {
    /// All bits are known.
    Value(Int),
    /// Some bits are not.
    Parts(ResetParts),
}

/// Reset with bits that have no defined value.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResetParts {
    /// Value of the known bits; 0 in the others.
    pub value: Int,
    /// Mask of the bits without a defined value.
    pub unknown: Int,
}

/// What a write to an alias register does to the register it stands beside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum AliasOp {
    /// Bits written 1 are cleared.
    Clear,
    /// Bits written 1 are set.
    Set,
    /// Bits written 1 are inverted.
    Invert,
}

/// An alias register beside every register.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Alias {
    /// Byte offset from the register.
    pub offset: Int,
    /// What writing 1 does.
    pub op: AliasOp,
    /// What else is to be known, such as what a read returns.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// A register window.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// The field that selects the window: `CTRL1.WIN`.
    pub select: String,
    /// The value that selects this window.
    pub value: Int,
    /// What is in the window.
    pub doc: String,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// A condition: an expression alone, or with a description.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Condition {
    /// The expression alone, such as `CCCR.INIT && CCCR.CCE`.
    Expression(String),
    /// With a description.
    Full(Box<ConditionFull>),
}

/// A condition with a description.
///
/// An expression compares fields with numbers or with names of their enumeration (`CON.OPMOD == configuration`),
/// takes a field alone as "is not 0", names other conditions, and joins with `&&`, `||`, `!` and parentheses.
/// `FLTCON.FLTEN[n]` is lane `n` of a field that has lanes, where `n` is the number of the register or lane that
/// is written.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConditionFull {
    /// The expression.
    pub expression: String,
    /// What the condition means, in your own words; shown where a write is refused.
    pub doc: String,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// The order in which the parts of a joined value are accessed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum HalfOrder {
    /// The part with the least significant bits first.
    #[default]
    LowFirst,
    /// The part with the most significant bits first.
    HighFirst,
}

/// A value that is split over several fields or registers.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Joined {
    /// The parts, least significant first: `REG` (the whole register), `REG.FIELD`, or in a message `WORD.FIELD`.
    pub parts: Vec<String>,
    /// What the value means.
    pub doc: String,
    /// Identifier in generated code, if not the key in lower case.
    #[serde(default)]
    pub name: Option<String>,
    /// Order of access when the parts are separate registers.
    #[serde(default)]
    pub order: HalfOrder,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// A range of addresses without a register.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReservedRange {
    /// First byte offset.
    pub from: Int,
    /// Last byte offset, included.
    pub to: Int,
    /// The window in which the range is reserved; left out, in all.
    #[serde(default)]
    pub window: Option<String>,
    /// What a read returns, where the manual says.
    #[serde(default)]
    pub reads: Option<Int>,
    /// A flag that an access sets: `IR.ARA`.
    #[serde(default)]
    pub sets: Option<String>,
    /// What else an access does.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}
