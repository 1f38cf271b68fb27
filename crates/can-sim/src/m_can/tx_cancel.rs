//! Transmit cancellation (2.3.40, 2.3.42, 3.5.7).

use super::{MCanModel, tx::bits};
use crate::model::Context;

impl MCanModel {
    /// Cancels requests: at once if the transmission has not started, at its end otherwise.
    pub(super) fn cancel_requests(&mut self, cx: &mut Context<'_>, buffers: u32) {
        if self.cccr().cce() {
            return;
        }
        if self.tx.placed.is_some() && cx.wire.requested(cx.node).is_none() {
            self.tx.sending = self.tx.placed.take();
        }
        let started = self.tx.sending.map_or(0, |sending| 1 << sending.buffer);
        for buffer in bits(buffers & !(started & self.pending())) {
            // 2.3.42: without a pending request it is finished at once.
            self.request_done(cx, 1 << buffer, true);
        }
        self.scan(cx);
    }
}
