//! Looking into the controller: what FIFOs hold, and the whole state in words.

use core::fmt::Write;

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use can_wire::Time;
use dspic33_canfd_pac::{
    enums::{DataPhaseRate, ErrorState, FrameFormat, IdentifierFormat},
    messages::{RxObjectR2, TxObjectT0, TxObjectT1, TxObjectT2},
};

use super::{Dspic33CanfdModel, names::Owner, tx::numbers};
use crate::{layout::Placed, memory::Memory, registers::Slot, trace::RegisterTouched};

/// A received message in RAM (table 9-1).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RxObjectHeld {
    /// Number of the object in its FIFO.
    pub index: u32,
    /// The message, with as many bytes as the object holds; the rest reads 0.
    pub frame: Frame,
    /// The filter that accepted it.
    pub filter: u8,
    /// The timestamp, if the FIFO stores them.
    pub timestamp: Option<u32>,
}

/// A message to send in RAM (table 6-1).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TxObjectHeld {
    /// Number of the object in its FIFO or the queue.
    pub index: u32,
    /// The message as the object describes it, with as many bytes as the object holds.
    pub frame: Frame,
    /// Sequence number.
    pub sequence: u32,
}

/// An event in RAM (table 7-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EventObject {
    /// Number of the object.
    pub index: u32,
    /// Identifier of the message that was sent.
    pub id: Id,
    /// Control bits.
    pub control: TxObjectT2,
    /// Sequence number.
    pub sequence: u32,
    /// The timestamp, if events are stamped.
    pub timestamp: Option<u32>,
}

/// RAM as the module addresses it.
struct Ram<'a> {
    memory: &'a Memory,
    base: u32,
}

impl Ram<'_> {
    fn word(&self, address: u32) -> u16 {
        let offset = address.saturating_sub(self.base);
        (self.memory.word(offset as usize / 4).unwrap_or(0) >> (offset % 4 * 8)) as u16
    }

    fn long(&self, address: u32) -> u32 {
        u32::from(self.word(address)) | u32::from(self.word(address + 2)) << 16
    }

    fn bytes(&self, from: u32, to: u32) -> Vec<u8> {
        (from..to).step_by(2).flat_map(|at| self.word(at).to_le_bytes()).collect()
    }

    fn id(&self, address: u32, extended: bool) -> Id {
        let (t0, t1) = (TxObjectT0::from_bits(self.word(address)), TxObjectT1::from_bits(self.word(address + 2)));
        let extension = u32::from(t0.eid()) | u32::from(t1.eid()) << 5;
        // 11 and 29 bits are what the fields have.
        match extended {
            false => Id::Standard(StandardId::new(t0.sid()).unwrap_or(StandardId::ZERO)),
            true => {
                let id = ExtendedId::new(u32::from(t0.sid()) << 18 | extension);
                Id::Extended(id.unwrap_or(ExtendedId::ZERO))
            }
        }
    }

    fn sequence(&self, address: u32) -> u32 {
        u32::from(TxObjectT2::from_bits(self.word(address + 4)).seq()) | u32::from(self.word(address + 6)) << 7
    }

    /// A message; the control bits of both kinds of objects stand in the same place.
    fn frame(&self, address: u32, data: &[u8]) -> Frame {
        let control = RxObjectR2::from_bits(self.word(address + 4));
        let fd = control.fdf() == FrameFormat::CanFd;
        let format = match (fd, control.rtr()) {
            (true, _) => Format::Fd(FdFlags {
                brs: control.brs() == DataPhaseRate::Data,
                esi: control.esi() == ErrorState::ErrorPassive,
            }),
            (false, true) => Format::Remote,
            (false, false) => Format::Data,
        };
        let id = self.id(address, control.ide() == IdentifierFormat::Extended);
        let twelfth = TxObjectT1::from_bits(self.word(address + 2)).sid11();
        Frame::from_fields(id, format, Dlc::from_low_bits(control.dlc().bits()), data)
            .with_remote_request_substitution(twelfth)
    }
}

impl Dspic33CanfdModel {
    const fn ram<'a>(&self, memory: &'a Memory) -> Ram<'a> {
        Ram { memory, base: self.config.memory_base }
    }

    /// Objects of a FIFO in use, oldest first, with their addresses.
    fn held(&self, number: u8, placed: Placed) -> Vec<(u32, u32)> {
        let ring = self.fifos.rings[usize::from(number)];
        let index = |offset: u32| (u32::from(ring.tail) + offset) % placed.count.max(1);
        (0..u32::from(ring.count)).map(|offset| (index(offset), placed.address(index(offset)))).collect()
    }

    /// What receive FIFO `number`, 1 to 31, holds, oldest first. `memory` is the RAM. Empty for a transmit FIFO.
    #[must_use]
    pub fn rx_fifo(&self, memory: &Memory, number: u8) -> Vec<RxObjectHeld> {
        if !(1..32).contains(&number) || self.is_transmit(number) {
            return Vec::new();
        }
        let ram = self.ram(memory);
        let placed = self.layout.objects[usize::from(number)];
        let stamped = self.fifo_control(number).rxtsen();
        let object = |(index, address): (u32, u32)| {
            let data = ram.bytes(address + if stamped { 12 } else { 8 }, address + placed.element);
            let filter = RxObjectR2::from_bits(ram.word(address + 4)).filhit().bits();
            let timestamp = stamped.then(|| ram.long(address + 8));
            RxObjectHeld { index, frame: ram.frame(address, &data), filter, timestamp }
        };
        self.held(number, placed).into_iter().map(object).collect()
    }

    /// What transmit FIFO `number`, 1 to 31, or the queue, number 0, holds: a FIFO oldest first, the queue by object.
    #[must_use]
    pub fn tx_fifo(&self, memory: &Memory, number: u8) -> Vec<TxObjectHeld> {
        if number > 31 || !self.is_transmit(number) {
            return Vec::new();
        }
        let ram = self.ram(memory);
        let placed = self.layout.objects[usize::from(number)];
        let held = match number {
            0 => numbers(self.fifos.queue.used).map(|n| (u32::from(n), placed.address(u32::from(n)))).collect(),
            _ => self.held(number, placed),
        };
        let object = |(index, address): (u32, u32)| {
            let data = ram.bytes(address + 8, address + placed.element);
            TxObjectHeld { index, frame: ram.frame(address, &data), sequence: ram.sequence(address) }
        };
        held.into_iter().map(object).collect()
    }

    /// What the event FIFO holds, oldest first.
    #[must_use]
    pub fn events(&self, memory: &Memory) -> Vec<EventObject> {
        let ram = self.ram(memory);
        let stamped = self.layout.tef.element > 8;
        let event = |(index, address): (u32, u32)| {
            let control = TxObjectT2::from_bits(ram.word(address + 4));
            let id = ram.id(address, control.ide() == IdentifierFormat::Extended);
            let timestamp = stamped.then(|| ram.long(address + 8));
            EventObject { index, id, control, sequence: ram.sequence(address), timestamp }
        };
        self.held(0, self.layout.tef).into_iter().map(event).collect()
    }

    /// A FIFO that can send or receive something.
    fn is_used(&self, number: u8) -> bool {
        self.is_transmit(number) || self.is_filter_target(number)
    }

    fn is_worth_showing(&self, slot: Slot) -> bool {
        match self.arrays.owner(slot) {
            Owner::Control(number) | Owner::Size(number) | Owner::Status(number) | Owner::Address(number) => {
                self.is_used(number)
            }
            Owner::FilterControl(_) | Owner::Module => true,
        }
    }

    /// Every register that differs from its reset value, decoded, then what no register tells.
    pub(super) fn dump(&self, now: Time) -> String {
        let mut text = format!("{} at {now}, node {:?}\n", self.regs.meta().title, self.modes.node);
        for slot in self.regs.slots() {
            let value = self.regs.get(slot);
            if value != self.regs.reset_value(slot) && self.is_worth_showing(slot) {
                let (name, fields) = (self.regs.name(slot), self.regs.info(slot).fields);
                let _infallible = writeln!(text, "{value:#06x} {:?}", RegisterTouched { name, fields, value });
            }
        }
        let layout = self.compute_layout();
        let fifos = (0..32_u8).zip(layout.objects).filter(|(number, _)| self.is_used(*number));
        let sections = core::iter::once(layout.tef).chain(fifos.map(|(_, placed)| placed));
        for section in sections.filter(|section| section.count > 0) {
            let (name, start, end) = (section.name, section.start, section.end());
            let _infallible = writeln!(text, "{name}: bytes {start:#06x} to {end:#06x}, {} objects", section.count);
        }
        for number in (0..32).filter(|number| self.fill(*number) > 0) {
            let (fill, depth) = (self.fill(number), self.depth(number));
            let _infallible =
                writeln!(text, "{}: {fill} of {depth} in use", self.layout.objects[usize::from(number)].name);
        }
        if self.fifos.rings[0].count > 0 {
            let _infallible = writeln!(text, "tef: {} of {} in use", self.fifos.rings[0].count, self.layout.tef.count);
        }
        for filter in 0..32 {
            if let Some(number) = self.filter_target(filter) {
                let _infallible = writeln!(text, "filter {filter}: to FIFO {number}");
            }
        }
        if let Some(sending) = self.tx.sending {
            let _infallible = writeln!(text, "on the bus: FIFO {}, {}", sending.source, sending.frame);
        }
        if let Some(placed) = self.tx.placed {
            let _infallible = writeln!(text, "next: FIFO {}, {}", placed.source, placed.frame);
        }
        text
    }
}
