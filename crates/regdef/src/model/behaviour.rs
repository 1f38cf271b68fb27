//! Effects, interrupts, bit timing, instances, conflicts and choices of the model.

use super::{
    Cite, ClusterId, ConditionId, EnumId, FieldRef, InterruptId, LineId, MessageId, OffsetReference, Phase2Within,
    RegisterId,
};

/// What one state of the registers does to others.
#[derive(Debug, Clone)]
pub struct Effect {
    /// The state.
    pub on: ConditionId,
    /// What happens.
    pub doc: String,
    /// Registers that return to their reset value as a whole.
    pub resets: Vec<RegisterId>,
    /// Fields that return to their reset value.
    pub resets_fields: Vec<FieldRef>,
    /// Fields that take the value of another field: (target, origin).
    pub loads: Vec<(FieldRef, FieldRef)>,
    /// Fields that take a value.
    pub sets: Vec<(FieldRef, u64)>,
    /// Held for as long as the state lasts.
    pub holds: bool,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// The interrupt structure.
#[derive(Debug, Clone, Default)]
pub struct Interrupts {
    /// How flags, enables and lines work together; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
    /// The lines.
    pub lines: Vec<InterruptLine>,
    /// The sources.
    pub sources: Vec<InterruptSource>,
}

/// An interrupt line.
#[derive(Debug, Clone)]
pub struct InterruptLine {
    /// Its name.
    pub name: String,
    /// What it signals.
    pub doc: String,
    /// The field that enables it.
    pub enable: Option<FieldRef>,
    /// The value of a line-select bit that routes a source here.
    pub select: Option<u64>,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// An interrupt source.
#[derive(Debug, Clone)]
pub struct InterruptSource {
    /// Its name.
    pub name: String,
    /// When it is raised.
    pub doc: String,
    /// The flag.
    pub flag: FieldRef,
    /// The enable.
    pub enable: Option<FieldRef>,
    /// The line-select bit.
    pub select: Option<FieldRef>,
    /// The lines it reaches directly.
    pub lines: Vec<LineId>,
    /// The sources it feeds.
    pub feeds: Vec<InterruptId>,
    /// First and last of its numbers in the interrupt code field.
    pub code: Option<(u64, u64)>,
    /// How the flag is cleared where clearing the flag bit is not the way; may be empty.
    pub cleared_by: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// The bit timing.
#[derive(Debug, Clone)]
pub struct BitTiming {
    /// The clock.
    pub clock: Clock,
    /// Arbitration phase.
    pub nominal: TimingPhase,
    /// Data phase.
    pub data: Option<TimingPhase>,
    /// Transmitter delay compensation.
    pub transmitter_delay: Option<TransmitterDelay>,
}

/// The CAN clock.
#[derive(Debug, Clone)]
pub struct Clock {
    /// The manual's name.
    pub name: String,
    /// Fixed divider in front of the prescaler.
    pub divider: u32,
    /// Highest frequency in hertz.
    pub max_hz: Option<u64>,
    /// What else is to be known; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// The fields of one phase.
#[derive(Debug, Clone)]
pub struct TimingPhase {
    /// Prescaler.
    pub prescaler: FieldRef,
    /// Propagation segment, where it is a field of its own.
    pub propagation: Option<FieldRef>,
    /// Phase segment 1, or propagation segment and phase segment 1 together.
    pub segment1: FieldRef,
    /// Phase segment 2.
    pub segment2: FieldRef,
    /// Synchronization jump width.
    pub jump_width: FieldRef,
    /// Fewest time quanta in a bit.
    pub min_quanta: u64,
    /// Most time quanta in a bit.
    pub max_quanta: u64,
    /// Rules that tie the fields together.
    pub rules: Vec<String>,
    /// Highest bit rate in bit/s.
    pub max_bit_rate: Option<u64>,
    /// What phase segment 2 must not be longer than.
    pub phase2_within: Option<Phase2Within>,
    /// The jump width has to be shorter than phase segment 2.
    pub jump_width_below_phase2: bool,
    /// Sampling three times: the field, and the smallest prescaler as the number it means.
    pub three_samples: Option<(FieldRef, u64)>,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// Transmitter delay compensation.
#[derive(Debug, Clone)]
pub struct TransmitterDelay {
    /// The field that switches it on.
    pub enable: FieldRef,
    /// The offset.
    pub offset: FieldRef,
    /// The filter window.
    pub filter: Option<FieldRef>,
    /// The measured or manual value.
    pub value: Option<FieldRef>,
    /// What the offset counts.
    pub reference: OffsetReference,
    /// Largest prescaler of the data phase, as the number it means.
    pub max_prescaler: Option<u64>,
    /// Largest position of the secondary sample point in clock periods.
    pub max_position: Option<u64>,
    /// Delay and offset together are shorter than this many data bits.
    pub max_bits: Option<u64>,
    /// Rules.
    pub rules: Vec<String>,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// One controller on one family of chips.
#[derive(Debug, Clone)]
pub struct Instance {
    /// Its name.
    pub name: String,
    /// The chips.
    pub chips: Vec<String>,
    /// Base address.
    pub base: u64,
    /// Base address of the message memory.
    pub memory: Option<u64>,
    /// Interrupt numbers by name.
    pub interrupts: Vec<(String, u64)>,
    /// What else is to be known; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// What a conflict or a choice is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A register.
    Register(RegisterId),
    /// A cluster.
    Cluster(ClusterId),
    /// A value joined from parts of registers: an index into the model's `joined`.
    Joined(usize),
    /// A field.
    Field(FieldRef),
    /// An enumeration.
    Enum(EnumId),
    /// A message.
    Message(MessageId),
    /// A word of a message.
    Word(MessageId, usize),
    /// A field of a word of a message.
    WordField(MessageId, usize, usize),
}

/// One reading of a conflict.
#[derive(Debug, Clone)]
pub struct Reading {
    /// Where.
    pub cite: Cite,
    /// What is said there.
    pub says: String,
}

/// A contradiction of the manual, and its resolution.
#[derive(Debug, Clone)]
pub struct Conflict {
    /// Short name.
    pub id: String,
    /// What it is about.
    pub at: Vec<Target>,
    /// What is wrong.
    pub what: String,
    /// The readings.
    pub says: Vec<Reading>,
    /// What is taken.
    pub taken: String,
    /// Why.
    pub because: String,
}

/// A silence of the manual.
#[derive(Debug, Clone)]
pub struct Choice {
    /// Short name.
    pub id: String,
    /// What it is about.
    pub at: Vec<Target>,
    /// The open question.
    pub question: String,
    /// The manual's nearest words; may be empty.
    pub nearest: String,
    /// What a model does.
    pub choice: String,
    /// Other sensible choices.
    pub alternatives: Vec<String>,
    /// Why; may be empty.
    pub because: String,
    /// Where the nearest words stand.
    pub cites: Vec<Cite>,
}
