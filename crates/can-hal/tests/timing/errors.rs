//! What is impossible, and what is said about it.

use can_hal::timing::{
    BitTiming, Bound, Compensation, JumpWidth, Limits, Phase, Prescalers, Propagation, Request, RequestFault,
    SamplePoint, Segments, TimingError,
};

fn error(limits: &Limits, request: Request) -> TimingError {
    limits.solve(&request).expect_err("this is impossible")
}

fn bound(limits: &Limits, request: Request) -> (Phase, Bound) {
    match error(limits, request) {
        TimingError::BitRate { phase, bound, .. } => (phase, bound),
        TimingError::Limit(fault) => (fault.phase, fault.bound),
        other => panic!("{other}"),
    }
}

#[test]
fn rates_between_two_divisors() {
    let found = error(&Limits::M_CAN, Request::new(40_000_000, 300_000));
    assert_eq!(
        found.to_string(),
        "nominal phase of 300000 bit/s: no prescaler and number of time quanta divide the clock to this rate; \
         the nearest are 298507.463 bit/s and 300751.880 bit/s"
    );
    let solution = Limits::M_CAN.solve(&Request::new(40_000_000, 300_000).within_ppm(2_507)).expect("133 periods");
    assert_eq!((solution.nominal.bit_rate.periods(), solution.nominal.error_ppm), (133, 2_507));
    assert!(Limits::M_CAN.solve(&Request::new(40_000_000, 300_000).within_ppm(2_506)).is_err());
}

#[test]
fn rates_out_of_reach() {
    let slow = Request::new(160_000_000, 100);
    assert_eq!(bound(&Limits::M_CAN, slow), (Phase::Nominal, Bound::LongestBit));
    assert_eq!(
        error(&Limits::M_CAN, slow).to_string(),
        "nominal phase of 100 bit/s: the bit is longer than the most time quanta with the largest prescaler; \
         the nearest is 811.688 bit/s"
    );
    let fast = Request::new(16_000_000, 1_000_000).data(5_000_000);
    assert_eq!(bound(&Limits::M_CAN, fast), (Phase::Data, Bound::ShortestBit));
    assert_eq!(
        error(&Limits::M_CAN, fast).to_string(),
        "data phase of 5000000 bit/s: the bit is shorter than the fewest time quanta with the smallest prescaler; \
         the nearest is 4000000 bit/s"
    );
}

#[test]
fn limits_of_the_manual() {
    assert_eq!(
        error(&Limits::DSPIC33_CANFD, Request::new(120_000_000, 500_000)),
        TimingError::Request(RequestFault::ClockTooFast(80_000_000))
    );
    let fast = Request::new(80_000_000, 1_000_000).data(10_000_000);
    assert_eq!(bound(&Limits::DSPIC33_CANFD, fast), (Phase::Data, Bound::BitRate));
    assert_eq!(
        error(&Limits::DSPIC33_CANFD, fast).to_string(),
        "data phase of 10000000 bit/s: the rate is above the highest that the manual allows; the nearest is 8000000 bit/s"
    );
    assert_eq!(bound(&Limits::PIC32_CAN, Request::new(80_000_000, 2_000_000)), (Phase::Nominal, Bound::BitRate));
    // The nearest rate above the limit is not offered.
    let odd = Request::new(27_000_000, 1_000_000);
    match error(&Limits::DSPIC33_ECAN, odd) {
        TimingError::BitRate { nearest, .. } => assert!(nearest.above.is_none_or(|rate| rate.get() <= 1_000_000)),
        other => panic!("{other}"),
    }
}

#[test]
fn requests_that_make_no_sense() {
    let limits = &Limits::M_CAN;
    assert_eq!(error(limits, Request::new(0, 500_000)), TimingError::Request(RequestFault::NoClock));
    assert_eq!(error(limits, Request::new(40_000_000, 0)), TimingError::Request(RequestFault::NoBitRate));
    assert_eq!(
        error(limits, Request::new(40_000_000, 500_000).data(0)).text(),
        "the data bit rate is below the nominal bit rate"
    );
    let slower = Request::new(40_000_000, 500_000).data(250_000);
    assert_eq!(bound(limits, slower), (Phase::Data, Bound::DataBelowNominal));
    let fd = Request::new(40_000_000, 500_000).data(2_000_000);
    assert_eq!(bound(&Limits::PIC32_CAN, fd), (Phase::Data, Bound::NoDataPhase));
    assert_eq!(bound(limits, Request::new(40_000_000, 500_000).three_samples()), (Phase::Nominal, Bound::ThreeSamples));
    assert_eq!(bound(limits, Request::new(40_000_000, 500_000).quanta(4)), (Phase::Nominal, Bound::Quanta));
    let wide = Request::new(40_000_000, 500_000).jump_width(JumpWidth::Quanta(11));
    assert_eq!(bound(limits, wide), (Phase::Nominal, Bound::JumpWidth));
}

#[test]
fn sample_points_out_of_reach() {
    // PIC32: phase segment 2 is at most as long as phase segment 1, so that no sample point lies before half of the bit.
    let early = Request::new(80_000_000, 500_000).sample_point(SamplePoint::percent(40));
    assert_eq!(
        error(&Limits::PIC32_CAN, early).to_string(),
        "nominal phase: sample point 40 % is out of reach; the nearest is 56.25 %"
    );
    // 25 quanta are the longest bit: 1 + 8 + 8 before the sample point and 8 behind it.
    let slow = Request::new(40_000_000, 12_500);
    assert_eq!(
        error(&Limits::DSPIC33_ECAN, slow).to_string(),
        "nominal phase: sample point 87.5 % is out of reach; the nearest is 68 %"
    );
    let taken = Limits::DSPIC33_ECAN.solve(&slow.any_sample_point()).expect("with any sample point it works");
    assert_eq!((taken.nominal.sample_point.get(), taken.nominal.sample_point_error), (6800, -1950));
}

#[test]
fn a_bus_that_is_too_long() {
    // 1 Mbit/s over 200 m: 2510 ns of propagation in a bit of 1000 ns.
    let long = Request::new(40_000_000, 1_000_000).propagation(Propagation::of_bus(200, 255));
    assert_eq!(bound(&Limits::M_CAN, long), (Phase::Nominal, Bound::Propagation));
}

#[test]
fn equal_prescalers() {
    // 125 kbit/s in 160 MHz needs a prescaler of 4 or more, the data phase with compensation 1 or 2.
    let request = Request::new(160_000_000, 125_000).data(2_000_000).prescalers(Prescalers::Equal);
    assert_eq!(bound(&Limits::M_CAN, request.compensation(Compensation::On)), (Phase::Data, Bound::EqualPrescalers));
    let without = Limits::M_CAN.solve(&request.compensation(Compensation::Off)).expect("4 and 4");
    assert_eq!(without.timing.nominal.prescaler, without.timing.data.expect("data phase").segments.prescaler);
}

#[test]
fn compensation_when_needed() {
    let compensation = |request: Request| {
        let solution = Limits::M_CAN.solve(&request).unwrap_or_else(|error| panic!("{error}"));
        solution.timing.data.expect("data phase").compensation.map(|c| c.offset)
    };
    // Below 1 Mbit/s there is time for the transceiver.
    assert_eq!(compensation(Request::new(40_000_000, 250_000).data(500_000)), None);
    assert_eq!(compensation(Request::new(40_000_000, 250_000).data(2_000_000)), Some(15));
    assert_eq!(compensation(Request::new(40_000_000, 500_000).data(2_000_000).compensation(Compensation::Off)), None);
    // 1 Mbit/s of 160 MHz needs a prescaler of 4, with which there is no compensation; the sample point at 750 ns is late
    // enough for the delay of 255 ns, but not for one of 800 ns.
    let slow = Request::new(160_000_000, 500_000).data(1_000_000);
    assert_eq!(compensation(slow), None);
    assert!(Limits::M_CAN.solve(&slow.loop_delay(800)).is_err());
    assert!(Limits::M_CAN.solve(&slow.compensation(Compensation::On)).is_err());
    // M_CAN 3.1.4.1: delay and offset are less than 6 data bits.
    let fast = Request::new(80_000_000, 1_000_000).data(8_000_000).data_sample_point(SamplePoint::percent(70));
    assert_eq!(compensation(fast.loop_delay(650)), Some(7));
    assert_eq!(bound(&Limits::M_CAN, fast.loop_delay(660)), (Phase::Data, Bound::CompensationSpan));
}

#[test]
fn segments_of_ones_own() {
    let good = Segments { prescaler: 1, propagation: 3, phase1: 3, phase2: 3, jump_width: 2 };
    let check = |segments: Segments| {
        Limits::PIC32_CAN
            .check(&BitTiming { nominal: segments, data: None, three_samples: false })
            .map_err(|fault| fault.bound)
    };
    assert_eq!(check(good), Ok(()));
    assert_eq!(check(Segments { prescaler: 0, ..good }), Err(Bound::Prescaler));
    assert_eq!(check(Segments { prescaler: 65, ..good }), Err(Bound::Prescaler));
    assert_eq!(check(Segments { propagation: 9, ..good }), Err(Bound::Propagation));
    assert_eq!(check(Segments { phase1: 0, ..good }), Err(Bound::Phase1));
    assert_eq!(check(Segments { phase2: 4, ..good }), Err(Bound::Phase2WithinPhase1));
    assert_eq!(check(Segments { propagation: 1, phase1: 2, phase2: 2, ..good }), Err(Bound::Quanta));
    assert_eq!(check(Segments { jump_width: 4, ..good }), Err(Bound::JumpWidth));
    let three = BitTiming { nominal: Segments { prescaler: 2, ..good }, data: None, three_samples: true };
    assert_eq!(Limits::PIC32_CAN.check(&three).map_err(|fault| fault.bound), Err(Bound::ThreeSamples));
    assert_eq!(Limits::DSPIC33_ECAN.check(&three), Ok(()));
}
