//! Error counters, error states and the flags they set (34.11, Register 34-5, 34.12.1.1, 34.12.1.3).

use can_wire::ErrorState;
use pic32_can_pac::registers::{Int, Trec};

use super::{Pic32CanModel, config::ErrorStateChanges};
use crate::model::Context;

/// Register 34-5.
const WARNING: u16 = 96;
const PASSIVE: u16 = 128;

/// How bad a counter is. The order is that of severity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
enum Level {
    #[default]
    Good,
    Warning,
    Passive,
    BusOff,
}

/// What CiTREC shows.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Errors {
    tec: u16,
    rec: u16,
    bus_off: bool,
    transmitter: Level,
    receiver: Level,
}

impl Errors {
    pub(super) const fn is_bus_off(&self) -> bool {
        self.bus_off
    }
}

fn level(count: u16) -> Level {
    match count {
        PASSIVE.. => Level::Passive,
        WARNING.. => Level::Warning,
        _ => Level::Good,
    }
}

impl Pic32CanModel {
    pub(super) fn count_errors(&mut self, tec: u16, rec: u16) {
        (self.errors.tec, self.errors.rec) = (tec, rec);
        self.show_errors();
    }

    /// 34.11.2.3, bus_off_recovery: the module begins to recover by itself.
    pub(super) fn error_state(&mut self, cx: &mut Context<'_>, to: ErrorState) {
        self.errors.bus_off = to == ErrorState::BusOff;
        self.show_errors();
        if self.errors.bus_off {
            self.request_dropped(cx);
            if !self.config.choices.bus_off_needs_configuration {
                self.recover(cx);
            }
        } else {
            self.schedule(cx);
        }
    }

    pub(super) fn recover(&self, cx: &mut Context<'_>) {
        let started = cx.wire.start_recovery(cx.node);
        debug_assert!(started.is_ok(), "a node that is bus off and switched on can recover: {started:?}");
    }

    /// 34.5.1, 34.4: the counters are cleared; that is no change of the error state.
    pub(super) fn reset_errors(&mut self, cx: &mut Context<'_>, on_the_wire: bool) {
        self.errors = Errors::default();
        self.show_errors();
        if on_the_wire && cx.wire.error_counters(cx.node) != (0, 0) {
            cx.wire.set_error_counters(cx.node, 0, 0);
        }
    }

    /// Register 34-5.
    fn show_errors(&mut self) {
        let Errors { tec, rec, bus_off, .. } = self.errors;
        let high = self.config.choices.warning_above_128;
        let warns = |count: u16| count >= WARNING && (count < PASSIVE || high);
        let bits = [
            (Trec::TXBO, bus_off),
            (Trec::TXBP, tec >= PASSIVE),
            (Trec::RXBP, rec >= PASSIVE),
            (Trec::TXWARN, warns(tec)),
            (Trec::RXWARN, warns(rec)),
            (Trec::EWARN, tec >= WARNING || rec >= WARNING),
        ];
        let shown = bits.into_iter().filter(|(_, holds)| *holds).fold(0, |word, (bit, _)| word | bit.bits());
        self.regs.set(self.r.trec, shown);
        // bus_off_recovery: in bus off TEC reads 0xFF.
        self.regs.set_field(self.f.tec, u32::from(tec));
        self.regs.set_field(self.f.rec, u32::from(rec));
        let transmitter = if bus_off { Level::BusOff } else { level(tec) };
        let before = core::mem::replace(&mut self.errors.transmitter, transmitter);
        self.level_changed(before, transmitter);
        let receiver = level(rec);
        let before = core::mem::replace(&mut self.errors.receiver, receiver);
        self.level_changed(before, receiver);
    }

    /// 34.12.1.3: once for each crossing of a threshold.
    fn level_changed(&mut self, before: Level, now: Level) {
        let told = match self.config.choices.error_state_changes {
            ErrorStateChanges::All => true,
            ErrorStateChanges::Upward => now > before,
            ErrorStateChanges::AllButLeavingWarning => (before, now) != (Level::Warning, Level::Good),
        };
        if before != now && told {
            self.raise(Int::CERRIF);
        }
    }
}
