//! Whole frames as bit strings on the bus.
#![allow(clippy::unwrap_used)]

mod common;

use can_wire::{Field, NodeConfig, Time};
use common::{bench_of, frame, record, run};

#[test]
fn smoke() {
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    let trace = record(&mut wire);
    wire.send(nodes[0], frame("123#DEADBEEF")).unwrap();
    for event in run(&mut wire, Time::from_us(300)) {
        println!("{event}");
    }
    let trace = trace.lock().unwrap();
    for n in 0..2 {
        let s: String = trace.bits.iter().filter(|b| b.node == nodes[n]).map(|b| if b.seen.bit() {'1'} else {'0'}).collect();
        println!("{s}");
    }
    for b in trace.bits.iter().filter(|b| b.node == nodes[0] && b.position.field == Field::Crc) { println!("{b:?}"); }
    panic!();
}
