//! Message RAM of the M_CAN (2.4).

use m_can_pac::enums::DataFieldSize;
use m_can_pac::meta::CONTROLLER;
use m_can_pac::registers::{Rxbc, Rxesc, Rxf0c, Rxf1c, Sidfc, Txbc, Txefc, Txesc, Xidfc};

use super::facts::{Facts, check_end};
use super::{LayoutError, Placed, SectionName, ok};

/// Where a section begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Start {
    /// Right behind the section before it, in the order of Figure 2: standard filters, extended filters, Rx FIFO 0,
    /// Rx FIFO 1, Rx Buffers, Tx Event FIFO, Tx Buffers. The first one begins at [`MCanMemory::origin`].
    #[default]
    Packed,
    /// At this byte of the Message RAM.
    At(u32),
}

/// What is asked of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Area {
    elements: u32,
    payload: DataFieldSize,
    start: Start,
}

impl Area {
    const NONE: Self = Self { elements: 0, payload: DataFieldSize::Bytes8, start: Start::Packed };

    const fn sized(self, elements: u32, payload: DataFieldSize) -> Self {
        Self { elements, payload, ..self }
    }
}

/// The number of sections.
const SECTIONS: usize = 7;

const STANDARD: usize = 0;
const EXTENDED: usize = 1;
const FIFO_0: usize = 2;
const FIFO_1: usize = 3;
const BUFFERS: usize = 4;
const EVENTS: usize = 5;
const TX: usize = 6;

const FACTS: [Facts; SECTIONS] = [
    Facts::of(&CONTROLLER, "standard_filters"),
    Facts::of(&CONTROLLER, "extended_filters"),
    Facts::of(&CONTROLLER, "rx_fifo_0"),
    Facts::of(&CONTROLLER, "rx_fifo_1"),
    Facts::of(&CONTROLLER, "rx_buffers"),
    Facts::of(&CONTROLLER, "tx_event_fifo"),
    Facts::of(&CONTROLLER, "tx_buffers"),
];

/// The sections that are wanted in a Message RAM. A section that is not named has no elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MCanMemory {
    ram_bytes: u32,
    origin: u32,
    areas: [Area; SECTIONS],
    tx_fifo: u32,
}

impl MCanMemory {
    /// An empty layout in a Message RAM of so many bytes. The RAM is at most 64 KiB (1.2); an M_CAN uses at most 17 408 bytes
    /// of it (2.4).
    #[must_use]
    pub const fn new(ram_bytes: u32) -> Self {
        Self { ram_bytes, origin: 0, areas: [Area::NONE; SECTIONS], tx_fifo: 0 }
    }

    /// With packed sections from this byte on: for a RAM that several M_CANs share.
    #[must_use]
    pub const fn origin(mut self, byte: u32) -> Self {
        self.origin = byte;
        self
    }

    /// With so many standard filter elements, 128 at most.
    #[must_use]
    pub const fn standard_filters(mut self, elements: u32) -> Self {
        self.areas[STANDARD].elements = elements;
        self
    }

    /// With so many extended filter elements, 64 at most.
    #[must_use]
    pub const fn extended_filters(mut self, elements: u32) -> Self {
        self.areas[EXTENDED].elements = elements;
        self
    }

    /// With an Rx FIFO 0 of so many elements, 64 at most.
    #[must_use]
    pub const fn rx_fifo_0(mut self, elements: u32, payload: DataFieldSize) -> Self {
        self.areas[FIFO_0] = self.areas[FIFO_0].sized(elements, payload);
        self
    }

    /// With an Rx FIFO 1 of so many elements, 64 at most.
    #[must_use]
    pub const fn rx_fifo_1(mut self, elements: u32, payload: DataFieldSize) -> Self {
        self.areas[FIFO_1] = self.areas[FIFO_1].sized(elements, payload);
        self
    }

    /// With so many dedicated Rx Buffers, 64 at most.
    #[must_use]
    pub const fn rx_buffers(mut self, elements: u32, payload: DataFieldSize) -> Self {
        self.areas[BUFFERS] = self.areas[BUFFERS].sized(elements, payload);
        self
    }

    /// With a Tx Event FIFO of so many elements, 32 at most.
    #[must_use]
    pub const fn tx_event_fifo(mut self, elements: u32) -> Self {
        self.areas[EVENTS].elements = elements;
        self
    }

    /// With so many dedicated Tx Buffers and so many of the Tx FIFO or Tx Queue, 32 at most together.
    #[must_use]
    pub const fn tx_buffers(mut self, dedicated: u32, fifo: u32, payload: DataFieldSize) -> Self {
        self.areas[TX] = self.areas[TX].sized(dedicated.saturating_add(fifo), payload);
        self.tx_fifo = fifo;
        self
    }

    /// With the standard filters here.
    #[must_use]
    pub const fn standard_filters_at(mut self, start: Start) -> Self {
        self.areas[STANDARD].start = start;
        self
    }

    /// With the extended filters here.
    #[must_use]
    pub const fn extended_filters_at(mut self, start: Start) -> Self {
        self.areas[EXTENDED].start = start;
        self
    }

    /// With Rx FIFO 0 here.
    #[must_use]
    pub const fn rx_fifo_0_at(mut self, start: Start) -> Self {
        self.areas[FIFO_0].start = start;
        self
    }

    /// With Rx FIFO 1 here.
    #[must_use]
    pub const fn rx_fifo_1_at(mut self, start: Start) -> Self {
        self.areas[FIFO_1].start = start;
        self
    }

    /// With the dedicated Rx Buffers here.
    #[must_use]
    pub const fn rx_buffers_at(mut self, start: Start) -> Self {
        self.areas[BUFFERS].start = start;
        self
    }

    /// With the Tx Event FIFO here.
    #[must_use]
    pub const fn tx_event_fifo_at(mut self, start: Start) -> Self {
        self.areas[EVENTS].start = start;
        self
    }

    /// With the Tx Buffers here.
    #[must_use]
    pub const fn tx_buffers_at(mut self, start: Start) -> Self {
        self.areas[TX].start = start;
        self
    }

    /// Places the sections and checks them.
    ///
    /// # Errors
    ///
    /// Too many elements, a start that is no multiple of 4, two sections that overlap, a section that ends behind the RAM or
    /// behind the 64 KiB that start addresses reach (2.4.1).
    pub const fn plan(&self) -> Result<MCanPlan, LayoutError> {
        let mut sections =
            [Placed { name: SectionName::single(""), start: 0, elements: 0, element_bytes: 0, used: false }; SECTIONS];
        let (mut next, mut i) = (self.origin, 0);
        while i < SECTIONS {
            let (facts, area) = (&FACTS[i], &self.areas[i]);
            let name = SectionName::single(facts.name());
            ok!(facts.check_elements(name, area.elements));
            let payload = match area.payload.number() {
                Some(bytes) => bytes,
                None => 0,
            };
            let start = match area.start {
                Start::At(byte) => byte,
                Start::Packed => next,
            };
            let used = area.elements > 0;
            let placed =
                Placed { name, start, elements: area.elements, element_bytes: facts.element_bytes(0, payload), used };
            if used {
                ok!(facts.check_start(name, start));
                ok!(check_end(&placed, self.ram_bytes as u64, facts.window()));
                next = placed.end() as u32;
            }
            ok!(no_overlap(&sections, i, &placed));
            sections[i] = placed;
            i += 1;
        }
        Ok(MCanPlan::new(sections, self.areas, self.tx_fifo))
    }

    /// The plan of a layout that is known to be possible: for a `const`, where an impossible one does not compile.
    ///
    /// # Panics
    ///
    /// If [`Self::plan`] finds something wrong.
    #[must_use]
    #[track_caller]
    pub const fn fixed(&self) -> MCanPlan {
        match self.plan() {
            Ok(plan) => plan,
            Err(error) => panic!("{}", error.text()),
        }
    }
}

const fn no_overlap(sections: &[Placed; SECTIONS], count: usize, placed: &Placed) -> Result<(), LayoutError> {
    let mut i = 0;
    while i < count {
        let other = sections[i];
        if other.overlaps(placed) {
            let (first, second) = if other.start <= placed.start { (other, *placed) } else { (*placed, other) };
            return Err(LayoutError::Overlap { first, second });
        }
        i += 1;
    }
    Ok(())
}

/// A checked layout with its register values. They hold sizes and start addresses; watermarks and modes are 0 and may be
/// added. All registers take writes only with `CCCR.INIT` and `CCCR.CCE`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MCanPlan {
    /// Standard filters: `LSS` and `FLSSA` (2.3.21).
    pub sidfc: Sidfc,
    /// Extended filters: `LSE` and `FLESA` (2.3.22).
    pub xidfc: Xidfc,
    /// Rx FIFO 0: `F0S` and `F0SA` (2.3.27).
    pub rxf0c: Rxf0c,
    /// Rx FIFO 1: `F1S` and `F1SA` (2.3.31).
    pub rxf1c: Rxf1c,
    /// Rx Buffers: `RBSA` (2.3.30).
    pub rxbc: Rxbc,
    /// Data field sizes of received messages (2.3.34).
    pub rxesc: Rxesc,
    /// Tx Event FIFO: `EFS` and `EFSA` (2.3.45).
    pub txefc: Txefc,
    /// Tx Buffers: `NDTB`, `TFQS` and `TBSA` (2.3.35).
    pub txbc: Txbc,
    /// Data field size of messages to send (2.3.37).
    pub txesc: Txesc,
    sections: [Placed; SECTIONS],
}

impl MCanPlan {
    const fn new(sections: [Placed; SECTIONS], areas: [Area; SECTIONS], tx_fifo: u32) -> Self {
        let mut starts = [0u16; SECTIONS];
        let mut i = 0;
        while i < SECTIONS {
            if sections[i].used {
                starts[i] = FACTS[i].start_code(sections[i].start) as u16;
            }
            i += 1;
        }
        Self {
            sidfc: Sidfc::RESET.with_lss(sections[STANDARD].elements as u8).with_flssa(starts[STANDARD]),
            xidfc: Xidfc::RESET.with_lse(sections[EXTENDED].elements as u8).with_flesa(starts[EXTENDED]),
            rxf0c: Rxf0c::RESET.with_f0s(sections[FIFO_0].elements as u8).with_f0sa(starts[FIFO_0]),
            rxf1c: Rxf1c::RESET.with_f1s(sections[FIFO_1].elements as u8).with_f1sa(starts[FIFO_1]),
            rxbc: Rxbc::RESET.with_rbsa(starts[BUFFERS]),
            rxesc: Rxesc::RESET
                .with_f0ds(areas[FIFO_0].payload)
                .with_f1ds(areas[FIFO_1].payload)
                .with_rbds(areas[BUFFERS].payload),
            txefc: Txefc::RESET.with_efs(sections[EVENTS].elements as u8).with_efsa(starts[EVENTS]),
            txbc: Txbc::RESET
                .with_ndtb((sections[TX].elements - tx_fifo) as u8)
                .with_tfqs(tx_fifo as u8)
                .with_tbsa(starts[TX]),
            txesc: Txesc::RESET.with_tbds(areas[TX].payload),
            sections,
        }
    }

    /// The sections that have elements, in the order of Figure 2. Offsets are bytes from the start of the Message RAM.
    pub fn sections(&self) -> impl Iterator<Item = Placed> + '_ {
        self.sections.iter().copied().filter(|section| section.used)
    }

    /// The standard filters.
    #[must_use]
    pub const fn standard_filters(&self) -> Placed {
        self.sections[STANDARD]
    }

    /// The extended filters.
    #[must_use]
    pub const fn extended_filters(&self) -> Placed {
        self.sections[EXTENDED]
    }

    /// Rx FIFO 0.
    #[must_use]
    pub const fn rx_fifo_0(&self) -> Placed {
        self.sections[FIFO_0]
    }

    /// Rx FIFO 1.
    #[must_use]
    pub const fn rx_fifo_1(&self) -> Placed {
        self.sections[FIFO_1]
    }

    /// The dedicated Rx Buffers.
    #[must_use]
    pub const fn rx_buffers(&self) -> Placed {
        self.sections[BUFFERS]
    }

    /// The Tx Event FIFO.
    #[must_use]
    pub const fn tx_event_fifo(&self) -> Placed {
        self.sections[EVENTS]
    }

    /// The Tx Buffers: the dedicated ones first, then those of the FIFO or queue.
    #[must_use]
    pub const fn tx_buffers(&self) -> Placed {
        self.sections[TX]
    }

    /// The byte behind the last section.
    #[must_use]
    pub const fn end(&self) -> u32 {
        let (mut end, mut i) = (0, 0);
        while i < SECTIONS {
            if self.sections[i].used && self.sections[i].end() > end {
                end = self.sections[i].end();
            }
            i += 1;
        }
        end as u32
    }
}
