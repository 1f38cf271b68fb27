//! The Tx Event FIFO (2.3.45 to 2.3.47, 2.4.4, 3.5.8).

use can_frame::Frame;
use m_can_pac::{
    enums::{CccrWmm, FrameFormat, TxEventType},
    messages::{TxEventE0, TxEventE1a, TxEventE1b},
    registers::{self as pac, Ir},
};

use super::{MCanModel, tx::Prepared};
use crate::{diagnostic::DiagnosticKind, model::Context};

impl MCanModel {
    /// Size of the Tx Event FIFO; more than 32 counts as 32 (2.3.45).
    pub(super) fn event_fifo_size(&self) -> u32 {
        u32::from(pac::Txefc::from_bits(self.regs.get(self.r.txefc)).efs()).min(32)
    }

    /// 3.5.8: a message with EFC was sent.
    pub(super) fn store_event(&mut self, cx: &mut Context<'_>, sent: &Prepared, frame: &Frame, cancelled: bool) {
        let timestamp_captured = self.uses_tsu() && sent.header.t1.tsce();
        let pointer = if timestamp_captured {
            self.timestamps.tx_pulses += 1;
            self.capture_in_tsu(cx.now)
        } else {
            0
        };
        if !sent.header.t1.efc() {
            return;
        }
        let size = self.event_fifo_size();
        let level = self.regs.field(self.f.effl);
        if level >= size {
            // 2.3.16: discarded, also with size zero.
            return self.raise(cx, Ir::TEFL);
        }
        let words = self.event(sent, frame, cancelled, timestamp_captured.then_some(pointer));
        let start = u32::from(pac::Txefc::from_bits(self.regs.get(self.r.txefc)).efsa());
        let put = self.regs.field(self.f.efpi);
        for (word, value) in (0..).zip(words) {
            self.ram_write(cx, start + put * 2 + word, value);
        }
        let level = level + 1;
        self.regs.set_field(self.f.efpi, if put + 1 == size { 0 } else { put + 1 });
        self.regs.set_field(self.f.effl, level);
        self.regs.set_field(self.f.eff, u32::from(level == size));
        let mut flags = Ir::TEFN;
        if level == size {
            flags |= Ir::TEFF;
        }
        // 2.3.45: 0 and more than 32 switch the watermark off.
        let watermark = u32::from(pac::Txefc::from_bits(self.regs.get(self.r.txefc)).efwm());
        if (1..=32).contains(&watermark) && self.reaches(level, watermark) {
            flags |= Ir::TEFW;
        }
        self.raise(cx, flags);
    }

    /// watermark_repetition.
    pub(super) fn reaches(&self, level: u32, watermark: u32) -> bool {
        level == watermark || self.config.choices.watermark_repeats && level > watermark
    }

    pub(super) fn uses_tsu(&self) -> bool {
        self.cccr().utsu() == m_can_pac::enums::CccrUtsu::External
    }

    /// 2.4.4.
    fn event(&self, sent: &Prepared, frame: &Frame, cancelled: bool, tsu: Option<u8>) -> [u32; 2] {
        let (t0, t1) = (sent.header.t0, sent.header.t1);
        // esi_of_classic_frames, tx_event_esi.
        let esi = match self.config.choices.event_esi_as_transmitted {
            true => frame.error_state_indicator(),
            false => self.tx.passive_at_start,
        };
        let esi = m_can_pac::enums::ErrorState::from_bits(u8::from(esi && frame.is_fd()));
        let e0 = TxEventE0::ZERO.with_esi(esi).with_xtd(t0.xtd()).with_rtr(t0.rtr()).with_id(t0.id());
        let kind = if cancelled { TxEventType::InSpiteOfCancellation } else { TxEventType::TxEvent };
        let format = if frame.is_fd() { FrameFormat::Fd } else { FrameFormat::Classic };
        let wide = self.cccr().wmm() == CccrWmm::Bits16 || self.uses_tsu();
        let e1 = if wide {
            // With wide markers and without TSU there is no timestamp at all.
            TxEventE1b::ZERO
                .with_mm(t1.mm())
                .with_et(kind)
                .with_fdf(format)
                .with_brs(frame.bit_rate_switch())
                .with_dlc(t1.dlc())
                .with_mm_high((sent.header.marker() >> 8) as u8)
                .with_tsc(tsu.is_some())
                .with_txtsp(tsu.unwrap_or(0))
                .bits()
        } else {
            TxEventE1a::ZERO
                .with_mm(t1.mm())
                .with_et(kind)
                .with_fdf(format)
                .with_brs(frame.bit_rate_switch())
                .with_dlc(t1.dlc())
                .with_txts(self.frame_timestamp())
                .bits()
        };
        [e0.bits(), e1]
    }

    /// 2.3.47, 3.6: the Get Index becomes the acknowledged one plus one, unchecked.
    pub(super) fn acknowledge_events(&mut self, cx: &mut Context<'_>, index: u32) {
        let size = self.event_fifo_size();
        let (get, put, fill) =
            (self.regs.field(self.f.efgi), self.regs.field(self.f.efpi), self.regs.field(self.f.effl));
        let valid = index < size && (index + size - get % size.max(1)) % size < fill;
        if !valid {
            cx.report("3.6", DiagnosticKind::AcknowledgeInvalid { register: "TXEFA", index, get, fill });
        }
        if self.cccr().cce() || size == 0 {
            return;
        }
        let get = if index + 1 >= size { 0 } else { index + 1 };
        self.regs.set_field(self.f.efgi, get);
        self.regs.set_field(self.f.effl, (put + size - get) % size);
        self.regs.set_field(self.f.eff, 0);
    }
}
