//! Operating modes and requests: what a controller asks of its node.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{
    Abort, BitFault, BusError, Disturbance, ErrorKind, Event, EventKind, Fault, FdSupport, Field,
    Frames, Level, Line, Mode, NodeConfig, NodeId, OverloadCause, Position, ProtocolException,
    RequestError, Role, Time, Wire,
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
fn integration_takes_eleven_recessive_bits() {
    let mut wire = Wire::new();
    let node = wire.add_node(NodeConfig::new()).unwrap();
    assert!(
        run(&mut wire, Time::from_ms(1)).is_empty(),
        "an off node does nothing"
    );
    let start = wire.now();
    wire.set_mode(node, Mode::Normal);
    let events = run(&mut wire, Time::from_us(50));
    let integrated = events
        .iter()
        .find(|event| event.kind == EventKind::Integrated)
        .unwrap();
    assert_eq!(integrated.time.since(start), BIT * 10 + Time::from_ns(800));
}

#[test]
fn integration_starts_again_at_every_dominant_bit() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    let late = wire.add_node(NodeConfig::new()).unwrap();
    wire.send(nodes[0], frame("123#00112233")).unwrap();
    run(&mut wire, Time::from_us(20));
    wire.set_mode(late, Mode::Normal);
    let events = run(&mut wire, Time::from_us(200));
    let time = |node, wanted: fn(&EventKind) -> bool| {
        events
            .iter()
            .find(|event| event.node == node && wanted(&event.kind))
            .unwrap()
            .time
    };
    // ACK delimiter, EOF and intermission are the first eleven recessive bits.
    let idle = time(nodes[0], |kind| *kind == EventKind::BusIdle);
    assert_eq!(time(late, |kind| *kind == EventKind::Integrated), idle);
    assert!(received(&events, late).is_empty());
}

/// With the filter, a short dominant pulse does not count as an edge during integration.
#[test]
fn the_edge_filter_ignores_pulses_below_two_quanta() {
    let integrated_after = |edge_filter, pulse_ns| {
        let mut wire = Wire::new();
        let node = wire
            .add_node(NodeConfig {
                edge_filter,
                ..NodeConfig::new()
            })
            .unwrap();
        wire.set_mode(node, Mode::Normal);
        let from = Time::from_ns(5_300);
        let until = from + Time::from_ns(pulse_ns);
        wire.inject(Fault::Disturb {
            line: Line::Bus,
            how: Disturbance::Dominant,
            from,
            until,
        });
        let events = run(&mut wire, Time::from_us(50));
        events
            .iter()
            .find(|event| event.kind == EventKind::Integrated)
            .unwrap()
            .time
    };
    let undisturbed = Time::from_ns(10_800);
    assert_eq!(integrated_after(true, 40), undisturbed);
    assert!(integrated_after(true, 60) > undisturbed);
    assert!(integrated_after(false, 40) > undisturbed);
}

#[test]
fn listen_only_receives_and_drives_nothing() {
    let (mut wire, nodes) = bench_of(3, NodeConfig::new());
    wire.set_mode(nodes[2], Mode::ListenOnly);
    let trace = common::record(&mut wire);
    wire.send(nodes[0], frame("123#11")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(received(&events, nodes[2]), [frame("123#11")]);
    assert_eq!(
        wire.send(nodes[2], frame("123#11")),
        Err(RequestError::CannotSend {
            mode: Mode::ListenOnly
        })
    );
    let trace = trace.lock().unwrap();
    assert!(
        trace
            .levels
            .iter()
            .all(|(_, signal, _)| *signal != can_wire::Signal::Tx(nodes[2]))
    );
}

#[test]
fn a_listener_alone_does_not_acknowledge() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    wire.set_mode(nodes[1], Mode::ListenOnly);
    wire.send(nodes[0], frame("123#11")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert!(transmitted(&events, nodes[0]).is_empty());
    // It sees its own acknowledgement inside, as ISO 11898-1 describes bus monitoring, but then the error flag.
    assert!(received(&events, nodes[1]).is_empty());
    assert_eq!(wire.error_counters(nodes[1]), (0, 0));
}

#[test]
fn restricted_operation_acknowledges_and_waits_for_idle_after_an_error() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    wire.set_mode(nodes[1], Mode::Restricted);
    wire.send(nodes[0], frame("123#11")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(transmitted(&events, nodes[0]), [frame("123#11")]);
    assert_eq!(received(&events, nodes[1]), [frame("123#11")]);
    wire.inject(Fault::Bit {
        node: nodes[1],
        fault: BitFault::InvertSeen,
        position: Position::new(Field::Data, 3),
        frames: Frames::next(),
    });
    wire.send(nodes[0], frame("123#5555")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(
        count(&events, nodes[1], |kind| matches!(
            kind,
            EventKind::Integrated
        )),
        1
    );
    assert_eq!(wire.error_counters(nodes[1]), (0, 0));
}

#[test]
fn internal_loopback_leaves_the_bus_alone() {
    let (mut wire, nodes) = bench_of(3, NodeConfig::new());
    wire.set_mode(nodes[2], Mode::InternalLoopback);
    run(&mut wire, Time::from_us(20));
    wire.send(nodes[0], frame("100#00")).unwrap();
    wire.send(nodes[2], frame("200##1AA")).unwrap();
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(
        received(&events, nodes[2]),
        [frame("200##1AA")],
        "its own, and not the bus's"
    );
    assert_eq!(transmitted(&events, nodes[2]), [frame("200##1AA")]);
    assert_eq!(received(&events, nodes[1]), [frame("100#00")]);
    // Valid at the transmitter's point, both events at once.
    let times: Vec<Time> = events
        .iter()
        .filter(|event| {
            let own = event.node == nodes[2];
            own && matches!(
                event.kind,
                EventKind::Received { .. } | EventKind::Transmitted { .. }
            )
        })
        .map(|event| event.time)
        .collect();
    assert_eq!(times[0], times[1]);
}

#[test]
fn external_loopback_shows_on_the_bus_and_needs_nobody() {
    let mut wire = Wire::new();
    let node = wire.add_node(NodeConfig::new()).unwrap();
    wire.set_mode(node, Mode::ExternalLoopback);
    run(&mut wire, Time::from_us(20));
    let trace = common::record(&mut wire);
    // What is on the bus does not matter to it.
    let (line, how) = (Line::Rx(node), Disturbance::Dominant);
    wire.inject(Fault::Disturb {
        line,
        how,
        from: wire.now(),
        until: wire.now() + Time::from_us(30),
    });
    wire.send(node, frame("123#11")).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    assert_eq!(received(&events, node), [frame("123#11")]);
    assert_eq!(
        count(&events, node, is_error),
        0,
        "no acknowledgement is needed"
    );
    assert!(
        trace
            .lock()
            .unwrap()
            .levels
            .iter()
            .any(|(_, signal, _)| *signal == can_wire::Signal::Bus)
    );
}

#[test]
fn a_tolerant_node_waits_while_an_fd_frame_passes() {
    let tolerant = NodeConfig {
        fd: FdSupport::Tolerant,
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = bench(&[NodeConfig::new(), NodeConfig::new(), tolerant]);
    assert_eq!(
        wire.send(nodes[2], frame("123##0")),
        Err(RequestError::NoFd)
    );
    wire.send(nodes[0], frame("123##1AABBCCDD")).unwrap();
    let events = run(&mut wire, Time::from_us(300));
    assert_eq!(received(&events, nodes[1]).len(), 1);
    assert_eq!(
        count(&events, nodes[2], |kind| *kind
            == EventKind::ProtocolException),
        1
    );
    assert_eq!(
        count(&events, nodes[2], |kind| *kind == EventKind::Integrated),
        1
    );
    assert_eq!(wire.error_counters(nodes[2]), (0, 0));
    wire.send(nodes[0], frame("123#AA")).unwrap();
    assert_eq!(
        received(&run(&mut wire, Time::from_us(200)), nodes[2]),
        [frame("123#AA")]
    );
}

#[test]
fn a_classic_node_destroys_fd_frames() {
    let classic = NodeConfig {
        fd: FdSupport::Classic,
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = bench(&[NodeConfig::new(), classic]);
    wire.send(nodes[0], frame("123##1AABBCCDD")).unwrap();
    let events = run(&mut wire, Time::from_us(300));
    assert!(transmitted(&events, nodes[0]).is_empty());
    assert!(count(&events, nodes[1], is_error) > 0);
}

/// `res` seen recessive: a protocol exception, or a form error where that is switched off.
#[test]
fn a_recessive_res_bit_is_an_exception_or_a_form_error() {
    for exception in [ProtocolException::Integrate, ProtocolException::FormError] {
        let (mut wire, nodes) = bench_of(
            3,
            NodeConfig {
                protocol_exception: exception,
                ..NodeConfig::new()
            },
        );
        let position = Position::new(Field::Res, 0);
        wire.inject(Fault::Bit {
            node: nodes[1],
            fault: BitFault::InvertSeen,
            position,
            frames: Frames::next(),
        });
        wire.send(nodes[0], frame("123##1AABBCCDD")).unwrap();
        let events = run(&mut wire, Time::from_us(300));
        let exceptions = count(&events, nodes[1], |kind| {
            *kind == EventKind::ProtocolException
        });
        let forms = count(
            &events,
            nodes[1],
            |kind| matches!(kind, EventKind::Error(BusError { kind: ErrorKind::Form, position: at, .. }) if *at == position),
        );
        let expected = if exception == ProtocolException::Integrate {
            (1, 0)
        } else {
            (0, 1)
        };
        assert_eq!((exceptions, forms), expected);
        assert_eq!(
            received(&events, nodes[2]).len(),
            exceptions,
            "an exception does not disturb the others"
        );
    }
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

/// A dominant third bit of intermission is a start of frame: a node with a request joins with its identifier.
#[test]
fn a_node_joins_a_start_of_frame_in_the_third_bit_of_intermission() {
    // The clocks differ so much that after a frame one node is a good part of a bit ahead.
    let slow = NodeConfig {
        clock_ppm: -4_500,
        ..NodeConfig::new()
    };
    let quick = NodeConfig {
        clock_ppm: 4_500,
        rx_delay: Time::from_ns(30),
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = bench(&[slow, quick]);
    let mut joined = 0;
    wire.send(nodes[0], frame("200#FFFFFFFFFFFFFFFF")).unwrap();
    wire.run_until(wire.now() + Time::from_ms(20), |wire, event| {
        match event.kind {
            EventKind::Transmitted { .. } | EventKind::ArbitrationLost { .. } => {
                let text = if event.node == nodes[0] {
                    "200#FFFFFFFFFFFFFFFF"
                } else {
                    "100#FFFFFFFFFFFFFFFF"
                };
                wire.send(event.node, frame(text)).unwrap();
            }
            EventKind::Received { .. } if wire.requested(event.node).is_none() => {
                wire.send(event.node, frame("100#FFFFFFFFFFFFFFFF"))
                    .unwrap();
            }
            EventKind::StartOfFrame {
                role: Role::Transmitter,
            } => joined += 1,
            EventKind::Error(_) => panic!("{event}"),
            _ => {}
        }
    });
    assert!(joined > 100, "{joined}");
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
