//! Receiving (3.4): Rx FIFOs and dedicated Rx Buffers.

use can_frame::Frame;
use m_can_pac::{
    enums::{CccrUtsu, FifoMode},
    messages::RxBuffer,
    registers as pac,
};
use regbus::{Bus, Payload};

use super::{
    Can, Inner, SETTLE,
    element::{decode_dlc, decode_format, decode_id},
    layout::Section,
};
use crate::{error::Overflow, mode::OnBus};

/// One of the two Rx FIFOs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RxFifo {
    /// Rx FIFO 0.
    Fifo0,
    /// Rx FIFO 1.
    Fifo1,
}

impl RxFifo {
    pub(super) const fn index(self) -> usize {
        match self {
            Self::Fifo0 => 0,
            Self::Fifo1 => 1,
        }
    }
}

/// RXFnS (2.3.27, 2.3.31).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FifoStatus {
    /// Elements stored, 0 to 64.
    pub level: u8,
    /// Index of the oldest element.
    pub get: u8,
    /// Index of the next element to be written.
    pub put: u8,
    /// The FIFO is full.
    pub full: bool,
    /// A message was lost in blocking mode. Cleared with IR.RF0L or IR.RF1L.
    pub lost: bool,
}

/// When a message was received.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RxTimestamp {
    /// Value of the timestamp counter at the start of the frame.
    Counter(u16),
    /// Number of the Timestamping Unit's register that holds the time of the end of the frame; `None` for a message
    /// whose filter does not ask for it.
    Unit(Option<u8>),
}

/// A received message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RxMessage {
    /// The frame. Data bytes that had no room in the element are 0.
    pub frame: Frame,
    /// Index of the matching filter element in the list for the identifier's length; `None` if none matched.
    pub filter: Option<u8>,
    /// When it was received.
    pub timestamp: RxTimestamp,
}

impl<R: Bus, M: Bus> Inner<R, M> {
    #[inline]
    fn fifo_status(&self, fifo: RxFifo) -> FifoStatus {
        match fifo {
            RxFifo::Fifo0 => {
                let s = self.regs.rxf0s().read();
                FifoStatus { level: s.f0fl(), get: s.f0gi(), put: s.f0pi(), full: s.f0f(), lost: s.rf0l() }
            }
            RxFifo::Fifo1 => {
                let s = self.regs.rxf1s().read();
                FifoStatus { level: s.f1fl(), get: s.f1gi(), put: s.f1pi(), full: s.f1f(), lost: s.rf1l() }
            }
        }
    }

    /// 2.2: the status follows an acknowledge after a delay. As long as the get index is the one just acknowledged, the
    /// status is read again, for a bounded number of times: a FIFO can also have come round to the same index.
    #[inline]
    fn settled_status(&mut self, fifo: RxFifo) -> FifoStatus {
        let mut status = self.fifo_status(fifo);
        if let Some(index) = self.acknowledged[fifo.index()].take() {
            let mut left = SETTLE;
            while status.level > 0 && status.get == index && left > 0 {
                status = self.fifo_status(fifo);
                left -= 1;
            }
        }
        status
    }

    #[inline]
    fn acknowledge(&mut self, fifo: RxFifo, index: u8) {
        // The bound never acts; it tells the compiler that the index fits the field.
        let index = index & FIFO_INDEX;
        match fifo {
            RxFifo::Fifo0 => self.regs.rxf0a().write(pac::Rxf0a::ZERO.with_f0ai(index)),
            RxFifo::Fifo1 => self.regs.rxf1a().write(pac::Rxf1a::ZERO.with_f1ai(index)),
        }
        if self.layout.rx_fifos[fifo.index()].count > 1 {
            self.acknowledged[fifo.index()] = Some(index);
        }
    }

    fn is_overwriting(&self, fifo: RxFifo) -> bool {
        let mode = match fifo {
            RxFifo::Fifo0 => self.regs.rxf0c().read().f0om(),
            RxFifo::Fifo1 => self.regs.rxf1c().read().f1om(),
        };
        mode == FifoMode::Overwrite
    }

    /// 2.4.2
    #[inline]
    fn read_element(&self, section: &Section, index: u8) -> RxMessage {
        let element = RxBuffer::new(self.ram, section.at(index));
        let (r0, r1) = (element.r0().read(), element.r1a().read());
        let format = decode_format(r1.fdf(), r0.rtr(), r1.brs(), r0.esi());
        let payload = Payload::<u32, M>::new(self.ram, element.offset() + RxBuffer::<M>::HEADER_BYTES, section.data());
        let frame = Frame::read_with(decode_id(r0.xtd(), r0.id()), format, decode_dlc(r1.dlc()), |data| {
            payload.read(data);
        });
        let timestamp = match self.cccr.utsu() {
            CccrUtsu::Internal => RxTimestamp::Counter(r1.rxts()),
            CccrUtsu::External => {
                let r1 = m_can_pac::messages::RxBufferR1b::from_bits(r1.bits());
                RxTimestamp::Unit(r1.tsc().then(|| r1.rxtsp()))
            }
        };
        RxMessage { frame, filter: (!r1.anmf()).then(|| r1.fidx()), timestamp }
    }

    /// 3.4.2: reads the oldest element and acknowledges it.
    #[inline]
    pub(super) fn receive(&mut self, fifo: RxFifo) -> Result<Option<RxMessage>, Overflow> {
        let status = self.settled_status(fifo);
        if status.lost {
            let flag = match fifo {
                RxFifo::Fifo0 => pac::Ir::RF0L,
                RxFifo::Fifo1 => pac::Ir::RF1L,
            };
            self.regs.ir().clear(flag);
            return Err(Overflow { fifo: fifo.index() as u8 });
        }
        if status.level == 0 {
            return Ok(None);
        }
        let section = self.layout.rx_fifos[fifo.index()];
        let mut index = status.get;
        // 3.4.2.2: a full FIFO that overwrites is read from behind the element that may be overwritten now.
        if status.full && section.count > 1 && self.is_overwriting(fifo) {
            index = if index + 1 < section.count { index + 1 } else { 0 };
        }
        let message = self.read_element(&section, index);
        self.acknowledge(fifo, index);
        Ok(Some(message))
    }

    /// 2.3.25, 2.3.26
    fn has_new_data(&self, buffer: u8) -> bool {
        let bit = u32::from(buffer) % 32;
        let flags = if buffer < 32 { self.regs.ndat1().read().bits() } else { self.regs.ndat2().read().bits() };
        flags >> bit & 1 == 1
    }

    fn clear_new_data(&self, buffer: u8) {
        let flag = 1 << (u32::from(buffer) % 32);
        if buffer < 32 {
            self.regs.ndat1().clear(pac::Ndat1::from_bits(flag));
        } else {
            self.regs.ndat2().clear(pac::Ndat2::from_bits(flag));
        }
    }
}

/// The bits of an index into an Rx FIFO.
const FIFO_INDEX: u8 = 0x3F;

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// The oldest message of an Rx FIFO (3.4.2). In overwrite mode a full FIFO is read from its second oldest message on,
    /// as the oldest may be overwritten meanwhile.
    ///
    /// # Errors
    /// [`Overflow`], once, if messages were lost since the last time; IR.RF0L or IR.RF1L is cleared by that. In overwrite
    /// mode the controller does not tell (2.3.27).
    pub fn receive_fifo(&mut self, fifo: RxFifo) -> Result<Option<RxMessage>, Overflow> {
        self.inner.receive(fifo)
    }

    /// The status of an Rx FIFO.
    #[must_use]
    pub fn fifo_status(&self, fifo: RxFifo) -> FifoStatus {
        self.inner.fifo_status(fifo)
    }

    /// Reads an element of an Rx FIFO without acknowledging it: a high priority message in the middle (3.4.2, 2.3.24).
    /// `None` if the FIFO has no such element. It is received again when its turn comes.
    #[must_use]
    pub fn peek_fifo(&self, fifo: RxFifo, index: u8) -> Option<RxMessage> {
        let section = &self.inner.layout.rx_fifos[fifo.index()];
        (index < section.count).then(|| self.inner.read_element(section, index))
    }

    /// New Data flags of the dedicated Rx Buffers, one bit each. IR.DRX is cleared before they are read, so that a message
    /// that arrives meanwhile raises it again (3.4.3.1).
    pub fn new_data(&mut self) -> u64 {
        let regs = &self.inner.regs;
        regs.ir().clear(pac::Ir::DRX);
        u64::from(regs.ndat1().read().bits()) | u64::from(regs.ndat2().read().bits()) << 32
    }

    /// The message in a dedicated Rx Buffer, if its New Data flag is set. The buffer is free for the next one afterwards
    /// (3.4.3).
    pub fn receive_buffer(&mut self, buffer: u8) -> Option<RxMessage> {
        let inner = &self.inner;
        if buffer >= inner.layout.rx_buffers.count || !inner.has_new_data(buffer) {
            return None;
        }
        let message = inner.read_element(&inner.layout.rx_buffers, buffer);
        inner.clear_new_data(buffer);
        Some(message)
    }

    /// What an Rx Buffer holds, whatever its New Data flag says: debug messages have none (3.4.4). `None` if there is no
    /// such buffer.
    #[must_use]
    pub fn read_buffer(&self, buffer: u8) -> Option<RxMessage> {
        let section = &self.inner.layout.rx_buffers;
        (buffer < section.count).then(|| self.inner.read_element(section, buffer))
    }
}
