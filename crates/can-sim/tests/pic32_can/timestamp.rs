//! Chapter 34.13, Register 34-8: the time stamp timer.

use can_sim::{Sim, Time};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{Con, Int, Tmr},
};
use regbus::Bus;

use crate::bench::*;

fn running(prescaler: u16) -> (Sim, Can) {
    let (sim, can, _) = bench(&[Use::Rx(4)]);
    can.regs(&sim).con().set_bits(Con::CANCAP);
    can.regs(&sim).tmr().write(Tmr::RESET.with_cantspre(prescaler));
    (sim, can)
}

/// Register 34-8, timestamp_prescaler: a step every CANTSPRE system clocks of 12.5 ns, and every clock with 0.
#[test]
fn rate() {
    for (prescaler, us, steps) in [(0_u16, 100, 8_000_u32), (1, 100, 8_000), (80, 1_000, 1_000), (65_535, 8_192, 10)] {
        let (sim, can) = running(prescaler);
        sim.run_for(Time::from_us(us));
        let count = u32::from(can.regs(&sim).tmr().read().cants());
        assert!(count.abs_diff(steps) <= 8, "CANTSPRE {prescaler}: {count} steps");
    }
}

/// Register 34-8: frozen while CANCAP is 0.
#[test]
fn frozen_without_cancap() {
    let (sim, can) = running(80);
    sim.run_for(Time::from_us(100));
    can.regs(&sim).con().clear_bits(Con::CANCAP);
    let count = can.regs(&sim).tmr().read().cants();
    assert!((99..=101).contains(&count));
    sim.run_for(Time::from_us(500));
    assert_eq!(can.regs(&sim).tmr().read().cants(), count);
    can.regs(&sim).con().set_bits(Con::CANCAP);
    sim.run_for(Time::from_us(100));
    assert!((count + 99..=count + 102).contains(&can.regs(&sim).tmr().read().cants()));
}

/// Register 34-8: any write restarts the prescaler and leaves CANTSPRE; CANTS can be set.
#[test]
fn writes_restart_the_prescaler() {
    let (sim, can) = running(8_000);
    for _ in 0..20 {
        sim.run_for(Time::from_us(90));
        let value = can.regs(&sim).tmr().read();
        can.regs(&sim).tmr().write(value);
    }
    assert_eq!(can.regs(&sim).tmr().read(), Tmr::RESET.with_cantspre(8_000), "a step needs 100 us");
    can.regs(&sim).tmr().write(Tmr::RESET.with_cantspre(80).with_cants(0x1234));
    sim.run_for(Time::from_us(10));
    assert!((0x123D..=0x123F).contains(&can.regs(&sim).tmr().read().cants()));
}

/// 34.12.1.9: the overflow, with code 0x46.
#[test]
fn overflow() {
    let (sim, can) = running(80);
    can.regs(&sim).int_().set_bits(Int::CTMRIE);
    let at = sim.run_until(Time::from_ms(70), |sim| sim.line(can.id, 0)).unwrap();
    assert!(at > Time::from_us(65_536) && at < Time::from_us(65_700), "{at}");
    assert_eq!(can.icod(&sim), 0x46);
    can.clear(&sim, Int::CTMRIF);
    sim.run_for(Time::from_ms(60));
    assert!(!can.flags(&sim).ctmrif());
    sim.run_for(Time::from_ms(6));
    assert!(can.flags(&sim).ctmrif());
}

/// 34.13: the count right after the end of frame, in CMSGTS; nothing without CANCAP (time_stamp_without_capture).
#[test]
fn captured_after_the_end_of_frame() {
    let (sim, can, peer) = bench(&[Use::Rx(4)]);
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert_eq!(can.word(&sim, 0x100) >> 16, 0);
    can.regs(&sim).con().set_bits(Con::CANCAP);
    can.regs(&sim).tmr().write(Tmr::RESET.with_cantspre(8));
    let zero = sim.now();
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    // The transmitter knows at the sample point of the last bit of EOF; 0.3 bits later the frame is over.
    let (sent, _) = sim.peer_sent(peer)[1];
    let end = sent.since(zero).as_ps() + 300_000;
    let stamp = u64::from(can.word(&sim, 0x110) >> 16);
    assert!(stamp.abs_diff(end / 100_000) <= 2, "{stamp} for {end} ps");
}

/// 34.13: also a message that the module receives from itself; 34.5.5.
#[test]
fn own_messages_are_stamped() {
    let (sim, can, _) = bench(&[Use::Tx(1), Use::Rx(1)]);
    can.mode(&sim, OperationMode::Loopback);
    can.regs(&sim).con().set_bits(Con::CANCAP);
    can.regs(&sim).tmr().write(Tmr::RESET.with_cantspre(80).with_cants(0x4000));
    can.send(&sim, 0, &frame("123#"));
    sim.run_for(FRAME);
    let stamp = can.word(&sim, 0x110) >> 16;
    assert!((0x4028..0x4050).contains(&stamp), "{stamp:#x}");
}

/// A write through an alias register works on the present count.
#[test]
fn alias_writes_use_the_present_count() {
    let (sim, can) = running(80);
    sim.run_for(Time::from_us(1_000));
    sim.registers(can.id).write(0x078, 0x8000_0000_u32);
    let count = can.regs(&sim).tmr().read().cants();
    assert!((0x8000 + 1_000..0x8000 + 1_005).contains(&count), "{count:#x}");
}
