//! Bugs that drivers for this module have really had, each as the driver would have it, and how it shows here.

use can_sim::{DiagnosticKind, Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{Con, FifoCon, Rxm},
};
use regbus::Bus;

use crate::bench::*;

/// Figure 34-9 taken at its word: FIFO3 is thought to begin right behind FIFO1, but FIFO2, which nobody has configured,
/// lies between them. The driver computes the address itself; its message is never seen.
#[test]
fn unconfigured_fifos_occupy_memory() {
    let (sim, can, peer) = bench(&[Use::Tx(4), Use::DataOnly(2), Use::Rx(1), Use::Tx(4)]);
    let thought = 0x100 + 4 * 16 + 2 * 8;
    can.store(&sim, thought, &frame("123#11"));
    can.fifo(&sim, 3).con().set_bits(FifoCon::UINC | FifoCon::TXREQ);
    sim.run_for(FRAME);
    assert_eq!(kinds(&sim), [DiagnosticKind::BufferNotWritten { fifo: 3, address: thought + 16 }]);
    assert_eq!(heard(&sim, peer), ["000#"], "what happened to lie in memory");
    assert_eq!(can.fifo(&sim, 3).ua().read().bits(), thought + 32, "CiFIFOUA3 had told");
}

/// The memory is allocated for the FIFOs in use, not for the ones between them.
#[test]
fn too_little_memory_for_the_gap() {
    let sim = Sim::new();
    let ram = sim.add_memory(can_sim::Memory::new(36).with_widths(&[8, 16, 32]));
    let id = sim.add_pic32_can("can1", can_sim::pic32_can::Pic32CanConfig::new(ram)).unwrap();
    let can = Can { id, ram };
    can.set_up(&sim, 0, &[Use::Tx(4), Use::DataOnly(2), Use::Rx(1), Use::Rx(4)]);
    can.start(&sim);
    let beyond = DiagnosticKind::SectionBeyondMemory { section: "fifo", end: 40 * 4, limit: 36 * 4 };
    assert_eq!(kinds(&sim), [beyond]);
}

/// A chip with 16 FIFOs and filters is used as if it had 32.
#[test]
fn sixteen_fifos_used_as_thirty_two() {
    let (sim, can, peer) = bench_with(&[Use::Rx(2)], |config| config.with_fifos(16));
    can.fifo(&sim, 20).con().write(FifoCon::TXEN);
    assert_eq!(kinds(&sim), [DiagnosticKind::NotImplemented { register: "FIFOCON[20]".into(), write: true }]);
    assert_eq!(can.fifo(&sim, 20).con().read().bits(), 0);
    assert_eq!(can.fifo(&sim, 20).ua().read().bits(), 0);
    assert_eq!(kinds(&sim).len(), 2);
    can.regs(&sim).rxf(16).write(standard(0x100));
    assert_eq!(kinds(&sim), [DiagnosticKind::NotImplemented { register: "RXF[16]".into(), write: true }]);
    can.select(&sim, 1, 0, 20, standard(0x100));
    assert!(matches!(&kinds(&sim)[..], [DiagnosticKind::Contradiction { what }] if what.contains("FIFO 20")));
    can.regs(&sim).flt_con(7).set_bits(pic32_can_pac::registers::FltCon::flten_bit(0));
    assert_eq!(kinds(&sim), [DiagnosticKind::NotImplemented { register: "FLTCON[7]".into(), write: true }]);
    sim.peer_send(peer, frame("100#"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), Some(frame("100#")), "the first 16 work");
    assert_eq!(sim.diagnostics(), []);
}

/// No list of steps in the manual sets ON (on_missing_in_steps): the driver polls OPMOD for ever.
#[test]
fn on_is_never_set() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    let con = can.regs(&sim).con();
    con.modify(|con| con.with_reqop(OperationMode::Normal));
    for _ in 0..100 {
        assert_eq!(con.read().opmod(), Ok(OperationMode::Configuration));
    }
    let found = kinds(&sim);
    assert!(
        matches!(&found[..], [DiagnosticKind::WriteIgnored { field: "REQOP", because, .. }] if because.contains("ON is 0")),
        "{found:?}"
    );
    con.set_bits(Con::ON);
    sim.run_for(FRAME);
}

/// The driver waits in a loop for TXREQ to fall, and looks for TXERR afterwards: the loop has destroyed it.
#[test]
fn polling_fifocon_loses_txerr() {
    let (sim, can, _) = bench(&[Use::Tx(2)]);
    let node = sim.node(can.id);
    let position = Position::new(Field::Data, 3);
    sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
    });
    can.send(&sim, 0, &frame("100#55"));
    let con = can.fifo(&sim, 0).con();
    while con.read().txreq() {}
    assert!(!con.read().txerr(), "the error is not seen");
    let found = kinds(&sim);
    assert!(
        matches!(&found[..], [DiagnosticKind::StatusReadTwice { register, lost, .. }] if register == "FIFOCON[0]" && lost & FifoCon::TXERR.bits() != 0),
        "{found:?}"
    );
}

/// The same for TXLARB.
#[test]
fn polling_fifocon_loses_txlarb() {
    let (sim, can, peer) = bench(&[Use::Tx(2)]);
    sim.peer_send(peer, frame("7FF#"));
    sim.run_for(Time::from_us(20));
    sim.peer_send(peer, frame("0FF#"));
    can.send(&sim, 0, &frame("100#55"));
    let con = can.fifo(&sim, 0).con();
    while con.read().txreq() {}
    assert!(!con.read().txlarb());
    assert!(
        matches!(&kinds(&sim)[..], [DiagnosticKind::StatusReadTwice { lost, .. }] if lost & FifoCon::TXLARB.bits() != 0)
    );
}

/// A read-modify-write of CiFIFOCONn for another bit, with the TXREQ that was read back then: the request that hardware
/// has made for a remote frame meanwhile is aborted.
#[test]
fn read_modify_write_aborts_a_request() {
    let (sim, can, peer) = bench(&[Use::Tx(2)]);
    can.mode(&sim, OperationMode::Configuration);
    can.accept_all(&sim, 0);
    can.fifo(&sim, 0).con().set_bits(FifoCon::RTREN);
    can.start(&sim);
    can.queue(&sim, 0, &frame("100#55"));
    let old = can.fifo(&sim, 0).con().read();
    // While the reply waits for the other node's next frame.
    sim.peer_send(peer, frame("100#R"));
    sim.peer_send(peer, frame("0FF#1122334455667788"));
    sim.run_until(FRAME, |sim| sim.peer_sent(peer).len() == 1).unwrap();
    can.fifo(&sim, 0).con().write(old.with_txpri(pic32_can_pac::enums::FifoConTxpri::Highest));
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    assert!(can.fifo(&sim, 0).con().read().txabat());
}

/// UINC on the wrong FIFO, as Example 34-4 is printed (example_34_4_fifo): the same message is read for ever.
#[test]
fn uinc_on_the_wrong_fifo() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[Use::Rx(2), Use::Rx(2)]);
    can.accept_all(&sim, 1);
    can.start(&sim);
    let peer = add_peer(&sim);
    sim.peer_send(peer, frame("100#01"));
    sim.peer_send(peer, frame("101#02"));
    sim.run_for(FRAME * 2);
    for _ in 0..3 {
        assert!(can.fifo(&sim, 1).int_().read().rxnemptyif());
        assert_eq!(can.look(&sim, can.fifo(&sim, 1).ua().read().bits()), frame("100#01"));
        can.advance(&sim, 0);
    }
    assert_eq!(kinds(&sim), vec![DiagnosticKind::FifoLimit { fifo: 0, full: false }; 3]);
}

/// UINC is forgotten: TXREQ clears at once, and nothing is sent. UINC is set twice: what lies in memory is sent.
#[test]
fn uinc_forgotten_or_twice() {
    let (sim, can, peer) = bench(&[Use::Tx(4)]);
    can.load(&sim, 0, &frame("100#"));
    can.request(&sim, 0);
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    can.advance(&sim, 0);
    can.advance(&sim, 0);
    assert_eq!(kinds(&sim), [DiagnosticKind::BufferNotWritten { fifo: 0, address: 0x110 }]);
}

/// The pointer of the buffer goes into CiFIFOBA as it is, a virtual address: the module stops at the first message.
#[test]
fn virtual_address_in_fifoba() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0xA000_0100, &[Use::Tx(2)]);
    assert_eq!(kinds(&sim), [DiagnosticKind::AddressNotPhysical { register: "FIFOBA", address: 0xA000_0100 }]);
    can.start(&sim);
    can.fifo(&sim, 0).con().set_bits(FifoCon::UINC | FifoCon::TXREQ);
    assert!(can.flags(&sim).serrif());
    assert!(kinds(&sim).contains(&DiagnosticKind::MemoryOverrun { address: 0xA000_0100 }));
}

/// A mask is changed while a filter that selects it is enabled.
#[test]
fn mask_changed_under_a_filter() {
    let (sim, can, _) = bench(&[Use::Rx(2)]);
    can.mode(&sim, OperationMode::Configuration);
    can.regs(&sim).rxm(0).write(EXACT);
    assert_eq!(can.regs(&sim).rxm(0).read(), Rxm::RESET);
    let found = kinds(&sim);
    assert!(
        matches!(&found[..], [DiagnosticKind::ProtectedWrite { register, condition: "no enabled filter selects the mask", .. }] if register == "RXM[0]"),
        "{found:?}"
    );
}

/// A message is changed after it was requested; a received one before it was taken (Example 34-15 as printed,
/// example_34_15_direction).
#[test]
fn writing_into_the_modules_buffers() {
    let (sim, can, peer) = bench(&[Use::Rx(2), Use::Tx(2)]);
    sim.peer_send(peer, frame("7FF#1122334455667788"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 1, &frame("100#11"));
    can.memory(&sim).write(0x128, 0x22_u32);
    assert_eq!(kinds(&sim), [DiagnosticKind::PendingBufferModified { buffer: 1, address: 0x128 }]);
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), ["100#22"]);
    for word in 0..4 {
        can.memory(&sim).write(0x100 + word * 4, 0_u32);
    }
    assert_eq!(kinds(&sim)[0], DiagnosticKind::ReceivedMessageModified { fifo: 0, address: 0x100 });
    assert_eq!(can.receive(&sim, 0), Some(frame("000#")), "the message is lost");
}

/// A short visit to Configuration mode for another setting drops every message.
#[test]
fn mode_bounce_empties_the_fifos() {
    let (sim, can, peer) = bench(&[Use::Rx(4), Use::Tx(4)]);
    sim.peer_send(peer, frame("123#"));
    can.queue(&sim, 1, &frame("100#"));
    sim.run_for(FRAME);
    can.mode(&sim, OperationMode::Configuration);
    can.start(&sim);
    can.request(&sim, 1);
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), None);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
}

/// A flag is "cleared" by setting it.
#[test]
fn setting_a_flag() {
    let (sim, can, _) = bench(&[Use::Rx(2)]);
    can.clear(&sim, pic32_can_pac::registers::Int::MODIF);
    can.regs(&sim).int_().set_bits(pic32_can_pac::registers::Int::from_bits(8));
    assert!(!can.flags(&sim).modif());
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::WriteIgnored { field: "MODIF", .. }]));
}
