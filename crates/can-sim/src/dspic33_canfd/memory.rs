//! Where message objects lie in system RAM, and how the module reaches them (5.4, 12.3.6).

use dspic33_canfd_pac::{
    enums::PayloadSize,
    messages::{RxObject, RxObjectTs, TefObject, TefObjectTs, TxObject},
    registers as pac,
};
use regbus::Mmio;

use super::Dspic33CanfdModel;
use crate::{diagnostic::DiagnosticKind, layout::Placed, model::Context};

/// Names of the sections, index 0 the queue.
const NAMES: [&str; 32] = [
    "txq", "fifo 1", "fifo 2", "fifo 3", "fifo 4", "fifo 5", "fifo 6", "fifo 7", "fifo 8", "fifo 9", "fifo 10",
    "fifo 11", "fifo 12", "fifo 13", "fifo 14", "fifo 15", "fifo 16", "fifo 17", "fifo 18", "fifo 19", "fifo 20",
    "fifo 21", "fifo 22", "fifo 23", "fifo 24", "fifo 25", "fifo 26", "fifo 27", "fifo 28", "fifo 29", "fifo 30",
    "fifo 31",
];

/// The sections in RAM, as the registers lay them out when Configuration mode is left.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub(super) tef: Placed,
    /// Index 0 is the queue.
    pub(super) objects: [Placed; 32],
}

impl Layout {
    pub(super) const fn empty() -> Self {
        const NOTHING: Placed = Placed { name: "", start: 0, element: 0, count: 0 };
        Self { tef: NOTHING, objects: [NOTHING; 32] }
    }
}

/// An address where no RAM is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NoRam;

/// Bytes that a payload size stands for.
pub(super) fn payload_bytes(size: PayloadSize) -> u32 {
    size.number().unwrap_or(0)
}

impl Dspic33CanfdModel {
    /// Equations 5-17 to 5-24.
    pub(super) fn compute_layout(&self) -> Layout {
        let con_h = self.con_h();
        let low = u32::from(pac::FifobaL::from_bits(self.word(self.r.fifoba_l)).fifoba()) * 4;
        let high = u32::from(pac::FifobaH::from_bits(self.word(self.r.fifoba_h)).fifoba());
        let mut at = high << 16 | low;
        let mut place = |name, element: usize, count: u32| {
            let placed = Placed { name, start: at, element: element as u32, count };
            at = at.wrapping_add(placed.element * placed.count);
            placed
        };
        let stamped = pac::TefconL::from_bits(self.word(self.r.tefcon_l)).teftsen();
        let event = if stamped { TefObjectTs::<Mmio>::BYTES } else { TefObject::<Mmio>::BYTES };
        let events = u32::from(pac::TefconH::from_bits(self.word(self.r.tefcon_h)).fsize()) + 1;
        let tef = place("tef", event, if con_h.stef() { events } else { 0 });
        let queue = pac::TxqconH::from_bits(self.word(self.r.txqcon_h));
        let count = if con_h.txqen() { u32::from(queue.fsize()) + 1 } else { 0 };
        let txq = place(NAMES[0], TxObject::<Mmio>::bytes(queue.plsize().bits().into()), count);
        let mut objects = [txq; 32];
        for number in 1..32_u8 {
            let (low, high) = (self.fifo_control(number), self.fifo_size(number));
            let code = usize::from(high.plsize().bits());
            // 5.4.5: RXTSEN makes no difference to a transmit FIFO.
            let bytes = match (self.is_transmit(number), low.rxtsen()) {
                (true, _) => TxObject::<Mmio>::bytes(code),
                (false, false) => RxObject::<Mmio>::bytes(code),
                (false, true) => RxObjectTs::<Mmio>::bytes(code),
            };
            // skipped_fifo_size: an unused FIFO takes its room too.
            objects[usize::from(number)] = place(NAMES[usize::from(number)], bytes, u32::from(high.fsize()) + 1);
        }
        Layout { tef, objects }
    }

    /// The sections of RAM: the event FIFO, the queue, FIFO 1 to 31. Addresses are bus addresses.
    #[must_use]
    pub fn layout(&self) -> Vec<Placed> {
        let layout = self.compute_layout();
        core::iter::once(layout.tef).chain(layout.objects).collect()
    }

    /// 5.4: nothing in hardware keeps a section inside the RAM.
    pub(super) fn check_section(&self, cx: &mut Context<'_>, placed: Placed) {
        let base = self.config.memory_base;
        let limit = base + cx.memory(self.config.memory).len() as u32 * 4;
        let (section, end) = (placed.name, placed.end());
        if placed.count > 0 && !(placed.start >= base && end <= limit) {
            cx.report("5.4", DiagnosticKind::SectionBeyondMemory { section, end, limit });
        }
    }

    #[inline]
    pub(super) fn ram_read(&self, cx: &mut Context<'_>, address: u32) -> Result<u16, NoRam> {
        let offset = address.checked_sub(self.config.memory_base).ok_or(NoRam)?;
        let word = cx.memory(self.config.memory).word(offset as usize / 4).ok_or(NoRam)?;
        Ok((word >> (offset % 4 * 8)) as u16)
    }

    /// Writes the bits of a 16-bit word that `mask` has.
    #[inline]
    pub(super) fn ram_write(&self, cx: &mut Context<'_>, address: u32, value: u16, mask: u16) -> Result<(), NoRam> {
        let offset = address.checked_sub(self.config.memory_base).ok_or(NoRam)?;
        let (index, shift) = (offset as usize / 4, offset % 4 * 8);
        let memory = cx.memory(self.config.memory);
        let word = memory.word(index).ok_or(NoRam)?;
        let mask = u32::from(mask) << shift;
        memory.set_word(index, word & !mask | u32::from(value) << shift & mask);
        Ok(())
    }

    /// Writes whole words.
    pub(super) fn ram_store(&self, cx: &mut Context<'_>, address: u32, words: &[u16]) -> Result<(), NoRam> {
        (address..).step_by(2).zip(words).try_for_each(|(at, word)| self.ram_write(cx, at, *word, 0xFFFF))
    }
}
