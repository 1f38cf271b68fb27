//! Modes beyond the common suite.

use can_hal::{
    Configured, Outcome, Polls, Receive as _, Sleep, TimedOut, Transmit, Wake,
    memory::Pic32CanFifo::{Receive, Transmit as Tx},
    pic32_can::{Config, Interrupts},
};
use can_sim::Time;
use can_wire::{BitFault, Fault, Field, Frames, Position};

use crate::bench::{ANY, Bench, FRAME, TIMING, WAIT, everything, frame};

/// 34.5.4: a message with an error is stored too.
#[test]
fn section_34_5_4_listen_all() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 });
    let filters = everything(0);
    let can = bench.configured(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    let mut can = can.start_listen_all(WAIT).unwrap();
    let node = bench.sim.node(bench.id);
    let position = Position::new(Field::CrcDelimiter, 0);
    bench.sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
    });
    bench.send(peer, &["123#0102"]);
    for _ in 0..2 {
        assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123#0102"));
    }
    assert_eq!(can.fetch(), Ok(None));
    assert!(can.interrupts().contains(Interrupts::INVALID_MESSAGE));
    bench.finish();
}

/// 34.5.3 and 34.5: from Listen Only mode to Normal mode with the messages kept.
#[test]
fn section_34_5_3_listen_only_to_normal() {
    let bench = Bench::new();
    let (sender, _other) = (bench.peer(), bench.peer());
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 }).fifo(1, Tx { elements: 1 });
    let filters = everything(0);
    let can = bench.configured(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    let can = can.start_listen_only(WAIT).unwrap();
    bench.send(sender, &["123#01"]);
    let mut can = can.leave_monitoring(WAIT).unwrap();
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123#01"));
    let ticket = can.send(&frame("124#")).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    bench.finish();
}

/// 34.5: a bus that is never recessive: the mode is not reached, the module stays in Configuration mode.
#[test]
fn section_34_5_a_bus_held_dominant() {
    let bench = Bench::new();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 1 });
    let can = bench.configured(&memory, &Config::new(TIMING));
    let (from, until) = (bench.sim.now(), bench.sim.now() + Time::from_ms(1));
    bench.sim.with_wire(|wire| {
        wire.inject(Fault::Disturb { line: can_wire::Line::Bus, how: can_wire::Disturbance::Dominant, from, until });
    });
    let refused = can.start_normal(Polls(200)).unwrap_err();
    assert_eq!(refused.error, TimedOut);
    bench.sim.run_for(Time::from_ms(2));
    let can = refused.can;
    assert_eq!(can.registers().con().read().opmod(), Ok(pic32_can_pac::enums::OperationMode::Configuration));
    assert!(can.start_normal(WAIT).is_ok());
    bench.finish();
}

/// 34.6.4, 34.5.6: Disable mode keeps FIFOs and messages, Configuration mode does not.
#[test]
fn sections_34_5_6_and_34_6_4_what_a_mode_keeps() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 }).fifo(1, Tx { elements: 2 });
    let filters = everything(0);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    let loaded = can.load(1, &frame("100#")).unwrap();
    bench.send(peer, &["123#01"]);
    let mut can = can.sleep(WAIT).unwrap().wake(WAIT).unwrap();
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123#01"));
    assert_eq!(can.outcome(loaded), Outcome::Pending);
    can.request(1);
    assert_eq!(can.wait_for(loaded, Polls(10_000)), Ok(Outcome::Sent));
    can.load(1, &frame("101#")).unwrap();
    bench.send(peer, &["124#"]);
    let mut can = can.stop(WAIT).unwrap().start(WAIT).unwrap();
    assert_eq!(can.fetch(), Ok(None));
    can.request(1);
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(peer), ["100#"]);
    let ticket = can.send(&frame("102#")).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    bench.finish();
}

/// 34.12.1.4: a system error stops the module; a new driver takes it into operation again.
#[test]
fn section_34_12_1_4_system_error() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 });
    let filters = everything(0);
    let config = Config::new(TIMING).with_filters(ANY, &filters);
    let mut can = bench.running(&memory, &config);
    bench.sim.act(bench.id, |model, cx| model.block_system_bus(cx, Time::from_ms(1)));
    bench.send(peer, &["100#", "101#"]);
    assert!(can.is_stopped());
    assert!(can.interrupts().contains(Interrupts::SYSTEM_ERROR));
    bench.sim.run_for(Time::from_ms(1));
    let mut can = bench.running(&memory, &config);
    assert!(!can.is_stopped());
    bench.send(peer, &["102#"]);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("102#"));
    bench.finish();
}
