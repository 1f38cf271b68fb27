//! Reception: where messages go, and their buffers (34.8.4, 34.8.5, 34.9).

use can_frame::{Frame, Id};
use can_wire::{BusError, Role, Time};
use pic32_can_pac::{
    enums::{DataLength, FifoConDonly, FrameType, IdentifierType, OperationMode, RxBufferCmsgsidFilhit},
    messages::{RxBufferCmsgeid, RxBufferCmsgsid},
    registers::FifoInt,
};

use super::{
    Pic32CanModel,
    config::{OverflowFlag, RemoteFlag},
    memory::SystemError,
};
use crate::model::Context;

/// What reception knows besides the registers.
#[derive(Clone, Debug, Default)]
pub(super) struct Rx {
    /// A message is being received.
    pub(super) processing: bool,
    /// Filters that are switched off when it has been filtered (34.8.1).
    pub(super) disabling: u32,
    /// The system bus is taken by another initiator until then.
    pub(super) blocked_until: Time,
    /// A message that waits for the system bus.
    waiting: Option<Waiting>,
}

/// A message on its way to memory.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    fifo: u8,
    filter: u8,
    message: Message,
}

/// What is stored.
#[derive(Clone, Copy, Debug)]
pub(super) struct Message {
    pub(super) frame: Frame,
    /// Data bytes that were received: fewer than the length says for a message with an error.
    data_bytes: u8,
    timestamp: Option<u16>,
}

impl Rx {
    pub(super) fn begin(&mut self) {
        self.processing = true;
    }

    /// The node has gone off the bus.
    pub(super) fn forget(&mut self) {
        self.processing = false;
        self.waiting = None;
    }
}

impl Pic32CanModel {
    /// A message was received without error.
    pub(super) fn received(&mut self, cx: &mut Context<'_>, frame: &Frame) {
        let timestamp = self.capture(cx);
        let message = Message { frame: *frame, data_bytes: frame.len() as u8, timestamp };
        self.accept(cx, message);
        self.message_over();
    }

    /// The message at hand has been filtered, or is lost.
    pub(super) fn message_over(&mut self) {
        self.rx.processing = false;
        if self.rx.disabling != 0 {
            self.finish_disabling();
        }
    }

    /// 34.5.4: in Listen All Messages mode a message with an error is stored as far as it was received. Before its length
    /// has been received there is no message (message_with_error).
    pub(super) fn reception_failed(&mut self, cx: &mut Context<'_>, error: &BusError) {
        if error.role == Role::Receiver && error.position.field.is_in_frame() && self.mode() == OperationMode::ListenAll
        {
            let partial = cx.wire.partial_frame(cx.node);
            if let Some(frame) = partial.frame {
                let data_bytes = partial.data_bytes;
                let timestamp = self.con().cancap().then(|| self.count(cx.now));
                self.accept(cx, Message { frame, data_bytes, timestamp });
            }
        }
        self.message_over();
    }

    /// 34.8.5: the lowest matching filter whose FIFO has room takes the message.
    fn accept(&mut self, cx: &mut Context<'_>, message: Message) {
        if let Some(waiting) = self.rx.waiting {
            // 34.12.1.6: the one before has not been stored yet.
            self.overflow(waiting.fifo);
            return self.system_error(cx, SystemError::Bandwidth, 0);
        }
        let mut full: Option<(u8, u8)> = None;
        let mut passed = 0_u32;
        let mut taken = false;
        for filter in 0..self.config.fifos {
            let Some(fifo) = self.matches(filter, &message.frame) else { continue };
            // A device with fewer FIFOs has nothing there.
            if fifo >= self.config.fifos {
                continue;
            }
            if self.transmits(fifo) {
                if message.frame.is_remote() && self.fifo_con(fifo).rtren() {
                    self.show_filter_hit(filter);
                    self.remote_request(cx, fifo);
                    taken = true;
                    break;
                }
                if self.config.choices.search_passes_transmit_fifo {
                    continue;
                }
                // data_frame_to_transmit_fifo.
                taken = true;
                break;
            }
            if message.frame.is_remote() && self.config.choices.remote_frames_dropped {
                taken = true;
                break;
            }
            if self.fifos.state[usize::from(fifo)].count == self.depth(fifo) {
                full = full.or(Some((filter, fifo)));
                passed |= 1 << fifo;
                continue;
            }
            self.store_when_possible(cx, Waiting { fifo, filter, message });
            taken = true;
            break;
        }
        self.flag_overflows(full, passed, taken);
    }

    /// 34.12.1.7, overflow_flag_of_several_fifos.
    fn flag_overflows(&mut self, first: Option<(u8, u8)>, passed: u32, taken: bool) {
        let Some((filter, fifo)) = first else { return };
        match self.config.choices.overflow_flag {
            OverflowFlag::PassedOver => super::bits(passed).for_each(|fifo| self.overflow(fifo)),
            _ if taken => return,
            OverflowFlag::LowestFilter => self.overflow(fifo),
            OverflowFlag::AllFull => super::bits(passed).for_each(|fifo| self.overflow(fifo)),
        }
        if self.config.choices.filhit_shows_lost && !taken {
            self.show_filter_hit(filter);
        }
    }

    /// RXOVFLIF of a FIFO: the message is lost, the pointers stay.
    pub(super) fn overflow(&mut self, fifo: u8) {
        let slot = self.r.fifo_interrupt[usize::from(fifo)];
        let word = self.regs.get(slot);
        if FifoInt::from_bits(word).rxovflie() {
            self.interrupts.latched_overflows |= 1 << fifo;
        }
        self.regs.set(slot, word | FifoInt::RXOVFLIF.bits());
        self.collect(fifo);
    }

    fn show_filter_hit(&mut self, filter: u8) {
        self.regs.set_field(self.f.filhit, u32::from(filter));
    }

    fn store_when_possible(&mut self, cx: &mut Context<'_>, waiting: Waiting) {
        if cx.now < self.rx.blocked_until {
            self.rx.waiting = Some(waiting);
        } else {
            self.store(cx, waiting);
        }
    }

    pub(super) fn rx_timer(&self) -> Option<Time> {
        self.rx.waiting.map(|_| self.rx.blocked_until)
    }

    pub(super) fn rx_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.rx.blocked_until <= cx.now
            && let Some(waiting) = self.rx.waiting.take()
        {
            self.store(cx, waiting);
        }
    }

    /// 34.9: the message goes into the next buffer of the FIFO.
    fn store(&mut self, cx: &mut Context<'_>, Waiting { fifo, filter, message }: Waiting) {
        let index = self.fifos.state[usize::from(fifo)].module;
        let address = self.buffer(fifo, index);
        let data_only = self.fifo_con(fifo).donly() == FifoConDonly::DataOnly;
        let held =
            self.config.choices.unused_keeps_memory.then(|| self.fetch(cx, address, if data_only { 2 } else { 4 }));
        let held = held.flatten();
        let stored = if data_only {
            // 34.9.1: always eight bytes, the unused ones 0.
            self.deposit(cx, address, &message.data([0; 2]))
        } else {
            let before = held.map_or([0; 2], |held| [held[2], held[3]]);
            let kept_timestamp = held.map_or(0, |held| RxBufferCmsgsid::from_bits(held[0]).cmsgts());
            let [first, second] = self.header(&message, filter, kept_timestamp);
            let [third, fourth] = message.data(before);
            self.deposit(cx, address, &[first, second, third, fourth])
        };
        if !stored {
            return self.system_error(cx, SystemError::Address, address);
        }
        let depth = self.depth(fifo);
        let state = &mut self.fifos.state[usize::from(fifo)];
        state.module = (index + 1) % depth;
        state.count += 1;
        self.show_filter_hit(filter);
        self.show_fifo(fifo);
    }

    /// Table 34-5: CMSGSID and CMSGEID.
    fn header(&self, message: &Message, filter: u8, kept_timestamp: u16) -> [u32; 2] {
        let frame = &message.frame;
        let (sid, eid, ide) = match frame.id() {
            Id::Standard(id) => (id.as_raw(), 0, IdentifierType::Standard),
            Id::Extended(id) => ((id.as_raw() >> 18) as u16, id.as_raw() & 0x3_FFFF, IdentifierType::Extended),
        };
        let remote = frame.is_remote();
        let flag = self.config.choices.remote_flag;
        let extended = frame.is_extended();
        let srr = extended || (remote && flag != RemoteFlag::Rtr);
        let rtr = remote && (extended || flag != RemoteFlag::Srr);
        let first = RxBufferCmsgsid::ZERO
            .with_cmsgts(message.timestamp.unwrap_or(kept_timestamp))
            .with_filhit(RxBufferCmsgsidFilhit::from_bits(filter))
            .with_sid(sid);
        let second = RxBufferCmsgeid::ZERO
            .with_srr(srr)
            .with_ide(ide)
            .with_eid(eid)
            .with_rtr(if rtr { FrameType::RemoteFrame } else { FrameType::DataFrame })
            .with_dlc(DataLength::from_bits(frame.dlc().code()));
        [first.bits(), second.bits()]
    }
}

impl Message {
    /// The data words; bytes that were not received are those of `rest`.
    fn data(&self, rest: [u32; 2]) -> [u32; 2] {
        let mut bytes = [0; 8];
        bytes[..4].copy_from_slice(&rest[0].to_le_bytes());
        bytes[4..].copy_from_slice(&rest[1].to_le_bytes());
        let received = &self.frame.data_bytes()[..usize::from(self.data_bytes).min(self.frame.len())];
        bytes[..received.len()].copy_from_slice(received);
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        [word(0), word(4)]
    }
}
