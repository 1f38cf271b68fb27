//! Chapter 34.11: error counters and states, over the wire; CERRIF and IVRIF (34.12.1.1, 34.12.1.3).

use can_sim::{PeerId, Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use pic32_can_pac::{
    enums::OperationMode,
    registers::{FifoCon, Int, Trec},
};

use crate::bench::*;

fn counters(sim: &Sim, can: Can, tec: u16, rec: u16) -> Trec {
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, tec, rec));
    sim.run_for(Time::from_ns(100));
    can.regs(sim).trec().read()
}

/// The next frames that the module sends have an error in their CRC, as the module sees it.
fn disturb(sim: &Sim, can: Can, count: u32) {
    let node = sim.node(can.id);
    let frames = Frames { sender: Some(node), skip: 0, count };
    let position = Position::new(Field::Crc, 2);
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
}

/// Register 34-5: the bits at the thresholds.
#[test]
fn thresholds() {
    let (sim, can, _) = bench(&[Use::Tx(1)]);
    let state = Trec::TXBP | Trec::RXBP | Trec::TXWARN | Trec::RXWARN | Trec::EWARN | Trec::TXBO;
    for (tec, rec, expected) in [
        (95, 0, Trec::ZERO),
        (96, 0, Trec::TXWARN | Trec::EWARN),
        (127, 0, Trec::TXWARN | Trec::EWARN),
        (128, 0, Trec::TXBP | Trec::EWARN),
        (0, 96, Trec::RXWARN | Trec::EWARN),
        (0, 128, Trec::RXBP | Trec::EWARN),
        (100, 100, Trec::TXWARN | Trec::RXWARN | Trec::EWARN),
        (0, 0, Trec::ZERO),
    ] {
        let trec = counters(&sim, can, tec, rec);
        assert_eq!(trec.bits() & state.bits(), expected.bits(), "TEC {tec}, REC {rec}");
        assert_eq!((u16::from(trec.tec()), u16::from(trec.rec())), (tec, rec));
    }
}

/// 34.12.1.3: 95 to 96 sets CERRIF; cleared it stays 0 above; again after a fall below 96, and above 127.
#[test]
fn once_for_each_crossing() {
    let (sim, can, _) = bench(&[Use::Tx(1)]);
    let told = |tec| {
        counters(&sim, can, tec, 0);
        let flag = can.flags(&sim).cerrif();
        can.clear(&sim, Int::CERRIF);
        flag
    };
    assert!(!told(95));
    assert!(told(96));
    assert!(!told(100));
    told(90);
    assert!(told(96));
    assert!(told(128));
    assert!(!told(140));
}

/// 34.12.1.1: an error sets IVRIF, one in a message received and one in a message sent; it does not set CERRIF.
#[test]
fn invalid_messages() {
    let (sim, can, peer) = bench(&[Use::Tx(2), Use::Rx(2)]);
    let node = sim.node(can.id);
    let position = Position::new(Field::CrcDelimiter, 0);
    sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
    });
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert!(can.flags(&sim).ivrif() && !can.flags(&sim).cerrif());
    assert_eq!(can.receive(&sim, 1), Some(frame("123#")), "the repetition");
    can.clear(&sim, Int::IVRIF);
    disturb(&sim, can, 1);
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME);
    assert!(can.flags(&sim).ivrif() && !can.flags(&sim).cerrif());
    assert_eq!(heard(&sim, peer), ["100#"]);
}

/// 34.11.1.2: without acknowledgement the message is repeated; an error frame follows (acknowledge_error_frame); TEC ends
/// at 128, error passive, and the module never goes bus off by it.
#[test]
fn alone_on_the_bus() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x100, &[Use::Tx(2)]);
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(Time::from_ms(10));
    let trec = can.regs(&sim).trec().read();
    assert_eq!(trec.tec(), 128);
    assert!(trec.txbp() && !trec.txbo());
    assert!(can.flags(&sim).cerrif() && can.flags(&sim).ivrif());
    assert!(can.fifo(&sim, 0).con().read().txreq());
    let peer = add_peer(&sim);
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), ["100#"]);
}

fn into_bus_off(sim: &Sim, can: Can) {
    disturb(sim, can, 40);
    can.send(sim, 0, &frame("100#"));
    let off = sim.run_until(Time::from_ms(20), |sim| {
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.error_state(node)) == can_wire::ErrorState::BusOff
    });
    assert!(off.is_some());
}

fn bus_off_bench() -> (Sim, Can, PeerId) {
    bench(&[Use::Tx(2), Use::Rx(2)])
}

/// 34.11.2.3, bus_off_recovery: TXBO with TEC 0xFF, then 128 times 11 recessive bits, both counters 0, and the message is
/// sent after all.
#[test]
fn bus_off_and_recovery() {
    let (sim, can, peer) = bus_off_bench();
    can.regs(&sim).int_().set_bits(Int::CERRIE);
    into_bus_off(&sim, can);
    let trec = can.regs(&sim).trec().read();
    assert!(trec.txbo());
    assert_eq!(trec.tec(), 0xFF);
    assert_eq!(can.icod(&sim), 0x41);
    can.clear(&sim, Int::CERRIF);
    sim.with_wire(|wire| wire.clear_faults());
    let begin = sim.now();
    sim.run_until(Time::from_ms(5), |sim| !can_is_bus_off(sim, can)).unwrap();
    let took = sim.now().since(begin);
    assert!(took >= Time::from_us(128 * 11 - 12) && took < Time::from_us(128 * 11 + 40), "{took}");
    assert_eq!(can.regs(&sim).trec().read().bits(), 0);
    assert!(can.flags(&sim).cerrif(), "leaving bus off is a change of state");
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), ["100#"]);
}

fn can_is_bus_off(sim: &Sim, can: Can) -> bool {
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.error_state(node)) == can_wire::ErrorState::BusOff
}

/// 34.5.1: Configuration mode ends bus off.
#[test]
fn configuration_mode_ends_bus_off() {
    let (sim, can, peer) = bus_off_bench();
    into_bus_off(&sim, can);
    can.mode(&sim, OperationMode::Configuration);
    assert_eq!(can.regs(&sim).trec().read().bits(), 0);
    assert!(!can_is_bus_off(&sim, can));
    sim.with_wire(|wire| wire.clear_faults());
    can.start(&sim);
    can.send(&sim, 0, &frame("101#"));
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), ["101#"]);
}

/// 34.5.6: Disable mode does not: the recovery begins again afterwards.
#[test]
fn disable_mode_keeps_bus_off() {
    let (sim, can, _) = bus_off_bench();
    into_bus_off(&sim, can);
    can.mode(&sim, OperationMode::Disable);
    sim.run_for(Time::from_ms(3));
    assert!(can_is_bus_off(&sim, can));
    can.regs(&sim).con().modify(|con| con.with_reqop(OperationMode::Normal));
    sim.run_for(Time::from_ms(2));
    assert!(!can_is_bus_off(&sim, can));
    assert_eq!(can.opmod(&sim), OperationMode::Normal);
}

/// A receiver's errors: REC rises to passive, and the module's own messages still go out.
#[test]
fn receive_errors() {
    let (sim, can, peer) = bus_off_bench();
    let node = sim.node(can.id);
    let other = sim.peer_node(peer);
    let position = Position::new(Field::Crc, 2);
    let frames = Frames { sender: Some(other), skip: 0, count: 12 };
    sim.with_wire(|wire| wire.set_error_counters(node, 0, 90));
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
    sim.peer_send(peer, frame("123#"));
    sim.run_for(Time::from_us(1_500));
    let trec = can.regs(&sim).trec().read();
    assert_eq!(trec.rec(), 90 + 12 - 1, "12 errors and a success");
    assert!(trec.rxwarn());
    assert!(can.flags(&sim).cerrif());
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME * 3);
    assert_eq!(heard(&sim, peer), ["100#"]);
    assert!(!can.fifo(&sim, 0).con().read().contains(FifoCon::TXREQ));
}
