//! Debug messages (3.4.4).

use m_can_pac::enums::RxBufferUse;

use super::MCanModel;
use crate::model::Context;

/// RXF1S.DMS: idle, A received, A and B received, all received and the DMA requested.
const IDLE: u32 = 0;
const A: u32 = 1;
const A_B: u32 = 2;
const A_B_C: u32 = 3;

impl MCanModel {
    /// What the state machine of Figure 10 does with a message; `None` if the message is not stored. The figure's labels
    /// name the transitions.
    fn debug_transition(&self, message: RxBufferUse) -> (u32, bool) {
        let state = self.regs.field(self.f.dms);
        match (state, message) {
            // T8: rejected while the DMA request is set.
            (A_B_C, _) => (A_B_C, false),
            // T1, T2.
            (IDLE | A, RxBufferUse::DebugA) => (A, true),
            // T4.
            (A, RxBufferUse::DebugB) => (A_B, true),
            // T6.
            (A_B, RxBufferUse::DebugC) => (A_B_C, true),
            // T5, debug_state_transition_t5.
            (A_B, RxBufferUse::DebugA) if self.config.choices.debug_a_restarts => (A, true),
            // T3, T5, and B or C in idle, debug_message_out_of_order: the process is restarted.
            _ => (IDLE, false),
        }
    }

    /// Whether a message for a debug buffer is stored; one for a dedicated Rx Buffer always is.
    pub(super) fn takes_debug_message(&self, message: RxBufferUse) -> bool {
        message == RxBufferUse::RxBuffer || self.debug_transition(message).1
    }

    /// 3.4.4.1: neither New Data flag nor IR.DRX are set.
    pub(super) fn debug_message(&mut self, message: RxBufferUse) {
        let (state, _) = self.debug_transition(message);
        self.regs.set_field(self.f.dms, state);
    }

    /// Output `m_can_dma_req` (3.4.4).
    #[must_use]
    pub fn dma_request(&self) -> bool {
        self.regs.field(self.f.dms) == A_B_C
    }

    /// Input `m_can_dma_ack`: the DMA has read the three messages (3.4.4, T7).
    pub fn acknowledge_dma(&mut self, _cx: &mut Context<'_>) {
        if self.dma_request() {
            self.regs.set_field(self.f.dms, IDLE);
        }
    }
}
