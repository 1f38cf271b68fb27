//! What the tests of fault confinement share.
#![allow(dead_code, clippy::unwrap_used)]

use can_wire::{
    BitFault, Disturbance, ErrorKind, ErrorState, Event, EventKind, Fault, Field, Frames, Line,
    NodeConfig, NodeId, Position, Time, Wire,
};

use super::{bench_of, frame, run};

pub const BIT: Time = Time::from_us(1);

pub fn two() -> (Wire, NodeId, NodeId) {
    let (wire, nodes) = bench_of(2, NodeConfig::new());
    (wire, nodes[0], nodes[1])
}

pub fn three() -> (Wire, NodeId, NodeId, NodeId) {
    let (wire, nodes) = bench_of(3, NodeConfig::new());
    (wire, nodes[0], nodes[1], nodes[2])
}

/// Sets the counters and takes in the events that tell of it.
pub fn preset(wire: &mut Wire, node: NodeId, tec: u16, rec: u16) {
    wire.set_error_counters(node, tec, rec);
    while wire.next_event(wire.now()).is_some() {}
}

/// A frame of which bit 9 of the CRC can be inverted without a stuff error.
pub const CLEAN: &str = "123#DEADBEEF";
pub const CLEAN_CRC_BIT: u16 = 9;

pub fn flip_seen(wire: &mut Wire, node: NodeId, field: Field, bit: u16) {
    let position = Position::new(field, bit);
    wire.inject(Fault::Bit {
        node,
        fault: BitFault::InvertSeen,
        position,
        frames: Frames::next(),
    });
}

pub fn errors(events: &[Event], node: NodeId) -> Vec<(ErrorKind, Position)> {
    let of_node = events.iter().filter(|event| event.node == node);
    of_node
        .filter_map(|event| match event.kind {
            EventKind::Error(error) => Some((error.kind, error.position)),
            _ => None,
        })
        .collect()
}

/// Every value that the counters of a node take.
pub fn counters(events: &[Event], node: NodeId) -> Vec<(u16, u16)> {
    let of_node = events.iter().filter(|event| event.node == node);
    of_node
        .filter_map(|event| match event.kind {
            EventKind::Counters { tec, rec } => Some((tec, rec)),
            _ => None,
        })
        .collect()
}

pub fn states(events: &[Event], node: NodeId) -> Vec<ErrorState> {
    let of_node = events.iter().filter(|event| event.node == node);
    of_node
        .filter_map(|event| match event.kind {
            EventKind::ErrorState { to, .. } => Some(to),
            _ => None,
        })
        .collect()
}

/// Holds a line for some bits, starting in the middle of the bit that begins `at` bits after now.
pub fn hold(wire: &mut Wire, line: Line, how: Disturbance, from: Time, until: Time) {
    wire.inject(Fault::Disturb {
        line,
        how,
        from,
        until,
    });
}

/// Time at which a node samples a bit of a frame that node `sender` starts next, found in a run that is thrown away.
pub fn sample_time(
    build: impl Fn() -> (Wire, NodeId),
    text: &str,
    of: NodeId,
    position: Position,
) -> Time {
    let (mut wire, sender) = build();
    let trace = super::record(&mut wire);
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

/// Enough to cover a sample point from both sides.
pub const HALF: Time = Time::from_ns(300);
