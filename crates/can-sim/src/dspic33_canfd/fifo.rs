//! FIFO 1 to 31: heads, tails, flags and user addresses (10.0), UINC and FRESET.

use dspic33_canfd_pac::{enums::FifoConLTxen, registers as pac};

use super::{Dspic33CanfdModel, names::Owner, queue::Queue};
use crate::{
    diagnostic::DiagnosticKind,
    model::Context,
    registers::{Slot, WriteAccess},
};

/// A FIFO's place in its objects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Ring {
    /// The tail: sent or read next.
    pub(super) tail: u8,
    /// Objects in use.
    pub(super) count: u8,
}

impl Ring {
    /// The head: filled next.
    pub(super) const fn head(self, depth: u32) -> u32 {
        (self.tail as u32 + self.count as u32) % if depth == 0 { 1 } else { depth }
    }

    pub(super) const fn is_full(self, depth: u32) -> bool {
        self.count as u32 >= depth
    }

    /// One more object in use. `uinc_beyond_limits`: without a check the head of a full FIFO runs past its tail.
    pub(super) const fn push(&mut self, depth: u32) {
        self.count = if self.is_full(depth) { 1 } else { self.count + 1 };
    }

    /// One object is done with. Without a check the tail of an empty FIFO runs past its head.
    pub(super) const fn pop(&mut self, depth: u32) {
        let depth = if depth == 0 { 1 } else { depth };
        self.tail = ((self.tail as u32 + 1) % depth) as u8;
        self.count = if self.count == 0 { depth as u8 - 1 } else { self.count - 1 };
    }
}

/// All FIFOs, the queue and the event FIFO.
#[derive(Clone, Debug, Default)]
pub(super) struct Fifos {
    /// Index 0 is the event FIFO.
    pub(super) rings: [Ring; 32],
    pub(super) queue: Queue,
    /// FIFOs with TXREQ, bit 0 the queue.
    pub(super) pending: u32,
    /// Those whose request is to be aborted.
    pub(super) aborting: u32,
}

const REQUESTS: u16 = pac::FifoConL::FRESET.union(pac::FifoConL::UINC).bits();

impl Dspic33CanfdModel {
    pub(super) fn fifo_control(&self, number: u8) -> pac::FifoConL {
        pac::FifoConL::from_bits(self.word(self.arrays.fifos[usize::from(number) - 1].con_l))
    }

    pub(super) fn fifo_size(&self, number: u8) -> pac::FifoConH {
        pac::FifoConH::from_bits(self.word(self.arrays.fifos[usize::from(number) - 1].con_h))
    }

    /// The queue, number 0, always transmits.
    #[inline]
    pub(super) fn is_transmit(&self, number: u8) -> bool {
        number == 0 || self.fifo_control(number).txen() == FifoConLTxen::Transmit
    }

    /// Control and status register of a FIFO, or of the queue for 0. Requests and flags stand in the same bits of both
    /// kinds.
    #[inline]
    pub(super) fn control_and_status(&self, number: u8) -> (Slot, Slot) {
        match number {
            0 => (self.r.txqcon_l, self.r.txqsta),
            _ => {
                let fifo = &self.arrays.fifos[usize::from(number) - 1];
                (fifo.con_l, fifo.sta)
            }
        }
    }

    pub(super) fn depth(&self, number: u8) -> u32 {
        self.layout.objects[usize::from(number)].count
    }

    /// Messages in a FIFO or the queue.
    pub(super) fn fill(&self, number: u8) -> u32 {
        match number {
            0 => self.fifos.queue.used.count_ones(),
            _ => u32::from(self.fifos.rings[usize::from(number)].count),
        }
    }

    /// What a write to FIFOCONnL or TXQCONL does not simply store.
    pub(super) fn write_control(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess, number: u8) {
        let request = u32::from(pac::FifoConL::TXREQ.bits());
        let (asked, had) = (access.new & request != 0, access.old & request != 0);
        if self.is_configuration() || !self.is_transmit(number) {
            // Register 3-32: TXREQ has no effect on a receive FIFO; in Configuration mode FIFOs are held in reset.
            access.new &= !request;
        } else if had && !asked {
            // 6.10: TXREQ stays set until the message is aborted or sent.
            access.new |= request;
            self.fifos.aborting |= 1 << number;
            let also = (access.old ^ access.new | access.ones() & u32::from(REQUESTS)) & !request;
            if also != 0 {
                let register = self.regs.name(access.slot);
                cx.report("6.4, 6.10", DiagnosticKind::RequestDropped { register, value: access.written });
            }
        } else if asked {
            self.fifos.aborting &= !(1 << number);
        }
    }

    pub(super) fn control_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess, number: u8) {
        let written = pac::FifoConL::from_bits(access.ones() as u16);
        self.clear_bits(access.slot, u32::from(pac::FifoConL::UINC.bits()));
        if self.is_configuration() {
            return self.combine(number);
        }
        if written.contains(pac::FifoConL::FRESET) {
            self.check_reset(cx, number);
            self.reset_fifo(cx, number);
        } else {
            if written.contains(pac::FifoConL::UINC) {
                self.increment(cx, number);
            }
            let asks = written.contains(pac::FifoConL::TXREQ) && self.is_transmit(number);
            if asks {
                self.request(cx, number);
            } else if self.fifos.aborting >> number & 1 == 1 {
                self.abort(cx, number);
            }
        }
        self.combine(number);
        self.scan(cx);
    }

    /// UINC.
    fn increment(&mut self, cx: &mut Context<'_>, number: u8) {
        let (depth, fill, transmit) = (self.depth(number), self.fill(number), self.is_transmit(number));
        let beyond = if transmit { fill >= depth } else { fill == 0 };
        if beyond {
            let (control, _) = self.control_and_status(number);
            let register = self.regs.name(control);
            cx.report("6.2, 9.1.1", DiagnosticKind::IncrementIgnored { register, fill, depth });
            if self.config.choices.uinc_is_checked {
                return;
            }
        }
        match (number, transmit) {
            (0, _) => self.queue_loaded(depth),
            (_, true) => self.fifos.rings[usize::from(number)].push(depth),
            (_, false) => self.fifos.rings[usize::from(number)].pop(depth),
        }
        self.show_fifo(number);
    }

    /// 6.14, 6.15, 9.3: a FIFO or the queue is empty again; its settings stay. The status register is reset by the
    /// description.
    pub(super) fn reset_fifo(&mut self, cx: &mut Context<'_>, number: u8) {
        self.end_request(number);
        self.withdraw(cx, number);
        match number {
            0 => self.fifos.queue = Queue::default(),
            _ => self.fifos.rings[usize::from(number)] = Ring::default(),
        }
        self.tx.accumulated[usize::from(number)] = 0;
        let (control, status) = self.control_and_status(number);
        self.regs.set(status, self.regs.reset_value(status));
        if !self.is_configuration() {
            self.clear_bits(control, u32::from(pac::FifoConL::FRESET.bits()));
            self.show_fifo(number);
        } else {
            self.combine(number);
        }
    }

    fn check_reset(&self, cx: &mut Context<'_>, number: u8) {
        let because = match self.is_transmit(number) {
            true if self.fifos.pending >> number & 1 == 1 => "a transmission is pending",
            false if self.is_filter_target(number) => "an enabled filter points to it",
            _ => return,
        };
        let register = self.regs.name(self.control_and_status(number).0);
        cx.report("6.14, 6.15, 9.3", DiagnosticKind::ResetInUse { register, because });
    }

    /// After Configuration mode: all flags and addresses.
    pub(super) fn show_all_fifos(&mut self) {
        for number in 0..32 {
            self.show_fifo(number);
        }
        self.show_events();
    }

    /// 10.1: flags, index and user address follow the fill level.
    pub(super) fn show_fifo(&mut self, number: u8) {
        if number == 0 {
            return self.show_queue();
        }
        let placed = self.layout.objects[usize::from(number)];
        let depth = placed.count;
        let ring = self.fifos.rings[usize::from(number)];
        let count = u32::from(ring.count);
        let (head, tail) = (ring.head(depth), u32::from(ring.tail));
        // transmit_half_flag: at most half full.
        let (index, user, edge, half, room) = match self.is_transmit(number) {
            true => (tail, head, count == 0, count * 2 <= depth, count < depth),
            false => (head, tail, count == depth, count * 2 >= depth, count > 0),
        };
        let fifo = self.arrays.fifos[usize::from(number) - 1];
        use pac::FifoSta as F;
        let flags = [(F::TFERFFIF, edge), (F::TFHRFHIF, half), (F::TFNRFNIF, room)];
        self.set_flags(fifo.sta, flags.map(|(flag, on)| (flag.bits(), on)));
        self.regs.set_field(fifo.index, index);
        self.show_address(fifo.ua_l, fifo.ua_h, placed.address(user));
        self.combine(number);
    }

    pub(super) fn show_address(&mut self, low: Slot, high: Slot, address: u32) {
        self.regs.set(low, address & 0xFFFF);
        self.regs.set(high, address >> 16);
    }

    /// Registers 3-38 to 3-43: user addresses mean nothing in Configuration mode.
    pub(super) fn watch_address_reads(&mut self, cx: &mut Context<'_>, slot: Slot) {
        let r = &self.r;
        let address = matches!(self.arrays.owner(slot), Owner::Address(_))
            || [r.tefua_l, r.tefua_h, r.txqua_l, r.txqua_h].contains(&slot);
        if address && self.is_configuration() {
            let (register, because) = (self.regs.name(slot), "the module is in Configuration mode");
            cx.report("Registers 3-38 to 3-43", DiagnosticKind::ReadUnreliable { register, because });
        }
    }
}
