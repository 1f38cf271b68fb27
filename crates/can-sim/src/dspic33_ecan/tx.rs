//! Transmission: requests, priority, what becomes of a message (8.0, 8.1).

use can_frame::Frame;
use dspic33_ecan_pac::registers::Intf;

use super::{
    EcanModel,
    dma::{Moved, WORDS},
    message,
    modes::sends,
};
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

/// Buffers that can transmit (1.2).
pub(super) const TX_BUFFERS: u8 = 8;

/// A message that has been handed to the protocol engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Prepared {
    pub(super) buffer: u8,
    pub(super) frame: Frame,
}

/// What transmission knows besides the registers.
#[derive(Clone, Debug, Default)]
pub(super) struct Tx {
    /// Handed to the engine, not started.
    pub(super) placed: Option<Prepared>,
    /// On the bus, or about to be in the next bit.
    pub(super) sending: Option<Prepared>,
    /// Bit per buffer: its message is aborted if its frame on the bus does not succeed.
    pub(super) aborting: u8,
    /// Bit per buffer: no DMA channel has fetched its message, which was reported.
    pub(super) not_served: u8,
}

impl EcanModel {
    pub(super) fn is_transmit_buffer(&self, buffer: u8) -> bool {
        buffer < TX_BUFFERS && self.regs.is_set(self.n.tx[usize::from(buffer)].txen)
    }

    /// Bit per buffer: TXREQ.
    pub(super) fn requests(&self) -> u8 {
        (0..TX_BUFFERS)
            .filter(|buffer| self.regs.is_set(self.n.tx[usize::from(*buffer)].txreq))
            .fold(0, |mask, n| mask | 1 << n)
    }

    pub(super) fn set_request(&mut self, buffer: u8, on: bool) {
        self.regs.set_field(self.n.tx[usize::from(buffer)].txreq, u32::from(on));
    }

    /// 8.2, abort_outcome: TXREQ of a message on the bus that is to be aborted stays 1 until it is known what becomes of
    /// the frame.
    pub(super) fn write_trcon(&mut self, cx: &Context<'_>, register: usize, access: &mut WriteAccess) {
        self.settle(cx);
        let Some(sending) = self.tx.sending.filter(|sending| usize::from(sending.buffer) / 2 == register) else {
            return;
        };
        let request = self.n.tx[usize::from(sending.buffer)].txreq.bits();
        if access.old & request != 0 && access.new & request == 0 {
            access.new |= request;
            self.tx.aborting |= 1 << sending.buffer;
        }
    }

    /// The host has written the control register of two buffers.
    pub(super) fn trcon_written(&mut self, cx: &mut Context<'_>, register: usize, access: &WriteAccess) {
        self.settle(cx);
        for lane in 0..2 {
            let buffer = (2 * register + lane) as u8;
            let names = self.n.tx[usize::from(buffer)];
            let was = |field: crate::registers::FieldAt| access.old & field.bits() != 0;
            let is = |field: crate::registers::FieldAt| access.new & field.bits() != 0;
            match (was(names.txreq), is(names.txreq)) {
                (false, true) => self.requested(cx, buffer),
                (true, false) => self.abort_buffer(cx, buffer),
                (true, true) if was(names.txen) && !is(names.txen) => {
                    // txen_change_while_pending.
                    let because = "TXEN was cleared while TXREQ is set; the message is aborted";
                    let buffer_number = u32::from(buffer);
                    cx.report(
                        "8.0",
                        DiagnosticKind::RequestIgnored { register: "TRCON", buffer: buffer_number, because },
                    );
                    self.abort_buffer(cx, buffer);
                }
                _ => {}
            }
        }
        self.scan(cx);
    }

    /// 8.1: TXREQ was set. What the last request has left is cleared, by the description.
    fn requested(&mut self, cx: &mut Context<'_>, buffer: u8) {
        let bit = 1 << buffer;
        self.tx.not_served &= !bit;
        let number = u32::from(buffer);
        if !self.is_transmit_buffer(buffer) {
            // 9.2.2, txreq_on_receive_buffer.
            let because = "TXEN is 0: it is a receive buffer";
            cx.report("9.2.2", DiagnosticKind::RequestIgnored { register: "TRCON", buffer: number, because });
        } else if number >= self.buffer_count() {
            // transmit_buffer_beyond_buffers.
            let what = format!("buffer {buffer} is to be sent, but DMABS gives {} buffers", self.buffer_count());
            cx.report("10.0", DiagnosticKind::Contradiction { what });
        }
        if self.regs.is_set(self.n.abat) {
            // abat_completion: a request made meanwhile is aborted too.
            self.abort_request(buffer);
        }
    }

    /// The engine may have begun with a message since it was placed.
    pub(super) fn settle(&mut self, cx: &Context<'_>) {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.sending = self.tx.placed.take();
        }
    }

    /// 8.1: the ready buffer with the highest priority; among equal ones the highest number.
    fn best(&self) -> Option<u8> {
        let ready = |buffer: &u8| self.is_transmit_buffer(*buffer) || self.config.choices.receive_buffer_is_sent;
        let pending = self.requests() & !self.tx.aborting & !self.tx.not_served;
        let pending = (0..TX_BUFFERS).filter(|buffer| pending >> buffer & 1 == 1).filter(ready);
        pending.max_by_key(|buffer| (self.regs.field(self.n.tx[usize::from(*buffer)].txpri), *buffer))
    }

    fn may_send(&self, cx: &Context<'_>) -> bool {
        !self.clocks_stopped() && self.modes.target.is_none() && sends(self.modes.now) && !self.is_bus_off(cx)
    }

    /// 8.1: before a start of frame all ready buffers are looked at.
    pub(super) fn scan(&mut self, cx: &mut Context<'_>) {
        if self.requests() == 0 && self.tx.placed.is_none() && self.dma.transmit.job.is_none() {
            return;
        }
        self.settle(cx);
        if self.tx.sending.is_some() {
            return;
        }
        loop {
            let Some(buffer) = self.best().filter(|_| self.may_send(cx)) else {
                self.dma.transmit.job = None;
                return self.withdraw(cx);
            };
            if self.tx.placed.is_some_and(|placed| placed.buffer == buffer) {
                self.dma.transmit.job = None;
                return;
            }
            if self.dma.transmit.job.is_some_and(|job| job.buffer == buffer) {
                return;
            }
            match self.fetch(cx, buffer) {
                Moved::Yes => return self.fetched(cx),
                Moved::UnderWay => return,
                Moved::NoChannel => self.not_fetched(cx, buffer),
            }
        }
    }

    /// dma_late: without a channel nothing is sent, and it is reported once for a request.
    fn not_fetched(&mut self, cx: &mut Context<'_>, buffer: u8) {
        self.tx.not_served |= 1 << buffer;
        let because = "no enabled DMA channel has the request";
        cx.report("10.1", DiagnosticKind::TransferNotServed { request: "CxTX", buffer: u32::from(buffer), because });
    }

    /// Words that are late have come.
    pub(super) fn transmit_words_due(&mut self, cx: &mut Context<'_>) {
        let Some(buffer) = self.dma.transmit.job.map(|job| job.buffer) else { return };
        match self.move_transmit_words(cx) {
            Moved::Yes => self.fetched(cx),
            Moved::UnderWay => {}
            Moved::NoChannel => {
                self.not_fetched(cx, buffer);
                self.scan(cx);
            }
        }
    }

    /// All words of a message are in the module: it is handed to the engine, in place of one that has not started.
    fn fetched(&mut self, cx: &mut Context<'_>) {
        let Some(job) = self.dma.transmit.job.take() else { return };
        self.settle(cx);
        if self.tx.sending.is_some() {
            return;
        }
        let words: [u16; WORDS] = job.words;
        Self::check_message(cx, job.buffer, &words);
        let frame = message::decode(&words);
        match cx.wire.send(cx.node, frame) {
            Ok(_) => self.tx.placed = Some(Prepared { buffer: job.buffer, frame }),
            Err(error) => {
                self.tx.placed = None;
                cx.report("8.1", DiagnosticKind::Contradiction { what: format!("buffer {}: {error}", job.buffer) });
            }
        }
    }

    /// Takes back a message that has not started.
    fn withdraw(&mut self, cx: &mut Context<'_>) {
        if self.tx.placed.take().is_some() {
            cx.wire.abort(cx.node);
        }
    }

    /// Start of the module's own frame.
    pub(super) fn own_frame_started(&mut self) {
        if let Some(placed) = self.tx.placed.take() {
            self.tx.sending = Some(placed);
        }
    }

    fn sent_or_failed(&mut self) -> Option<Prepared> {
        self.tx.sending.take().or_else(|| self.tx.placed.take())
    }

    /// 8.1, 12.3.1: the message was sent. abort_outcome: also if it should have been aborted.
    pub(super) fn transmitted(&mut self, cx: &mut Context<'_>) {
        let Some(sent) = self.sent_or_failed() else { return };
        self.tx.aborting &= !(1 << sent.buffer);
        self.set_request(sent.buffer, false);
        if !self.config.choices.txerr_stays {
            self.regs.set_field(self.n.tx[usize::from(sent.buffer)].txerr, 0);
        }
        self.served.transmitted = sent.buffer;
        self.raise(Intf::TBIF);
        self.finish_abort_all();
        self.scan(cx);
    }

    /// 8.1, Table 8-1: the message lost arbitration and stays pending.
    pub(super) fn arbitration_lost(&mut self, cx: &mut Context<'_>) {
        self.not_sent(cx, |names| names.txlarb);
    }

    /// 8.1: the message met an error and stays pending.
    pub(super) fn transmission_failed(&mut self, cx: &mut Context<'_>) {
        self.not_sent(cx, |names| names.txerr);
    }

    fn not_sent(&mut self, cx: &mut Context<'_>, record: impl Fn(&super::names::TxNames) -> crate::registers::FieldAt) {
        let Some(failed) = self.sent_or_failed() else { return };
        let names = self.n.tx[usize::from(failed.buffer)];
        self.regs.set_field(record(&names), 1);
        if self.tx.aborting >> failed.buffer & 1 == 1 {
            self.abort_request(failed.buffer);
            self.finish_abort_all();
        }
        self.scan(cx);
    }

    /// The engine has dropped a message: the mode or the error state does not allow it any more. It stays pending.
    pub(super) fn request_dropped(&mut self, cx: &mut Context<'_>) {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.placed = None;
        }
    }

    /// The host has written into DMA RAM: the message of a pending request must not change.
    pub(super) fn watch_pending_buffers(&mut self, cx: &mut Context<'_>, word: usize) {
        let Some(channel) = self.dma.transmit.channel else { return };
        let address = word as u32 * 4;
        let Some(buffer) = address.checked_sub(channel.start).map(|distance| distance / super::dma::BUFFER_BYTES)
        else {
            return;
        };
        if buffer < u32::from(TX_BUFFERS) && self.requests() >> buffer & 1 == 1 && self.is_transmit_buffer(buffer as u8)
        {
            cx.report("8.1", DiagnosticKind::PendingBufferModified { buffer, address });
        }
    }
}
