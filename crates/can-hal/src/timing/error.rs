//! What can be wrong with a request or a timing.

use core::fmt;

use super::{BitRate, SamplePoint};

/// Arbitration phase or data phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Phase {
    /// Arbitration phase, and all of a classic frame.
    Nominal,
    /// Data phase of a CAN FD frame with bit-rate switch.
    Data,
}

impl Phase {
    /// In words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nominal => "nominal phase",
            Self::Data => "data phase",
        }
    }
}

/// The limit that was hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bound {
    /// The bit would be shorter than the fewest quanta with the smallest prescaler.
    ShortestBit,
    /// The bit would be longer than the most quanta with the largest prescaler.
    LongestBit,
    /// The clock is no whole multiple of the bit rate, or not one that prescaler and quanta can make.
    Divisor,
    /// Highest bit rate that the manual allows.
    BitRate,
    /// Range of the prescaler.
    Prescaler,
    /// Both phases need the same prescaler.
    EqualPrescalers,
    /// Range of the propagation segment, or a bit that is too short for it.
    Propagation,
    /// Range of phase segment 1.
    Phase1,
    /// Range of phase segment 2.
    Phase2,
    /// Phase segment 2 is too long for the segments before it.
    Phase2WithinPhase1,
    /// Number of quanta in a bit.
    Quanta,
    /// Range of the jump width, or a phase segment shorter than it.
    JumpWidth,
    /// Prescaler too small for sampling three times, or a controller that does not.
    ThreeSamples,
    /// The controller has no data phase.
    NoDataPhase,
    /// The data bit rate is below the nominal one.
    DataBelowNominal,
    /// The controller has no transmitter delay compensation.
    NoCompensation,
    /// Prescaler of the data phase with transmitter delay compensation.
    CompensatedPrescaler,
    /// Range of the offset of the compensation.
    CompensationOffset,
    /// Range of the filter window of the compensation.
    CompensationFilter,
    /// Delay and offset come to more data bits than the compensation can span.
    CompensationSpan,
}

impl Bound {
    /// In words.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::ShortestBit => "the bit is shorter than the fewest time quanta with the smallest prescaler",
            Self::LongestBit => "the bit is longer than the most time quanta with the largest prescaler",
            Self::Divisor => "no prescaler and number of time quanta divide the clock to this rate",
            Self::BitRate => "the rate is above the highest that the manual allows",
            Self::Prescaler => "the prescaler is out of range",
            Self::EqualPrescalers => "no prescaler serves both phases",
            Self::Propagation => "the propagation segment is out of range or leaves no room in the bit",
            Self::Phase1 => "phase segment 1 is out of range",
            Self::Phase2 => "phase segment 2 is out of range",
            Self::Phase2WithinPhase1 => "phase segment 2 is longer than the segments before it allow",
            Self::Quanta => "the number of time quanta in a bit is out of range",
            Self::JumpWidth => "the jump width is out of range or longer than a phase segment",
            Self::ThreeSamples => "sampling three times is not possible, or not with this prescaler",
            Self::NoDataPhase => "the controller has no data phase",
            Self::DataBelowNominal => "the data bit rate is below the nominal bit rate",
            Self::NoCompensation => "the controller has no transmitter delay compensation",
            Self::CompensatedPrescaler => "the data prescaler is too large for transmitter delay compensation",
            Self::CompensationOffset => "the offset of the transmitter delay compensation is out of range",
            Self::CompensationFilter => "the filter window of the transmitter delay compensation is out of range",
            Self::CompensationSpan => "the loop delay and the offset come to more data bits than can be compensated",
        }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

/// Segments that a controller does not allow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SegmentFault {
    /// Of which phase.
    pub phase: Phase,
    /// The limit.
    pub bound: Bound,
}

impl fmt::Display for SegmentFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.phase.name(), self.bound)
    }
}

impl core::error::Error for SegmentFault {}

/// The possible bit rates next to one that is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Nearest {
    /// The next lower one, or the very one.
    pub below: Option<BitRate>,
    /// The next higher one, or the very one.
    pub above: Option<BitRate>,
}

/// A request that makes no sense by itself, whatever the clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RequestFault {
    /// A clock of 0 Hz.
    NoClock,
    /// The clock is faster than the controller allows; the limit in hertz.
    ClockTooFast(u32),
    /// A bit rate of 0 bit/s.
    NoBitRate,
}

/// Why there is no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TimingError {
    /// The request itself.
    Request(RequestFault),
    /// The bit rate.
    BitRate {
        /// Of which phase.
        phase: Phase,
        /// The limit that was hit.
        bound: Bound,
        /// What was requested, in bit/s.
        requested: u32,
        /// What is possible instead.
        nearest: Nearest,
    },
    /// The sample point is further off than allowed.
    SamplePoint {
        /// Of which phase.
        phase: Phase,
        /// What was requested.
        requested: SamplePoint,
        /// The nearest possible one at the best bit rate.
        nearest: SamplePoint,
    },
    /// A limit that has nothing to do with the rate.
    Limit(SegmentFault),
}

impl TimingError {
    /// In words, without numbers: the message of a compile error.
    #[must_use]
    pub const fn text(&self) -> &'static str {
        match self {
            Self::Request(RequestFault::NoClock) => "the clock is 0 Hz",
            Self::Request(RequestFault::ClockTooFast(_)) => "the clock is faster than the controller allows",
            Self::Request(RequestFault::NoBitRate) => "the bit rate is 0 bit/s",
            Self::BitRate { bound, .. } | Self::Limit(SegmentFault { bound, .. }) => bound.text(),
            Self::SamplePoint { .. } => "no sample point is near enough to the requested one",
        }
    }
}

impl fmt::Display for TimingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Request(RequestFault::ClockTooFast(max)) => {
                write!(f, "{}: {max} Hz at most", self.text())
            }
            Self::Request(_) => f.write_str(self.text()),
            Self::BitRate { phase, bound, requested, nearest } => {
                write!(f, "{} of {requested} bit/s: {bound}", phase.name())?;
                match (nearest.below, nearest.above) {
                    (Some(below), Some(above)) if below == above => write!(f, "; possible is {below}"),
                    (Some(below), Some(above)) => write!(f, "; the nearest are {below} and {above}"),
                    (Some(one), None) | (None, Some(one)) => write!(f, "; the nearest is {one}"),
                    (None, None) => Ok(()),
                }
            }
            Self::SamplePoint { phase, requested, nearest } => {
                write!(f, "{}: sample point {requested} is out of reach; the nearest is {nearest}", phase.name())
            }
            Self::Limit(fault) => write!(f, "{fault}"),
        }
    }
}

impl core::error::Error for TimingError {}
