//! The two DMA channels that move messages between the module and DMA RAM, a word at a time (10.0, 12.1, 12.2).
//!
//! The DMA controller has a manual of its own. This stands in for it as far as the module can tell: which words are moved
//! where and when.

use can_wire::Time;

use super::EcanModel;
use crate::{
    diagnostic::{Bits, DiagnosticKind},
    model::Context,
};

/// Words of a message (10.1).
pub(super) const WORDS: usize = 8;

/// Bytes of a message buffer (9.2).
pub(super) const BUFFER_BYTES: u32 = 16;

/// How a channel forms its addresses: DMAxCON.AMODE.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum DmaAddressing {
    /// 10: the module gives the buffer and the word. The only mode that works (9.2.1).
    #[default]
    PeripheralIndirect,
    /// 00: one word after the other from the start address, for each block anew.
    PostIncrement,
    /// 01: always the start address.
    Fixed,
}

/// A DMA channel that a request of the module is assigned to, and that is enabled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct DmaChannel {
    /// DMAxSTA: bytes from the start of the DMA RAM to buffer 0.
    pub start: u32,
    /// DMAxCON.AMODE.
    pub addressing: DmaAddressing,
    /// DMAxCNT plus one: transfers after which the channel raises its own interrupt and begins again.
    pub transfers: u16,
    /// DMAxCON.MODE: true for one-shot, in which the channel disables itself after these transfers.
    pub one_shot: bool,
    /// From the request for a word until the word has been moved.
    pub latency: Time,
}

impl DmaChannel {
    /// A channel as in Example 10-1: words, peripheral indirect, continuous, eight transfers for each message, without
    /// delay.
    #[must_use]
    pub const fn new(start: u32) -> Self {
        Self {
            start,
            addressing: DmaAddressing::PeripheralIndirect,
            transfers: WORDS as u16,
            one_shot: false,
            latency: Time::ZERO,
        }
    }

    /// The same with a delay for each word.
    #[must_use]
    pub const fn with_latency(mut self, latency: Time) -> Self {
        self.latency = latency;
        self
    }
}

/// What a channel has done so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct DmaStatistics {
    /// Words moved.
    pub words: u64,
    /// Interrupts of the channel: blocks of [`DmaChannel::transfers`] words that are complete.
    pub interrupts: u64,
}

/// One channel at work.
#[derive(Clone, Debug)]
pub(super) struct Port {
    pub(super) channel: Option<DmaChannel>,
    statistics: DmaStatistics,
    /// Transfers of the block that is under way.
    in_block: u16,
    /// The message that is being moved.
    pub(super) job: Option<Job>,
}

/// A message on its way through a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Job {
    pub(super) buffer: u8,
    pub(super) words: [u16; WORDS],
    moved: usize,
    next: Time,
}

impl Port {
    fn new(channel: Option<DmaChannel>) -> Self {
        Self { channel, statistics: DmaStatistics::default(), in_block: 0, job: None }
    }

    /// Address of a word in DMA RAM.
    fn address(&self, channel: &DmaChannel, buffer: u8, word: usize) -> u32 {
        let within = match channel.addressing {
            DmaAddressing::PeripheralIndirect => u32::from(buffer) * BUFFER_BYTES + 2 * word as u32,
            DmaAddressing::PostIncrement => 2 * u32::from(self.in_block),
            DmaAddressing::Fixed => 0,
        };
        channel.start.wrapping_add(within)
    }

    fn count(&mut self) {
        self.statistics.words += 1;
        self.in_block += 1;
        let Some(channel) = self.channel else { return };
        if self.in_block >= channel.transfers {
            self.in_block = 0;
            self.statistics.interrupts += 1;
            if channel.one_shot {
                self.channel = None;
            }
        }
    }
}

/// Both channels.
#[derive(Clone, Debug)]
pub(super) struct Dma {
    pub(super) transmit: Port,
    pub(super) receive: Port,
    /// The next received message goes to another buffer than it should.
    misplaced: Option<u8>,
}

/// What came of a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Moved {
    Yes,
    /// Not yet.
    UnderWay,
    NoChannel,
}

impl Dma {
    pub(super) fn new(transmit: Option<DmaChannel>, receive: Option<DmaChannel>) -> Self {
        Self { transmit: Port::new(transmit), receive: Port::new(receive), misplaced: None }
    }

    pub(super) fn next_timer(&self) -> Option<Time> {
        let next = |port: &Port| port.job.map(|job| job.next);
        [next(&self.transmit), next(&self.receive)].into_iter().flatten().min()
    }
}

impl EcanModel {
    /// Sets up the DMA channels anew: `None` where no enabled channel has the request.
    pub fn set_dma(&mut self, cx: &mut Context<'_>, transmit: Option<DmaChannel>, receive: Option<DmaChannel>) {
        for (port, channel) in [(&mut self.dma.transmit, transmit), (&mut self.dma.receive, receive)] {
            port.channel = channel;
            port.in_block = 0;
        }
        self.tx.not_served = 0;
        self.scan(cx);
    }

    /// The channels of the CxTX and of the CxRX request.
    #[must_use]
    pub const fn dma_channels(&self) -> [Option<DmaChannel>; 2] {
        [self.dma.transmit.channel, self.dma.receive.channel]
    }

    /// What the channels of the CxTX and of the CxRX request have done so far.
    #[must_use]
    pub const fn dma_statistics(&self) -> [DmaStatistics; 2] {
        [self.dma.transmit.statistics, self.dma.receive.statistics]
    }

    /// The next received message is written to this buffer instead of its own, as some silicon does (PIC24HJ errata
    /// DS80000441J, item 17). Its flags are those of its own buffer.
    pub fn misplace_next_message(&mut self, buffer: u8) {
        self.dma.misplaced = Some(buffer % 32);
    }

    /// Starts to fetch a message for transmission (10.1).
    pub(super) fn fetch(&mut self, cx: &mut Context<'_>, buffer: u8) -> Moved {
        let Some(channel) = self.dma.transmit.channel else { return Moved::NoChannel };
        let next = cx.now + channel.latency;
        self.dma.transmit.job = Some(Job { buffer, words: [0; WORDS], moved: 0, next });
        self.move_transmit_words(cx)
    }

    /// Moves the words that are due from DMA RAM to CxTXD.
    pub(super) fn move_transmit_words(&mut self, cx: &mut Context<'_>) -> Moved {
        let memory = self.config.memory;
        while let Some(mut job) = self.dma.transmit.job {
            let Some(channel) = self.dma.transmit.channel else {
                self.dma.transmit.job = None;
                return Moved::NoChannel;
            };
            if job.next > cx.now {
                return Moved::UnderWay;
            }
            let address = self.dma.transmit.address(&channel, job.buffer, job.moved);
            let word = cx.memory(memory).read(address as usize, Bits(16));
            if word.is_none() {
                cx.report("10.1", DiagnosticKind::MemoryOverrun { address });
            }
            // dma_in_filter_window: the address of CxTXD is that of RXF0EID.
            let reached = if self.dma_meets_filters() { self.n.rxfeid[0] } else { self.n.txd };
            self.regs.set(reached, word.unwrap_or(0));
            job.words[job.moved] = self.regs.get(self.n.txd) as u16;
            job.moved += 1;
            self.dma.transmit.count();
            job.next = cx.now + channel.latency;
            self.dma.transmit.job = Some(job);
            if job.moved == WORDS {
                return Moved::Yes;
            }
        }
        Moved::UnderWay
    }

    /// Starts to store a received message (10.1.1).
    pub(super) fn store(&mut self, cx: &mut Context<'_>, buffer: u8, words: [u16; WORDS]) -> Moved {
        let Some(channel) = self.dma.receive.channel else { return Moved::NoChannel };
        let buffer = self.dma.misplaced.take().unwrap_or(buffer);
        let next = cx.now + channel.latency;
        self.dma.receive.job = Some(Job { buffer, words, moved: 0, next });
        self.move_receive_words(cx)
    }

    /// Moves the words that are due from CxRXD to DMA RAM.
    pub(super) fn move_receive_words(&mut self, cx: &mut Context<'_>) -> Moved {
        let memory = self.config.memory;
        while let Some(mut job) = self.dma.receive.job {
            let Some(channel) = self.dma.receive.channel else {
                self.dma.receive.job = None;
                return Moved::NoChannel;
            };
            if job.next > cx.now {
                return Moved::UnderWay;
            }
            let address = self.dma.receive.address(&channel, job.buffer, job.moved);
            self.regs.set(self.n.rxd, u32::from(job.words[job.moved]));
            // dma_in_filter_window: the address of CxRXD is that of RXF0SID.
            let reached = if self.dma_meets_filters() { self.n.rxfsid[0] } else { self.n.rxd };
            let word = self.regs.get(reached);
            if !cx.memory(memory).write(address as usize, Bits(16), word) {
                cx.report("10.1.1", DiagnosticKind::MemoryOverrun { address });
            }
            job.moved += 1;
            self.dma.receive.count();
            job.next = cx.now + channel.latency;
            self.dma.receive.job = (job.moved < WORDS).then_some(job);
        }
        Moved::Yes
    }

    /// With the alternative of `dma_in_filter_window` the window is selected for the DMA controller too.
    fn dma_meets_filters(&self) -> bool {
        !self.config.choices.dma_ignores_window && self.regs.is_set(self.n.win)
    }

    /// True while the module asks for words to send, and for received words to be taken.
    pub(super) const fn data_requests(&self) -> (bool, bool) {
        let transmit = matches!(self.dma.transmit.job, Some(job) if job.moved < WORDS);
        (transmit, self.dma.receive.job.is_some())
    }
}
