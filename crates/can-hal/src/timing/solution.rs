//! What the solver hands out.

use core::fmt;

use super::{BitTiming, SamplePoint, Segments, Tolerance};

/// A bit rate as the clock makes it: a clock in hertz and the periods of it in a bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BitRate {
    clock: u32,
    periods: u64,
}

impl BitRate {
    pub(super) const fn new(clock: u32, periods: u64) -> Self {
        Self { clock, periods }
    }

    /// Clock in hertz.
    #[must_use]
    pub const fn clock(self) -> u32 {
        self.clock
    }

    /// Clock periods in a bit.
    #[must_use]
    pub const fn periods(self) -> u64 {
        self.periods
    }

    /// In bit/s, rounded to the nearest whole number.
    #[must_use]
    pub const fn get(self) -> u32 {
        self.rounded(1) as u32
    }

    /// In thousandths of a bit/s, rounded to the nearest whole number.
    #[must_use]
    pub const fn millis(self) -> u64 {
        self.rounded(1000)
    }

    const fn rounded(self, parts: u64) -> u64 {
        match (self.clock as u64 * parts + self.periods / 2).checked_div(self.periods) {
            Some(value) => value,
            None => 0,
        }
    }

    /// Deviation from a requested bit rate in ppm, rounded away from 0, so that 0 means exact.
    #[must_use]
    pub const fn error_ppm(self, requested: u32) -> i32 {
        let wanted = requested as i128 * self.periods as i128;
        let difference = self.clock as i128 - wanted;
        if wanted == 0 || difference == 0 {
            return 0;
        }
        let size = (difference.abs() * 1_000_000 + wanted - 1) / wanted;
        let size = if size > i32::MAX as i128 { i32::MAX } else { size as i32 };
        if difference < 0 { -size } else { size }
    }
}

impl fmt::Display for BitRate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let millis = self.millis();
        match (millis / 1000, millis % 1000) {
            (whole, 0) => write!(f, "{whole} bit/s"),
            (whole, rest) => write!(f, "{whole}.{rest:03} bit/s"),
        }
    }
}

/// How well a phase came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PhaseReport {
    /// The bit rate.
    pub bit_rate: BitRate,
    /// Its deviation in ppm of the requested one, rounded away from 0: 0 means exact.
    pub error_ppm: i32,
    /// The sample point.
    pub sample_point: SamplePoint,
    /// Its deviation in hundredths of a percent of the bit time, positive if it is late, rounded to the nearest.
    pub sample_point_error: i16,
}

impl PhaseReport {
    pub(super) const fn of(segments: &Segments, clock: u32, divider: u32, rate: u32, target: SamplePoint) -> Self {
        let bit_rate = segments.bit_rate(clock, divider);
        let sample_point = segments.sample_point();
        Self {
            bit_rate,
            error_ppm: bit_rate.error_ppm(rate),
            sample_point,
            sample_point_error: sample_point.get() as i16 - target.get() as i16,
        }
    }
}

/// A bit timing with its quality.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Solution {
    /// The timing.
    pub timing: BitTiming,
    /// The arbitration phase.
    pub nominal: PhaseReport,
    /// The data phase.
    pub data: Option<PhaseReport>,
    /// What the clocks of two nodes may deviate.
    pub tolerance: Tolerance,
}
