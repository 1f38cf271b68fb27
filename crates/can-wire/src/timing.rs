//! Bit timing (ISO 11898-1:2015, 11.3 "Bit timing and synchronization").

use core::fmt;

use crate::Time;

/// One bit time in time quanta: a synchronization segment of one quantum, then the segments below.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BitTiming {
    /// Periods of the node's clock per time quantum.
    pub prescaler: u16,
    /// Propagation segment, in time quanta. Registers that know only one value for the time before the sample point
    /// put it into `phase_seg1` and leave this at 0.
    pub prop_seg: u16,
    /// Phase segment 1, in time quanta.
    pub phase_seg1: u16,
    /// Phase segment 2, in time quanta.
    pub phase_seg2: u16,
    /// Synchronization jump width, in time quanta.
    pub sjw: u16,
}

/// Why a bit timing cannot work in any controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TimingError {
    /// A clock frequency of zero or beyond 1 GHz, or a tolerance of 10 % or more.
    Clock {
        /// Nominal frequency in hertz.
        hz: u32,
        /// Deviation in parts per million.
        ppm: i32,
    },
    /// A segment, the prescaler or the jump width is zero or larger than any controller has it.
    Segment {
        /// Which one.
        name: &'static str,
        /// The value given.
        value: u16,
        /// The smallest value that works.
        min: u16,
        /// The largest value that is taken.
        max: u16,
    },
    /// The bit is longer than 2 ms, below every bit rate CAN is used at.
    TooSlow {
        /// The length of one bit.
        bit: Time,
    },
    /// No prescaler and number of quanta give this bit rate exactly.
    NoTiming {
        /// Clock frequency in hertz.
        hz: u32,
        /// Bit rate in bit/s.
        rate: u32,
    },
}

impl fmt::Display for TimingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            TimingError::Clock { hz, ppm } => write!(f, "no usable clock: {hz} Hz {ppm:+} ppm"),
            TimingError::Segment {
                name,
                value,
                min,
                max,
            } => write!(f, "{name} is {value}, but must be {min} to {max}"),
            TimingError::TooSlow { bit } => write!(f, "one bit takes {bit}, longer than 2000 us"),
            TimingError::NoTiming { hz, rate } => {
                write!(f, "{rate} bit/s cannot be made exactly from {hz} Hz")
            }
        }
    }
}

impl std::error::Error for TimingError {}

const MAX_PRESCALER: u16 = 1024;
const MAX_SEGMENT: u16 = 1024;

impl BitTiming {
    /// Time quanta from the start of a bit to its sample point.
    #[must_use]
    pub const fn sample_quanta(&self) -> u64 {
        1 + self.prop_seg as u64 + self.phase_seg1 as u64
    }

    /// Time quanta of one bit.
    #[must_use]
    pub const fn quanta(&self) -> u64 {
        self.sample_quanta() + self.phase_seg2 as u64
    }

    /// The bit rate in bit/s that a clock of `hz` gives, rounded down.
    #[must_use]
    pub const fn bit_rate(&self, hz: u32) -> u32 {
        (hz as u64 / (self.prescaler as u64 * self.quanta())) as u32
    }

    /// Position of the sample point within the bit, in thousandths.
    #[must_use]
    pub const fn sample_point_permille(&self) -> u32 {
        (self.sample_quanta() * 1000 / self.quanta()) as u32
    }

    /// A timing for exactly `rate` bit/s from a clock of `hz`, its sample point as near to `permille` thousandths as
    /// possible, with the smallest prescaler (most quanta, up to 400) and the largest jump width (up to 128). Half of
    /// the time before the sample point is propagation segment.
    ///
    /// # Errors
    /// [`TimingError::NoTiming`] if no whole number of quanta, at least 4, makes the rate.
    pub fn for_rate(hz: u32, rate: u32, permille: u32) -> Result<BitTiming, TimingError> {
        let none = TimingError::NoTiming { hz, rate };
        for prescaler in 1..=MAX_PRESCALER {
            let quantum_rate = u64::from(rate) * u64::from(prescaler);
            if rate == 0 || !u64::from(hz).is_multiple_of(quantum_rate) {
                continue;
            }
            let quanta = u64::from(hz) / quantum_rate;
            if quanta > 400 {
                continue;
            }
            if quanta < 4 {
                break;
            }
            let sample = (quanta * u64::from(permille) + 500) / 1000;
            let sample = sample.clamp(2, quanta - 1);
            let before = (sample - 1) as u16;
            let phase_seg2 = (quanta - sample) as u16;
            let phase_seg1 = before.div_ceil(2).max(phase_seg2.min(before));
            let sjw = phase_seg1.min(phase_seg2).min(128);
            return Ok(BitTiming {
                prescaler,
                prop_seg: before - phase_seg1,
                phase_seg1,
                phase_seg2,
                sjw,
            });
        }
        Err(none)
    }

    /// Checks what no controller can do. A jump width beyond the phase segments is not refused: controllers accept it
    /// too, and a node with it behaves as it would in silicon.
    ///
    /// # Errors
    /// [`TimingError::Segment`] with the value that is out of range.
    pub fn check(&self) -> Result<(), TimingError> {
        let range = |name, value, min, max| {
            if (min..=max).contains(&value) {
                Ok(())
            } else {
                Err(TimingError::Segment {
                    name,
                    value,
                    min,
                    max,
                })
            }
        };
        range("prescaler", self.prescaler, 1, MAX_PRESCALER)?;
        range("prop_seg", self.prop_seg, 0, MAX_SEGMENT)?;
        range(
            "phase_seg1",
            self.phase_seg1,
            u16::from(self.prop_seg == 0),
            MAX_SEGMENT,
        )?;
        range("phase_seg2", self.phase_seg2, 1, MAX_SEGMENT)?;
        range("sjw", self.sjw, 1, MAX_SEGMENT)
    }

    /// The largest deviation of every node's clock, in ppm, at which classic frames still arrive: the conditions that
    /// a resynchronization over ten bits and the sampling of the bit after an error flag put on the timing.
    ///
    /// ```text
    /// df <= SJW / (20 * NBT)        df <= min(PS1, PS2) / (2 * (13 * NBT - PS2))
    /// ```
    #[must_use]
    pub fn tolerance_ppm(&self) -> u32 {
        let bit = self.quanta();
        let phase = u64::from(self.phase_seg1.min(self.phase_seg2));
        let resync = ppm(i128::from(self.sjw), u128::from(20 * bit));
        let error_flag = ppm(
            i128::from(phase),
            u128::from(2 * (13 * bit - u64::from(self.phase_seg2))),
        );
        resync.min(error_flag)
    }

    /// The largest deviation of every node's clock, in ppm, for FD frames with bit-rate switch: the two conditions of
    /// [`BitTiming::tolerance_ppm`] and the three for the data phase.
    #[must_use]
    pub fn tolerance_with_data_ppm(&self, data: &BitTiming) -> u32 {
        let (nominal_bit, data_bit) = (
            i128::from(self.quanta() as u32),
            i128::from(data.quanta() as u32),
        );
        let (nbrp, dbrp) = (i128::from(self.prescaler), i128::from(data.prescaler));
        let (n_seg2, d_seg2) = (i128::from(self.phase_seg2), i128::from(data.phase_seg2));
        let phase = i128::from(self.phase_seg1.min(self.phase_seg2));
        let resync = ppm(i128::from(data.sjw), (20 * data_bit).unsigned_abs());
        // Both sides of the remaining two are multiplied by the prescaler in their denominators.
        let switch = ppm(
            phase * nbrp,
            (2 * ((6 * data_bit - d_seg2) * dbrp + 7 * nominal_bit * nbrp)).unsigned_abs(),
        );
        let jump = i128::from(data.sjw) * dbrp - (nbrp - dbrp).max(0);
        let back = ppm(
            jump,
            (2 * ((2 * nominal_bit - n_seg2) * nbrp + (d_seg2 + 4 * data_bit) * dbrp))
                .unsigned_abs(),
        );
        self.tolerance_ppm().min(resync).min(switch).min(back)
    }
}

fn ppm(numerator: i128, denominator: u128) -> u32 {
    (numerator.max(0).unsigned_abs() * 1_000_000 / denominator.max(1)) as u32
}

/// Transmitter delay compensation (ISO 11898-1:2015, 11.3.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DelayCompensation {
    /// Where the delay comes from.
    pub delay: DelaySource,
    /// Offset added to the delay to get the secondary sample point, in clock periods.
    pub offset: i16,
    /// The secondary sample point is never later than this after the start of its bit, in clock periods; the width of
    /// the counter in the controller. Often 127.
    pub limit: u16,
}

/// Where the transmitter delay comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DelaySource {
    /// Measured in every FD frame from the edge between FDF and res on the transmit output to the same edge on the
    /// receive input.
    Measured {
        /// Edges that would give a secondary sample point earlier than this many clock periods are ignored: the filter
        /// window against glitches. 0 takes every edge.
        filter: u16,
    },
    /// Set by software, in clock periods.
    Fixed(u16),
}

impl DelayCompensation {
    /// Measured delay plus `offset` clock periods, a limit of 127, no filter window.
    #[must_use]
    pub const fn measured(offset: i16) -> DelayCompensation {
        DelayCompensation {
            delay: DelaySource::Measured { filter: 0 },
            offset,
            limit: 127,
        }
    }

    /// The secondary sample point for a delay, both in clock periods.
    pub(crate) fn secondary_sample_point(&self, delay: u64) -> u64 {
        (delay as i64 + i64::from(self.offset)).clamp(0, i64::from(self.limit)) as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 500 kbit/s and 2 Mbit/s at 80 MHz with sample points at 80 %, as the dsPIC33 CAN FD manual computes it: its
    /// tables print 0.78 % as the result of all five conditions.
    #[test]
    fn the_worked_example_of_a_manual() {
        let nominal = BitTiming {
            prescaler: 1,
            prop_seg: 95,
            phase_seg1: 32,
            phase_seg2: 32,
            sjw: 32,
        };
        let data = BitTiming {
            prescaler: 1,
            prop_seg: 23,
            phase_seg1: 8,
            phase_seg2: 8,
            sjw: 8,
        };
        assert_eq!(
            (nominal.bit_rate(80_000_000), data.bit_rate(80_000_000)),
            (500_000, 2_000_000)
        );
        assert_eq!(
            (
                nominal.sample_point_permille(),
                data.sample_point_permille()
            ),
            (800, 800)
        );
        assert_eq!(nominal.tolerance_ppm(), 7_812);
        assert_eq!(nominal.tolerance_with_data_ppm(&data), 7_812);
    }

    #[test]
    fn timings_for_a_rate() {
        let timing = BitTiming::for_rate(40_000_000, 1_000_000, 800).expect("divides");
        assert_eq!(
            (timing.prescaler, timing.quanta(), timing.sample_quanta()),
            (1, 40, 32)
        );
        assert_eq!(timing.check(), Ok(()));
        let slow = BitTiming::for_rate(80_000_000, 10_000, 875).expect("divides");
        assert_eq!(
            (
                slow.bit_rate(80_000_000),
                slow.prescaler,
                slow.sample_point_permille()
            ),
            (10_000, 20, 875)
        );
        let error = BitTiming::for_rate(8_000_000, 3_000_000, 800).expect_err("2.67 quanta");
        assert_eq!(
            error,
            TimingError::NoTiming {
                hz: 8_000_000,
                rate: 3_000_000
            }
        );
    }

    #[test]
    fn segments_of_zero_are_refused() {
        let good = BitTiming {
            prescaler: 1,
            prop_seg: 0,
            phase_seg1: 1,
            phase_seg2: 1,
            sjw: 1,
        };
        assert_eq!(good.check(), Ok(()));
        for (bad, name) in [
            (
                BitTiming {
                    prescaler: 0,
                    ..good
                },
                "prescaler",
            ),
            (
                BitTiming {
                    phase_seg1: 0,
                    ..good
                },
                "phase_seg1",
            ),
            (
                BitTiming {
                    phase_seg2: 0,
                    ..good
                },
                "phase_seg2",
            ),
            (BitTiming { sjw: 0, ..good }, "sjw"),
        ] {
            assert!(matches!(bad.check(), Err(TimingError::Segment { name: n, .. }) if n == name));
        }
    }
}
