//! The Rx Handler: where received messages go, and their elements (2.3.24 to 2.3.26, 2.4.2, 3.4).

use can_frame::{Frame, Id};
use can_wire::{BusError, Role};
use m_can_pac::{
    enums::{DataLengthCode, ErrorState, FrameFormat, FrameKind, HpmsMsi, IdFormat, RxBufferUse},
    messages::{RxBufferR0, RxBufferR1a, RxBufferR1b},
    registers::{self as pac, Ir},
};

use super::{
    MCanModel,
    filters::{Destination, Verdict},
};
use crate::model::Context;

/// What the Rx Handler knows besides the registers.
#[derive(Clone, Debug, Default)]
pub(super) struct Rx {
    /// The next message meets a Message RAM failure.
    pub(super) ram_failure: bool,
    /// Pulses of `m_can_fe[2:0]`.
    filter_events: [u64; 3],
}

/// What happened to a message at a FIFO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stored {
    /// In this element.
    At(u32),
    /// The FIFO was full, or has no elements.
    Lost,
}

impl MCanModel {
    pub(super) fn reset_rx(&mut self) {
        self.rx.ram_failure = false;
    }

    /// A message was received without error.
    pub(super) fn received(&mut self, cx: &mut Context<'_>, frame: &Frame) {
        // In loop back the node's own frame is received, and its data phase counted when it was sent.
        if !matches!(self.modes.mode, can_wire::Mode::InternalLoopback | can_wire::Mode::ExternalLoopback) {
            self.count_data_phase(cx, frame);
        }
        if core::mem::take(&mut self.rx.ram_failure) {
            // 2.3.16: the message is dropped; Put Index and New Data flags stay.
            return self.raise(cx, Ir::MRAF);
        }
        let verdict = self.filter(cx, frame);
        for (pin, pulses) in self.rx.filter_events.iter_mut().enumerate() {
            *pulses += u64::from(verdict.pins >> pin & 1);
        }
        // 2.4.5: a Sync message is captured whether it is stored or not.
        let tsu = (self.uses_tsu() && verdict.sync).then(|| {
            self.timestamps.rx_pulses += 1;
            self.capture_in_tsu(cx.now)
        });
        let stored = match verdict.destination {
            Destination::Nowhere => None,
            Destination::Fifo(fifo) => Some((fifo, self.store_in_fifo(cx, fifo, frame, &verdict, tsu))),
            Destination::Buffer { number, purpose: RxBufferUse::RxBuffer } => {
                self.store_in_buffer(cx, number, frame, &verdict, tsu);
                self.set_new_data(number);
                self.raise(cx, Ir::DRX);
                None
            }
            Destination::Buffer { number, purpose } => {
                if self.takes_debug_message(purpose) {
                    self.store_in_buffer(cx, number, frame, &verdict, tsu);
                }
                self.debug_message(purpose);
                None
            }
        };
        if verdict.priority {
            self.high_priority(cx, frame, &verdict, stored);
        }
    }

    /// 2.3.24.
    fn high_priority(
        &mut self,
        cx: &mut Context<'_>,
        frame: &Frame,
        verdict: &Verdict,
        stored: Option<(usize, Stored)>,
    ) {
        let (msi, element) = match stored {
            None => (HpmsMsi::None_, 0),
            Some((_, Stored::Lost)) => (HpmsMsi::MessageLost, 0),
            Some((0, Stored::At(element))) => (HpmsMsi::Fifo0, element),
            Some((_, Stored::At(element))) => (HpmsMsi::Fifo1, element),
        };
        self.regs.set_field(self.f.flst, u32::from(frame.is_extended()));
        self.regs.set_field(self.f.fidx, u32::from(verdict.element.unwrap_or(0)));
        self.regs.set_field(self.f.msi, u32::from(msi.bits()));
        self.regs.set_field(self.f.bidx, element);
        self.raise(cx, Ir::HPM);
    }

    /// 3.4.1, `partly_stored_message`: storing had begun when the error came: the element is partly overwritten, indices
    /// and flags stay.
    pub(super) fn reception_failed(&mut self, cx: &mut Context<'_>, error: &BusError) {
        if error.role != Role::Receiver || !error.position.field.is_in_frame() {
            return;
        }
        let partial = cx.wire.partial_frame(cx.node);
        let Some(frame) = partial.frame else { return };
        let verdict = self.filter(cx, &frame);
        let place = match verdict.destination {
            Destination::Nowhere => None,
            Destination::Fifo(fifo) => self.next_element(fifo),
            Destination::Buffer { number, purpose } => {
                self.takes_debug_message(purpose).then(|| self.rx_buffer(number))
            }
        };
        if let Some((start, code)) = place {
            let words = self.element_words(cx, start, code, &frame, &verdict, None);
            let complete = 2 + usize::from(partial.data_bytes) / 4;
            for (word, value) in (start..).zip(words.into_iter().take(complete)) {
                self.ram_write(cx, word, value);
            }
        }
    }

    /// Word address and data field code of a dedicated Rx Buffer (3.4.3, rx_buffer_offset_unit).
    pub(super) fn rx_buffer(&self, number: u8) -> (u32, u8) {
        let code = pac::Rxesc::from_bits(self.regs.get(self.r.rxesc)).rbds().bits();
        let start = u32::from(pac::Rxbc::from_bits(self.regs.get(self.r.rxbc)).rbsa());
        (start + u32::from(number) * Self::rx_element_words(code), code)
    }

    fn store_in_buffer(&mut self, cx: &mut Context<'_>, number: u8, frame: &Frame, verdict: &Verdict, tsu: Option<u8>) {
        let (start, code) = self.rx_buffer(number);
        self.write_element(cx, start, code, frame, verdict, tsu);
    }

    pub(super) fn write_element(
        &mut self,
        cx: &mut Context<'_>,
        start: u32,
        code: u8,
        frame: &Frame,
        verdict: &Verdict,
        tsu: Option<u8>,
    ) {
        let words = self.element_words(cx, start, code, frame, verdict, tsu);
        for (word, value) in (start..).zip(words) {
            self.ram_write(cx, word, value);
        }
    }

    /// 2.4.2: the words of an element, as many as the message has and the element holds.
    fn element_words(
        &mut self,
        cx: &mut Context<'_>,
        start: u32,
        code: u8,
        frame: &Frame,
        verdict: &Verdict,
        tsu: Option<u8>,
    ) -> Vec<u32> {
        let (xtd, id) = match frame.id() {
            Id::Standard(id) => (IdFormat::Standard, u32::from(id.as_raw()) << 18),
            Id::Extended(id) => (IdFormat::Extended, id.as_raw()),
        };
        let r0 = RxBufferR0::ZERO
            .with_esi(ErrorState::from_bits(u8::from(frame.error_state_indicator())))
            .with_xtd(xtd)
            .with_rtr(if frame.is_remote() { FrameKind::Remote } else { FrameKind::Data })
            .with_id(id);
        let format = if frame.is_fd() { FrameFormat::Fd } else { FrameFormat::Classic };
        let dlc = DataLengthCode::from_bits(frame.dlc().code());
        let r1 = if self.uses_tsu() {
            RxBufferR1b::ZERO
                .with_anmf(verdict.element.is_none())
                .with_fidx(verdict.element.unwrap_or(0))
                .with_fdf(format)
                .with_brs(frame.bit_rate_switch())
                .with_dlc(dlc)
                .with_tsc(tsu.is_some())
                .with_rxtsp(tsu.unwrap_or(0))
                .bits()
        } else {
            RxBufferR1a::ZERO
                .with_anmf(verdict.element.is_none())
                .with_fidx(verdict.element.unwrap_or(0))
                .with_fdf(format)
                .with_brs(frame.bit_rate_switch())
                .with_dlc(dlc)
                .with_rxts(self.frame_timestamp())
                .bits()
        };
        // 2.3.34: of a longer message only as many bytes as the element holds.
        let held = (Self::rx_element_words(code) as usize - 2) * 4;
        let data = &frame.data_bytes()[..frame.len().min(held)];
        let mut words = vec![r0.bits(), r1];
        for bytes in data.chunks(4) {
            // received_data_padding.
            let mut word = match self.config.choices.received_padding_is_zero || bytes.len() == 4 {
                true => [0; 4],
                false => self.ram_read(cx, start + words.len() as u32).to_le_bytes(),
            };
            word[..bytes.len()].copy_from_slice(bytes);
            words.push(u32::from_le_bytes(word));
        }
        words
    }

    /// 2.3.25, 2.3.26.
    pub(super) fn has_new_data(&self, buffer: u8) -> bool {
        let slot = if buffer < 32 { self.r.ndat1 } else { self.r.ndat2 };
        self.regs.get(slot) >> (buffer % 32) & 1 == 1
    }

    fn set_new_data(&mut self, buffer: u8) {
        let slot = if buffer < 32 { self.r.ndat1 } else { self.r.ndat2 };
        self.set_bits(slot, 1 << (buffer % 32));
    }

    /// Pulses of the filter event pins `m_can_fe[2:0]` so far (2.4.5).
    #[must_use]
    pub const fn filter_events(&self) -> [u64; 3] {
        self.rx.filter_events
    }
}
