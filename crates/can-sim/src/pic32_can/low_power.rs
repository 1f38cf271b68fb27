//! Low-power modes and wake-up (34.14).

use can_wire::{Level, Mode};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{self as pac, Int},
};

use super::{Pic32CanModel, modes::node_mode};
use crate::{diagnostic::DiagnosticKind, model::Context};

/// What the device does (34.14).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum DeviceState {
    /// The CPU runs.
    #[default]
    Run,
    /// Idle mode: the CPU is stopped, the peripherals run unless they have SIDLE set.
    Idle,
    /// Sleep mode: the system clock is stopped.
    Sleep,
}

impl Pic32CanModel {
    /// 34.14.3: the device is in Sleep mode, or in Idle mode with SIDLE set.
    pub(super) fn is_sleeping(&self) -> bool {
        match self.modes.device {
            DeviceState::Run => false,
            DeviceState::Idle => self.con().sidle(),
            DeviceState::Sleep => true,
        }
    }

    /// Changes the state of the device (34.14). The module sleeps in Sleep mode, and in Idle mode with SIDLE set.
    pub fn set_device_state(&mut self, cx: &mut Context<'_>, state: DeviceState) {
        let before = self.is_sleeping();
        self.modes.device = state;
        let sleeping = self.is_sleeping();
        if before == sleeping {
            return;
        }
        self.timer_conditions_changed(cx);
        if !self.con().on() || self.modes.stopped {
            return;
        }
        if sleeping {
            if cx.wire.mode(cx.node) != Mode::Off {
                let what = format!("the device goes to sleep while the module is in {:?} mode", self.mode());
                cx.report("34.14.1, 34.14.2", DiagnosticKind::Contradiction { what });
                // CiTX is driven recessive.
                self.leave_bus(cx);
            }
            self.watch_for_activity(cx);
        } else {
            self.modes.wake_at = None;
            // 34.14.3: waking up does not change the mode.
            let mode = node_mode(self.mode());
            if mode != Mode::Off && self.go_on_bus(cx) {
                cx.wire.set_mode(cx.node, mode);
            }
            self.request_mode(cx);
        }
    }

    /// Has the wire report the next dominant edge.
    pub(super) fn watch_for_activity(&mut self, cx: &mut Context<'_>) {
        let mut config = *cx.wire.config(cx.node);
        config.wake_on_edge = true;
        let watching = cx.wire.configure(cx.node, config);
        debug_assert!(watching.is_ok(), "a node that is off can be configured: {watching:?}");
    }

    /// 34.14.3: bus activity. With WAKFIL only a pulse longer than the filter's counts.
    pub(super) fn activity(&mut self, cx: &mut Context<'_>) {
        if pac::Cfg::from_bits(self.regs.get(self.r.cfg)).wakfil() {
            self.modes.wake_at = Some(cx.now + self.config.wake_filter);
        } else {
            self.wake_up();
        }
    }

    fn wake_up(&mut self) {
        let disabled = self.mode() == OperationMode::Disable && self.config.choices.wake_in_disable;
        if self.is_sleeping() || disabled {
            self.raise(Int::WAKIF);
        }
    }

    /// WAKFIL: the time that a pulse has to last is over.
    pub(super) fn pulse_lasted(&mut self, cx: &mut Context<'_>) {
        if self.modes.wake_at.is_some_and(|at| at <= cx.now) {
            self.modes.wake_at = None;
            if cx.wire.rx_level(cx.node) == Level::Dominant {
                self.wake_up();
            } else {
                self.watch_for_activity(cx);
            }
        }
    }

    /// The state of the device.
    #[must_use]
    pub const fn device_state(&self) -> DeviceState {
        self.modes.device
    }
}
