//! Messages as they stand in DMA RAM (5.0, 2.0).

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};
use dspic33_ecan_pac::{
    enums::{FilterNumber, IdentifierFormat},
    messages::{RxBufferWord0, RxBufferWord2, RxBufferWord7, TxBufferWord0, TxBufferWord1, TxBufferWord2},
};

use super::{EcanModel, dma::WORDS};
use crate::{diagnostic::DiagnosticKind, model::Context};

/// The longest message in bytes.
const MAX_BYTES: u8 = 8;

/// The frame that the words of a transmit buffer describe.
pub(super) fn decode(words: &[u16; WORDS]) -> Frame {
    let (w0, w1) = (TxBufferWord0::from_bits(words[0]), TxBufferWord1::from_bits(words[1]));
    let w2 = TxBufferWord2::from_bits(words[2]);
    let (id, remote) = match w0.ide() {
        // standard_remote_frame: RTR is ignored, SRR decides (Buffer 5-3).
        IdentifierFormat::Standard => (StandardId::new(w0.sid()).map(Id::Standard), w0.srr()),
        IdentifierFormat::Extended => {
            let raw = u32::from(w0.sid()) << 18 | u32::from(w1.eid()) << 6 | u32::from(w2.eid());
            (ExtendedId::new(raw).map(Id::Extended), w2.rtr())
        }
    };
    let mut data = [0; 8];
    for (bytes, word) in data.chunks_exact_mut(2).zip(&words[3..7]) {
        // Buffer 5-4: the byte with the even number in the low half.
        bytes.copy_from_slice(&word.to_le_bytes());
    }
    let format = if remote { Format::Remote } else { Format::Data };
    // 11 and 29 bits are what the fields have. dlc_above_8: eight bytes, the code as it is.
    Frame::from_fields(id.unwrap_or(Id::Standard(StandardId::ZERO)), format, Dlc::from_low_bits(w2.dlc()), &data)
}

/// The words of a received message, with `data` in the data bytes.
pub(super) fn encode(frame: &Frame, filter: u8, data: &[u8; 8]) -> [u16; WORDS] {
    let remote = frame.is_remote();
    let w2 = RxBufferWord2::from_bits(u16::from(frame.dlc().code()));
    let (w0, w1, w2) = match frame.id() {
        // extended_words_of_standard_message: 0; a remote frame is told by SRR (standard_remote_frame).
        Id::Standard(id) => (RxBufferWord0::from_bits(0).with_sid(id.as_raw()).with_srr(remote), 0, w2),
        Id::Extended(id) => {
            let id = id.as_raw();
            let w0 = RxBufferWord0::from_bits(0).with_sid((id >> 18) as u16).with_srr(true);
            let w2 = w2.with_eid((id & 0x3F) as u8).with_rtr(remote);
            (w0.with_ide(IdentifierFormat::Extended), (id >> 6 & 0xFFF) as u16, w2)
        }
    };
    let word = |n: usize| u16::from_le_bytes([data[2 * n], data[2 * n + 1]]);
    let filter = FilterNumber::from_bits(filter).unwrap_or(FilterNumber::Filter(0));
    let w7 = RxBufferWord7::from_bits(0).with_filhit(filter);
    [w0.bits(), w1, w2.bits(), word(0), word(1), word(2), word(3), w7.bits()]
}

impl EcanModel {
    /// What of a message to be sent does not fit the frame that the module makes of it.
    pub(super) fn check_message(cx: &mut Context<'_>, buffer: u8, words: &[u16; WORDS]) {
        let (w0, w2) = (TxBufferWord0::from_bits(words[0]), TxBufferWord2::from_bits(words[2]));
        let extended = w0.ide() == IdentifierFormat::Extended;
        let mut wrong = |section, what| {
            cx.report(section, DiagnosticKind::MessageInvalid { buffer: u32::from(buffer), what });
        };
        if extended && !w0.srr() {
            // srr_zero_in_extended.
            wrong("2.2", "SRR is 0 in an extended message; it is sent as 1");
        }
        if !extended && w2.rtr() && !w0.srr() {
            wrong("Buffer 5-3", "RTR of a standard message is ignored; SRR requests a remote frame");
        }
        if w2.rb1() || w2.rb0() {
            // reserved_frame_bits.
            wrong("Buffer 5-3", "RB1 or RB0 is 1; they are sent as 0");
        }
        if w2.dlc() > MAX_BYTES {
            wrong("2.1", "the DLC is above 8; eight bytes are sent");
        }
    }
}
