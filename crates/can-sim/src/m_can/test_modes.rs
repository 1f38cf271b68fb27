//! Test modes (2.3.5, 3.1.9). Loop back is a mode of the node, see `modes`.

use can_wire::{Disturbance, Level};
use m_can_pac::{enums::TestTx, registers as pac};

use super::MCanModel;
use crate::model::Context;

impl MCanModel {
    /// 2.3.5: TEST.RX follows the pin, whether CCCR.TEST is set or not (`test_monitor_visibility`).
    pub(super) fn show_pin(&mut self, cx: &mut Context<'_>) {
        let level = cx.wire.rx_level(cx.node);
        self.regs.poke_field(self.f.test_rx, u32::from(level == Level::Recessive));
    }

    /// 2.3.5: TEST.TX takes the pin `m_can_tx` away from the core. The form of the sample point signal is not
    /// described; the pin stays recessive while it is selected.
    pub(super) fn follow_test_pin(&mut self, cx: &mut Context<'_>) {
        let tx = pac::Test::from_bits(self.regs.get(self.r.test)).tx();
        if core::mem::replace(&mut self.modes.test_tx, tx) == tx {
            return;
        }
        let held = match tx {
            TestTx::Core => None,
            TestTx::Dominant => Some(Disturbance::Dominant),
            TestTx::SamplePoint | TestTx::Recessive => Some(Disturbance::Recessive),
        };
        cx.wire.override_output(cx.node, held);
    }
}
