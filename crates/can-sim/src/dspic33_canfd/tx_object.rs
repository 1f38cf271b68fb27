//! Transmit message objects and the frames they become (6.1, table 6-1).

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use dspic33_canfd_pac::{
    enums::{ConHEsigm, DataPhaseRate, ErrorState, FrameFormat, IdentifierFormat, OperationMode},
    messages::{TxObjectT0, TxObjectT1, TxObjectT2},
    registers as pac,
};

use super::{
    Dspic33CanfdModel,
    memory::{NoRam, payload_bytes},
    tx::Prepared,
};
use crate::{diagnostic::DiagnosticKind, model::Context};

/// Bits of T1 that exist; the others are left out of events (`unimplemented_message_bits`).
const T1_BITS: u16 = 0x3FFF;

/// The words before the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) words: [u16; 4],
}

/// Why a message is not sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unsendable {
    /// 6.12: its DLC stands for more than the payload size.
    Mismatch(Header),
    /// It lies where no RAM is.
    NoRam(u32),
}

impl Header {
    pub(super) fn t0(self) -> TxObjectT0 {
        TxObjectT0::from_bits(self.words[0])
    }

    pub(super) fn t1(self) -> TxObjectT1 {
        TxObjectT1::from_bits(self.words[1])
    }

    pub(super) fn t2(self) -> TxObjectT2 {
        TxObjectT2::from_bits(self.words[2])
    }

    fn extension(self) -> u32 {
        u32::from(self.t0().eid()) | u32::from(self.t1().eid()) << 5
    }

    fn is_extended(self) -> bool {
        self.t2().ide() == IdentifierFormat::Extended
    }

    pub(super) fn id(self) -> Id {
        let base = self.t0().sid();
        // Both lie in range by the width of their fields.
        if self.is_extended() {
            let id = ExtendedId::new(u32::from(base) << 18 | self.extension());
            Id::Extended(id.unwrap_or(ExtendedId::MAX))
        } else {
            Id::Standard(StandardId::new(base).unwrap_or(StandardId::MAX))
        }
    }
}

impl Dspic33CanfdModel {
    pub(super) fn read_header(&self, cx: &mut Context<'_>, address: u32) -> Result<Header, NoRam> {
        let mut words = [0; 4];
        for (word, at) in words.iter_mut().zip((address..).step_by(2)) {
            *word = self.ram_read(cx, at)?;
        }
        words[1] &= T1_BITS;
        Ok(Header { words })
    }

    /// 6.1: FDF, BRS, ESI and RTR. 4.3.2: in Normal CAN 2.0 mode FDF, BRS and ESI are ignored.
    fn format(&self, header: Header) -> Format {
        let t2 = header.t2();
        let con_h = self.con_h();
        let fd = t2.fdf() == FrameFormat::CanFd && con_h.opmod() != OperationMode::NormalCan2_0;
        match (fd, t2.rtr()) {
            (true, _) => Format::Fd(FdFlags {
                brs: t2.brs() == DataPhaseRate::Data && !self.con_l().brsdis(),
                // The node adds the error passive state.
                esi: con_h.esigm() == ConHEsigm::Gateway && t2.esi() == ErrorState::ErrorPassive,
            }),
            (false, true) => Format::Remote,
            (false, false) => Format::Data,
        }
    }

    /// 8.2.4, Register 3-8: RRS carries the twelfth bit of the identifier of CAN FD base frames.
    fn twelfth_bit(&self, header: Header) -> bool {
        let enabled = pac::TdcH::from_bits(self.word(self.r.tdc_h)).sid11en();
        enabled && !header.is_extended() && header.t1().sid11()
    }

    /// The order in which messages win arbitration, the lowest first: base identifier, RTR, RRS or SRR, IDE, the rest.
    pub(super) fn priority(&self, header: Header) -> u64 {
        let base = u64::from(header.t0().sid());
        let format = self.format(header);
        let remote = u64::from(format == Format::Remote);
        if header.is_extended() {
            base << 21 | 0b11 << 19 | u64::from(header.extension()) << 1 | remote
        } else {
            let rrs = matches!(format, Format::Fd(_)) && self.twelfth_bit(header);
            base << 21 | (remote | u64::from(rrs)) << 20
        }
    }

    /// The frame of the message that a FIFO or the queue sends next.
    pub(super) fn prepare(&mut self, cx: &mut Context<'_>, source: u8) -> Result<Prepared, Unsendable> {
        let (object, size) = match source {
            0 => (self.next_in_queue(cx), pac::TxqconH::from_bits(self.word(self.r.txqcon_h)).plsize()),
            _ => (self.fifos.rings[usize::from(source)].tail, self.fifo_size(source).plsize()),
        };
        let address = self.layout.objects[usize::from(source)].address(u32::from(object));
        let no_ram = |_| Unsendable::NoRam(address);
        let header = self.read_header(cx, address).map_err(no_ram)?;
        let format = self.format(header);
        let dlc = Dlc::from_low_bits(header.t2().dlc().bits());
        let len = match format {
            Format::Data => dlc.classic_len(),
            Format::Remote => 0,
            Format::Fd(_) => dlc.fd_len(),
        };
        if len > payload_bytes(size) as usize {
            return Err(Unsendable::Mismatch(header));
        }
        let mut data = [0; 64];
        for (bytes, at) in data[..len.next_multiple_of(2)].chunks_exact_mut(2).zip((address + 8..).step_by(2)) {
            bytes.copy_from_slice(&self.ram_read(cx, at).map_err(no_ram)?.to_le_bytes());
        }
        let frame = Frame::from_fields(header.id(), format, dlc, &data[..len])
            .with_remote_request_substitution(self.twelfth_bit(header));
        Ok(Prepared { source, object, header, frame })
    }

    /// 6.2: the host has written a word of RAM that a pending message occupies.
    pub(super) fn watch_pending_objects(&mut self, cx: &mut Context<'_>, word: usize) {
        let pending = self.fifos.pending;
        if pending == 0 {
            return;
        }
        let address = self.config.memory_base + word as u32 * 4;
        let placed = super::tx::numbers(pending).find(|number| {
            let placed = self.layout.objects[usize::from(*number)];
            (placed.start..placed.end()).contains(&address)
        });
        let Some(number) = placed else { return };
        let placed = self.layout.objects[usize::from(number)];
        let object = ((address - placed.start) / placed.element) as u8;
        let occupied = match number {
            0 => self.fifos.queue.used >> object & 1 == 1,
            _ => {
                let ring = self.fifos.rings[usize::from(number)];
                let distance = (u32::from(object) + placed.count - u32::from(ring.tail)) % placed.count;
                distance < u32::from(ring.count)
            }
        };
        if occupied {
            let buffer = u32::from(number);
            cx.report("6.2", DiagnosticKind::PendingBufferModified { buffer, address });
            self.scan(cx);
        }
    }
}
