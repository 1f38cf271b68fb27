//! Chapter 3.1: modes of operation.

use can_hal::{
    ErrorState, LastError, Polls, Receive, StandardId, TimedOut, Transmit,
    m_can::{Activity, Config, Interrupts, Line, TxOptions},
    mode::Restricted,
    timing::{MCanTiming, Request},
};
use can_sim::Time;
use can_wire::{Disturbance, NodeConfig};
use m_can_pac::registers::Cccr;

use crate::bench::{Bench, Driver, FRAME, TIMING, frame, texts};

/// 3.1.1: INIT, wait for it, CCE, configuration, INIT back, wait for it.
#[test]
fn section_3_1_1_software_initialization() {
    let bench = Bench::new();
    bench.sim.trace(true);
    let can = bench.configured(&Config::new(TIMING)).start_normal(Polls(20)).unwrap();
    let accesses = bench.accesses();
    let writes: Vec<Cccr> = accesses
        .iter()
        .filter(|(name, write, _)| name == "CCCR" && *write)
        .map(|(_, _, value)| Cccr::from_bits(*value))
        .collect();
    let (init, both) = (Cccr::INIT, Cccr::INIT | Cccr::CCE);
    assert_eq!(writes, [init, both, both, Cccr::ZERO]);
    let first_protected = accesses.iter().position(|(name, _, _)| name == "NBTP").unwrap();
    let cce = accesses.iter().position(|(name, write, value)| name == "CCCR" && *write && *value == both.bits());
    assert!(cce.unwrap() < first_protected);
    assert!(accesses.last().is_some_and(|(name, write, value)| name == "CCCR" && !write && value & 1 == 0));
    assert!(!can.is_stopped());
    bench.finish();
}

/// 3.1.1: a Message RAM with parity is written before it is read.
#[test]
fn section_3_1_1_message_ram_is_initialized() {
    let bench = Bench::new();
    bench.sim.with_memory(bench.ram, |memory| memory.words_mut().fill(0xDEAD_BEEF));
    let mut can = bench.driver(&crate::bench::MEMORY);
    let words = crate::bench::MEMORY.plan().unwrap().end() as usize / 4;
    can.zero_memory();
    bench.sim.with_memory(bench.ram, |memory| {
        assert!(memory.words()[..words].iter().all(|word| *word == 0));
        assert!(memory.words()[words..].iter().all(|word| *word == 0xDEAD_BEEF));
    });
    can.configure(&Config::new(TIMING)).unwrap();
    bench.finish();
}

/// A controller that is found running is stopped first, whatever mode it is in.
#[test]
fn section_3_1_1_a_running_controller_is_taken_over() {
    let bench = Bench::new();
    bench.running(&Config::new(TIMING).with_fd());
    let mut can = bench.driver(&crate::bench::MEMORY);
    can.configure(&Config::new(TIMING)).unwrap();
    bench.finish();
}

/// 3.1.5: the bit rate of a bus is found by trying, without disturbing anybody.
#[test]
fn section_3_1_5_bit_rate_detection_in_restricted_mode() {
    let bench = Bench::new();
    let (sender, other) = (bench.peer(), bench.peer());
    let timing = |rate| MCanTiming::solve(&Request::new(40_000_000, rate)).unwrap();
    let mut can = bench.driver(&crate::bench::MEMORY);
    can.configure(&Config::new(timing(125_000))).unwrap();
    let mut found = None;
    for rate in [125_000, 250_000, 500_000, 1_000_000] {
        can.set_bit_timing(&timing(rate));
        let mut listening: Driver<'_, Restricted> = can.start_restricted(Polls(20)).unwrap();
        assert!(listening.is_restricted());
        bench.send(sender, &["123#0102", "124#", "125#01", "126#"]);
        if listening.fetch().unwrap().is_some() {
            found = Some(rate);
            let mut can = listening.leave_restricted();
            assert!(!can.is_restricted());
            let ticket = can.send(&frame("321#")).unwrap();
            can.wait_for(ticket, Polls(10_000)).unwrap();
            break;
        }
        can = listening.into_configuration(Polls(20)).unwrap();
    }
    assert_eq!(found, Some(1_000_000));
    assert_eq!(bench.sim.peer_sent(sender).len(), 16, "nobody was disturbed");
    assert!(bench.seen(other).contains(&"321#".to_owned()));
    bench.finish();
}

/// 3.1.6: Bus Monitoring Mode can be left without leaving the bus.
#[test]
fn section_3_1_6_bus_monitoring() {
    let bench = Bench::new();
    let (sender, other) = (bench.peer(), bench.peer());
    let mut can = bench.configured(&Config::new(TIMING)).start_monitoring(Polls(20)).unwrap();
    bench.sim.run_for(FRAME);
    bench.send(sender, &["123#01"]);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123#01"));
    let mut can = can.leave_monitoring();
    let ticket = can.send(&frame("321#")).unwrap();
    can.wait_for(ticket, Polls(10_000)).unwrap();
    assert_eq!(bench.seen(other), ["123#01", "321#"]);
    bench.finish();
}

/// 3.1.8: pending transmissions are done first; then INIT and CSA are set. Back: CSR, CSA, INIT.
#[test]
fn section_3_1_8_power_down() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    can.send_queued(&frame("123#01"), TxOptions::default()).unwrap();
    let can = can.power_down(Polls(10_000)).unwrap();
    assert_eq!(bench.seen(other), ["123#01"]);
    let cccr = can.registers().cccr().read();
    assert!(cccr.init() && cccr.csa());
    bench.sim.trace(true);
    let can = can.power_up(Polls(100)).unwrap();
    let first = bench.accesses().into_iter().find(|(name, write, _)| name == "CCCR" && *write).unwrap();
    assert_eq!(first.2, Cccr::INIT.bits(), "INIT is held at one until the acknowledge has gone");
    let cccr = can.registers().cccr().read();
    assert!(!cccr.init() && !cccr.csa() && !cccr.csr());
    bench.finish();
}

/// 3.1.8: on a disturbed bus idle may never come. The wait ends, and software initialization is still possible.
#[test]
fn section_3_1_8_power_down_on_a_disturbed_bus() {
    let bench = Bench::new();
    let other = bench.peer();
    let can = bench.running(&Config::new(TIMING));
    let node = bench.sim.peer_node(other);
    bench.sim.with_wire(|wire| wire.override_output(node, Some(Disturbance::Dominant)));
    bench.sim.run_for(FRAME);
    let refused = can.power_down(Polls(1_000)).unwrap_err();
    assert_eq!(refused.error, TimedOut);
    let mut can = refused.can;
    assert_ne!(can.protocol_status().activity, Activity::Idle);
    assert!(!can.registers().cccr().read().csr(), "the request is withdrawn");
    assert!(can.into_configuration(Polls(20)).is_ok());
    bench.finish();
}

/// 2.3.14: Bus_Off sets INIT. After it is cleared, 129 sequences of 11 recessive bits, each reported as Bit0Error and
/// counted in REC; then the counters are 0.
#[test]
fn section_2_3_14_bus_off_recovery() {
    let bench = Bench::new();
    let _other = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    can.clear_interrupts(Interrupts::from_bits(u32::MAX));
    let node = bench.sim.node(bench.id);
    bench.sim.with_wire(|wire| wire.override_output(node, Some(Disturbance::Recessive)));
    can.send_queued(&frame("123#01"), TxOptions::default()).unwrap();
    bench.sim.run_for(FRAME * 20);
    bench.sim.with_wire(|wire| wire.override_output(node, None));
    assert!(can.is_stopped());
    assert!(can.take_interrupts().contains(Interrupts::BO));
    assert!(can.protocol_status().status.is_bus_off());
    can.cancel_buffers(u32::MAX >> 25);
    can.leave_bus_off(Polls(20)).unwrap();
    bench.sim.run_for(Time::from_us(11 * 60));
    let status = can.protocol_status().status;
    assert_eq!((status.error_state, status.last_error), (ErrorState::BusOff, Some(LastError::Bit0)));
    assert!((50..=60).contains(&status.counters.receive), "{status:?}");
    // Beginning again makes it longer: 129 sequences count from there.
    can.leave_bus_off(Polls(20)).unwrap();
    bench.sim.run_for(Time::from_us(11 * 140));
    let status = can.protocol_status().status;
    assert_eq!((status.error_state, status.counters.transmit), (ErrorState::Active, 0), "{status:?}");
    assert_eq!(status.counters.receive, 0);
    assert!(can.take_interrupts().contains(Interrupts::BO), "IR.BO rises at both changes");
}

/// 3.1.9: both loop back modes.
#[test]
fn section_3_1_9_loop_back() {
    for internal in [true, false] {
        let bench = Bench::new();
        let other = bench.peer();
        let can = bench.configured(&Config::new(TIMING).with_fd());
        let started =
            if internal { can.start_internal_loop_back(Polls(20)) } else { can.start_external_loop_back(Polls(20)) };
        let mut can = started.unwrap();
        bench.sim.run_for(FRAME);
        let ticket = can.send(&frame("123##10102")).unwrap();
        can.wait_for(ticket, Polls(10_000)).unwrap();
        assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123##10102"));
        assert_eq!(bench.seen(other).len(), usize::from(!internal), "only external loop back is seen on the bus");
        // 3.1.9: the test mode ends with configuration mode.
        let can = can.into_configuration(Polls(20)).unwrap();
        let can = can.start_normal(Polls(20)).unwrap();
        assert!(!can.registers().cccr().read().test());
        assert!(!can.registers().test().read().lbck());
        bench.finish();
    }
}

/// 3.1.5, 2.3.16: the Message RAM is late; hardware restricts the node until software ends that.
#[test]
fn section_3_1_5_message_ram_failure_restricts() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    can.enable_interrupts(Interrupts::MRAF, Line::Int1);
    bench.sim.act(bench.id, |model, cx| model.fail_ram(cx, can_sim::m_can::RamFailure::TxTooLate));
    can.send_queued(&frame("123#01"), TxOptions::default()).unwrap();
    bench.sim.run_for(FRAME);
    assert!(can.is_restricted());
    assert!(bench.sim.line(bench.id, 1) && !bench.sim.line(bench.id, 0));
    assert!(can.take_interrupts().contains(Interrupts::MRAF));
    can.end_restriction();
    assert!(!can.is_restricted());
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other), ["123#01"]);
}

/// The reception works while the controller is restricted, and a fast bus is not needed for the filters.
#[test]
fn section_3_1_5_restricted_acknowledges() {
    let bench = Bench::new();
    let sender = bench.sim.add_peer(NodeConfig::new()).unwrap();
    let id = StandardId::new(0x123).unwrap();
    let filters = [can_hal::m_can::Filter::exact(id, can_hal::m_can::Action::Fifo1)];
    let can = bench.configured(&Config::new(TIMING).with_filters(&filters, &[]));
    let mut can = can.start_restricted(Polls(20)).unwrap();
    bench.sim.run_for(FRAME);
    bench.send(sender, &["123#01"]);
    assert_eq!(bench.sim.peer_sent(sender).len(), 1, "acknowledged");
    let message = can.receive_fifo(can_hal::m_can::RxFifo::Fifo1).unwrap().unwrap();
    assert_eq!(texts(&[message]), ["123#01"]);
    bench.finish();
}
