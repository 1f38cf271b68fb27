//! Looking into the controller: what a FIFO holds, and the whole state in words.

use core::fmt::Write;

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use can_wire::Time;
use m_can_pac::{
    enums::{FrameFormat, FrameKind, IdFormat},
    messages::{RxBufferR0, RxBufferR1a, TxEventE0, TxEventE1b},
    registers as pac,
};

use super::MCanModel;
use crate::{layout, memory::Memory, trace::RegisterTouched};

/// A received message in Message RAM (2.4.2).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RxElement {
    /// Number of the element in its FIFO, or of the Rx Buffer.
    pub index: u32,
    /// The message, with as many bytes as the element holds; the rest reads 0.
    pub frame: Frame,
    /// The matching filter element; `None` if none matched.
    pub filter: Option<u8>,
    /// Bits 15:0 of R1: the timestamp, or with CCCR.UTSU the reference to it.
    pub timestamp: u16,
}

/// A Tx event in Message RAM (2.4.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TxEventElement {
    /// Number of the element.
    pub index: u32,
    /// The first word.
    pub e0: TxEventE0,
    /// The second word; its lower half has the layout that CCCR.WMM and CCCR.UTSU select.
    pub e1: TxEventE1b,
}

impl MCanModel {
    /// What an Rx FIFO holds, oldest first. `memory` is the Message RAM.
    #[must_use]
    pub fn rx_fifo(&self, memory: &Memory, fifo: usize) -> Vec<RxElement> {
        let (config, names) = (self.fifo_config(fifo), self.fifo_names(fifo));
        let words = Self::rx_element_words(config.code);
        let (get, level) = (self.regs.field(names.get), self.regs.field(names.level));
        let element = |offset: u32| {
            let index = (get + offset) % config.size.max(1);
            element(memory, index, config.start + index * words, words)
        };
        (0..level).map(element).collect()
    }

    /// What a dedicated Rx Buffer holds, new or not. `memory` is the Message RAM.
    #[must_use]
    pub fn rx_buffer_element(&self, memory: &Memory, number: u8) -> RxElement {
        let (start, code) = self.rx_buffer(number);
        element(memory, u32::from(number), start, Self::rx_element_words(code))
    }

    /// What the Tx Event FIFO holds, oldest first. `memory` is the Message RAM.
    #[must_use]
    pub fn tx_events(&self, memory: &Memory) -> Vec<TxEventElement> {
        let start = u32::from(pac::Txefc::from_bits(self.regs.get(self.r.txefc)).efsa());
        let (get, level) = (self.regs.field(self.f.efgi), self.regs.field(self.f.effl));
        let word = |at: u32| memory.word(at as usize).unwrap_or(0);
        let event = |offset: u32| {
            let index = (get + offset) % self.event_fifo_size().max(1);
            let at = start + index * 2;
            TxEventElement { index, e0: TxEventE0::from_bits(word(at)), e1: TxEventE1b::from_bits(word(at + 1)) }
        };
        (0..level).map(event).collect()
    }

    /// The Message RAM as the registers divide it; Rx Buffers, whose number no register tells, are shown as one.
    #[must_use]
    pub fn layout(&self) -> Vec<layout::Placed> {
        layout::sections(&self.regs, |_| 1)
    }

    /// Every register that differs from its reset value, decoded, then what no register tells.
    pub(super) fn dump(&self, now: Time) -> String {
        let mut text = format!("{} at {now}, node {:?}\n", self.regs.meta().title, self.modes.mode);
        for slot in self.regs.slots() {
            let value = self.regs.get(slot);
            if value != self.regs.reset_value(slot) {
                let (name, fields) = (self.regs.name(slot), self.regs.info(slot).fields);
                let _infallible = writeln!(text, "{value:#010x} {:?}", RegisterTouched { name, fields, value });
            }
        }
        for section in self.layout().iter().filter(|section| section.count > 0) {
            let (name, start, end) = (section.name, section.start, section.end());
            let _infallible = writeln!(text, "{name}: bytes {start:#06x} to {end:#06x}, {} elements", section.count);
        }
        if let Some(sending) = self.tx.sending {
            let _infallible = writeln!(text, "on the bus: buffer {}, {}", sending.buffer, sending.frame);
        }
        if let Some(placed) = self.tx.placed {
            let _infallible = writeln!(text, "next: buffer {}, {}", placed.buffer, placed.frame);
        }
        for (at, command) in &self.commands {
            let _infallible = writeln!(text, "under way until {at}: {command:?}");
        }
        text
    }
}

fn element(memory: &Memory, index: u32, start: u32, words: u32) -> RxElement {
    let word = |at: u32| memory.word((start + at) as usize).unwrap_or(0);
    let (r0, r1) = (RxBufferR0::from_bits(word(0)), RxBufferR1a::from_bits(word(1)));
    let id = match r0.xtd() {
        IdFormat::Standard => StandardId::new((r0.id() >> 18) as u16).map(Id::Standard),
        IdFormat::Extended => ExtendedId::new(r0.id()).map(Id::Extended),
    };
    let format = match (r1.fdf(), r0.rtr()) {
        (FrameFormat::Fd, _) => Format::Fd(FdFlags { brs: r1.brs(), esi: r0.esi().bits() == 1 }),
        (FrameFormat::Classic, FrameKind::Remote) => Format::Remote,
        (FrameFormat::Classic, FrameKind::Data) => Format::Data,
    };
    let data: Vec<u8> = (2..words).flat_map(|at| word(at).to_le_bytes()).collect();
    let dlc = Dlc::from_low_bits(r1.dlc().bits());
    RxElement {
        index,
        // 11 and 29 bits are what the fields have.
        frame: Frame::from_fields(id.unwrap_or(Id::Standard(StandardId::ZERO)), format, dlc, &data),
        filter: (!r1.anmf()).then(|| r1.fidx()),
        timestamp: r1.rxts(),
    }
}
