//! Bugs that drivers for M_CAN have really had, each as the driver would have it, and how it shows here.

use std::{cell::RefCell, rc::Rc};

use crate::bench::{Can, FRAME, SETUP, Setup, add, frame};
use can_sim::{DiagnosticKind, Memory, PeerId, Sim, m_can::MCanConfig};
use can_wire::NodeConfig;
use m_can_pac::registers::{self as pac, Ir};
use regbus::Bus;

fn bench(setup: &Setup) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, setup);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    (sim, can, peer)
}

fn kinds(sim: &Sim) -> Vec<DiagnosticKind> {
    sim.take_diagnostics().into_iter().map(|diagnostic| diagnostic.kind).collect()
}

/// The acknowledge register is read, the index ORed in, and written back: once index 1 has been acknowledged, index 2
/// becomes 3, and the driver reads wrong elements for ever.
#[test]
fn acknowledging_with_an_ored_old_index() {
    let (sim, can, peer) = bench(&Setup { rxf0c: 8 << 16 | 0x40, rxesc: 0, ..SETUP });
    for text in ["001#", "002#", "003#", "004#"] {
        sim.peer_send(peer, frame(text));
    }
    sim.run_for(FRAME * 5);
    let mut diagnosed = Vec::new();
    let mut read = Vec::new();
    for _ in 0..4 {
        let get = can.regs(&sim).rxf0s().read().f0gi();
        read.push(can.read_element(&sim, 0x40, usize::from(get), 0).to_string());
        let old = can.regs(&sim).rxf0a().read().bits();
        can.regs(&sim).rxf0a().write(pac::Rxf0a::from_bits(old | u32::from(get)));
        sim.run_for(can_sim::Time::from_us(1));
        diagnosed.extend(kinds(&sim));
    }
    assert_ne!(read, ["001#", "002#", "003#", "004#"]);
    // Index 2 became 3: legal, and element 2's successor was never read; what follows is not.
    let fill =
        |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::AcknowledgeInvalid { register: "RXF0A", fill: 0, .. });
    assert!(diagnosed.iter().any(fill), "{diagnosed:?}");
}

/// TXBC is written with the buffer numbers alone, its start address lost: the Tx Buffers lie on the filter list.
#[test]
fn txbc_written_without_its_start_address() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.set_up(&sim, &Setup { sidfc: 4 << 16, ..SETUP });
    let bus = sim.registers(can.id);
    bus.write(0x0C0, 3_u32 << 24 | 2 << 16);
    can.start(&sim);
    let found = kinds(&sim);
    let overlap = |first, second, address| DiagnosticKind::SectionsOverlap { first, second, address };
    assert!(found.contains(&overlap("standard_filters", "tx_buffers", 0)), "{found:?}");
    assert!(found.contains(&overlap("tx_buffers", "rx_fifo_0", 0x40)), "{found:?}");
}

/// A section behind the 64 KiB that start addresses reach, or behind the RAM that the device has.
#[test]
fn message_ram_beyond_its_end() {
    let sim = Sim::new();
    let ram = sim.add_memory(Memory::new(16_384));
    let id = sim.add_m_can("can0", MCanConfig::new(ram)).unwrap();
    let can = Can { id, ram };
    can.set_up(&sim, &Setup { rxf0c: 64 << 16 | 0xFFF0, ..SETUP });
    can.start(&sim);
    let beyond = |end, limit| DiagnosticKind::SectionBeyondMemory { section: "rx_fifo_0", end, limit };
    assert_eq!(kinds(&sim), [beyond(0xFFF0 + 64 * 72, 0x1_0000)]);
    let (sim, can, peer) = bench(&Setup { rxf0c: 64 << 16 | 0x43F8, ..SETUP });
    assert_eq!(kinds(&sim), [beyond(0x43F8 + 64 * 72, 4352 * 4)]);
    sim.peer_send(peer, frame("123#11"));
    sim.run_for(FRAME);
    assert_eq!(kinds(&sim), [DiagnosticKind::MemoryOverrun { address: 0x4400 }], "R2 of the first element");
    assert!(can.ir(&sim).contains(Ir::RF0N));
}

/// The interrupt is enabled and routed to line 1, but only line 0 is enabled: the handler never runs.
#[test]
fn interrupt_routed_to_the_other_line() {
    let (sim, can, peer) = bench(&SETUP);
    let regs = can.regs(&sim);
    let calls = Rc::new(RefCell::new(0));
    let counter = Rc::clone(&calls);
    sim.on_interrupt(can.id, 0, move |_| *counter.borrow_mut() += 1);
    regs.ie().write(pac::Ie::from_bits(Ir::RF0N.bits()));
    regs.ils().write(pac::Ils::from_bits(Ir::RF0N.bits()));
    regs.ile().write(pac::Ile::EINT0);
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert_eq!(*calls.borrow(), 0);
    assert_eq!(kinds(&sim), [DiagnosticKind::InterruptUnheard { register: "IR".into(), fields: vec!["RF0N"] }]);
}

/// `IR |= flag`: the read brings in every flag that is set, the write clears them all; the other message is never seen.
#[test]
fn clearing_flags_by_read_modify_write() {
    let lost = |read_modify_write: bool| {
        let (sim, can, peer) = bench(&Setup { sidfc: 1 << 16, ..SETUP });
        can.memory(&sim).write(0, 1_u32 << 30 | 2 << 27 | 0x200 << 16 | 0x200);
        sim.peer_send(peer, frame("100#"));
        sim.peer_send(peer, frame("200#"));
        sim.run_for(FRAME * 3);
        let bus = sim.registers(can.id);
        let old = if read_modify_write { bus.read::<u32>(0x050) } else { 0 };
        bus.write(0x050, old | Ir::RF0N.bits());
        !can.ir(&sim).contains(Ir::RF1N)
    };
    assert!(!lost(false));
    assert!(lost(true), "RF1N was cleared by accident");
}

/// PSR is read once for Bus_Off and once more for the error code, which the first read has destroyed.
#[test]
fn reading_psr_twice() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &SETUP);
    can.send(&sim, 0, &frame("123#"));
    sim.run_for(FRAME);
    let regs = can.regs(&sim);
    assert!(!regs.psr().read().bo());
    assert_eq!(regs.psr().read().lec().bits(), 7, "the missing acknowledgement is not seen");
    let found = kinds(&sim);
    assert!(matches!(found[..], [DiagnosticKind::StatusReadTwice { lost, .. }] if lost & 7 == 3), "{found:?}");
}

/// The handler forgets to clear its flag: it is entered again and again.
#[test]
fn interrupt_storm() {
    let (sim, can, peer) = bench(&SETUP);
    let regs = can.regs(&sim);
    regs.ie().write(pac::Ie::from_bits(Ir::RF0N.bits()));
    regs.ile().write(pac::Ile::EINT0);
    sim.on_interrupt(can.id, 0, move |sim| {
        can.receive(sim, 0);
    });
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert_eq!(kinds(&sim), [DiagnosticKind::InterruptStorm { line: 0, entries: 1_000 }]);
}

/// Configuration registers are written without CCE, or before INIT has been taken over.
#[test]
fn configuration_outside_configuration_mode() {
    let (sim, can, _) = bench(&SETUP);
    let regs = can.regs(&sim);
    regs.cccr().write(pac::Cccr::INIT | pac::Cccr::CCE);
    regs.nbtp().write(pac::Nbtp::RESET);
    assert_ne!(regs.nbtp().read(), pac::Nbtp::RESET);
    let protected = |d: &DiagnosticKind| matches!(d, DiagnosticKind::ProtectedWrite { register, condition: "config", .. } if register == "NBTP");
    assert!(kinds(&sim).iter().any(protected));
}

/// A message is written into the second buffer of an empty Tx FIFO: it is never sent.
#[test]
fn tx_fifo_buffer_that_was_not_handed_out() {
    let (sim, can, peer) = bench(&SETUP);
    can.send(&sim, 3, &frame("123#"));
    sim.run_for(FRAME * 3);
    assert_eq!(sim.peer_received(peer), []);
    assert_eq!(kinds(&sim), [DiagnosticKind::NotHandedOut { register: "TXBAR", buffer: 3, put: 2 }]);
}

/// Data is copied byte by byte into a Message RAM that takes words only.
#[test]
fn byte_copies_into_message_ram() {
    let (sim, can, _) = bench(&SETUP);
    can.memory(&sim).write(0x14C8, 0x55_u8);
    assert_eq!(kinds(&sim), [DiagnosticKind::IllegalAccess { offset: 0x14C8, width: 8, write: true }]);
    assert_eq!(sim.with_memory(can.ram, |memory| memory.word(0x532)), Some(0));
}

/// A pending message is changed.
#[test]
fn panics_where_a_test_asks_for_it() {
    let caught = std::panic::catch_unwind(|| {
        let sim = Sim::builder().panic_on_diagnostic().build();
        let can = add(&sim, "can0").run(&sim, &SETUP);
        can.regs(&sim).nbtp().write(pac::Nbtp::RESET);
    });
    let message = *caught.unwrap_err().downcast::<String>().unwrap();
    assert!(message.contains("can0: write of 0x6000a03 to NBTP cannot change"), "{message}");
    assert!(message.contains("needs `config` [2.2, 3.1.1]"), "{message}");
}

/// The trace names what each access did.
#[test]
fn the_trace_decodes_accesses() {
    let (sim, can, _) = bench(&SETUP);
    sim.trace(true);
    can.send(&sim, 0, &frame("123#"));
    let _ = can.regs(&sim).rxf0s().read();
    let lines: Vec<String> = sim.trace(false).iter().map(ToString::to_string).collect();
    assert_eq!(lines.len(), 4, "{lines:#?}");
    assert!(
        lines[1].contains("can0: read 0x0c0 = 0x030214c0 TXBC { TFQM: fifo, TFQS: 3, NDTB: 2, TBSA: 0x530 }"),
        "{}",
        lines[1]
    );
    assert!(lines[2].contains("write 0x0d0 = 0x00000001 TXBAR"), "{}", lines[2]);
    assert!(sim.describe(can.id).contains("TXBC { TFQM: fifo"));
}

/// The counters of ECR are taken for each other: a node that nobody acknowledges seems to receive badly, and the driver
/// looks for the fault at the wrong end. A transmitter that is not acknowledged counts to 128, which seven bits of REC
/// cannot even show.
#[test]
fn the_error_counters_swapped() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &SETUP);
    can.send(&sim, 0, &frame("123#"));
    sim.run_for(FRAME * 40);
    let ecr = can.regs(&sim).ecr().read();
    assert_eq!((ecr.tec(), ecr.rec(), ecr.rp()), (128, 0, false), "error passive by transmitting alone");
    let swapped = |word: u32| (word >> 8 & 0x7F, word & 0x7F);
    assert_eq!(swapped(ecr.bits()), (0, 0), "as if there were no errors at all");
}
