//! Requests and what comes of them: frames, aborts, mode changes, overload, faults of the lines.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{
    Abort, BitFault, BusError, Disturbance, ErrorKind, Event, EventKind, Fault, Field, Frames,
    Level, Line, Mode, NodeConfig, NodeId, OverloadCause, Position, RequestError, Role, Time,
};
use common::{bench, bench_of, frame, received, run, transmitted};

const BIT: Time = Time::from_us(1);

fn count(events: &[Event], node: NodeId, wanted: impl Fn(&EventKind) -> bool) -> usize {
    events
        .iter()
        .filter(|event| event.node == node && wanted(&event.kind))
        .count()
}

fn is_error(kind: &EventKind) -> bool {
    matches!(kind, EventKind::Error(_))
}

#[test]
fn a_request_can_be_replaced_until_its_start_of_frame() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    wire.send(nodes[1], frame("100#")).unwrap();
    run(&mut wire, Time::from_us(10));
    assert_eq!(wire.send(nodes[0], frame("300#")), Ok(None));
    assert_eq!(wire.send(nodes[0], frame("200#")), Ok(Some(frame("300#"))));
    assert_eq!(wire.requested(nodes[0]), Some(frame("200#")));
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(transmitted(&events, nodes[0]), [frame("200#")]);
    assert_eq!(wire.requested(nodes[0]), None);
}

#[test]
fn abort_drops_what_has_not_started_and_tells_what_has() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    assert_eq!(wire.abort(nodes[0]), Abort::Nothing);
    wire.send(nodes[0], frame("123#")).unwrap();
    assert_eq!(wire.abort(nodes[0]), Abort::Dropped(frame("123#")));
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(
        events.iter().map(|event| event.kind).collect::<Vec<_>>(),
        [EventKind::Aborted {
            frame: frame("123#")
        }]
    );
    wire.send(nodes[0], frame("123#")).unwrap();
    run(&mut wire, Time::from_us(20));
    assert_eq!(wire.abort(nodes[0]), Abort::OnTheBus(frame("123#")));
    assert_eq!(
        transmitted(&run(&mut wire, Time::from_us(200)), nodes[0]).len(),
        1
    );
}

#[test]
fn a_mode_at_idle_waits_for_the_end_of_the_frame() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    wire.send(nodes[0], frame("123#AA")).unwrap();
    run(&mut wire, Time::from_us(20));
    wire.set_mode_at_idle(nodes[0], Mode::Off);
    assert_eq!(wire.mode(nodes[0]), Mode::Normal);
    let events = run(&mut wire, Time::from_us(200));
    let order: Vec<_> = events
        .iter()
        .filter(|event| event.node == nodes[0])
        .map(|event| event.kind)
        .collect();
    assert!(
        matches!(
            order[..],
            [
                EventKind::Transmitted { .. },
                EventKind::ModeChanged { mode: Mode::Off }
            ]
        ),
        "{order:?}"
    );
}

#[test]
fn switching_off_in_the_middle_of_a_frame_leaves_an_error_to_the_others() {
    let (mut wire, nodes) = bench_of(3, NodeConfig::new());
    wire.send(nodes[0], frame("123#0011223344556677")).unwrap();
    run(&mut wire, Time::from_us(40));
    wire.set_mode(nodes[0], Mode::Off);
    assert_eq!(wire.tx_level(nodes[0]), Level::Recessive);
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(
        count(&events, nodes[0], |kind| matches!(
            kind,
            EventKind::Aborted { .. }
        )),
        1
    );
    let stuff = |kind: &EventKind| {
        matches!(
            kind,
            EventKind::Error(BusError {
                kind: ErrorKind::Stuff,
                ..
            })
        )
    };
    assert_eq!(count(&events, nodes[1], stuff), 1);
}

#[test]
fn data_up_to_an_error_is_available() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    let position = Position::new(Field::Data, 20);
    wire.inject(Fault::Bit {
        node: nodes[0],
        fault: BitFault::InvertDriven,
        position,
        frames: Frames::next(),
    });
    wire.send(nodes[0], frame("12345678#0123456789")).unwrap();
    let limit = wire.now() + Time::from_us(200);
    while let Some(event) = wire.next_event(limit) {
        if event.node == nodes[1] && is_error(&event.kind) {
            let partial = wire.partial_frame(nodes[1]);
            // 0x45 was cut short by the inverted bit and the error flag that followed.
            assert_eq!(partial.data_bytes, 3);
            assert_eq!(partial.frame, Some(frame("12345678#0123480000")));
            return;
        }
    }
    panic!("no error");
}

#[test]
fn the_error_state_goes_out_with_the_frame() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    wire.send(nodes[0], frame("123##0AA")).unwrap();
    assert_eq!(
        received(&run(&mut wire, Time::from_us(200)), nodes[1]),
        [frame("123##0AA")]
    );
    wire.set_error_counters(nodes[0], 130, 0);
    wire.send(nodes[0], frame("123##0AA")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(received(&events, nodes[1]), [frame("123##2AA")]);
    assert_eq!(
        transmitted(&events, nodes[0]),
        [frame("123##2AA")],
        "as it was on the bus"
    );
    // A gateway may set it for someone else.
    wire.set_error_counters(nodes[0], 0, 0);
    wire.send(nodes[0], frame("123##2AA")).unwrap();
    assert_eq!(
        received(&run(&mut wire, Time::from_us(200)), nodes[1]),
        [frame("123##2AA")]
    );
}

#[test]
fn at_most_two_requested_overload_frames_delay_the_next_frame() {
    let gap = |requests| {
        let (mut wire, nodes) = bench_of(2, NodeConfig::new());
        for _ in 0..requests {
            wire.request_overload(nodes[1]);
        }
        wire.send(nodes[0], frame("123#")).unwrap();
        let mut times = Vec::new();
        wire.run_until(wire.now() + Time::from_us(400), |wire, event| {
            match event.kind {
                EventKind::Transmitted { .. } if times.is_empty() => {
                    times.push(event.time);
                    wire.send(nodes[0], frame("123#")).unwrap();
                }
                EventKind::StartOfFrame {
                    role: Role::Transmitter,
                } if !times.is_empty() => times.push(event.time),
                EventKind::Error(_) => panic!("{event}"),
                _ => {}
            }
        });
        times[1].since(times[0]).as_ns() / 1_000
    };
    assert_eq!(gap(0), 4);
    // The others answer to the first bit of the flag with their own: 7 dominant bits, then 8 of delimiter.
    assert_eq!([gap(1), gap(2), gap(3)], [19, 34, 34]);
}

#[test]
fn a_dominant_bit_in_intermission_is_answered_with_an_overload_frame() {
    for bit in [0u64, 1] {
        let (mut wire, nodes) = bench_of(2, NodeConfig::new());
        wire.send(nodes[0], frame("123#AA")).unwrap();
        let mut sent = Time::ZERO;
        let limit = wire.now() + Time::from_us(100);
        while let Some(event) = wire.next_event(limit) {
            if matches!(event.kind, EventKind::Transmitted { .. }) {
                sent = event.time;
                break;
            }
        }
        let from = sent + BIT * bit + Time::from_ns(300);
        wire.inject(Fault::Disturb {
            line: Line::Bus,
            how: Disturbance::Dominant,
            from,
            until: from + BIT,
        });
        let events = run(&mut wire, Time::from_us(100));
        for node in &nodes {
            let cause = EventKind::Overload(OverloadCause::Intermission);
            assert_eq!(count(&events, *node, |kind| *kind == cause), 1, "bit {bit}");
            assert_eq!(wire.error_counters(*node), (0, 0));
        }
    }
}

/// A dominant third bit of intermission is a start of frame: a node with a request joins with its identifier, without a
/// start of frame of its own.
#[test]
fn a_node_joins_a_start_of_frame_in_the_third_bit_of_intermission() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    wire.send(nodes[0], frame("200#AA")).unwrap();
    let limit = wire.now() + Time::from_us(100);
    let mut sent = Time::ZERO;
    while let Some(event) = wire.next_event(limit) {
        if matches!(event.kind, EventKind::Transmitted { .. }) {
            sent = event.time;
            break;
        }
    }
    wire.send(nodes[1], frame("100#55")).unwrap();
    let trace = common::record(&mut wire);
    // The third bit begins 2.2 us after the sample point of the last bit of EOF. The pulse synchronizes both nodes.
    let from = sent + Time::from_ns(2_250);
    wire.inject(Fault::Disturb {
        line: Line::Bus,
        how: Disturbance::Dominant,
        from,
        until: from + BIT,
    });
    let events = run(&mut wire, Time::from_us(100));
    let start = EventKind::StartOfFrame {
        role: Role::Transmitter,
    };
    let started = events
        .iter()
        .find(|event| event.node == nodes[1] && event.kind == start)
        .unwrap();
    assert_eq!(started.time, from + Time::from_ns(800));
    assert_eq!(received(&events, nodes[0]), [frame("100#55")]);
    assert_eq!(transmitted(&events, nodes[1]), [frame("100#55")]);
    let trace = trace.lock().unwrap();
    let own: Vec<_> = trace
        .bits
        .iter()
        .filter(|bit| bit.node == nodes[1])
        .collect();
    let sof = own
        .iter()
        .position(|bit| bit.position.field == Field::Sof)
        .unwrap();
    assert_eq!(
        own[sof].driven,
        Level::Recessive,
        "the start of frame was not its own"
    );
    assert_eq!(
        (own[sof + 1].position, own[sof + 1].role),
        (Position::new(Field::BaseId, 0), Role::Transmitter)
    );
}

#[test]
fn an_off_node_is_woken_once_by_an_edge() {
    let config = NodeConfig {
        wake_on_edge: true,
        rx_delay: Time::from_ns(70),
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = bench(&[NodeConfig::new(), NodeConfig::new(), config]);
    wire.set_mode(nodes[2], Mode::Off);
    let start = wire.now();
    wire.send(nodes[0], frame("123#")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    let woken: Vec<Time> = events
        .iter()
        .filter(|event| event.kind == EventKind::WakeUp)
        .map(|event| event.time)
        .collect();
    assert_eq!(woken.len(), 1);
    assert!(
        woken[0] > start && woken[0].as_ps() % 25_000 == 20_000,
        "{}: an edge of the bus 70 ns late",
        woken[0]
    );
}

#[test]
fn requests_that_make_no_sense_are_refused() {
    let (mut wire, nodes) = bench_of(1, NodeConfig::new());
    let state = can_wire::ErrorState::Active;
    assert_eq!(
        wire.start_recovery(nodes[0]),
        Err(RequestError::NotBusOff { state })
    );
    assert_eq!(
        wire.configure(nodes[0], NodeConfig::new()),
        Err(RequestError::NotOff { mode: Mode::Normal })
    );
    wire.set_mode(nodes[0], Mode::Off);
    assert_eq!(
        wire.send(nodes[0], frame("1FF#")),
        Err(RequestError::CannotSend { mode: Mode::Off })
    );
    let broken = NodeConfig {
        clock_hz: 0,
        ..NodeConfig::new()
    };
    assert!(matches!(
        wire.configure(nodes[0], broken),
        Err(RequestError::Timing(_))
    ));
    assert_eq!(
        wire.configure(nodes[0], NodeConfig::new().with_rate(500_000).unwrap()),
        Ok(())
    );
    assert_eq!(wire.config(nodes[0]).nominal_bit(), BIT * 2);
}

/// A short to dominant, a short to recessive, a cut: the bus works again afterwards.
#[test]
fn the_bus_recovers_from_shorts_and_cuts() {
    type MakeFault = fn(NodeId, Time, Time) -> Fault;
    let faults: [MakeFault; 4] = [
        |_, from, until| Fault::Disturb {
            line: Line::Bus,
            how: Disturbance::Dominant,
            from,
            until,
        },
        |_, from, until| Fault::Disturb {
            line: Line::Bus,
            how: Disturbance::Recessive,
            from,
            until,
        },
        |_, from, until| Fault::Disturb {
            line: Line::Bus,
            how: Disturbance::Inverted,
            from,
            until,
        },
        |node, from, until| Fault::Cut { node, from, until },
    ];
    for fault in faults {
        let (mut wire, nodes) = bench_of(3, NodeConfig::new());
        wire.send(nodes[0], frame("123#0011223344")).unwrap();
        let from = wire.now() + Time::from_us(25);
        wire.inject(fault(nodes[1], from, from + Time::from_us(37)));
        run(&mut wire, Time::from_ms(2));
        wire.send(nodes[1], frame("321#55")).unwrap();
        let events = run(&mut wire, Time::from_us(200));
        assert_eq!(received(&events, nodes[0]), [frame("321#55")]);
        assert_eq!(received(&events, nodes[2]), [frame("321#55")]);
    }
}

#[test]
fn a_dropped_acknowledgement_is_missed_by_the_transmitter_only_if_it_was_the_only_one() {
    for (count, expected) in [(2, 0), (3, 1)] {
        let (mut wire, nodes) = bench_of(count, NodeConfig::new());
        wire.inject(Fault::DropAck {
            node: nodes[1],
            frames: Frames::next_of(nodes[0]),
        });
        wire.send(nodes[0], frame("123#00")).unwrap();
        let events = run(&mut wire, Time::from_us(200));
        assert_eq!(transmitted(&events, nodes[0]).len(), expected);
        // A receiver whose acknowledgement does not reach the bus sees that if nobody else acknowledges.
        let missed = |kind: &EventKind| {
            matches!(
                kind,
                EventKind::Error(BusError {
                    kind: ErrorKind::Bit0,
                    ..
                })
            )
        };
        assert_eq!(self::count(&events, nodes[1], missed), 1 - expected);
    }
}
