//! Requests, priorities, and the course of a transmission (34.7.2, 34.7.3, 34.7.5).

use can_frame::Frame;
use can_wire::Role;
use pic32_can_pac::{enums::OperationMode, registers::FifoCon};

use super::{Pic32CanModel, bits};
use crate::{diagnostic::DiagnosticKind, model::Context};

/// A message that has been handed to the protocol engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Placed {
    pub(super) fifo: u8,
    pub(super) index: u8,
    pub(super) frame: Frame,
    /// Its FIFO has been reset since: the message goes on, but no pointer follows.
    pub(super) orphan: bool,
}

/// What transmission knows besides the registers.
#[derive(Clone, Debug, Default)]
pub(super) struct Tx {
    /// FIFOs with TXEN and TXREQ.
    pub(super) requested: u32,
    /// Of these, the ones whose abort waits for the end of their message.
    pub(super) aborting: u32,
    /// Handed to the engine, not started.
    pub(super) placed: Option<Placed>,
    /// On the bus, or about to be in the next bit.
    pub(super) sending: Option<Placed>,
    /// The write under way clears TXREQ.
    pub(super) abort_wanted: bool,
}

impl Tx {
    /// The node has gone off the bus.
    pub(super) fn forget(&mut self) {
        self.placed = None;
        self.sending = None;
    }
}

impl Pic32CanModel {
    /// CiFIFOCONn has been written: TXREQ and TXPRI as they are now, and an abort if it was asked for.
    pub(super) fn requests_written(&mut self, cx: &mut Context<'_>, fifo: u8) {
        let con = self.fifo_con(fifo);
        let abort = core::mem::take(&mut self.tx.abort_wanted);
        let bit = 1 << fifo;
        if con.txreq() && self.transmits(fifo) {
            self.tx.requested |= bit;
            let empty = self.fifos.state[usize::from(fifo)].count == 0;
            if empty && !self.config.choices.txreq_waits_for_message {
                // txreq_on_empty_fifo.
                self.request_done(fifo);
            }
        } else {
            self.tx.requested &= !bit;
        }
        if abort {
            self.abort(cx, fifo);
        } else {
            self.schedule(cx);
        }
    }

    /// TXREQ is cleared by hardware.
    pub(super) fn request_done(&mut self, fifo: u8) {
        self.tx.requested &= !(1 << fifo);
        self.tx.aborting &= !(1 << fifo);
        self.clear_control(fifo, FifoCon::TXREQ);
        if self.tx.aborting == 0 {
            // Register 34-1: all transmissions are aborted.
            self.regs.set_field(self.f.abat, 0);
        }
    }

    pub(super) fn withdraw_requests(&mut self) {
        for fifo in bits(self.tx.requested) {
            self.request_done(fifo);
        }
    }

    /// A FIFO has been reset: its messages are gone, and its request with them (txreq_after_fifo_reset).
    pub(super) fn tx_fifo_reset(&mut self, cx: &mut Context<'_>, fifo: u8) {
        if self.tx.requested >> fifo & 1 == 1 && !self.config.choices.txreq_survives_reset {
            self.request_done(fifo);
        }
        self.tx.aborting &= !(1 << fifo);
        self.begun(cx);
        if let Some(sending) = &mut self.tx.sending
            && sending.fifo == fifo
        {
            sending.orphan = true;
        }
        self.schedule(cx);
    }

    /// 34.5: the modes in which messages are sent. A message waits in the others (txreq_in_passive_modes).
    fn sends(&self) -> bool {
        let transmits =
            matches!(self.mode(), OperationMode::Normal | OperationMode::ListenAll | OperationMode::Loopback);
        self.is_running() && transmits && !self.errors.is_bus_off()
    }

    /// The engine may have begun with the placed message: its start of frame follows in the next bit.
    pub(super) fn begun(&mut self, cx: &mut Context<'_>) {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.sending = self.tx.placed.take();
        }
    }

    /// 34.7.3: compares the priority of all FIFOs that are ready, and hands over the best message.
    pub(super) fn schedule(&mut self, cx: &mut Context<'_>) {
        if self.tx.requested == 0 && self.tx.placed.is_none() {
            return;
        }
        self.begun(cx);
        if self.tx.sending.is_some() {
            return;
        }
        let best = if self.sends() { self.best() } else { None };
        let Some(fifo) = best else {
            if self.tx.placed.take().is_some() {
                cx.wire.abort(cx.node);
            }
            return;
        };
        let index = self.fifos.state[usize::from(fifo)].module;
        if self.tx.placed.is_some_and(|placed| (placed.fifo, placed.index) == (fifo, index)) {
            return;
        }
        self.place(cx, fifo, index);
    }

    /// The highest TXPRI, and of equal ones the highest number.
    fn best(&self) -> Option<u8> {
        let ready =
            bits(self.tx.requested & !self.tx.aborting).filter(|fifo| self.fifos.state[usize::from(*fifo)].count > 0);
        ready.max_by_key(|fifo| (self.fifo_con(*fifo).txpri().bits(), *fifo))
    }

    fn place(&mut self, cx: &mut Context<'_>, fifo: u8, index: u8) {
        let Some(frame) = self.message(cx, fifo, index) else { return };
        match cx.wire.send(cx.node, frame) {
            Ok(_) => self.tx.placed = Some(Placed { fifo, index, frame, orphan: false }),
            Err(error) => {
                self.tx.placed = None;
                cx.report("34.7", DiagnosticKind::Contradiction { what: format!("FIFO {fifo}: {error}") });
            }
        }
    }

    /// Software has changed a message that is requested.
    pub(super) fn fetch_again(&mut self, cx: &mut Context<'_>, fifo: u8, index: u8) {
        self.begun(cx);
        if self.tx.placed.is_some_and(|placed| (placed.fifo, placed.index) == (fifo, index)) {
            self.place(cx, fifo, index);
        }
    }

    pub(super) fn start_of_frame(&mut self, cx: &mut Context<'_>, role: Role) {
        self.message_boundary(cx, true);
        if role == Role::Transmitter
            && let Some(placed) = self.tx.placed.take()
        {
            self.tx.sending = Some(placed);
        }
        self.rx.begin();
    }

    /// A message was sent: the pointers follow, also if its abort was asked for (34.7.4).
    pub(super) fn transmitted(&mut self, cx: &mut Context<'_>, frame: &Frame) {
        let Some(sent) = self.tx.sending.take().or_else(|| self.tx.placed.take()) else { return };
        if !sent.orphan {
            let fifo = sent.fifo;
            let depth = self.depth(fifo);
            let state = &mut self.fifos.state[usize::from(fifo)];
            state.module = (state.module + 1) % depth;
            state.count -= 1;
            let empty = state.count == 0;
            let aborting = self.tx.aborting >> fifo & 1 == 1;
            self.clear_control(fifo, FifoCon::TXABAT);
            if aborting && !empty && self.config.choices.partial_abort_sets_flag {
                self.set_control(fifo, FifoCon::TXABAT);
            }
            if empty || aborting {
                self.request_done(fifo);
            }
            self.show_fifo(fifo);
        }
        // own_frames.
        if self.config.choices.own_frames_received && self.mode() != OperationMode::Loopback {
            self.received(cx, frame);
        }
        self.schedule(cx);
    }

    /// Register 34-20: lost arbitration, or an error. The message is sent again unless its abort was asked for.
    pub(super) fn transmission_ended(&mut self, cx: &mut Context<'_>, status: FifoCon) {
        let Some(failed) = self.tx.sending.take().or_else(|| self.tx.placed.take()) else { return };
        if !failed.orphan {
            self.set_control(failed.fifo, status);
            if self.tx.aborting >> failed.fifo & 1 == 1 {
                self.aborted(failed.fifo);
            }
        }
        self.schedule(cx);
    }

    /// The engine has dropped a message that had not started, or cut one off.
    pub(super) fn request_dropped(&mut self, cx: &mut Context<'_>) {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.placed = None;
        }
    }

    /// 34.7.5: a remote frame matched a filter that points to this transmit FIFO.
    pub(super) fn remote_request(&mut self, cx: &mut Context<'_>, fifo: u8) {
        if self.fifos.state[usize::from(fifo)].count == 0 {
            // remote_request_overflow: the flag exists in a transmit FIFO too.
            return self.overflow(fifo);
        }
        self.set_control(fifo, FifoCon::TXREQ);
        self.tx.requested |= 1 << fifo;
        self.schedule(cx);
    }

    /// The message that is on the bus, or next, with its FIFO.
    #[must_use]
    pub fn sending(&self) -> Option<(u8, Frame)> {
        self.tx.sending.or(self.tx.placed).map(|placed| (placed.fifo, placed.frame))
    }

    pub(super) fn is_sending(&self, fifo: u8) -> bool {
        self.tx.sending.is_some_and(|sending| sending.fifo == fifo && !sending.orphan)
    }
}
