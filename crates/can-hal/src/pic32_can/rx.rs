//! Receiving (34.6.3, 34.9).

use can_frame::Frame;
use pic32_can_pac::{messages::RxDataBuffer, registers as pac};
use regbus::Bus;

use super::{Can, Inner, element, fifo::Kind};
use crate::{Overflow, mode::OnBus};

/// A received message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RxMessage {
    /// The frame.
    pub frame: Frame,
    /// The filter that has accepted it.
    pub filter: u8,
    /// The time stamp timer right after the end of the frame; `None` without time stamps.
    pub timestamp: Option<u16>,
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// The buffer of the oldest message of a receive FIFO of a kind; `None` if there is none.
    #[inline]
    fn oldest(&mut self, number: u8, kind: Kind) -> Result<Option<usize>, Overflow> {
        let Some(fifo) = self.fifos.get(usize::from(number)).filter(|fifo| fifo.kind == kind) else { return Ok(None) };
        let registers = self.regs.fifo(usize::from(number % 32));
        let flags = registers.int_().read();
        if flags.rxovflif() {
            // 34.12.3: sticky. One store, so that no other bit changes.
            registers.int_().clear_bits(pac::FifoInt::RXOVFLIF);
            return Err(Overflow { fifo: number });
        }
        let offset = || (fifo.checked(registers.ua().read().bits(), self.base) - self.address) as usize;
        Ok(flags.rxnemptyif().then(offset))
    }

    /// 34.6.3: the message has been read. UINC through the SET register: a read of CiFIFOCONn would destroy its flags.
    #[inline]
    fn take(&self, number: u8) {
        self.regs.fifo(usize::from(number % 32)).con().set_bits(pac::FifoCon::UINC);
    }

    #[inline]
    pub(super) fn receive(&mut self, number: u8) -> Result<Option<RxMessage>, Overflow> {
        let Some(offset) = self.oldest(number, Kind::Receive)? else { return Ok(None) };
        let message = element::read(self.ram, offset, self.timestamps);
        self.take(number);
        Ok(Some(message))
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// The oldest message of a receive FIFO (34.6.3). `None` if it has none, or is no FIFO for full messages.
    ///
    /// # Errors
    /// [`Overflow`], once, if messages were lost since the last time; RXOVFLIF is cleared by that.
    pub fn receive_fifo(&mut self, fifo: u8) -> Result<Option<RxMessage>, Overflow> {
        self.inner.receive(fifo)
    }

    /// The oldest message of a data-only FIFO: eight bytes, those beyond the length of the message 0. Its identifier and
    /// length are not kept (34.9.1). `None` if it has none, or is no such FIFO.
    ///
    /// # Errors
    /// As for [`Can::receive_fifo`].
    pub fn receive_data(&mut self, fifo: u8) -> Result<Option<[u8; 8]>, Overflow> {
        let inner = &mut self.inner;
        let Some(offset) = inner.oldest(fifo, Kind::ReceiveData)? else { return Ok(None) };
        let mut data = [0; 8];
        RxDataBuffer::new(inner.ram, offset).payload().read(&mut data);
        inner.take(fifo);
        Ok(Some(data))
    }

    /// The flags of a FIFO, which follow its fill level, and its overflow flag (Register 34-21).
    #[must_use]
    pub fn fifo_flags(&self, fifo: u8) -> pac::FifoInt {
        self.inner.regs.fifo(usize::from(fifo % 32)).int_().read()
    }

    /// The filter that has matched last (34.12.7).
    #[must_use]
    pub fn last_filter(&self) -> u8 {
        self.inner.regs.vec().read().filhit().bits()
    }
}
