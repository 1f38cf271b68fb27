//! smoke
#![allow(clippy::unwrap_used)]
mod common;
use can_wire::{NodeConfig, Time, output::*};
use common::{bench_of, frame, run};
use std::sync::{Arc, Mutex};

#[test]
fn smoke() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    let cap = Arc::new(Mutex::new(FrameCapture::new(nodes[1], 1)));
    let vcd = Vcd::new(std::fs::File::create("/tmp/x.vcd").unwrap(), 2).unwrap();
    let pcap = PcapNg::new(std::fs::File::create("/tmp/x.pcapng").unwrap(), Tap::Bus, 2).unwrap();
    let sinks: Vec<Box<dyn can_wire::TraceSink + Send>> = vec![Box::new(cap.clone()), Box::new(vcd), Box::new(pcap)];
    wire.set_trace(Some(Box::new(sinks)));
    for f in ["123#DEADBEEF", "12345678##1000000000000000000112233", "123#R5", "7FF#R", "12345678#1122", "012##0AA"] {
        wire.send(nodes[0], frame(f)).unwrap();
        for event in run(&mut wire, Time::from_us(300)) {
            println!("{event}");
        }
    }
    let cap = cap.lock().unwrap();
    println!("{}", cap.timeline());
    std::fs::write("/tmp/x.svg", cap.svg()).unwrap();
}
