//! The same seed gives the same bytes of every output; another seed gives others.
#![allow(clippy::unwrap_used)]

mod common;

use std::{
    io,
    sync::{Arc, Mutex},
};

use can_wire::{
    ErrorState, EventKind, NodeConfig, Time, TraceSink,
    output::{CandumpLog, FrameCapture, PcapNg, Tap, Vcd},
};
use common::{Random, bench, frames};

/// A file in memory that can be read while a sink writes it.
#[derive(Clone, Default)]
struct Bytes(Arc<Mutex<Vec<u8>>>);

impl io::Write for Bytes {
    fn write(&mut self, buffer: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap().extend_from_slice(buffer);
        Ok(buffer.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// VCD, candump log, capture, timeline and picture of a noisy run.
fn outputs(seed: u64) -> Vec<Vec<u8>> {
    let random = &mut Random::new(seed);
    let slow = NodeConfig {
        clock_ppm: -700,
        rx_delay: Time::from_ps(12_345),
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = bench(&[NodeConfig::new(), slow, NodeConfig::new()]);
    for node in &nodes {
        wire.set_noise(*node, 0.002, seed);
    }
    let files: Vec<Bytes> = (0..3).map(|_| Bytes::default()).collect();
    let capture = Arc::new(Mutex::new(FrameCapture::new(nodes[0], 5)));
    let sinks: Vec<Box<dyn TraceSink + Send>> = vec![
        Box::new(Vcd::new(files[0].clone(), 3).unwrap()),
        Box::new(CandumpLog::new(files[1].clone(), Tap::EachNode, 3)),
        Box::new(PcapNg::new(files[2].clone(), Tap::EachNode, 3).unwrap()),
        Box::new(Arc::clone(&capture)),
    ];
    wire.set_trace(Some(Box::new(sinks)));
    for _ in 0..150 {
        for node in &nodes {
            // Some requests are refused, by bus off.
            let _ = wire.send(*node, frames::any_frame(random));
        }
        let limit = wire.now() + Time::from_us(random.below(1_500));
        while let Some(event) = wire.next_event(limit) {
            if matches!(
                event.kind,
                EventKind::ErrorState {
                    to: ErrorState::BusOff,
                    ..
                }
            ) {
                wire.start_recovery(event.node).unwrap();
            }
        }
    }
    let mut outputs: Vec<Vec<u8>> = files
        .iter()
        .map(|file| file.0.lock().unwrap().clone())
        .collect();
    let capture = capture.lock().unwrap();
    assert!(capture.is_complete());
    outputs.push(capture.timeline().into_bytes());
    outputs.push(capture.svg().into_bytes());
    outputs
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let names = ["VCD", "candump", "pcapng", "timeline", "SVG"];
    let (first, again, other) = (outputs(11), outputs(11), outputs(12));
    for (index, name) in names.iter().enumerate() {
        assert!(first[index].len() > 200, "{name} is not empty");
        assert_eq!(first[index], again[index], "{name} repeats");
        assert_ne!(first[index], other[index], "{name} depends on the seed");
    }
}
