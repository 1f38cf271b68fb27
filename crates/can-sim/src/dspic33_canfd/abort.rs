//! Aborting transmissions (6.10).

use can_wire::Abort;
use dspic33_canfd_pac::registers as pac;

use super::{Dspic33CanfdModel, tx::numbers};
use crate::model::Context;

impl Dspic33CanfdModel {
    /// TXREQ was cleared: the message is dropped, unless it is on the bus.
    pub(super) fn abort(&mut self, cx: &mut Context<'_>, number: u8) {
        self.fifos.aborting |= 1 << number;
        if self.is_on_bus(cx, number) {
            return;
        }
        self.withdraw(cx, number);
        self.aborted(number);
    }

    fn is_on_bus(&mut self, cx: &mut Context<'_>, number: u8) -> bool {
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.sending = self.tx.placed.take();
        }
        self.tx.sending.is_some_and(|sending| sending.source == number)
    }

    /// Takes a message that has not started back from the node.
    pub(super) fn withdraw(&mut self, cx: &mut Context<'_>, number: u8) {
        if self.tx.placed.is_some_and(|placed| placed.source == number) {
            let dropped = cx.wire.abort(cx.node);
            let placed = self.tx.placed.take();
            if matches!(dropped, Abort::OnTheBus(_)) {
                self.tx.sending = placed;
            }
        }
    }

    /// TXABT is set and the index stays where it is.
    pub(super) fn aborted(&mut self, number: u8) {
        let history = core::mem::take(&mut self.tx.accumulated[usize::from(number)]);
        self.set_history(number, history | pac::FifoSta::TXABT.bits());
        self.end_request(number);
        self.combine(number);
    }

    /// `abort_all_effect`, `abat_clear`: ABAT aborts every request and falls when none is left.
    pub(super) fn follow_abort_all(&mut self, cx: &mut Context<'_>) {
        if !self.con_h().abat() {
            return;
        }
        for number in numbers(self.fifos.pending) {
            self.abort(cx, number);
        }
        if self.fifos.pending == 0 {
            self.regs.set_field(self.f.abat, 0);
        }
    }
}
