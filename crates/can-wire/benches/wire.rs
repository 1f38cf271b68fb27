//! Frames per second of simulated traffic: nodes that take turns with 8-byte classic frames at 1 Mbit/s, back to back.
//!
//! `cargo bench -p can-wire`; one item is one frame of 113 us simulated time, interframe space included.
#![allow(clippy::unwrap_used)]

use can_frame::Frame;
use can_wire::{EventKind, Mode, NodeConfig, NodeId, Time, Wire};
use divan::{Bencher, counter::ItemsCount};

fn main() {
    println!("one frame takes {} of simulated time", frame_time());
    divan::main();
}

const FRAMES: u32 = 1_000;

fn frame() -> Frame {
    "123#0123456789ABCDEF".parse().unwrap()
}

fn wire(nodes: usize, config: NodeConfig, fast: bool) -> (Wire, Vec<NodeId>) {
    let mut wire = Wire::new();
    wire.set_fast_path(fast);
    let nodes: Vec<NodeId> = (0..nodes).map(|_| wire.add_node(config).unwrap()).collect();
    for node in &nodes {
        wire.set_mode(*node, Mode::Normal);
    }
    wire.run_until(Time::from_us(50), |_, _| {});
    (wire, nodes)
}

/// Sends frames back to back, the next node after each.
fn exchange(wire: &mut Wire, nodes: &[NodeId], frame: Frame, frames: u32) {
    let mut sent = 0;
    wire.send(nodes[0], frame).unwrap();
    while let Some(event) = wire.next_event(Time::MAX) {
        if matches!(event.kind, EventKind::Transmitted { .. }) {
            sent += 1;
            if sent == frames {
                break;
            }
            let next = nodes[(event.node.index() + 1) % nodes.len()];
            wire.send(next, frame).unwrap();
        }
    }
    let settled = wire.now() + Time::from_us(20);
    wire.run_until(settled, |_, _| {});
}

fn frame_time() -> Time {
    let (mut wire, nodes) = wire(2, NodeConfig::new(), false);
    let start = wire.now();
    exchange(&mut wire, &nodes, frame(), 1_001);
    let thousand = wire.now().since(start).as_ps();
    let (mut wire, nodes) = self::wire(2, NodeConfig::new(), false);
    let start = wire.now();
    exchange(&mut wire, &nodes, frame(), 1);
    Time::from_ps((thousand - wire.now().since(start).as_ps()) / 1_000)
}

#[divan::bench(sample_count = 10, sample_size = 1, args = [2, 4, 16, 64])]
fn bit_path(bencher: Bencher<'_, '_>, nodes: usize) {
    let (mut wire, nodes) = wire(nodes, NodeConfig::new(), false);
    bencher
        .counter(ItemsCount::new(FRAMES))
        .bench_local(|| exchange(&mut wire, &nodes, frame(), FRAMES));
}

#[divan::bench(sample_count = 10, sample_size = 1, args = [2, 4, 16, 64])]
fn fast_path(bencher: Bencher<'_, '_>, nodes: usize) {
    let (mut wire, nodes) = wire(nodes, NodeConfig::new(), true);
    bencher
        .counter(ItemsCount::new(FRAMES))
        .bench_local(|| exchange(&mut wire, &nodes, frame(), FRAMES));
}

/// With 50 ns to and from the bus at every node.
#[divan::bench(sample_count = 10, sample_size = 1, args = [2, 16])]
fn bit_path_with_delays(bencher: Bencher<'_, '_>, nodes: usize) {
    let config = NodeConfig {
        tx_delay: Time::from_ns(50),
        rx_delay: Time::from_ns(50),
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = wire(nodes, config, false);
    bencher
        .counter(ItemsCount::new(FRAMES))
        .bench_local(|| exchange(&mut wire, &nodes, frame(), FRAMES));
}

/// With 50 ns to and from the bus at every node.
#[divan::bench(sample_count = 10, sample_size = 1, args = [2, 16])]
fn fast_path_with_delays(bencher: Bencher<'_, '_>, nodes: usize) {
    let config = NodeConfig {
        tx_delay: Time::from_ns(50),
        rx_delay: Time::from_ns(50),
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = wire(nodes, config, true);
    bencher
        .counter(ItemsCount::new(FRAMES))
        .bench_local(|| exchange(&mut wire, &nodes, frame(), FRAMES));
}

/// FD frames of 64 bytes with bit-rate switch to 5 Mbit/s.
#[divan::bench(sample_count = 10, sample_size = 1, args = [false, true])]
fn fd_64_bytes(bencher: Bencher<'_, '_>, fast: bool) {
    let (mut wire, nodes) = wire(2, NodeConfig::new(), fast);
    let frame: Frame = format!("123##1{}", "0123456789ABCDEF".repeat(8))
        .parse()
        .unwrap();
    bencher
        .counter(ItemsCount::new(FRAMES))
        .bench_local(|| exchange(&mut wire, &nodes, frame, FRAMES));
}
