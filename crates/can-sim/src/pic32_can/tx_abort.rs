//! Aborting transmissions (34.7.4, ABAT of Register 34-1).

use pic32_can_pac::registers::FifoCon;

use super::{Pic32CanModel, bits};
use crate::model::Context;

impl Pic32CanModel {
    /// TXREQ was written 0: at once if the message is not on the bus, at its end otherwise.
    pub(super) fn abort(&mut self, cx: &mut Context<'_>, fifo: u8) {
        self.begun(cx);
        if self.is_sending(fifo) {
            self.tx.aborting |= 1 << fifo;
            return;
        }
        if self.tx.requested >> fifo & 1 == 1 {
            self.aborted(fifo);
        }
        self.schedule(cx);
    }

    /// The pointers stay, so that CiFIFOCIn tells what was sent.
    pub(super) fn aborted(&mut self, fifo: u8) {
        self.set_control(fifo, FifoCon::TXABAT);
        self.request_done(fifo);
    }

    /// Register 34-1: ABAT aborts the transmissions of all FIFOs, and is cleared when that is done.
    pub(super) fn abort_all(&mut self, cx: &mut Context<'_>) {
        self.tx.aborting = self.tx.requested;
        for fifo in bits(self.tx.requested) {
            self.abort(cx, fifo);
        }
        if self.tx.aborting == 0 {
            self.regs.set_field(self.f.abat, 0);
        }
    }
}
