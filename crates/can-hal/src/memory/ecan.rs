//! Message buffers of the ECAN module in DMA RAM (9.2, 10.0).

use dspic33_ecan_pac::enums::BufferCount;
use dspic33_ecan_pac::meta::CONTROLLER;
use dspic33_ecan_pac::registers::Fctrl;

use super::facts::{Facts, check_end, same};
use super::{LayoutError, Placed, SectionName, ok};

const BUFFERS: Facts = Facts::of(&CONTROLLER, "buffers");

/// The layout of a received message in the order of the description; a message to send takes the same room.
const RECEIVE: usize = 1;

/// The buffers that are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DsPic33EcanMemory {
    start: u32,
    ram_bytes: u32,
    buffers: BufferCount,
    fifo_start: u8,
    aligned: bool,
}

impl DsPic33EcanMemory {
    /// So many buffers in a DMA RAM of so many bytes, from its byte `start` on, with the FIFO starting at buffer `fifo_start`.
    ///
    /// The start is the DMA channels' `DMAxSTA`, the same for both.
    #[must_use]
    pub const fn new(start: u32, ram_bytes: u32, buffers: BufferCount, fifo_start: u8) -> Self {
        Self { start, ram_bytes, buffers, fifo_start, aligned: true }
    }

    /// Also at a start that is no multiple of the next power of two of the size.
    ///
    /// The ECAN manual does not ask for it (choice `buffer_alignment`); the DMA controller's peripheral indirect mode, which
    /// puts the offset of the buffer in place of address bits, does.
    #[must_use]
    pub const fn unaligned(mut self) -> Self {
        self.aligned = false;
        self
    }

    /// Places the buffers and checks them.
    ///
    /// # Errors
    ///
    /// A start that is not aligned, buffers that end behind the RAM, a FIFO that starts behind the last buffer.
    pub const fn plan(&self) -> Result<DsPic33EcanPlan, LayoutError> {
        let name = SectionName::single(BUFFERS.name());
        let count = match self.buffers.number() {
            Some(count) => count,
            None => 0,
        };
        ok!(BUFFERS.check_count(name, count));
        let element_bytes = BUFFERS.element_bytes(RECEIVE, BUFFERS.only_payload(RECEIVE));
        let all = Placed { name, start: self.start, elements: count, element_bytes, used: true };
        let alignment = if self.aligned { all.bytes().next_power_of_two() } else { 2 };
        if !self.start.is_multiple_of(alignment) {
            return Err(LayoutError::Unaligned { section: name, start: self.start, alignment });
        }
        ok!(check_end(&all, self.ram_bytes as u64, u64::MAX));
        if self.fifo_start as u32 >= count {
            return Err(LayoutError::FifoStart { start: self.fifo_start, buffers: count });
        }
        Ok(DsPic33EcanPlan {
            fctrl: Fctrl::RESET.with_dmabs(self.buffers).with_fsa(self.fifo_start),
            start: self.start,
            all,
            fifo_start: self.fifo_start,
        })
    }

    /// The plan of a layout that is known to be possible: for a `const`, where an impossible one does not compile.
    ///
    /// # Panics
    ///
    /// If [`Self::plan`] finds something wrong.
    #[must_use]
    #[track_caller]
    pub const fn fixed(&self) -> DsPic33EcanPlan {
        match self.plan() {
            Ok(plan) => plan,
            Err(error) => panic!("{}", error.text()),
        }
    }
}

/// A checked layout with its register value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DsPic33EcanPlan {
    /// Number of buffers and start of the FIFO (Register 4-18).
    pub fctrl: Fctrl,
    /// For `DMAxSTA` of both channels: the first byte of the buffers in DMA RAM.
    pub start: u32,
    all: Placed,
    fifo_start: u8,
}

impl DsPic33EcanPlan {
    /// Buffers that can transmit if the layout has them: those of the `TRmnCON` registers.
    pub const TRANSMIT_BUFFERS: u32 = transmit_buffers();

    /// The first byte of a buffer in DMA RAM; `None` if there is no such buffer.
    #[must_use]
    pub const fn buffer(&self, number: u8) -> Option<u32> {
        self.all.element(number as u32)
    }

    /// All buffers.
    #[must_use]
    pub const fn buffers(&self) -> Placed {
        self.all
    }

    /// The buffers in front of the FIFO, and the FIFO, which runs from its start to the last buffer.
    pub fn sections(&self) -> impl Iterator<Item = Placed> + '_ {
        let front = u32::from(self.fifo_start);
        let fifo = Placed {
            name: SectionName::single("fifo"),
            start: self.all.start + front * self.all.element_bytes,
            elements: self.all.elements - front,
            ..self.all
        };
        [Placed { elements: front, ..self.all }, fifo].into_iter().filter(|section| section.elements > 0)
    }

    /// The byte behind the last buffer.
    #[must_use]
    pub const fn end(&self) -> u32 {
        self.all.end() as u32
    }
}

const fn transmit_buffers() -> u32 {
    let mut i = 0;
    while i < CONTROLLER.registers.len() {
        let register = &CONTROLLER.registers[i];
        if same(register.name, "TRCON")
            && let Some(array) = register.array
        {
            return array.count * register.fields[0].lanes as u32;
        }
        i += 1;
    }
    0
}
