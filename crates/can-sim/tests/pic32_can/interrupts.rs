//! Chapter 34.12: the three layers, codes, persistency.

use can_sim::{Sim, Time};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{Con, FifoInt, Int},
};

use regbus::Bus;

use crate::bench::*;

/// 34.12.6: the example: FIFO0 pending, then FIFO5 too, then FIFO5 serviced.
#[test]
fn codes_of_fifos() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[Use::Rx(2); 6]);
    can.filter(&sim, 0, 0, 0, standard(0x100), EXACT);
    can.select(&sim, 1, 0, 5, standard(0x105));
    can.start(&sim);
    let peer = add_peer(&sim);
    for fifo in [0, 5] {
        can.fifo(&sim, fifo).int_().set_bits(FifoInt::RXNEMPTYIE);
    }
    can.regs(&sim).int_().set_bits(Int::RBIE);
    assert_eq!(can.icod(&sim), 0x40);
    sim.peer_send(peer, frame("100#"));
    sim.run_for(FRAME);
    assert_eq!((can.icod(&sim), can.regs(&sim).fstat().read().bits()), (0x00, 1));
    sim.peer_send(peer, frame("105#"));
    sim.run_for(FRAME);
    assert_eq!((can.icod(&sim), can.regs(&sim).fstat().read().bits()), (0x05, 1 << 5 | 1));
    assert!(sim.line(can.id, 0));
    can.receive(&sim, 5);
    assert_eq!(can.icod(&sim), 0x00);
    can.receive(&sim, 0);
    assert_eq!(can.icod(&sim), 0x40);
    assert!(!sim.line(can.id, 0));
    assert_eq!(sim.diagnostics(), []);
}

/// Register 34-4, 34.12.6: every code, each masking the lower ones, raised by setting its flag from inside.
#[test]
fn code_priorities() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x100, &[Use::Rx(2), Use::Tx(2)]);
    can.clear(&sim, Int::MODIF);
    let enables = Int::from_bits(0xF80F_0000);
    can.regs(&sim).int_().set_bits(enables);
    can.fifo(&sim, 1).int_().set_bits(FifoInt::TXEMPTYIE);
    assert_eq!(can.icod(&sim), 1);
    let flags = [(Int::CERRIF, 0x41), (Int::WAKIF, 0x42), (Int::CTMRIF, 0x46), (Int::MODIF, 0x47), (Int::IVRIF, 0x48)];
    for (flag, code) in flags {
        set(&sim, can, flag);
        assert_eq!(can.icod(&sim), code);
    }
    for (flag, _) in flags.into_iter().rev() {
        can.clear(&sim, flag);
    }
    assert_eq!(can.icod(&sim), 1);
}

/// Raises a flag as hardware does, and lets the code follow.
fn set(sim: &Sim, can: Can, flag: Int) {
    use can_sim::Model;
    sim.act(can.id, |model, _| {
        let slot = model.registers().find("INT", 0, 0).unwrap();
        let value = model.registers().get(slot);
        model.registers_mut().set(slot, value | flag.bits());
    });
    can.regs(sim).int_().clear_bits(Int::ZERO);
}

/// Register 34-4: without an enable the code stays at no interrupt, however many flags are set (34.12: flags are set
/// whether they are enabled or not).
#[test]
fn codes_need_enables() {
    let (sim, can, peer) = bench(&[Use::Rx(1)]);
    sim.peer_send(peer, frame("100#"));
    sim.peer_send(peer, frame("101#"));
    sim.run_for(FRAME * 2);
    assert!(can.flags(&sim).modif());
    assert!(can.fifo(&sim, 0).int_().read().contains(FifoInt::RXOVFLIF | FifoInt::RXFULLIF | FifoInt::RXNEMPTYIF));
    assert!(!can.flags(&sim).rbif() && !can.flags(&sim).rbovif());
    assert_eq!(can.icod(&sim), 0x40);
    can.regs(&sim).int_().set_bits(Int::MODIE);
    assert_eq!(can.icod(&sim), 0x47);
    assert!(sim.line(can.id, 0));
    can.clear(&sim, Int::MODIF);
    assert_eq!(can.icod(&sim), 0x40);
    assert!(!sim.line(can.id, 0));
}

/// 34.12.1.7, 34.12.5: overflow: RXOVFLIF, CiRXOVF with RXOVFLIE, RBOVIF, code 0x43; only RXOVFLIF can be cleared.
#[test]
fn receive_overflow() {
    let (sim, can, peer) = bench(&[Use::Rx(1)]);
    can.regs(&sim).int_().set_bits(Int::RBOVIE);
    sim.peer_send(peer, frame("100#"));
    sim.peer_send(peer, frame("101#"));
    sim.run_for(FRAME * 2);
    assert_eq!(can.regs(&sim).rxovf().read().bits(), 0, "not without RXOVFLIE");
    can.fifo(&sim, 0).int_().set_bits(FifoInt::RXOVFLIE);
    assert_eq!(can.regs(&sim).rxovf().read().bits(), 1, "rxovf_level");
    assert!(can.flags(&sim).rbovif());
    assert_eq!(can.icod(&sim), 0x43);
    can.clear(&sim, Int::RBOVIF);
    sim.registers(can.id).write(0x064, 1_u32);
    assert!(can.flags(&sim).rbovif());
    assert_eq!(can.regs(&sim).fstat().read().bits(), 0, "34.12.4: an overflow is not in CiFSTAT");
    can.fifo(&sim, 0).int_().clear_bits(FifoInt::RXOVFLIF);
    assert!(!can.flags(&sim).rbovif());
    assert_eq!(can.icod(&sim), 0x40);
}

/// 34.12.1.10, 34.12.1.11, 34.12.3: TBIF and RBIF are the OR of their sources, and go away with them only.
#[test]
fn persistent_interrupts() {
    let (sim, can, peer) = bench(&[Use::Rx(2), Use::Tx(2)]);
    can.regs(&sim).int_().set_bits(Int::TBIE | Int::RBIE);
    can.fifo(&sim, 1).int_().set_bits(FifoInt::TXEMPTYIE);
    assert!(can.flags(&sim).tbif() && sim.line(can.id, 0), "an empty transmit FIFO fires at once");
    can.clear(&sim, Int::TBIF);
    assert!(can.flags(&sim).tbif());
    can.queue(&sim, 1, &frame("100#"));
    assert!(!can.flags(&sim).tbif());
    for (enable, filled) in [(FifoInt::RXNEMPTYIE, 1), (FifoInt::RXHALFIE, 1), (FifoInt::RXFULLIE, 2)] {
        can.fifo(&sim, 0).int_().set_bits(enable);
        for n in 1..=2 {
            sim.peer_send(peer, frame("100#"));
            sim.run_for(FRAME);
            assert_eq!(can.flags(&sim).rbif(), n >= filled, "{enable:?} with {n}");
        }
        can.clear(&sim, Int::RBIF);
        assert!(can.flags(&sim).rbif());
        while can.receive(&sim, 0).is_some() {}
        assert!(!can.flags(&sim).rbif());
        can.fifo(&sim, 0).int_().clear_bits(enable);
    }
}

/// Register 34-21: the flags of the other direction read 0.
#[test]
fn flags_of_the_other_direction() {
    let (sim, can, _) = bench(&[Use::Rx(2), Use::Tx(2)]);
    let transmit = FifoInt::TXNFULLIF | FifoInt::TXHALFIF | FifoInt::TXEMPTYIF;
    assert_eq!(can.fifo(&sim, 0).int_().read(), FifoInt::ZERO);
    assert_eq!(can.fifo(&sim, 1).int_().read(), transmit);
}

/// 34.12.1.8: MODIF, also for changes that the software requested.
#[test]
fn mode_change_interrupt() {
    let (sim, can, _) = bench(&[Use::Rx(2)]);
    can.clear(&sim, Int::MODIF);
    can.regs(&sim).int_().set_bits(Int::MODIE);
    can.regs(&sim).con().modify(|con| con.with_reqop(OperationMode::Disable));
    assert!(sim.run_until(FRAME, |sim| sim.line(can.id, 0)).is_some());
    assert_eq!(can.icod(&sim), 0x47);
    assert_eq!(can.opmod(&sim), OperationMode::Disable);
}

/// 34.12.7: FILHIT is the filter that matched last; clearing interrupts leaves it.
#[test]
fn filter_hit() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[Use::Rx(4)]);
    can.filter(&sim, 17, 0, 0, standard(0x100), EXACT);
    can.select(&sim, 30, 0, 0, standard(0x101));
    can.start(&sim);
    let peer = add_peer(&sim);
    for (text, hit) in [("100#", 17), ("101#", 30), ("102#", 30)] {
        sim.peer_send(peer, frame(text));
        sim.run_for(FRAME);
        can.clear(&sim, Int::from_bits(0xFFFF));
        assert_eq!(can.filhit(&sim), hit);
    }
}

/// An interrupt handler with a jump table on ICOD, as 34.12.6 recommends, drains everything.
#[test]
fn handler_with_a_jump_table() {
    use std::{cell::RefCell, rc::Rc};
    let (sim, can, peer) = bench(&[Use::Rx(4), Use::Tx(4)]);
    can.regs(&sim).con().set_bits(Con::CANCAP);
    can.clear(&sim, Int::MODIF);
    can.regs(&sim).int_().set_bits(Int::RBIE | Int::MODIE | Int::IVRIE);
    can.fifo(&sim, 0).int_().set_bits(FifoInt::RXNEMPTYIE);
    let read = Rc::new(RefCell::new(Vec::new()));
    let log = Rc::clone(&read);
    sim.on_interrupt(can.id, 0, move |sim| match can.icod(sim) {
        0 => log.borrow_mut().push(can.receive(sim, 0).unwrap().to_string()),
        0x47 => can.clear(sim, Int::MODIF),
        0x48 => can.clear(sim, Int::IVRIF),
        code => panic!("{code:#x}"),
    });
    for text in ["100#", "101#", "102#"] {
        sim.peer_send(peer, frame(text));
    }
    sim.run_for(FRAME * 4);
    can.mode(&sim, OperationMode::ListenAll);
    sim.run_for(Time::from_us(5));
    assert_eq!(*read.borrow(), ["100#", "101#", "102#"]);
    assert_eq!(sim.diagnostics(), []);
}
