//! Where the buffers of the FIFOs lie in system RAM, and errors on the way there (34.6, 34.12.1.4 to 34.12.1.6).

use can_wire::Time;
use pic32_can_pac::{
    enums::{FifoConDonly, FifoConTxen},
    messages::{RxBuffer, RxDataBuffer, TxBuffer},
    registers::{self as pac, Int},
};
use regbus::Mmio;

use super::Pic32CanModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

/// The two fatal errors (34.12.1.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SystemError {
    /// A buffer lies where there is no RAM (34.12.1.5).
    Address,
    /// A received message was not stored before the next one arrived (34.12.1.6).
    Bandwidth,
}

/// Virtual addresses of the unmapped segments KSEG0 and KSEG1 of a MIPS processor begin here.
const FIRST_UNMAPPED_VIRTUAL_ADDRESS: u32 = 0x8000_0000;

/// Words of the largest buffer.
pub(super) const WORDS: usize = 4;

impl Pic32CanModel {
    pub(super) fn fifo_con(&self, fifo: u8) -> pac::FifoCon {
        pac::FifoCon::from_bits(self.regs.get(self.r.fifo_control[usize::from(fifo)]))
    }

    pub(super) fn transmits(&self, fifo: u8) -> bool {
        self.fifo_con(fifo).txen() == FifoConTxen::Transmit
    }

    /// Messages that a FIFO holds.
    pub(super) fn depth(&self, fifo: u8) -> u8 {
        self.fifo_con(fifo).fsize() + 1
    }

    /// Bytes of one buffer. DONLY has no effect on a transmit FIFO (Register 34-20).
    pub(super) fn buffer_bytes(&self, fifo: u8) -> u32 {
        let con = self.fifo_con(fifo);
        let bytes = match (con.txen(), con.donly()) {
            (FifoConTxen::Transmit, _) => TxBuffer::<Mmio>::BYTES,
            (FifoConTxen::Receive, FifoConDonly::FullMessage) => RxBuffer::<Mmio>::BYTES,
            (FifoConTxen::Receive, FifoConDonly::DataOnly) => RxDataBuffer::<Mmio>::BYTES,
        };
        bytes as u32
    }

    /// 34.6.1: every FIFO begins right behind the one before it, whether that is used or not.
    pub(super) fn lay_out(&mut self) {
        let mut next = self.regs.get(self.r.fifo_base);
        for fifo in 0..self.config.fifos {
            self.fifos.start[usize::from(fifo)] = next;
            next = next.wrapping_add(u32::from(self.depth(fifo)) * self.buffer_bytes(fifo));
        }
        self.fifos.end = next;
        self.fifos.written = [0; 32];
    }

    /// Physical address of a buffer.
    pub(super) fn buffer(&self, fifo: u8, index: u8) -> u32 {
        self.fifos.start[usize::from(fifo)].wrapping_add(u32::from(index) * self.buffer_bytes(fifo))
    }

    /// The FIFO and the number of the buffer in which an address lies.
    fn place_of(&self, address: u32) -> Option<(u8, u8)> {
        let starts = &self.fifos.start[..usize::from(self.config.fifos)];
        if address >= self.fifos.end {
            return None;
        }
        let fifo = starts.partition_point(|start| *start <= address).checked_sub(1)? as u8;
        let distance = address - self.fifos.start[usize::from(fifo)];
        Some((fifo, (distance / self.buffer_bytes(fifo)) as u8))
    }

    /// The number of the word in the memory; `None` where there is no RAM.
    fn word_number(&self, cx: &mut Context<'_>, address: u32) -> Option<usize> {
        let number = address.checked_sub(self.config.memory_base)? as usize / 4;
        (number < cx.memory(self.config.memory).len()).then_some(number)
    }

    /// The words of a buffer; `None` if it does not lie in RAM.
    pub(super) fn fetch(&self, cx: &mut Context<'_>, address: u32, words: usize) -> Option<[u32; WORDS]> {
        let last = address.checked_add(words as u32 * 4 - 4)?;
        let first = self.word_number(cx, address)?;
        self.word_number(cx, last)?;
        let memory = cx.memory(self.config.memory);
        Some(core::array::from_fn(|n| if n < words { memory.word(first + n).unwrap_or(0) } else { 0 }))
    }

    /// Stores words; returns false if they do not lie in RAM.
    pub(super) fn deposit(&self, cx: &mut Context<'_>, address: u32, words: &[u32]) -> bool {
        let last = address.checked_add(words.len() as u32 * 4 - 4);
        let Some((first, _)) = self.word_number(cx, address).zip(last.and_then(|last| self.word_number(cx, last)))
        else {
            return false;
        };
        let memory = cx.memory(self.config.memory);
        words.iter().enumerate().all(|(n, word)| memory.set_word(first + n, *word))
    }

    /// 34.12.1.4: a fatal error.
    pub(super) fn system_error(&mut self, cx: &mut Context<'_>, error: SystemError, address: u32) {
        if error == SystemError::Address {
            cx.report("34.12.1.5", DiagnosticKind::MemoryOverrun { address });
        }
        self.interrupts.system_error = Some(error);
        self.stop(cx);
        self.raise(Int::SERRIF);
    }

    /// Keeps the module from storing messages for a time, as another initiator with higher priority on the system bus does
    /// (34.12.1.6). A message waits; if the next one arrives meanwhile, that is a bus bandwidth error.
    pub fn block_system_bus(&mut self, cx: &mut Context<'_>, span: Time) {
        self.rx.blocked_until = cx.now + span;
    }

    /// When Configuration mode ends: the FIFOs up to the last one in use have to lie in RAM.
    pub(super) fn check_layout(&self, cx: &mut Context<'_>) {
        let Some(last) = (0..self.config.fifos).rev().find(|fifo| self.is_used(*fifo)) else { return };
        let base = self.regs.get(self.r.fifo_base);
        let end = u64::from(self.buffer(last, 0)) + u64::from(self.depth(last)) * u64::from(self.buffer_bytes(last));
        let memory = cx.memory(self.config.memory).len() as u64 * 4;
        let limit = u64::from(self.config.memory_base) + memory;
        if self.is_virtual(base, limit) {
            return;
        }
        if base < self.config.memory_base || end > limit {
            let (end, limit) = (end.min(u64::from(u32::MAX)) as u32, limit.min(u64::from(u32::MAX)) as u32);
            cx.report("34.6.1", DiagnosticKind::SectionBeyondMemory { section: "fifo", end, limit });
        }
    }

    /// A FIFO is in use: it transmits, a filter points to it, or it differs from its reset.
    fn is_used(&self, fifo: u8) -> bool {
        self.fifo_con(fifo) != pac::FifoCon::RESET || self.filters_pointing_to(fifo) != 0
    }

    fn is_virtual(&self, address: u32, limit: u64) -> bool {
        address >= FIRST_UNMAPPED_VIRTUAL_ADDRESS && u64::from(address) >= limit
    }

    /// 34.6: CiFIFOBA takes a physical address.
    pub(super) fn base_written(&mut self, cx: &mut Context<'_>) {
        let address = self.regs.get(self.r.fifo_base);
        let limit = u64::from(self.config.memory_base) + cx.memory(self.config.memory).len() as u64 * 4;
        if self.is_virtual(address, limit) {
            cx.report("34.6, Register 34-19", DiagnosticKind::AddressNotPhysical { register: "FIFOBA", address });
        }
        self.lay_out();
        self.show_all_fifos();
    }

    /// Software has written a word of RAM.
    pub(super) fn word_written(&mut self, cx: &mut Context<'_>, word: usize) {
        let address = (word as u32).wrapping_mul(4).wrapping_add(self.config.memory_base);
        let Some((fifo, index)) = self.place_of(address) else { return };
        let state = self.fifos.state[usize::from(fifo)];
        let depth = self.depth(fifo);
        if self.transmits(fifo) {
            self.fifos.written[usize::from(fifo)] |= 1 << index;
            let queued = (index + depth - state.module) % depth < state.count;
            if queued && self.fifo_con(fifo).txreq() {
                let buffer = u32::from(fifo);
                cx.report("34.6.2", DiagnosticKind::PendingBufferModified { buffer, address });
                self.fetch_again(cx, fifo, index);
            }
        } else if (index + depth - state.user) % depth < state.count {
            let fifo = u32::from(fifo);
            cx.report("34.6.3", DiagnosticKind::ReceivedMessageModified { fifo, address });
        }
    }
}
