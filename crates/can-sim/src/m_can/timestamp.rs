//! Timestamps (2.3.9, 2.3.10, 3.2) and the count of CAN bit times that they and the timeout counter share.

use can_frame::Frame;
use can_wire::{Field, Time, encode};
use m_can_pac::{
    enums::{CccrNiso, TsccTss},
    registers::{self as pac, Ir},
};

use super::MCanModel;
use crate::model::Context;

/// CAN bit times since the first start. Nominal bits are counted by the node's clock; the shorter bits of a data phase
/// are added at the end of their frame (`timestamp_counter_with_fd`).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BitCounter {
    counted: u64,
    since: Option<Time>,
    bit: Time,
}

impl BitCounter {
    /// The node begins to count bits.
    pub(super) fn start(&mut self, now: Time, bit: Time) {
        self.since = Some(now);
        self.bit = bit;
    }

    /// 2.3.10, `timestamp_counter_in_init`: there are no bit times while CCCR.INIT is 1.
    pub(super) fn stop(&mut self, now: Time) {
        self.counted = self.bits(now);
        self.since = None;
    }

    /// Bit times so far.
    pub(super) fn bits(&self, now: Time) -> u64 {
        self.counted + self.since.map_or(0, |since| now.since(since).as_ps() / self.bit.as_ps().max(1))
    }

    /// When a number of bit times is reached; `None` while none pass.
    pub(super) fn time_of(&self, bits: u64) -> Option<Time> {
        let since = self.since?;
        Some(since + self.bit * bits.saturating_sub(self.counted))
    }

    fn add(&mut self, bits: u64) {
        self.counted += bits;
    }
}

/// The timestamp counter and what it was at the last start of frame.
#[derive(Clone, Debug)]
pub(super) struct Timestamps {
    /// Bit times at which the counter was `value`.
    from: u64,
    value: u64,
    /// Wrap-arounds that IR.TSW has told.
    wraps: u64,
    at_start_of_frame: u16,
    /// Timestamp registers of the TSU: when each was captured; and the one that is used next.
    tsu: Vec<Option<Time>>,
    next: usize,
    /// Pulses of `m_can_tsrx` and `m_can_tstx`.
    pub(super) rx_pulses: u64,
    pub(super) tx_pulses: u64,
}

impl Timestamps {
    pub(super) fn new(registers: Option<u8>) -> Self {
        Self {
            from: 0,
            value: 0,
            wraps: 0,
            at_start_of_frame: 0,
            tsu: vec![None; usize::from(registers.unwrap_or(0).min(8))],
            next: 0,
            rx_pulses: 0,
            tx_pulses: 0,
        }
    }
}

impl MCanModel {
    /// TSCC.TCP + 1: bit times per count, of the timestamp and of the timeout counter.
    pub(super) fn prescaler(&self) -> u64 {
        u64::from(pac::Tscc::from_bits(self.regs.get(self.r.tscc)).tcp()) + 1
    }

    fn timestamp_source(&self) -> TsccTss {
        pac::Tscc::from_bits(self.regs.get(self.r.tscc)).tss()
    }

    /// All counts since the counter was last set, wrap-arounds included.
    fn counts(&self, now: Time) -> u64 {
        self.timestamps.value + (self.clock.bits(now) - self.timestamps.from) / self.prescaler()
    }

    fn timestamp(&self, now: Time) -> u16 {
        match self.timestamp_source() {
            TsccTss::Zero | TsccTss::ZeroAlt => 0,
            TsccTss::Internal => self.counts(now) as u16,
            TsccTss::External => self.external_timebase(now),
        }
    }

    /// 2.3.9: the input `m_can_ext_ts`.
    fn external_timebase(&self, now: Time) -> u16 {
        (u128::from(now.as_ps()) * u128::from(self.config.external_timebase_hz) / 1_000_000_000_000) as u16
    }

    /// Brings TSCV and TOCV up to the present, and their flags.
    pub(super) fn show_counters(&mut self, cx: &mut Context<'_>) {
        let wraps = self.counts(cx.now) >> 16;
        // 2.3.10: a wrap-around of the internal counter.
        if wraps > self.timestamps.wraps && self.timestamp_source() == TsccTss::Internal {
            self.raise(cx, Ir::TSW);
        }
        self.timestamps.wraps = wraps;
        self.regs.set_field(self.f.tsc, u32::from(self.timestamp(cx.now)));
        self.count_down(cx);
    }

    /// 2.3.10: a write resets the counter and is no wrap-around; with the external timebase the write condition of the
    /// description keeps it from doing anything.
    pub(super) fn reset_timestamp(&mut self, cx: &mut Context<'_>) {
        if self.timestamp_source() == TsccTss::External {
            return;
        }
        self.timestamps.from = self.clock.bits(cx.now);
        self.timestamps.value = 0;
        self.timestamps.wraps = 0;
    }

    /// Before TSCC changes: what was counted so far stays.
    pub(super) fn keep_counts(&mut self, cx: &mut Context<'_>) {
        self.timestamps.value = self.counts(cx.now) & 0xFFFF;
        self.timestamps.wraps = 0;
        self.timestamps.from = self.clock.bits(cx.now);
    }

    pub(super) fn timestamp_timer(&self) -> Option<Time> {
        if self.timestamp_source() != TsccTss::Internal {
            return None;
        }
        let counts = ((self.timestamps.wraps + 1) << 16) - self.timestamps.value;
        self.clock.time_of(self.timestamps.from + counts * self.prescaler())
    }

    /// 3.2.1: captured at the start of every frame, received or transmitted.
    pub(super) fn capture_timestamp(&mut self, now: Time) {
        self.timestamps.at_start_of_frame = self.timestamp(now);
    }

    pub(super) const fn frame_timestamp(&self) -> u16 {
        self.timestamps.at_start_of_frame
    }

    /// 3.2.2: at the end of a frame the TSU captures its time and tells in which of its registers.
    pub(super) fn capture_in_tsu(&mut self, now: Time) -> u8 {
        let number = self.timestamps.next;
        if let Some(register) = self.timestamps.tsu.get_mut(number) {
            *register = Some(now);
            self.timestamps.next = (number + 1) % self.timestamps.tsu.len();
        }
        number as u8
    }

    /// The timestamp registers of the TSU: when each was captured last.
    #[must_use]
    pub fn tsu_registers(&self) -> &[Option<Time>] {
        &self.timestamps.tsu
    }

    /// Pulses of `m_can_tsrx` and of `m_can_tstx` so far (3.2.2).
    #[must_use]
    pub const fn tsu_pulses(&self) -> (u64, u64) {
        (self.timestamps.rx_pulses, self.timestamps.tx_pulses)
    }

    /// The end of a frame with a data phase: its bits were shorter than nominal ones, so that there were more of them.
    pub(super) fn count_data_phase(&mut self, cx: &mut Context<'_>, frame: &Frame) {
        let counting = self.timestamp_source() == TsccTss::Internal || self.timeout_enabled();
        if !frame.bit_rate_switch() || !counting {
            return;
        }
        self.show_counters(cx);
        let iso = self.cccr().niso() == CccrNiso::Iso11898_1;
        let data_phase = |field: Field| field > Field::Brs;
        let bits = encode(frame, iso).iter().filter(|bit| data_phase(bit.position.field)).count() as u64;
        let config = cx.wire.config(cx.node);
        let nominal = bits * config.data_bit().as_ps() / config.nominal_bit().as_ps().max(1);
        self.clock.add(bits.saturating_sub(nominal));
        self.show_counters(cx);
    }
}
