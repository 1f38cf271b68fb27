//! Error counters, error states and bus diagnostics (13.0, Registers 3-44 to 3-49).

use can_frame::Frame;
use can_wire::{BusError, ErrorKind, ErrorState, Role};
use dspic33_canfd_pac::registers as pac;

use super::Dspic33CanfdModel;
use crate::{model::Context, registers::Slot};

/// 12.3.3: the counters reach the warning range here.
const WARNING: u16 = 96;
const PASSIVE_ABOVE: u16 = 127;

/// The counters as they were last.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Errors {
    tec: u16,
    rec: u16,
    /// TEC before it last changed.
    tec_before: u16,
    bus_off: bool,
}

impl Dspic33CanfdModel {
    pub(super) fn error(&mut self, cx: &mut Context<'_>, error: &BusError) {
        // A CRC is checked behind the delimiter that ends the data phase.
        let late = error.kind == ErrorKind::Crc
            && cx.wire.partial_frame(cx.node).frame.is_some_and(|frame| frame.bit_rate_switch());
        let data = error.data_phase || late;
        let counters = if data { self.r.bdiag0_h } else { self.r.bdiag0_l };
        self.count_diagnostic(counters, if error.role == Role::Transmitter { 8 } else { 0 }, 0xFF);
        use pac::Bdiag1H as D;
        let flag = match (error.kind, data) {
            (ErrorKind::Stuff, false) => D::NSTUFERR,
            (ErrorKind::Stuff, true) => D::DSTUFERR,
            (ErrorKind::Form, false) => D::NFORMERR,
            (ErrorKind::Form, true) => D::DFORMERR,
            (ErrorKind::Crc, false) => D::NCRCERR,
            (ErrorKind::Crc, true) => D::DCRCERR,
            (ErrorKind::Bit0, false) => D::NBIT0ERR,
            (ErrorKind::Bit0, true) => D::DBIT0ERR,
            (ErrorKind::Bit1, false) => D::NBIT1ERR,
            (ErrorKind::Bit1, true) => D::DBIT1ERR,
            (ErrorKind::Ack, _) => D::NACKERR,
        };
        self.diagnose(flag);
        // errors_without_error_frame.
        if self.sends() {
            self.raise(pac::IntL::IVMIF);
        }
    }

    pub(super) fn diagnose(&mut self, flag: pac::Bdiag1H) {
        self.set_bits(self.r.bdiag1_h, u32::from(flag.bits()));
    }

    /// 13.0: one more, `diagnostic_counter_overflow`.
    fn count_diagnostic(&mut self, slot: Slot, lsb: u32, max: u32) {
        let word = self.regs.get(slot);
        let count = word >> lsb & max;
        let next = if count < max {
            count + 1
        } else if self.config.choices.diagnostic_counters_wrap {
            0
        } else {
            max
        };
        self.regs.set(slot, word & !(max << lsb) | next << lsb);
    }

    /// A message went through without error, either way.
    pub(super) fn count_message(&mut self) {
        self.count_diagnostic(self.r.bdiag1_l, 0, 0xFFFF);
    }

    /// Register 3-49: the ESI flag of a received message.
    pub(super) fn note_received(&mut self, frame: &Frame) {
        if frame.error_state_indicator() {
            self.diagnose(pac::Bdiag1H::ESI);
        }
    }

    /// 12.3.3, 13.0: the error counters have changed.
    pub(super) fn count(&mut self, tec: u16, rec: u16) {
        let before = self.errors;
        self.errors = Errors { tec, rec, tec_before: before.tec, bus_off: before.bus_off };
        let rises = |old: u16, new: u16, limit: u16| old < limit && new >= limit;
        let crosses = |old: u16, new: u16| (old > PASSIVE_ABOVE) != (new > PASSIVE_ABOVE);
        let crossed = rises(before.tec, tec, WARNING)
            || rises(before.rec, rec, WARNING)
            || crosses(before.tec, tec)
            || crosses(before.rec, rec);
        if crossed && !before.bus_off {
            self.raise(pac::IntL::CERRIF);
        }
        self.show_counters();
    }

    fn show_counters(&mut self) {
        let Errors { tec, rec, .. } = self.errors;
        self.regs.set_field(self.f.terrcnt, u32::from(tec.min(255)));
        self.regs.set_field(self.f.rerrcnt, u32::from(rec.min(255)));
        let warns = |count: u16| (WARNING..=PASSIVE_ABOVE).contains(&count);
        use pac::TrecH as S;
        let states = [
            (S::TXBP, tec > PASSIVE_ABOVE),
            (S::RXBP, rec > PASSIVE_ABOVE),
            (S::TXWARN, warns(tec)),
            (S::RXWARN, warns(rec)),
            (S::EWARN, warns(tec) || warns(rec)),
        ];
        self.set_flags(self.r.trec_h, states.map(|(flag, on)| (flag.bits(), on)));
    }

    /// 13.1.
    pub(super) fn error_state(&mut self, cx: &mut Context<'_>, to: ErrorState) {
        if to == ErrorState::BusOff {
            self.errors.bus_off = true;
            let shown = match self.config.choices.bus_off_reads_255 {
                true => 0xFF,
                // error_counter_in_bus_off: the error that led here has counted 8.
                false => self.errors.tec_before + 8,
            };
            self.regs.set_field(self.f.terrcnt, u32::from(shown));
            // Sets CERRIF and FRESET of the transmit FIFOs, by the description.
            self.regs.set_field(self.f.txbo, 1);
            let first = if self.config.choices.bus_off_resets_queue { 0 } else { 1 };
            for number in first..32 {
                if self.is_transmit(number) {
                    self.reset_fifo(cx, number);
                }
            }
            self.start_recovery(cx);
        } else if core::mem::take(&mut self.errors.bus_off) {
            self.regs.set_field(self.f.txbo, 0);
            self.show_counters();
            self.raise(pac::IntL::CERRIF);
            self.diagnose(pac::Bdiag1H::TXBOERR);
            self.scan(cx);
        } else {
            self.scan(cx);
        }
    }

    /// 13.1: the recovery starts by itself.
    pub(super) fn start_recovery(&mut self, cx: &mut Context<'_>) {
        let started = cx.wire.start_recovery(cx.node);
        debug_assert!(started.is_ok(), "a node that is bus off and switched on can recover: {started:?}");
    }

    /// Register 3-49: NBIT0ERR each time eleven recessive bits have been seen.
    pub(super) fn recovery_sequence(&mut self) {
        self.diagnose(pac::Bdiag1H::NBIT0ERR);
    }

    /// Sets and clears flags of a register.
    pub(super) fn set_flags<const N: usize>(&mut self, slot: Slot, flags: [(u16, bool); N]) {
        let mut word = self.regs.get(slot);
        for (flag, on) in flags {
            word = if on { word | u32::from(flag) } else { word & !u32::from(flag) };
        }
        self.regs.set(slot, word);
    }

    pub(super) fn set_bits(&mut self, slot: Slot, bits: u32) {
        self.regs.set(slot, self.regs.get(slot) | bits);
    }

    pub(super) fn clear_bits(&mut self, slot: Slot, bits: u32) {
        self.regs.set(slot, self.regs.get(slot) & !bits);
    }
}
