//! Chapters 4, 12 and 13: modes, system errors, interrupts, errors, the Time Base Counter.

use can_hal::{
    Configured, ErrorState, Events, InterruptSet, Outcome, Polls, Receive, TimedOut, Transmit,
    dspic33_canfd::{Config, Interrupts, MainFlags, OperationMode, Reference, Timestamping},
    timing::{DsPic33CanFdTiming, Request, SamplePoint},
};
use can_sim::{
    Time,
    dspic33_canfd::{DeviceMode, SystemFailure},
};
use can_wire::{BitFault, Disturbance, Fault, Field, Frames, Position};
use dspic33_canfd_pac::{enums::VecLIcode, registers::ConH};

use crate::bench::{Bench, CONFIG, FRAME, MODE, PLAN, TIMING, frame};

fn requested(value: u32) -> u8 {
    ConH::from_bits(value as u16).reqop().bits()
}

/// 4.2: CON, REQOP = 4 and the wait come before the first protected write; the configuration ends with REQOP and the wait.
#[test]
fn section_4_2_initialization() {
    let bench = Bench::new();
    bench.sim.trace(true);
    let can = bench.configured(&PLAN, &CONFIG).start_normal(MODE).unwrap();
    let accesses = bench.accesses();
    let at = |name: &str, write: bool| accesses.iter().position(|(n, w, _)| n == name && *w == write).unwrap();
    assert!(at("CONL", true) < at("CONH", true) && at("CONH", false) < at("NBTCFGH", true));
    let modes: Vec<u8> = accesses
        .iter()
        .filter(|(name, write, _)| name == "CONH" && *write)
        .map(|(.., value)| requested(*value))
        .collect();
    assert_eq!(modes, [4, 4, 0]);
    assert_eq!(can.operation_mode(), OperationMode::NormalCanFd);
    bench.finish();
}

/// 4.1, 4.2: a module that is found running is brought to Configuration mode, after the message on the bus.
#[test]
fn section_4_2_a_running_module_is_taken_over() {
    let bench = Bench::new();
    let peer = bench.peer();
    let _ = bench.running(&CONFIG);
    bench.sim.peer_send(peer, frame("123#0011223344556677"));
    bench.sim.run_for(Time::from_us(30));
    let can = bench.driver(&PLAN);
    assert_eq!(can.registers().con_h().read().opmod(), OperationMode::Configuration);
    assert_eq!(bench.sim.peer_sent(peer).len(), 1, "the message was acknowledged");
    bench.finish();
}

/// 4.3: the formats of the configuration choose the Normal mode.
#[test]
fn section_4_3_normal_modes() {
    let bench = Bench::new();
    let can = bench.running(&CONFIG);
    assert_eq!(can.operation_mode(), OperationMode::NormalCanFd);
    let mut can = can.stop(MODE).unwrap();
    can.configure(&Config::new(TIMING)).unwrap();
    let can = can.start_normal(MODE).unwrap();
    assert_eq!(can.operation_mode(), OperationMode::NormalCan2_0);
    bench.finish();
}

/// A bound that is too short leaves the module in Configuration mode, with nothing pending.
#[test]
fn section_4_1_5_a_bus_that_is_never_idle() {
    let bench = Bench::new();
    let can = bench.configured(&PLAN, &CONFIG);
    let node = bench.sim.node(bench.id);
    let (how, from, until) = (Disturbance::Dominant, Time::ZERO, Time::from_ms(50));
    bench.sim.with_wire(|wire| wire.inject(Fault::Disturb { line: can_wire::Line::Rx(node), how, from, until }));
    let refused = can.start_normal(Polls(500)).unwrap_err();
    assert_eq!(refused.error, TimedOut);
    bench.sim.run_for(Time::from_ms(60));
    assert_eq!(refused.can.registers().con_h().read().opmod(), OperationMode::Configuration);
    assert!(refused.can.start_normal(MODE).is_ok());
    bench.finish();
}

/// 4.5.1: the bit rate is found by trying, without disturbing the bus.
#[test]
fn section_4_5_1_bit_rate_detection() {
    let bench = Bench::new();
    let (sender, _other) = (bench.peer(), bench.peer());
    let mut can = bench.configured(&PLAN, &CONFIG);
    let mut found = None;
    for rate in [250_000, 500_000, 800_000, 1_000_000] {
        let request = Request::new(40_000_000, rate).sample_point(SamplePoint::percent(80));
        can.set_bit_timing(&DsPic33CanFdTiming::solve(&request).unwrap());
        let mut listening = can.start_listen_only(MODE).unwrap();
        assert_eq!(listening.operation_mode(), OperationMode::ListenOnly);
        bench.send(sender, &["155#5555", "2AA#AA55"]);
        if listening.fetch().unwrap().is_some() {
            found = Some(rate);
        }
        can = listening.stop(MODE).unwrap();
    }
    assert_eq!(found, Some(1_000_000));
    assert!(bench.sim.peer_sent(sender).len() == 8, "nothing was disturbed");
}

/// 4.5.2: acknowledges what it receives.
#[test]
fn section_4_5_2_restricted_operation() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.configured(&PLAN, &CONFIG).start_restricted(MODE).unwrap();
    bench.send(peer, &["123#01"]);
    assert_eq!(bench.sim.peer_sent(peer).len(), 1);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123#01"));
    bench.finish();
}

/// 4.5.3.2: external loop back shows on the bus.
#[test]
fn section_4_5_3_external_loop_back() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.configured(&PLAN, &CONFIG).start_external_loop_back(MODE).unwrap();
    let ticket = can.send(&frame("123##1AABB")).unwrap();
    assert_eq!(can.wait_for(ticket, MODE), Ok(Outcome::Sent));
    bench.sim.run_for(FRAME);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123##1AABB"));
    assert_eq!(bench.seen(peer), ["123##1AABB"]);
    bench.finish();
}

/// 4.6.1, the recommended steps: 1. REQOP = 001, 2. poll OPMOD, 3. SLEEP. 4.6.3: the way back.
#[test]
fn section_4_6_1_sleep_in_three_steps_and_section_4_6_3_wake_up() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    let flags = can.interrupts();
    can.clear(flags);
    bench.sim.trace(true);
    let asleep = can.power_down(MODE).unwrap();
    let modes: Vec<u8> = bench.written("CONH").into_iter().map(requested).collect();
    assert_eq!(modes, [1]);
    bench.sim.act(bench.id, |model, cx| model.set_device_mode(cx, DeviceMode::Sleep));
    // SOF wakes the processor, the message is lost.
    bench.peer();
    bench.send(peer, &["123#01"]);
    assert!(bench.sim.line(bench.id, 2), "the wake-up interrupt");
    let mut can = asleep.power_up(MODE).unwrap();
    assert!(can.interrupts().events().contains(Events::WAKE_UP));
    can.clear(Interrupts::of(MainFlags::WAKIF));
    assert!(!can.interrupts().events().contains(Events::WAKE_UP));
    assert_eq!(can.fetch(), Ok(None));
    bench.send(peer, &["124#02"]);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("124#02"));
    bench.finish();
}

/// 12.3.6: a transmit underflow leads out of Normal mode; the way back leads through Configuration mode.
#[test]
fn section_12_3_6_system_error() {
    for (listens, mode) in [(false, OperationMode::RestrictedOperation), (true, OperationMode::ListenOnly)] {
        let bench = Bench::new();
        let peer = bench.peer();
        let mut can = bench.running(&Config { listen_after_system_error: listens, ..CONFIG });
        bench.sim.act(bench.id, |model, cx| model.fail(cx, SystemFailure::TxUnderflow));
        let ticket = can.send(&frame("123#01")).unwrap();
        bench.sim.run_for(FRAME);
        assert_eq!(can.operation_mode(), mode);
        let events = can.interrupts().events();
        assert!(events.contains(Events::MEMORY | Events::MODE), "{events:?}");
        assert_eq!(can.outcome(ticket), Outcome::Pending);
        let mut can = can.stop(MODE).unwrap().start(MODE).unwrap();
        can.clear(Interrupts::of(MainFlags::SERRIF));
        let ticket = can.send(&frame("124#02")).unwrap();
        assert_eq!(can.wait_for(ticket, MODE), Ok(Outcome::Sent));
        assert_eq!(bench.seen(peer), ["124#02"]);
        bench.finish();
    }
}

/// 12.4.1: a jump table on the codes: highest number first.
#[test]
fn section_12_4_1_interrupt_lookup() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    can.clear(Interrupts::of(MainFlags::MODIF));
    can.enable_interrupts(MainFlags::RXIF | MainFlags::TEFIF | MainFlags::RXOVIF);
    assert_eq!(can.interrupt_codes().interrupt, Ok(VecLIcode::None_));
    bench.send(peer, &["123#01"]);
    assert!(bench.sim.line(bench.id, 0));
    assert_eq!(can.interrupt_codes().interrupt.map(VecLIcode::bits), Ok(1));
    let ticket = can.send(&frame("124#02")).unwrap();
    can.wait_for(ticket, MODE).unwrap();
    bench.sim.run_for(FRAME);
    let codes = can.interrupt_codes();
    assert_eq!(codes.interrupt, Ok(VecLIcode::TransmitEvent));
    assert_eq!((codes.receive.map(|code| code.bits()), codes.filter), (Ok(1), 0));
    assert!(can.tx_event().unwrap().is_some());
    assert!(can.fetch().unwrap().is_some());
    assert_eq!(can.interrupt_codes().interrupt, Ok(VecLIcode::None_));
    assert!(!bench.sim.line(bench.id, 0) && !bench.sim.line(bench.id, 2));
    can.disable_interrupts(MainFlags::RXIF);
    bench.send(peer, &["123#01"]);
    assert!(!bench.sim.line(bench.id, 0) && can.interrupts().flags.rxif());
    bench.finish();
}

/// 13.0: the counters the right way round, the kinds of errors, and their counters.
#[test]
fn section_13_0_counters_and_diagnostics() {
    let bench = Bench::new();
    let _peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    let node = bench.sim.node(bench.id);
    bench.sim.with_wire(|wire| wire.set_error_counters(node, 104, 9));
    bench.sim.run_for(Time::from_us(1));
    let status = can.status();
    assert_eq!((status.counters.transmit, status.counters.receive, status.warning), (104, 9, true));
    let (fault, position) = (BitFault::InvertSeen, Position::new(Field::Crc, 3));
    let frames = Frames { sender: Some(node), skip: 0, count: 2 };
    bench.sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault, position, frames }));
    let ticket = can.send(&frame("123#01")).unwrap();
    assert_eq!(can.wait_for(ticket, MODE), Ok(Outcome::Sent));
    bench.sim.run_for(FRAME);
    let diagnostics = can.diagnostics();
    assert_eq!((diagnostics.nominal_transmit, diagnostics.nominal_receive, diagnostics.data_transmit), (2, 0, 0));
    assert_eq!(diagnostics.error_free, 1);
    assert!(can.status().last_error.is_some());
    assert_eq!(can.status().last_error, None, "told once");
    can.clear_diagnostics();
    assert_eq!(can.diagnostics().nominal_transmit, 0);
    bench.finish();
}

/// 13.1: bus off: what was waiting has failed, the module comes back by itself, what is queued meanwhile is sent.
#[test]
fn section_13_1_recovery_from_bus_off() {
    // The last of the given frames stands at the first, or at another object of its FIFO.
    for sent_before in 0..5 {
        let bench = Bench::new();
        let peer = bench.peer();
        let mut can = bench.running(&CONFIG);
        let send = |can: &mut crate::bench::Driver<'_, can_hal::mode::Running>, text: &str| {
            can.send_fifo(3, &frame(text), Default::default()).unwrap()
        };
        for _ in 0..sent_before {
            let ticket = send(&mut can, "100#");
            assert_eq!(can.wait_for(ticket, MODE), Ok(Outcome::Sent));
        }
        let node = bench.sim.node(bench.id);
        bench.sim.with_wire(|wire| wire.override_output(node, Some(Disturbance::Recessive)));
        let lost = send(&mut can, "123#01");
        bench.sim.run_for(Time::from_us(500));
        bench.sim.with_wire(|wire| wire.override_output(node, None));
        assert_eq!(can.status().error_state, ErrorState::BusOff);
        assert!(can.interrupts().events().contains(Events::BUS_OFF));
        assert_eq!(can.outcome(lost), Outcome::Failed, "after {sent_before}");
        let queued = send(&mut can, "124#02");
        assert_eq!(can.outcome(queued), Outcome::Pending);
        bench.sim.run_for(Time::from_ms(3));
        assert_eq!(can.status().error_state, ErrorState::Active);
        assert_eq!(can.outcome(queued), Outcome::Sent);
        assert_eq!(bench.seen(peer).last().map(String::as_str), Some("124#02"));
        bench.finish();
    }
}

/// 11.0: both halves of the counter belong together, and the timestamps are its values.
#[test]
fn section_11_0_time_base() {
    let bench = Bench::new();
    let peer = bench.peer();
    let timestamps = Timestamping::Counter { clocks: 1, reference: Reference::StartOfFrame };
    let mut can = bench.running(&Config { timestamps, ..CONFIG });
    let started = bench.sim.now();
    let first = can.time_base();
    for _ in 0..200 {
        bench.sim.run_for(Time::from_us(81));
        let expected = bench.sim.now().since(started).as_ps() / 25_000;
        let time = u64::from(can.time_base() - first);
        assert!(time.abs_diff(expected) < 30, "{time} instead of {expected}");
    }
    let before = can.timestamp().unwrap();
    bench.send(peer, &["123#01"]);
    let stamp = can.fetch().unwrap().unwrap().timestamp.unwrap();
    assert!(stamp > before && stamp < can.timestamp().unwrap());
    bench.finish();
}
