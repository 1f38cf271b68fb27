//! The Time Base Counter and timestamps (11.0).

use can_frame::Frame;
use can_wire::Time;
use dspic33_canfd_pac::{
    enums::{TsconHTseof, TsconHTsres},
    registers as pac,
};

use super::Dspic33CanfdModel;
use crate::{model::Context, registers::WriteAccess};

/// The counter: what it was at a point in time, and since when it counts.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct TimeBase {
    value: u32,
    since: Option<Time>,
}

/// The point of a frame at which the counter is captured, before TSCONH selects one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moments {
    pub(super) sof: Time,
    /// The bit after FDF.
    pub(super) res: Option<Time>,
    /// The frame is valid.
    pub(super) valid: Time,
}

impl Dspic33CanfdModel {
    fn time_control(&self) -> pac::TsconH {
        pac::TsconH::from_bits(self.word(self.r.tscon_h))
    }

    /// `tbc_prescaler`: clock periods per count.
    fn clocks_per_count(&self) -> u128 {
        u128::from(pac::TsconL::from_bits(self.word(self.r.tscon_l)).tbcpre()) + 1
    }

    /// Clock periods per 10^18 picoseconds.
    fn clock(&self) -> u128 {
        let place = &self.config.place;
        u128::from(place.clock_hz) * (1_000_000 + i128::from(place.clock_ppm)).unsigned_abs()
    }

    /// Counts since the counter was last set.
    fn counts(&self, span: Time) -> u128 {
        u128::from(span.as_ps()) * self.clock() / 1_000_000_000_000_000_000 / self.clocks_per_count()
    }

    /// The counter at a time that is not before it was last set.
    fn time_at(&self, at: Time) -> u32 {
        match self.time_base.since {
            Some(since) if at > since => self.time_base.value.wrapping_add(self.counts(at.since(since)) as u32),
            _ => self.time_base.value,
        }
    }

    /// Table 11-1: the timestamp of a frame.
    pub(super) fn timestamp(&self, frame: &Frame, moments: Moments) -> u32 {
        let control = self.time_control();
        let at = match (control.tseof(), control.tsres(), moments.res) {
            (TsconHTseof::Valid, ..) => moments.valid,
            (TsconHTseof::Beginning, TsconHTsres::AfterFdf, Some(res)) if frame.is_fd() => res,
            _ => moments.sof,
        };
        self.time_at(at)
    }

    /// Brings TBCL and TBCH up to the present.
    pub(super) fn show_time(&mut self, cx: &mut Context<'_>) {
        let value = self.time_at(cx.now);
        self.regs.set(self.r.tbc_l, value & 0xFFFF);
        self.regs.set(self.r.tbc_h, value >> 16);
    }

    /// Before the prescaler or the enable changes: what was counted so far stays.
    pub(super) fn keep_time(&mut self, cx: &mut Context<'_>) {
        self.time_base.value = self.time_at(cx.now);
        if self.time_base.since.is_some() {
            self.time_base.since = Some(cx.now);
        }
    }

    /// 11.0: TBCEN enables the counter; clearing it stops and resets it, by the description.
    pub(super) fn time_control_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        if access.slot != self.r.tscon_h {
            return;
        }
        let enabled = self.time_control().tbcen();
        if enabled && self.time_base.since.is_none() {
            self.time_base = TimeBase { value: self.stored_time(), since: Some(cx.now) };
        } else if !enabled && self.time_base.since.is_some() {
            self.time_base = TimeBase { value: self.stored_time(), since: None };
        }
    }

    fn stored_time(&self) -> u32 {
        self.regs.get(self.r.tbc_l) | self.regs.get(self.r.tbc_h) << 16
    }

    /// Register 3-9: any write resets the prescaler's count; while the counter runs it changes nothing else
    /// (`tbc_write_while_running`).
    pub(super) fn time_written(&mut self, cx: &mut Context<'_>) {
        if self.time_base.since.is_some() {
            self.keep_time(cx);
        } else {
            self.time_base.value = self.stored_time();
        }
    }

    /// 4.6.1: without a clock the counter stands still.
    pub(super) fn stop_time(&mut self) {
        self.time_base = TimeBase { value: self.stored_time(), since: None };
    }

    pub(super) fn continue_time(&mut self, cx: &mut Context<'_>) {
        if self.time_control().tbcen() {
            self.time_base.since = Some(cx.now);
        }
    }

    /// When the counter rolls over.
    pub(super) fn time_base_timer(&self) -> Option<Time> {
        let since = self.time_base.since?;
        let clocks = ((1_u128 << 32) - u128::from(self.time_base.value)) * self.clocks_per_count();
        let ps = (clocks * 1_000_000_000_000_000_000).div_ceil(self.clock().max(1));
        Some(since + Time::from_ps(u64::try_from(ps).ok()?))
    }

    /// 12.3.5: the rollover sets TBCIF.
    pub(super) fn time_base_passed(&mut self, cx: &mut Context<'_>) {
        if self.time_base_timer().is_some_and(|at| at <= cx.now) {
            self.time_base = TimeBase { value: 0, since: Some(cx.now) };
            self.raise(pac::IntL::TBCIF);
        }
    }
}
