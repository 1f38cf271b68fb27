//! The bit-timing unit of a node: time quanta, sample points, synchronization (ISO 11898-1:2015, 11.3).
//!
//! Between two sample points the unit knows where the bit boundary and the next sample point will be if no edge comes.
//! An edge moves them: [`BitClock::edge`].

use crate::{
    BitTiming, NodeConfig, Time,
    protocol::Sync,
    time::{Fine, Tick},
};

/// The segments of one bit time in the quanta of one prescaler.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segments {
    pub(crate) quantum: Tick,
    /// Quanta from the start of the bit to its sample point.
    pub(crate) before: u64,
    /// Quanta from the sample point to the end: phase segment 2.
    pub(crate) after: u64,
    pub(crate) sjw: u64,
    before_span: u64,
    after_span: u64,
}

impl Segments {
    fn new(timing: &BitTiming, clock: Tick) -> Segments {
        let quantum = clock.times(timing.prescaler);
        let (before, after) = (timing.sample_quanta(), u64::from(timing.phase_seg2));
        Segments {
            quantum,
            before,
            after,
            sjw: u64::from(timing.sjw),
            before_span: quantum.span(before),
            after_span: quantum.span(after),
        }
    }

    pub(crate) fn bit(&self) -> u64 {
        self.before + self.after
    }
}

#[derive(Clone, Debug)]
pub(crate) struct BitClock {
    pub(crate) clock: Tick,
    pub(crate) nominal: Segments,
    pub(crate) data: Segments,
    /// Boundary between the bit sampled last and the one sampled next.
    pub(crate) start: Fine,
    /// The sample point before `start`.
    pub(crate) sampled: Fine,
    /// The sample point after `start`.
    pub(crate) next_sample: Fine,
    /// [`BitClock::next_sample`] in picoseconds, rounded up.
    pub(crate) next_sample_at: u64,
    /// Quantum and jump width before and after `start`; they differ around a bit-rate switch.
    data_before: bool,
    data_after: bool,
    /// Level at the last sample point, and whether an edge has been used since: only one synchronization between two
    /// sample points, and only after a recessive bit.
    pub(crate) may_sync: bool,
}

/// What an edge did to the timing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    Nothing,
    /// The next sample point, and the bit boundary if it was still ahead, have moved. A change of the output that was
    /// due at the boundary happens no earlier than this: the tick at which the edge is seen.
    Moved {
        output_from: Fine,
    },
}

impl BitClock {
    pub(crate) fn new(config: &NodeConfig) -> BitClock {
        let clock = Tick::of_clock(config.clock_hz, config.clock_ppm);
        BitClock {
            clock,
            nominal: Segments::new(&config.nominal, clock),
            data: Segments::new(&config.data, clock),
            start: Fine::default(),
            sampled: Fine::default(),
            next_sample: Fine::default(),
            next_sample_at: 0,
            data_before: false,
            data_after: false,
            may_sync: false,
        }
    }

    #[inline]
    fn set_next_sample(&mut self, at: Fine) {
        self.next_sample = at;
        self.next_sample_at = at.ceil();
    }

    #[inline]
    pub(crate) fn segments(&self, data: bool) -> &Segments {
        if data { &self.data } else { &self.nominal }
    }

    /// Starts a nominal bit at the first tick of the node's clock that is not before `now`.
    pub(crate) fn restart(&mut self, now: Time) {
        let now = Fine::from_time(now);
        let ticks = now.ticks_since(Fine::default(), self.clock);
        let grid = Fine::default().plus(ticks, self.clock);
        self.start = if grid < now { grid.plus(1, self.clock) } else { grid };
        self.sampled = self.start;
        self.set_next_sample(self.start.plus(self.nominal.before, self.nominal.quantum));
        self.data_before = false;
        self.data_after = false;
        self.may_sync = true;
    }

    /// Moves an idle bit grid forward so that the next sample point is not before `now`.
    pub(crate) fn catch_up(&mut self, now: Time) {
        let now = Fine::from_time(now);
        if self.next_sample >= now {
            return;
        }
        let quantum = self.nominal.quantum;
        let late = now.ticks_since(self.next_sample, quantum);
        let mut bits = late / self.nominal.bit();
        if self.next_sample.plus(bits * self.nominal.bit(), quantum) < now {
            bits += 1;
        }
        let quanta = bits * self.nominal.bit();
        self.start = self.start.plus(quanta, quantum);
        self.set_next_sample(self.next_sample.plus(quanta, quantum));
        self.sampled = self.start.minus(self.nominal.after, quantum);
    }

    /// The sample point has been reached. `data` is the bit rate from here on; the bit that ends may have begun at the
    /// other one.
    #[inline]
    pub(crate) fn sampled(&mut self, level: bool, data: bool) {
        let segments = if data { &self.data } else { &self.nominal };
        let start = self.next_sample.after(segments.after_span);
        let next = start.after(segments.before_span);
        self.sampled = self.next_sample;
        self.start = start;
        self.set_next_sample(next);
        self.data_before = data;
        self.data_after = data;
        self.may_sync = level;
    }

    /// Stands between two nominal bits, the second of which begins at `start`; the first was recessive.
    pub(crate) fn jump_to(&mut self, start: Fine) {
        self.start = start;
        self.sampled = start.minus(self.nominal.after, self.nominal.quantum);
        self.set_next_sample(start.plus(self.nominal.before, self.nominal.quantum));
        self.data_before = false;
        self.data_after = false;
        self.may_sync = true;
    }

    /// True if an edge at `at` lies in the synchronization segment: at the right time.
    #[inline]
    pub(crate) fn expects_edge(&self, at: u64) -> bool {
        let at = Fine::from_time(Time::from_ps(at));
        let quantum = self.segments(self.data_after).quantum;
        at >= self.start && at.is_within_first(self.start, quantum)
    }

    /// A recessive to dominant edge at the input. `driving` tells whether the node itself sends dominant in the bit
    /// that begins at `start`.
    pub(crate) fn edge(&mut self, at: Time, sync: Sync, driving_dominant: bool) -> Effect {
        let at = Fine::from_time(at);
        if at < self.start {
            self.edge_after_sample(at, sync)
        } else {
            self.edge_before_sample(at, sync, driving_dominant)
        }
    }

    /// The edge lies in phase segment 2: a negative phase error of the quanta that are left.
    fn edge_after_sample(&mut self, at: Fine, sync: Sync) -> Effect {
        let (quantum, after, sjw) = {
            let segments = self.segments(self.data_before);
            (segments.quantum, segments.after, segments.sjw)
        };
        let elapsed = at.ticks_since(self.sampled, quantum);
        let left = after.saturating_sub(elapsed);
        let shorter = match sync {
            Sync::None => return Effect::Nothing,
            Sync::Hard => left,
            Sync::Resync => left.min(sjw),
        };
        self.may_sync = false;
        if shorter == 0 {
            return Effect::Nothing;
        }
        let seen = self.sampled.plus(elapsed, quantum);
        let seen = if seen < at { self.sampled.plus(elapsed + 1, quantum) } else { seen };
        self.start = self.start.minus(shorter, quantum);
        let next = self.segments(self.data_after);
        self.set_next_sample(self.start.plus(next.before, next.quantum));
        Effect::Moved { output_from: seen.max(self.start) }
    }

    /// The edge lies between the start of the bit and its sample point: a positive phase error, or none within the
    /// synchronization segment.
    fn edge_before_sample(&mut self, at: Fine, sync: Sync, driving_dominant: bool) -> Effect {
        let (quantum, before, sjw) = {
            let segments = self.segments(self.data_after);
            (segments.quantum, segments.before, segments.sjw)
        };
        let late = if at.is_within_first(self.start, quantum) { 0 } else { at.ticks_since(self.start, quantum) };
        match sync {
            Sync::None => Effect::Nothing,
            Sync::Hard => {
                self.may_sync = false;
                if late == 0 {
                    return Effect::Nothing;
                }
                self.start = self.start.plus(late, quantum);
                self.set_next_sample(self.start.plus(before, quantum));
                Effect::Moved { output_from: self.start }
            }
            Sync::Resync if late > 0 && driving_dominant => Effect::Nothing,
            Sync::Resync => {
                self.may_sync = false;
                if late == 0 {
                    return Effect::Nothing;
                }
                self.set_next_sample(self.next_sample.plus(late.min(sjw), quantum));
                Effect::Moved { output_from: self.start }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 MHz, 10 quanta per bit of 100 ns, sample point after 7, jump width 2.
    fn clock() -> BitClock {
        let timing = BitTiming { prescaler: 1, prop_seg: 2, phase_seg1: 4, phase_seg2: 3, sjw: 2 };
        let config = NodeConfig { clock_hz: 10_000_000, nominal: timing, data: timing, ..NodeConfig::new() };
        let mut clock = BitClock::new(&config);
        clock.restart(Time::from_ns(1_000));
        clock.sampled(true, false);
        // Sampled at 1700, next bit 2000 to 3000, sample point 2700.
        clock
    }

    fn times(clock: &BitClock) -> (u64, u64) {
        (clock.start.ceil() / 1_000, clock.next_sample.ceil() / 1_000)
    }

    #[test]
    fn an_edge_in_the_synchronization_segment_changes_nothing() {
        for ns in [2_000, 2_050, 2_099] {
            let mut clock = clock();
            assert_eq!(clock.edge(Time::from_ns(ns), Sync::Resync, false), Effect::Nothing);
            assert!(!clock.may_sync, "the edge is used up");
            assert_eq!(times(&clock), (2_000, 2_700));
        }
    }

    #[test]
    fn a_late_edge_lengthens_phase_segment_1_by_the_jump_width_at_most() {
        for (ns, sample) in [(2_100, 2_800), (2_250, 2_900), (2_399, 2_900), (2_650, 2_900)] {
            let mut clock = clock();
            clock.edge(Time::from_ns(ns), Sync::Resync, false);
            assert_eq!(times(&clock), (2_000, sample), "edge at {ns}");
        }
    }

    #[test]
    fn an_early_edge_shortens_phase_segment_2_by_the_jump_width_at_most() {
        // Output changes no earlier than the tick that sees the edge.
        for (ns, start, output) in
            [(1_950, 1_900, 2_000), (1_900, 1_900, 1_900), (1_850, 1_800, 1_900), (1_720, 1_800, 1_800)]
        {
            let mut clock = clock();
            let effect = clock.edge(Time::from_ns(ns), Sync::Resync, false);
            assert_eq!(times(&clock), (start, start + 700), "edge at {ns}");
            assert_eq!(effect, Effect::Moved { output_from: Fine::from_time(Time::from_ns(output)) });
        }
    }

    #[test]
    fn a_node_that_sends_dominant_ignores_late_edges() {
        let mut clock = clock();
        assert_eq!(clock.edge(Time::from_ns(2_350), Sync::Resync, true), Effect::Nothing);
        assert_eq!(times(&clock), (2_000, 2_700));
    }

    #[test]
    fn hard_synchronization_restarts_the_bit_at_the_quantum_of_the_edge() {
        for (ns, start) in [(1_720, 1_700), (1_950, 1_900), (2_050, 2_000), (2_650, 2_600)] {
            let mut clock = clock();
            clock.edge(Time::from_ns(ns), Sync::Hard, false);
            assert_eq!(times(&clock), (start, start + 700), "edge at {ns}");
        }
    }

    #[test]
    fn an_idle_grid_catches_up_by_whole_bits() {
        let mut clock = clock();
        clock.catch_up(Time::from_ns(102_701));
        assert_eq!(times(&clock), (103_000, 103_700));
        clock.catch_up(Time::from_ns(103_700));
        assert_eq!(times(&clock), (103_000, 103_700));
    }
}
