//! Looking into the module: what a buffer holds, how the filters are set, and the whole state in words.

use core::fmt::Write;

use can_frame::Frame;
use can_wire::Time;
use dspic33_ecan_pac::{enums::FilterTarget, messages::RxBufferWord7};

use super::{
    EcanModel,
    dma::{BUFFER_BYTES, WORDS},
    fifo::MAX_BUFFERS,
    message,
};
use crate::{diagnostic::Bits, memory::Memory, trace::RegisterTouched};

/// A message buffer in DMA RAM (5.0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BufferContents {
    /// Number of the buffer.
    pub buffer: u8,
    /// The words as they are.
    pub words: [u16; WORDS],
    /// The message that they describe, read as a transmit buffer.
    pub frame: Frame,
    /// FILHIT: the filter that the message hit. Meaningless in a transmit buffer.
    pub filter: u8,
}

/// The receive FIFO (9.3).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FifoState {
    /// First buffer: FSA.
    pub start: u8,
    /// Last buffer, by DMABS.
    pub end: u8,
    /// FBP.
    pub write: u8,
    /// FNRB.
    pub read: u8,
    /// Its full buffers, lowest first.
    pub full: Vec<u8>,
}

impl EcanModel {
    /// What a buffer holds. `memory` is the DMA RAM; the buffers are where the receive channel has them, or without one
    /// the transmit channel.
    #[must_use]
    pub fn buffer(&self, memory: &Memory, buffer: u8) -> BufferContents {
        let start = self.dma.receive.channel.or(self.dma.transmit.channel).map_or(0, |channel| channel.start);
        let address = start + u32::from(buffer) * BUFFER_BYTES;
        let word = |n: usize| memory.read(address as usize + 2 * n, Bits(16)).unwrap_or(0) as u16;
        let words = core::array::from_fn(word);
        let filter = RxBufferWord7::from_bits(words[7]).filhit().map_or_else(|code| code, |filter| filter.bits());
        BufferContents { buffer, words, frame: message::decode(&words), filter }
    }

    /// The receive FIFO.
    #[must_use]
    pub fn fifo(&self) -> FifoState {
        let ((start, end), (write, read)) = (self.fifo_area(), self.fifo_pointers());
        let full = (start..=end).filter(|buffer| self.full() >> buffer & 1 == 1).collect();
        FifoState { start, end, write, read, full }
    }

    /// Where a filter stores its messages; `None` while it is disabled.
    #[must_use]
    pub fn filter_target(&self, filter: u8) -> Option<FilterTarget> {
        (filter < 16 && self.enabled_filters() >> filter & 1 == 1).then(|| self.target(filter))
    }

    /// Whether an enabled filter matches a message, whatever becomes of it.
    #[must_use]
    pub fn filter_matches(&self, filter: u8, frame: &Frame) -> bool {
        self.filter_target(filter).is_some() && self.matches(filter, frame)
    }

    /// The buffer whose message is on the bus, and the one that comes next.
    #[must_use]
    pub fn transmitting(&self) -> (Option<u8>, Option<u8>) {
        (self.tx.sending.map(|sending| sending.buffer), self.tx.placed.map(|placed| placed.buffer))
    }

    /// Every register that differs from its reset value, decoded, then what no register tells.
    pub(super) fn dump(&self, now: Time) -> String {
        let (mode, power) = (self.modes.now, self.power);
        let mut text = format!("{} at {now}, mode {mode:?}, device {power:?}\n", self.regs.meta().title);
        let mut line = |line: core::fmt::Arguments<'_>| {
            let _infallible = writeln!(text, "{line}");
        };
        if let Some(target) = self.modes.target {
            line(format_args!("waiting for the bus to be idle for mode {target:?}"));
        }
        for slot in self.regs.slots() {
            let value = self.regs.get(slot);
            if value != self.regs.reset_value(slot) {
                let (name, fields) = (self.regs.name(slot), self.regs.info(slot).fields);
                line(format_args!("{value:#06x} {:?}", RegisterTouched { name, fields, value }));
            }
        }
        let fifo = self.fifo();
        line(format_args!(
            "{} buffers; FIFO {} to {}, next write {}, next read {}, full {:?}",
            self.buffer_count(),
            fifo.start,
            fifo.end,
            fifo.write,
            fifo.read,
            fifo.full
        ));
        let full: Vec<u32> = (0..MAX_BUFFERS).filter(|buffer| self.full() >> buffer & 1 == 1).collect();
        let lost: Vec<u32> = (0..MAX_BUFFERS).filter(|buffer| self.overflown() >> buffer & 1 == 1).collect();
        line(format_args!("full buffers {full:?}, overflown {lost:?}, interrupt code {}", self.interrupt_code()));
        for filter in (0..16).filter(|filter| self.enabled_filters() >> filter & 1 == 1) {
            line(format_args!("filter {filter} to {:?} by {:?}", self.target(filter), self.mask_source(filter)));
        }
        for (what, message) in [("on the bus", self.tx.sending), ("next", self.tx.placed)] {
            if let Some(message) = message {
                line(format_args!("{what}: buffer {}, {}", message.buffer, message.frame));
            }
        }
        for (request, channel) in ["CxTX", "CxRX"].into_iter().zip(self.dma_channels()) {
            match channel {
                Some(channel) => line(format_args!("DMA for {request}: {channel:?}")),
                None => line(format_args!("DMA for {request}: none")),
            }
        }
        text
    }
}
