//! Error management (11.0).

use crate::bench::{Can, FRAME, frame, pair, received};
use can_sim::{Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use dspic33_ecan_pac::{
    enums::{InterruptCode, OperationMode},
    registers::{Inte, Intf},
};

fn set(sim: &Sim, can: Can, tec: u16, rec: u16) {
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, tec, rec));
    sim.run_for(Time::from_us(1));
}

const STATES: Intf =
    Intf::TXBO.union(Intf::TXBP).union(Intf::RXBP).union(Intf::TXWAR).union(Intf::RXWAR).union(Intf::EWARN);

/// 11.2.1 to 11.2.5: the states by the counters, and ERRIF on entry.
#[test]
fn section_11_2_error_states() {
    for (tec, rec, states) in [
        (95, 95, Intf::from_bits(0)),
        (96, 0, Intf::TXWAR | Intf::EWARN),
        (127, 0, Intf::TXWAR | Intf::EWARN),
        (0, 96, Intf::RXWAR | Intf::EWARN),
        (0, 127, Intf::RXWAR | Intf::EWARN),
        (128, 0, Intf::TXBP | Intf::EWARN),
        (0, 128, Intf::RXBP | Intf::EWARN),
        (100, 130, Intf::TXWAR | Intf::RXBP | Intf::EWARN),
    ] {
        let (sim, can, _) = pair();
        set(&sim, can, tec, rec);
        assert_eq!(can.intf(&sim) & STATES, states, "{tec}/{rec}");
        assert_eq!(can.intf(&sim).errif(), states.bits() != 0);
        let ec = can.regs(&sim).ec().read();
        assert_eq!((u16::from(ec.terrcnt()), u16::from(ec.rerrcnt())), (tec, rec));
        // 12.3: clearing ERRIF leaves the states; they raise it again only when they are entered again.
        can.regs(&sim).intf().clear(Intf::ERRIF);
        assert_eq!(can.intf(&sim), states);
        set(&sim, can, tec, rec);
        assert_eq!(can.intf(&sim), states);
        // Hardware clears the states.
        set(&sim, can, 0, 0);
        assert_eq!(can.intf(&sim).bits(), 0);
        set(&sim, can, tec, rec);
        assert_eq!(can.intf(&sim).errif(), states.bits() != 0);
    }
}

/// 12.3: each of five states raises ERRIF; EWARN alone does not.
#[test]
fn section_12_3_error_interrupt_sources() {
    let (sim, can, _) = pair();
    can.regs(&sim).inte().write(Inte::ERRIE);
    for (tec, rec, entered) in
        [(96, 0, true), (97, 0, false), (97, 96, true), (128, 96, true), (128, 128, true), (127, 128, true)]
    {
        can.regs(&sim).intf().clear(Intf::ERRIF);
        set(&sim, can, tec, rec);
        assert_eq!(sim.line(can.id, 0), entered, "{tec}/{rec}");
        let code = if entered { InterruptCode::Error } else { InterruptCode::NoInterrupt };
        assert_eq!(can.regs(&sim).vec().read().icode(), Ok(code));
    }
}

/// 11.2.4: the way of a transmitter over the wire: each error adds 8, warning at 96.
#[test]
fn section_11_2_transmitter_over_the_wire() {
    let (sim, can, other) = pair();
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 0));
    let frames = Frames { count: 12, ..Frames::next_of(node) };
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
    can.send(&sim, 0, &frame("100#00"));
    sim.run_until(FRAME * 20, |sim| can.regs(sim).ec().read().terrcnt() == 88).unwrap();
    assert!(!can.intf(&sim).errif());
    sim.run_until(FRAME * 2, |sim| can.regs(sim).ec().read().terrcnt() == 96).unwrap();
    assert_eq!(can.intf(&sim) & STATES, Intf::TXWAR | Intf::EWARN);
    assert!(can.intf(&sim).errif());
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).ec().read().terrcnt(), 95);
    assert_eq!(can.intf(&sim) & STATES, Intf::from_bits(0));
    assert_eq!(received(&sim, other), ["100#00"]);
}

/// Takes the module to bus off: every frame it sends meets an error.
fn go_bus_off(sim: &Sim, can: Can) {
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 0));
    let frames = Frames { count: 32, ..Frames::next_of(node) };
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertDriven, position, frames }));
    can.send(sim, 0, &frame("100#00"));
    let bus_off = |sim: &Sim| sim.with_wire(|wire| wire.error_state(node)) == can_wire::ErrorState::BusOff;
    sim.run_until(FRAME * 60, bus_off).unwrap();
    sim.run_for(Time::from_ns(1));
}

/// 11.2.3, Figure 11-1: bus off at 256, and the way back after 128 times 11 recessive bits, by itself
/// (`bus_off_recovery`). TERRCNT shows 255 (`terrcnt_in_bus_off`), TXBP and EWARN stay (`txbp_in_bus_off`).
#[test]
fn figure_11_1_bus_off_and_recovery() {
    let (sim, can, other) = pair();
    go_bus_off(&sim, can);
    let off = sim.now();
    assert_eq!(can.intf(&sim) & STATES, Intf::TXBO | Intf::TXBP | Intf::EWARN);
    assert!(can.intf(&sim).errif());
    assert_eq!(can.regs(&sim).ec().read().terrcnt(), 255);
    assert_eq!(can.mode(&sim), OperationMode::Normal);
    can.take_flags(&sim);
    sim.peer_send(other, frame("7FF#"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(other), [], "a node that is bus off does not acknowledge");
    let back = sim.run_until(FRAME * 30, |sim| !can.intf(sim).txbo()).unwrap();
    assert!(back.since(off) >= Time::from_us(128 * 11), "{}", back.since(off));
    assert_eq!((can.regs(&sim).ec().read().bits(), can.intf(&sim) & STATES), (0, Intf::from_bits(0)));
    sim.run_for(FRAME * 4);
    assert_eq!(received(&sim, other), ["100#00"], "the request was still pending");
}

/// A mode that is requested in bus off is reached with the next 11 recessive bits; afterwards the recovery begins anew.
#[test]
fn a_mode_is_requested_in_bus_off() {
    let (sim, can, other) = pair();
    go_bus_off(&sim, can);
    can.enter(&sim, OperationMode::Configuration);
    assert!(can.intf(&sim).txbo(), "configuration_on_request: it clears nothing");
    sim.run_for(Time::from_ms(2));
    assert!(can.intf(&sim).txbo());
    can.enter(&sim, OperationMode::Normal);
    assert!(can.intf(&sim).txbo());
    sim.run_for(Time::from_us(129 * 11));
    assert!(!can.intf(&sim).txbo());
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["100#00"]);
}

/// 11.1: the five kinds of errors, each as a receiver meets it.
#[test]
fn section_11_1_errors_of_a_receiver() {
    for (field, bit) in [(Field::Data, 0), (Field::Crc, 3), (Field::CrcDelimiter, 0), (Field::Eof, 2)] {
        let (sim, can, other) = pair();
        let node = sim.node(can.id);
        let fault = Fault::Bit {
            node,
            fault: BitFault::InvertSeen,
            position: Position::new(field, bit),
            frames: Frames::next(),
        };
        sim.with_wire(|wire| wire.inject(fault));
        sim.peer_send(other, frame("100#5555"));
        sim.run_until(FRAME, |sim| can.intf(sim).ivrif()).unwrap();
        assert!(!can.is_full(&sim, 8) && can.regs(&sim).ec().read().rerrcnt() > 0, "{field:?}");
        sim.run_for(FRAME);
        assert_eq!(can.take(&sim, 8), Some(frame("100#5555")), "the sender repeats it");
    }
}
