//! Fault confinement: error passive, bus off, recovery, flags and overload conditions.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{
    BitFault, Disturbance, ErrorKind, ErrorState, EventKind, Fault, Field, Frames, Line, Mode, NodeConfig, NodeId,
    OverloadCause, Position, Role, Time, Wire,
};
use common::{bench_of, confine::*, frame, received, run, transmitted};

// A controller that stops at its error, in the middle of the disturbed bit, leaves no dominant level behind.
#[test]
fn a_fault_on_the_output_ends_with_its_bit_also_if_the_node_is_switched_off_in_it() {
    let (mut wire, a, b) = two();
    let position = Position::new(Field::Data, 3);
    wire.inject(Fault::Bit { node: a, fault: BitFault::InvertDriven, position, frames: Frames::next_of(a) });
    wire.send(a, frame("123#FF")).unwrap();
    let failed = |event: &can_wire::Event| matches!(event.kind, EventKind::TransmissionFailed(_));
    while !failed(&wire.next_event(Time::from_ms(1)).unwrap()) {}
    assert!(wire.bus_level().is_dominant(), "the disturbed bit");
    wire.set_mode(a, Mode::Off);
    assert!(!wire.bus_level().is_dominant());
    run(&mut wire, Time::from_us(200));
    assert_eq!(wire.error_counters(b), (0, 1), "a frame that is cut short is one error for its receiver");
}

// Rule i: error passive above 127, and the error that makes it so is still signalled with an active flag.
#[test]
fn i_the_error_that_makes_a_node_passive_is_signalled_actively() {
    let (mut wire, a, b) = two();
    preset(&mut wire, a, 127, 0);
    assert_eq!(wire.error_state(a), ErrorState::Active);
    let trace = common::record(&mut wire);
    for (attempt, state) in [(1, ErrorState::Passive), (2, ErrorState::Passive)] {
        flip_seen(&mut wire, a, Field::Data, 2);
        wire.send(a, frame("123#0000")).unwrap();
        let events = run(&mut wire, Time::from_us(300));
        assert_eq!(wire.error_state(a), state);
        if attempt == 1 {
            assert_eq!(states(&events, a), [ErrorState::Passive]);
            assert_eq!(counters(&events, a), [(135, 0)]);
        }
        let mut trace = trace.lock().unwrap();
        let flag: Vec<bool> = trace
            .bits
            .drain(..)
            .filter(|bit| bit.node == a && bit.position.field == Field::ErrorFlag)
            .map(|bit| bit.driven.is_dominant())
            .collect();
        assert!(flag.iter().all(|dominant| *dominant == (attempt == 1)), "attempt {attempt}: {flag:?}");
        assert!(flag.len() >= 6);
    }
    // The passive flag of the second attempt did not disturb the frame that b was receiving from nobody else: b ran
    // into six recessive bits.
    assert_eq!(wire.error_state(b), ErrorState::Active);
}

// Rule j: error active again when both counters are below 128.
#[test]
fn j_a_passive_node_becomes_active_when_both_counters_allow() {
    let (mut wire, a, b) = two();
    preset(&mut wire, a, 129, 128);
    let mut seen = Vec::new();
    for _ in 0..2 {
        wire.send(a, frame("123#00")).unwrap();
        run(&mut wire, Time::from_us(200));
        seen.push((wire.error_counters(a), wire.error_state(a)));
    }
    assert_eq!(seen, [((128, 128), ErrorState::Passive), ((127, 128), ErrorState::Passive)]);
    wire.send(b, frame("123#00")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(states(&events, a), [ErrorState::Active]);
    assert_eq!(wire.error_counters(a), (127, 127));
}

// Rule k: bus off when the transmit error counter exceeds 255: 32 errors in a row from zero.
#[test]
fn k_32_transmit_errors_in_a_row_lead_to_bus_off() {
    let (mut wire, a, _b) = two();
    // Nothing dominant leaves a: every SOF is a bit error, and the active flags too.
    hold(&mut wire, Line::Tx(a), Disturbance::Recessive, Time::ZERO, Time::from_ms(100));
    let mut failures = 0;
    let mut values = Vec::new();
    while wire.error_state(a) != ErrorState::BusOff {
        wire.send(a, frame("123#00")).unwrap();
        let events = run(&mut wire, Time::from_us(400));
        failures += errors(&events, a).len();
        values.extend(counters(&events, a).into_iter().map(|(tec, _)| tec));
        assert!(failures <= 40, "bus off must come");
    }
    assert_eq!(failures, 32);
    let expected: Vec<u16> = (1..=32).map(|count| (8 * count).min(255)).collect();
    assert_eq!(values, expected);
    // It is silent and takes no requests.
    assert!(wire.send(a, frame("123#00")).is_err());
    assert!(run(&mut wire, Time::from_ms(5)).is_empty());
    assert_eq!(wire.tx_level(a), can_wire::Level::Recessive);
}

fn bus_off(recovery_sequences: u16) -> (Wire, NodeId, NodeId) {
    let (mut wire, nodes) = bench_of(2, NodeConfig { recovery_sequences, ..NodeConfig::new() });
    let (a, b) = (nodes[0], nodes[1]);
    preset(&mut wire, a, 250, 0);
    flip_seen(&mut wire, a, Field::Data, 2);
    wire.send(a, frame("123#0000")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(states(&events, a), [ErrorState::BusOff]);
    (wire, a, b)
}

// Rule l: 128 occurrences of 11 recessive bits, not one bit more or less.
#[test]
fn l_recovery_takes_128_times_11_recessive_bits() {
    for (setting, sequences) in [(128, 128), (129, 129u16)] {
        let (mut wire, a, _) = bus_off(setting);
        assert!(run(&mut wire, Time::from_ms(10)).is_empty(), "nothing happens before the request");
        wire.start_recovery(a).unwrap();
        let start = wire.now();
        let events = run(&mut wire, Time::from_ms(3));
        let done = events.iter().filter(|event| matches!(event.kind, EventKind::RecoverySequence { .. }));
        assert_eq!(done.count(), usize::from(sequences));
        let active = events.iter().find(|event| matches!(event.kind, EventKind::ErrorState { .. })).unwrap();
        assert_eq!(active.kind, EventKind::ErrorState { from: ErrorState::BusOff, to: ErrorState::Active });
        // The last of 128 * 11 bits is sampled at 80 % of it.
        let bits = 11 * u64::from(sequences);
        assert_eq!(active.time.since(start), BIT * (bits - 1) + Time::from_ns(800));
        assert_eq!(wire.error_counters(a), (0, 0));
        wire.send(a, frame("123#00")).unwrap();
        assert_eq!(transmitted(&run(&mut wire, Time::from_us(200)), a).len(), 1);
    }
}

// Rule l with traffic: a frame ends with 11 recessive bits (ACK delimiter, EOF, intermission), which count once;
// dominant bits start the row again.
#[test]
fn l_traffic_in_between_counts_once_per_frame() {
    let (mut wire, nodes) = bench_of(3, NodeConfig::new());
    let (a, b) = (nodes[0], nodes[1]);
    preset(&mut wire, a, 250, 0);
    flip_seen(&mut wire, a, Field::Data, 2);
    wire.send(a, frame("123#0000")).unwrap();
    run(&mut wire, Time::from_us(200));
    wire.start_recovery(a).unwrap();
    let (mut frames, mut sequences) = (0, 0);
    wire.send(b, frame("123#0000")).unwrap();
    let limit = wire.now() + Time::from_ms(30);
    while let Some(event) = wire.next_event(limit) {
        match event.kind {
            // Back to back: the next frame starts right after the intermission.
            EventKind::Transmitted { .. } => {
                frames += 1;
                wire.send(b, frame("123#0000")).unwrap();
            }
            EventKind::RecoverySequence { count } => sequences = count,
            EventKind::ErrorState { to: ErrorState::Active, .. } => break,
            _ => {}
        }
    }
    assert_eq!(sequences, 128);
    // One sequence at the end of each frame, none inside (no 11 recessive bits in a stuffed stream).
    assert!((127..=128).contains(&frames), "{frames} frames");
}

// A passive transmitter waits eight more bits before its next frame; others may start meanwhile.
#[test]
fn a_passive_transmitter_suspends_transmission() {
    let gap = |tec| {
        let (mut wire, a, _) = two();
        preset(&mut wire, a, tec, 0);
        wire.send(a, frame("123#00")).unwrap();
        let mut times = Vec::new();
        wire.run_until(wire.now() + Time::from_us(300), |wire, event| match event.kind {
            EventKind::Transmitted { .. } if times.is_empty() => {
                times.push(event.time);
                wire.send(a, frame("123#00")).unwrap();
            }
            EventKind::StartOfFrame { role: Role::Transmitter } if !times.is_empty() => times.push(event.time),
            _ => {}
        });
        times[1].since(times[0])
    };
    // From the sample point of the last bit of EOF: three bits of intermission, then SOF.
    assert_eq!(gap(0), BIT * 4);
    assert_eq!(gap(200), BIT * 12);
}

#[test]
fn another_node_may_start_while_a_passive_one_is_suspended() {
    let (mut wire, a, b) = two();
    preset(&mut wire, a, 200, 0);
    wire.send(a, frame("001#00")).unwrap();
    let mut order = Vec::new();
    let limit = wire.now() + Time::from_us(400);
    wire.run_until(limit, |wire, event| {
        if let EventKind::Transmitted { frame: sent, .. } = event.kind {
            order.push((event.node, sent));
            if order.len() == 1 {
                // a would win the arbitration, but b may start 8 bits earlier.
                wire.send(a, frame("002#00")).unwrap();
                wire.send(b, frame("700#00")).unwrap();
            }
        }
    });
    let order: Vec<_> = order.into_iter().map(|(node, sent)| (node, sent.raw_id())).collect();
    assert_eq!(order, [(a, 0x001), (b, 0x700), (a, 0x002)]);
}

// Error flags as others see them: dominant bits that superpose to 6 to 12.
#[test]
fn an_error_flag_is_six_to_twelve_dominant_bits_on_the_bus() {
    let lengths = |field, bit| {
        let (mut wire, a, b, _) = three();
        let trace = common::record(&mut wire);
        flip_seen(&mut wire, b, field, bit);
        wire.send(a, frame(CLEAN)).unwrap();
        run(&mut wire, Time::from_us(200));
        let trace = trace.lock().unwrap();
        let after_error =
            trace.bits.iter().filter(|bit| bit.node == b).skip_while(|bit| bit.position.field != Field::ErrorFlag);
        after_error.take_while(|bit| bit.seen.is_dominant()).count()
    };
    // b alone detects an error within the data and sends six dominant bits; at the sixth the others meet a stuff error,
    // or a bit error at the first, and add theirs.
    let in_data = lengths(Field::Crc, CLEAN_CRC_BIT);
    assert_eq!(in_data, 7, "the others answer to the first bit, in EOF");
    let (mut wire, a, b, _) = three();
    let trace = common::record(&mut wire);
    // b takes a stuff error while the others receive zeros: they need six dominant bits to notice.
    wire.inject(Fault::Bit {
        node: b,
        fault: BitFault::InvertSeen,
        position: Position::stuff_before(Field::BaseId, 4),
        frames: Frames::next(),
    });
    wire.send(a, frame("000#")).unwrap();
    run(&mut wire, Time::from_us(200));
    let trace = trace.lock().unwrap();
    let flag = trace.bits.iter().filter(|bit| bit.node == b).skip_while(|bit| bit.position.field != Field::ErrorFlag);
    let length = flag.take_while(|bit| bit.seen.is_dominant()).count();
    assert!((6..=12).contains(&length), "{length}");
}

// A receiver that sees a dominant last bit of EOF takes the frame and sends an overload flag; the transmitter takes it
// for an error and sends again: the well-known double reception.
#[test]
fn a_dominant_last_bit_of_eof_is_an_overload_condition_for_receivers_only() {
    let (mut wire, a, b) = two();
    let at = sample_time(
        || {
            let (wire, a, _) = two();
            (wire, a)
        },
        "123#00",
        a,
        Position::new(Field::Eof, 6),
    );
    hold(&mut wire, Line::Bus, Disturbance::Dominant, at.since(Time::from_ns(700)), at + HALF);
    wire.send(a, frame("123#00")).unwrap();
    let mut events = Vec::new();
    wire.run_until(wire.now() + Time::from_us(400), |wire, event| {
        if matches!(event.kind, EventKind::TransmissionFailed(_)) {
            wire.send(a, frame("123#00")).unwrap();
        }
        events.push(event);
    });
    assert_eq!(received(&events, b).len(), 2);
    assert_eq!(transmitted(&events, a).len(), 1);
    let overload = events.iter().find(|event| event.node == b && matches!(event.kind, EventKind::Overload(_)));
    assert_eq!(overload.unwrap().kind, EventKind::Overload(OverloadCause::LastBitOfEof));
    assert_eq!(errors(&events, a), [(ErrorKind::Bit1, Position::new(Field::Eof, 6))]);
    assert_eq!(wire.error_counters(b), (0, 0), "an overload condition is no error");
}

#[test]
fn modes_without_error_signalling_do_not_count() {
    for mode in [Mode::ListenOnly, Mode::Restricted] {
        let (mut wire, a, _, c) = three();
        wire.set_mode(c, mode);
        flip_seen(&mut wire, c, Field::Crc, CLEAN_CRC_BIT);
        wire.send(a, frame(CLEAN)).unwrap();
        let events = run(&mut wire, Time::from_us(300));
        assert_eq!(errors(&events, c).len(), 1, "{mode:?} detects");
        assert_eq!(wire.error_counters(c), (0, 0), "{mode:?} does not count");
        assert_eq!(transmitted(&events, a).len(), 1, "{mode:?} does not disturb");
    }
}
