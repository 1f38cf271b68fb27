//! Operating modes: integration, listening, restricted operation, loop back, FD tolerance.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{
    BitFault, BusError, Disturbance, ErrorKind, Event, EventKind, Fault, FdSupport, Field, Frames,
    Line, Mode, NodeConfig, NodeId, Position, ProtocolException, RequestError, Time, Wire,
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
