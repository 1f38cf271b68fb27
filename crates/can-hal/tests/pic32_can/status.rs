//! Status and time stamps beyond the common suite.

use can_hal::{
    Outcome, Polls, Receive as _, Transmit,
    memory::Pic32CanFifo::{Receive, Transmit as Tx},
    pic32_can::{Config, FifoFlags, Interrupts, TxStatus},
};
use can_sim::Time;
use can_wire::{BitFault, Fault, Field, Frames, Position};

use crate::bench::{ANY, Bench, FRAME, TIMING, everything, frame};

const QUIET: TxStatus = TxStatus { requested: false, aborted: false, lost_arbitration: false, error: false };

/// Register 34-20: what reading CiFIFOCONn destroys is told once, also if another call has read the register.
#[test]
fn register_34_20_transmit_status() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 4 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    assert_eq!(can.tx_status(0), QUIET);
    bench.sim.peer_send(peer, frame("7FF#"));
    bench.sim.run_for(Time::from_us(20));
    bench.sim.peer_send(peer, frame("0FF#1122334455667788"));
    let ticket = can.send(&frame("100#01")).unwrap();
    bench.sim.run_for(Time::from_us(90));
    // The abort reads the register again and again.
    can.abort(0);
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Cancelled));
    assert!(can.tx_status(0).lost_arbitration);
    assert_eq!(can.tx_status(0), QUIET);
    bench.sim.run_for(FRAME);
    let node = bench.sim.node(bench.id);
    let position = Position::new(Field::Data, 2);
    bench.sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
    });
    let ticket = can.send(&frame("101#55")).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    let status = can.tx_status(0);
    assert!(status.error && !status.lost_arbitration && !status.requested);
    assert_eq!(can.tx_status(0), QUIET);
    // The model points at reads that follow one which destroyed something; here the driver has kept it.
    let found = bench.sim.take_diagnostics();
    assert!(
        found.iter().all(|found| matches!(found.kind, can_sim::DiagnosticKind::StatusReadTwice { .. })),
        "{found:?}"
    );
}

/// As near to one attempt as the module comes: aborted after the first error.
#[test]
fn giving_up_after_a_failed_attempt() {
    let bench = Bench::new();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 4 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    // Nobody acknowledges.
    let ticket = can.send(&frame("100#01")).unwrap();
    let mut polls = 0;
    while !can.abort_if_failed(0) {
        polls += 1;
        assert!(polls < 10_000);
    }
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Cancelled));
    let errors = can.status().counters.transmit;
    assert!(errors == 8 || errors == 16, "one attempt, or two: {errors}");
    bench.sim.run_for(FRAME * 4);
    assert_eq!(can.status().counters.transmit, errors);
}

/// 34.13: the timer can be set, and its wrap is told (34.12.1.9).
#[test]
fn section_34_13_time_stamp_timer() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 });
    let filters = everything(0);
    let mut config = Config::new(TIMING).with_filters(ANY, &filters);
    config.timestamps = Some(80);
    let mut can = bench.running(&memory, &config);
    can.set_timestamp_timer(0xFFF0);
    can.enable_interrupts(Interrupts::TIMER);
    assert!(!bench.sim.line(bench.id, 0));
    bench.send(peer, &["123#"]);
    assert!(bench.sim.line(bench.id, 0));
    can.clear(Interrupts::TIMER);
    assert!(!bench.sim.line(bench.id, 0));
    let stamp = can.fetch().unwrap().unwrap().timestamp.unwrap();
    assert!((20..120).contains(&stamp), "{stamp}");
    can.disable_interrupts(Interrupts::TIMER);
    can.set_timestamp_timer(0xFFFF);
    bench.sim.run_for(Time::from_us(10));
    assert!(can.interrupts().contains(Interrupts::TIMER));
    assert!(!bench.sim.line(bench.id, 0), "set, but not enabled");
    bench.finish();
}

/// Without time stamps there are none.
#[test]
fn no_time_stamps() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 });
    let filters = everything(0);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    bench.send(peer, &["123#"]);
    assert_eq!((can.timestamp(), can.fetch().unwrap().unwrap().timestamp), (None, None));
    bench.finish();
}

/// 34.12.2: which flags of a FIFO count is a choice: only a full one here.
#[test]
fn section_34_12_2_flags_of_a_fifo() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 2 });
    let filters = everything(0);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    can.enable_fifo_flags(0, FifoFlags::RXFULLIE);
    can.enable_interrupts(Interrupts::RECEIVE);
    bench.send(peer, &["100#"]);
    assert!(!bench.sim.line(bench.id, 0));
    bench.send(peer, &["101#"]);
    assert!(bench.sim.line(bench.id, 0));
    can.fetch().unwrap();
    assert!(!bench.sim.line(bench.id, 0));
    bench.finish();
}
