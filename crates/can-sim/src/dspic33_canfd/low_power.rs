//! Sleep and Idle mode of the device, and wake-up by bus activity (4.6).

use can_wire::{Level, Mode, Time};
use dspic33_canfd_pac::{enums::OperationMode, registers as pac};

use super::Dspic33CanfdModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

/// What the device is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum DeviceMode {
    /// It runs.
    #[default]
    Run,
    /// Idle mode: the processor stands still, peripherals run unless they are told to stop.
    Idle,
    /// Sleep mode: no clock.
    Sleep,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LowPower {
    device: DeviceMode,
    /// The module stands still.
    stopped: bool,
    /// End of the wake-up filter's time.
    filter_end: Option<Time>,
}

impl LowPower {
    pub(super) const fn is_stopped(self) -> bool {
        self.stopped
    }
}

impl Dspic33CanfdModel {
    /// The device goes to Sleep or Idle mode, or runs again.
    pub fn set_device_mode(&mut self, cx: &mut Context<'_>, mode: DeviceMode) {
        let before = core::mem::replace(&mut self.low_power.device, mode);
        // 4.6.3: system Sleep after Disable mode, or Idle with SIDL.
        let stops = mode == DeviceMode::Sleep || mode == DeviceMode::Idle && self.con_l().sidl();
        if before == mode || stops == self.low_power.stopped {
            return;
        }
        if stops {
            let mode = self.operation_mode();
            if !matches!(mode, OperationMode::Disable | OperationMode::Configuration) {
                let what = format!("the device stops the module in mode {mode:?} instead of Disable mode");
                cx.report("4.6.1, 4.6.2", DiagnosticKind::Contradiction { what });
            }
            self.show_time(cx);
            self.stop_time();
            // 4.6.2: CxTX is recessive.
            self.stop_node(cx, true);
            self.low_power.stopped = true;
            self.watch_bus(cx);
        } else {
            self.low_power.filter_end = None;
            self.low_power.stopped = false;
            self.continue_time(cx);
            self.stop_node(cx, false);
        }
    }

    /// What the device is doing: bus activity ends Sleep and Idle mode.
    #[must_use]
    pub const fn device_mode(&self) -> DeviceMode {
        self.low_power.device
    }

    /// 4.6.3: the module watches CxRX while it sleeps.
    fn watch_bus(&mut self, cx: &mut Context<'_>) {
        let config = can_wire::NodeConfig { wake_on_edge: true, ..*cx.wire.config(cx.node) };
        let watching = cx.wire.configure(cx.node, config);
        debug_assert!(watching.is_ok() && self.modes.node == Mode::Off, "the node is off: {watching:?}");
    }

    /// A falling edge on CxRX.
    pub(super) fn bus_activity(&mut self, cx: &mut Context<'_>) {
        if !self.low_power.stopped {
            return;
        }
        let con = self.con_l();
        let length = self.config.wake_up_filter[usize::from(con.wft().bits())];
        // 5.2.3: with WAKFIL a low-pass filter keeps glitches from waking the module.
        if con.wakfil() && length > Time::ZERO {
            self.low_power.filter_end = Some(cx.now + length);
        } else {
            self.wake_up(cx);
        }
    }

    pub(super) const fn wake_up_timer(&self) -> Option<Time> {
        self.low_power.filter_end
    }

    pub(super) fn wake_up_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.low_power.filter_end.is_none_or(|at| at > cx.now) {
            return;
        }
        self.low_power.filter_end = None;
        if cx.wire.rx_level(cx.node) == Level::Dominant {
            self.wake_up(cx);
        } else {
            self.watch_bus(cx);
        }
    }

    /// 4.6.3, 12.3.2: WAKIF is set; with WAKIE the device runs again. OPMOD is what it was (4.6.1).
    fn wake_up(&mut self, cx: &mut Context<'_>) {
        self.raise(pac::IntL::WAKIF);
        if pac::IntH::from_bits(self.word(self.r.int_h)).wakie() {
            self.set_device_mode(cx, DeviceMode::Run);
        }
    }
}
