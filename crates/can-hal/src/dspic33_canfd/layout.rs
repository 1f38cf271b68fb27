//! Sections of the message memory, as the driver needs them (5.4).

use dspic33_canfd_pac::{
    enums::FifoConLTxen,
    messages::{RxObject, RxObjectTs, TefObject, TxObject},
    registers::{FifoConH, FifoConL, TefconH, TefconL, TxqconH},
};
use regbus::{Bus, Mmio};

use super::ConfigError;
use crate::{
    Region,
    memory::{DsPic33CanFdPlan, Placed},
};

/// Objects of the queue, a FIFO, or the event FIFO. An object has 76 bytes at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) struct Section {
    /// Offset of the first object in the region.
    offset: u32,
    /// Bytes of an object.
    element: u8,
    pub(super) count: u8,
    /// Bytes before the data.
    header: u8,
}

impl Section {
    fn new<M: Bus>(placed: Placed, header: usize, region: &Region<M>) -> Result<Self, ConfigError> {
        let end = u64::from(region.address()) + u64::from(region.bytes());
        match placed.start.checked_sub(region.address()) {
            Some(offset) if placed.end() <= end => Ok(Self {
                offset,
                element: placed.element_bytes as u8,
                count: placed.elements as u8,
                header: header as u8,
            }),
            _ => Err(ConfigError::OutsideRegion(placed)),
        }
    }

    /// Offset of an object.
    #[inline]
    pub(super) const fn at(&self, index: u8) -> usize {
        self.offset as usize + self.element as usize * index as usize
    }

    /// The object at an offset.
    #[inline]
    pub(super) fn index(&self, offset: usize) -> u8 {
        let distance = offset.saturating_sub(self.offset as usize);
        (distance / usize::from(self.element.max(1))) as u8
    }

    /// Data bytes of an object.
    #[inline]
    pub(super) const fn data(&self) -> usize {
        self.element.saturating_sub(self.header) as usize
    }

    #[inline]
    pub(super) const fn header(&self) -> usize {
        self.header as usize
    }
}

/// A plan whose sections lie in a region.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub(super) fifoba: u32,
    pub(super) stef: bool,
    pub(super) txqen: bool,
    pub(super) tefcon_l: TefconL,
    pub(super) tefcon_h: TefconH,
    pub(super) txqcon_h: TxqconH,
    /// Index 0 is the queue.
    pub(super) objects: [Section; 32],
    /// TXEN and RXTSEN, FSIZE and PLSIZE of each FIFO; reset values for those that are not set up. Index 0 is not used.
    pub(super) fifos: [(FifoConL, FifoConH); 32],
    /// FIFOs that receive, and those that transmit, bit 0 for the queue.
    pub(super) receive: u32,
    pub(super) transmit: u32,
}

impl Layout {
    pub(super) fn new<M: Bus>(plan: &DsPic33CanFdPlan, region: &Region<M>) -> Result<Self, ConfigError> {
        let section = |placed: Option<Placed>, header: usize| match placed {
            Some(placed) => Section::new(placed, header, region),
            None => Ok(Section::default()),
        };
        let mut layout = Self {
            fifoba: plan.fifoba,
            stef: plan.stef,
            txqen: plan.txqen,
            tefcon_l: plan.tefconl,
            tefcon_h: plan.tefconh,
            txqcon_h: plan.txqconh,
            objects: [Section::default(); 32],
            fifos: [(FifoConL::RESET, FifoConH::RESET); 32],
            receive: 0,
            transmit: u32::from(plan.txqen),
        };
        // The event FIFO is read at its user address; here it only has to lie in the region.
        section(plan.tef, TefObject::<Mmio>::HEADER_BYTES)?;
        layout.objects[0] = section(plan.txq, TxObject::<Mmio>::HEADER_BYTES)?;
        for (number, fifo) in plan.fifos() {
            let bit = 1 << (number % 32);
            let header = match (fifo.conl.txen(), fifo.conl.rxtsen()) {
                (FifoConLTxen::Transmit, _) => {
                    layout.transmit |= if fifo.placed.used { bit } else { 0 };
                    TxObject::<Mmio>::HEADER_BYTES
                }
                (FifoConLTxen::Receive, stamped) => {
                    layout.receive |= if fifo.placed.used { bit } else { 0 };
                    if stamped { RxObjectTs::<Mmio>::HEADER_BYTES } else { RxObject::<Mmio>::HEADER_BYTES }
                }
            };
            let index = usize::from(number % 32);
            layout.fifos[index] = (fifo.conl, fifo.conh);
            layout.objects[index] = Section::new(fifo.placed, header, region)?;
        }
        Ok(layout)
    }

    /// The queue, or the transmit FIFO with the lowest number that answers no remote frames.
    pub(super) const fn first_transmit(&self, replies: u32) -> Option<u8> {
        let usable = self.transmit & !replies;
        if usable == 0 { None } else { Some(usable.trailing_zeros() as u8) }
    }
}

/// The numbers of the bits that are 1, lowest first.
#[inline]
pub(super) fn numbers(mut mask: u32) -> impl Iterator<Item = u8> {
    core::iter::from_fn(move || {
        let bit = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (bit < 32).then_some(bit as u8)
    })
}
