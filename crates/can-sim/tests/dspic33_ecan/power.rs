//! Low-power modes and wake-up (13.0).

use crate::bench::{CFG2, FRAME, frame, kinds, pair, pair_with, received};
use can_sim::{Sim, Time, dspic33_ecan::Power};
use can_wire::{Disturbance, Fault, Level, Line};
use dspic33_ecan_pac::{
    enums::{InterruptCode, OperationMode},
    registers::{Inte, Intf},
};

/// 13.1, 13.3: Disable mode, Sleep, bus activity, wake-up by interrupt; the waking message is lost and the module is
/// still in Disable mode.
#[test]
fn section_13_3_sleep_and_wake_up() {
    let (sim, can, other) = pair();
    can.regs(&sim).inte().write(Inte::WAKIE);
    can.enter(&sim, OperationMode::Disable);
    sim.act(can.id, |model, cx| model.sleep(cx));
    sim.run_for(FRAME);
    assert_eq!(sim.inspect(can.id, |model| model.power()), Power::Sleep);
    assert!(!sim.line(can.id, 0));
    sim.peer_send(other, frame("100#01"));
    sim.run_until(FRAME, |sim| sim.line(can.id, 0)).unwrap();
    assert_eq!(sim.inspect(can.id, |model| model.power()), Power::Running);
    assert_eq!(can.regs(&sim).vec().read().icode(), Ok(InterruptCode::WakeUp));
    assert_eq!(can.mode(&sim), OperationMode::Disable);
    can.regs(&sim).intf().clear(Intf::WAKIF);
    assert!(!sim.line(can.id, 0));
    sim.run_for(FRAME);
    assert!(!can.is_full(&sim, 8), "the message is lost");
    can.enter(&sim, OperationMode::Normal);
    sim.run_for(FRAME * 2);
    assert_eq!(can.take(&sim, 8), Some(frame("100#01")), "sent again for want of an acknowledge");
    assert_eq!(sim.diagnostics(), []);
}

/// 13.3: without WAKIE the flag rises, and the device sleeps on.
#[test]
fn section_13_3_wake_up_not_enabled() {
    let (sim, can, other) = pair();
    can.enter(&sim, OperationMode::Disable);
    sim.act(can.id, |model, cx| model.sleep(cx));
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(sim.inspect(can.id, |model| model.power()), Power::Sleep);
    sim.act(can.id, |model, cx| model.run(cx));
    assert!(can.intf(&sim).wakif());
}

/// A dominant pulse on the module's receive line.
fn glitch(sim: &Sim, node: can_wire::NodeId, length: Time) {
    let from = sim.now() + Time::from_us(1);
    let disturb = Fault::Disturb { line: Line::Rx(node), how: Disturbance::Dominant, from, until: from + length };
    sim.with_wire(|wire| wire.inject(disturb));
    sim.run_for(Time::from_us(5));
}

/// 13.3: with WAKFIL a short glitch does not wake the device. CxCFG2 can be written in Configuration mode only.
#[test]
fn section_13_3_wake_up_filter() {
    for (filter, length, wakes) in [(false, 50, true), (true, 50, false), (true, 119, false), (true, 400, true)] {
        let (sim, can, _) = pair();
        can.enter(&sim, OperationMode::Configuration);
        can.regs(&sim).cfg2().write(CFG2.with_wakfil(filter));
        can.regs(&sim).inte().write(Inte::WAKIE);
        can.enter(&sim, OperationMode::Disable);
        sim.act(can.id, |model, cx| model.sleep(cx));
        glitch(&sim, sim.node(can.id), Time::from_ns(length));
        assert_eq!(sim.line(can.id, 0), wakes, "filter {filter}, {length} ns");
        // Two glitches are no pulse.
        if !wakes {
            glitch(&sim, sim.node(can.id), Time::from_ns(length));
            assert!(!sim.line(can.id, 0));
        }
    }
}

/// The oscillator takes its time to start.
#[test]
fn section_13_3_start_up() {
    let (sim, can, other) = pair_with(|mut config| {
        config.start_up = Time::from_us(500);
        config
    });
    can.regs(&sim).inte().write(Inte::WAKIE);
    can.enter(&sim, OperationMode::Disable);
    sim.act(can.id, |model, cx| model.sleep(cx));
    sim.peer_send(other, frame("100#01"));
    let woken = sim.run_until(FRAME, |sim| sim.line(can.id, 0)).unwrap();
    let running = |sim: &Sim| sim.inspect(can.id, |model| model.power()) == Power::Running;
    let runs = sim.run_until(FRAME * 10, running).unwrap();
    assert_eq!(runs.since(woken), Time::from_us(500));
}

/// 13.1, `sleep_while_active`: reported; the frame on the bus breaks off, CxTX is recessive and the mode stays.
#[test]
fn section_13_1_sleep_while_active() {
    let (sim, can, other) = pair();
    can.send(&sim, 0, &frame("100#0000000000000000"));
    sim.run_for(Time::from_us(40));
    sim.act(can.id, |model, cx| model.sleep(cx));
    assert_eq!(kinds(&sim)[0].to_string(), "the device goes to Sleep while the module is in mode Normal");
    assert_eq!(can.on_wire(&sim, |wire, node| wire.tx_level(node)), Level::Recessive);
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), Vec::<String>::new());
    assert_eq!(can.mode(&sim), OperationMode::Normal);
    sim.act(can.id, |model, cx| model.run(cx));
    sim.run_for(FRAME * 2);
    assert_eq!(received(&sim, other), ["100#0000000000000000"], "still pending");
}

/// 13.2, `idle_mode`: with CSIDL 0 the module goes on in Idle mode, with CSIDL 1 it stops.
#[test]
fn section_13_2_idle() {
    for csidl in [false, true] {
        let (sim, can, other) = pair();
        can.regs(&sim).ctrl1().modify(|value| value.with_csidl(csidl));
        if csidl {
            can.enter(&sim, OperationMode::Disable);
        }
        sim.act(can.id, |model, cx| model.idle(cx));
        sim.peer_send(other, frame("100#01"));
        sim.run_for(FRAME);
        sim.act(can.id, |model, cx| model.run(cx));
        assert_eq!(can.is_full(&sim, 8), !csidl);
        assert!(!can.intf(&sim).wakif(), "13.3: only while the device sleeps");
        assert_eq!(sim.diagnostics(), []);
    }
    let (sim, can, _) = pair();
    can.regs(&sim).ctrl1().modify(|value| value.with_csidl(true));
    sim.act(can.id, |model, cx| model.idle(cx));
    assert_eq!(kinds(&sim)[0].to_string(), "the CPU goes to Idle with CSIDL 1 while the module is in mode Normal");
}
