//! Transmitter delay compensation: 200 ns from output to input at 5 Mbit/s.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{
    DelayCompensation, DelaySource, Disturbance, ErrorKind, Event, EventKind, Fault, Field, Line, NodeConfig, NodeId,
    Position, Role, Time, Wire,
};
use common::{bench_of, frame, run};

fn errors(events: &[Event]) -> Vec<&Event> {
    events.iter().filter(|event| matches!(event.kind, EventKind::Error(_))).collect()
}

/// 100 ns to the bus and 100 ns back, 5 Mbit/s in the data phase: the delay is as long as a bit, the sample point lies
/// after 150 ns.
fn delayed(compensation: Option<DelayCompensation>) -> NodeConfig {
    NodeConfig {
        tx_delay: Time::from_ns(100),
        rx_delay: Time::from_ns(100),
        delay_compensation: compensation,
        ..NodeConfig::new()
    }
}

const FD_FRAME: &str = "123##1AA55AA55AA55AA55";

fn outcome(config: NodeConfig) -> (Vec<Event>, Wire, Vec<NodeId>) {
    let (mut wire, nodes) = bench_of(2, config);
    wire.send(nodes[0], frame(FD_FRAME)).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    (events, wire, nodes)
}

fn measured(events: &[Event]) -> Option<(u16, u16)> {
    events.iter().find_map(|event| match event.kind {
        EventKind::TransmitterDelay { delay, secondary_sample_point } => Some((delay, secondary_sample_point)),
        _ => None,
    })
}

#[test]
fn without_compensation_a_delay_beyond_the_sample_point_is_a_bit_error() {
    let (events, _, nodes) = outcome(delayed(None));
    let error = events.iter().find_map(|event| match event.kind {
        EventKind::Error(error) if event.node == nodes[0] => Some(error),
        _ => None,
    });
    let error = error.expect("the transmitter cannot see its own bits in time");
    // BRS is recessive, ESI dominant: at its sample point the transmitter still sees BRS.
    assert_eq!((error.kind, error.position, error.data_phase), (ErrorKind::Bit0, Position::new(Field::Esi, 0), true));
    // The same delay does no harm in the nominal bit time.
    let (mut wire, nodes) = bench_of(2, delayed(None));
    wire.send(nodes[0], frame("123##0AA55")).unwrap();
    assert!(errors(&run(&mut wire, Time::from_us(200))).is_empty());
}

#[test]
fn compensation_measures_the_delay_and_samples_late() {
    // 200 ns are 8 periods of 25 ns; 6 more put the secondary sample point at 75 % of the returned bit.
    let (events, _, nodes) = outcome(delayed(Some(DelayCompensation::measured(6))));
    assert_eq!(measured(&events), Some((8, 14)));
    assert!(errors(&events).is_empty());
    assert_eq!(common::received(&events, nodes[1]), [frame(FD_FRAME)]);
    // A part of a period does not count.
    let odd = NodeConfig { rx_delay: Time::from_ps(124_999), ..delayed(Some(DelayCompensation::measured(5))) };
    assert_eq!(measured(&outcome(odd).0), Some((8, 13)));
    // Software may know it.
    let fixed = DelayCompensation { delay: DelaySource::Fixed(8), offset: 6, limit: 127 };
    let (events, ..) = outcome(delayed(Some(fixed)));
    assert_eq!((measured(&events), errors(&events).len()), (Some((8, 14)), 0));
}

#[test]
fn a_secondary_sample_point_outside_the_bit_is_a_bit_error() {
    // The returned bit lasts from period 8 to period 16.
    for (offset, good) in [(-1, false), (0, true), (7, true), (8, false), (12, false)] {
        let (events, ..) = outcome(delayed(Some(DelayCompensation::measured(offset))));
        assert_eq!(errors(&events).is_empty(), good, "offset {offset}");
        if !good {
            let EventKind::Error(error) = errors(&events)[0].kind else { unreachable!() };
            assert!(matches!(error.kind, ErrorKind::Bit0 | ErrorKind::Bit1) && error.data_phase);
        }
    }
}

#[test]
fn a_disturbed_bit_is_found_at_its_secondary_sample_point() {
    let config = delayed(Some(DelayCompensation::measured(6)));
    let (mut probe, nodes) = bench_of(2, config);
    let trace = common::record(&mut probe);
    probe.send(nodes[0], frame(FD_FRAME)).unwrap();
    run(&mut probe, Time::from_us(200));
    let victim = Position::new(Field::Data, 9);
    let bits = trace.lock().unwrap().bits.clone();
    let bit = bits.iter().find(|bit| bit.node == nodes[0] && bit.position == victim).unwrap();
    // The bit is on the bus 100 ns after it was sent.
    let from = bit.start + Time::from_ns(100);
    let (mut wire, nodes) = bench_of(2, config);
    let how = Disturbance::Inverted;
    wire.inject(Fault::Disturb { line: Line::Bus, how, from, until: from + Time::from_ns(200) });
    wire.send(nodes[0], frame(FD_FRAME)).unwrap();
    let events = run(&mut wire, Time::from_us(200));
    let found =
        events.iter().find(|event| event.node == nodes[0] && matches!(event.kind, EventKind::Error(_))).unwrap();
    let EventKind::Error(error) = found.kind else { unreachable!() };
    assert_eq!((error.position, error.role, error.data_phase), (victim, Role::Transmitter, true));
    // The reaction comes at the next ordinary sample point: one bit after the one of the victim, whose secondary sample
    // point is 350 ns after its start.
    assert_eq!(found.time.since(bit.start), Time::from_ns(200 + 150));
}

#[test]
fn a_filter_window_keeps_glitches_from_ending_the_measurement() {
    let run_with = |filter| {
        let delay = DelaySource::Measured { filter };
        let config = delayed(Some(DelayCompensation { delay, offset: 6, limit: 127 }));
        let (mut probe, nodes) = bench_of(2, config);
        let trace = common::record(&mut probe);
        probe.send(nodes[0], frame(FD_FRAME)).unwrap();
        run(&mut probe, Time::from_us(200));
        let bits = trace.lock().unwrap().bits.clone();
        let res = bits.iter().find(|bit| bit.node == nodes[0] && bit.position.field == Field::Res).unwrap().start;
        let (mut wire, nodes) = bench_of(2, config);
        // A dominant glitch of 20 ns at the receive input, inside the late FDF bit.
        let from = res + Time::from_ns(60);
        let (line, how) = (Line::Rx(nodes[0]), Disturbance::Dominant);
        wire.inject(Fault::Disturb { line, how, from, until: from + Time::from_ns(20) });
        wire.send(nodes[0], frame(FD_FRAME)).unwrap();
        measured(&run(&mut wire, Time::from_us(200))).unwrap()
    };
    assert_eq!(run_with(0), (2, 8), "the glitch 60 ns after the edge was taken for it");
    assert_eq!(run_with(10), (8, 14));
}
