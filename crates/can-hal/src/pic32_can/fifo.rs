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
    /// Offset of its first buffer in the region.
    offset: u32,
    /// FSIZE, TXEN and DONLY.
    pub(super) con: FifoCon,
    /// The next buffer that software writes, of a transmit FIFO.
    pub(super) head: u8,
    /// Messages that lie in its buffers and are put in when Configuration mode ends.
    pub(super) preloaded: u8,
    /// Messages put in since the driver was made, and how many of them were there when the FIFO was reset last.
    pub(super) queued: u32,
    pub(super) base: u32,
    /// The messages that the last abort was meant for: from, to; and the first of them that was not sent.
    pub(super) asked: (u32, u32),
    pub(super) cancelled_from: u32,
}

impl Fifo {
    const UNUSED: Self = Self {
        kind: Kind::Unused,
        depth: 1,
        offset: 0,
        con: FifoCon::RESET,
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

    /// Offset in the region of the buffer at a physical address that CiFIFOUAn has given (34.6.2, 34.6.3). An address
    /// outside the FIFO cannot be; it would count as its first buffer.
    #[inline]
    pub(super) const fn offset_of(&self, address: u32, region: u32) -> usize {
        let distance = address.wrapping_sub(region).wrapping_sub(self.offset);
        let inside = distance < self.depth as u32 * self.element();
        (self.offset + if inside { distance } else { 0 }) as usize
    }

    /// Offset of the next buffer that software writes, worked out: CiFIFOUAn is not valid in Configuration mode
    /// (Register 34-22).
    pub(super) const fn head_offset(&self) -> usize {
        (self.offset + self.head as u32 * self.element()) as usize
    }

    /// The head moves on by one message; returns its number.
    #[inline]
    pub(super) const fn advance(&mut self) -> u32 {
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
        let offset = placed.start.checked_sub(region.address()).filter(|_| placed.end() <= end);
        let Some(offset) = offset else { return Err(ConfigError::OutsideRegion(placed)) };
        let kind = match (placed.used, fifo.con.txen(), fifo.con.donly()) {
            (false, ..) => Kind::Unused,
            (true, FifoConTxen::Transmit, _) => Kind::Transmit,
            (true, FifoConTxen::Receive, FifoConDonly::FullMessage) => Kind::Receive,
            (true, FifoConTxen::Receive, FifoConDonly::DataOnly) => Kind::ReceiveData,
        };
        let depth = placed.elements as u8;
        fifos[usize::from(number) % FIFOS] = Fifo { kind, depth, offset, con: fifo.con, ..Fifo::UNUSED };
    }
    Ok(fifos)
}
