//! Bit timing: from clock, bit rate and sample point to the segments of a bit, and to register values.
//!
//! Everything here works in a `const`: a timing that is impossible is a compile error, and a firmware carries nothing but
//! the register words.
//!
//! ```
//! use can_hal::timing::{MCanTiming, Request, SamplePoint};
//!
//! const REQUEST: Request = Request::new(40_000_000, 500_000).data(2_000_000).data_sample_point(SamplePoint::percent(75));
//! const TIMING: MCanTiming = MCanTiming::fixed(&REQUEST);
//!
//! assert_eq!(TIMING.nbtp.ntseg1(), 68); // 70 quanta before the sample point, with the synchronization segment
//! assert_eq!(TIMING.tdcr.tdco(), 15); // the data sample point, in clock periods
//! ```
//!
//! ```compile_fail
//! # use can_hal::timing::{MCanTiming, Request};
//! const TIMING: MCanTiming = MCanTiming::fixed(&Request::new(40_000_000, 300_000)); // 40 MHz is no multiple of 300 kbit/s
//! # assert_eq!(TIMING.nbtp.ntseg1(), 0);
//! ```
//!
//! # What is chosen
//!
//! - Of all solutions the one with the smallest bit-rate error, of those the one with the smallest sample-point error, of
//!   those the one with the lowest prescaler (dsPIC33 CAN FD 5.3.7: short quanta). With a data phase, equal prescalers win
//!   over lower ones where nothing is lost by it (5.3.7: identical quanta in both phases).
//! - A deviation of the bit rate has to be asked for ([`Request::within_ppm`]), otherwise only exact solutions count: the
//!   ECAN manual (6.4) and the PIC32 manual (34.10.4.1) demand whole multiples.
//! - Sample points: [`SamplePoint::recommended`].
//! - Jump width: [`JumpWidth`]; transmitter delay compensation: [`Compensation`]; propagation segment: [`Propagation`].
//!
//! # Units
//!
//! Clock in hertz, bit rates in bit/s, sample points in hundredths of a percent of the bit time, errors in ppm of what was
//! requested, segments in time quanta, the delay compensation in periods of the CAN clock.

mod error;
mod limits;
mod registers;
mod request;
mod search;
mod solution;
mod solver;
mod tolerance;

pub use error::{Bound, Nearest, Phase, RequestFault, SegmentFault, TimingError};
pub use limits::{DelayLimits, FieldRange, Limits, OffsetReference, PhaseLimits};
pub use registers::{DsPic33CanFdTiming, DsPic33EcanTiming, MCanTiming, Pic32CanTiming};
pub use request::{Compensation, JumpWidth, PhaseRequest, Prescalers, Propagation, Request, SamplePoint};
pub use solution::{BitRate, PhaseReport, Solution};
pub use tolerance::Tolerance;

/// The parts of a bit, as numbers of time quanta, not as register values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Segments {
    /// Clock periods in a time quantum, a fixed divider in front of the prescaler not counted.
    pub prescaler: u32,
    /// Propagation segment. Controllers without a field of its own take it together with phase segment 1.
    pub propagation: u32,
    /// Phase segment 1.
    pub phase1: u32,
    /// Phase segment 2.
    pub phase2: u32,
    /// Synchronization jump width.
    pub jump_width: u32,
}

impl Segments {
    /// Length of the synchronization segment in time quanta (ISO 11898-1).
    pub const SYNC: u32 = 1;

    /// Time quanta in a bit.
    #[must_use]
    pub const fn quanta(&self) -> u32 {
        self.before_sample() + self.phase2
    }

    /// Time quanta from the start of the bit to the sample point.
    #[must_use]
    pub const fn before_sample(&self) -> u32 {
        Self::SYNC + self.propagation + self.phase1
    }

    /// The sample point.
    #[must_use]
    pub const fn sample_point(&self) -> SamplePoint {
        SamplePoint::of(self.before_sample(), self.quanta())
    }

    /// The bit rate, from the clock in hertz and the fixed divider in front of the prescaler.
    #[must_use]
    pub const fn bit_rate(&self, clock: u32, divider: u32) -> BitRate {
        BitRate::new(clock, divider as u64 * self.prescaler as u64 * self.quanta() as u64)
    }
}

/// Transmitter delay compensation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DelayCompensation {
    /// From the measured delay to the secondary sample point, in clock periods.
    pub offset: u32,
    /// Smallest position of the secondary sample point, in clock periods; 0 for none.
    pub filter: u32,
}

/// The data phase of CAN FD frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DataPhase {
    /// The parts of a bit.
    pub segments: Segments,
    /// Transmitter delay compensation, where it is needed.
    pub compensation: Option<DelayCompensation>,
}

/// The bit timing of a controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BitTiming {
    /// Arbitration phase, and all of a classic frame.
    pub nominal: Segments,
    /// Data phase of frames with bit-rate switch.
    pub data: Option<DataPhase>,
    /// Every bit is sampled three times and the majority counts. ECAN and PIC32 CAN only.
    pub three_samples: bool,
}
