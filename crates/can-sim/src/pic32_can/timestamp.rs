//! The time stamp timer (34.13, Register 34-8).

use can_wire::{Mode, Time};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{self as pac, Int},
};

use super::Pic32CanModel;
use crate::{model::Context, registers::WriteAccess};

/// The timer: its count at a time, and whether it runs.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Timer {
    /// When the count was what CANTS holds, with the prescaler at its start.
    since: Option<Time>,
    /// System clocks that the prescaler had counted when the timer was stopped.
    held: u64,
    /// Overflows that CTMRIF has told since then.
    told: u64,
}

impl Pic32CanModel {
    fn tmr(&self) -> pac::Tmr {
        pac::Tmr::from_bits(self.regs.get(self.r.tmr))
    }

    /// timestamp_prescaler: system clocks for one step.
    fn period(&self) -> u64 {
        u64::from(self.tmr().cantspre()).max(1)
    }

    /// Register 34-8: frozen while CANCAP is 0. Without system clock, and in Disable mode with the module's clock stopped,
    /// there is nothing to count (timer_in_disable_mode).
    fn timer_can_run(&self) -> bool {
        let clocked = self.mode() != OperationMode::Disable || self.config.choices.timer_runs_in_disable;
        self.con().on() && self.con().cancap() && !self.is_sleeping() && clocked
    }

    /// System clocks in a span, by the device's real clock.
    fn clocks_in(&self, span: Time) -> u64 {
        let place = &self.config.place;
        let hz = u128::from(place.clock_hz) * u128::from((1_000_000 + i64::from(place.clock_ppm)).unsigned_abs());
        (u128::from(span.as_ps()) * hz / 1_000_000_000_000_000_000) as u64
    }

    /// Steps since CANTS was set, its overflows included.
    fn steps(&self, now: Time) -> u64 {
        let clocks = self.timer.since.map_or(0, |since| self.clocks_in(now.since(since)));
        u64::from(self.tmr().cants()) + (self.timer.held + clocks) / self.period()
    }

    /// CANTS at a time.
    pub(super) fn count(&self, at: Time) -> u16 {
        self.steps(at) as u16
    }

    /// Something that the timer needs has changed: it stops or goes on.
    pub(super) fn timer_conditions_changed(&mut self, cx: &mut Context<'_>) {
        match (self.timer_can_run(), self.timer.since.is_some()) {
            (true, false) => self.timer.since = Some(cx.now),
            (false, true) => self.stop_timer(cx),
            _ => {}
        }
    }

    /// The count stays.
    pub(super) fn stop_timer(&mut self, cx: &mut Context<'_>) {
        let Some(since) = self.timer.since else { return };
        let clocks = self.timer.held + self.clocks_in(cx.now.since(since));
        let (count, held) = (self.count(cx.now), clocks % self.period());
        self.tell_overflows(cx.now);
        self.regs.set_field(self.f.cants, u32::from(count));
        self.timer = Timer { since: None, held, told: 0 };
    }

    /// 34.12.1.9.
    fn tell_overflows(&mut self, now: Time) {
        let overflows = self.steps(now) >> 16;
        if overflows > self.timer.told {
            self.timer.told = overflows;
            self.raise(Int::CTMRIF);
        }
    }

    /// Brings CANTS up to the present.
    pub(super) fn show_timer(&mut self, cx: &mut Context<'_>) {
        let Some(since) = self.timer.since else { return };
        let clocks = self.timer.held + self.clocks_in(cx.now.since(since));
        let count = self.count(cx.now);
        self.tell_overflows(cx.now);
        self.regs.set_field(self.f.cants, u32::from(count));
        self.timer = Timer { since: Some(cx.now), held: clocks % self.period(), told: 0 };
    }

    /// The write is worked out again on the present count.
    pub(super) fn write_timer(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        self.show_timer(cx);
        *access = self.regs.plan_write(access.slot, access.lanes, access.written, access.alias);
    }

    /// Register 34-8: any write restarts the prescaler (timer_alias_write).
    pub(super) fn timer_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        if access.alias.is_none() || self.config.choices.alias_write_restarts_timer {
            let since = self.timer.since.map(|_| cx.now);
            self.timer = Timer { since, held: 0, told: 0 };
        }
    }

    /// When CANTS overflows next.
    pub(super) fn timestamp_timer(&self) -> Option<Time> {
        let since = self.timer.since?;
        let steps = ((self.timer.told + 1) << 16) - u64::from(self.tmr().cants());
        let clocks = u128::from((steps * self.period()).saturating_sub(self.timer.held));
        let place = &self.config.place;
        let hz =
            u128::from(place.clock_hz.max(1)) * u128::from((1_000_000 + i64::from(place.clock_ppm)).unsigned_abs());
        let ps = (clocks * 1_000_000_000_000_000_000).div_ceil(hz.max(1));
        Some(since + Time::from_ps(u64::try_from(ps).unwrap_or(u64::MAX >> 2)))
    }

    pub(super) fn timestamp_time_passed(&mut self, cx: &mut Context<'_>) {
        self.tell_overflows(cx.now);
    }

    /// 34.13: the time stamp of a message is the count right after its end of frame. A receiver knows that the message
    /// is valid one bit before the last one of the end of frame, a node in loop back in the last one.
    pub(super) fn capture(&mut self, cx: &mut Context<'_>) -> Option<u16> {
        if !self.con().cancap() {
            return None;
        }
        let config = cx.wire.config(cx.node);
        let bit = config.nominal_bit().as_ps();
        let nominal = config.nominal;
        let behind_sample = bit * u64::from(nominal.phase_seg2) / nominal.quanta();
        let bits = if cx.wire.mode(cx.node) == Mode::InternalLoopback { 0 } else { bit };
        Some(self.count(cx.now + Time::from_ps(behind_sample + bits)))
    }
}
