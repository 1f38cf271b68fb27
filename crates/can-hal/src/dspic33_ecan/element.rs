//! Frames as words of message buffers (5.0).

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};
use dspic33_ecan_pac::{
    enums::{FilterNumber, IdentifierFormat},
    messages::{RxBuffer, TxBuffer, TxBufferWord0, TxBufferWord1, TxBufferWord2},
};
use regbus::Bus;

use super::{Inner, RxMessage};

impl<R: Bus, M: Bus> Inner<R, M> {
    /// Writes the message of a buffer whose request is not pending. The bounds never act; they tell the compiler that the
    /// values fit their fields.
    #[inline]
    pub(super) fn write_element(&self, buffer: u8, frame: &Frame) {
        let element = TxBuffer::new(self.ram, self.layout.at(buffer));
        let remote = frame.is_remote();
        // Codes above 8, which the setter refuses, stand for eight bytes and are sent as they are (`dlc_above_8`).
        let length = TxBufferWord2::from_bits(u16::from(frame.dlc().code() & 0xF));
        let (word0, word1, word2) = match frame.id() {
            // 2.1, 2.3; a remote frame is requested by SRR (`standard_remote_frame`).
            Id::Standard(id) => {
                let sid = id.as_raw() & StandardId::MAX.as_raw();
                (TxBufferWord0::from_bits(0).with_sid(sid).with_srr(remote), TxBufferWord1::from_bits(0), length)
            }
            // 2.2: SRR is 1 (`srr_extended`).
            Id::Extended(id) => {
                let raw = id.as_raw() & ExtendedId::MAX.as_raw();
                let word0 =
                    TxBufferWord0::from_bits(0).with_sid((raw >> 18) as u16 & StandardId::MAX.as_raw()).with_srr(true);
                let word1 = TxBufferWord1::from_bits(0).with_eid((raw >> 6) as u16 & 0xFFF);
                let word2 = length.with_eid((raw & 0x3F) as u8).with_rtr(remote);
                (word0.with_ide(IdentifierFormat::Extended), word1, word2)
            }
        };
        element.word0().write(word0);
        element.word1().write(word1);
        element.word2().write(word2);
        element.payload().write(frame.data_bytes(), 0);
    }

    #[inline]
    pub(super) fn read_element(&self, buffer: u8) -> RxMessage {
        let element = RxBuffer::new(self.ram, self.layout.at(buffer));
        let (word0, word2) = (element.word0().read(), element.word2().read());
        let (id, remote) = match word0.ide() {
            IdentifierFormat::Standard => {
                (Id::Standard(StandardId::new(word0.sid()).unwrap_or(StandardId::ZERO)), word0.srr())
            }
            IdentifierFormat::Extended => {
                let middle = u32::from(element.word1().read().eid());
                let raw = u32::from(word0.sid()) << 18 | middle << 6 | u32::from(word2.eid());
                (Id::Extended(ExtendedId::new(raw).unwrap_or(ExtendedId::ZERO)), word2.rtr())
            }
        };
        let format = if remote { Format::Remote } else { Format::Data };
        let frame = Frame::read_with(id, format, Dlc::from_low_bits(word2.dlc()), |data| {
            element.payload().read(data);
        });
        let (Ok(FilterNumber::Filter(filter)) | Err(filter)) = element.word7().read().filhit();
        RxMessage { frame, filter, buffer }
    }
}
