//! The transmit event FIFO (7.0).

use can_frame::{Dlc, Format, Id};
use dspic33_canfd_pac::{
    messages::{RxObjectR2, TefObject, TefObjectTs},
    registers as pac,
};
use regbus::Bus;

use super::{
    Can, Inner,
    object::{decode_dlc, decode_format, decode_id},
};
use crate::{error::Overflow, mode::OnBus};

/// A record about a frame that was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TxEvent {
    /// The frame's identifier.
    pub id: Id,
    /// Its format.
    pub format: Format,
    /// Its data length code.
    pub dlc: Dlc,
    /// The sequence number it was sent with.
    pub sequence: u32,
    /// When it was sent; `None` if events are planned without timestamps.
    pub timestamp: Option<u32>,
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// TEFTSEN and the enables that INTL.TEFIF needs to tell of events (12.1.6).
    pub(super) fn event_control(&self) -> pac::TefconL {
        let enables = pac::TefconL::TEFOVIE | pac::TefconL::TEFNEIE;
        let stamped = self.layout.tefcon_l.teftsen();
        if self.layout.stef { enables.with_teftsen(stamped) } else { pac::TefconL::ZERO }
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// The oldest event (7.1). There are none if the plan has no event FIFO.
    ///
    /// # Errors
    /// [`Overflow`], once, if events were lost since the last time; TEFOVIF is cleared by that.
    pub fn tx_event(&mut self) -> Result<Option<TxEvent>, Overflow> {
        let inner = &self.inner;
        let status = inner.regs.tefsta().read();
        if status.tefovif() {
            inner.regs.tefsta().clear(pac::Tefsta::TEFOVIF);
            return Err(Overflow { fifo: 0 });
        }
        if !inner.layout.stef || !status.tefneif() {
            return Ok(None);
        }
        // tef_address: the user address is the address of the object.
        let at = inner.offset(inner.regs.read_tefua());
        let object = TefObject::new(inner.ram, at);
        let (te0, te1, te2) = (object.te0().read(), object.te1().read(), object.te2().read());
        let stamped = inner.layout.tefcon_l.teftsen();
        let control = RxObjectR2::from_bits(te2.bits());
        let event = TxEvent {
            id: decode_id(te0, te1, te2.ide()),
            format: decode_format(control),
            dlc: decode_dlc(control),
            sequence: object.read_seq(),
            timestamp: stamped.then(|| TefObjectTs::new(inner.ram, at).read_txmsgts()),
        };
        inner.regs.tefcon_l().write(inner.event_control().with_uinc(true));
        Ok(Some(event))
    }
}
