//! Plans of message memory: where each section lies, checked before the controller sees it.
//!
//! None of the controllers checks its layout. An overlap, a section beyond the end of the RAM or a wrong alignment shows as
//! messages that overwrite each other, so a plan is made and checked first, if possible in a `const`, where a wrong one does
//! not compile:
//!
//! ```
//! use can_hal::memory::{MCanMemory, MCanPlan};
//! use m_can_pac::enums::DataFieldSize;
//!
//! const PLAN: MCanPlan = MCanMemory::new(4352 * 4)
//!     .standard_filters(28)
//!     .rx_fifo_0(32, DataFieldSize::Bytes64)
//!     .tx_buffers(4, 12, DataFieldSize::Bytes64)
//!     .fixed();
//!
//! assert_eq!(PLAN.rxf0c.f0sa(), 28); // in words: right behind the filters
//! ```
//!
//! The sizes of elements, the numbers of elements and the units of addresses come from the descriptions
//! ([`regbus::meta::Section`], [`regbus::meta::Message`]).

mod canfd;
mod ecan;
mod facts;
mod m_can;
mod pic32;

pub use canfd::{DsPic33CanFdFifo, DsPic33CanFdFifoPlan, DsPic33CanFdMemory, DsPic33CanFdPlan};
pub use ecan::{DsPic33EcanMemory, DsPic33EcanPlan};
pub use m_can::{MCanMemory, MCanPlan, Start};
pub use pic32::{Pic32CanFifo, Pic32CanFifoPlan, Pic32CanMemory, Pic32CanPlan};

use core::fmt;

/// The name of a section: that of the description, with a number where there are several.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SectionName {
    /// The section's name in the description.
    pub name: &'static str,
    /// The number of the FIFO.
    pub number: Option<u8>,
}

impl SectionName {
    const fn single(name: &'static str) -> Self {
        Self { name, number: None }
    }

    const fn numbered(name: &'static str, number: u8) -> Self {
        Self { name, number: Some(number) }
    }
}

impl fmt::Display for SectionName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for letter in self.name.chars() {
            fmt::Write::write_char(f, if letter == '_' { ' ' } else { letter })?;
        }
        match self.number {
            Some(number) => write!(f, " {number}"),
            None => Ok(()),
        }
    }
}

/// A section at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Placed {
    /// Which one.
    pub name: SectionName,
    /// First byte: an offset in the RAM (M_CAN, ECAN), or an address (CAN FD, PIC32).
    pub start: u32,
    /// Number of elements.
    pub elements: u32,
    /// Bytes in an element.
    pub element_bytes: u32,
    /// The user has set it up; `false` for a FIFO that takes room only because one with a higher number is in use.
    pub used: bool,
}

impl Placed {
    /// Bytes in all.
    #[must_use]
    pub const fn bytes(&self) -> u32 {
        self.elements * self.element_bytes
    }

    /// The byte behind the last one.
    #[must_use]
    pub const fn end(&self) -> u64 {
        self.start as u64 + self.bytes() as u64
    }

    /// The first byte of an element; `None` if there is no such element.
    #[must_use]
    pub const fn element(&self, index: u32) -> Option<u32> {
        if index < self.elements { self.start.checked_add(index * self.element_bytes) } else { None }
    }

    const fn overlaps(&self, other: &Self) -> bool {
        self.elements > 0
            && other.elements > 0
            && (self.start as u64) < other.end()
            && (other.start as u64) < self.end()
    }
}

/// Why a layout is impossible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LayoutError {
    /// More elements than the section can have, or none where there has to be one.
    Elements {
        /// The section.
        section: SectionName,
        /// What was asked for.
        requested: u32,
        /// Fewest.
        min: u32,
        /// Most.
        max: u32,
    },
    /// A start address that the register cannot hold.
    Unaligned {
        /// The section.
        section: SectionName,
        /// Its start.
        start: u32,
        /// What it has to be a multiple of.
        alignment: u32,
    },
    /// Two sections share bytes.
    Overlap {
        /// The one that begins first.
        first: Placed,
        /// The other.
        second: Placed,
    },
    /// A section ends behind the end of the RAM.
    TooLarge {
        /// The section.
        section: Placed,
        /// The byte behind the last one of the RAM.
        end: u64,
    },
    /// A section begins or ends behind what start addresses can reach.
    Unreachable {
        /// The section.
        section: Placed,
        /// The byte behind the last one that can be reached.
        end: u64,
    },
    /// A FIFO that does not exist.
    NoSuchFifo {
        /// The number that was asked for.
        number: u8,
        /// First number.
        first: u8,
        /// Last number.
        last: u8,
    },
    /// The start of the FIFO is no buffer of the area.
    FifoStart {
        /// The start that was asked for.
        start: u8,
        /// Number of buffers.
        buffers: u32,
    },
}

impl LayoutError {
    /// In words, without names and numbers: the message of a compile error.
    #[must_use]
    pub const fn text(&self) -> &'static str {
        match self {
            Self::Elements { .. } => "a section has too many elements, or too few",
            Self::Unaligned { .. } => "a section begins at an address that the register cannot hold",
            Self::Overlap { .. } => "two sections overlap",
            Self::TooLarge { .. } => "the sections do not fit into the RAM",
            Self::Unreachable { .. } => "a section lies behind what start addresses can reach",
            Self::NoSuchFifo { .. } => "there is no FIFO of this number",
            Self::FifoStart { .. } => "the FIFO starts behind the last buffer",
        }
    }
}

impl fmt::Display for LayoutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Elements { section, requested, min, max } => {
                write!(f, "{section}: {requested} elements, but it takes {min} to {max}")
            }
            Self::Unaligned { section, start, alignment } => {
                write!(f, "{section}: starts at {start:#x}, which is no multiple of {alignment}")
            }
            Self::Overlap { first, second } => write!(
                f,
                "{} ({:#x} to {:#x}) and {} ({:#x} to {:#x}) overlap",
                first.name,
                first.start,
                first.end() - 1,
                second.name,
                second.start,
                second.end() - 1
            ),
            Self::TooLarge { section, end } => write!(
                f,
                "{} ends at {:#x}, but the RAM at {:#x}: {} bytes are missing",
                section.name,
                section.end() - 1,
                end.saturating_sub(1),
                section.end().saturating_sub(end)
            ),
            Self::Unreachable { section, end } => write!(
                f,
                "{} ends at {:#x}, behind {:#x}, the last byte that a start address can reach",
                section.name,
                section.end() - 1,
                end.saturating_sub(1)
            ),
            Self::NoSuchFifo { number, first, last } => {
                write!(f, "there is no FIFO {number}: the numbers are {first} to {last}")
            }
            Self::FifoStart { start, buffers } => {
                write!(f, "the FIFO cannot start at buffer {start} of {buffers}")
            }
        }
    }
}

impl core::error::Error for LayoutError {}

/// Unwraps in a `const fn`, where `?` does not exist.
macro_rules! ok {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error),
        }
    };
}
use ok;
