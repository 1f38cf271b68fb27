//! Tx events (2.4.4, 3.5.7).

use can_frame::{Dlc, Format, Id};
use m_can_pac::{
    enums::{CccrUtsu, CccrWmm, TxEventType},
    messages::{TxEvent as Element, TxEventE1b},
    registers as pac,
};
use regbus::Bus;

use super::{
    Can,
    element::{decode_dlc, decode_format, decode_id},
    rx::RxTimestamp,
};
use crate::{error::Overflow, mode::OnBus};

/// What a Tx event reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum TxEventKind {
    /// The frame was sent.
    Sent,
    /// The frame was sent in spite of its cancellation; always so if it is not repeated (3.1.7).
    SentAnyway,
    /// A reserved code.
    Reserved(u8),
}

/// A record about a sent frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TxEvent {
    /// The frame's identifier.
    pub id: Id,
    /// Its format.
    pub format: Format,
    /// Its data length code.
    pub dlc: Dlc,
    /// The message marker it was sent with.
    pub marker: u16,
    /// What is reported.
    pub kind: TxEventKind,
    /// When it was sent; `None` with wide message markers and no Timestamping Unit.
    pub timestamp: Option<RxTimestamp>,
}

/// The bits of an index into the Tx Event FIFO.
const EVENT_INDEX: u8 = 0x1F;

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// The oldest Tx event (3.5.7).
    ///
    /// # Errors
    /// [`Overflow`], once, if events were lost since the last time; IR.TEFL is cleared by that.
    pub fn tx_event(&mut self) -> Result<Option<TxEvent>, Overflow> {
        let inner = &self.inner;
        let status = inner.regs.txefs().read();
        if status.tefl() {
            inner.regs.ir().clear(pac::Ir::TEFL);
            return Err(Overflow { fifo: 0 });
        }
        if status.effl() == 0 {
            return Ok(None);
        }
        let index = status.efgi();
        let element = Element::new(inner.ram, inner.layout.tx_events.at(index));
        let (e0, e1) = (element.e0().read(), element.e1a().read());
        inner.regs.txefa().write(pac::Txefa::ZERO.with_efai(index & EVENT_INDEX));
        let unit = inner.cccr.utsu() == CccrUtsu::External;
        let (marker, timestamp) = if unit || inner.cccr.wmm() == CccrWmm::Bits16 {
            let e1 = TxEventE1b::from_bits(e1.bits());
            let timestamp = unit.then(|| RxTimestamp::Unit(e1.tsc().then(|| e1.txtsp())));
            (u16::from_le_bytes([e1.mm(), e1.mm_high()]), timestamp)
        } else {
            (u16::from(e1.mm()), Some(RxTimestamp::Counter(e1.txts())))
        };
        let kind = match e1.et() {
            Ok(TxEventType::TxEvent) => TxEventKind::Sent,
            Ok(TxEventType::InSpiteOfCancellation) => TxEventKind::SentAnyway,
            Err(code) => TxEventKind::Reserved(code),
        };
        Ok(Some(TxEvent {
            id: decode_id(e0.xtd(), e0.id()),
            format: decode_format(e1.fdf(), e0.rtr(), e1.brs(), e0.esi()),
            dlc: decode_dlc(e1.dlc()),
            marker,
            kind,
            timestamp,
        }))
    }
}
