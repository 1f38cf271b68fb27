//! Software initialization, operating modes and power down (3.1).

use can_wire::Mode;
use m_can_pac::{enums::TestTx, registers as pac};

use super::{Command, MCanModel};
use crate::{diagnostic::DiagnosticKind, layout, model::Context, registers::WriteAccess};

/// What the modes depend on besides CCCR.
#[derive(Clone, Debug)]
pub(super) struct Modes {
    /// What the node on the bus has been told.
    pub(super) mode: Mode,
    /// CCCR.CCE when it was looked at last.
    cce: bool,
    /// CCCR.CSR as software has written it, and the input `m_can_clkstop_req`.
    csr_written: bool,
    clkstop_req: bool,
    /// CCCR.ASM as software has written it, or as a Message RAM failure has set it since; and the input `m_can_cok`.
    asm_written: bool,
    clock_ok: bool,
    /// The last start has failed for its bit timing and was reported.
    refused: bool,
    pub(super) test_tx: TestTx,
}

impl Default for Modes {
    fn default() -> Self {
        Self {
            mode: Mode::Off,
            cce: false,
            csr_written: false,
            clkstop_req: false,
            asm_written: false,
            clock_ok: true,
            refused: false,
            test_tx: TestTx::Core,
        }
    }
}

impl MCanModel {
    /// What is not stored as it is written to CCCR.
    pub(super) fn write_cccr(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        let init = self.f.init.bits();
        if access.lanes & init != 0 {
            self.write_init(cx, access, init);
        }
        // 3.1.8: CSR reads 1 while the pin is active.
        let csr = self.f.csr.bits();
        if access.lanes & csr != 0 {
            self.modes.csr_written = access.new & csr != 0;
        }
        if self.modes.clkstop_req {
            access.new |= csr;
        }
        // 3.1.5: with m_can_cok at 0 ASM is 1, and returns to what was written.
        let asm = self.f.asm.bits();
        if access.lanes & asm != 0 {
            self.modes.asm_written = access.new & asm != 0;
        }
        if !self.modes.clock_ok {
            access.new |= asm;
        }
        // 2.3.7: bits that synthesis fixes to 0.
        if self.config.tsu_registers.is_none() {
            access.new &= !pac::Cccr::UTSU.bits();
        }
        if self.config.iso_only {
            access.new &= !pac::Cccr::NISO.bits();
        }
    }

    /// 2.3.7: the value written to INIT is taken over in the other clock domain, and is read back only then.
    fn write_init(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess, init: u32) {
        let wanted = access.new & init != 0;
        if self.config.choices.command_delay == 0 {
            return;
        }
        access.new = access.new & !init | access.old & init;
        let pending = self.commands.iter().rev().find_map(|(_, command)| match command {
            Command::Init(value) => Some(*value),
            _ => None,
        });
        if let Some(pending) = pending
            && pending != wanted
        {
            cx.report("2.3.7", DiagnosticKind::NotTakenOver { register: "CCCR", field: "INIT" });
        }
        if pending.unwrap_or(access.old & init != 0) == wanted {
            return;
        }
        // 3.1.1: CCE falls with INIT, so a 1 written together with INIT 0 is never seen.
        self.command(cx, Command::Init(wanted));
    }

    /// 3.1.1: CCE resets the status registers, by the description, and holds the handlers idle.
    pub(super) fn follow_configuration_mode(&mut self, cx: &mut Context<'_>) {
        let cce = self.cccr().cce();
        if core::mem::replace(&mut self.modes.cce, cce) == cce {
            return;
        }
        if cce {
            // requests_during_configuration: what was requested and not taken over is forgotten.
            self.regs.set(self.r.txbar, 0);
            self.regs.set(self.r.txbcr, 0);
            self.commands.retain(|(_, command)| matches!(command, Command::Init(_)));
            self.reset_tx(cx);
            self.reset_rx();
        } else {
            self.check_configuration(cx);
            self.start_tx();
        }
    }

    fn wanted_mode(&self) -> Mode {
        let cccr = self.cccr();
        if cccr.init() {
            return Mode::Off;
        }
        let loop_back = pac::Test::from_bits(self.regs.get(self.r.test)).lbck();
        match (loop_back, cccr.mon(), cccr.asm_()) {
            // 3.1.9.2: MON and LBCK together are internal loop back, which transmits although MON alone does not.
            (true, true, _) => Mode::InternalLoopback,
            (true, false, _) => Mode::ExternalLoopback,
            (false, true, _) => Mode::ListenOnly,
            (false, false, true) => Mode::Restricted,
            (false, false, false) => Mode::Normal,
        }
    }

    /// Takes the node on the bus to the mode that the registers ask for.
    pub(super) fn follow_modes(&mut self, cx: &mut Context<'_>) {
        self.follow_test_pin(cx);
        let wanted = self.wanted_mode();
        if wanted == Mode::Off {
            self.modes.refused = false;
        }
        if wanted == self.modes.mode || self.modes.refused {
            return;
        }
        let loops = matches!(wanted, Mode::InternalLoopback | Mode::ExternalLoopback);
        if loops && self.cccr().asm_() {
            let what = "Restricted Operation Mode is combined with Loop Back Mode".to_owned();
            cx.report("3.1.5", DiagnosticKind::Contradiction { what });
        }
        let before = self.modes.mode;
        if before == Mode::Off {
            if !self.go_on_bus(cx) {
                self.modes.refused = true;
                return;
            }
            self.clock.start(cx.now, cx.wire.config(cx.node).nominal_bit());
        }
        self.modes.mode = wanted;
        cx.wire.set_mode(cx.node, wanted);
        self.node_restarted(cx, before, wanted);
        if wanted == Mode::Off {
            // 3.1.1: message transfer stops at once; the counters that count bit times have none to count.
            self.show_counters(cx);
            self.clock.stop(cx.now);
        }
        self.mode_changed(cx);
    }

    /// 2.3.14: clearing INIT after Bus_Off starts the recovery. Another start of it counts from the beginning again, so
    /// toggling INIT cannot shorten it.
    fn node_restarted(&mut self, cx: &mut Context<'_>, before: Mode, now: Mode) {
        let bus_off = cx.wire.error_state(cx.node) == can_wire::ErrorState::BusOff;
        if before == Mode::Off && now != Mode::Off && bus_off {
            let started = cx.wire.start_recovery(cx.node);
            debug_assert!(started.is_ok(), "a node that is bus off and switched on can recover: {started:?}");
        }
        let rejoins = before == Mode::Off || now == Mode::Off;
        if rejoins {
            self.synchronizing();
        }
    }

    /// 3.1.8: a clock stop waits for pending transmissions and for bus idle, sets INIT and is then acknowledged.
    pub(super) fn follow_clock_stop(&mut self, cx: &mut Context<'_>) {
        let cccr = self.cccr();
        if !cccr.csr() {
            if cccr.csa() {
                self.regs.set_field(self.f.csa, 0);
            }
            return;
        }
        if cccr.csa() {
            return;
        }
        let done = self.regs.get(self.r.txbrp) == 0 && self.commands.is_empty() && self.is_idle();
        if !cccr.init() && done {
            self.regs.set_field(self.f.init, 1);
            self.follow_modes(cx);
        }
        if self.cccr().init() {
            self.regs.set_field(self.f.csa, 1);
        }
    }

    /// Input `m_can_clkstop_req`: requests a clock stop like CCCR.CSR (3.1.8).
    pub fn set_clock_stop_request(&mut self, cx: &mut Context<'_>, active: bool) {
        self.modes.clkstop_req = active;
        self.regs.set_field(self.f.csr, u32::from(active || self.modes.csr_written));
        self.follow(cx);
    }

    /// Output `m_can_clkstop_ack` (3.1.8).
    #[must_use]
    pub fn clock_stop_acknowledged(&self) -> bool {
        self.cccr().csa()
    }

    /// Input `m_can_cok` of a Clock Calibration unit: while it is 0, CCCR.ASM is 1 (3.1.5).
    pub fn set_clock_ok(&mut self, cx: &mut Context<'_>, ok: bool) {
        self.modes.clock_ok = ok;
        self.regs.set_field(self.f.asm, u32::from(!ok || self.modes.asm_written));
        self.follow(cx);
    }

    /// 3.1.5: the Tx Handler has failed to read the Message RAM in time.
    pub(super) fn enter_restricted_operation(&mut self) {
        // restricted_mode_sources: only software can end what a failure has begun.
        self.modes.asm_written = true;
        self.regs.set_field(self.f.asm, 1);
    }

    /// When configuration mode ends: what is written in the registers cannot all be meant.
    fn check_configuration(&mut self, cx: &mut Context<'_>) {
        self.check_field_ranges(cx);
        self.check_bit_timing(cx);
        let txbc = pac::Txbc::from_bits(self.regs.get(self.r.txbc));
        let (dedicated, rest) = (u32::from(txbc.ndtb()).min(32), u32::from(txbc.tfqs()).min(32));
        if dedicated + rest > 32 {
            let what = format!("TXBC: {dedicated} dedicated Tx Buffers and {rest} of FIFO or queue are more than 32");
            cx.report("2.3.35", DiagnosticKind::Contradiction { what });
        }
        let buffers = self.referenced_rx_buffers(cx);
        let sections = layout::sections(&self.regs, |_| buffers);
        self.check_sections(cx, sections);
    }
}
