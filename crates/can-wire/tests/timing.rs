//! Clocks that differ, bit timings that do not fit, delays: what synchronization can make up for and what it cannot.
#![allow(clippy::unwrap_used)]

mod common;

use can_frame::{Dlc, Format, Frame, StandardId};
use can_wire::{
    BitTiming, ErrorKind, ErrorState, Event, EventKind, FdSupport, NodeConfig, Role, Time,
};
use common::{Random, bench, bench_of, frame, frames, run};

/// 40 quanta, sample point at 80 %, 0.5 % fast.
fn fast() -> NodeConfig {
    NodeConfig {
        clock_ppm: 5_000,
        ..NodeConfig::new()
    }
}

/// 20 quanta, sample point at 65 %, 0.5 % slow, another clock.
fn slow() -> NodeConfig {
    let nominal = BitTiming {
        prescaler: 4,
        prop_seg: 5,
        phase_seg1: 7,
        phase_seg2: 7,
        sjw: 4,
    };
    let data = BitTiming {
        prescaler: 1,
        prop_seg: 4,
        phase_seg1: 6,
        phase_seg2: 5,
        sjw: 5,
    };
    NodeConfig {
        clock_hz: 80_000_000,
        clock_ppm: -5_000,
        nominal,
        data,
        ..NodeConfig::new()
    }
}

/// Frames with the longest stretches without an edge, and random ones.
fn hard_frame(random: &mut Random) -> Frame {
    let data = frames::any_data(random);
    Frame::from_fields(
        frames::any_id(random),
        Format::Data,
        Dlc::new(8).unwrap(),
        &data,
    )
}

fn errors(events: &[Event]) -> Vec<&Event> {
    events
        .iter()
        .filter(|event| matches!(event.kind, EventKind::Error(_)))
        .collect()
}

#[test]
fn different_legal_timings_with_half_a_percent_communicate() {
    let (a, b) = (fast(), slow());
    assert_eq!(
        (
            a.nominal.bit_rate(a.clock_hz),
            b.nominal.bit_rate(b.clock_hz)
        ),
        (1_000_000, 1_000_000)
    );
    assert!(a.nominal.tolerance_ppm() >= 5_000 && b.nominal.tolerance_ppm() >= 5_000);
    let (mut wire, nodes) = bench(&[a, b]);
    let mut random = Random::new(0x05C1);
    for index in 0..1_000 {
        let frame = hard_frame(&mut random);
        let sender = nodes[index % 2];
        wire.send(sender, frame).unwrap();
        let events = run(&mut wire, Time::from_us(180));
        assert!(
            errors(&events).is_empty(),
            "frame {index} {frame}: {}",
            errors(&events)[0]
        );
        assert_eq!(common::received(&events, nodes[1 - index % 2]), [frame]);
    }
}

#[test]
fn fd_frames_with_clocks_within_the_tolerance_communicate() {
    // Nodes that switch the bit rate need the same sample points: the switch happens there.
    let nominal = BitTiming {
        prescaler: 4,
        prop_seg: 7,
        phase_seg1: 8,
        phase_seg2: 4,
        sjw: 4,
    };
    let data = BitTiming {
        prescaler: 1,
        prop_seg: 4,
        phase_seg1: 7,
        phase_seg2: 4,
        sjw: 4,
    };
    let (a, b) = (
        fast(),
        NodeConfig {
            nominal,
            data,
            ..slow()
        },
    );
    let ppm = a
        .nominal
        .tolerance_with_data_ppm(&a.data)
        .min(b.nominal.tolerance_with_data_ppm(&b.data)) as i32;
    assert!(ppm >= 2_000, "{ppm} ppm");
    let (mut wire, nodes) = bench(&[
        NodeConfig {
            clock_ppm: ppm,
            ..a
        },
        NodeConfig {
            clock_ppm: -ppm,
            ..b
        },
    ]);
    let mut random = Random::new(0x05C2);
    for index in 0..500 {
        let frame = frames::any_fd(&mut random);
        wire.send(nodes[index % 2], frame).unwrap();
        let events = run(&mut wire, Time::from_us(900));
        assert!(
            errors(&events).is_empty(),
            "frame {index} {frame}: {}",
            errors(&events)[0]
        );
    }
}

/// Sends frames without edges for ten bits from `a` and returns the first error at `b`.
fn first_error(a: NodeConfig, b: NodeConfig) -> Option<ErrorKind> {
    let (mut wire, nodes) = bench(&[a, b]);
    for text in [
        "555#FFFFFFFFFFFFFFFF",
        "2AA#0000000000000000",
        "7FF#00FF00FF00FF00FF",
    ] {
        wire.send(nodes[0], frame(text)).unwrap();
        for event in run(&mut wire, Time::from_us(300)) {
            match event.kind {
                EventKind::Error(error) if event.node == nodes[1] => {
                    assert_eq!(error.role, Role::Receiver);
                    return Some(error.kind);
                }
                _ => {}
            }
        }
    }
    None
}

#[test]
fn a_jump_width_that_the_formula_forbids_fails() {
    let narrow = |config: NodeConfig| NodeConfig {
        nominal: BitTiming {
            sjw: 1,
            ..config.nominal
        },
        ..config
    };
    assert!(narrow(fast()).nominal.tolerance_ppm() < 5_000);
    assert_eq!(first_error(fast(), slow()), None);
    // The receiver drifts away from the transmitter: it samples a bit twice or misses one.
    let error = first_error(
        fast(),
        NodeConfig {
            clock_ppm: -5_000,
            ..narrow(NodeConfig::new())
        },
    );
    assert!(
        matches!(
            error,
            Some(ErrorKind::Stuff | ErrorKind::Crc | ErrorKind::Form)
        ),
        "{error:?}"
    );
}

#[test]
fn a_sample_point_that_the_formula_forbids_fails() {
    let late = BitTiming {
        prescaler: 1,
        prop_seg: 19,
        phase_seg1: 19,
        phase_seg2: 1,
        sjw: 1,
    };
    assert!(late.tolerance_ppm() < 5_000);
    // A fast transmitter's bit is over before the slow receiver samples it.
    let error = first_error(
        fast(),
        NodeConfig {
            nominal: late,
            clock_ppm: -5_000,
            ..NodeConfig::new()
        },
    );
    assert!(
        matches!(
            error,
            Some(ErrorKind::Stuff | ErrorKind::Crc | ErrorKind::Form)
        ),
        "{error:?}"
    );
    assert_eq!(
        first_error(
            NodeConfig::new(),
            NodeConfig {
                nominal: late,
                ..NodeConfig::new()
            }
        ),
        None
    );
}

#[test]
fn a_node_at_the_wrong_bit_rate_disturbs_the_others_and_goes_passive() {
    for rate in [500_000, 250_000, 800_000] {
        // A node that knows FD frames may take what it sees for a protocol exception and wait instead.
        let wrong = NodeConfig {
            fd: FdSupport::Classic,
            ..NodeConfig::new().with_rate(rate).unwrap()
        };
        let (mut wire, nodes) = bench(&[NodeConfig::new(), NodeConfig::new(), wrong]);
        let text = "123#0123456789ABCDEF";
        wire.send(nodes[0], frame(text)).unwrap();
        let (mut disturbed, mut passive_after) = (0, None);
        let limit = wire.now() + Time::from_ms(200);
        while let Some(event) = wire.next_event(limit) {
            match event.kind {
                EventKind::TransmissionFailed(_)
                | EventKind::ArbitrationLost { .. }
                | EventKind::Transmitted { .. }
                    if event.node == nodes[0] =>
                {
                    // An error flag in the identifier looks like lost arbitration at first.
                    disturbed += u32::from(!matches!(event.kind, EventKind::Transmitted { .. }));
                    if wire.error_state(nodes[0]) != ErrorState::BusOff {
                        wire.send(nodes[0], frame(text)).unwrap();
                    }
                }
                EventKind::ErrorState {
                    to: ErrorState::BusOff,
                    ..
                } => wire.start_recovery(event.node).unwrap(),
                EventKind::ErrorState {
                    from: ErrorState::BusOff,
                    ..
                } if event.node == nodes[0] => {
                    wire.send(nodes[0], frame(text)).unwrap();
                }
                EventKind::ErrorState {
                    to: ErrorState::Passive,
                    ..
                } if event.node == nodes[2] => {
                    passive_after.get_or_insert(disturbed);
                }
                EventKind::Received { .. } => {
                    assert_ne!(event.node, nodes[2], "it cannot have understood")
                }
                _ => {}
            }
        }
        assert!(
            disturbed > 3,
            "{rate} bit/s: {disturbed} transmissions failed"
        );
        assert!(
            passive_after.is_some(),
            "{rate} bit/s: the wrong node went passive"
        );
    }
}

/// A loop delay beyond the nominal sample point leaves no room for the acknowledgement.
#[test]
fn too_long_a_bus_cannot_be_acknowledged_in_time() {
    let far = |ns| NodeConfig {
        tx_delay: Time::from_ns(ns),
        rx_delay: Time::from_ns(ns),
        ..NodeConfig::new()
    };
    let works = |ns| {
        let (mut wire, nodes) = bench_of(2, far(ns));
        wire.send(nodes[0], frame("123#0123")).unwrap();
        !common::transmitted(&run(&mut wire, Time::from_us(200)), nodes[0]).is_empty()
    };
    // There and back again, both ways through two half delays: four times `ns` up to 800 ns, plus what the jump width
    // of 8 quanta can make up for at the edge of the acknowledgement.
    assert!(works(150) && works(195));
    assert!(!works(420));
}

#[test]
fn an_identifier_makes_no_difference_to_the_time_of_validity() {
    // Valid for receivers at the last but one bit of EOF, for the transmitter at the last.
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    wire.send(nodes[0], Frame::data(StandardId::MAX, &[1, 2, 3]).unwrap())
        .unwrap();
    let events = run(&mut wire, Time::from_us(200));
    let time = |node, wanted: fn(&EventKind) -> bool| {
        events
            .iter()
            .find(|event| event.node == node && wanted(&event.kind))
            .unwrap()
            .time
    };
    let valid = time(nodes[1], |kind| matches!(kind, EventKind::Received { .. }));
    let sent = time(nodes[0], |kind| {
        matches!(kind, EventKind::Transmitted { .. })
    });
    assert_eq!(sent.since(valid), Time::from_us(1));
}
