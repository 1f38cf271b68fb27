//! Bugs that drivers for ECAN have really had, each as the driver would have it, and how it shows here.

use std::{cell::RefCell, rc::Rc};

use crate::{
    bench::{CFG1, FIFO_5_TO_11, FRAME, add_with, everything, frame, kinds, pair, pair_with, peer, received},
    fifo,
    interrupts::EVENT,
};
use can_sim::{DiagnosticKind, Sim, Time};
use dspic33_ecan_pac::{
    enums::{Ctrl1Win, FilterTarget, InterruptCode, OperationMode, TxPriority},
    registers::{self as pac, Inte, Intf},
};
use regbus::Bus;

/// The FIFO is drained by the buffer that ICODE names: when two messages have come before the handler runs, the older
/// one stays behind, and the module later finds its buffer full.
#[test]
fn draining_the_fifo_by_icode() {
    let run = |by_icode: bool| {
        let (sim, can, other) = fifo::bench(FIFO_5_TO_11);
        can.regs(&sim).inte().write(Inte::RBIE);
        let mut read = Vec::new();
        for pair in 0..8 {
            fifo::receive(&sim, other, 2 * pair);
            fifo::receive(&sim, other, 2 * pair + 1);
            let code = can.regs(&sim).vec().read().icode();
            can.regs(&sim).intf().clear(Intf::RBIF);
            if by_icode {
                let Ok(InterruptCode::Trb(buffer) | InterruptCode::Rb(buffer)) = code else { panic!("{code:?}") };
                read.extend(can.take(&sim, usize::from(buffer)).map(|frame| frame.data_bytes()[0]));
            } else {
                while let Some(frame) = can.take_from_fifo(&sim) {
                    read.push(frame.data_bytes()[0]);
                }
            }
        }
        (read, can.regs(&sim).rxovf(1).read().bits(), kinds(&sim))
    };
    let (read, lost, found) = run(false);
    assert_eq!((read, lost, found), ((0..16).collect(), 0, vec![]));
    let (read, lost, found) = run(true);
    assert!(read.len() < 16 && lost != 0, "{read:?}");
    assert!(matches!(found[0], DiagnosticKind::AcknowledgeInvalid { register: "RXFUL", .. }), "{found:?}");
}

/// ICODE names the buffer that was served last, not the oldest.
#[test]
fn icode_is_not_the_read_pointer() {
    let (sim, can, other) = fifo::bench(FIFO_5_TO_11);
    can.regs(&sim).inte().write(Inte::RBIE);
    fifo::receive(&sim, other, 1);
    fifo::receive(&sim, other, 2);
    assert_eq!(can.regs(&sim).vec().read().icode(), Ok(InterruptCode::Trb(6)));
    assert_eq!(can.regs(&sim).fifo().read().fnrb().map(|buffer| buffer.bits()), Ok(5));
}

/// After an overflow FBP has passed buffers that FNRB has not: a driver that waits for the buffer which FNRB names finds it
/// empty although others are full, and later reads them in the wrong order.
#[test]
fn draining_by_fnrb_after_an_overflow() {
    let (sim, can, other) = fifo::bench(FIFO_5_TO_11);
    for number in 0..9 {
        fifo::receive(&sim, other, number);
    }
    while can.take_from_fifo(&sim).is_some() {}
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0x0705, "empty, and the next message goes to buffer 7");
    fifo::receive(&sim, other, 10);
    assert_eq!(can.take_from_fifo(&sim), None);
    for number in 11..17 {
        fifo::receive(&sim, other, number);
    }
    assert_eq!(can.take_from_fifo(&sim), Some(frame("100#0F")), "not the oldest");
    let expected = DiagnosticKind::AcknowledgeInvalid { register: "RXFUL", index: 5, get: 7, fill: 7 };
    assert_eq!(kinds(&sim), [expected]);
}

/// The handler comes while the main program has the filter window open: its store to clear RXFUL changes a buffer pointer.
#[test]
fn an_interrupt_while_the_filter_window_is_open() {
    let (sim, can, other) = pair();
    can.regs(&sim).inte().write(Inte::RBIE);
    let calls = Rc::new(RefCell::new(0));
    let counter = Rc::clone(&calls);
    sim.on_interrupt(can.id, EVENT, move |sim| {
        *counter.borrow_mut() += 1;
        can.release(sim, 8);
        can.regs(sim).intf().clear(Intf::RBIF);
    });
    let mut regs = can.regs(&sim);
    regs.filter_window(|window| {
        sim.peer_send(other, frame("100#01"));
        sim.run_for(FRAME);
        assert_ne!(window.buf_pnt(1).read().bits(), 0x0008, "the pointers of filters 0 to 3 are spoilt");
    });
    assert_eq!(*calls.borrow(), 1);
    assert!(can.is_full(&sim, 8), "and the buffer was not released");
    let register = "BUFPNT[1]".to_owned();
    assert_eq!(kinds(&sim), [DiagnosticKind::WindowOfAnother { register, window: "filter", handler: true }]);
}

/// The handler opens the filter window and does not close it: the main program requests a transmission in a mask.
#[test]
fn win_left_set_by_an_interrupt_handler() {
    let (sim, can, other) = pair();
    can.regs(&sim).inte().write(Inte::RBIE);
    sim.on_interrupt(can.id, EVENT, move |sim| {
        can.release(sim, 8);
        can.regs(sim).intf().clear(Intf::RBIF);
        can.regs(sim).ctrl1().modify(|value| value.with_win(Ctrl1Win::Filter));
        let bus = sim.registers(can.id);
        bus.write(0x40, 0x2000_u16);
    });
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(kinds(&sim), [], "the handler itself did what it wanted");
    can.send(&sim, 0, &frame("200#"));
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), Vec::<String>::new());
    let found = kinds(&sim);
    assert!(
        matches!(&found[..], [DiagnosticKind::WindowOfAnother { register, handler: false, .. }] if register == "RXMSID[0]"),
        "{found:?}"
    );
}

/// A handler that saves and restores WIN harms nobody.
#[test]
fn a_handler_that_restores_win() {
    let (sim, can, other) = pair();
    can.regs(&sim).inte().write(Inte::RBIE);
    sim.on_interrupt(can.id, EVENT, move |sim| {
        let ctrl1 = can.regs(sim).ctrl1();
        let saved = ctrl1.read();
        ctrl1.write(saved.with_win(Ctrl1Win::Buffer));
        can.release(sim, 8);
        can.regs(sim).intf().clear(Intf::RBIF);
        ctrl1.write(saved);
    });
    let mut regs = can.regs(&sim);
    regs.filter_window(|window| {
        sim.peer_send(other, frame("100#01"));
        sim.run_for(FRAME);
        window.buf_pnt(1).modify(|value| value.with_fbp(0, FilterTarget::Buffer(9)));
    });
    sim.peer_send(other, frame("100#02"));
    sim.run_for(FRAME);
    assert!(!can.is_full(&sim, 8) && can.is_full(&sim, 9));
    assert_eq!(sim.diagnostics(), []);
}

/// Example 9-2 ends with WIN still 1: nothing that follows reaches the transmit control or the full flags.
#[test]
fn example_9_2_leaves_win_set() {
    let sim = Sim::new();
    let can =
        add_with(&sim, "can1", |config| config).set_up(&sim).add_filter(&sim, everything(FilterTarget::Buffer(8)));
    can.regs(&sim).ctrl1().modify(|value| value.with_win(Ctrl1Win::Filter));
    can.enter(&sim, OperationMode::Normal);
    let found = kinds(&sim);
    assert!(
        matches!(&found[..], [DiagnosticKind::Contradiction { what }] if what.contains("filter window")),
        "{found:?}"
    );
    // An address that only the buffer window would leave free.
    let _ = sim.registers(can.id).read::<u16>(0x28);
    assert_eq!(kinds(&sim), [DiagnosticKind::ReservedAddress { offset: 0x28, write: false }]);
}

/// RXFUL is cleared by a read-modify-write: a message that is stored between the read and the write is lost.
#[test]
fn rxful_cleared_by_read_modify_write() {
    let run = |read_modify_write: bool| {
        let (sim, can, other) = fifo::bench(FIFO_5_TO_11);
        fifo::receive(&sim, other, 1);
        let (bus, offset) = (sim.registers(can.id), can.regs(&sim).rxful(1).offset());
        let old: u16 = bus.read(offset);
        // The handler is interrupted here.
        fifo::receive(&sim, other, 2);
        bus.write(offset, if read_modify_write { old & !0x20 } else { !0x20 });
        (can.take_from_fifo(&sim), kinds(&sim))
    };
    assert_eq!(run(false), (Some(frame("100#02")), vec![]));
    let (message, found) = run(true);
    assert_eq!(message, None, "the second message is gone");
    let stale = DiagnosticKind::StaleWrite { register: "RXFUL[1]".into(), fields: vec!["RXFUL"], bits: 0x40 };
    assert!(found.contains(&stale), "{found:?}");
}

/// The same with the flags of CxINTF.
#[test]
fn intf_cleared_by_read_modify_write() {
    let (sim, can, other) = pair();
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME);
    let (bus, offset) = (sim.registers(can.id), can.regs(&sim).intf().offset());
    let old: u16 = bus.read(offset);
    sim.peer_send(other, frame("101#"));
    sim.run_for(FRAME);
    bus.write(offset, old & !Intf::TBIF.bits());
    assert!(!can.intf(&sim).rbif());
    let stale = DiagnosticKind::StaleWrite { register: "INTF".into(), fields: vec!["RBIF"], bits: 0x02 };
    assert_eq!(kinds(&sim), [stale]);
}

/// No DMA channel has the receive request: nothing arrives, and the module says nothing.
#[test]
fn receive_dma_channel_missing() {
    let (sim, can, other) = pair_with(|mut config| {
        config.receive_dma = None;
        config
    });
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(other).len(), 1, "it is acknowledged all the same");
    assert_eq!((can.intf(&sim).bits(), can.is_full(&sim, 8)), (0, false));
    let because = "no enabled DMA channel has the request";
    assert_eq!(kinds(&sim), [DiagnosticKind::TransferNotServed { request: "CxRX", buffer: 8, because }]);
}

/// No DMA channel has the transmit request: TXREQ stays set for ever.
#[test]
fn transmit_dma_channel_missing() {
    let (sim, can, other) = pair_with(|mut config| {
        config.transmit_dma = None;
        config
    });
    can.send(&sim, 0, &frame("100#01"));
    sim.run_for(FRAME * 5);
    assert!(can.outcome(&sim, 0).0);
    assert_eq!(received(&sim, other), Vec::<String>::new());
    let because = "no enabled DMA channel has the request";
    assert_eq!(kinds(&sim), [DiagnosticKind::TransferNotServed { request: "CxTX", buffer: 0, because }]);
    sim.act(can.id, |model, cx| {
        let [_, receive] = model.dma_channels();
        model.set_dma(cx, receive, receive);
    });
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["100#01"]);
}

/// The two channels have different start addresses: what is written is not what is sent.
#[test]
fn dma_channels_with_different_starts() {
    let (sim, can, other) = pair_with(|mut config| {
        config.transmit_dma = Some(can_sim::dspic33_ecan::DmaChannel::new(0x200));
        config
    });
    can.send(&sim, 0, &frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["000#"]);
}

/// The bit timing is written in Normal mode, or before OPMODE shows Configuration mode.
#[test]
fn configuration_outside_configuration_mode() {
    let (sim, can, _) = pair();
    let regs = can.regs(&sim);
    regs.ctrl1().modify(|value| value.with_reqop(OperationMode::Configuration));
    regs.cfg1().write(pac::Cfg1::RESET.with_brp(7));
    assert_eq!(regs.cfg1().read(), CFG1);
    let found = kinds(&sim);
    assert!(
        matches!(&found[..], [DiagnosticKind::ProtectedWrite { register, condition: "configuration", .. }] if register == "CFG1"),
        "{found:?}"
    );
    while regs.ctrl1().read().opmode() != Ok(OperationMode::Configuration) {}
    regs.cfg1().write(pac::Cfg1::RESET.with_brp(7));
    assert_eq!(regs.cfg1().read().brp(), 7);
}

/// TXREQ of one buffer is set by a read-modify-write while the message of the other buffer of the register completes:
/// its old TXREQ goes back in, and the message is sent twice.
#[test]
fn txreq_read_modify_write_sends_twice() {
    let (sim, can, other) = pair();
    can.transmit_buffer(&sim, 1, TxPriority::Lowest);
    can.send(&sim, 0, &frame("100#AA"));
    can.write(&sim, 1, &frame("101#BB"));
    let control = can.regs(&sim).tr_con_of(0).0;
    let old = control.read();
    sim.run_for(FRAME);
    control.write(old.with_txreq(1, true));
    sim.run_for(FRAME * 3);
    assert_eq!(received(&sim, other), ["100#AA", "101#BB", "100#AA"]);
    let stale = DiagnosticKind::StaleWrite { register: "TRCON[0]".into(), fields: vec!["TXREQ"], bits: 1 << 3 };
    assert_eq!(kinds(&sim), [stale]);
}

/// The other way round: hardware sets TXREQ for a remote frame between the read and the write, and the answer is aborted.
#[test]
fn txreq_read_modify_write_aborts_an_answer() {
    let sim = Sim::new();
    let can =
        add_with(&sim, "can1", |config| config).set_up(&sim).add_filter(&sim, everything(FilterTarget::Buffer(0)));
    can.transmit_buffer(&sim, 0, TxPriority::Lowest).transmit_buffer(&sim, 1, TxPriority::Lowest);
    let control = can.regs(&sim).tr_con_of(0).0;
    control.write(control.read().with_rtren(0, true));
    can.write(&sim, 0, &frame("100#AA"));
    can.write(&sim, 1, &frame("101#BB"));
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    let old = control.read();
    sim.peer_send(other, frame("100#R1"));
    let asked = |sim: &Sim| sim.inspect(can.id, |model| model.transmitting() != (None, None));
    sim.run_until(FRAME, asked).unwrap();
    control.write(old.with_txreq(1, true));
    sim.run_for(FRAME * 3);
    assert_eq!(received(&sim, other), ["101#BB"]);
    assert!(can.outcome(&sim, 0).1, "TXABT");
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::StaleWrite { bits: 8, .. }]));
}

/// Both buffers are requested in one write, or each with a value read afresh: nothing is reported.
#[test]
fn honest_writes_of_txreq() {
    let (sim, can, other) = pair();
    can.transmit_buffer(&sim, 1, TxPriority::Lowest);
    can.write(&sim, 0, &frame("100#AA"));
    can.write(&sim, 1, &frame("101#BB"));
    let control = can.regs(&sim).tr_con_of(0).0;
    control.write(control.read().with_txreq(0, true).with_txreq(1, true));
    sim.run_for(FRAME * 2);
    control.write(control.read().with_txreq(0, true));
    sim.run_for(FRAME * 2);
    control.write(control.read().with_txreq(1, true));
    sim.run_for(FRAME * 2);
    assert_eq!(received(&sim, other), ["101#BB", "100#AA", "100#AA", "101#BB"]);
    assert_eq!(sim.diagnostics(), []);
}

/// The handler forgets to clear its flag.
#[test]
fn interrupt_storm() {
    let (sim, can, other) = pair();
    can.regs(&sim).inte().write(Inte::RBIE);
    sim.on_interrupt(can.id, EVENT, move |sim| {
        can.take(sim, 8);
    });
    sim.peer_send(other, frame("100#"));
    sim.run_for(FRAME);
    assert_eq!(kinds(&sim), [DiagnosticKind::InterruptStorm { line: EVENT, entries: 1_000 }]);
}

/// Filters are left as a reset leaves them: all enabled and unknown. Whether a message arrives is chance.
#[test]
fn filters_left_after_reset() {
    let stored = |seed: u32| {
        let sim = Sim::new();
        let can = add_with(&sim, "can1", |mut config| {
            config.unknown_reset = can_sim::registers::UnknownReset::Pattern(seed);
            config
        });
        can.regs(&sim).cfg1().write(CFG1);
        can.regs(&sim).cfg2().write(crate::bench::CFG2);
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        sim.peer_send(other, frame("123#"));
        sim.run_for(FRAME);
        can.is_full(&sim, 0)
    };
    let outcomes: Vec<bool> = (0..200).map(stored).collect();
    assert!(outcomes.contains(&true) && outcomes.contains(&false), "{outcomes:?}");
}

/// Polling OPMODE with a bound: on a bus that is held dominant the mode is never reached.
#[test]
fn waiting_for_a_mode_without_an_idle_bus() {
    let sim = Sim::new();
    let can = add_with(&sim, "can1", |config| config).set_up(&sim);
    let (from, until) = (Time::ZERO, Time::from_ms(50));
    let (line, how) = (can_wire::Line::Bus, can_wire::Disturbance::Dominant);
    sim.with_wire(|wire| wire.inject(can_wire::Fault::Disturb { line, how, from, until }));
    can.regs(&sim).ctrl1().modify(|value| value.with_reqop(OperationMode::Normal));
    sim.run_for(Time::from_ms(40));
    assert_eq!(can.mode(&sim), OperationMode::Configuration);
    sim.run_for(Time::from_ms(11));
    assert_eq!(can.mode(&sim), OperationMode::Normal);
}
