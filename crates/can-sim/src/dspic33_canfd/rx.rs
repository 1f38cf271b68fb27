//! Reception: filtering, receive objects, overflow, automatic replies (6.11, 8.2, 9.0).

use can_frame::Frame;
use can_wire::Time;
use dspic33_canfd_pac::{
    enums::{DataLengthCode, DataPhaseRate, ErrorState, FilterNumber, FrameFormat, IdentifierFormat},
    messages::{RxObjectR2, TxObjectT0, TxObjectT1},
    registers as pac,
};

use super::{
    Dspic33CanfdModel,
    memory::{NoRam, payload_bytes},
    timestamp::Moments,
};
use crate::model::Context;

/// What the module knows of receptions besides the registers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rx {
    /// `filhit_event`: the filter of the last message stored.
    pub(super) filter_hit: u8,
}

impl Dspic33CanfdModel {
    /// A message was received without error.
    pub(super) fn received(&mut self, cx: &mut Context<'_>, frame: &Frame, sof: Time, res: Option<Time>) {
        self.count_message();
        self.note_received(frame);
        self.renew_attempts();
        if core::mem::take(&mut self.system.rx_overflow) {
            // 12.3.6: the new message is discarded.
            return self.raise_buffer_error();
        }
        let mut first_full = None;
        for filter in 0..32_u8 {
            let Some(number) = self.filter_target(filter) else { continue };
            if number == 0 || !self.filter_matches(filter, frame) {
                continue;
            }
            if self.is_transmit(number) {
                self.auto_reply(cx, number, frame);
                return;
            }
            let depth = self.depth(number);
            if !self.fifos.rings[usize::from(number)].is_full(depth) {
                return self.store(cx, filter, number, frame, Moments { sof, res, valid: cx.now });
            }
            // 8.2: filtering goes on with the next filter.
            if self.config.choices.every_full_fifo_overflows {
                self.overflow(number);
            }
            first_full.get_or_insert(number);
        }
        // overflow_with_several_filters.
        if let Some(number) = first_full {
            self.overflow(number);
        }
    }

    /// 12.1.4.
    fn overflow(&mut self, number: u8) {
        let (_, status) = self.control_and_status(number);
        self.set_bits(status, u32::from(pac::FifoSta::RXOVIF.bits()));
        self.combine(number);
    }

    /// 6.11: a remote frame requests what a transmit FIFO with RTREN holds; anything else for a transmit FIFO is
    /// discarded (8.2).
    fn auto_reply(&mut self, cx: &mut Context<'_>, number: u8, frame: &Frame) {
        if !frame.is_remote() || !self.fifo_control(number).rtren() {
            return;
        }
        if self.fill(number) == 0 {
            // rxovif_transmit_fifo.
            return self.overflow(number);
        }
        self.request(cx, number);
        self.scan(cx);
    }

    /// 9.1, table 9-1.
    fn store(&mut self, cx: &mut Context<'_>, filter: u8, number: u8, frame: &Frame, moments: Moments) {
        let placed = self.layout.objects[usize::from(number)];
        let ring = self.fifos.rings[usize::from(number)];
        let address = placed.address(ring.head(placed.count));
        let stamp = self.fifo_control(number).rxtsen().then(|| self.timestamp(frame, moments));
        if self.write_object(cx, address, filter, number, frame, stamp).is_err() {
            return self.address_error(cx, address);
        }
        self.rx.filter_hit = filter;
        self.fifos.rings[usize::from(number)].push(placed.count);
        self.show_fifo(number);
    }

    fn write_object(
        &mut self,
        cx: &mut Context<'_>,
        address: u32,
        filter: u8,
        number: u8,
        frame: &Frame,
        stamp: Option<u32>,
    ) -> Result<(), NoRam> {
        let raw = frame.raw_id();
        let (base, extension) = if frame.is_extended() { (raw >> 18, raw & 0x3_FFFF) } else { (raw, 0) };
        let twelve_bits = pac::TdcH::from_bits(self.word(self.r.tdc_h)).sid11en() && !frame.is_extended();
        let r0 = TxObjectT0::ZERO.with_sid(base as u16).with_eid((extension & 0x1F) as u8);
        let r1 = TxObjectT1::ZERO
            .with_eid((extension >> 5) as u16)
            .with_sid11(twelve_bits && frame.remote_request_substitution());
        let esi = frame.error_state_indicator();
        let r2 = RxObjectR2::ZERO
            .with_filhit(FilterNumber::from_bits(filter))
            .with_esi(if esi { ErrorState::ErrorPassive } else { ErrorState::ErrorActive })
            .with_fdf(if frame.is_fd() { FrameFormat::CanFd } else { FrameFormat::Can2_0 })
            .with_brs(if frame.bit_rate_switch() { DataPhaseRate::Data } else { DataPhaseRate::Nominal })
            .with_rtr(frame.is_remote())
            .with_ide(if frame.is_extended() { IdentifierFormat::Extended } else { IdentifierFormat::Base })
            .with_dlc(DataLengthCode::from_bits(frame.dlc().code()));
        let time = stamp.unwrap_or(0);
        let words = [r0.bits(), r1.bits(), r2.bits(), 0, time as u16, (time >> 16) as u16];
        let header = if stamp.is_some() { &words[..] } else { &words[..4] };
        self.ram_store(cx, address, header)?;
        // 9.4: bytes that do not fit are discarded.
        let room = payload_bytes(self.fifo_size(number).plsize()) as usize;
        let data = &frame.data_bytes()[..frame.len().min(room)];
        let at = address + header.len() as u32 * 2;
        for (bytes, at) in data.chunks(2).zip((at..).step_by(2)) {
            // bytes_behind_the_message.
            let whole = bytes.len() == 2 || self.config.choices.last_word_is_whole;
            let word = u16::from_le_bytes([bytes[0], bytes.get(1).copied().unwrap_or(0)]);
            self.ram_write(cx, at, word, if whole { 0xFFFF } else { 0x00FF })?;
        }
        if frame.len() > room {
            self.raise(pac::IntL::IVMIF);
            self.diagnose(pac::Bdiag1H::DLCMM);
        }
        Ok(())
    }
}
