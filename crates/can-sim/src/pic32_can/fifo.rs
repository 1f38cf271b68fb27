//! The message FIFOs: pointers, their reset, and the flags that follow their fill level (34.6, Registers 34-20 to 34-23).

use can_wire::Time;
use pic32_can_pac::{
    enums::FifoConTxen,
    registers::{self as pac, FifoCon, FifoInt},
};

use super::{Pic32CanModel, bits, config::UserAddress};
use crate::{
    diagnostic::DiagnosticKind,
    model::Context,
    registers::{ReadAccess, WriteAccess},
};

/// The pointers of a FIFO.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Fifo {
    /// The buffer that software uses next: head of a transmit FIFO, tail of a receive FIFO.
    pub(super) user: u8,
    /// The buffer that the module uses next.
    pub(super) module: u8,
    /// Messages between them.
    pub(super) count: u8,
}

/// All FIFOs.
#[derive(Clone, Debug, Default)]
pub(super) struct Fifos {
    pub(super) state: [Fifo; 32],
    /// Physical addresses.
    pub(super) start: [u32; 32],
    pub(super) end: u32,
    /// Per transmit FIFO the buffers that software has ever written.
    pub(super) written: [u32; 32],
    /// FIFOs with FRESET set, and when it is cleared.
    resetting: u32,
    reset_at: Option<Time>,
    /// What the last read of CiFIFOCONn destroyed.
    destroyed: Option<(u8, u32)>,
    reads: u8,
}

/// Host accesses within which a second read of a status that the first one destroyed counts as a mistake.
const READ_TWICE_WITHIN: u8 = 2;

const STATUS: FifoCon = FifoCon::TXLARB.union(FifoCon::TXERR);

impl Pic32CanModel {
    /// Resets the pointers and the state of every FIFO: off, or Configuration mode (34.6.4). The registers follow by the
    /// description.
    pub(super) fn reset_fifos(&mut self, cx: &mut Context<'_>) {
        self.fifos.resetting = 0;
        self.fifos.reset_at = None;
        for fifo in 0..32 {
            self.clear_control(fifo, FifoCon::FRESET);
            self.reset_fifo(cx, fifo);
        }
        self.regs.set_field(self.f.abat, 0);
    }

    fn reset_fifo(&mut self, cx: &mut Context<'_>, fifo: u8) {
        self.fifos.state[usize::from(fifo)] = Fifo::default();
        self.interrupts.latched_overflows &= !(1 << fifo);
        self.clear_interrupt(fifo, FifoInt::RXOVFLIF);
        self.clear_control(fifo, STATUS | FifoCon::TXABAT);
        self.tx_fifo_reset(cx, fifo);
        self.show_fifo(fifo);
    }

    pub(super) fn set_control(&mut self, fifo: u8, flags: FifoCon) {
        let slot = self.r.fifo_control[usize::from(fifo)];
        self.regs.set(slot, self.regs.get(slot) | flags.bits());
    }

    pub(super) fn clear_control(&mut self, fifo: u8, flags: FifoCon) {
        let slot = self.r.fifo_control[usize::from(fifo)];
        self.regs.set(slot, self.regs.get(slot) & !flags.bits());
    }

    fn clear_interrupt(&mut self, fifo: u8, flags: FifoInt) {
        let slot = self.r.fifo_interrupt[usize::from(fifo)];
        self.regs.set(slot, self.regs.get(slot) & !flags.bits());
    }

    /// What is not stored as it is written to CiFIFOCONn.
    pub(super) fn write_control(&mut self, cx: &mut Context<'_>, fifo: u8, access: &mut WriteAccess) {
        let (old, new) = (FifoCon::from_bits(access.old), FifoCon::from_bits(access.new));
        if new.txen() != old.txen() && !self.in_configuration() {
            if self.config.choices.txen_locked {
                access.new = access.new & !FifoCon::TXEN.bits() | access.old & FifoCon::TXEN.bits();
                self.ignored(cx, "34.5.1", access.slot, "TXEN", "TXEN is changed outside Configuration mode");
            } else {
                let what = format!("TXEN of FIFO {fifo} is changed outside Configuration mode");
                cx.report("34.5.1", DiagnosticKind::Contradiction { what });
            }
        }
        let new = FifoCon::from_bits(access.new);
        if old.txreq() && !new.txreq() {
            // Register 34-20: it stays 1 until the message is aborted or sent.
            access.new |= FifoCon::TXREQ.bits();
            self.tx.abort_wanted = true;
        } else if new.txreq() && !old.txreq() {
            self.refuse_request(cx, access);
        }
        if self.config.choices.alias_write_reads && access.alias.is_some() {
            access.new &= !STATUS.bits();
        }
    }

    /// Register 34-20: TXREQ has no effect on a receive FIFO, and 34.4 none on a module that is off.
    fn refuse_request(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        let because = match FifoCon::from_bits(access.new).txen() {
            FifoConTxen::Receive => "the FIFO is a receive FIFO",
            FifoConTxen::Transmit if !self.con().on() => "the module is off",
            FifoConTxen::Transmit => return,
        };
        access.new &= !FifoCon::TXREQ.bits();
        self.ignored(cx, "Register 34-20", access.slot, "TXREQ", because);
    }

    /// CiFIFOCONn has been written: layout, commands and requests, in this order.
    pub(super) fn control_written(&mut self, cx: &mut Context<'_>, fifo: u8, access: &WriteAccess) {
        if (access.old ^ access.new) & (LAYOUT_FIELDS | FifoCon::TXEN.bits()) != 0 {
            self.lay_out();
            // Pointers into buffers of another size or direction mean nothing.
            self.fifos.state[usize::from(fifo)] = Fifo::default();
            if FifoCon::from_bits(access.new).txen() == FifoConTxen::Receive {
                self.clear_control(fifo, FifoCon::TXREQ);
            }
            self.show_all_fifos();
        }
        let written = FifoCon::from_bits(access.new);
        if written.uinc() {
            self.clear_control(fifo, FifoCon::UINC);
            self.advance(cx, fifo);
        }
        if written.freset() && access.old & FifoCon::FRESET.bits() == 0 {
            self.begin_reset(cx, fifo);
        }
        self.requests_written(cx, fifo);
    }

    /// 34.6.4: FRESET. Software has to see to its preconditions.
    fn begin_reset(&mut self, cx: &mut Context<'_>, fifo: u8) {
        let pending = self.transmits(fifo) && self.fifo_con(fifo).txreq();
        if pending || (!self.transmits(fifo) && self.filters_pointing_to(fifo) != 0) {
            let why = if pending { "a transmission is pending" } else { "an enabled filter points to it" };
            let what = format!("FIFO {fifo} is reset although {why}");
            cx.report("34.6.4", DiagnosticKind::Contradiction { what });
        }
        self.reset_fifo(cx, fifo);
        self.fifos.resetting |= 1 << fifo;
        self.fifos.reset_at = Some(cx.now + self.clocks(self.config.choices.reset_clocks));
    }

    pub(super) const fn fifo_timer(&self) -> Option<Time> {
        self.fifos.reset_at
    }

    pub(super) fn fifo_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.fifos.reset_at.is_some_and(|at| at <= cx.now) {
            self.fifos.reset_at = None;
            for fifo in bits(core::mem::take(&mut self.fifos.resetting)) {
                self.clear_control(fifo, FifoCon::FRESET);
            }
        }
    }

    /// Register 34-20, 34.6.2, 34.6.3: UINC.
    fn advance(&mut self, cx: &mut Context<'_>, fifo: u8) {
        let slot = self.r.fifo_control[usize::from(fifo)];
        if !self.con().on() || self.modes.stopped {
            return self.ignored(cx, "34.4", slot, "UINC", "the module is off");
        }
        let (depth, transmits) = (self.depth(fifo), self.transmits(fifo));
        let state = self.fifos.state[usize::from(fifo)];
        let at_limit = if transmits { state.count == depth } else { state.count == 0 };
        if at_limit {
            let kind = DiagnosticKind::FifoLimit { fifo: u32::from(fifo), full: transmits };
            cx.report("34.6.2, 34.6.3", kind);
            if !self.config.choices.uinc_passes_limit {
                return;
            }
        }
        if transmits && self.fifos.written[usize::from(fifo)] >> state.user & 1 == 0 {
            let address = self.buffer(fifo, state.user);
            cx.report("34.6.2", DiagnosticKind::BufferNotWritten { fifo: u32::from(fifo), address });
        }
        let state = &mut self.fifos.state[usize::from(fifo)];
        state.user = (state.user + 1) % depth;
        if !at_limit {
            state.count = if transmits { state.count + 1 } else { state.count - 1 };
        }
        self.show_fifo(fifo);
    }

    pub(super) fn show_all_fifos(&mut self) {
        for fifo in 0..32 {
            self.show_fifo(fifo);
        }
    }

    /// CiFIFOUAn, CiFIFOCIn and the flags show the state of a FIFO.
    pub(super) fn show_fifo(&mut self, fifo: u8) {
        let n = usize::from(fifo);
        if fifo >= self.config.fifos {
            return;
        }
        let state = self.fifos.state[n];
        let hidden = self.in_configuration() && self.config.choices.user_address != UserAddress::Present;
        if !hidden {
            self.regs.set(self.r.fifo_user[n], self.buffer(fifo, state.user));
        }
        self.regs.set(self.r.fifo_index[n], u32::from(state.module));
        let (count, depth) = (state.count, self.depth(fifo));
        let flags = match (self.transmits(fifo), self.con().on()) {
            // half_of_odd_depth.
            (true, _) => [
                (FifoInt::TXNFULLIF, count < depth),
                (FifoInt::TXHALFIF, 2 * count <= depth),
                (FifoInt::TXEMPTYIF, count == 0),
            ],
            (false, on) => [
                (FifoInt::RXFULLIF, on && count == depth),
                (FifoInt::RXHALFIF, on && 2 * count >= depth && count > 0),
                (FifoInt::RXNEMPTYIF, on && count > 0),
            ],
        };
        let shown = flags.into_iter().filter(|(_, holds)| *holds).fold(0, |word, (flag, _)| word | flag.bits());
        let slot = self.r.fifo_interrupt[n];
        self.regs.set(slot, self.regs.get(slot) & !LEVELS.bits() | shown);
        self.collect(fifo);
    }

    /// `user_address_in_configuration`.
    pub(super) fn show_user_address(&mut self, fifo: u8) {
        if self.in_configuration() && self.config.choices.user_address == UserAddress::Zero {
            self.regs.set(self.r.fifo_user[usize::from(fifo)], 0);
        }
    }

    /// Register 34-22: the address is not valid in Configuration mode.
    pub(super) fn watch_user_address(&mut self, cx: &mut Context<'_>, access: &ReadAccess) {
        if self.in_configuration() && self.con().on() {
            let register = self.regs.name(access.slot);
            let because = "the user address is not valid in Configuration mode";
            cx.report("Register 34-22", DiagnosticKind::InvalidRead { register, because });
        }
    }

    /// Register 34-20: a read of CiFIFOCONn destroys TXLARB and TXERR; a driver that reads again at once has lost them.
    pub(super) fn watch_status_reads(&mut self, cx: &mut Context<'_>, fifo: Option<u8>, access: &ReadAccess) {
        self.fifos.reads = self.fifos.reads.saturating_add(1);
        let Some(fifo) = fifo else { return };
        if let Some((of, lost)) = self.fifos.destroyed.take()
            && of == fifo
            && self.fifos.reads <= READ_TWICE_WITHIN
            && access.value & STATUS.bits() == 0
        {
            let register = self.regs.name(access.slot);
            cx.report("Register 34-20", DiagnosticKind::StatusReadTwice { register, lost, seen: access.value });
        }
        if access.value & STATUS.bits() != 0 {
            self.fifos.destroyed = Some((fifo, access.value));
            self.fifos.reads = 0;
        }
    }
}

/// The fields of CiFIFOCONn, besides TXEN, that decide where buffers lie.
const LAYOUT_FIELDS: u32 =
    pac::FifoCon::ZERO.with_fsize(31).with_donly(pic32_can_pac::enums::FifoConDonly::DataOnly).bits();

/// The flags that follow the fill level.
const LEVELS: FifoInt = FifoInt::TXNFULLIF
    .union(FifoInt::TXHALFIF)
    .union(FifoInt::TXEMPTYIF)
    .union(FifoInt::RXFULLIF)
    .union(FifoInt::RXHALFIF)
    .union(FifoInt::RXNEMPTYIF);
