//! Transmit message buffers and the frames they become (34.7.1, Table 34-2, Figures 34-12 to 34-14).

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};
use pic32_can_pac::{
    enums::{FrameType, IdentifierType},
    messages::{TxBufferCmsgeid, TxBufferCmsgsid},
    meta::CONTROLLER,
};
use regbus::meta::MessageWord;

use super::{
    Pic32CanModel,
    memory::{SystemError, WORDS},
};
use crate::{diagnostic::DiagnosticKind, model::Context};

/// The frame that a transmit buffer describes.
pub(super) fn decode(words: [u32; WORDS]) -> Frame {
    let (sid, eid) = (TxBufferCmsgsid::from_bits(words[0]), TxBufferCmsgeid::from_bits(words[1]));
    let id = match eid.ide() {
        // Both lie in range by the width of their fields.
        IdentifierType::Standard => StandardId::new(sid.sid()).map_or(Id::Standard(StandardId::MAX), Id::Standard),
        IdentifierType::Extended => {
            let id = u32::from(sid.sid()) << 18 | eid.eid();
            ExtendedId::new(id).map_or(Id::Extended(ExtendedId::MAX), Id::Extended)
        }
    };
    // Figure 34-12: only RTR makes a remote request (remote_flag_of_standard_frames).
    let format = if eid.rtr() == FrameType::RemoteFrame { Format::Remote } else { Format::Data };
    let mut data = [0; 8];
    data[..4].copy_from_slice(&words[2].to_le_bytes());
    data[4..].copy_from_slice(&words[3].to_le_bytes());
    Frame::from_fields(id, format, Dlc::from_low_bits(eid.dlc().bits()), &data)
}

/// The bits of a word of the transmit buffer that have a field.
fn fields(name: &str) -> u32 {
    let buffer = CONTROLLER.messages.iter().find(|message| message.name == "TX_BUFFER");
    let word = |word: &&MessageWord| word.name == name;
    let word = buffer.and_then(|buffer| buffer.words.iter().find(word));
    word.map_or(u32::MAX, |word| word.fields.iter().fold(0, |mask, field| mask | field.all()))
}

/// The words that software has to leave 0 in part, by their names.
pub(super) fn implemented() -> [u32; 2] {
    ["CMSGSID", "CMSGEID"].map(fields)
}

impl Pic32CanModel {
    /// The frame of a message in a transmit FIFO; `None`, and a system error, if its buffer does not lie in RAM.
    pub(super) fn message(&mut self, cx: &mut Context<'_>, fifo: u8, index: u8) -> Option<Frame> {
        let address = self.buffer(fifo, index);
        let Some(words) = self.fetch(cx, address, WORDS) else {
            self.system_error(cx, SystemError::Address, address);
            return None;
        };
        self.check_message(cx, fifo, words);
        Some(decode(words))
    }

    /// Table 34-2, Figure 34-12: what software has to write.
    fn check_message(&self, cx: &mut Context<'_>, fifo: u8, words: [u32; WORDS]) {
        let eid = TxBufferCmsgeid::from_bits(words[1]);
        let shaded = words.iter().zip(self.tx_fields).any(|(word, fields)| word & !fields != 0);
        let extended = eid.ide() == IdentifierType::Extended;
        let wrong = [
            (shaded, "bits without a field are not 0"),
            (eid.rb0() || eid.rb1(), "RB0 or RB1 is not 0"),
            (extended && !eid.srr(), "SRR is 0 in an extended message; it is sent as 1"),
        ];
        for (_, what) in wrong.into_iter().filter(|(wrong, _)| *wrong) {
            cx.report("34.7.1", DiagnosticKind::MessageInvalid { buffer: u32::from(fifo), what });
        }
    }
}
