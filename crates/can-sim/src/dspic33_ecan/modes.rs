//! Operating modes and how they are reached (7.0, Register 4-23).

use can_wire::{ErrorState, Field, Mode};
use dspic33_ecan_pac::{enums::OperationMode, registers as pac};

use super::EcanModel;
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

/// Where the module is between its modes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Modes {
    /// OPMODE.
    pub(super) now: OperationMode,
    /// A mode that is requested and not reached.
    pub(super) target: Option<OperationMode>,
}

impl Default for Modes {
    fn default() -> Self {
        Self { now: OperationMode::Configuration, target: None }
    }
}

/// Modes without traffic: the module neither sees nor drives the bus (7.1, 7.6, `configuration_on_bus`).
pub(super) const fn is_off(mode: OperationMode) -> bool {
    matches!(mode, OperationMode::Configuration | OperationMode::Disable)
}

/// Modes in which the module sends (7.2, 7.4, 7.5).
pub(super) const fn sends(mode: OperationMode) -> bool {
    matches!(mode, OperationMode::Normal | OperationMode::Loopback | OperationMode::ListenAll)
}

impl EcanModel {
    /// The mode of the node on the bus.
    pub(super) const fn wire_mode(&self, mode: OperationMode) -> Mode {
        match mode {
            OperationMode::Configuration | OperationMode::Disable => Mode::Off,
            OperationMode::Normal | OperationMode::ListenAll => Mode::Normal,
            OperationMode::ListenOnly => Mode::ListenOnly,
            OperationMode::Loopback if self.config.choices.loopback_drives_pin => Mode::ExternalLoopback,
            OperationMode::Loopback => Mode::InternalLoopback,
        }
    }

    /// What is not stored as it is written to CxCTRL1.
    pub(super) fn write_ctrl1(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        // reserved_bit_11: the description has no such bit, so that it stays 0.
        const RESERVED: u32 = 1 << 11;
        if access.ones() & RESERVED != 0 {
            cx.report("Register 4-23", DiagnosticKind::ReservedBits { register: "CTRL1", bits: RESERVED });
        }
    }

    pub(super) fn ctrl1_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let (old, new) = (pac::Ctrl1::from_bits(access.old as u16), pac::Ctrl1::from_bits(access.new as u16));
        self.window.written(cx, old.win(), new.win());
        if old.reqop() != new.reqop() {
            match new.reqop() {
                Ok(mode) => self.request_mode(cx, mode),
                // reserved_mode_request: OPMODE stays.
                Err(code) => {
                    let value = u32::from(code);
                    cx.report(
                        "Register 4-23",
                        DiagnosticKind::ReservedValue { register: "CTRL1", field: "REQOP", value },
                    );
                    self.request_mode(cx, self.modes.now);
                }
            }
        }
        if new.abat() && !old.abat() {
            self.abort_all(cx);
        }
    }

    /// 7.0: software requests a mode; it is reached when the bus has been idle for 11 recessive bits.
    fn request_mode(&mut self, cx: &mut Context<'_>, wanted: OperationMode) {
        if wanted == self.modes.now {
            if self.modes.target.take().is_some() {
                self.stay(cx);
            }
            return;
        }
        if self.modes.now == OperationMode::Configuration && self.modes.target.is_none() {
            self.check_configuration(cx);
        }
        self.modes.target = Some(wanted);
        if !self.config.choices.requests_survive_mode_change {
            self.abort_every_request(cx);
        }
        // mode_change_with_pending_messages: no frame is started any more.
        self.scan(cx);
        if !self.clocks_stopped() {
            self.start_change(cx);
        }
    }

    /// A request is taken back before it was reached.
    fn stay(&mut self, cx: &mut Context<'_>) {
        let mode = self.wire_mode(self.modes.now);
        if !self.clocks_stopped() {
            if is_off(self.modes.now) {
                cx.wire.set_mode(cx.node, mode);
            } else {
                cx.wire.set_mode_at_idle(cx.node, mode);
            }
        }
        self.scan(cx);
    }

    /// Sets out for the requested mode. From a mode off the bus the node has to watch it first.
    pub(super) fn start_change(&mut self, cx: &mut Context<'_>) {
        let Some(wanted) = self.modes.target else { return };
        let mode = self.wire_mode(wanted);
        if is_off(self.modes.now) {
            if !self.go_on_bus(cx) {
                self.modes.target = None;
                return;
            }
            cx.wire.set_mode(cx.node, if mode == Mode::Off { Mode::ListenOnly } else { mode });
            if self.is_bus_off(cx) {
                self.start_recovery(cx);
            }
            return;
        }
        if self.is_bus_off(cx) {
            if !self.config.choices.automatic_bus_off_recovery {
                self.reach(cx);
            }
        } else if cx.wire.mode(cx.node) != mode {
            cx.wire.set_mode_at_idle(cx.node, mode);
        } else if cx.wire.position(cx.node).field == Field::Idle {
            self.reach(cx);
        }
    }

    pub(super) fn is_bus_off(&self, cx: &Context<'_>) -> bool {
        cx.wire.error_state(cx.node) == ErrorState::BusOff
    }

    /// 11.2, Figure 11-1.
    pub(super) fn start_recovery(&mut self, cx: &mut Context<'_>) {
        let started = cx.wire.start_recovery(cx.node);
        debug_assert!(started.is_ok(), "a node that is bus off and switched on can recover: {started:?}");
    }

    /// The node has seen 11 recessive bits after it was off.
    pub(super) fn integrated(&mut self, cx: &mut Context<'_>) {
        if is_off(self.modes.now) {
            self.reach(cx);
        }
    }

    /// The node has changed its mode with the bus idle.
    pub(super) fn node_mode_changed(&mut self, cx: &mut Context<'_>, mode: Mode) {
        if !is_off(self.modes.now) && self.modes.target.is_some_and(|wanted| self.wire_mode(wanted) == mode) {
            self.reach(cx);
        }
    }

    /// The bus is idle: modes that differ in nothing that the node knows of change here.
    pub(super) fn bus_idle(&mut self, cx: &mut Context<'_>) {
        let same = |wanted| self.wire_mode(wanted) == self.wire_mode(self.modes.now);
        if !is_off(self.modes.now) && self.modes.target.is_some_and(same) {
            self.reach(cx);
        }
    }

    /// 11 recessive bits during the recovery from bus off.
    pub(super) fn recovery_sequence(&mut self, cx: &mut Context<'_>) {
        self.reach(cx);
    }

    /// OPMODE takes the requested mode.
    fn reach(&mut self, cx: &mut Context<'_>) {
        let Some(mode) = self.modes.target.take() else { return };
        let before = core::mem::replace(&mut self.modes.now, mode);
        self.regs.set_field(self.n.opmode, u32::from(mode.bits()));
        let node = self.wire_mode(mode);
        if cx.wire.mode(cx.node) != node {
            cx.wire.set_mode(cx.node, node);
        }
        if before == OperationMode::Configuration {
            self.configuration_left();
        }
        // configuration_on_request.
        if mode == OperationMode::Configuration && self.config.choices.configuration_clears_counters {
            cx.wire.set_error_counters(cx.node, 0, 0);
        }
        if is_off(mode) {
            self.tx.sending = None;
            self.tx.placed = None;
        }
        self.scan(cx);
    }

    /// The operating mode, and one that is requested and not reached (7.0).
    #[must_use]
    pub const fn mode(&self) -> (OperationMode, Option<OperationMode>) {
        (self.modes.now, self.modes.target)
    }
}
