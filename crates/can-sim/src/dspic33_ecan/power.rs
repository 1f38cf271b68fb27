//! Sleep, Idle and wake-up of the device (13.0).

use can_wire::{NodeConfig, Time};
use dspic33_ecan_pac::registers::{self as pac, Intf};

use super::{EcanModel, modes::is_off};
use crate::{diagnostic::DiagnosticKind, model::Context};

/// What the CPU's PWRSAV instruction has done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Power {
    /// Clocks run.
    #[default]
    Running,
    /// PWRSAV 1: all clocks stopped (13.1).
    Sleep,
    /// PWRSAV 0: the CPU is in Idle mode; the module goes on unless CSIDL stops it (13.2).
    Idle,
}

/// A wake-up on its way.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct WakeUp {
    /// 13.3: the bus has become dominant; the filter looks at it again at this time.
    filter: Option<Time>,
    /// The CPU runs again at this time.
    start: Option<Time>,
}

impl EcanModel {
    /// The CPU executes PWRSAV 1 (13.1).
    pub fn sleep(&mut self, cx: &mut Context<'_>) {
        self.power = Power::Sleep;
        self.stop_clocks(cx, true, "the device goes to Sleep");
    }

    /// The CPU executes PWRSAV 0 (13.2).
    pub fn idle(&mut self, cx: &mut Context<'_>) {
        self.power = Power::Idle;
        if pac::Ctrl1::from_bits(self.regs.get(self.n.ctrl1) as u16).csidl() {
            self.stop_clocks(cx, false, "the CPU goes to Idle with CSIDL 1");
        }
    }

    /// The CPU runs again, by whatever interrupt or reset.
    pub fn run(&mut self, cx: &mut Context<'_>) {
        let stopped = self.clocks_stopped();
        self.power = Power::Running;
        self.wake_up = WakeUp::default();
        if !stopped {
            return;
        }
        self.set_wake_on_edge(cx, false);
        if !is_off(self.modes.now) {
            cx.wire.set_mode(cx.node, self.wire_mode(self.modes.now));
            if self.is_bus_off(cx) {
                self.start_recovery(cx);
            }
        }
        self.start_change(cx);
        self.scan(cx);
    }

    /// What the CPU is doing.
    #[must_use]
    pub const fn power(&self) -> Power {
        self.power
    }

    pub(super) fn clocks_stopped(&self) -> bool {
        match self.power {
            Power::Running => false,
            Power::Sleep => true,
            Power::Idle => pac::Ctrl1::from_bits(self.regs.get(self.n.ctrl1) as u16).csidl(),
        }
    }

    /// sleep_while_active: the frame on the bus breaks off, CxTX becomes recessive, OPMODE stays.
    fn stop_clocks(&mut self, cx: &mut Context<'_>, wakes: bool, when: &str) {
        if !is_off(self.modes.now) {
            let what = format!("{when} while the module is in mode {:?}", self.modes.now);
            let section = if wakes { "13.1" } else { "13.2" };
            cx.report(section, DiagnosticKind::Contradiction { what });
        }
        cx.wire.set_mode(cx.node, can_wire::Mode::Off);
        self.set_wake_on_edge(cx, wakes);
        self.tx.sending = None;
        self.tx.placed = None;
        self.dma.transmit.job = None;
    }

    /// 13.3: the receive line is watched only while the device sleeps (`disable_mode_wake_up`).
    fn set_wake_on_edge(&mut self, cx: &mut Context<'_>, wake_on_edge: bool) {
        let config = NodeConfig { wake_on_edge, ..*cx.wire.config(cx.node) };
        let set = cx.wire.configure(cx.node, config);
        debug_assert!(set.is_ok(), "the node is off and its other settings are as they were: {set:?}");
    }

    /// A dominant edge while the device sleeps.
    pub(super) fn edge_in_sleep(&mut self, cx: &mut Context<'_>) {
        if self.power != Power::Sleep {
            return;
        }
        if pac::Cfg2::from_bits(self.regs.get(self.n.cfg2) as u16).wakfil() {
            self.wake_up.filter = Some(cx.now + self.config.wake_up_filter);
            // The next edge counts anew: this one may be a glitch.
            self.set_wake_on_edge(cx, true);
        } else {
            self.activity_in_sleep(cx);
        }
    }

    /// 13.3: bus activity sets WAKIF, and with WAKIE wakes the CPU. The module stays in its mode.
    fn activity_in_sleep(&mut self, cx: &mut Context<'_>) {
        self.raise(Intf::WAKIF);
        if pac::Inte::from_bits(self.regs.get(self.n.inte) as u16).wakie() {
            if self.config.start_up == Time::ZERO {
                self.run(cx);
            } else {
                self.wake_up.start.get_or_insert(cx.now + self.config.start_up);
            }
        }
    }

    pub(super) fn power_timer(&self) -> Option<Time> {
        [self.wake_up.filter, self.wake_up.start].into_iter().flatten().min()
    }

    pub(super) fn power_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.wake_up.filter.is_some_and(|at| at <= cx.now) {
            self.wake_up.filter = None;
            if cx.wire.rx_level(cx.node).is_dominant() {
                self.activity_in_sleep(cx);
            }
        }
        if self.wake_up.start.is_some_and(|at| at <= cx.now) {
            self.run(cx);
        }
    }
}
