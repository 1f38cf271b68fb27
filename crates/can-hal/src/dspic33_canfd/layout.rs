//! Sections of the message memory, as the driver needs them (5.4).

use dspic33_canfd_pac::{
    enums::{FifoConLTxen, PayloadSize},
    messages::{RxObject, RxObjectTs, TxObject},
    registers::{FifoConH, TefconH, TefconL, TxqconH},
};
use regbus::{Bus, Mmio};

use super::ConfigError;
use crate::{
    Region,
    memory::{DsPic33CanFdPlan, Placed},
};

/// Bytes before the data of an object without timestamp, and of one with.
const HEADER: usize = TxObject::<Mmio>::HEADER_BYTES;
const STAMPED: usize = RxObjectTs::<Mmio>::HEADER_BYTES;
const _: () = assert!(RxObject::<Mmio>::HEADER_BYTES == HEADER, "a message to send and a received one are alike");

/// Objects of the queue or a FIFO. An object has 76 bytes at most, all objects together less than 128 KiB.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) struct Section {
    /// Offset of the first object in the region, in 32-bit words.
    word: u16,
    /// Bytes of an object, and its highest bit: the objects hold timestamps.
    element: u8,
    pub(super) count: u8,
}

const WITH_TIMESTAMPS: u8 = 0x80;

impl Section {
    fn new<M: Bus>(placed: Placed, stamped: bool, region: &Region<M>) -> Result<Self, ConfigError> {
        let end = u64::from(region.address()) + u64::from(region.bytes());
        let word = placed.start.checked_sub(region.address()).and_then(|offset| u16::try_from(offset / 4).ok());
        match word {
            Some(word) if placed.end() <= end => Ok(Self {
                word,
                element: placed.element_bytes as u8 | if stamped { WITH_TIMESTAMPS } else { 0 },
                count: placed.elements as u8,
            }),
            _ => Err(ConfigError::OutsideRegion(placed)),
        }
    }

    const fn bytes(&self) -> usize {
        (self.element & !WITH_TIMESTAMPS) as usize
    }

    /// Offset of an object.
    #[inline]
    pub(super) const fn at(&self, index: u8) -> usize {
        self.word as usize * 4 + self.bytes() * index as usize
    }

    /// The object at an offset.
    #[inline]
    pub(super) const fn index(&self, offset: usize) -> u8 {
        let bytes = if self.bytes() == 0 { 1 } else { self.bytes() };
        (offset.saturating_sub(self.word as usize * 4) / bytes) as u8
    }

    /// Data bytes of an object.
    #[inline]
    pub(super) const fn data(&self) -> usize {
        self.bytes().saturating_sub(self.header())
    }

    /// The objects hold timestamps.
    #[inline]
    pub(super) const fn stamped(&self) -> bool {
        self.element & WITH_TIMESTAMPS != 0
    }

    /// Bytes before the data.
    #[inline]
    pub(super) const fn header(&self) -> usize {
        if self.stamped() { STAMPED } else { HEADER }
    }

    /// FSIZE and PLSIZE (Register 3-33).
    pub(super) const fn size(&self) -> FifoConH {
        let sizes = TxObject::<Mmio>::PAYLOAD_BYTES;
        let mut code = 0;
        while code + 1 < sizes.len() && sizes[code] < self.data() {
            code += 1;
        }
        let fsize = self.count.saturating_sub(1) & 0x1F;
        FifoConH::RESET.with_plsize(PayloadSize::from_bits(code as u8)).with_fsize(fsize)
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
    /// FIFOs that receive, and those that transmit, bit 0 for the queue.
    pub(super) receive: u32,
    pub(super) transmit: u32,
}

impl Layout {
    pub(super) fn new<M: Bus>(plan: &DsPic33CanFdPlan, region: &Region<M>) -> Result<Self, ConfigError> {
        let section = |placed: Option<Placed>| match placed {
            Some(placed) => Section::new(placed, false, region),
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
            receive: 0,
            transmit: u32::from(plan.txqen),
        };
        // The event FIFO is read at its user address; here it only has to lie in the region.
        section(plan.tef)?;
        layout.objects[0] = section(plan.txq)?;
        for (number, fifo) in plan.fifos() {
            let used = u32::from(fifo.placed.used) << (number % 32);
            let transmits = fifo.conl.txen() == FifoConLTxen::Transmit;
            if transmits {
                layout.transmit |= used;
            } else {
                layout.receive |= used;
            }
            let stamped = !transmits && fifo.conl.rxtsen();
            layout.objects[usize::from(number % 32)] = Section::new(fifo.placed, stamped, region)?;
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
