//! A controller's description as data.

use super::Field;

/// A field of a register: indices into [`Controller::registers`] and [`RegisterInfo::fields`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldRef {
    /// The register.
    pub register: u16,
    /// The field.
    pub field: u16,
}

/// A controller as its description tells it.
#[derive(Clone, Copy, Debug)]
pub struct Controller {
    /// Identifier: `m_can`.
    pub name: &'static str,
    /// Name.
    pub title: &'static str,
    /// Bytes the block occupies.
    pub span: u32,
    /// Widths in bits of legal accesses.
    pub access_widths: &'static [u8],
    /// Alias registers beside every register that has [`RegisterInfo::aliased`].
    pub aliases: &'static [Alias],
    /// Windows.
    pub windows: &'static [Window],
    /// Registers.
    pub registers: &'static [RegisterInfo],
    /// Conditions.
    pub conditions: &'static [Condition],
    /// Values split over several registers.
    pub joined: &'static [Joined],
    /// Ranges without a register.
    pub reserved: &'static [Reserved],
    /// What states of the registers do to other registers.
    pub effects: &'static [Effect],
    /// Interrupt lines.
    pub lines: &'static [InterruptLine],
    /// Interrupt sources.
    pub interrupts: &'static [InterruptSource],
    /// Message layouts.
    pub messages: &'static [Message],
    /// Placement of messages.
    pub sections: &'static [Section],
    /// Bit timing.
    pub bit_timing: Option<BitTiming>,
}

/// An alias register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Alias {
    /// Suffix to the register's name.
    pub name: &'static str,
    /// Byte offset from the register.
    pub offset: u32,
    /// What writing 1 does.
    pub op: AliasOp,
}

/// What writing 1 to an alias register does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AliasOp {
    /// Clears the bit.
    Clear,
    /// Sets the bit.
    Set,
    /// Inverts the bit.
    Invert,
}

/// A register window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// Name.
    pub name: &'static str,
    /// The selecting field.
    pub select: FieldRef,
    /// Its value for this window.
    pub value: u32,
}

/// Repetition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Array {
    /// Number of elements.
    pub count: u32,
    /// Distance in bytes.
    pub stride: u32,
    /// The manual's number of the first element.
    pub first: u32,
}

/// A register, or an array of them.
#[derive(Clone, Copy, Debug)]
pub struct RegisterInfo {
    /// Name in the description.
    pub name: &'static str,
    /// The manual's spelling; `{n}` stands for the number of the element.
    pub label: &'static str,
    /// Width in bits.
    pub width: u8,
    /// Byte offset of the first element; `None` for a register of the device.
    pub offset: Option<u32>,
    /// Repetition by the cluster it is in.
    pub cluster: Option<Array>,
    /// Repetition of its own.
    pub array: Option<Array>,
    /// The manual's own names of the elements; empty where they are the label and a number.
    pub labels: &'static [&'static str],
    /// Index into [`Controller::windows`].
    pub window: Option<u8>,
    /// Value after reset.
    pub reset: u32,
    /// Bits without a defined value after reset.
    pub reset_unknown: u32,
    /// Alias registers stand beside it.
    pub aliased: bool,
    /// Fields.
    pub fields: &'static [Field],
    /// Where it stands in the manual.
    pub source: &'static str,
}

impl RegisterInfo {
    /// Bits that belong to a field.
    #[must_use]
    pub fn implemented(&self) -> u32 {
        self.fields.iter().fold(0, |mask, field| mask | field.all())
    }

    /// Number of physical registers.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.cluster.map_or(1, |c| c.count) * self.array.map_or(1, |a| a.count)
    }

    /// Byte offset of an element of the cluster and of the array, both counted from 0.
    #[must_use]
    pub fn offset_of(&self, element: u32, inner: u32) -> Option<u32> {
        let outer = self.cluster.map_or(0, |c| c.stride * element);
        self.offset.map(|offset| offset + outer + self.array.map_or(0, |a| a.stride * inner))
    }
}

/// A condition.
#[derive(Clone, Copy, Debug)]
pub struct Condition {
    /// Name, or the expression itself.
    pub name: &'static str,
    /// What it means.
    pub doc: &'static str,
    /// The expression.
    pub expr: Expr,
    /// Where it stands in the manual; may be empty.
    pub source: &'static str,
}

/// A truth value over fields.
#[derive(Clone, Copy, Debug)]
pub enum Expr {
    /// Always true.
    Always,
    /// A field compared with a number.
    Compare {
        /// The field.
        field: FieldRef,
        /// Which element or lane.
        index: Index,
        /// How.
        comparison: Comparison,
        /// With what.
        value: u32,
    },
    /// A field of the message's own words compared with a number.
    Word {
        /// Index into [`Controller::messages`].
        message: u16,
        /// Index into [`Message::words`].
        word: u16,
        /// Index into [`MessageWord::fields`].
        field: u16,
        /// How.
        comparison: Comparison,
        /// With what.
        value: u32,
    },
    /// Not true.
    Not(&'static Expr),
    /// All are true.
    All(&'static [Expr]),
    /// At least one is true.
    Any(&'static [Expr]),
}

/// Which element or lane of a repeated field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Index {
    /// The field is not repeated, or that of the register being written.
    Single,
    /// The one with the own number.
    Own,
    /// A fixed number.
    Fixed(u32),
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

impl Comparison {
    /// Compares.
    #[must_use]
    pub const fn holds(self, left: u32, right: u32) -> bool {
        match self {
            Self::Equal => left == right,
            Self::NotEqual => left != right,
            Self::Less => left < right,
            Self::LessOrEqual => left <= right,
            Self::Greater => left > right,
            Self::GreaterOrEqual => left >= right,
        }
    }
}

impl Expr {
    /// Whether the expression is true, given a way to look up a register field.
    pub fn holds(&self, field: &mut dyn FnMut(FieldRef, Index) -> u32) -> bool {
        match *self {
            Self::Always => true,
            Self::Compare { field: at, index, comparison, value } => comparison.holds(field(at, index), value),
            Self::Word { .. } => false,
            Self::Not(inner) => !inner.holds(field),
            Self::All(of) => of.iter().all(|e| e.holds(field)),
            Self::Any(of) => of.iter().any(|e| e.holds(field)),
        }
    }
}

/// A part of a joined value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Index of the register, or of the word of a message.
    pub holder: u16,
    /// Least significant bit in it.
    pub lsb: u8,
    /// Number of bits.
    pub width: u8,
    /// Position in the joined value.
    pub shift: u8,
}

/// A value split over several registers or words.
#[derive(Clone, Copy, Debug)]
pub struct Joined {
    /// Name.
    pub name: &'static str,
    /// Number of bits.
    pub width: u8,
    /// The parts, least significant first.
    pub parts: &'static [Part],
}

/// A range of addresses without a register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reserved {
    /// First byte offset.
    pub from: u32,
    /// Last byte offset, included.
    pub to: u32,
    /// Index into [`Controller::windows`].
    pub window: Option<u8>,
    /// What a read returns, where the manual says.
    pub reads: Option<u32>,
    /// The flag an access sets.
    pub sets: Option<FieldRef>,
}

/// What one state of the registers does to others.
#[derive(Clone, Copy, Debug)]
pub struct Effect {
    /// Index into [`Controller::conditions`].
    pub on: u16,
    /// What happens.
    pub doc: &'static str,
    /// Registers that return to their reset value.
    pub resets: &'static [u16],
    /// Fields that return to their reset value.
    pub resets_fields: &'static [FieldRef],
    /// Fields that take the value of another: (target, origin).
    pub loads: &'static [(FieldRef, FieldRef)],
    /// Fields that take a value.
    pub sets: &'static [(FieldRef, u32)],
    /// Held for as long as the state lasts.
    pub holds: bool,
}

/// An interrupt line.
#[derive(Clone, Copy, Debug)]
pub struct InterruptLine {
    /// Name.
    pub name: &'static str,
    /// The field that enables it.
    pub enable: Option<FieldRef>,
    /// The value of a line-select bit that routes a source here.
    pub select: Option<u32>,
}

/// An interrupt source.
#[derive(Clone, Copy, Debug)]
pub struct InterruptSource {
    /// Name.
    pub name: &'static str,
    /// The flag.
    pub flag: FieldRef,
    /// The enable.
    pub enable: Option<FieldRef>,
    /// The line-select bit.
    pub select: Option<FieldRef>,
    /// Indices into [`Controller::lines`].
    pub lines: &'static [u16],
    /// Indices into [`Controller::interrupts`] of the sources it feeds.
    pub feeds: &'static [u16],
    /// First and last of its numbers in the interrupt code field.
    pub code: Option<(u32, u32)>,
}

/// A message element.
#[derive(Clone, Copy, Debug)]
pub struct Message {
    /// Name.
    pub name: &'static str,
    /// Width in bits of its words.
    pub word_width: u8,
    /// Bytes in front of the payload, or of the whole element.
    pub header_bytes: u32,
    /// Words.
    pub words: &'static [MessageWord],
    /// Data bytes.
    pub payload: Option<Payload>,
    /// Values split over words.
    pub joined: &'static [Joined],
}

/// A word of a message element.
#[derive(Clone, Copy, Debug)]
pub struct MessageWord {
    /// Name.
    pub name: &'static str,
    /// Byte offset.
    pub offset: u32,
    /// Index into [`Controller::conditions`]: when it has this layout.
    pub present_when: Option<u16>,
    /// Fields.
    pub fields: &'static [Field],
}

/// The data bytes of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Payload {
    /// Byte offset.
    pub offset: u32,
    /// Sizes in bytes, in the order of the codes of the size field.
    pub sizes: &'static [u32],
}

/// A run of equal elements in memory.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// Name.
    pub name: &'static str,
    /// Indices into [`Controller::messages`].
    pub elements: &'static [u16],
    /// The parts of its start address; empty if it follows the section before it.
    pub start: &'static [Part],
    /// Bytes for one unit of the start address.
    pub start_unit: u32,
    /// The fields that add up to the number of elements.
    pub count: &'static [FieldRef],
    /// Largest number of elements.
    pub max: Option<u32>,
    /// The field that selects the payload size.
    pub payload_size: Option<FieldRef>,
    /// Index into [`Controller::conditions`]: when it exists.
    pub exists_when: Option<u16>,
}

/// The bit timing.
#[derive(Clone, Copy, Debug)]
pub struct BitTiming {
    /// The manual's name of the clock.
    pub clock: &'static str,
    /// Fixed divider in front of the prescaler.
    pub divider: u32,
    /// Highest clock frequency in hertz.
    pub max_clock: Option<u32>,
    /// Arbitration phase.
    pub nominal: TimingPhase,
    /// Data phase.
    pub data: Option<TimingPhase>,
    /// Transmitter delay compensation.
    pub transmitter_delay: Option<TransmitterDelay>,
}

/// The fields of one phase.
#[derive(Clone, Copy, Debug)]
pub struct TimingPhase {
    /// Prescaler.
    pub prescaler: FieldRef,
    /// Propagation segment, where it is a field of its own.
    pub propagation: Option<FieldRef>,
    /// Phase segment 1, or propagation and phase segment 1 together.
    pub segment1: FieldRef,
    /// Phase segment 2.
    pub segment2: FieldRef,
    /// Synchronization jump width.
    pub jump_width: FieldRef,
    /// Fewest time quanta in a bit.
    pub min_quanta: u32,
    /// Most time quanta in a bit.
    pub max_quanta: u32,
    /// Highest bit rate in bit/s.
    pub max_bit_rate: Option<u32>,
    /// What phase segment 2 must not be longer than.
    pub phase2_within: Phase2Within,
    /// The jump width has to be shorter than phase segment 2, not only as long.
    pub jump_width_below_phase2: bool,
    /// Sampling three times, where the controller does that.
    pub three_samples: Option<ThreeSamples>,
}

/// What phase segment 2 must not be longer than.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Phase2Within {
    /// Its own range is the only limit.
    Anything,
    /// Phase segment 1.
    Phase1,
    /// Propagation segment and phase segment 1 together.
    PropagationAndPhase1,
}

/// Sampling every bit three times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ThreeSamples {
    /// The field that switches it on.
    pub field: FieldRef,
    /// Smallest prescaler with it, as the number it means.
    pub min_prescaler: u32,
}

/// Where the offset of the transmitter delay compensation counts from, so that the secondary sample point comes to lie
/// where the sample point of the data phase lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OffsetReference {
    /// It is the time from the start of the bit to the sample point.
    SamplePoint,
    /// It is that time without the synchronization segment.
    Segment1,
}

/// Transmitter delay compensation.
#[derive(Clone, Copy, Debug)]
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
    /// Largest prescaler of the data phase with compensation, as the number it means; `None` if the manual names none.
    pub max_prescaler: Option<u32>,
    /// Largest position of the secondary sample point in clock periods; a later one is taken as this.
    pub max_position: Option<u32>,
    /// Delay and offset together are shorter than this many data bits.
    pub max_bits: Option<u32>,
}
