//! Fault confinement: one test per rule of the counters, with their values after each step.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{
    BitFault, Disturbance, ErrorKind, ErrorState, EventKind, Fault, Field, Frames, Line,
    NodeConfig, NodeId, Position, Time, Wire,
};
use common::{bench_of, confine::*, frame, received, run, transmitted};

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
