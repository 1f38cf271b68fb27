//! Reception: which buffer takes a message, and what becomes of it (9.1, 9.2, 8.3.2).

use std::collections::VecDeque;

use can_frame::Frame;
use can_wire::{BusError, Role};
use dspic33_ecan_pac::{
    enums::{FilterTarget, OperationMode},
    registers::Intf,
};

use super::{
    EcanModel,
    config::{BytesBeyondDlc, ListenAllDestination},
    dma::{BUFFER_BYTES, Moved},
    message,
};
use crate::{
    diagnostic::{Bits, DiagnosticKind},
    model::Context,
};

/// What reception knows besides the registers.
#[derive(Clone, Debug, Default)]
pub(super) struct Rx {
    /// The FIFO pointers have been loaded.
    pub(super) fifo_started: bool,
    /// Full buffers that the FIFO has filled, oldest first.
    pub(super) filled: VecDeque<u8>,
    /// The message that DMA is storing.
    storing: Option<Storing>,
    /// Data bytes in the message assembly buffer.
    assembly: [u8; 8],
}

/// A message whose words are on their way to DMA RAM.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Storing {
    buffer: u8,
    filter: u8,
    fifo: bool,
}

/// A filter that a message has matched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Hit {
    filter: u8,
    target: FilterTarget,
}

impl EcanModel {
    /// Bit per buffer: RXFUL.
    pub(super) fn full(&self) -> u32 {
        self.regs.get(self.n.rxful[0]) | self.regs.get(self.n.rxful[1]) << 16
    }

    /// Bit per buffer: RXOVF.
    pub(super) fn overflown(&self) -> u32 {
        self.regs.get(self.n.rxovf[0]) | self.regs.get(self.n.rxovf[1]) << 16
    }

    fn answers_remote(&self, buffer: u8) -> bool {
        self.is_transmit_buffer(buffer) && self.regs.is_set(self.n.tx[usize::from(buffer)].rtren)
    }

    /// A message was received without error.
    pub(super) fn received(&mut self, cx: &mut Context<'_>, frame: &Frame) {
        self.assemble(frame, frame.len());
        let hit = self.accept(frame);
        if hit.is_some() {
            self.capture(cx);
        }
        self.dispatch(cx, frame, hit);
    }

    fn dispatch(&mut self, cx: &mut Context<'_>, frame: &Frame, hit: Option<(Hit, bool)>) {
        match hit {
            Some((hit, true)) => self.take(cx, frame, hit),
            Some((hit, false)) => self.lose(hit.target),
            None => {}
        }
    }

    /// 7.4, listen_all_broken_message: a message with an error is stored as far as it had arrived.
    pub(super) fn broken_message(&mut self, cx: &mut Context<'_>, error: &BusError) {
        let takes = self.modes.now == OperationMode::ListenAll && self.config.choices.listen_all_stores_broken;
        if !takes || error.role != Role::Receiver || !error.position.field.is_in_frame() {
            return;
        }
        let partial = cx.wire.partial_frame(cx.node);
        let Some(frame) = partial.frame else { return };
        self.assemble(&frame, usize::from(partial.data_bytes));
        let hit = self.accept(&frame);
        self.dispatch(cx, &frame, hit);
    }

    fn assemble(&mut self, frame: &Frame, bytes: usize) {
        let arrived = &frame.data_bytes()[..bytes.min(frame.len())];
        if self.config.choices.bytes_beyond_dlc != BytesBeyondDlc::PreviousMessage {
            self.rx.assembly = [0; 8];
        }
        self.rx.assembly[..arrived.len()].copy_from_slice(arrived);
    }

    /// 9.2.1, note: the lowest-numbered matching filter that points to an empty buffer; if all are full, the lowest one.
    /// With it whether the message can be taken.
    fn accept(&mut self, frame: &Frame) -> Option<(Hit, bool)> {
        let enabled = self.enabled_filters();
        let mut first = None;
        for filter in (0..16).filter(|filter| enabled >> filter & 1 == 1) {
            if !self.matches(filter, frame) {
                continue;
            }
            let hit = Hit { filter, target: self.target(filter) };
            if self.is_empty(hit.target, frame) {
                return Some((hit, true));
            }
            first.get_or_insert(hit);
        }
        if first.is_none() && self.modes.now == OperationMode::ListenAll {
            let hit = self.unfiltered(enabled)?;
            return Some((hit, self.is_empty(hit.target, frame)));
        }
        Some((first?, false))
    }

    /// 7.4, listen_all_destination.
    fn unfiltered(&self, enabled: u16) -> Option<Hit> {
        match self.config.choices.listen_all_destination {
            ListenAllDestination::FirstFilter => {
                let filter = (0..16).find(|filter| enabled >> filter & 1 == 1)?;
                Some(Hit { filter, target: self.target(filter) })
            }
            ListenAllDestination::Buffer0 => Some(Hit { filter: 0, target: FilterTarget::Buffer(0) }),
            ListenAllDestination::Fifo => Some(Hit { filter: 0, target: FilterTarget::Fifo }),
        }
    }

    /// Whether a target can take a message now. A buffer that answers remote frames takes those.
    fn is_empty(&mut self, target: FilterTarget, frame: &Frame) -> bool {
        match target {
            FilterTarget::Buffer(buffer) if self.answers_remote(buffer) => frame.is_remote(),
            FilterTarget::Buffer(buffer) => self.can_store(buffer),
            FilterTarget::Fifo => {
                self.start_fifo();
                // fifo_among_several_filters.
                self.fifo_can_store() || !self.config.choices.fifo_counts_when_empty
            }
        }
    }

    fn can_store(&self, buffer: u8) -> bool {
        let beyond = u32::from(buffer) >= self.buffer_count() && !self.config.choices.pointer_beyond_buffers_stores;
        !beyond && !self.is_transmit_buffer(buffer) && self.full() >> buffer & 1 == 0
    }

    /// fsa_beyond_end: a FIFO that starts behind the last buffer has no buffer.
    fn fifo_can_store(&self) -> bool {
        let ((start, end), (write, _)) = (self.fifo_area(), self.fifo_pointers());
        start <= end && !self.is_transmit_buffer(write) && self.full() >> (write % 32) & 1 == 0
    }

    fn take(&mut self, cx: &mut Context<'_>, frame: &Frame, hit: Hit) {
        match hit.target {
            // 8.3.2: a remote frame is answered and not stored; remote_answer_flags: no flag.
            FilterTarget::Buffer(buffer) if self.answers_remote(buffer) => {
                self.set_request(buffer, true);
                self.tx.not_served &= !(1 << buffer);
                self.scan(cx);
            }
            FilterTarget::Buffer(buffer) => {
                if u32::from(buffer) >= self.buffer_count() {
                    // pointer_beyond_buffers.
                    let count = self.buffer_count();
                    let what =
                        format!("filter {} points to buffer {buffer}, but DMABS gives {count} buffers", hit.filter);
                    cx.report("9.2", DiagnosticKind::Contradiction { what });
                }
                self.begin_storing(cx, frame, Storing { buffer, filter: hit.filter, fifo: false });
            }
            FilterTarget::Fifo if self.fifo_can_store() => {
                let (buffer, _) = self.fifo_pointers();
                self.begin_storing(cx, frame, Storing { buffer, filter: hit.filter, fifo: true });
            }
            FilterTarget::Fifo => self.lose(hit.target),
        }
    }

    /// 9.2.5, 9.3.1: the message is lost. In the FIFO the write pointer advances all the same.
    fn lose(&mut self, target: FilterTarget) {
        match target {
            FilterTarget::Buffer(buffer) => {
                let choices = &self.config.choices;
                let flagged = if self.answers_remote(buffer) {
                    choices.data_frame_on_remote_buffer_overflows
                } else {
                    !self.is_transmit_buffer(buffer) || choices.frame_on_transmit_buffer_overflows
                };
                if flagged {
                    self.overflow(buffer);
                }
            }
            FilterTarget::Fifo => {
                let ((start, end), (write, _)) = (self.fifo_area(), self.fifo_pointers());
                if start > end {
                    return self.overflow(start);
                }
                self.overflow(write);
                self.advance_fifo();
            }
        }
    }

    /// Every lost message raises the interrupt, also if RXOVF is set already.
    fn overflow(&mut self, buffer: u8) {
        let slot = self.n.rxovf[usize::from(buffer / 16) % 2];
        self.regs.set(slot, self.regs.get(slot) | 1 << (buffer % 16));
        self.raise(Intf::RBOVIF);
    }

    /// 10.1.1: eight words go to DMA RAM before RXFUL is set.
    fn begin_storing(&mut self, cx: &mut Context<'_>, frame: &Frame, storing: Storing) {
        let buffer = u32::from(storing.buffer);
        let lost = |because| DiagnosticKind::TransferNotServed { request: "CxRX", buffer, because };
        if self.rx.storing.is_some() {
            // dma_late: the message assembly buffer is not free.
            return cx.report("10.1.1", lost("the words of the message before are still on their way"));
        }
        let mut data = self.rx.assembly;
        if self.config.choices.bytes_beyond_dlc == BytesBeyondDlc::Kept {
            self.keep_bytes(cx, storing.buffer, frame.len(), &mut data);
        }
        let words = message::encode(frame, storing.filter, &data);
        self.rx.storing = Some(storing);
        match self.store(cx, storing.buffer, words) {
            Moved::Yes => self.stored(),
            Moved::UnderWay => {}
            Moved::NoChannel => {
                self.rx.storing = None;
                cx.report("10.1.1", lost("no enabled DMA channel has the request"));
            }
        }
    }

    /// bytes_beyond_dlc: they keep what the buffer held.
    fn keep_bytes(&self, cx: &mut Context<'_>, buffer: u8, from: usize, data: &mut [u8; 8]) {
        let Some(channel) = self.dma.receive.channel else { return };
        let start = channel.start + u32::from(buffer) * BUFFER_BYTES + 6;
        let memory = cx.memory(self.config.memory);
        for (n, byte) in data.iter_mut().enumerate().skip(from) {
            *byte = memory.read(start as usize + n, Bits(8)).unwrap_or(0) as u8;
        }
    }

    /// Words that are late have gone.
    pub(super) fn receive_words_due(&mut self, cx: &mut Context<'_>) {
        if self.rx.storing.is_none() {
            return;
        }
        match self.move_receive_words(cx) {
            Moved::Yes => self.stored(),
            Moved::UnderWay => {}
            Moved::NoChannel => {
                let Some(storing) = self.rx.storing.take() else { return };
                let because = "the DMA channel was disabled before all words were moved";
                let buffer = u32::from(storing.buffer);
                cx.report("10.1.1", DiagnosticKind::TransferNotServed { request: "CxRX", buffer, because });
            }
        }
    }

    /// 9.2.5, 12.3.2: RXFUL, by the description with RBIF; then the FIFO pointer and its interrupt (9.3.1).
    fn stored(&mut self) {
        let Some(Storing { buffer, filter, fifo }) = self.rx.storing.take() else { return };
        self.served.received = buffer;
        self.served.filter = filter;
        let slot = self.n.rxful[usize::from(buffer / 16)];
        self.regs.set(slot, self.regs.get(slot) | 1 << (buffer % 16));
        if fifo {
            self.rx.filled.push_back(buffer);
            self.advance_fifo();
            if self.fifo_almost_full() {
                self.raise(Intf::FIFOIF);
            }
        }
    }
}
