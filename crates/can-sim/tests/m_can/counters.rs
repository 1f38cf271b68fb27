//! Counters in time: Bus_Off recovery, timestamp, timeout; and power down on a bus that is never idle: sections 2.3.9 to
//! 2.3.14, 3.1.8 and 3.3 of the manual.

use crate::bench::{Can, FRAME, SETUP, Setup, add, frame};
use can_sim::{Sim, Time};
use can_wire::{BitFault, Disturbance, Fault, Field, Frames, Line, NodeConfig, Position};
use m_can_pac::{
    enums::{Activity, LastErrorCode},
    registers::{self as pac, Ir},
};
use regbus::Bus;

fn prepared(tscc: u32, tocc: u32) -> (Sim, Can) {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.set_up(&sim, &SETUP);
    can.regs(&sim).tscc().write(pac::Tscc::from_bits(tscc));
    can.regs(&sim).tocc().write(pac::Tocc::from_bits(tocc));
    (sim, can)
}

/// 2.3.14: REC counts the sequences of 11 recessive bits one by one, stays at 127 with RP set, CEL does not count; LEC is
/// Bit0Error after each; a dominant bit only delays the next one. `receive_counter_in_recovery`.
#[test]
fn section_2_3_14_recovery_sequence_by_sequence() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &SETUP);
    sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let regs = can.regs(&sim);
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 0));
    sim.with_wire(|wire| wire.set_error_counters(node, 255, 0));
    let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
    sim.with_wire(|wire| wire.inject(fault));
    can.send(&sim, 0, &frame("123#00"));
    sim.run_until(FRAME, |sim| can.ir(sim).contains(Ir::BO)).unwrap();
    sim.run_for(FRAME);
    let (psr, ecr) = (regs.psr().read(), regs.ecr().read());
    assert!(psr.bo() && psr.ep() && psr.ew());
    assert_eq!((psr.act(), ecr.tec()), (Activity::Synchronizing, 255));
    assert!(regs.cccr().read().init(), "of its own accord");
    sim.run_for(FRAME * 20);
    assert!(regs.psr().read().bo(), "nothing is counted while INIT is 1");
    assert_eq!(regs.ecr().read().cel(), 0);
    regs.cccr().write(pac::Cccr::ZERO);
    let (mut last, mut seen) = (0, Vec::new());
    let back = sim.run_until(Time::from_ms(3), |sim| {
        let ecr = can.regs(sim).ecr().read();
        let count = u16::from(ecr.rec()) + u16::from(ecr.rp());
        if ecr.rec() != 0 && count != last {
            last = count;
            seen.push((count, ecr.rp(), ecr.cel(), can.regs(sim).psr().read().lec()));
        }
        !can.regs(sim).psr().read().bo()
    });
    assert!(back.is_some());
    assert_eq!(seen.len(), 128, "{seen:?}");
    for (expected, (count, rp, cel, lec)) in (1..).zip(seen) {
        assert_eq!((count, rp, cel, lec), (expected, expected == 128, 0, LastErrorCode::Bit0Error));
    }
    assert_eq!(regs.ecr().read().bits(), 0, "both counters are reset at the end");
}

/// 2.3.9, 2.3.10: TSS = 0 and 3 read 0 and stamp 0; each byte of TSCV resets the counter; INIT stops it.
#[test]
fn section_2_3_10_timestamp_counter() {
    for tss in [0, 3] {
        let (sim, can) = prepared(tss, 0);
        can.start(&sim);
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).tscv().read().bits(), 0);
        sim.peer_send(peer, frame("123#"));
        sim.run_for(FRAME);
        assert_eq!(sim.with_memory(can.ram, |memory| memory.words()[0x11] & 0xFFFF), 0);
    }
    let (sim, can) = prepared(1, 0);
    can.start(&sim);
    for byte in 0..4 {
        sim.run_for(FRAME);
        let before = can.regs(&sim).tscv().read().tsc();
        assert!((199..240).contains(&before), "{before}");
        sim.registers(can.id).write(0x024 + byte, 0xA5_u8);
        assert_eq!(can.regs(&sim).tscv().read().tsc(), 0, "byte {byte}");
    }
    sim.run_for(FRAME);
    can.configure(&sim);
    let stopped = can.regs(&sim).tscv().read().tsc();
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).tscv().read().tsc(), stopped, "`timestamp_counter_in_init`; CCE leaves it");
    assert_ne!(stopped, 0);
}

/// 2.3.10: the wrap-around from 0xFFFF to 0, at each prescaler; the external timebase wraps without a flag.
#[test]
fn section_2_3_10_wrap_around() {
    for tcp in [0, 1, 15] {
        let (sim, can) = prepared(tcp << 16 | 1, 0);
        can.start(&sim);
        sim.registers(can.id).write(0x024, 0_u32);
        let count = u64::from(tcp) + 1;
        sim.run_for(Time::from_us(65_535 * count));
        assert_eq!((can.regs(&sim).tscv().read().tsc(), can.ir(&sim) & Ir::TSW), (0xFFFF, Ir::ZERO), "TCP {tcp}");
        sim.run_for(Time::from_us(count));
        assert_eq!((can.regs(&sim).tscv().read().tsc(), can.ir(&sim) & Ir::TSW), (0, Ir::TSW), "TCP {tcp}");
        can.clear(&sim);
        sim.run_for(Time::from_us(65_536 * count));
        assert!(can.ir(&sim).contains(Ir::TSW), "and again");
    }
    let (sim, can) = prepared(2, 0);
    can.start(&sim);
    sim.run_for(Time::from_ms(70));
    assert!(can.regs(&sim).tscv().read().tsc() < 0x2000);
    assert_eq!(can.ir(&sim) & Ir::TSW, Ir::ZERO);
}

/// 2.3.11, 3.3: nothing counts without ETOC, nor while INIT is 1; each byte of TOCV presets; the prescaler is TCP.
#[test]
fn section_3_3_continuous_timeout() {
    let (sim, can) = prepared(0, 100 << 16);
    can.start(&sim);
    sim.run_for(FRAME * 2);
    assert_eq!((can.regs(&sim).tocv().read().toc(), can.ir(&sim) & Ir::TOO), (100, Ir::ZERO), "ETOC = 0");
    let (sim, can) = prepared(3 << 16, 1_000 << 16 | 1);
    sim.run_for(FRAME * 30);
    assert_eq!((can.regs(&sim).tocv().read().toc(), can.ir(&sim) & Ir::TOO), (1_000, Ir::ZERO), "INIT = 1");
    can.start(&sim);
    for byte in 0..4 {
        sim.run_for(Time::from_us(800));
        let toc = can.regs(&sim).tocv().read().toc();
        assert!((780..=801).contains(&toc), "four bits a count: {toc}");
        sim.registers(can.id).write(0x02C + byte, 0_u8);
        assert_eq!(can.regs(&sim).tocv().read().toc(), 1_000, "byte {byte}");
    }
    sim.run_for(Time::from_us(400));
    can.regs(&sim).cccr().write(pac::Cccr::INIT);
    sim.run_for(Time::from_us(1));
    let stopped = can.regs(&sim).tocv().read().toc();
    sim.run_for(FRAME * 30);
    assert_eq!((can.regs(&sim).tocv().read().toc(), can.ir(&sim) & Ir::TOO), (stopped, Ir::ZERO), "stopped by INIT");
}

/// 3.3: controlled by the Tx Event FIFO: an event starts it, an acknowledge that empties the FIFO presets it; a second
/// element does not start it again.
#[test]
fn section_3_3_timeout_of_tx_events() {
    let (sim, can) = prepared(0, 500 << 16 | 1 << 1 | 1);
    can.start(&sim);
    sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME * 5);
    let toc = || can.regs(&sim).tocv().read().toc();
    assert_eq!(toc(), 500);
    let send = || {
        can.write_with(&sim, 0, &frame("123#"), |t1| t1.with_efc(true));
        can.request(&sim, 1);
        sim.run_until(FRAME, |sim| can.ir(sim).contains(Ir::TEFN)).unwrap();
        can.clear(&sim);
    };
    send();
    assert!((498..=500).contains(&toc()));
    sim.run_for(Time::from_us(300));
    send();
    assert!(toc() < 200, "counts on");
    can.regs(&sim).txefa().write(pac::Txefa::RESET.with_efai(0));
    sim.run_for(Time::from_us(1));
    assert!(toc() < 200, "one is left");
    can.regs(&sim).txefa().write(pac::Txefa::RESET.with_efai(1));
    sim.run_for(Time::from_us(1));
    assert_eq!(toc(), 500);
    sim.run_for(FRAME * 5);
    assert_eq!((toc(), can.ir(&sim) & Ir::TOO), (500, Ir::ZERO));
    send();
    sim.run_for(Time::from_us(510));
    assert_eq!((toc(), can.ir(&sim) & Ir::TOO), (0, Ir::TOO));
    can.clear(&sim);
    send();
    sim.run_for(FRAME * 5);
    assert_eq!((toc(), can.ir(&sim) & Ir::TOO), (0, Ir::ZERO), "it has not been empty since");
}

/// 3.1.8: on a bus that is never idle a clock stop is not acknowledged; INIT written by software ends the waiting, in the
/// middle of a transmission.
#[test]
fn section_3_1_8_clock_stop_on_a_disturbed_bus() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &SETUP);
    sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let (from, until) = (sim.now(), sim.now() + Time::from_ms(5));
    sim.with_wire(|wire| wire.inject(Fault::Disturb { line: Line::Bus, how: Disturbance::Dominant, from, until }));
    sim.run_for(Time::from_us(20));
    let regs = can.regs(&sim);
    regs.cccr().write(pac::Cccr::CSR);
    sim.run_for(Time::from_ms(1));
    assert_eq!(regs.cccr().read(), pac::Cccr::CSR);
    assert_ne!(regs.psr().read().act(), Activity::Idle);
    regs.cccr().write(pac::Cccr::CSR | pac::Cccr::INIT);
    sim.run_for(Time::from_us(1));
    assert_eq!(regs.cccr().read(), pac::Cccr::CSR | pac::Cccr::CSA | pac::Cccr::INIT);
}

/// 3.1.1: leaving Bus_Off through configuration mode keeps the error counters; hardware counts from there.
#[test]
fn section_3_1_1_init_leaves_the_error_counters() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &Setup { ..SETUP });
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, 100, 50));
    sim.run_for(Time::from_us(1));
    can.configure(&sim);
    let ecr = can.regs(&sim).ecr().read();
    assert_eq!((ecr.tec(), ecr.rec(), can.regs(&sim).psr().read().ew()), (100, 50, true));
    can.start(&sim);
    let ecr = can.regs(&sim).ecr().read();
    assert_eq!((ecr.tec(), ecr.rec()), (100, 50));
}
