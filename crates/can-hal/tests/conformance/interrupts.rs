//! Interrupts.

use std::{cell::Cell, rc::Rc};

use can_hal::{Events, InterruptSet, Receive, Transmit};
use can_sim::Sim;

use crate::bench::{Bench, FRAME, Setup, drain, frame, peer, start};

pub fn a_flag_that_rises_between_read_and_clear_stays<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    let before = can.interrupts();
    can.clear(before);
    // A frame without acknowledgement raises no flag of reception; a received one does so while the others are cleared.
    sim.peer_send(other, frame("123#01"));
    sim.run_for(FRAME);
    let read = can.interrupts();
    assert!(read.events().contains(Events::RECEIVED), "{read:?}");
    drain(&mut can);
    // Between the read and the write of the clear, messages overflow the FIFO.
    sim.interrupt_host(0, move |sim| {
        for _ in 0..B::RX_DEPTH + 1 {
            sim.peer_send(other, frame("123#02"));
        }
        sim.run_for(FRAME * (B::RX_DEPTH as u64 + 1));
    });
    can.clear(read);
    let after = can.interrupts();
    if B::EXPECTED.loses_silently {
        assert!(after.events().contains(Events::RECEIVED), "{after:?}");
    } else {
        assert!(after.events().contains(Events::LOST), "{after:?}");
    }
}

/// A handler that clears first and drains then, with a message arriving before each of its accesses in turn.
pub fn no_message_is_forgotten_wherever_it_arrives<B: Bench>() {
    for skip in 0..40 {
        let sim = Sim::new();
        let bench = B::add(&sim, "can0");
        let other = peer(&sim);
        let mut can = start(bench, &sim, &Setup::CLASSIC);
        let flags = can.interrupts();
        can.clear(flags);
        B::enable_receive_interrupt(&mut can);
        sim.peer_send(other, frame("123#01"));
        sim.run_for(FRAME);
        let arrived = Rc::new(Cell::new(false));
        let arrival = Rc::clone(&arrived);
        sim.interrupt_host(skip, move |sim| {
            sim.peer_send(other, frame("123#02"));
            sim.run_for(FRAME);
            arrival.set(true);
        });
        let (mut received, mut entries) = (0, 0);
        while bench.line(&sim) {
            let flags = can.interrupts();
            can.clear(flags);
            received += drain(&mut can).len();
            entries += 1;
            assert!(entries < 10, "the line does not fall");
        }
        assert_eq!(received, 1 + usize::from(arrived.get()), "message before access {skip}");
    }
}

pub fn events_say_what_happened<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    let flags = can.interrupts();
    can.clear(flags);
    assert!(can.interrupts().events().is_empty(), "nothing has happened: {:?}", can.interrupts());
    // Nobody acknowledges: after 12 attempts the warning limit is reached, after 16 the node is error passive.
    can.send(&frame("123#01")).unwrap();
    sim.run_for(FRAME * 4);
    let events = can.interrupts().events();
    assert!(events.contains(Events::WARNING | Events::PASSIVE), "{events:?}");
    assert!(!events.intersects(Events::RECEIVED | Events::BUS_OFF), "{events:?}");
}
