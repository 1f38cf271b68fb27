//! Error and protocol status, timestamps, timeout and interrupts: sections 2.3.9 to 2.3.19, 3.2.1 and 3.3 of the manual.

use std::{cell::RefCell, rc::Rc};

use crate::bench::{Can, FD, FRAME, SETUP, Setup, add, add_with, choices, frame};
use can_sim::{Sim, Time, m_can::RamFailure};
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
use m_can_pac::{
    enums::{Activity, LastErrorCode},
    registers::{self as pac, Ir},
};
use regbus::Bus;

fn running(setup: &Setup) -> (Sim, Can) {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, setup);
    (sim, can)
}

fn invert(sim: &Sim, can: Can, field: Field, bit: u16, frames: Frames) {
    let (node, position) = (sim.node(can.id), Position::new(field, bit));
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
}

/// 2.3.13, 2.3.14, 2.3.16: warning, error passive, Bus_Off, and the recovery in 129 sequences.
#[test]
fn section_2_3_14_bus_off_and_recovery() {
    let (sim, can) = running(&SETUP);
    let regs = can.regs(&sim);
    sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    invert(&sim, can, Field::Data, 0, Frames::all());
    can.send(&sim, 0, &frame("123#00"));
    let seen = |flag: Ir| sim.run_until(FRAME * 100, |sim| can.ir(sim).contains(flag)).unwrap();
    seen(Ir::EW);
    let ecr = regs.ecr().read();
    assert_eq!((ecr.tec(), ecr.cel()), (96, 12));
    assert!(regs.psr().read().ew());
    seen(Ir::EP);
    let psr = regs.psr().read();
    assert!(psr.ep() && regs.ecr().read().tec() == 128, "{psr:?}");
    assert_eq!(psr.lec(), LastErrorCode::Bit0Error, "the first data bit was sent dominant");
    seen(Ir::BO);
    assert!(regs.psr().read().bo() && regs.cccr().read().init(), "INIT is set by hardware");
    assert_eq!(sim.diagnostics(), [], "the pending request waits, it is no mistake");
    sim.with_wire(|wire| wire.clear_faults());
    can.clear(&sim);
    let start = sim.now();
    regs.cccr().write(pac::Cccr::ZERO);
    sim.run_for(Time::from_us(11 * 64));
    // Toggling INIT starts the count again.
    can.configure(&sim);
    let restart = sim.now();
    can.start(&sim);
    sim.run_for(Time::from_us(11 * 10));
    let ecr = regs.ecr().read();
    assert!((10..=12).contains(&ecr.rec()), "REC counts the sequences: {ecr:?}");
    assert_eq!(regs.psr().read().lec(), LastErrorCode::Bit0Error);
    assert!(can.ir(&sim).contains(Ir::PEA));
    let end = sim.run_until(Time::from_ms(2), |sim| can.ir(sim).contains(Ir::BO)).unwrap();
    let length = end.since(restart);
    assert!((Time::from_us(11 * 129)..Time::from_us(11 * 129 + 5)).contains(&length), "{length}, {start}");
    let (ecr, psr) = (regs.ecr().read(), regs.psr().read());
    assert_eq!((ecr.tec(), ecr.rec(), ecr.rp(), psr.bo(), psr.ep(), psr.ew()), (0, 0, false, false, false, false));
    assert_eq!(regs.txbrp().read().bits(), 0, "configuration mode reset the request");
    can.send(&sim, 0, &frame("123#00"));
    sim.run_for(FRAME);
    assert_eq!(regs.txbto().read().bits(), 1);
}

/// 2.3.13: REC, RP, and CEL that sticks at 0xFF and then sets ELO.
#[test]
fn section_2_3_13_error_counters() {
    let (sim, can) = running(&SETUP);
    let regs = can.regs(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, 0, 127));
    sim.run_for(Time::from_us(1));
    assert_eq!((regs.ecr().read().rec(), regs.ecr().read().rp()), (127, false));
    invert(&sim, can, Field::Data, 0, Frames::next());
    sim.peer_send(peer, frame("123#00"));
    let found = sim.run_until(FRAME, |sim| can.ir(sim).contains(Ir::EP));
    assert!(found.is_some(), "{:#?} {}", sim.bus_log(), sim.describe(can.id));
    let ecr = regs.ecr().read();
    assert_eq!((ecr.rec(), ecr.rp(), ecr.cel()), (127, true, 0), "CEL does not count when only RP is set");
    sim.run_for(FRAME * 2);
    assert!(!regs.ecr().read().rp());
    let one_error = || {
        for node in [node, sim.peer_node(peer)] {
            sim.with_wire(|wire| wire.set_error_counters(node, 0, 0));
        }
        invert(&sim, can, Field::Data, 0, Frames::next());
        sim.peer_send(peer, frame("123#00"));
        sim.run_for(FRAME * 2);
    };
    for _ in 0..255 {
        one_error();
    }
    assert_eq!(sim.registers(can.id).read::<u8>(0x041), 0, "byte 1 leaves CEL alone");
    assert_eq!(can.ir(&sim) & Ir::ELO, Ir::ZERO);
    one_error();
    assert!(can.ir(&sim).contains(Ir::ELO), "CEL has stuck at 0xFF");
    assert_eq!((regs.ecr().read().cel(), regs.ecr().read().cel()), (0xFF, 0));
}

/// 2.3.14: LEC for the arbitration phase, DLEC once the data phase is reached; RFDF, RBRS, RESI whatever the filters say.
#[test]
fn section_2_3_14_error_codes_of_both_phases() {
    let (sim, can) = running(&Setup { cccr: FD, gfc: 2 << 4, ..SETUP });
    let regs = can.regs(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let codes = |text: &str| {
        sim.peer_send(peer, frame(text));
        sim.run_for(FRAME * 2);
        let psr = regs.psr().read();
        (psr.lec().bits(), psr.dlec().bits(), psr.rfdf(), psr.rbrs(), psr.resi())
    };
    assert_eq!(codes("123#11"), (0, 7, false, false, false));
    assert_eq!(codes("123##011"), (0, 7, true, false, false));
    assert_eq!(codes("123##311"), (7, 0, true, true, true), "the next event of such a frame is shown in DLEC");
    assert_eq!(regs.psr().read().bits() & 0x7F07, 0x0707, "the read has cleared all of it");
    for (field, flag, lec) in
        [(Field::Dlc, Ir::PED, false), (Field::CrcDelimiter, Ir::PED, false), (Field::Fdf, Ir::PEA, true)]
    {
        can.clear(&sim);
        invert(&sim, can, field, 0, Frames::next());
        sim.peer_send(peer, frame("123##111"));
        sim.run_until(FRAME * 2, |sim| can.ir(sim).intersects(Ir::PEA | Ir::PED)).unwrap();
        assert_eq!(can.ir(&sim) & (Ir::PEA | Ir::PED), flag, "{field}");
        let psr = regs.psr().read();
        assert_eq!((psr.lec().bits() != 7, psr.dlec().bits() != 7), (lec, !lec), "{field}");
        sim.run_for(FRAME * 2);
        let _ = regs.psr().read();
    }
}

/// 2.3.9, 2.3.10, 3.2.1: timestamps: internal with prescaler, external, zero; wrap-around; reset by a write.
#[test]
fn section_3_2_1_timestamps() {
    for tcp in [0, 3] {
        let sim = Sim::new();
        let can = add(&sim, "can0");
        can.set_up(&sim, &SETUP);
        can.regs(&sim).tscc().write(pac::Tscc::from_bits(tcp << 16 | 1));
        can.start(&sim);
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        sim.registers(can.id).write(0x027, 0x55_u8);
        let reset = sim.now();
        sim.run_for(Time::from_us(1_000));
        let tsc = u64::from(can.regs(&sim).tscv().read().tsc());
        let bits = sim.now().since(reset).as_ns() / 1_000;
        assert!(tsc.abs_diff(bits / u64::from(tcp + 1)) <= 1, "{tsc} after {bits} bits");
        sim.peer_send(peer, frame("123#11"));
        sim.run_for(FRAME);
        let rxts = u64::from(sim.with_memory(can.ram, |memory| memory.word(0x11).unwrap()) & 0xFFFF);
        assert!((tsc..=tsc + 3).contains(&rxts), "captured at SOF: {rxts}, {tsc}");
        assert!(!can.ir(&sim).contains(Ir::TSW), "a write is no wrap-around");
        let wrap = sim.run_until(Time::from_ms(70 * 4), |sim| can.ir(sim).contains(Ir::TSW)).unwrap();
        let bits = wrap.since(reset).as_ns() / 1_000;
        assert!(bits.abs_diff(65_536 * u64::from(tcp + 1)) <= 20, "{bits}");
    }
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.set_up(&sim, &SETUP);
    can.regs(&sim).tscc().write(pac::Tscc::from_bits(2));
    can.start(&sim);
    sim.registers(can.id).write(0x024, 0_u32);
    assert_eq!(u64::from(can.regs(&sim).tscv().read().tsc()), sim.now().as_ns() / 1_000, "a write does nothing");
    assert!(!sim.diagnostics().is_empty());
}

/// 2.3.11, 2.3.12, 3.3: the timeout counter in Continuous Mode and under FIFO control.
#[test]
fn section_3_3_timeout_counter() {
    let bench = |tocc: u32| {
        let sim = Sim::new();
        let can = add(&sim, "can0");
        can.set_up(&sim, &SETUP);
        can.regs(&sim).tocc().write(pac::Tocc::from_bits(tocc));
        assert_eq!(can.regs(&sim).tocv().read().bits(), 500);
        can.start(&sim);
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        (sim, can, peer)
    };
    let toc = |sim: &Sim, can: Can| u64::from(can.regs(sim).tocv().read().toc());
    let (sim, can, _) = bench(500 << 16 | 1);
    let left = toc(&sim, can);
    assert!((250..300).contains(&left), "runs since INIT was reset: {left}");
    sim.registers(can.id).write(0x02F, 0_u8);
    let preset = sim.now();
    assert!((499..=500).contains(&toc(&sim, can)));
    for expiry in 1..4_u64 {
        let at = sim.run_until(Time::from_ms(2), |sim| can.ir(sim).contains(Ir::TOO)).unwrap();
        assert!(at.since(preset).as_ns().abs_diff(500_000 * expiry) < 2_000, "restarts at TOP at once");
        can.clear(&sim);
    }
    can.configure(&sim);
    assert_eq!(toc(&sim, can), 500);
    for (tos, filter) in [(2, 0), (3, 1 << 4)] {
        let (sim, can, peer) = bench(500 << 16 | tos << 1 | 1);
        can.configure(&sim);
        can.regs(&sim).gfc().write(pac::Gfc::from_bits(filter));
        can.start(&sim);
        sim.run_for(FRAME * 5);
        assert_eq!(toc(&sim, can), 500, "an empty FIFO presets the counter");
        sim.peer_send(peer, frame("123#"));
        sim.run_until(FRAME, |sim| toc(sim, can) < 500).unwrap();
        let stored = sim.now();
        sim.registers(can.id).write(0x02C, 0_u32);
        assert!(toc(&sim, can) < 500, "a write does nothing");
        let at = sim.run_until(Time::from_ms(2), |sim| can.ir(sim).contains(Ir::TOO)).unwrap();
        assert!(at.since(stored).as_ns().abs_diff(500_000) < 3_000, "{}", at.since(stored));
        can.clear(&sim);
        sim.run_for(Time::from_ms(2));
        assert_eq!((toc(&sim, can), can.ir(&sim) & Ir::TOO), (0, Ir::ZERO), "stopped");
        assert!(can.receive(&sim, tos as usize - 2).is_some());
        assert_eq!(toc(&sim, can), 500);
    }
}

/// 2.3.16 to 2.3.19: flags, enables, line selection, line enables; handlers see the lines.
#[test]
fn section_2_3_16_interrupt_lines() {
    let (sim, can) = running(&SETUP);
    let regs = can.regs(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let changes = Rc::new(RefCell::new(Vec::new()));
    for line in 0..2 {
        let changes = Rc::clone(&changes);
        sim.on_line(can.id, line, move |_, level| changes.borrow_mut().push((line, level)));
    }
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert!(can.ir(&sim).contains(Ir::RF0N), "set without being enabled");
    regs.ie().write(pac::Ie::from_bits(Ir::RF0N.bits()));
    assert!(!sim.line(can.id, 0), "both lines are disabled after reset");
    regs.ile().write(pac::Ile::from_bits(3));
    assert!(sim.line(can.id, 0) && !sim.line(can.id, 1));
    regs.ils().write(pac::Ils::from_bits(Ir::RF0N.bits()));
    assert!(!sim.line(can.id, 0) && sim.line(can.id, 1));
    regs.ir().clear(Ir::RF0N);
    assert!(!sim.line(can.id, 1));
    assert_eq!(*changes.borrow(), [(0, true), (0, false), (1, true), (1, false)]);
    // A level-sensitive handler that receives.
    let received = Rc::new(RefCell::new(Vec::new()));
    let sink = Rc::clone(&received);
    sim.on_interrupt(can.id, 1, move |sim| {
        can.regs(sim).ir().clear(Ir::RF0N);
        while let Some(frame) = can.receive(sim, 0) {
            sink.borrow_mut().push(frame);
        }
    });
    for text in ["200#", "201#", "202#", "203#"] {
        sim.peer_send(peer, frame(text));
    }
    sim.run_for(FRAME * 5);
    let texts: Vec<String> = received.borrow().iter().map(ToString::to_string).collect();
    assert_eq!(texts, ["123#", "200#", "201#", "202#", "203#"]);
}

/// `per_buffer_enable_gates`: whether TXBTIE keeps IR.TC from being set, or only from reaching the line.
#[test]
fn section_2_3_43_per_buffer_enables() {
    for gates in [true, false] {
        let sim = Sim::new();
        let can =
            add_with(&sim, "can0", |config| config.with_choices(choices(|c| c.per_buffer_enable_gates_flag = gates)));
        can.run(&sim, &SETUP);
        sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        let regs = can.regs(&sim);
        regs.ie().write(pac::Ie::from_bits(Ir::TC.bits()));
        regs.ile().write(pac::Ile::EINT0);
        regs.txbtie().write(pac::Txbtie::from_bits(2));
        can.send(&sim, 0, &frame("123#"));
        sim.run_for(FRAME);
        assert_eq!((can.ir(&sim).contains(Ir::TC), sim.line(can.id, 0)), (!gates, false));
        can.clear(&sim);
        can.send(&sim, 1, &frame("123#"));
        sim.run_for(FRAME);
        assert_eq!((can.ir(&sim).contains(Ir::TC), sim.line(can.id, 0)), (true, true));
    }
}

/// 2.3.6, 2.3.16: watchdog and bit errors of the Message RAM.
#[test]
fn section_2_3_16_message_ram_failures() {
    let (sim, can) = running(&SETUP);
    let fail = |failure| sim.act(can.id, |model, cx| model.fail_ram(cx, failure));
    fail(RamFailure::NoAnswer);
    assert_eq!(can.ir(&sim) & Ir::WDI, Ir::ZERO, "WDC = 0 disables the watchdog");
    fail(RamFailure::Corrected);
    assert_eq!(can.ir(&sim) & (Ir::BEC | Ir::BEU), Ir::BEC);
    assert!(!can.regs(&sim).cccr().read().init());
    for _ in 0..2 {
        fail(RamFailure::Uncorrected);
        assert!(can.ir(&sim).contains(Ir::BEU) && can.regs(&sim).cccr().read().init());
        can.start(&sim);
        assert_eq!(can.regs(&sim).psr().read().act(), Activity::Idle, "clearing INIT suffices");
    }
    can.configure(&sim);
    can.regs(&sim).rwd().write(pac::Rwd::RESET.with_wdc(0x40));
    assert_eq!(can.regs(&sim).rwd().read().wdv(), 0x40);
    can.start(&sim);
    fail(RamFailure::NoAnswer);
    assert!(can.ir(&sim).contains(Ir::WDI));
}
