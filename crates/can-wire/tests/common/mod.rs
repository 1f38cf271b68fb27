//! What the tests share: a bench of nodes, recorders, random frames.
#![allow(dead_code, clippy::unwrap_used)]

pub mod confine;
pub mod frames;

use std::sync::{Arc, Mutex};

use can_frame::Frame;
use can_wire::{
    BitRecord, Event, EventKind, Level, Mode, NodeConfig, NodeId, Signal, Time, TraceSink, Wire,
};

/// A wire with nodes in normal mode that have finished bus integration.
pub fn bench(configs: &[NodeConfig]) -> (Wire, Vec<NodeId>) {
    let mut wire = Wire::new();
    let nodes: Vec<NodeId> = configs
        .iter()
        .map(|config| wire.add_node(*config).unwrap())
        .collect();
    for node in &nodes {
        wire.set_mode(*node, Mode::Normal);
    }
    let slowest = configs
        .iter()
        .map(NodeConfig::nominal_bit)
        .max()
        .unwrap_or_default();
    let until = wire.now() + slowest * 14;
    wire.run_until(until, |_, _| {});
    (wire, nodes)
}

/// `count` nodes of the same kind.
pub fn bench_of(count: usize, config: NodeConfig) -> (Wire, Vec<NodeId>) {
    bench(&vec![config; count])
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

/// Runs for `span` and collects the events.
pub fn run(wire: &mut Wire, span: Time) -> Vec<Event> {
    let until = wire.now() + span;
    let mut events = Vec::new();
    wire.run_until(until, |_, event| events.push(event));
    events
}

pub fn received(events: &[Event], node: NodeId) -> Vec<Frame> {
    let frames = events.iter().filter(|event| event.node == node);
    frames
        .filter_map(|event| match event.kind {
            EventKind::Received { frame, .. } => Some(frame),
            _ => None,
        })
        .collect()
}

pub fn transmitted(events: &[Event], node: NodeId) -> Vec<Frame> {
    let frames = events.iter().filter(|event| event.node == node);
    frames
        .filter_map(|event| match event.kind {
            EventKind::Transmitted { frame, .. } => Some(frame),
            _ => None,
        })
        .collect()
}

/// Keeps everything a trace is told.
#[derive(Default)]
pub struct Recorder {
    pub levels: Vec<(Time, Signal, Level)>,
    pub bits: Vec<BitRecord>,
    pub events: Vec<Event>,
    pub no_bits: bool,
}

impl TraceSink for Recorder {
    fn level(&mut self, time: Time, signal: Signal, level: Level) {
        self.levels.push((time, signal, level));
    }
    fn bit(&mut self, bit: &BitRecord) {
        self.bits.push(*bit);
    }
    fn event(&mut self, event: &Event) {
        self.events.push(*event);
    }
    fn wants_bits(&self) -> bool {
        !self.no_bits
    }
}

pub fn record(wire: &mut Wire) -> Arc<Mutex<Recorder>> {
    let recorder = Arc::new(Mutex::new(Recorder::default()));
    wire.set_trace(Some(Box::new(Arc::clone(&recorder))));
    recorder
}

/// A small generator, so that a test says its seed and nothing else.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0xD1B5_4A32_D192_ED03)
    }

    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    pub fn below(&mut self, end: u64) -> u64 {
        (self.next() >> 11) % end
    }

    pub fn coin(&mut self) -> bool {
        self.below(2) == 1
    }

    pub fn bytes(&mut self) -> [u8; 64] {
        let mut bytes = [0; 64];
        for chunk in bytes.chunks_mut(8) {
            chunk.copy_from_slice(&self.next().to_le_bytes());
        }
        bytes
    }
}
