//! The Tx Handler: requests, Tx scan, start and end of transmissions (2.3.35 to 2.3.42, 3.5).

use can_frame::Frame;
use can_wire::{Role, Time};
use m_can_pac::{
    enums::TxbcTfqm,
    registers::{self as pac, Ir},
};

use super::{MCanModel, sends, tx_element::Header};
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

/// A message that has been handed to the CAN core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Prepared {
    pub(super) buffer: u8,
    pub(super) header: Header,
    pub(super) frame: Frame,
}

/// What the Tx Handler knows besides the registers.
#[derive(Clone, Debug, Default)]
pub(super) struct Tx {
    /// Handed to the core, not started.
    pub(super) placed: Option<Prepared>,
    /// On the bus, or about to be in the next bit.
    pub(super) sending: Option<Prepared>,
    /// The first four words of the two best messages, loaded at the last Tx scan (3.5).
    pub(super) preloaded: [Option<(u8, [u32; 4])>; 2],
    /// Elements of the Tx FIFO from Get Index to Put Index.
    pub(super) used: u32,
    /// 3.5.1: no transmission starts before.
    pause: Option<Time>,
    /// When a running Tx scan ends.
    scan_end: Option<Time>,
    /// TXBRP has changed while a Tx scan was running.
    scan_again: bool,
    /// 2.3.38: buffers requested while a Tx scan was running, which the scan does not consider.
    late: u32,
    /// The node was error passive when the transmission started.
    pub(super) passive_at_start: bool,
    /// The next start of a transmission meets a Message RAM failure.
    pub(super) ram_failure: bool,
}

/// How the buffers are divided (2.3.35).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Division {
    pub(super) dedicated: u32,
    pub(super) rest: u32,
    pub(super) queue: bool,
}

impl MCanModel {
    pub(super) fn division(&self) -> Division {
        let txbc = pac::Txbc::from_bits(self.regs.get(self.r.txbc));
        let dedicated = u32::from(txbc.ndtb()).min(32);
        // too_many_tx_buffers: what is beyond buffer 31 does not exist.
        let rest = u32::from(txbc.tfqs()).min(32).min(32 - dedicated);
        Division { dedicated, rest, queue: txbc.tfqm() == TxbcTfqm::Queue }
    }

    /// Mask of the Tx Buffers that TXBC configures.
    pub(super) fn configured_buffers(&self) -> u32 {
        let Division { dedicated, rest, .. } = self.division();
        regbus::bits::mask(dedicated + rest)
    }

    pub(super) fn pending(&self) -> u32 {
        self.regs.get(self.r.txbrp)
    }

    /// 2.3.39, 2.3.40: bits of buffers that are not configured stay 0; without a running scan a request is taken over
    /// at once, a cancellation stays until the request is gone.
    pub(super) fn write_requests(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        if access.refused.is_some() {
            return;
        }
        let (register, section) = if access.slot == self.r.txbar { ("TXBAR", "2.3.39") } else { ("TXBCR", "2.3.40") };
        let configured = self.configured_buffers();
        for buffer in bits(access.ones() & !configured) {
            let because = "TXBC configures no such buffer";
            cx.report(section, DiagnosticKind::RequestIgnored { register, buffer, because });
        }
        let scanning = self.tx.scan_end.is_some();
        access.new = if access.slot == self.r.txbar && !scanning { access.old } else { access.new & configured };
    }

    /// 2.3.39: sets TXBRP, clears what the buffers' last transmissions have left, and starts a Tx scan.
    pub(super) fn add_requests(&mut self, cx: &mut Context<'_>, buffers: u32) {
        if self.cccr().cce() || buffers == 0 {
            return;
        }
        let pending = self.pending();
        for buffer in bits(buffers & pending) {
            let because = "its request is pending already";
            cx.report("2.3.39", DiagnosticKind::RequestIgnored { register: "TXBAR", buffer, because });
        }
        let added = buffers & !pending;
        self.clear_bits(self.r.txbto, added);
        self.clear_bits(self.r.txbcf, added);
        // In Bus Monitoring Mode TXBRP is held in reset, by the description (3.1.6).
        self.regs.set(self.r.txbrp, pending | added);
        if self.tx.scan_end.is_some() {
            self.tx.late |= added;
        }
        self.fifo_requested(cx, added);
        self.scan(cx);
    }

    /// 3.5: looks for the message with the highest priority.
    pub(super) fn scan(&mut self, cx: &mut Context<'_>) {
        let duration = self.config.choices.tx_scan;
        if duration == Time::ZERO {
            return self.finish_scan(cx);
        }
        if self.tx.scan_end.is_some() {
            self.tx.scan_again = true;
        } else if self.pending() != 0 || self.tx.placed.is_some() {
            self.tx.scan_end = Some(cx.now + duration);
        }
    }

    fn finish_scan(&mut self, cx: &mut Context<'_>) {
        // 2.3.39: the bits of TXBAR are reset at the end of the scan.
        self.regs.set(self.r.txbar, 0);
        let (first, second) = self.best_two(cx);
        self.preload(cx, first, second);
        self.show_fifo();
        self.place(cx, first);
    }

    /// The two pending messages with the highest priority.
    fn best_two(&mut self, cx: &mut Context<'_>) -> (Option<u8>, Option<u8>) {
        let mut best: [Option<(u64, u8)>; 2] = [None; 2];
        for buffer in bits(self.candidates()) {
            let header = self.read_header(cx, buffer as u8);
            let rated = Some((header.priority(), buffer as u8));
            // Equal identifiers go by buffer number (3.5.2, queue_equal_identifiers).
            if best[0].is_none() || rated < best[0] {
                best = [rated, best[0]];
            } else if best[1].is_none() || rated < best[1] {
                best[1] = rated;
            }
        }
        (best[0].map(|(_, buffer)| buffer), best[1].map(|(_, buffer)| buffer))
    }

    /// 3.5.2 to 3.5.6: all pending dedicated and queue buffers; of a FIFO the one at the Get Index.
    fn candidates(&self) -> u32 {
        let Division { dedicated, queue, .. } = self.division();
        let pending = self.pending();
        let started = self.tx.sending.map_or(0, |sending| 1 << sending.buffer);
        let eligible = if queue {
            pending
        } else {
            let get = 1 << self.regs.field(self.f.tfgi);
            let fifo = if self.tx.used > 0 { get } else { 0 };
            pending & (regbus::bits::mask(dedicated) | fifo)
        };
        eligible & !started & !self.tx.late
    }

    /// Hands a message to the core, in place of one that has not started.
    pub(super) fn place(&mut self, cx: &mut Context<'_>, buffer: Option<u8>) {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            // The core has begun with it: its start of frame follows in the next bit.
            self.tx.sending = self.tx.placed.take();
        }
        // The failure that makes the node bus off is told before PSR.BO follows.
        let bus_off = cx.wire.error_state(cx.node) == can_wire::ErrorState::BusOff;
        let allowed = sends(self.modes.mode) && self.tx.pause.is_none() && !bus_off;
        let buffer = buffer.filter(|_| allowed);
        if self.tx.sending.is_some() {
            return;
        }
        let Some(buffer) = buffer else {
            if self.tx.placed.take().is_some() {
                cx.wire.abort(cx.node);
            }
            self.show_prepared();
            return;
        };
        let prepared = self.prepare(cx, buffer);
        if self.tx.placed != Some(prepared) {
            match cx.wire.send(cx.node, prepared.frame) {
                Ok(_) => self.tx.placed = Some(prepared),
                Err(error) => {
                    self.tx.placed = None;
                    cx.report("3.5", DiagnosticKind::Contradiction { what: format!("buffer {buffer}: {error}") });
                }
            }
        }
        self.show_prepared();
    }

    /// 2.3.5: TEST shows the prepared and the last started buffer while CCCR.TEST is set; otherwise the description
    /// holds it at its reset value.
    fn show_prepared(&mut self) {
        if !self.cccr().test() {
            return;
        }
        let prepared = self.tx.placed.map(|placed| u32::from(placed.buffer));
        self.regs.set_field(self.f.pval, u32::from(prepared.is_some()));
        if let Some(buffer) = prepared {
            self.regs.set_field(self.f.txbnp, buffer);
        }
    }

    pub(super) fn start_of_frame(&mut self, cx: &mut Context<'_>, role: Role) {
        self.capture_timestamp(cx.now);
        if role == Role::Receiver {
            // 3.5.1: the pause ends with the start of another node's frame.
            if self.tx.pause.take().is_some() {
                self.scan(cx);
            }
            return;
        }
        self.tx.passive_at_start = self.is_error_passive();
        if let Some(placed) = self.tx.placed.take() {
            self.tx.sending = Some(placed);
        }
        if let Some(sending) = self.tx.sending
            && self.cccr().test()
        {
            self.regs.set_field(self.f.sval, 1);
            self.regs.set_field(self.f.txbns, u32::from(sending.buffer));
        }
        if core::mem::take(&mut self.tx.ram_failure) {
            self.tx_ram_failed(cx);
        }
        self.show_prepared();
    }

    /// 2.3.41, 3.5.7, 3.1.7.1: a message was sent.
    pub(super) fn transmitted(&mut self, cx: &mut Context<'_>, frame: &Frame) {
        self.count_data_phase(cx, frame);
        let Some(sent) = self.tx.sending.take().or_else(|| self.tx.placed.take()) else { return };
        let bit = 1 << sent.buffer;
        let cancelled = self.regs.get(self.r.txbcr) & bit != 0;
        self.set_bits(self.r.txbto, bit);
        self.request_done(cx, bit, cancelled);
        self.raise_for_buffer(cx, Ir::TC, self.regs.get(self.r.txbtie) & bit != 0);
        self.store_event(cx, &sent, frame, cancelled || self.cccr().dar());
        if self.cccr().txp() {
            // 3.5.1: two bit times of bus idle after the three of intermission. The request has to be there half a bit
            // before the bit boundary at which it may start.
            let bit = cx.wire.config(cx.node).nominal_bit().as_ps();
            self.tx.pause = Some(cx.now + Time::from_ps(bit * 9 / 2));
        }
        self.scan(cx);
    }

    /// Lost arbitration, or an error: the request stays pending, unless it was cancelled or DAR forbids to repeat it
    /// (3.1.7.1, 3.5.7).
    pub(super) fn transmission_ended(&mut self, cx: &mut Context<'_>) {
        let Some(failed) = self.tx.sending.take().or_else(|| self.tx.placed.take()) else { return };
        let bit = 1 << failed.buffer;
        if self.cccr().dar() || self.regs.get(self.r.txbcr) & bit != 0 {
            self.request_done(cx, bit, true);
        }
        self.scan(cx);
    }

    /// A request is gone from TXBRP: TXBCR and the FIFO follow, and TXBCF if it was cancelled.
    pub(super) fn request_done(&mut self, cx: &mut Context<'_>, bit: u32, cancelled: bool) {
        self.clear_bits(self.r.txbrp, bit);
        self.clear_bits(self.r.txbcr, bit);
        // 3.5: what was preloaded belongs to this request; the next one for the same buffer is another message.
        for preloaded in &mut self.tx.preloaded {
            preloaded.take_if(|(buffer, _)| bit >> *buffer & 1 == 1);
        }
        if cancelled {
            self.set_bits(self.r.txbcf, bit);
            self.raise_for_buffer(cx, Ir::TCF, self.regs.get(self.r.txbcie) & bit != 0);
        }
        self.fifo_released(cx);
    }

    /// The core has dropped a request that had not started: going off the bus, or Bus_Off.
    pub(super) fn request_dropped(&mut self, cx: &mut Context<'_>) {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.placed = None;
        }
    }

    /// The node has changed its mode: what it was doing is over (3.1.1, 3.1.5, 3.1.6).
    pub(super) fn mode_changed(&mut self, cx: &mut Context<'_>) {
        if !sends(self.modes.mode) {
            self.tx.sending = None;
            self.tx.placed = None;
            self.tx.pause = None;
            if self.pending() == 0 {
                self.fifo_emptied();
            }
        }
        self.scan(cx);
    }

    pub(super) fn tx_timer(&self) -> Option<Time> {
        [self.tx.pause, self.tx.scan_end].into_iter().flatten().min()
    }

    pub(super) fn tx_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.tx.pause.is_some_and(|at| at <= cx.now) {
            self.tx.pause = None;
            self.scan(cx);
        }
        if self.tx.scan_end.is_some_and(|at| at <= cx.now) {
            self.tx.scan_end = None;
            self.finish_scan(cx);
            self.tx.late = 0;
            if core::mem::take(&mut self.tx.scan_again) {
                self.scan(cx);
            }
        }
    }

    /// 3.1.1: CCE holds the Tx Handler idle.
    pub(super) fn reset_tx(&mut self, _cx: &mut Context<'_>) {
        self.tx = Tx::default();
    }

    pub(super) fn set_bits(&mut self, slot: crate::registers::Slot, bits: u32) {
        self.regs.set(slot, self.regs.get(slot) | bits);
    }

    pub(super) fn clear_bits(&mut self, slot: crate::registers::Slot, bits: u32) {
        self.regs.set(slot, self.regs.get(slot) & !bits);
    }
}

/// The numbers of the bits that are 1, lowest first.
pub(super) fn bits(mut mask: u32) -> impl Iterator<Item = u32> {
    core::iter::from_fn(move || {
        let bit = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (bit < 32).then_some(bit)
    })
}
