//! Switching the module on and off, operating modes (34.4, 34.5).

use can_wire::{ErrorState, Mode, Time};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{self as pac, Int},
};

use super::{Pic32CanModel, config::RegistersWhileOff, low_power::DeviceState};
use crate::{
    diagnostic::DiagnosticKind,
    model::Context,
    registers::{ReadAccess, WriteAccess},
};

/// What the modes depend on besides CiCON.
#[derive(Clone, Debug, Default)]
pub(super) struct Modes {
    /// Requested in REQOP and not yet shown in OPMOD.
    target: Option<OperationMode>,
    /// The node has to see 11 recessive bits before the target is reached.
    integrating: bool,
    /// The target differs from the present mode in the module only: it is reached between two messages.
    between_messages: bool,
    /// A fatal system error has stopped the module (34.12.1.4).
    pub(super) stopped: bool,
    /// When CANBUSY falls.
    off_at: Option<Time>,
    pub(super) device: DeviceState,
    /// A message is on the bus.
    pub(super) in_message: bool,
    /// WAKFIL: the pulse that may wake the module has begun, and is long enough at this time.
    pub(super) wake_at: Option<Time>,
    /// Reads of CiCON while a request cannot take effect.
    futile_reads: u8,
}

/// Reads of CiCON after which a driver is said to wait for a mode in vain.
const FUTILE_READS: u8 = 3;

/// The mode of the node that an operating mode needs.
pub(super) const fn node_mode(mode: OperationMode) -> Mode {
    match mode {
        OperationMode::Configuration | OperationMode::Disable => Mode::Off,
        OperationMode::Normal | OperationMode::ListenAll => Mode::Normal,
        OperationMode::Loopback => Mode::InternalLoopback,
        OperationMode::ListenOnly => Mode::ListenOnly,
    }
}

impl Pic32CanModel {
    pub(super) fn con(&self) -> pac::Con {
        pac::Con::from_bits(self.regs.get(self.r.con))
    }

    /// The operating mode; a reserved code that OPMOD has taken counts as Disable (reserved_mode_request).
    pub(super) fn mode(&self) -> OperationMode {
        self.con().opmod().unwrap_or(OperationMode::Disable)
    }

    pub(super) fn in_configuration(&self) -> bool {
        self.mode() == OperationMode::Configuration
    }

    /// On, not stopped by an error, not sleeping.
    pub(super) fn is_running(&self) -> bool {
        self.con().on() && !self.modes.stopped && !self.is_sleeping()
    }

    /// What is not stored as it is written to CiCON.
    pub(super) fn write_con(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        let on = pac::Con::ON.bits();
        let (old, new) = (pac::Con::from_bits(access.old), pac::Con::from_bits(access.new));
        if old.on() && !new.on() && !self.in_configuration() && !self.modes.stopped {
            let what = "ON is cleared outside Configuration mode, a message in progress is cut off".to_owned();
            cx.report("34.4", DiagnosticKind::Contradiction { what });
        }
        if new.reqop().is_err() && new.reqop() != old.reqop() {
            self.ignored(cx, "34.5, Register 34-1", access.slot, "REQOP", "the mode is reserved");
        }
        // Register 34-1: only hardware clears ABAT; a module that is off has nothing to abort.
        if access.new & on == 0 {
            access.new &= !pac::Con::ABAT.bits();
        }
        self.modes.futile_reads = 0;
    }

    pub(super) fn ignored(
        &self,
        cx: &mut Context<'_>,
        section: &'static str,
        slot: crate::registers::Slot,
        field: &'static str,
        because: &'static str,
    ) {
        let register = self.regs.name(slot);
        cx.report(section, DiagnosticKind::WriteIgnored { register, field, because });
    }

    /// CiCON has been written.
    pub(super) fn con_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let (old, new) = (pac::Con::from_bits(access.old), pac::Con::from_bits(access.new));
        if old.cancap() != new.cancap() {
            self.timer_conditions_changed(cx);
        }
        match (old.on(), new.on()) {
            (true, false) => return self.turn_off(cx),
            (false, true) => {
                self.modes.off_at = None;
                self.regs.set_field(self.f.canbusy, 1);
                self.timer_conditions_changed(cx);
                self.request_mode(cx);
            }
            (true, true) | (false, false) if old.reqop() != new.reqop() => self.request_mode(cx),
            _ => {}
        }
        if new.abat() {
            self.abort_all(cx);
        }
    }

    /// 34.4: the module is held in reset and all FIFOs are reset; OPMOD reads configuration (registers_while_off).
    fn turn_off(&mut self, cx: &mut Context<'_>) {
        self.leave_bus(cx);
        self.modes = Modes {
            device: self.modes.device,
            off_at: Some(cx.now + self.clocks(self.reset_clocks())),
            ..Modes::default()
        };
        self.stop_timer(cx);
        self.regs.set_field(self.f.opmod, u32::from(OperationMode::Configuration.bits()));
        self.reset_errors(cx, true);
        if self.config.choices.registers_while_off == RegistersWhileOff::Reset {
            let busy = self.regs.field(self.f.canbusy);
            self.regs.reset();
            self.regs.set_field(self.f.canbusy, busy);
            self.tx.requested = 0;
            self.lay_out();
        }
        self.reset_fifos(cx);
        self.clear_flags();
    }

    pub(super) fn leave_bus(&mut self, cx: &mut Context<'_>) {
        self.tx.forget();
        self.rx.forget();
        cx.wire.set_mode(cx.node, Mode::Off);
        self.modes.in_message = false;
    }

    /// 34.5: a mode is requested in REQOP; OPMOD follows in step with the bus.
    pub(super) fn request_mode(&mut self, cx: &mut Context<'_>) {
        let Ok(target) = self.con().reqop() else {
            if self.config.choices.reserved_mode_taken && self.con().on() {
                self.leave_bus(cx);
                let code = self.regs.field(self.f.reqop);
                self.regs.set_field(self.f.opmod, code);
                self.modes.target = None;
            }
            return;
        };
        if !self.con().on() {
            if self.config.choices.request_acts_while_off {
                self.regs.set_field(self.f.opmod, u32::from(target.bits()));
            }
            return;
        }
        if self.modes.stopped || self.is_sleeping() {
            return;
        }
        self.modes.target = Some(target);
        self.modes.between_messages = false;
        self.modes.integrating = false;
        let (present, wanted) = (cx.wire.mode(cx.node), node_mode(target));
        if present == wanted {
            if present == Mode::Off {
                return self.arrive(cx, target);
            }
            // An earlier request that has not been carried out is withdrawn.
            cx.wire.set_mode_at_idle(cx.node, wanted);
            self.modes.between_messages = self.modes.in_message;
            if !self.modes.in_message {
                self.arrive(cx, target);
            }
        } else if present == Mode::Off {
            self.join(cx, target);
        } else if target == OperationMode::Configuration && !self.config.choices.configuration_waits {
            self.leave_bus(cx);
        } else {
            // 34.5.6: a message in progress is finished first (configuration_entry_wait).
            cx.wire.set_mode_at_idle(cx.node, wanted);
        }
    }

    /// From off the bus onto it: OPMOD shows the mode once the node has seen 11 recessive bits (mode_entry).
    fn join(&mut self, cx: &mut Context<'_>, target: OperationMode) {
        if self.in_configuration() {
            self.check_layout(cx);
        }
        if !self.go_on_bus(cx) {
            self.modes.target = None;
            return;
        }
        let bus_off = cx.wire.error_state(cx.node) == ErrorState::BusOff;
        self.modes.integrating = !bus_off && !self.config.choices.mode_shown_at_once;
        cx.wire.set_mode(cx.node, node_mode(target));
        if bus_off {
            self.recover(cx);
            self.arrive(cx, target);
        }
    }

    /// The node has changed its mode.
    pub(super) fn node_mode_changed(&mut self, cx: &mut Context<'_>, mode: Mode) {
        if mode == Mode::Off || mode == Mode::ListenOnly {
            self.tx.forget();
        }
        if mode == Mode::Off {
            self.modes.in_message = false;
        }
        let Some(target) = self.modes.target.filter(|target| node_mode(*target) == mode) else { return };
        let looped = self.mode() == OperationMode::Loopback || target == OperationMode::Loopback;
        if self.modes.integrating || (looped && mode != Mode::Off) {
            self.modes.integrating = true;
        } else {
            self.arrive(cx, target);
        }
    }

    /// The node takes part in the traffic.
    pub(super) fn integrated(&mut self, cx: &mut Context<'_>) {
        self.modes.in_message = false;
        if core::mem::take(&mut self.modes.integrating)
            && let Some(target) = self.modes.target
        {
            self.arrive(cx, target);
        }
        self.schedule(cx);
    }

    /// A message has begun, or the bus is idle.
    pub(super) fn message_boundary(&mut self, cx: &mut Context<'_>, begins: bool) {
        self.modes.in_message = begins;
        if core::mem::take(&mut self.modes.between_messages)
            && let Some(target) = self.modes.target
        {
            self.arrive(cx, target);
        }
    }

    /// 34.5: the requested mode is in force.
    fn arrive(&mut self, cx: &mut Context<'_>, target: OperationMode) {
        self.modes.target = None;
        let before = self.con().opmod();
        if before == Ok(target) {
            return self.schedule(cx);
        }
        if before == Ok(OperationMode::Configuration) && node_mode(target) == Mode::Off {
            self.check_layout(cx);
        }
        let shown = self.regs.get(self.r.trec);
        self.regs.set_field(self.f.opmod, u32::from(target.bits()));
        if target == OperationMode::Configuration {
            if self.config.choices.configuration_clears_counters {
                self.reset_errors(cx, true);
            } else {
                self.regs.set(self.r.trec, shown);
            }
            self.reset_fifos(cx);
        } else {
            self.show_all_fifos();
        }
        // 34.12.1.8.
        self.raise(Int::MODIF);
        self.timer_conditions_changed(cx);
        let passive = matches!(target, OperationMode::ListenOnly | OperationMode::Disable);
        if passive && self.config.choices.txreq_withdrawn_in_passive_modes {
            self.withdraw_requests();
        }
        if target == OperationMode::Disable && self.config.choices.wake_in_disable {
            self.watch_for_activity(cx);
        }
        self.schedule(cx);
    }

    /// 34.12.1.4: a fatal error has stopped the module; only clearing ON ends that.
    pub(super) fn stop(&mut self, cx: &mut Context<'_>) {
        self.leave_bus(cx);
        self.modes.stopped = true;
        self.modes.target = None;
        self.modes.off_at = Some(cx.now + self.clocks(self.reset_clocks()));
    }

    pub(super) fn modes_timer(&self) -> Option<Time> {
        [self.modes.off_at, self.modes.wake_at].into_iter().flatten().min()
    }

    pub(super) fn modes_time_passed(&mut self, cx: &mut Context<'_>) {
        if self.modes.off_at.is_some_and(|at| at <= cx.now) {
            self.modes.off_at = None;
            self.regs.set_field(self.f.canbusy, 0);
        }
        self.pulse_lasted(cx);
    }

    /// `canbusy_while_idle`.
    pub(super) fn show_busy(&mut self) {
        if self.config.choices.busy_only_with_message && self.con().on() && !self.modes.stopped {
            self.regs.set_field(self.f.canbusy, u32::from(self.modes.in_message));
        }
    }

    /// A driver that polls OPMOD although ON is 0 waits for ever.
    pub(super) fn watch_futile_polling(&mut self, cx: &mut Context<'_>, access: &ReadAccess) {
        let con = pac::Con::from_bits(access.value);
        if con.on() || con.reqop() == con.opmod() {
            return;
        }
        self.modes.futile_reads = self.modes.futile_reads.saturating_add(1);
        if self.modes.futile_reads == FUTILE_READS {
            let because = "ON is 0: the module is held in reset, and OPMOD does not follow";
            self.ignored(cx, "34.4", access.slot, "REQOP", because);
        }
    }

    fn reset_clocks(&self) -> u32 {
        self.config.choices.reset_clocks
    }

    /// The time of a number of system clocks.
    pub(super) fn clocks(&self, clocks: u32) -> Time {
        Time::from_ps(u64::from(clocks) * 1_000_000_000_000 / u64::from(self.config.place.clock_hz.max(1)))
    }
}
