//! Acceptance filters (2.4.5, 2.4.6, 3.4.1).
//!
//! Filter elements are in the Message RAM, so that they may change at any time; what is protected is the number of
//! elements and everything in GFC, SIDFC, XIDFC and XIDAM.

use core::fmt;

use can_frame::{ExtendedId, StandardId};
use m_can_pac::{
    enums::{ExtendedFilterType, FilterAction, RxBufferUse, StandardFilterType},
    messages::{
        ExtendedFilter as ExtendedElement, ExtendedFilterF0, ExtendedFilterF1, ExtendedFilterF1RxBuffer,
        StandardFilter as StandardElement, StandardFilterS0, StandardFilterS0RxBuffer,
    },
};
use regbus::Bus;

use super::{Can, Inner};

/// What happens to a message that matches (2.4.5, SFEC).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Action {
    /// Stored in Rx FIFO 0.
    Fifo0,
    /// Stored in Rx FIFO 1.
    Fifo1,
    /// Rejected.
    Reject,
    /// High priority message: reported, not stored.
    Priority,
    /// High priority message, stored in Rx FIFO 0.
    PriorityFifo0,
    /// High priority message, stored in Rx FIFO 1.
    PriorityFifo1,
}

impl Action {
    const fn code(self) -> FilterAction {
        match self {
            Self::Fifo0 => FilterAction::Fifo0,
            Self::Fifo1 => FilterAction::Fifo1,
            Self::Reject => FilterAction::Reject,
            Self::Priority => FilterAction::Priority,
            Self::PriorityFifo0 => FilterAction::PriorityFifo0,
            Self::PriorityFifo1 => FilterAction::PriorityFifo1,
        }
    }
}

/// The three messages of a debug sequence (3.4.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum DebugMessage {
    /// Message A.
    A,
    /// Message B.
    B,
    /// Message C.
    C,
}

/// Which identifiers match.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matching<I> {
    /// None: the element is skipped.
    Nothing,
    /// From the first to the second, both included.
    Range(I, I, Action),
    /// The same without the Extended ID AND Mask. For 11-bit identifiers, which have no such mask, it is a range.
    RangeUnmasked(I, I, Action),
    /// One of two.
    Dual(I, I, Action),
    /// Those that equal the identifier where the mask is 1.
    Mask(I, u32, Action),
    /// One, stored in a dedicated Rx Buffer.
    Buffer(I, u8),
    /// One, stored as a debug message in an Rx Buffer.
    Debug(I, DebugMessage, u8),
}

/// An acceptance filter for identifiers of type `I`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter<I> {
    /// Which identifiers match, and what happens.
    pub matching: Matching<I>,
    /// SSYNC, ESYNC: a Timestamping Unit takes the time of the message.
    pub sync: bool,
    /// For messages to a dedicated Rx Buffer: which filter event pins pulse, one bit each (0 to 7).
    pub event_pins: u8,
}

/// A filter for 11-bit identifiers.
pub type StandardFilter = Filter<StandardId>;
/// A filter for 29-bit identifiers.
pub type ExtendedFilter = Filter<ExtendedId>;

impl<I: Copy> Filter<I> {
    /// An element that is skipped.
    pub const DISABLED: Self = Self::new(Matching::Nothing);

    /// A filter without pulses and without timestamp of a Timestamping Unit.
    #[must_use]
    pub const fn new(matching: Matching<I>) -> Self {
        Self { matching, sync: false, event_pins: 0 }
    }

    /// Matches from `first` to `last`, both included.
    #[must_use]
    pub const fn range(first: I, last: I, action: Action) -> Self {
        Self::new(Matching::Range(first, last, action))
    }

    /// Matches two identifiers.
    #[must_use]
    pub const fn dual(a: I, b: I, action: Action) -> Self {
        Self::new(Matching::Dual(a, b, action))
    }

    /// Matches one identifier.
    #[must_use]
    pub const fn exact(id: I, action: Action) -> Self {
        Self::new(Matching::Dual(id, id, action))
    }

    /// Matches what equals `id` where `mask` is 1. A mask of 0 matches all.
    #[must_use]
    pub const fn mask(id: I, mask: u32, action: Action) -> Self {
        Self::new(Matching::Mask(id, mask, action))
    }

    /// Matches one identifier and stores it in a dedicated Rx Buffer, unless its New Data flag is set.
    #[must_use]
    pub const fn buffer(id: I, buffer: u8) -> Self {
        Self::new(Matching::Buffer(id, buffer))
    }

    /// Matches one identifier and stores it as a debug message in an Rx Buffer. The buffers of the three messages are
    /// consecutive.
    #[must_use]
    pub const fn debug(id: I, message: DebugMessage, buffer: u8) -> Self {
        Self::new(Matching::Debug(id, message, buffer))
    }

    /// The same, with its time taken by a Timestamping Unit.
    #[must_use]
    pub const fn with_sync(mut self) -> Self {
        self.sync = true;
        self
    }

    /// The same, with pulses at filter event pins; only for messages to a dedicated Rx Buffer.
    #[must_use]
    pub const fn with_event_pins(mut self, pins: u8) -> Self {
        self.event_pins = pins;
        self
    }
}

/// Why a filter cannot be stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FilterError {
    /// There is no such filter element.
    NoSuchElement {
        /// The element.
        index: usize,
        /// How many there are.
        count: u8,
    },
    /// The first identifier of a range is above the last.
    Reversed {
        /// The first.
        first: u32,
        /// The last.
        last: u32,
    },
    /// The mask has bits that the identifier has not.
    MaskTooWide {
        /// The mask.
        mask: u32,
    },
    /// There is no such Rx Buffer.
    NoSuchBuffer {
        /// The buffer.
        buffer: u8,
        /// How many there are.
        count: u8,
    },
    /// There are only three filter event pins.
    EventPins {
        /// The pins asked for.
        pins: u8,
    },
}

impl fmt::Display for FilterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchElement { index, count } => write!(f, "there are {count} filter elements, but no {index}"),
            Self::Reversed { first, last } => write!(f, "the range begins at {first:#x}, behind its end {last:#x}"),
            Self::MaskTooWide { mask } => write!(f, "mask {mask:#x} has more bits than the identifier"),
            Self::NoSuchBuffer { buffer, count } => write!(f, "there are {count} Rx Buffers, but no {buffer}"),
            Self::EventPins { pins } => write!(f, "filter event pins {pins:#x}: there are three"),
        }
    }
}

impl core::error::Error for FilterError {}

/// Checks a filter against the controller's Rx Buffers and gives it with identifiers as numbers.
fn checked<I: Copy>(
    filter: &Filter<I>,
    raw: impl Fn(I) -> u32,
    max: u32,
    buffers: u8,
) -> Result<Matching<u32>, FilterError> {
    let ordered = |first, last| if first > last { Err(FilterError::Reversed { first, last }) } else { Ok(()) };
    let exists = |buffer| {
        if buffer < buffers { Ok(()) } else { Err(FilterError::NoSuchBuffer { buffer, count: buffers }) }
    };
    if filter.event_pins > 7 {
        return Err(FilterError::EventPins { pins: filter.event_pins });
    }
    Ok(match filter.matching {
        Matching::Nothing => Matching::Nothing,
        Matching::Range(a, b, action) => {
            ordered(raw(a), raw(b))?;
            Matching::Range(raw(a), raw(b), action)
        }
        Matching::RangeUnmasked(a, b, action) => {
            ordered(raw(a), raw(b))?;
            Matching::RangeUnmasked(raw(a), raw(b), action)
        }
        Matching::Dual(a, b, action) => Matching::Dual(raw(a), raw(b), action),
        Matching::Mask(_, mask, _) if mask > max => return Err(FilterError::MaskTooWide { mask }),
        Matching::Mask(id, mask, action) => Matching::Mask(raw(id), mask, action),
        Matching::Buffer(id, buffer) => {
            exists(buffer)?;
            Matching::Buffer(raw(id), buffer)
        }
        Matching::Debug(id, message, buffer) => {
            exists(buffer)?;
            Matching::Debug(raw(id), message, buffer)
        }
    })
}

const fn debug_use(message: DebugMessage) -> RxBufferUse {
    match message {
        DebugMessage::A => RxBufferUse::DebugA,
        DebugMessage::B => RxBufferUse::DebugB,
        DebugMessage::C => RxBufferUse::DebugC,
    }
}

/// 2.4.5: the word of a standard filter element.
fn standard_word(filter: &StandardFilter, buffers: u8) -> Result<u32, FilterError> {
    let max = u32::from(StandardId::MAX.as_raw());
    let matching = checked(filter, |id| u32::from(id.as_raw()), max, buffers)?;
    let plain = |kind, a: u32, b: u32, action: Action| {
        let word = StandardFilterS0::ZERO.with_sft(kind).with_sfec(action.code());
        word.with_sfid1(a as u16).with_sfid2(b as u16).with_ssync(filter.sync).bits()
    };
    let to_buffer = |id: u32, destination, buffer| {
        let word = StandardFilterS0RxBuffer::ZERO.with_sfec(FilterAction::RxBuffer).with_sfid1(id as u16);
        let word = word.with_ssync(filter.sync).with_destination(destination);
        word.with_event_pins(filter.event_pins).with_buffer(buffer).bits()
    };
    Ok(match matching {
        Matching::Nothing => StandardFilterS0::ZERO.with_sft(StandardFilterType::Disabled).bits(),
        Matching::Range(a, b, action) | Matching::RangeUnmasked(a, b, action) => {
            plain(StandardFilterType::Range, a, b, action)
        }
        Matching::Dual(a, b, action) => plain(StandardFilterType::Dual, a, b, action),
        Matching::Mask(id, mask, action) => plain(StandardFilterType::Classic, id, mask, action),
        Matching::Buffer(id, buffer) => to_buffer(id, RxBufferUse::RxBuffer, buffer),
        Matching::Debug(id, message, buffer) => to_buffer(id, debug_use(message), buffer),
    })
}

/// 2.4.6: the two words of an extended filter element.
fn extended_words(filter: &ExtendedFilter, buffers: u8) -> Result<(ExtendedFilterF0, u32), FilterError> {
    let matching = checked(filter, |id| id.as_raw(), ExtendedId::MAX.as_raw(), buffers)?;
    let plain = |kind, a, b, action: Action| {
        let f0 = ExtendedFilterF0::ZERO.with_efec(action.code()).with_efid1(a);
        (f0, ExtendedFilterF1::ZERO.with_eft(kind).with_esync(filter.sync).with_efid2(b).bits())
    };
    let to_buffer = |id, destination, buffer| {
        let f0 = ExtendedFilterF0::ZERO.with_efec(FilterAction::RxBuffer).with_efid1(id);
        let f1 = ExtendedFilterF1RxBuffer::ZERO.with_esync(filter.sync).with_destination(destination);
        (f0, f1.with_event_pins(filter.event_pins).with_buffer(buffer).bits())
    };
    Ok(match matching {
        Matching::Nothing => (ExtendedFilterF0::ZERO, 0),
        Matching::Range(a, b, action) => plain(ExtendedFilterType::Range, a, b, action),
        Matching::RangeUnmasked(a, b, action) => plain(ExtendedFilterType::RangeUnmasked, a, b, action),
        Matching::Dual(a, b, action) => plain(ExtendedFilterType::Dual, a, b, action),
        Matching::Mask(id, mask, action) => plain(ExtendedFilterType::Classic, id, mask, action),
        Matching::Buffer(id, buffer) => to_buffer(id, RxBufferUse::RxBuffer, buffer),
        Matching::Debug(id, message, buffer) => to_buffer(id, debug_use(message), buffer),
    })
}

impl<R: Bus, M: Bus> Inner<R, M> {
    pub(super) fn write_standard_filter(&self, index: usize, filter: &StandardFilter) -> Result<(), FilterError> {
        let section = &self.layout.standard_filters;
        if index >= usize::from(section.count) {
            return Err(FilterError::NoSuchElement { index, count: section.count });
        }
        let word = standard_word(filter, self.layout.rx_buffers.count)?;
        StandardElement::new(self.ram, section.at(index as u8)).s0().write(StandardFilterS0::from_bits(word));
        Ok(())
    }

    pub(super) fn write_extended_filter(&self, index: usize, filter: &ExtendedFilter) -> Result<(), FilterError> {
        let section = &self.layout.extended_filters;
        if index >= usize::from(section.count) {
            return Err(FilterError::NoSuchElement { index, count: section.count });
        }
        let (f0, f1) = extended_words(filter, self.layout.rx_buffers.count)?;
        let element = ExtendedElement::new(self.ram, section.at(index as u8));
        // Two words cannot change at once: in between the element is disabled.
        element.f0().write(ExtendedFilterF0::ZERO);
        element.f1().write(ExtendedFilterF1::from_bits(f1));
        element.f0().write(f0);
        Ok(())
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Replaces a filter element for 11-bit identifiers, in any mode; messages on their way are filtered by the old or by
    /// the new one.
    ///
    /// # Errors
    /// A [`FilterError`]; the element is unchanged then.
    pub fn set_standard_filter(&mut self, index: usize, filter: &StandardFilter) -> Result<(), FilterError> {
        self.inner.write_standard_filter(index, filter)
    }

    /// Replaces a filter element for 29-bit identifiers, in any mode. While it changes it is disabled, so that a message
    /// on its way may be filtered by neither the old nor the new one.
    ///
    /// # Errors
    /// A [`FilterError`]; the element is unchanged then.
    pub fn set_extended_filter(&mut self, index: usize, filter: &ExtendedFilter) -> Result<(), FilterError> {
        self.inner.write_extended_filter(index, filter)
    }
}
