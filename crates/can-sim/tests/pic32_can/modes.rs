//! Chapters 34.4, 34.5 and 34.14: switching on and off, operating modes, sleep.

use can_sim::{DiagnosticKind, Sim, Time, pic32_can::DeviceState};
use can_wire::{BitFault, Disturbance, Fault, Field, Frames, Line, Position};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{Cfg, Con, FifoCon, FifoInt, Int},
};

use crate::bench::*;

/// Example 34-1.
#[test]
fn example_34_1() {
    let (sim, can, _) = bench(&[Use::Rx(2)]);
    let con = can.regs(&sim).con();
    con.modify(|con| con.with_reqop(OperationMode::Configuration));
    while con.read().opmod() != Ok(OperationMode::Configuration) {}
    con.clear_bits(Con::from_bits(0x8000));
    let mut polls = 0;
    while con.read().canbusy() {
        polls += 1;
        assert!(polls < 100);
    }
    assert!(polls > 0, "it takes clocks");
    assert_eq!(sim.diagnostics(), []);
}

/// Register 34-1: the state after reset.
#[test]
fn reset_state() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    let con = can.regs(&sim).con().read();
    assert_eq!((con.reqop(), con.opmod()), (Ok(OperationMode::Configuration), Ok(OperationMode::Configuration)));
    assert!(!con.on() && !con.canbusy());
}

/// 34.4: without ON the module takes no part, and REQOP has no effect (mode_request_while_off).
#[test]
fn off_means_off() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    let con = can.regs(&sim).con();
    con.modify(|con| con.with_reqop(OperationMode::Normal));
    sim.run_for(FRAME);
    assert_eq!(con.read().opmod(), Ok(OperationMode::Configuration));
    can.regs(&sim).cfg().write(CFG);
    con.set_bits(Con::ON);
    sim.run_for(FRAME);
    assert_eq!(con.read().opmod(), Ok(OperationMode::Normal), "the mode in REQOP is entered after ON is set");
    assert!(con.read().canbusy());
}

/// 34.4: registers keep their values, FIFOs and flags do not (registers_while_off).
#[test]
fn switching_off_keeps_the_configuration() {
    let (sim, can, peer) = bench(&[Use::Rx(2)]);
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    can.mode(&sim, OperationMode::Configuration);
    let regs = can.regs(&sim);
    regs.con().clear_bits(Con::ON);
    assert_eq!(regs.cfg().read(), CFG);
    assert_eq!(regs.fifo(0).con().read().fsize(), 1);
    assert!(regs.flt_con(0).read().flten(0));
    assert_eq!(can.flags(&sim), Int::ZERO);
    assert_eq!(regs.con().read().opmod(), Ok(OperationMode::Configuration));
}

/// 34.5: OPMOD follows in step with the bus: after 11 recessive bits (mode_entry), with MODIF (34.12.1.8).
#[test]
fn normal_mode_needs_a_quiet_bus() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[Use::Rx(1)]);
    can.clear(&sim, Int::MODIF);
    let begin = sim.now();
    can.start(&sim);
    let waited = sim.now().since(begin);
    // The eleventh sample point, at 70 % of the bit.
    assert!(waited >= Time::from_ns(10_700) && waited < Time::from_us(14), "{waited}");
    assert!(can.flags(&sim).modif());
}

/// 34.5.6: Disable mode waits for the end of the message in progress, in both directions.
#[test]
fn disable_waits_for_the_message() {
    for transmit in [true, false] {
        let (sim, can, peer) = bench(&[Use::Tx(2), Use::Rx(2)]);
        if transmit {
            can.send(&sim, 0, &frame("100#1122334455667788"));
        } else {
            sim.peer_send(peer, frame("100#1122334455667788"));
        }
        sim.run_for(Time::from_us(30));
        can.regs(&sim).con().modify(|con| con.with_reqop(OperationMode::Disable));
        sim.run_for(Time::from_us(50));
        assert_eq!(can.opmod(&sim), OperationMode::Normal);
        sim.run_for(FRAME);
        assert_eq!(can.opmod(&sim), OperationMode::Disable);
        if transmit {
            assert_eq!(heard(&sim, peer), ["100#1122334455667788"]);
        } else {
            assert_eq!(can.receive(&sim, 1), Some(frame("100#1122334455667788")));
        }
    }
}

/// 34.5.6, 34.5.1: Disable mode keeps the error counters, Configuration mode clears them; nothing is received meanwhile.
#[test]
fn disable_keeps_error_counters() {
    let (sim, can, peer) = bench(&[Use::Rx(4)]);
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, 10, 20));
    sim.run_for(Time::from_us(5));
    can.mode(&sim, OperationMode::Disable);
    assert_eq!((can.regs(&sim).trec().read().tec(), can.regs(&sim).trec().read().rec()), (10, 20));
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), None);
    can.start(&sim);
    assert_eq!(can.regs(&sim).trec().read().tec(), 10);
    can.mode(&sim, OperationMode::Configuration);
    assert_eq!(can.regs(&sim).trec().read().bits(), 0);
    assert_eq!(sim.with_wire(|wire| wire.error_counters(node)), (0, 0));
}

/// 34.5.5: loopback: the message reaches the receive path, with a dummy acknowledge, and nothing reaches the bus.
#[test]
fn loopback() {
    let (sim, can, peer) = bench(&[Use::Tx(2), Use::Rx(2)]);
    can.mode(&sim, OperationMode::Loopback);
    can.send(&sim, 0, &frame("123#1122"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 1), Some(frame("123#1122")));
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    assert!(!can.fifo(&sim, 0).con().read().txreq());
    assert_eq!(can.regs(&sim).trec().read().bits(), 0);
    can.start(&sim);
    can.send(&sim, 0, &frame("124#"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 1), None, "own_frames");
    assert_eq!(heard(&sim, peer), ["124#"]);
}

/// 34.5.3: Listen Only: receives, sends nothing, acknowledges nothing, counts nothing.
#[test]
fn listen_only() {
    let (sim, can, peer) = bench(&[Use::Tx(2), Use::Rx(2)]);
    let other = add_peer(&sim);
    can.mode(&sim, OperationMode::ListenOnly);
    sim.peer_send(peer, frame("123#11"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 1), Some(frame("123#11")));
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME);
    assert!(can.fifo(&sim, 0).con().read().txreq(), "it stays pending (txreq_in_passive_modes)");
    assert_eq!(heard(&sim, other), ["123#11"]);
    let node = sim.peer_node(other);
    let crc = Position::new(Field::Crc, 3);
    sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertDriven, position: crc, frames: Frames::next() });
    });
    sim.peer_send(peer, frame("124#"));
    sim.run_for(FRAME * 2);
    assert_eq!(can.regs(&sim).trec().read().bits(), 0);
    can.start(&sim);
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, other).last().unwrap(), "100#", "sent once the mode allows it");
}

/// 34.5.3: a module in Listen Only mode does not acknowledge: a lone sender gets an error.
#[test]
fn listen_only_does_not_acknowledge() {
    let (sim, can, peer) = bench(&[Use::Rx(2)]);
    can.mode(&sim, OperationMode::ListenOnly);
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    let node = sim.peer_node(peer);
    assert!(sim.with_wire(|wire| wire.error_counters(node)).0 >= 8);
    assert!(can.flags(&sim).ivrif(), "the error is seen");
}

/// 34.5.4: Listen All Messages: a message with an error is stored with the data up to the error.
#[test]
fn listen_all() {
    for (mode, stored) in [(OperationMode::Normal, false), (OperationMode::ListenAll, true)] {
        let (sim, can, peer) = bench(&[Use::Rx(4)]);
        can.mode(&sim, mode);
        let node = sim.node(can.id);
        let position = Position::new(Field::CrcDelimiter, 0);
        sim.with_wire(|wire| {
            wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
        });
        sim.peer_send(peer, frame("123#1122334455"));
        sim.run_for(FRAME * 2);
        let mut received = Vec::new();
        while let Some(frame) = can.receive(&sim, 0) {
            received.push(frame.to_string());
        }
        let expected: &[&str] = if stored { &["123#1122334455"; 2] } else { &["123#1122334455"] };
        assert_eq!(received, expected, "{mode:?}: the frame with the error, and its repetition");
        assert!(can.flags(&sim).ivrif());
    }
}

/// 34.5.4: data that did not arrive is 0; before the length nothing is stored (message_with_error).
#[test]
fn listen_all_stores_what_was_received() {
    let run = |position| {
        let (sim, can, peer) = bench(&[Use::Rx(4)]);
        can.mode(&sim, OperationMode::ListenAll);
        let other = sim.peer_node(peer);
        sim.with_wire(|wire| {
            wire.inject(Fault::Bit { node: other, fault: BitFault::InvertDriven, position, frames: Frames::next() });
        });
        sim.peer_send(peer, frame("123#5555555555555555"));
        sim.run_for(FRAME);
        can.receive(&sim, 0).map(|frame| frame.to_string())
    };
    let cut = run(Position::new(Field::Data, 32)).unwrap();
    assert!(cut.starts_with("123#55555555"), "{cut}");
    assert!(cut.ends_with("000000"), "{cut}");
    assert_eq!(run(Position::new(Field::BaseId, 9)).as_deref(), Some("123#5555555555555555"), "only the repetition");
}

/// reserved_mode_request.
#[test]
fn reserved_modes() {
    let (sim, can, _) = bench(&[Use::Rx(2)]);
    let con = can.regs(&sim).con();
    for code in [5_u32, 6] {
        con.write(Con::from_bits(con.read().bits() & !(7 << 24) | code << 24));
        sim.run_for(FRAME);
        assert_eq!(can.opmod(&sim), OperationMode::Normal);
        assert!(matches!(kinds(&sim)[..], [DiagnosticKind::WriteIgnored { field: "REQOP", .. }]));
    }
}

/// 34.4: ON cleared in the middle of a message cuts it off.
#[test]
fn switching_off_in_a_message() {
    let (sim, can, peer) = bench(&[Use::Tx(2)]);
    can.send(&sim, 0, &frame("100#1122334455667788"));
    sim.run_for(Time::from_us(50));
    can.regs(&sim).con().clear_bits(Con::ON);
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::Contradiction { .. }]));
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    let node = sim.peer_node(peer);
    assert!(sim.with_wire(|wire| wire.error_counters(node)).1 > 0, "the others see an error");
    assert!(!can.fifo(&sim, 0).con().read().txreq(), "txreq_after_fifo_reset");
}

/// 34.5: a request is withdrawn by another one.
#[test]
fn changing_ones_mind() {
    let (sim, can, peer) = bench(&[Use::Rx(2)]);
    sim.peer_send(peer, frame("100#1122334455667788"));
    sim.run_for(Time::from_us(30));
    let con = can.regs(&sim).con();
    con.modify(|con| con.with_reqop(OperationMode::Disable));
    con.modify(|con| con.with_reqop(OperationMode::Normal));
    sim.run_for(FRAME * 2);
    assert_eq!(can.opmod(&sim), OperationMode::Normal);
    assert_eq!(can.receive(&sim, 0), Some(frame("100#1122334455667788")));
    con.modify(|con| con.with_reqop(OperationMode::ListenAll));
    sim.run_for(Time::from_us(3));
    assert_eq!(can.opmod(&sim), OperationMode::ListenAll);
}

/// 34.14.3: the recommended procedure, steps 1 to 5.
#[test]
fn sleep_and_wake_up() {
    let (sim, can, peer) = bench(&[Use::Rx(2)]);
    let other = add_peer(&sim);
    can.regs(&sim).int_().set_bits(Int::WAKIE);
    can.mode(&sim, OperationMode::Disable);
    can.clear(&sim, Int::MODIF);
    sim.act(can.id, |model, cx| model.set_device_state(cx, DeviceState::Sleep));
    sim.run_for(FRAME);
    assert!(!sim.line(can.id, 0));
    sim.peer_send(peer, frame("123#"));
    let woken = sim.run_until(FRAME, |sim| sim.line(can.id, 0));
    assert!(woken.is_some(), "bus activity");
    sim.act(can.id, |model, cx| model.set_device_state(cx, DeviceState::Run));
    assert_eq!(can.icod(&sim), 0x42);
    assert!(can.flags(&sim).wakif());
    assert_eq!(can.opmod(&sim), OperationMode::Disable, "waking up does not change the mode");
    can.start(&sim);
    can.clear(&sim, Int::WAKIF);
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), None, "the message that woke the device is lost");
    sim.peer_send(other, frame("124#"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), Some(frame("124#")));
    assert_eq!(sim.diagnostics(), []);
}

/// 34.14.2: Idle mode stops the module only with SIDLE set.
#[test]
fn idle_mode() {
    for stops in [false, true] {
        let (sim, can, peer) = bench(&[Use::Rx(2)]);
        let other = add_peer(&sim);
        if stops {
            can.mode(&sim, OperationMode::Disable);
            can.regs(&sim).con().set_bits(Con::SIDLE);
        }
        sim.act(can.id, |model, cx| model.set_device_state(cx, DeviceState::Idle));
        sim.peer_send(peer, frame("123#"));
        sim.run_for(FRAME);
        assert_eq!(can.flags(&sim).wakif(), stops);
        assert_eq!(can.receive(&sim, 0).is_some(), !stops);
        assert_eq!(heard(&sim, other), ["123#"]);
    }
}

/// 34.14.1: a module that is active when the device goes to sleep drives the pin recessive; that is a mistake.
#[test]
fn sleeping_while_active() {
    let (sim, can, peer) = bench(&[Use::Tx(2)]);
    can.send(&sim, 0, &frame("100#1122334455667788"));
    sim.run_for(Time::from_us(50));
    sim.act(can.id, |model, cx| model.set_device_state(cx, DeviceState::Sleep));
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::Contradiction { .. }]));
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    sim.act(can.id, |model, cx| model.set_device_state(cx, DeviceState::Run));
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), ["100#1122334455667788"]);
}

/// 34.14.3: WAKFIL keeps short glitches from waking the module.
#[test]
fn wake_up_filter() {
    for (filter, pulse_ns, wakes) in [(false, 100, true), (true, 100, false), (true, 900, true)] {
        let sim = Sim::new();
        let can = add(&sim, "can1");
        can.set_up(&sim, 0x100, &[]);
        can.regs(&sim).cfg().write(if filter { CFG | Cfg::WAKFIL } else { CFG });
        can.mode(&sim, OperationMode::Disable);
        sim.act(can.id, |model, cx| model.set_device_state(cx, DeviceState::Sleep));
        let from = sim.now() + Time::from_us(5);
        let until = from + Time::from_ns(pulse_ns);
        sim.with_wire(|wire| wire.inject(Fault::Disturb { line: Line::Bus, how: Disturbance::Dominant, from, until }));
        sim.run_for(FRAME);
        assert_eq!(can.flags(&sim).wakif(), wakes, "{filter} {pulse_ns}");
    }
}

/// 34.5.1: the registers that Configuration mode protects, written in Normal mode.
#[test]
fn configuration_mode_protects() {
    let (sim, can, _) = bench(&[Use::Rx(2)]);
    let regs = can.regs(&sim);
    regs.cfg().write(Cfg::RESET);
    can.base(&sim, 0x400);
    regs.rxm(1).write(EXACT);
    assert_eq!((regs.cfg().read(), regs.fifo_ba().read().bits(), regs.rxm(1).read().bits()), (CFG, 0x100, 0));
    let names: Vec<String> = kinds(&sim)
        .into_iter()
        .filter_map(|kind| match kind {
            DiagnosticKind::ProtectedWrite { register, .. } => Some(register),
            _ => None,
        })
        .collect();
    assert_eq!(names, ["CFG", "FIFOBA", "RXM[1]"]);
    regs.cfg().set_bits(Cfg::WAKFIL);
    assert_eq!(regs.cfg().read(), CFG, "alias_locks");
    // Not protected: priorities, remote enable, enables, the timer.
    let _ = sim.take_diagnostics();
    regs.fifo(0).con().set_bits(FifoCon::RTREN);
    regs.fifo(0).int_().set_bits(FifoInt::RXFULLIE);
    regs.con().set_bits(Con::CANCAP);
    assert_eq!(sim.diagnostics(), []);
}
