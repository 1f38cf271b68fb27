//! Listen-only, sleep, stop.

use can_hal::{Configured, Events, InterruptSet, Outcome, Polls, Receive, Sleep, TimedOut, Transmit, Wake};
use can_sim::Sim;

use crate::bench::{Bench, FRAME, Setup, drain, frame, peer, send_and_wait, start};

pub fn listen_only_sends_nothing<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let sender = peer(&sim);
    let can = bench.set_up(&sim, &Setup::CLASSIC);
    let mut can = can.start_listen_only(Polls(B::MODE_POLLS)).unwrap_or_else(|_| panic!("{:?}", sim.diagnostics()));
    sim.run_for(FRAME);
    sim.peer_send(sender, frame("123#01"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(sender), [], "it does not acknowledge");
    assert_eq!(drain(&mut can).len(), 0, "a frame that nobody acknowledges is no frame");
    peer(&sim);
    sim.run_for(FRAME * 2);
    assert_eq!(sim.peer_sent(sender).len(), 1);
    let received = drain(&mut can);
    assert_eq!(received.len(), 1);
    assert_eq!(received[0].frame, frame("123#01"));
    assert_eq!(sim.diagnostics(), []);
}

pub fn sleep_waits_and_wake_resumes<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let (sender, other) = (peer(&sim), peer(&sim));
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    let ticket = can.send(&frame("123#01")).unwrap();
    let asleep = can.sleep(Polls(100_000)).unwrap_or_else(|_| panic!("it does not sleep"));
    assert_eq!(sim.peer_received(other).len(), 1, "what was pending is sent first");
    bench.device_sleeps(&sim);
    sim.peer_send(sender, frame("200#02"));
    sim.run_for(FRAME);
    bench.device_wakes(&sim);
    let mut can = asleep.wake(Polls(B::MODE_POLLS)).unwrap_or_else(|_| panic!("it does not wake"));
    assert_eq!(can.outcome(ticket), Outcome::Sent);
    let events = can.interrupts().events();
    assert_eq!(events.contains(Events::WAKE_UP), B::EXPECTED.wake_on_traffic, "{events:?}");
    sim.run_for(FRAME);
    assert_eq!(drain(&mut can).len(), 0, "what was on the bus meanwhile is lost");
    sim.peer_send(sender, frame("201#03"));
    sim.run_for(FRAME);
    assert_eq!(drain(&mut can)[0].frame, frame("201#03"));
    assert_eq!(send_and_wait(&mut can, &frame("124#02")), Outcome::Sent);
    assert_eq!(sim.diagnostics(), []);
}

pub fn what_does_not_happen_in_time_is_refused<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    // Nobody acknowledges: the frame stays pending, and the controller cannot sleep.
    let ticket = can.send(&frame("123#01")).unwrap();
    let before = sim.accesses();
    let Err(refused) = can.sleep(Polls(50)) else { panic!("it sleeps with a pending frame") };
    assert_eq!(refused.error, TimedOut);
    // A poll may look at several registers: every place from which a frame may be sent.
    let accesses = sim.accesses() - before;
    assert!((50..50 * 10).contains(&accesses), "the wait is bounded: {accesses} accesses");
    let mut can = refused.can;
    assert_eq!(can.outcome(ticket), Outcome::Pending);
    assert_eq!(can.wait_for(ticket, Polls(10)), Err(TimedOut));
    let other = peer(&sim);
    sim.run_for(FRAME);
    assert_eq!(can.outcome(ticket), Outcome::Sent);
    assert_eq!(sim.peer_received(other).len(), 1);
}

pub fn stop_and_start_again<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let (sender, _other) = (peer(&sim), peer(&sim));
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    for number in 0..3 {
        let text = format!("12{number}#0{number}");
        assert_eq!(send_and_wait(&mut can, &frame(&text)), Outcome::Sent);
        let stopped = can.stop(Polls(B::MODE_POLLS)).unwrap_or_else(|_| panic!("it does not stop"));
        sim.peer_send(sender, frame("300#"));
        sim.run_for(FRAME);
        can = stopped.start(Polls(B::MODE_POLLS)).unwrap_or_else(|_| panic!("it does not start"));
        sim.run_for(FRAME);
        assert_eq!(drain(&mut can).len(), 0, "it was off the bus");
        sim.peer_send(sender, frame(&text));
        sim.run_for(FRAME);
        assert_eq!(drain(&mut can)[0].frame, frame(&text));
    }
    assert_eq!(sim.diagnostics(), []);
}
