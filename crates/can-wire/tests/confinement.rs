//! Fault confinement: one test per rule, with the counters after each step.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{
    BitFault, Disturbance, ErrorKind, ErrorState, Event, EventKind, Fault, Field, Frames, Line,
    Mode, NodeConfig, NodeId, OverloadCause, Position, Role, Time, Wire,
};
use common::{bench_of, frame, received, run, transmitted};

const BIT: Time = Time::from_us(1);

fn two() -> (Wire, NodeId, NodeId) {
    let (wire, nodes) = bench_of(2, NodeConfig::new());
    (wire, nodes[0], nodes[1])
}

fn three() -> (Wire, NodeId, NodeId, NodeId) {
    let (wire, nodes) = bench_of(3, NodeConfig::new());
    (wire, nodes[0], nodes[1], nodes[2])
}

/// Sets the counters and takes in the events that tell of it.
fn preset(wire: &mut Wire, node: NodeId, tec: u16, rec: u16) {
    wire.set_error_counters(node, tec, rec);
    while wire.next_event(wire.now()).is_some() {}
}

/// A frame of which bit 9 of the CRC can be inverted without a stuff error.
const CLEAN: &str = "123#DEADBEEF";
const CLEAN_CRC_BIT: u16 = 9;

fn flip_seen(wire: &mut Wire, node: NodeId, field: Field, bit: u16) {
    let position = Position::new(field, bit);
    wire.inject(Fault::Bit {
        node,
        fault: BitFault::InvertSeen,
        position,
        frames: Frames::next(),
    });
}

fn errors(events: &[Event], node: NodeId) -> Vec<(ErrorKind, Position)> {
    let of_node = events.iter().filter(|event| event.node == node);
    of_node
        .filter_map(|event| match event.kind {
            EventKind::Error(error) => Some((error.kind, error.position)),
            _ => None,
        })
        .collect()
}

/// Every value that the counters of a node take.
fn counters(events: &[Event], node: NodeId) -> Vec<(u16, u16)> {
    let of_node = events.iter().filter(|event| event.node == node);
    of_node
        .filter_map(|event| match event.kind {
            EventKind::Counters { tec, rec } => Some((tec, rec)),
            _ => None,
        })
        .collect()
}

fn states(events: &[Event], node: NodeId) -> Vec<ErrorState> {
    let of_node = events.iter().filter(|event| event.node == node);
    of_node
        .filter_map(|event| match event.kind {
            EventKind::ErrorState { to, .. } => Some(to),
            _ => None,
        })
        .collect()
}

/// Holds a line for some bits, starting in the middle of the bit that begins `at` bits after now.
fn hold(wire: &mut Wire, line: Line, how: Disturbance, from: Time, until: Time) {
    wire.inject(Fault::Disturb {
        line,
        how,
        from,
        until,
    });
}

/// Time at which a node samples a bit of a frame that node `sender` starts next, found in a run that is thrown away.
fn sample_time(
    build: impl Fn() -> (Wire, NodeId),
    text: &str,
    of: NodeId,
    position: Position,
) -> Time {
    let (mut wire, sender) = build();
    let trace = common::record(&mut wire);
    wire.send(sender, frame(text)).unwrap();
    run(&mut wire, Time::from_us(200));
    let trace = trace.lock().unwrap();
    trace
        .bits
        .iter()
        .find(|bit| bit.node == of && bit.position == position)
        .unwrap()
        .sample
}

// Rule a: a receiver that detects an error counts 1.
#[test]
fn a_receiver_counts_one_per_error() {
    let (mut wire, a, b, c) = three();
    // A CRC error is signalled after the ACK delimiter. Node c acknowledges, so the transmitter sees nothing until
    // then.
    flip_seen(&mut wire, b, Field::Crc, CLEAN_CRC_BIT);
    wire.send(a, frame(CLEAN)).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(
        errors(&events, b),
        [(ErrorKind::Crc, Position::new(Field::AckDelimiter, 0))]
    );
    assert_eq!(counters(&events, b)[0], (0, 1), "by 1 for the error itself");
    // The others see the first bit of the error flag where EOF begins.
    assert_eq!(
        errors(&events, c),
        [(ErrorKind::Form, Position::new(Field::Eof, 0))]
    );
    assert_eq!(
        errors(&events, a),
        [(ErrorKind::Bit1, Position::new(Field::Eof, 0))]
    );
    assert!(received(&events, c).is_empty() && transmitted(&events, a).is_empty());
}

// Rule b: a receiver that sees a dominant bit right after its error flag was first, and counts 8.
#[test]
fn b_the_first_receiver_to_signal_counts_eight_more() {
    let (mut wire, a, b, c) = three();
    flip_seen(&mut wire, b, Field::Crc, CLEAN_CRC_BIT);
    wire.send(a, frame(CLEAN)).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    // b's flag begins one bit before those of a and c, so b sees one more dominant bit after it.
    assert_eq!(counters(&events, b), [(0, 1), (0, 9)]);
    // c acknowledged the frame before it met the error, and its REC was 0.
    assert_eq!(counters(&events, c), [(0, 1)]);
    assert_eq!(counters(&events, a), [(8, 0)]);
}

// Rule c: a transmitter that sends an error flag counts 8.
#[test]
fn c_a_transmitter_counts_eight_per_error() {
    let (mut wire, a, b) = two();
    let text = "123#0000";
    for step in 1..=3u16 {
        wire.inject(Fault::Bit {
            node: a,
            fault: BitFault::InvertSeen,
            position: Position::new(Field::Data, 2),
            frames: Frames::next_of(a),
        });
        wire.send(a, frame(text)).unwrap();
        let events = run(&mut wire, Time::from_us(200));
        assert_eq!(
            errors(&events, a),
            [(ErrorKind::Bit0, Position::new(Field::Data, 2))]
        );
        assert_eq!(wire.error_counters(a), (8 * step, 0));
        // The receiver sees six dominant bits: a stuff error, and no dominant bit after its own flag.
        assert_eq!(errors(&events, b).len(), 1);
        assert_eq!(wire.error_counters(b), (0, step));
    }
}

// Rule c, exception 1: error passive, no acknowledgement, no dominant bit during the passive flag.
#[test]
fn c1_a_passive_transmitter_alone_stays_at_128() {
    let (mut wire, nodes) = bench_of(1, NodeConfig::new());
    let a = nodes[0];
    let mut seen = Vec::new();
    for _ in 0..40 {
        wire.send(a, frame("123#")).unwrap();
        let events = run(&mut wire, Time::from_us(200));
        assert_eq!(
            errors(&events, a),
            [(ErrorKind::Ack, Position::new(Field::AckSlot, 0))]
        );
        seen.push(wire.error_counters(a).0);
    }
    let expected: Vec<u16> = (1..=40).map(|attempt| (8 * attempt).min(128)).collect();
    assert_eq!(seen, expected);
    assert_eq!(wire.error_state(a), ErrorState::Passive);
}

// The other side of exception 1: a dominant bit in the passive flag makes it count.
#[test]
fn c1_does_not_apply_when_the_passive_flag_meets_a_dominant_bit() {
    let (mut wire, a, b) = two();
    preset(&mut wire, a, 128, 0);
    // b drops its acknowledgement, and a short makes the third bit of a's passive flag dominant.
    wire.inject(Fault::DropAck {
        node: b,
        frames: Frames::next(),
    });
    let start = {
        let build = || {
            let (mut wire, nodes) = bench_of(2, NodeConfig::new());
            preset(&mut wire, nodes[0], 128, 0);
            (wire, nodes[0])
        };
        sample_time(build, "123#", a, Position::new(Field::AckDelimiter, 0))
    };
    let from = start + BIT * 2;
    hold(
        &mut wire,
        Line::Bus,
        Disturbance::Dominant,
        from.since(HALF),
        from + HALF,
    );
    wire.send(a, frame("123#")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(
        errors(&events, a)[0],
        (ErrorKind::Ack, Position::new(Field::AckSlot, 0))
    );
    assert_eq!(counters(&events, a)[0], (136, 0));
}

/// Enough to cover a sample point from both sides.
const HALF: Time = Time::from_ns(300);

// Rule c, exception 2: a stuff bit of the arbitration field, sent recessive and seen dominant.
#[test]
fn c2_a_stuff_error_in_arbitration_does_not_count() {
    let (mut wire, a, b) = two();
    let position = Position::stuff_before(Field::BaseId, 4);
    // The identifier 0 has its first stuff bit before its fifth bit: SOF and four zeros.
    let at = sample_time(
        || {
            let (wire, a, _) = two();
            (wire, a)
        },
        "000#",
        a,
        position,
    );
    hold(
        &mut wire,
        Line::Bus,
        Disturbance::Dominant,
        at.since(Time::from_ns(700)),
        at + HALF,
    );
    wire.send(a, frame("000#")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(errors(&events, a), [(ErrorKind::Stuff, position)]);
    assert_eq!(counters(&events, a), [], "TEC and REC stay");
    assert_eq!(counters(&events, b), [(0, 1)]);
    let failed = events
        .iter()
        .any(|event| event.node == a && matches!(event.kind, EventKind::TransmissionFailed(_)));
    assert!(failed, "the transmission has failed all the same");
}

// Rule d: a transmitter that meets a bit error in its active error flag counts 8.
#[test]
fn d_bit_errors_in_a_transmitters_flag_count_eight_each() {
    let (mut wire, a, _) = two();
    flip_seen(&mut wire, a, Field::Data, 2);
    for bit in [0, 3] {
        flip_seen(&mut wire, a, Field::ErrorFlag, bit);
    }
    wire.send(a, frame("123#0000")).unwrap();
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(counters(&events, a)[..3], [(8, 0), (16, 0), (24, 0)]);
    let kinds: Vec<_> = errors(&events, a)
        .into_iter()
        .map(|(kind, _)| kind)
        .collect();
    assert_eq!(
        kinds[..3],
        [ErrorKind::Bit0, ErrorKind::Bit0, ErrorKind::Bit0]
    );
}

// Rule d, overload flag.
#[test]
fn d_bit_errors_in_a_transmitters_overload_flag_count_eight() {
    let (mut wire, a, _) = two();
    wire.request_overload(a);
    flip_seen(&mut wire, a, Field::OverloadFlag, 2);
    wire.send(a, frame("123#00")).unwrap();
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(counters(&events, a)[0], (8, 0));
    assert_eq!(
        errors(&events, a)[0],
        (ErrorKind::Bit0, Position::new(Field::OverloadFlag, 2))
    );
}

// Rule e: a receiver that meets a bit error in its active error flag or overload flag counts 8.
#[test]
fn e_bit_errors_in_a_receivers_flags_count_eight_each() {
    let (mut wire, a, b) = two();
    flip_seen(&mut wire, b, Field::Crc, CLEAN_CRC_BIT);
    flip_seen(&mut wire, b, Field::ErrorFlag, 1);
    wire.send(a, frame(CLEAN)).unwrap();
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(counters(&events, b)[..2], [(0, 1), (0, 9)]);

    let (mut wire, a, b) = two();
    wire.request_overload(b);
    flip_seen(&mut wire, b, Field::OverloadFlag, 1);
    wire.send(a, frame(CLEAN)).unwrap();
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(counters(&events, b)[0], (0, 8));
}

/// Shorts the bus dominant after the flag of an error and returns the counters of transmitter and receiver for each
/// number of dominant bits after the flag.
fn dominant_after_flag(bits: u64, passive: bool) -> ((u16, u16), (u16, u16)) {
    let build = |wire: &mut Wire, a: NodeId| {
        if passive {
            preset(wire, a, 130, 0);
        }
        flip_seen(wire, a, Field::Data, 2);
    };
    let (mut probe, a, _) = two();
    build(&mut probe, a);
    let trace = common::record(&mut probe);
    probe.send(a, frame("123#0000")).unwrap();
    run(&mut probe, Time::from_us(200));
    let first = {
        let trace = trace.lock().unwrap();
        let after = |bit: &&can_wire::BitRecord| {
            bit.node == a && bit.position == Position::new(Field::ErrorDelimiter, 0)
        };
        trace.bits.iter().find(after).unwrap().start
    };
    let (mut wire, a, b) = two();
    build(&mut wire, a);
    let from = first + Time::from_ns(100);
    hold(
        &mut wire,
        Line::Bus,
        Disturbance::Dominant,
        from,
        from + BIT * bits,
    );
    wire.send(a, frame("123#0000")).unwrap();
    run(&mut wire, Time::from_us(200));
    (wire.error_counters(a), wire.error_counters(b))
}

// Rule f: up to seven dominant bits after a flag are tolerated; the eighth and every eighth after it count 8.
#[test]
fn f_a_long_row_of_dominant_bits_counts() {
    // An active transmitter: 8 for its error, then 8 for each sequence.
    let transmitter: Vec<u16> = [0, 7, 8, 15, 16, 24]
        .map(|bits| dominant_after_flag(bits, false).0.0)
        .to_vec();
    assert_eq!(transmitter, [8, 8, 16, 16, 24, 32]);
    // The receiver: 1 for its stuff error, 8 by rule b as soon as one more bit follows its own flag. Its flag ends
    // later than the transmitter's, so it counts the same bits later.
    let receiver = |bits| dominant_after_flag(bits, false).1.1;
    let flags = (0..40).map(receiver).collect::<Vec<u16>>();
    assert_eq!(flags[0], 1);
    let steps: Vec<u64> = (1..40)
        .filter(|bits| flags[*bits as usize] != flags[*bits as usize - 1])
        .collect();
    assert_eq!(flags[steps[0] as usize], 9, "rule b");
    assert_eq!(flags[steps[1] as usize], 17, "rule f");
    assert_eq!(
        steps[1] - steps[0],
        7,
        "the eighth bit, the first of which counted by rule b"
    );
    assert_eq!(steps[2] - steps[1], 8);
}

// Rule f, passive flag: a node that sends a passive flag tolerates seven dominant bits after it.
#[test]
fn f_holds_for_passive_flags_too() {
    let counts: Vec<u16> = [0, 7, 8, 16]
        .map(|bits| dominant_after_flag(bits, true).0.0)
        .to_vec();
    // 130 + 8 for the error; the frame has six recessive bits only after the receiver's flag.
    let base = counts[0];
    assert_eq!(
        counts.iter().map(|count| count - base).collect::<Vec<_>>(),
        [0, 0, 8, 16]
    );
}

// Rule g: a successful transmission counts down by 1, not below 0.
#[test]
fn g_a_transmission_counts_down_by_one() {
    let (mut wire, a, _) = two();
    preset(&mut wire, a, 3, 0);
    let mut seen = Vec::new();
    for _ in 0..5 {
        wire.send(a, frame("123#00")).unwrap();
        run(&mut wire, Time::from_us(200));
        seen.push(wire.error_counters(a).0);
    }
    assert_eq!(seen, [2, 1, 0, 0, 0]);
}

// Rule h: a reception counts down by 1, from above 127 to the configured value between 119 and 127.
#[test]
fn h_a_reception_counts_down_by_one_or_to_the_edge_of_passive() {
    for after in [119, 127] {
        let config = NodeConfig {
            rec_after_passive: after,
            ..NodeConfig::new()
        };
        let (mut wire, nodes) = bench_of(2, config);
        let (a, b) = (nodes[0], nodes[1]);
        preset(&mut wire, b, 0, 140);
        let mut seen = Vec::new();
        for _ in 0..3 {
            wire.send(a, frame("123#00")).unwrap();
            run(&mut wire, Time::from_us(200));
            seen.push(wire.error_counters(b).1);
        }
        let after = u16::from(after);
        assert_eq!(seen, [after, after - 1, after - 2]);
        assert_eq!(wire.error_state(b), ErrorState::Active);
    }
    let (mut wire, a, b) = two();
    preset(&mut wire, b, 0, 1);
    for expected in [0, 0] {
        wire.send(a, frame("123#00")).unwrap();
        run(&mut wire, Time::from_us(200));
        assert_eq!(wire.error_counters(b), (0, expected));
    }
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
        assert!(
            flag.iter().all(|dominant| *dominant == (attempt == 1)),
            "attempt {attempt}: {flag:?}"
        );
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
    assert_eq!(
        seen,
        [
            ((128, 128), ErrorState::Passive),
            ((127, 128), ErrorState::Passive)
        ]
    );
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
    hold(
        &mut wire,
        Line::Tx(a),
        Disturbance::Recessive,
        Time::ZERO,
        Time::from_ms(100),
    );
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
    let (mut wire, nodes) = bench_of(
        2,
        NodeConfig {
            recovery_sequences,
            ..NodeConfig::new()
        },
    );
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
        assert!(
            run(&mut wire, Time::from_ms(10)).is_empty(),
            "nothing happens before the request"
        );
        wire.start_recovery(a).unwrap();
        let start = wire.now();
        let events = run(&mut wire, Time::from_ms(3));
        let done = events
            .iter()
            .filter(|event| matches!(event.kind, EventKind::RecoverySequence { .. }));
        assert_eq!(done.count(), usize::from(sequences));
        let active = events
            .iter()
            .find(|event| matches!(event.kind, EventKind::ErrorState { .. }))
            .unwrap();
        assert_eq!(
            active.kind,
            EventKind::ErrorState {
                from: ErrorState::BusOff,
                to: ErrorState::Active
            }
        );
        // The last of 128 * 11 bits is sampled at 80 % of it.
        let bits = 11 * u64::from(sequences);
        assert_eq!(
            active.time.since(start),
            BIT * (bits - 1) + Time::from_ns(800)
        );
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
            EventKind::ErrorState {
                to: ErrorState::Active,
                ..
            } => break,
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
        wire.run_until(wire.now() + Time::from_us(300), |wire, event| {
            match event.kind {
                EventKind::Transmitted { .. } if times.is_empty() => {
                    times.push(event.time);
                    wire.send(a, frame("123#00")).unwrap();
                }
                EventKind::StartOfFrame {
                    role: Role::Transmitter,
                } if !times.is_empty() => times.push(event.time),
                _ => {}
            }
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
    let order: Vec<_> = order
        .into_iter()
        .map(|(node, sent)| (node, sent.raw_id()))
        .collect();
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
        let after_error = trace
            .bits
            .iter()
            .filter(|bit| bit.node == b)
            .skip_while(|bit| bit.position.field != Field::ErrorFlag);
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
    let flag = trace
        .bits
        .iter()
        .filter(|bit| bit.node == b)
        .skip_while(|bit| bit.position.field != Field::ErrorFlag);
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
    hold(
        &mut wire,
        Line::Bus,
        Disturbance::Dominant,
        at.since(Time::from_ns(700)),
        at + HALF,
    );
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
    let overload = events
        .iter()
        .find(|event| event.node == b && matches!(event.kind, EventKind::Overload(_)));
    assert_eq!(
        overload.unwrap().kind,
        EventKind::Overload(OverloadCause::LastBitOfEof)
    );
    assert_eq!(
        errors(&events, a),
        [(ErrorKind::Bit1, Position::new(Field::Eof, 6))]
    );
    assert_eq!(
        wire.error_counters(b),
        (0, 0),
        "an overload condition is no error"
    );
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
        assert_eq!(
            transmitted(&events, a).len(),
            1,
            "{mode:?} does not disturb"
        );
    }
}
