//! Frames as message buffers (34.7.1, 34.9).

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};
use pic32_can_pac::{
    enums::{FrameType, IdentifierType},
    messages::{RxBuffer, TxBuffer, TxBufferCmsgeid, TxBufferCmsgsid},
};
use regbus::Bus;

use super::{RxMessage, filter::split};

/// Table 34-2, Figure 34-12: SRR is 1 in an extended message. Bits without a field are 0, data bytes beyond the length too.
#[inline]
pub(super) fn write<M: Bus>(ram: M, offset: usize, frame: &Frame) {
    let buffer = TxBuffer::new(ram, offset);
    let kind = if frame.is_remote() { FrameType::RemoteFrame } else { FrameType::DataFrame };
    // DLC stands in the lowest bits; its setter has a check that never fails here.
    let word = TxBufferCmsgeid::from_bits(u32::from(frame.dlc().code() & 0xF)).with_rtr(kind);
    // The bounds never act; they tell the compiler that the values fit their fields.
    let (sid, word) = match frame.id() {
        Id::Standard(id) => (id.as_raw() & StandardId::MAX.as_raw(), word),
        Id::Extended(id) => {
            let (sid, eid) = split(id);
            (sid, word.with_srr(true).with_ide(IdentifierType::Extended).with_eid(eid))
        }
    };
    buffer.cmsgsid().write(TxBufferCmsgsid::ZERO.with_sid(sid));
    buffer.cmsgeid().write(word);
    let mut data = [0; 8];
    for (to, from) in data.iter_mut().zip(frame.data_bytes()) {
        *to = *from;
    }
    buffer.payload().write(&data, 0);
}

/// Table 34-5. Which bit marks a standard remote frame is not stated: both RTR and SRR count.
#[inline]
pub(super) fn read<M: Bus>(ram: M, offset: usize, stamped: bool) -> RxMessage {
    let buffer = RxBuffer::new(ram, offset);
    let (sid, eid) = (buffer.cmsgsid().read(), buffer.cmsgeid().read());
    let standard = eid.ide() == IdentifierType::Standard;
    let id = if standard {
        Id::Standard(StandardId::new(sid.sid() & StandardId::MAX.as_raw()).unwrap_or(StandardId::ZERO))
    } else {
        let raw = u32::from(sid.sid()) << 18 | eid.eid();
        Id::Extended(ExtendedId::new(raw & ExtendedId::MAX.as_raw()).unwrap_or(ExtendedId::ZERO))
    };
    let remote = eid.rtr() == FrameType::RemoteFrame || (standard && eid.srr());
    let format = if remote { Format::Remote } else { Format::Data };
    let frame = Frame::read_with(id, format, Dlc::from_low_bits(eid.bits() as u8), |data| {
        buffer.payload().read(data);
    });
    RxMessage { frame, filter: sid.filhit().bits(), timestamp: stamped.then(|| sid.cmsgts()) }
}
