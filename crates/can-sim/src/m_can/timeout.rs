//! The timeout counter (2.3.11, 2.3.12, 3.3).

use can_wire::Time;
use m_can_pac::{
    enums::ToccTos,
    registers::{self as pac, Ir},
};

use super::MCanModel;
use crate::model::Context;

/// The down-counter: it had a value at a number of bit times, and counts from there or stands.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Timeout {
    value: u64,
    running_since: Option<u64>,
    /// Under FIFO control: expired, and the FIFO has not been empty since.
    expired: bool,
}

impl Timeout {
    /// After a hardware reset.
    pub(super) fn new(value: u32) -> Self {
        Self { value: u64::from(value), ..Self::default() }
    }
}

impl MCanModel {
    fn tocc(&self) -> pac::Tocc {
        pac::Tocc::from_bits(self.regs.get(self.r.tocc))
    }

    pub(super) fn timeout_enabled(&self) -> bool {
        self.tocc().etoc()
    }

    /// The fill level of the FIFO that controls the counter; `None` in Continuous Mode.
    fn controlling_level(&self) -> Option<u32> {
        match self.tocc().tos() {
            ToccTos::Continuous => None,
            ToccTos::TxEventFifo => Some(self.regs.field(self.f.effl)),
            ToccTos::RxFifo0 => Some(self.regs.field(self.f.f0fl)),
            ToccTos::RxFifo1 => Some(self.regs.field(self.f.f1fl)),
        }
    }

    fn remaining(&self, now: Time) -> u64 {
        let counted =
            self.timeout.running_since.map_or(0, |since| self.clock.bits(now).saturating_sub(since) / self.prescaler());
        self.timeout.value.saturating_sub(counted)
    }

    /// Starts, stops and presets the counter as the registers ask for.
    pub(super) fn follow_timeout(&mut self, cx: &mut Context<'_>) {
        let (tocc, cccr) = (self.tocc(), self.cccr());
        let level = self.controlling_level();
        // 3.1.1, timeout_preset_level: CCE holds the counter at TOP. 3.3: so does an empty FIFO.
        if cccr.cce() || level == Some(0) {
            self.timeout = Timeout { value: u64::from(tocc.top()), running_since: None, expired: false };
            return self.show_timeout(cx.now);
        }
        // 3.3: the counter runs only while INIT is 0, and is stopped by INIT. 2.3.12: under FIFO control it stops at zero.
        let runs = tocc.etoc() && !cccr.init() && !self.timeout.expired;
        if runs && self.timeout.running_since.is_none() {
            self.timeout.running_since = Some(self.clock.bits(cx.now));
        } else if !runs && self.timeout.running_since.is_some() {
            self.timeout.value = self.remaining(cx.now);
            self.timeout.running_since = None;
        }
    }

    /// 3.3: a write presets the counter in Continuous Mode, and does nothing under FIFO control.
    pub(super) fn preset_timeout(&mut self, cx: &mut Context<'_>) {
        if self.controlling_level().is_none() {
            self.timeout.value = u64::from(self.tocc().top());
            self.timeout.running_since = self.timeout.running_since.map(|_| self.clock.bits(cx.now));
        }
        self.show_timeout(cx.now);
    }

    /// Brings the counter up to the present.
    pub(super) fn count_down(&mut self, cx: &mut Context<'_>) {
        while let Some(since) = self.timeout.running_since
            && self.remaining(cx.now) == 0
        {
            self.raise(cx, Ir::TOO);
            if self.controlling_level().is_some() {
                self.timeout = Timeout { value: 0, running_since: None, expired: true };
            } else {
                // 3.3: in Continuous Mode it restarts at TOP at once. A period of 0 expires at every count.
                self.timeout.running_since = Some(since + self.timeout.value.max(1) * self.prescaler());
                self.timeout.value = u64::from(self.tocc().top()).max(1);
            }
        }
        self.show_timeout(cx.now);
    }

    fn show_timeout(&mut self, now: Time) {
        let remaining = self.remaining(now) as u32;
        self.regs.set_field(self.f.toc, remaining);
    }

    pub(super) fn timeout_timer(&self) -> Option<Time> {
        let since = self.timeout.running_since?;
        self.clock.time_of(since + self.timeout.value * self.prescaler())
    }
}
