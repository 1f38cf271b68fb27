//! Sections of the Message RAM (2.4.1).

use core::fmt;

use m_can_pac::{
    enums::DataFieldSize,
    messages::{ExtendedFilter, RxBuffer, StandardFilter, TxBuffer, TxEvent},
    meta::CONTROLLER,
};
use regbus::Mmio;

/// A run of equal elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Section {
    /// Bytes from the start of the region.
    pub(super) start: u32,
    /// Bytes of an element.
    pub(super) element: u32,
    pub(super) count: u8,
}

impl Section {
    /// Offset of an element.
    #[inline]
    pub(super) const fn at(&self, index: u8) -> usize {
        (self.start + self.element * index as u32) as usize
    }

    const fn end(&self) -> u32 {
        self.start + self.element * self.count as u32
    }
}

/// How many elements each section has, and of what size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// 11-bit filter elements, 0 to 128.
    pub standard_filters: u8,
    /// 29-bit filter elements, 0 to 64.
    pub extended_filters: u8,
    /// Elements of Rx FIFO 0, 0 to 64.
    pub rx_fifo_0: u8,
    /// Elements of Rx FIFO 1, 0 to 64.
    pub rx_fifo_1: u8,
    /// Dedicated Rx Buffers, 0 to 64.
    pub rx_buffers: u8,
    /// Elements of the Tx Event FIFO, 0 to 32.
    pub tx_events: u8,
    /// Dedicated Tx Buffers; with the Tx FIFO or Queue 0 to 32.
    pub tx_dedicated: u8,
    /// Elements of the Tx FIFO or Queue.
    pub tx_queue: u8,
    /// Data bytes of an element of Rx FIFO 0.
    pub rx_fifo_0_data: DataFieldSize,
    /// Data bytes of an element of Rx FIFO 1.
    pub rx_fifo_1_data: DataFieldSize,
    /// Data bytes of a dedicated Rx Buffer.
    pub rx_buffer_data: DataFieldSize,
    /// Data bytes of a Tx Buffer.
    pub tx_data: DataFieldSize,
}

impl Sizes {
    /// No elements, 8 data bytes everywhere.
    pub const NONE: Self = Self {
        standard_filters: 0,
        extended_filters: 0,
        rx_fifo_0: 0,
        rx_fifo_1: 0,
        rx_buffers: 0,
        tx_events: 0,
        tx_dedicated: 0,
        tx_queue: 0,
        rx_fifo_0_data: DataFieldSize::Bytes8,
        rx_fifo_1_data: DataFieldSize::Bytes8,
        rx_buffer_data: DataFieldSize::Bytes8,
        tx_data: DataFieldSize::Bytes8,
    };

    /// The same with room for this many data bytes in all messages.
    #[must_use]
    pub const fn with_data(mut self, size: DataFieldSize) -> Self {
        self.rx_fifo_0_data = size;
        self.rx_fifo_1_data = size;
        self.rx_buffer_data = size;
        self.tx_data = size;
        self
    }
}

/// Where the sections of the Message RAM lie; checked, and never overlapping.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    pub(super) standard_filters: Section,
    pub(super) extended_filters: Section,
    pub(super) rx_fifos: [Section; 2],
    pub(super) rx_buffers: Section,
    pub(super) tx_events: Section,
    pub(super) tx_buffers: Section,
    pub(super) sizes: Sizes,
}

/// Why there is no such layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LayoutError {
    /// A section has more elements than the controller can use.
    TooMany {
        /// The section, by its name in the description.
        section: &'static str,
        /// Elements asked for.
        count: u32,
        /// Most elements there can be.
        max: u32,
    },
    /// The sections need more memory than there is.
    TooLong {
        /// Bytes needed.
        bytes: u32,
        /// Bytes there are.
        room: u32,
    },
    /// The region does not begin at a word, or reaches behind the addresses that start address fields can hold.
    Address {
        /// Where the region begins.
        address: u32,
    },
}

impl fmt::Display for LayoutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooMany { section, count, max } => write!(f, "{section} has {count} elements, the most are {max}"),
            Self::TooLong { bytes, room } => write!(f, "the sections need {bytes} bytes, there are {room}"),
            Self::Address { address } => write!(f, "message RAM cannot begin at {address:#x}"),
        }
    }
}

impl core::error::Error for LayoutError {}

/// Largest number of elements of a section, from the description.
const fn most(section: &str) -> u32 {
    let mut index = 0;
    while index < CONTROLLER.sections.len() {
        let candidate = &CONTROLLER.sections[index];
        if equal(candidate.name, section) {
            return match candidate.max {
                Some(max) => max,
                None => panic!("the description gives this section no limit"),
            };
        }
        index += 1;
    }
    panic!("the description has no such section")
}

const fn equal(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut index = 0;
    while index < a.len() && index < b.len() && a[index] == b[index] {
        index += 1;
    }
    index == a.len() && index == b.len()
}

/// Addresses that start address fields can hold: 14 bits of 32-bit words (2.4.1).
const ADDRESSES: u32 = 1 << 16;

impl Layout {
    /// The sections one behind the other, in the order of the description.
    ///
    /// # Errors
    /// [`LayoutError::TooMany`] for a section with more elements than the controller can use.
    pub const fn packed(sizes: &Sizes) -> Result<Self, LayoutError> {
        const LIMITS: [(&str, u32); 7] = [
            ("standard_filters", most("standard_filters")),
            ("extended_filters", most("extended_filters")),
            ("rx_fifo_0", most("rx_fifo_0")),
            ("rx_fifo_1", most("rx_fifo_1")),
            ("rx_buffers", most("rx_buffers")),
            ("tx_event_fifo", most("tx_event_fifo")),
            ("tx_buffers", most("tx_buffers")),
        ];
        let wanted = [
            (sizes.standard_filters as u32, StandardFilter::<Mmio>::BYTES as u32),
            (sizes.extended_filters as u32, ExtendedFilter::<Mmio>::BYTES as u32),
            (sizes.rx_fifo_0 as u32, RxBuffer::<Mmio>::bytes(sizes.rx_fifo_0_data.bits() as usize) as u32),
            (sizes.rx_fifo_1 as u32, RxBuffer::<Mmio>::bytes(sizes.rx_fifo_1_data.bits() as usize) as u32),
            (sizes.rx_buffers as u32, RxBuffer::<Mmio>::bytes(sizes.rx_buffer_data.bits() as usize) as u32),
            (sizes.tx_events as u32, TxEvent::<Mmio>::BYTES as u32),
            (
                sizes.tx_dedicated as u32 + sizes.tx_queue as u32,
                TxBuffer::<Mmio>::bytes(sizes.tx_data.bits() as usize) as u32,
            ),
        ];
        let mut placed = [Section { start: 0, element: 0, count: 0 }; 7];
        let (mut index, mut end) = (0, 0);
        while index < wanted.len() {
            let ((count, element), (section, max)) = (wanted[index], LIMITS[index]);
            if count > max {
                return Err(LayoutError::TooMany { section, count, max });
            }
            placed[index] = Section { start: end, element, count: count as u8 };
            end += count * element;
            index += 1;
        }
        let [standard_filters, extended_filters, rx_fifo_0, rx_fifo_1, rx_buffers, tx_events, tx_buffers] = placed;
        Ok(Self {
            standard_filters,
            extended_filters,
            rx_fifos: [rx_fifo_0, rx_fifo_1],
            rx_buffers,
            tx_events,
            tx_buffers,
            sizes: *sizes,
        })
    }

    /// Bytes from the start of the first section to the end of the last.
    #[must_use]
    pub const fn bytes(&self) -> u32 {
        self.tx_buffers.end()
    }

    /// Checks the layout against the region it is to lie in.
    pub(super) const fn fits(&self, address: u32, room: u32) -> Result<(), LayoutError> {
        let bytes = self.bytes();
        if bytes > room {
            return Err(LayoutError::TooLong { bytes, room });
        }
        if !address.is_multiple_of(4) || address > ADDRESSES - bytes {
            return Err(LayoutError::Address { address });
        }
        Ok(())
    }
}
