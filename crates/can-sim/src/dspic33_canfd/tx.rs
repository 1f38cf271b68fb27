//! Requests, priorities, transmissions and their repetition (6.4 to 6.9, 6.13).

use can_frame::Frame;
use can_wire::{ErrorState, Role, Time};
use dspic33_canfd_pac::{
    enums::{ConHRtxat, RetransmissionAttempts},
    registers as pac,
};

use super::{
    Dspic33CanfdModel,
    timestamp::Moments,
    tx_object::{Header, Unsendable},
};
use crate::{model::Context, registers::WriteAccess};

/// A message that has been handed to the node on the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Prepared {
    /// FIFO number, 0 for the queue.
    pub(super) source: u8,
    pub(super) object: u8,
    pub(super) header: Header,
    pub(super) frame: Frame,
}

/// How a transmission came to nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ended {
    ArbitrationLost,
    Error,
}

/// What the module knows of transmissions besides the registers.
#[derive(Clone, Debug, Default)]
pub(super) struct Tx {
    /// Handed to the node, not started.
    pub(super) placed: Option<Prepared>,
    /// On the bus, or about to be in the next bit.
    pub(super) sending: Option<Prepared>,
    /// 6.8: no transmission starts before.
    pause: Option<Time>,
    /// FIFO and attempts that have failed in a row (6.9.2).
    attempts: Option<(u8, u8)>,
    /// TXLARB and TXERR of the messages being sent (`transmit_status_flags`).
    pub(super) accumulated: [u16; 32],
}

const HISTORY: u16 = pac::FifoSta::TXABT.union(pac::FifoSta::TXLARB).union(pac::FifoSta::TXERR).bits();

impl Dspic33CanfdModel {
    /// 6.6: zeros are ignored, and so are receive FIFOs.
    pub(super) fn write_requests(&mut self, access: &mut WriteAccess, first: u8) {
        let added = access.new & !access.old;
        for bit in 0..16_u8 {
            let refused = self.is_configuration() || !self.is_transmit(first + bit);
            if added >> bit & 1 == 1 && refused {
                access.new &= !(1 << bit);
            }
        }
    }

    pub(super) fn requests_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess, first: u8) {
        for bit in numbers(access.ones() & access.new) {
            self.fifos.aborting &= !(1 << (first + bit));
            self.request(cx, first + bit);
        }
        self.scan(cx);
    }

    /// 6.4, 6.5: TXREQ of a FIFO or the queue is set.
    pub(super) fn request(&mut self, cx: &mut Context<'_>, number: u8) {
        // stale_transmit_request; 6.10: while ABAT is set nothing can be sent.
        if self.fill(number) == 0 || self.con_h().abat() {
            return self.end_request(number);
        }
        self.fifos.pending |= 1 << number;
        self.show_request(number, true);
        if number == 0 && self.tx.placed.is_some_and(|placed| placed.source != 0) {
            // TXQCI is recomputed with every request.
            self.next_in_queue(cx);
        }
    }

    fn show_request(&mut self, number: u8, on: bool) {
        let (control, _) = self.control_and_status(number);
        let bit = u32::from(pac::FifoConL::TXREQ.bits());
        if on {
            self.set_bits(control, bit);
        } else {
            self.clear_bits(control, bit);
        }
        self.set_numbered(self.r.txreq_l, self.r.txreq_h, number, on);
    }

    pub(super) fn end_request(&mut self, number: u8) {
        self.fifos.pending &= !(1 << number);
        self.fifos.aborting &= !(1 << number);
        self.show_request(number, false);
    }

    /// 6.7: highest TXPRI, then the queue, then the highest FIFO number.
    fn best_source(&self) -> Option<u8> {
        numbers(self.fifos.pending).max_by_key(|number| {
            let priority = match number {
                0 => pac::TxqconH::from_bits(self.word(self.r.txqcon_h)).txpri(),
                _ => self.fifo_size(*number).txpri(),
            };
            (priority, *number == 0, *number)
        })
    }

    /// Hands the message with the highest priority to the node, in place of one that has not started.
    pub(super) fn scan(&mut self, cx: &mut Context<'_>) {
        if self.tx.placed.is_none() && self.fifos.pending == 0 {
            return;
        }
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            // The node has begun with it: its start of frame follows in the next bit.
            self.tx.sending = self.tx.placed.take();
        }
        if self.tx.sending.is_some() {
            return;
        }
        let bus_off = cx.wire.error_state(cx.node) == ErrorState::BusOff;
        let allowed = self.sends() && self.tx.pause.is_none() && !bus_off && !self.is_configuration();
        while let Some(source) = self.best_source().filter(|_| allowed) {
            match self.prepare(cx, source) {
                Ok(prepared) => return self.place(cx, prepared),
                Err(Unsendable::Mismatch(header)) => self.dlc_mismatch(cx, source, header),
                Err(Unsendable::NoRam(address)) => {
                    // transmit_address_error.
                    self.address_error(cx, address);
                    return self.fall_back(cx);
                }
            }
        }
        if self.tx.placed.take().is_some() {
            cx.wire.abort(cx.node);
        }
    }

    fn place(&mut self, cx: &mut Context<'_>, prepared: Prepared) {
        if self.tx.placed == Some(prepared) {
            return;
        }
        // 6.9.2: another FIFO starts with all its attempts.
        if self.tx.attempts.is_some_and(|(source, _)| source != prepared.source) {
            self.tx.attempts = None;
        }
        self.tx.placed = cx.wire.send(cx.node, prepared.frame).is_ok().then_some(prepared);
    }

    /// 6.12: the message is not sent.
    fn dlc_mismatch(&mut self, cx: &mut Context<'_>, source: u8, header: Header) {
        self.raise(pac::IntL::IVMIF);
        self.diagnose(pac::Bdiag1H::DLCMM);
        self.end_request(source);
        if self.config.choices.event_for_dlc_mismatch {
            self.store_event(cx, header.words, 0);
        }
    }

    pub(super) fn start_of_frame(&mut self, cx: &mut Context<'_>, role: Role) {
        self.regs.set_field(self.f.busy, 1);
        if role == Role::Receiver {
            // 6.8: after a received message there is no delay.
            if self.tx.pause.take().is_some() {
                self.scan(cx);
            }
            return;
        }
        if let Some(placed) = self.tx.placed.take() {
            self.tx.sending = Some(placed);
        }
        if core::mem::take(&mut self.system.tx_underflow) {
            self.transmission_underflows(cx);
        }
    }

    /// 6.13: a message was sent.
    pub(super) fn transmitted(&mut self, cx: &mut Context<'_>, frame: &Frame, sof: Time, res: Option<Time>) {
        self.count_message();
        let Some(sent) = self.tx.sending.take().or_else(|| self.tx.placed.take()) else { return };
        let Prepared { source, object, header, .. } = sent;
        self.tx.attempts = None;
        let history = core::mem::take(&mut self.tx.accumulated[usize::from(source)]);
        self.set_history(source, history);
        if self.con_h().stef() {
            let time = self.timestamp(frame, Moments { sof, res, valid: cx.now });
            self.store_event(cx, header.words, time);
        }
        match source {
            0 => self.queue_sent(object),
            _ => {
                let depth = self.depth(source);
                self.fifos.rings[usize::from(source)].pop(depth);
            }
        }
        let one_shot = self.config.choices.one_shot_ends_request
            && self.is_restricted()
            && self.attempts_of(source) == RetransmissionAttempts::Disabled;
        if self.fill(source) == 0 || self.fifos.aborting >> source & 1 == 1 || one_shot {
            self.end_request(source);
        }
        self.show_fifo(source);
        self.follow_abort_all(cx);
        let idle = self.con_h().txbws().number().unwrap_or(0);
        if idle > 0 {
            // 6.8: idle bits after the three of intermission. The request has to be there half a bit before the bit
            // boundary at which it may start.
            let bit = cx.wire.config(cx.node).nominal_bit().as_ps();
            self.tx.pause = Some(cx.now + Time::from_ps(bit * (u64::from(idle) + 3) - bit / 2));
        }
        self.scan(cx);
    }

    /// 6.9: lost arbitration, or an error.
    pub(super) fn transmission_ended(&mut self, cx: &mut Context<'_>, how: Ended) {
        let Some(failed) = self.tx.sending.take().or_else(|| self.tx.placed.take()) else { return };
        let source = failed.source;
        let flag = match how {
            Ended::ArbitrationLost => pac::FifoSta::TXLARB,
            Ended::Error => pac::FifoSta::TXERR,
        };
        self.tx.accumulated[usize::from(source)] |= flag.bits();
        let (_, status) = self.control_and_status(source);
        self.set_bits(status, u32::from(flag.bits()));
        if self.fifos.aborting >> source & 1 == 1 {
            self.aborted(source);
        } else if self.is_exhausted(source, how) {
            self.tx.attempts = None;
            self.end_request(source);
            self.set_bits(status, u32::from(pac::FifoSta::TXATIF.bits()));
        }
        self.combine(source);
        self.follow_abort_all(cx);
        self.scan(cx);
    }

    /// TXAT, which counts only if RTXAT says so.
    fn attempts_of(&self, source: u8) -> RetransmissionAttempts {
        match source {
            0 => pac::TxqconH::from_bits(self.word(self.r.txqcon_h)).txat(),
            _ => self.fifo_size(source).txat(),
        }
    }

    fn is_restricted(&self) -> bool {
        self.con_h().rtxat() == ConHRtxat::Restricted
    }

    fn is_exhausted(&mut self, source: u8, how: Ended) -> bool {
        if !self.is_restricted() {
            return false;
        }
        match (self.attempts_of(source), how) {
            (RetransmissionAttempts::Disabled, _) => true,
            // 6.9.2: lost arbitration uses up no attempt.
            (RetransmissionAttempts::Three, Ended::Error) => {
                let failed = self.tx.attempts.map_or(0, |(_, failed)| failed) + 1;
                self.tx.attempts = Some((source, failed));
                failed >= self.config.choices.three_attempts
            }
            _ => false,
        }
    }

    /// 6.9.2: a received message gives all attempts back.
    pub(super) fn renew_attempts(&mut self) {
        self.tx.attempts = None;
    }

    pub(super) fn set_history(&mut self, source: u8, flags: u16) {
        let (_, status) = self.control_and_status(source);
        let word = self.regs.get(status);
        self.regs.set(status, word & !u32::from(HISTORY) | u32::from(flags));
    }

    /// The node has dropped a request that had not started.
    pub(super) fn request_dropped(&mut self, cx: &mut Context<'_>) {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.placed = None;
        }
    }

    /// The node no longer sends: what it was doing is over, requests stay pending.
    pub(super) fn node_left(&mut self, _cx: &mut Context<'_>) {
        if !self.sends() {
            self.tx.sending = None;
            self.tx.placed = None;
            self.tx.pause = None;
        }
    }

    pub(super) const fn tx_timer(&self) -> Option<Time> {
        self.tx.pause
    }

    pub(super) fn tx_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.tx.pause.is_some_and(|at| at <= cx.now) {
            self.tx.pause = None;
            self.scan(cx);
        }
    }
}

/// The numbers of the bits that are 1, lowest first.
pub(super) fn numbers(mut mask: u32) -> impl Iterator<Item = u8> {
    core::iter::from_fn(move || {
        let bit = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (bit < 32).then_some(bit as u8)
    })
}
