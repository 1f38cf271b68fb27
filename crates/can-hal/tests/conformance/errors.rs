//! Error states and bus off.

use can_hal::{ErrorState, LastError, Outcome, Polls, Receive, RestartAfter, Transmit};
use can_sim::{Sim, Time};
use can_wire::Disturbance;

use crate::bench::{Bench, FRAME, Running, Setup, frame, peer, send_and_wait, start};

/// Nothing dominant leaves the node any more: every attempt to send ends with a bit error.
fn mute<B: Bench>(bench: B, sim: &Sim, on: bool) {
    let node = bench.node(sim);
    sim.with_wire(|wire| wire.override_output(node, on.then_some(Disturbance::Recessive)));
}

/// Sends until the node is bus off; returns the error states and warnings seen, each once.
fn until_bus_off<B: Bench>(bench: B, sim: &Sim, can: &mut Running<'_, B>) -> Vec<(ErrorState, bool)> {
    mute(bench, sim, true);
    let node = bench.node(sim);
    can.send(&frame("123#01")).unwrap();
    let mut seen: Vec<(ErrorState, bool)> = Vec::new();
    for _ in 0..10_000 {
        let status = can.status();
        let (transmit, _) = sim.with_wire(|wire| wire.error_counters(node));
        let now = (status.error_state, status.warning);
        if status.error_state != ErrorState::BusOff {
            assert!(status.counters.transmit.abs_diff(transmit) <= 8, "{status:?}, but the node counts {transmit}");
            let shown = status.counters.transmit;
            assert_eq!(status.warning, shown >= 96, "{status:?}");
            assert_eq!(status.error_state == ErrorState::Passive, shown >= 128, "{status:?}");
        }
        if seen.last() != Some(&now) {
            seen.push(now);
        }
        if status.is_bus_off() {
            break;
        }
        // A muted node counts 8 for every bit of its error flag: four bits lie between warning and error passive.
        sim.run_for(Time::from_us(1));
    }
    mute(bench, sim, false);
    seen
}

pub fn warning_passive_bus_off_and_back<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    let states = until_bus_off(bench, &sim, &mut can);
    let order: Vec<ErrorState> = states.iter().map(|(state, _)| *state).collect();
    assert_eq!(order, [ErrorState::Active, ErrorState::Active, ErrorState::Passive, ErrorState::BusOff], "{states:?}");
    assert_eq!(states.iter().position(|(_, warning)| *warning), Some(1), "warning while error active");
    // Off the bus nothing is received.
    sim.run_for(FRAME);
    if B::EXPECTED.recovers_by_itself {
        sim.run_for(FRAME * 4);
    } else {
        sim.run_for(FRAME * 20);
        assert!(can.status().is_bus_off(), "nothing happens without restart");
        can.restart(Polls(B::MODE_POLLS)).unwrap();
        sim.run_for(FRAME * 4);
    }
    let status = can.status();
    assert_eq!((status.error_state, status.warning), (ErrorState::Active, false), "{status:?}");
    // What was pending may have been sent by now.
    let before = sim.peer_received(other).len();
    assert_eq!(send_and_wait(&mut can, &frame("124#02")), Outcome::Sent);
    assert!(sim.peer_received(other).len() > before);
    assert_eq!(can.status().counters.transmit, 0);
}

pub fn restart_after_a_pause<B: Bench>() {
    for pause in [Time::ZERO, Time::from_us(50_000)] {
        let sim = Sim::new();
        let bench = B::add(&sim, "can0");
        let _other = peer(&sim);
        let mut can = start(bench, &sim, &Setup::CLASSIC);
        until_bus_off(bench, &sim, &mut can);
        let off = sim.now();
        let ps = pause.as_ps();
        let mut policy = if pause == Time::ZERO { RestartAfter::immediately() } else { RestartAfter::new(ps) };
        let mut restarts = Vec::new();
        while sim.now() < off + Time::from_us(100_000) {
            if policy.due(can.status().is_bus_off(), sim.now().as_ps()) {
                restarts.push(sim.now().since(off));
                can.restart(Polls(B::MODE_POLLS)).unwrap();
            }
            sim.run_for(Time::from_us(500));
        }
        let status = can.status();
        assert_eq!(status.error_state, ErrorState::Active, "{status:?}");
        if !B::EXPECTED.recovers_by_itself {
            assert_eq!(restarts.len(), 1, "{restarts:?}");
            assert!(restarts[0] >= pause && restarts[0] < pause + Time::from_us(2_000), "{restarts:?}");
        }
    }
}

pub fn a_missing_acknowledge_is_told<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    can.status();
    can.send(&frame("123#01")).unwrap();
    sim.run_for(FRAME);
    let status = can.status();
    assert_eq!(status.last_error, B::EXPECTED.last_error.then_some(LastError::Ack));
    assert!(status.counters.transmit >= 8, "{status:?}");
}
