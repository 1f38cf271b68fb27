//! Bugs that drivers for this module have really had, each as the driver would have it, and how it shows here.

use std::{cell::RefCell, rc::Rc};

use crate::bench::{BASE, Can, FRAME, Mode, TX8, TxFifo, add, frame, ids, kinds, pair};
use can_sim::{DiagnosticKind, PeerId, Sim, Time};
use dspic33_canfd_pac::{enums::PayloadSize, registers as pac};
use regbus::Bus;

fn bench() -> (Sim, Can, PeerId) {
    let (sim, can, peer) = pair();
    can.tx_fifo(&sim, 1, TX8);
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
    can.accept_all(&sim, 2);
    can.start(&sim);
    (sim, can, peer)
}

/// The interrupt "FIFO not full" is enabled before there is anything to send. The FIFO is not full now and for ever: the
/// handler, which only fills when it has data, runs again and again.
#[test]
fn transmit_interrupt_enabled_before_there_is_data() {
    let (sim, can, _) = bench();
    let calls = Rc::new(RefCell::new(0));
    let counter = Rc::clone(&calls);
    sim.on_interrupt(can.id, 1, move |_| *counter.borrow_mut() += 1);
    let regs = can.regs(&sim);
    regs.int_h().write(pac::IntH::TXIE);
    regs.fifo(1).con_l().write(pac::FifoConL::TXEN | pac::FifoConL::TFNRFNIE);
    let found = kinds(&sim);
    assert!(found.contains(&DiagnosticKind::InterruptStorm { line: 1, entries: *calls.borrow() }), "{found:?}");
}

/// The receive handler clears RXIF in INTL, which is read-only, instead of emptying the FIFO: the level stays.
#[test]
fn receive_interrupt_that_is_cleared_in_the_wrong_place() {
    let (sim, can, peer) = bench();
    sim.on_interrupt(can.id, 0, move |sim| can.regs(sim).int_l().clear(pac::IntL::RXIF));
    let regs = can.regs(&sim);
    regs.int_h().write(pac::IntH::RXIE);
    regs.fifo(2).con_l().write(pac::FifoConL::TFNRFNIE);
    assert_eq!(kinds(&sim), []);
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::InterruptStorm { line: 0, .. }]));
}

/// The enables are changed by a read-modify-write around a request that was made through CxTXREQ in between: TXREQ is
/// written back as 0, which is an abort.
#[test]
fn txreq_written_back_as_0() {
    let (sim, can, peer) = bench();
    sim.peer_send(peer, frame("050#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.load(&sim, 1, &frame("100#"));
    let con = can.regs(&sim).fifo(1).con_l();
    let old = con.read();
    can.request(&sim, 1 << 1);
    con.write(old.with_txatie(true));
    let found = kinds(&sim);
    assert_eq!(found, [DiagnosticKind::RequestDropped { register: "FIFOCONL[1]".into(), value: 0x0090 }]);
    sim.run_for(FRAME * 3);
    assert_eq!(ids(&sim, peer), [], "the message is never sent");
    assert!(can.status(&sim, 1).txabt());
}

/// 6.4: a message is appended with a write of UINC alone while the FIFO transmits. The write carries TXREQ 0: everything
/// that has not started is aborted.
#[test]
fn uinc_without_txreq_while_transmitting() {
    let (sim, can, peer) = bench();
    ["100#", "101#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
    can.request(&sim, 1 << 1);
    sim.run_for(Time::from_us(20));
    let at = (can.user_address(&sim, 1) - BASE) as usize;
    can.write_object(&sim, at, &frame("102#"), |t2| t2);
    can.regs(&sim).fifo(1).con_l().write(pac::FifoConL::TXEN | pac::FifoConL::UINC);
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::RequestDropped { .. }]));
    sim.run_for(FRAME * 4);
    assert_eq!(ids(&sim, peer), [0x100], "the other two wait for ever");
    assert!(!can.status(&sim, 1).tferffif());
}

/// Example 6-1 sets UINC and TXREQ one after the other. If the FIFO runs empty in between, nothing is lost; but if the
/// driver leaves TXREQ out because it has just read it as 1, the message waits for the next one.
#[test]
fn relying_on_a_request_that_has_just_ended() {
    let (sim, can, peer) = bench();
    can.send(&sim, 1, &frame("100#"));
    let con = can.regs(&sim).fifo(1).con_l();
    let transmitting = con.read().txreq();
    sim.run_for(FRAME);
    let at = (can.user_address(&sim, 1) - BASE) as usize;
    can.write_object(&sim, at, &frame("101#"), |t2| t2);
    con.write(pac::FifoConL::TXEN.union(pac::FifoConL::UINC).with_txreq(!transmitting));
    sim.run_for(FRAME);
    assert!(transmitting);
    assert_eq!(ids(&sim, peer), [0x100]);
    assert_eq!(can.status(&sim, 1).fifoci(), 1, "the message stands in the FIFO");
}

/// User addresses are read and kept in Configuration mode, where they mean nothing.
#[test]
fn user_addresses_read_in_configuration_mode() {
    let sim = Sim::new();
    let can = crate::bench::add_with(&sim, "can0", |mut config| {
        config.unknown_reset = can_sim::registers::UnknownReset::Pattern(7);
        config
    });
    can.configure(&sim);
    can.tx_fifo(&sim, 1, TX8);
    let kept = can.user_address(&sim, 1);
    let found = kinds(&sim);
    let unreliable = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::ReadUnreliable { .. });
    assert!(found.len() == 2 && found.iter().all(unreliable), "{found:?}");
    can.start(&sim);
    assert_ne!(kept, can.user_address(&sim, 1));
    assert_eq!(can.user_address(&sim, 1), BASE);
}

/// The halves of CxTREC the wrong way round: the driver takes the low byte for the transmit counter. With counters that
/// differ its expectation fails.
#[test]
fn error_counters_swapped() {
    let (sim, can, _) = bench();
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, 104, 9));
    sim.run_for(Time::from_us(1));
    let word: u16 = sim.registers(can.id).read(0x034);
    let (wrong_tec, wrong_rec) = (word as u8, (word >> 8) as u8);
    assert_ne!((wrong_tec, wrong_rec), (104, 9), "the driver's expectation fails");
    assert_eq!((wrong_tec, wrong_rec), (9, 104));
    // What the state bits say does not fit the swapped counters: the transmitter is in the warning range.
    let states = can.regs(&sim).trec_h().read();
    assert!(states.txwarn() && !states.rxwarn());
    let trec = can.regs(&sim).trec_l().read();
    assert_eq!((trec.terrcnt(), trec.rerrcnt()), (104, 9));
}

/// A driver that counts by itself and does not look at the flags: UINC on a full and on an empty FIFO.
#[test]
fn uinc_on_a_full_or_an_empty_fifo() {
    let (sim, can, _) = bench();
    (0..4).for_each(|_| can.load(&sim, 1, &frame("100#")));
    assert_eq!(kinds(&sim), []);
    can.increment(&sim, 1, false);
    let full = DiagnosticKind::IncrementIgnored { register: "FIFOCONL[1]".into(), fill: 4, depth: 4 };
    assert_eq!(kinds(&sim), [full]);
    can.increment(&sim, 2, false);
    let empty = DiagnosticKind::IncrementIgnored { register: "FIFOCONL[2]".into(), fill: 0, depth: 4 };
    assert_eq!(kinds(&sim), [empty]);
    can.release_event(&sim);
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::IncrementIgnored { .. }]));
}

/// 6.2: a message is loaded without looking whether there is room: it lands on the one that is being sent.
#[test]
fn loading_into_a_full_fifo() {
    let (sim, can, _) = bench();
    (0..4).for_each(|_| can.load(&sim, 1, &frame("100#1111")));
    can.request(&sim, 1 << 1);
    sim.run_for(Time::from_us(20));
    let at = (can.user_address(&sim, 1) - BASE) as usize;
    can.write_object(&sim, at, &frame("700#"), |t2| t2);
    let found = kinds(&sim);
    assert!(found.contains(&DiagnosticKind::PendingBufferModified { buffer: 1, address: BASE }), "{found:?}");
}

/// `CxINTL &= ~flag` writes back 0 for whatever rises between the read and the write.
#[test]
fn clearing_flags_by_read_modify_write() {
    let lost = |read_modify_write: bool| {
        let (sim, can, _) = bench();
        let bus = sim.registers(can.id);
        assert!(can.flags(&sim).modif());
        let old = if read_modify_write { bus.read::<u16>(0x01C) } else { u16::MAX };
        let node = sim.node(can.id);
        // The error counter crosses its threshold now.
        sim.with_wire(|wire| wire.set_error_counters(node, 100, 0));
        sim.run_for(Time::from_us(1));
        bus.write(0x01C, old & !pac::IntL::MODIF.bits());
        !can.flags(&sim).cerrif()
    };
    assert!(lost(true), "the new flag is cleared unseen");
    assert!(!lost(false), "a word of ones with one 0 touches only its flag");
}

/// 8.1: a filter is changed while it is enabled: nothing happens to it.
#[test]
fn filter_changed_while_enabled() {
    let (sim, can, peer) = bench();
    let flt = can.regs(&sim).flt(0);
    flt.obj_l().write(pac::FltObjL::from_bits(0x123));
    flt.mask_l().write(pac::MaskL::from_bits(0x7FF));
    let found = kinds(&sim);
    let refused =
        |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::ProtectedWrite { condition: "filter_disabled", .. });
    assert!(found.len() == 2 && found.iter().all(refused), "{found:?}");
    sim.peer_send(peer, frame("456#"));
    sim.run_for(FRAME);
    assert!(can.has_message(&sim, 2), "it still accepts everything");
}

/// The FIFOs are set up right after REQOP is written, without waiting for OPMOD: every write is refused.
#[test]
fn configuring_without_waiting_for_configuration_mode() {
    let (sim, can, peer) = bench();
    sim.peer_send(peer, frame("123#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.ask(&sim, Mode::Configuration);
    can.tx_fifo(&sim, 3, TxFifo { depth: 8, size: PayloadSize::Bytes64, priority: 0 });
    let found = kinds(&sim);
    let refused = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::ProtectedWrite { condition: "config", .. });
    assert!(found.len() == 2 && found.iter().all(refused), "{found:?}");
    assert_eq!(can.regs(&sim).fifo(3).con_h().read().fsize(), 0);
}

/// A FIFO is reset in Configuration mode and the driver waits there for FRESET to read 0: it never does.
#[test]
fn waiting_for_freset_in_configuration_mode() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.configure(&sim);
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(pac::FifoConL::FRESET);
    let done = (0..1_000).any(|_| !con.read().freset());
    assert!(!done);
}

/// Example 7-1 reserves 200 bytes for a configuration that takes 420: the module writes behind its buffer.
#[test]
fn a_buffer_that_is_too_small() {
    let (sim, can, _) = pair();
    let end = BASE + 4096 * 4;
    can.set_base(&sim, end - 200);
    can.events(&sim, 5, true);
    can.tx_fifo(&sim, 1, TxFifo { depth: 5, size: PayloadSize::Bytes64, priority: 0 });
    can.start(&sim);
    let beyond = DiagnosticKind::SectionBeyondMemory { section: "fifo 1", end: end + 220, limit: end };
    assert_eq!(kinds(&sim), [beyond]);
}

/// FIFOSTA is read twice, by a debugger or a careless poll: the second read no longer knows of the abort.
#[test]
fn txabt_is_gone_after_one_read() {
    let (sim, can, peer) = bench();
    sim.peer_send(peer, frame("050#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 1, &frame("100#"));
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(con.read().with_txreq(false));
    assert!(can.status(&sim, 1).txabt());
    assert!(!can.status(&sim, 1).txabt());
}
