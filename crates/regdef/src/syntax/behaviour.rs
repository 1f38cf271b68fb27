//! Effects, interrupts, bit timing, instances, conflicts and choices as they are written.

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{Cite, Int, OneOrMany, Range, ValueKey};

/// What one state of the registers does to other registers.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Effect {
    /// The state, as an expression: `CCCR.CCE`. The effect happens when it becomes true.
    pub on: String,
    /// What happens, in your own words.
    pub doc: String,
    /// Registers (`REG`) and fields (`REG.FIELD`) that return to their reset value.
    #[serde(default)]
    pub resets: Vec<String>,
    /// Fields that take the value of another field: `{TOCV.TOC: TOCC.TOP}`.
    #[serde(default)]
    pub loads: IndexMap<String, String>,
    /// Fields that take a value: `{TXQCONL.FRESET: 1}`.
    #[serde(default)]
    pub sets: IndexMap<String, Int>,
    /// The effect is held for as long as the state lasts.
    #[serde(default)]
    pub holds: bool,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// The interrupt structure.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interrupts {
    /// How flags, enables and lines work together.
    pub doc: String,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// The lines that leave the controller.
    pub lines: IndexMap<String, InterruptLine>,
    /// Sources that are named regularly, a whole register at once.
    #[serde(default)]
    pub groups: Vec<InterruptGroup>,
    /// Sources one by one.
    #[serde(default)]
    pub sources: IndexMap<String, InterruptSource>,
}

/// An interrupt line.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterruptLine {
    /// What the line signals.
    pub doc: String,
    /// The field that enables the line: `ILE.EINT0`.
    #[serde(default)]
    pub enable: Option<String>,
    /// The value of a source's line-select bit that routes it here.
    #[serde(default)]
    pub select: Option<Int>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// Interrupt sources whose names follow a rule: one source per field of a flag register.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterruptGroup {
    /// The register of the flags: `IR`.
    pub flags: String,
    /// The register of the enables: `IE`.
    #[serde(default)]
    pub enables: Option<String>,
    /// Name of an enable, with `{}` for the flag's name: `"{}E"`.
    #[serde(default)]
    pub enable_name: Option<String>,
    /// The register of the line-select bits: `ILS`.
    #[serde(default)]
    pub selects: Option<String>,
    /// Name of a line-select bit: `"{}L"`.
    #[serde(default)]
    pub select_name: Option<String>,
    /// The lines the sources can reach.
    pub lines: Vec<String>,
    /// Text taken off the end of the flag's name before it is put into the others and names the source: `IF`.
    #[serde(default)]
    pub strip: Option<String>,
    /// Fields of the flag register that are no sources.
    #[serde(default)]
    pub except: Vec<String>,
}

/// An interrupt source.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterruptSource {
    /// When it is raised; taken from the flag's description if left out.
    #[serde(default)]
    pub doc: Option<String>,
    /// The flag: `REG.FIELD`.
    pub flag: String,
    /// The enable: `REG.FIELD`.
    #[serde(default)]
    pub enable: Option<String>,
    /// The line-select bit.
    #[serde(default)]
    pub select: Option<String>,
    /// The lines it reaches.
    #[serde(default)]
    pub lines: Vec<String>,
    /// The sources it feeds instead of a line: the next level of a tree.
    #[serde(default)]
    pub feeds: Vec<String>,
    /// Its number in the interrupt code field: `65`, or `"0..31"` for a source that repeats.
    #[serde(default)]
    pub code: Option<ValueKey>,
    /// How the flag is cleared where clearing the flag bit itself is not the way.
    #[serde(default)]
    pub cleared_by: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// The bit timing.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BitTiming {
    /// The clock that the time quantum is divided from.
    pub clock: Clock,
    /// Arbitration phase, and all of a classic frame.
    pub nominal: TimingPhase,
    /// Data phase of a CAN FD frame with bit rate switch.
    #[serde(default)]
    pub data: Option<TimingPhase>,
    /// Transmitter delay compensation.
    #[serde(default)]
    pub transmitter_delay: Option<TransmitterDelay>,
}

/// The CAN clock.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Clock {
    /// The manual's name of the clock.
    pub name: String,
    /// Fixed divider in front of the prescaler; 1 if left out.
    #[serde(default)]
    pub divider: Option<u32>,
    /// Highest frequency in hertz.
    #[serde(default)]
    pub max_hz: Option<Int>,
    /// What else is to be known.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// The fields of one phase. Their limits and encodings stand at the fields.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TimingPhase {
    /// Prescaler.
    pub prescaler: String,
    /// Propagation segment, where it is programmed apart from phase segment 1.
    #[serde(default)]
    pub propagation: Option<String>,
    /// Phase segment 1, or propagation segment and phase segment 1 together.
    pub segment1: String,
    /// Phase segment 2.
    pub segment2: String,
    /// Synchronization jump width.
    pub jump_width: String,
    /// Time quanta in a bit.
    pub quanta: Range,
    /// Rules that tie the fields together, in your own words.
    #[serde(default)]
    pub rules: Vec<String>,
    /// Highest bit rate in bit/s that the manual allows.
    #[serde(default)]
    pub max_bit_rate: Option<Int>,
    /// What phase segment 2 must not be longer than; its own range only if left out.
    #[serde(default)]
    pub phase2_within: Option<Phase2Within>,
    /// The jump width has to be shorter than phase segment 2, not only as long.
    #[serde(default)]
    pub jump_width_below_phase2: bool,
    /// Sampling three times, where the controller does that.
    #[serde(default)]
    pub three_samples: Option<ThreeSamples>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// What phase segment 2 must not be longer than.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Phase2Within {
    /// Phase segment 1.
    Phase1,
    /// Propagation segment and phase segment 1 together.
    PropagationAndPhase1,
}

/// Sampling every bit three times.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThreeSamples {
    /// The field that switches it on.
    pub field: String,
    /// Smallest prescaler with it, as the number it means, not as programmed; 1 if left out.
    #[serde(default)]
    pub min_prescaler: Option<Int>,
}

/// What the offset of the transmitter delay compensation is, so that the secondary sample point lies where the sample
/// point of the data phase lies.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OffsetReference {
    /// The time from the start of the bit to the sample point.
    #[default]
    SamplePoint,
    /// That time without the synchronization segment.
    Segment1,
}

/// Transmitter delay compensation.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransmitterDelay {
    /// The field that switches it on.
    pub enable: String,
    /// The offset to the secondary sample point.
    pub offset: String,
    /// The filter window.
    #[serde(default)]
    pub filter: Option<String>,
    /// The measured or manual value.
    #[serde(default)]
    pub value: Option<String>,
    /// What the offset counts; to the sample point if left out.
    #[serde(default)]
    pub reference: OffsetReference,
    /// Largest prescaler of the data phase with compensation, as the number it means.
    #[serde(default)]
    pub max_prescaler: Option<Int>,
    /// Largest position of the secondary sample point in clock periods.
    #[serde(default)]
    pub max_position: Option<Int>,
    /// Delay and offset together are shorter than this many data bits.
    #[serde(default)]
    pub max_bits: Option<Int>,
    /// Rules, in your own words.
    #[serde(default)]
    pub rules: Vec<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// One controller on one family of chips.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Instance {
    /// The chips.
    pub chips: Vec<String>,
    /// Base address of the register block.
    pub base: Int,
    /// Base address of the message memory, where it is a memory of its own.
    #[serde(default)]
    pub memory: Option<Int>,
    /// Interrupt numbers by line.
    #[serde(default)]
    pub interrupts: IndexMap<String, Int>,
    /// What else is to be known.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands: an external source.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// A contradiction or damage of the manual, and its resolution.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Conflict {
    /// Short name, lower case with underscores; it is the anchor in the generated pages.
    pub id: String,
    /// The registers, fields (`REG.FIELD`), enumerations, messages or words (`MESSAGE.WORD`) it is about; empty
    /// if it is about none in particular.
    #[serde(default)]
    pub at: Vec<String>,
    /// What is wrong, in a few words.
    pub what: String,
    /// What the manual says where.
    pub says: Vec<Says>,
    /// What this file takes.
    pub taken: String,
    /// Why.
    pub because: String,
}

/// One reading of a conflict.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Says {
    /// Where.
    pub cite: Cite,
    /// What is said there, in your own words or as a value.
    pub says: String,
}

/// A silence of the manual that a model has to fill.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Choice {
    /// Short name, lower case with underscores; a simulator option has the same name.
    pub id: String,
    /// The registers, fields, enumerations or messages it is about.
    #[serde(default)]
    pub at: Vec<String>,
    /// The question the manual leaves open.
    pub question: String,
    /// The manual's nearest words, in your own.
    #[serde(default)]
    pub nearest: Option<String>,
    /// What a model does.
    pub choice: String,
    /// Other sensible choices, where a model should offer them.
    #[serde(default)]
    pub alternatives: Vec<String>,
    /// Why.
    #[serde(default)]
    pub because: Option<String>,
    /// Where the nearest words stand.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}
