//! FIFOs in system RAM, as the driver needs them (34.6).

use pic32_can_pac::{
    Mmio,
    enums::{FifoConDonly, FifoConTxen},
    messages::{RxBuffer, RxDataBuffer, TxBuffer},
    registers::FifoCon,
};
use regbus::Bus;

use super::{ConfigError, FIFOS};
use crate::{Region, memory::Pic32CanPlan};

/// What a FIFO is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Nothing: it is not in the plan, or takes room only.
    Unused,
    Transmit,
    Receive,
    ReceiveData,
}

/// One FIFO.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fifo {
    pub(super) kind: Kind,
    pub(super) depth: u8,
    /// Distance of its first buffer from the base of FIFO 0, in words.
    words: u16,
    /// The next buffer that software writes, of a transmit FIFO.
    pub(super) head: u8,
    /// Messages that lie in its buffers and are put in when Configuration mode ends.
    pub(super) preloaded: u8,
    /// Messages put in since the driver was made, and how many of them were there when the FIFO was reset last.
    pub(super) queued: u16,
    pub(super) base: u16,
    /// The messages that the last abort was meant for: from, to; and the first of them that was not sent.
    pub(super) asked: (u16, u16),
    pub(super) cancelled_from: u16,
}

impl Fifo {
    const UNUSED: Self = Self {
        kind: Kind::Unused,
        depth: 1,
        words: 0,
        head: 0,
        preloaded: 0,
        queued: 0,
        base: 0,
        asked: (0, 0),
        cancelled_from: 0,
    };

    /// Bytes of a buffer.
    pub(super) const fn element(&self) -> u32 {
        let bytes = match self.kind {
            Kind::Transmit => TxBuffer::<Mmio>::BYTES,
            Kind::Unused | Kind::Receive => RxBuffer::<Mmio>::BYTES,
            Kind::ReceiveData => RxDataBuffer::<Mmio>::BYTES,
        };
        bytes as u32
    }

    /// Physical address of the buffer that CiFIFOUAn has given (34.6.2, 34.6.3). An address outside the FIFO cannot be; it
    /// would count as its first buffer.
    #[inline]
    pub(super) const fn checked(&self, address: u32, base: u32) -> u32 {
        let first = self.first(base);
        let inside = address.wrapping_sub(first) < self.depth as u32 * self.element();
        if inside { address } else { first }
    }

    /// Physical address of its first buffer; `base` is that of FIFO 0.
    const fn first(&self, base: u32) -> u32 {
        base + self.words as u32 * 4
    }

    /// Physical address of the next buffer that software writes, worked out: CiFIFOUAn is not valid in Configuration mode
    /// (Register 34-22).
    pub(super) const fn head_address(&self, base: u32) -> u32 {
        self.first(base) + self.head as u32 * self.element()
    }

    /// FSIZE, TXEN and DONLY; those of a FIFO that was never set up for one that takes room only.
    pub(super) const fn con(&self) -> FifoCon {
        let con = FifoCon::RESET.with_fsize((self.depth - 1) & 31);
        match self.kind {
            Kind::Unused | Kind::Receive => con,
            Kind::Transmit => con.with_txen(FifoConTxen::Transmit),
            Kind::ReceiveData => con.with_donly(FifoConDonly::DataOnly),
        }
    }

    /// The head moves on by one message; returns its number.
    #[inline]
    pub(super) const fn advance(&mut self) -> u16 {
        let number = self.queued;
        self.queued = number.wrapping_add(1);
        self.head = if self.head + 1 < self.depth { self.head + 1 } else { 0 };
        number
    }

    /// 34.6.4: the FIFO has been reset; what was in it is gone.
    pub(super) const fn forget(&mut self) {
        self.head = 0;
        self.preloaded = 0;
        self.base = self.queued;
    }
}

/// Every FIFO of a plan, checked to lie in the region.
pub(super) fn place<M: Bus>(plan: &Pic32CanPlan, region: &Region<M>) -> Result<[Fifo; FIFOS], ConfigError> {
    let mut fifos = [Fifo::UNUSED; FIFOS];
    let end = u64::from(region.address()) + u64::from(region.bytes());
    for (number, fifo) in plan.fifos() {
        let placed = fifo.placed;
        if placed.start < region.address() || placed.end() > end {
            return Err(ConfigError::OutsideRegion(placed));
        }
        let kind = match (placed.used, fifo.con.txen(), fifo.con.donly()) {
            (false, ..) => Kind::Unused,
            (true, FifoConTxen::Transmit, _) => Kind::Transmit,
            (true, FifoConTxen::Receive, FifoConDonly::FullMessage) => Kind::Receive,
            (true, FifoConTxen::Receive, FifoConDonly::DataOnly) => Kind::ReceiveData,
        };
        // 34.1: FIFOs have 32 messages at most, and all of them together 16 KiB.
        let (depth, words) = (placed.elements as u8, ((placed.start - plan.fifoba) / 4) as u16);
        fifos[usize::from(number) % FIFOS] = Fifo { kind, depth, words, ..Fifo::UNUSED };
    }
    Ok(fifos)
}
