//! From a request to a solution: which phases, with or without compensation, with equal prescalers or not.

use super::search::{Interval, Search, equal, max, min, same};
use super::{
    BitTiming, Bound, Compensation, DataPhase, DelayCompensation, Limits, Nearest, Phase, PhaseLimits, PhaseReport,
    PhaseRequest, Prescalers, Propagation, Request, RequestFault, SegmentFault, Segments, Solution, TimingError,
    Tolerance,
};

/// Unwraps in a `const fn`, where `?` does not exist.
macro_rules! ok {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error),
        }
    };
}

impl Limits {
    /// Finds the best bit timing.
    ///
    /// # Errors
    ///
    /// The limit that was hit, with the nearest possible bit rates or sample point.
    pub const fn solve(&self, request: &Request) -> Result<Solution, TimingError> {
        if request.clock == 0 {
            return Err(TimingError::Request(RequestFault::NoClock));
        }
        if let Some(max) = self.max_clock
            && request.clock > max
        {
            return Err(TimingError::Request(RequestFault::ClockTooFast(max)));
        }
        let nominal = ok!(self.search(Phase::Nominal, request, &request.nominal, &self.nominal));
        let Some(data_request) = &request.data else {
            let best = ok!(nominal.solve(Phase::Nominal, request));
            return self.finish(request, nominal.segments(&best), None);
        };
        let Some(data_limits) = &self.data else { return Err(limit(Phase::Data, Bound::NoDataPhase)) };
        if data_request.bit_rate < request.nominal.bit_rate {
            return Err(limit(Phase::Data, Bound::DataBelowNominal));
        }
        let data = ok!(self.search(Phase::Data, request, data_request, data_limits));
        match self.compensated(request, data_request) {
            None => self.both(request, &nominal, &data, false),
            Some(needed) => {
                let Some(delay) = &self.delay else { return Err(limit(Phase::Data, Bound::NoCompensation)) };
                let least = data.prescalers.min;
                let slow = Search {
                    prescalers: Interval { min: least, max: min(data.prescalers.max, delay.max_prescaler) },
                    ..data
                };
                let with = self.both(request, &nominal, &slow, true);
                if needed {
                    return with;
                }
                let without = self.both(request, &nominal, &data, false);
                match (&with, &without) {
                    (Ok(with_it), Ok(without_it)) if !no_worse(with_it, without_it) => without,
                    (Err(_), Ok(_)) => without,
                    _ => with,
                }
            }
        }
    }

    /// The solution of a request that is known to have one: for a `const`, where an impossible request does not compile.
    ///
    /// # Panics
    ///
    /// If [`Self::solve`] finds nothing.
    #[must_use]
    #[track_caller]
    pub const fn fixed(&self, request: &Request) -> Solution {
        match self.solve(request) {
            Ok(solution) => solution,
            Err(error) => panic!("{}", error.text()),
        }
    }

    const fn search<'a>(
        &self,
        phase: Phase,
        request: &Request,
        wanted: &'a PhaseRequest,
        limits: &'a PhaseLimits,
    ) -> Result<Search<'a>, TimingError> {
        if wanted.bit_rate == 0 {
            return Err(TimingError::Request(RequestFault::NoBitRate));
        }
        let mut prescalers = Interval { min: limits.prescaler.min, max: limits.prescaler.max };
        let mut propagation = request.propagation;
        match phase {
            Phase::Nominal => {
                if request.three_samples {
                    match limits.three_samples_prescaler {
                        Some(least) => prescalers.min = max(prescalers.min, least),
                        None => return Err(limit(phase, Bound::ThreeSamples)),
                    }
                }
            }
            // dsPIC33 CAN FD 5.3.3: only one node transmits, so that propagation is no limit in the data phase.
            Phase::Data => propagation = Propagation::Longest,
        }
        if let Some(quanta) = wanted.quanta
            && (quanta < limits.min_quanta || quanta > limits.max_quanta)
        {
            return Err(limit(phase, Bound::Quanta));
        }
        let search =
            Search { limits, request: wanted, clock: request.clock, divider: self.divider, propagation, prescalers };
        if let Some(highest) = limits.max_bit_rate
            && wanted.bit_rate > highest
        {
            let at_most = PhaseRequest { bit_rate: highest, ..*wanted };
            let (_, nearest) = Search { request: &at_most, ..search }.run();
            return Err(search.failed(phase, Bound::BitRate, Nearest { above: None, ..nearest }));
        }
        Ok(search)
    }

    /// Whether the delay is to be compensated, and whether it has to be.
    const fn compensated(&self, request: &Request, data: &PhaseRequest) -> Option<bool> {
        /// dsPIC33 CAN FD 5.3.7.
        const RECOMMENDED_FROM: u32 = 1_000_000;
        match request.compensation {
            Compensation::Off => None,
            Compensation::On => Some(true),
            Compensation::Automatic => {
                // The sample point in nanoseconds, times 10 000 times the bit rate on both sides.
                let sample = data.target().get() as u128 * 1_000_000_000;
                let delay = request.loop_delay as u128 * data.bit_rate as u128 * 10_000;
                if self.delay.is_none() {
                    None
                } else if sample <= delay {
                    Some(true)
                } else if data.bit_rate >= RECOMMENDED_FROM {
                    Some(false)
                } else {
                    None
                }
            }
        }
    }

    /// Solves both phases.
    const fn both(
        &self,
        request: &Request,
        nominal: &Search<'_>,
        data: &Search<'_>,
        compensate: bool,
    ) -> Result<Solution, TimingError> {
        let alone = match (nominal.solve(Phase::Nominal, request), data.solve(Phase::Data, request)) {
            (Ok(n), Ok(d)) => (n, d),
            (Err(error), _) | (_, Err(error)) => return Err(error),
        };
        let (n, d) = match request.prescalers {
            Prescalers::Independent => alone,
            Prescalers::PreferEqual => match equal(nominal, data) {
                Some((n, d)) if same(&n, &alone.0) && same(&d, &alone.1) => (n, d),
                _ => alone,
            },
            Prescalers::Equal => match equal(nominal, data) {
                Some((n, d)) => {
                    let nothing = Nearest { below: None, above: None };
                    let accepted = (
                        nominal.accept(Phase::Nominal, request, &n, nothing),
                        data.accept(Phase::Data, request, &d, nothing),
                    );
                    match accepted {
                        (Ok(()), Ok(())) => (n, d),
                        _ => return Err(limit(Phase::Data, Bound::EqualPrescalers)),
                    }
                }
                None => return Err(limit(Phase::Data, Bound::EqualPrescalers)),
            },
        };
        let segments = data.segments(&d);
        let compensation = match (&self.delay, compensate) {
            (Some(limits), true) => {
                let offset = limits.offset_for(&segments);
                // M_CAN 3.1.4.1: delay and offset stay below the span of the compensation.
                let delay = (request.loop_delay as u64 * request.clock as u64).div_ceil(1_000_000_000);
                if let Some(bits) = limits.max_bits {
                    let span = bits as u64 * segments.prescaler as u64 * segments.quanta() as u64;
                    if delay + offset as u64 >= span {
                        return Err(limit(Phase::Data, Bound::CompensationSpan));
                    }
                }
                Some(DelayCompensation { offset, filter: 0 })
            }
            _ => None,
        };
        self.finish(request, nominal.segments(&n), Some(DataPhase { segments, compensation }))
    }

    const fn report(&self, request: &Request, segments: &Segments, wanted: &PhaseRequest) -> PhaseReport {
        PhaseReport::of(segments, request.clock, self.divider, wanted.bit_rate, wanted.target())
    }

    const fn finish(
        &self,
        request: &Request,
        nominal: Segments,
        data: Option<DataPhase>,
    ) -> Result<Solution, TimingError> {
        let timing = BitTiming { nominal, data, three_samples: request.three_samples };
        if let Err(fault) = self.check(&timing) {
            return Err(TimingError::Limit(fault));
        }
        Ok(Solution {
            timing,
            nominal: self.report(request, &nominal, &request.nominal),
            data: match (&data, &request.data) {
                (Some(data), Some(wanted)) => Some(self.report(request, &data.segments, wanted)),
                _ => None,
            },
            tolerance: Tolerance::of(&timing),
        })
    }
}

const fn limit(phase: Phase, bound: Bound) -> TimingError {
    TimingError::Limit(SegmentFault { phase, bound })
}

/// Whether a solution is as good as another in the data phase.
const fn no_worse(one: &Solution, other: &Solution) -> bool {
    match (&one.data, &other.data) {
        (Some(one), Some(other)) => {
            one.error_ppm.unsigned_abs() <= other.error_ppm.unsigned_abs()
                && one.sample_point_error.unsigned_abs() <= other.sample_point_error.unsigned_abs()
        }
        _ => true,
    }
}
