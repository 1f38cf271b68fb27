//! Laws of every solution, and brute force.

use can_hal::timing::{
    DsPic33CanFdTiming, DsPic33EcanTiming, FieldRange, Limits, MCanTiming, PhaseLimits, Pic32CanTiming, Propagation,
    Request, SamplePoint, Segments, TimingError,
};
use proptest::prelude::*;

/// What a solution is compared by, exactly: deviation of the rate, then of the sample point.
fn quality(limits: &Limits, request: &Request, s: &Segments) -> ((u128, u128), (u128, u128)) {
    let wanted = &request.nominal;
    let periods = u128::from(limits.divider) * u128::from(s.prescaler) * u128::from(s.quanta());
    let rate = u128::from(request.clock).abs_diff(periods * u128::from(wanted.bit_rate));
    let point =
        (u128::from(s.before_sample()) * 10_000).abs_diff(u128::from(wanted.target().get()) * u128::from(s.quanta()));
    ((rate, periods), (point, s.quanta().into()))
}

fn less(a: ((u128, u128), (u128, u128)), b: ((u128, u128), (u128, u128))) -> bool {
    let fraction = |a: (u128, u128), b: (u128, u128)| (a.0 * b.1).cmp(&(b.0 * a.1));
    fraction(a.0, b.0).then(fraction(a.1, b.1)).is_lt()
}

/// Every bit that the limits allow, as far as rate and sample point go.
fn all(limits: &Limits) -> Vec<Segments> {
    let phase = &limits.nominal;
    let mut found = Vec::new();
    for prescaler in phase.prescaler.min..=phase.prescaler.max {
        let propagations = phase.propagation.map_or(0..=0, |range| range.min..=range.max);
        for propagation in propagations {
            for phase1 in phase.phase1.min..=phase.phase1.max {
                for phase2 in phase.phase2.min..=phase.phase2.max {
                    let nominal = Segments { prescaler, propagation, phase1, phase2, jump_width: 1 };
                    let timing = can_hal::timing::BitTiming { nominal, data: None, three_samples: false };
                    if limits.check(&timing).is_ok() {
                        found.push(nominal);
                    }
                }
            }
        }
    }
    found
}

/// A controller so small that everything can be tried.
fn small(within: regbus::meta::Phase2Within, own_field: bool) -> Limits {
    Limits {
        controller: "small",
        clock: "clock",
        divider: 2,
        max_clock: None,
        nominal: PhaseLimits {
            prescaler: FieldRange::less_one(1, 8),
            propagation: own_field.then_some(FieldRange::less_one(1, 4)),
            phase1: FieldRange::less_one(1, if own_field { 5 } else { 12 }),
            phase2: FieldRange::less_one(2, 6),
            jump_width: FieldRange::less_one(1, 4),
            min_quanta: 6,
            max_quanta: 16,
            max_bit_rate: None,
            phase2_within: within,
            jump_width_below_phase2: true,
            three_samples_prescaler: None,
        },
        data: None,
        delay: None,
    }
}

fn request() -> impl Strategy<Value = Request> {
    (1_000u32..200_000_000, 1_000u32..2_000_000, 3_000u16..9_800).prop_map(|(clock, rate, point)| {
        Request::new(clock, rate).sample_point(SamplePoint::hundredths(point)).nearest().any_sample_point()
    })
}

/// Clocks and rates as they are in use, so that many requests are possible.
fn usual() -> impl Strategy<Value = Request> {
    let clock =
        prop::sample::select(vec![8u32, 16, 20, 24, 40, 48, 60, 64, 80, 120, 160]).prop_map(|mhz| mhz * 1_000_000);
    let rate = prop::sample::select(vec![
        10_000u32, 20_000, 50_000, 83_333, 100_000, 125_000, 250_000, 500_000, 800_000, 1_000_000,
    ]);
    let data = prop::option::of(prop::sample::select(vec![1_000_000u32, 2_000_000, 4_000_000, 5_000_000, 8_000_000]));
    let propagation = prop_oneof![
        Just(Propagation::Longest),
        (0u32..1500).prop_map(Propagation::AtLeast),
        (0u32..20).prop_map(Propagation::Quanta)
    ];
    (clock, rate, data, propagation, 5_000u16..9_500, prop::sample::select(vec![0u32, 100, 5_000, 50_000])).prop_map(
        |(clock, rate, data, propagation, point, ppm)| {
            let request =
                Request::new(clock, rate).propagation(propagation).sample_point(SamplePoint::hundredths(point));
            let request = request.within_ppm(ppm).sample_point_within(1_000);
            data.map_or(request, |rate| request.data(rate))
        },
    )
}

proptest! {
    /// No bit of a small controller is better than the solution.
    #[test]
    fn nothing_is_better(request in request(), own_field: bool, rule in 0..3) {
        use regbus::meta::Phase2Within::{Anything, Phase1, PropagationAndPhase1};
        let limits = small([Anything, Phase1, PropagationAndPhase1][rule as usize], own_field);
        let bits = all(&limits);
        prop_assert!(!bits.is_empty());
        let solution = limits.solve(&request).map_err(|error| TestCaseError::fail(error.to_string()))?;
        let ours = quality(&limits, &request, &solution.timing.nominal);
        for other in &bits {
            prop_assert!(!less(quality(&limits, &request, other), ours), "{other:?} is better than {solution:?}");
        }
    }

    /// The nearest rates of an error are the nearest there are.
    #[test]
    fn the_nearest_rates_are_the_nearest(request in request(), own_field: bool) {
        let limits = small(regbus::meta::Phase2Within::Anything, own_field);
        let Err(TimingError::BitRate { nearest, .. }) = limits.solve(&request.within_ppm(0)) else { return Ok(()) };
        let rate = |s: &Segments| u64::from(limits.divider) * u64::from(s.prescaler) * u64::from(s.quanta());
        let wanted = |periods: u64| (periods * u64::from(request.nominal.bit_rate)).cmp(&u64::from(request.clock));
        let bits = all(&limits);
        let below = bits.iter().map(rate).filter(|p| wanted(*p).is_ge()).min();
        let above = bits.iter().map(rate).filter(|p| wanted(*p).is_le()).max();
        prop_assert_eq!(nearest.below.map(|r| r.periods()), below);
        prop_assert_eq!(nearest.above.map(|r| r.periods()), above);
    }

    /// Every solution is within the limits, deviates as it says, and keeps to the request.
    #[test]
    fn solutions_keep_to_limits_and_request(request in usual()) {
        for limits in Limits::ALL {
            let Ok(solution) = limits.solve(&request) else { continue };
            let timing = solution.timing;
            prop_assert_eq!(limits.check(&timing), Ok(()));
            prop_assert!(solution.nominal.error_ppm.unsigned_abs() <= request.max_error_ppm);
            let s = timing.nominal;
            let exact = f64::from(request.clock) / f64::from(limits.divider * s.prescaler * s.quanta());
            let error = (exact / f64::from(request.nominal.bit_rate) - 1.0) * 1e6;
            prop_assert!((f64::from(solution.nominal.error_ppm) - error).abs() <= 1.0 + 1e-6);
            prop_assert!(solution.nominal.sample_point_error.unsigned_abs() <= request.max_sample_point_error);
            match request.propagation {
                Propagation::Longest => {}
                Propagation::Quanta(quanta) => prop_assert_eq!(s.propagation, quanta),
                Propagation::AtLeast(ns) => {
                    let length = f64::from(s.propagation * s.prescaler * limits.divider) / f64::from(request.clock) * 1e9;
                    prop_assert!(length + 1e-3 >= f64::from(ns), "{length} {ns}");
                }
            }
            prop_assert!(s.jump_width <= limits.nominal.longest_jump_width(s.phase1, s.phase2));
        }
    }

    /// The register values say the same as the segments.
    #[test]
    fn registers_say_the_same(request in usual()) {
        if let Ok(solution) = Limits::M_CAN.solve(&request) {
            let r = MCanTiming::of(&solution.timing).map_err(|e| TestCaseError::fail(e.to_string()))?;
            let s = solution.timing.nominal;
            // 2.3.8: every field is one less than what it means.
            prop_assert_eq!(u32::from(r.nbtp.nbrp()) + 1, s.prescaler);
            prop_assert_eq!(u32::from(r.nbtp.ntseg1()) + 1, s.propagation + s.phase1);
            prop_assert_eq!(u32::from(r.nbtp.ntseg2()) + 1, s.phase2);
            prop_assert_eq!(u32::from(r.nbtp.nsjw()) + 1, s.jump_width);
            if let Some(data) = solution.timing.data {
                prop_assert_eq!(u32::from(r.dbtp.dbrp()) + 1, data.segments.prescaler);
                prop_assert_eq!(u32::from(r.dbtp.dtseg1() + r.dbtp.dtseg2()) + 3, data.segments.quanta());
                prop_assert_eq!(r.dbtp.tdc(), data.compensation.is_some());
                prop_assert_eq!(u32::from(r.tdcr.tdco()), data.compensation.map_or(0, |c| c.offset));
            }
        }
        if let Ok(solution) = Limits::DSPIC33_CANFD.solve(&request) {
            let r = DsPic33CanFdTiming::of(&solution.timing).map_err(|e| TestCaseError::fail(e.to_string()))?;
            let s = solution.timing.nominal;
            prop_assert_eq!(u32::from(r.nbtcfgh.brp()) + 1, s.prescaler);
            prop_assert_eq!(u32::from(r.nbtcfgh.tseg1()) + 1, s.propagation + s.phase1);
            prop_assert_eq!((u32::from(r.nbtcfgl.tseg2()) + 1, u32::from(r.nbtcfgl.sjw()) + 1), (s.phase2, s.jump_width));
        }
        let classic = Request { data: None, ..request };
        if let Ok(solution) = Limits::DSPIC33_ECAN.solve(&classic) {
            let r = DsPic33EcanTiming::of(&solution.timing).map_err(|e| TestCaseError::fail(e.to_string()))?;
            let s = solution.timing.nominal;
            let fields = [r.cfg1.brp(), r.cfg2.prseg(), r.cfg2.seg1ph(), r.cfg2.seg2ph(), r.cfg1.sjw()];
            let meanings = [s.prescaler, s.propagation, s.phase1, s.phase2, s.jump_width];
            prop_assert_eq!(fields.map(|field| u32::from(field) + 1), meanings);
        }
        if let Ok(solution) = Limits::PIC32_CAN.solve(&classic) {
            let r = Pic32CanTiming::of(&solution.timing).map_err(|e| TestCaseError::fail(e.to_string()))?;
            let s = solution.timing.nominal;
            let fields = [r.cfg.brp(), r.cfg.prseg(), r.cfg.seg1ph(), r.cfg.seg2ph(), r.cfg.sjw()];
            let meanings = [s.prescaler, s.propagation, s.phase1, s.phase2, s.jump_width];
            prop_assert_eq!(fields.map(|field| u32::from(field) + 1), meanings);
        }
    }

    /// No request panics.
    #[test]
    fn no_request_panics(
        clock: u32, rate: u32, data: Option<u32>, point: u16, data_point: u16, quanta: Option<u32>, propagation in
            prop_oneof![any::<u32>().prop_map(Propagation::AtLeast), any::<u32>().prop_map(Propagation::Quanta)],
        three: bool, delay: u32, ppm: u32, jump: Option<u32>,
    ) {
        use can_hal::timing::JumpWidth;
        let mut request = Request::new(clock, rate).sample_point(SamplePoint::hundredths(point)).propagation(propagation);
        request = Request { three_samples: three, loop_delay: delay, max_error_ppm: ppm, ..request };
        request.nominal.quanta = quanta;
        if let Some(data) = data {
            request = request.data(data).data_sample_point(SamplePoint::hundredths(data_point));
        }
        if let Some(jump) = jump {
            request = request.jump_width(JumpWidth::Quanta(jump));
        }
        for limits in Limits::ALL {
            if let Err(error) = limits.solve(&request) {
                prop_assert!(!error.to_string().is_empty());
            }
        }
    }
}
