//! Access codes as they are written.

use schemars::JsonSchema;
use serde::Deserialize;

/// What software may do with a field, and what a write of it means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum AccessCode {
    /// Read and write; a write stores.
    Rw,
    /// Read only; a write does nothing.
    Ro,
    /// Write only; what a read returns means nothing.
    Wo,
    /// A flag: writing 1 clears it, writing 0 does nothing.
    W1c,
    /// A flag: writing 0 clears it, writing 1 does nothing.
    W0c,
    /// A request: writing 1 makes it, writing 0 does nothing, hardware clears it.
    W1s,
    /// A request that can be withdrawn: writing 1 makes it, writing 0 aborts it, hardware clears it.
    Rwhc,
    /// Read and write, but hardware also changes it, so that writing back what was read can undo the hardware.
    Rwh,
    /// A write of any value clears or presets the field; the written value is ignored.
    Wclr,
}

/// What a read does to a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ReadEffect {
    /// A read clears the field to 0.
    Clear,
    /// A read sets every bit of the field.
    Set,
}

/// A read with a side effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OnRead {
    /// What the read does.
    pub effect: ReadEffect,
    /// Number of the byte of the register whose reading triggers the effect (0 is bits 7:0), where a read of
    /// the other bytes does not. Left out, any read of the register triggers it.
    #[serde(default)]
    pub byte: Option<u8>,
}
