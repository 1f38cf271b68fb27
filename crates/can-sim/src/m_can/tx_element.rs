//! Tx Buffer elements and the frames they become (2.4.3, 2.3.37, Table 58).

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use m_can_pac::{
    enums::{FrameFormat, FrameKind, IdFormat, TxBufferT0Esi},
    messages::{TxBuffer, TxBufferT0, TxBufferT1},
    registers as pac,
};

use super::{MCanModel, tx::Prepared};
use crate::{diagnostic::DiagnosticKind, model::Context};

/// 2.3.37: what is sent for bytes that the element does not hold.
const PADDING: u8 = 0xCC;

/// The first two words of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) t0: TxBufferT0,
    pub(super) t1: TxBufferT1,
}

impl Header {
    fn new(words: [u32; 2]) -> Self {
        Self { t0: TxBufferT0::from_bits(words[0]), t1: TxBufferT1::from_bits(words[1]) }
    }

    /// transmit_priority_order: the order in which messages win arbitration, the lowest first: base identifier, RTR or
    /// SRR, IDE, rest of the identifier, RTR.
    pub(super) fn priority(self) -> u64 {
        let id = u64::from(self.t0.id());
        let remote = u64::from(self.t0.rtr() == FrameKind::Remote);
        let base = id >> 18;
        match self.t0.xtd() {
            IdFormat::Standard => base << 21 | remote << 20,
            IdFormat::Extended => base << 21 | 0b11 << 19 | (id & 0x3_FFFF) << 1 | remote,
        }
    }

    fn id(self) -> Id {
        let id = self.t0.id();
        // 2.4.3: a standard identifier stands in bits 28:18. Both lie in range by the width of their fields.
        match self.t0.xtd() {
            IdFormat::Standard => {
                StandardId::new((id >> 18) as u16).map_or(Id::Standard(StandardId::MAX), Id::Standard)
            }
            IdFormat::Extended => ExtendedId::new(id).map_or(Id::Extended(ExtendedId::MAX), Id::Extended),
        }
    }

    pub(super) fn marker(self) -> u16 {
        u16::from(self.t1.mm_high()) << 8 | u16::from(self.t1.mm())
    }
}

impl MCanModel {
    /// Words of one Tx Buffer element.
    fn tx_element_words(&self) -> u32 {
        let code = pac::Txesc::from_bits(self.regs.get(self.r.txesc)).tbds().bits();
        TxBuffer::<regbus::Mmio>::bytes(usize::from(code)) as u32 / 4
    }

    /// 3.5.2: word address of a Tx Buffer.
    pub(super) fn tx_element(&self, buffer: u8) -> u32 {
        let start = u32::from(pac::Txbc::from_bits(self.regs.get(self.r.txbc)).tbsa());
        start + u32::from(buffer) * self.tx_element_words()
    }

    pub(super) fn read_header(&mut self, cx: &mut Context<'_>, buffer: u8) -> Header {
        let at = self.tx_element(buffer);
        Header::new([self.ram_read(cx, at), self.ram_read(cx, at + 1)])
    }

    /// 3.5: the first four words of the two best messages are loaded ahead. What was loaded for a message stays, while
    /// its request does (pending_buffer_modified).
    pub(super) fn preload(&mut self, cx: &mut Context<'_>, first: Option<u8>, second: Option<u8>) {
        let before = self.tx.preloaded;
        let known = |buffer: u8| before.iter().flatten().find(|(loaded, _)| *loaded == buffer).copied();
        self.tx.preloaded = [first, second].map(|buffer| {
            let buffer = buffer?;
            Some(known(buffer).unwrap_or_else(|| {
                let at = self.tx_element(buffer);
                (buffer, [0, 1, 2, 3].map(|word| self.ram_read(cx, at + word)))
            }))
        });
    }

    /// The frame of a message that goes to the core.
    pub(super) fn prepare(&mut self, cx: &mut Context<'_>, buffer: u8) -> Prepared {
        let at = self.tx_element(buffer);
        let loaded = self.tx.preloaded.iter().flatten().find(|(loaded, _)| *loaded == buffer);
        let first = match loaded {
            Some((_, words)) => *words,
            None => [0, 1, 2, 3].map(|word| self.ram_read(cx, at + word)),
        };
        let header = Header::new([first[0], first[1]]);
        let dlc = Dlc::from_low_bits(header.t1.dlc().bits());
        let format = self.format(header);
        let len = match format {
            Format::Data => dlc.classic_len(),
            Format::Remote => 0,
            Format::Fd(_) => dlc.fd_len(),
        };
        let mut data = [PADDING; 64];
        let held = (self.tx_element_words() - 2) as usize * 4;
        for (word, bytes) in data[..held.min(len.next_multiple_of(4))].chunks_mut(4).enumerate() {
            let value = match first.get(word + 2) {
                Some(value) => *value,
                None => self.ram_read(cx, at + 2 + word as u32),
            };
            bytes.copy_from_slice(&value.to_le_bytes());
        }
        Prepared { buffer, header, frame: Frame::from_fields(header.id(), format, dlc, &data[..len]) }
    }

    /// Table 58; 2.4.3: a remote frame is classic even with CAN FD enabled, and ESI is ORed with the error passive flag.
    fn format(&self, header: Header) -> Format {
        let cccr = self.cccr();
        if header.t0.rtr() == FrameKind::Remote {
            return Format::Remote;
        }
        if !cccr.fdoe() || header.t1.fdf() != FrameFormat::Fd {
            return Format::Data;
        }
        Format::Fd(FdFlags {
            brs: cccr.brse() && header.t1.brs(),
            esi: header.t0.esi() == TxBufferT0Esi::Recessive || self.is_error_passive(),
        })
    }

    /// The Host has written a word of the Message RAM: it must leave pending messages alone.
    pub(super) fn watch_pending_buffers(&mut self, cx: &mut Context<'_>, word: usize) {
        let pending = self.pending();
        if pending == 0 {
            return;
        }
        let (first, words) = (self.tx_element(0), self.tx_element_words());
        let Some(distance) = (word as u32).checked_sub(first) else { return };
        let buffer = distance / words;
        if buffer > 31 || pending >> buffer & 1 == 0 {
            return;
        }
        cx.report("3.5", DiagnosticKind::PendingBufferModified { buffer, address: word as u32 * 4 });
        if self.tx.placed.is_some_and(|placed| u32::from(placed.buffer) == buffer) {
            self.place(cx, Some(buffer as u8));
        }
    }
}
