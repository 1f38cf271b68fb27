//! FIFOs of the PIC32 CAN module (34.6), one behind the other in system RAM.

use pic32_can_pac::enums::{FifoConDonly, FifoConTxen};
use pic32_can_pac::meta::CONTROLLER;
use pic32_can_pac::registers::FifoCon;

use super::facts::{Facts, check_end};
use super::{LayoutError, Placed, SectionName, ok};

const FIFO: Facts = Facts::of(&CONTROLLER, "fifo");

/// The number of FIFOs.
const FIFOS: usize = FIFO.repeated().0;
/// The number of the first.
const FIRST: u8 = FIFO.repeated().1;

/// The layouts in the order of the description.
const TRANSMIT: usize = 0;
const RECEIVE: usize = 1;
const RECEIVE_DATA: usize = 2;

/// What a FIFO is set up for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pic32CanFifo {
    /// Messages to send, 16 bytes each.
    Transmit {
        /// Number of messages, 1 to 32.
        elements: u32,
    },
    /// Received messages with identifier, length, filter and time stamp, 16 bytes each.
    Receive {
        /// Number of messages, 1 to 32.
        elements: u32,
    },
    /// Data of received messages and nothing else, 8 bytes each (34.9.1).
    ReceiveData {
        /// Number of messages, 1 to 32.
        elements: u32,
    },
}

impl Pic32CanFifo {
    const fn parts(self) -> (u32, usize) {
        match self {
            Self::Transmit { elements } => (elements, TRANSMIT),
            Self::Receive { elements } => (elements, RECEIVE),
            Self::ReceiveData { elements } => (elements, RECEIVE_DATA),
        }
    }

    /// What a FIFO is that nobody set up.
    const fn reset() -> Self {
        let con = FifoCon::RESET;
        let elements = con.fsize() as u32 + FIFO.min();
        match (con.txen(), con.donly()) {
            (FifoConTxen::Transmit, _) => Self::Transmit { elements },
            (FifoConTxen::Receive, FifoConDonly::FullMessage) => Self::Receive { elements },
            (FifoConTxen::Receive, FifoConDonly::DataOnly) => Self::ReceiveData { elements },
        }
    }
}

/// The FIFOs that are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pic32CanMemory {
    base: u32,
    ram_bytes: u32,
    fifos: [Option<Pic32CanFifo>; FIFOS],
    wrong_fifo: Option<u8>,
}

impl Pic32CanMemory {
    /// An empty layout in so many bytes of RAM from the physical address `base` on, a multiple of 4.
    #[must_use]
    pub const fn new(base: u32, ram_bytes: u32) -> Self {
        Self { base, ram_bytes, fifos: [None; FIFOS], wrong_fifo: None }
    }

    /// With FIFO `number`, 0 to 31. Lower FIFOs that are not set up take room too: one message of 16 bytes (34.6.1).
    #[must_use]
    pub const fn fifo(mut self, number: u8, fifo: Pic32CanFifo) -> Self {
        match number.checked_sub(FIRST) {
            Some(index) if (index as usize) < FIFOS => self.fifos[index as usize] = Some(fifo),
            _ => self.wrong_fifo = Some(number),
        }
        self
    }

    /// Places the FIFOs and checks them.
    ///
    /// # Errors
    ///
    /// A FIFO that does not exist, too many or no messages, a base that is no multiple of 4, a FIFO that ends behind the RAM.
    pub const fn plan(&self) -> Result<Pic32CanPlan, LayoutError> {
        if let Some(number) = self.wrong_fifo {
            return Err(LayoutError::NoSuchFifo { number, first: FIRST, last: FIRST + FIFOS as u8 - 1 });
        }
        let ram_end = self.base as u64 + self.ram_bytes as u64;
        let mut plan = Pic32CanPlan { fifoba: self.base, fifos: [None; FIFOS] };
        ok!(FIFO.check_start(SectionName::numbered(FIFO.name(), FIRST), self.base));
        let mut count = FIFOS;
        while count > 0 && self.fifos[count - 1].is_none() {
            count -= 1;
        }
        let (mut next, mut i) = (self.base, 0);
        while i < count {
            let (fifo, used) = match self.fifos[i] {
                Some(fifo) => (fifo, true),
                None => (Pic32CanFifo::reset(), false),
            };
            let (elements, layout) = fifo.parts();
            let name = SectionName::numbered(FIFO.name(), FIRST + i as u8);
            ok!(FIFO.check_elements(name, elements));
            let element_bytes = FIFO.element_bytes(layout, FIFO.only_payload(layout));
            let placed = Placed { name, start: next, elements, element_bytes, used };
            ok!(check_end(&placed, ram_end, FIFO.window()));
            next = placed.end() as u32;
            plan.fifos[i] = Some(Pic32CanFifoPlan::new(fifo, placed));
            i += 1;
        }
        Ok(plan)
    }

    /// The plan of a layout that is known to be possible: for a `const`, where an impossible one does not compile.
    ///
    /// # Panics
    ///
    /// If [`Self::plan`] finds something wrong.
    #[must_use]
    #[track_caller]
    pub const fn fixed(&self) -> Pic32CanPlan {
        match self.plan() {
            Ok(plan) => plan,
            Err(error) => panic!("{}", error.text()),
        }
    }
}

/// A FIFO at its place, with its register value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pic32CanFifoPlan {
    /// `FSIZE`, `TXEN` and `DONLY` (Register 34-20); `FSIZE` and `DONLY` take writes only in Configuration mode.
    pub con: FifoCon,
    /// Its place.
    pub placed: Placed,
}

impl Pic32CanFifoPlan {
    const fn new(fifo: Pic32CanFifo, placed: Placed) -> Self {
        let (txen, donly) = match fifo {
            Pic32CanFifo::Transmit { .. } => (FifoConTxen::Transmit, FifoConDonly::FullMessage),
            Pic32CanFifo::Receive { .. } => (FifoConTxen::Receive, FifoConDonly::FullMessage),
            Pic32CanFifo::ReceiveData { .. } => (FifoConTxen::Receive, FifoConDonly::DataOnly),
        };
        let size = FIFO.count_code(placed.elements) as u8;
        Self { con: FifoCon::RESET.with_fsize(size).with_txen(txen).with_donly(donly), placed }
    }
}

/// A checked layout with its register values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pic32CanPlan {
    /// For `CiFIFOBA`: the physical address at which FIFO 0 begins.
    pub fifoba: u32,
    fifos: [Option<Pic32CanFifoPlan>; FIFOS],
}

impl Pic32CanPlan {
    /// FIFO `number`, 0 to 31; `None` if it takes no room.
    #[must_use]
    pub const fn fifo(&self, number: u8) -> Option<Pic32CanFifoPlan> {
        match number.checked_sub(FIRST) {
            Some(index) if (index as usize) < FIFOS => self.fifos[index as usize],
            _ => None,
        }
    }

    /// The FIFOs that take room, with their numbers.
    pub fn fifos(&self) -> impl Iterator<Item = (u8, Pic32CanFifoPlan)> + '_ {
        (FIRST..).zip(self.fifos.iter()).filter_map(|(number, fifo)| Some((number, (*fifo)?)))
    }

    /// The FIFOs that take room, by address.
    pub fn sections(&self) -> impl Iterator<Item = Placed> + '_ {
        self.fifos.iter().flatten().map(|fifo| fifo.placed)
    }

    /// The address behind the last FIFO.
    #[must_use]
    pub fn end(&self) -> u32 {
        self.sections().last().map_or(self.fifoba, |section| section.end() as u32)
    }
}
