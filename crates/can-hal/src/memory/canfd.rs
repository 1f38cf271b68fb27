//! Message memory of the dsPIC33 CAN FD module (5.4): event FIFO, queue and FIFOs one behind the other in system RAM.

use dspic33_canfd_pac::enums::{FifoConLTxen, PayloadSize};
use dspic33_canfd_pac::meta::CONTROLLER;
use dspic33_canfd_pac::registers::{FifoConH, FifoConL, TefconH, TefconL, TxqconH};

use super::facts::{Facts, check_end};
use super::{LayoutError, Placed, SectionName, ok};

const TEF: Facts = Facts::of(&CONTROLLER, "tef");
const TXQ: Facts = Facts::of(&CONTROLLER, "txq");
const FIFO: Facts = Facts::of(&CONTROLLER, "fifo");

/// The number of FIFOs.
const FIFOS: usize = FIFO.repeated().0;
/// The number of the first.
const FIRST: u8 = FIFO.repeated().1;

/// The layouts of an event in the order of the description: without timestamp, with.
const EVENT: [usize; 2] = [0, 1];
/// The layouts of an object in a FIFO: to send, received, received with timestamp.
const TRANSMIT: usize = 0;
const RECEIVE: [usize; 2] = [1, 2];

const fn bytes(payload: PayloadSize) -> u32 {
    match payload.number() {
        Some(bytes) => bytes,
        None => 0,
    }
}

/// What a FIFO is set up for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DsPic33CanFdFifo {
    /// Messages to send.
    Transmit {
        /// Number of objects, 1 to 32.
        elements: u32,
        /// Data bytes of each.
        payload: PayloadSize,
    },
    /// Received messages.
    Receive {
        /// Number of objects, 1 to 32.
        elements: u32,
        /// Data bytes of each.
        payload: PayloadSize,
        /// With a timestamp in each, which takes 4 bytes.
        timestamps: bool,
    },
}

impl DsPic33CanFdFifo {
    const fn place(&self, number: u8, start: u32, used: bool) -> Placed {
        let (elements, element_bytes) = match *self {
            Self::Transmit { elements, payload } => (elements, FIFO.element_bytes(TRANSMIT, bytes(payload))),
            Self::Receive { elements, payload, timestamps } => {
                (elements, FIFO.element_bytes(RECEIVE[timestamps as usize], bytes(payload)))
            }
        };
        Placed { name: SectionName::numbered(FIFO.name(), number), start, elements, element_bytes, used }
    }

    /// What a FIFO is that nobody set up.
    const fn reset() -> Self {
        let (low, high) = (FifoConL::RESET, FifoConH::RESET);
        let elements = high.fsize() as u32 + FIFO.min();
        match low.txen() {
            FifoConLTxen::Transmit => Self::Transmit { elements, payload: high.plsize() },
            FifoConLTxen::Receive => Self::Receive { elements, payload: high.plsize(), timestamps: low.rxtsen() },
        }
    }
}

/// The sections that are wanted. Event FIFO and queue are off unless named, although a reset switches them on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DsPic33CanFdMemory {
    base: u32,
    ram_bytes: u32,
    tef: Option<(u32, bool)>,
    txq: Option<(u32, PayloadSize)>,
    fifos: [Option<DsPic33CanFdFifo>; FIFOS],
    wrong_fifo: Option<u8>,
}

impl DsPic33CanFdMemory {
    /// An empty layout in so many bytes of RAM from the address `base` on, a multiple of 4.
    #[must_use]
    pub const fn new(base: u32, ram_bytes: u32) -> Self {
        Self { base, ram_bytes, tef: None, txq: None, fifos: [None; FIFOS], wrong_fifo: None }
    }

    /// With a transmit event FIFO of 1 to 32 events, with timestamps or without.
    #[must_use]
    pub const fn tef(mut self, elements: u32, timestamps: bool) -> Self {
        self.tef = Some((elements, timestamps));
        self
    }

    /// With a transmit queue of 1 to 32 objects.
    #[must_use]
    pub const fn txq(mut self, elements: u32, payload: PayloadSize) -> Self {
        self.txq = Some((elements, payload));
        self
    }

    /// With FIFO `number`, 1 to 31. Lower FIFOs that are not set up take room too: one object with 8 data bytes (5.4.6).
    #[must_use]
    pub const fn fifo(mut self, number: u8, fifo: DsPic33CanFdFifo) -> Self {
        match number.checked_sub(FIRST) {
            Some(index) if (index as usize) < FIFOS => self.fifos[index as usize] = Some(fifo),
            _ => self.wrong_fifo = Some(number),
        }
        self
    }

    /// Places the sections and checks them (Equations 5-17 to 5-24).
    ///
    /// # Errors
    ///
    /// A FIFO that does not exist, too many or no elements, a base that is no multiple of 4, a section that ends behind the
    /// RAM.
    pub const fn plan(&self) -> Result<DsPic33CanFdPlan, LayoutError> {
        if let Some(number) = self.wrong_fifo {
            return Err(LayoutError::NoSuchFifo { number, first: FIRST, last: FIRST + FIFOS as u8 - 1 });
        }
        let ram_end = self.base as u64 + self.ram_bytes as u64;
        let mut plan = DsPic33CanFdPlan {
            fifoba: self.base,
            stef: self.tef.is_some(),
            txqen: self.txq.is_some(),
            tefconl: TefconL::RESET,
            tefconh: TefconH::RESET,
            txqconh: TxqconH::RESET,
            tef: None,
            txq: None,
            fifos: [None; FIFOS],
        };
        ok!(TEF.check_start(SectionName::single(TEF.name()), self.base));
        let mut next = self.base;
        if let Some((elements, timestamps)) = self.tef {
            let element_bytes = TEF.element_bytes(EVENT[timestamps as usize], 0);
            let name = SectionName::single(TEF.name());
            let placed = Placed { name, start: next, elements, element_bytes, used: true };
            next = ok!(checked(&TEF, &placed, ram_end));
            plan.tefconl = plan.tefconl.with_teftsen(timestamps);
            plan.tefconh = plan.tefconh.with_fsize(TEF.count_code(elements) as u8);
            plan.tef = Some(placed);
        }
        if let Some((elements, payload)) = self.txq {
            let element_bytes = TXQ.element_bytes(0, bytes(payload));
            let name = SectionName::single(TXQ.name());
            let placed = Placed { name, start: next, elements, element_bytes, used: true };
            next = ok!(checked(&TXQ, &placed, ram_end));
            plan.txqconh = plan.txqconh.with_fsize(TXQ.count_code(elements) as u8).with_plsize(payload);
            plan.txq = Some(placed);
        }
        let mut i = 0;
        while i < last(&self.fifos) {
            let (fifo, used) = match self.fifos[i] {
                Some(fifo) => (fifo, true),
                // Equation 5-24: every FIFO with a lower number counts.
                None => (DsPic33CanFdFifo::reset(), false),
            };
            let placed = fifo.place(FIRST + i as u8, next, used);
            next = ok!(checked(&FIFO, &placed, ram_end));
            plan.fifos[i] = Some(DsPic33CanFdFifoPlan::new(fifo, placed));
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
    pub const fn fixed(&self) -> DsPic33CanFdPlan {
        match self.plan() {
            Ok(plan) => plan,
            Err(error) => panic!("{}", error.text()),
        }
    }
}

/// Checks a section and gives the byte behind it.
const fn checked(facts: &Facts, placed: &Placed, ram_end: u64) -> Result<u32, LayoutError> {
    ok!(facts.check_elements(placed.name, placed.elements));
    ok!(check_end(placed, ram_end, TEF.window()));
    Ok(placed.end() as u32)
}

/// The number of FIFOs that take room.
const fn last(fifos: &[Option<DsPic33CanFdFifo>; FIFOS]) -> usize {
    let mut count = FIFOS;
    while count > 0 && fifos[count - 1].is_none() {
        count -= 1;
    }
    count
}

/// A FIFO at its place, with its register values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DsPic33CanFdFifoPlan {
    /// `TXEN` and `RXTSEN` (Register 3-32).
    pub conl: FifoConL,
    /// `FSIZE` and `PLSIZE` (Register 3-33).
    pub conh: FifoConH,
    /// Its place.
    pub placed: Placed,
}

impl DsPic33CanFdFifoPlan {
    const fn new(fifo: DsPic33CanFdFifo, placed: Placed) -> Self {
        let (txen, payload, timestamps) = match fifo {
            DsPic33CanFdFifo::Transmit { payload, .. } => (FifoConLTxen::Transmit, payload, false),
            DsPic33CanFdFifo::Receive { payload, timestamps, .. } => (FifoConLTxen::Receive, payload, timestamps),
        };
        Self {
            conl: FifoConL::RESET.with_txen(txen).with_rxtsen(timestamps),
            conh: FifoConH::RESET.with_fsize(FIFO.count_code(placed.elements) as u8).with_plsize(payload),
            placed,
        }
    }
}

/// A checked layout with its register values. All of them take writes only in Configuration mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DsPic33CanFdPlan {
    /// For `FIFOBA`: the address at which the memory begins.
    pub fifoba: u32,
    /// For `CxCONH.STEF`: there is an event FIFO.
    pub stef: bool,
    /// For `CxCONH.TXQEN`: there is a queue.
    pub txqen: bool,
    /// `TEFTSEN` of the event FIFO.
    pub tefconl: TefconL,
    /// `FSIZE` of the event FIFO.
    pub tefconh: TefconH,
    /// `FSIZE` and `PLSIZE` of the queue.
    pub txqconh: TxqconH,
    /// Place of the event FIFO.
    pub tef: Option<Placed>,
    /// Place of the queue.
    pub txq: Option<Placed>,
    fifos: [Option<DsPic33CanFdFifoPlan>; FIFOS],
}

impl DsPic33CanFdPlan {
    /// FIFO `number`, 1 to 31; `None` if it takes no room.
    #[must_use]
    pub const fn fifo(&self, number: u8) -> Option<DsPic33CanFdFifoPlan> {
        match number.checked_sub(FIRST) {
            Some(index) if (index as usize) < FIFOS => self.fifos[index as usize],
            _ => None,
        }
    }

    /// The FIFOs that take room, with their numbers.
    pub fn fifos(&self) -> impl Iterator<Item = (u8, DsPic33CanFdFifoPlan)> + '_ {
        (FIRST..).zip(self.fifos.iter()).filter_map(|(number, fifo)| Some((number, (*fifo)?)))
    }

    /// Everything that takes room, by address.
    pub fn sections(&self) -> impl Iterator<Item = Placed> + '_ {
        let fifos = self.fifos.iter().flatten().map(|fifo| fifo.placed);
        self.tef.into_iter().chain(self.txq).chain(fifos)
    }

    /// The address behind the last section.
    #[must_use]
    pub fn end(&self) -> u32 {
        self.sections().last().map_or(self.fifoba, |section| section.end() as u32)
    }
}
