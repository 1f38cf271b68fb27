//! Aborting messages (8.2).

use super::{EcanModel, tx::TX_BUFFERS};
use crate::model::Context;

impl EcanModel {
    /// TXREQ of a buffer was cleared. The message is aborted unless its frame is on the bus and succeeds.
    pub(super) fn abort_buffer(&mut self, cx: &mut Context<'_>, buffer: u8) {
        self.settle(cx);
        if self.tx.sending.is_some_and(|sending| sending.buffer == buffer) {
            self.tx.aborting |= 1 << buffer;
        } else {
            self.abort_request(buffer);
        }
        self.finish_abort_all();
    }

    /// abort_outcome: the abort has taken effect.
    pub(super) fn abort_request(&mut self, buffer: u8) {
        self.tx.aborting &= !(1 << buffer);
        self.set_request(buffer, false);
        self.regs.set_field(self.n.tx[usize::from(buffer)].txabt, 1);
    }

    /// Register 4-23: ABAT was set.
    pub(super) fn abort_all(&mut self, cx: &mut Context<'_>) {
        self.abort_every_request(cx);
        self.finish_abort_all();
        self.scan(cx);
    }

    /// Every pending message is aborted; one on the bus when it fails.
    pub(super) fn abort_every_request(&mut self, cx: &mut Context<'_>) {
        self.settle(cx);
        let requests = self.requests();
        for buffer in (0..TX_BUFFERS).filter(|buffer| requests >> buffer & 1 == 1) {
            if self.tx.sending.is_some_and(|sending| sending.buffer == buffer) {
                self.tx.aborting |= 1 << buffer;
            } else {
                self.abort_request(buffer);
            }
        }
    }

    /// abat_completion: ABAT falls when no request is left.
    pub(super) fn finish_abort_all(&mut self) {
        if self.regs.is_set(self.n.abat) && self.requests() == 0 && self.tx.aborting == 0 {
            self.regs.set_field(self.n.abat, 0);
        }
    }
}
