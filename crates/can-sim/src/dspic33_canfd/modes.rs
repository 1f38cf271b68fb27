//! Modes of operation and how they change (4.0 to 4.5).

use can_wire::{ErrorState, Mode, Time};
use dspic33_canfd_pac::{
    enums::{ConHSerrlom, OperationMode},
    registers as pac,
};

use super::Dspic33CanfdModel;
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

/// What the modes depend on besides CONL and CONH.
#[derive(Clone, Debug, Default)]
pub(super) struct Modes {
    /// What the node on the bus has been told.
    pub(super) node: Mode,
    /// A mode that is on its way.
    pending: Option<OperationMode>,
    /// When the module acts on it.
    act_at: Option<Time>,
    /// The node integrates to the bus for the pending mode.
    integrating: bool,
}

/// The main groups of modes (4.0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Group {
    Configuration,
    Normal,
    Sleep,
    Debug,
}

const fn group(mode: OperationMode) -> Group {
    match mode {
        OperationMode::Configuration => Group::Configuration,
        OperationMode::NormalCanFd | OperationMode::NormalCan2_0 => Group::Normal,
        OperationMode::Disable => Group::Sleep,
        OperationMode::ListenOnly
        | OperationMode::RestrictedOperation
        | OperationMode::InternalLoopback
        | OperationMode::ExternalLoopback => Group::Debug,
    }
}

/// The mode of the node on the bus.
const fn node_mode(mode: OperationMode) -> Mode {
    match mode {
        OperationMode::Configuration | OperationMode::Disable => Mode::Off,
        OperationMode::NormalCanFd | OperationMode::NormalCan2_0 => Mode::Normal,
        OperationMode::ListenOnly => Mode::ListenOnly,
        OperationMode::RestrictedOperation => Mode::Restricted,
        OperationMode::InternalLoopback => Mode::InternalLoopback,
        OperationMode::ExternalLoopback => Mode::ExternalLoopback,
    }
}

impl Dspic33CanfdModel {
    /// The mode that OPMOD shows.
    #[must_use]
    pub fn operation_mode(&self) -> OperationMode {
        self.con_h().opmod()
    }

    pub(super) fn is_configuration(&self) -> bool {
        self.operation_mode() == OperationMode::Configuration
    }

    /// True while the node sends frames.
    pub(super) const fn sends(&self) -> bool {
        matches!(self.modes.node, Mode::Normal | Mode::InternalLoopback | Mode::ExternalLoopback)
    }

    /// `module_disabled`: with CON = 0 the module stays off the bus and changes no mode.
    pub(super) fn enable_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let con = pac::ConL::CON.bits();
        let (before, now) = (access.old as u16 & con != 0, access.new as u16 & con != 0);
        if before && !now {
            self.cancel_pending(cx);
            self.switch_node(cx, Mode::Off);
        } else if !before && now {
            let mode = self.operation_mode();
            if node_mode(mode) != Mode::Off {
                self.go_on_bus(cx, mode);
            }
            self.request_mode(cx, true);
        }
    }

    pub(super) fn mode_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let reqop = |word: u32| pac::ConH::from_bits(word as u16).reqop();
        self.request_mode(cx, reqop(access.old) != reqop(access.new));
    }

    /// 4.1: REQOP asks for a mode. `new` is false if it only says again what it said before.
    fn request_mode(&mut self, cx: &mut Context<'_>, new: bool) {
        let (from, to) = (self.operation_mode(), self.con_h().reqop());
        if !self.con_l().con() || self.low_power.is_stopped() || self.modes.pending == Some(to) {
            return;
        }
        if from == to {
            return self.cancel_pending(cx);
        }
        if self.is_illegal(from, to) {
            if new {
                let (from, to) = (format!("{from:?}"), format!("{to:?}"));
                cx.report("4.1.1, 4.1.2", DiagnosticKind::IllegalModeChange { from, to });
            }
            return;
        }
        // A later request replaces a pending one.
        self.cancel_pending(cx);
        self.modes.pending = Some(to);
        if self.modes.node == Mode::Off {
            let ps = u64::from(self.config.choices.mode_delay) * 1_000_000_000_000;
            self.modes.act_at = Some(cx.now + Time::from_ps(ps / u64::from(self.config.place.clock_hz.max(1))));
        } else {
            // 4.1.3, 4.2, 4.4: not during a transmission or reception.
            cx.wire.set_mode_at_idle(cx.node, Mode::Off);
        }
    }

    /// `illegal_mode_request`.
    fn is_illegal(&self, from: OperationMode, to: OperationMode) -> bool {
        match (group(from), group(to)) {
            (Group::Normal, Group::Normal) | (Group::Debug, Group::Debug) => true,
            (Group::Normal, Group::Debug) | (Group::Debug, Group::Normal) => !self.config.choices.normal_to_debug,
            _ => false,
        }
    }

    fn cancel_pending(&mut self, cx: &mut Context<'_>) {
        if self.modes.pending.take().is_none() {
            return;
        }
        self.modes.act_at = None;
        if core::mem::take(&mut self.modes.integrating) {
            self.switch_node(cx, Mode::Off);
        } else if self.modes.node != Mode::Off {
            cx.wire.set_mode_at_idle(cx.node, self.modes.node);
        }
    }

    pub(super) fn mode_timer(&self) -> Option<Time> {
        self.modes.act_at
    }

    pub(super) fn mode_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.modes.act_at.is_some_and(|at| at <= cx.now) {
            self.modes.act_at = None;
            self.act_on_request(cx);
        }
    }

    /// The node is off the bus and a mode is pending.
    fn act_on_request(&mut self, cx: &mut Context<'_>) {
        let Some(to) = self.modes.pending else { return };
        if node_mode(to) == Mode::Off {
            self.modes.pending = None;
            return self.change_mode(cx, to);
        }
        if !self.go_on_bus(cx, to) {
            self.modes.pending = None;
            return;
        }
        let recovering = cx.wire.error_state(cx.node) == ErrorState::BusOff;
        if self.config.choices.mode_after_integration && !recovering {
            self.modes.integrating = true;
        } else {
            self.modes.pending = None;
            self.change_mode(cx, to);
        }
    }

    /// Takes the node to the bus with the bit timing of the registers; it integrates (4.1.5). Returns false if the
    /// registers describe no node.
    fn go_on_bus(&mut self, cx: &mut Context<'_>, mode: OperationMode) -> bool {
        if self.is_configuration() {
            // 4.2: the counters are reset on leaving Configuration mode, which also ends bus off.
            self.errors = super::errors::Errors::default();
            cx.wire.set_error_counters(cx.node, 0, 0);
        }
        if !self.configure_node(cx, mode) {
            return false;
        }
        self.switch_node(cx, node_mode(mode));
        if cx.wire.error_state(cx.node) == ErrorState::BusOff {
            self.start_recovery(cx);
        }
        true
    }

    fn switch_node(&mut self, cx: &mut Context<'_>, mode: Mode) {
        self.modes.node = mode;
        cx.wire.set_mode(cx.node, mode);
        if mode == Mode::Off {
            self.regs.set_field(self.f.busy, 0);
        }
        self.node_left(cx);
        self.scan(cx);
    }

    /// The node has seen eleven recessive bits.
    pub(super) fn integrated(&mut self, cx: &mut Context<'_>) {
        if core::mem::take(&mut self.modes.integrating)
            && let Some(mode) = self.modes.pending.take()
        {
            self.change_mode(cx, mode);
        }
    }

    /// The node has changed its mode at bus idle.
    pub(super) fn node_changed(&mut self, cx: &mut Context<'_>, mode: Mode) {
        if mode == Mode::Off && self.modes.node != Mode::Off {
            self.modes.node = Mode::Off;
            self.regs.set_field(self.f.busy, 0);
            self.node_left(cx);
            self.act_on_request(cx);
        }
    }

    /// OPMOD changes.
    fn change_mode(&mut self, cx: &mut Context<'_>, to: OperationMode) {
        let from = self.operation_mode();
        if from == OperationMode::Configuration {
            self.layout = self.compute_layout();
            self.check_configuration(cx);
        }
        // Leaving Configuration mode resets what 4.2 lists, by the description.
        self.regs.set_field(self.f.opmod, u32::from(to.bits()));
        // modif_cause: 12.3.4.
        self.raise(pac::IntL::MODIF);
        if to == OperationMode::Configuration {
            self.enter_configuration(cx);
        } else if from == OperationMode::Configuration {
            self.show_all_fifos();
        }
        self.scan(cx);
    }

    /// 4.2: in Configuration mode everything is reset; Register 3-45: TXBO, because the module is off the bus.
    fn enter_configuration(&mut self, cx: &mut Context<'_>) {
        self.regs.set_field(self.f.txbo, 1);
        for number in 0..32 {
            self.reset_fifo(cx, number);
        }
        self.reset_events();
        self.tx = super::tx::Tx::default();
        self.regs.set_field(self.f.abat, 0);
    }

    /// 12.3.6, `mode_after_system_error`: the module leaves a mode that sends for the one that SERRLOM selects.
    pub(super) fn fall_back(&mut self, cx: &mut Context<'_>) {
        if !self.sends() {
            return;
        }
        let to = match self.con_h().serrlom() {
            ConHSerrlom::RestrictedOperation => OperationMode::RestrictedOperation,
            ConHSerrlom::ListenOnly => OperationMode::ListenOnly,
        };
        self.modes.node = node_mode(to);
        cx.wire.set_mode(cx.node, self.modes.node);
        self.node_left(cx);
        self.change_mode(cx, to);
    }

    /// The device has stopped the module, or lets it run again (4.6).
    pub(super) fn stop_node(&mut self, cx: &mut Context<'_>, stopped: bool) {
        if stopped {
            self.cancel_pending(cx);
            self.switch_node(cx, Mode::Off);
        } else {
            let mode = self.operation_mode();
            if node_mode(mode) != Mode::Off && self.con_l().con() {
                self.go_on_bus(cx, mode);
            }
            self.request_mode(cx, true);
        }
    }

    /// When Configuration mode ends: what is written in the registers cannot all be meant.
    fn check_configuration(&mut self, cx: &mut Context<'_>) {
        self.check_bit_timing(cx);
        let layout = self.layout.clone();
        self.check_section(cx, layout.tef);
        for number in 0..32_u8 {
            if self.is_transmit(number) || self.is_filter_target(number) {
                self.check_section(cx, layout.objects[usize::from(number)]);
            }
        }
    }
}
