//! The search for one phase.
//!
//! It goes through the prescalers and takes for each the one or two numbers of quanta that bring the bit rate nearest: the
//! best pair of all is among them, because for its prescaler no other number of quanta comes nearer.

use regbus::meta::Phase2Within;

use super::{
    BitRate, Bound, JumpWidth, Nearest, Phase, PhaseLimits, PhaseRequest, Propagation, Request, SamplePoint, Segments,
    TimingError,
};

/// A fraction that is not negative.
#[derive(Clone, Copy)]
struct Error {
    numerator: u64,
    denominator: u64,
}

impl Error {
    const fn less(self, other: Self) -> bool {
        (self.numerator as u128) * (other.denominator as u128) < (other.numerator as u128) * (self.denominator as u128)
    }

    const fn same(self, other: Self) -> bool {
        !self.less(other) && !other.less(self)
    }
}

/// One phase with one prescaler and one number of quanta, and with the sample point nearest to the requested one.
#[derive(Clone, Copy)]
pub(super) struct Candidate {
    prescaler: u32,
    quanta: u32,
    phase2: u32,
    rate: Error,
    sample_point: Error,
}

impl Candidate {
    const fn better(&self, other: &Self) -> bool {
        if self.rate.less(other.rate) || other.rate.less(self.rate) {
            return self.rate.less(other.rate);
        }
        self.sample_point.less(other.sample_point)
    }
}

/// The numbers from `min` to `max`.
#[derive(Clone, Copy)]
pub(super) struct Interval {
    pub(super) min: u32,
    pub(super) max: u32,
}

impl Interval {
    /// `None` if it is empty.
    const fn checked(self) -> Option<Self> {
        if self.min <= self.max { Some(self) } else { None }
    }
}

pub(super) const fn min(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}

pub(super) const fn max(a: u32, b: u32) -> u32 {
    if a > b { a } else { b }
}

/// The search for one phase.
pub(super) struct Search<'a> {
    pub(super) limits: &'a PhaseLimits,
    pub(super) request: &'a PhaseRequest,
    pub(super) clock: u32,
    pub(super) divider: u32,
    pub(super) propagation: Propagation,
    /// Prescalers to try.
    pub(super) prescalers: Interval,
}

impl Search<'_> {
    /// The shortest propagation segment.
    const fn shortest_propagation(&self, prescaler: u32) -> u32 {
        let least = match self.limits.propagation {
            Some(range) => range.min,
            None => 0,
        };
        match self.propagation {
            Propagation::Longest => least,
            Propagation::Quanta(quanta) => quanta,
            Propagation::AtLeast(nanoseconds) => {
                let periods = (nanoseconds as u64 * self.clock as u64).div_ceil(1_000_000_000);
                let quanta = periods.div_ceil(self.divider as u64 * prescaler as u64);
                max(least, if quanta > u32::MAX as u64 { u32::MAX } else { quanta as u32 })
            }
        }
    }

    /// The longest propagation segment.
    const fn longest_propagation(&self) -> u32 {
        match (self.propagation, self.limits.propagation) {
            (Propagation::Quanta(quanta), _) => quanta,
            (_, Some(range)) => range.max,
            (_, None) => u32::MAX,
        }
    }

    /// The limits of phase segment 1 in a bit with so many quanta between the synchronization segment and the sample point.
    const fn phase1(&self, prescaler: u32, before: u32) -> Interval {
        let shortest = self.shortest_propagation(prescaler);
        let longest = self.longest_propagation();
        let (least, most) = match self.limits.propagation {
            Some(_) => (self.limits.phase1.min, self.limits.phase1.max),
            // The field holds both segments: its limits are those of `before`.
            None => (1, u32::MAX),
        };
        Interval { min: max(least, before.saturating_sub(longest)), max: min(most, before.saturating_sub(shortest)) }
    }

    /// Shortest and longest time between the synchronization segment and the sample point; `None` if there is none.
    const fn before(&self, prescaler: u32) -> Option<Interval> {
        let limits = self.limits;
        let shortest = self.shortest_propagation(prescaler);
        let interval = match limits.propagation {
            Some(range) => {
                if !range.contains(shortest) {
                    return None;
                }
                let longest = min(self.longest_propagation(), range.max);
                Interval { min: shortest + limits.phase1.min, max: longest + limits.phase1.max }
            }
            None => Interval { min: max(limits.phase1.min, shortest.saturating_add(1)), max: limits.phase1.max },
        };
        interval.checked()
    }

    /// How many quanta a bit can have; `None` if no number fits.
    const fn quanta(&self, prescaler: u32) -> Option<Interval> {
        let limits = self.limits;
        let Some(before) = self.before(prescaler) else { return None };
        let shortest = self.shortest_propagation(prescaler);
        let (least, most) = match limits.phase2_within {
            Phase2Within::Anything => (before.min, limits.phase2.max),
            Phase2Within::Phase1 => (
                max(before.min, shortest.saturating_add(limits.phase2.min)),
                min(limits.phase2.max, self.phase1(prescaler, before.max).max),
            ),
            Phase2Within::PropagationAndPhase1 => {
                (max(before.min, limits.phase2.min), min(limits.phase2.max, before.max))
            }
        };
        let mut interval = Interval {
            min: max(limits.min_quanta, Segments::SYNC.saturating_add(least).saturating_add(limits.phase2.min)),
            max: min(limits.max_quanta, Segments::SYNC + before.max + most),
        };
        if let Some(fixed) = self.request.quanta {
            interval = Interval { min: max(interval.min, fixed), max: min(interval.max, fixed) };
        }
        interval.checked()
    }

    /// What phase segment 2 can be in a bit of so many quanta; `None` if nothing.
    const fn phase2(&self, prescaler: u32, quanta: u32) -> Option<Interval> {
        let limits = self.limits;
        let Some(before) = self.before(prescaler) else { return None };
        let rest = quanta - Segments::SYNC;
        let within = match limits.phase2_within {
            Phase2Within::Anything => u32::MAX,
            // phase2 <= phase1 <= rest - phase2 - shortest propagation, and phase1 has a limit of its own.
            Phase2Within::Phase1 => {
                min(rest.saturating_sub(self.shortest_propagation(prescaler)) / 2, limits.phase1.max)
            }
            Phase2Within::PropagationAndPhase1 => rest / 2,
        };
        let interval = Interval {
            min: max(limits.phase2.min, rest.saturating_sub(before.max)),
            max: min(min(limits.phase2.max, rest.saturating_sub(before.min)), within),
        };
        interval.checked()
    }

    /// The best for a prescaler and a number of quanta.
    const fn at(&self, prescaler: u32, quanta: u32) -> Option<Candidate> {
        let Some(interval) = self.phase2(prescaler, quanta) else { return None };
        let target = self.request.target().get() as u64;
        // An early sample point wins over an equally late one, so the longer phase segment 2 is tried first.
        let long = (quanta as u64 * (10_000 - target)).div_ceil(10_000) as u32;
        let long = max(min(long, interval.max), interval.min);
        let short = if long > interval.min { long - 1 } else { long };
        let (first, second) = (self.with_phase2(prescaler, quanta, long), self.with_phase2(prescaler, quanta, short));
        Some(if second.sample_point.less(first.sample_point) { second } else { first })
    }

    const fn with_phase2(&self, prescaler: u32, quanta: u32, phase2: u32) -> Candidate {
        let periods = self.divider as u64 * prescaler as u64 * quanta as u64;
        let target = self.request.target().get() as u64;
        Candidate {
            prescaler,
            quanta,
            phase2,
            rate: Error {
                numerator: (self.clock as u64).abs_diff(periods * self.request.bit_rate as u64),
                denominator: periods,
            },
            sample_point: Error {
                numerator: ((quanta - phase2) as u64 * 10_000).abs_diff(target * quanta as u64),
                denominator: quanta as u64,
            },
        }
    }

    /// The numbers of quanta that bring the bit rate nearest from above and from below.
    const fn nearest_quanta(&self, prescaler: u32) -> Option<Interval> {
        let Some(possible) = self.quanta(prescaler) else { return None };
        let per_quantum = self.divider as u64 * prescaler as u64 * self.request.bit_rate as u64;
        let low = self.clock as u64 / per_quantum;
        let low = if low > possible.max as u64 { possible.max } else { max(low as u32, possible.min) };
        Some(Interval { min: low, max: min(low + 1, possible.max) })
    }

    /// The best for a prescaler.
    const fn at_prescaler(&self, prescaler: u32) -> Option<Candidate> {
        let Some(quanta) = self.nearest_quanta(prescaler) else { return None };
        match (self.at(prescaler, quanta.min), self.at(prescaler, quanta.max)) {
            (Some(a), Some(b)) => Some(if b.better(&a) { b } else { a }),
            (Some(one), None) | (None, Some(one)) => Some(one),
            (None, None) => None,
        }
    }

    /// The best of all, and the bit rates next to the requested one.
    pub(super) const fn run(&self) -> (Option<Candidate>, Nearest) {
        let mut best: Option<Candidate> = None;
        let mut nearest = Nearest { below: None, above: None };
        let mut prescaler = self.prescalers.min;
        while prescaler <= self.prescalers.max {
            if let Some(candidate) = self.at_prescaler(prescaler) {
                match best {
                    Some(known) if !candidate.better(&known) => {}
                    _ => best = Some(candidate),
                }
            }
            self.note(&mut nearest, prescaler);
            // Every larger prescaler makes the bit longer still.
            let shortest = self.divider as u64 * prescaler as u64 * self.limits.min_quanta as u64;
            if shortest * self.request.bit_rate as u64 > self.clock as u64 {
                break;
            }
            prescaler += 1;
        }
        (best, nearest)
    }

    /// Notes the rates next to the requested one that a prescaler can make.
    const fn note(&self, nearest: &mut Nearest, prescaler: u32) {
        let Some(around) = self.nearest_quanta(prescaler) else { return };
        let mut quanta = around.min;
        while quanta <= around.max {
            if self.at(prescaler, quanta).is_some() {
                let periods = self.divider as u64 * prescaler as u64 * quanta as u64;
                let rate = BitRate::new(self.clock, periods);
                // A longer bit is a lower rate.
                let exact = periods * self.request.bit_rate as u64;
                if exact >= self.clock as u64 && matches_better(nearest.below, periods, true) {
                    nearest.below = Some(rate);
                }
                if exact <= self.clock as u64 && self.allowed(rate) && matches_better(nearest.above, periods, false) {
                    nearest.above = Some(rate);
                }
            }
            quanta += 1;
        }
    }

    const fn allowed(&self, rate: BitRate) -> bool {
        match self.limits.max_bit_rate {
            Some(limit) => rate.periods() * limit as u64 >= self.clock as u64,
            None => true,
        }
    }

    /// Whether the propagation segment was asked for, so that it may be what makes the bit too long.
    const fn propagation_decides(&self) -> bool {
        !matches!(self.propagation, Propagation::Longest)
    }

    /// Why the requested rate cannot be made.
    const fn bound(&self, nearest: &Nearest) -> Bound {
        match (nearest.below, nearest.above) {
            (Some(_), Some(_)) => Bound::Divisor,
            (Some(_), None) if self.propagation_decides() => Bound::Propagation,
            (Some(_), None) => Bound::ShortestBit,
            (None, Some(_)) => Bound::LongestBit,
            (None, None) => Bound::Propagation,
        }
    }

    pub(super) const fn failed(&self, phase: Phase, bound: Bound, nearest: Nearest) -> TimingError {
        TimingError::BitRate { phase, bound, requested: self.request.bit_rate, nearest }
    }

    /// The best, if it keeps to what the request allows.
    pub(super) const fn solve(&self, phase: Phase, request: &Request) -> Result<Candidate, TimingError> {
        let (best, nearest) = self.run();
        let Some(best) = best else { return Err(self.failed(phase, self.bound(&nearest), nearest)) };
        match self.accept(phase, request, &best, nearest) {
            Ok(()) => Ok(best),
            Err(error) => Err(error),
        }
    }

    pub(super) const fn accept(
        &self,
        phase: Phase,
        request: &Request,
        candidate: &Candidate,
        nearest: Nearest,
    ) -> Result<(), TimingError> {
        let rate = candidate.rate;
        // The error is a fraction of the requested rate.
        let error = rate.numerator as u128 * 1_000_000;
        let allowed = rate.denominator as u128 * self.request.bit_rate as u128 * request.max_error_ppm as u128;
        if error > allowed {
            return Err(self.failed(phase, self.bound(&nearest), nearest));
        }
        let made = BitRate::new(self.clock, rate.denominator);
        if let Some(limit) = self.limits.max_bit_rate
            && !self.allowed(made)
            && self.request.bit_rate <= limit
        {
            return Err(self.failed(phase, Bound::BitRate, nearest));
        }
        let point = candidate.sample_point;
        if point.numerator > point.denominator * request.max_sample_point_error as u64 {
            return Err(TimingError::SamplePoint {
                phase,
                requested: self.request.target(),
                nearest: SamplePoint::of(candidate.quanta - candidate.phase2, candidate.quanta),
            });
        }
        Ok(())
    }

    /// The segments of a candidate.
    pub(super) const fn segments(&self, candidate: &Candidate) -> Segments {
        let before = candidate.quanta - candidate.phase2 - Segments::SYNC;
        let possible = self.phase1(candidate.prescaler, before);
        let phase1 = match self.propagation {
            // At least as long as phase segment 2, so that neither tolerance nor jump width suffer.
            Propagation::Longest | Propagation::AtLeast(_) => min(max(candidate.phase2, possible.min), possible.max),
            Propagation::Quanta(_) => possible.max,
        };
        let longest = self.limits.longest_jump_width(phase1, candidate.phase2);
        let jump_width = match self.request.jump_width {
            JumpWidth::Largest => longest,
            JumpWidth::HalfPhase2 => max(1, min(longest, candidate.phase2 / 2)),
            JumpWidth::Quanta(quanta) => quanta,
        };
        Segments {
            prescaler: candidate.prescaler,
            propagation: before - phase1,
            phase1,
            phase2: candidate.phase2,
            jump_width,
        }
    }
}

/// Whether a rate is nearer than the one known so far.
const fn matches_better(known: Option<BitRate>, periods: u64, below: bool) -> bool {
    match known {
        None => true,
        Some(known) => {
            if below {
                periods < known.periods()
            } else {
                periods > known.periods()
            }
        }
    }
}

/// As good in bit rate and sample point.
pub(super) const fn same(a: &Candidate, b: &Candidate) -> bool {
    a.rate.same(b.rate) && a.sample_point.same(b.sample_point)
}

/// The best pair with equal prescalers: first the rates count, nominal before data, then the sample points.
pub(super) const fn equal(nominal: &Search<'_>, data: &Search<'_>) -> Option<(Candidate, Candidate)> {
    let mut best: Option<(Candidate, Candidate)> = None;
    let mut prescaler = max(nominal.prescalers.min, data.prescalers.min);
    while prescaler <= min(nominal.prescalers.max, data.prescalers.max) {
        if let (Some(n), Some(d)) = (nominal.at_prescaler(prescaler), data.at_prescaler(prescaler)) {
            best = match best {
                Some((bn, bd)) if !better_pair((&n, &d), (&bn, &bd)) => Some((bn, bd)),
                _ => Some((n, d)),
            };
        }
        prescaler += 1;
    }
    best
}

const fn better_pair(new: (&Candidate, &Candidate), old: (&Candidate, &Candidate)) -> bool {
    let pairs = [
        (new.0.rate, old.0.rate),
        (new.1.rate, old.1.rate),
        (new.0.sample_point, old.0.sample_point),
        (new.1.sample_point, old.1.sample_point),
    ];
    let mut i = 0;
    while i < pairs.len() {
        let (a, b) = pairs[i];
        if a.less(b) {
            return true;
        }
        if b.less(a) {
            return false;
        }
        i += 1;
    }
    false
}
