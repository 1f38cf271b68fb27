//! Chapter 34.6: layout of the FIFOs, their pointers and their reset; Examples 34-2 to 34-5; the figures of 34.7.6, 34.9.3.

use can_sim::{DiagnosticKind, Sim, Time};
use pic32_can_pac::{
    enums::{FifoConDonly, FifoConTxen, OperationMode},
    registers::{FifoCon, FifoInt},
};

use crate::bench::*;

fn layout(sim: &Sim, can: Can) -> Vec<(u32, u32)> {
    sim.inspect(can.id, |model| model.layout())
}

/// Figure 34-9: what it calls FIFO3 is FIFO2 (figure_34_9_fifo3): 36 words.
#[test]
fn figure_34_9() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x1000, &[Use::Tx(4), Use::DataOnly(2), Use::Rx(4)]);
    assert_eq!(layout(&sim, can)[..3], [(0x1000, 0x40), (0x1040, 0x10), (0x1050, 0x40)]);
    let (start, bytes) = layout(&sim, can)[2];
    assert_eq!((start + bytes - 0x1000) / 4, 36);
}

/// 34.6.1: with FIFO2 left alone it still takes its default of four words, and FIFO3 begins behind it.
#[test]
fn unused_fifos_take_room() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x1000, &[Use::Tx(4), Use::DataOnly(2), Use::Rx(1), Use::Rx(4)]);
    assert_eq!(layout(&sim, can)[2..4], [(0x1050, 0x10), (0x1060, 0x40)]);
    assert_eq!(can.fifo(&sim, 3).ua().read().bits(), 0x1060);
    assert_eq!((0x1060 + 0x40 - 0x1000) / 4, 40);
}

/// Figure 34-10 and Example 34-2, with OPMOD compared to 4 (decimal_mode_code) and ON set (on_missing_in_steps): 40 words.
#[test]
fn example_34_2() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    let regs = can.regs(&sim);
    regs.con().set_bits(pic32_can_pac::registers::Con::ON);
    can.mode(&sim, OperationMode::Configuration);
    regs.cfg().write(CFG);
    can.base(&sim, 0x2000);
    for fifo in [0, 1] {
        regs.fifo(fifo).con().write(FifoCon::RESET.with_fsize(1));
        regs.fifo(fifo).con().set_bits(FifoCon::from_bits(0x80));
    }
    for fifo in [2, 3] {
        regs.fifo(fifo).con().write(FifoCon::RESET.with_fsize(2));
        regs.fifo(fifo).con().clear_bits(FifoCon::from_bits(0x80));
    }
    can.mode(&sim, OperationMode::Normal);
    assert_eq!(layout(&sim, can)[..4], [(0x2000, 0x20), (0x2020, 0x20), (0x2040, 0x30), (0x2070, 0x30)]);
    let first = [0x2000, 0x2020, 0x2040, 0x2070];
    for (fifo, address) in first.into_iter().enumerate() {
        assert_eq!(regs.fifo(fifo).ua().read().bits(), address);
    }
    // Every buffer of the figure, walked by UINC.
    let expected = [&[0x2000, 0x2010][..], &[0x2020, 0x2030]];
    for (fifo, buffers) in expected.into_iter().enumerate() {
        for address in buffers {
            assert_eq!(regs.fifo(fifo).ua().read().bits(), *address);
            can.queue(&sim, fifo, &frame("100#"));
        }
        assert_eq!(regs.fifo(fifo).ua().read().bits(), buffers[0], "wraps");
    }
    assert_eq!(sim.diagnostics(), []);
}

/// Figure 34-16: FIFO0 receives (figure_34_16), FIFO1 transmits; 164 words up to the end of FIFO31.
#[test]
fn figure_34_16() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x100, &[Use::Rx(4), Use::Tx(7)]);
    let layout = layout(&sim, can);
    assert_eq!(layout[..4], [(0x100, 0x40), (0x140, 0x70), (0x1B0, 0x10), (0x1C0, 0x10)]);
    assert_eq!(layout[31], (0x380, 0x10));
    assert_eq!((0x390 - 0x100) / 4, 164);
}

/// 34.6.1: 29 FIFOs as 0, 1 and 5 to 31 need the room of 32, as 0 to 28 that of 29.
#[test]
fn gaps_cost_memory() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0, &[Use::Rx(1); 32]);
    let layout = layout(&sim, can);
    assert_eq!((layout[31].0 + layout[31].1, layout[28].0 + layout[28].1), (32 * 16, 29 * 16));
}

/// 34.1: 1024 messages of 16 bytes are the most.
#[test]
fn largest_memory() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x2000, &[Use::Tx(32); 32]);
    let (start, bytes) = layout(&sim, can)[31];
    assert_eq!(start + bytes - 0x2000, 16_384);
    assert_eq!(sim.diagnostics(), []);
}

/// Register 34-20: DONLY has no effect on a transmit FIFO.
#[test]
fn data_only_transmit_fifo() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[]);
    let con = FifoCon::RESET.with_txen(FifoConTxen::Transmit).with_donly(FifoConDonly::DataOnly).with_fsize(3);
    can.fifo(&sim, 0).con().write(con);
    can.start(&sim);
    assert_eq!(layout(&sim, can)[..2], [(0x100, 64), (0x140, 16)]);
}

/// Register 34-19: the two lowest bits of CiFIFOBA do not exist.
#[test]
fn base_address_is_word_aligned() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x103, &[Use::Rx(1)]);
    can.start(&sim);
    assert_eq!(can.regs(&sim).fifo_ba().read().bits(), 0x100);
    assert_eq!(can.fifo(&sim, 0).ua().read().bits(), 0x100);
}

/// 34.6: the memory may begin anywhere; addresses in registers are physical.
#[test]
fn memory_at_another_address() {
    let sim = Sim::new();
    let can = add_with(&sim, "can1", |config| config.with_memory_base(0x1000_0000));
    can.set_up(&sim, 0x1000_0100, &[Use::Tx(2), Use::Rx(2)]);
    can.accept_all(&sim, 1);
    can.start(&sim);
    let peer = add_peer(&sim);
    assert_eq!(can.fifo(&sim, 0).ua().read().bits(), 0x1000_0100);
    can.store(&sim, 0x100, &frame("100#AABB"));
    can.fifo(&sim, 0).con().set_bits(FifoCon::UINC | FifoCon::TXREQ);
    sim.peer_send(peer, frame("101#CC"));
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), ["100#AABB"]);
    assert_eq!(can.look(&sim, 0x120), frame("101#CC"));
    assert_eq!(sim.diagnostics(), []);
}

/// Example 34-3: four messages into FIFO0, each with UINC and TXREQ in one write of 0x2008.
#[test]
fn example_34_3() {
    let (sim, can, peer) = bench(&[Use::Tx(4)]);
    for text in ["100#01", "101#02", "102#03", "103#04"] {
        can.load(&sim, 0, &frame(text));
        can.fifo(&sim, 0).con().set_bits(FifoCon::from_bits(0x2008));
    }
    sim.run_for(FRAME * 4);
    assert_eq!(heard(&sim, peer), ["100#01", "101#02", "102#03", "103#04"]);
    assert!(!can.fifo(&sim, 0).con().read().txreq());
    assert_eq!(sim.diagnostics(), []);
}

/// Example 34-4 with UINC of the FIFO that is read (example_34_4_fifo).
#[test]
fn example_34_4() {
    let (sim, can, peer) = bench(&[Use::Rx(1), Use::Rx(4)]);
    can.mode(&sim, OperationMode::Configuration);
    can.regs(&sim).flt_con(0).clear_bits(pic32_can_pac::registers::FltCon::flten_bit(0));
    can.accept_all(&sim, 1);
    can.start(&sim);
    for text in ["100#01", "101#02", "102#03"] {
        sim.peer_send(peer, frame(text));
    }
    sim.run_for(FRAME * 3);
    let mut read = Vec::new();
    while can.fifo(&sim, 1).int_().read().rxnemptyif() {
        read.push(can.look(&sim, can.fifo(&sim, 1).ua().read().bits()).to_string());
        can.fifo(&sim, 1).con().set_bits(FifoCon::from_bits(0x2000));
    }
    assert_eq!(read, ["100#01", "101#02", "102#03"]);
}

/// Example 34-5: FRESET is polled until it is clear; the pointers, TXABAT, TXLARB and TXERR are reset.
#[test]
fn example_34_5() {
    let (sim, can, _) = bench(&[Use::Tx(4), Use::Tx(4)]);
    for fifo in [0, 1] {
        can.queue(&sim, fifo, &frame("100#"));
        can.request(&sim, fifo);
        can.fifo(&sim, fifo).con().clear_bits(FifoCon::TXREQ);
    }
    sim.run_for(FRAME);
    let fifo = can.fifo(&sim, 0);
    fifo.con().set_bits(FifoCon::from_bits(0x4000));
    let mut polls = 0;
    while fifo.con().read().freset() {
        polls += 1;
        assert!(polls < 100);
    }
    assert!(polls > 0, "the reset takes clocks");
    assert_eq!((fifo.ua().read().bits(), fifo.ci().read().fifoci()), (0x100, 0));
    assert!(!fifo.con().read().txabat());
    assert!(fifo.int_().read().txemptyif());
    assert!(!can.fifo(&sim, 1).int_().read().txemptyif(), "the other FIFO keeps its message");
    assert_eq!(can.fifo(&sim, 1).ua().read().bits(), 0x150);
}

/// 34.6.4: what FRESET asks for.
#[test]
fn preconditions_of_freset() {
    let (sim, can, _) = bench(&[Use::Rx(2), Use::Tx(2)]);
    can.fifo(&sim, 0).con().set_bits(FifoCon::FRESET);
    assert!(matches!(&kinds(&sim)[..], [DiagnosticKind::Contradiction { what }] if what.contains("filter")));
    can.send(&sim, 1, &frame("100#"));
    can.fifo(&sim, 1).con().set_bits(FifoCon::FRESET);
    assert!(matches!(&kinds(&sim)[..], [DiagnosticKind::Contradiction { what }] if what.contains("pending")));
}

/// 34.6.4: entering Configuration mode and switching off reset every FIFO.
#[test]
fn other_resets() {
    for off in [false, true] {
        let (sim, can, peer) = bench(&[Use::Rx(2), Use::Tx(2)]);
        sim.peer_send(peer, frame("123#11"));
        can.queue(&sim, 1, &frame("100#"));
        sim.run_for(FRAME);
        assert!(can.fifo(&sim, 0).int_().read().rxnemptyif());
        if off {
            can.mode(&sim, OperationMode::Configuration);
            can.regs(&sim).con().clear_bits(pic32_can_pac::registers::Con::ON);
        } else {
            can.mode(&sim, OperationMode::Configuration);
            can.start(&sim);
        }
        let shown = can.fifo(&sim, 0);
        assert_eq!(shown.int_().read() & FifoInt::RXNEMPTYIF, FifoInt::ZERO);
        assert_eq!((shown.ua().read().bits(), shown.ci().read().bits()), (0x100, 0));
        assert_eq!(can.fifo(&sim, 1).ua().read().bits(), 0x120);
    }
}

/// Register 34-20: FSIZE and DONLY only in Configuration mode; TXEN in every mode (txen_change).
#[test]
fn protected_layout() {
    let (sim, can, _) = bench(&[Use::Rx(2)]);
    can.fifo(&sim, 0).con().write(FifoCon::RESET.with_fsize(7).with_donly(FifoConDonly::DataOnly));
    assert_eq!(can.fifo(&sim, 0).con().read(), FifoCon::RESET.with_fsize(1));
    let refused = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::ProtectedWrite { fields, .. } if fields == &["FSIZE", "DONLY"]);
    assert!(kinds(&sim).iter().any(refused));
    can.fifo(&sim, 1).con().set_bits(FifoCon::TXEN);
    assert!(can.fifo(&sim, 1).int_().read().txemptyif());
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::Contradiction { .. }]));
}

/// Registers as a figure of 34.7.6 shows them: UA, CI, TXNFULLIF, TXHALFIF, TXEMPTYIF, TXREQ.
type Shown = (u32, u8, bool, bool, bool, bool);

fn shown(sim: &Sim, can: Can) -> Shown {
    let fifo = can.fifo(sim, 1);
    let flags = fifo.int_().read();
    (
        fifo.ua().read().bits(),
        fifo.ci().read().fifoci(),
        flags.txnfullif(),
        flags.txhalfif(),
        flags.txemptyif(),
        fifo.con().read().txreq(),
    )
}

/// Figures 34-17 to 34-22: FIFO1 of seven messages, first buffer at 0x140.
#[test]
fn figures_34_17_to_34_22() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x100, &[Use::Rx(4), Use::Tx(7)]);
    let peer = add_peer(&sim);
    assert_eq!(shown(&sim, can), (0x140, 0, true, true, true, false), "Figure 34-17");
    can.send(&sim, 1, &frame("100#00"));
    assert_eq!(shown(&sim, can), (0x150, 0, true, true, false, true), "Figure 34-18");
    sim.run_for(FRAME);
    assert_eq!(shown(&sim, can), (0x150, 1, true, true, true, false), "Figure 34-19");
    for n in 1..7 {
        assert_eq!(can.fifo(&sim, 1).ua().read().bits(), 0x140 + n * 0x10);
        can.queue(&sim, 1, &frame(&format!("100#0{n}")));
    }
    assert_eq!(shown(&sim, can), (0x140, 1, true, false, false, false), "Figure 34-20");
    can.send(&sim, 1, &frame("100#07"));
    assert_eq!(shown(&sim, can), (0x150, 1, false, false, false, true), "Figure 34-21");
    sim.run_for(FRAME * 8);
    assert_eq!(shown(&sim, can), (0x150, 1, true, true, true, false), "Figure 34-22");
    let expected: Vec<String> = (0..8).map(|n| format!("100#0{n}")).collect();
    assert_eq!(heard(&sim, peer), expected);
    assert_eq!(sim.diagnostics(), []);
}

/// Figures 34-30 to 34-36: FIFO0 of seven messages at 0x100 receives. UA, CI, RXOVFLIF, RXFULLIF, RXHALFIF, RXNEMPTYIF.
#[test]
fn figures_34_30_to_34_36() {
    let (sim, can, peer) = bench(&[Use::Rx(7)]);
    let shown = |sim: &Sim| {
        let fifo = can.fifo(sim, 0);
        let flags = fifo.int_().read();
        let (ua, ci) = (fifo.ua().read().bits(), fifo.ci().read().fifoci());
        (ua, ci, flags.rxovflif(), flags.rxfullif(), flags.rxhalfif(), flags.rxnemptyif())
    };
    let mut number = 0;
    let mut receive = |count: u32| {
        for _ in 0..count {
            sim.peer_send(peer, frame(&format!("10{number}#")));
            number += 1;
        }
        sim.run_for(FRAME * u64::from(count));
    };
    assert_eq!(shown(&sim), (0x100, 0, false, false, false, false), "Figure 34-30");
    receive(1);
    assert_eq!(shown(&sim), (0x100, 1, false, false, false, true), "Figure 34-31");
    receive(2);
    assert_eq!(shown(&sim), (0x100, 3, false, false, false, true));
    receive(1);
    assert_eq!(shown(&sim), (0x100, 4, false, false, true, true), "half full with the fourth");
    receive(2);
    assert_eq!(shown(&sim), (0x100, 6, false, false, true, true), "Figure 34-32");
    assert_eq!(can.receive(&sim, 0), Some(frame("100#")));
    assert_eq!(shown(&sim), (0x110, 6, false, false, true, true), "Figure 34-33");
    receive(1);
    assert_eq!(shown(&sim), (0x110, 0, false, false, true, true), "Figure 34-34");
    receive(1);
    assert_eq!(shown(&sim), (0x110, 1, false, true, true, true), "Figure 34-35");
    receive(1);
    assert_eq!(shown(&sim), (0x110, 1, true, true, true, true), "Figure 34-36: MSG8 is lost");
    let rest: Vec<_> = core::iter::from_fn(|| can.receive(&sim, 0)).map(|frame| frame.to_string()).collect();
    assert_eq!(rest, ["101#", "102#", "103#", "104#", "105#", "106#", "107#"]);
    assert!(can.fifo(&sim, 0).int_().read().rxovflif(), "sticky (34.12.3)");
    can.fifo(&sim, 0).int_().clear_bits(FifoInt::RXOVFLIF);
    assert_eq!(shown(&sim), (0x110, 1, false, false, false, false));
}

/// Register 34-22: the user address is not valid in Configuration mode.
#[test]
fn user_address_in_configuration_mode() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[Use::Rx(2)]);
    let _ = can.fifo(&sim, 0).ua().read();
    assert!(matches!(&kinds(&sim)[..], [DiagnosticKind::InvalidRead { register, .. }] if register == "FIFOUA[0]"));
    can.start(&sim);
    let _ = can.fifo(&sim, 0).ua().read();
    assert_eq!(sim.diagnostics(), []);
}

/// uinc_at_limit, uinc_readback.
#[test]
fn uinc_at_the_limit() {
    let (sim, can, _) = bench(&[Use::Tx(2), Use::Rx(2)]);
    can.queue(&sim, 0, &frame("100#"));
    can.queue(&sim, 0, &frame("101#"));
    assert_eq!(sim.diagnostics(), []);
    can.advance(&sim, 0);
    assert_eq!(kinds(&sim), [DiagnosticKind::FifoLimit { fifo: 0, full: true }]);
    can.advance(&sim, 1);
    assert_eq!(kinds(&sim), [DiagnosticKind::FifoLimit { fifo: 1, full: false }]);
    assert_eq!((can.fifo(&sim, 0).ua().read().bits(), can.fifo(&sim, 1).ua().read().bits()), (0x100, 0x120));
    assert!(!can.fifo(&sim, 0).con().read().uinc(), "it always reads 0");
    sim.run_for(Time::from_us(1));
}

/// 34.12.1.5: a FIFO in memory that does not exist stops the module.
#[test]
fn address_error() {
    for transmit in [true, false] {
        let sim = Sim::new();
        let can = add(&sim, "can1");
        let base = WORDS as u32 * 4 - 8;
        can.set_up(&sim, base, &[if transmit { Use::Tx(1) } else { Use::Rx(1) }]);
        can.accept_all(&sim, 0);
        can.start(&sim);
        let beyond = DiagnosticKind::SectionBeyondMemory { section: "fifo", end: base + 16, limit: base + 8 };
        assert_eq!(kinds(&sim), [beyond]);
        let regs = can.regs(&sim);
        regs.int_().set_bits(pic32_can_pac::registers::Int::SERRIE);
        let peer = add_peer(&sim);
        if transmit {
            can.fifo(&sim, 0).con().set_bits(FifoCon::UINC | FifoCon::TXREQ);
        } else {
            sim.peer_send(peer, frame("100#"));
        }
        sim.run_for(FRAME);
        assert!(kinds(&sim).contains(&DiagnosticKind::MemoryOverrun { address: base }));
        assert!(can.flags(&sim).serrif());
        assert_eq!(can.icod(&sim), 0x44);
        assert!(sim.line(can.id, 0));
        assert!(!regs.con().read().canbusy(), "stopped");
        can.clear(&sim, pic32_can_pac::registers::Int::SERRIF);
        assert!(can.flags(&sim).serrif(), "only ON clears it");
        regs.con().clear_bits(pic32_can_pac::registers::Con::ON);
        assert!(!can.flags(&sim).serrif());
        assert_eq!(can.icod(&sim), 0x40);
    }
}
