//! Simulated time.

use core::{fmt, ops};

/// A point in simulated time, or a span of it, in integer picoseconds. The clock starts at zero and lasts 213 days.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Time(u64);

impl Time {
    /// The start of the simulation.
    pub const ZERO: Time = Time(0);
    /// Later than everything that happens.
    pub const MAX: Time = Time(u64::MAX >> 2);

    /// A time in picoseconds.
    #[must_use]
    pub const fn from_ps(ps: u64) -> Time {
        Time(ps)
    }

    /// A time in nanoseconds.
    #[must_use]
    pub const fn from_ns(ns: u64) -> Time {
        Time(ns * 1_000)
    }

    /// A time in microseconds.
    #[must_use]
    pub const fn from_us(us: u64) -> Time {
        Time(us * 1_000_000)
    }

    /// A time in milliseconds.
    #[must_use]
    pub const fn from_ms(ms: u64) -> Time {
        Time(ms * 1_000_000_000)
    }

    /// Picoseconds.
    #[must_use]
    pub const fn as_ps(self) -> u64 {
        self.0
    }

    /// Nanoseconds, rounded down.
    #[must_use]
    pub const fn as_ns(self) -> u64 {
        self.0 / 1_000
    }

    /// Seconds, for a report.
    #[must_use]
    pub fn as_secs_f64(self) -> f64 {
        self.0 as f64 / 1e12
    }

    /// The span since `earlier`, zero if that is not earlier.
    #[must_use]
    pub const fn since(self, earlier: Time) -> Time {
        Time(self.0.saturating_sub(earlier.0))
    }
}

impl ops::Add for Time {
    type Output = Time;

    fn add(self, other: Time) -> Time {
        Time(self.0 + other.0)
    }
}

impl ops::AddAssign for Time {
    fn add_assign(&mut self, other: Time) {
        self.0 += other.0;
    }
}

impl ops::Mul<u64> for Time {
    type Output = Time;

    fn mul(self, factor: u64) -> Time {
        Time(self.0 * factor)
    }
}

/// Microseconds with all six digits of the picoseconds: `12.345678 us`.
impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{:06} us", self.0 / 1_000_000, self.0 % 1_000_000)
    }
}

/// A node's own notion of time: picoseconds with 32 binary fraction bits, because the period of a clock that is some
/// ppm off is no whole number of picoseconds. What leaves the node is rounded up to a picosecond, as an event happens
/// no earlier than its cause.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(crate) struct Fine(u128);

const FRACTION_BITS: u32 = 32;

impl Fine {
    #[inline]
    pub(crate) fn from_time(time: Time) -> Fine {
        Fine(u128::from(time.0) << FRACTION_BITS)
    }

    #[inline]
    pub(crate) fn ceil(self) -> u64 {
        ((self.0 + ((1 << FRACTION_BITS) - 1)) >> FRACTION_BITS) as u64
    }

    #[inline]
    pub(crate) fn plus(self, ticks: u64, tick: Tick) -> Fine {
        Fine(self.0 + u128::from(ticks) * u128::from(tick.0))
    }

    /// Later by a span that was worked out once with [`Tick::span`].
    #[inline]
    pub(crate) fn after(self, span: u64) -> Fine {
        Fine(self.0 + u128::from(span))
    }

    #[inline]
    pub(crate) fn minus(self, ticks: u64, tick: Tick) -> Fine {
        Fine(self.0 - u128::from(ticks) * u128::from(tick.0))
    }

    /// True if this is later than `start` by less than one tick: the commonest case of [`Fine::ticks_since`], without a
    /// division.
    #[inline]
    pub(crate) fn is_within_first(self, start: Fine, tick: Tick) -> bool {
        self.0 < start.0 + u128::from(tick.0)
    }

    /// How many whole ticks lie between `start` and this; zero if this is not later.
    #[inline]
    pub(crate) fn ticks_since(self, start: Fine, tick: Tick) -> u64 {
        let span = self.0.saturating_sub(start.0);
        match u64::try_from(span) {
            Ok(span) => span / tick.0,
            Err(_) => (span / u128::from(tick.0)) as u64,
        }
    }

    /// The span since `earlier` in units of 2^-32 ps; `None` if that is later.
    #[inline]
    pub(crate) fn checked_since(self, earlier: Fine) -> Option<u128> {
        self.0.checked_sub(earlier.0)
    }
}

/// The length of a clock period or time quantum in units of 2^-32 ps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) struct Tick(pub(crate) u64);

impl Tick {
    /// One picosecond.
    pub(crate) const PICOSECOND: u64 = 1 << FRACTION_BITS;

    /// The period of a clock of `hz` that is `ppm` too fast.
    pub(crate) fn of_clock(hz: u32, ppm: i32) -> Tick {
        let scaled = u128::from(hz) * (1_000_000 + i128::from(ppm)).unsigned_abs();
        let second_scaled = 1_000_000_000_000_000_000u128 << FRACTION_BITS;
        Tick(((second_scaled + scaled / 2) / scaled) as u64)
    }

    /// So many ticks as one span; a bit lasts at most 2 ms, which fits.
    pub(crate) fn span(self, ticks: u64) -> u64 {
        self.0 * ticks
    }

    pub(crate) fn times(self, prescaler: u16) -> Tick {
        Tick(self.0 * u64::from(prescaler))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_that_is_off_keeps_its_average_frequency() {
        let tick = Tick::of_clock(40_000_000, 5_000);
        let after = Fine::default().plus(40_200_000_000, tick);
        assert!(after.ceil().abs_diff(1_000_000_000_000_000) <= 10, "{} ps", after.ceil());
        assert_eq!(Tick::of_clock(40_000_000, 0).0, 25_000 * Tick::PICOSECOND);
    }

    #[test]
    fn ticks_are_counted_down_to_the_grid() {
        let tick = Tick::of_clock(10_000_000, 0);
        let start = Fine::from_time(Time::from_ns(50));
        let later = Fine::from_time(Time::from_ns(399));
        assert_eq!(later.ticks_since(start, tick), 3);
        assert_eq!(start.ticks_since(later, tick), 0);
    }
}
