//! Receiving (9.0).

use can_frame::Frame;
use dspic33_canfd_pac::{
    messages::{RxObject, RxObjectTs},
    registers as pac,
};
use regbus::{Bus, Payload};

use super::{
    Can, Inner,
    config::transmits,
    object::{decode_dlc, decode_format, decode_id},
};
use crate::{error::Overflow, mode::OnBus};

/// A received message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RxMessage {
    /// The frame. Data bytes that had no room in the object are 0.
    pub frame: Frame,
    /// The filter that accepted it.
    pub filter: u8,
    /// When it was received; `None` if the FIFO is planned without timestamps.
    pub timestamp: Option<u32>,
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// 9.1.1: reads the object at the user address and releases it.
    #[inline]
    pub(super) fn receive(&mut self, number: u8) -> Result<Option<RxMessage>, Overflow> {
        let fifo = self.fifo(number);
        let status = fifo.sta().read();
        if status.rxovif() {
            // 12.1.4
            fifo.sta().clear(pac::FifoSta::RXOVIF);
            return Err(Overflow { fifo: number });
        }
        if !status.tfnrfnif() {
            return Ok(None);
        }
        let at = self.offset(fifo.read_ua());
        let message = self.read_object(number, at);
        fifo.con_l().write(self.fifo_control(number).with_uinc(true));
        Ok(Some(message))
    }

    /// Table 9-1.
    #[inline]
    fn read_object(&self, number: u8, at: usize) -> RxMessage {
        let section = self.layout.objects[usize::from(number) % 32];
        let object = RxObject::new(self.ram, at);
        let (r0, r1, r2) = (object.r0().read(), object.r1().read(), object.r2().read());
        let timestamp = section.stamped().then(|| RxObjectTs::new(self.ram, at).read_rxmsgts());
        let payload = Payload::<u16, M>::new(self.ram, at + section.header(), section.data());
        let frame = Frame::read_with(decode_id(r0, r1, r2.ide()), decode_format(r2), decode_dlc(r2), |data| {
            payload.read(data);
        });
        let frame = frame.with_remote_request_substitution(r1.sid11());
        RxMessage { frame, filter: r2.filhit().bits(), timestamp }
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// The oldest message of a receive FIFO (9.1.1); `None` if there is none, or if the FIFO does not receive.
    ///
    /// # Errors
    /// [`Overflow`], once, if messages were lost since the last time; RXOVIF is cleared by that.
    pub fn receive_fifo(&mut self, fifo: u8) -> Result<Option<RxMessage>, Overflow> {
        if !transmits(self.inner.layout.receive, fifo) {
            return Ok(None);
        }
        self.inner.receive(fifo)
    }
}
