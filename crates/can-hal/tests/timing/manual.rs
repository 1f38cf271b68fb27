//! Every bit-timing example of the four manuals, with the printed numbers.

use can_hal::timing::{
    BitTiming, Compensation, DataPhase, DelayCompensation, DsPic33CanFdTiming, DsPic33EcanTiming, JumpWidth, Limits,
    MCanTiming, Pic32CanTiming, Propagation, Request, SamplePoint, Segments, Solution,
};
use m_can_pac::registers::{Dbtp, Nbtp};

/// dsPIC33 CAN FD 5.3.8: 80 MHz, 500 kbit/s and 2 Mbit/s, both sampled at 80 %, a bus of 40 m.
const CANFD: Request = Request::new(80_000_000, 500_000)
    .sample_point(SamplePoint::percent(80))
    .data(2_000_000)
    .data_sample_point(SamplePoint::percent(80))
    .propagation(Propagation::of_bus(40, 255));
const CANFD_SOLUTION: Solution = Limits::DSPIC33_CANFD.fixed(&CANFD);

#[test]
fn canfd_tables_5_3_and_5_4() {
    let nominal = CANFD_SOLUTION.timing.nominal;
    assert_eq!(nominal, Segments { prescaler: 1, propagation: 95, phase1: 32, phase2: 32, jump_width: 32 });
    assert_eq!(nominal.quanta(), 160);
    let data = CANFD_SOLUTION.timing.data.expect("there is a data phase").segments;
    assert_eq!((data.prescaler, data.propagation + data.phase1, data.phase2, data.jump_width), (1, 31, 8, 8));
    assert_eq!(data.quanta(), 40);
    // "0.78 %": the smallest is condition 2 with exactly 0.78125 %.
    assert_eq!(CANFD_SOLUTION.tolerance.min(), 7_812);
    assert_eq!(CANFD_SOLUTION.tolerance.after_error_flag, 7_812);
    assert_eq!(CANFD_SOLUTION.tolerance.resynchronization, 10_000);
    assert_eq!(CANFD_SOLUTION.tolerance.data_resynchronization, Some(10_000));
    assert_eq!(CANFD_SOLUTION.tolerance.after_data_error_flag, Some(11_834));
    assert_eq!(CANFD_SOLUTION.tolerance.rate_switch, Some(8_771));
}

#[test]
fn canfd_table_5_5() {
    const REGISTERS: DsPic33CanFdTiming = DsPic33CanFdTiming::fixed(&CANFD);
    assert_eq!((REGISTERS.nbtcfgh.brp(), REGISTERS.nbtcfgh.tseg1()), (0, 126));
    assert_eq!((REGISTERS.nbtcfgl.tseg2(), REGISTERS.nbtcfgl.sjw()), (31, 31));
    assert_eq!((REGISTERS.dbtcfgh.brp(), REGISTERS.dbtcfgh.tseg1()), (0, 30));
    assert_eq!((REGISTERS.dbtcfgl.tseg2(), REGISTERS.dbtcfgl.sjw()), (7, 7));
    assert_eq!((REGISTERS.tdch.tdcmod().bits(), REGISTERS.tdcl.tdco(), REGISTERS.tdcl.tdcv()), (2, 31, 0));
}

/// Equation 5-9 in 5.3.8: 910 ns, 72.8 quanta of 12.5 ns.
#[test]
fn canfd_propagation_delay() {
    assert_eq!(Propagation::of_bus(40, 255), Propagation::AtLeast(910));
    // With a propagation segment of 73 quanta and not one less, 73 is the least that passes.
    let least =
        |quanta| Limits::DSPIC33_CANFD.solve(&CANFD.propagation(Propagation::Quanta(quanta))).map(|s| s.timing.nominal);
    assert_eq!(least(73).map(|n| (n.propagation, n.phase1)), Ok((73, 54)));
    // A bus of 60 m fits into the 95 quanta, one of 70 m takes from phase segment 1.
    let of_bus = |metres| {
        let request = CANFD.propagation(Propagation::of_bus(metres, 255));
        Limits::DSPIC33_CANFD.solve(&request).map(|s| (s.timing.nominal.propagation, s.timing.nominal.jump_width))
    };
    assert_eq!(of_bus(60), Ok((95, 32)));
    assert_eq!(of_bus(70), Ok((97, 30)));
}

/// Examples 6-1, 7-1 and 9-1 of the CAN FD manual: 40 MHz, 1 Mbit/s and 2 Mbit/s at 80 %.
#[test]
fn canfd_code_examples() {
    let request = Request::new(40_000_000, 1_000_000)
        .sample_point(SamplePoint::percent(80))
        .data(2_000_000)
        .data_sample_point(SamplePoint::percent(80));
    let registers = DsPic33CanFdTiming::solve(&request).expect("the examples have a solution");
    assert_eq!((registers.nbtcfgh.bits(), registers.nbtcfgl.bits()), (0x001E, 0x0707));
    assert_eq!((registers.dbtcfgh.bits(), registers.dbtcfgl.bits()), (0x000E, 0x0303));
    assert_eq!((registers.tdch.bits(), registers.tdcl.bits()), (0x0002, 0x0F00));
}

/// M_CAN 2.3.8: with a clock of 8 MHz the reset value of NBTP is 500 kbit/s. M_CAN 2.3.4: that of DBTP too.
#[test]
fn m_can_reset_values() {
    let request = Request::new(8_000_000, 500_000)
        .sample_point(SamplePoint::percent(75))
        .data(500_000)
        .data_sample_point(SamplePoint::percent(75));
    let registers = MCanTiming::solve(&request).expect("the reset values are a solution");
    assert_eq!(registers.nbtp, Nbtp::RESET);
    assert_eq!(registers.nbtp.bits(), 0x0600_0A03);
    assert_eq!(registers.dbtp, Dbtp::RESET);
    assert_eq!(registers.dbtp.bits(), 0x0000_0A33);
}

/// M_CAN 3.1.3: 20 MHz and the shortest data bit of 4 quanta give 5 Mbit/s.
#[test]
fn m_can_fastest_data_phase() {
    let request = Request::new(20_000_000, 1_000_000)
        .data(5_000_000)
        .data_sample_point(SamplePoint::percent(50))
        .compensation(Compensation::Off);
    let solution = Limits::M_CAN.solve(&request).expect("the example is a solution");
    assert_eq!(solution.timing.data.expect("there is a data phase").segments.quanta(), 4);
    let registers = MCanTiming::of(&solution.timing).expect("solutions are within the limits");
    assert_eq!(registers.dbtp.bits(), 0x0000_0010);
}

/// M_CAN 2.3.4 and 2.3.8: the longest bits have 49 and 385 quanta.
#[test]
fn m_can_longest_bits() {
    let limits = Limits::M_CAN;
    assert_eq!(limits.nominal.max_quanta, 385);
    assert_eq!(1 + limits.nominal.phase1.max + limits.nominal.phase2.max, 385);
    let data = limits.data.expect("M_CAN has a data phase");
    assert_eq!(data.max_quanta, 49);
    assert_eq!(1 + data.phase1.max + data.phase2.max, 49);
}

/// M_CAN 2.3.4: with TDC the data prescaler is 1 or 2 (DBRP 0 or 1).
#[test]
fn m_can_compensation_limits_the_prescaler() {
    let phase = |prescaler| Segments { prescaler, propagation: 2, phase1: 4, phase2: 3, jump_width: 3 };
    let timing = |prescaler, compensation| BitTiming {
        nominal: Segments { prescaler: 4, propagation: 40, phase1: 9, phase2: 9, jump_width: 9 },
        data: Some(DataPhase { segments: phase(prescaler), compensation }),
        three_samples: false,
    };
    let on = Some(DelayCompensation { offset: 14, filter: 0 });
    assert!(MCanTiming::of(&timing(2, on)).is_ok());
    assert!(MCanTiming::of(&timing(3, on)).is_err());
    assert!(MCanTiming::of(&timing(3, None)).is_ok());
}

/// ECAN Examples 6-1 and 6-2: FCY 40 MHz, 1 Mbit/s, propagation delay 5 quanta, sample point 70 %, three samples.
#[test]
fn ecan_examples_6_1_and_6_2() {
    let request = Request::new(40_000_000, 1_000_000)
        .sample_point(SamplePoint::percent(70))
        .propagation(Propagation::Quanta(5))
        .three_samples();
    let solution = Limits::DSPIC33_ECAN.solve(&request).expect("the example is a solution");
    let expected = Segments { prescaler: 1, propagation: 5, phase1: 8, phase2: 6, jump_width: 4 };
    assert_eq!(solution.timing.nominal, expected);
    assert_eq!(expected.quanta(), 20);
    let registers = DsPic33EcanTiming::of(&solution.timing).expect("solutions are within the limits");
    assert_eq!((registers.cfg1.bits(), registers.cfg2.bits()), (0x00C0, 0x05FC));
}

/// PIC32 Examples 34-16 and 34-17: FSYS 80 MHz, 1 Mbit/s, propagation delay 3 quanta, sample point 70 %, three samples. The
/// prescaler follows: with three samples it is at least 3. The code programs a jump width of 3 quanta where its comment
/// says 2; only 2 is shorter than phase segment 2, which 34.10.4.3 asks for.
#[test]
fn pic32_examples_34_16_and_34_17() {
    let request = Request::new(80_000_000, 1_000_000)
        .sample_point(SamplePoint::percent(70))
        .propagation(Propagation::Quanta(3))
        .three_samples();
    let solution = Limits::PIC32_CAN.solve(&request).expect("the example is a solution");
    let expected = Segments { prescaler: 4, propagation: 3, phase1: 3, phase2: 3, jump_width: 2 };
    assert_eq!(solution.timing.nominal, expected);
    assert_eq!(expected.quanta(), 10);
    let registers = Pic32CanTiming::of(&solution.timing).expect("solutions are within the limits");
    assert_eq!(registers.cfg.brp(), 3);
    assert_eq!(registers.cfg.bits(), 0x0002_D243);
    // The value as the code has it: SJW is 2.
    let as_coded = Pic32CanTiming::solve(&request.jump_width(JumpWidth::Quanta(3))).expect("it is within the limits");
    assert_eq!((as_coded.cfg.sjw(), as_coded.cfg.bits()), (2, 0x0002_D283));
}

/// ECAN Equations 6-1 and 6-2 with other rates: FCY 40 MHz, the prescaler field for each number of quanta.
#[test]
fn ecan_equation_6_2() {
    let cases = [(1_000_000, 10, 1), (500_000, 20, 1), (250_000, 20, 3), (125_000, 20, 7), (125_000, 16, 9)];
    let slow = [(100_000, 25, 7), (50_000, 20, 19), (20_000, 25, 39), (12_500, 25, 63)];
    for (rate, quanta, brp) in cases.into_iter().chain(slow) {
        let request = Request::new(40_000_000, rate).quanta(quanta).any_sample_point();
        let registers = DsPic33EcanTiming::solve(&request).unwrap_or_else(|error| panic!("{rate}: {error}"));
        assert_eq!(registers.cfg1.brp(), brp, "{rate} bit/s of {quanta} quanta");
    }
    // The prescaler would be 1.25, 2.5 and 0.8.
    for quanta in [16, 8, 25] {
        let request = Request::new(40_000_000, 1_000_000).quanta(quanta).any_sample_point();
        assert!(DsPic33EcanTiming::solve(&request).is_err(), "{quanta} quanta");
    }
}

#[test]
fn recommended_sample_points() {
    let expected = [(500_000, 8750), (500_001, 8000), (800_000, 8000), (800_001, 7500), (8_000_000, 7500)];
    for (rate, point) in expected {
        assert_eq!(SamplePoint::recommended(rate).get(), point);
    }
}
