//! Looking into the module: what a FIFO holds, and the whole state in words.

use core::fmt::Write;

use can_frame::Frame;
use can_wire::Time;
use pic32_can_pac::{
    enums::{FifoConDonly, FrameType, IdentifierType},
    messages::{RxBufferCmsgeid, RxBufferCmsgsid, TxBufferCmsgeid, TxBufferCmsgsid},
};

use super::{Pic32CanModel, memory::WORDS, tx_message::decode};
use crate::{memory::Memory, trace::RegisterTouched};

/// A message in a FIFO, decoded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Element {
    /// A transmit message, or a full received one.
    Message {
        /// Physical address of its buffer.
        address: u32,
        /// The message.
        frame: Frame,
        /// The filter that accepted it, for a received message.
        filter: Option<u8>,
        /// CMSGTS of a received message.
        timestamp: Option<u16>,
    },
    /// A data-only received message: identifier and length are not kept (34.9.1).
    Data {
        /// Physical address of its buffer.
        address: u32,
        /// Its eight bytes.
        data: [u8; 8],
    },
}

impl Pic32CanModel {
    /// What a FIFO holds, oldest first. `memory` is the system RAM.
    #[must_use]
    pub fn fifo(&self, memory: &Memory, fifo: u8) -> Vec<Element> {
        let state = self.fifos.state[usize::from(fifo)];
        let oldest = if self.transmits(fifo) { state.module } else { state.user };
        let depth = self.depth(fifo);
        (0..state.count).map(|n| self.element(memory, fifo, (oldest + n) % depth)).collect()
    }

    fn element(&self, memory: &Memory, fifo: u8, index: u8) -> Element {
        let address = self.buffer(fifo, index);
        let first = (address.wrapping_sub(self.config.memory_base) / 4) as usize;
        let words: [u32; WORDS] = core::array::from_fn(|n| memory.word(first + n).unwrap_or(0));
        if self.transmits(fifo) {
            return Element::Message { address, frame: decode(words), filter: None, timestamp: None };
        }
        if self.fifo_con(fifo).donly() == FifoConDonly::DataOnly {
            let [a, b, ..] = words.map(u32::to_le_bytes);
            return Element::Data { address, data: [a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]] };
        }
        let (sid, eid) = (RxBufferCmsgsid::from_bits(words[0]), RxBufferCmsgeid::from_bits(words[1]));
        // A standard remote frame is marked in RTR, SRR or both.
        let standard = eid.ide() == IdentifierType::Standard;
        let remote = eid.rtr() == FrameType::RemoteFrame || (standard && eid.srr());
        let kind = if remote { FrameType::RemoteFrame } else { FrameType::DataFrame };
        let plain = [
            TxBufferCmsgsid::ZERO.with_sid(sid.sid()).bits(),
            TxBufferCmsgeid::from_bits(words[1]).with_rtr(kind).bits(),
            words[2],
            words[3],
        ];
        Element::Message {
            address,
            frame: decode(plain),
            filter: Some(sid.filhit().bits()),
            timestamp: Some(sid.cmsgts()),
        }
    }

    /// Physical address and bytes of each FIFO, as the registers place them.
    #[must_use]
    pub fn layout(&self) -> Vec<(u32, u32)> {
        let place = |fifo| (self.buffer(fifo, 0), u32::from(self.depth(fifo)) * self.buffer_bytes(fifo));
        (0..self.config.fifos).map(place).collect()
    }

    /// Every register that differs from its reset value, decoded, then what no register tells.
    pub(super) fn dump(&self, now: Time) -> String {
        let mut text = format!("{} at {now}, {:?} mode", self.regs.meta().title, self.mode());
        for (holds, what) in [
            (!self.con().on(), "off"),
            (self.modes.stopped, "stopped by a system error"),
            (self.is_sleeping(), "sleeping"),
            (self.errors.is_bus_off(), "bus off"),
        ] {
            if holds {
                let _infallible = write!(text, ", {what}");
            }
        }
        text.push('\n');
        for slot in self.regs.slots() {
            let value = self.regs.get(slot);
            if value != self.regs.reset_value(slot) {
                let (name, fields) = (self.regs.name(slot), self.regs.info(slot).fields);
                let _infallible = writeln!(text, "{value:#010x} {:?}", RegisterTouched { name, fields, value });
            }
        }
        for fifo in 0..self.config.fifos {
            let state = self.fifos.state[usize::from(fifo)];
            if state.count == 0 && !self.transmits(fifo) && self.filters_pointing_to(fifo) == 0 {
                continue;
            }
            let kind = if self.transmits(fifo) { "transmit" } else { "receive" };
            let (start, depth) = (self.buffer(fifo, 0), self.depth(fifo));
            let _infallible = writeln!(
                text,
                "FIFO {fifo}: {kind}, {} of {depth} messages, from {start:#x}, software at {}, module at {}",
                state.count, state.user, state.module
            );
        }
        if let Some((fifo, frame)) = self.sending() {
            let _infallible = writeln!(text, "next or on the bus: FIFO {fifo}, {frame}");
        }
        text
    }
}
